# SPDX-License-Identifier: MIT
"""Limits that change while a program runs leave what is planned as it is, whatever the operator
wants behind that: some of the seeds of tests/new_limits.py, other ones for each commit."""

import new_limits
import pytest

from pycnc.kernel import lib

SEEDS = 20_000
# Of the cases so many may pass a limit, for a period, where the tick sets off again and a new plan
# comes: 3 of 1500 did, by a quarter at most.
SOME = 1 / 100
TRIED = {"quick": 5, "suite": 60, "whole": 600}


@pytest.mark.parametrize("slope", ["linear", "jerk", "optimal"])
def test_no_axis_passes_both_limits(slope, draw, draw_seed):
    count = TRIED[draw]
    begin = draw_seed * count % SEEDS
    told = [new_limits.try_seed(seed, slope) for seed in range(begin, begin + count)]
    beyond = [each.case.seed for each in told if each.is_beyond()]
    assert len(beyond) <= max(1, SOME * count), beyond
    assert not any(each.jumps() for each in told), beyond


# The clock's step was that of the new limits, the path's that of the old: jerks of 36 to 1300 times
# the limit.
@pytest.mark.parametrize("seed", [2, 10, 27, 29, 46, 57])
def test_a_path_that_is_planned_keeps_its_clock(seed):
    assert not new_limits.try_seed(seed, "optimal").is_beyond()


# A clock that set off ran on beyond the plan's time, since the plan of a hold brakes as hard as its
# axes can, and nothing allowed it to ease off: 92 to 3 million times the limit of jerk.
# … and it came while the clock set off (2072, 5348): nothing slower is planned then any more.
@pytest.mark.parametrize("seed", [2072, 5134, 5318, 5348, 5373])
def test_a_clock_that_sets_off_never_overtakes_the_plan(seed):
    assert not new_limits.try_seed(seed, "optimal").is_beyond()


# What was planned was braked by limits that came later: 3.9 to 15.6 times those of jerk.
@pytest.mark.parametrize("seed", [5367, 5485, 5537, 5635])
def test_a_brake_keeps_the_limits_of_what_it_brakes(seed):
    assert not new_limits.try_seed(seed, "jerk").is_beyond()


# The link took every other seg of a clocked path for a jump: it has a coordinate of its own.
@pytest.mark.sample(4)
@pytest.mark.parametrize("seed", range(2000, 2040))
def test_the_link_of_a_clocked_path_keeps_what_it_promises(seed):
    case = new_limits.draw(seed, "optimal")[0]
    live = new_limits.Live(case.machine())
    live.push(case.text)
    for _ in range(400):
        live.tick()
        assert lib.nck_invariants(live.nck) == 0
