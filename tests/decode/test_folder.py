# SPDX-License-Identifier: MIT
"""Subprograms in files of a folder: the same as in one text, and findings by their own file."""

import random

import command_line
import numpy as np
import pytest

import pycnc
from pycnc.machine import Machine

HEAD = "G21 G90 G94 F300.\nG0 X0. Y0.\n"


def mill(folder, base):
    return Machine.load("mill3", set=[f"dialect.base={base}", f"dialect.programs={folder}"])


def fanuc(rng):
    """Return (main program, {number: subprogram}), which call each other."""
    numbers = rng.sample(range(1, 9999), 4)
    subs = {}
    for place, number in enumerate(numbers):
        calls = [f"M98 P{other}" for other in numbers[place + 1 :] if rng.random() < 0.4]
        lines = [f"G91 G1 X{rng.randint(1, 9)}. Y#1", *calls, "G90", "M99"]
        subs[number] = "\n".join([f"O{number:04}", *lines, ""])
    calls = [rng.choice((f"M98 P{n}", f"G65 P{n} A2.", f"M98 P{n} L2", f"M98 P3{n:04}"))
             for n in rng.choices(numbers, k=5)]  # fmt: skip
    return HEAD + "#1=1.\n" + "\n".join(calls) + "\nM30\n", subs


def names(rng, number):
    return rng.choice((f"O{number:04}.nc", f"{number}.NC", f"o{number}.tap", f"{number:04}"))


def same(one, other):
    fields = ["kind", "target_nm", "feed"]
    assert (one.diagnostics.errors, other.diagnostics.errors) == (0, 0)
    np.testing.assert_array_equal(one.blocks[fields], other.blocks[fields])
    assert one.block_count > 3


@pytest.mark.parametrize("seed", range(30))
def test_programs_of_a_folder_are_the_same_as_behind_the_text(seed, tmp_path):
    rng = random.Random(seed)
    main, subs = fanuc(rng)
    held = [number for number in subs if rng.random() < 0.3]
    for number, text in subs.items():
        tape = rng.random() < 0.5
        bare = text.partition("\n")[2] if rng.random() < 0.3 else text
        if number not in held:
            (tmp_path / names(rng, number)).write_text(f"%\n{bare}%\n" if tape else bare)
    (tmp_path / "O9998.txt").write_text("no program at all\n")
    here = main + "".join(subs[number] for number in held)
    one = pycnc.load(here, mill(tmp_path, "fanuc"))
    same(one, pycnc.load(main + "".join(subs.values()), mill("", "fanuc")))
    same(pycnc.Program(one.text, one.machine), one)


@pytest.mark.parametrize("end", ["M2\n", "M30", ""])
def test_a_named_subprogram_is_found_by_its_name(end, tmp_path):
    sub = "o<hole> sub\nG1 X#1\no<hole> endsub\n"
    (tmp_path / "hole.ngc").write_text(sub)
    (tmp_path / "77.ngc").write_text("o77 sub\nG1 Y#1\no<hole> call [9]\no77 endsub\n")
    main = "G21 G90 F100\no<HOLE> call [3]\n(o<other> call)\no77 call [4]\n" + end
    inner = "o77 sub\nG1 Y#1\no<hole> call [9]\no77 endsub\n"
    whole = main.replace("G21", sub + inner + "G21")
    same(pycnc.load(main, mill(tmp_path, "linuxcnc")), pycnc.load(whole, mill("", "linuxcnc")))


def test_a_mistake_is_told_by_its_own_file_and_line(tmp_path):
    file = tmp_path / "O5000 (a).nc"
    file.write_text("x")
    other = tmp_path / "O6000.nc"
    other.write_text("%\nO6000\nG1 X1.\nG777\nM99\n%\n")
    found = pycnc.load(HEAD + "M98 P6000\nM30\n", mill(tmp_path, "fanuc")).diagnostics
    (error,) = [each for each in found if each.severity == "error"]
    assert (error.file, error.line, error.id, error.source) == (str(other), 4, "g-unknown", b"G777")
    called = [each for each in found if each.id == "called-from"]
    assert [(each.file, each.line) for each in called] == [("<text>", 3)]


def test_a_folder_that_is_none_and_a_name_in_two_files_are_errors(tmp_path):
    text = HEAD + "M98 P6000\nM30\n"
    found = pycnc.load(text, mill(tmp_path / "none", "fanuc")).diagnostics
    assert [each.id for each in found if each.severity == "error"] == ["programs", "label-missing"]
    for name in ("O6000.nc", "6000.ngc"):
        (tmp_path / name).write_text("O6000\nM99\n")
    found = pycnc.load(text, mill(tmp_path, "fanuc")).diagnostics
    assert "6000 is in two files" in found.shown[0].message


VERBS = ("check", "time", "why", "run", "report", "look", "plot", "sweep", "compare")


@pytest.mark.parametrize("verb", VERBS)
def test_every_verb_that_reads_a_program_takes_what_its_remedies_say(verb, tmp_path):
    """--programs, and --zero."""
    (tmp_path / "O9000.nc").write_text("G91 G1 X5. F600.\nG90\nM99\n")
    part = tmp_path / "part.nc"
    part.write_text("O1\nG21 G90 G0 X1.\nM98 P9000\nM30\n")
    suffix = {"report": ".html", "look": ".html", "plot": ".png"}.get(verb)
    more = ["-o", tmp_path / f"x{suffix}"] if suffix else []
    more += {"sweep": ["--set", "axis.x.v_max_mm_s=50,60"], "compare": [part]}.get(verb, [])
    told = command_line.pycnc(verb, part, *more, "-m", "haas_vf2", "--programs", tmp_path,
                              "--zero=-300,-200,-100")  # fmt: skip
    assert told.code == 0, told.err
    assert "work-zero" not in told.out + told.err and "label-missing" not in told.err
