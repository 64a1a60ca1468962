# SPDX-License-Identifier: MIT
"""Cao's experiments with grades, as data: the bubble step by step, and what grades cost."""

from importlib import resources

import numpy as np

from pycnc import stages
from pycnc.planning import grades
from pycnc.machine import Machine
from pycnc.papers import paths
from pycnc.program import Program
from pycnc.report.trace import run

WORKED_EXAMPLE = (1, 5, 2, 5, 3, 1)  # Cao, figure 10: preplanned grades of p1 to p6
_FEW_BLOCKS, _MANY_BLOCKS = 200, 5000


def sweeps(preplanned):
    """Return the grades before the bubble and after every sweep that changes one.

    Every sweep is the race-free form: g'_i = min(p_i, g_{i−1} + 1, g_{i+1} + 1).

    Examples
    --------
    >>> [grades.tolist() for grades in sweeps([1, 5, 2, 5, 3, 1])]
    [[1, 5, 2, 5, 3, 1], [1, 2, 2, 3, 2, 1]]
    """
    done = [np.asarray(preplanned)]
    while True:
        g = done[-1]
        gathered = g.copy()
        gathered[1:] = np.minimum(gathered[1:], g[:-1] + 1)
        gathered[:-1] = np.minimum(gathered[:-1], g[1:] + 1)
        if np.array_equal(gathered, g):
            return done
        done.append(gathered)


def exact_path(name):
    """Return a shipped machine as grades are compared on it: linear slope, no tolerance."""
    return Machine.load(name, set={"path.slope": "linear", "path.tolerance_mm": 0})


def programs():
    """Return name → (NC text, machine) of the programs that grades are tried on."""
    example = resources.files("pycnc").joinpath("examples")
    mill, lathe = exact_path("mill3"), exact_path("cak6150n")
    return {
        "lathe8": (paths.lathe8_program().encode(), Machine.load("cao2014")),
        "turned_pin": (example.joinpath("turned_pin.ngc").read_bytes(), lathe),
        "first_part": (example.joinpath("first_part.ngc").read_bytes(), mill),
        "freeform": (freeform_program(_MANY_BLOCKS).encode(), mill),
    }


def freeform_program(blocks):
    """Return the wavy surface of paths.freeform as NC text."""
    points = paths.freeform(blocks)
    feed = paths.FREEFORM_FEED_MM_S * 60
    lines = ["G21 G17 G90 G61 G94", "G0 X0 Y0 Z0", f"F{feed:.0f}"]
    lines += [f"G1 X{x:.6f} Y{y:.6f} Z{z:.6f}" for x, y, z in points[1:]]
    return "\n".join([*lines, "M2", ""])


def chart(text, machine, stretch=-1):
    """Return (s, sweeps) of one stretch of a program: the grades of its points, figure 9 to 12.

    Parameters
    ----------
    text : bytes
    machine : Machine
    stretch : int
        Which one, from rest to rest; the last one by default.

    Returns
    -------
    s : numpy.ndarray
        (n,) path coordinate of the points from the stretch's start [mm].
    sweeps : list of numpy.ndarray
        (n,) grades before the bubble and after each sweep.
    """
    plan, _ = grades.of_text(text, machine)
    units, points = _of_stretches(plan)[stretch]
    s = np.concatenate([[0], np.cumsum(plan.units["length"][units])])
    return s, sweeps(plan.preplanned[points])


def charts():
    """Return (title, s, sweeps) of the illustration path, and of a pass over the wavy surface."""
    text, machine = programs()["lathe8"]
    wavy = freeform_program(_FEW_BLOCKS).encode()
    return [
        ("eight segments on cao2014", *chart(text, machine)),
        ("one pass over the wavy surface on mill3", *chart(wavy, exact_path("mill3"))),
    ]


def _of_stretches(plan):
    """Return (units, points) of every stretch, two slices each."""
    found = []
    for k, stretch in enumerate(plan.stretches):
        begin, end = int(stretch["unit_begin"]), int(stretch["unit_end"])
        found.append((slice(begin, end), slice(begin + k, end + k + 1)))
    return found


def cost_rows(steps=(1, 2, 4, 8)):
    """Return what grades cost in machining time against the exact envelope.

    Returns
    -------
    list of dict
        program, steps (n of eq. 10), units, grades (most of any stretch), time_s by grades,
        same_caps_s by the exact envelope under the caps of the same units, cost_percent of the
        former over the latter, kernel_s: the kernel's own exact plan, whose corners also leave
        room for the acceleration along the path.
    """
    rows = []
    for name, (text, machine) in programs().items():
        for n in steps:
            plan, exact = grades.of_text(text, machine, steps=n)
            by_grades, same_caps = _moving_times(plan)
            rows.append({
                "program": name,
                "steps": n,
                "units": len(plan.units),
                "grades": int(plan.stretches["rule"]["count"].max()),
                "time_s": round(by_grades, 3),
                "same_caps_s": round(same_caps, 3),
                "cost_percent": round(100 * (by_grades / same_caps - 1), 2),
                "kernel_s": round(float(exact["cut_s"] + exact["rapid_s"]), 3),
            })  # fmt: skip
    return rows


def _moving_times(plan):
    """Return the time of all moves by their grades, and by the exact envelope under their caps."""
    cells = plan.cells()
    by_grades = float(cells["duration"][cells["length"] > 0].sum())
    exact = 0.0
    for (units, points), stretch in zip(_of_stretches(plan), plan.stretches, strict=True):
        exact += stages.slope(
            plan.units["length"][units], plan.v[units], stretch["rule"]["a"], None,
            plan.v_transfer[points],
        ).time_s  # fmt: skip
    return by_grades, exact


def lathe_runs():
    """Return kind of planning → Trace of the turned pin on the lathe of the paper, CAK6150N."""
    text, machine = programs()["turned_pin"]
    program = Program(text, machine, file="turned_pin.ngc")
    return {kind: run(program, plan=kind) for kind in ("exact", "grades")}
