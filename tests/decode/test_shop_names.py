# SPDX-License-Identifier: MIT
"""Room 1: names of programs as shops write them, what is put out, and words that say nothing."""

import random

import pytest

import pycnc
from pycnc.kernel.bind import lib
from pycnc.machine import Machine


@pytest.fixture(scope="module")
def mill():
    ends = {f"axis.{axis}.{end}_mm": "free" for axis in "xyz" for end in ("min", "max")}
    return Machine.load("mill3", dialect="fanuc", set=ends | {"dialect.integers": "units"})


def moves(text, machine):
    """Return (ids of errors, x of all moves [mm])."""
    program = pycnc.load(text, machine)
    kinds = (lib.NCK_BLOCK_LINE, lib.NCK_BLOCK_RAPID)
    blocks = program.blocks[[kind in kinds for kind in program.blocks["kind"]]]
    errors = [each.id for each in program.diagnostics if each.severity == "error"]
    return errors, (blocks["target_nm"][:, 0] / 1e6).round(6).tolist()


@pytest.mark.sample(40)
@pytest.mark.parametrize("number", range(600))
def test_p_is_a_name_where_there_is_one_else_a_count_and_a_name(number, mill, draw_seed):
    pen = random.Random(draw_seed + number)
    names = pen.sample([7, 1235, 9010, 31235, 51235, 90100, 20007], pen.randrange(1, 6))
    lines, expected, wrong, at = ["G21 G90 G94 F900", "G0 X0"], [0.0], False, 0
    for _ in range(pen.randrange(1, 9)):
        called = pen.choice([7, 1235, 9010, 31235, 51235, 90100, 20007, 61235])
        how_often = pen.choice(["", "", " L2"])
        lines.append(f"M98 P{called:0{pen.choice((1, 8))}d}{how_often}")
        name, count = (called, 1) if called in names else (called % 10000, called // 10000)
        if name not in names:
            wrong = True
            break
        for _ in range(max(count, 1) * (2 if how_often else 1)):
            at += names.index(name) + 1
            expected.append(float(at))
    lines.append("M30")
    for k in pen.sample(range(len(names)), len(names)):
        lines += [f"O{names[k]:04d}", f"G91 G1 X{k + 1}.", "G90", "M99"]
    errors, found = moves("\n".join([*lines, ""]), mill)
    assert errors == ["label-missing"] * wrong
    assert found == expected


@pytest.mark.parametrize("seed", range(20))
def test_a_file_of_five_digits_is_called_by_them(seed, mill, tmp_path):
    pen = random.Random(seed)
    whole, short = pen.randrange(10_001, 99_999), 0
    short = whole % 10_000
    has = pen.choice([{whole}, {short}, {whole, short}])
    for name in has:
        (tmp_path / f"O{name:04d}.nc").write_text(f"G91 G1 X{1 if name == whole else 2}.\nM99\n")
    machine = Machine.load(mill, set={"dialect.programs": str(tmp_path)})
    errors, found = moves(f"G21 G90 F900\nG0 X0\nM98 P{whole}\nM30\n", machine)
    assert errors == []
    assert found == ([0.0, 1.0] if whole in has
                     else [0.0] + [2.0 * k for k in range(1, whole // 10_000 + 1)])  # fmt: skip


@pytest.mark.parametrize("seed", range(40))
def test_what_is_put_out_moves_nothing_and_is_told(seed, mill):
    pen = random.Random(seed)
    lines, told = ["%", pen.choice(["<PART-1>", "O<NAME>", "O12", "<A B>(X1)"]), "G21 G90 F900"], []
    for k in range(pen.randrange(1, 9)):
        word = pen.choice(["DPRNT[X#5041[44]*Y#101[53]]", "BPRNT[C*X#100[3]]", "POPEN", "PCLOS",
                           "dprnt[G0 X99.]"])  # fmt: skip
        lines += [f"{pen.choice(['', 'N7 ', ' '])}{word}", f"G1 X{k + 1}."]
        told += [len(lines) - 1] * ("[" in word)
    program = pycnc.load("\n".join([*lines, "M30", "%", ""]), mill)
    assert program.diagnostics.errors == 0
    assert [each.line for each in program.diagnostics if each.id == "remark"] == told[:10]
    plain = "\n".join(line for line in lines if "PRNT" not in line.upper() and "P" not in line[2:])
    assert moves("\n".join([*lines, "M30", ""]), mill)[1] == moves(f"{plain}\nM30\n", mill)[1]


@pytest.mark.parametrize(("text", "machine", "error"), [
    ("G0 <A>\n", "fanuc", "character"), ("<A\n", "fanuc", "character"),
    ("<A>\nG0 X1\n", "linuxcnc", "character"), ("POPEN\n", "linuxcnc", "expression"),
    ("F9 G2 X1 I.5 K0.\n", "fanuc", None), ("F9 G2 X1 I.5 K.1\n", "fanuc", "word-unused"),
    ("F9 G2 X1 I.5 K0.\n", "linuxcnc", "word-unused"),
    ("F9 G18 G2 X1 I.5 J0 K0\n", "fanuc", None),
])  # fmt: skip
def test_a_word_that_says_nothing_is_none_of_fanucs_mistakes(text, machine, error):
    program = pycnc.load(f"G21 G90\nG0 X0\n{text}M2\n", Machine.load("mill3", dialect=machine))
    found = [each.id for each in program.diagnostics if each.severity == "error"]
    assert found == ([error] if error else [])
