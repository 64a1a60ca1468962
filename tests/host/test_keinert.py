# SPDX-License-Identifier: MIT
"""Keinert's parallel look-ahead: equal to the serial profile wherever no drop is reported."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pycnc import errors, stages
from pycnc.planning import parallel

FEED = 100.0  # mm/s
# An acceleration of 1000 mm/s² reaches it within 5 mm.
ACCELERATION = 1000.0


def surface(n, step_mm, corners, seed=0):
    """Return (vv_cap, h, vv_feed) of a path of short blocks, some of their junctions corners."""
    rng = np.random.default_rng([n, seed])
    vv_cap = np.where(rng.random(n) < corners, rng.uniform(0, FEED**2, n), FEED**2)
    h = 2 * ACCELERATION * rng.uniform(0.5 * step_mm, 1.5 * step_mm, n - 1)
    return vv_cap, h, np.full(n - 1, FEED**2)


def test_the_profile_is_the_serial_one_if_the_overlap_suffices():
    path = surface(10_000, 0.5, 0.1)
    found = stages.keinert(*path)
    assert found.dropped == 0
    assert not found.tasks["too_short"].any()
    assert found.certain.all()
    assert (found.vv == stages.envelope(*path[:2])).all()


def test_the_overlap_is_as_long_as_the_way_to_the_feed():
    path = surface(10_000, 0.5, 0.1)
    tasks = stages.keinert(*path).tasks
    h = path[1]
    for task in tasks[:-1]:
        end = task["first"] + task["count"]
        k = int(task["overlap_behind"])
        assert h[end : end + k].sum() >= FEED**2 > h[end : end + k - 1].sum()
    for task in tasks[1:]:
        first, k = int(task["first"]), int(task["overlap_before"])
        assert h[first - k : first].sum() >= FEED**2 > h[first - k + 1 : first].sum()


def test_the_overlap_stays_between_its_bounds():
    long_blocks = stages.keinert(*surface(5000, 50, 0.1), overlap=(5, 50)).tasks
    assert set(long_blocks["overlap_behind"][:-1]) == {5}
    short_blocks = stages.keinert(*surface(5000, 0.01, 0.1), overlap=(5, 50)).tasks
    assert set(short_blocks["overlap_behind"][:-1]) == {50}
    assert short_blocks["too_short"].all()
    # the path itself ends: what is not there is not needed
    assert long_blocks["overlap_before"][0] == long_blocks["overlap_behind"][-1] == 0


def test_an_overlap_that_is_too_short_drops_and_says_where():
    path = surface(10_000, 0.01, 0.0005)
    want = stages.envelope(*path[:2])
    found = stages.keinert(*path)
    lower = found.vv < want
    assert lower.any()
    assert not (lower & found.certain).any()
    assert (found.vv <= want).all()
    assert found.dropped == (~found.certain).sum() >= lower.sum()
    by_task = np.add.reduceat(~found.certain, found.tasks["first"].astype(int))
    assert (found.tasks["dropped"] == by_task).all()


cap = st.floats(0, 1e4)
block = st.tuples(cap, st.floats(0, 1e4), st.floats(0, 1e4))
settings = st.fixed_dictionaries(
    {
        "length": st.integers(2, 12),
        "overlap": st.tuples(st.integers(0, 4), st.integers(4, 9)),
        "threads": st.integers(1, 3),
        "vv_start": cap,
        "vv_end": cap,
    }
)


@given(cap, st.lists(block, max_size=40), settings)
def test_the_profile_is_never_above_and_equal_where_certain(last, blocks, chosen):
    vv_cap, h, vv_feed = np.array(blocks).reshape(-1, 3).T
    vv_cap = np.append(vv_cap, last)
    found = stages.keinert(vv_cap, h, vv_feed, **chosen)
    want = stages.envelope(vv_cap, h, vv_start=chosen["vv_start"], vv_end=chosen["vv_end"])
    assert (found.vv <= want).all()
    assert (found.vv == want)[found.certain].all()


def test_the_tasks_share_all_blocks_out():
    for n in (1, 2, 299, 300, 301, 600, 10_001):
        tasks = stages.keinert(*surface(n, 0.5, 0.1)).tasks
        assert len(tasks) == -(-n // 300)
        assert list(tasks["first"]) == list(range(0, n, 300))
        assert tasks["count"].sum() == n


@pytest.mark.parametrize("threads", [1, 2, 4])
def test_time_stamps_tell_who_did_what_when(threads):
    found = stages.keinert(*surface(100_000, 0.5, 0.1), threads=threads)
    tasks = found.tasks
    crew = set(tasks["thread"])
    assert crew <= set(range(threads if parallel.has_threads() else 1))
    assert (tasks["entry_ns"] >= 0).all()
    assert (tasks["exit_ns"] <= found.wall_ns).all()
    for member in crew:
        mine = tasks[tasks["thread"] == member]
        assert (mine["exit_ns"] >= mine["entry_ns"]).all()
        assert (mine["entry_ns"][1:] >= mine["exit_ns"][:-1]).all()


@pytest.mark.parametrize("bad", [np.nan, np.inf, -1.0])
@pytest.mark.parametrize("which", [0, 1, 2])
def test_a_bad_number_is_named(which, bad):
    path = surface(2000, 0.5, 0.1)
    path[which][1234] = bad
    path[which][1500] = bad
    with pytest.raises(errors.ArgumentError, match="index 1234:"):
        stages.keinert(*path)


@pytest.mark.parametrize(
    "wrong",
    [{"length": 1}, {"overlap": (6, 5)}, {"overlap": (-1, 5)}, {"threads": 0}, {"threads": 65}],
)
def test_settings_out_of_range_are_refused(wrong):
    with pytest.raises(errors.ArgumentError, match="out of range"):
        stages.keinert(*surface(100, 0.5, 0.1), **wrong)


def test_arrays_that_do_not_fit_are_refused():
    vv_cap, h, vv_feed = surface(100, 0.5, 0.1)
    for arrays in ((vv_cap[1:], h, vv_feed), (vv_cap, h, vv_feed[1:]), ([], [], [])):
        with pytest.raises(errors.ArgumentError, match="fit"):
            stages.keinert(*arrays)
