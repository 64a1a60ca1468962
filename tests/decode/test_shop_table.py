# SPDX-License-Identifier: MIT
"""Room 1: the table of what shops write does as it says, row by row."""

import re
from pathlib import Path

import pytest

from pycnc import stages
from pycnc.kernel.bind import diagnostic_id, status_id
from pycnc.machine import Machine

PAGE = Path(__file__).resolve().parents[2] / "docs" / "shops.md"
SETS = {
    "Mills": ("mill3", [
        "dialect.base=fanuc", "dialect.probe=touches", "dialect.d_offset=radius",
        "dialect.scale_unit=1", "home.g30.z_mm=0", "tool.1.radius_mm=2", "tool.2.radius_mm=2",
        *(f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")),
    ]),
    "Lathes": ("cak6150n", []),
}  # fmt: skip
HEADS = {"Mills": "G21 G90 G94 G17 G54\nS900 M3\nG0 X0. Y0. Z20.\n",
         "Lathes": "G21 G18 G99\nS500 M3\nG0 X40. Z2.\n"}  # fmt: skip


def rows():
    """Return (chapter, feature, lines, what becomes of them)."""
    found, chapter = [], ""
    for line in PAGE.read_text(encoding="utf-8").splitlines():
        chapter = line[3:] if line.startswith("## ") else chapter
        if match := re.fullmatch(r"\| ([^|]+) \| `(.+)` \| (.+) \|", line):
            found.append((chapter, *match.groups()))
    return found


def test_the_page_has_57_features_and_counts_what_is_read():
    read = sum(here.startswith("read") for *_, here in rows())
    assert len(rows()) == len({feature for _, feature, *_ in rows()}) == 57
    assert f"{read} of 57 are read" in PAGE.read_text(encoding="utf-8")


@pytest.mark.parametrize(("chapter", "feature", "lines", "here"), rows())
def test_a_feature_is_read_or_refused_as_the_page_says(chapter, feature, lines, here):
    name, changes = SETS[chapter]
    text = f"{HEADS[chapter]}{lines.replace(' ⏎ ', chr(10))}\nM30\n"
    blocks, found = stages.decode(text.encode(), Machine.load(name, set=changes))
    errors = [status_id(int(each["code"])) for each in found if each["code"] < 0]
    notes = [diagnostic_id(int(each["code"])) for each in found if each["code"] > 0]
    ids = re.findall(r"`(.+?)`", here)
    assert errors[:1] == (ids if not here.startswith("read") else []), feature
    assert notes[:1] == ids or errors, feature
    assert len(blocks) > 3 or errors, feature
