# SPDX-License-Identifier: MIT
"""Room 4 in bulk: the exact envelope by several roads, and Keinert's parallel look-ahead."""

import dataclasses
import functools

import numpy as np

from pycnc import errors, kernel
from pycnc.planning import dispatch
from pycnc.kernel.bind import check, ffi, lib, pointer
from pycnc.kernel.records import dtype, enum

_BACKENDS = {
    "c": lib.NCK_HOST_SERIAL,
    "simd": lib.NCK_HOST_SIMD,
    "threads": lib.NCK_HOST_THREADS,
}
_REALS = {np.dtype(np.float32): "float", np.dtype(np.float64): "double"}


def threads():
    """Return how many threads plan by default: the computer's, or ``OMP_NUM_THREADS``."""
    return lib.nck_host_threads()


def has_threads():
    """Return whether the module was built with OpenMP."""
    return bool(lib.nck_host_has_threads())


def processors():
    """Return the instruction sets that are built and that this processor has, the best one last."""
    names = [each.name.removeprefix("CPU_").lower() for each in enum("nck_host_cpu_t")]
    return tuple(names[: lib.nck_host_cpu() + 1])


def envelope(
    vv_cap, h, *, vv_start=0.0, vv_end=0.0, backend="auto", threads=None, processor=None, out=None
):
    """Room 4: the largest profile of squared speeds that caps and accelerations allow.

    The exact two-pass look-ahead: backward vv_i = min(vv_cap_i, vv_{i+1} + h_i), then forward
    vv_{i+1} = min(vv_{i+1}, vv_i + h_i). All backends give the same bits; `dispatch.last_report`
    tells who ran and why.

    Parameters
    ----------
    vv_cap : array_like
        (n,) cap of v² at every node [mm²/s²], not negative.
    h : array_like
        (n − 1,) 2·a·length of every piece [mm²/s²], not negative. If both are float32, so is all
        that follows; otherwise it is float64.
    vv_start, vv_end : float
        v² at the ends, at most [mm²/s²].
    backend : {"auto", "c", "simd", "threads", "opencl"}
        Serial, in the lanes of vectors, by OpenMP, on a device, or where a calibration found it
        quickest. ``auto`` goes on in C if a device fails, with one warning.
    threads : int, optional
        For ``"threads"``; without it, as many as the computer has.
    processor : str, optional
        One of `processors`, for comparisons; without it the best one.
    out : numpy.ndarray, optional
        (n,) array to fill; it may be vv_cap. After an error it is not to be used.

    Returns
    -------
    numpy.ndarray
        (n,) v² at every node [mm²/s²].

    Raises
    ------
    ArgumentError
        For a NaN, infinite or negative number (the first is named) and lengths that do not fit.
    DeviceError
        If a backend was named and is not here, or fails.

    Examples
    --------
    >>> envelope([9.0, 100.0, 9.0], [16.0, 4.0], vv_start=9.0, vv_end=9.0)
    array([ 9., 13.,  9.])
    """
    vv_cap, h, vv = _arrays(vv_cap, h, out)
    real, n = _REALS[vv.dtype], len(vv)
    choice = dispatch.choose(backend, real, n, _identity(), _measure)
    path = (vv_cap, h, (float(vv_start), float(vv_end)), vv)
    if choice.backend == "opencl":
        choice, report = _on_device_or_in_c(choice, real, path)
    else:
        report = _in_c(real, (choice.backend, threads, processor), *path)
    dispatch.note(dispatch.Report(choice.backend, backend, choice.why, real, n, **report))
    return vv


def _arrays(vv_cap, h, out):
    """Return caps, pieces and the array to fill: of one type, contiguous, of fitting lengths."""
    vv_cap, h = np.asarray(vv_cap), np.asarray(h)
    is_float = vv_cap.dtype == np.float32 and h.dtype == np.float32
    real = np.dtype(np.float32 if is_float else np.float64)
    vv_cap, h = np.ascontiguousarray(vv_cap, real), np.ascontiguousarray(h, real)
    if vv_cap.ndim != 1 or h.ndim != 1 or len(vv_cap) != len(h) + 1:
        raise errors.ArgumentError(f"{vv_cap.shape} nodes and {h.shape} pieces do not fit")
    if out is None:
        return vv_cap, h, np.empty_like(vv_cap)
    if out.shape != vv_cap.shape or out.dtype != real or not out.flags.c_contiguous:
        raise errors.ArgumentError(f"out must be {real}, contiguous, of shape {vv_cap.shape}")
    # Chunks read what stands beside them: nothing may be overwritten there before.
    vv_cap = vv_cap.copy() if np.may_share_memory(vv_cap, out) else vv_cap
    return vv_cap, h.copy() if np.may_share_memory(h, out) else h, out


def _choice(name, crew, processor):
    """Return the record that chooses a road of C."""
    known = processors()
    if processor is not None and processor not in known:
        raise errors.DeviceError(
            f"processor {processor!r} is not here; here: {', '.join(known)}", id="device-absent"
        )
    if name == "threads" and not has_threads():
        raise errors.DeviceError(
            "backend 'threads' is not built: the compiler had no OpenMP", id="device-absent"
        )
    if name != "threads":
        crew = 1
    elif crew is None:
        crew = threads()
    if not 1 <= crew <= lib.NCK_HOST_THREADS_MAX:
        raise errors.ArgumentError(f"threads must be 1 to {lib.NCK_HOST_THREADS_MAX}, not {crew}")
    cpu = known.index(processor) if processor else len(known) - 1
    choice = {"backend": _BACKENDS[name], "cpu": cpu, "threads": crew}
    return ffi.new("nck_host_choice_t *", choice), known[cpu], crew


def _problem(real, vv_cap, h, ends):
    """Return what an envelope is found for, as C reads it; the arrays must outlive it."""
    caps, pieces = pointer(real, vv_cap), pointer(real, h)
    return ffi.new(f"nck_host_problem_{real}_t *", [caps, pieces, len(vv_cap), *ends])


def _in_c(real, road, vv_cap, h, ends, vv):
    """Compute on a road of C, as `_choice` takes it. Returns what the report tells."""
    choice, cpu, crew = _choice(*road)
    report = ffi.new("nck_host_envelope_report_t *")
    compute = getattr(lib, f"nck_host_envelope_{real}")
    status = compute(choice, _problem(real, vv_cap, h, ends), pointer(real, vv), report)
    if status == lib.NCK_E_ARGUMENT:
        raise _bad_number(report.bad, vv_cap, h, ends)
    check(status)
    counts = ("blocks", "blocks_refused", "chunks_refused", "overlap")
    return {
        "processor": cpu,
        "threads": crew,
        **{count: getattr(report, count) for count in counts},
    }


def _on_device(vv_cap, h, ends, vv):
    """Compute on an OpenCL device. Returns what the report tells."""
    from pycnc import device

    return {"processor": str(device.envelope(vv_cap, h, *ends, vv))}


def _on_device_or_in_c(choice, real, path):
    """Compute on a device; if it fails and nobody named it, in C. Returns who did it, and how."""
    try:
        return choice, _on_device(*path)
    except errors.DeviceError as cause:
        _refuse_bad_numbers(real, *path[:3])
        if choice.is_named:
            raise
        choice = dispatch.Choice("simd", False, dispatch.fall_back(cause))
    return choice, _in_c(real, (choice.backend, None, None), *path)


def _bad_number(index, vv_cap, h, ends):
    """Return the error that names the first number that is NaN, infinite or negative."""
    named = [("vv_cap", vv_cap[index])]
    named += [("h", h[index])] if index < len(h) else [("vv_end", ends[1])]
    named += [("vv_start", ends[0])] if index == 0 else []
    what = next((f"{name} is {x}" for name, x in named if not 0 <= x < np.inf), "a number")
    return errors.ArgumentError(
        f"index {index}: {what}; it must be finite and not negative",
        id="argument",
        status=lib.NCK_E_ARGUMENT,
    )


def _refuse_bad_numbers(real, vv_cap, h, ends):
    find = getattr(lib, f"nck_host_envelope_bad_{real}")
    bad = find(_problem(real, vv_cap, h, ends))
    if bad < len(vv_cap):
        raise _bad_number(bad, vv_cap, h, ends)


# The calibration


@functools.cache
def _identity():
    return f"pycnc {kernel.version()}; {processors()[-1]}; {threads()} threads"


def chosen(real, n):
    """Return the `pycnc.planning.dispatch.Choice` that "auto" stands for at so many nodes."""
    return dispatch.choose("auto", real, n, _identity(), _measure)


def sample(real, n):
    """Return caps and pieces of a path like a milled surface's: a tenth of its nodes are corners.

    Parameters
    ----------
    real : {"float", "double"}
    n : int
        Nodes.
    """
    rng = np.random.default_rng(n)
    vv_cap = np.where(rng.random(n) < 0.1, rng.uniform(0, 1e4, n), 1e4)
    h = rng.uniform(500, 1500, max(n - 1, 0))
    kind = {"float": np.float32, "double": np.float64}[real]
    return vv_cap.astype(kind), h.astype(kind)


def time_envelope(real, backend, vv_cap, h, vv, *, seconds, processor=None, threads=None):
    """Return the least time of some runs in C [ns], after one that warms up.

    Parameters
    ----------
    real : {"float", "double"}
        Type of the arrays vv_cap, h and vv, which is filled.
    backend : {"c", "simd", "threads"}
    seconds : float
        Repeat for so long, five times at least.
    """
    choice, _, _ = _choice(backend, threads, processor)
    compute = getattr(lib, f"nck_host_measure_{real}")
    problem, result = _problem(real, vv_cap, h, (0.0, 0.0)), pointer(real, vv)
    return _least_ns(functools.partial(compute, choice, problem, result), seconds)


def time_triad(n, *, threads, seconds):
    """Return the least time of some triads a = b + s·c over n floats [ns]: the memory's bound."""
    a, b, c = (pointer("float", each) for each in np.zeros((3, n), np.float32))
    return _least_ns(functools.partial(lib.nck_host_measure_triad, b, c, n, threads, a), seconds)


def _least_ns(measure, seconds):
    """Return the least of what measure(runs) tells, repeated for so long."""
    check(measure(1))  # warms up
    best, begun = measure(5), lib.nck_host_clock_ns()
    while lib.nck_host_clock_ns() - begun < seconds * 1e9:
        best = min(best, measure(5))
    return best


def _measure(real, backend, n):
    """Return ns a node, or None for what ``auto`` does not take on its own.

    A device is not measured: its kernels take seconds to compile, which nobody asked for.
    """
    if backend == "opencl" or (backend == "threads" and threads() == 1):
        return None
    vv_cap, h = sample(real, n)
    return time_envelope(real, backend, vv_cap, h, np.empty_like(vv_cap), seconds=2e-3) / n


def _measure_all(real, backend, n):
    """As `_measure`, with the device; None if there is none."""
    if backend != "opencl":
        return _measure(real, backend, n)
    vv_cap, h = sample(real, n)
    vv, best = np.empty_like(vv_cap), np.inf
    try:
        for runs in range(6):
            begun = lib.nck_host_clock_ns()
            _on_device(vv_cap, h, (0.0, 0.0), vv)
            took = lib.nck_host_clock_ns() - begun
            best = min(best, took) if runs else np.inf  # the first one compiles
    except errors.DeviceError:
        return None
    return best / n


def calibrate(*, device=False):
    """Measure anew what ``backend="auto"`` goes by, and keep it.

    Parameters
    ----------
    device : bool
        Measure the OpenCL device too: only then ``auto`` takes it where it is the quickest.

    Returns
    -------
    pycnc.planning.dispatch.Calibration
    """
    return dispatch.calibration(_identity(), _measure_all if device else _measure, anew=True)


# Keinert's look-ahead


@dataclasses.dataclass(frozen=True)
class Keinert:
    """What the parallel look-ahead found, and how it went.

    Attributes
    ----------
    vv : numpy.ndarray
        (n,) v² at every node [mm²/s²].
    tasks : numpy.ndarray
        Of dtype ``nck_host_keinert_task_t``, a row for each look-ahead buffer: ``first``,
        ``count``, ``overlap_before``, ``overlap_behind``, ``too_short``, ``dropped``, ``thread``,
        ``entry_ns``, ``exit_ns``.
    certain : numpy.ndarray
        (n,) False where a task reports a drop: there vv may be lower than the exact envelope.
    wall_ns : int
        Time of the whole call: tasks, filling of buffers, putting together [ns].
    """

    vv: np.ndarray
    tasks: np.ndarray
    certain: np.ndarray
    wall_ns: int

    @property
    def dropped(self):
        """Nodes that may lie lower than needed, because the largest overlap was too short."""
        return int(self.tasks["dropped"].sum())


def keinert(
    vv_cap, h, vv_feed, *, vv_start=0.0, vv_end=0.0, length=300, overlap=(5, 50), threads=None
):
    """Room 4 as Keinert et al. (2014) run it: look-ahead buffers with an overlap, a task for each.

    Parameters
    ----------
    vv_cap, h, vv_start, vv_end
        As for `envelope`.
    vv_feed : array_like
        (n − 1,) programmed feed of every block, squared [mm²/s²].
    length : int
        Blocks of a look-ahead buffer, 2 at least.
    overlap : (int, int)
        Least and most blocks of overlap. Between them it ends where the path suffices to reach the
        feed.
    threads : int, optional
        Without it, as many as the computer has.

    Returns
    -------
    Keinert
        Its profile equals the exact envelope wherever no drop is reported, and is never above it.

    Raises
    ------
    ArgumentError
        If a number is NaN, infinite or negative, or the settings are out of range.

    Examples
    --------
    >>> found = keinert(np.full(1000, 100.0), np.full(999, 8.0), np.full(999, 100.0))
    >>> found.dropped, len(found.tasks), int(found.tasks["overlap_behind"].max())
    (0, 4, 13)
    """
    arrays = [np.ascontiguousarray(each, np.float64) for each in (vv_cap, h, vv_feed)]
    n = len(arrays[0])
    if n == 0 or any(each.shape != (n - 1,) for each in arrays[1:]):
        raise errors.ArgumentError(f"shapes do not fit: {[each.shape for each in arrays]}")
    settings = _keinert_settings(length, overlap, threads)
    tasks = np.empty(lib.nck_host_keinert_tasks(settings, n), dtype("nck_host_keinert_task_t"))
    rows = lib.nck_host_keinert_rows(settings)
    buffers = np.empty((len(tasks), rows), dtype("nck_host_keinert_row_t"))
    buffers.view(np.uint8).fill(0)  # a control has its buffers at hand: no page is new when timed
    tables = ffi.new("nck_host_keinert_tables_t *")
    tables.rows = pointer("nck_host_keinert_row_t", buffers)
    tables.tasks = pointer("nck_host_keinert_task_t", tasks)
    problem = _problem("double", *arrays[:2], (vv_start, vv_end))
    feeds, vv, bad = pointer("double", arrays[2]), np.empty(n), ffi.new("size_t *")
    begun = lib.nck_host_clock_ns()
    status = lib.nck_host_keinert(settings, problem, feeds, tables, pointer("double", vv), bad)
    wall_ns = lib.nck_host_clock_ns() - begun
    if status == lib.NCK_E_ARGUMENT:
        raise errors.ArgumentError(
            f"index {bad[0]}: a number is NaN, infinite or negative", id="argument", status=status
        )
    check(status)
    return Keinert(vv, tasks, _certain(tasks, buffers), wall_ns)


def _keinert_settings(length, overlap, crew):
    crew = lib.nck_host_threads() if crew is None else crew
    crews = range(1, lib.NCK_HOST_THREADS_MAX + 1)
    if not (length >= 2 and 0 <= overlap[0] <= overlap[1] and crew in crews):
        raise errors.ArgumentError(
            f"length {length} (2 at least), overlap {overlap} (least, most) or threads {crew} "
            f"(1 to {crews[-1]}) out of range"
        )
    return ffi.new("nck_host_keinert_settings_t *", [length, *overlap, crew])


def _certain(tasks, buffers):
    """Return for every node whether its task was certain of it."""
    certain = [
        rows["vv"][before : before + count] == rows["vv_most"][before : before + count]
        for rows, before, count in zip(
            buffers, tasks["overlap_before"], tasks["count"], strict=True
        )
    ]
    return np.concatenate(certain)
