# SPDX-License-Identifier: MIT
"""What the tests of the firmware share: programs, and promises that a run's trace must keep."""

import math
from typing import NamedTuple

import cases
import numpy as np

from pycnc import controller
from pycnc.machine import Machine

SLOPES = ("linear", "jerk")
EVERYWHERE = ("host", "m7")  # where the faults are tried
PERIOD_S = 1e-3
NM = 1e-6  # mm
PERIOD_UNITS = 25_000  # of the controllers' clock
END_NM = (24_000_000, -6_000_000, 0)
# A way that never crosses itself: straight moves of 2 to 25 mm, and many of 0.1 mm.
POINTS = [(0, 0), (25, 0), (25, 10), (12, 10), (10, 12), (12, 15), (40, 15), (40, 2)]
POINTS += [(40 - 0.1 * k, 2 + 3 * math.sin(k / 25) - 0.02 * k) for k in range(1, 100)]
POINTS += [(30, -5), (24, -6)]
PROGRAM = cases.polyline(POINTS, feed=3000)
WAVE = [(0.05 * k, 0.4 * math.sin(k / 9)) for k in range(1500)]  # a long way for a small window
WAVE_END_NM = (*(round(1e6 * x) for x in WAVE[-1]), 0)
ERROR = cases.polyline(POINTS[:6], feed=3000).replace("M2", "G1 X12 Y15.5\nG87\nG1 X30")


def opened(name, tool):
    """Open a controller, or skip where its tools are missing."""
    if name != "host":
        tool("arm-none-eabi-gcc"), tool("qemu-system-arm")
    return controller.open(name)


class Change(NamedTuple):
    """Something that the board switched, and how long ago the watchdog was fed then."""

    output: str
    value: int
    unfed: int


def run_in(folder, chosen, program, commands=(), **conditions):
    """Run a program in a folder; return why it stopped ("" for a whole run) and what was switched.

    A run that a handler or the watchdog has ended leaves no report, but its outputs.
    """
    job = [*controller._settings(mill()), *controller._conditions(conditions, True)]
    (folder / "job").write_text("\n".join([*job, *controller._commands(commands)]) + "\n")
    (folder / "program").write_text(program)
    cause = ""
    try:
        chosen._execute(folder, 60, None)
    except controller.FirmwareError as error:
        cause = str(error).partition(" stopped: ")[2]
    kind = [("output", "<u4"), ("value", "<i4"), ("unfed", "<u4")]
    rows = np.fromfile(folder / "outputs", kind).tolist()
    return cause, [Change(("drives", "spindle", "coolant")[k], *rest) for k, *rest in rows]


def report_in(folder):
    """Return the last state of a whole run, the tick that it came after, and the run's rows."""
    report = controller._read_report(folder / "report")
    tick, code = report["event"][-1]
    names = report["names"].split()
    return names[int(code)], int(tick), controller._read_rows(folder / "trace", report)


def is_safe(changes):
    """Drives, spindle and coolant were on, and are off since: nothing is switched on again."""
    last = {change.output: change.value for change in changes}
    once_off = [change.value for change in changes if change.value == 0]
    return last == {"drives": 0, "spindle": 0, "coolant": 0} and once_off == [0, 0, 0]


def mill(slope="jerk", **changes):
    return Machine.load("mill3", set={"path.slope": slope, **changes})


def long_way():
    return cases.polyline(WAVE, feed=3000)


def motion(outcome):
    """Return (joints [mm], speeds, accelerations) of a run from its start at zero."""
    joints = np.vstack([np.zeros((2, 3)), outcome.rows["joint_nm"] * NM])
    v, a = np.diff(joints[1:], axis=0), np.diff(joints, n=2, axis=0)
    return joints[2:], v / PERIOD_S, a / PERIOD_S**2


def hold_limits(outcome, machine):
    """Every axis keeps its speed and acceleration at every tick, rounding to nanometres aside."""
    _, v, a = motion(outcome)
    assert (np.abs(v) <= machine.limits("v_max") * (1 + 1e-6) + 2 * NM / PERIOD_S).all()
    assert (np.abs(a) <= machine.limits("a_max") * (1 + 1e-6) + 4 * NM / PERIOD_S**2).all()


def nearest(joints, start, way):
    """Return (segment, share of it, distance) of the point of a way nearest to each setpoint."""
    low, high = joints.min(axis=0) - 1, joints.max(axis=0) + 1
    least, most = np.minimum(start, start + way), np.maximum(start, start + way)
    near = np.flatnonzero(((least <= high) & (most >= low)).all(axis=1))
    start, way = start[near], way[near]
    share = np.einsum("tsj,sj->ts", joints[:, None] - start, way) / (way**2).sum(axis=1)
    share = np.clip(share, 0, 1)
    apart = np.linalg.norm(joints[:, None] - (start + share[..., None] * way), axis=2)
    best, rows = apart.argmin(axis=1), np.arange(len(joints))
    return near[best], share[rows, best], apart[rows, best]


def along(outcome, points=POINTS):
    """Return how far along the way each setpoint is; all of them must be on it."""
    joints = outcome.rows["joint_nm"][:, :2] * NM
    points = np.round(np.array(points, float), 6)
    way = np.diff(points, axis=0)
    length = np.linalg.norm(way, axis=1)
    begin = np.concatenate([[0], np.cumsum(length)])
    done = []
    for part in np.array_split(joints, len(joints) // 100 + 1):
        segment, share, apart = nearest(part, points[:-1], way)
        assert apart.max() < 2e-6
        done.append(begin[segment] + share * length[segment])
    done = np.concatenate(done)
    assert (np.diff(done) >= -3e-6).all(), "the run goes backward on the path"
    return done


def rests_at_its_end(outcome):
    """The last setpoints are the same, to the nanometre, and are what the report says."""
    last = outcome.rows["joint_nm"][-8:]
    assert (last == last[-1]).all()
    assert tuple(last[-1]) == outcome.joints_nm
