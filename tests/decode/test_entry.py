# SPDX-License-Identifier: MIT
"""Room 1: a program that begins in the middle goes on as the whole one would."""

import cases
import numpy as np
import pytest

import pycnc
from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

EVERYTHING = """G21 G17 G90 G94 F500
T2 M6 G43
S900 M4
M8
G0 X10 Y10 Z50
G55 G91.1
G1 Z-1 F300
G2 X20 Y20 I5 J5
G91 G1 X5 M7
#<n> = 3
o1 while [#<n> gt 0]
  X1 S[900 + #<n>]
  #<n> = [#<n> - 1]
o1 endwhile
G90 G98 G81 X40 Z-5 R2
X50
G80 M9
G64 P0.1
G20 G1 X2
G21 T3
M5
G0 Z40
M2
"""


TURNED = """G21 G18 G99
G50 S2000
T0202
G96 S120 M3
G0 X60 Z2 M8
G1 Z-10 F0.2
G50 X0 Z5
U4 W-2
G90 X50 Z-20
X46
G97 S600
G92 X44 Z-15 F1.5
X43
G74 R0.5
G74 Z-20. X40. P1000 Q4000 F0.1
G98 F200
G0 X70 Z9
G28 U0 W0
M30
"""
LATHE = ("dialect.base=fanuc", "dialect.system=A", "tool.2.x_mm=3", "tool.2.length_mm=-7")


def whole(machine, text):
    blocks, diagnostics = stages.decode(text, machine)
    assert not (diagnostics["code"] < 0).any()
    return blocks


def entered(name, text, line, settings=()):
    """Return the blocks of a text from a line on, and the first error."""
    machine = Machine.load(name, set=[*settings, f"dialect.from_line={line}"])
    blocks, diagnostics = stages.decode(text, machine)
    errors = diagnostics[diagnostics["code"] < 0]
    return blocks, [status_id(int(each["code"])) for each in errors]


def parted(line):
    """Return the blocks of the whole program before a line and from it on, and those entered."""
    text = EVERYTHING.encode()
    full = whole(Machine.load("mill3"), text)
    first = int(np.argmax(full["line"] >= line))
    blocks, errors = entered("mill3", text, line)
    assert errors == []
    return full[:first], full[first:], blocks


@pytest.mark.parametrize("line", range(1, EVERYTHING.count("\n") + 1))
def test_from_every_line_on_the_blocks_are_those_of_the_whole_program(line):
    before, rest, blocks = parted(line)
    assert (blocks[-len(rest) :] == rest).all()
    entry = blocks[: -len(rest)]
    moves = before[before["kind"] <= lib.NCK_BLOCK_ARC]
    if len(moves):  # the tool comes to where it would be
        assert (entry[-1]["target_nm"] == moves[-1]["target_nm"]).all()


@pytest.mark.parametrize("line", range(2, TURNED.count("\n") + 1))
def test_a_lathe_enters_with_its_zero_tool_and_modes(line):
    text = TURNED.encode()
    full = whole(Machine.load("cak6150n", set=LATHE), text)
    first = int(np.argmax(full["line"] >= line))
    blocks, errors = entered("cak6150n", text, line, LATHE)
    assert errors == []
    assert (blocks[-len(full[first:]) :] == full[first:]).all()
    assert in_force(blocks[: len(blocks) - len(full[first:])]) == in_force(full[:first])


def in_force(blocks):
    """Return the last speed (G96, G97), spindle and coolant words, and the tool, of outputs."""
    state = {}
    for block in blocks[(blocks["kind"] == lib.NCK_BLOCK_OUTPUT)
                        | (blocks["kind"] == lib.NCK_BLOCK_WAIT)]:  # fmt: skip
        kind, value = int(block["output"]["kind"]), float(block["output"]["value"])
        if kind == lib.NCK_OUTPUT_M and value == 9:
            state.pop(7, None), state.pop(8, None)
        group = {3: 5, 4: 5}.get(value, value) if kind == lib.NCK_OUTPUT_M else -1 - kind
        if not (kind == lib.NCK_OUTPUT_M and value in (6, 9)):
            speeds = (lib.NCK_OUTPUT_SPINDLE_SPEED, lib.NCK_OUTPUT_SURFACE_SPEED)
            state["speed" if kind in speeds else group] = (kind, value) if kind in speeds else value
    if state.get(5) == 5:
        del state[5]
    return state


@pytest.mark.parametrize("line", range(5, EVERYTHING.count("\n") + 1))
def test_tool_spindle_and_coolant_are_those_of_the_line(line):
    before, rest, blocks = parted(line)
    assert in_force(blocks[: len(blocks) - len(rest)]) == in_force(before)


def test_what_a_line_cannot_be_is_told():
    mill = lambda text, line: entered("mill3", text.encode(), line)[1]  # noqa: E731
    assert mill("G21 G90 G0 X1\nX2\nM2\n", 4) == ["label-missing"]
    comp = "G21 G90 T1 M6\nG0 X1\nG41 D1 G1 X20 F100\nX30\nG40 Y50\nM2\n"
    settings = ["tool.1.radius_mm=3"]
    assert entered("mill3", comp.encode(), 4, settings)[1] == ["comp-on"]
    assert entered("mill3", comp.encode(), 3, settings)[1] == []


def test_the_rest_runs_within_all_limits_and_ends_where_the_whole_program_does():
    case = cases.CASES[0]
    lines = case.text.count("\n")
    machine = Machine.load(case.machine, set=[f"dialect.from_line={lines // 2}"])
    begun = pycnc.load(case.text, machine)
    assert begun.diagnostics.errors == 0
    everything = pycnc.load(case.text, case.machine)
    assert (begun.blocks[-1] == everything.blocks[-1]).all() if begun.block_count else False
    trace = pycnc.run(begun)
    assert all(peak["v"] <= 1 + 1e-9 for axis, peak in trace.summary["peaks"].items()
               if axis != "path")  # fmt: skip
