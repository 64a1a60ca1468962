# SPDX-License-Identifier: MIT
"""A print that begins in the middle goes on under the limits and shares that it has set before."""

import random

import pytest
from test_control import machine_of

from pycnc.machine import Machine
from pycnc.planning.plan import Plan
from pycnc.program import load

LIMITS = {
    "marlin": ("M201 X{a} Y{a}", "M203 X{v} Y{v}", "M204 P{a} T{b}", "M204 S{b} R{a}", "M205 X{c}",
               "M205 J0.0{c}", "M220 S{p}", "M221 S{p}", "M205 B{b}"),
    "klipper": ("SET_VELOCITY_LIMIT ACCEL={a}", "SET_VELOCITY_LIMIT VELOCITY={v}", "M204 S{b}",
                "SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY={c} MINIMUM_CRUISE_RATIO=0.{c}",
                "M220 S{p}", "M221 S{p}", "M204 P{a} T{b}"),
}  # fmt: skip


def written(pen, kind):
    """Return (text, line of a rest) of a print that sets limits before it and behind it."""
    rows = ["G21 G90", "M82", "G1 Z20 F900"]
    rests, e = [], 0.0
    for _ in range(pen.randrange(30, 90)):
        word = pen.choice(LIMITS[kind]).format(
            a=pen.randrange(100, 3000), b=pen.randrange(100, 3000), v=pen.randrange(10, 200),
            c=pen.randrange(1, 10), p=pen.choice([20, 50, 80, 120, 300]),
        )  # fmt: skip
        e += pen.choice([0, 0, 0.4, -0.3])
        place = f"X{pen.uniform(0, 90):.2f} Y{pen.uniform(0, 90):.2f}"
        row = pen.choice([f"G1 {place} E{e:.2f}", f"G0 {place} F{pen.randrange(600, 9000)}", word])
        rows.append(row)
        if pen.random() < 0.2:
            rows.append("G4 P1")
            rests.append(len(rows))
    rows += ["G4 P1", "G1 X3 F1200"]
    return "\n".join([*rows, ""]).encode(), pen.choice(rests or [len(rows) - 1])


def _behind(text, machine, line):
    """Return the time of each line behind a rest."""
    parts = Plan(load(text, machine), keep=False, by="line").parts
    return {part["line"]: part["time_s"] for part in parts if part["line"] > line}


@pytest.mark.sample(40)
@pytest.mark.parametrize("number", range(1000))
@pytest.mark.parametrize("kind", sorted(LIMITS))
def test_behind_a_rest_each_line_takes_what_it_takes_in_the_whole(kind, number, draw_seed):
    pen = random.Random(draw_seed + number)
    text, line = written(pen, kind)
    bare = machine_of(kind, acceleration=1000) if kind == "marlin" else machine_of(kind)
    more = {"axis.z.min_mm": -5, "axis.z.max_mm": 300}
    whole, later = (Machine.load(bare, set={**more, "dialect.from_line": at}) for at in (0, line))
    expected = _behind(text, whole, line)
    assert expected
    assert _behind(text, later, line) == pytest.approx(expected, rel=1e-6, abs=1e-9)
