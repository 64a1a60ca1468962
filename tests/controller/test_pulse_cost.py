# SPDX-License-Identifier: MIT
"""What pulses of three motors cost on two cores, in instructions; docs/size.md has it."""

import re

import pytest

pytestmark = pytest.mark.thorough

SLACK = 0.05


@pytest.mark.parametrize("core", ["m4f", "m7"])
def test_the_page_tells_what_a_pulse_costs(core, root, tool, tmp_path):
    tool("arm-none-eabi-gcc")
    tool("qemu-system-arm")
    import targets

    targets.build(core, "pulses")
    image = targets.build(core) / "pulses.elf"
    targets.emulate(core, image, counts=tmp_path / "counts", folder=tmp_path)
    found = {}
    for line in (tmp_path / "counts").read_text(encoding="utf-8").splitlines():
        name, runs, total, most = line.split()
        found[name] = int(most), int(total) / int(runs)
    page = (root / "docs" / "size.md").read_text(encoding="utf-8")
    row = re.search(rf"^\| {core} \|(.*)\|$", page, re.M)
    numbers = [*found["tick"], *found["prep"]]
    assert row, numbers
    for told, now in zip(row[1].split("|"), numbers, strict=True):
        assert float(told.replace(",", "")) == pytest.approx(now, rel=SLACK), numbers
