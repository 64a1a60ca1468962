# SPDX-License-Identifier: MIT
"""A program alone, and results that go next to their program."""

import json

import pytest
from command_line import pycnc

GOOD = b"G21 G90 G17 G64 P0.01\nG1 X10 F600\nG1 X10 Y10\nG1 X0 Y0\nM2\n"


@pytest.fixture
def good(tmp_path):
    file = tmp_path / "good.nc"
    file.write_bytes(GOOD)
    return file


@pytest.fixture
def wrong(tmp_path):
    file = tmp_path / "wrong.nc"
    file.write_bytes(GOOD.replace(b"M2", b"G2 X5 I1 J1\nM2"))
    return file


@pytest.mark.parametrize("words", [(), ("look",), ("-m", "mill4")])
def test_a_program_alone_is_checked_timed_and_shown(words, good):
    verb, options = (words, ()) if words[:1] == ("look",) else ((), words)
    page = good.with_suffix(".html")
    result = pycnc(*verb, good, *options)
    assert (result.code, result.err) == (0, "")
    first, second, *_, last = result.out.splitlines()
    assert first.startswith(f"{good} on {'mill4' if options else 'mill3'}, slope optimal: ")
    assert second.startswith("  ideal time ")
    assert last == str(page)
    assert page.read_text(encoding="utf-8").startswith("<!doctype html>")
    told = json.loads(pycnc(*verb, good, *options, "--json").out)
    assert told == {**json.loads(pycnc("why", good, *options, "--json").out), "report": str(page)}


def test_a_program_alone_that_is_wrong_or_missing_has_no_page(wrong, tmp_path):
    result = pycnc(wrong)
    assert (result.code, result.out) == (1, "")
    assert "error[arc-radius]" in result.err
    assert not wrong.with_suffix(".html").exists()
    for missing in ("part.ngc", tmp_path / "part"):
        result = pycnc(missing)
        assert (result.code, result.out) == (2, "")
        assert result.err.startswith(f"{missing}: error[file]: ")


def test_a_verb_goes_before_a_file_of_its_name(good, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("time", "part"):
        (tmp_path / name).write_bytes(good.read_bytes())
    assert pycnc("time", "time").out.startswith("time on mill3")
    assert pycnc("part").out.endswith("part.html\n")


@pytest.mark.thorough
@pytest.mark.parametrize(("verb", "ending"), [("report", ".html"), ("plot", ".png")])
def test_a_result_goes_next_to_the_program_and_never_over_it(verb, ending, good):
    beside = good.with_suffix(ending)
    assert pycnc(verb, good).out == f"{beside}\n"
    beside.write_bytes(GOOD)
    result = pycnc(verb, beside)
    assert (result.code, beside.read_bytes()) == (2, GOOD)
    assert result.err.startswith("--output: error[output]: ")
    result = pycnc(verb, "-", stdin=GOOD)
    assert (result.code, result.out) == (2, "")
    assert f"-o part{ending}" in result.err
