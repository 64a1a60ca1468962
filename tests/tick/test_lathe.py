# SPDX-License-Identifier: MIT
"""Lathes: surface speed, feed a revolution, tools by T0202, as the tick executes them."""

import judged
import numpy as np
import pytest

from pycnc.machine import Machine
from pycnc.program import Program

SLOPES = ("linear", "jerk", "optimal")
FACING = "G21 G18 G99\nG50 S2000\nG96 S200 M3\nG0 X{d} Z0\nG1 X0 F0.2\nG0 Z5\nM30\n"
PROFILE = (
    "G21 G18 G99\nG50 S2500\nG96 S150 M3\nG0 X20 Z2\nG1 Z0 F0.3\nX24 Z-2\nZ-10\n"
    "G3 X34 Z-15 R5\nG1 X60 Z-30\nG2 X80 Z-40 R10\nG1 X90\nG97\nG0 X100\nM30\n"
)


def lathe(text, *change):
    """Return a program for the lathe, in Fanuc's G-code system A."""
    machine = Machine.load("cak6150n", set=("dialect.system=A", *change))
    return Program(text.encode(), machine, file="lathe")


def poses(program, line):
    """Return the poses of a run, and which of them are of a line's move."""
    pose = judged.rows_of(program)["pose"]
    return pose, pose["line"] == line


# F a revolution follows the speed, and the speed follows the place


@pytest.mark.parametrize("change", [(), ("path.tolerance_mm=0",)], ids=["smoothed", "exact"])
@pytest.mark.parametrize("slope", SLOPES)
def test_facing_keeps_feed_a_revolution_at_every_tick_in_the_cut(slope, change):
    program = lathe(FACING.format(d=200), f"path.slope={slope}", *change)
    pose, cuts = poses(program, 5)
    ramp = 10 if slope == "linear" else 45  # ticks from rest to 400 mm/min: v/a, 2·√(v/j)
    within = np.flatnonzero(cuts)[ramp:-ramp]
    ratio = pose["v"][within] / (pose["spindle_rpm"][within] * 0.2 / 60)
    assert len(ratio) > 40_000
    assert ratio.min() > 0.99 and ratio.max() < 1.01
    judged.run(program)


@pytest.mark.parametrize("slope", SLOPES)
def test_the_spindle_turns_by_the_place_of_every_tick(slope):
    program = lathe(PROFILE, f"path.slope={slope}")
    pose, _ = poses(program, 5)
    cuts = (pose["line"] > 4) & (pose["line"] < 12)
    r = np.abs(pose["axis"][cuts, 0])
    assert pose["spindle_rpm"][cuts] == pytest.approx(
        np.minimum(2000, 150e3 / (2 * np.pi * r)), rel=1e-12
    )
    judged.run(program)


@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("a", [100, 1000])
def test_no_move_is_faster_than_the_spindle_can_follow(slope, a):
    program = lathe(PROFILE, f"path.slope={slope}", f"spindle.a_max_rpm_s={a}")
    pose, _ = poses(program, 5)
    moves = (pose["line"] > 4) & (pose["line"] < 13)
    change = np.abs(np.diff(pose["spindle_rpm"][moves])) / program.machine.period_s
    assert 0.9 * a < change.max() <= a * (1 + 1e-9)
    judged.run(program)


def test_an_override_of_the_feed_does_not_outrun_the_spindle():
    program = lathe(PROFILE, "spindle.a_max_rpm_s=100")
    pose = judged.rows_of(program, commands=[(0, "override", 200, 100)])["pose"]
    moves = (pose["line"] > 4) & (pose["line"] < 13)
    change = np.abs(np.diff(pose["spindle_rpm"][moves])) / program.machine.period_s
    assert 90 < change.max() <= 100 * (1 + 1e-9)


def test_a_cut_along_the_axis_is_one_piece():
    program = lathe("G21 G18 G99 G61 G50 S900\nG96 S90 M3\nG0 X40 Z2\nG1 Z-30 F0.2\nM30\n")
    _, segs, _, _ = judged.plan(program)
    assert np.count_nonzero(segs["line"] == 4) == 1


def test_feed_a_minute_is_the_same_under_g96():
    program = lathe(FACING.format(d=40).replace("G99", "G98").replace("F0.2", "F120"))
    pose, cuts = poses(program, 5)
    assert pose["v"][cuts].max() == pytest.approx(2.0, rel=1e-3)


# Words


def blocks(text, *change):
    program = lathe(text, *change)
    assert not [each for each in program.diagnostics if each.severity == "error"]
    return program.blocks


def test_the_most_is_the_least_of_the_programs_and_the_machines():
    def most(said):
        return blocks(f"G50 S{said}\nG96 S100 M3\nG0 X10\nM30\n")["spindle_rpm"][-2]

    assert most(1500) == 1500
    assert most(3000) == 2000


@pytest.mark.parametrize("units, mm_min", [("G21", 100e3), ("G20", 30480)])
def test_surface_speed_is_metres_or_feet_a_minute(units, mm_min):
    assert blocks(f"{units}\nG96 S100 M3\nG0 X1\nM30\n")["surface"][-2] == mm_min


def test_g97_without_s_keeps_the_speed_of_its_place():
    block = blocks("G21\nG96 S100 M3\nG0 X50\nG97\nG0 X10\nM30\n")[-2]
    assert block["surface"] == 0
    assert block["spindle_rpm"] == pytest.approx(100e3 / (np.pi * 50), rel=1e-12)


def test_g96_remembers_its_s_on_fanucs_lathes_alone():
    text = "G21\nG96 S100 M3\nG97 S500\nG96\nG0 X10\nM30\n"
    assert blocks(text)["surface"][-2] == 100e3
    machine = Machine.load("cak6150n", set=("dialect.base=linuxcnc",))
    errors = Program(text.encode(), machine, file="t").diagnostics
    assert [each.id for each in errors if each.severity == "error"] == ["word-missing"]


def test_d_is_the_most_in_rs274ngc():
    text = "G21 G18 G90\nG96 D1500 S100 M3\nG0 X10\nM2\n"
    change = ("dialect.base=linuxcnc",)
    machine = Machine.load("cak6150n", set=change)
    assert Program(text.encode(), machine, file="t").blocks["spindle_rpm"][-2] == 1500


@pytest.mark.parametrize(
    "line, name",
    [
        ("G96 D100 S90", "word-unused"),
        ("G50 S0", "number-range"),
        ("G96", "word-missing"),
        ("T0909", "tool-unknown"),
        ("T0109", "tool-unknown"),
    ],
)
def test_what_cannot_be_is_told(line, name):
    errors = lathe(f"{line}\nM30\n").diagnostics
    assert [(each.id, each.line) for each in errors if each.severity == "error"] == [(name, 1)]


def test_g96_needs_a_most_of_the_speed():
    (error,) = lathe("G96 S90\nM30\n", "spindle.rpm_max=0").diagnostics
    assert (error.id, "G50" in error.help) == ("speed-limit", True)


def test_t_turns_the_turret_and_takes_the_offset():
    change = ("tool.2.x_mm=3", "tool.2.length_mm=-7")
    block = blocks("G21\nG0 X20 Z5\nT0102\nG0 X20 Z5\nT0100\nG0 X20 Z5\nM30\n", *change)
    moves, waits = block[block["kind"] == 0], block[block["kind"] == 4]
    assert waits["output"]["value"].tolist() == [1]  # a change of the offset alone turns nothing
    at = (moves["target_nm"] + np.pad(moves["tool_nm"], ((0, 0), (0, 6))))[:, [0, 2]]
    assert (at[1] - at[0]).tolist() == [3_000_000, -7_000_000]
    assert (at[2] - at[0]).tolist() == [0, 0]


def test_the_nose_is_that_of_the_offset():
    text = "G21 G18 G98\nT01{}\nG0 X20 Z5\nG42 G1 X10 Z2 F90\nZ-9\nX20\nG40 G0 X30\nM30\n"
    change = ("tool.2.radius_mm=0.4", "tool.2.orientation=3", "path.slope=linear")
    of_2 = judged.plan(lathe(text.format("02"), *change))[1]
    alone = ("tool.1.radius_mm=0.4", "tool.1.orientation=3", "path.slope=linear")
    assert (of_2["end"] == judged.plan(lathe(text.format("01"), *alone))[1]["end"]).all()


def test_dwell_and_reference_by_fanucs_words():
    block = blocks("G21\nG4 X1.5\nG4 U2.\nG4 P500\nG28 U0 W0\nM30\n")
    assert block["dwell_s"][block["kind"] == 3].tolist() == [1.5, 2, 0.5]
    assert block["target_nm"][-2, [0, 2]].tolist() == [200_000_000, 600_000_000]


@pytest.mark.parametrize("feed, ids", [("", ["assumed-feed-mode"]), ("per_minute", [])])
def test_what_f_means_before_g98_or_g99_is_told(feed, ids):
    change = (f"dialect.feed={feed}",) if feed else ()
    program = lathe("G21\nM3 S500\nG1 X10. F0.2\nM30\n", *change)
    assert [each.id for each in program.diagnostics] == ids


def test_f_may_mean_a_revolution_at_start():
    block = blocks("G21\nM3 S500\nG1 X10 F0.2\nM30\n", "dialect.feed=per_rev")
    assert block["feed_mode"][-2] == 2
