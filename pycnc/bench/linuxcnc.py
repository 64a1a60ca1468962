# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench linuxcnc`, `butterfly` and `window`: machining times of whole programs.

Times and peaks are those of the emitted setpoints. Peaks are shares of the limits: v, a and j are
the largest of any axis, path_j is that of the path coordinate. The columns of LinuxCNC are times
that its full simulation took with the same limits (1 ms servo period; 2.9 with its trapezoid, which
does not limit jerk, and 2.10 with its S-curve, which holds axis jerk to 1.3 to 2 times the limit),
as docs/planner.md has them; nothing of it is run here. bound_s is a lower bound, by a linear
program for each axis, for everything within the same tolerance and limits. These numbers are the
same on every computer; a missing path_error or time would mean that the program was refused.
"""

from pycnc.bench import programs
from pycnc.kernel.bind import lib
from pycnc.machine import Machine
from pycnc.planning.plan import Plan
from pycnc.program import Program
from pycnc.report.trace import Trace

# (name, program, path mode, LinuxCNC 2.9 trapezoid, 2.10 S-curve, lower bound [s])
CASES = (
    ("micro-segments", programs.micro, "G64 P0.01", 7.656, 53.6, 7.9),
    ("micro-segments", programs.micro, "G64 P0.01 Q0", 22.18, None, 7.9),
    ("micro-segments", programs.micro, "G61", 162.1, None, None),
    ("zigzag 1 mm", programs.zigzag, "G64 P0.01", 24.64, 52.0, 39.3),
    ("zigzag 1 mm", programs.zigzag, "G64 P0.1", 20.5, 145.0, 28.5),
    ("zigzag 10 mm", lambda mode: programs.zigzag(mode, 100, 10.0), "G64 P0.01", 19.97, 29.7, 26.3),
)
CHORDS_MM = (0.0005, 0.001, 0.002, 0.005, 0.01)
TOLERANCE = "G64 P0.01"
WINDOWS = (8, 16, 32, 64, 128, 256, 640, 1024, 0)  # blocks; 0: all that the kernel holds
RAMP_S = 100 / 1000 + 1000 / 10_000  # v/A + A/J of the machine of the comparison
BUTTERFLY_LIMITS = ((1000, 10_000), (3000, 50_000))  # of every axis: mm/s², mm/s³


def measured(text, machine):
    """Return {time_s, v_peak, a_peak, j_peak, path_j_peak, path_error_mm} of a run.

    Parameters
    ----------
    text : bytes
    machine : Machine

    Raises
    ------
    ProgramError
    """
    facts = Trace(Program(text, machine), keep=False).summary
    peaks = dict(facts["peaks"])
    path = peaks.pop("path")
    largest = {f"{kind}_peak": max(axis[kind] for axis in peaks.values()) for kind in "vaj"}
    return {
        "time_s": facts["time_s"],
        **largest,
        "path_j_peak": path["j"],
        "path_error_mm": facts["path_error_mm"],
    }


def bench_linuxcnc_rows(cases=CASES):
    """Return rows {program, mode, time_s, v_peak, a_peak, j_peak, path_j_peak, path_error_mm,
    linuxcnc_trapezoid_s, linuxcnc_s_curve_s, bound_s}."""
    machine = programs.machine()
    return [
        {
            "program": name,
            "mode": mode,
            **measured(make(mode), machine),
            "linuxcnc_trapezoid_s": trapezoid,
            "linuxcnc_s_curve_s": s_curve,
            "bound_s": bound,
        }
        for name, make, mode, trapezoid, s_curve, bound in cases
    ]


def bench_butterfly_rows(chords_mm=CHORDS_MM, limits=BUTTERFLY_LIMITS):
    """Return rows {chord_mm, a, j, lines, time_s, ratio, v_peak, a_peak, j_peak, path_j_peak,
    path_error_mm}.

    ratio: time over the least time of the same limits, any chords.
    """
    rows = []
    for a, j in limits:
        machine = programs.machine(a=a, j=j)
        some = [_butterfly_row(chord_mm, a, j, machine) for chord_mm in chords_mm]
        least = min(row["time_s"] for row in some)
        rows += [row | {"ratio": row["time_s"] / least} for row in some]
    return rows


def _butterfly_row(chord_mm, a, j, machine):
    text = programs.butterfly(TOLERANCE, chord_mm)
    return {
        "chord_mm": chord_mm,
        "a": a,
        "j": j,
        "lines": text.count(b"\n"),
        "ratio": None,
        **measured(text, machine),
    }


def bench_window_rows(modes=("G64 P0.01", "G61"), windows=WINDOWS):
    """Return rows {program, mode, lookahead_blocks, time_s, ratio, ramps}.

    Planned times of the micro-segments with a look-ahead of so many blocks; ratio: over the time
    with all of the window; ramps: how long the blocks last at the mean speed of that, over v/A +
    A/J.
    """
    rows = []
    for mode in modes:
        text, machine = programs.micro(mode), programs.machine()
        program = Program(text, machine)
        whole = Plan(program, keep=False)
        each_s = whole.time_s / int((program.blocks["kind"] <= lib.NCK_BLOCK_ARC).sum())
        for blocks in windows:
            changed = Machine.load(machine, set={"path.lookahead_blocks": blocks})
            time_s = Plan(Program(text, changed), keep=False).time_s
            rows.append(
                {
                    "program": "micro-segments",
                    "mode": mode,
                    "lookahead_blocks": blocks,
                    "time_s": time_s,
                    "ratio": time_s / whole.time_s,
                    "ramps": blocks * each_s / RAMP_S if blocks else None,
                }
            )
    return rows
