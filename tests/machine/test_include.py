# SPDX-License-Identifier: MIT
"""Files that a configuration of another control includes, and cannot."""

import random

import pytest
from command_line import pycnc

KLIPPER = "[printer]\nkinematics: cartesian\nmax_velocity: 100\nmax_accel: 1000\n"


@pytest.mark.parametrize(
    ("files", "words"),
    [
        ({"a.cfg": "[include b.cfg]\n", "b.cfg": "[include a.cfg]\n"}, "a.cfg: includes itself"),
        ({"a.cfg": f"[include no.cfg]\n{KLIPPER}"}, "line 1: [include no.cfg]: no.cfg: No such"),
        ({"a.cfg": f"[include /dev/zero]\n{KLIPPER}"}, "no file"),
    ],
)
def test_what_cannot_be_included_is_refused(files, words, tmp_path):
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    result = pycnc("machine", "import", tmp_path / "a.cfg")
    assert (result.code, result.out) == (2, "")
    assert words in result.err
    assert len(result.err.splitlines()) == 1


@pytest.mark.parametrize("name", ["mainsail.cfg", "fluidd.cfg", "../timelapse.cfg"])
def test_macros_of_a_page_may_be_elsewhere(name, tmp_path):
    (tmp_path / "a.cfg").write_text(f"[include {name}]\n{KLIPPER}[stepper_x]\nposition_max: 9\n")
    result = pycnc("machine", "import", tmp_path / "a.cfg")
    assert result.code == 0
    assert f"line 1: [include {name}] (No such file or directory: not read)" in result.out


@pytest.mark.sample(12)
@pytest.mark.parametrize("number", range(60))
def test_an_include_that_comes_back_is_told_in_one_line(number, draw_seed, tmp_path):
    """Files that include each other in a ring, by name or by a pattern that has the file itself."""
    pen = random.Random(draw_seed + number)
    names = [f"{letter}.cfg" for letter in "abcdef"[: pen.randrange(1, 7)]]
    for name, after in zip(names, [*names[1:], names[0]], strict=True):
        words = pen.choice([f"[include {after}]", "[include *.cfg]", f"[include ./{after}]"])
        (tmp_path / name).write_text(f"{words}\n" * pen.randrange(1, 4) + KLIPPER)
    result = pycnc("machine", "import", tmp_path / "a.cfg")
    assert (result.code, result.out) == (2, "")
    assert len(result.err.splitlines()) == 1 and "includes itself" in result.err
