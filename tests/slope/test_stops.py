# SPDX-License-Identifier: MIT
"""A hold, an abort and an override of zero are heard within ten periods, and the path rests within
what braking takes and 21 periods; within a tolerance it takes longer, and no longer than told in
docs/controller.md."""

import re

import numpy as np
import pytest

import pycnc
from pycnc.bench import programs, stops
from pycnc.program import Program

HEARD = 10
SPARE = 21  # periods beyond v/a + a/j


@pytest.mark.parametrize("event", stops.EVENTS)
@pytest.mark.parametrize("slope", stops.SLOPES)
def test_a_line_of_a_metre_is_left_at_once(slope, event):
    told = stops.row(slope, "a line of 1 m", event, moments=2)
    assert told["heard_ms"] <= HEARD or event == "override 0"
    assert told["rest_worst_ms"] <= told["least_worst_ms"] + SPARE + 20 * (event == "override 0")


@pytest.mark.thorough
@pytest.mark.sample(3)
@pytest.mark.parametrize("event", ["hold", "abort"])
@pytest.mark.parametrize("slope", stops.SLOPES)
def test_blocks_of_a_micrometre_stop_as_a_line_does(slope, event):
    told = stops.row(slope, "blocks of 1 µm", event, moments=3)
    assert told["rest_worst_ms"] <= told["least_worst_ms"] + SPARE + told["heard_ms"]


@pytest.mark.thorough
@pytest.mark.sample(3)
@pytest.mark.parametrize(
    "slope, name, most_ms",
    [
        ("linear", "micro-segments, exact", 175), ("jerk", "micro-segments, exact", 360),
        ("optimal", "micro-segments, P0.01", 390), ("optimal", "zigzag 10 mm, P0.01", 260),
    ],
)  # fmt: skip
def test_many_segments_stop_no_later_than_told(slope, name, most_ms):
    assert stops.row(slope, name, "hold", moments=3)["rest_worst_ms"] <= most_ms


@pytest.mark.parametrize("tick", [900, 1200, 1500])
def test_behind_an_override_that_came_down_a_slower_move_is_entered_at_its_own_feed(tick):
    text = f"{programs.head('G64 P0.01')}G1 X250 F4800\nX400 F2400\nM2\n"
    commands = [(1, "override", 200, 100), (tick, "override", 100, 100)]
    trace = pycnc.run(Program(text.encode(), programs.machine("jerk")), commands=commands)
    slow = trace["s_mm"] >= 250
    assert trace["vel_mm_s"][~slow].max() > 99
    assert trace["vel_mm_s"][slow].max() < 40.5


def peaks_of_axes(run, kinds="va"):
    """Return the largest share of an axis' limits: v, a, j."""
    peaks = run.summary["peaks"]
    return max(peaks[axis][kind] for axis in peaks if axis != "path" for kind in kinds)


@pytest.mark.sample(3)
@pytest.mark.parametrize("slope, name", [("linear", "micro-segments, exact"),
                                         *(("optimal", name) for name in stops.SMOOTHED)])
def test_every_axis_keeps_its_limits_while_it_stops(slope, name):
    text, machine = stops.PROGRAMS[name](), programs.machine(slope, stops.A, stops.J)
    moments = zip(np.linspace(300, 8300, 24).astype(int), 8 * list(stops.EVENTS), strict=True)
    for tick, event in moments:
        command = (int(tick), *stops.EVENTS[event])
        run = pycnc.run(text, machine=machine, commands=[command])
        kinds, more = ("va", 1e-6) if slope == "linear" else ("vaj", 0.05)  # as in stop_gate.py
        assert peaks_of_axes(run, kinds) <= 1 + more, tick


def test_a_linear_hold_keeps_the_limits_of_an_even_polygon():
    text, machine = programs.micro("G61"), programs.machine("linear", stops.A, stops.J)
    for tick in np.linspace(300, 8300, 12).astype(int):
        run = pycnc.run(text, machine=machine, commands=[(int(tick), "hold")])
        assert peaks_of_axes(run) <= 1 + 1e-6, tick


@pytest.mark.parametrize("tick", range(1650, 1750, 10))
def test_a_linear_hold_keeps_limits_where_an_override_passes_a_slow_feed(tick):
    turn = np.linspace(0, 4 * np.pi, 800)
    points = zip(8 * np.cos(turn) - 8, 8 * np.sin(turn), strict=True)
    chords = "\n".join(f"G1 X{x:.6f} Y{y:.6f}" for x, y in points)
    text = f"{programs.head('G64 P0.01')}F1200\n{chords}\nM2\n"
    commands = [(1, "override", 200, 100), (tick, "hold")]
    machine = programs.machine("linear", stops.A, stops.J)
    assert peaks_of_axes(pycnc.run(text, machine=machine, commands=commands)) <= 1 + 1e-6


def test_the_page_has_a_row_for_every_slope_and_program(root):
    page = (root / "docs" / "controller.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `(\w+)`, (.+?) \|(?: +[\d–]+ \|){4}$", page, re.M)
    assert rows == stops.ROWS
