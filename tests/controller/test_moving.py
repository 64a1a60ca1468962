# SPDX-License-Identifier: MIT
"""The files of docs/moving.md compile for their processors, and are as short as it says."""

import re
import subprocess

import pytest

FOLDER = "firmware_sim/moving"
CORES = {
    "stm32f4": ["-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"],
    "rp2040": ["-mcpu=cortex-m0plus", "-mfloat-abi=soft"],
}
FLAGS = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Wundef",
         "-Wdouble-promotion", "-Werror", "-O2", "-mthumb", "-ffp-contract=off"]  # fmt: skip
LINES_MOST = 150


@pytest.mark.parametrize("part", CORES)
def test_a_part_compiles_with_what_is_common(part, root, tool, tmp_path):
    compiler = tool("arm-none-eabi-gcc")
    for name in (part, "moving"):
        command = [compiler, *FLAGS, *CORES[part]]
        command += [f"-I{root / 'csrc'}", f"-I{root / 'firmware_sim'}"]
        command += ["-c", root / FOLDER / f"{name}.c", "-o", tmp_path / f"{name}.o"]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
    needed = subprocess.run(["arm-none-eabi-nm", "-u", tmp_path / "moving.o"], capture_output=True,
                            text=True).stdout  # fmt: skip
    given = subprocess.run(["arm-none-eabi-nm", tmp_path / f"{part}.o"], capture_output=True,
                           text=True).stdout  # fmt: skip
    wanted = set(re.findall(r"U (part_\w+)", needed))
    assert len(wanted) == 5 and wanted <= set(re.findall(r"T (part_\w+)", given))


def test_the_page_tells_how_long_they_are(root):
    page = (root / "docs" / "moving.md").read_text(encoding="utf-8")
    told = dict(re.findall(r"^\| `(\w+)\.c` \| (\d+) \|", page, re.M))
    assert set(told) == {*CORES, "moving"}
    for name, lines in told.items():
        text = (root / FOLDER / f"{name}.c").read_text(encoding="utf-8")
        assert len(text.splitlines()) == int(lines) <= LINES_MOST
