# SPDX-License-Identifier: MIT
"""Planning by grades (Cao et al. 2014): the bubble, the units, and whole programs run by them."""

import json

import cases
import checker
import judged
import numpy as np
import pytest
from command_line import pycnc as command
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from sampling import cheap_first

import pycnc
from pycnc import errors, kernel
from pycnc.kernel import records
from pycnc.planning import grades
from pycnc.bench import grades as bench_grades
from pycnc.machine import Machine
from pycnc.kernel.records import dtype, enum
from pycnc.report.trace import Trace

WORKED = [1, 5, 2, 5, 3, 1]  # figure 10
SETTLED = [1, 2, 2, 3, 2, 1]  # figure 12
CASES = {str(case): case for case in cases.CASES}
FILES = ("arcs_rword.gcode", "tp_trochoidal.ngc", "surf_webgcode_46k.ngc", "odd_no_spaces.gcode")
LIMITS = enum("nck_limit_t")


@pytest.fixture(scope="module")
def mill():
    """Return the shipped mill as grades run on it."""
    return Machine.load("mill3", set=judged.LINEAR_EXACT)


def line_segs(lengths, feed=20.0):
    """Return segs along x."""
    segs = np.zeros(len(lengths), dtype("nck_seg_t"))
    ends = np.cumsum(lengths)
    segs["seq"] = np.arange(len(segs))
    segs["line"] = np.arange(len(segs)) + 1
    segs["end"][:, 0], segs["start"][1:, 0] = ends, ends[:-1]
    segs["length"], segs["feed"], segs["feed_scale"] = lengths, feed, 1.0
    return segs


# The bubble


def test_the_worked_example_settles_as_printed():
    swept, sweeps = grades.bubble(WORKED, method="sweeps")
    assert swept.tolist() == SETTLED and sweeps == 2
    assert grades.bubble(WORKED)[0].tolist() == SETTLED


@given(arrays.arrays(np.int32, st.integers(0, 80), elements=st.integers(0, 50)))
def test_scan_and_sweeps_give_the_least_over_all_points(preplanned):
    scanned, _ = grades.bubble(preplanned)
    swept, sweeps = grades.bubble(preplanned, method="sweeps")
    far = np.abs(np.subtract.outer(np.arange(len(preplanned)), np.arange(len(preplanned))))
    oracle = (preplanned[None, :] + far).min(axis=1) if len(preplanned) else preplanned
    assert (scanned == oracle).all() and (swept == oracle).all()
    assert sweeps <= preplanned.max(initial=0) + 1


def test_the_printed_bubble_gives_the_worked_example_in_one_order_of_writes():
    steps = list(grades.bubble_printed(WORKED, lambda k: range(5)))
    assert [step.tolist() for step in steps] == [[1, 3, 2, 4, 2, 1], SETTLED, SETTLED]


@pytest.mark.parametrize(("descending", "wrong_at_least"), [(False, 50), (True, 350)])
def test_the_printed_bubble_stops_at_wrong_results(descending, wrong_at_least):
    rng, wrong = np.random.default_rng(2014), 0
    for _ in range(400):
        preplanned = rng.integers(0, 10, 20)
        orders = (lambda k: range(18, -1, -1)) if descending else (lambda k: rng.permutation(19))
        *_, before, stopped = [preplanned, *grades.bubble_printed(preplanned, orders)]
        assert (before == stopped).all(), "it stopped"
        right, _ = grades.bubble(preplanned)
        wrong += (stopped != right).any()
    assert wrong >= wrong_at_least


@pytest.mark.parametrize(("bad", "at"), [([3, -1, 2], 1), ([0, 1, 2**31 - 1], 2), ([2**40], 0)])
def test_a_grade_that_is_none_is_named(bad, at):
    for method in ("scan", "sweeps"):
        with pytest.raises(errors.ArgumentError, match=f"index {at}: grade {bad[at]} "):
            grades.bubble(bad, method=method)


@pytest.mark.parametrize("bad", [[0.5, 1.0], [np.nan], [np.inf, 2.0]])
def test_grades_are_whole_numbers(bad):
    with pytest.raises(errors.ArgumentError, match="whole numbers"):
        grades.bubble(bad)


# Tables and angles


def test_the_table_has_the_speeds_of_equation_8(mill):
    made = grades.rule(mill, 100.0, a=500.0, steps=5)
    table = grades.table(made)
    length = 5 * 100.0 * mill.period_s
    assert made["length"][0] == pytest.approx(length)
    assert len(table) == np.ceil(100.0**2 / (2 * 500 * length)) + 1
    assert table[0] == 0 and table[-1] == 100.0
    assert np.diff(table[:-1] ** 2) == pytest.approx(2 * 500 * length)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -1.0, 0.0])
def test_a_table_of_a_bad_number_is_refused(mill, bad):
    for given_numbers in ({"v_command": bad}, {"v_command": 9.0, "a": bad}):
        with pytest.raises(errors.ArgumentError):
            grades.rule(mill, **given_numbers)
    with pytest.raises(errors.ArgumentError):
        grades.rule(mill, 9.0, steps=0)


def test_angles_of_lines_are_those_of_their_directions():
    segs = line_segs([1.0] * 4)
    directions = np.array([[1, 0, 0], [0, 1, 0], [0, -1, 0], [0, -1, 1e-9]], float)
    segs["start"][:, :3], segs["end"][:, :3] = 0, directions
    angles = grades.link_angles(segs)
    assert angles == pytest.approx([np.pi / 2, np.pi, 1e-9], rel=1e-12)


# Whole paths


@settings(deadline=None)
@given(st.lists(st.floats(1e-3, 30.0), min_size=1, max_size=60), st.integers(1, 8))
def test_units_cover_the_path_and_every_invariant_holds(lengths, steps):
    planned = grades.Grades(line_segs(lengths), Machine.load("mill3"), steps=steps)
    length = planned.stretches["rule"]["length"][0]
    assert planned.holds()
    assert planned.units["length"].sum() == pytest.approx(sum(lengths))
    assert len(planned.units) == 1 or planned.units["length"].min() >= length * (1 - 1e-8)
    assert planned.cells()["length"].sum() == pytest.approx(sum(lengths))


def test_a_rest_cuts_a_path_into_stretches(mill):
    segs = line_segs([5.0] * 6)
    segs["stop"][1], segs["feed"][4:] = 1, 3.0
    planned = grades.Grades(segs, mill)
    assert planned.stretches["seg_end"].tolist() == [2, 4, 6]
    assert planned.stretches["rule"]["v_max"].tolist() == [20.0, 20.0, 3.0]
    assert planned.cells()["stop"].sum() >= 3


@pytest.mark.parametrize("bad", [np.nan, np.inf, -2.0, 0.0])
@pytest.mark.parametrize("field", ["length", "feed"])
def test_the_first_bad_seg_is_named_and_nothing_planned(mill, field, bad):
    segs = line_segs([2.0] * 9)
    segs[field][[5, 7]] = bad
    with pytest.raises(errors.ArgumentError, match=r"seg 5 \(line 6\)") as caught:
        grades.Grades(segs, mill)
    assert caught.value.line == 6


def test_a_plan_that_memory_does_not_hold_is_refused(mill, monkeypatch):
    monkeypatch.setattr(records, "free_memory", lambda: 2**20)
    with pytest.raises(errors.ArgumentError, match="items of units need .* GiB") as caught:
        grades.Grades(line_segs([1e4]), mill)
    assert caught.value.id == "memory"


def test_more_units_than_can_be_counted_are_refused(mill):
    with pytest.raises(errors.ArgumentError, match="planning units or more") as caught:
        grades.Grades(line_segs([1e6, 1e6], feed=0.5), mill, steps=1)
    assert caught.value.id == "memory"


def test_an_empty_path_has_no_cells(mill):
    planned = grades.Grades(line_segs([]), mill)
    assert len(planned.cells()) == 0 and planned.totals["time_s"] == 0


# Programs


def judge_run(program):
    """Run a program by grades under the checker's eyes, but for the accelerations of the axes."""
    planned, _ = grades.of_text(program.text, program.machine)
    lenient = program.machine.record.copy()
    lenient["axis"]["a_max"] = np.inf
    judge = checker.Checker(program.blocks, lenient)
    controller = grades.Simulation(planned)
    for rows, _ in controller.pieces():
        judge.add(rows)
    judge.finish()
    return planned, controller, judge


@pytest.mark.sample(quick=10)
@pytest.mark.parametrize("name", CASES)
def test_a_run_by_grades_keeps_speeds_path_stops_and_end(name):
    planned, controller, judge = judge_run(judged.load_exact(CASES[name]))
    assert planned.holds()
    assert controller.starved_ticks == 0
    assert judge.ticks == planned.totals["ticks"] or not len(planned.segs)


@pytest.mark.sample(2)
@pytest.mark.thorough
@pytest.mark.parametrize("name", cheap_first(FILES, cases.DEAR_FILES))
def test_a_corpus_file_runs_by_grades(name):
    file = next(each for each in cases.RUNNING_FILES if each.file == name)
    if not file.path.exists():
        pytest.skip("no corpus here")
    planned, controller, judge = judge_run(judged.load_exact(file))
    assert planned.holds() and controller.starved_ticks == 0
    assert judge.ticks == planned.totals["ticks"]


@pytest.mark.parametrize("name", [name for name in CASES if "stops" in name or "output" in name])
def test_outputs_come_in_the_same_order_as_by_the_exact_plan(name):
    program = judged.load_exact(CASES[name])
    by_grades, _ = grades.of_text(program.text, program.machine)
    told = []
    for controller in (
        kernel.Simulation(program.text, program.machine), grades.Simulation(by_grades),
    ):  # fmt: skip
        rows = np.concatenate([rows.copy() for rows, _ in controller.pieces()])
        changes = np.flatnonzero(np.diff(rows["spindle_rpm"], prepend=0.0))
        told.append((rows["spindle_rpm"][changes].tolist(), rows["pose"]["line"][changes].tolist()))
    assert told[0][0] == told[1][0]
    assert told[0][0] or name == "outputs_alone"  # which moves nothing: its run has no row


def test_two_runs_by_grades_give_the_same_bytes():
    program = judged.load_exact(CASES["random_arcs_0"])
    runs = []
    for _ in range(2):
        controller = grades.Simulation(grades.of_text(program.text, program.machine)[0])
        runs.append(b"".join(rows.tobytes() for rows, _ in controller.pieces()))
    assert runs[0] == runs[1]


def test_few_prep_steps_give_the_same_bytes():
    program = judged.load_exact(CASES["spiral"])
    planned, _ = grades.of_text(program.text, program.machine)
    runs = []
    for prep_steps in (1, kernel.PREP_STEPS):
        controller = grades.Simulation(planned, prep_steps)
        rows = np.concatenate([rows.copy() for rows, _ in controller.pieces()])
        runs.append(rows["pose"].tobytes())
        assert controller.starved_ticks == 0
    assert runs[0] == runs[1]


def test_a_sharp_corner_is_a_rest_and_costs_time(mill):
    program = pycnc.load("G21 G90 G17 G61 F3000\nG1 X20\nG1 Y20\nG1 X40\nM2\n", machine=mill)
    exact, by_grades = pycnc.plan(program), pycnc.plan(program, plan="grades")
    assert by_grades.time_s > exact.time_s == by_grades.exact_time_s
    angles = by_grades.grades.angle
    assert np.sort(angles)[-2:] == pytest.approx([np.pi / 2] * 2)
    assert (by_grades.grades.grade[angles > 1] == 0).all()


def test_an_arc_is_slowed_by_the_acceleration_between_its_steps(mill):
    program = pycnc.load("G21 G90 G17 G61 F6000\nG3 X0 Y0 I2 J0\nM2\n", machine=mill)
    planned = pycnc.plan(program, plan="grades").grades
    a = float(mill.limits("a_max")[0])
    assert (planned.unit_limit == LIMITS.CURVATURE).any()
    assert planned.v.max() <= np.sqrt(2 * np.sqrt(2) * a) * 1.1


# The bench


@pytest.mark.thorough
def test_every_variant_of_the_bench_gives_the_same_grades():
    rows = bench_grades.bench_bubble_rows(sizes=(300, 5000), seconds=0.0)
    assert {"C scan", "C sweeps"} <= {row["variant"] for row in rows}
    assert all(row["equal"] and row["ns_per_point"] > 0 for row in rows)


# The front door


def test_run_tells_that_it_was_planned_by_grades(tmp_path):
    file = tmp_path / "part.ngc"
    file.write_text("G21 G90 G17 S900 M3\nF1200 G1 X10\nG4 P0.1\nG2 X20 Y10 I0 J10\nM30\n")
    result = command("lab", "run", "--plan", "grades", "--json", file)
    facts = json.loads(result.out)
    assert result.code == 0 and facts["plan"] == "grades"
    assert facts["path_error_mm"] <= 1e-6 and facts["starved_ticks"] == 0
    assert facts["limit_time_s"]["dwell"] == pytest.approx(0.1)
    timed = json.loads(command("lab", "time", "--plan", "grades", "--json", file).out)
    assert timed["plan"] == "grades" and timed["time_s"] == facts["time_s"]
    assert json.loads(command("lab", "run", "--json", file).out)["plan"] == "exact"


def test_an_unknown_plan_is_a_wrong_call(tmp_path):
    file = tmp_path / "part.ngc"
    file.write_text("G21 G90 F600 G1 X1\nM2\n")
    for verb in ("run", "time"):
        result = command("lab", verb, "--plan", "bubbles", file)
        assert result.code == 2 and "'exact', 'grades'" in result.err


def test_accelerations_are_reported_and_not_judged():
    trace = Trace(judged.load_exact(CASES["zigzag"]), plan="grades")
    assert trace.plan.kind == "grades" and "a" in trace.summary["peaks"]["x"]
    assert trace["pos_x_mm"][-1] == trace.plan.segs["end"][-1, 0]


def test_a_run_planned_on_a_device_has_the_same_bytes():
    program = judged.load_exact(CASES["random_smooth_0"])
    runs = []
    for backend in ("c", "opencl"):
        try:
            planned, _ = grades.of_text(program.text, program.machine, backend=backend)
        except errors.DeviceError as cause:
            pytest.skip(f"no OpenCL here: {cause}")
        assert planned.backend == backend and planned.holds()
        rows = [rows.tobytes() for rows, _ in grades.Simulation(planned).pieces()]
        runs.append(b"".join(rows))
    assert runs[0] == runs[1]


def test_a_named_device_that_is_absent_is_a_failure_with_a_remedy(tmp_path, monkeypatch):
    monkeypatch.setenv("PYCNC_DEVICE", "no such device")
    file = tmp_path / "part.ngc"
    file.write_text("G21 G90 F600 G1 X1\nM2\n")
    result = command("lab", "run", "--plan", "grades", "--backend", "opencl", file)
    assert result.code == 4 and "pip install" in result.err
    assert command("lab", "run", "--plan", "grades", file).code == 0
    assert command("lab", "run", "--backend", "opencl", file).code == 4
