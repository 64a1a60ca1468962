# SPDX-License-Identifier: MIT
"""Room 1: canned cycles against rs274, in the order of their blocks, and in other dialects."""

import re

import cycle_programs
import pytest
import rs274_oracle

import pycnc
from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

FREE = [f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
TOOLS = {1: 0.0, 2: 50.8}  # lengths [mm]
PECKS = 2e-5  # [mm] fifty pecks, each rounded to a nanometre
CALLS = {
    "STRAIGHT_FEED": "line", "STRAIGHT_TRAVERSE": "rapid", "DWELL": "dwell",
    "STOP_SPINDLE_TURNING": "M5", "START_SPINDLE_CLOCKWISE": "M3",
    "START_SPINDLE_COUNTERCLOCKWISE": "M4",
}  # fmt: skip


@pytest.fixture(scope="module")
def machine():
    """Return a mill with free travel and the tools of the oracle."""
    lengths = [f"tool.{number}.length_mm={length}" for number, length in TOOLS.items()]
    homes = [f"home.{code}.{axis}_mm=0" for code in ("g28", "g30") for axis in "xyz"]  # rs274's
    return Machine.load("mill3", set=FREE + homes + lengths)


@pytest.fixture
def oracle(tool, tmp_path):
    """Return the function that runs rs274 on a text; skip without rs274."""
    tool("rs274")

    def run(text):
        (tmp_path / "program.ngc").write_bytes(text)
        return rs274_oracle.run(tmp_path / "program.ngc", tmp_path, TOOLS)

    return run


def errors_of(diagnostics):
    errors = diagnostics[diagnostics["code"] < 0]
    return [(status_id(int(each["code"])), int(each["line"])) for each in errors]


@pytest.mark.sample(6)
@pytest.mark.parametrize("first", range(0, 300, 25))
def test_random_programs_equal_rs274(first, machine, oracle):
    for seed in range(first, first + 25):
        text = cycle_programs.program(seed)
        blocks, diagnostics = stages.decode(text, machine)
        assert errors_of(diagnostics) == [], f"seed {seed}"
        theirs, complaint = oracle(text)
        assert complaint == "", f"seed {seed}"
        for move in theirs:
            move.tolerance += PECKS
        theirs = rs274_oracle.drill_upright(theirs)
        ours = rs274_oracle.from_blocks(blocks, lib.NCK_COUNTS_PER_DEG)
        equal, words = rs274_oracle.difference(ours, theirs)
        assert words == "", f"seed {seed}: {words}"
        assert equal > 0.8 * len(theirs)


def test_random_programs_reach_every_word():
    text = b"".join(cycle_programs.program(seed) for seed in range(300)).decode().upper()
    words = {*re.findall(r"G\d+(?:\.\d)?", text), *re.findall("[LPQR]", text)}
    wanted = {*cycle_programs.CODES, *"LPQR", *"G17 G18 G19 G20 G21 G80 G90 G91 G98 G99".split()}
    assert wanted - words == set()


def deeds_of_blocks(blocks):
    kinds = {lib.NCK_BLOCK_RAPID: "rapid", lib.NCK_BLOCK_LINE: "line", lib.NCK_BLOCK_DWELL: "dwell"}
    for block in blocks[:-1]:
        if kind := kinds.get(block["kind"]):
            yield kind
        elif block["output"]["kind"] == lib.NCK_OUTPUT_M:
            yield f"M{block['output']['value']:.0f}"


@pytest.mark.parametrize("code", cycle_programs.CODES)
def test_dwells_and_spindle_words_stand_where_rs274_has_them(code, machine, oracle, tmp_path):
    dwell = " P0.5" if code in cycle_programs.TIMED else ""
    peck = " Q2" if code in cycle_programs.PECKED else ""
    text = f"G21 G90 G98 F600 S500 M4\nG0 Z9\n{code} X5 Z-3 R2.5{dwell}{peck}\nM2\n".encode()
    blocks, diagnostics = stages.decode(text, machine)
    assert errors_of(diagnostics) == []
    assert oracle(text)[1] == ""
    canon = (tmp_path / "canon.txt").read_text()
    theirs = [CALLS[name] for name in re.findall(r"N\.* +(\w+)\(", canon) if name in CALLS]
    assert theirs.pop() == "M5"  # of M2
    assert list(deeds_of_blocks(blocks)) == theirs


REFUSED_ALIKE = (
    "G81 X1 Z-1", "G81 X1 R1", "G82 X1 Z-1 R1", "G83 X1 Z-1 R1", "G73 X1 Z-1 R1 Q0", "G81 X1 Z2 R1",
    "G81 X1 Z-1 R1 L0", "G81 X1 Z-1 R1 P1", "G81 X1 Z-1 R1 Q1", "G81 X1 Z-1 R1\nG82 X2 P1",
    "G81 X1 Z-1 R1\nR2", "G86 X1 Z-1 R1 P1", "G93 G81 X1 Z-1 R1 F9", "G81", "G98 G99",
)  # fmt: skip


@pytest.mark.parametrize("lines", REFUSED_ALIKE)
def test_what_rs274_refuses_is_refused(lines, machine, oracle):
    text = f"G21 G90 F600\n{lines}\nM2\n".encode()
    _, diagnostics = stages.decode(text, machine)
    assert len(errors_of(diagnostics)) == 1
    assert oracle(text)[1] != ""


def test_a_row_of_holes_is_planned_and_run_alike():
    text = "G21 G90 G98 F300 S500 M3\nG0 Z20\nG83 X10 Y5 Z-12 R2 Q5\nG91 X15 L3\nG80\nM2\n"
    program = pycnc.load(text, Machine.load("mill3", set=FREE))
    assert program.diagnostics.errors == 0
    plan, trace = pycnc.plan(program), pycnc.run(program)
    assert plan.time_s == pytest.approx(trace.summary["time_s"])


def test_turning_cycles_stay_within_the_limits_of_the_lathe_and_end_where_they_begin():
    text = "G21 G18 G98 F300 S500 M3\nG0 X60 Z2\nG90 X50 Z-30\nX46 R-2\nG94 X20 Z-1\nM30\n"
    program = pycnc.load(text, Machine.load("cak6150n", set=["dialect.system=A"]))
    assert program.diagnostics.errors == 0
    targets = program.blocks["target_nm"][program.blocks["kind"] <= lib.NCK_BLOCK_LINE]
    assert (targets[[4, 8, 12]] == targets[0]).all()
    plan, trace = pycnc.plan(program), pycnc.run(program)
    assert plan.time_s == pytest.approx(trace.summary["time_s"])
    assert all(peak <= 1 + 1e-9 for axis in "xz" for peak in (
        trace.summary["peaks"][axis]["v"], trace.summary["peaks"][axis]["a"]))  # fmt: skip
