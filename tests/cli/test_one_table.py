# SPDX-License-Identifier: MIT
"""What takes time is told by one table and in one vocabulary, whichever verb tells it."""

import json
import re

import numpy as np
import pytest
from cases import FAMILIES
from command_line import pycnc

from pycnc.names import SCHEMA

REST = "G61.1 G1 X0 Y0 F900\nG4 P0.2\nM2\n"


def part(tmp_path, family, seed):
    make, count = FAMILIES[family]
    text = make(np.random.default_rng([seed, 7]), min(count, 60))
    assert "M2" in text
    file = tmp_path / "part.ngc"
    file.write_text(text.replace("M2\n", REST, 1))
    return file


def table(shown):
    """Return the rows of the causes, without the second places of a cause."""
    lines = shown.splitlines()
    begin = next(k for k, line in enumerate(lines) if line.endswith("worst at line"))
    rows = []
    for line in lines[begin + 1 :]:
        if not re.match(r" +(\d+ (h|min) )?[\d.]+ (s|min) +\d", line):
            if "of it" in line:
                continue
            break
        rows.append(line.split())
    return rows


@pytest.mark.sample(quick=2)
@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("family", ["lines", "smooth"])
@pytest.mark.parametrize("slope", ["jerk", "optimal", "linear"])
def test_a_run_tells_what_why_tells(family, slope, seed, tmp_path):
    file = part(tmp_path, family, seed)
    ran, why = table(pycnc("run", file, "--slope", slope).out), table(
        pycnc("why", file, "--slope", slope).out
    )
    assert 0 < len(ran) == min(len(why), 6)
    for left, right in zip(ran, why, strict=False):
        assert left[:5] == right[:5]


def test_what_there_is_none_of_is_not_told(tmp_path):
    file = tmp_path / "part.ngc"
    file.write_text("G21 G90 G1 X10 F600\nM2\n")
    for verb in ("time", "run"):
        shown = pycnc(verb, file).out
        assert "speeding up" in shown
        for words in ("  rapid ", "dwell 0", "rapid 0", "0.000 s", "accelerate"):
            assert words not in shown


@pytest.mark.parametrize("verb", ["time", "run", "why", "look"])
def test_results_name_the_schema_that_they_keep_to(verb, tmp_path):
    file = tmp_path / "part.ngc"
    for text, code in (("G21 G90 G1 X10 F600\nM2\n", 0), ("G21 G90 G1 X10\nM2\n", 1)):
        file.write_text(text)
        result = pycnc(verb, file, "--json")
        assert (result.code, json.loads(result.out)["schema_version"]) == (code, SCHEMA)
