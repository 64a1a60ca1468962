# SPDX-License-Identifier: MIT
"""A tolerance is measured both ways: how far the run is from the program, and how near it comes to
every point that the program names. Judged by runs that were spoilt on purpose: each is made of a
run with exact stops, which is sound within any tolerance."""

from itertools import pairwise

import checker
import judged
import numpy as np
import pytest
from judged import judge, rounded

import pycnc
from pycnc.bench import programs
from pycnc.machine import Machine
from pycnc.report.path_error import PathError
from pycnc.program import Program

P = 0.1
HEAD = "G17 G21 G90 G94 "
CORNER = "G1 X40 F1200\nG1 Y40\nM2\n"
SPIKE = "G1 X80 F1200\nG1 X0.027413 Y2.094155\nM2\n"  # back at 1.5 degrees
CIRCLE = "G1 X40 F1200\nG3 I0 J5\nG1 X80\nM2\n"


def stopping_run(moves):
    """Return a program within P, and the rows of a run that stops at the end of every move."""
    machine = Machine.load("mill3", set=["path.slope=optimal"])
    rows = judged.rows_of(Program(f"{HEAD}G61.1\n{moves}".encode(), machine))
    return Program(f"{HEAD}G64 P{P}\n{moves}".encode(), machine), rows


def bump(s, middle, reach=15.0):
    """Return 1 at the middle, 0 beyond reach, with four derivatives everywhere."""
    return np.cos(np.clip((s - middle) / reach, -1, 1) * np.pi / 2) ** 6


def moved(rows, middle, away):
    """Move the run by away [mm] where its coordinate is the middle, and less about it."""
    size = bump(rows["pose"]["s"], middle)
    rows["pose"]["axis"][:, :2] += np.outer(size, away)
    return rounded(rows)


def a_cut_corner(rows):
    return moved(rows, 40, (-5 * P, 5 * P))


def a_tip_missed_by_a_little(rows):
    return moved(rows, 40, (-1.4 * P / np.sqrt(2), 1.4 * P / np.sqrt(2)))


def a_corner_left_outward(rows):
    return moved(rows, 40, (1.2 * P / np.sqrt(2), -1.2 * P / np.sqrt(2)))


def a_cut_tip(rows):
    """From one line of the spike to the other 7.5 mm before its tip: within P of both."""
    ahead = rows["pose"]["s"] - 80
    over = np.clip(ahead / 20, -1, 1)
    share = 0.5 + over * (15 - 10 * over**2 + 3 * over**4) / 16  # from line to line
    near = np.clip(ahead / 24, -1, 1) ** 2
    left = 24 * (5 + 15 * near - 5 * near**2 + near**3) / 16  # to the tip; beyond 24 mm as it was
    left = np.maximum(left, np.abs(ahead))
    back = np.array([0.027413 - 80, 2.094155]) / np.hypot(0.027413 - 80, 2.094155)
    ways = (1 - share)[:, None] * np.array([-1, 0]) + share[:, None] * back
    rows["pose"]["axis"][:, :2] = [80, 0] + left[:, None] * ways
    return rounded(rows)


def missed(moves, spoil):
    """Return what the checker says about a spoilt run."""
    program, rows = stopping_run(moves)
    judge(program, rows)
    with pytest.raises(checker.PhysicsError) as caught:
        judge(program, spoil(rows.copy()))
    return str(caught.value)


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (a_cut_corner, "off the path"),
        (a_tip_missed_by_a_little, "programmed point is missed by 0.139"),
        (a_corner_left_outward, "tool faster than its feed"),
    ],
)
def test_the_checker_finds_a_spoilt_corner(spoil, words):
    assert words in missed(CORNER, spoil)


def test_the_checker_finds_a_path_that_leaves_a_corner_outward():
    program, _ = stopping_run(CORNER.replace("F1200", "F1300"))
    _, rows = stopping_run(CORNER)  # slow enough for a longer way
    with pytest.raises(checker.PhysicsError, match="off the path"):
        judge(program, a_corner_left_outward(rows))


def test_the_checker_finds_a_tip_that_is_cut_between_two_lines_that_are_nearly_one():
    assert "programmed point is missed by 7.4" in missed(SPIKE, a_cut_tip)


def a_circle_left_out(rows):
    """Stand where it begins and ends."""
    turning = rows["pose"]["block"] == 1
    rows["pose"]["axis"][turning, :2] = [40, 0]
    return rounded(rows)


def test_the_checker_finds_a_circle_that_is_left_out():
    assert "programmed point is missed by" in missed(CIRCLE, a_circle_left_out)


# What `path_error_mm` tells


def test_the_path_error_is_what_a_run_of_fine_ticks_misses_a_corner_by():
    machine = Machine.load("mill3", set=["path.slope=optimal", "kernel.period_ms=0.1"])
    trace = pycnc.run(f"{HEAD}G64 P0.05\nG1 X40 F6000\nY40\nM2\n", machine=machine)
    nearest = np.hypot(trace["pos_x_mm"] - 40, trace["pos_y_mm"]).min()
    assert nearest > 0.04
    assert trace.summary["path_error_mm"] == pytest.approx(nearest, rel=0.01)


def segs_of(text):
    program = Program(f"{HEAD}{text}".encode(), Machine.load("mill3"))
    return program, judged.plan(program)[1]


def error_of(program, *pieces):
    error = PathError(program)
    for segs in pieces:
        error.add_segs(segs)
    error.finish_segs()
    return error


@pytest.mark.parametrize("moves", [CORNER, SPIKE, CIRCLE, "G18 G2 X4 Z4 R4 Y2 F600\nG1 A9\nM2\n"])
def test_an_exact_path_has_no_error(moves):
    machine = Machine.load("mill5_xyzac")
    program = Program(f"{HEAD}G61\n{moves}".encode(), machine)
    segs = judged.plan(program)[1]
    assert error_of(program, *np.array_split(segs, len(segs))).largest_mm < 1e-12


def test_a_line_in_place_of_a_circle_misses_it():
    program, _ = segs_of(f"G64 P1\n{CIRCLE}")
    _, segs = segs_of("G61\nG1 X40 F1200\nX41\nX80\nM2\n")
    segs["end"][1], segs["start"][2] = segs["start"][1], segs["start"][1]
    lengths = program.moves.length() - 80
    segs["length"][1] = lengths
    segs["s_begin"][2] += lengths - 1
    assert error_of(program, segs).largest_mm == pytest.approx(10, abs=1e-9)


@pytest.mark.parametrize("pieces", [1, 3])
def test_a_spline_that_cuts_a_corner_misses_its_vertex(pieces):
    program, _ = segs_of(f"G64 P1\n{CORNER}")
    _, segs = segs_of("G61\nG1 X37 F1200\nX40\nY40\nM2\n")
    segs["kind"][1] = 2
    segs["start"][2] = segs["end"][1] = [40, 3, 0, 0, 0, 0, 0, 0, 0]
    segs["shape"]["inner"][1] = [segs["start"][1], segs["end"][1]]  # a straight cut
    segs["length"][1:] = [6, 37]
    segs["s_begin"][2] = 43
    error = error_of(program, *np.array_split(segs, pieces))
    assert error.largest_mm == pytest.approx(3 / np.sqrt(2), rel=1e-6)
    assert error.missed == pytest.approx(3 / np.sqrt(2), rel=1e-6)


def test_what_comes_by_later_is_not_near():
    """To and fro twice, the first time a part of the way only."""
    program, _ = segs_of("G64 P0.1\nG1 X10 F1200\nX0\nX10\nX0\nM2\n")
    _, segs = segs_of("G61\nG1 X5 F1200\nX0\nX10\nX0\nM2\n")
    segs["length"], segs["s_begin"] = 10, [0, 10, 20, 30]
    assert error_of(program, segs).largest_mm == pytest.approx(5)


@pytest.mark.parametrize("keep", [True, False])
def test_a_program_read_in_pieces_is_as_far_from_its_run(monkeypatch, keep):
    """Of a long program only what is near is in memory: that is enough."""
    machine = Machine.load("mill3", set=["path.slope=optimal"])
    moves = [f"X{k * 0.7:.2f} Y{k % 3 * 0.6:.2f}" for k in range(120)]
    text = f"{HEAD}G64 P{P}\nG1 F3000\n{chr(10).join(moves)}\nG2 X0 Y0 R60\nM2\n".encode()
    whole = pycnc.run(Program(text, machine))
    monkeypatch.setattr("pycnc.program._PIECE", 16)
    monkeypatch.setattr("pycnc.kernel.BLOCK_ROWS", 16)
    monkeypatch.setattr("pycnc.report.path_error._SEGS", 32)
    monkeypatch.setattr("pycnc.report.path_error._MOVES", 16)
    parts = pycnc.run(Program(text, machine, keep=keep))
    assert whole.summary["path_error_mm"] > 0.1 * P
    assert parts.summary["path_error_mm"] == whole.summary["path_error_mm"]


@pytest.mark.parametrize("step", [0.1, 1.0])
@pytest.mark.parametrize("mode", ["G61", "G64 P0.01"])
def test_more_jerk_is_never_slower(mode, step):
    program = programs.zigzag(mode, 60, step)
    jerks = (10_000, 50_000, 200_000, 1_000_000, 10_000_000, 100_000_000)
    times = [pycnc.plan(program, programs.machine(j=j)).time_s for j in jerks]
    for less, more in pairwise(times):  # a step of the optimal slope may cost up to 2 %
        assert more <= (1.005 if mode == "G61" else 1.02) * less
    assert times[-1] < 0.8 * times[0]


@pytest.mark.parametrize(("count", "step", "tolerances"), [
    (2, 2.0, (0.03, 0.1, 0.3, 1.0)), (2, 10.0, (0.03, 0.1, 0.3, 1.0)), (60, 1.0, (0.03, 0.1, 0.3)),
])  # fmt: skip
def test_more_tolerance_is_never_slower_at_corners_that_are_stopped_at(count, step, tolerances):
    machine = programs.machine()
    runs = [
        pycnc.run(programs.zigzag(f"G64 P{tolerance}", count, step), machine).summary
        for tolerance in tolerances
    ]
    for (less, more), tolerance in zip(pairwise(runs), tolerances[1:], strict=True):
        assert more["time_s"] <= 1.005 * less["time_s"]
        assert more["path_error_mm"] <= tolerance
        assert max(more["peaks"][axis]["j"] for axis in "xy") <= 1


@pytest.mark.parametrize("last", [0.03, 0.08, 0.2])
@pytest.mark.parametrize("way", [1, -1])
def test_a_curve_of_chords_does_not_rest_at_the_vertex_beside_its_end(last, way):
    turns = np.radians(2.2) * np.arange(18)
    lengths = np.append(np.full(17, 0.14), last)[::way]
    places = np.cumsum(lengths[:, None] * np.column_stack([np.cos(turns), np.sin(turns)]), axis=0)
    points = np.vstack([[0, 0], np.round(places, 6)])
    plan = pycnc.plan(Program.from_points(points, 6000, programs.machine(), tolerance=0.01))
    assert not plan.segs["stop"][1:-1].any()
    jerk = programs.machine().limits("j_max")[:2].min()
    assert plan.time_s < 1.6 * (32 * lengths.sum() / jerk) ** (1 / 3)


def test_more_tolerance_is_no_slower_at_a_turn_back_of_two_corners():
    points = np.array([(x, y) for y, xs in ((0, np.arange(0, 30.1, 0.125)),
                                            (0.12, np.arange(30, -0.1, -0.125))) for x in xs])
    times = [
        pycnc.plan(Program.from_points(points, 6000, programs.machine(), tolerance=p)).time_s
        for p in (0.01, 0.02, 0.05)
    ]
    for less, more in pairwise(times):
        assert more <= 1.005 * less


def test_a_slow_feed_is_kept_on_all_of_a_wide_bend():
    machine = Machine.load("mill3")
    moves = "G1 X-0.8 Y-0.67 F150\nG1 X0.2\nM2\n"
    exact, wide = (
        pycnc.plan(Program(f"{HEAD}{mode}\n{moves}".encode(), machine)).time_s
        for mode in ("G61.1", "G64 P0.86")
    )
    assert wide <= 1.2 * exact


def test_a_path_jerk_that_no_axis_allows_changes_nothing():
    program = programs.zigzag("G64 P0.01", 60, 1.0)
    times = [
        pycnc.plan(program, Machine.load("mill3", set=[f"path.j_max_mm_s3={j}"])).time_s
        for j in (2e5, 1e9)
    ]
    assert times[0] == times[1]
