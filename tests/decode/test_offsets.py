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
ROUNDING = 5e-4  # [mm] rs274 prints an angle in four decimals, places are within 600 mm


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


def turned_program(seed):
    """Return a text whose work systems are turned about their zeros, shifted by G92.

    No turn is set while G92 is in force: rs274 then turns the place about the wrong zero.
    """
    source = random.Random(seed)
    lines = ["G21 G17 G90 G94 G91.1 F500", "T2 M6"]

    def places(most=90):
        letters = source.sample("XYZ", source.randint(1, 3))
        return " ".join(f"{letter}{source.uniform(-most, most):.4f}" for letter in letters)

    def arc():
        x, y = source.uniform(-30, 30), source.uniform(-30, 30)
        return f"G91 G{source.choice((2, 3))} X{2 * x:.4f} Y{2 * y:.4f} I{x:.4f} J{y:.4f}\nG90"

    for _ in range(40):
        turn = source.choice(("", f" R{source.choice((0, 90, -30, 371.5, source.uniform(0, 9)))}"))
        lines.append(source.choice((
            f"G1 {places()}", f"G0 {places()}", f"G1 {places()}", arc(), arc(), f"G92 {places()}",
            "G92.1", f"G52 {places()}", f"G92.1\nG10 L2 P{source.randint(0, 9)} {places()}{turn}",
            f"G92.1\nG10 L2 P{source.randint(1, 2)} X1{turn}", source.choice(SYSTEMS[:2]),
            source.choice(SYSTEMS), f"G53 G0 {places()}", source.choice(("G43", "G49")),
            "G1 X[#5420 + 1] Y#5421", f"G91 G1 {places(5)}\nG90", f"G1 @{source.randint(5, 40)}"
            f" ^{source.randint(0, 360)}",
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
@pytest.mark.parametrize("write", [program, turned_program])
@pytest.mark.parametrize("first", range(0, 100, 25))
def test_shifted_zeros_are_those_of_rs274(first, write, tool, tmp_path):
    tool("rs274")
    lengths = [f"tool.{number}.length_mm={length}" for number, length in TOOLS.items()]
    machine = Machine.load("mill3", set=[*FREE, *lengths, "path.arc_radius_mm=0.005"])
    for seed in range(first, first + 25):
        text = write(seed)
        (tmp_path / "program.ngc").write_bytes(text)
        theirs, complaint = rs274_oracle.run(tmp_path / "program.ngc", tmp_path, TOOLS)
        blocks, diagnostics = stages.decode(text, machine)
        errors = diagnostics[diagnostics["code"] < 0]
        assert [status_id(int(each["code"])) for each in errors] == [], f"seed {seed}"
        assert complaint == "", f"seed {seed}"
        for move in theirs:
            move.tolerance += ROUNDING if write == turned_program else 0.0
        ours = rs274_oracle.from_blocks(blocks, lib.NCK_COUNTS_PER_DEG)
        _, words = rs274_oracle.difference(ours, theirs)
        assert words == "", f"seed {seed}: {words}"


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("G10 L20 P1 X5", "layout-on"), ("G28 X0", "layout-on"), ("G18 G2 X9 Z9 R9", "layout-on"),
        ("G18\nG41 D1 G1 X5", "layout-on"), ("G18\nG81 X1 Z1 Y-1 R1", "layout-on"),
        ("G10 L2 P1 R1000001", "number-range"),
        ("G10 L20 P2 R5 X1", "layout-on"), ("G10 L2 P1 R0\nG10 L20 P2 R5 X1", "unsupported"),
    ],
)
def test_what_a_turned_work_system_cannot_is_refused(line, found):
    machine = Machine.load("mill3", set=[*FREE, "tool.1.radius_mm=1"])
    text = f"G21 G17 G90 F500\nG10 L2 P1 R30\nG1 X1\n{line}\nM2\n"
    _, findings = stages.decode(text.encode(), machine)
    errors = [status_id(int(each["code"])) for each in findings if each["code"] < 0]
    assert errors == [found]


def test_a_turn_is_read_as_a_parameter_and_nothing_to_places_of_the_machine():
    machine = Machine.load("mill3", set=[*FREE])
    text = "G21 G90 G55\nG10 L2 P2 R-30\nG0 X#5250 Y#5230\nG53 G0 X1 Y2\nG28\nM2\n"
    blocks, findings = stages.decode(text.encode(), machine)
    assert not (findings["code"] < 0).any()
    x, y, _ = (blocks[blocks["kind"] == 0]["target_nm"][0][:3] / 1e6).tolist()
    assert (x, y) == (pytest.approx(330 * 3**0.5 / 2, abs=1e-5), pytest.approx(-165, abs=1e-5))
    assert (blocks[blocks["kind"] == 0]["target_nm"][1][:2] / 1e6).tolist() == [1, 2]


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
