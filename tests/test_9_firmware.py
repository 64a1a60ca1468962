# SPDX-License-Identifier: MIT
"""The firmware on the host and on two Cortex-M under QEMU: the same setpoints everywhere, and every
fault ends at rest on the path, in a state that says what it was."""

import json
import math
import re
from dataclasses import replace
from pathlib import Path

import cases
import judged
import numpy as np
import pytest
from command_line import pycnc
from hypothesis import given, settings
from hypothesis import strategies as st

from pycnc import errors, firmware
from pycnc.machine import Machine

ROOT = Path(__file__).resolve().parents[1]
SLOPES = ("linear", "jerk")
EVERYWHERE = ("host", "m7")  # where the faults are tried
PERIOD_S = 1e-3
NM = 1e-6  # mm
END_NM = (24_000_000, 5_000_000, 0)
# A way that never crosses itself: straight moves of 2 to 25 mm, and many of 0.1 mm.
POINTS = [(0, 0), (25, 0), (25, 10), (12, 10), (10, 12), (12, 15), (40, 15), (40, 2)]
POINTS += [(40 - 0.1 * k, 2 + 3 * math.sin(k / 25) - 0.02 * k) for k in range(1, 100)]
POINTS += [(30, -5), (24, 5)]
PROGRAM = cases.polyline(POINTS, feed=3000)
WAVE = [(0.05 * k, 0.4 * math.sin(k / 9)) for k in range(1500)]  # a long way for a small window
WAVE_END_NM = (*(round(1e6 * x) for x in WAVE[-1]), 0)
ERROR = cases.polyline(POINTS[:6], feed=3000).replace("M2", "G1 X12 Y15.5\nG99\nG1 X30")


@pytest.fixture(scope="session")
def controllers(tool):
    """Return the function that opens a controller, or skips where its tools are missing."""

    def get(name):
        if name != "host":
            tool("arm-none-eabi-gcc"), tool("qemu-system-arm")
        return firmware.open(name)

    return get


def mill(slope="jerk", **changes):
    return Machine.load("mill3", set={"path.slope": slope, **changes})


def long_way():
    return cases.polyline(WAVE, feed=3000)


def motion(outcome):
    """Return (joints [mm], speeds, accelerations) of a run from its start at zero."""
    joints = np.vstack([np.zeros((2, 3)), outcome.rows["joint_nm"] * NM])
    v, a = np.diff(joints[1:], axis=0), np.diff(joints, n=2, axis=0)
    return joints[2:], v / PERIOD_S, a / PERIOD_S**2


def hold_limits(outcome, machine):
    """Every axis keeps its speed and acceleration at every tick, rounding to nanometres aside."""
    _, v, a = motion(outcome)
    assert (np.abs(v) <= machine.limits("v_max") * (1 + 1e-6) + 2 * NM / PERIOD_S).all()
    assert (np.abs(a) <= machine.limits("a_max") * (1 + 1e-6) + 4 * NM / PERIOD_S**2).all()


def nearest(joints, start, way):
    """Return (segment, share of it, distance) of the point of a way nearest to each setpoint."""
    low, high = joints.min(axis=0) - 1, joints.max(axis=0) + 1
    least, most = np.minimum(start, start + way), np.maximum(start, start + way)
    near = np.flatnonzero(((least <= high) & (most >= low)).all(axis=1))
    start, way = start[near], way[near]
    share = np.einsum("tsj,sj->ts", joints[:, None] - start, way) / (way**2).sum(axis=1)
    share = np.clip(share, 0, 1)
    apart = np.linalg.norm(joints[:, None] - (start + share[..., None] * way), axis=2)
    best, rows = apart.argmin(axis=1), np.arange(len(joints))
    return near[best], share[rows, best], apart[rows, best]


def along(outcome, points=POINTS):
    """Return how far along the way each setpoint is; all of them must be on it."""
    joints = outcome.rows["joint_nm"][:, :2] * NM
    points = np.round(np.array(points, float), 6)
    way = np.diff(points, axis=0)
    length = np.linalg.norm(way, axis=1)
    begin = np.concatenate([[0], np.cumsum(length)])
    done = []
    for part in np.array_split(joints, len(joints) // 100 + 1):
        segment, share, apart = nearest(part, points[:-1], way)
        assert apart.max() < 2e-6
        done.append(begin[segment] + share * length[segment])
    done = np.concatenate(done)
    assert (np.diff(done) >= -3e-6).all(), "the run goes backward on the path"
    return done


def rests_at_its_end(outcome):
    """The last setpoints are the same, to the nanometre, and are what the report says."""
    last = outcome.rows["joint_nm"][-8:]
    assert (last == last[-1]).all()
    assert tuple(last[-1]) == outcome.joints_nm


# The same setpoints everywhere

GOLDEN = [
    case for case in cases.CASES
    if case.name in (
        "square", "full_circle", "helix", "planes", "zigzag", "empty_moves", "waits", "rotary",
        "reversals", "outputs_alone", "random_arcs_0",
    )
]  # fmt: skip


def all_agree(outcomes):
    assert {each.state for each in outcomes} == {"done"}
    assert len({(each.hash, each.ticks, each.joints_nm) for each in outcomes}) == 1
    assert {each.overruns + each.starved_ticks for each in outcomes} == {0}


@pytest.mark.parametrize("case", GOLDEN, ids=str)
def test_setpoints_are_the_same_on_every_controller(controllers, case):
    machine = Machine.load(case.machine, set=[*case.set, "path.slope=linear"])
    all_agree([controllers(name).run(case.text, machine) for name in firmware.CONTROLLERS])


@pytest.mark.parametrize("case", GOLDEN, ids=str)
def test_jerk_limited_setpoints_are_the_same_on_host_and_m7(controllers, case):
    machine = Machine.load(case.machine, set=[*case.set, "path.slope=jerk"])
    all_agree([controllers(name).run(case.text, machine) for name in EVERYWHERE])


def test_jerk_limited_setpoints_are_the_same_on_an_m4f_that_is_fast_enough(controllers):
    (case,) = (each for each in GOLDEN if each.name == "planes")
    machine = Machine.load(case.machine, set=["path.slope=jerk"])
    outcomes = [
        controllers(name).run(case.text, machine, instruction_ns=1) for name in ("host", "m4f")
    ]
    all_agree(outcomes)


# The wrapper's capacities are larger. Under the linear slope that changes nothing for programs that
# fit into the firmware's window.
@pytest.mark.parametrize("name", ["full_circle", "helix", "waits", "lathe_part", "rotary"])
def test_the_firmware_gives_what_the_python_wrapper_gives(controllers, name):
    (case,) = (each for each in cases.CASES if each.name == name)
    case = replace(case, set=(*case.set, "path.slope=linear"))
    rows = judged.rows_of(judged.load(case))
    machine = Machine.load(case.machine, set=case.set)
    outcome = controllers("host").run(case.text, machine, trace=True)
    joints = outcome.rows["joint_nm"][: len(rows)]
    assert np.array_equal(joints, rows["axes"]["joint_nm"][:, : joints.shape[1]])
    assert (outcome.rows["joint_nm"][len(rows) :] == joints[-1]).all()


def surface(rows=25, columns=400):
    """A milled surface: rows of short moves, to and fro."""
    points = []
    for row in range(rows):
        y = 0.5 * row
        xs = [0.12 * k for k in range(columns)][:: 1 if row % 2 == 0 else -1]
        points += [(x, y, 2 * math.sin(x / 7) * math.cos(y / 5)) for x in xs]
    return cases.polyline(points, feed=6000)


def test_ten_thousand_blocks_run_in_time_on_a_cortex_m7(controllers):
    text = surface()
    host, m7 = (controllers(name).run(text, mill("jerk")) for name in EVERYWHERE)
    assert text.count("G1 ") == 10_000
    assert host.state == m7.state == "done"
    assert m7.hash == host.hash and m7.joints_nm == host.joints_nm
    assert (m7.overruns, m7.underruns, host.overruns, host.underruns) == (0, 0, 0, 0)
    assert m7.wall_s < 60
    assert sum(m7.load.values()) < 1
    assert min(m7.stack_left.values()) > 0


def test_a_run_is_repeated_to_the_bit(controllers):
    commands = [(300, "hold"), (700, "resume"), (900, "override", 40, 100)]
    for name in EVERYWHERE:
        twice = [
            controllers(name).run(PROGRAM, mill(), commands, trace=True, prep_steps=9)
            for _ in range(2)
        ]
        assert np.array_equal(twice[0].rows, twice[1].rows)
        assert twice[0].facts == twice[1].facts


# The operator


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


@pytest.mark.parametrize("name", EVERYWHERE)
def test_an_override_of_nothing_stands_still_until_it_is_raised(controllers, name):
    commands = [(300, "override", 0, 0), (2000, "override", 100, 100)]
    outcome = controllers(name).run(PROGRAM, mill(), commands, trace=True)
    done = along(outcome)
    assert done[1500] == done[1999] and done[1999] < done[-1]
    assert outcome.state == "done" and outcome.joints_nm == END_NM


@pytest.mark.parametrize("name", EVERYWHERE)
def test_single_block_holds_at_the_end_of_every_block(controllers, name):
    text = cases.polyline(POINTS[:4], feed=6000)
    commands = [(0, "single_block", 1), *((1000 * k, "resume") for k in range(1, 4))]
    outcome = controllers(name).run(text, mill(), commands, trace=True)
    for k, point in enumerate(POINTS[1:4], 1):
        stands = outcome.rows["joint_nm"][min(1000 * k, len(outcome.rows)) - 1, :2]
        assert tuple(stands) == tuple(round(1e6 * x) for x in point)
    assert outcome.state == "done"


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
    again = controllers(name).run("G21 G90 G1 F3000 X24 Y5\nM2\n", there, trace=True)
    assert abs(again.rows["joint_nm"][0] - outcome.joints_nm).max() < 1e6 * 50 * PERIOD_S
    assert again.state == "done" and again.joints_nm == END_NM


@pytest.mark.parametrize("name", EVERYWHERE)
def test_an_emergency_stop_ends_at_the_next_tick_with_the_drives_off(controllers, name):
    outcome = controllers(name).run(PROGRAM, mill(), [(500, "estop")], trace=True)
    assert outcome.state == "estop"
    after = outcome.rows[500:]
    assert len(after) > 0 and (after["drives"] == 0).all()
    assert (after["joint_nm"] == outcome.rows["joint_nm"][499]).all()
    assert (outcome.rows["drives"][:500] == 1).all()
    assert tuple(outcome.rows["joint_nm"][499]) == outcome.joints_nm


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


@settings(max_examples=40)
@given(script=SCRIPTS, slope=st.sampled_from(SLOPES), steps=st.sampled_from([0, 2, 5, 40]))
def test_whatever_the_operator_does_the_limits_hold_and_the_end_is_reached(script, slope, steps):
    machine = mill(slope)
    commands = [(tick, *command) for tick, command in script]
    commands += [(2600, "override", 100, 100), (2601, "resume"), (2900, "resume")]
    outcome = firmware.open("host").run(PROGRAM, machine, commands, trace=True, prep_steps=steps)
    assert outcome.state == "done" and outcome.joints_nm == END_NM
    hold_limits(outcome, machine)
    along(outcome)


@settings(max_examples=30)
@given(tick=st.integers(0, 2000), what=st.sampled_from(["abort", "estop", "hold"]),
       slope=st.sampled_from(SLOPES))  # fmt: skip
def test_an_end_at_any_tick_keeps_the_position(tick, what, slope):
    machine = mill(slope)
    outcome = firmware.open("host").run(PROGRAM, machine, [(tick, what)], trace=True)
    assert outcome.state in ({"hold": "hold", "abort": "aborted", "estop": "estop"}[what], "done")
    rests_at_its_end(outcome)
    along(outcome)
    if what != "estop":
        hold_limits(outcome, machine)


# Faults


@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_starved_motion_stops_on_the_path_and_goes_on(controllers, name, slope):
    machine = mill(slope)
    text = long_way()
    outcome = controllers(name).run(text, machine, [(150, "feeder_pause", 4000)], trace=True)
    assert "starved" in [state for _, state in outcome.events]
    assert outcome.state == "done" and outcome.starved_ticks > 500
    hold_limits(outcome, machine)
    along(outcome, WAVE)
    assert outcome.joints_nm == WAVE_END_NM


@pytest.mark.parametrize("name", EVERYWHERE)
def test_text_that_never_comes_ends_in_a_fault(controllers, name):
    commands = [(150, "feeder_pause", 4_000_000)]
    outcome = controllers(name).run(long_way(), mill(), commands, trace=True, starve_ticks=200)
    assert outcome.state == "fault_starved"
    rests_at_its_end(outcome)
    along(outcome, WAVE)


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


@pytest.mark.parametrize("name", EVERYWHERE)
def test_a_tick_that_just_fits_is_no_fault(controllers, name):
    outcome = controllers(name).run(PROGRAM, mill(), [(400, "tick_work", 15_000, 150)])
    assert outcome.state == "done" and outcome.overruns == 0
    assert 0.5 < outcome.tick_most < 1


@pytest.mark.parametrize("task", [1, 3, 5], ids=["supervisor", "feeder", "prep"])
@pytest.mark.parametrize("name", EVERYWHERE)
def test_a_stack_that_is_left_is_found_and_the_motion_ends(controllers, name, task):
    commands = [(400, "stack_work", task)]
    outcome = controllers(name).run(long_way(), mill(), commands, trace=True, max_ticks=20_000)
    assert outcome.state == "fault_stack"
    hold_limits(outcome, mill())
    rests_at_its_end(outcome)
    assert along(outcome, WAVE)[-1] < 70


@pytest.mark.parametrize("name", EVERYWHERE)
def test_a_program_error_ends_behind_what_stands_before_it(controllers, name):
    outcome = controllers(name).run(ERROR, mill(), trace=True)
    assert outcome.state == "program_error"
    assert outcome.joints_nm == (12_000_000, 15_500_000, 0)
    (error,) = [each for each in outcome.diagnostics if each.severity == "error"]
    assert (error.id, error.line) == ("unsupported", ERROR[: ERROR.index("G99")].count("\n") + 1)
    rests_at_its_end(outcome)
    along(outcome, [*POINTS[:6], (12, 15.5)])


def test_a_machine_that_makes_no_sense_is_a_fault(controllers):
    machine = mill()
    machine._rows["axis"]["v_max"][0, 0] = -1.0
    outcome = controllers("host").run(PROGRAM, machine)
    assert outcome.state == "fault_machine" and outcome.ticks == 0


@pytest.mark.parametrize("steps", range(1, 17))
def test_the_ring_runs_empty_and_full_at_every_phase(controllers, steps):
    for slope in SLOPES:
        outcome = controllers("host").run(PROGRAM, mill(slope), trace=True, prep_steps=steps)
        assert outcome.state == "done" and outcome.joints_nm == END_NM
        hold_limits(outcome, mill(slope))
        along(outcome)


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


# What goes wrong before a run


@pytest.mark.parametrize("missing", ["arm-none-eabi-gcc", "qemu-system-arm"])
def test_a_missing_tool_is_named_with_its_remedy(monkeypatch, tmp_path, missing):
    file = tmp_path / "part.nc"
    file.write_text(PROGRAM)
    which = firmware.shutil.which

    def look(name):
        return None if name == missing else which(name)

    monkeypatch.setattr(firmware.shutil, "which", look)
    firmware._build.cache_clear()
    result = pycnc("run", file, "--controller", "m7")
    assert result.code == 4
    assert re.search(rf"error\[controller\]: {missing} is not installed.*apt-get", result.err)


def test_what_the_controller_does_not_take_is_a_usage_error(controllers, tmp_path):
    file = tmp_path / "part.nc"
    file.write_text(PROGRAM)
    wrong = (["--at", "100 fly"], ["--at", "hold"], ["--at", "9 override 500 1"], ["-o", "t.npz"])
    for words in wrong:
        result = pycnc("run", file, "--controller", "host", *words)
        assert result.code == 2 and "pycnc: error[" in result.err
    assert pycnc("run", file, "--at", "100 hold").code == 2
    assert pycnc("run", file, "--controller", "m9").code == 2
    with pytest.raises(errors.ArgumentError):
        controllers("host").run(PROGRAM, prep_step=3)


def test_a_controller_that_does_not_end_is_given_up(controllers):
    silent = [(0, "feeder_pause", 4_000_000_000)]
    for name in EVERYWHERE:
        with pytest.raises(firmware.FirmwareError, match="did not end"):
            controllers(name).run(PROGRAM, commands=silent, timeout_s=1)


# The command line, and the page


def test_run_on_a_controller_tells_state_load_and_hash(controllers, tmp_path):
    file = tmp_path / "part.nc"
    file.write_text(PROGRAM)
    words = ["run", file, "--controller", "host", "--at", "400 hold", "--at", "900 resume"]
    facts = json.loads(pycnc(*words, "--json").out)
    assert facts["state"] == "done" and facts["controller"] == "host" and facts["overruns"] == 0
    assert [state for _, state in facts["events"]][-2:] == ["run", "done"]
    shown = pycnc(*words)
    assert shown.code == 0 and facts["hash"] in shown.out
    file.write_text(ERROR)
    wrong = pycnc("run", file, "--controller", "host")
    assert wrong.code == 1 and "error[unsupported]" in wrong.err


def test_the_page_about_the_controller_runs(controllers):
    page = (ROOT / "docs" / "controller.md").read_text(encoding="utf-8")
    controllers("m7")
    for code in re.findall(r"```python\n(.*?)```", page, re.S):
        exec(code, {})
