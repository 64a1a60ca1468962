# SPDX-License-Identifier: MIT
"""Room 1: the first random programs of the families that only the long run has, against rs274."""

import re

import against_rs274
import pytest

ELSEWHERE = {"modes", "cycles", "macros", "zeros", "states"}  # test_decode.py and its kin
FIRST, COUNT = 1, 10


@pytest.mark.sample(quick=2)
@pytest.mark.parametrize("name", sorted(against_rs274.FAMILIES.keys() - ELSEWHERE))
def test_random_programs_equal_rs274(name, tool, tmp_path):
    tool("rs274")
    moves = 0
    for seed in range(FIRST, FIRST + COUNT):
        equal, words = against_rs274.compare(name, seed, tmp_path)
        assert words == "", f"seed {seed}"
        moves += equal
    assert moves > 5 * COUNT


WORDS = {
    "turning": r"G74|G75|G90\b|G94\b|G92\b|G32\b|G50\b|G99\b|U-?\d|W-?\d|R-?\d",
    "fanuc": r"GOTO|THEN|WHILE|END|G65|M98|M99|AND|XOR",
    "layouts": r"G51\.1|G51\b|G68\b|G16\b|G15\b",
    "lathe": r"G33\b|G33\.1|G76|G96|G95|G7\b|G20",
    "taps": r"G84|G74|G33\.1|G98|G99|G91",
    "contours": r"G41\b|G42\b|G41\.1|G42\.1|G18",
}


@pytest.mark.parametrize("name", WORDS)
def test_random_programs_reach_every_word(name):
    texts = [against_rs274.FAMILIES[name].write(seed) for seed in range(40)]
    ours = b"\n".join(text[0] if isinstance(text, tuple) else text for text in texts).decode()
    kinds = [word.replace("\\b", r"(?![\d.])") for word in WORDS[name].split("|")]
    assert [word for word in kinds if not re.search(word, ours)] == []


def test_the_table_of_the_page_has_every_family(root):
    page = (root / "docs" / "words.md").read_text(encoding="utf-8")
    told = re.findall(r"^\| [^|]*\(`(\w+)`\) \|", page, re.M)
    assert told == list(against_rs274.FAMILIES)
