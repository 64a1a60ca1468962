# SPDX-License-Identifier: MIT
"""Programs without text: points and moves are planned and run as the same text is."""

import numpy as np
import pytest

import pycnc
from pycnc.errors import ArgumentError, ProgramError
from pycnc.program import Program
from pycnc.kernel.records import dtype

TEXT = (
    "G21 G90 G17 G90.1 G61 G0 X0 Y0\nG1 X10 F600\nG64 P0.01 X10 Y4\nG3 X10 Y8 I10 J6 F900\n"
    "G4 P0.1\nS1200\nM3\nT1\nG61.1 G1 X2 Y8 Z1\nG93 X0 F60\nM2\n"
)
MOVES = [
    {"kind": "rapid", "x": 0, "y": 0, "path": "exact"},
    {"kind": "line", "x": 10, "feed": 600},
    {"kind": "line", "x": 10, "y": 4, "tolerance": 0.01},
    {"kind": "arc", "x": 10, "y": 8, "centre": (10, 6), "turns": 1, "feed": 900},
    {"kind": "dwell", "seconds": 0.1},
    {"kind": "s", "rpm": 1200},
    {"kind": "m", "code": 3},
    {"kind": "t", "number": 1},
    {"kind": "line", "x": 2, "y": 8, "z": 1, "path": "stop"},
    {"kind": "line", "x": 0, "feed": 60, "feed_mode": "inverse"},
    {"kind": "m", "code": 2},
]


def rows_of(program, slope):
    trace = pycnc.run(program, slope=slope)
    return {name: trace[name] for name in ("line", "joint_0_nm", "joint_1_nm", "joint_2_nm")}


@pytest.mark.parametrize("slope", ["linear", "jerk"])
def test_moves_are_executed_as_the_same_text(slope):
    by_text = rows_of(pycnc.load(TEXT, "mill3"), slope)
    by_moves = rows_of(Program.from_moves(MOVES, "mill3"), slope)
    assert len(by_text["line"]) > 1000
    for name in by_text:
        np.testing.assert_array_equal(by_moves[name], by_text[name], name)


def test_points_are_gone_to_one_after_the_other():
    turn = np.linspace(0, 2 * np.pi, 500)
    points = np.c_[20 + 8 * np.cos(turn), 20 + 8 * np.sin(turn), turn]
    program = Program.from_points(points, feed=1500, machine="mill3", tolerance=0.005)
    trace = pycnc.run(program, slope="jerk")
    assert program.block_count == 501 and not list(program.diagnostics)
    path = np.c_[trace["pos_x_mm"], trace["pos_y_mm"], trace["pos_z_mm"]]
    np.testing.assert_allclose(path[-1], points[-1], atol=1e-6)
    radius = np.hypot(path[:, 0] - 20, path[:, 1] - 20)[trace["line"] > 1]
    assert abs(radius - 8).max() < 0.006
    assert np.all(np.diff(trace["line"].astype(int)) >= 0) and trace["line"][-1] == 500
    assert trace.summary["path_error_mm"] < 0.0051


def test_feed_may_be_given_for_every_point():
    points = [[0, 0], [20, 0], [20, 20]]
    slow = pycnc.plan(Program.from_points(points, feed=[100, 300, 300], machine="mill3"))
    fast = pycnc.plan(Program.from_points(points, feed=[100, 300, 1200], machine="mill3"))
    assert slow.time_s == pytest.approx(8.0, abs=0.3) and fast.time_s == pytest.approx(5, abs=0.3)


def test_a_block_program_goes_to_another_slope_and_machine():
    program = Program.from_points([[0, 0, 0], [5, 5, 5]], feed=600, machine="mill3")
    assert pycnc.plan(program, machine="mill5_xyzac", slope="optimal").time_s > 0.5
    assert pycnc.plan(program, plan="grades", slope="linear").time_s > 0.5


def test_rows_of_the_kernel_are_taken_as_they_are():
    rows = np.zeros(2, dtype("nck_block_in_t"))
    rows["id"], rows["kind"], rows["axes"] = [70001, 70002], 2, 1
    rows["target"][:, 0] = [3, 4]
    rows["sets"], rows["feed"] = 1, 600
    assert Program.from_moves(rows, "mill3").blocks["line"].tolist() == [70001, 70002, 70002]


def test_an_error_of_the_program_names_the_move():
    program = Program.from_moves([{"kind": "line", "x": 1, "feed": 60, "id": 41},
                                  {"kind": "line", "x": 1e5, "id": 42}], "mill3")  # fmt: skip
    with pytest.raises(ProgramError) as caught:
        pycnc.run(program)
    assert caught.value.line == 42 and "travel" in str(caught.value)


@pytest.mark.parametrize(
    ("moves", "said"),
    [
        ([{"kind": "lin"}], "no kind 'lin'"),
        ([{"kind": "line", "i": 3}], "no 'i' in a line"),
        ([{"kind": "arc", "x": 3, "turns": 1}], "'centre' is missing"),
        ([{"kind": "line", "x": "far"}], "could not convert"),
        ([{"kind": "line", "x": 1, "feed": 0}], "outside of its range"),
        ([{"kind": "line", "x": float("nan")}], "outside of its range"),
        ([{"kind": "line", "x": 1, "path": "exact", "tolerance": 1}], "path is one of"),
    ],
)
def test_a_bad_move_is_refused_in_one_sentence(moves, said):
    with pytest.raises(ArgumentError, match=said):
        Program.from_moves(moves, "mill3")


@pytest.mark.parametrize(
    ("points", "feed", "said"),
    [
        ([1, 2, 3], 100, "shape"),
        (np.zeros((0, 2)), 100, "shape"),
        ([[0, 0, 0, 0]], 100, "k from 1 to 3"),
        ([[0, 0], [1, 1]], [100, 0], "point 1"),
        ([[0, 0], [1, np.inf]], 100, "point 1"),
        ([[0, 0], [1, 1]], [1, 2, 3], "feed"),
        ([[0, 0], [1]], 100, "points: "),
        ([[0, 0], [1, 1]], "fast", "feed: "),
    ],
)
def test_bad_points_are_refused_in_one_sentence(points, feed, said):
    with pytest.raises(ArgumentError, match=said):
        Program.from_points(points, feed, "mill3")
