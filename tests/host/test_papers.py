# SPDX-License-Identifier: MIT
"""The experiments of the two papers: what every implementation of them must show."""

import json
import re

import numpy as np
import pytest
from command_line import pycnc
from hypothesis import given
from hypothesis import strategies as st

from pycnc import ArgumentError, stages
from pycnc.planning import grades
from pycnc.papers import grades as papers_grades
from pycnc.papers import parallel as papers_parallel
from pycnc.papers import paths as papers

LOOKAHEADS = (0, 1, 2, 3, 4, 6, 8)
KINDS = ("linear", "sshape", "whole")
ROUNDING = 1e-9


@pytest.fixture(scope="module")
def lathe8():
    return papers.lathe8()


def totals(path, kind):
    return {n: path.profile(kind, n).time_s for n in LOOKAHEADS}


def at_ends(cells):
    """Return speed and acceleration at the ends of cells."""
    v, a, j, t = (cells[name] for name in ("v", "a", "j", "duration"))
    return v + t * (a + t * j / 2), a + t * j


# Cao et al., section 8


@pytest.mark.parametrize("kind", ["sshape", "whole"])
def test_each_of_the_first_two_look_ahead_segments_saves_time_and_no_other_does(lathe8, kind):
    time = totals(lathe8, kind)
    assert time[0] > time[1] > time[2]
    assert {time[n] for n in LOOKAHEADS if n > 2} == {time[2]}


def test_a_linear_ramp_needs_but_one_look_ahead_segment_there(lathe8):
    # it brakes within 1.4 mm, and the shortest segment has 1.83
    time = totals(lathe8, "linear")
    assert time[0] > time[1]
    assert {time[n] for n in LOOKAHEADS if n > 1} == {time[1]}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("n", [1, 2, 6])
def test_the_slowest_inner_junction_is_the_reversal_after_segment_four(lathe8, kind, n):
    inner = lathe8.profile(kind, n).v_node[1:-1]
    assert inner.argmin() + 1 == 4
    assert inner[3] == pytest.approx(lathe8.a_max * lathe8.period_s / 2)
    assert np.all(inner > 0)


@pytest.mark.parametrize("kind", KINDS)
def test_without_look_ahead_every_segment_ends_at_rest(lathe8, kind):
    assert not lathe8.profile(kind, 0).v_node.any()


def test_the_shipped_path_gives_the_printed_totals_and_its_own_tables(lathe8):
    for n, table in papers.lathe8_table()["tables"].items():
        profile = lathe8.profile("whole", int(n))
        assert (profile.v_node * 60).round(2).tolist() == table["v"]
        assert lathe8.segment_ms(profile).tolist() == table["t"]
        assert lathe8.segment_ms(profile).sum() == papers.PRINTED_MS[min(int(n), 2)]


def test_ramps_of_fixed_duration_come_near_the_printed_total_without_look_ahead(lathe8):
    total = lathe8.segment_ms(lathe8.profile("fixed", 0)).sum()
    assert total == 32000
    assert total == pytest.approx(papers.PRINTED_MS[0], rel=0.012)


@pytest.mark.parametrize("kind, n", [*((k, n) for k in KINDS for n in (0, 1, 2, 6)), ("fixed", 0)])
def test_tangential_limits_hold_at_every_period(lathe8, kind, n):
    s, v, a = lathe8.profile(kind, n).sample(lathe8.period_s)
    assert np.all((v >= -ROUNDING) & (v <= lathe8.v_max + ROUNDING))
    assert np.abs(a).max() <= lathe8.a_max + ROUNDING
    assert np.abs(np.diff(v)).max() <= lathe8.a_max * lathe8.period_s + ROUNDING
    assert np.all(np.diff(s) >= 0)
    assert s[-1] == pytest.approx(lathe8.length.sum(), abs=ROUNDING)
    assert v[-1] == a[-1] == 0


@pytest.mark.parametrize("n", [0, 1, 2, 6])
def test_the_s_shape_has_no_steps_of_acceleration_where_the_linear_ramp_has(lathe8, n):
    smooth, linear = (
        np.abs(np.diff(lathe8.profile(kind, n).sample(lathe8.period_s)[2])).max()
        for kind in ("sshape", "linear")
    )
    assert smooth <= lathe8.j_max * lathe8.period_s * (1 + ROUNDING)
    assert linear >= lathe8.a_max


def test_tangents_turn_by_half_a_turn_after_segment_four_alone(lathe8):
    assert np.flatnonzero(lathe8.v_node[1:-1] < lathe8.v_max).tolist() == [3]


# The look-ahead, whatever the path

paths = st.integers(1, 40).flatmap(
    lambda n: st.tuples(
        st.lists(st.floats(1e-3, 10), min_size=n, max_size=n),
        st.lists(st.floats(0.1, 10), min_size=n, max_size=n),
        st.lists(st.just(0.0) | st.floats(1e-3, 12), min_size=n + 1, max_size=n + 1),
    )
)


@given(
    path=paths,
    kind=st.sampled_from(KINDS),
    n=st.none() | st.integers(0, 6),
    j=st.floats(1, 1e4),
)
def test_every_profile_is_feasible(path, kind, n, j):
    length, v_cap, v_node = map(np.array, path)
    profile = stages.slope(length, v_cap, 25, j, v_node, kind=kind, lookahead=n)
    cells, node = profile.cells, profile.v_node
    v, a = at_ends(cells)
    assert np.all(node <= v_node + ROUNDING)
    # the whole length of every segment, without a gap in speed
    assert np.bincount(cells["seg"], cells["length"]) == pytest.approx(length, rel=1e-9, abs=1e-12)
    assert v[:-1] == pytest.approx(cells["v"][1:], abs=1e-7)
    assert v[cells["last"] == 1] == pytest.approx(node[1:], abs=1e-7)
    # no limit is exceeded
    assert np.all(cells["duration"] > 0)
    assert np.all(cells["v"] <= v_cap[cells["seg"]] * (1 + 1e-9))
    assert max(np.abs(cells["a"]).max(), np.abs(a).max()) <= 25 * (1 + 1e-5)
    if kind == "sshape":
        assert np.abs(cells["j"]).max() <= j * (1 + 1e-4)  # rounding of small dv


@given(path=paths, n=st.integers(0, 5))
def test_looking_further_ahead_never_lowers_a_speed_of_linear_ramps(path, n):
    length, v_cap, v_node = map(np.array, path)
    near, far, all_ = (
        stages.slope(length, v_cap, 25, 100, v_node, kind="linear", lookahead=k).v_node
        for k in (n, n + 1, None)
    )
    assert np.all(near <= far + ROUNDING)
    assert np.all(far <= all_ + ROUNDING)


def test_linear_slope_over_the_whole_path_is_the_exact_envelope():
    random = np.random.default_rng(5)
    length, v_node = random.uniform(0.01, 2, 500), random.uniform(0, 10, 501)
    v_node[[0, -1]] = 0
    profile = stages.slope(length, 10, 25, None, v_node, kind="linear")
    vv = stages.envelope(v_node**2, 2 * 25 * length, vv_start=0, vv_end=0)
    assert profile.v_node == pytest.approx(np.sqrt(vv), rel=1e-12)


@pytest.mark.parametrize(
    "change, says",
    [
        ({"length_mm": [1.0, np.nan]}, "index 1"),
        ({"length_mm": [0.0, 1.0]}, "index 0"),
        ({"v_cap": [1.0, -1.0]}, "index 1"),
        ({"a_max": np.inf}, "index 0"),
        ({"kind": "sshape", "j_max": None}, "index 0"),
        ({"v_node": [0.0, 1.0, np.nan]}, "index 2"),
        ({"v_node": [0.0, 1.0]}, "do not fit"),
        ({"length_mm": []}, "do not fit"),
        ({"kind": "round"}, "not one of"),
        ({"lookahead": -1}, "not be negative"),
        ({"kind": "fixed", "lookahead": 1}, "index 2"),
    ],
)
def test_a_number_outside_of_its_range_is_named(change, says):
    good = {"length_mm": [1.0, 1.0], "v_cap": 1.0, "a_max": 1.0, "j_max": 1.0}
    good |= {"v_node": [0.0, 1.0, 0.0]}
    with pytest.raises(ArgumentError, match=says):
        stages.slope(**(good | change))


# Cao et al., section 7: the bubble, and what its grades cost


def test_the_worked_example_is_done_in_one_sweep_and_confirmed_in_the_next():
    before, after = papers_grades.sweeps(papers_grades.WORKED_EXAMPLE)
    assert before.tolist() == [1, 5, 2, 5, 3, 1]
    assert after.tolist() == [1, 2, 2, 3, 2, 1]


@given(preplanned=st.lists(st.integers(0, 40), min_size=1, max_size=200))
def test_the_drawn_sweeps_end_where_the_kernel_ends(preplanned):
    drawn = papers_grades.sweeps(preplanned)
    kernel, made = grades.bubble(preplanned, method="sweeps")
    assert drawn[-1].tolist() == kernel.tolist() == grades.bubble(preplanned)[0].tolist()
    assert len(drawn) == made  # as many as change something, and the beginning
    assert all(np.all(later <= before) for before, later in zip(drawn, drawn[1:], strict=False))


def test_grades_in_a_chart_meet_both_criteria():
    for _, s, steps in papers_grades.charts():
        assert np.all(np.diff(s) > 0)
        assert np.abs(np.diff(steps[-1])).max() <= 1
        assert np.all(steps[-1] <= steps[0])
        assert steps[-1][0] == steps[-1][-1] == 0


def test_grades_never_save_time_against_the_exact_envelope_under_the_same_caps():
    rows = papers_grades.cost_rows(steps=(4,))
    assert {row["program"] for row in rows} == set(papers_grades.programs())
    assert all(0 <= row["cost_percent"] < 15 for row in rows)


def test_the_lathe_of_the_paper_runs_by_grades_to_the_same_end():
    runs = papers_grades.lathe_runs()
    exact, by_grades = runs["exact"], runs["grades"]
    assert by_grades.summary["time_s"] > exact.summary["time_s"]
    joints = [name for name in exact.columns if name.startswith("joint_")]
    assert len(joints) == 2
    assert [exact[name][-1] for name in joints] == [by_grades[name][-1] for name in joints]
    for axis in ("x", "z"):
        assert by_grades.summary["peaks"][axis]["v"] <= 1 + 1e-6


# Keinert et al.: the path that stands in for their workpiece


def test_the_wavy_surface_has_short_blocks_that_stay_on_it():
    points = papers.freeform(3000)
    x, y, z = points.T
    assert len(points) == 3001
    assert z == pytest.approx(4 * np.sin(x / 7) * np.cos(y / 9), abs=1e-12)
    assert np.linalg.norm(np.diff(points, axis=0), axis=1).max() < 0.8


def test_parallel_look_ahead_equals_the_serial_one_with_the_papers_overlap():
    seen = papers_parallel.profiles(blocks=20_000, short=5)
    tasks = seen["found"].tasks
    assert np.array_equal(seen["serial"], seen["parallel"])
    assert seen["found"].dropped == 0
    assert np.all(tasks["overlap_behind"][:-1] >= 5)
    assert np.all(tasks["overlap_behind"] <= 50)


def test_too_little_overlap_gives_a_lower_profile_and_says_where():
    seen = papers_parallel.profiles(blocks=20_000, short=5)
    lower = seen["short"] < seen["serial"]
    assert lower.any()
    assert np.all(seen["short"] <= seen["serial"])
    assert not np.any(lower & seen["found_short"].certain)


@pytest.mark.thorough
def test_figures_5_and_the_scaling_study_have_a_row_for_everything():
    rows = papers_parallel.efficiency_rows(sizes=(100, 1000))
    assert [row["blocks"] for row in rows] == [100, 1000]
    assert all(row["equal"] and row["serial_us"] > 0 < row["parallel_us"] for row in rows)
    rows = papers_parallel.scaling_rows(sizes=(1000,), backends=("c", "simd"))
    names = [(row["real"], row["backend"]) for row in rows]
    assert names == [(r, b) for r in ("float", "double") for b in ("c", "simd", "triad")]
    assert all(row.get("equal", True) and row["ns_per_point"] > 0 for row in rows)


@pytest.mark.seldom(4, "pycnc/bench", "pycnc/device", "opencl")
def test_copies_to_a_device_take_their_time():
    rows = papers_parallel.scaling_rows(sizes=(1_000_000,), backends=("opencl",))
    copied = [row for row in rows if "copy_in_ns" in row]
    if not copied:
        pytest.skip("no OpenCL device here")
    for row in copied:
        bytes_in = 8 if row["real"] == "float" else 16
        assert row["equal"]
        assert row["copy_in_ns"] > bytes_in / 200  # no memory moves 200 GB/s for one core


# The page and its figures


def table_row(root, first_cell):
    """Return the cells behind the first one of a table row of docs/papers.md."""
    page = (root / "docs" / "papers.md").read_text(encoding="utf-8")
    (row,) = [line for line in page.splitlines() if line.startswith(f"| {first_cell}")]
    return [cell.strip() for cell in row.strip("|").split("|")][1:]


@pytest.mark.parametrize(
    "kind, name",
    [("whole", "S over whole segments | a"), ("sshape", "S-shape | a"), ("linear", "linear | a")],
)
def test_the_page_tells_the_total_times(root, lathe8, kind, name):
    rows = papers.lookahead_rows(lathe8, (0, 1, 2, 3))
    told = [f"{row['total_ms']:,}".replace(",", " ") for row in rows if row["kind"] == kind]
    assert table_row(root, name)[-4:] == told


def test_the_page_tells_what_grades_cost(root):
    names = {
        "lathe8": "eight segments, cao2014", "turned_pin": "turned_pin, cak6150n",
        "first_part": "first_part, mill3", "freeform": "wavy surface, mill3",
    }  # fmt: skip
    rows = papers_grades.cost_rows()
    for program, name in names.items():
        costs = [row["cost_percent"] for row in rows if row["program"] == program]
        (four,) = [r for r in rows if r["program"] == program and r["steps"] == 4]
        told = [f"{cost:.2f} %" for cost in costs]
        told += [str(four["grades"]), f"{four['time_s']:.3f}", f"{four['kernel_s']:.3f}"]
        assert table_row(root, name) == told


def test_every_figure_of_the_page_is_there_and_is_a_picture(root):
    page = (root / "docs" / "papers.md").read_text(encoding="utf-8")
    named = re.findall(r"!\[[^]]+\]\((figures/[\w.]+)\)", page)
    drawn = {f"figures/{path.name}" for path in (root / "docs" / "figures").glob("*.png")}
    others = {name for name in drawn if name.startswith(("figures/report", "figures/first_part"))}
    assert set(named) == drawn - others  # README's, docs/report.md's
    for name in named:
        content = (root / "docs" / name).read_bytes()
        assert content.startswith(b"\x89PNG")
        assert len(content) < 100_000


@pytest.mark.seldom(4, "pycnc/bench", "pycnc/papers", "docs/figures")
def test_the_command_that_the_page_names_draws_what_it_shows(root, tmp_path):
    done = pycnc("lab", "bench", "cao", "--json", "-o", tmp_path)
    assert done.code == 0
    assert json.loads(done.out)["bench"] == "cao"
    assert {row["kind"] for row in json.loads(done.out)["rows"]} == {*KINDS, "fixed"}
    drawn = {path.name for path in tmp_path.iterdir()}
    assert drawn == {path.name for path in (root / "docs" / "figures").glob("cao_*.png")}


def test_a_folder_that_cannot_be_made_is_told(tmp_path):
    taken = tmp_path / "taken"
    taken.write_text("")
    done = pycnc("lab", "bench", "cao", "-o", taken)
    assert done.code == 2
    assert "cannot write it" in done.err
