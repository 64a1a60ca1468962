# SPDX-License-Identifier: MIT
"""What a line costs in instructions: room by room as the page says, and no dearer for macros."""

import re
import subprocess

import pytest
import targets

from pycnc.bench import cost

pytestmark = pytest.mark.thorough

COMPILER = "12.2.0"  # what the numbers here and on the page were counted with, -O2 on x86-64
INSTRUCTIONS = {"line": 694, "modal": 570, "arc": 3323, "macro": 6955}  # of decoding a line
BEFORE_MACROS = {"line": 1917, "modal": 1416, "arc": 3185}
WITHIN, MOST = 0.05, 1.05  # 2 % for macros, 1 % for whose a code is, 2 % for words of shops


@pytest.fixture(scope="module")
def folder(tool, root, tmp_path_factory):
    """Return a folder with the programs whose instructions can be counted and compared.

    Their kernel is that of tests/qemu in the module's capacities, which need not be compiled again;
    for what counts the calls of `draw_motion`, its file is.
    """
    tool("valgrind")
    version = subprocess.run([tool("gcc"), "-dumpfullversion"], capture_output=True, text=True)
    if version.stdout.strip() != COMPILER:
        pytest.skip(f"instructions were counted with gcc {COMPILER}")
    kernel = targets.build("host", "nck_host") / "libnck_host.a"
    folder = tmp_path_factory.mktemp("cost")
    for name, level, sources in (
        ("text_to_cells", "-O2", []), ("plain_lines", "-O2", []),
        ("text_to_cells", "-O0", [root / "csrc/nck/prep/5_slope/draw.c"]),
    ):  # fmt: skip
        program = [root / f"tests/c/{name}.c", *sources, kernel]
        cost.compile_c(program, folder / f"{name}{level}", level, cost.capacities())
    return folder


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
