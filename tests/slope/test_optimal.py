# SPDX-License-Identifier: MIT
"""The slope `optimal`, by convex optimisation along clocked paths, in the whole kernel: what its
programs promise, how soon a rest comes, and that it is as fast as its prototype."""

import sys
from pathlib import Path

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
def test_a_rest_comes_in_time(first):
    stop_gate.hold(clocked.try_rest, range(first, first + 20))


# Found once, of nasty programs: b beside a rest was drawn as no row had it; whoever answered while
# the other planner began behind a rest had the wrong one; at rest a plan that broke a limit was
# sought again for ever; a coordinate went back where a path does; a clock of a run of 1 nm stood
# still; a brake for a plan that brakes had no number in it.
@pytest.mark.parametrize(
    ("seed", "number"),
    [(1, 8), (1, 18), (1, 24), (1, 29), (1, 88), (1, 93), (1, 133), (1, 180), (1, 399), (2, 299)],
)
def test_what_was_found_once_is_found_no_more(seed, number):
    assert nasty_judge.find(nasty_seeds.case("optimal", seed, number)) == []


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
