# SPDX-License-Identifier: MIT
"""A rest that is asked for comes in time, whatever was asked for before it and whether prep is
there or not: some of the seeds of tests/stop_gate.py, other ones for each commit."""

import pytest
import stop_gate

SEEDS = 20_000
SOME = 1 / 12  # may pass a limit: one in a thousand does, where a brake meets the plan's own
TRIED = {"quick": 25, "suite": 300, "whole": 3000}  # cases, in 25 parts


@pytest.mark.parametrize("part", range(25))
def test_every_rest_comes_in_time_and_within_limits(part, draw, draw_seed):
    count = TRIED[draw] // 25
    begin = (draw_seed * 25 + part) * count % SEEDS
    told = [stop_gate.try_case(stop_gate.draw(seed)) for seed in range(begin, begin + count)]
    late = [each.case.seed for each in told if each and each.is_late()]
    beyond = [each.case.seed for each in told if each and each.is_beyond()]
    assert not late
    assert len(beyond) <= SOME * max(12, count), beyond
