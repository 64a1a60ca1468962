# SPDX-License-Identifier: MIT
"""Runs on other controls: stretches against sums, by hand and by seed; page, trace, comparison."""

import json
import math
import random
from pathlib import Path

import numpy as np
import pytest
from control_oracle import trapezoid
from test_control import KINDS, PRINTERS, any_program, klipper, machine_of

from pycnc import errors
from pycnc.kernel.records import copied
from pycnc.machine import Machine
from pycnc.planning import control, stretches
from pycnc.planning.plan import Plan, plan
from pycnc.program import load
from pycnc.report import compare, page
from pycnc.report.trace import Trace, run
from pycnc.report.trail import Trail

CORPUS = Path(__file__).resolve().parents[3] / "shared" / "corpus"


def traced(program):
    """Return all stretches and low points of a program, and what its planner tells."""
    planner = control.Planner(program, traced=True)
    kept = [(copied(rows), copied(feet)) for rows, feet in planner.pieces()]
    rows, feet = (np.concatenate(arrays) for arrays in zip(*kept, strict=True))
    return rows, feet, planner


def places_of(rows):
    return np.hstack([rows["end"]["xyz"], rows["end"]["abc"], rows["uvw"]])


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(4))
def test_the_stretches_are_the_plan(kind, seed):
    program = any_program(kind, seed)
    rows, feet, planner = traced(program)
    time_s = plan(program).time_s
    assert float(planner.totals["time_s"]) == time_s
    assert math.fsum(rows["duration"]) == pytest.approx(time_s, rel=1e-9)
    assert rows["end"]["t"][-1] == pytest.approx(time_s, rel=1e-9)
    # A stretch begins as fast as the one before has ended, and so long as it lasts.
    assert np.all(rows["v_begin"][1:] == rows["end"]["v"][:-1]) or kind == "marlin"
    v = (rows["v_begin"] + rows["end"]["v"]) / 2
    way = np.diff(places_of(rows), axis=0, prepend=places_of(rows)[:1])
    own = 3 if kind in PRINTERS else way.shape[1]  # a printer's length is that of the tool
    length = np.linalg.norm(way[:, :own], axis=1)
    if kind in ("klipper", "grbl", "grblhal", "fluidnc"):
        tool = length > 1e-9  # mm: what rounding leaves
        assert np.abs(v * rows["duration"] - length)[tool].max() < 1e-6
    # By line and in all they are what `time` tells.
    by_line = {part["line"]: part["time_s"] for part in Plan(program, keep=False, by="line").parts}
    lines, where = np.unique(rows["end"]["line"], return_inverse=True)
    times = np.bincount(where, rows["duration"])
    for line, time in zip(lines.tolist(), times.tolist(), strict=True):
        assert by_line.get(line, 0.0) == pytest.approx(time, rel=1e-9, abs=1e-12), line
    # Low points are in order, each with its ramps.
    assert np.all(np.diff(feet["first"].astype(np.int64)) >= 0)
    assert np.all(feet["at"] < len(rows)) and np.all(feet["first"] <= feet["at"] + 1)
    lost = math.fsum(float(cause["lost_s"]["sum"]) for cause in planner.why["causes"])
    assert math.fsum(feet["low"]["lost_s"]) <= lost + 1e-9 * time_s


@pytest.mark.parametrize("kind", KINDS)
def test_no_stretch_is_faster_than_the_control_s_limits(kind):
    program = any_program(kind, "limits")
    most_v, most_a = stretches.limits_of(program.machine)
    peaks = Trace(program, keep=False).summary["peaks"]
    assert peaks and all(set(peak) <= {"v", "a"} for peak in peaks.values())
    slack = 1.02 if kind == "marlin" else 1 + 1e-6  # its rates are whole steps
    assert max(value for peak in peaks.values() for value in peak.values()) <= slack, peaks
    assert {name for name in peaks if name != "path"} <= set(program.machine.axes)
    assert ("path" in peaks) == bool(np.isfinite(most_v[-1]) or np.isfinite(most_a[-1]))


@pytest.mark.parametrize("kind", ["klipper", "grbl", "linuxcnc"])
def test_rows_that_are_few_are_filled_again(monkeypatch, kind):
    program = any_program(kind, "few")
    whole, feet, _ = traced(program)
    monkeypatch.setattr(control, "_STRETCHES", 8)
    pieces, feet_of_pieces, _ = traced(program)
    assert pieces.tobytes() == whole.tobytes()
    assert feet_of_pieces.tobytes() == feet.tobytes()


def test_samples_of_a_line_are_those_by_hand():
    a, top, length = 1000.0, 50.0, 40.0
    trace = run("G21\nG90\nG1 X40 F3000\n", klipper())
    t, ramp = trace["t_s"], top / a
    end = trapezoid(length, a, 0, 0, top)
    up, down = np.minimum(t, ramp), np.maximum(t - (end - ramp), 0.0)
    by_hand = a * up**2 / 2 + top * (t - up - down) + (top * down - a * down**2 / 2)
    assert np.abs(trace["pos_x_mm"] - np.where(t < end, by_hand, length)).max() < 1e-9
    assert len(trace) == math.ceil(end / trace.program.machine.period_s - 1e-9)
    assert trace.summary["time_s"] == pytest.approx(end, rel=1e-12)
    assert trace["joint_0_nm"][-1] == 40_000_000


@pytest.mark.parametrize("kind", KINDS)
def test_a_run_and_a_page_have_the_time_of_time(kind):
    program = any_program(kind, "page")
    time_s = plan(program).time_s
    trace = Trace(program)
    assert trace.summary["time_s"] == time_s and trace.summary["end"] == "done"
    assert 0 <= len(trace) * program.machine.period_s - time_s < program.machine.period_s * 1.001
    _, found = page.make(program)
    assert found.time_s == time_s
    trail = Trail(program)
    Plan(program, keep=False, trail=trail.add)
    columns, told = trail.columns(program.text, [])
    assert told["points"] > 100 and told["feet"] > 10
    # The samples go on along the stretches, no faster than they are.
    steps = np.stack([np.diff(trace[f"pos_{letter}_mm"]) for letter in "xyz"])
    v = np.maximum(trace["vel_mm_s"][1:], trace["vel_mm_s"][:-1])
    most = max(v.max(), trace["feed_cmd_mm_min"].max() / 60) * program.machine.period_s
    assert np.linalg.norm(steps, axis=0).max() <= most * (1 + 1e-6)


_CUTS = {  # of LinuxCNC: lines, and lines and arcs
    "lines": ("G1 X{0} Y{1}", "G1 X{0}", "G1 X{0} Y{1} Z{2}"),
    "arcs": ("G1 X{0} Y{1}", "G2 X0 Y0 I8 J0", "G3 X6 Y0 I3 J0", "G2 X0 Y9 I-5 J4.5 Z{2}",
             "G18\nG2 X4 Z0 I2 K0\nG17"),
}  # fmt: skip


@pytest.mark.parametrize("mode, cuts, most", [
    ("G61", "lines", 1e-9), ("G61", "arcs", 0.0055), ("G64 P0.01 Q0", "lines", 0.0151),
    ("G64 P0.1 Q0", "lines", 0.1051), ("G64 P0.1 Q0.05", "lines", 0.1551),
    # Where an arc meets a line, the blend is that of two lines: it is not within P there.
    ("G64 P0.01 Q0", "arcs", 0.05), ("G64 P0.1 Q0", "arcs", 0.7),
])  # fmt: skip
@pytest.mark.parametrize("seed", range(3))
def test_linuxcnc_s_path_is_the_program_s_within_its_tolerance(mode, cuts, most, seed):
    rng, lines = random.Random(f"{mode}{seed}"), []
    for _ in range(60):
        way = [round(rng.uniform(-15, 15), 3), round(rng.uniform(-15, 15), 3), rng.randint(-1, 1)]
        lines.append(rng.choice(_CUTS[cuts]).format(*way))
    text = f"G21\nG90\n{mode}\nG91\nF3000\n" + "\n".join(lines) + "\nM2\n"
    trace = Trace(load(text.encode(), machine_of("linuxcnc")), keep=False)
    assert trace.summary["path_error_mm"] <= most


def test_behind_a_thread_the_path_goes_on_from_its_end():
    head, machine = "G21\nG90\nG95 F1\nM3 S600\n", machine_of("linuxcnc")
    thread = load(f"{head}G33 Z-10 K1\nG0 Z0\nM2\n".encode(), machine)
    alone = plan(f"{head}G0 Z-10\nM2\n", machine).totals["rapid_s"]
    assert alone > 0.1
    assert plan(thread).totals["rapid_s"] == pytest.approx(alone, rel=1e-9)
    trace = Trace(thread)
    assert trace["pos_z_mm"].min() == pytest.approx(-10, abs=0.02)
    assert trace["pos_z_mm"][-1] == pytest.approx(0, abs=1e-9)


def test_arcs_of_grbl_are_within_its_tolerance():
    text = "G21\nG90\nG1 F3000 X10\nG2 X30 Y20 I20 J0\nG3 X10 Y0 I0 J-20\nG1 X0\n"
    for tolerance in (0.002, 0.05):
        machine = machine_of("grbl", arc_tolerance=tolerance)
        error = Trace(load(text.encode(), machine), keep=False).summary["path_error_mm"]
        assert 0.4 * tolerance < error < 1.05 * tolerance


@pytest.mark.parametrize("kind", KINDS)
def test_a_comparison_with_this_kernel(kind):
    text = "G21\nG90\nG1 X40 F3000\nG1 Y30\nG1 X0\n"
    theirs = machine_of(kind)
    ours = Machine.load(theirs, set={"control.kind": "nck"})
    sides = [compare.of_trace(run(text, machine), name)
             for machine, name in ((theirs, kind), (ours, "nck"))]  # fmt: skip
    found = compare.Comparison(*sides)
    difference = plan(text, ours).time_s - plan(text, theirs).time_s
    assert found.time_s == pytest.approx(difference, abs=2 * ours.period_s)
    assert found.distance_mm < (10 if kind == "linuxcnc" else 0.1)  # a quarter of its lines
    assert {line for line, *_ in found.lines} == {3, 4, 5}


def test_what_this_kernel_alone_does_is_refused_with_a_remedy():
    program = load(b"G21\nG90\nG1 X40 F3000\n", klipper())
    for more in ({"prep_steps": 1}, {"commands": ((10, "hold"),)}):
        with pytest.raises(errors.ArgumentError, match="--set control.kind=nck"):
            Trace(program, **more)


def test_a_run_without_a_move_has_no_sample():
    trace = Trace(load(b"G21\nG90\n", klipper()))
    assert len(trace) == 0 and trace.summary["time_s"] == 0


@pytest.mark.skipif(not CORPUS.is_dir(), reason="../shared has no corpus")
@pytest.mark.parametrize("kind", ["klipper", "grbl", "linuxcnc"])
def test_samples_of_the_corpus(kind):
    rng, done = random.Random(kind), 0
    files = [file for file in CORPUS.glob("*.*") if file.stat().st_size < 600_000]
    base = Machine.load("mill3", set={"control.kind": kind, "work.zero": "unknown"})
    for file in rng.sample(sorted(files), 10):
        program = load(file.read_bytes(), base)
        if program.diagnostics.errors or not program.block_count:
            continue
        rows, _, planner = traced(program)
        time_s = float(planner.totals["time_s"])
        assert math.fsum(rows["duration"]) == pytest.approx(time_s, rel=1e-9), file.name
        done += 1
    assert done >= 3
