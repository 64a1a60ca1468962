# SPDX-License-Identifier: MIT
"""More of something makes few programs slower: families by seed on a soft and a stiff machine.

Outside of pytest SEEDS of each: ``python tests/slope/test_monotony.py SEEDS [first]``.
"""

import sys

import pytest

from pycnc.bench import families, monotony, programs

# What goes up, through which values.
WALKS = (
    ("a", (0.5, 1.0, 2.0), {}),
    ("j", (0.5, 1.0, 2.0), {}),
    ("v", (0.5, 1.0, 2.0, 4.0), {}),
    ("P", (0.002, 0.01, 0.05), {}),
    ("window", (32, 128, 0), {}),
)
MOST = 0.01  # of all steps may be slower by more than monotony.MOST


def text_of(points, feed, mode=""):
    """Return a program along points [mm]."""
    lines = "".join(f"X{x:.5f} Y{y:.5f} Z{z:.5f}\n" for x, y, z in points[1:])
    return f"{programs.head(mode)}G1 F{feed:.4f}\n{lines}M2\n".encode()


def cases(seeds):
    """Yield a program of every family, machine and seed."""
    for name, limits in families.MACHINES.items():
        machine = programs.machine("optimal", *limits)
        for family in families.FAMILIES:
            for seed in seeds:
                text = text_of(*families.draw(family, seed))
                yield monotony.Tried(f"{family} {name} {seed}", text, machine)


def slower(seeds):
    """Return how many steps there are, and the rows of those that are slower."""
    *rows, total = monotony.bench_monotony_rows(cases(seeds), WALKS)
    return int(total["program"].split()[0]), rows


@pytest.mark.thorough
@pytest.mark.parametrize("seed", [0, 4])
def test_more_of_something_makes_few_programs_slower(seed):
    steps, rows = slower([seed])
    assert steps > 200
    assert len(rows) <= MOST * steps, rows


if __name__ == "__main__":
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    steps, rows = slower(range(first, first + int(sys.argv[1])))
    for row in rows:
        print(f"{row['program']}: {row['more']} {row['from']} to {row['to']}: "
              f"{100 * row['slower']:.2f} % slower")  # fmt: skip
    print(f"{steps} steps, {len(rows)} slower")
