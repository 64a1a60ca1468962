# SPDX-License-Identifier: MIT
"""Room 1: what Klipper saves of its modes and brings back."""

import random

import pytest

import pycnc


def program(pen):
    """Return (a print that saves and restores, the same in plain words)."""
    lines, plain, kept = ["G21", "G90", "M82", "G92 E0"], [], {}
    now = {"way": "G90", "flow": "M82", "feed": "1500"}
    plain += lines
    for k in range(pen.randrange(5, 40)):
        name = pen.choice(["", " NAME=a", " name=b MOVE=0"])
        what = pen.randrange(6)
        if what == 0:
            kept[name] = dict(now)
            lines.append(f"SAVE_GCODE_STATE{name}")
        elif what == 1 and name in kept:
            changed = [key for key in now if now[key] != kept[name][key]]
            if "flow" in changed and len(changed) > 1:
                continue
            lines.append(f"{pen.choice(['RESTORE', 'restore'])}_GCODE_STATE{name}")
            now = dict(kept[name])
            words = [now["way"], f"F{now['feed']}"] if "flow" not in changed else [now["flow"]]
            plain.append(" ".join(words))
        elif what == 2:
            now["way"] = pen.choice(["G90", "G91"])
            lines.append(now["way"])
            plain.append(now["way"])
        elif what == 3:
            now["flow"] = pen.choice(["M82", "M83"])
            lines.append(now["flow"])
            plain.append(now["flow"])
        else:
            feed = pen.choice(["", f" F{pen.randrange(300, 9000)}"])
            now["feed"] = feed[2:] or now["feed"]
            at = pen.randrange(1, 4) if now["way"] == "G91" else pen.randrange(5, 190)
            lines.append(f"G1 X{at} E{0.01 * k:.2f}{feed} ; F7")
            plain.append(lines[-1])
    return "\n".join([*lines, "G1 X5 E1", ""]), "\n".join([*plain, "G1 X5 E1", ""])


@pytest.mark.sample(30)
@pytest.mark.parametrize("number", range(400))
def test_a_restored_state_is_what_plain_words_say(number, draw_seed):
    text, plain = program(random.Random(draw_seed + number))
    one, other = (pycnc.load(each, "printer_klipper") for each in (text, plain))
    for name in ("target_nm", "feed", "kind"):
        assert one.blocks[name].tolist() == other.blocks[name].tolist()
    is_there = "restore_gcode" in text.lower()
    told = [each for each in one.diagnostics if "RESTORE" in each.message]
    assert [each.id for each in told] == ["macro-still"] * is_there


@pytest.mark.parametrize("line", [
    "RESTORE_GCODE_STATE NAME=a MOVE=1", "RESTORE_GCODE_STATE NAME=never", "RESTORE_GCODE_STATE",
])  # fmt: skip
def test_a_state_that_moves_or_was_never_saved_is_a_macro_of_its_own(line):
    text = f"G21\nG90\nM83\nSAVE_GCODE_STATE NAME=a\nG91\nG1 X5 E1 F900\n{line}\n"
    (found,) = [each for each in pycnc.load(text, "printer_klipper").diagnostics
                if each.severity == "warning"]  # fmt: skip
    assert (found.id, found.line) == ("macro-own", 7)


def test_a_state_that_needs_two_lines_stays_a_macro():
    text = "G21\nG90\nM82\nSAVE_GCODE_STATE\nG91\nM83\nG1 X5 E1 F900\nRESTORE_GCODE_STATE\n"
    assert pycnc.load(text, "printer_klipper").diagnostics.counts["macro-own"] == 1


@pytest.mark.parametrize(
    "line", ["Tx", "Tc ; all", "T?", "M702 C", "M701", 'M98 P"/macros/prime.g"']
)
def test_what_a_firmware_alone_knows_may_move(line):
    text = f"M104 S200\nG21\nG90\n{line}\nG1 X5 E1 F900\nT1\n"
    (found,) = [each for each in pycnc.load(text, "printer_marlin").diagnostics
                if each.severity in ("warning", "error")]  # fmt: skip
    assert (found.id, found.line, found.message.split(",")[0]) == (
        "macro-own", 4, line.split()[0].upper())  # fmt: skip


@pytest.mark.parametrize("machine", ["printer", "printer_marlin", "printer_klipper"])
@pytest.mark.parametrize("seed", range(10))
def test_what_a_host_hears_is_told_once_and_skipped(machine, seed):
    pen = random.Random(seed)
    lines = [f"G1 X{pen.randrange(1, 90)} F900 ; @no" for _ in range(9)]
    plain = "\n".join(["G21", "G90", *lines, ""])
    for _ in range(pen.randrange(1, 5)):
        lines.insert(pen.randrange(len(lines)), pen.choice(["@pause", " @OBJECT cube 1", "@PAUSE"]))
    text = "\n".join(["G21", "G90", *lines, ""])
    one, other = pycnc.load(text, machine), pycnc.load(plain, machine)
    assert one.diagnostics.errors == 0
    assert one.blocks["target_nm"].tolist() == other.blocks["target_nm"].tolist()
    names = {line.split()[0].upper() for line in lines if line.lstrip().startswith("@")}
    told = [each.message.split(",")[0] for each in one.diagnostics if each.id == "macro-still"]
    assert sorted(told) == sorted(names)
