# SPDX-License-Identifier: MIT
"""Limits that change while a program runs leave what is planned as it is, whatever the operator
wants behind that: some of the seeds of tests/new_limits.py, other ones for each commit."""

import new_limits
import pytest

SEEDS = 20_000
# Of the cases so many may pass a limit: where the tick brakes, and goes on. Some still jump there
# (seed 2066 by 1.10 of an acceleration, 2072 by 21 of a jerk): tests/new_limits.py tells them.
SOME = 1 / 12
TRIED = {"quick": 5, "suite": 60, "whole": 600}


@pytest.mark.parametrize("part", range(5))
def test_no_axis_passes_both_limits_along_a_clocked_path(part, draw, draw_seed):
    count = TRIED[draw] // 5
    begin = (draw_seed * 5 + part) * count % SEEDS
    told = [new_limits.try_seed(seed, "optimal") for seed in range(begin, begin + count)]
    beyond = [each.case.seed for each in told if each.is_beyond()]
    assert len(beyond) <= max(2, SOME * count), beyond


# The clock's step was that of the new limits, the path's that of the old: jerks of 36 to 1300 times
# the limit.
@pytest.mark.parametrize("seed", [2, 10, 27, 29, 46, 57])
def test_a_path_that_is_planned_keeps_its_clock(seed):
    assert not new_limits.try_seed(seed, "optimal").is_beyond()


# A clock that set off ran on beyond the plan's time, since the plan of a hold brakes as hard as its
# axes can, and nothing allowed it to ease off: 92 to 3 million times the limit of jerk.
@pytest.mark.parametrize("seed", [5134, 5318, 5373])
def test_a_clock_that_sets_off_never_overtakes_the_plan(seed):
    assert not new_limits.try_seed(seed, "optimal").jumps()
