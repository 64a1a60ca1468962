# SPDX-License-Identifier: MIT
"""A thread's wait for the spindle's angle is planned: a run takes as long as its plan says."""

import pytest
import thread_programs

import pycnc
from pycnc.machine import Machine
from pycnc.planning import parts
from pycnc.planning.plan import Plan

LATHE = ("dialect.base=linuxcnc",)
AFTER_FACING = (  # the angle hangs on every period of the surface speed before
    "G21 G18 G90 G96 S200 D2000 M3\nG0 X100 Z5\nG1 X20 F200\nG97 S800\nG0 X24 Z5\n"
    "G33 Z-20 K1.5\nG0 X30\nM2\n"
)


@pytest.mark.sample(4, quick=1)
@pytest.mark.parametrize("family", thread_programs.FAMILIES)
def test_a_run_takes_as_long_as_planned(family):
    judged = [thread_programs.judge(family, seed) for seed in range(1, 7)]
    assert [each for each in judged if each] == []
    assert judged.count([]) >= 4  # the others' threads are too short


@pytest.mark.parametrize("slope", ["linear", "jerk"])
@pytest.mark.parametrize("tolerance", ["", " G64 P0.01"])
def test_behind_a_surface_speed_too(slope, tolerance):
    machine = Machine.load("cak6150n", set=(*LATHE, f"path.slope={slope}"))
    program = pycnc.load(AFTER_FACING.replace("G90", f"G90{tolerance}"), machine=machine)
    summary = pycnc.run(program).summary
    assert summary["time_s"] == pytest.approx(pycnc.plan(program).time_s, abs=1e-9)
    assert summary["limit_time_s"]["starved"] == 0


def test_a_plan_by_grades_takes_a_thread_for_what_it_lasts():
    machine = Machine.load("cak6150n", set=(*LATHE, "path.slope=linear"))
    text = "G21 G18 G90 G61 S800 M3\nG0 X24 Z5\nG33 Z-20 K1\nG0 X40\nM2\n"
    program = pycnc.load(text, machine=machine)
    by_grades, exact = pycnc.plan(program, plan="grades"), pycnc.plan(program)
    assert by_grades.exact_time_s == exact.time_s
    assert by_grades.time_s == pytest.approx(exact.time_s, abs=0.5 * 60 / 800 + 0.01)  # half a turn


@pytest.mark.thorough
def test_a_big_program_with_threads_is_planned_on_one_core_and_never_in_parts(monkeypatch):
    monkeypatch.setattr(parts, "PART_BLOCKS", 10)
    moves = "".join(f"G1 F3000 X{20 + k % 2 / 20}\n" for k in range(20_000))
    text = f"G21 G18 G90 G61 S800 M3\nG0 X20 Z5\n{moves}M0\nG33 Z-20 K1\nG0 X40\nM2\n"
    program = pycnc.load(text, machine=Machine.load("cak6150n", set=LATHE))
    assert program.has_threads and parts.of(program) is None
    beside = Plan(program, keep=False)
    assert beside.time_s == pycnc.run(program).summary["time_s"]
