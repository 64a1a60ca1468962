# SPDX-License-Identifier: MIT
"""Keinert's experiments and the scaling study, as data."""

import gc
import time

import numpy as np

from pycnc import errors
from pycnc.planning import parallel
from pycnc.papers import paths
from pycnc.kernel.records import free_memory

BLOCKS = (100, 300, 1_000, 3_000, 10_000, 30_000, 100_000, 300_000, 1_000_000)
SIZES = (10**3, 10**4, 10**5, 10**6, 10**7, 10**8)
BACKENDS = ("c", "simd", "threads", "opencl")
_SECONDS = 0.2  # what a measurement is repeated for, three times at least
_REAL = {"float": np.float32, "double": np.float64}
_ARRAYS = 8  # copies of a path that a size needs at most, caps, pieces and results together


def limits(blocks):
    """Return (vv_cap, h, vv_feed) of the wavy surface, as Keinert's look-ahead takes them."""
    vv_cap, h = paths.polyline_limits(
        paths.freeform(blocks), paths.FREEFORM_FEED_MM_S, paths.FREEFORM_A_MAX,
        paths.FREEFORM_PERIOD_S,
    )  # fmt: skip
    return vv_cap, h, np.full(blocks, paths.FREEFORM_FEED_MM_S**2)


def efficiency_rows(sizes=BLOCKS):
    """Return time of serial and parallel look-ahead over the number of blocks (figure 5).

    Returns
    -------
    list of dict
        blocks, tasks, serial_us: one pass each way, parallel_us: all of Keinert's on all threads,
        one_thread_us: the same on one thread, chunks_us: the kernel's own overlapped chunks on all
        threads, equal: whether all profiles are equal to the bit.
    """
    rows = []
    for blocks in sizes:
        given = limits(blocks)
        vv = np.empty(blocks + 1)
        serial_ns = parallel.time_envelope("double", "c", *given[:2], vv, seconds=_SECONDS)
        chunked, road = np.empty_like(vv), "threads" if parallel.has_threads() else "simd"
        chunks_ns = parallel.time_envelope("double", road, *given[:2], chunked, seconds=_SECONDS)
        found = _best_keinert(given)
        rows.append({
            "blocks": blocks,
            "tasks": len(found.tasks),
            "serial_us": round(serial_ns / 1e3, 1),
            "parallel_us": round(found.wall_ns / 1e3, 1),
            "one_thread_us": round(_best_keinert(given, threads=1).wall_ns / 1e3, 1),
            "chunks_us": round(chunks_ns / 1e3, 1),
            "threads": parallel.threads(),
            "equal": bool(np.array_equal(found.vv, vv) and np.array_equal(chunked, vv)),
        })  # fmt: skip
    return rows


def _best_keinert(given, **settings):
    """Return the quickest of some runs."""
    runs, begun = [], time.perf_counter()
    while len(runs) < 3 or time.perf_counter() - begun < _SECONDS:
        runs.append(parallel.keinert(*given, **settings))
    return min(runs, key=lambda found: found.wall_ns)


def profiles(blocks=200_000, short=5):
    """Return what figures 6, 7 and 8 show of one interpreter buffer.

    Parameters
    ----------
    blocks : int
    short : int
        A largest overlap that does not suffice.

    Returns
    -------
    dict
        s [mm] and speeds [mm/s] of all points: serial, parallel, short; found: the Keinert of
        enough overlap; found_short: of too little.
    """
    given = limits(blocks)
    found = _best_keinert(given)
    found_short = parallel.keinert(*given, overlap=(5, short))
    serial = parallel.envelope(*given[:2], vv_start=0, vv_end=0, backend="c")
    s = np.concatenate([[0], np.cumsum(given[1] / (2 * paths.FREEFORM_A_MAX))])
    return {
        "s": s,
        "serial": np.sqrt(serial),
        "parallel": np.sqrt(found.vv),
        "short": np.sqrt(found_short.vv),
        "found": found,
        "found_short": found_short,
    }


# The scaling study


def scaling_rows(sizes=SIZES, backends=BACKENDS, progress=None):
    """Return ns per point of every backend over the number of points, beside the triad's.

    The path is that of `parallel.sample`: a tenth of its nodes are corners.

    Returns
    -------
    list of dict
        n, real, backend, ns_per_point, of a device with own memory also copy_in_ns and copy_out_ns
        per point; equal: the same bits as C's serial pass. The backend "triad": the time in which
        memory moves as many bytes, 12 a point in float, 24 in double.
    """
    rows = []
    for n in sizes:
        for real in _REAL:
            if n * np.dtype(_REAL[real]).itemsize * _ARRAYS > free_memory():
                continue
            rows += _scaling_of(n, real, backends)
            gc.collect()
            if progress:
                progress(len(rows), None)
    return rows


def _scaling_of(n, real, backends):
    """Return the rows of one size and number type."""
    vv_cap, h = (_aligned(each) for each in parallel.sample(real, n))
    serial = parallel.envelope(vv_cap, h, vv_start=0, vv_end=0, backend="c")
    rows, vv = [], _aligned(np.empty_like(vv_cap))
    for backend in backends:
        if backend == "opencl":
            rows += _device_rows(n, real, vv_cap, h, vv, serial)
            continue
        try:
            ns = parallel.time_envelope(real, backend, vv_cap, h, vv, seconds=_SECONDS) / n
        except errors.DeviceError:
            continue  # built without threads
        rows.append(_row(n, real, backend, ns, equal=bool(np.array_equal(vv, serial))))
    numbers, crews = n * vv.itemsize // 4, {1, parallel.threads()}
    triad_ns = min(parallel.time_triad(numbers, threads=crew, seconds=_SECONDS) for crew in crews)
    return [*rows, _row(n, real, "triad", triad_ns / n)]


def _row(n, real, backend, ns, **more):
    return {"n": n, "real": real, "backend": backend, "ns_per_point": round(ns, 4), **more}


def _aligned(array):
    """Return an array at the begin of a page, where a device uses it without copies."""
    from pycnc import device

    moved = device.empty(len(array), array.dtype)
    moved[:] = array
    return moved


def _device_rows(n, real, vv_cap, h, vv, serial):
    """Return the rows of every OpenCL device: in place, and with copies in and out."""
    from pycnc import device

    try:
        kinds = [each.kind for each in device.devices() if each.kind != "oclgrind"]
    except errors.DeviceError:
        return []
    rows = []
    for kind in dict.fromkeys(kinds):
        session = device.in_use(kind)
        try:
            launch = device.EnvelopeLaunch(session, vv_cap, h, vv)
            in_place = _least_ns(lambda run=launch.run: run(0, 0)) / n
        except errors.DeviceError:
            continue  # no certain overlap within a tile: auto goes on in C there
        equal = bool(np.array_equal(vv, serial))
        rows.append(_row(n, real, f"opencl {kind}", in_place, equal=equal))
        copies = _copies_ns(session, vv_cap, h, vv)
        total = in_place + sum(copies) / n
        rows.append(_row(
            n, real, f"opencl {kind}, copies", total,
            copy_in_ns=round(copies[0] / n, 4), copy_out_ns=round(copies[1] / n, 4), equal=equal,
        ))  # fmt: skip
    return rows


def _copies_ns(session, vv_cap, h, vv):
    """Return the time [ns] of copies into a device's own memory and of the result out of it."""
    pairs = [(session.room(len(array), array.dtype), array) for array in (vv_cap, h)]
    result = session.room(len(vv), vv.dtype)

    def copy_in():
        for buffer, array in pairs:
            session.cl.enqueue_copy(session.queue, buffer, array)

    copy_in_ns = _least_ns(copy_in)
    return copy_in_ns, _least_ns(lambda: session.cl.enqueue_copy(session.queue, vv, result))


def _least_ns(work):
    """Return the least time of some runs [ns], after one that warms up."""
    work()
    times, begun = [], time.perf_counter()
    while len(times) < 3 or time.perf_counter() - begun < _SECONDS:
        before = time.perf_counter_ns()
        work()
        times.append(time.perf_counter_ns() - before)
    return min(times)
