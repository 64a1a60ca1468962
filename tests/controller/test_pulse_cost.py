# SPDX-License-Identifier: MIT
"""What pulses and drives cost on two cores, in instructions; docs/size.md has it."""

import re

import pytest

pytestmark = pytest.mark.thorough

SLACK = 0.05


@pytest.mark.parametrize("image", ["pulses", "drives"])
@pytest.mark.parametrize("core", ["m4f", "m7"])
def test_the_page_tells_what_they_cost(core, image, root, tool, tmp_path):
    tool("arm-none-eabi-gcc")
    tool("qemu-system-arm")
    import targets

    targets.build(core, image)
    program = targets.build(core) / f"{image}.elf"
    targets.emulate(core, program, counts=tmp_path / "counts", folder=tmp_path)
    found = {}
    for line in (tmp_path / "counts").read_text(encoding="utf-8").splitlines():
        name, runs, total, most = line.split()
        found[name] = int(most), int(total) / int(runs)
    page = (root / "docs" / "size.md").read_text(encoding="utf-8")
    table = page.partition(f"## What {image} cost")[2]
    row = re.search(rf"^\| {core} \|(.*)\|$", table, re.M)
    numbers = [*found["tick"], *found["prep"]]
    assert row, numbers
    for told, now in zip(row[1].split("|"), numbers, strict=True):
        assert float(told.replace(",", "")) == pytest.approx(now, rel=SLACK), numbers
