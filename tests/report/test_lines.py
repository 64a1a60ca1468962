# SPDX-License-Identifier: MIT
"""Every tick names the line that is being cut, and every line that is cut owns its ticks."""

from importlib.resources import files

import numpy as np
import pytest
from cases import CASES, DEAR_FILES, FAMILIES, RUNNING_FILES, SEEDS
from programmed_path import Limits, Path

from pycnc import Trace, load
from pycnc.machine import Machine
from pycnc.planning.plan import Plan
from pycnc.report import compare

EXAMPLES = files("pycnc") / "examples"
HEADS = ("G61", "G64 P0.01", "G64 P0.05 Q0.05", "G64 P0.2 Q0.1")
SLOPES = ("jerk", "linear", "optimal")
NEAR_MM = 0.1  # beside the tolerance
ROUNDING_MM = 1e-6
TICKS = 2  # that a line's time may be off: where it begins and ends is between two ticks
REST_TICKS = 1  # a wait that begins or ends beside a line lasts till its next tick


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
        assert len(ticks) or np.sum(by_place == number) <= TICKS, number
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
    assert np.abs(wrong).max() <= TICKS * period
    side = compare.of_trace(done, "A")
    found = compare.Comparison(side, side)
    assert {number: a for number, a, _ in found.lines} == pytest.approx(told, abs=1.01 * period)


# All programs: arcs, rotary axes, lathes, prints, loops and calls, whose lines come again


def places_of(done):
    """Return where the axes are at each tick, in the order of X to W."""
    places = np.zeros((len(done["line"]), 9))
    for k, axis in enumerate("xyzabcuvw"):
        for name in (f"pos_{axis}_mm", f"pos_{axis}_deg"):
            if name in done.columns:
                places[:, k] = done[name]
    return places


def from_own_line(path, done, places, ticks):
    """Return how far ticks are from the nearest moves of the lines that they name."""
    s, line, home = done["s_mm"], done["line"], path._blocks_at(done["s_mm"])
    far, moves = np.full(len(ticks), np.inf), np.flatnonzero(path.length > 0)
    moves = moves[np.argsort(path.line[moves], kind="stable")]
    order = np.argsort(line[ticks], kind="stable")
    named, known = line[ticks][order], path.line[moves]
    for number in np.unique(named):
        own = moves[slice(*np.searchsorted(known, [number, number + 1]))]
        mine = order[slice(*np.searchsorted(named, [number, number + 1]))]
        assert len(own), f"line {number} has no move, and ticks that move"
        here = ticks[mine]
        at = np.searchsorted(own, home[here])
        for k in range(-3, 3):
            block = own[np.clip(at + k, 0, len(own) - 1)]
            far[mine] = np.minimum(far[mine], path.apart(block, s[here], places[here]))
    return far


def hold(program):
    """Hold lines and times of a whole program against each other, and against its places."""
    done, plan = Trace(program), Plan(program, keep=False, by="line")
    period, line = program.machine.period_s, done["line"]
    if not len(line):
        return
    told = {n: period * k for n, k in zip(*(each.tolist() for each in np.unique(
        line, return_counts=True)), strict=True)}  # fmt: skip
    parts = {part["line"]: sum(part[f"{kind}_s"] for kind in ("cut", "rapid", "dwell"))
             for part in plan.parts}  # fmt: skip
    assert sum(p["time_s"] for p in plan.parts) == pytest.approx(plan.totals["total_s"], abs=1e-9)
    wrong = {n: abs(parts.get(n, 0) - told.get(n, 0)) for n in parts.keys() | told}
    most = (TICKS + REST_TICKS + 1e-6) * period
    assert max(wrong.values()) <= most, max(wrong, key=wrong.get)
    path = Path(program.blocks, Limits.of(program.machine.record))
    places, home = places_of(done), path._blocks_at(done["s_mm"])
    moving = 1 + np.flatnonzero(np.any(np.diff(places, axis=0) != 0, axis=1))
    near = np.maximum(path.tolerance[home], path.tolerance[np.minimum(home + 1, home.max())])
    far = from_own_line(path, done, places, moving)
    assert np.all(far <= near[moving] + NEAR_MM), line[moving[np.argmax(far - near[moving])]]
    cut, count = np.unique(path.line[home[moving]], return_counts=True)
    silent = [n for n, k in zip(cut.tolist(), count, strict=True) if k >= TICKS and n not in told]
    assert not silent


@pytest.mark.sample(12, quick=2)
@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("case", CASES, ids=str)
def test_lines_of_all_cases_own_their_ticks(case, slope):
    hold(load(case.text, Machine.load(case.machine, set=[*case.set, f"path.slope={slope}"])))


@pytest.mark.sample(3, quick=0)
@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize(
    "file", [each for each in RUNNING_FILES if each.file not in DEAR_FILES], ids=str
)
def test_lines_of_files_that_others_share_own_their_ticks(file, slope):
    if not file.path.exists():
        pytest.skip(f"{file.path} is not here")
    hold(load(file.path, Machine.load(file.machine, set=[*file.set, f"path.slope={slope}"])))


@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize(
    ("file", "machine"), [("first_part", "mill3"), ("turned_pin", "cak6150n")]
)
def test_lines_of_the_examples_own_their_ticks(file, machine, slope):
    hold(load(EXAMPLES / f"{file}.ngc", Machine.load(machine, set={"path.slope": slope})))
