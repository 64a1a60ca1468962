# SPDX-License-Identifier: MIT
"""Room 1: RS274NGC's polar words @ and ^, and O words, against LinuxCNC's rs274."""

import random

import pytest
import rs274_oracle

from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

FREE = [f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
HEAD = "G21 G90 G17 G94 F300\n"


@pytest.fixture(scope="module")
def mill():
    return Machine.load("mill3", set=[*FREE, "work.g55.x_mm=7", "work.g55.y_mm=-3"])


def errors(text, machine):
    findings = stages.decode(text.encode(), machine)[1]
    return [(status_id(int(each["code"])), int(each["line"])) for each in findings
            if each["code"] < 0]  # fmt: skip


def word(rng):
    """Return @, ^ or both, sometimes as an expression."""
    radius, angle = round(rng.uniform(1, 40), 3), round(rng.uniform(-400, 400), 2)
    words = [f"@{rng.choice((f'{radius}', f'[{radius}+1]'))}",
             f"^{rng.choice((f'{angle}', f'[{angle}/2]'))}"]  # fmt: skip
    return " ".join(rng.sample(words, rng.choice((1, 2, 2))))


def program(seed):
    """Return a random program of polar moves; the zero is where it never stands."""
    rng = random.Random(seed)
    lines = ["G0 X5 Y3 Z9"]
    for _ in range(12):
        kind = rng.random()
        if kind < 0.15:
            lines.append(rng.choice(("G90", "G91", "G92 X11 Y-4", "G20", "G21")))
        elif kind < 0.3:
            lines.append(f"G90 G0 X{rng.randint(1, 9)} Y{rng.randint(1, 9)} Z9")
        elif kind < 0.55:
            count = f" L{rng.randint(1, 5)}" if rng.random() < 0.6 else ""
            depth = rng.choice(("G90 G99 G81 {} R2 Z-1", "G91 G98 G81 {} R-1 Z-2"))
            lines += [f"{depth.format(word(rng))}{count}", "G80 G90 G0 Z9"]
        else:
            mode = rng.choice(("", "G90 ", "G91 "))
            lines.append(f"{mode}{rng.choice(('G0', 'G1'))} {word(rng)}")
    return HEAD + "\n".join(lines) + "\nM2\n"


@pytest.mark.parametrize("seed", range(60))
def test_polar_words_lead_where_rs274_goes(seed, mill, tool, tmp_path):
    tool("rs274")
    text = program(seed)
    (tmp_path / "polar.ngc").write_text(text)
    theirs, complaint = rs274_oracle.run(tmp_path / "polar.ngc", tmp_path, {})
    blocks, findings = stages.decode(text.encode(), mill)
    assert (complaint, [each for each in findings if each["code"] < 0]) == ("", []), text
    for move in theirs:
        move.tolerance += 2e-4  # rs274 adds steps up in numbers of its own
    ours = rs274_oracle.from_blocks(blocks, lib.NCK_COUNTS_PER_DEG)
    equal, words = rs274_oracle.difference(ours, rs274_oracle.drill_upright(theirs))
    assert not words, text
    assert equal >= 0.5 * len(theirs)


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("G0 @5 X1", "word-shared"), ("G18 G0 @5", "incremental"), ("G0 G55 @5", "incremental"),
        ("G0 @5 @6", "word-twice"), ("G0 @", "expression"), ("G0 ^[1/0]", "value"),
        ("G91 G0 @5", "value"), ("G0 @9999999999", "number-range"),
        ("G0 @99999999", "number-range"),
        ("G28 @5", "incremental"),
    ],
)  # fmt: skip
def test_polar_words_that_lead_nowhere_are_refused(line, found, mill):
    assert errors(f"{HEAD}{line}\nM2\n", mill) == [(found, 2)]


def test_polar_words_are_linuxcncs(mill):
    fanuc = Machine.load(mill, dialect="fanuc")
    assert errors("G21 G90 G94\nG0 @5.\nM30\n", fanuc) == [("other-base", 2)]
    assert errors(f"{HEAD}G18\nG0 @5\nM2\n", mill) == [("unsupported", 3)]


SUBS = ("o{0} sub", "o{0}  s u b", "O{0}SUB")
ENDS = ("o{0} endsub", "o{0} end sub [{1}]", "o{0} endsub [{1}]")
RETURNS = ("o{0} return", "o{1} return [{2}]", "o{0} re turn [#1*2]")


@pytest.mark.parametrize("seed", range(40))
def test_subprograms_end_as_rs274_ends_them(seed, mill, tool, tmp_path):
    tool("rs274")
    rng = random.Random(seed)
    inner = rng.choice(RETURNS).format(100, 101, rng.randint(1, 9))
    end = rng.choice(ENDS).format(100, rng.randint(1, 9))
    condition = rng.choice(("o101 if [#1 GT 2]", "o101 i f [#1 GT 2]"))
    text = (f"{HEAD}{rng.choice(SUBS).format(100)}\n{condition}\nG0 X#1\n{inner}\n"
            f"o101 {rng.choice(('endif', 'end if'))}\nG0 Y#1\n{end}\n")  # fmt: skip
    for _ in range(4):
        text += f"o100 call [{rng.randint(-5, 9)}]\nG1 Z[#<_value>+#<_value_returned>]\n"
    text += "M2\n"
    (tmp_path / "subs.ngc").write_text(text)
    theirs, complaint = rs274_oracle.run(tmp_path / "subs.ngc", tmp_path, {})
    blocks, findings = stages.decode(text.encode(), mill)
    assert (complaint, [each for each in findings if each["code"] < 0]) == ("", []), text
    ours = rs274_oracle.from_blocks(blocks, lib.NCK_COUNTS_PER_DEG)
    equal, words = rs274_oracle.difference(ours, theirs)
    assert not words, text
    assert equal >= 0.5 * len(theirs)
