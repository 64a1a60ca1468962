# SPDX-License-Identifier: MIT
"""Drives, spindle and coolant are off at the end of every fault, in every handler and when nothing
works any more: on the host, and on two Cortex-M under QEMU, whose board has a watchdog."""

import firmware_runs
import pytest
from firmware_runs import PERIOD_UNITS, is_safe, long_way, report_in, run_in

from pycnc import controller

PROGRAM = "S800 M3\nM8\n" + long_way()
WATCHDOG_PERIODS = 16
FOREVER = 4_000_000_000  # units: 160 s
HANDLER_UNITS = 1_000  # from a task that does wrong to the pins, 40 us
# A period in which the core sleeps lasts two of them by the other clocks of QEMU 7.2.
PERIODS_ASLEEP = {"host": 1, "m4f": 2, "m7": 2}


@pytest.fixture(scope="session")
def controllers(tool):
    """Return the function that opens a controller by its name."""
    return lambda name: firmware_runs.opened(name, tool)


@pytest.fixture(params=controller.CONTROLLERS)
def name(request):
    """Return the name of each controller in turn."""
    return request.param


FAULTS = {
    "soft_limit": [(100, "travel", 0, -10_000_000, 12_000_000)],
    "soft_limit, too late to brake": [(300, "travel", 0, -10_000_000, 1_000_000)],
    "estop": [(300, "estop")],
    "fault_overrun": [(300, "tick_work", 130_000, 150)],
    "fault_stack": [(300, "stack_work", 5)],
    "fault_stack, of the supervisor": [(300, "stack_work", 1)],
    "fault_starved": [(150, "feeder_pause", 4_000_000)],
    "fault_task": [(300, "task_work", 1, FOREVER)],
}


@pytest.mark.sample(10)
@pytest.mark.parametrize("fault", FAULTS)
def test_the_state_that_a_fault_ends_in_is_safe_from_its_first_tick(
    controllers, name, fault, tmp_path
):
    slow = {"max_ticks": 20_000, "starve_ticks": 200}
    cause, changes = run_in(tmp_path, controllers(name), PROGRAM, FAULTS[fault], **slow)
    state, tick, rows = report_in(tmp_path)
    assert (cause, state) == ("", fault.partition(",")[0])
    assert is_safe(changes)
    assert all(change.unfed <= PERIODS_ASLEEP[name] * PERIOD_UNITS for change in changes[-3:])
    off = rows["drives"] == 0
    assert off[rows["tick"] > tick].all()
    assert not off[rows["tick"] < tick].any()


@pytest.mark.sample(quick=1)
def test_a_setpoint_beyond_its_travel_needs_no_supervisor(controllers, name, tmp_path):
    commands = [(300, "travel", 0, -10_000_000, 1_000_000), (300, "task_work", 1, FOREVER)]
    cause, changes = run_in(tmp_path, controllers(name), PROGRAM, commands)
    state, tick, rows = report_in(tmp_path)
    assert (cause, state) == ("", "fault_task")
    assert is_safe(changes)
    assert (rows["drives"] == (rows["tick"] <= 300)).all()


@pytest.mark.sample(quick=3)
@pytest.mark.parametrize("priority", [1, 3, 5], ids=["supervisor", "feeder", "prep"])
def test_the_handler_of_a_fault_makes_safe_at_once(controllers, name, priority, tmp_path):
    commands = [(300, "trap", priority)]
    cause, changes = run_in(tmp_path, controllers(name), PROGRAM, commands)
    assert cause == "usage fault"
    assert is_safe(changes)
    least = min(change.unfed for change in changes[-3:])
    assert least <= PERIODS_ASLEEP[name] * PERIOD_UNITS
    assert max(change.unfed for change in changes[-3:]) <= least + HANDLER_UNITS


@pytest.mark.sample(quick=1)
def test_a_fault_in_the_tick_makes_safe_within_a_period(controllers, name, tmp_path):
    cause, changes = run_in(tmp_path, controllers(name), PROGRAM, [(300, "trap", 0)])
    assert cause in ("usage fault", "hard fault")
    assert is_safe(changes)
    longest = PERIODS_ASLEEP[name] * PERIOD_UNITS + HANDLER_UNITS
    assert all(change.unfed <= longest for change in changes[-3:])


HANGS = {
    "a tick that never ends": (300, "tick_work", FOREVER, 1),
    "a task that keeps interrupts out": (300, "masked_work", 5, FOREVER),
    "a supervisor that does": (300, "masked_work", 1, FOREVER),
}


@pytest.mark.sample(quick=3)
@pytest.mark.parametrize("hang", HANGS)
def test_whatever_hangs_the_watchdog_makes_safe(controllers, name, hang, tmp_path):
    cause, changes = run_in(tmp_path, controllers(name), PROGRAM, [HANGS[hang]])
    assert cause == "watchdog"
    assert is_safe(changes)
    longest = WATCHDOG_PERIODS * PERIOD_UNITS
    assert all(longest <= change.unfed <= longest + HANDLER_UNITS for change in changes[-3:])


@pytest.mark.sample(quick=1)
def test_a_task_that_comes_late_is_no_hang(controllers, name, tmp_path):
    commands = [(300, "task_work", 5, 80 * PERIOD_UNITS)]
    cause, changes = run_in(tmp_path, controllers(name), PROGRAM, commands)
    assert (cause, report_in(tmp_path)[0]) == ("", "done")


@pytest.mark.sample(quick=1)
def test_a_whole_run_switches_what_the_program_says_and_ends_safe(controllers, name, tmp_path):
    text = "G21 G90 G61 F3000\nM8\nS500 M4\nG1 X5\nS600\nM5\nM9\nM3\nG1 X0\nM2\n"
    cause, changes = run_in(tmp_path, controllers(name), text)
    assert (cause, report_in(tmp_path)[0]) == ("", "done")
    said = [(change.output, change.value) for change in changes]
    assert said == [
        ("drives", 1), ("coolant", 1), ("spindle", -500), ("spindle", -600), ("spindle", 0),
        ("coolant", 0), ("spindle", 600), ("drives", 0), ("spindle", 0),
    ]  # fmt: skip
    assert changes[-1].unfed <= HANDLER_UNITS, "the report is written first"
