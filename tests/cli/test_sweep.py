# SPDX-License-Identifier: MIT
"""``pycnc sweep``: a grid of plans, the same bits with one worker, many, or a cluster."""

import csv
import json
import math
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from cases import spiral, star
from command_line import pycnc

from pycnc import errors, kernel, plan
from pycnc import sweep as make_sweep
from pycnc.machine import Machine
from pycnc.planning import parts, sweep, workers

AXES = ["--set", "path.j_max_mm_s3=1e4..1e6/3", "--set", "path.slope=jerk,linear"]


@pytest.fixture
def files(tmp_path):
    for name, text in (("star.ngc", star(chord=1.0)), ("spiral.ngc", spiral(chord=0.5))):
        (tmp_path / name).write_text(text)
    return [str(tmp_path / "star.ngc"), str(tmp_path / "spiral.ngc")]


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("1..5/3", ["1", "3", "5"]),
        ("1e4..1e6/3", ["10000", "100000", "1000000"]),
        ("1e6..1e4/3", ["1000000", "100000", "10000"]),
        ("0..100/5", ["0", "25", "50", "75", "100"]),
        ("0.01..0.05/2", ["0.01", "0.05"]),
        ("jerk, linear", ["jerk", "linear"]),
        ("0.01", ["0.01"]),
    ],
)
def test_values_of_a_setting(text, values):
    assert sweep.values_of(text) == values


@pytest.mark.parametrize("text", ["1..", "..5/3", "1..5", "1..5/1", "1..x/3", "1..5/0.5", "a..b/3",
                                  "1..inf/3", "nan..2/3"])  # fmt: skip
def test_a_range_that_is_none_is_told(text, files):
    with pytest.raises(errors.ArgumentError, match="no range"):
        sweep.values_of(text)
    result = pycnc("sweep", files[0], "--set", f"path.tolerance_mm={text}")
    assert (result.code, result.err.count("error[grid]")) == (2, 1)


def test_a_grid_that_is_too_large_is_counted_and_not_begun(tmp_path):
    many = ["--set", "path.j_max_mm_s3=1..2/1000", "--set", "path.a_max_mm_s2=1..2/1000"]
    result = pycnc("sweep", tmp_path / "absent.ngc", *many)
    assert result.code == 2
    assert "1,000,000 plans (1 program x 1000 x 1000)" in result.err
    assert pycnc("sweep", "x", "--set", "path.j_max_mm_s3=1..2/99999999999").code == 2


def test_rows_are_plans_in_the_order_of_the_grid(files):
    told = json.loads(pycnc("sweep", *files, *AXES, "--json").out)
    assert told["settings"]["path.slope"] == ["jerk", "linear"]
    points = [(row["file"], row["path.j_max_mm_s3"], row["path.slope"]) for row in told["rows"]]
    assert points == [(file, j, slope) for file in files for j in ("10000", "100000", "1000000")
                      for slope in ("jerk", "linear")]  # fmt: skip
    for row in told["rows"]:
        settings = [f"path.j_max_mm_s3={row['path.j_max_mm_s3']}"]
        machine = Machine.load("mill3", set=[*settings, f"path.slope={row['path.slope']}"])
        assert row["time_s"] == plan(Path(row["file"]).read_text(), machine).time_s


@pytest.mark.thorough
def test_one_two_and_eight_workers_give_the_same_bytes(files, tmp_path):
    told, tables = set(), set()
    for jobs in ("1", "2", "8"):
        table = tmp_path / f"{jobs}.csv"
        result = pycnc("sweep", *files, *AXES, "--json", "--jobs", jobs, "-o", table)
        assert (result.code, result.err) == (0, "")
        told.add(result.out)
        tables.add(table.read_bytes())
    assert (len(told), len(tables)) == (1, 1)
    rows = list(csv.DictReader(tables.pop().decode().splitlines()))
    assert len(rows) == 12
    assert float(rows[0]["time_s"]) == json.loads(told.pop())["rows"][0]["time_s"]


def test_a_cluster_gives_the_same_rows(files):
    distributed = pytest.importorskip("distributed")
    axes = {"path.slope": ["jerk", "linear"]}
    own = make_sweep(files, axes)
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None,
        protocol="inproc://",
    ) as cluster:  # fmt: skip
        there = make_sweep(files, axes, cluster=cluster.scheduler_address)
    assert there.rows == own.rows
    assert list(own.to_pandas()["time_s"]) == [row["time_s"] for row in own.rows]
    assert list(own.to_polars().columns) == own.columns


def test_a_cluster_that_is_not_there_is_told(files):
    result = pycnc("sweep", *files, *AXES, "--cluster", "nonsense://nowhere")
    assert (result.code, result.err.count("error[cluster]")) == (2, 1)


def dying(unit, machine, texts):
    """Die at one task, always or once."""
    if dict(unit.task.changes)["path.slope"] == "optimal" and not os.path.exists(texts["once"]):
        if texts["kind"] == "once":
            open(texts["once"], "w").close()
        os.kill(os.getpid(), signal.SIGKILL)
    return sweep._row(unit.task)


@pytest.mark.thorough
@pytest.mark.parametrize("kind", ["once", "always"])
def test_a_dead_worker_is_replaced_and_its_task_tried_again_then_named(kind, tmp_path):
    tasks = sweep.tasks_of(["a", "b"], {"path.slope": ["jerk", "optimal", "linear"]})
    texts = {"kind": kind, "once": str(tmp_path / "once")}
    board = sweep._Board(tasks, Machine.load("mill3"))
    found = workers.each(board.take, dying, (None, texts), 2)
    rows = {unit.number: board.put(unit, result) for unit, result in found}
    assert sorted(rows) == list(range(6))
    named = {k: row["error"] for k, row in rows.items() if row.get("error")}
    assert set(named) == ({1, 4} if kind == "always" else set())
    assert all("3 workers died at it" in words and "-9" in words for words in named.values())


# Huge programs


def with_rests(lines, every):
    """Return a program of short moves, in mm and within a tolerance, with rests and offsets that
    change on the way: what is in force at a cut is much."""
    text = ["G21 G90 G94 G17 G64 P0.02 F3000", "S9000 M3"]
    for k in range(lines):
        angle = 0.07 * k
        x, y = 30 * math.cos(angle) + 3 * math.sin(7 * angle), 30 * math.sin(angle)
        text.append(f"X{x:.4f} Y{y:.4f} Z{-2 - math.sin(angle):.4f}" if k else "G1 X33 Y0 Z-2")
        if k % every == every - 1:
            text.append(RESTS[k // every % len(RESTS)])
    return "\n".join([*text, "G0 Z0", "M2", ""])


RESTS = (
    "G4 P0.02", "M0", "T2 M6\nS8000 M4\nF2500", "G10 L2 P1 X1 Y-2", "G61", "G4 P0.01\nG64 P0.05",
    "G92 X30", "M5\nM1\nM3",
)  # fmt: skip


def sums_of(text, machine, part=None):
    planner = kernel.Planner(text.encode(), machine, (), part=part)
    for _ in planner.pieces():
        pass
    return planner.totals


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("slope", ["linear", "jerk"])
def test_parts_add_up_to_the_plan_of_the_whole_program_to_the_tick(slope):
    machine = Machine.load("mill3", set=[f"path.slope={slope}"])
    text = with_rests(6000, 97)
    cuts = list(kernel.cuts(text.encode(), machine, 90))
    found = parts.add([sums_of(text, machine, part) for part in cuts], machine)
    whole = sums_of(text, machine)
    assert len(cuts) > 30
    for name in ("ticks", "blocks", "segs", "nodes", "cells", "tool_changes", "spindle_starts"):
        assert found[name] == whole[name], name
    assert found["time_s"] == whole["time_s"]
    for name in ("cut_s", "rapid_s", "dwell_s", "length_mm"):
        assert found[name] == pytest.approx(whole[name], rel=1e-9), name


def test_a_program_is_cut_within_calls_and_loops():
    machine = Machine.load("mill3")
    text = ("G21 G90 G61 F2000\no1 sub\nG1 X[#1] Y[#2]\nG4 P0.01\nG1 X0\no1 endsub\n#5=0\n"
            "o2 while [#5 LT 40]\no1 call [#5] [3]\n#5=[#5+1]\no2 endwhile\nM2\n")  # fmt: skip
    cuts = list(kernel.cuts(text.encode(), machine, 1))
    found = parts.add([sums_of(text, machine, part) for part in cuts], machine)
    assert len(cuts) == 41
    assert found["ticks"] == sums_of(text, machine)["ticks"]


def test_no_cut_is_where_the_tool_stands_beside_its_contour():
    machine = Machine.load("mill3", set=["tool.1.radius_mm=3"])
    text = ("G21 G90 G17 G61 F1000\nT1 M6\nG1 X-20 Y0\nG41 D1 X0\nX20\nG4 P0.1\nY20\nG40 Y40\n"
            "G4 P0.1\nX0\nM2\n")  # fmt: skip
    blocks = [blocks for _, blocks in kernel.cuts(text.encode(), machine, 1)]
    cuts = list(kernel.cuts(text.encode(), machine, 1))
    found = parts.add([sums_of(text, machine, part) for part in cuts], machine)
    assert 2 <= len(blocks) <= 3
    assert found["ticks"] == sums_of(text, machine)["ticks"]


@pytest.mark.seldom(4, "pycnc/planning", "tests/cli")
def test_a_huge_program_has_the_same_bits_with_1_2_and_8_workers(tmp_path):
    file = tmp_path / "huge.ngc"
    file.write_text(with_rests(2 * parts.PART_BLOCKS + 5000, 997))
    settings = {"path.slope": ["linear", "jerk"]}
    rows = [make_sweep([file], settings, jobs=jobs).rows for jobs in (1, 2, 8)]
    assert rows[0] == rows[1] == rows[2]
    uncut = plan(file, "mill3", "jerk").totals
    assert (rows[0][1]["time_s"], rows[0][1]["total_s"]) == (uncut["time_s"], uncut["total_s"])


def test_an_error_in_a_part_is_told_once():
    board = sweep._Board(sweep.tasks_of(["a"], {"path.slope": ["jerk"]}), Machine.load("mill3"))
    unit = board.take()
    assert board.put(unit, [(b"", 10), (b"", 10), (b"", 0)]) is None
    units = [board.take() for _ in range(3)]
    assert [one.place for one in units] == [0, 1, 2] and board.take() is None
    assert board.put(units[2], sweep._row(unit.task, error="third")) is None
    assert board.put(units[0], workers.Lost("with exit code -9")) is None
    assert board.put(units[1], sweep._row(unit.task, error="second"))["error"] == (
        "3 workers died at it, the last one with exit code -9"
    )


def test_a_program_with_an_error_is_named_and_the_others_go_on(files, tmp_path):
    bad = tmp_path / "bad.ngc"
    bad.write_text("G21 G90\nG1 X10 F100 Q\nM2\n")
    result = pycnc("sweep", files[0], bad, "--set", "path.slope=jerk,linear", "--jobs", "2")
    assert result.code == 1
    assert result.err.count("bad.ngc path.slope=") == 2
    assert ":2:13: error[" in result.err
    assert result.out.count("no time") == 2
    assert "fastest" in result.out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--set", "path.slop=jerk"], "did you mean slope"),
        (["--set", "path.slope=jerk,straight"], "error[machine]"),
        (["--set", "path.slope"], "error[grid]"),
        (["--set", "path.slope=jerk", "-o", "x.txt"], "error[format]"),
        (["--set", "path.slope=jerk", "-o", "no/such/folder.csv"], "error[file]"),
    ],
)
def test_what_is_no_sweep_is_told(arguments, words, files, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = pycnc("sweep", files[0], *arguments)
    assert result.code == 2
    assert words in result.err
    assert not list(tmp_path.glob("*.part"))


@pytest.mark.parametrize(
    ("settings", "idle"),
    [
        (["path.j_max_mm_s3=1e5,2e5", "path.slope=linear"], ["path.j_max_mm_s3"]),
        (["path.j_max_mm_s3=1e5,2e5", "path.slope=linear,jerk"], []),
        (["path.slope=jerk,linear", "dialect.system=A,B"], ["dialect.system"]),
    ],
)
def test_a_setting_without_effect_on_the_whole_grid_is_a_warning(settings, idle, files):
    result = pycnc("sweep", files[0], *(word for each in settings for word in ("--set", each)))
    told = [line for line in result.err.splitlines() if "warning[no-effect]" in line]
    assert [line.partition("=")[0] for line in told] == [f"--set {key}" for key in idle]


def test_a_place_that_cannot_be_written_is_told_before_anything_is_planned(files, monkeypatch):
    monkeypatch.setattr(sweep, "Sweep", lambda *_: pytest.fail("planned"))
    result = pycnc("sweep", files[0], "--set", "path.slope=jerk", "-o", "no/such/folder.csv")
    assert (result.code, result.out) == (2, "")


@pytest.mark.thorough
def test_an_interrupt_ends_it_with_130_and_no_half_file(files, tmp_path):
    table = tmp_path / "table.csv"
    command = [sys.executable, "-m", "pycnc", "sweep", *files, "-o", table, "--jobs", "2",
               "--set", "path.j_max_mm_s3=1e4..1e6/4000"]  # fmt: skip
    process = subprocess.Popen(
        list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        start_new_session=True,
    )  # fmt: skip
    time.sleep(4)
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert (process.returncode, out) == (130, "")
    assert "Traceback" not in err
    assert not table.exists() and not list(tmp_path.glob("*.part"))


def test_workers_are_deaf_to_an_interrupt_from_their_first_instruction_on():
    code = """if True:
        import pathlib
        from pycnc.planning import workers
        for each in [workers._Worker(print, ()) for _ in range(2)]:
            print(pathlib.Path(f"/proc/{each.process.pid}/status").read_text())
            each.end()
    """
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    blocked = [int(line.split()[1], 16) for line in out.stdout.splitlines() if "SigBlk" in line]
    assert [mask >> signal.SIGINT - 1 & 1 for mask in blocked] == [1, 1]


def test_a_sweep_shows_itself(files):
    found = make_sweep(files[:1], ["path.slope=jerk,linear"])
    assert repr(found) == "<Sweep on mill3: 2 plans over 1>"
    assert found._repr_html_().count("<tr>") == 3
