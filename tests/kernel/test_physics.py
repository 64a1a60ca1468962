# SPDX-License-Identifier: MIT
"""The physics of whole runs: own programs, random families, programs that nobody thought of; each
judged by the independent checker. And the checker judged by runs that were spoilt on purpose."""

import cases
import checker
import judged
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from judged import judge, retimed, rounded
from sampling import examples
from unthought import program_text

from pycnc import kernel
from pycnc.errors import ProgramError
from pycnc.machine import Machine
from pycnc.program import Program

CASES = {str(case): case for case in cases.CASES}
AT_REST_ALONE = {"outputs_alone"}  # one tick that hands the outputs over; nothing to plan


@pytest.fixture(params=CASES)
def case(request):
    """Return every case in turn."""
    return CASES[request.param]


# Runs keep every promise


@pytest.mark.sample(quick=16)
@pytest.mark.parametrize("load", [judged.load_exact, judged.load], ids=["linear", "shipped"])
def test_a_run_keeps_limits_path_and_stops(case, load):
    judged.run(load(case).check())


@pytest.mark.sample(40)
@pytest.mark.parametrize("prep_steps", [1, 2, 3, 7])
def test_a_starved_run_keeps_limits_path_and_stops(case, prep_steps):
    judged.run(judged.load_exact(case), prep_steps)


@pytest.mark.sample(quick=10)
@pytest.mark.parametrize("prep_steps", [2, kernel.PREP_STEPS])
def test_two_runs_give_the_same_bytes(case, prep_steps):
    program = judged.load_exact(case)
    assert judged.digest_of(program, prep_steps) == judged.digest_of(program, prep_steps)


@pytest.mark.sample(quick=8)
def test_how_many_rows_are_asked_for_makes_no_difference(case, monkeypatch):
    program = judged.load_exact(case)
    whole = judged.digest_of(program, 3)
    monkeypatch.setattr(kernel, "_TICK_ROWS", 17)
    assert judged.digest_of(program, 3) == whole


@pytest.mark.sample(quick=10)
def test_the_plan_takes_as_long_as_the_run(case):
    program = judged.load_exact(case)
    totals, segs, nodes, cells = judged.plan(program)
    rows = judged.rows_of(program)
    assert totals["ticks"] == (0 if case.name in AT_REST_ALONE else len(rows))
    assert totals["time_s"] == totals["ticks"] * program.machine.period_s
    assert (totals["segs"], totals["nodes"], totals["cells"]) == (len(segs), len(nodes), len(cells))
    assert totals["blocks"] == len(program.blocks)


def test_the_times_of_a_plan_add_up(case):
    totals = judged.plan(judged.load_exact(case))[0]
    by_kind = totals["cut_s"] + totals["rapid_s"] + totals["dwell_s"]
    by_phase = totals["accelerate_s"] + totals["cruise_s"] + totals["decelerate_s"]
    assert by_kind == pytest.approx(totals["time_s"], rel=1e-9)
    assert by_phase + totals["dwell_s"] == pytest.approx(totals["time_s"], rel=1e-9)
    assert totals["limit_s"].sum() == pytest.approx(totals["time_s"], rel=1e-9)


def test_the_length_of_a_plan_is_the_length_of_the_program(case):
    program = judged.load_exact(case)
    path = checker.Path(program.blocks, checker.Limits.of(program.machine.record))
    assert judged.plan(program)[0]["length_mm"] == pytest.approx(path.length.sum(), rel=1e-12)


@pytest.mark.sample(30)
@pytest.mark.parametrize("blocks", [2, 3, 10])
def test_a_short_window_is_slower_and_keeps_every_promise(case, blocks):
    change = (*case.set, f"path.lookahead_blocks={blocks}")
    short = cases.Case(case.name, case.text, case.machine, change)
    ticks = judged.run(judged.load_exact(short)).ticks
    assert ticks >= len(judged.rows_of(judged.load_exact(case)))


def test_starvation_is_noticed_and_costs_time():
    program = judged.load_exact(CASES["spiral"])
    fed, starved = judged.run(program), judged.run(program, prep_steps=1)
    assert fed.starved_ticks == 0
    assert starved.starved_ticks > 0
    assert starved.ticks > fed.ticks


@pytest.mark.sample(10)
@pytest.mark.parametrize("period_ms", [0.125, 0.5, 4, 10])
@pytest.mark.parametrize("name", ["star", "rotary", "random_arcs_0", "random_lines_1", "waits"])
def test_any_period_keeps_every_promise(name, period_ms):
    case = CASES[name]
    change = (*case.set, f"kernel.period_ms={period_ms}")
    judged.run(judged.load_exact(cases.Case(name, case.text, case.machine, change)))


def test_everything_before_an_error_is_executed_and_nothing_after():
    text = b"G21 G90 G94 G17\nG1 X10 F600\nX20\nG1 QQ\nX30\nM2\n"
    program = Program(text, Machine.load("mill3", set=judged.LINEAR_EXACT))
    good = program.blocks["line"] < 4
    judge = checker.Checker(program.blocks[good], program.machine.record)
    controller = kernel.Simulation(program.text, program.machine)
    with pytest.raises(ProgramError, match="number"):
        for rows, _ in controller.pieces():
            judge.add(rows)
    judge.finish()


# Programs that nobody thought of
@pytest.mark.thorough

@examples(250)
@given(program_text, st.sampled_from((1, 2, 3, 5, 11, 256)))
def test_any_program_keeps_every_promise(text, prep_steps):
    free = ("axis.z.max_mm=free", "axis.z.min_mm=free")
    machine = Machine.load("mill3", set=(*judged.LINEAR_EXACT, *free))
    program = Program(text.encode(), machine)
    if not program.diagnostics.errors:  # arcs and steps may leave the travel
        judged.run(program, prep_steps)


# The checker finds what is spoilt


@pytest.fixture(scope="module")
def sound():
    """Return a program with stops and arcs, and its rows."""
    moves = "G1 X10 F3000\nG9 X20\nG3 X20 Y10 J5\nG4 P0.05\nG1 X0\nY0.0005\nY0.001\nM2\n"
    program = Program((cases.HEAD + moves).encode(), Machine.load("mill3", set=judged.LINEAR_EXACT))
    return program, judged.rows_of(program)


def off_the_path(rows):
    rows["pose"]["axis"][:, 2] += 2e-6 * np.sin(np.linspace(0, np.pi, len(rows))) ** 2
    return rounded(rows)


def one_nanometre_short(rows):
    rows["axes"]["joint_nm"][-1, 1] -= 1
    return rows


def a_tick_lost(rows):
    return retimed(np.delete(rows, len(rows) // 3))


def twice_as_fast(rows):
    return retimed(rows[1::2].copy())


def an_end_missing(rows):
    return rows[:-3]


def a_block_missing(rows):
    return retimed(rows[rows["pose"]["block"] != rows["pose"]["block"].max() - 2].copy())


def a_dwell_too_short(rows):
    dwelling = np.flatnonzero(rows["pose"]["state"] == 2)
    return retimed(np.delete(rows, dwelling[:1]))


def a_step_back(rows):
    k = len(rows) // 3
    rows["pose"]["axis"][[k, k + 1]] = rows["pose"]["axis"][[k + 1, k]]
    return rounded(rows)


def a_stop_rounded_off(rows):
    last = np.flatnonzero(np.diff(rows["pose"]["block"]) > 0)[1]
    rows["pose"]["axis"][last, 0] -= 2e-9
    rows["axes"]["joint_nm"][last, 0] -= 1
    return rows


def a_clock_that_drifts(rows):
    rows["t_s"] *= 1 + 1e-12
    return rows


def the_earlier_block(rows):
    k = np.flatnonzero(rows["pose"]["block"] == rows["pose"]["block"].max() - 1)[0]
    rows["pose"]["block"][k] -= 4
    return rows


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (off_the_path, "off the path"),
        (one_nanometre_short, "rounded pose|end"),
        (a_tick_lost, "acceleration|feed"),
        (twice_as_fast, "acceleration|feed|exact stop"),
        (an_end_missing, "end|left out|acceleration"),
        (a_block_missing, "speed|acceleration|exact stop"),
        (a_dwell_too_short, "dwells"),
        (a_step_back, "acceleration|backward|back"),
        (a_stop_rounded_off, "exact stop|rounded"),
        (a_clock_that_drifts, "time"),
        (the_earlier_block, "earlier block|off the path"),
    ],
)
def test_the_checker_finds_a_spoilt_run(sound, spoil, words):
    program, rows = sound
    judge(program, rows)
    with pytest.raises(checker.PhysicsError, match=words):
        judge(program, spoil(rows.copy()))
