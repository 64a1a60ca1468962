# SPDX-License-Identifier: MIT
"""What a line costs in instructions: room by room as the page says, and no dearer for macros."""

import re
import subprocess

import pytest

from pycnc.bench import cost

pytestmark = pytest.mark.thorough

COMPILER = "12.2.0"  # what the numbers here and on the page were counted with, -O2 on x86-64
INSTRUCTIONS = {"line": 694, "modal": 570, "arc": 3183, "macro": 6955}  # of decoding a line
BEFORE_MACROS = {"line": 1917, "modal": 1416, "arc": 3185}
WITHIN, MOST = 0.05, 1.03  # 2 % for macros, 1 % for whose a code is


@pytest.fixture(scope="module")
def folder(tool, tmp_path_factory):
    """Return a folder to build in, where instructions can be counted and compared."""
    tool("valgrind")
    version = subprocess.run([tool("gcc"), "-dumpfullversion"], capture_output=True, text=True)
    if version.stdout.strip() != COMPILER:
        pytest.skip(f"instructions were counted with gcc {COMPILER}")
    return tmp_path_factory.mktemp("cost")


@pytest.mark.parametrize("kind", INSTRUCTIONS)
def test_a_plain_line_costs_what_the_table_says(kind, folder):
    now = cost.count_line(folder, kind)
    assert now == pytest.approx(INSTRUCTIONS[kind], rel=WITHIN)


@pytest.mark.parametrize("kind", BEFORE_MACROS)
def test_macros_have_made_no_plain_line_dearer(kind, folder):
    assert cost.count_line(folder, kind) <= MOST * BEFORE_MACROS[kind]


def test_a_line_costs_what_the_page_says_from_text_to_cells(folder, root):
    page = (root / "docs" / "size.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (.+?) \| ([\d.,]+) \| ([\d.,]+) \| ([\d.,]+) \|$", page, re.M)
    told = {name: tuple(float(x.replace(",", "")) for x in numbers) for name, *numbers in rows}
    for name, now in cost.figures(folder).items():
        start, written, target = told[name]
        assert (start, target) == pytest.approx(cost.GOALS[name])
        assert now == pytest.approx(written, rel=WITHIN), name
