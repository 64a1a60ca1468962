# SPDX-License-Identifier: MIT
"""Rows of what OpenCL costs: the envelope and the bubble on every PoCL device and GPU, beside
serial C.

On a device with memory of its own three variants tell the copies apart: all of them, the caps and
pieces on the device already, and all of it there (kernels alone).

Every variant runs on the same arrays in the same process, a warm-up first, then until its least
time has had time to show. Wrong would make it: other work on the cores (a device of two threads
loses most), a clock that changes between variants, paths where no overlap is certain.
"""

import functools
import time

import numpy as np

from pycnc import device
from pycnc.device import grades as device_grades
from pycnc.planning import grades, parallel

SIZES = (10_000, 100_000, 1_000_000, 10_000_000)
SECONDS = 0.3  # of repetition for each variant; three runs at least
KINDS = ("basic", "pthread", "gpu")  # PoCL in the calling thread, on all cores; any GPU
REALS = {"float": np.float32, "double": np.float64}
GRADES = 64
# Sweeps cost a hundred times what a scan costs: larger sizes would tell nothing more.
SWEEPS_MOST = 1_000_000
LOW_POINTS = 0.02  # share of points with a low grade, the others may have the highest


def bench_opencl_rows(sizes=SIZES, seconds=SECONDS):
    """Return rows {n, variant, ns_per_point, ratio_to_serial, equal} of envelope and bubble.

    Parameters
    ----------
    sizes : iterable of int
        Nodes.
    seconds : float
        Least time of repetition for each variant.

    Returns
    -------
    list of dict
        ratio_to_serial: how many times as fast as serial C in the same number type, in the same
        run; for the bubble as fast as one launch for each sweep on the same device, None where
        those were not run. equal: the bits of serial C.
    """
    rows = []
    for n in sizes:
        for real in REALS:
            rows += _envelope_rows(n, real, seconds)
        for kind in _kinds():
            rows += _bubble_rows(n, kind, seconds)
    return rows


def _kinds():
    there = {each.kind for each in device.devices()}
    return [kind for kind in KINDS if kind in there]


def _name(kind):
    return device.choose(kind).name if kind == "gpu" else f"PoCL {kind}"


def _least_ns(run, seconds):
    """Return the least time of one run, repeated for so long [ns]."""
    run()
    best, count, end = float("inf"), 0, time.perf_counter() + seconds
    while count < 3 or time.perf_counter() < end:
        begun = time.perf_counter_ns()
        run()
        best, count = min(best, time.perf_counter_ns() - begun), count + 1
    return best


def _row(n, variant, ns, reference_ns, equal):
    ratio = reference_ns / ns if reference_ns else None
    return {
        "n": n,
        "variant": variant,
        "ns_per_point": ns / n,
        "ratio_to_serial": ratio,
        "equal": equal,
    }


def _aligned(array):
    made = device.empty(len(array), array.dtype)
    made[:] = array
    return made


def _copy_and_run(session, vv_cap, h, vv):
    device.EnvelopeLaunch(session, vv_cap, h, vv).run(0.0, 0.0)


def _envelope_rows(n, real, seconds):
    """Return the rows of one size and number type."""
    vv_cap, h = map(_aligned, parallel.sample(real, n))
    want, vv = device.empty(n, REALS[real]), device.empty(n, REALS[real])
    serial_ns = parallel.time_envelope(real, "c", vv_cap, h, want, seconds=seconds)
    parallel.envelope(vv_cap, h, backend="c", out=want)
    rows = [_row(n, f"serial C, {real}", serial_ns, serial_ns, True)]
    for kind in _kinds():
        for name, run, finish in _variants(device.in_use(kind), vv_cap, h, vv):
            vv.fill(-1.0)
            ns = _least_ns(run, seconds)
            finish()
            equal = vv.tobytes() == want.tobytes()
            rows.append(_row(n, f"{_name(kind)}, {name}, {real}", ns, serial_ns, equal))
    return rows


def _variants(session, vv_cap, h, vv):
    """Yield (name, run, finish) of the ways to run the envelope on a device; finish: what is not
    timed and vv needs."""
    copying = device.Session(session.device)
    copying.shares_memory = False
    copies = functools.partial(_copy_and_run, copying, vv_cap, h, vv)
    launch = device.EnvelopeLaunch(session, vv_cap, h, vv)
    run = functools.partial(launch.run, 0.0, 0.0)
    if session.shares_memory:
        yield "zero-copy", run, _nothing
        yield "with copies", copies, _nothing
    else:
        yield "with copies", copies, _nothing
        yield "caps there", run, _nothing
        yield "kernels alone", functools.partial(launch.run_kernels, 0.0, 0.0), launch.fetch


def _nothing():
    pass


def _bubble_rows(n, kind, seconds):
    """Return the rows of the bubble's three forms on one device."""
    rng = np.random.default_rng(n)
    low = rng.random(n) < LOW_POINTS
    p = _aligned(np.where(low, rng.integers(0, GRADES, n), GRADES - 1).astype(np.int32))
    want, settled = grades.bubble(p)[0], device.empty(n, np.int32)
    rows, sweep_ns = [], None
    for method in ("sweep", "fused", "scan") if n <= SWEEPS_MOST else ("scan",):
        settled.fill(-1)
        run = functools.partial(device_grades.bubble, p, method, kind, settled)
        ns = _least_ns(run, seconds)
        sweep_ns = ns if method == "sweep" else sweep_ns
        equal = settled.tobytes() == want.tobytes()
        rows.append(_row(n, f"bubble by {method}, {_name(kind)}", ns, sweep_ns, equal))
    return rows
