# SPDX-License-Identifier: MIT
"""Times under a feed override, and what is left at a line."""

import json
import random

import pytest
from command_line import pycnc

from pycnc.machine import Machine
from pycnc.planning.plan import Plan
from pycnc.program import load
from pycnc.report.trace import run

KINDS = ("klipper", "grbl", "grblhal", "fluidnc", "marlin", "linuxcnc")


def _program(pen, scale=1.0, end="M2"):
    rows = []
    for k in range(pen.randrange(4, 30)):
        feed = pen.randrange(200, 3000)
        rows.append(f"G1 X{pen.uniform(0, 60):.3f} Y{pen.uniform(0, 60):.3f} F{feed * scale:g}")
        if k % 7 == 3:
            rows.append(f"G4 P{pen.randrange(3)}")
    return "\n".join(["G21", "G90", *rows, end, ""])


@pytest.mark.sample(30)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("number", range(40))
def test_an_override_is_as_if_the_program_said_other_feeds(kind, number, draw_seed):
    seed, percent = draw_seed + number, random.Random(number).choice([10, 50, 80, 150, 200])
    base = "marlin" if kind in ("klipper", "marlin") else "linuxcnc"
    machine = Machine.load("mill3", set={"control.kind": kind, "dialect.base": base})
    end = "M84" if base == "marlin" else "M2"
    as_it_is = load(_program(random.Random(seed), end=end), machine)
    scaled = load(_program(random.Random(seed), percent / 100, end), machine)
    got = Plan(as_it_is, override=percent / 100).time_s
    assert got == pytest.approx(Plan(scaled).time_s, rel=1e-9)


def test_rapids_of_a_printer_have_the_override_too_and_others_have_not():
    text = "G21\nG90\nG0 X80 F600\nG1 X10 F600\n"
    times = {}
    for kind in ("klipper", "linuxcnc"):
        base = {"klipper": "marlin"}.get(kind, kind)
        machine = Machine.load("mill3", set={"control.kind": kind, "dialect.base": base})
        whole, half = (Plan(load(text, machine), override=o).totals for o in (1.0, 0.5))
        times[kind] = half["rapid_s"] / whole["rapid_s"]
    assert times["klipper"] == pytest.approx(2, rel=0.05) and times["linuxcnc"] == 1


def test_this_kernels_override_is_that_of_its_clock(tmp_path):
    text = _program(random.Random(5))
    told = json.loads(pycnc("time", "-", "--override", "50", "--json", stdin=text.encode()).out)
    assert told["time_s"] == run(text, commands=[(0, "override", 50, 100)]).summary["time_s"]
    assert told["override"] == 50 and "cut_s" not in told
    for words in (["--by", "line"], ["--left", "3"], ["--plan", "grades"], ["-"]):
        refused = pycnc("lab", "time", "-", "--override", "50", *words, stdin=text.encode())
        assert refused.code == 2 and "error[override]" in refused.err, words


@pytest.mark.sample(20)
@pytest.mark.parametrize("number", range(60))
def test_what_is_left_at_a_line_is_what_its_lines_take(number, draw_seed):
    pen = random.Random(draw_seed + number)
    kind = pen.choice(["nck", *KINDS])
    text = _program(pen)
    line = pen.randrange(1, text.count("\n") + 1)
    options = ["--set", f"control.kind={kind}", "--json"]
    told = json.loads(pycnc("time", "-", *options, "--left", line, stdin=text.encode()).out)
    whole = told["total_s"]
    assert told["left_s"] == pytest.approx(
        sum(part["time_s"] for part in told["parts"] if part["line"] >= line))  # fmt: skip
    first = json.loads(pycnc("time", "-", *options, "--left", 1, stdin=text.encode()).out)
    assert first["left_s"] == pytest.approx(whole, abs=0.01)
    assert 0 <= told["left_s"] <= first["left_s"]


def test_a_loop_has_no_line_that_says_how_far_it_is():
    text = b"G21 G90\no1 repeat [3]\nG1 X10 F600\nX0\no1 endrepeat\nM2\n"
    told = pycnc("time", "-", "--left", "3", stdin=text)
    assert told.code == 2 and "error[left]: line 3 comes behind line 4" in told.err
    told = pycnc("time", "-", "--left", "3", "--by", "tool", stdin=text)
    assert told.code == 2 and "error[left]" in told.err
