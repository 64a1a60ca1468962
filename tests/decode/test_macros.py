# SPDX-License-Identifier: MIT
"""Room 1: expressions, parameters, O words and subprograms against rs274."""

import macro_programs
import pytest
import rs274_oracle
from cases import CORPUS

import pycnc
from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

FREE = [f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
READ_BACK = 4e-6  # [mm] positions that a program reads are rounded to nanometres, again and again


@pytest.fixture(scope="module")
def machine():
    """Return a mill with free travel."""
    return Machine.load("mill3", set=FREE)


def errors_of(diagnostics):
    errors = diagnostics[diagnostics["code"] < 0]
    return [(status_id(int(each["code"])), int(each["line"])) for each in errors]


@pytest.mark.sample(6)
@pytest.mark.parametrize("first", range(0, 300, 25))
def test_random_programs_equal_rs274(first, machine, tool, tmp_path):
    tool("rs274")
    for seed in range(first, first + 25):
        text = macro_programs.program(seed)
        blocks, diagnostics = stages.decode(text, machine)
        assert errors_of(diagnostics) == [], f"seed {seed}"
        (tmp_path / "program.ngc").write_bytes(text)
        theirs, complaint = rs274_oracle.run(tmp_path / "program.ngc", tmp_path, {})
        assert "error" not in complaint.lower(), f"seed {seed}: {complaint}"
        for move in theirs:
            move.tolerance += READ_BACK
        ours = rs274_oracle.from_blocks(blocks, lib.NCK_COUNTS_PER_DEG)
        equal, words = rs274_oracle.difference(ours, theirs)
        assert words == "", f"seed {seed}: {words}"
        assert equal > 0.9 * len(theirs)


def test_random_programs_reach_every_word():
    text = b"".join(macro_programs.program(seed) for seed in range(300)).upper()
    words = "SUB ENDSUB CALL RETURN IF ELSEIF ELSE ENDIF WHILE ENDWHILE DO REPEAT ENDREPEAT".split()
    words += ["BREAK", "CONTINUE", *macro_programs.UNARY, *macro_programs.WHOLE, "ATAN", "LN"]
    assert [word for word in words if word.encode() not in text] == []


def test_the_parameters_of_fanuc_calls_are_shared_and_those_of_o_words_are_not():
    file = CORPUS / "mill_fanuc_m98_vars.ngc"
    if not file.exists():
        pytest.skip(f"no corpus file {file}")
    text = file.read_bytes()
    for call, wanted in ((b"M98 P1", 13.01), (b"O2 call", 42.01)):
        line = call + b"\nG21 G90 G0 X#1 Z[#31-40]\nM30"
        program = pycnc.load(text.replace(call, line, 1), set_free())
        assert program.diagnostics.errors == 0
        assert program.blocks["target_nm"][0, 0] == round(wanted * 1e6)
        assert program.blocks["target_nm"][0, 2] == round((13.31 - 40) * 1e6)


def set_free():
    return Machine.load("mill3", set=FREE)


def test_an_error_says_the_calls_in_force():
    text = "G21 G90\nO1 sub\nO2 call [#1]\nO1 endsub\nO2 sub\nG0 X[1/#1]\nO2 endsub\nO1 call [0]\n"
    program = pycnc.load(text)
    found = [(each.id, each.line) for each in program.diagnostics if each.severity != "note"]
    calls = [each.line for each in program.diagnostics if each.id == "called-from"]
    assert found == [("value", 6)] and calls == [3, 8]


def test_a_program_with_calls_runs_and_is_planned_alike():
    text = "G21 G90 F600\nO1 sub\nG1 X[#1] Y[#1/2]\nO1 endsub\nO2 repeat [3]\nO1 call [5]\n" \
        "O1 call [0]\nO2 endrepeat\nM2\n"
    program = pycnc.load(text)
    plan, trace = pycnc.plan(program), pycnc.run(program)
    assert len(program.blocks) == 7
    assert plan.time_s == pytest.approx(trace.summary["time_s"])
