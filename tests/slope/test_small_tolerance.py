# SPDX-License-Identifier: MIT
"""Tolerances near the least that knots are short enough for: no cliff, and every limit holds."""

import re

import clocked
import numpy as np
import pytest
from test_monotony import text_of

from pycnc.bench import families, programs
from pycnc.planning.plan import Plan
from pycnc.program import Program


def planned_s(points, feed, mode, slope, limits):
    """Return the time of a program along points [s]."""
    text = text_of(points, feed, mode)
    return Plan(Program(text, programs.machine(slope, *limits)), keep=False).time_s


@pytest.mark.thorough
@pytest.mark.parametrize("family", families.FAMILIES)
def test_the_least_tolerances_are_no_slower_than_stops(family):
    rng = np.random.default_rng([78, list(families.FAMILIES).index(family)])
    for limits in families.MACHINES.values():
        points, feed = families.draw(family, int(rng.integers(1000)))
        mode = f"G64 P{10 ** rng.uniform(-3.7, -2.7):.7f}"
        within = planned_s(points[:60], feed, mode, "optimal", limits)
        assert within <= 1.02 * planned_s(points[:60], feed, "G61.1", "jerk", limits)


def of_small_tolerances(seed):
    """Return a program of `clocked.py` within 0.18 to 2 µm."""
    rng = np.random.default_rng([79, seed])
    words = iter(10 ** rng.uniform(-3.75, -2.7, 1000))
    return re.sub(r"P[\d.]+", lambda _: f"P{next(words):.7f}", clocked.text_of(seed))


@pytest.mark.sample(6)
@pytest.mark.parametrize("seed", range(200))
def test_limits_hold_within_small_tolerances(seed):
    operate = clocked.operated if seed % 2 else None
    assert clocked.findings(seed, make=of_small_tolerances, operate=operate) == ""
