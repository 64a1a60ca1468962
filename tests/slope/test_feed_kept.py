# SPDX-License-Identifier: MIT
"""The feed that was programmed, under the default slope: a line has it but for its ramps, and no
curve is faster. Outside of pytest N of both:
``PYTHONPATH=tests python tests/slope/test_feed_kept.py N [first]``."""

import sys

import judged
import numpy as np
import pytest
from test_any_machine import draw

from pycnc.bench import programs
from pycnc.planning.plan import Plan
from pycnc.program import Program

SHARE = 1.01  # of the best time: what the gap of the solver costs
ROUNDING = 0.008  # s: a rest lies on a tick, and a plan's nodes are so far apart or less
OVER = 1e-4  # of F: setpoints are whole nanometres


def line(seed):
    """Return the time of one line of a drawn length, feed and machine, and the best one [s]; none
    where it does not come to its feed."""
    rng = np.random.default_rng([91, seed])
    a, j, v = 10 ** rng.uniform(2, 4), 10 ** rng.uniform(3, 6), 10 ** rng.uniform(0, 2)
    length = 10 ** rng.uniform(0.5, 2.7)
    way = rng.normal(0, 1, 3)
    way /= np.linalg.norm(way)
    points = np.round([[0, 0, 0], way * length], 5)
    steepest = np.abs(way).max()
    a_way, j_way = a / steepest, j / steepest
    ramps = 2 * np.sqrt(v / j_way) if v * j_way < a_way**2 else v / a_way + a_way / j_way
    if ramps * v > length:
        return None
    machine = programs.machine("optimal", a, j)
    program = Program.from_points(points, 60 * v, machine, tolerance=0.01)
    return Plan(program, keep=False).time_s, length / v + ramps


def fastest(seed):
    """Return the highest speed of a drawn program, over its feed."""
    rng = np.random.default_rng([92, seed])
    a, j, feed, points = draw(seed)
    tolerance = 10 ** rng.uniform(-3, -1)
    feed *= 10 ** rng.uniform(-1.5, 0)
    machine = programs.machine("optimal", a, j)
    program = Program.from_points(points, feed, machine, tolerance=tolerance)
    pose = judged.rows_of(program)["pose"]
    ways = np.linalg.norm(np.diff(pose["axis"][:, :3], axis=0), axis=1)
    sampled = (ways.max() - 2e-6) / machine.period_s
    return max(pose["v"].max(), sampled) / (feed / 60)


@pytest.mark.parametrize("seed", [12, 46, 57, *range(100, 112)])
def test_a_line_has_its_feed_but_for_its_ramps(seed):
    times = line(seed)
    if times is None:
        pytest.skip("it does not come to its feed")
    ours, best = times
    assert best - 1e-3 <= ours <= SHARE * best + ROUNDING


@pytest.mark.parametrize("seed", range(300, 308))
def test_no_curve_is_faster_than_its_feed(seed):
    assert fastest(seed) <= 1 + OVER


if __name__ == "__main__":
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    for seed in range(first, first + int(sys.argv[1])):
        times, most = line(seed), fastest(seed)
        if times and times[0] > SHARE * times[1] + ROUNDING:
            print(f"seed {seed}: {times[0]:.3f} s, {times[1]:.3f} at best", flush=True)
        if most > 1 + OVER:
            print(f"seed {seed}: {most:.5f} of its feed", flush=True)
