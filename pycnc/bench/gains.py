# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench gains`: what each part buys over the linear look-ahead of two papers.

Machine of the comparison (v 100 mm/s, a 1000 mm/s², j 10 000 mm/s³ an axis, T = 1 ms); machining
times [s], planned. cao_10_s: Cao et al. 2014 with ten blocks of look-ahead, the most that they
advise; linear, exact path. keinert_s: the same, all blocks seen, as Keinert et al. 2014 make
affordable. sshape_s: a jerk limit as Cao has it (`--plan sshape`), a = 0 at every junction. jerk_s:
acceleration carried across junctions. p_0_01_s, p_0_1_s: `optimal` within 0.01 and 0.1 mm, where
the jerk of every axis is limited, too, which on the exact path nothing can. The linear slope limits
no jerk at all. These numbers are the same on every computer.
"""

from pycnc.bench import kernel, programs
from pycnc.machine import Machine
from pycnc.planning.plan import Plan
from pycnc.program import Program

# Column → what is set of the machine.
STEPS = {
    "cao_10_s": {"path.slope": "linear", "path.lookahead_blocks": 11},
    "keinert_s": {"path.slope": "linear"},
    "sshape_s": {},
    "jerk_s": {"path.slope": "jerk"},
    "p_0_01_s": {"path.slope": "optimal", "path.tolerance_mm": 0.01},
    "p_0_1_s": {"path.slope": "optimal", "path.tolerance_mm": 0.1},
}
CASES = (
    ("micro-segments of 0.055 mm", lambda: programs.micro("")),
    ("butterfly, chords of 1 µm", lambda: programs.butterfly("", 0.001)),
    ("butterfly, chords of 10 µm", lambda: programs.butterfly("", 0.01)),
    ("zigzag 1 mm", lambda: programs.zigzag("")),
    ("zigzag 10 mm", lambda: programs.zigzag("", 100, 10.0)),
    ("wavy surface", lambda: kernel.relief(20_000).replace(b" G61", b"")),
)


def bench_gains_rows(cases=CASES):
    """Return rows {program, and a time for each of `STEPS`}.

    Parameters
    ----------
    cases : iterable of (str, callable)
        A name, and what makes a program's text without a path mode.
    """
    return [
        {"program": name} | {
            step: _time_s(make(), keys, "sshape" if step == "sshape_s" else "exact")
            for step, keys in STEPS.items()
        }
        for name, make in cases
    ]


def _time_s(text, keys, plan):
    machine = Machine.load(programs.machine(), set=keys)
    return Plan(Program(text, machine), plan=plan, keep=False).time_s
