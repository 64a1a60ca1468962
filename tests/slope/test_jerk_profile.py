# SPDX-License-Identifier: MIT
"""Jerk-limited profiles of whole paths: limits at every sample, near the fastest there is; and the
numerical optimum, the programs and the measurements that say so."""

import doctest
import json

import numpy as np
import pytest

from pycnc import bench, stages
from pycnc.kernel import records
from pycnc.bench import butterfly, linuxcnc, numeric, optimum, programs, timing
from pycnc.errors import ArgumentError
from pycnc.machine import Machine
from pycnc.program import Program

PERIOD_S = 1e-3
# Of the fastest: hull - forward/backward - hull loses most where speeds at junctions are low.
NEAR, MEDIAN = 1.03, 1.006


def problem(length, v_cap, v_node, a=2000.0, j=40000.0):
    """Return a problem with the same acceleration and jerk everywhere."""
    n = len(length)
    return {
        "length_mm": np.array(length, float),
        "v_cap": np.broadcast_to(np.array(v_cap, float), n).copy(),
        "a_max": np.full(n, a),
        "j_max": np.full(n, j),
        "v_node": np.array(v_node, float),
    }


def optimum_of(given, cells=360):
    return numeric.fastest(numeric.grid_of(**given, cell_mm=given["length_mm"].sum() / cells))[1]


@pytest.mark.parametrize("seed", range(12))
def test_a_profile_keeps_every_cap_at_every_sample(seed):
    given = optimum.random_problem(seed)
    peaks = optimum.peaks(given, stages.slope(**given, kind="jerk"))
    assert peaks["v_peak"] <= 1 + 1e-9
    assert peaks["a_peak"] <= 1 + 1e-8
    assert peaks["j_peak"] <= 1 + 1e-6
    assert peaks["junction_over_mm_s"] <= 1e-9


def test_a_profile_goes_forward_over_the_whole_path_and_ends_at_rest():
    given = optimum.random_problem(3)
    profile = stages.slope(**given, kind="jerk")
    s, v, _ = profile.sample(PERIOD_S)
    assert (np.diff(s) >= -1e-12).all()
    assert s[-1] == pytest.approx(given["length_mm"].sum(), rel=1e-12)
    assert v[-1] == pytest.approx(0, abs=1e-9)
    assert len(s) == np.ceil(profile.time_s / PERIOD_S) + 1


def test_a_profile_lands_on_every_stop():
    given = problem([5, 5], 100, [0, 0, 0])
    s, v, _ = stages.slope(**given, kind="jerk").sample(PERIOD_S / 8)
    k = np.argmin(np.abs(s - 5))
    assert s[k] == pytest.approx(5, abs=1e-6)
    assert v[k] == pytest.approx(0, abs=1e-2)


def test_a_long_path_is_planned_in_longer_steps():
    """Steps of an eighth of the period would be lost in rounding beside 20 m."""
    given = problem([20_000], 500, [0, 0])
    with pytest.raises(ArgumentError, match="lost in rounding"):
        stages.slope(**given, kind="jerk", step_s=PERIOD_S / 8)
    least = 20_000 / 500 + 500 / 2000 + 2000 / 40_000
    assert stages.slope(**given, kind="jerk").time_s == pytest.approx(least, rel=5e-5)


def test_profiles_are_near_the_fastest_there_is():
    ratios = []
    for seed in range(8):
        given = optimum.random_problem(seed)
        ratios.append(stages.slope(**given, kind="jerk").time_s / optimum_of(given))
    assert max(ratios) <= NEAR
    assert np.median(ratios) <= MEDIAN


def test_acceleration_is_carried_across_junctions():
    """Many short segments without any cap at their junctions are one long one."""
    one = stages.slope(**problem([20], 80, [0, 0]), kind="jerk").time_s
    many = stages.slope(**problem([0.05] * 400, 80, [0] + [80] * 399 + [0]), kind="jerk").time_s
    stopping = stages.slope(
        **problem([0.05] * 400, 80, [0] + [80] * 399 + [0]), kind="sshape"
    ).time_s
    assert many <= 1.01 * one
    assert stopping > 1.5 * many


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"j_max": [-1.0]}, "index 0"),
        ({"v_node": [0.0, np.nan]}, "index 1"),
        ({"length_mm": [np.inf]}, "index 0"),
        ({"lookahead": 3}, "whole path"),
        ({"period_s": 0.0}, "index 1"),
        ({"j_scale": 2.0}, "index 1"),
    ],
)
def test_a_number_out_of_range_is_refused(change, words):
    with pytest.raises(ArgumentError, match=words):
        stages.slope(**{**problem([10], 50, [0, 0]), **change}, kind="jerk")


@pytest.mark.parametrize(
    ("change", "id_", "words"),
    [
        ({"period_s": 1e-6, "step_s": 1e-6}, "period", "segment 0 would never be passed"),
        ({"length_mm": [1e6], "v_cap": [1.0]}, "memory", "33,554,432 nodes"),
    ],
)
def test_a_profile_of_too_many_cells_is_refused_in_little_memory(change, id_, words):
    rooms = []

    def make(what, count, name, remedy):
        rooms.append(count * records.dtype(name).itemsize)
        return records.room(what, count, name, remedy)

    with pytest.MonkeyPatch.context() as patch, pytest.raises(ArgumentError, match=words) as caught:
        patch.setattr(stages, "room", make)
        stages.slope(**{**problem([10], 50, [0, 0]), **change}, kind="jerk")
    assert caught.value.id == id_
    assert max(rooms) < 2**27


def test_more_samples_than_memory_holds_are_refused():
    with pytest.raises(ArgumentError, match="give a longer period_s"):
        stages.slope(**problem([10], 50, [0, 0]), kind="jerk").sample(1e-14)


# The numerical optimum


@pytest.mark.parametrize(
    ("length", "a", "j", "time_s"),
    [
        (10.0, 1e6, 10_000.0, (32 * 10 / 10_000) ** (1 / 3)),  # four phases of constant jerk
        (20.0, 500.0, 1e5, 0.005 + np.sqrt(0.005**2 + 4 * 20 / 500)),  # acceleration is reached
    ],
)
def test_the_numerical_optimum_finds_closed_forms(length, a, j, time_s):
    assert optimum_of(problem([length], 1e4, [0, 0], a, j)) == pytest.approx(time_s, rel=2e-3)


def test_the_numerical_optimum_is_feasible_and_no_small_change_is_faster():
    given = optimum.random_problem(2)
    grid = numeric.grid_of(**given, cell_mm=given["length_mm"].sum() / 120)
    vv, time_s = numeric.fastest(grid)
    a = np.diff(vv) / (2 * grid.h)
    q = 2 * grid.h / (np.sqrt(vv[:-1]) + np.sqrt(vv[1:]))
    rise = np.diff(a, prepend=0, append=0)
    around = np.append(q, 0) + np.append(0, q)
    jerk = np.minimum(np.append(grid.j, np.inf), np.append(np.inf, grid.j))
    assert (vv <= grid.vv_cap * (1 + 1e-12)).all()
    assert (np.abs(a) <= grid.a).all()
    assert (np.abs(rise) <= jerk * around / 2 * (1 + 1e-9)).all()
    assert time_s == pytest.approx(q.sum())
    finer = numeric.grid_of(**given, cell_mm=given["length_mm"].sum() / 480)
    assert numeric.fastest(finer)[1] == pytest.approx(time_s, rel=0.01)


# The bench


@pytest.fixture
def stored(tmp_path):
    """Return a folder with two problems, one of them with its optimum."""
    for name, seed in (("one", 0), ("two", 4)):
        given = optimum.random_problem(seed)
        arrays = {key: given[name] for name, key in optimum.KEYS.items()}
        np.savez(tmp_path / f"{name}.npz", **arrays)
    np.savez(tmp_path / "two.opt.npz", T=optimum_of(optimum.random_problem(4)))
    return tmp_path


def test_optimum_reads_problems_and_tells_what_was_promised(stored, capsys):
    rows = bench.run("optimum", json=True, paths=stored)
    assert json.loads(capsys.readouterr().out)["rows"] == rows
    assert [row["path"] for row in rows] == ["one", "two"]
    assert {
        "path", "segments", "nodes", "time_s", "t_opt_s", "ratio", "v_peak", "a_peak", "j_peak",
        "junction_over_mm_s", "ns_per_node",
    } <= set(rows[0])  # fmt: skip
    assert rows[0]["t_opt_s"] is None
    assert 1 < rows[1]["ratio"] < NEAR
    assert all(row["ns_per_node"] > 0 for row in rows)


def test_optimum_makes_problems_of_its_own(monkeypatch, capsys):
    options = {"problems": 3, "kind": "jerk"}
    monkeypatch.setattr(optimum.bench_optimum_rows, "__kwdefaults__", options)
    rows = bench.run("optimum", json=True)
    capsys.readouterr()
    assert len(rows) == 4
    assert rows[-1]["ratio"] == pytest.approx(np.median([row["ratio"] for row in rows[:-1]]))


def test_optimum_refuses_what_is_no_problem(tmp_path):
    with pytest.raises(ArgumentError, match="no problem"):
        bench.run("optimum", paths=tmp_path)
    np.savez(tmp_path / "half.npz", L=[1.0])
    with pytest.raises(ArgumentError, match="lacks F, A, J, Vj"):
        bench.run("optimum", paths=tmp_path)


def test_peaks_see_what_breaks_a_cap():
    given = problem([10, 10], [100, 20], [0, 20, 0])
    slow = {**given, "v_cap": np.array([100.0, 10.0]), "a_max": given["a_max"] / 2}
    slow |= {"j_max": given["j_max"] / 3, "v_node": np.array([0, 12.0, 0])}
    peaks = optimum.peaks(slow, stages.slope(**given, kind="jerk"))
    assert peaks["v_peak"] == pytest.approx(2, rel=0.01)
    assert peaks["a_peak"] > 1.5
    assert peaks["j_peak"] > 2.5
    assert peaks["junction_over_mm_s"] == pytest.approx(8, abs=0.1)


def test_a_plan_is_timed():
    assert timing.jerk(problem([10, 10], 100, [0, 50, 0]), 2) > 0


# Programs


@pytest.mark.thorough
@pytest.mark.parametrize("chord_mm", [0.001, 0.01])
def test_no_chord_of_the_butterfly_leaves_the_curve_by_more_than_its_error(chord_mm):
    u = butterfly.cuts(chord_mm)
    ends = butterfly.point(u)
    ways = np.diff(ends, axis=0)
    for share in np.linspace(0, 1, 21)[1:-1]:
        apart = butterfly.point(u[:-1] + share * np.diff(u)) - ends[:-1]
        along = np.clip((apart * ways).sum(axis=1) / (ways**2).sum(axis=1), 0, 1)
        leaves = np.linalg.norm(apart - along[:, None] * ways, axis=1)
        assert leaves.max() <= chord_mm * 1.02
    assert ends[0].tolist() == [54.493, 52.139]
    assert ends[-1] == pytest.approx([54.492, 52.139], abs=1e-12)


@pytest.mark.thorough
def test_the_butterfly_is_as_long_as_the_literature_has_it():
    assert np.linalg.norm(np.diff(butterfly.polygon(0.002), axis=0), axis=1).sum() == (
        pytest.approx(382.86, abs=0.05)
    )


@pytest.mark.parametrize(
    ("make", "blocks"),
    [
        (lambda: programs.micro("G64 P0.01", 50), 52),
        (lambda: programs.zigzag("G61", 30, 2.0), 32),
        (lambda: programs.butterfly("G64 P0.01", 0.05), None),
    ],
)
def test_a_program_of_a_bench_decodes(make, blocks):
    program = Program(make(), programs.machine("linear")).check()
    assert blocks in (None, len(program.blocks))


@pytest.mark.parametrize("module", [numeric, optimum, butterfly, programs])
def test_the_examples_in_the_docstrings_run(module):
    found = doctest.testmod(module, extraglobs={"Machine": Machine})
    assert found.attempted > 0
    assert found.failed == 0


def test_rows_of_the_comparison_have_the_columns_that_they_promise(monkeypatch):
    measured = {"time_s": 2.0, "v_peak": 1.0}
    monkeypatch.setattr(linuxcnc, "measured", lambda text, machine: measured)
    monkeypatch.setattr(programs, "machine", lambda **limits: None)
    rows = linuxcnc.bench_linuxcnc_rows(linuxcnc.CASES[3:5])
    assert [row["program"] for row in rows] == ["zigzag 1 mm"] * 2
    assert {"linuxcnc_trapezoid_s", "linuxcnc_s_curve_s", "bound_s", "time_s"} <= set(rows[0])
    rows = linuxcnc.bench_butterfly_rows((0.01, 0.02), ((1000, 10_000),))
    assert [row["ratio"] for row in rows] == [1.0, 1.0]
