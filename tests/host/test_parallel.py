# SPDX-License-Identifier: MIT
"""The exact envelope by every road of C: the bits of the serial recurrence, or a clear error."""

import doctest
import json
import warnings

import cases
import judged
import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from sampling import cheap_first

from pycnc import device, errors, stages
from pycnc.planning import dispatch, parallel
from pycnc.bench import parallel as bench_parallel

FILES = {str(file): file for file in cases.RUNNING_FILES}
REALS = {"float": np.float32, "double": np.float64}
ROADS = {
    **{f"simd {cpu}": {"backend": "simd", "processor": cpu} for cpu in parallel.processors()},
    **{f"threads {k}": {"backend": "threads", "threads": k} for k in (1, 2, 3)},
}
if not parallel.has_threads():
    ROADS = {name: road for name, road in ROADS.items() if road["backend"] != "threads"}

# Lanes are 1040 floats or 520 doubles long (65 cache lines), a block has 4, 8 or 16 of them, a
# chunk has 32 lanes; blocks, chunks and the shortest lanes begin and end around these numbers of
# nodes.
EDGES = (64, 128, 512, 2080, 4160, 8320, 16640, 33280, 66560)
SIZES = sorted({1, 2, 3, 5, 100_003, *(edge + k for edge in EDGES for k in (-1, 0, 1, 2))})

FAMILIES = {
    # name: (share of low caps, low caps up to, high cap, pieces from, to)
    "all capped": (1.0, 1e4, 1e4, 1e5, 2e5),
    "never capped": (0.0, 0, 1e30, 1, 2),
    "surface": (0.1, 1e4, 1e4, 500, 1500),
    "5 um segments": (0.01, 1e4, 1e4, 9.9, 10.1),
    "50 mm segments": (0.3, 1e4, 1e4, 9e4, 1.1e5),
    "rare stops": (0.0005, 0, 1e4, 1, 100),
    "no length": (0.2, 100, 1e4, 0, 0),
}


def family(name, n, real, seed=0):
    """Return caps and pieces of a named family."""
    share, low, high, h_from, h_to = FAMILIES[name]
    rng = np.random.default_rng([n, seed])
    vv_cap = np.where(rng.random(n) < share, rng.uniform(0, low, n), high)
    return vv_cap.astype(REALS[real]), rng.uniform(h_from, h_to, n - 1).astype(REALS[real])


def recurrence(vv_cap, h, vv_start, vv_end):
    """Return the envelope by its definition, one number after the other."""
    vv = list(vv_cap)
    vv[-1] = min(vv[-1], type(vv[-1])(vv_end))
    for i in range(len(h) - 1, -1, -1):
        vv[i] = min(vv[i], vv[i + 1] + h[i])
    vv[0] = min(vv[0], type(vv[0])(vv_start))
    for i in range(len(h)):
        vv[i + 1] = min(vv[i + 1], vv[i] + h[i])
    return np.array(vv, vv_cap.dtype)


def serial(vv_cap, h, **ends):
    return stages.envelope(vv_cap, h, backend="c", **ends)


# Equal bits


@pytest.mark.parametrize("real", REALS)
@pytest.mark.parametrize("name", FAMILIES)
def test_serial_c_is_the_recurrence(name, real):
    vv_cap, h = family(name, 700, real)
    vv = serial(vv_cap, h, vv_start=50.0, vv_end=9.5)
    assert vv.dtype == REALS[real]
    assert vv.tobytes() == recurrence(vv_cap, h, 50.0, 9.5).tobytes()


@pytest.mark.sample(quick=24)
@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize("real", REALS)
@pytest.mark.parametrize("name", FAMILIES)
def test_every_road_gives_the_bits_of_the_serial_one(name, real, road):
    for n in SIZES:
        vv_cap, h = family(name, n, real)
        want = serial(vv_cap, h, vv_start=77.0, vv_end=1e4)
        vv = stages.envelope(vv_cap, h, vv_start=77.0, vv_end=1e4, **ROADS[road])
        assert vv.tobytes() == want.tobytes(), f"{n} nodes"


number = st.one_of(
    st.sampled_from([0.0, -0.0, 1.0, 2.0**-149, 2.0**-126, 3.0e38]),
    st.floats(0, 1e5, width=32),
)
pattern = st.tuples(
    st.lists(number, min_size=1, max_size=12),
    st.lists(number, min_size=1, max_size=12),
    st.integers(1, 40_000),
    st.sampled_from(list(REALS)),
    st.sampled_from(list(ROADS)),
)


@given(pattern, number, number)
@example(([0.0, -0.0], [-0.0, 0.0], 5000, "float", "simd plain"), -0.0, 0.0)
@example(([1e30], [-0.0], 5000, "double", "simd plain"), 1.0, -0.0)
def test_random_patterns_give_the_bits_of_the_serial_road(case, vv_start, vv_end):
    caps, pieces, n, real, road = case
    vv_cap, h = np.resize(caps, n).astype(REALS[real]), np.resize(pieces, n - 1).astype(REALS[real])
    want = serial(vv_cap, h, vv_start=vv_start, vv_end=vv_end)
    vv = stages.envelope(vv_cap, h, vv_start=vv_start, vv_end=vv_end, **ROADS[road])
    assert vv.tobytes() == want.tobytes()


@pytest.mark.sample(8)
@pytest.mark.parametrize("name", cheap_first(FILES, cases.DEAR_FILES))
def test_every_road_gives_the_same_bits_on_real_programs(name):
    if not FILES[name].path.exists():
        pytest.skip(f"{FILES[name].path} is not here: the corpus lies beside the repository")
    nodes = judged.plan(judged.load_exact(FILES[name]))[2]
    if len(nodes) == 0:
        pytest.skip(f"{name} moves nothing")
    h = (2.0 * nodes["a"] * nodes["length"])[:-1]
    for real in REALS.values():
        vv_cap, pieces = nodes["vv_cap"].astype(real), h.astype(real)
        want = serial(vv_cap, pieces)
        for road in ROADS.values():
            assert stages.envelope(vv_cap, pieces, **road).tobytes() == want.tobytes()
    found = stages.keinert(nodes["vv_cap"], h, nodes["vv_piece"][:-1])
    want = serial(nodes["vv_cap"], h)
    assert (found.vv <= want).all()
    assert (found.vv == want)[found.certain].all()


@pytest.mark.parametrize("road", ["serial", *ROADS])
def test_caps_may_be_replaced_in_place(road):
    vv_cap, h = family("surface", 70_000, "float")
    want = serial(vv_cap, h)
    stages.envelope(vv_cap, h, out=vv_cap, **ROADS.get(road, {"backend": "c"}))
    assert vv_cap.tobytes() == want.tobytes()


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize("real", REALS)
def test_a_path_beyond_the_last_cache_gives_the_same_bits(real, road):
    vv_cap, h = parallel.sample(real, 2_200_000)
    want = serial(vv_cap, h)
    assert stages.envelope(vv_cap, h, **ROADS[road]).tobytes() == want.tobytes()
    stages.envelope(vv_cap, h, out=vv_cap, **ROADS[road])
    assert vv_cap.tobytes() == want.tobytes()


# The certificate and the fallback


@pytest.mark.parametrize("real", REALS)
def test_lanes_are_used_where_overlaps_are_certain(real):
    stages.envelope(*family("surface", 100_000, real), backend="simd")
    report = dispatch.last_report()
    assert report.blocks >= 6  # of 16,640 nodes, or of half as many
    assert report.blocks_refused == report.chunks_refused == 0
    assert 0 < report.overlap <= 128


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize("real", REALS)
def test_a_path_that_no_overlap_can_split_falls_back_and_says_so(real, road):
    vv_cap, h = family("never capped", 100_000, real)
    vv = stages.envelope(vv_cap, h, **ROADS[road])
    report = dispatch.last_report()
    assert report.blocks_refused > 0
    if road != "threads 1":  # its one chunk has no edge to be certain of
        assert report.chunks_refused > 0
    assert vv.tobytes() == serial(vv_cap, h).tobytes()


def test_a_ramp_longer_than_a_lane_refuses_blocks_and_not_the_chunk():
    vv_cap, h = np.full(200_000, 1e4, np.float32), np.full(199_999, 6.0, np.float32)
    vv_cap[::4096] = 0
    vv = stages.envelope(vv_cap, h, backend="simd")
    report = dispatch.last_report()
    assert report.blocks_refused > 0
    assert report.chunks_refused == 0
    assert vv.tobytes() == serial(vv_cap, h).tobytes()


# Bad numbers


@pytest.mark.sample(quick=12)
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, -1.0])
@pytest.mark.parametrize("road", ["serial", *ROADS])
@pytest.mark.parametrize("real", REALS)
def test_a_bad_number_is_named_and_nothing_is_planned(real, road, bad):
    options = ROADS.get(road, {"backend": "c"})
    n = 70_001
    for place in (0, 1, 16_640, 33_281, n - 2):
        for which, name in enumerate(("vv_cap", "h")):
            arrays = family("surface", n, real)
            arrays[which][place] = bad
            arrays[0][n - 1] = np.nan  # a later one, which is not the first
            out = np.full(n, 7, REALS[real])
            with pytest.raises(errors.ArgumentError, match=f"index {place}: {name} is"):
                stages.envelope(*arrays, out=out, **options)
            assert not out.any()


@pytest.mark.parametrize("road", ["serial", *ROADS])
@pytest.mark.parametrize("end", ["vv_start", "vv_end"])
def test_a_bad_end_is_named(road, end):
    arrays = family("surface", 1000, "double")
    with pytest.raises(errors.ArgumentError, match=f"{end} is nan"):
        stages.envelope(*arrays, **{end: np.nan}, **ROADS.get(road, {"backend": "c"}))


def test_arrays_that_do_not_fit_are_refused():
    for vv_cap, h in (([], []), ([1.0], [1.0]), ([[1.0]], []), ([1.0, 1.0], [])):
        with pytest.raises(errors.ArgumentError, match="do not fit"):
            stages.envelope(vv_cap, h)
    for out in (np.empty(3), np.empty(2, np.float32), np.empty(4)[::2]):
        with pytest.raises(errors.ArgumentError, match="out must be"):
            stages.envelope([1.0, 1.0], [1.0], out=out)
    for threads in (0, -1, 65):
        with pytest.raises(errors.ArgumentError, match="threads must be"):
            stages.envelope([1.0, 1.0], [1.0], backend="threads", threads=threads)


# The choice


@pytest.fixture
def store(tmp_path, monkeypatch):
    """Let the dispatch begin without experience, in a folder of its own. Returns its file."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.delenv("PYCNC_BACKEND", raising=False)
    monkeypatch.setattr(dispatch, "_tables", {})
    monkeypatch.setattr(dispatch, "_warned", set())
    return tmp_path / "pycnc" / "dispatch.json"


COSTS = {"c": 3.0, "simd": 1.0, "threads": None, "opencl": None}


def invented(real, backend, nodes):
    """Return costs of a computer that is not there: vectors need a start of 300 nodes."""
    del real
    return None if COSTS[backend] is None else COSTS[backend] + (backend == "simd") * 300 / nodes


def test_auto_takes_the_quickest_at_that_size(store):
    assert dispatch.choose("auto", "float", 10, "x", invented).backend == "c"
    assert dispatch.choose("auto", "float", 100, "x", invented).backend == "c"
    choice = dispatch.choose("auto", "float", 5000, "x", invented)
    assert choice.backend == "simd"
    assert "calibrated at 5,000 nodes" in choice.why
    assert store.exists()


def test_a_calibration_is_kept_for_its_computer_alone(store):
    dispatch.calibration("x", invented)
    dispatch._tables.clear()

    def refuse(*_):
        raise AssertionError("measured again")

    assert dispatch.choose("auto", "double", 5000, "x", refuse).backend == "simd"
    with pytest.raises(AssertionError):
        dispatch.choose("auto", "double", 5000, "another version", refuse)


@pytest.mark.parametrize("text", ["", "{", "[]", "{}", '{"computer": "x", "costs": {"float": {}}}'])
def test_a_damaged_calibration_is_measured_again(store, text):
    store.parent.mkdir()
    store.write_text(text)
    assert dispatch.choose("auto", "float", 5000, "x", invented).backend == "simd"
    assert json.loads(store.read_text())["costs"]["float"]["c"]


def test_a_folder_that_cannot_be_written_is_no_error(store, monkeypatch):
    store.parent.write_text("a file stands where the folder should be")
    assert dispatch.choose("auto", "float", 5000, "x", invented).backend == "simd"


def test_the_environment_names_what_auto_stands_for(store, monkeypatch):
    monkeypatch.setenv("PYCNC_BACKEND", "c")
    stages.envelope(*family("surface", 5000, "float"))
    report = dispatch.last_report()
    assert (report.backend, report.asked, report.why) == ("c", "auto", "named by PYCNC_BACKEND")
    monkeypatch.setenv("PYCNC_BACKEND", "abacus")
    with pytest.raises(errors.ArgumentError, match="abacus"):
        stages.envelope(*family("surface", 5000, "float"))


def test_the_choice_is_reported(store):
    stages.envelope(*family("surface", 20_000, "float"))
    report = dispatch.last_report()
    assert report.backend in ("c", "simd", "threads")
    assert (report.asked, report.real, report.nodes) == ("auto", "float", 20_000)
    assert "calibrated" in report.why
    stages.envelope(*family("surface", 20_000, "double"), backend="simd", processor="plain")
    assert str(dispatch.last_report()) == "simd (double, plain): named by the caller"


def broken_device(*_):
    raise errors.DeviceError("the device was lost", id="device-lost")


def test_auto_goes_on_in_c_with_one_warning(store, monkeypatch):
    monkeypatch.setattr(device, "envelope", broken_device)
    monkeypatch.setitem(COSTS, "opencl", 0.1)
    monkeypatch.setattr(parallel, "_measure", invented)
    vv_cap, h = family("surface", 5000, "float")
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        for _ in range(3):
            vv = stages.envelope(vv_cap, h)
            assert vv.tobytes() == serial(vv_cap, h).tobytes()
    assert [str(each.message) for each in told] == ["planning goes on in C: the device was lost"]
    stages.envelope(vv_cap, h)
    assert dispatch.last_report().backend == "simd"
    assert "fell back: the device was lost" in dispatch.last_report().why


def test_a_named_backend_fails_clearly(store, monkeypatch):
    monkeypatch.setattr(device, "envelope", broken_device)
    arrays = family("surface", 5000, "float")
    with pytest.raises(errors.DeviceError, match="the device was lost"):
        stages.envelope(*arrays, backend="opencl")
    monkeypatch.setenv("PYCNC_BACKEND", "opencl")
    with pytest.raises(errors.DeviceError, match="the device was lost"):
        stages.envelope(*arrays)
    with pytest.raises(errors.ArgumentError, match="abacus"):
        stages.envelope(*arrays, backend="abacus")
    with pytest.raises(errors.DeviceError, match="quantum"):
        stages.envelope(*arrays, backend="simd", processor="quantum")


def test_threads_are_refused_where_they_are_not_built(store, monkeypatch):
    monkeypatch.setattr(parallel, "has_threads", lambda: False)
    with pytest.raises(errors.DeviceError, match="no OpenMP"):
        stages.envelope([1.0, 1.0], [1.0], backend="threads")
    monkeypatch.setattr(parallel, "threads", lambda: 1)  # as C tells without OpenMP
    stages.envelope(*family("surface", 5000, "float"))
    assert dispatch.last_report().backend in ("c", "simd")
    assert "threads" not in dispatch.last_report().why


def test_a_bad_number_is_named_whatever_the_device_says(store, monkeypatch):
    monkeypatch.setattr(device, "envelope", broken_device)
    vv_cap, h = family("surface", 5000, "float")
    h[99] = np.nan
    with pytest.raises(errors.ArgumentError, match="index 99: h is nan"):
        stages.envelope(vv_cap, h, backend="opencl")


def test_the_examples_in_the_docstrings_run():
    assert doctest.testmod(parallel).failed == 0
    assert doctest.testmod(parallel).attempted >= 3


# The bench


def test_the_rows_of_the_bench_hold_equal_bits():
    rows = bench_parallel.bench_lookahead_rows(sizes=(1000, 20_000), seconds=0.001)
    assert {row["n"] for row in rows} == {1000, 20_000}
    for row in rows:
        assert row["ns_per_point"] > 0
        assert row["equal"] is (None if row["variant"].startswith("triad") else True)
    for real in REALS:
        for n in (1000, 20_000):
            names = [row["variant"] for row in rows if row["n"] == n and real in row["variant"]]
            assert sum(name.startswith("auto: ") for name in names) == 1
            assert {f"serial, {real}", f"simd, {real}"} <= set(names)
