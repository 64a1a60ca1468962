# SPDX-License-Identifier: MIT
"""Tapping: the tool's place goes by the spindle's angle alone, in and out of the hole."""

import re

import numpy as np
import pytest
import rs274_oracle

from pycnc import kernel
from pycnc.kernel.bind import lib
from pycnc.machine import Machine
from pycnc.program import Program

EXACT, UNEVEN = (0.0, 0.0, 1.0), (0.1, 0.02, 0.7)  # spindles: late [s], ripple, over turns
HOLES = "G21 G90 G17 G98 M3 S600 F600\nG0 Z10\nG84 X10 Z-20 R5 P0.2\nX20\nG80\nM2\n"
LEAD, R, BOTTOM = 1.0, 5.0, -20.0
KIND = lib.NCK_SEG_TAP


def load(text, *change, machine="mill3"):
    return Program(text.encode(), Machine.load(machine, set=change), file="taps")


def run(program, spindle=None, commands=()):
    assert [each.id for each in program.diagnostics if each.severity == "error"] == []
    simulation = kernel.Simulation(program.text, program.machine, 4, commands, spindle)
    return np.concatenate([rows.copy() for rows, _ in simulation.pieces()]), simulation


def findings(text, *change):
    errors = [each for each in load(text, *change).diagnostics if each.severity == "error"]
    return [(each.id, each.line) for each in errors]


@pytest.mark.parametrize("slope", ["linear", "jerk"])
@pytest.mark.parametrize("drive", [0, 3000])
@pytest.mark.parametrize("spindle", [EXACT, UNEVEN])
def test_the_tool_is_on_the_helix_in_and_out(slope, drive, spindle):
    program = load(HOLES, f"path.slope={slope}", f"spindle.a_max_rpm_s={drive}")
    rows, simulation = run(program, spindle)
    pose, z = rows["pose"], rows["pose"]["axis"][:, 2]
    taps = pose["kind"] == KIND
    thread = taps & (z < R - 1)  # behind the run-in
    leads = (z / LEAD + rows["spindle_turns"])[thread]
    assert np.abs(leads - np.round(leads)).max() * LEAD <= 1e-6
    assert (simulation.end, simulation.thread_lost) == ("done", False)
    late_mm = 10 * spindle[0]  # [mm] at 10 mm/s: the spindle's, as the page says
    assert BOTTOM - late_mm * 1.05 - 1e-9 <= z.min() <= BOTTOM + 1e-9
    assert pose["spindle_rpm"][taps].min() == pytest.approx(-600)
    assert len(np.unique(pose["block"][taps])) == 2


def test_the_bottom_is_reached_and_the_spindle_rests_there():
    rows, _ = run(load(HOLES), EXACT)
    z = rows["pose"]["axis"][:, 2]
    assert z.min() == pytest.approx(BOTTOM, abs=1e-9)
    rests = (rows["pose"]["spindle_rpm"] == 0) & (z < BOTTOM + 1e-6)
    assert rests.sum() == pytest.approx(2 * 200, abs=4)  # P0.2, two holes


@pytest.mark.parametrize("slope", ["linear", "jerk"])
def test_a_tap_keeps_the_limits_of_the_axis(slope):
    rows, _ = run(load(HOLES, f"path.slope={slope}"), EXACT)
    z = rows["pose"]["axis"][rows["pose"]["kind"] == KIND, 2]
    assert np.abs(np.diff(z, 2)).max() / 1e-6 <= 2000
    assert slope == "linear" or np.abs(np.diff(z, 3)).max() / 1e-9 <= 40_000


def test_the_plan_takes_as_long_as_the_tap_but_for_the_wait():
    rows, _ = run(load(HOLES), EXACT)
    tap = (rows["pose"]["kind"] == KIND).sum() * 1e-3
    planned = load(HOLES).blocks["tap"]["duration"].sum()
    assert abs(tap - planned) <= 2 * 0.05 + 0.01  # half a turn of 0.1 s each


@pytest.mark.parametrize("after", [200, 1500, 2700, 2760, 2900, 4000])
def test_an_abort_brakes_the_spindle_and_the_tool_stays_in_step(after):
    begin = int(np.flatnonzero(run(load(HOLES), EXACT)[0]["pose"]["kind"] == KIND)[0])
    rows, simulation = run(load(HOLES), EXACT, [(begin + after, "abort")])
    assert (simulation.end, simulation.thread_lost) == ("aborted", True)
    z = rows["pose"]["axis"][:, 2]
    leads = z + rows["spindle_turns"]
    last = slice(begin + after - 5, None)
    assert np.ptp(leads[last] - leads[begin + after - 5]) <= 1e-9
    assert rows["pose"]["spindle_rpm"][-1] == 0
    assert np.abs(np.diff(z[last], 2)).max() / 1e-6 <= 2000


def test_a_hold_waits_for_the_end_of_the_tap():
    plain, _ = run(load(HOLES), EXACT)
    begin = int(np.flatnonzero(plain["pose"]["kind"] == KIND)[0])
    held, simulation = run(
        load(HOLES), EXACT, [(begin + 1000, "hold"), (begin + 9000, "resume")]
    )  # fmt: skip
    first = np.flatnonzero(plain["pose"]["kind"] == KIND)[:3000]
    assert (held["pose"]["axis"][first] == plain["pose"]["axis"][first]).all()
    assert (simulation.end, simulation.thread_lost) == ("done", False)


def test_a_spindle_that_does_not_follow_leads_no_axis_out_of_its_travel():
    rows, simulation = run(load(HOLES, "axis.z.min_mm=-21"), (30.0, 0.0, 1.0))
    assert simulation.thread_lost
    assert rows["pose"]["axis"][:, 2].min() >= -21


def test_fanucs_cycle_starts_the_spindle_as_the_tap_is_and_says_its_lead():
    text = "G21 G90 G95 S300\nM29 S300\nG0 Z9\nG74 X5 Z-9 R4 F1.25\nM30\n"
    blocks = load(text, "dialect.base=fanuc").blocks
    taps = blocks[blocks["kind"] == lib.NCK_BLOCK_TAP]
    assert taps["tap"]["lead"].tolist() == [1.25]
    codes = blocks["output"][blocks["output"]["kind"] == lib.NCK_OUTPUT_M]["value"].tolist()
    assert codes == [29, 4, 30]
    text = "G21 G90 G94 S300 M3\nG0 Z9\nG84 X5 Z-9 R4 F375\nM30\n"
    blocks = load(text, "dialect.base=fanuc").blocks
    assert blocks["tap"]["lead"][blocks["kind"] == lib.NCK_BLOCK_TAP].tolist() == [1.25]


@pytest.mark.parametrize(
    ("lines", "found"),
    [
        ("G84 X1 Z-20 R5", ("word-missing", 3)),  # the spindle stands
        ("M4\nG84 X1 Z-20 R5", ("word-missing", 4)),
        ("M3\nG74 X1 Z-20 R5", ("word-missing", 4)),
        ("M3\nG84 X1 Z4.99 R5", ("thread-run-in", 4)),
        ("M3\nG33.1 Z9.99 K1", ("thread-run-in", 4)),
        ("M3\nG33.1 Z-5", ("word-missing", 4)),
        ("M3\nG33.1 K1", ("word-missing", 4)),
        ("M3\nG33.1 Z-5 K30", ("thread-speed", 4)),
        ("M3\nG33.1 Z-999 K1", ("travel", 4)),
        ("M3 G96 D600 S100\nG33.1 Z-5 K1", ("thread-speed", 4)),
        ("G33.1 Z-5 K1", ("thread-speed", 3)),
        ("M3 S0.0001\nG33.1 Z-5 K1", ("thread-speed", 4)),  # one turn in a week
        ("M3 S0.0001\nG84 X1 Z-20 R5", ("thread-speed", 4)),
        ("M3\nG84 X1 Z-20 R5 Q1", ("word-unused", 4)),
    ],
)
def test_what_cannot_be_tapped_is_told(lines, found):
    assert findings(f"G21 G90 S600 F600\nG0 Z10\n{lines}\nM2\n") == [found]


TAPPED = (
    "G33.1 Z-7 K1.5", "G33.1 X3 Y4 Z-7 K0.8", "G91 G33.1 Z-14 K1\nG33.1 X2 Z-9 K1",
    "G84 X1 Y2 Z-9 R4", "G99 G84 X1 Z-9 R4 P1\nX7\nG91 X3 L2 R-1 Z-12",    "M4\nG74 X1 Z-9 R4",
)  # fmt: skip


@pytest.mark.parametrize("lines", TAPPED)
def test_holes_are_where_rs274_taps_them(lines, tool, tmp_path):
    tool("rs274")
    text = f"G21 G17 G90 G98 S600 F600 M3\nG0 X0 Y9 Z10\n{lines}\nG80\nG0 X1 Y1\nM2\n"
    (tmp_path / "program.ngc").write_text(text)
    _, complaint = rs274_oracle.run(tmp_path / "program.ngc", tmp_path, {1: 0.0})
    assert complaint == ""
    theirs = re.findall(r"(STRAIGHT_FEED|RIGID_TAP)\((.*)\)", (tmp_path / "canon.txt").read_text())
    bottoms = [[float(word) for word in numbers.split(",")][:3] for _, numbers in theirs]
    if theirs[0][0] == "STRAIGHT_FEED":  # of its cycles in and out
        bottoms = bottoms[::2]
    blocks = load(text).blocks
    taps = blocks[blocks["kind"] == lib.NCK_BLOCK_TAP]
    ours = taps["target_nm"][:, :3] / 1e6 + taps["tap"]["way"]
    assert np.allclose(ours, bottoms, atol=1e-4)
