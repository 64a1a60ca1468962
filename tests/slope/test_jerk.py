# SPDX-License-Identifier: MIT
"""Whole runs under the slopes that limit jerk, judged by the independent checker: on the exact path
and within a tolerance (optimal), with late preparation, and with an operator who does what he
likes. And the checker judged by runs that were spoilt on purpose."""

import cases
import checker
import judged
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from judged import judge, retimed, rounded
from programmed_path import DWELL
from sampling import examples
from unthought import program_text

import pycnc
from pycnc import kernel
from pycnc.errors import ArgumentError
from pycnc.machine import Machine
from pycnc.program import Program

TOLERANCE = "G64 P0.01"
CASES = {str(case): case for case in cases.CASES}
SQUARE = "G21 G17 G90 G61 G94\nG1 X50 F3000\nG1 Y50\nG3 X100 Y100 I50 J0\nG0 X0\nM2\n"


def jerk_limited(case, mode=None):
    """Return the decoded program of a case, under a limit of jerk; mode: within a tolerance."""
    text = case.text if mode is None else case.text.replace("G61\n", f"{mode}\n", 1)
    text = text if mode is None else text.replace("G94 G61 ", f"G94 {mode} ", 1)
    slope = "jerk" if mode is None else "optimal"
    change = (*case.set, f"path.slope={slope}", "path.tolerance_mm=0")
    return judged.load(cases.Case(case.name, text, case.machine, change)).check()


@pytest.fixture(params=CASES)
def case(request):
    """Return every case in turn."""
    return CASES[request.param]


# Runs keep every promise


@pytest.mark.sample(quick=6)
def test_a_run_keeps_jerk_and_all_other_limits_on_the_exact_path(case):
    run = judged.run(jerk_limited(case))
    assert run.judge.path_error_mm <= 1e-6
    assert run.judge.path_j <= 1 + 1e-6


@pytest.mark.sample(quick=6)
def test_within_a_tolerance_every_axis_keeps_its_jerk(case):
    run = judged.run(jerk_limited(case, TOLERANCE))
    assert run.judge.path_error_mm <= 0.01 * (1 + 1e-6)
    assert run.judge.j.max() <= 1 + 1e-6


@pytest.mark.sample(30)
@pytest.mark.parametrize(("blocks", "mode"), [(2, None), (20, None), (3, TOLERANCE)])
def test_a_short_window_comes_to_the_end_and_keeps_every_promise(case, blocks, mode):
    change = (*case.set, f"path.lookahead_blocks={blocks}")
    run = judged.run(jerk_limited(cases.Case(case.name, case.text, case.machine, change), mode))
    assert run.starved_ticks == 0


@pytest.mark.sample(40, quick=6)
@pytest.mark.parametrize("prep_steps", [1, 5])
@pytest.mark.parametrize("mode", [None, TOLERANCE])
def test_a_starved_run_keeps_every_promise(case, mode, prep_steps):
    judged.run(jerk_limited(case, mode), prep_steps)


@pytest.mark.sample(quick=8)
@pytest.mark.parametrize("mode", [None, TOLERANCE])
def test_the_plan_takes_as_long_as_the_run_but_for_a_tick_at_a_dwell(case, mode):
    program = jerk_limited(case, mode)
    planned = int(judged.plan(program)[0]["ticks"])
    longer = len(judged.rows_of(program)) - planned
    dwells = int(np.count_nonzero(program.blocks["kind"] == DWELL))
    assert 0 <= longer <= max(dwells, case.name == "outputs_alone")


@pytest.mark.parametrize("name", ["star", "spiral", "random_smooth_1", "random_lines_0"])
def test_a_looser_tolerance_is_not_slower(name):
    text = CASES[name].text
    ticks = [
        len(judged.rows_of(jerk_limited(CASES[name], f"G64 P{tolerance}")))
        for tolerance in (0.005, 0.01, 0.02, 0.05)
    ]
    assert "G61" in text
    assert all(looser <= 1.013 * tighter for tighter, looser in zip(ticks, ticks[1:], strict=False))


@pytest.mark.parametrize("name", ["star", "random_smooth_1", "random_arcs_0"])
def test_two_runs_give_the_same_bytes(name):
    program = jerk_limited(CASES[name], TOLERANCE)
    assert judged.digest_of(program) == judged.digest_of(program)


@examples(60)
@given(program_text, st.sampled_from((1, 3, 256)), st.sampled_from(("G61", TOLERANCE)))
def test_any_program_keeps_every_promise(text, prep_steps, mode):
    slope = "jerk" if mode == "G61" else "optimal"
    free = ["axis.z.max_mm=free", "axis.z.min_mm=free", f"path.slope={slope}"]
    machine = Machine.load("mill3", set=free)
    program = Program(f"{mode}\n{text}".encode(), machine)
    if not program.diagnostics.errors:
        judged.run(program, prep_steps)


# The operator


def traced(commands, text=SQUARE, **options):
    """Return the trace of a run on mill3 with the jerk-limited slope."""
    return pycnc.run(text, slope="jerk", commands=commands, **options)


def test_a_hold_rests_on_the_path_and_resume_goes_on_to_the_end():
    free, held = traced([]), traced([(200, "hold"), (1000, "resume")])
    assert held["pos_x_mm"][-1] == free["pos_x_mm"][-1]
    assert (np.diff(held["s_mm"][600:1000]) == 0).all()
    assert held.summary["ticks"] == pytest.approx(free.summary["ticks"] + 800, abs=150)


def test_the_stopping_distance_is_that_of_the_jerk_limited_brake():
    v, a, j, answer_s = 50.0, 2500.0, 50000.0, 0.03
    ramp_s = 2 * np.sqrt(v / j) if v < a * a / j else v / a + a / j
    trace = traced([(400, "hold")])
    assert trace["s_mm"][-1] - trace["s_mm"][399] <= v * (answer_s + ramp_s / 2) * 1.05


@pytest.mark.parametrize(("percent", "factor"), [(50, 0.5), (150, 1.5), (25, 0.25)])
def test_an_override_scales_the_feed(percent, factor):
    trace = traced([(0, "override", percent)])
    cutting = trace["kind"] != 1
    assert trace["vel_mm_s"][cutting].max() == pytest.approx(50 * factor, rel=0.02)
    assert set(trace["override"][cutting].tolist()) == {factor}


def test_a_raised_override_is_answered_while_the_path_moves():
    trace = traced([(400, "override", 150)])
    assert trace["vel_mm_s"][399] == pytest.approx(50)
    assert trace["vel_mm_s"][600] == pytest.approx(75, rel=0.01)


def test_rapids_have_an_override_of_their_own():
    slow, fast = traced([(0, "override", 100, 10)]), traced([])
    rapid = slow["kind"] == 1
    assert slow["vel_mm_s"][rapid].max() <= 0.11 * fast["vel_mm_s"][fast["kind"] == 1].max()


def test_a_single_block_stops_at_the_end_of_every_block():
    trace = traced([(0, "single_block", 1), (3000, "resume"), (6000, "resume")])
    ends = [(50, 0), (50, 50), (100, 100)]
    for tick, (x, y) in zip((2999, 5999, len(trace) - 1), ends, strict=True):
        assert trace["pos_x_mm"][tick] == pytest.approx(x, abs=1e-9)
        assert trace["pos_y_mm"][tick] == pytest.approx(y, abs=1e-9)


BLOCKS = "G21 G17 G90 G61 G94\nG1 X60 F3000\nG1 Y20\nM2\n"
SINGLE = (0, "single_block", 1)  # at tick 500 the plan rests at X60 already


@pytest.mark.parametrize("command", ["hold", "abort"])
def test_a_hold_and_an_abort_behind_single_block_rest_as_soon_as_without_it(command):
    alone, behind = (traced([*first, (500, command)], BLOCKS) for first in ((), (SINGLE,)))
    braked = np.flatnonzero(np.diff(behind["s_mm"][499:]) < 0.05 * (1 - 1e-9))[0]
    assert braked <= 10
    assert behind["s_mm"][-1] == pytest.approx(alone["s_mm"][-1], abs=0.05)
    assert behind["s_mm"][-1] < 30


def test_a_resume_behind_single_block_goes_on_to_the_end_of_the_block():
    program = Program(BLOCKS.encode(), Machine.load("mill3", set=["path.slope=jerk"]))
    held = [SINGLE, (500, "hold"), (900, "resume")]
    judged.run(program, commands=held)
    assert traced(held, BLOCKS)["s_mm"][-1] == 60
    assert traced([*held, (3000, "resume")], BLOCKS)["s_mm"][-1] == 80


@pytest.mark.parametrize("percent", [20, 50, 99, 120, 200])
def test_an_override_behind_single_block_is_met_and_the_end_of_the_block_kept(percent):
    program = Program(BLOCKS.encode(), Machine.load("mill3", set=["path.slope=jerk"]))
    commands = [SINGLE, (500, "override", percent, 100)]
    judged.run(program, commands=commands)
    trace = traced(commands, BLOCKS)
    assert trace["vel_mm_s"][750] == pytest.approx(0.5 * percent, rel=1e-3)
    assert trace["s_mm"][-1] == 60


@pytest.mark.parametrize("tick", [500, 1180, 1240])
def test_single_block_switched_off_on_the_way_goes_on_without_a_resume(tick):
    trace = traced([SINGLE, (tick, "single_block", 0)], BLOCKS)
    assert trace["s_mm"][tick] < 60
    assert trace["s_mm"][-1] == 80


def test_an_abort_rests_and_drops_the_rest():
    trace = traced([(300, "abort"), (900, "resume")])
    assert 0 < trace["pos_x_mm"][-1] < 50
    assert trace.summary["ticks"] < 600


@pytest.mark.parametrize(
    ("command", "words"),
    [
        ((3, "fly"), "no command 'fly'"),
        ((3, "override", 201), "0 … 200 and 0 … 100"),
        ((3, "override"), "0 … 200"),
        ((-1, "hold"), "from 0 on"),
        ((3, "hold", 1), "no number"),
    ],
)
def test_a_command_that_is_none_is_refused(command, words):
    with pytest.raises(ArgumentError, match=words):
        traced([command])


@pytest.mark.parametrize("rest", ["M0", "G4 P0.01"])
@pytest.mark.parametrize("tick", [460, 470])
def test_a_rest_that_a_late_override_plans_anew_is_kept(rest, tick):
    head = "G17 G21 G90 G94 G64 P1 F5607\nG0 X-3.8533 Y-5.913\nX-19.0223 Y19.2605\n"
    text = f"{head}{rest}\nG1 Y0\nM2\n"
    slow_y = ("axis.y.a_max_mm_s2=500", "path.slope=jerk")
    program = judged.load(cases.Case("late", text, set=slow_y))
    judged.run(program, commands=[(tick, "override", 176, 40)])


SCRIPT = st.lists(
    st.one_of(
        st.tuples(st.integers(0, 4000), st.sampled_from(("hold", "resume", "resume"))),
        st.tuples(
            st.integers(0, 4000), st.just("override"), st.integers(10, 200), st.integers(10, 100)
        ),
        st.tuples(st.integers(0, 4000), st.just("single_block"), st.integers(0, 1)),
        st.tuples(st.integers(500, 9000), st.just("abort")),
    ),
    max_size=8,
)


@pytest.mark.thorough
@examples(120)
@given(
    st.sampled_from(("square", "star", "random_arcs_0", "random_smooth_1", "reversals")),
    st.sampled_from((2, 7, kernel.PREP_STEPS)), SCRIPT,
)  # fmt: skip
def test_whatever_the_operator_does_limits_and_path_are_kept(name, prep_steps, script):
    judged.run(jerk_limited(CASES[name]), prep_steps, script, answer=np.inf)


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("prep_steps", (1, 2, 3, 7))
def test_a_resume_on_the_way_to_a_rest_goes_on_when_prep_has_made_its_plan(prep_steps):
    program = jerk_limited(CASES["random_arcs_0"])
    alone = judged.run(program, prep_steps, [(0, "single_block", 1)]).ticks
    for tick in range(10, 140, 10):
        script = [(0, "single_block", 1), (tick, "resume")]
        ticks = judged.run(program, prep_steps, script, answer=np.inf).ticks
        assert ticks > alone, f"resumed behind tick {tick} it stays where it rests"


# The checker finds what is spoilt


@pytest.fixture(scope="module")
def sound():
    """Return a program that rounds corners of lines and arcs within a tolerance, and its rows."""
    text = "G17 G21 G90 G94 G64 P0.1\nG1 X20 F3000\nY10\nG3 X10 Y20 I-10\nG1 X0\nY0\nM2\n"
    program = Program(text.encode(), Machine.load("mill3"))
    return program, judged.rows_of(program)


def out_of_the_tolerance(rows):
    """Cut the arc's inside; its centre is (10, 10)."""
    arc = np.flatnonzero(rows["pose"]["block"] == 2)[100:-100]
    bump = np.sin(np.linspace(0, np.pi, len(arc)))[:, None] ** 4
    poses = rows["pose"]["axis"]
    poses[arc, :2] = 10 + (poses[arc, :2] - 10) * (1 - 0.013 * bump)
    return rounded(rows)


def trembling(rows):
    rows["pose"]["axis"][5:-5, 2] += 2e-5 * (np.arange(len(rows) - 10) % 2)
    return rounded(rows)


def a_sharp_corner(rows):
    path = np.minimum(rows["pose"]["s"], 20.0)
    near = np.abs(rows["pose"]["s"] - 20) < 0.05
    rows["pose"]["axis"][near, 0] = path[near]
    rows["pose"]["axis"][near, 1] = np.maximum(rows["pose"]["s"][near] - 20, 0)
    return rounded(rows)


def an_accelerated_tick(rows):
    rows["pose"]["s"][300:] += 2e-4
    return rows


def a_shorter_way_than_told(rows):
    rows["pose"]["s"] *= 0.9999
    return rows


def a_stretch_left_out(rows):
    corner = np.searchsorted(rows["pose"]["s"], 20)
    return retimed(np.delete(rows, np.arange(corner - 3, corner + 3)))


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (out_of_the_tolerance, "off the path"),
        (trembling, "jerk|further"),
        (an_accelerated_tick, "path acceleration|path jerk|feed"),
        (a_shorter_way_than_told, "left out"),
    ],
)
def test_the_checker_finds_a_spoilt_run_within_a_tolerance(sound, spoil, words):
    program, rows = sound
    judge(program, rows)
    with pytest.raises(checker.PhysicsError, match=words):
        judge(program, spoil(rows.copy()))


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (a_sharp_corner, "speed|jerk|acceleration|further"),
        (a_stretch_left_out, "speed|acceleration|feed|jerk"),
    ],
)
def test_the_checker_finds_a_spoilt_corner_that_is_crossed(spoil, words):
    text = "G17 G21 G90 G94 G64 P3\nG1 X20 F3000\nY10\nG3 X10 Y20 I-10\nG1 X0\nY0\nM2\n"
    program = Program(text.encode(), Machine.load("mill3"))
    rows = judged.rows_of(program)
    judge(program, rows)
    with pytest.raises(checker.PhysicsError, match=words):
        judge(program, spoil(rows.copy()))


def test_the_checker_finds_a_slope_that_breaks_the_jerk():
    """Rows of the linear slope are not those of a jerk-limited machine."""
    text = b"G17 G21 G90 G94 G61\nG1 X20 F3000\nY10\nM2\n"
    rows = judged.rows_of(Program(text, Machine.load("mill3", set=["path.slope=linear"])))
    program = Program(text, Machine.load("mill3", set=["path.slope=jerk"]))
    with pytest.raises(checker.PhysicsError, match="jerk"):
        judge(program, rows)


@pytest.mark.parametrize(
    ("commands", "words"),
    [
        ([(100, "hold")], "does not come to rest"),
        ([(0, "override", 50)], "faster than its feed"),
        ([(100, "abort")], "does not come to rest"),
    ],
)
def test_the_checker_finds_an_operator_who_is_not_heard(sound, commands, words):
    program, rows = sound
    judge = checker.Checker(program.blocks, program.machine.record, commands)
    with pytest.raises(checker.PhysicsError, match=words):
        judge.add(rows)
