# SPDX-License-Identifier: MIT
"""What a text is for is told in one line, with the command that reads it."""

import random
import shlex

import pytest
from cases import CORPUS

import pycnc
from pycnc.machine import Machine

KINDS = {"a print": "printer", "a Klipper print": "printer_klipper",
         "a lathe's program": "lathe_fanuc",
         "a program for axes that turn": "mill5_xyzac"}  # fmt: skip


def number(rng):
    return f"{rng.uniform(-40, 40):.2f}"


def text_of(kind, seed):
    """Return a random program of a kind."""
    rng = random.Random(seed)
    if kind == "a print":
        lines = [rng.choice(("M104 S200", "M140 S60", "N4 M190 S60")), "G21 G90"]
        lines += [f"G1 X{number(rng)} Y{number(rng)} E{k}.5 F900" for k in range(30)]
    elif kind == "a Klipper print":
        words = ("EXCLUDE_OBJECT_DEFINE NAME=a", "SET_VELOCITY_LIMIT ACCEL=900", "START_PRINT B=60")
        lines = ["M104 S200", "G21", "G90", rng.choice(words)]
        lines += [f"G1 X{number(rng)} Y{number(rng)} E{k}.5 F900" for k in range(30)]
        lines.insert(9, rng.choice(words))
    elif kind == "a lathe's program":
        lines = ["G21", rng.choice(("G50 S2000", "G96 S200 M3", "T0101"))]
        lines += [f"{rng.choice(('G0', 'G1'))} X{number(rng)} W{number(rng)} F.2"
                  for _ in range(30)]  # fmt: skip
    else:
        lines = ["G21 G90 G94 F300"]
        lines += [f"G1 X{number(rng)} Y1. {rng.choice('AC')}{number(rng)}" for _ in range(30)]
    return "(X1 Y2 A3)\n" + "\n".join(lines) + "\n"


@pytest.mark.parametrize("seed", range(20))
@pytest.mark.parametrize("kind", KINDS)
def test_a_kind_is_told_once_with_the_machine_that_reads_it(kind, seed):
    program = pycnc.load(text_of(kind, seed), Machine.load("mill3", set=["dialect.base=linuxcnc"]))
    first = program.diagnostics.shown[0]
    strange = [each.id for each in program.diagnostics.shown if each.id.endswith("-unknown")]
    assert (first.id, kind in first.message) == ("looks-like", True)
    assert f"-m {KINDS[kind]}" in first.help
    assert len(strange) == len(set(strange))
    assert program.diagnostics.errors >= 10


@pytest.mark.parametrize("kind", KINDS)
def test_a_machine_of_the_kind_says_nothing(kind):
    machine = Machine.load(KINDS[kind])
    told = pycnc.load(text_of(kind, 1) + "G777\n", machine).diagnostics.counts
    assert (told["looks-like"], told["g-unknown"]) == (0, 1)


@pytest.mark.parametrize("seed", range(20))
def test_a_laser_is_told_without_an_error_and_cuts_of_a_spindle_are_none(seed):
    rng = random.Random(seed)
    mill = Machine.load("mill3", set=["dialect.base=linuxcnc"])
    cuts = [f"G1 X{number(rng)} Y{number(rng)} S{rng.choice((0, 300, 850.5))} F900"
            for _ in range(40)]  # fmt: skip
    text = f"; G1 S1\nG21 G90\n{rng.choice(('M3', 'M4'))} S0\n" + "\n".join(cuts) + "\nM5\nM2\n"
    program = pycnc.load(text, mill)
    (found,) = [each for each in program.diagnostics if each.id == "looks-like"]
    assert "a laser" in found.message and "-m laser" in found.help
    assert program.diagnostics.errors == 0
    others = (text.replace("M5", "G1 Z-3"), "\n".join(cuts[:2]) + "\n",
              "G21 G90 M3 S900\n" + "\n".join(f"G1 X{number(rng)} S900 F90" for _ in range(40)))
    for other in others:
        assert pycnc.load(f"{other}\nM2\n", mill).diagnostics.counts["looks-like"] == 0
    assert pycnc.load(text, "laser").diagnostics.counts["looks-like"] == 0


@pytest.mark.parametrize("seed", range(20))
def test_a_laser_of_one_power_is_told_and_what_has_a_height_or_a_speed_is_none(seed):
    rng = random.Random(seed)
    mill = Machine.load("mill3", set=["dialect.base=linuxcnc"])
    power, cut = rng.randrange(1, 1000), rng.choice(["G1 X9Y9S{}F900", "G01 Y3 S{} F90"])
    head = f"G21 G90\n{rng.choice(['M3', 'M4', 'M03 S0', 'N5 M4'])}\nG0 X1 Y2\n"
    cuts = "\n".join(f"X{number(rng)} Y{number(rng)}" for _ in range(9))
    text = f"{head}{cut.format(power)}\n{cuts}\n{rng.choice(['G1 S0', 'M5 S0', ''])}\nM5\nM2\n"
    program = pycnc.load(text, mill)
    assert program.diagnostics.counts["looks-like"] == 1
    assert program.diagnostics.errors == 0
    for other in (f"G0 Z5\n{text}", f"S900\n{text}", text.replace("M", "(M)")):
        assert pycnc.load(other, mill).diagnostics.counts["looks-like"] == 0
    assert pycnc.load(text, "laser").diagnostics.counts["looks-like"] == 0


@pytest.mark.parametrize("text", [
    "G21 G90\nG1 X1 Y2 F9\nG777\n", "G21 G90\nG0 X1 Y2\nA5 M2\n", "G96 S100 D900\nG1 X1 Y1\nG777\n",
])  # fmt: skip
def test_a_mills_program_with_a_mistake_is_no_other_kind(text):
    assert pycnc.load(text).diagnostics.counts["looks-like"] == 0


@pytest.mark.parametrize(("text", "machine"), [
    ("G21 G90 G94 F9\nG1 X1 A4\nX2 A5\nM2\n", "mill4"),
    ("G21 G90 G94 F9\nG1 X1 A4\nX2 C5\nM2\n", "mill5_xyzac"),
    ("G21 G99 T0101 G97 S500 M3\nG0 X24. Z2.\nM30\n", "lathe_fanuc"),
    ("G96 D2500 S180 M3\nG95 G1 X1 Z1 F0.2\nT99 M6\nM2\n", "cak6150n --dialect linuxcnc"),
])  # fmt: skip
def test_the_command_has_the_machine_that_the_words_are_of(text, machine):
    first = pycnc.load(text, Machine.load("mill3")).diagnostics.shown[0]
    assert (first.id, first.help.partition("-m ")[2]) == ("looks-like", machine)


def test_the_command_of_a_print_reads_it():
    file = CORPUS / "print_cura_bp_case_56k.gcode"
    if not file.exists():
        pytest.skip("no corpus")
    text = file.read_bytes()[:100_000].rpartition(b"\n")[0]
    command = shlex.split(pycnc.load(text, Machine.load("mill3")).diagnostics.shown[0].help)
    assert command[:2] == ["pycnc", "time"]
    assert pycnc.load(text, command[command.index("-m") + 1]).diagnostics.errors == 0


@pytest.mark.parametrize("seed", range(20))
def test_a_raster_whose_lines_have_no_g1_is_a_lasers(seed):
    rng = random.Random(seed)
    rows = [f"{rng.choice('XY')}{rng.choice(('', '-'))}0.1S{rng.randrange(900)}" for _ in range(40)]
    text = "G21\nG91\nM4\nG0X9Y9\nG1X2S0F6000\n" + "\n".join(rows) + "\nM5\nM2\n"
    mill = Machine.load("mill3")
    assert "-m laser" in pycnc.load(text, mill).diagnostics.shown[0].help
    deep = text.replace("G1X2", "G1Z-1X2")
    assert pycnc.load(deep, mill).diagnostics.counts["looks-like"] == 0


@pytest.mark.parametrize("seed", range(20))
def test_a_mills_program_of_fanuc_is_told_with_the_command_that_reads_it(seed):
    rng = random.Random(seed)
    rows = [f"G0 X{number(rng)} Y{number(rng)}" for _ in range(9)]
    own = rng.choice(("G187 P2 E.02", "G54.1 P3", "G05.1 Q1", "G154 P2", "G5 P10000"))
    turns = rng.choice(("", "G0 A30.\nG0 A40.\n"))
    head = f"%\nO{rng.randrange(10, 9999)} (PART)\nG21 G90\n{own}\n"
    text = head + "\n".join(rows) + f"\n{turns}"
    first = pycnc.load(f"{text}M30\n%\n", Machine.load("mill3")).diagnostics.shown[0]
    options = "-m mill4 --dialect fanuc" if turns else "-m haas_vf2"
    assert (first.id, options in first.help) == ("looks-like", True)
    plain = text.replace(own, "G17")  # which RS274NGC has, too
    assert pycnc.load(f"{plain}M30\n%\n", Machine.load("mill4")).diagnostics.counts[
        "looks-like"] == 0  # fmt: skip
    assert pycnc.load(f"{text}M30\n%\n", Machine.load("mill4", dialect="fanuc")).diagnostics.counts[
        "looks-like"] == 0  # fmt: skip


@pytest.mark.parametrize("seed", range(40))
def test_words_of_a_mill_that_a_print_has_too_make_none(seed):
    """M codes of a machine's own without a heat, and chamfers that are no axis C."""
    rng = random.Random(seed)
    own = rng.choice(["M104", "M109", "N7 M140", "M190", "M104 (ARM)", "M109 P501 (WAIT)"])
    lines = ["O1", "G21 G90 G54", "T1 M6", "G43 H1 Z50.", own, "G1 X10. ,C1. F900.", "Y10. ,C1.",
             "X0", rng.choice(["A0.", "M999", "G1 X2. J4."]), "M30"]  # fmt: skip
    found = pycnc.load("\n".join(lines) + "\n", Machine.load("haas_vf2")).diagnostics
    assert found.errors
    assert not any("printer" in each.help or "mill5" in each.help for each in found)
