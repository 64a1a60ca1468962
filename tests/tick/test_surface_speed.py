# SPDX-License-Identifier: MIT
"""Contours under G96 within a tolerance, drawn by seed: feed a revolution, the spindle's
acceleration, and every limit. Outside of pytest N:
``PYTHONPATH=tests python tests/tick/test_surface_speed.py N``."""

import sys

import judged
import numpy as np
import pytest

from pycnc.machine import Machine
from pycnc.program import Program

NEAR = 0.004  # of a feed a revolution, that the speed may be above it: knots about the place
FOLLOWS = 0.002  # of the spindle's acceleration: nodes' speeds hold at nodes


def draw(seed):
    """Return a drawn program for the lathe, its feed a revolution [mm] and the acceleration of its
    spindle [rpm/s]; 0: at once."""
    rng = np.random.default_rng([96, seed])
    feed = rng.choice([0.05, 0.2, 0.5])
    a = rng.choice([0, 100, 1000])
    tolerance = 10 ** rng.uniform(-3, -1)
    x, z = rng.uniform(10, 100), 0.0
    lines = [
        "G21 G18 G99",
        f"G50 S{rng.integers(500, 2001)}",
        f"G96 S{rng.integers(50, 301)} M3",
        f"G0 X{x:.3f} Z2",
        f"G1 Z0 F{feed}",
    ]
    for _ in range(rng.integers(2, 9)):
        dx, dz = rng.choice([0.3, 3, 20]) * rng.normal(0, 1, 2)
        dx, dz = (dx, 0) if rng.random() < 0.3 else (0, dz) if rng.random() < 0.3 else (dx, dz)
        x, z = abs(x + dx), z - abs(dz)
        move = "G0" if rng.random() < 0.1 else "G1"
        arc = rng.random() < 0.2 and dx != 0 and dz != 0
        radius = rng.uniform(0.6, 3) * np.hypot(dx / 2, dz) if arc else 0
        lines.append(f"G2 X{x:.3f} Z{z:.3f} R{radius:.3f}" if arc else f"{move} X{x:.3f} Z{z:.3f}")
    lines.append("G97 G0 X200\nM30\n")
    change = ("dialect.system=A", "path.slope=optimal", f"spindle.a_max_rpm_s={a}")
    change += (f"path.tolerance_mm={tolerance:.4f}",)
    machine = Machine.load("cak6150n", set=change)
    return Program("\n".join(lines).encode(), machine, file=f"seed {seed}"), feed, a


def check(seed):
    """Return a broken promise of a seed's run, or nothing."""
    program, feed, a = draw(seed)
    assert not [each for each in program.diagnostics if each.severity == "error"]
    judged.run(program)
    rows = judged.rows_of(program)
    pose = rows["pose"]
    rapids = {block["line"] for block in program.blocks if block["kind"] == 0}
    cuts = (pose["line"] > 4) & ~np.isin(pose["line"], list(rapids)) & (pose["spindle_rpm"] > 0)
    most = (pose["v"][cuts] / (pose["spindle_rpm"][cuts] * feed / 60)).max()
    if most > 1 + NEAR:
        return f"{most:.4f} of its feed a revolution"
    moves = (pose["line"] > 4) & (pose["line"] < pose["line"].max())
    change = np.abs(np.diff(pose["spindle_rpm"][moves])) / program.machine.period_s
    if a and change.max() > a * (1 + FOLLOWS):
        return f"{change.max() / a:.4f} of the spindle's acceleration"
    return None


@pytest.mark.parametrize("seed", range(8))
def test_a_contour_under_surface_speed_keeps_every_limit(seed):
    assert check(seed) is None


if __name__ == "__main__":
    for seed in range(int(sys.argv[1])):
        try:
            found = check(seed)
        except Exception as error:  # noqa: BLE001 - whatever a run breaks is told with its seed
            found = error
        if found:
            print(f"seed {seed}: {found}", flush=True)
