# SPDX-License-Identifier: MIT
"""The same bits everywhere: setpoints on three Cortex-M, on the host and from Python.

Nothing is compared with a stored path. Python's module has the capacities "host", which no board
can hold, so that the chain is: Python, a host program of equal capacities, the same program with a
board's capacities, the boards. Programs that every capacity set plans alike close the ring.
"""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import clocked
import numpy as np
import pytest
import targets
from cases import PROGRAM_CASES, RANDOM_CASES, Case
from targets import run_setpoints

import pycnc
from pycnc.bench import programs
from pycnc.machine import Machine

SLOPES = ("linear", "jerk")
# Once the slope's last node but one came out at rest, and its cell never ended.
STOPS = Case(
    "stops_after_stops",
    "F2173\nG9 G1 Y-0.4463\nG1 X-13.9918\nG9 G1 Y7.3513\nF2423\nG0 X17.6740 Y17.3543\n"
    "G9 G1 Y-4.9081\nG0 X-12.2704 Y12.8535\n",
)
RANDOM = [case for case in RANDOM_CASES if case.name.endswith("_0")]
SMOOTHED = [
    replace(case, name=f"{case.name}_smoothed", text=case.text.replace("G61", "G64 P0.01"))
    for case in (*PROGRAM_CASES, *RANDOM)
    if case.name in ("star", "zigzag", "tiny_circles", "random_lines_0", "random_arcs_0")
]
CASES = [*PROGRAM_CASES, *RANDOM, *SMOOTHED, STOPS]
# Smoothing and planning under a jerk limit take a Cortex-M4F, which has no double, 20 times as
# long as the rest: it gets the short programs.
SHORT = (
    "circle_of_two_arcs", "full_circle", "tiny_circles", "planes", "empty_moves", "waits",
    "outputs_alone", "wait_at_the_end", "tiny_circles_smoothed",
)  # fmt: skip
# Too dense for a board's window: there, and only there, capacities change what the linear slope
# does.
DENSE = ("micrometres",)
RUNS = [(case, slope) for slope in SLOPES for case in CASES]
SMALL_RUNS = [(case, slope) for case, slope in RUNS if case.name in SHORT]
# Of the time in Python's window, most that 64 knots in floats take here: 1.063 where all of the
# program is as small as P, 1.024 elsewhere.
SHORT_WINDOW = 1.08
SHARE = 1.003  # of an axis' limit, what a plan may take (docs/planner.md)
GRAIN_MM = 1e-6  # of setpoints
HASH_BEGIN, HASH_PRIME = 0xCBF29CE484222325, 0x100000001B3


@pytest.fixture(scope="module", autouse=True)
def builds(tool):
    """Build all programs before the first test runs."""
    for name in ("arm-none-eabi-gcc", "qemu-system-arm"):
        tool(name)
    for core in ("host", "m4f", "m7"):
        targets.build(core)


def machine_of(case, slope):
    return Machine.load(case.machine, set=(*case.set, f"path.slope={slope}"))


def run_everywhere(runs, case, slope, folder):
    """Run a case as each (core, capacities); return their results."""
    machine = machine_of(case, slope)

    def run_one(run):
        place = folder / "-".join(run)
        place.mkdir()
        return run_setpoints(*run, case, machine, place)

    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(run_one, runs))


def rows_of(run, folder):
    """Return the setpoints of a run: one row a tick."""
    axes = targets.capacities(run[1]).get("NCK_AXIS_MAX", 9) if run[1] != "default" else 9
    return np.fromfile(folder / "-".join(run) / "rows", "i8").reshape(-1, axes)


def hash_of(rows):
    """Return the hash that the programs compute, of the same setpoints."""
    value = HASH_BEGIN
    for word in rows.ravel().view("u8").tolist():
        value = ((value ^ word) * HASH_PRIME) & 0xFFFFFFFFFFFFFFFF
    return value


def first_difference(one, other):
    """Return the number of the first tick that differs, and both its rows."""
    count = min(len(one), len(other))
    differs = np.flatnonzero((one[:count] != other[:count]).any(axis=1))
    k = int(differs[0]) if len(differs) else count
    return k, one[k : k + 1], other[k : k + 1]


def assert_equal(runs, results, folder):
    first = results[0]
    assert first.error == 0 and first.starved == 0 and first.ticks > 0
    for run, result in zip(runs[1:], results[1:], strict=True):
        if result.hash != first.hash:
            where = first_difference(rows_of(runs[0], folder), rows_of(run, folder))
            pytest.fail(f"{run} differs from {runs[0]} at tick {where}")
        assert result.ticks == first.ticks


def is_quick(case, slope):
    return case.name in SHORT or (slope == "linear" and case not in SMOOTHED)


@pytest.mark.sample(24, quick=3)
@pytest.mark.parametrize(("case", "slope"), RUNS, ids=str)
def test_setpoints_are_the_same_on_every_core(case, slope, tmp_path, draw):
    runs = [("host", "default"), ("m7", "default")]
    runs += [("m4f", "default")] * is_quick(case, slope)
    runs += [("m55", "default")] * (case.name in SHORT and draw == "whole")
    assert_equal(runs, run_everywhere(runs, case, slope, tmp_path), tmp_path)


@pytest.mark.sample(9)
@pytest.mark.parametrize(("case", "slope"), SMALL_RUNS, ids=str)
def test_setpoints_are_the_same_in_64_kilobytes_of_ram(case, slope, tmp_path):
    runs = [("host", "small"), ("m4f", "small")]
    assert_equal(runs, run_everywhere(runs, case, slope, tmp_path), tmp_path)


@pytest.mark.sample(3, quick=1)
@pytest.mark.parametrize("case", SMOOTHED, ids=str)
def test_the_optimal_slope_has_the_same_bits_in_single_precision(case, tmp_path):
    runs = [("host", "optimal"), ("m7", "optimal")]
    runs += [("m4f", "optimal")] * (case.name == "zigzag_smoothed")
    results = run_everywhere(runs, case, "optimal", tmp_path)
    assert_equal(runs, results, tmp_path)
    machine = machine_of(case, "optimal")
    whole = pycnc.plan(pycnc.load(case.text, machine=machine))
    assert results[0].ticks <= SHORT_WINDOW * whole.time_s / machine.period_s + 1


@pytest.mark.sample(12, quick=4)
@pytest.mark.parametrize("seed", range(1000))
def test_a_short_window_of_the_optimal_slope_keeps_every_limit(seed, tmp_path):
    machine = Machine.load(programs.machine("optimal"))
    case = Case(f"clocked_{seed}", clocked.text_of(seed))
    result = run_setpoints("host", "optimal", case, machine, tmp_path)
    assert result.error == 0 and result.starved == 0
    rows = np.fromfile(tmp_path / "rows", "i8").reshape(-1, 3) / 1e6
    limits = machine.record["axis"]["v_max"][0], machine.record["axis"]["a_max"][0]
    # Exact blocks pass the jerk of axes at junctions.
    limits += () if "G61" in case.text else (machine.record["axis"]["j_max"][0],)
    for order, limit in enumerate(limits, start=1):
        most = np.abs(np.diff(rows, order, axis=0)).max() - 2**order * GRAIN_MM / 2
        assert most <= SHARE * limit * machine.period_s**order
    planned = pycnc.plan(pycnc.load(case.text, machine=machine))
    np.testing.assert_allclose(rows[-1], planned.segs[-1]["end"][:3], rtol=0, atol=2 * GRAIN_MM)


# Nothing but outputs is left where the path rests for the last time.
LAST_ALONE = ("outputs_alone", "waits", "wait_at_the_end")


@pytest.mark.sample(24)
@pytest.mark.parametrize(("case", "slope"), RUNS, ids=str)
def test_python_gives_the_same_setpoints(case, slope, tmp_path):
    runs = (("host", "host"), ("host", "default"))
    results = run_everywhere(runs, case, slope, tmp_path)
    trace = pycnc.run(pycnc.load(case.text, machine=machine_of(case, slope)))
    rows = rows_of(runs[0], tmp_path)
    names = [name for name in trace.columns if name.startswith("joint_")]
    given = np.stack([trace[name] for name in names], axis=1)
    if case.name in LAST_ALONE:  # a controller hands over outputs in a period, in which it rests
        stands = given[-1:] if len(given) else np.zeros((1, len(names)), np.int64)
        given = np.concatenate((given, stands))
    np.testing.assert_array_equal(rows[:, : len(names)], given)
    assert not rows[:, len(names) :].any()
    assert results[0].hash == hash_of(rows)
    if slope == "linear" and case not in SMOOTHED:
        assert (results[1].hash == results[0].hash) == (case.name not in DENSE)


def test_a_setpoint_that_differs_by_a_nanometre_is_seen(tmp_path):
    case = PROGRAM_CASES[0]
    run = ("host", "default")
    result = run_everywhere([run], case, "linear", tmp_path)[0]
    rows = rows_of(run, tmp_path)
    assert hash_of(rows) == result.hash
    rows[len(rows) // 2, 0] += 1
    assert hash_of(rows) != result.hash


def test_quotients_and_roots_of_an_m4f_have_the_bits_of_its_library():
    targets.emulate("m4f", targets.build("m4f") / "soft_doubles.elf")


# How a board ends a run that its program does not end

EXITS = {
    "none": 0, "unexpected": 100, "hard": 102, "bus": 104, "division": 105, "undefined": 105,
    "stack": 104, "overrun": 106,
}  # fmt: skip
NO_FAULT = ("none", "overrun")


@pytest.mark.sample(6)
@pytest.mark.parametrize("core", ["m4f", "m7", pytest.param("m55", marks=pytest.mark.campaign)])
@pytest.mark.parametrize("kind", EXITS)
def test_a_fault_ends_the_run_with_its_own_status(core, kind):
    image, status, said = targets.build(core) / "faults.elf", 0, ""
    try:
        targets.emulate(core, image, kind)
    except targets.TargetError as cause:
        status, said = cause.status, str(cause)
    assert status == EXITS[kind]
    assert ("switched off" in said) == (kind not in NO_FAULT)
