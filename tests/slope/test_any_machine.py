# SPDX-License-Identifier: MIT
"""The default slope on any machine: soft, stiff, slow to stop, with or without much jerk. Machine
and program are drawn by seed. Outside of pytest N programs:
``python tests/slope/test_any_machine.py N [first]``."""

import sys

import numpy as np
import pytest

from pycnc.bench import families, programs
from pycnc.planning.plan import Plan
from pycnc.program import Program

P = 0.01  # mm
MOST = 1.05  # of the time under `jerk`: 1.035 is the worst of 300 from seed 0
TICKS = 3  # … and some


def draw(seed):
    """Return a, j of a machine [mm/s², mm/s³], a feed [mm/min] and the points of a program [mm]."""
    rng = np.random.default_rng([77, seed])
    a, j, v = 10 ** rng.uniform(1, 4.3), 10 ** rng.uniform(1.5, 6), 10 ** rng.uniform(1.3, 2.7)
    kind = rng.choice(["one", "lines", "zigzag", "polygon", "pocket"])
    if kind == "one":
        points = np.array([[0, 0, 0], [10 ** rng.uniform(-1, 2.7), 0, 0]])
    elif kind == "lines":
        way = rng.normal(0, 120, (int(rng.integers(2, 6)), 3)) * [1, 1, 0]
        points = np.cumsum(np.vstack([np.zeros(3), way]), axis=0)
    else:
        points = families.FAMILIES[kind](rng)
    return a, j, 60 * v, np.round(points - points[0], 5)


def times(seed):
    """Return the times of a seed's program under `optimal` and `jerk` [s]."""
    a, j, feed, points = draw(seed)
    for slope in ("optimal", "jerk"):
        machine = programs.machine(slope, a, j)
        program = Program.from_points(points, feed, machine, tolerance=P)
        yield Plan(program, keep=False).time_s


@pytest.mark.parametrize("seed", [29, 54, 58, 108, 175, 196, *range(300, 330)])
def test_the_default_is_no_slower_than_jerk_on_any_machine(seed):
    ours, jerk = times(seed)
    assert ours <= MOST * jerk + TICKS * 1e-3


if __name__ == "__main__":
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    ratios = []
    for seed in range(first, first + int(sys.argv[1])):
        ours, jerk = times(seed)
        ratios.append(ours / jerk)
        if ours > MOST * jerk + TICKS * 1e-3:
            print(f"seed {seed}: {ours:.3f} s, under jerk {jerk:.3f} s", flush=True)
    mean = np.exp(np.mean(np.log(ratios)))
    print(f"{len(ratios)} programs: {mean:.3f} of the time under jerk, {max(ratios):.3f} at most")
