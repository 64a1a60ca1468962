# SPDX-License-Identifier: MIT
"""``pycnc time``: what takes time that no axis makes, parts of the time, several files."""

import json
import random
import re

import pytest
from command_line import pycnc

from pycnc import errors, load, run
from pycnc.machine import Machine
from pycnc.planning.plan import Plan
from pycnc.report.trace import Trace

PROGRAM = b"""%
(side one)
G21 G90 G17 T1 M6
S5000 M3
M3
G0 X10 Y2
G1 Z-1 F300
X30 F600 (a cut, not a section)
; side two
N90 M5
T2 M6 S3000 M4
G1 X0 F900
M3
X5 G4 P0.25
( side one )
G0 X0 Y0 Z5
M2
"""
MACHINE = Machine.load("mill3", set={"times.tool_change_s": 7, "times.spindle_start_s": 1.5})


def parts(by, program=PROGRAM, machine=MACHINE):
    planned = Plan(load(program, machine=machine), keep=False, by=by)
    return planned, {part["name"]: part for part in planned.parts}


def test_tools_and_spindle_take_the_time_that_the_machine_file_says():
    told = Plan(load(PROGRAM, machine=MACHINE), keep=False).totals
    assert (told["tool_changes"], told["spindle_starts"]) == (2, 3), "on, other way, and back"
    assert (told["tool_change_s"], told["spindle_s"]) == (14, 4.5)
    assert told["total_s"] == pytest.approx(told["time_s"] + 18.5)
    plain = Plan(load(PROGRAM, machine=Machine.load(MACHINE, set={"times.tool_change_s": 0})))
    assert plain.time_s == told["time_s"], "no tick is made for them"


def test_a_run_tells_the_same_total_as_the_plan():
    text = PROGRAM.replace(b"T2 M6", b"T2")  # a run is some ticks later behind a change of tool
    told = run(text, machine=MACHINE).summary
    planned = Plan(load(text, machine=MACHINE), keep=False).totals
    assert planned["total_s"] > planned["time_s"] + 11
    assert (told["time_s"], told["total_s"]) == (planned["time_s"], planned["total_s"])


@pytest.mark.parametrize(
    "text",
    ["M2\n", "M3 S100\nM30\n", "M3 S9\nM0\nM8\nM30\n", "G1 X1 F600\nM5\nM9\nM30\n", "T1 M6\nM2\n"],
)
def test_what_only_hands_over_takes_no_tick_in_a_run_either(text):
    made = run(text)
    assert made.summary["time_s"] == Plan(load(text), keep=False).time_s
    assert made.summary["ticks"] == len(made) == round(made.summary["time_s"] * 1000)
    assert made.summary["end"] == "done"


@pytest.mark.parametrize("ending", ["npz", "csv", "parquet"])
def test_a_run_without_a_tick_is_a_trace_without_a_row(ending, tmp_path):
    made, file = run("M3 S9\nM2\n"), tmp_path / f"run.{ending}"
    getattr(made, f"to_{ending}")(file)
    read = Trace.load(file)
    assert list(read.columns) == list(made.columns)
    assert len(read) == len(made) == 0


def test_a_turret_changes_its_tool_by_t_alone():
    text = b"G21 G18 G98\nT1\nG0 X100 Z10\nG1 Z0 F200\nT1\nT3\nG1 Z-5\nM30\n"
    planned, found = parts("tool", text, Machine.load("cak6150n"))
    assert planned.totals["tool_changes"] == len(found) == 2


@pytest.mark.parametrize("by", ["tool", "section", "line"])
def test_parts_add_up_to_the_whole_and_the_longest_comes_first(by):
    planned, found = parts(by)
    for name in ("cut_s", "rapid_s", "dwell_s", "tool_change_s", "spindle_s"):
        total = sum(part[name] for part in found.values())
        assert total == pytest.approx(planned.totals[name], abs=1e-9), name
    times = [part["time_s"] for part in planned.parts]
    assert times == sorted(times, reverse=True)
    assert sum(times) == pytest.approx(planned.totals["total_s"], abs=1e-9)


def test_a_section_begins_at_a_comment_of_its_own_line():
    _, found = parts("section")
    assert set(found) == {"side one", "side two"}
    assert found["side two"]["dwell_s"] == pytest.approx(0.25, abs=0.01)
    assert (found["side one"]["line"], found["side two"]["line"]) == (3, 11)
    assert found["side one"]["rapid_s"] > 0, "the second one of this name, too"


def test_tools_have_what_is_done_under_them():
    planned, found = parts("tool")
    assert set(found) == {"T1", "T2"}
    assert found["T1"]["cut_s"] > 2 > found["T2"]["dwell_s"] > 0.25
    before = b"G1 X1 F100\n" + PROGRAM.replace(b"%\n", b"")
    assert "no tool" in parts("tool", before)[1]


def test_a_line_has_its_text():
    _, found = parts("line")
    assert found["X30 F600 (a cut, not a section)"]["cut_s"] == pytest.approx(2, abs=0.1)
    assert found["T2 M6 S3000 M4"]["tool_change_s"] == 7


def test_a_segment_that_shares_cells_with_others_gets_its_own_time():
    steps = 400
    text = "G21 G90 G61\n" + "".join(f"G1 X{k * 0.05:.3f} F600\n" for k in range(1, steps + 1))
    planned = Plan(load(text + "M2\n"), keep=False, by="line")
    times = [part["time_s"] for part in planned.parts]
    assert len(times) == steps
    assert times[steps // 2] == pytest.approx(0.005, rel=1e-6), "0.05 mm at 10 mm/s"


def test_the_rest_of_a_tool_change_is_not_told_as_a_dwell_alone(tmp_path):
    file = tmp_path / "part.ngc"
    file.write_text("G21 G90 G1 X10 F600\nT1 M6\nX0\nM2\n")
    for verb in ("time", "run"):
        assert re.search(r"dwells and waits +0\.001 s", pycnc(verb, file).out)


def test_parts_are_told_as_a_table_with_units(tmp_path):
    file = tmp_path / "part.ngc"
    file.write_bytes(PROGRAM)
    result = pycnc("time", file, "--by", "tool")
    head, columns, *rows = result.out.splitlines()
    assert re.search(r"tool changes 16\.00 s, spindle starts 6\.000 s; speeding up", head)
    assert columns.split() == ["time", "share", "cut", "rapid", "dwells", "and", "waits",
                               "tool", "changes", "spindle", "starts", "line", "tool"]  # fmt: skip
    assert [row.split()[-1] for row in rows] == ["T2", "T1"]
    assert all(" s " in row for row in rows)
    told = json.loads(pycnc("time", file, "--by", "section", "--json").out)
    assert {part["name"] for part in told["parts"]} == {"side one", "side two"}


@pytest.mark.parametrize("length, shown", [(60, "n" * 60), (61, "n" * 59 + "…")])
def test_a_name_of_more_than_60_letters_is_cut(length, shown):
    program = b"G21 G90 F600\n(" + b"n" * length + b")\nG1 X1\nM2\n"
    assert f"  {shown}\n" in pycnc("time", "-", "--by", "section", stdin=program).out


def test_several_files_have_a_total_and_jobs_change_nothing_but_the_clock(tmp_path):
    for name in ("a.ngc", "b.ngc"):
        (tmp_path / name).write_bytes(PROGRAM)
    files = tmp_path / "a.ngc", tmp_path / "missing.ngc", tmp_path / "b.ngc"
    one, two = (pycnc("time", *files, "--jobs", jobs) for jobs in (1, 2))
    assert one == two
    assert one.code == 2
    *lines, total = one.out.splitlines()
    assert len(lines) == 2
    assert total.startswith("total of 2 files (1 without a time): ")
    both = [json.loads(pycnc("time", "--json", file).out)["total_s"] for file in files[::2]]
    assert f"{sum(both):.2f} s (cut" in total


@pytest.mark.parametrize("by", ["tool", "section", "line"])
def test_a_program_without_time_has_no_parts(by):
    assert pycnc("time", "-q", "-", "--by", by, stdin=b"M2\n").code == 0
    assert json.loads(pycnc("time", "--json", "-", "--by", by, stdin=b"M2\n").out)["parts"] == []
    assert "parts" not in json.loads(pycnc("time", "--json", "-", stdin=b"M2\n").out)
    assert pycnc("why", "-", "--what-if", stdin=b"M2\n").code == 0


def test_grades_are_not_told_by_parts():
    result = pycnc("lab", "time", "-", "--plan", "grades", "--by", "tool", stdin=PROGRAM)
    assert result.code == 2
    assert "grades" in result.err
    with pytest.raises(errors.ArgumentError, match="no parts by 'colour'"):
        Plan(load(PROGRAM), by="colour")


@pytest.mark.parametrize("value", ["-1", "nan", "4000", '"long"'])
def test_times_have_their_range(value):
    result = pycnc("time", "-", "--set", f"times.tool_change_s={value}", stdin=PROGRAM)
    assert result.code == 2
    assert "times.tool_change_s" in result.err


def test_what_nearly_all_programs_leave_to_the_control_is_told_when_asked(tmp_path):
    file = tmp_path / "arc.ngc"
    file.write_text("G21 G90 F100\nG2 X10 I5\nM2\n")
    for verb in ("check", "time"):
        assert "assumed-" not in "".join((run := pycnc(verb, file)).out + run.err)
    told = pycnc("check", file, "-v").out
    assert "note[assumed-centre]" in told and "note[assumed-plane]" in told


@pytest.mark.sample(6, quick=2)
@pytest.mark.parametrize("machine", ["mill3", "router", "printer_marlin", "printer_klipper"])
@pytest.mark.parametrize("number", range(3))
def test_what_is_left_behind_the_last_line_is_one_error(number, machine, draw_seed):
    pen = random.Random(draw_seed + number)
    moves = [f"G1 X{pen.randrange(1, 90)} F900" for _ in range(pen.randrange(1, 6))]
    end = "M2" if machine in ("mill3", "router") else "G4 P10"
    rows = ["G21 G90", *moves, end]
    behind = [] if end != "M2" else ["", "G1 X1"][: pen.randrange(3)]
    text = "\n".join([*rows, *behind, ""]).encode()
    for line in range(1, len(rows) + 5):
        told = pycnc("time", "-", "-m", machine, "--left", line, stdin=text)
        assert told.code == 2 * (line > len(rows)), told
        if told.code:
            assert told.err.count("error[left]") == 1 and f"ends at line {len(rows)}" in told.err
