# SPDX-License-Identifier: MIT
"""Fanuc's ,A: one axis of the plane and the angle of the line say where it ends."""

import math
import random

import numpy as np
import pytest

import pycnc
from pycnc.kernel.bind import lib
from pycnc.machine import Machine

AXES = {17: "XY", 18: "ZX", 19: "YZ"}


def fanuc(*changes):
    return Machine.load("mill5_xyzac", set=["dialect.base=fanuc", *changes])


def decoded(text, machine):
    program = pycnc.load(text, machine)
    return [(each.id, each.line, each.col) for each in program.diagnostics
            if each.severity == "error"], program.blocks  # fmt: skip


@pytest.mark.sample(12)
@pytest.mark.parametrize("seed", range(400))
def test_the_line_ends_where_its_angle_leads(seed, draw_seed):
    rng = random.Random(seed + draw_seed)
    plane, inch, steps = rng.choice((17, 18, 19)), rng.random() < 0.3, rng.random() < 0.3
    scale, reach = (25.4, 2) if inch else (1.0, 50)
    lines = [f"G{20 if inch else 21} G90 G{plane} G94 F900", "G0 X0 Y0 Z0"]
    at, ends = [0.0, 0.0], []
    if steps:
        lines.append("G91")
    for _ in range(12):
        angle = round(rng.choice((rng.uniform(-360, 360), rng.choice((0, 30, 45, 90, 180)))), 3)
        sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
        said = 0 if abs(cosine) > abs(sine) else 1
        place = round(rng.uniform(-reach, reach), 3)
        way = round(place - at[said], 6) if steps else place - at[said]  # as it is written
        rest = way * (sine / cosine if said == 0 else cosine / sine)
        at[said] += way
        at[1 - said] += rest
        if max(map(abs, at)) * scale > 190:
            break
        word = f"{AXES[plane][said]}{way if steps else place:.6f}"
        slant = f",A{angle:.3f}"
        lines.append(f"G1 {word} {slant}" if rng.random() < 0.5 else f"G1 {slant} {word}")
        ends.append([value * scale for value in at])
    errors, blocks = decoded("\n".join([*lines, "M30\n"]), fanuc("axis.z.min_mm=free",
                             "axis.x.min_mm=free", "axis.y.min_mm=free", "axis.x.max_mm=free",
                             "axis.y.max_mm=free", "axis.z.max_mm=free"))  # fmt: skip
    assert errors == []
    cuts = blocks[blocks["kind"] == lib.NCK_BLOCK_LINE]
    first = blocks[blocks["kind"] == lib.NCK_BLOCK_RAPID]["target_nm"][-1]
    places = ["XYZ".index(letter) for letter in AXES[plane]]
    found = (cuts["target_nm"] - first)[:, places] / 1e6
    assert len(found) == len(ends) > 0
    assert found == pytest.approx(np.array(ends), abs=2e-5)


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ("G1 X5. Y5. ,A30.", ("word-shared", 3, 13)),
        ("G1 ,A30.", ("corner", 3, 5)),
        ("G1 ,A30.\nX9. Y9.", ("corner", 3, 5)),
        ("G1 ,A30.\nX9. Y9. ,A30.5", ("corner", 3, 5)),
        ("G1 ,A30.\nX9. Y9. ,A210.5", ("corner", 3, 5)),
        ("G1 ,A30.\nX-9999. Y9. ,A31.1", ("travel", 4, 1)),
        ("G1 ,A30.\nX199. Y-9. ,A35.", ("travel", 4, 1)),
        ("G1 ,A30.\nX9. ,A90.", ("unsupported", 4, 6)),
        ("G1 ,A30.\n,A90.", ("unsupported", 4, 2)),
        ("G1 ,A30.\nG91 X9. Y9. ,A90.", ("incremental", 4, 14)),
        ("G1 ,A30.\nG0 X9. Y9. ,A90.", ("word-unused", 4, 13)),
        ("G1 ,A30.\nM8\nX9. Y9. ,A90.", ("corner", 3, 5)),
        ("G1 ,A30. ,R50.\nX9. Y9. ,A90.", ("corner", 3, 11)),
        ("G1 ,A30. ,R0.\nX9. Y9. ,A90.", ("number-range", 3, 11)),
        ("G0 X5. ,A30.", ("word-unused", 3, 9)),
        ("G1 X5. ,A90.", ("number-range", 3, 9)),
        ("G1 X5. ,A361.", ("number-range", 3, 9)),
        ("G1 X5. ,A1. ,A2.", ("word-twice", 3, 14)),
        ("G54 G1 X5. ,A1.", ("incremental", 3, 13)),
        ("G68 X0. Y0. R9.\nG1 X5. ,A1.", ("layout-on", 4, 9)),
        ("G1 X5. ,B1.", ("character", 3, 8)),
    ],
)
def test_what_says_no_end_is_refused_at_its_word(line, error):
    errors, _ = decoded(f"G21 G90 G17 G94 F900\nG0 X1. Y1.\n{line}\nM30\n", fanuc())
    assert errors == [error]


def test_a_line_along_its_axis_and_one_across_are_plain():
    lines = ["G1 X5. ,A0.", "Y9. ,A90.", "X2. ,A180. ,C1.", "Y3. ,A-90.", "M30\n"]
    text = "\n".join(["G21 G90 G17 G94 F900", "G0 X1. Y1.", *lines])
    errors, blocks = decoded(text, fanuc())
    assert errors == []
    cuts = blocks[blocks["kind"] == lib.NCK_BLOCK_LINE]["target_nm"][:, :2] / 1e6
    assert cuts.tolist() == [[5, 1], [5, 9], [3, 9], [2, 8], [2, 3]]


def _met(start, first, end, second):
    """Return where a line from a place at an angle meets one that leads to another place."""
    a, b = (np.array([math.cos(math.radians(t)), math.sin(math.radians(t))])
            for t in (first, second))  # fmt: skip
    along, _ = np.linalg.solve(np.array([a, b]).T, np.array(end) - start)
    return np.array(start) + along * a


def _rounded(start, corner, end, radius):
    """Return where the corner's piece begins and ends."""
    legs = np.array(start) - corner, np.array(end) - corner
    units = [leg / np.linalg.norm(leg) for leg in legs]
    half = math.acos(np.clip(units[0] @ units[1], -1, 1)) / 2
    off = radius / math.tan(half)
    return [corner + off * unit for unit in units], off, [np.linalg.norm(leg) for leg in legs]


@pytest.mark.sample(40)
@pytest.mark.parametrize("seed", range(2000))
def test_two_lines_that_angles_say_meet(seed, draw_seed):
    pen = random.Random(seed + draw_seed)
    plane = pen.choice((17, 18, 19))
    lines, at, ends = [f"G21 G90 G{plane} G94 F900", "G0 X0 Y0 Z0"], np.zeros(2), []
    for _ in range(5):
        first, second = (round(pen.uniform(-360, 360), 2) for _ in "ab")
        if abs(math.sin(math.radians(first - second))) < 0.1:
            continue
        end = np.array([round(pen.uniform(-50, 50), 3) for _ in "ab"])
        corner, radius = _met(at, first, end, second), 0.0
        if np.abs(corner).max() > 5000 or min(np.linalg.norm(corner - at),
                                              np.linalg.norm(corner - end)) < 0.5:  # fmt: skip
            continue
        pieces, off, legs = _rounded(at, corner, end, 0.2)
        if off < 0.9 * min(legs) and pen.random() < 0.5:
            radius = 0.2
        ends += [*(pieces if radius else [corner]), end]
        lines.append(f"G1 ,A{first:.2f}" + " ,R0.2" * bool(radius))
        word = " ".join(f"{a}{b:.3f}" for a, b in zip(AXES[plane], end, strict=True))
        lines.append(f"{word} ,A{second:.2f}")
        at = end
    free = [f"axis.{a}.{end}_mm=free" for a in "xyz" for end in ("min", "max")]
    errors, blocks = decoded("\n".join([*lines, "M30\n"]), fanuc(*free))
    assert errors == []
    first = blocks[blocks["kind"] == lib.NCK_BLOCK_RAPID]["target_nm"][-1]
    cuts = blocks[np.isin(blocks["kind"], (lib.NCK_BLOCK_LINE, lib.NCK_BLOCK_ARC))]
    places = ["XYZ".index(letter) for letter in AXES[plane]]
    found = (cuts["target_nm"] - first)[:, places] / 1e6
    assert len(found) == len(ends)
    if ends:
        assert found == pytest.approx(np.array(ends), abs=1e-4)


@pytest.mark.parametrize("word", [",A", "A"])
def test_a_lathe_says_an_angle_with_a_comma_or_without(word):
    text = f"G21 G18 G98\nG0 X20. Z0.\nG1 Z-10. {word}135. F90.\nM30\n"
    program = pycnc.load(text, Machine.load("lathe_fanuc"))
    assert program.diagnostics.errors == 0
    start, end = program.blocks["target_nm"][:2, 0] / 1e6
    assert end - start == pytest.approx(10, abs=1e-5)


def test_a_lathe_s_lines_meet_where_the_drawing_has_them():
    lines = ["G21 G18 G98", "G0 X20. Z5.", "G1 ,A180. F90.", "X40. Z-30. ,A135. ,R2.", "Z-50.",
             "W-10. ,A170.", "G0 X60.", "M30\n"]  # fmt: skip
    program = pycnc.load("\n".join(lines), Machine.load("lathe_fanuc", set={"work.zero": "told"}))
    assert [each.id for each in program.diagnostics if each.severity == "error"] == []
    lines = program.blocks["line"]
    ends = program.blocks["target_nm"] - program.blocks["target_nm"][lines == 2][-1]
    x, z = ends[:, 0] / 1e6 + 10, ends[:, 2] / 1e6 + 5
    assert (x[lines == 3][0], z[lines == 3][0]) == pytest.approx((10, -20), abs=1e-5)
    assert (x[lines == 6][0], z[lines == 6][0]) == pytest.approx(
        (20 + 10 * math.tan(math.radians(10)), -60), abs=1e-5)  # fmt: skip
