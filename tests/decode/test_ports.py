# SPDX-License-Identifier: MIT
"""Room 1: outputs and inputs, states that are kept and restored, G28.1 and G43.1, against rs274."""

import random

import pytest
import rs274_oracle

import pycnc
from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

FREE = [f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
TOOLS = {1: 0.0, 2: 50.8}
HOMES = [f"home.{code}.{axis}_mm=0" for code in ("g28", "g30") for axis in "xyz"]


@pytest.fixture(scope="module")
def machine():
    lengths = [f"tool.{number}.length_mm={length}" for number, length in TOOLS.items()]
    return Machine.load("mill3", set=[*FREE, *HOMES, *lengths])


@pytest.fixture
def oracle(tool, tmp_path):
    tool("rs274")

    def run(text):
        (tmp_path / "program.ngc").write_bytes(text.encode())
        return rs274_oracle.run(tmp_path / "program.ngc", tmp_path, TOOLS)

    return run


def decode(text, machine):
    program = pycnc.load(text, machine)
    found = [(each.id, each.line) for each in program.diagnostics if each.severity == "error"]
    return program.blocks, found


def outputs(blocks):
    names = {lib.NCK_OUTPUT_DIGITAL: "bit", lib.NCK_OUTPUT_ANALOGUE: "value",
             lib.NCK_OUTPUT_INPUT: "input", lib.NCK_OUTPUT_M: "M",
             lib.NCK_OUTPUT_SPINDLE_SPEED: "S"}  # fmt: skip
    return [
        (names[int(block["output"]["kind"])], int(block["output"]["number"]),
         float(block["output"]["value"]), int(block["kind"]) == lib.NCK_BLOCK_WAIT)
        for block in blocks[:-1] if block["kind"] >= lib.NCK_BLOCK_WAIT
    ]  # fmt: skip


def test_ports_are_handed_over_in_their_place(machine):
    text = "M62 P1\nM63 P2\nM64 P0\nM65 P3\nM67 E0 Q1.5\nM68 E1 Q-2\nM66 P0 L0\nM66 P1 L3 Q5\nM2\n"
    blocks, errors = decode(text, machine)
    assert errors == []
    assert outputs(blocks) == [
        ("bit", 1, 1.0, False), ("bit", 2, 0.0, False), ("bit", 0, 1.0, False),
        ("bit", 3, 0.0, False), ("value", 0, 1.5, False), ("value", 1, -2.0, False),
        ("input", 0, 0.0, False), ("input", 301, 5.0, True),
    ]  # fmt: skip


def test_a_port_is_switched_while_the_tool_moves(machine):
    text = "G21 G90 G64 P0.01\nG1 X10 F3000\nM62 P1\nX20\nM2\n"
    plain = pycnc.plan(pycnc.load(text.replace("M62 P1\n", ""), machine)).time_s
    assert pycnc.plan(pycnc.load(text, machine)).time_s == plain


REFUSED = (
    "M62", "M67 Q1", "M66 P1 E1 L0", "M66 P1 L3", "M66 E1 L3 Q1", "M62 P1 M64 P2", "M66 L3 Q1",
    "M72", "M70\nM71\nM72", "G43.2", "G43.2 H9",
)  # fmt: skip


@pytest.mark.parametrize("lines", REFUSED)
def test_what_rs274_refuses_is_refused(lines, machine, oracle):
    text = f"G21 G90\n{lines}\nM2\n"
    assert len(decode(text, machine)[1]) == 1
    assert oracle(text)[1] != ""


def test_a_state_is_restored_with_its_outputs(machine):
    change = "G20 G91 F3 S5 G55 G18 M4 M9 G64 P1\n"
    text = f"G21 G90 G17 G54 F30 S100 M3 M8\nM70\n{change}M72\nG1 X1\nG2 X2 I.5\nM2\n"
    blocks, errors = decode(text, machine)
    assert errors == []
    last = [(kind, value) for kind, _, value, _ in outputs(blocks)][-3:]
    assert last == [("S", 100.0), ("M", 3.0), ("M", 8.0)]
    assert blocks["target_nm"][-2][0] == 2_000_000
    assert blocks["feed"][-2] == 30


@pytest.mark.parametrize("end", ["O100 endsub", "O100 return\nO100 endsub"])
def test_m73_restores_when_its_call_is_over(end, machine, oracle):
    text = f"G21 G90 F30\nO100 sub\nM73\nG91 G20 M3 S9\nG0 X1\n{end}\nO100 call\nO100 call\nG0 X1\n"
    blocks, errors = decode(text + "M2\n", machine)
    assert errors == []
    moves = blocks[blocks["kind"] == 0]["target_nm"][:, 0] / 1e6
    assert moves.tolist() == [25.4, 50.8, 1.0]
    assert [value for kind, _, value, _ in outputs(blocks) if kind == "M"] == [3, 5, 3, 5]
    theirs, complaint = oracle(text + "M2\n")
    assert complaint == ""
    assert [move.end[0] for move in theirs] == pytest.approx(moves.tolist(), abs=2e-3)


def test_m99_restores_too(machine):
    text = "G21 G90 F30\nM98 P100\nG0 X1\nM2\nO100\nM73\nG91 S9\nG0 X3\nM99\n"
    blocks, errors = decode(text, Machine.load("mill3", set=[*FREE]))
    assert errors == []
    assert blocks[blocks["kind"] == 0]["target_nm"][:, 0].tolist() == [3_000_000, 1_000_000]


def program(seed):
    """Return a text that keeps and restores states, or sets lengths (rs274 restores G43.1 as the
    G43 of the tool), and sets homes."""
    source = random.Random(seed)
    states = seed % 2
    lines = ["G21 G17 G90 G94 F500", "T2 M6", "S100 M3", "M70"]

    def places():
        letters = source.sample("XYZ", source.randint(1, 3))
        return " ".join(f"{letter}{source.uniform(-90, 90):.4f}" for letter in letters)

    for _ in range(40):
        lines.append(source.choice((
            *(("M70", "M72", "M72") if states else (f"G43.1 {places()}", "G43.2 H2")),
            f"G1 {places()}", f"G0 {places()}", source.choice(("G54", "G55")),
            source.choice(("G90", "G91")), "G28.1", "G30.1", "G28", "G30", f"G28 {places()}",
            "G43 H2", "G49", f"F{source.randint(9, 900)}",
            f"G10 L2 P2 {places()}", source.choice(("G61", "G64 P0.1")), f"G0 {places()}",
        )))  # fmt: skip
    return "\n".join([*lines, "G90 G0 X1 Y2 Z3", "M2", ""])


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("first", range(0, 60, 20))
def test_random_programs_equal_rs274(first, machine, oracle):
    for seed in range(first, first + 20):
        text = program(seed)
        blocks, diagnostics = stages.decode(text.encode(), machine)
        errors = diagnostics[diagnostics["code"] < 0]
        assert [status_id(int(each["code"])) for each in errors] == [], f"seed {seed}"
        theirs, complaint = oracle(text)
        assert complaint == "", f"seed {seed}"
        ours = rs274_oracle.from_blocks(blocks, lib.NCK_COUNTS_PER_DEG)
        _, words = rs274_oracle.difference(ours, theirs)
        assert words == "", f"seed {seed}: {words}"


def test_codes_of_rs274_stay_strange_to_others():
    fanuc = Machine.load("mill3", set=["dialect.base=fanuc"])
    for line in ("M62 P1", "M70", "G43.2 H1", "G28.1"):
        assert [each[0] for each in decode(f"G21 G90\n{line}\nM30\n", fanuc)[1]] == ["other-base"]
