# SPDX-License-Identifier: MIT
"""Room 1: mirrored, scaled, turned and polar coordinates of Fanuc's mills, against the same program
without them, mapped here."""

import math
import random

import numpy as np
import pytest

import pycnc
from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

FREE = [f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
PLANES = {17: (0, 1), 18: (2, 0), 19: (1, 2)}
WORDS = {17: "XYIJZ", 18: "ZXKIY", 19: "YZJKX"}
NEAR = 3e-6  # [mm] roundings to whole nanometres


@pytest.fixture(scope="module")
def machine():
    return Machine.load("mill3", set=[*FREE, "dialect.base=fanuc", "work.g55.x_mm=7"])


def decode(text, machine):
    blocks, diagnostics = stages.decode(text.encode(), machine)
    errors = diagnostics[diagnostics["code"] < 0]
    found = [(status_id(int(each["code"])), int(each["line"])) for each in errors]
    return blocks[blocks["kind"] <= lib.NCK_BLOCK_ARC], found


class Layout:
    """A random one: the words that begin and end it, and what it does to places and ways."""

    def __init__(self, source, plane):
        u, v = PLANES[plane]
        self.begin, self.end, self.steps = [], [], []
        place = lambda: [round(source.uniform(-40, 40), 3) for _ in range(3)]  # noqa: E731
        if source.random() < 0.5:
            at, axes = place(), source.sample(range(3), source.randint(1, 3))
            self.begin.append("G51.1 " + " ".join(f"{'XYZ'[k]}{at[k]}" for k in axes))
            self.end.insert(0, "G50.1")
            factor = np.array([-1.0 if k in axes else 1.0 for k in range(3)])
            self.steps.append((np.diag(factor), np.array(at)))
        if source.random() < 0.6:
            at, p = place(), round(source.uniform(0.2, 3), 2)
            even = source.random() < 0.5
            words = f"P{p:.2f}" if even else f"I{p:.2f} J-{p:.2f} K{p:.2f}"
            self.begin.append(f"G51 X{at[0]} Y{at[1]} Z{at[2]} {words}")
            self.end.insert(0, "G50")
            self.steps.append((np.diag([p, p if even else -p, p]), np.array(at)))
        if source.random() < 0.7 or not self.begin:
            at, angle = place(), source.uniform(-400, 400)
            self.begin.append(f"G68 {'XYZ'[u]}{at[u]} {'XYZ'[v]}{at[v]} R{angle:.4f}")
            self.end.insert(0, "G69")
            matrix = np.eye(3)
            c, s = math.cos(math.radians(round(angle, 4))), math.sin(math.radians(round(angle, 4)))
            matrix[np.ix_([u, v], [u, v])] = [[c, -s], [s, c]]
            self.steps.append((matrix, np.array(at)))

    def place(self, at):
        for k, (matrix, _) in enumerate(self.steps):
            fixed = self._centre(k)  # it is a place of the program too
            at = matrix @ (at - fixed) + fixed
        return at

    def _centre(self, k):
        at = self.steps[k][1]
        for j in range(k):
            fixed = self._centre(j)
            at = self.steps[j][0] @ (at - fixed) + fixed
        return at

    def way(self, way):
        for matrix, _ in self.steps:
            way = matrix @ way
        return way


def moves(source, plane):
    """Lines and arcs; the first says every coordinate."""
    u, v, i, j, w = WORDS[plane]
    number = lambda: f"{source.uniform(-30, 30):.3f}"  # noqa: E731
    lines = [f"G90 G0 X{number()} Y{number()} Z{number()}"]
    for _ in range(25):
        kind = source.randint(0, 5)
        if kind == 0:
            lines.append(source.choice(["G90", "G91"]))
        elif kind <= 2:
            letters = source.sample("XYZ", source.randint(1, 3))
            code = source.randint(0, 1)
            lines.append(f"G{code} " + " ".join(letter + number() for letter in letters))
        elif kind == 3:
            a, b = source.uniform(-9, 9), source.uniform(-9, 9)
            r = math.hypot(a, b) * source.uniform(0.55, 2) * source.choice([1, -1])
            lines.append(f"G91 G{source.choice('23')} {u}{a:.3f} {v}{b:.3f} R{r:.3f} {w}1")
        else:
            r, a, b = source.uniform(1, 9), source.uniform(0, 6), source.uniform(0, 6)
            end = [r * (math.cos(b) - math.cos(a)), r * (math.sin(b) - math.sin(a))]
            centre = [-r * math.cos(a), -r * math.sin(a)]
            lines.append(
                f"G91 G{source.choice('23')} {u}{end[0]:.6f} {v}{end[1]:.6f} "
                f"{i}{centre[0]:.6f} {j}{centre[1]:.6f}"
            )
    return lines


@pytest.mark.parametrize("first", range(0, 120, 30))
def test_a_program_lies_where_its_layout_puts_it(first, machine):
    for seed in range(first, first + 30):
        source = random.Random(seed)
        plane = source.choice([17, 18, 19])
        layout, lines = Layout(source, plane), moves(source, plane)
        head = f"G21 G55 G94 F600 G{plane}\n"
        plain, errors = decode("\n".join([head, *lines, "M30", ""]), machine)
        assert errors == []
        text = "\n".join([head, *layout.begin, *lines, *layout.end, "G90 G0 X1 Y2 Z3", "M30", ""])
        laid, errors = decode(text, machine)
        assert errors == [], f"seed {seed}: {errors}"
        assert (laid["target_nm"][-1][:3] == [8_000_000, 2_000_000, 3_000_000]).all()
        zero = np.array([7.0, 0.0, 0.0])
        assert laid["kind"][:-1].tolist() == plain["kind"].tolist(), f"seed {seed}"
        for ours, theirs in zip(laid, plain, strict=False):
            want = layout.place(theirs["target_nm"][:3] / 1e6 - zero) + zero
            assert np.abs(ours["target_nm"][:3] / 1e6 - want).max() < 25 * NEAR, f"seed {seed}"
            if theirs["kind"] != lib.NCK_BLOCK_ARC:
                continue
            u, v = PLANES[plane]
            centre = theirs["target_nm"][:3] / 1e6 - zero
            centre[u], centre[v] = theirs["centre_mm"] - zero[[u, v]]
            want = (layout.place(centre) + zero)[[u, v]]
            assert np.abs(ours["centre_mm"] - want).max() < 1e-3, f"seed {seed}"
            flips = mirrors(layout, u, v)
            assert ours["sweep_rad"] == pytest.approx(
                theirs["sweep_rad"] * (-1 if flips else 1), abs=1e-4
            ), f"seed {seed}"


def mirrors(layout, u, v):
    a, b = np.zeros(3), np.zeros(3)
    a[u], b[v] = 1.0, 1.0
    a, b = layout.way(a), layout.way(b)
    return a[u] * b[v] - a[v] * b[u] < 0


@pytest.mark.parametrize(
    ("lines", "places"),
    [
        ("G16\nG0 X10 Y30\nY120\nG15 X1", [(8.660254, 5), (-5, 8.660254), (1, 8.660254)]),
        ("G16\nG0 X10 Y0\nG91 Y90\nX5 Y0", [(10, 0), (0, 10), (0, 15)]),
        ("G0 X3 Y4\nG16 Y90", [(3, 4), (0, 5)]),
        ("G68 X0 Y0 R90\nG16 G0 X10 Y0", [(0, 10)]),
        ("G54 G16 G17 G0 X10 Y-90", [(0, -10)]),
    ],
)
def test_polar_coordinates(lines, places, machine):
    blocks, errors = decode(f"G21 G90 G54\n{lines}\nM30\n", machine)
    assert errors == []
    ends = blocks["target_nm"][-len(places) :, :2] / 1e6
    assert np.allclose(ends, places, atol=1e-6)


def test_holes_on_a_circle_by_steps_of_the_angle(machine):
    text = "G21 G90 G54 G98 F100\nG0 Z9\nG16 G81 X50 Y0 Z-5 R2\nG91 Y60 K5\nG15 G80\nM30\n"
    blocks, errors = decode(text, machine)
    cuts = blocks[blocks["kind"] == lib.NCK_BLOCK_LINE]["target_nm"] / 1e6
    angles = np.radians(np.arange(0, 360, 60))
    assert errors == []
    assert np.allclose(cuts[:, 0], 50 * np.cos(angles), atol=1e-6)
    assert np.allclose(cuts[:, 1], 50 * np.sin(angles), atol=1e-6)
    assert (cuts[:, 2] == -5).all()


@pytest.mark.thorough
def test_a_tool_stays_on_its_side_of_a_mirrored_contour(machine):
    contour = "G1 G41 D1 X10 Y0 F600\nX20\nG3 X30 Y10 J10\nG1 Y20\nG40 Y40"
    change = [*FREE, "dialect.base=fanuc", "tool.1.radius_mm=3"]
    ends = {}
    for name, words in {"plain": "", "mirrored": "G51.1 X0", "turned": "G68 X0 Y0 R90"}.items():
        text = f"G21 G90 G54 G17 G61\nG0 X0 Y-9\n{words}\nG90 G0 X0 Y-9\n{contour}\nM30\n"
        trace = pycnc.run(pycnc.load(text, Machine.load("mill3", set=change)))
        assert trace.program.diagnostics.errors == 0
        at = trace.columns
        ends[name] = np.stack([at["pos_x_mm"], at["pos_y_mm"]], axis=1)
    for name, back in {"mirrored": [[-1, 0], [0, 1]], "turned": [[0, -1], [1, 0]]}.items():
        other = ends[name] @ np.array(back)
        for point in ends["plain"][::200]:
            assert np.hypot(*(other - point).T).min() < 0.2


FOUND = (
    ("G68 X0 Y0 R30\nG92 X0", ("layout-on", 3)),
    ("G68 X0 Y0 R30\nG55", ("layout-on", 3)),
    ("G68 X0 Y0 R30\nG53 X0", ("layout-on", 3)),
    ("G68 X0 Y0 R30\nG28 X0", ("layout-on", 3)),
    ("G68 X0 Y0 R30\nG18", ("layout-on", 3)),
    ("G68 X0 Y0 R30\nG51 P2.", ("layout-on", 3)),
    ("G68 X0 Y0 R30\nG68 R3", ("layout-on", 3)),
    ("G51 P2.\nG51.1 X0", ("layout-on", 3)),
    ("G51 I2. J1.\nG2 X5 R5 F9", ("layout-on", 3)),
    ("G51 P2.\nG81 X1 Z-1 R1 F9", ("layout-on", 3)),
    ("G51.1 Z0\nG81 X1 Z-1 R1 F9", ("layout-on", 3)),
    ("G51 P2", ("scale-unit", 2)),
    ("G51 P0.", ("number-range", 2)),
    ("G51 X0", ("word-missing", 2)),
    ("G51 P2. I1.", ("word-shared", 2)),
    ("G68 X0 Y0", ("word-missing", 2)),
    ("G91 G68 X0 Y0 R5", ("incremental", 2)),
    ("G51.1", ("word-missing", 2)),
    ("G68 G69", ("modal-group", 2)),
    ("G68 G51 X0 Y0", ("modal-group", 2)),
    ("G16 G81 X5 Y0 Z-1 R1 F9\nG91 X1 Y9 K3", ("number-range", 3)),
)


@pytest.mark.parametrize(("lines", "found"), FOUND)
def test_what_cannot_be_laid_out_is_told(lines, found, machine):
    assert decode(f"G21 G90 G17 G54\n{lines}\nM30\n", machine)[1] == [found]


def test_the_flag_says_what_a_factor_without_a_point_means():
    for unit, want in (("0.001", 2.0), ("1", 2000.0 / 1000)):
        change = [*FREE, "dialect.base=fanuc", f"dialect.scale_unit={unit}"]
        factor = "2000" if unit == "0.001" else "2"
        text = f"G21 G90 G54\nG51 X0 Y0 P{factor}\nG0 X5\nM30\n"
        blocks, errors = decode(text, Machine.load("mill3", set=change))
        assert errors == []
        assert blocks["target_nm"][-1][0] == 5e6 * want


def test_a_safety_line_ends_what_is_not_in_force(machine):
    blocks, errors = decode("G17 G40 G49 G80 G69 G15 G50 G90 G21 G54\nG0 X5\nM30\n", machine)
    assert (errors, blocks["target_nm"][-1][0]) == ([], 5e6)
