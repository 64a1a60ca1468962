# SPDX-License-Identifier: MIT
"""How soon the path rests after the operator wants it to: every slope, its programs, hold, abort
and an override of zero, at moments spread over the run.

`heard` is the first tick that is slower than without the event, `rest` the first of the rest;
`least` is v/a + a/j at the speed of the event, what braking in a straight line takes.
"""

import numpy as np

import pycnc
from pycnc.bench import programs

SLOPES = ("linear", "jerk")  # that take the exact path
EVENTS = {"hold": ("hold",), "abort": ("abort",), "override 0": ("override", 0, 0)}
A, J = 1000, 10_000  # of the machine of the programs [mm/s², mm/s³]


def _line():
    return "G21 G90 G94 G61\nG1 F6000 X1000\nM2\n"


def _micrometres():
    blocks = "".join(f"X{0.001 * k:.3f}\n" for k in range(1, 8001))
    return f"G21 G90 G94 G61\nG1 F6000\n{blocks}M2\n"


PROGRAMS = {
    "a line of 1 m": _line,
    "blocks of 1 µm": _micrometres,
    "micro-segments, exact": lambda: programs.micro("G61"),
    "micro-segments, P0.01": lambda: programs.micro("G64 P0.01"),
    "zigzag 10 mm, P0.01": lambda: programs.zigzag("G64 P0.01", 60, 10.0),
}

SMOOTHED = [name for name in PROGRAMS if "P0.01" in name]  # the optimal slope's
EXACT = [name for name in PROGRAMS if name not in SMOOTHED]
ROWS = [(slope, name) for slope in SLOPES for name in EXACT]
ROWS += [("optimal", name) for name in SMOOTHED]


def _stop(undisturbed, text, machine, tick, event):
    """Return the ticks until an event is heard, and until the path rests."""
    speed = pycnc.run(text, machine=machine, commands=[(tick, *event)])["vel_mm_s"]
    both = min(len(speed), len(undisturbed))
    slower = np.flatnonzero(speed[tick:both] < undisturbed[tick:both] * (1 - 1e-9) - 1e-9)
    heard = int(slower[0]) if len(slower) else both - tick
    moving = np.flatnonzero(speed > 1e-9)
    return heard, int(moving[-1]) + 1 - tick


def row(slope, name, event, moments=8):
    """Return one row: ticks of 1 ms over the moments of a program.

    Parameters
    ----------
    slope : {"linear", "jerk", "optimal"}
    name : str
        Of `PROGRAMS`.
    event : str
        Of `EVENTS`.
    moments : int
        How many, evenly spread over the run.

    Returns
    -------
    dict
        heard (the latest), rest_mean, rest_worst and least_worst in ms.
    """
    machine, text = programs.machine(slope, A, J), PROGRAMS[name]()
    undisturbed = pycnc.run(text, machine=machine)["vel_mm_s"]
    ticks = np.linspace(0.1, 0.9, moments) * len(undisturbed)
    stops = [_stop(undisturbed, text, machine, int(k), EVENTS[event]) for k in ticks]
    heard, rest = np.array(stops).T
    v = undisturbed[ticks.astype(int)]
    least = 1000 * (v / A + (A / J if slope != "linear" else 0))
    return {
        "slope": slope, "program": name, "event": event, "heard_ms": int(heard.max()),
        "rest_mean_ms": round(float(rest.mean())), "rest_worst_ms": int(rest.max()),
        "least_worst_ms": round(float(least.max())),
    }  # fmt: skip


def bench_stops_rows():
    """Return a row for every slope, program of it and event."""
    return [row(slope, name, event) for slope, name in ROWS for event in EVENTS]
