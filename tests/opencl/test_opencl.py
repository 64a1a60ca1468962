# SPDX-License-Identifier: MIT
"""OpenCL kernels: the bits of C on PoCL, always; no race and no overrun under Oclgrind; and what
happens when a device is absent, broken or in doubt."""

import concurrent.futures
import os
import subprocess
import sys

import cases
import judged
import numpy as np
import pytest
from envelopes import HOME_DEVICES, REALS, by_c, on_device, random_path
from hypothesis import given
from hypothesis import strategies as st
from sampling import cheap_first, examples

from pycnc import device
from pycnc.device import grades as device_grades
from pycnc.device import launch
from pycnc.planning import grades
from pycnc.bench import opencl as bench_opencl
from pycnc.errors import ArgumentError, DeviceError, NckError
from pycnc.kernel.records import dtype

PART_MIN = 2048  # of envelope.cl: below, a path is planned in one go
PROGRAMS = {str(each): each for each in (*cases.CASES, *cases.RUNNING_FILES)}


@pytest.fixture(params=HOME_DEVICES)
def home(request):
    """Return the name of a PoCL device."""
    return request.param


@pytest.fixture(params=launch.KERNELS)
def kernel(request):
    """Return which kernel file plans: that of processors or that of GPUs."""
    return request.param


# The envelope


@pytest.mark.sample(quick=80)
@pytest.mark.parametrize("real", REALS)
@pytest.mark.parametrize("rare", [0.5, 0.01, 0.0])
@pytest.mark.parametrize(
    "n", [1, 2, 3, *(PART_MIN + k for k in (-1, 0, 1, 15, 16, 17)), 8336, 8337, 8353, 40_000]
)
def test_a_device_gives_the_bits_of_c(home, kernel, n, rare, real):
    vv_cap, h = random_path(n, n, rare, real)
    want = by_c(vv_cap, h, 50.0, 20.0)
    assert on_device(home, vv_cap, h, 50.0, 20.0, kernel=kernel).tobytes() == want.tobytes()


@given(st.integers(1, 30_000), st.integers(1, 9), st.integers(0, 99), st.sampled_from(REALS),
       st.sampled_from(launch.KERNELS))  # fmt: skip
@examples(100)
def test_the_bits_do_not_depend_on_the_parts(n, count, seed, real, kernel):
    vv_cap, h = random_path(n, seed, 0.02, real, h=(10.0, 300.0))
    got = on_device("basic", vv_cap, h, 9.0, 4.0, count=count, kernel=kernel)
    assert got.tobytes() == by_c(vv_cap, h, 9.0, 4.0).tobytes()


@pytest.mark.parametrize("real", REALS)
@pytest.mark.parametrize("edge", [-1, 0, 1])
@pytest.mark.parametrize("count", [2, 3, 7])
def test_edges_of_parts_do_not_show(home, count, edge, real):
    vv_cap, h = random_path(count * PART_MIN + edge, 5, 0.01, real)
    assert on_device(home, vv_cap, h, count=count).tobytes() == by_c(vv_cap, h).tobytes()


# a = 1000 mm/s², caps to (100 mm/s)²
@pytest.mark.parametrize("real", REALS)
@pytest.mark.parametrize("length", [0.005, 0.05, 1.0, 50.0])
def test_short_and_long_segments(home, kernel, length, real):
    n = 30_000
    vv_cap, _ = random_path(n, 11, 0.01, real)
    h = np.full(n - 1, 2 * 1000 * length, real)
    assert on_device(home, vv_cap, h, kernel=kernel).tobytes() == by_c(vv_cap, h).tobytes()


@pytest.mark.parametrize("real", REALS)
def test_all_capped_and_wide_open_paths(home, kernel, real):
    vv_cap, h = random_path(20_000, 3, 0.1, real)
    steep = np.full_like(h, 1e9)
    got = on_device(home, vv_cap, steep, 1e9, 1e9, kernel=kernel)
    assert got.tobytes() == vv_cap.tobytes()
    open_cap = np.full_like(vv_cap, 1e8)
    want = by_c(open_cap, h)
    with pytest.raises(DeviceError) as caught:  # no cap is ever met: no overlap can be certain
        on_device(home, open_cap, h, count=2, kernel=kernel)
    assert caught.value.id == "device-overlap"
    # too short to be cut, or no longer than an overlap: certain again
    short = slice(0, {"parts": PART_MIN - 1, "tiles": 1025}[kernel])
    got = on_device(home, open_cap[short], h[short][:-1], kernel=kernel)
    assert got.tobytes() == by_c(open_cap[short], h[short][:-1]).tobytes() != want.tobytes()


@pytest.mark.parametrize("real", REALS)
@pytest.mark.parametrize("count", [1, 5])
def test_doubt_is_raised_and_never_a_wrong_profile(kernel, real, count):
    told = set()
    for length in (2e-5, 5e-4, 1e-3, 2e-3, 0.01):  # braking from 100 mm/s takes 5 mm
        vv_cap, _ = random_path(30_000, 2, 0.002, real)
        h = np.full(len(vv_cap) - 1, 2000 * length, real)
        try:
            got = on_device("basic", vv_cap, h, count=count, kernel=kernel)
            assert got.tobytes() == by_c(vv_cap, h).tobytes()
            told.add("certain")
        except DeviceError as error:
            told.add(error.id)
    assert told == {"certain", "device-overlap"}


# Caps rise faster than the speed may, so that no node is at its cap going forward. Pieces grow, so
# that going backward each is at its cap within an overlap. Mirrored, it is the other way round.
@pytest.mark.parametrize("real", REALS)
@pytest.mark.parametrize("step", [1, -1])
def test_doubt_in_one_direction_alone_is_told(home, kernel, real, step):
    h = np.exp(np.arange(8999) / 900)
    vv_cap = 1.1 * np.cumsum(np.append(1.0, h))
    path = (np.ascontiguousarray(each[::step], real) for each in (vv_cap, h))
    with pytest.raises(DeviceError) as caught:
        on_device(home, *path, 1e9, 1e9, count=2, kernel=kernel)
    assert caught.value.id == "device-overlap"


@pytest.mark.sample(quick=48)
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, -1.0])
@pytest.mark.parametrize("which", [0, 1])
@pytest.mark.parametrize("place", [0, 1, 15, 16, 5000, 9998])
@pytest.mark.parametrize("real", REALS)
def test_a_bad_number_is_found_wherever_it_stands(kernel, bad, which, place, real):
    arrays = random_path(10_000, 1, 0.01, real)
    arrays[which][place] = bad
    for name, count in (("basic", 1), ("pthread", 3)):
        with pytest.raises(DeviceError) as caught:
            on_device(name, *arrays, count=count, kernel=kernel)
        assert caught.value.id == "device-number"


def test_bad_ends_and_bad_caps_of_short_paths_are_found(kernel):
    vv_cap, h = random_path(100, 1, 0.01, np.float64)
    for ends in ((np.nan, 0.0), (0.0, -1.0), (np.inf, 0.0)):
        with pytest.raises(DeviceError, match="NaN"):
            on_device("basic", vv_cap, h, *ends, kernel=kernel)
    vv_cap[-1] = np.nan
    with pytest.raises(DeviceError, match="NaN"):
        on_device("basic", vv_cap, h, kernel=kernel)


def test_arrays_of_any_alignment_and_in_place(kernel):
    vv_cap, h = random_path(9001, 1, 0.01, np.float32)
    want = by_c(vv_cap, h)
    bytes_ = np.zeros(4 * 9001 + 4, np.uint8)
    odd = bytes_[4:].view(np.float32)
    odd[:] = vv_cap
    device.envelope(odd, h, 0.0, 0.0, odd, device="basic", kernel=kernel)
    assert odd.tobytes() == want.tobytes()


@pytest.mark.parametrize(
    "shapes", [(0, 0, 0), (3, 3, 3), (3, 2, 2), (3, 1, 3)], ids=lambda shapes: f"{shapes}"
)
def test_arrays_that_do_not_fit_are_refused(shapes):
    vv_cap, h, out = (np.ones(max(n, 0)) for n in shapes)
    with pytest.raises(ArgumentError):
        device.envelope(vv_cap, h, 0.0, 0.0, out)


def test_number_types_are_not_mixed():
    with pytest.raises(ArgumentError):
        device.envelope(np.ones(3, np.float32), np.ones(2), 0.0, 0.0, np.ones(3))


def nodes_of(name):
    case = PROGRAMS[name]
    if hasattr(case, "path") and not case.path.exists():
        pytest.skip(f"{case.path} is not here: the corpus lies beside the repository")
    return judged.plan(judged.load_exact(case))[2]


@pytest.mark.sample(30)
@pytest.mark.parametrize("name", cheap_first(PROGRAMS, cases.DEAR_FILES))
def test_real_paths_have_the_bits_of_c(kernel, name):
    nodes = nodes_of(name)
    if len(nodes) == 0:
        pytest.skip("no motion")
    for real in REALS:
        vv_cap = nodes["vv_cap"].astype(real)
        h = (2.0 * nodes["a"] * nodes["length"]).astype(real)[:-1]
        want = by_c(vv_cap, h)
        for home in HOME_DEVICES:
            try:
                got = on_device(home, vv_cap, h, kernel=kernel)
                assert got.tobytes() == want.tobytes()
            except DeviceError as error:
                assert error.id == "device-overlap"  # the caller plans by C then


def test_threads_may_share_a_device(home, kernel):
    paths = [random_path(500 + 10 * k, k, 0.02, np.float64) for k in range(8)]

    def planned(path):
        vv = np.empty_like(path[0])
        device.envelope(*path, 0.0, 0.0, vv, device=home, kernel=kernel)
        return vv.tobytes()

    with concurrent.futures.ThreadPoolExecutor(4) as crew:
        got = list(crew.map(planned, paths * 50))
    assert got == [by_c(*path).tobytes() for path in paths] * 50


# The bubble


def by_scan(p):
    return grades.bubble(p, method="scan")[0]


@pytest.mark.parametrize("method", ["scan", "sweep", "fused"])
def test_the_worked_example_of_the_paper(home, method):
    settled, launches = device_grades.bubble(np.array([1, 5, 2, 5, 3, 1], np.int32), method, home)
    assert settled.tolist() == [1, 2, 2, 3, 2, 1]
    assert launches == {"scan": 1, "sweep": 2, "fused": 2}[method]


@pytest.mark.parametrize("method", ["scan", "sweep", "fused"])
@pytest.mark.parametrize("n", [0, 1, 2, 63, 64, 65, 127, 128, 129, 1023, 1025, 2049, 8321, 20_000])
@pytest.mark.parametrize("top", [3, 64])
def test_every_form_of_the_bubble_gives_the_same_grades(home, method, n, top):
    rng = np.random.default_rng(n)
    p = np.where(rng.random(n) < 0.02, rng.integers(0, top, n), top).astype(np.int32)
    settled, _ = device_grades.bubble(p, method, home)
    assert settled.tolist() == by_scan(p).tolist()


@given(st.lists(st.integers(0, 5000), max_size=700))
@examples(50)
def test_the_scan_is_exact_on_all_data(p):
    p = np.array(p, np.int32)
    assert device_grades.bubble(p, "scan", "basic")[0].tolist() == by_scan(p).tolist()


def test_sweeps_sink_one_grade_each():
    p = np.full(200, 40, np.int32)
    p[0] = p[-1] = 0
    _, launches = device_grades.bubble(p, "sweep", "basic")
    assert launches == 40  # 39 sweeps lower something, the last confirms
    _, launches = device_grades.bubble(p, "fused", "basic")
    assert launches == 4  # 16 sweeps each


@pytest.mark.parametrize("bad", [-1, device_grades.NO_LIMIT])
def test_grades_out_of_range_are_refused(bad):
    with pytest.raises(ArgumentError, match="index 3"):
        device_grades.bubble(np.array([1, 1, 1, bad], np.int32))


# All four stages of the papers


def assert_grades_have_the_bits_of_c(name, kinds):
    case = PROGRAMS[name]
    if hasattr(case, "path") and not case.path.exists():
        pytest.skip(f"{case.path} is not here: the corpus lies beside the repository")
    program = judged.load_exact(case)
    plan, _ = grades.of_text(program.text, program.machine)
    if len(plan.units) == 0:
        pytest.skip("no motion")
    for kind in kinds:
        got = device_grades.plan_grades(plan.segs, plan.units, plan.stretches, kind)
        for field in vars(got):
            want = getattr(plan, field)
            assert getattr(got, field).tobytes() == want.tobytes(), field


@pytest.mark.sample(15)
@pytest.mark.parametrize("name", cheap_first(PROGRAMS, cases.DEAR_FILES))
def test_planning_by_grades_has_the_bits_of_c(name):
    assert_grades_have_the_bits_of_c(name, HOME_DEVICES)


# Devices


def test_pocl_is_at_home_with_two_devices():
    kinds = [each.kind for each in device.devices()]
    assert set(HOME_DEVICES) <= set(kinds)
    assert device.choose() == device.devices()[0]
    assert device.choose("basic").units == 1
    assert "PoCL" in str(device.choose("pthread"))  # the version tells two of them apart


def skip_without_gpu():
    if not any(each.kind == "gpu" for each in device.devices()):
        pytest.skip("no GPU here: its bits were not compared")


@pytest.mark.parametrize("real", REALS)
@pytest.mark.parametrize("n", [1, 2, 1000, 100_000, 1_000_000])
def test_a_gpu_gives_the_bits_of_c(kernel, n, real):
    skip_without_gpu()
    vv_cap, h = random_path(n, 1, 0.02, real)
    assert on_device("gpu", vv_cap, h, kernel=kernel).tobytes() == by_c(vv_cap, h).tobytes()


@pytest.mark.parametrize("method", ["scan", "fused", "sweep"])
def test_a_gpu_settles_grades_as_c_does(method):
    skip_without_gpu()
    p = np.random.default_rng(1).integers(0, 64, 100_000).astype(np.int32)
    assert device_grades.bubble(p, method, "gpu")[0].tobytes() == grades.bubble(p)[0].tobytes()


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_gpu_plans_by_grades_as_c_does(name):
    skip_without_gpu()
    assert_grades_have_the_bits_of_c(name, ["gpu"])


def test_the_environment_chooses(monkeypatch):
    monkeypatch.setenv("PYCNC_DEVICE", "basic")
    assert device.choose().kind == "basic"


@pytest.mark.parametrize("name", [*HOME_DEVICES, "oclgrind"])
def test_records_lie_where_c_has_them(name):
    told = device_grades.layout(name)
    assert len(told) == 3
    for record, numbers in told.items():
        fields = dtype(record).fields.values()
        assert numbers == [offset for _, offset in fields] + [dtype(record).itemsize]


def test_a_device_that_is_not_there_is_named_with_those_that_are():
    with pytest.raises(DeviceError, match="no OpenCL device 'tpu'; there: pthread") as caught:
        device.choose("tpu")
    assert caught.value.id == "device-absent"
    assert isinstance(caught.value, NckError)


def test_a_kernel_that_does_not_build_is_an_error(monkeypatch, tmp_path):
    used = device.in_use("basic")
    (tmp_path / "broken.cl").write_text("__kernel void broken() { nothing }")
    monkeypatch.setattr(device, "_folder", lambda name: tmp_path)
    with pytest.raises(DeviceError, match="does not build broken.cl") as caught:
        used.program("broken", "double")
    assert caught.value.id == "device-build"


def test_a_lost_device_is_an_error_and_is_found_again(monkeypatch):
    used = device.in_use("basic")

    def lost(*_):
        raise used.cl.RuntimeError("device lost")

    vv_cap, h = random_path(5000, 1, 0.1, np.float64)
    with monkeypatch.context() as broken:
        broken.setattr(used.cl, "enqueue_nd_range_kernel", lost)
        with pytest.raises(DeviceError, match="device lost") as caught:
            on_device("basic", vv_cap, h)
        with pytest.raises(DeviceError):
            device_grades.bubble(np.ones(9, np.int32), "scan", "basic")
    assert caught.value.id == "device-lost"
    assert on_device("basic", vv_cap, h).tobytes() == by_c(vv_cap, h).tobytes()


def in_process(code, **environment):
    """Run Python code in a process of its own, with changes to the environment."""
    env = {**os.environ, **{key: str(value) for key, value in environment.items()}}
    command = [sys.executable, "-c", code]
    return subprocess.run(command, capture_output=True, text=True, env=env, timeout=600)


def test_without_pyopencl_the_remedy_is_named():
    code = (
        "import sys; sys.modules['pyopencl'] = None\n"
        "from pycnc import device\n"
        "try: device.choose()\n"
        "except device.errors.DeviceError as error: print(error.id, error)"
    )
    done = in_process(code)
    assert done.stdout.startswith("device-absent")
    assert "pip install" in done.stdout


def test_a_broken_opencl_does_not_take_the_process_with_it(tmp_path):
    abort = "import os, sys\nif any('prove(' in word for word in sys.orig_argv): os.abort()\n"
    (tmp_path / "sitecustomize.py").write_text(abort)  # as PoCL does where it finds no linker
    code = (
        "from pycnc import device\n"
        "try: device.in_use('basic')\n"
        "except device.errors.DeviceError as error: print(error.id, error)\n"
        "print('still here')"
    )
    done = in_process(code, PATH=tmp_path, XDG_CACHE_HOME=tmp_path, PYTHONPATH=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("device-build")
    assert "install binutils" in done.stdout
    assert done.stdout.endswith("still here\n")


def test_a_home_that_cannot_be_written_does_not_matter(tmp_path):
    code = "from pycnc import device; print(device.probe('basic').kind, device.cache_folder())"
    nowhere = "/proc/nowhere"  # not even root makes a folder there
    done = in_process(code, HOME=nowhere, XDG_CACHE_HOME=nowhere, TMPDIR=tmp_path)
    assert done.stdout.startswith(f"basic {tmp_path}"), done.stderr


# Oclgrind


UNDER_OCLGRIND = """
import numpy as np
from pycnc import device
from pycnc.device import grades as device_grades
from pycnc.planning import grades
from pycnc.machine import Machine
used = device.in_use("oclgrind")
rng = np.random.default_rng(1)
for real in (np.float32, np.float64):
    for n, count in ((1, 1), (2, 1), (300, 1), (2049, 1), (4200, 2)):
        vv_cap, h = rng.uniform(0, 100, n).astype(real), rng.uniform(1, 30, n - 1).astype(real)
        vv = np.empty(n, real)
        for kernel in ("parts", "tiles"):
            device.EnvelopeLaunch(used, vv_cap, h, vv, count, kernel).run(1.0, 0.0)
p = rng.integers(0, 20, 1100).astype(np.int32)
for method in ("scan", "sweep", "fused"):
    device_grades.bubble(p, method, "oclgrind")
text = b"G21 G90 G94 G17 G61\\nF1200\\nG1 X2 Y1\\nG3 X4 Y1 I1 J0\\nG1 X5\\nM2\\n"
plan, _ = grades.of_text(text, Machine.load("mill3", set=["path.slope=linear"]))
device_grades.plan_grades(plan.segs, plan.units, plan.stretches, "oclgrind")
print("ran", len(plan.units))
"""

RACE = """
import numpy as np
from pycnc import device
used = device.session(device.choose("oclgrind"))
source = "__kernel void race(__global int *x) { x[0] = get_global_id(0); x[9] = 1; }"
kernel = used.cl.Program(used.context, source).build().race
x = used.cl.Buffer(used.context, used.cl.mem_flags.READ_WRITE, 8)
kernel.set_args(x)
used.cl.enqueue_nd_range_kernel(used.queue, kernel, (4,), (1,))
used.queue.finish()
"""


def oclgrind(code, log):
    done = in_process(code, OCLGRIND_DATA_RACES=1, OCLGRIND_UNINITIALIZED=0, OCLGRIND_LOG=log)
    return done, log.read_text() if log.exists() else ""


def test_oclgrind_would_tell_of_a_race_and_of_an_overrun(tmp_path):
    _, words = oclgrind(RACE, tmp_path / "log")
    assert "data race" in words
    assert "Invalid write" in words


@pytest.mark.thorough
def test_oclgrind_finds_no_race_and_no_overrun(tmp_path):
    done, words = oclgrind(UNDER_OCLGRIND, tmp_path / "log")
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("ran")
    assert words == ""


# The bench


def test_the_bench_measures_equal_bits():
    rows = bench_opencl.bench_opencl_rows(sizes=(10_000,), seconds=0.0)
    assert len(rows) == 2 * 5 + 2 * 3
    assert all(row["equal"] for row in rows)
    assert all(row["ns_per_point"] > 0 for row in rows)
