# SPDX-License-Identifier: MIT
"""Curves within a tolerance keep to the travel, however near to its ends the program goes."""

import checker
import numpy as np
import pytest

from pycnc import kernel
from pycnc.machine import Machine
from pycnc.program import Program

AXIS = """[axis.{axis}]
v_max_mm_s = 250
a_max_mm_s2 = 2500
j_max_mm_s3 = 50000
min_mm = {least:.6f}
max_mm = {most:.6f}
"""


def drawn(seed):
    """Return a program of lines and arcs that often touch the ends of the travel or come near, a
    machine with that travel, and the tolerance."""
    rng = np.random.default_rng([31, seed])
    size, tolerance = 10 ** rng.uniform(-0.5, 1.5), float(rng.choice([0.01, 0.05, 0.2, 1.0]))
    size = float(np.round(size, 6))
    lines = [f"G21 G17 G90 G94 G64 P{tolerance}", f"F{rng.choice([300, 3000, 20000])}"]
    place = np.zeros(3)
    for _ in range(int(rng.integers(3, 40))):
        step = size * 10 ** rng.uniform(-2, 0.3) * rng.normal(size=3) * (rng.random(3) < 0.6)
        near = np.where(rng.random(3) < 0.3, rng.uniform(0, 1.5 * tolerance), 0)
        end = np.round(np.clip(place + step, near - size, size - near), 6)
        words = " ".join(f"{axis}{x:.6f}" for axis, x in zip("XYZ", end, strict=True))
        chord = np.linalg.norm((end - place)[:2])
        kind = rng.random()
        if kind < 0.2 and chord > 1e-3:
            words = f"G{rng.integers(2, 4)} {words} R{chord * rng.uniform(0.51, 3):.6f}"
        elif kind < 0.3:  # a circle that touches an end
            words, end = f"G{rng.integers(2, 4)} I{(size - place[0]) / 2:.6f} J0", place
        else:
            words = f"G{int(kind > 0.4)} {words}"
        lines.append(words)
        place = end
    axes = "".join(AXIS.format(axis=axis, least=-size, most=size) for axis in "xyz")
    return lines, Machine.from_text(f'[path]\nslope = "optimal"\n{axes}', "travel")


def within(lines, machine):
    """Return the program without the arcs that bulge beyond the travel."""
    while True:
        program = Program("\n".join([*lines, "M2", ""]).encode(), machine)
        errors = [one for one in program.diagnostics if one.severity == "error"]
        if not errors:
            return program.check()
        lines = [line for k, line in enumerate(lines, 1) if k != errors[0].line]


@pytest.mark.sample(30)
@pytest.mark.parametrize("seed", range(2000))
def test_no_curve_leaves_the_travel(seed):
    lines, machine = drawn(seed)
    program = within(lines, machine)
    judge = checker.Checker(program.blocks, machine.record)
    for rows, _ in kernel.Simulation(program.text, machine, kernel.PREP_STEPS, ()).pieces():
        judge.add(rows)
    judge.finish()
