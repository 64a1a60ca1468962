# SPDX-License-Identifier: MIT
"""Room 1: where the zero is, against rs274: G10 L2 L20, G52, G92 and its kin, work systems."""

import random

import pytest
import rs274_oracle

from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

FREE = [f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
SYSTEMS = "G54 G55 G56 G57 G58 G59 G59.1 G59.2 G59.3".split()
TOOLS = {1: 0.0, 2: 50.8}


def program(seed):
    """Return a text that shifts its zero between moves."""
    source = random.Random(seed)
    lines = ["G21 G17 G90 G94 F500", "T2 M6"]

    def places():
        letters = source.sample("XYZ", source.randint(1, 3))
        return " ".join(f"{letter}{source.uniform(-90, 90):.4f}" for letter in letters)

    for _ in range(40):
        lines.append(source.choice((
            f"G1 {places()}", f"G0 {places()}", f"G52 {places()}", f"G92 {places()}", "G92.1",
            "G92.2", "G92.3", f"G10 L2 P{source.randint(0, 9)} {places()}",
            f"G10 L20 P{source.randint(0, 9)} {places()}", source.choice(SYSTEMS),
            source.choice(("G90", "G91")), source.choice(("G43", "G49")), f"G1 {places()}",
        )))  # fmt: skip
    return "\n".join([*lines, "G90 G0 X1 Y2 Z3", "M2", ""]).encode()


def tool_program(seed):
    """Return a text that changes its tools: G10 L1 L10 L11 between G43, shifts and moves."""
    source = random.Random(seed)
    lines = ["G21 G17 G90 G94 F500", "T2 M6", "G0 X1 Y2 Z3"]

    def places():
        letters = source.sample("XYZ", source.randint(1, 3))
        return " ".join(f"{letter}{source.uniform(-90, 90):.4f}" for letter in letters)

    for _ in range(40):
        change = f"G10 L{source.choice([1, 10, 11])} P{source.randint(1, 2)} {places()}"
        lines.append(source.choice((
            change, change, f"{change} R{source.uniform(0, 9):.3f}", f"G1 {places()}",
            f"G0 {places()}", "G43", "G43 H1", "G43 H2", "G49", "G43.2 H1", f"G92 {places()}",
            "G92.1", f"G10 L2 P{source.choice([0, 1, 9])} {places()}", source.choice(SYSTEMS),
            source.choice(("G90", "G91")), f"G1 {places()}",
        )))  # fmt: skip
    return "\n".join([*lines, "G90 G0 X1 Y2 Z3", "M2", ""]).encode()


@pytest.mark.sample(quick=2)
@pytest.mark.parametrize("first", range(0, 100, 25))
def test_shifted_zeros_are_those_of_rs274(first, tool, tmp_path):
    tool("rs274")
    lengths = [f"tool.{number}.length_mm={length}" for number, length in TOOLS.items()]
    machine = Machine.load("mill3", set=[*FREE, *lengths])
    for seed in range(first, first + 25):
        text = program(seed)
        (tmp_path / "program.ngc").write_bytes(text)
        theirs, complaint = rs274_oracle.run(tmp_path / "program.ngc", tmp_path, TOOLS)
        blocks, diagnostics = stages.decode(text, machine)
        errors = diagnostics[diagnostics["code"] < 0]
        assert [status_id(int(each["code"])) for each in errors] == [], f"seed {seed}"
        assert complaint == "", f"seed {seed}"
        ours = rs274_oracle.from_blocks(blocks, lib.NCK_COUNTS_PER_DEG)
        _, words = rs274_oracle.difference(ours, theirs)
        assert words == "", f"seed {seed}: {words}"


def last_place(text):
    machine = Machine.load("mill3", set=[*FREE, "dialect.base=fanuc"])
    blocks, diagnostics = stages.decode(text.encode(), machine)
    errors = diagnostics[diagnostics["code"] < 0]
    if len(errors):
        return status_id(int(errors[0]["code"]))
    return (blocks[blocks["kind"] == 0]["target_nm"][-1][:3] / 1e6).tolist()


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("G54 G0 X1 Y0 Z0\nG52 X10 Y20\nX1 Y2 Z3\nM30\n", [11, 22, 3]),
        ("G54 G0 X1 Y0 Z0\nG52 X10\nG52 X0\nX1 Y2 Z3\nM30\n", [1, 2, 3]),
        ("G54 G0 X1 Y0 Z0\nG52 X10\nG55\nX1 Y2 Z3\nM30\n", [11, 2, 3]),
        ("G54 G0 X1 Y0 Z0\nG92 X5\nG52 X10\nX1\nM30\n", "unsupported"),
        ("G54 G0 X1 Y0 Z0\nG52 X10\nG92 X5\nX1\nM30\n", "unsupported"),
        ("G54 G0 X1 Y0 Z0\nG91 G52 X10\nX1\nM30\n", "incremental"),
        ("G54 G0 X1 Y2 Z3\nG10 L20 P1 X0 Y0\nX1 Y1\nM30\n", [1, 1, 3]),
        ("G54 G0 X1 Y2 Z3\nG10 L2 P7 X0 Y0\nX1 Y1\nM30\n", "number-range"),
        ("G10 L2 P0 X5 Y6\nG54 G0 X1 Y2 Z3\nG55 X1\nM30\n", [6, 8, 3]),
        ("G10 L2 P0 X5\nG91 G10 L2 P0 X1\nG10 L2 P1 X1\nG90 G54 G0 X1 Y2 Z3\nM30\n",
         [8, 2, 3]),
        ("G10 L2 P0 X5\nG0 X1 Y2 Z3\nG92 X10\nX11\nM30\n", [7, 2, 3]),
    ],
)
def test_fanucs_local_zero_counts_in_every_work_system(text, place):
    assert last_place(text) == place
