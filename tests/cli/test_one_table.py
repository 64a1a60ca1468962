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


PARTS = ("cut", "rapid", "dwells and waits", "tool changes", "spindle starts", "speeding up",
         "steady", "braking")  # fmt: skip
TIME = r"(?:\d+ (?:h|min) )?[\d.]+ (?:s|min)"
TOOLS = "--set", "times.tool_change_s=8", "--set", "times.spindle_start_s=1.5"


def parts_of(shown):
    """Return part → its time, as one of `PARTS` is told somewhere."""
    found = {words: re.search(rf"\b{words} +({TIME})", shown) for words in PARTS}
    return {words: match[1] for words, match in found.items() if match}


def seconds(words):
    """Return a time in words as a number."""
    units = {"h": 3600, "min": 60, "s": 1}
    return sum(float(n) * units[unit] for n, unit in re.findall(r"([\d.]+) (h|min|s)", words))


@pytest.mark.sample(4, quick=1)
@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("family", ["lines", "smooth", "arcs", "stops"])
def test_all_verbs_tell_one_time_in_one_vocabulary(family, seed, tmp_path):
    file = part(tmp_path, family, seed)
    file.write_text(file.read_text().replace("M2\n", "T2 M6\nM3 S900\nM2\n", 1))
    shown = {verb: pycnc(verb, file, *TOOLS).out
             for verb in ("time", "why", "run", "look", "report")}  # fmt: skip
    heads = {re.match(r".*, slope \w+: [^(\n]*[^(\n ]", shown[verb])[0]
             for verb in ("time", "why", "run", "look")}  # fmt: skip
    assert len(heads) == 1
    (whole,) = {seconds(each.rpartition(":")[2]) for each in heads}
    told = parts_of(shown["time"])
    assert told == parts_of(shown["run"]) == parts_of(shown["look"].splitlines()[0])
    assert {"tool changes", "spindle starts"} <= set(told)
    (sums,) = {re.search(r"  (ideal time .*)", shown[verb])[1] for verb in ("why", "look")}
    in_run = re.search("What holds it back: (ideal time .*)", shown["run"])[1]
    assert in_run.split(" · ") == [sums.split(" · ")[0], sums.split(" · ")[-1]]
    assert sum(seconds(each) for each in sums.split("·")) == pytest.approx(whole, rel=1e-3)
    assert table(shown["look"]) == table(shown["why"])


def test_what_there_is_none_of_is_not_told(tmp_path):
    file = tmp_path / "part.ngc"
    file.write_text("G21 G90 G1 X10 F600\nM2\n")
    for verb in ("time", "run"):
        shown = pycnc(verb, file).out
        assert "speeding up" in shown
        for words in ("  rapid ", "waits 0", "rapid 0", "0.000 s", "accelerate"):
            assert words not in shown


@pytest.mark.parametrize("verb", ["time", "run", "why", "look"])
def test_results_name_the_schema_that_they_keep_to(verb, tmp_path):
    file = tmp_path / "part.ngc"
    for text, code in (("G21 G90 G1 X10 F600\nM2\n", 0), ("G21 G90 G1 X10\nM2\n", 1)):
        file.write_text(text)
        result = pycnc(verb, file, "--json")
        assert (result.code, json.loads(result.out)["schema_version"]) == (code, SCHEMA)
