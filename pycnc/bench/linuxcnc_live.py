# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench linuxcnc --live`: this planner against LinuxCNC's own, in LinuxCNC.

Each program runs in the LinuxCNC that is installed here, with its own planner (stock), with this
one without a jerk limit (linear) and with it (nck), all with 100 mm/s, 1000 mm/s² and 10 000
mm/s³ for each axis. Times are from the first to the last setpoint that differs; peaks are
shares of an axis' limits, of the nck run; off_mm is the largest distance of a setpoint from
the programmed lines. same_order: the lines that both planners have told come in one order. Rows
of hold, abort and override 0: from when it was asked for until the rest; the last two with
LinuxCNC's own way to the planner, some 10 ms. Rows of threads: phase_um is by how much the tool
leaves its thread while the spindle cuts at constant speed, over all passes. cycle_mean: of the
motion controller's function, LinuxCNC's own share in it, over the stock planner's in the same
program; cycle_worst: the longest one over the same. What the system does meanwhile counts too,
without a realtime kernel. Times of motion are the same on every computer where moves come in time
(with Q0 they do not); those of cycles are not. nck_tp has to be installed (docs/linuxcnc.md).
"""

import re
import tempfile
from pathlib import Path

import numpy as np

from pycnc.bench import programs
from pycnc.linuxcnc import live

STOCK, LINEAR, OURS = "", "nck_tp planner=linear", "nck_tp"
EXAMPLES = Path("/usr/share/linuxcnc/ncfiles")
NEAR = 400  # lines on either side among which the nearest one is sought
CASES = (
    ("micro", programs.micro, "G64 P0.01"),
    ("micro", programs.micro, "G64 P0.01 Q0.001"),
    ("micro", programs.micro, "G64 P0.01 Q0"),
    ("zigzag 10 mm", lambda mode: programs.zigzag(mode, 100, 10.0), "G64 P0.01"),
)
SHIPPED = (
    ("3dtest.ngc", "XYZ"), ("comp.ngc", "XYZ"), ("polar.ngc", "XYZ"), ("lathecomp.ngc", "XZ"),
)  # fmt: skip
STOPS = (1, 3)  # of CASES
STOP_AFTER_S = 1.0
ASKED = {
    "hold": [(STOP_AFTER_S, "hold")],
    "abort": [(STOP_AFTER_S, "mark"), (0, "abort")],
    "override 0": [(STOP_AFTER_S, "mark"), (0, "override", 0.0)],
}
LEAD = 2.0  # of the threads [mm]
CUTS = (-5.0, -15.0)  # of Z, where a thread is at its speed [mm]
THREADS = (
    ("G33", "G0 X0 Z2\nG33 Z-20 K2"),
    ("G76", "G0 X10 Z2\nG76 P2 Z-20 I-1 J0.4 K1.2 R1 Q0 H0 E0 L0"),
    ("G95", "G95 F2\nG0 X0 Z2\nG1 Z-20"),
    ("G33.1", "G0 X0 Z2\nG33.1 Z-20 K2"),
)


def _run(text, planner, axes="XYZ", script=()):
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)
        return live.run(folder, text, planner=planner, axes=axes, script=script)


def _points(text):
    """Return the points of a program of G0 and G1 with X Y Z."""
    place, points = [0.0, 0.0, 0.0], [(0.0, 0.0, 0.0)]
    for line in text.splitlines():
        for letter, number in re.findall(r"([XYZ])\s*(-?[\d.]+)", line):
            place["XYZ".index(letter)] = float(number)
        if tuple(place) != points[-1]:
            points.append(tuple(place))
    return np.array(points)


def _off(places, points):
    """Return the largest distance of a place from the lines, followed in their order."""
    begins, ways = points[:-1], np.diff(points, axis=0)
    squares, at, worst = (ways**2).sum(axis=1), 0, 0.0
    for place in places:
        part = slice(max(0, at - 3), at + NEAR)
        away = place - begins[part]
        share = np.clip((away * ways[part]).sum(axis=1) / squares[part], 0, 1)
        distance = np.linalg.norm(away - share[:, None] * ways[part], axis=1)
        at = part.start + int(distance.argmin())
        worst = max(worst, float(distance.min()))
    return worst


def _order(log):
    """Return the program's lines as the planner has told them, each once in a row."""
    lines = log.line[log.line > 0].astype(int)
    return lines[np.flatnonzero(np.diff(lines, prepend=-1))].tolist()


def _is_same_order(one, other):
    """Return whether the lines that both have come in one order."""
    short, long = sorted((_order(one), _order(other)), key=len)
    rest = iter(long)
    return all(line in rest for line in short)


def _row(name, mode, text, axes, points=None):
    stock, linear, ours = (_run(text, planner, axes) for planner in (STOCK, LINEAR, OURS))
    v, a, j = ours.peaks(live.Limits())
    ends = float(np.abs(stock.places[-1] - ours.places[-1]).max())
    return {
        "program": name, "mode": mode, "stock_s": stock.time_s, "linear_s": linear.time_s,
        "linear/stock": linear.time_s / stock.time_s, "nck_s": ours.time_s, "v_peak": v,
        "a_peak": a, "j_peak": j, "ends_apart_mm": ends, "same_order": _is_same_order(stock, ours),
        "off_mm": None if points is None else _off(ours.places, points),
        "cycle_mean": ours.time.mean() / stock.time.mean(),
        "cycle_worst": ours.time.max() / stock.time.mean(),
    }  # fmt: skip


def _stop_row(name, mode, text, asked):
    """Return how long both planners take to rest; the program ends there."""
    script = [*ASKED[asked], (STOP_AFTER_S, "abort"), (0, "override", 1.0), (0, "go on")]
    stock, ours = (_run(text, planner, script=script) for planner in (STOCK, OURS))
    return {"program": f"{name}: {asked}", "mode": mode, "stock_s": stock.rest_s(),
            "nck_s": ours.rest_s()}  # fmt: skip


def phase_um(log):
    """Return by how much the tool leaves its thread; passes begin a whole revolution apart."""
    z, step = log.places[:, 2], LEAD * np.gradient(log.turns)
    rows = (z < CUTS[0]) & (z > CUTS[1]) & (np.abs(np.gradient(z) + step) < 0.02 * np.abs(step))
    off = (z[rows] / LEAD + log.turns[rows]) % 1.0
    away = (off - off[0] + 0.5) % 1.0 if len(off) else np.full(1, np.nan)
    return float(np.ptp(away)) * LEAD * 1000


def thread(lines):
    """Return the program of a thread: its lines, the spindle before and behind."""
    return f"G21 G18 G90 G64 P0.01\nM3 S600\nG4 P1\nG1 F1200 X0 Z2\n{lines}\nG0 X0\nM5\nM2\n"


def _thread_row(name, lines):
    text = thread(lines)
    stock, ours = (_run(text, planner) for planner in (STOCK, OURS))
    v, a, j = ours.peaks(live.Limits())
    return {"program": name, "mode": "S600, 2 mm", "stock_s": stock.time_s,
            "nck_s": ours.time_s, "v_peak": v, "a_peak": a, "j_peak": j,
            "stock_phase_um": phase_um(stock), "phase_um": phase_um(ours)}  # fmt: skip


def each_live_row():
    """Yield the rows of `bench_live_rows`, each as soon as it is there."""
    texts = [(name, mode, make(mode).decode()) for name, make, mode in CASES]
    for each in texts:
        yield _row(*each, "XYZ", _points(each[2]))
    for k in STOPS:
        for asked in ASKED:
            yield _stop_row(*texts[k], asked)
    for each in THREADS:
        yield _thread_row(*each)
    for name, axes in SHIPPED:
        text = (EXAMPLES / name).read_text(encoding="utf-8", errors="replace")
        yield _row(name, "its own", text, axes)


def bench_live_rows():
    """Return rows {program, mode, stock_s, linear_s, linear/stock, nck_s, v_peak, a_peak, j_peak,
    ends_apart_mm, same_order, off_mm, cycle_mean, cycle_worst, stock_phase_um, phase_um}."""
    return list(each_live_row())
