# SPDX-License-Identifier: MIT
"""The slope `optimal`, by convex optimisation along clocked paths, in the whole kernel: what its
programs promise, how soon a rest comes, and that it is as fast as its prototype."""

import sys
from pathlib import Path

import numpy as np
import pytest

TESTS = Path(__file__).resolve().parents[1]
sys.path += [str(TESTS), str(TESTS / "kernel")]

import cases
import clocked
import judged
import nasty_judge
import nasty_seeds
import stop_gate

from pycnc.bench import bounds, programs
from pycnc.planning.plan import Plan

CASES = {str(case): case for case in cases.CASES}
# Of the prototype's time: 0.3 % of every limit is kept.
NEAR = 1.005
TAKEN = 1.03  # of a limit, by a brake of the tick: a sample of jerk weighs three periods
# Programs, P [mm], and what the prototype takes for them [s]: v 100 mm/s, a 1000, j 10 000.
PROTOTYPE = {
    "two edges": (lambda: bounds._stairs(2, 10.0), 0.01, 0.599),
    "zigzag of 1 mm": (lambda: bounds._stairs(12, 1.0), 0.01, 1.341),
    "zigzag of 10 mm": (lambda: bounds._stairs(6, 10.0), 0.01, 1.719),
    "butterfly": (lambda: bounds._butterfly(0.001), 0.01, 1.652),
    "butterfly, whole": (lambda: bounds._butterfly(0.005, 1.0), 0.01, 6.012),
    "spiral": (bounds._spiral, 0.01, 3.224),
    "arcs of 2 mm": (lambda: bounds._arcs(2.0), 0.01, 1.393),
    "arcs of 20 mm": (lambda: bounds._arcs(20.0), 0.01, 2.103),
}


@pytest.mark.sample(12)
@pytest.mark.parametrize("seed", range(24))
def test_a_program_keeps_its_promises(seed):
    assert clocked.findings(seed) == ""


@pytest.mark.sample(2)
@pytest.mark.parametrize("part", range(8))
def test_whatever_the_operator_does_the_path_keeps_limits_of_its_own(part):
    seeds = range(9 * part, 9 * part + 9, 3)
    found = [clocked.findings(seed, operate=clocked.operated) for seed in seeds]
    assert not any(found), found


# An override that came down while a hold stood was answered by one more plan that slows down: a
# fiftieth of what was left, at a place from which the path goes on. There the tool crept for
# seconds, went back (21, 96, 101), or took twice its jerk (58). What one such plan had left was too
# slow to find an end from (219, 244, 459, 501). From a rest, what moves by rounding alone had a
# direction (861: 2.7 times the path's jerk).
@pytest.mark.sample(8)
@pytest.mark.parametrize("seed", [21, 58, 96, 101, 219, 244, 459, 501, 861, *range(150, 219)])
def test_overrides_that_come_down_around_a_hold_break_nothing(seed):
    assert clocked.findings(seed, operate=clocked.slowed) == ""


@pytest.mark.sample(6)
@pytest.mark.parametrize("seed", range(12))
def test_feeds_of_lines_shorter_than_a_knot_are_kept(seed):
    assert clocked.findings(seed, clocked.short_of) == ""


@pytest.mark.sample(12, quick=2)
@pytest.mark.parametrize("steps", [3, 7])
@pytest.mark.parametrize("name", CASES)
def test_a_case_keeps_its_limits_when_preparation_is_late(name, steps):
    case = CASES[name]
    text = case.text.replace("G61\n", "G64 P0.01\n", 1).replace("G94 G61 ", "G94 G64 P0.01 ", 1)
    machine = (*case.set, "path.slope=optimal", "path.tolerance_mm=0")
    program = judged.load(cases.Case(case.name, text, case.machine, machine)).check()
    run = judged.run(program, prep_steps=steps)
    assert run.judge.path_error_mm <= 0.01 * (1 + 1e-6)
    assert run.judge.j.max() <= 1 + 1e-6


@pytest.mark.thorough
@pytest.mark.parametrize("first", [100, 120])
def test_who_rests_while_prep_is_dead_goes_on_within_the_limits(first):
    stop_gate.hold(clocked.try_off, range(first, first + 20))


@pytest.mark.thorough
@pytest.mark.parametrize("first", [100, 120])
def test_a_rest_comes_in_time(first):
    stop_gate.hold(clocked.try_rest, range(first, first + 20))


# Found once, of nasty programs: b beside a rest was drawn as no row had it; whoever answered while
# the other planner began behind a rest had the wrong one; at rest a plan that broke a limit was
# sought again for ever; a coordinate went back where a path does; a clock of a run of 1 nm stood
# still; a brake for a plan that brakes had no number in it; a brake took 1.1 to 1.7 of a jerk where
# the path turned back; a window's end stopped too hard where the path was faster there;
# a piece in which a slower block begins had the feed of the one before.
@pytest.mark.parametrize(
    ("seed", "number"),
    [(1, 8), (1, 18), (1, 24), (1, 29), (1, 39), (1, 88), (1, 93), (1, 114), (1, 133), (1, 180),
     (1, 378), (1, 384), (1, 399), (1, 410), (1, 466), (1, 503), (1, 608), (2, 26),
     (2, 135), (2, 299)],
)  # fmt: skip
def test_what_was_found_once_is_found_no_more(seed, number):
    assert nasty_judge.find(nasty_seeds.case("optimal", seed, number)) == []


# Where a path turns back |p′| of its clock comes near nothing: there a brake can do nothing about
# what it asks of the axis, and has to have eased off before.
TURNS = {
    "there and back": ["X1.2", "X0.3", "X1.7", "X1.6", "X2.6"],
    "nearly back": ["X0.7 Y0.0001", "X0 Y0.03", "X0.5 Y-0.02 Z0.4", "Z-0.3"],
    "arcs": ["X1 Y0.2", "G2 X1.4 Y0 I0.2 J-0.2", "G3 X2 Y0 I0.3 J0", "G1 X1 Y0.1", "Y-0.9"],
}


@pytest.mark.parametrize("turns", TURNS)
def test_a_brake_that_begins_anywhere_keeps_every_limit(turns):
    words = [f"G1 {TURNS[turns][0]}", *TURNS[turns][1:]]
    text = "\n".join(["G21 G17 G90 G94 G64 P0.001", "F9000", *words, "M2", ""])
    case = stop_gate.Case(
        0, turns, text, exact=False, slope="optimal", period_s=1e-3, a=2500.0, j=50_000.0,
        prep_steps=4096, dead=True, goes_on=False, patience=0, first="none", value=0.0, last="hold",
    )  # fmt: skip
    whole = stop_gate.Run(case)
    whole.go(1000)
    speeds = whole.poses()["v"]
    ramp = round(case.a / case.j / case.period_s)  # what acceleration there is makes of a speed
    for then in range(5, whole.ticks - 5, 4):
        run = stop_gate.Run(case)
        run.go(then)
        run.rest("hold", None)
        run.die()
        run.go(200)
        poses = run.poses()
        told = stop_gate.judge(case, poses["v"], poses["axis"][:, :3], then)
        ends = range(then, min(then + ramp, len(speeds)))
        axes = whole.poses()["axis"][:, :3]
        bound_s = max(stop_gate.bound_of(case, speeds, axes, end) for end in ends)
        assert told.rest_s <= case.most() * bound_s, then
        assert max(told.fast, told.a, told.j) <= TAKEN, (then, told.fast, told.a, told.j)


# Whoever was held in the middle of a plan, while prep was dead, goes on from there by the tick's
# own clock: so soon that it is behind a run without that by what a ramp to the top speed takes.
@pytest.mark.parametrize("turns", TURNS)
@pytest.mark.parametrize("stiff", [0.2, 1.0, 30.0])  # of the jerk
def test_a_clock_that_sets_off_anywhere_keeps_every_limit(turns, stiff):
    words = [f"G1 {TURNS[turns][0]}", *TURNS[turns][1:]]
    text = "\n".join(["G21 G17 G90 G94 G64 P0.001", "F9000", *words, "M2", ""])
    case = stop_gate.Case(
        0, turns, text, exact=False, slope="optimal", period_s=1e-3, a=2500.0, j=50_000.0 * stiff,
        prep_steps=4096, dead=True, goes_on=True, patience=0, first="none", value=0.0, last="hold",
    )  # fmt: skip
    whole = stop_gate.Run(case)
    whole.go(1000)
    for then in range(5, whole.ticks - 5, 9):
        run = stop_gate.Run(case)
        run.go(then)
        run.rest("hold", None)
        run.die()
        run.go(300)
        run.live()
        stood = run.ticks
        run.go_on()
        assert run.go(4000), f"{then}: no end"
        poses = run.poses()
        told = stop_gate.judge(case, poses["v"], poses["axis"][:, :3], then)
        assert max(told.fast, told.a, told.j) <= TAKEN, (then, told.fast, told.a, told.j)
        moves = np.flatnonzero(np.diff(poses["axis"][stood - 1 :, :3], axis=0).any(axis=1))
        ramp_s = whole.poses()["v"].max() / case.a + case.a / case.j
        late_s = (moves.max(initial=0) - (whole.ticks - then)) * case.period_s
        assert late_s <= ramp_s + 20 * case.period_s, (then, late_s, ramp_s)


# A plan slows down to 2 % of its speed, so far a tenth takes longer than a line's brake would.
@pytest.mark.thorough
def test_a_lowered_override_is_heard_in_time():
    shares = [clocked.try_lowered(seed) for seed in range(200, 400)]
    shares = [share for share in shares if share]
    half, most, longest = np.percentile(shares, [50, 90, 100])
    assert half < 1
    assert most < 1.5
    assert longest < 3


def test_an_override_near_nothing_and_another_one_let_it_go_on():
    stop_gate.hold(clocked.try_rest, [262])


@pytest.mark.sample(8)
@pytest.mark.parametrize("name", PROTOTYPE)
def test_it_is_as_fast_as_the_prototype(name):
    make, tolerance, prototype_s = PROTOTYPE[name]
    made = make()
    points, moves = made if isinstance(made, tuple) else (made, None)
    machine = programs.machine("optimal")
    program = bounds._program(points - points[0], tolerance, moves, machine)
    assert Plan(program).time_s <= NEAR * prototype_s
