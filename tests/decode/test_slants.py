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
        ("G1 ,A30.", ("unsupported", 3, 5)),
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
