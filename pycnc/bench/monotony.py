# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench monotony`: where more of something makes a program slower.

Each of 20 programs is planned on its machine under the slope `optimal`, with a, j and v of every
axis times a factor, within P (0: the exact path) and with a window of so many blocks (0: all). One
of these goes up a step while the others stay: a row is a step that takes more than 0.5 % longer.
slope: to the linear one, along the exact path. override: the tick's time, on programs of less than
20 s. The last row counts: the steps that were tried, and those that are slower. Long files are
cut after the first 2000 lines; what a file says of its path (G61, G64 P) wins. These numbers are
the same on every computer.
"""

import itertools
from dataclasses import dataclass, field

from pycnc.bench import corpus, programs
from pycnc.machine import Machine
from pycnc.planning.plan import Plan
from pycnc.program import Program
from pycnc.report.trace import Trace

MOST = 1.005  # of the time with less
LINES = 2000  # of a file
SHORT_S = 20.0  # a program that is run, not only planned
BASE = {"a": 1.0, "j": 1.0, "v": 1.0, "P": 0.01, "window": 0, "slope": "optimal", "override": 100}
# What goes up, through which values, and what the others are meanwhile.
WALKS = (
    ("a", (0.5, 1.0, 2.0, 4.0), {"P": (0.0, 0.01), "j": (1.0, 10.0)}),
    ("j", (0.1, 1.0, 10.0, 100.0), {"P": (0.0, 0.01), "a": (1.0, 4.0)}),
    ("v", (1.0, 2.0, 4.0), {"P": (0.0, 0.01)}),
    ("P", (0.001, 0.01, 0.1, 1.0), {"j": (1.0, 10.0)}),  # at 0 no axis' jerk counts in corners
    ("window", (8, 32, 128, 512, 0), {"P": (0.0, 0.01)}),
    ("slope", ("optimal", "linear"), {"P": (0.0,), "j": (1.0, 100.0)}),
    ("override", (50, 100, 150, 200), {"P": (0.0, 0.01)}),
)
CORPUS = (
    "arcs_rword.gcode", "laser_tball_engrave.gcode", "lathe_g71_g70_pawn.ngc",
    "mill_camotics_locket.ngc", "mill_cutcomp_semicolon.ngc", "mill_fanuc_3dparallel_g19.nc",
    "mill_fanuc_g17_18_19.nc", "mill_fusion_grbl_helix.nc", "mill_nist_circle_diamond_square.ngc",
    "print_cura_bp_case_56k.gcode", "surf_la_peinture_180k.gc", "surf_webgcode_46k.ngc",
    "tp_random_lines_0.001in.ngc", "tp_trochoidal.ngc", "tp_zigzag.ngc",
)  # fmt: skip
# Without a path mode: P is what the machine says.
OWN = (
    ("micro-segments", lambda: programs.micro("", 2500)),
    ("zigzag 1 mm", lambda: programs.zigzag("", 60, 1.0)),
    ("zigzag 10 mm", lambda: programs.zigzag("", 20, 10.0)),
    ("two edges of 2 mm", lambda: programs.zigzag("", 2, 2.0)),
    ("butterfly, chords of 5 µm", lambda: programs.butterfly("", 0.005)),
)


@dataclass
class Tried:
    """A program, its machine, and the times that it takes."""

    name: str
    text: bytes
    machine: Machine
    times: dict = field(default_factory=dict)

    def time_of(self, values):
        """Return the time with these values [s], None if that is not tried."""
        key = tuple(sorted(values.items()))
        if key not in self.times:
            self.times[key] = self._time_of(**values)
        return self.times[key]

    def _time_of(self, override, **values):
        program = Program(self.text, changed(self.machine, **values), file=self.name)
        planned_s = Plan(program, keep=False).time_s
        if override == 100:
            return planned_s
        if planned_s > SHORT_S:
            return None
        commands = [(0, "override", override, 100)]
        return Trace(program, keep=False, commands=commands).summary["time_s"]


def changed(machine, *, a, j, v, P, window, slope):
    """Return a machine with limits of every axis times factors, and settings of its path."""
    keys = [f"path.slope={slope}", f"path.tolerance_mm={P}", f"path.lookahead_blocks={window}"]
    units = {"v": "s", "a": "s2", "j": "s3"}
    for kind, factor in (("v", v), ("a", a), ("j", j)):
        for axis, limit in zip(machine.axes, machine.limits(f"{kind}_max"), strict=True):
            unit = "deg" if axis in "abc" else "mm"
            keys.append(f"axis.{axis}.{kind}_max_{unit}_{units[kind]}={limit * factor:.12g}")
    return Machine.load(machine, set=keys)


def cases():
    """Return the programs, those of the corpus only if it is there."""
    found = [Tried(name, make(), programs.machine()) for name, make in OWN]
    settings = {name: (machine, changes) for name, machine, changes in corpus.RUNNING}
    for name in CORPUS:
        file, (machine, changes) = corpus.FOLDER / name, settings[name]
        if file.exists():
            lines = file.read_bytes().splitlines(keepends=True)
            text = b"".join(lines[:LINES])
            found.append(Tried(name, text, Machine.load(machine, set=changes)))
    return found


def bench_monotony_rows(some=None, walks=WALKS):
    """Return rows {program, more, from, to, at, from_s, to_s, slower}, the worst first.

    Parameters
    ----------
    some : iterable of Tried, optional
        Programs in place of `cases`.
    walks : iterable of (str, tuple, dict)
        As `WALKS`.
    """
    rows = [row for case in some or cases() for row in _steps(case, walks)]
    slower = sorted((row for row in rows if row["slower"] > MOST - 1), key=_slower, reverse=True)
    total = dict.fromkeys(rows[0]) | {"program": f"{len(rows)} steps, {len(slower)} slower"}
    return [*slower, total]


def _slower(row):
    return row["slower"]


def _steps(case, walks):
    """Yield a row for every step of a program."""
    for more, through, others in walks:
        for kept in itertools.product(*others.values()):
            at = dict(zip(others, kept, strict=True))
            timed = [case.time_of(BASE | at | {more: value}) for value in through]
            for k, (before, behind) in enumerate(itertools.pairwise(timed)):
                if before is not None and behind is not None:
                    yield {
                        "program": case.name, "more": more,
                        "from": str(through[k]), "to": str(through[k + 1]),
                        "at": " ".join(f"{name} {value}" for name, value in at.items()),
                        "from_s": before, "to_s": behind,
                        "slower": behind / before - 1 if before else 0.0,
                    }  # fmt: skip
