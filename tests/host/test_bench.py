# SPDX-License-Identifier: MIT
"""Benches: they time the whole work, and their rows keep the contract; on small programs here."""

import doctest
import functools
import json
import shutil

import judged
import numpy as np
import pytest

from pycnc import bench
from pycnc.bench import cores as bench_cores
from pycnc.bench import kernel as bench_kernel
from pycnc.bench import parallel as bench_parallel
from pycnc.bench import timing
from pycnc.errors import ArgumentError, ProgramError
from pycnc.kernel.bind import lib
from pycnc.machine import Machine
from pycnc.program import Program


@pytest.fixture
def small(monkeypatch):
    """Make the programs of the benches short and let each run once."""
    for name, size in (("relief", 1500), ("arcs", 400), ("circles", 3), ("micrometres", 500)):
        made = functools.partial(getattr(bench_kernel, name), size)
        monkeypatch.setattr(bench_kernel, name, made)
    monkeypatch.setattr(bench_kernel, "LOOPS", 100)
    monkeypatch.setattr(bench_kernel, "ROUNDS", 1)
    monkeypatch.setattr(bench_cores, "ROUNDS", 1)
    monkeypatch.setattr(bench_cores, "CASES", {"linear": 40_000, "jerk": 20_000})
    rows = functools.partial(bench_parallel.bench_lookahead_rows, sizes=(1000,), seconds=0)
    monkeypatch.setattr(bench_parallel, "bench_lookahead_rows", rows)


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("made", ["relief", "arcs", "circles", "micrometres"])
def test_a_program_of_a_bench_runs_and_keeps_every_promise(made):
    text = getattr(bench_kernel, made)(300)
    judged.run(Program(text, bench_kernel.plain_machine()).check())


def test_a_loop_is_read_as_often_as_the_bench_says(small):
    program = Program(bench_kernel.loop(), bench_kernel.plain_machine()).check()
    assert (program.blocks["kind"] == lib.NCK_BLOCK_LINE).sum() == 100


def test_every_tick_is_timed_and_no_more():
    program = Program(bench_kernel.relief(500), bench_kernel.plain_machine())
    ns = timing.ticks(program.text, program.machine, 10**6)
    assert len(ns) == len(judged.rows_of(program))
    assert (ns >= 0).all()
    assert len(timing.ticks(program.text, program.machine, 7)) == 7


def test_a_program_error_is_no_time():
    with pytest.raises(ProgramError):
        timing.ticks(b"G1 QQ\n", Machine.load("mill3"), 10)


def test_the_window_alone_gives_every_node_of_the_plan():
    program = Program(bench_kernel.arcs(500), bench_kernel.plain_machine())
    segs = timing.segs_of(program.text, program.machine)
    ns, pieces = timing.window(segs, program.machine)
    assert ns > 0
    assert pieces == judged.plan(program)[0]["nodes"]


@pytest.mark.sample(quick=2)
@pytest.mark.parametrize("name", ["decode", "lookahead", "tick", "time", "cores"])
def test_a_bench_prints_json_of_the_contract(small, capsys, name):
    rows = bench.run(name, json=True)
    told = json.loads(capsys.readouterr().out)
    assert set(told) == {"bench", "commit", "machine", "rows"}
    assert set(told["machine"]) == {"cpu", "cores", "device"}
    assert told["bench"] == name
    assert told["rows"] == rows
    assert len(rows) > 1
    assert all(rows[0].keys() == row.keys() for row in rows)


def test_lookahead_tells_equality_and_ratio_to_serial(small, capsys):
    rows = bench.run("lookahead", json=True)
    capsys.readouterr()
    assert {"n", "variant", "ns_per_point", "ratio_to_serial", "equal"} <= set(rows[0])
    assert all(row["equal"] in (True, None) for row in rows)
    assert all(row["ns_per_point"] > 0 for row in rows)


def test_several_cores_have_the_bits_of_one(small, capsys):
    rows = bench.run("cores", json=True)
    capsys.readouterr()
    assert all(row["equal"] for row in rows)
    assert rows[0]["variant"] == "one core" and rows[0]["ratio_to_one_core"] == 1


def test_decode_stands_beside_rs274_where_it_is_installed(small, capsys):
    rows = bench.run("decode", json=True)
    capsys.readouterr()
    peers = {row["variant"] for row in rows}
    assert peers == {"pycnc", "rs274"} if shutil.which("rs274") else {"pycnc"}


def test_a_bench_prints_one_table_and_what_would_make_it_wrong(small, capsys):
    bench.run("tick")
    head, table, *notes = capsys.readouterr().out.split("\n\n")
    assert head.startswith("tick, ")
    names, *lines = table.splitlines()
    assert names.split() == ["case", "ticks", "ns_mean", "ns_median", "ns_99_99", "ns_max"]
    assert len(lines) == 4
    assert "Wrong would make it" in notes[0]


def test_an_unknown_bench_is_refused_with_the_list():
    with pytest.raises(ArgumentError, match="decode, lookahead"):
        bench.run("beauty")


def test_columns_are_aligned_and_what_is_missing_is_a_dash():
    rows = [{"n": 1000, "x": 2.71828, "ok": True}, {"n": 7, "x": None, "ok": np.bool_(False)}]
    lines = bench.table(rows).splitlines()
    assert lines == ["   n      x   ok", "1000  2.718  yes", "   7      -   no"]
    assert bench.table([]) == "(no rows)"


@pytest.mark.parametrize("module", [bench, timing])
def test_the_examples_in_the_docstrings_run(module):
    found = doctest.testmod(module, extraglobs={"Machine": Machine})
    assert found.attempted > 0
    assert found.failed == 0
