# SPDX-License-Identifier: MIT
"""Real programs: every file of the corpus runs to its end under the checker's eyes, or ends with
the diagnostic that the table in cases.py names."""

import functools

import cases
import judged
import numpy as np
import pytest
from sampling import cheap_first

from pycnc import kernel
from pycnc.errors import ProgramError
from pycnc.kernel import Simulation
from pycnc.kernel.bind import lib
from pycnc.machine import Machine
from pycnc.planning.plan import Plan, plan
from pycnc.program import Program
from pycnc.report.trace import Trace

FILES = {str(file): file for file in cases.CORPUS_FILES}
RUNNING = {str(file): file for file in cases.RUNNING_FILES}
# 17 and 4 million ticks: run once, and not measured a second time
SLOW = {"ax4_rotation_51k.nc", "print_cura_bp_case_56k.gcode"}
STARVED = 1  # prep step a tick: too few for moves of less than a period


def present(file):
    """Return the file of the corpus, or skip the test."""
    if not file.path.exists():
        pytest.skip(f"{file.path} is not here: the corpus lies beside the repository")
    return file


@functools.cache
def program_of(name):
    """Return a file as a program for the linear slope, on the exact path."""
    return judged.load_exact(present(FILES[name]))


@functools.cache
def run_of(name):
    """Return the run of a file, judged once for all tests."""
    return judged.run(program_of(name))


def short(names):
    """Return the names of the files that are not slow; a quick run has none of the dear ones."""
    return cheap_first([n for n in names if FILES[n].file not in SLOW], cases.DEAR_FILES)


def whole(names):
    """Return the same names, and of slow files those that the campaign alone has."""
    slow = [pytest.param(n, marks=pytest.mark.campaign) for n in names if FILES[n].file in SLOW]
    return short(names) + slow


def test_the_table_names_every_file_of_the_corpus():
    if not cases.CORPUS.exists():
        pytest.skip(f"{cases.CORPUS} is not here")
    folders = cases.CORPUS, cases.SHARED_PROGRAMS
    there = {path for folder in folders for path in folder.iterdir()}
    programs = {path for path in there if path.suffix not in (".tsv", ".py")}
    assert {file.path for file in cases.CORPUS_FILES} == programs


@pytest.mark.parametrize("name", FILES)
def test_a_file_ends_as_the_table_says(name):
    file, program = FILES[name], program_of(name)
    errors = [(each.id, each.line) for each in program.diagnostics if each.severity == "error"]
    assert (errors[0] if errors else None) == file.ends
    if file.ends:
        with pytest.raises(ProgramError) as caught:
            plan(program)
        assert (caught.value.id, caught.value.line) == file.ends


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", whole(RUNNING))
def test_a_run_keeps_limits_path_and_stops(name):
    run = run_of(name)
    assert run.starved_ticks == 0
    assert run.judge.path_error_mm <= 1e-6


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", whole(RUNNING))
def test_the_plan_takes_as_long_as_the_run(name):
    ticks = run_of(name).ticks
    assert plan(program_of(name)).time_s == ticks * program_of(name).machine.period_s


@pytest.mark.sample(4)
@pytest.mark.thorough
@pytest.mark.parametrize("name", short(RUNNING))
def test_two_runs_give_the_same_bytes(name):
    assert judged.digest_of(program_of(name)) == run_of(name).digest


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", short(RUNNING))
def test_the_summary_tells_what_the_checker_found(name):
    summary, run = Trace(program_of(name), keep=False).summary, run_of(name)
    assert summary["ticks"] == run.ticks
    assert summary["path_error_mm"] <= 1e-6
    for axis, peaks in summary["peaks"].items():
        assert peaks["a"] <= 1 + 1e-6
        assert peaks.get("v", 0) <= 1 + 1e-6
        if axis != "path":
            column = "xyzabcuvw".index(axis)
            assert peaks["a"] == pytest.approx(run.judge.a[column], rel=1e-9)
            assert peaks["v"] == pytest.approx(run.judge.v[column], rel=1e-9)


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", short(RUNNING))
def test_a_starved_run_keeps_limits_path_and_stops(name):
    starved = judged.run(program_of(name), STARVED)
    assert starved.ticks >= run_of(name).ticks


@pytest.mark.sample(quick=2)
@pytest.mark.parametrize("name", [str(file) for file in cases.THREAD_FILES])
def test_a_file_with_threads_runs_to_its_end(name):
    file = present(FILES[name])
    program = judged.load(file)
    simulation = kernel.Simulation(program.text, program.machine, 4)
    pose = np.concatenate([rows["pose"].copy() for rows, _ in simulation.pieces()])
    assert (simulation.end, simulation.thread_lost) == ("done", False)
    assert (pose["kind"] >= lib.NCK_SEG_THREAD).any()


# The machines as they are shipped: jerk-limited, within their tolerance

LONG = SLOW | {"surf_la_peinture_180k.gc", "mill_fusion_grbl_helix.nc"}  # minutes of ticks


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", [name for name in RUNNING if FILES[name].file not in LONG])
def test_a_plan_of_a_shipped_machine_takes_as_long_as_the_run(name):
    program = judged.load(present(FILES[name]))
    ticks = sum(len(rows) for rows, _ in Simulation(program.text, program.machine).pieces())
    assert Plan(program, keep=False).time_s == ticks * program.machine.period_s


SHORT = ("arcs_rword.gcode", "mill_fanuc_g17_18_19.nc", "tp_trochoidal.ngc", "tp_zigzag.ngc")


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", [name for name in RUNNING if FILES[name].file in SHORT])
def test_a_shipped_machine_keeps_every_limit_and_its_tolerance(name):
    program = judged.load(present(FILES[name]))
    judge = judged.run(program).judge
    assert program.machine.settings.path.slope == "optimal"
    assert judge.tolerance_used <= 1
    assert judge.j.max() <= 1 + 1e-6


# The jerk-limited slope, on the beginning of every file

LINES = 400  # read of a file: enough for arcs, corners and micro-segments
HOUR = "mill_fanuc_g81_g91.nc"  # of feed: 4 million ticks, the next file has 700 000
JERK_QUICK = [
    *cheap_first([
        name for name in RUNNING if FILES[name].file not in
        SLOW | {HOUR, "tp_random_lines_0.001in.ngc", "odd_no_spaces.gcode"}
    ], cases.DEAR_FILES),
    *(pytest.param(name, marks=pytest.mark.campaign) for name in RUNNING
      if FILES[name].file == HOUR),
]  # fmt: skip


def beginning_of(name, mode):
    """Return the first lines of a file as a program, in a path mode of its own."""
    file = present(FILES[name])
    lines = [line for line in file.path.read_bytes().split(b"\n")[:LINES] if line.strip() != b"%"]
    text = b"\n".join([mode.encode(), *lines, b"M2", b""]).replace(b"G61", b"").replace(b"G64", b"")
    text = mode.encode() + b"\n" + text.partition(b"\n")[2]
    machine = Machine.load(file.machine, set=(*file.set, "path.slope=jerk"))
    if machine.settings.dialect.base != "linuxcnc" and mode.startswith("G64"):  # P is LinuxCNC's
        change = f"path.tolerance_mm={mode.partition('P')[2]}"
        machine = Machine.load(file.machine, set=(*file.set, "path.slope=jerk", change))
        text = text.replace(mode.encode(), b"G64", 1)
    return Program(text, machine, file=name).check()


@pytest.mark.sample(6)
@pytest.mark.parametrize("name", JERK_QUICK)
def test_on_the_exact_path_the_path_keeps_its_jerk(name):
    judge = judged.run(beginning_of(name, "G61")).judge
    assert judge.path_j <= 1 + 1e-6
    assert judge.path_error_mm <= 1e-6


@pytest.mark.sample(6)
@pytest.mark.parametrize("name", JERK_QUICK)
def test_within_a_tolerance_every_axis_keeps_its_jerk(name):
    judge = judged.run(beginning_of(name, "G64 P0.01")).judge
    assert judge.j.max() <= 1 + 1e-6
    assert judge.path_j <= 1 + 1e-6
    assert judge.tolerance_used <= 1 + 1e-6
