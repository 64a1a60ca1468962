# SPDX-License-Identifier: MIT
"""Configurations of RepRapFirmware, which are programs: what cannot be known is refused."""

import random
import re

import configurations
import pytest

from pycnc.machine import importer, source


@pytest.mark.sample(30)
@pytest.mark.parametrize("number", range(300))
def test_what_a_condition_or_an_expression_decides_is_refused_by_its_line(number, draw_seed):
    pen = random.Random(draw_seed + number)
    case = configurations.reprap(draw_seed + number)
    (data,) = case.files.values()
    rows = source.decode(data).split("\n")
    if not (numbers := [k for k, row in enumerate(rows) if row.startswith(("M566", "M201"))]):
        return
    k = pen.choice(numbers)
    if pen.random() < 0.5:
        rows[k] = re.sub(r"([XYZ])\d[\d.:]*", r"\1{var.a}", rows[k], count=1)
    else:
        rows[k : k + 1] = [pen.choice(["if var.a", "while iterations < 3"]), f"  {rows[k]}"]
        k += 1
    draft = importer.read("\n".join(rows), "config.g")
    (place, words), = draft.problems
    assert place == f"line {k + 1}"
    assert "in numbers" in words
