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
MOST = 1.05  # of the time with a stop at every corner
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
    """Return the times of a seed's program within P, and with a stop at every corner [s]."""
    a, j, feed, points = draw(seed)
    for mode, slope in ((f"G64 P{P}", "optimal"), ("G61.1", "jerk")):
        lines = "".join(f"X{x:.5f} Y{y:.5f} Z{z:.5f}\n" for x, y, z in points[1:])
        text = f"{programs.head(mode)}G1 F{feed}\n{lines}M2\n"
        yield Plan(Program(text.encode(), programs.machine(slope, a, j)), keep=False).time_s


@pytest.mark.parametrize("seed", [29, 54, 58, 108, 175, 196, *range(300, 330)])
def test_the_default_is_no_slower_than_stops_on_any_machine(seed):
    ours, stops = times(seed)
    assert ours <= MOST * stops + TICKS * 1e-3


if __name__ == "__main__":
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    ratios = []
    for seed in range(first, first + int(sys.argv[1])):
        ours, stops = times(seed)
        ratios.append(ours / stops)
        if ours > MOST * stops + TICKS * 1e-3:
            print(f"seed {seed}: {ours:.3f} s, with stops {stops:.3f} s", flush=True)
    mean = np.exp(np.mean(np.log(ratios)))
    print(f"{len(ratios)} programs: {mean:.3f} of the time with stops, {max(ratios):.3f} at most")
