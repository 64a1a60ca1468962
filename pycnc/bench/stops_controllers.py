# SPDX-License-Identifier: MIT
"""How soon a controller rests: two slopes, three programs, a hold, an abort, an overrun and a soft
limit, in the native program and on two Cortex-M under QEMU, preparation and all.

Ticks of 1 ms from the event, at tick 600, to rest; for the soft limit, set there 20 mm ahead, what
is left of them [mm]. A word behind the number: it jumped, or ended in another state. "at rest": it
had not begun, or waited for preparation. `least` is v/a + a/j.
"""

import numpy as np

from pycnc import controller
from pycnc.bench import programs, stops

TICK, MOST = 600, 8000
AHEAD_NM = 20_000_000  # the soft limit
OVERRUN = (130_000, 1)  # units of other work in one tick of 25 000
EVENTS = {
    "hold": ("hold",), "abort": ("abort",), "overrun": ("tick_work", *OVERRUN),
    "travel": None,
}  # fmt: skip
STATES = {
    "hold": "hold", "abort": "aborted", "overrun": "fault_overrun", "travel": "soft_limit",
}  # fmt: skip


def _rows(board, slope, name, commands):
    machine = programs.machine(slope, stops.A, stops.J)
    outcome = controller.open(board).run(
        stops.PROGRAMS[name](), machine, commands, trace=True, max_ticks=MOST, timeout_s=600
    )
    return outcome, outcome.rows["joint_nm"]


def _limit(joints):
    """Return the joint that moves most from here on, where it gets to, and the command."""
    begin = joints[TICK - 1]
    gone = np.linalg.norm(joints[TICK:] - begin, axis=1)
    end = joints[TICK + int(np.argmax(gone >= min(AHEAD_NM, 0.6 * gone.max())))]
    k = int(np.argmax(np.abs(end - begin)))
    ends = sorted((int(end[k]), int(begin[k] - np.sign(end[k] - begin[k]) * 10**9)))
    return k, int(end[k]), (TICK, "travel", k, *ends)


def _kept_back(joints):
    """Return whether a setpoint was kept back: a stop that no brake makes."""
    jump = np.abs(np.diff(joints, 2, axis=0)).max(axis=1) * 1e-6 / 1e-6  # mm/s² at T = 1 ms
    return jump[TICK:].max() > 1.5 * stops.A


def _told(board, slope, name, event, limit):
    k, end, travel = limit
    command = travel if event == "travel" else (TICK, *EVENTS[event])
    outcome, joints = _rows(board, slope, name, [command])
    if len(joints) <= TICK:
        return "at rest"
    if event == "travel":
        number = f"{abs(int(joints[-1][k]) - end) / 1e6:.2f}"
        number += " jumped" if _kept_back(joints) else ""
    else:
        moved = np.flatnonzero(np.any(np.diff(joints, axis=0) != 0, axis=1))
        rest = int(moved[-1]) + 2 - TICK if len(moved) else -1
        number = str(rest) if rest >= 0 else "at rest"
    return number if outcome.state == STATES[event] else f"{number} {outcome.state}"


def row(board, slope, name, events=tuple(EVENTS)):
    """Return one row of the table.

    Parameters
    ----------
    board : {"host", "m4f", "m7"}
    slope : {"linear", "jerk"}
    name : str
        Of `stops.EXACT`.
    events : sequence of str
        Of `EVENTS`.

    Returns
    -------
    dict
        controller, slope, program, an item for every event (ms, mm), least_ms.
    """
    _, joints = _rows("host", slope, name, [])
    v = float(np.linalg.norm(joints[TICK - 1] - joints[TICK - 2])) * 1e-3  # mm/s
    least = 1000 * (v / stops.A + (stops.A / stops.J if slope != "linear" else 0))
    told = {event: _told(board, slope, name, event, _limit(joints)) for event in events}
    return {"controller": board, "slope": slope, "program": name, **told, "least_ms": round(least)}


def bench_stops_controllers_rows():
    """Return a row for every controller, slope and program."""
    return [
        row(board, slope, name)
        for board in controller.CONTROLLERS
        for slope in stops.SLOPES
        for name in stops.EXACT
    ]
