# SPDX-License-Identifier: MIT
"""A rest that is asked for comes in time on a Cortex-M, with the instructions that it has, and
where prep has died: some of the seeds of firmware_stops.py, other ones for each commit."""

import firmware_runs
import firmware_stops
import pytest
import stop_gate

SEEDS = 20_000
TRIED = {"quick": 2, "suite": 6, "whole": 120}  # an M7 and an M4F by turns


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("part", range(2))
def test_every_rest_comes_in_time_and_within_limits(part, draw, draw_seed, tool):
    for core in firmware_stops.INSTRUCTIONS_NS:
        firmware_runs.opened(core, tool)
    begin = (draw_seed * 2 + part) * TRIED[draw] % SEEDS
    stop_gate.hold(firmware_stops.try_seed, range(begin, begin + TRIED[draw]))
