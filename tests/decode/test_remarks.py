# SPDX-License-Identifier: MIT
"""What a program says to its operator: found by seed among other comments, and told."""

import random
import re
import subprocess

import pytest
from command_line import pycnc

from pycnc import load
from pycnc.machine import Machine

MILL = Machine.load("mill3")


def _remark(rng, k):
    """Return (the source of a remark, what is told of it)."""
    kind, blank = rng.choice(("MSG", "DEBUG", "PRINT")), rng.choice(("", " ", "\t "))
    numbers = rng.random() < 0.3
    said = f"part {k}{' is #31' if numbers else ''}"
    cased = "".join(rng.choice((letter, letter.lower())) for letter in kind)
    told = said if kind == "MSG" else said.replace("#31", "2.500000")
    return f"({blank}{cased}{blank},{blank}{said}{blank})", f"says: {told}"


@pytest.mark.parametrize("seed", range(20))
def test_remarks_are_told_with_their_place(seed):
    rng = random.Random(seed)
    skips, lines, expected = rng.random() < 0.5, ["G21 G90 F100 #31=2.5"], []
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


_FORMS = ("%d", "%f", "%.0f", "%.3f", "%.9f", "%4", "%x", "%%", "%.2d", "%D", " ", "_", ".5")


def _shown(rng, k):
    """Return a remark with numbers, named by its line."""
    names = (f"#{rng.randint(1, 4)}", "#<abc>", "#<A B c>", "#<_g>", "#<never>", "#9", "#6000", "#")
    parts = [rng.choice(rng.choice((names, _FORMS))) for _ in range(rng.randint(1, 6))]
    return f"(PRINT,L{k}: {''.join(parts)}#1|)"


def _talking(rng):
    """Return a program that says numbers, in branches, loops and calls."""
    values = [rng.choice((0.5, 1.5, -2.5, 7, 1 / 3, 1234567.891, -0.0004)) for _ in range(6)]
    lines = [f"#{k}={value:.6f}" for k, value in enumerate(values[:4], 1)]
    lines += [f"#<abc>={values[4]:.6f}", f"#<_g>={values[5]:.6f}", "o9 sub", "", "o9 endsub"]
    sub, k = lines.index(""), len(lines)
    lines[sub] = _shown(rng, sub)
    for _ in range(8):
        k = len(lines)
        lines += rng.choice((
            [_shown(rng, k)], [f"#{rng.randint(1, 4)}=[#1+1] {_shown(rng, k)}"],
            [f"o{k} if [#1 GT 1]", _shown(rng, k + 1), f"o{k} endif"],
            [f"o{k} repeat [3]", "#2=[#2+0.25]", _shown(rng, k + 2), f"o{k} endrepeat"],
            [f"o9 call [{rng.randint(1, 9)}]"], [f"G1 X{k} {_shown(rng, k)}"],
            [f"o{k} if [#1 LT 1] {_shown(rng, k)}", f"o{k} endif"],
        ))  # fmt: skip
    return "\n".join(["G21 G90 F100", *lines, "M2", ""])


@pytest.mark.sample(12)
@pytest.mark.parametrize("seed", range(1000))
def test_numbers_are_shown_as_linuxcnc_shows_them(seed, draw_seed, tool, tmp_path):
    text = _talking(random.Random(seed + draw_seed))
    part = tmp_path / "part.ngc"
    part.write_text(text)
    done = subprocess.run([tool("rs274"), "-g", part], capture_output=True, text=True, cwd=tmp_path,
                          stdin=subprocess.DEVNULL)  # fmt: skip
    theirs = {}
    for said in re.findall(r"^ ?(L\d+:.*\|)$", done.stdout + done.stderr, re.M):
        theirs.setdefault(said.partition(":")[0], []).append(said)
    machine = Machine.load(MILL, set={"axis.x.max_mm": "free"})
    ours = [each.message for each in load(text, machine).diagnostics if each.id == "remark"]
    expected = []
    for line in re.findall(r"L\d+(?=:)", re.sub(r"^o\d+ .*", "", text, flags=re.M)):
        runs = theirs.get(line)
        more = f" (and {len(runs) - 1:,} times more, the last one: {runs[-1]})" if runs else ""
        more = more if runs and len(runs) > 1 else ""
        expected.append(f"says: {runs[0]}{more}" if runs else None)
    assert len(ours) == len(expected)
    for mine, there in zip(ours, expected, strict=True):
        if there is None:  # a line that nothing comes to
            assert "#" not in mine or mine.startswith("says, with the numbers that hold then:")
        else:
            assert mine == there, text
