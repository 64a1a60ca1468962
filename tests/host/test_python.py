# SPDX-License-Identifier: MIT
"""The Python package: programs, plans and traces, and measurements that would find a fault."""

import csv
import doctest
import importlib
import json
import math
import threading

import numpy as np
import pytest

import pycnc
from pycnc import kernel, stages
from pycnc.planning import measure
from pycnc.kernel.bind import lib
from pycnc.machine import Machine
from pycnc.program.lines import Lines
from pycnc.report.path_error import PathError
from pycnc.kernel.records import dtype, enum

SQUARE = b"G21 G90 G17 G91.1 G54 F1200\nG0 Z5\nG1 X20\nY20\nX0\nY0\nM2\n"
ARCS = (
    b"G21 G90 G17 G91.1 F900\nG1 X10\nG3 X20 Y10 I10 J0 (270 degrees)\nG3 X20 Y10 Z-6 I5 J5 P3\n"
    b"G18 G2 X30 Z-16 I10 K0\nG19 G3 Y20 Z-26 R10\nG4 P0.05\nM30\n"
)


@pytest.fixture(scope="module")
def exact():
    """Return a machine that keeps to the exact path where the program gives no tolerance."""
    return Machine.load("mill3", set=["path.slope=linear", "path.tolerance_mm=0"])


@pytest.fixture(scope="module")
def trace(exact):
    return pycnc.run(ARCS, machine=exact)


# Doors


def test_the_front_door_has_the_promised_names():
    for name in ("load", "plan", "run", "Machine", "Program", "Plan", "Trace", "stages"):
        assert hasattr(pycnc, name)
    pycnc.run(SQUARE)
    assert callable(pycnc.plan), "a module of the same name must not hide the function"


@pytest.mark.parametrize(
    "name",
    ["program", "program.lines", "planning.plan", "report.trace", "stages", "planning.measure",
     "report.plot", "machine", "kernel.records"],
)  # fmt: skip
def test_the_examples_in_the_docstrings_run(name):
    module = importlib.import_module(f"pycnc.{name}")
    names = {"np": np, "enum": importlib.import_module("pycnc.kernel.records").enum}
    found = doctest.testmod(module, extraglobs=names | {"Machine": Machine})
    assert found.failed == 0


# Programs


@pytest.mark.parametrize("piece", [1, 3, 7, 1 << 20])
@pytest.mark.parametrize(
    "text",
    [b"", b"\n", b"G1", b"G1\n", b"a\rbb\r\n\r\nccc\n\rdddd\n\n", b"a\r\nbb\r\nccc", b"a\rb\r",
     b"".join(b"X%d\n" % k for k in range(50))],
)  # fmt: skip
def test_lines_are_those_that_a_split_finds(monkeypatch, text, piece):
    monkeypatch.setattr("pycnc.program.lines._PIECE", piece)
    expected = text.splitlines()
    assert list(Lines(text)) == expected
    assert len(Lines(text)) == len(expected)
    for order in (1, -1):
        found = Lines(text)
        numbers = range(-1, len(expected) + 3)[::order]
        wanted = [expected[n - 1] if 0 < n <= len(expected) else b"" for n in numbers]
        assert [found[number] for number in numbers] == wanted


def test_text_and_file_give_the_same_program(tmp_path):
    file = tmp_path / "part.nc"
    file.write_bytes(SQUARE)
    from_file, from_text = pycnc.load(file), pycnc.load(SQUARE)
    assert np.array_equal(from_file.blocks, from_text.blocks)
    assert from_file.sha256 == from_text.sha256
    assert from_file.file == str(file)


def test_length_and_bounds_take_arcs_into_account():
    program = pycnc.load(ARCS).check()
    quarter, helix = 10 * math.pi / 2, math.hypot(3 * 2 * math.pi * math.hypot(5, 5), 6)
    straight = 10.0
    arc_18, arc_19 = 10 * math.pi / 2, 10 * math.pi / 2
    assert program.length_mm == pytest.approx(
        straight + 3 * quarter + helix + arc_18 + arc_19, abs=1e-4
    )
    low, high = program.bounds["y"]
    assert (low, high) == pytest.approx((-10.0, 15 + math.hypot(5, 5)), abs=1e-4)


def test_the_summary_of_a_program_is_short_and_safe():
    program = pycnc.load(SQUARE)
    program.file = "<b>part</b>.nc"
    assert len(repr(program).splitlines()) == 1
    assert "<b>" not in program._repr_html_()


def test_a_program_error_names_its_line():
    program = pycnc.load(b"G21\nG1 X10 F100\nG1 Q5\nM2\n")
    with pytest.raises(pycnc.ProgramError) as caught:
        pycnc.plan(program)
    assert (caught.value.line, caught.value.id) == (3, "word-unused")


# Plans


@pytest.mark.parametrize("slope", ["linear", "jerk"])
def test_a_plan_and_its_run_take_the_same_time(slope):
    planned, run = pycnc.plan(ARCS, slope=slope), pycnc.run(ARCS, slope=slope)
    assert planned.time_s == pytest.approx(run.summary["time_s"], abs=1e-9)


def test_the_times_of_a_plan_add_up():
    plan = pycnc.plan(ARCS)
    parts = plan.totals
    assert parts["cut_s"] + parts["rapid_s"] + parts["dwell_s"] == pytest.approx(plan.time_s)
    assert sum(parts["limit_time_s"].values()) == pytest.approx(plan.time_s)


def test_the_arrays_of_a_plan_are_whole(exact):
    plan = pycnc.plan(SQUARE, machine=exact)
    assert len(plan.segs) == plan.totals["segments"] == 5
    assert plan.cells["length"].sum() == pytest.approx(plan.totals["length_mm"])
    assert plan.nodes["length"].sum() == pytest.approx(plan.totals["length_mm"])


def test_what_is_not_built_is_refused_with_what_is():
    with pytest.raises(pycnc.ArgumentError, match="linear"):
        pycnc.plan(SQUARE, slope="round")
    for call in (pycnc.plan, pycnc.run):
        with pytest.raises(pycnc.ArgumentError, match="auto, c"):
            call(SQUARE, backend="opencl")
    with pytest.raises(pycnc.ArgumentError, match="auto, c"):
        stages.envelope([1.0], [], backend="fpga")


# Stages


def test_the_envelope_is_the_two_passes_in_this_order():
    rng = np.random.default_rng(7)
    cap, h = rng.uniform(0, 100, 999), rng.uniform(0, 20, 998)
    want = cap.copy()
    want[-1] = min(want[-1], 3.0)
    for i in reversed(range(998)):
        want[i] = min(want[i], want[i + 1] + h[i])
    want[0] = min(want[0], 2.0)
    for i in range(998):
        want[i + 1] = min(want[i + 1], want[i] + h[i])
    out = np.empty(999)
    assert stages.envelope(cap, h, vv_start=2.0, vv_end=3.0, out=out) is out
    assert np.array_equal(out, want)


@pytest.mark.parametrize("bad", [math.nan, math.inf, -1.0])
def test_the_envelope_names_the_number_that_it_refuses(bad):
    with pytest.raises(pycnc.ArgumentError, match="index 2"):
        stages.envelope([1.0, 1.0, bad, 1.0], [1.0, 1.0, 1.0])


def test_the_envelope_refuses_lengths_that_do_not_fit():
    with pytest.raises(pycnc.ArgumentError):
        stages.envelope([1.0, 1.0], [1.0, 1.0])
    with pytest.raises(pycnc.ArgumentError):
        stages.envelope([1.0, 1.0], [1.0], out=np.empty(3))


def test_the_decode_stage_gives_blocks_and_findings():
    blocks, findings = stages.decode(SQUARE, Machine.load("mill3"))
    assert len(blocks) == 6
    assert blocks["line"].tolist() == [2, 3, 4, 5, 6, 7]
    assert len(findings) == 0


# Traces


def test_two_runs_give_the_same_rows(trace, exact):
    again = pycnc.run(ARCS, machine=exact)
    assert all(np.array_equal(trace[name], again[name]) for name in trace.columns)


def test_a_trace_ends_where_the_program_ends(trace):
    assert [trace[f"joint_{k}_nm"][-1] for k in range(3)] == [30_000_000, 20_000_000, -26_000_000]
    assert trace["vel_mm_s"].max() <= 15.0 * (1 + 1e-12)
    assert set(np.unique(trace["kind"])) >= {2, 3, 4}
    assert trace.limit_names()[int(trace["limit"][trace["kind"] == 4][0])] == "dwell"


def test_rows_stay_on_the_path_and_a_step_aside_is_found(trace):
    assert trace.summary["path_error_mm"] < 1e-9
    for line in range(2, 7):  # line, arc, helix, arcs in the other planes
        middle = int(np.median(np.flatnonzero(trace["line"] == line)))
        found = []
        for axis in range(3):
            rows = _rows(trace)
            rows["pose"]["axis"][middle, axis] += 1e-4
            error = PathError(trace.program)
            error.add(rows)
            found.append(error.largest_mm)
        assert 5e-5 < max(found) <= 1e-4 + 1e-9


def _rows(trace):
    """Return the rows of a trace on the exact path as the controller gave them."""
    rows = np.zeros(len(trace), dtype("sim_row_t"))
    for field, name in (("line", "line"), ("block", "block"), ("s", "s_mm")):
        rows["pose"][field] = trace[name]
    for k, letter in enumerate("xyz"):
        rows["pose"]["axis"][:, k] = trace[f"pos_{letter}_mm"]
    return rows


def test_peaks_are_finite_differences_across_pieces(trace):
    machine, rows = trace.program.machine, _rows(trace)
    peaks = measure.Peaks(machine)
    for begin in range(0, len(rows), 7):
        peaks.add(rows[begin : begin + 7])
    whole = trace.summary["peaks"]
    assert peaks.result() == whole
    x = np.concatenate([np.zeros(3), trace["pos_x_mm"]])
    limits = [machine.limits(kind)[0] for kind in ("v_max", "a_max", "j_max")]
    for order, kind in enumerate("vaj", 1):
        ratio = np.abs(np.diff(x, order)).max() / 1e-3**order / limits[order - 1]
        assert whole["x"][kind] == pytest.approx(ratio, rel=1e-9)


def test_a_jump_shows_in_the_peaks(trace):
    rows = _rows(trace)
    rows["pose"]["axis"][300:, 1] += 1.0
    peaks = measure.Peaks(trace.program.machine)
    peaks.add(rows)
    assert peaks.result()["y"]["v"] > 3


def _path_peaks(machine, s, **poses):
    """Return the peaks of the path of a run that stands at coordinates, tick by tick."""
    rows = np.zeros(len(s), dtype("sim_row_t"))
    rows["pose"]["s"] = s
    for name, values in poses.items():
        rows["pose"][name] = values
    peaks = measure.Peaks(machine)
    for begin in range(0, len(rows), 5):
        peaks.add(rows[begin : begin + 5])
    return peaks.result()["path"]


def test_the_coordinate_of_a_clocked_path_has_no_peaks():
    machine, s = Machine.load("mill3"), np.arange(30.0) ** 2
    spline = int(enum("nck_seg_kind_t").SPLINE)
    assert _path_peaks(machine, s, kind=spline) == {"a": 0, "j": 0}
    jerk = Machine.load("mill3", set={"path.slope": "jerk"})
    assert _path_peaks(jerk, s, kind=spline)["a"] > 1
    kinds = np.where(np.arange(30) < 20, spline, int(enum("nck_seg_kind_t").LINE))
    assert _path_peaks(machine, s, kind=kinds)["a"] > 1


# How a run ends

STOPS = [k * 1e-4 for k in range(1, 61)] + [k * 0.1 for k in range(1, 1001)]  # [mm]
HELD = b"G21 G90 G17 G61 F3000\nG1 X50\nM0\nY50\nX0\nM2\n"


def test_stops_of_one_tick_each_do_not_end_a_run():
    moves = "".join(f"G1 X{x:.6f}\n" for x in STOPS)
    text = f"G17 G21 G90 G94 G61.1 F3000\n{moves}M2\n"
    plan, done = pycnc.plan(text), pycnc.run(text)
    assert (len(done), done.summary["end"]) == (round(plan.time_s / 1e-3), "done")
    assert done["pos_x_mm"][-1] == 100


@pytest.mark.parametrize(
    ("commands", "end"),
    [
        ([], "done"),
        ([(300, "hold")], "hold"),
        ([(300, "hold"), (5000, "resume")], "done"),
        ([(0, "hold")], "hold"),
        ([(0, "single_block", 1)], "single_block"),
        ([(0, "single_block", 1), (5000, "single_block", 0)], "single_block"),
        ([(0, "override", 0)], "override"),
        ([(500, "override", 0)], "override"),
        ([(500, "override", 0), (5000, "override", 100)], "done"),
        ([(300, "abort")], "aborted"),
    ],
)
def test_a_run_says_how_it_ended(commands, end):
    done = pycnc.run(HELD, slope="jerk", commands=commands)
    assert done.summary["end"] == end
    assert (done["pos_x_mm"][-1] == 0 and done["pos_y_mm"][-1] == 50) == (end == "done")
    assert (end in repr(done)) == (end != "done")


def test_a_hold_during_a_wait_is_kept_when_the_wait_ends():
    free = pycnc.run(HELD, slope="jerk")
    waits = int(np.flatnonzero(free["kind"] == measure.KINDS.index("wait"))[-1]) + 1
    done = pycnc.run(HELD, slope="jerk", commands=[(waits - 1, "hold")])
    assert (done.summary["end"], done["pos_x_mm"][-1]) == ("hold", 50)


def test_a_run_that_is_broken_off_leaves_no_planning_behind(exact, monkeypatch):
    def plans_for_ever(planner):
        while True:
            yield np.empty(0, dtype("nck_seg_t")), 0

    def interrupted(simulation):
        raise KeyboardInterrupt

    monkeypatch.setattr("pycnc.kernel.Planner.pieces", plans_for_ever)
    monkeypatch.setattr("pycnc.kernel.Simulation.pieces", interrupted)
    before = threading.active_count()
    with pytest.raises(KeyboardInterrupt):
        pycnc.run(SQUARE, machine=exact)
    assert threading.active_count() == before


def test_what_planning_finds_wrong_is_told_before_what_the_run_does(exact, monkeypatch):
    monkeypatch.setattr("pycnc.kernel.Planner.pieces", lambda planner: 1 / 0)
    monkeypatch.setattr("pycnc.kernel.Simulation.pieces", lambda simulation: [][0])
    with pytest.raises(ZeroDivisionError):
        pycnc.run(SQUARE, machine=exact)


def test_a_kernel_that_stands_still_is_told_with_numbers():
    controller = kernel.Simulation(HELD, Machine.load("mill3"))
    controller._nck.link.seg_head = lib.NCK_SEG_MAX  # no room that ever becomes free
    words = r"after tick 16 \(0\.016 s\), at line 0: neither"
    with pytest.raises(pycnc.InternalError, match=words):
        for _ in controller.pieces():
            pass
    assert controller.end == "stalled"


def test_few_prep_steps_starve_the_tick_and_break_no_limit(exact):
    lines = b"".join(b"G1 X%.3f Y%.3f\n" % (k * 0.02, k % 2 * 0.001) for k in range(1500))
    starved = pycnc.run(b"G21 G90 F6000\n" + lines + b"M2\n", machine=exact, prep_steps=1)
    fluent = pycnc.run(b"G21 G90 F6000\n" + lines + b"M2\n", machine=exact)
    assert fluent.summary["starved_ticks"] == 0
    assert starved.summary["time_s"] >= fluent.summary["time_s"]
    for name in "xyz":
        assert starved.summary["peaks"][name]["a"] <= 1 + 1e-6
    assert starved.summary["path_error_mm"] < 1e-9


def test_the_summary_has_the_promised_keys(trace):
    promised = {
        "file", "machine", "version", "schema_version", "period_s",
        "time_s", "ticks", "blocks", "segments",
        "length_mm", "slope", "plan_s", "run_s", "peaks", "path_error_mm", "starved_ticks",
        "limit_time_s", "diagnostics",
    }  # fmt: skip
    assert promised <= set(trace.summary)
    assert set(trace.summary["peaks"]) == {"x", "y", "z", "path"}
    limits = {
        "feed", "rapid", "corner", "curvature", "chord", "accel", "jerk", "exact_stop", "dwell",
        "wait", "lookahead", "starved", "feed_max", "spindle", "thread", "mode", "axis_v:x",
            "axis_v:y", "axis_v:z",
    }  # fmt: skip
    assert set(trace.summary["limit_time_s"]) == limits
    assert sum(trace.summary["limit_time_s"].values()) == pytest.approx(trace.summary["time_s"])


# Trace files


def test_an_npz_has_every_row_and_says_what_it_is(trace, tmp_path):
    trace.to_npz(tmp_path / "trace.npz")
    with np.load(tmp_path / "trace.npz") as archive:
        facts = json.loads(str(archive["metadata"]))
        for name, array in trace.columns.items():
            assert np.array_equal(archive[name], array)
            assert archive[name].dtype == array.dtype
    assert facts["program_sha256"] == trace.program.sha256
    assert facts["machine_sha256"] == trace.program.machine.sha256
    assert facts["units"]["joint_0_nm"] == "nm"
    assert facts["dialect"] == "linuxcnc"


def test_a_csv_has_every_row_to_the_last_bit(trace, tmp_path):
    trace.to_csv(tmp_path / "trace.csv")
    lines = (tmp_path / "trace.csv").read_text().splitlines()
    head = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    assert head["machine"] == "mill3"
    assert len(rows) == len(trace)
    assert [float(row["pos_x_mm"]) for row in rows] == trace["pos_x_mm"].tolist()
    assert [int(row["joint_2_nm"]) for row in rows] == trace["joint_2_nm"].tolist()
    assert {row["limit"] for row in rows} <= set(trace.summary["limit_time_s"])


def test_a_parquet_file_has_every_row_and_its_units(trace, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    trace.to_parquet(tmp_path / "trace.parquet")
    table = parquet.read_table(tmp_path / "trace.parquet")
    assert np.array_equal(table["pos_y_mm"].to_numpy(), trace["pos_y_mm"])
    assert table.schema.field("vel_mm_s").metadata[b"unit"] == b"mm/s"
    assert table.schema.metadata[b"machine_sha256"].decode() == trace.program.machine.sha256
    names = trace.limit_names()
    assert table["limit"].to_pylist() == [names[code] for code in trace["limit"].tolist()]


def test_a_run_written_in_pieces_equals_one_kept_whole(trace, tmp_path):
    from pycnc.report.trace import Trace

    piecewise = Trace(trace.program, keep=False, output=tmp_path / "a.npz")
    assert piecewise.columns == {}
    with np.load(tmp_path / "a.npz") as archive:
        assert all(np.array_equal(archive[name], trace[name]) for name in trace.columns)
    with pytest.raises(pycnc.StateError):
        piecewise.to_csv(tmp_path / "b.csv")


def test_a_rotary_machine_has_degrees_in_its_columns():
    trace = pycnc.run(b"G21 G90 G1 X10 A30 C-90 F600\nM2\n", machine="mill5_xyzac")
    assert trace["pos_c_deg"][-1] == -90.0
    assert trace["joint_4_nm"][-1] == -90_000_000_000
    assert trace["joint_3_nm"][-1] == 30_000_000_000


def test_a_lathe_counts_radii_where_the_program_counts_diameters():
    trace = pycnc.run(b"G21 G90 G18 G98\nG1 X30 Z-10 F600\nM30\n", machine="cak6150n")
    assert trace["pos_x_mm"][-1] == 15.0
    assert trace["joint_0_nm"][-1] == 15_000_000
    assert trace["joint_1_nm"][-1] == (300 - 10) * 1_000_000


# Pictures


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize(
    ("text", "machine", "three"),
    [
        (SQUARE, "mill3", False),
        (ARCS, "mill3", True),
        (b"G21 G90 G98 G18\nG1 X30 Z-10 F600\nM30\n", "cak6150n", False),
        (b"G21 G90\nG0 X5\nM2\n", "cao2014", False),
        (b"G21\nM2\n", "mill3", False),
    ],
)
def test_a_run_can_be_drawn(text, machine, three, tmp_path):
    pytest.importorskip("matplotlib")
    figure = pycnc.run(text, machine=machine).plot(tmp_path / "run.png")
    assert (figure.axes[0].name == "3d") == three
    assert (tmp_path / "run.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("slope", ["jerk", "linear"])
def test_a_run_goes_on_at_once_behind_a_wait_on_the_way(slope):
    moves = [f"G1 X{k * 0.02:.3f} Y{math.sin(k * 0.02):.5f}" for k in range(6000)]
    moves[3000:3000], moves[1500:1500] = ["M0"], ["T1 M6"]
    program = pycnc.load("\n".join(["G21 G90 G17 F3000", *moves, "M2", ""]), "mill3")
    planned = pycnc.plan(program, slope=slope)
    assert pycnc.run(program, slope=slope).summary["time_s"] == planned.time_s
