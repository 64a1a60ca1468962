# SPDX-License-Identifier: MIT
"""The firmware under an operator and under faults: whatever comes, the limits hold, the path is
kept, and every fault ends at rest in a state that says what it was."""

import cases
import firmware_runs
import numpy as np
import pytest
from firmware_runs import (
    END_NM,
    ERROR,
    EVERYWHERE,
    NM,
    PERIOD_S,
    POINTS,
    PROGRAM,
    SLOPES,
    WAVE,
    WAVE_END_NM,
    along,
    hold_limits,
    long_way,
    mill,
    motion,
    rests_at_its_end,
)
from hypothesis import given
from hypothesis import strategies as st
from sampling import examples

from pycnc import controller


@pytest.fixture(scope="session")
def controllers(tool):
    """Return the function that opens a controller by its name."""
    return lambda name: firmware_runs.opened(name, tool)


# The operator


@pytest.mark.sample(quick=2)
@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_a_hold_rests_on_the_path_and_a_resume_goes_on(controllers, name, slope):
    machine = mill(slope)
    commands = [(400, "hold"), (1900, "resume")]
    outcome = controllers(name).run(long_way(), machine, commands, trace=True)
    states = [state for _, state in outcome.events]
    assert [state for state in states if state != "starved"] == [
        "run", "stopping", "hold", "run", "done"
    ]  # fmt: skip
    hold_limits(outcome, machine)
    done = along(outcome, WAVE)
    assert (done[1700:1900] == done[1700]).all()
    assert 0 < done[1899] < done[-1]
    assert outcome.joints_nm == WAVE_END_NM
    rests_at_its_end(outcome)


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_an_override_changes_the_speed_and_not_the_path(controllers, name):
    plain = controllers(name).run(PROGRAM, mill(), trace=True)
    slow = controllers(name).run(PROGRAM, mill(), [(0, "override", 50, 100)], trace=True)
    changed = controllers(name).run(
        PROGRAM, mill(), [(200, "override", 150, 100), (600, "override", 30, 100)], trace=True
    )
    top = [np.linalg.norm(motion(each)[1], axis=1).max() for each in (plain, slow, changed)]
    assert top[0] == pytest.approx(50, rel=1e-3)
    assert top[1] == pytest.approx(25, rel=1e-3)
    assert top[2] > 55
    for outcome in (plain, slow, changed):
        hold_limits(outcome, mill())
        along(outcome)
        assert outcome.state == "done" and outcome.joints_nm == END_NM


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_an_override_of_nothing_stands_still_until_it_is_raised(controllers, name):
    commands = [(300, "override", 0, 0), (2000, "override", 100, 100)]
    outcome = controllers(name).run(PROGRAM, mill(), commands, trace=True)
    done = along(outcome)
    assert done[1500] == done[1999] and done[1999] < done[-1]
    assert outcome.state == "done" and outcome.joints_nm == END_NM


def test_an_override_of_nothing_before_the_first_move_ends_the_run_as_a_hold(controllers):
    outcome = controllers("host").run(PROGRAM, mill(), [(0, "override", 0, 0)], timeout_s=20)
    assert outcome.state == "hold" and outcome.joints_nm == (0, 0, 0)


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_single_block_holds_at_the_end_of_every_block(controllers, name):
    text = cases.polyline(POINTS[:4], feed=6000)
    commands = [(0, "single_block", 1), *((1000 * k, "resume") for k in range(1, 4))]
    outcome = controllers(name).run(text, mill(), commands, trace=True)
    for k, point in enumerate(POINTS[1:4], 1):
        stands = outcome.rows["joint_nm"][min(1000 * k, len(outcome.rows)) - 1, :2]
        assert tuple(stands) == tuple(round(1e6 * x) for x in point)
    assert outcome.state == "done"


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_an_abort_keeps_the_position_and_the_next_program_goes_on_there(controllers, name):
    machine = mill()
    outcome = controllers(name).run(PROGRAM, machine, [(500, "abort")], trace=True)
    assert outcome.state == "aborted"
    hold_limits(outcome, machine)
    rests_at_its_end(outcome)
    done = along(outcome)
    assert done[499] <= done[-1] < 40
    x, y, _ = outcome.joints_nm
    there = mill(**{"start.x_mm": x * NM, "start.y_mm": y * NM})
    again = controllers(name).run("G21 G90 G1 F3000 X24 Y-6\nM2\n", there, trace=True)
    assert abs(again.rows["joint_nm"][0] - outcome.joints_nm).max() < 1e6 * 50 * PERIOD_S
    assert again.state == "done" and again.joints_nm == END_NM


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_an_emergency_stop_ends_at_the_next_tick_with_the_drives_off(controllers, name):
    outcome = controllers(name).run(PROGRAM, mill(), [(500, "estop")], trace=True)
    assert outcome.state == "estop"
    after = outcome.rows[500:]
    assert len(after) > 0 and (after["drives"] == 0).all()
    assert (after["joint_nm"] == outcome.rows["joint_nm"][499]).all()
    assert (outcome.rows["drives"][:500] == 1).all()
    assert tuple(outcome.rows["joint_nm"][499]) == outcome.joints_nm


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_a_soft_limit_stops_before_it_is_passed(controllers, name):
    machine = mill()
    for limit in (21_000_000, 39_500_000):
        commands = [(100, "travel", 0, -10_000_000, limit)]
        outcome = controllers(name).run(PROGRAM, machine, commands, trace=True)
        assert outcome.state == "soft_limit"
        assert outcome.rows["joint_nm"][:, 0].max() <= limit
        hold_limits(outcome, machine)
        rests_at_its_end(outcome)
        along(outcome)


def test_a_soft_limit_that_comes_too_late_keeps_the_setpoint_back(controllers):
    commands = [(300, "travel", 0, -10_000_000, 1_000_000)]
    outcome = controllers("host").run(PROGRAM, mill(), commands, trace=True)
    assert outcome.state == "soft_limit"
    assert (outcome.rows["joint_nm"][300:] == outcome.rows["joint_nm"][299]).all()


SCRIPTS = st.lists(
    st.tuples(
        st.integers(0, 2500),
        st.sampled_from([
            ("hold",), ("resume",), ("override", 0, 100), ("override", 37, 100),
            ("override", 200, 100), ("override", 100, 100), ("feeder_pause", 300),
        ]),
    ),
    max_size=12,
)  # fmt: skip


@examples(40)
@given(script=SCRIPTS, slope=st.sampled_from(SLOPES), steps=st.sampled_from([0, 2, 5, 40]))
def test_whatever_the_operator_does_the_limits_hold_and_the_end_is_reached(script, slope, steps):
    machine = mill(slope)
    commands = [(tick, *command) for tick, command in script]
    commands += [(2600, "override", 100, 100), (2601, "resume"), (2900, "resume")]
    outcome = controller.open("host").run(PROGRAM, machine, commands, trace=True, prep_steps=steps)
    assert outcome.state == "done" and outcome.joints_nm == END_NM
    hold_limits(outcome, machine)
    along(outcome)


@examples(30)
@given(tick=st.integers(1, 2000), what=st.sampled_from(["abort", "estop", "hold"]),
       slope=st.sampled_from(SLOPES))  # fmt: skip
def test_an_end_at_any_tick_keeps_the_position(tick, what, slope):
    machine = mill(slope)
    outcome = controller.open("host").run(PROGRAM, machine, [(tick, what)], trace=True)
    assert outcome.state in ({"hold": "hold", "abort": "aborted", "estop": "estop"}[what], "done")
    rests_at_its_end(outcome)
    along(outcome)
    if what != "estop":
        hold_limits(outcome, machine)


# Faults


@pytest.mark.sample(quick=2)
@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_starved_motion_stops_on_the_path_and_goes_on(controllers, name, slope):
    machine = mill(slope)
    text = long_way()
    outcome = controllers(name).run(text, machine, [(150, "feeder_pause", 4000)], trace=True)
    assert "starved" in [state for _, state in outcome.events]
    assert outcome.state == "done" and outcome.starved_ticks > 100
    hold_limits(outcome, machine)
    along(outcome, WAVE)
    assert outcome.joints_nm == WAVE_END_NM


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_text_that_never_comes_ends_in_a_fault(controllers, name):
    commands = [(150, "feeder_pause", 4_000_000)]
    outcome = controllers(name).run(long_way(), mill(), commands, trace=True, starve_ticks=200)
    assert outcome.state == "fault_starved"
    rests_at_its_end(outcome)
    along(outcome, WAVE)


@pytest.mark.sample(quick=2)
@pytest.mark.parametrize("name", EVERYWHERE)
@pytest.mark.parametrize("units", [26_000, 40_000, 70_000, 130_000])
def test_a_tick_overrun_stops_the_motion_and_hangs_nothing(controllers, name, units):
    commands = [(400, "tick_work", units, 150)]
    outcome = controllers(name).run(PROGRAM, mill(), commands, trace=True, max_ticks=20_000)
    assert outcome.state == "fault_overrun"
    assert outcome.overruns > 0 and outcome.given_away > 0
    hold_limits(outcome, mill())
    rests_at_its_end(outcome)
    assert along(outcome)[-1] < 40


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_a_tick_that_just_fits_is_no_fault(controllers, name):
    outcome = controllers(name).run(PROGRAM, mill(), [(400, "tick_work", 15_000, 150)])
    assert outcome.state == "done" and outcome.overruns == 0
    assert 0.5 < outcome.tick_most < 1


@pytest.mark.sample(quick=2)
@pytest.mark.parametrize("task", [1, 3, 5], ids=["supervisor", "feeder", "prep"])
@pytest.mark.parametrize("name", EVERYWHERE)
def test_a_stack_that_is_left_is_found_and_the_motion_ends(controllers, name, task):
    commands = [(400, "stack_work", task)]
    outcome = controllers(name).run(long_way(), mill(), commands, trace=True, max_ticks=20_000)
    assert outcome.state == "fault_stack"
    hold_limits(outcome, mill())
    rests_at_its_end(outcome)
    assert along(outcome, WAVE)[-1] < 70


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_a_program_error_ends_behind_what_stands_before_it(controllers, name):
    outcome = controllers(name).run(ERROR, mill(), trace=True)
    assert outcome.state == "program_error"
    assert outcome.joints_nm == (12_000_000, 15_500_000, 0)
    (error,) = [each for each in outcome.diagnostics if each.severity == "error"]
    assert (error.id, error.line) == ("unsupported", ERROR[: ERROR.index("G87")].count("\n") + 1)
    rests_at_its_end(outcome)
    along(outcome, [*POINTS[:6], (12, 15.5)])


def test_a_machine_that_makes_no_sense_is_a_fault(controllers):
    machine = mill()
    machine._rows["axis"]["v_max"][0, 0] = -1.0
    outcome = controllers("host").run(PROGRAM, machine)
    assert outcome.state == "fault_machine" and outcome.ticks == 0


@pytest.mark.sample(quick=3)
@pytest.mark.parametrize("steps", range(1, 17))
def test_the_ring_runs_empty_and_full_at_every_phase(controllers, steps):
    for slope in SLOPES:
        outcome = controllers("host").run(PROGRAM, mill(slope), trace=True, prep_steps=steps)
        assert outcome.state == "done" and outcome.joints_nm == END_NM
        hold_limits(outcome, mill(slope))
        along(outcome)


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("slope", SLOPES)
def test_text_may_stop_at_any_tick(controllers, slope):
    machine = mill(slope)
    for tick in range(90, 120, 2):
        outcome = controllers("host").run(
            long_way(), machine, [(tick, "feeder_pause", 3000)], trace=True
        )
        assert outcome.state == "done" and outcome.joints_nm == WAVE_END_NM
        assert outcome.starved_ticks > 0
        hold_limits(outcome, machine)
        along(outcome, WAVE)
