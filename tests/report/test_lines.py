# SPDX-License-Identifier: MIT
"""Every tick names the line that is being cut, and every line that is cut owns its ticks."""

import numpy as np
import pytest
from cases import FAMILIES, SEEDS

from pycnc import Trace, load
from pycnc.machine import Machine
from pycnc.planning.plan import Plan
from pycnc.report import compare

HEADS = ("G61", "G64 P0.01", "G64 P0.05 Q0.05", "G64 P0.2 Q0.1")
SLOPES = ("jerk", "linear", "optimal")
NEAR_MM = 0.1  # beside the tolerance
ROUNDING_MM = 1e-6
TICKS = 2  # that a line's time may be off: where it begins and ends is between two ticks
OVERLAP_TICKS = 10  # where a stop and the start behind it overlap: each half is one motion's


def chords(program):
    """Return source line → begins and ends of its moves, and their places in X, Y, Z [mm]."""
    blocks = np.concatenate([piece.copy() for piece in program.pieces()])
    ends = blocks["target_nm"][:, :3] / 1e6
    start = program.machine.record["start_nm"][:3] / 1e6
    begins = np.vstack([start, ends[:-1]])
    found = {}
    for line, begin, end in zip(blocks["line"], begins, ends, strict=True):
        if np.any(begin != end):
            found.setdefault(int(line), []).append((begin, end))
    return found


def lines_by_place(program, s):
    """Return the lines that places of the path are in."""
    blocks = np.concatenate([piece.copy() for piece in program.pieces()])
    ends = np.vstack([program.machine.record["start_nm"], blocks["target_nm"]])[:, :3] / 1e6
    known = np.cumsum(np.linalg.norm(np.diff(ends, axis=0), axis=1))
    at = np.searchsorted(known, s - ROUNDING_MM)
    return blocks["line"][np.minimum(at, len(known) - 1)]


def away(places, begin, end):
    """Return how far places are from a chord."""
    chord = end - begin
    share = np.clip((places - begin) @ chord / (chord @ chord), 0, 1)
    return np.linalg.norm(places - begin - share[:, None] * chord, axis=1)


def text_of(family, seed, head):
    make, count = FAMILIES[family]
    body = make(np.random.default_rng([seed, 5, len(head)]), min(count, 600))
    return body.replace("G61\n", f"{head}\n", 1)


@pytest.mark.sample(24, quick=4)
@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("family", ["lines", "smooth"])
@pytest.mark.parametrize("head", HEADS)
def test_a_tick_names_the_line_where_it_is(head, family, slope, seed):
    text = text_of(family, seed, head)
    assert head in text
    program = load(text, Machine.load("mill3", set={"path.slope": slope}))
    done = Trace(program)
    line, places = done["line"], np.column_stack([done[f"pos_{axis}_mm"] for axis in "xyz"])
    tolerance = float(head.partition("P")[2].split(" ")[0] or 0)
    moves = np.append(True, np.any(np.diff(places, axis=0) != 0, axis=1))
    owners, by_place = chords(program), lines_by_place(program, done["s_mm"])
    for number, own in owners.items():
        ticks = places[moves & (line == number)]
        assert len(ticks) or np.sum(by_place == number) < TICKS, number
        far = np.min([away(ticks, *each) for each in own], axis=0)
        assert far.max(initial=0) <= tolerance + NEAR_MM, number
    assert set(line[moves]) <= {*owners, 0}


@pytest.mark.sample(24, quick=4)
@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("family", ["lines", "smooth"])
@pytest.mark.parametrize("head", HEADS)
def test_lines_have_the_time_of_their_ticks_and_all_of_it(head, family, slope, seed):
    text = text_of(family, seed, head)
    program = load(text, Machine.load("mill3", set={"path.slope": slope}))
    done, plan = Trace(program), Plan(program, keep=False, by="line")
    parts = {part["line"]: part["time_s"] for part in plan.parts}
    period = program.machine.period_s
    lines, ticks = np.unique(done["line"], return_counts=True)
    told = dict(zip(lines.tolist(), (ticks * period).tolist(), strict=True))
    assert sum(parts.values()) == pytest.approx(plan.totals["total_s"], abs=1e-9)
    wrong = np.array([parts.get(each, 0) - told.get(each, 0) for each in parts.keys() | told])
    overlaps = slope == "jerk" and head != "G61"
    assert np.abs(wrong).max() <= (OVERLAP_TICKS if overlaps else TICKS) * period
    assert np.quantile(np.abs(wrong), 0.98) <= TICKS * period
    side = compare.of_trace(done, "A")
    found = compare.Comparison(side, side)
    assert {number: a for number, a, _ in found.lines} == pytest.approx(told, abs=1.01 * period)
