# SPDX-License-Identifier: MIT
"""The exact envelope: feasible, the largest, the same bits whichever way it is computed."""

import cases
import judged
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sampling import cheap_first

from pycnc import stages
from pycnc.errors import ArgumentError

CASES = {str(case): case for case in cases.CASES}
FILES = {str(file): file for file in cases.RUNNING_FILES}
BLOCK = 2048  # what csrc/host/envelope.c works on at a time

square = st.floats(0, 1e6, allow_subnormal=False)
profile = st.integers(1, 40).flatmap(
    lambda n: st.tuples(
        st.lists(square, min_size=n, max_size=n), st.lists(square, min_size=n - 1, max_size=n - 1)
    )
)


def two_passes(vv_cap, h, vv_start=np.inf, vv_end=np.inf):
    """Return the envelope by its definition, one Python float after the other."""
    vv = [float(each) for each in vv_cap]
    h = [float(each) for each in h]
    vv[-1] = min(vv[-1], vv_end)
    for i in range(len(h) - 1, -1, -1):
        vv[i] = min(vv[i], vv[i + 1] + h[i])
    vv[0] = min(vv[0], vv_start)
    for i in range(len(h)):
        vv[i + 1] = min(vv[i + 1], vv[i] + h[i])
    return np.array(vv)


def fixpoint(vv_cap, h):
    """Return the largest profile by brute force: lower what breaks a rule until nothing does."""
    vv = np.array(vv_cap, float)
    while True:
        lower = vv.copy()
        lower[:-1] = np.minimum(lower[:-1], vv[1:] + h)
        lower[1:] = np.minimum(lower[1:], vv[:-1] + h)
        if (lower == vv).all():
            return vv
        vv = lower


def random_profile(n, seed, rare):
    """Return caps and pieces; rare: the share of low caps, few of them make long ramps."""
    rng = np.random.default_rng(seed)
    vv_cap = np.where(rng.random(n) < rare, rng.uniform(0, 10, n), rng.uniform(1e3, 1e4, n))
    return vv_cap, rng.uniform(0.1, 5, n - 1)


@given(profile)
def test_the_envelope_is_the_largest_that_keeps_every_rule(case):
    vv_cap, h = np.array(case[0]), np.array(case[1])
    vv = stages.envelope(vv_cap, h, vv_start=1e9, vv_end=1e9)
    assert (vv <= vv_cap).all()
    assert (vv[1:] <= vv[:-1] + h).all()
    assert (vv[:-1] <= vv[1:] + h).all()
    assert (vv == fixpoint(vv_cap, h)).all()


@given(profile, square, square)
def test_the_ends_are_kept(case, vv_start, vv_end):
    vv_cap, h = np.array(case[0]), np.array(case[1])
    vv = stages.envelope(vv_cap, h, vv_start=vv_start, vv_end=vv_end)
    assert vv[0] <= vv_start
    assert vv[-1] <= vv_end
    assert (vv == two_passes(vv_cap, h, vv_start, vv_end)).all()


@pytest.mark.parametrize("rare", [0.5, 0.01, 0.0005, 0])
@pytest.mark.parametrize("n", [1, 2, BLOCK - 1, BLOCK, BLOCK + 1, BLOCK + 2, 5 * BLOCK + 77])
def test_lanes_give_the_bits_of_the_plain_recurrence(n, rare):
    vv_cap, h = random_profile(n, seed=n, rare=rare)
    vv = stages.envelope(vv_cap, h)
    assert vv.tobytes() == two_passes(vv_cap, h, 0.0, 0.0).tobytes()


def test_caps_may_be_replaced_in_place():
    vv_cap, h = random_profile(3 * BLOCK, seed=1, rare=0.001)
    want = stages.envelope(vv_cap, h)
    stages.envelope(vv_cap, h, out=vv_cap)
    assert (vv_cap == want).all()


@pytest.mark.parametrize("bad", [np.nan, np.inf, -1.0])
@pytest.mark.parametrize("place", [0, 1, BLOCK, 3 * BLOCK - 1])
@pytest.mark.parametrize("which", [0, 1])
def test_a_bad_number_is_named_by_its_index(bad, place, which):
    arrays = random_profile(3 * BLOCK + 1, seed=2, rare=0.1)
    arrays[which][place : place + 2] = bad
    with pytest.raises(ArgumentError, match=f"index {place}:"):
        stages.envelope(*arrays)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -1.0])
def test_bad_ends_are_refused(bad):
    with pytest.raises(ArgumentError):
        stages.envelope([1.0, 1.0], [1.0], vv_start=bad)
    with pytest.raises(ArgumentError):
        stages.envelope([1.0, 1.0], [1.0], vv_end=bad)


# The window of the kernel


def whole_path(nodes):
    """Return the envelope of all nodes of a plan, in one piece."""
    vv_cap = np.append(nodes["vv_cap"], 0.0)
    return stages.envelope(vv_cap, 2.0 * nodes["a"] * nodes["length"])[:-1]


@pytest.mark.parametrize("name", CASES)
def test_the_window_gives_the_bits_of_the_whole_path(name):
    nodes = judged.plan(judged.load_exact(CASES[name]))[2]
    assert not nodes["open"].any()
    assert nodes["vv"].tobytes() == whole_path(nodes).tobytes()


@pytest.mark.sample(8)
@pytest.mark.parametrize("name", cheap_first(FILES, cases.DEAR_FILES))
def test_the_window_gives_the_bits_of_the_whole_path_on_real_programs(name):
    if not FILES[name].path.exists():
        pytest.skip(f"{FILES[name].path} is not here: the corpus lies beside the repository")
    nodes = judged.plan(judged.load_exact(FILES[name]))[2]
    assert not nodes["open"].any()
    assert nodes["vv"].tobytes() == whole_path(nodes).tobytes()


@pytest.mark.parametrize("blocks", [2, 3, 20])
@pytest.mark.parametrize("name", ["spiral", "random_lines_0", "random_smooth_1", "random_arcs_2"])
def test_a_short_window_never_exceeds_the_whole_path(name, blocks):
    case = CASES[name]
    change = (*case.set, f"path.lookahead_blocks={blocks}")
    nodes = judged.plan(judged.load_exact(cases.Case(name, case.text, case.machine, change)))[2]
    whole = whole_path(nodes)
    assert (nodes["vv"] <= whole).all()
    assert (nodes["vv"][1:] <= nodes["vv"][:-1] + 2.0 * (nodes["a"] * nodes["length"])[:-1]).all()
    assert nodes["open"].any() or nodes["vv"].tobytes() == whole.tobytes()
