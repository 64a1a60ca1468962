# SPDX-License-Identifier: MIT
"""Room 1: splines against their own definition (B-spline basis functions), and against what rs274
takes and refuses."""

import random

import numpy as np
import pytest
import rs274_oracle
from polylines import distance

import pycnc
from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

FREE = [f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
HEAD = "G21 G90 G17 F600\nG0 X0 Y0\n"
CHORD = 1e-3  # [mm] path.chord_error_mm of mill3


@pytest.fixture(scope="module")
def machine():
    return Machine.load("mill3", set=FREE)


def decode(text, machine):
    blocks, diagnostics = stages.decode(text.encode(), machine)
    errors = diagnostics[diagnostics["code"] < 0]
    found = [(status_id(int(each["code"])), int(each["line"])) for each in errors]
    return blocks[blocks["kind"] <= lib.NCK_BLOCK_ARC], found


def curve_of(points, weights, knots, order, samples):
    """Return points of a rational B-spline by Cox and de Boor's recursion, those of knots too."""
    n = len(points) - 1
    u = np.union1d(np.linspace(knots[0], knots[-1], samples, endpoint=False), knots[:-order])
    basis = [((knots[i] <= u) & (u < knots[i + 1])).astype(float) for i in range(n + order)]
    for k in range(2, order + 1):
        for i in range(n + 1 + order - k):
            left, right = knots[i + k - 1] - knots[i], knots[i + k] - knots[i + 1]
            a = (u - knots[i]) / left * basis[i] if left else 0.0
            b = (knots[i + k] - u) / right * basis[i + 1] if right else 0.0
            basis[i] = a + b
    weighed = np.array(weights)[:, None] * np.array(basis[: n + 1])
    return (weighed.T @ np.array(points)) / weighed.sum(axis=0)[:, None]


def curve(points, weights, order):
    """Return points of the one with knots 0 … 0 1 2 … m … m."""
    n = len(points) - 1
    knots = [max(0, min(i - order + 1, n - order + 2)) for i in range(n + order + 1)]
    return curve_of(points, weights, knots, order, 700 * (n - order + 2))


def check(blocks, points, weights, order):
    path = np.vstack([points[0], blocks["target_nm"][1:, :2] / 1e6])
    want = curve(points, weights, order)
    assert (path[-1] == np.round(points[-1], 6)).all()
    assert distance(want[::7], path) <= 1.05 * CHORD
    assert distance(path, np.vstack([want, points[-1]])) <= 1e-3
    assert (blocks["kind"][1:] == lib.NCK_BLOCK_LINE).all()
    assert (blocks["feed"][1:] == 600).all()


@pytest.mark.sample(quick=4)
@pytest.mark.parametrize("seed", range(20))
def test_a_nurbs_is_the_one_of_its_definition(seed, machine):
    source = random.Random(seed)
    order, count = source.choice([2, 3, 3, 4, 5]), source.randint(5, 12)
    number = lambda: round(source.uniform(-20, 20), 3)  # noqa: E731
    points = [(0.0, 0.0)] + [(number(), number()) for _ in range(count)]
    weights = [round(source.uniform(0.5, 3), 2) for _ in points]
    lines = [f"G5.2 P{weights[0]} L{order}"]
    lines += [f"X{x} Y{y} P{w}" for (x, y), w in zip(points[1:], weights[1:], strict=True)]
    blocks, errors = decode(HEAD + "\n".join([*lines, "G5.3", "M2", ""]), machine)
    assert errors == []
    check(blocks, points, weights, order)


@pytest.mark.parametrize("seed", range(10))
def test_g5_and_g5_1_are_bezier_curves(seed, machine):
    source = random.Random(seed)
    i, j, p, q, x, y = (round(source.uniform(-20, 20), 3) for _ in range(6))
    blocks, errors = decode(f"{HEAD}G5 I{i} J{j} P{p} Q{q} X{x} Y{y}\nM2\n", machine)
    assert errors == []
    check(blocks, [(0, 0), (i, j), (x + p, y + q), (x, y)], [1] * 4, 4)
    blocks, errors = decode(f"{HEAD}G91 G5.1 I{i} J{j} X{x} Y{y}\nM2\n", machine)
    assert errors == []
    check(blocks, [(0, 0), (i, j), (x, y)], [1] * 3, 3)


def test_a_g5_without_i_and_j_goes_on_as_the_one_before(machine):
    text = f"{HEAD}G5 I0 J3 P-2 Q-3 X1 Y1\nG5 P0 Q-3 X4 Y1\nM2\n"
    blocks, _ = decode(text, machine)
    path = np.vstack([[0.0, 0.0], blocks["target_nm"][1:, :2] / 1e6])
    second = curve([(1, 1), (3, 4), (4, -2), (4, 1)], [1] * 4, 4)
    assert distance(second[::9], path) <= 1.05 * CHORD


def test_a_spline_in_inches_and_the_time_of_plan_and_run(machine):
    text = "G20 G90 G17 F20\nG0 X0 Y0\nG5 I0 J1 P0 Q-1 X1 Y1\nM2\n"
    blocks, errors = decode(text, machine)
    assert errors == []
    assert blocks["target_nm"][-1][:2].tolist() == [25_400_000, 25_400_000]
    program = pycnc.load(text, machine)
    assert pycnc.plan(program).time_s == pytest.approx(pycnc.run(program).summary["time_s"])


SAID = (
    ("G5 I0 J3 P0 X1 Y1", "word-missing"),
    ("G5 I0 J3 P0 Q1 X1 Y1 Z2", "spline"),
    ("G18\nG5 I0 J3 P0 Q1 X1 Y1", "spline"),
    ("G5.1 X3", "word-missing"),
    ("G5.1 I1 J2", "word-missing"),
    ("G5.2 X0 Y1 P1\nG5.3", "spline"),
    ("G5.3", "spline"),
    ("G5.2 X0 P1\nG5.3", "word-missing"),
    ("G5.2 X0 Y1 P1\nX1 Y1\nG5.3", "word-missing"),
    ("G5.2 X0 Y1 P1 L6\nX1 Y1 P1\nG5.3", "spline"),
    ("G5.2 X0 Y1 P1\nG1 X5\nG5.3", "spline"),
    ("G5 I0 J3 P0 Q-3 X1", ""),
    ("G5.2 X0 Y1 P1\nX1 Y1 P1\nG5.3\nG1 X4", ""),
    ("G5.2 X0 Y1 P1\nX1 Y1 P1\nG5.3\nX4", "no-motion"),
    ("G5 P0 Q-3 X1 Y1", ""),
)


@pytest.mark.parametrize(("lines", "found"), SAID)
def test_rs274_takes_and_refuses_the_same(lines, found, machine, tool, tmp_path):
    tool("rs274")
    text = f"{HEAD}{lines}\nM2\n"
    errors = decode(text, machine)[1]
    assert [each[0] for each in errors][:1] == ([found] if found else [])
    (tmp_path / "program.ngc").write_text(text)
    _, complaint = rs274_oracle.run(tmp_path / "program.ngc", tmp_path, {1: 0.0})
    assert (complaint == "") == (found == "")


@pytest.mark.parametrize(
    ("lines", "found"),
    [
        ("G5.2 X0 Y1 P0\nX1 Y1 P1\nG5.3", ("number-range", 3)),
        ("G5.2 X0 Y1 P1 L9\nX1 Y1 P1\nG5.3", ("number-range", 3)),
        ("G93\nG5 I0 J3 P0 Q1 X1 Y1 F9", ("unsupported", 4)),
        ("G41 D1\nG5 I0 J3 P0 Q1 X1 Y1", ("comp-on", 4)),
    ],
)
def test_what_cannot_be_a_spline_is_told(lines, found):
    machine = Machine.load("mill3", set=[*FREE, "tool.1.radius_mm=1"])
    assert decode(f"{HEAD}{lines}\nM2\n", machine)[1][:1] == [found]


OPEN = "G5.2 X0 Y1 P1\nX1 Y1 P1\nX2 Y3 P1\n"


@pytest.mark.parametrize(
    ("lines", "found"),
    [
        (f"{OPEN}M2\n", ("spline", 3)),
        (f"{OPEN}M30\n", ("spline", 3)),
        (OPEN, ("spline", 3)),
        ("G5.2 X0 Y1 P1 M2\n", ("spline", 3)),
        (f"{OPEN}G1 X5\nX6\nX7 Y7\nG5.3\nM2\n", ("spline", 6)),
        (f"{OPEN}G80\nG5.3\nM2\n", ("spline", 6)),
        (f"{OPEN}G28 Z0\nG5.3\nM2\n", ("spline", 6)),
        (f"{OPEN}G30\nG5.3\nM2\n", ("spline", 6)),
        (f"{OPEN}G5.3 X4\nM2\n", ("word-unused", 6)),
        (f"{OPEN}X4 Y4\nX5 Y5\nG5.3\nM2\n", ("word-missing", 6)),
        (f"{OPEN}?\nX5 Y5 P1\nG5.3\nM2\n", ("character", 6)),
    ],
)
def test_a_spline_that_is_not_ended_is_one_finding(lines, found, machine):
    blocks, errors = decode(HEAD + lines, machine)
    assert errors == [found]
    assert (blocks["kind"] == lib.NCK_BLOCK_RAPID).all()


def test_a_spline_that_the_end_mark_cuts_off_is_told(machine):
    assert decode(f"%\n{HEAD}{OPEN}%\n", machine)[1] == [("spline", 4)]


def test_what_sets_no_place_may_stand_in_a_spline(machine):
    between = "G55\nM3 S100\nG4 P0.1\nG92 X9\nG4 P0.1\n"
    plain = decode(f"{HEAD}{OPEN}G5.3\nM2\n", machine)[0]
    blocks, errors = decode(f"{HEAD}{OPEN}{between}G5.3\nM2\n", machine)
    assert errors == []
    assert (blocks["target_nm"] == plain["target_nm"]).all()


def test_travel_is_looked_at_chord_by_chord():
    errors = decode(f"{HEAD}G5 I0 J999 P0 Q999 X1 Y1\nM2\n", Machine.load("mill3"))[1]
    assert errors == [("travel", 3)]
    assert decode(f"{HEAD}G5 I0 J300 P0 Q300 X1 Y1\nM2\n", Machine.load("mill3"))[1] == []


# Fanuc's G6.2: knots that are said, in space.


def said_knots(points, weights, knots, order):
    places = [f"X{x} Y{y} Z{z} R{w}" for (x, y, z), w in zip(points, weights, strict=True)]
    places += [""] * order
    lines = [f"K{knot} {place}" for knot, place in zip(knots, places, strict=True)]
    return f"G6.2 P{order} " + "\n".join(lines)


@pytest.mark.sample(quick=4)
@pytest.mark.parametrize("seed", range(20))
def test_g6_2_is_the_curve_of_its_definition(seed):
    source = random.Random(seed)
    order, count = source.choice([2, 3, 4, 4]), source.randint(4, 12)
    number = lambda: round(source.uniform(-20, 20), 3)  # noqa: E731
    points = [(0.0, 0.0, 0.0)] + [(number(), number(), number()) for _ in range(count)]
    weights = [round(source.uniform(0.5, 3), 2) for _ in points]
    inner = sorted(round(source.uniform(1, 5), 3) for _ in range(len(points) - order))
    if order == 4 and len(inner) > 3:
        inner[1] = inner[2]  # twice
    knots = [float(source.choice([0, 0.5]))] * order + inner + [6.0] * order
    text = f"{HEAD}{said_knots(points, weights, knots, order)}\nG1 X0.\nM30\n"
    blocks, errors = decode(text, Machine.load("mill3", set=[*FREE, "dialect.base=fanuc"]))
    assert errors == []
    path = np.vstack([points[0], blocks["target_nm"][1:-1, :3] / 1e6])
    want = curve_of(points, weights, knots, order, 25_000)
    assert (path[-1] == np.round(points[-1], 6)).all()
    assert distance(want[::47], path) <= 1.05 * CHORD
    assert distance(path[::5], np.vstack([want, points[-1]])) <= 2e-3
    assert (blocks["feed"][1:] == 600).all()


ARC = "G6.2 P3 K0. X0. Y0. R1.\nK0. X5. Y0. R0.70710678\nK0. X5. Y5. R1.\nK1.\nK1.\nK1.\n"


def test_a_quarter_of_a_circle_is_one():
    machine = Machine.load("mill3", set=[*FREE, "dialect.base=fanuc"])
    blocks, errors = decode(f"{HEAD}{ARC}G1 X9.\nM30\n", machine)
    assert errors == []
    curve_nm = blocks["target_nm"][1:-1, :2]
    radius = np.hypot(curve_nm[:, 0], curve_nm[:, 1] - 5_000_000)
    assert abs(radius - 5_000_000).max() <= 2


@pytest.mark.parametrize(
    ("lines", "found"),
    [
        (ARC.replace("X0. Y0.", "X1. Y0."), ("spline", 3)),  # the tool is elsewhere
        (ARC.replace("K1.\nK1.\nK1.", "K1.\nK1.\nK2."), ("spline", 8)),
        (ARC.replace("K1.\nK1.\nK1.", "K1.\nG1 X9."), ("spline", 7)),
        (ARC.replace("K0. X5. Y5.", "K-1. X5. Y5."), ("spline", 5)),
        (ARC.replace("K0. X5. Y5.", "X5. Y5."), ("word-missing", 5)),
        (ARC.replace("X5. Y5.", "X5."), ("word-missing", 5)),
        (ARC.replace("X5. Y5.", "X5. Y5. Z1."), ("spline", 5)),
        (ARC.replace("K1.\nK1.\nK1.", "K1\nK1.\nK1."), ("scale-unit", 6)),
        (ARC.replace("P3", "P5"), ("number-range", 3)),
        (ARC.replace("R0.7", "R-0.7"), ("number-range", 4)),
        (ARC.replace("G6.2", "G91 G6.2"), ("spline", 3)),
        (ARC.replace("G6.2", "G93 G6.2"), ("unsupported", 3)),
        (ARC + "K1.\n", ("spline", 9)),
        (ARC + "X3. Y3. K2.\n", ("spline", 9)),
        (ARC.replace("K1.\nK1.\nK1.", "K1.\nM30"), ("spline", 3)),
    ],
)
def test_what_cannot_be_a_g6_2_is_one_finding(lines, found):
    machine = Machine.load("mill3", set=[*FREE, "dialect.base=fanuc"])
    assert decode(f"{HEAD}{lines}G0 X1.\nM30\n", machine)[1] == [found]
