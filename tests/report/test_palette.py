# SPDX-License-Identifier: MIT
"""The colours of pages and pictures: who sees no green tells them apart; fast is one colour."""

import itertools
import re
from pathlib import Path

import numpy as np
import pytest

from pycnc.report import plot

ROOT = Path(__file__).resolve().parents[2]
LEAST = 15.0  # difference by CIE 1976, of what must not be taken for another
PALETTE = plot.palette()
# What deuteranopes see, in linear sRGB: Machado, Oliveira and Fernandes 2009, severity 1.
DEUTERANOPIA = np.array([[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413],
                         [-0.011820, 0.042940, 0.968881]])  # fmt: skip
TO_XYZ = np.array([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750],
                   [0.0193339, 0.1191920, 0.9503041]])  # fmt: skip


def linear(hexes):
    """Return colours in linear sRGB."""
    levels = np.array([[int(each[k : k + 2], 16) for k in (1, 3, 5)] for each in hexes]) / 255
    return np.where(levels <= 0.04045, levels / 12.92, ((levels + 0.055) / 1.055) ** 2.4)


def lab(colours):
    """Return L*, a* and b* of colours in linear sRGB, under D65."""
    parts = colours @ TO_XYZ.T / TO_XYZ.sum(axis=1)
    f = np.where(parts > 216 / 24389, np.cbrt(parts), (24389 / 27 * parts + 16) / 116)
    return np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], -1)


def seen(hexes):
    return lab(np.clip(linear(hexes) @ DEUTERANOPIA.T, 0, 1))


def too_near(colours):
    """Return pairs of names whose colours deuteranopes, or anybody, cannot tell apart."""
    found = []
    for view in (seen(colours.values()), lab(linear(colours.values()))):
        for (one, a), (other, b) in itertools.combinations(zip(colours, view, strict=True), 2):
            if np.linalg.norm(a - b) < LEAST:
                found.append((one, other, round(float(np.linalg.norm(a - b)), 1)))
    return found


def test_the_differences_are_those_of_the_definition():
    white, black = lab(linear(["#ffffff", "#000000"]))
    assert white == pytest.approx([100, 0, 0], abs=0.02)
    assert black == pytest.approx([0, 0, 0], abs=0.02)
    red, green = seen(["#c81e1e", "#5a6e00"])
    plain = np.linalg.norm(np.subtract(*lab(linear(["#c81e1e", "#5a6e00"]))))
    assert np.linalg.norm(red - green) < 0.4 * plain  # these two are near for a deuteranope


def test_causes_are_told_apart():
    changes = {f"change of {name}": colour for name, colour in PALETTE["changes"].items()}
    causes = {**PALETTE["limits"], **PALETTE["axes"], **changes}
    assert len(causes) == 27
    assert too_near(causes) == []


@pytest.mark.parametrize("name", ["speed", "near", "tools"])
def test_stops_of_a_scale_and_tools_are_told_apart(name):
    colours = {f"{k}": colour for k, colour in enumerate(PALETTE[name])}
    if name == "tools":
        colours["rapid"] = PALETTE["limits"]["rapid"]
    assert too_near(colours) == []


def test_fast_and_slow_are_one_colour_each_in_pictures_and_pages():
    from matplotlib.colors import to_hex

    colours = plot._colours()
    assert [to_hex(colours(end)) for end in (0.0, 1.0)] == [PALETTE["speed"][k] for k in (0, -1)]
    source = (ROOT / "page/src/colours.js").read_text(encoding="utf-8")
    assert re.findall(r"SPEED = (.*);", source) == ["palette.speed"]
    assert re.findall(r"slowness: scale\([^,]*, (\w+)", source) == ["SPEED"]
    assert re.findall(r" speed: scale\([^,]*, (\w+)", source) == ["SPEED"]


def test_no_room_of_the_page_has_a_palette_of_its_own():
    for path in (ROOT / "page/src").glob("*.js"):
        listed = re.findall(r'\["#[0-9a-f]{6}", *"#[0-9a-f]{6}"', path.read_text(encoding="utf-8"))
        assert listed == [], path.name
