# SPDX-License-Identifier: MIT
"""What a program says to its operator: found by seed among other comments, and told."""

import random

import pytest
from command_line import pycnc

from pycnc import load
from pycnc.machine import Machine

MILL = Machine.load("mill3")


def _remark(rng, k):
    """Return (the source of a remark, what is told of it)."""
    kind, blank = rng.choice(("MSG", "DEBUG", "PRINT")), rng.choice(("", " ", "\t "))
    numbers = rng.random() < 0.3
    said = f"part {k}{' is #5420' if numbers else ''}"
    cased = "".join(rng.choice((letter, letter.lower())) for letter in kind)
    then = ", with the numbers that hold then" if numbers and kind != "MSG" else ""
    return f"({blank}{cased}{blank},{blank}{said}{blank})", f"says{then}: {said}"


@pytest.mark.parametrize("seed", range(20))
def test_remarks_are_told_with_their_place(seed):
    rng = random.Random(seed)
    skips, lines, expected = rng.random() < 0.5, ["G21 G90 F100"], []
    for k in range(12):
        source, words = _remark(rng, k)
        move = rng.choice(("", f"G1 X{k} ", f"N{k} "))
        line, column, told = rng.choice((
            (f"{move}{source}", len(move) + 1, True),
            (f"{move}(a (comment) {source}".replace("(a (", "(a) ("), None, True),
            (f"{move}{source} (behind it)", 0, False), (f"{move}; {source}", 0, False),
            (f"/{move}{source}", len(move) + 2, not skips), (f"{move}(MSGS, no)", 0, False),
            (f"{move}(no MSG, no)", 0, False), (f"G1 Y{k}", 0, False),
        ))  # fmt: skip
        lines.append(line)
        if told:
            expected.append((len(lines), column or line.rindex("(") + 1, words))
    end = rng.choice(("\n", "\r\n"))
    text = end.join([*lines, "M2", "(MSG, behind the end)", ""])
    machine = Machine.load(MILL, set={"dialect.block_skip": skips})
    found = [(each.line, each.col, each.message) for each in load(text, machine).diagnostics
             if each.id == "remark"]  # fmt: skip
    assert found == expected


def test_check_and_run_tell_them(tmp_path):
    part = tmp_path / "part.ngc"
    part.write_text("G21 G90\n(MSG, clamp the part)\nG1 X1 F100\nM2\n")
    assert "2:1: note[remark]: says: clamp the part" in pycnc("check", part).out
    assert "Line 2 says: clamp the part" in pycnc("run", part).out


def test_other_languages_have_none():
    text = "G21\nG90\n(MSG, hello)\nG1 X1 F100\n"
    for base in ("grbl", "fanuc", "marlin"):
        machine = Machine.load(MILL, set={"dialect.base": base})
        assert "remark" not in load(text, machine).diagnostics.counts
