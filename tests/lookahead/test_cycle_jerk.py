# SPDX-License-Identifier: MIT
"""Within a tolerance every axis keeps its speed, acceleration and jerk in cycles, threads and
contours, too; tests/cycle_jerk.py looks further. And on the exact path inside of every arc."""

import cycle_jerk
import numpy as np
import pytest
from programmed_path import Limits

from pycnc import kernel
from pycnc.machine import Machine
from pycnc.program import Program

SEEDS = range(1, 201)  # of each family
SETTLED = 24  # ticks in an arc behind which no filter mixes in what came before
CIRCLES = [(0.1, 600), (0.5, 3000), (2, 600), (2, 6000), (5, 6000), (20, 20000), (100, 20000)]


@pytest.mark.sample(24)
@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", cycle_jerk.FAMILIES)
def test_cycles_within_a_tolerance_keep_every_limit_of_every_axis(name, seed):
    case = cycle_jerk.case(name, seed)
    found = cycle_jerk.judge(case)
    assert not found, f"{name} {seed}: {found}\n{case.machine} {case.set}\n{case.text}"


@pytest.mark.sample(quick=2)
@pytest.mark.parametrize("name", cycle_jerk.FAMILIES)
def test_few_of_the_programs_are_refused(name):
    refused = sum(cycle_jerk.judge(cycle_jerk.case(name, seed)) is None for seed in range(1, 9))
    assert refused < 4


def worst_inside_arcs(text, change):
    """Return the largest share of an axis' jerk inside of arcs, and the time."""
    machine = Machine.load("mill3", set=change)
    program = Program(text.encode(), machine, file="arcs")
    rows = np.concatenate([rows.copy() for rows, _ in
                           kernel.Simulation(program.text, machine).pieces()])  # fmt: skip
    limits = Limits.of(machine.record)
    pose = rows["pose"]
    entered = np.diff(pose["block"], prepend=-1) != 0
    here = np.arange(len(pose))
    age = here - np.maximum.accumulate(np.where(entered, here, 0))
    inside = ((age >= SETTLED) & (pose["kind"] == 1))[3:]
    jerk = np.abs(np.diff(pose["axis"][:, :3], n=3, axis=0)) / limits.period_s**3
    return (jerk[inside] / limits.j_max[:3]).max(), len(rows) * limits.period_s


@pytest.mark.parametrize(("radius", "feed"), CIRCLES)
def test_an_exact_arc_keeps_the_jerk_of_its_axes(radius, feed):
    text = (f"G21 G90 G17 G61 F{feed}\nG0 X{radius}\nG4 P0.1\nG3 I-{radius}\nG3 I-{radius}\n"
            f"G4 P0.1\nG2 X-{radius} I-{radius} Z{radius / 3}\nG4 P0.1\n"
            f"G18 G2 X{radius} I{radius} Z{radius / 3}\nM2\n")  # fmt: skip
    change = ("path.slope=jerk", "axis.z.j_max_mm_s3=2500")
    worst, time_s = worst_inside_arcs(text, change)
    assert worst <= 1 + 1e-6
    if feed == 600 and radius == 2:
        assert time_s < 4.5  # not slowed down where nothing asks for it


def blocks_seen(blocks, text, slope="jerk"):
    """Return how long a program takes with a look-ahead of so many blocks."""
    change = (f"path.slope={slope}", f"path.lookahead_blocks={blocks}")
    machine = Machine.load("mill3", set=change)
    program = Program(text.encode(), machine, file="ahead")
    return sum(len(rows) for rows, _ in kernel.Simulation(program.text, machine).pieces())


@pytest.mark.parametrize("slope", ["jerk", "linear"])
def test_a_look_ahead_of_two_blocks_sees_a_whole_arc_however_many_pieces_it_has(slope):
    """Within P an arc is many pieces of a spline, and one block."""
    text = "G21 G90 G17 G64 P0.01 F3000\nG3 X0 Y40 J20\nG3 X0 Y0 J-20\nM2\n"
    seen = blocks_seen(3, text, slope)
    assert seen <= 1.02 * blocks_seen(0, text, slope)
