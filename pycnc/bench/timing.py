# SPDX-License-Identifier: MIT
"""Calls into the kernel that time it: every tick of a program, the window of room 4, profiles."""

import numpy as np

from pycnc import kernel, stages
from pycnc.kernel.bind import check, ffi, lib, pointer
from pycnc.kernel.records import dtype


def ticks(text, machine, most):
    """Run a program with prep always ahead and time every tick.

    Parameters
    ----------
    text : bytes
    machine : Machine
    most : int
        Ticks at most.

    Returns
    -------
    numpy.ndarray
        (ticks,) int64, time of every tick [ns], the clock's own taken off.

    Raises
    ------
    ProgramError

    Examples
    --------
    >>> len(ticks(b"G21 G90 G94 G17 G1 X10 F600\\nM2\\n", Machine.load("mill3"), 100))
    100
    """
    ns = np.empty(most, np.uint32)
    times = ffi.new("nck_host_times_t *", [pointer("uint32_t", ns), most, 0])
    given = ffi.from_buffer("char[]", text)
    check(
        lib.nck_host_bench_ticks(ffi.new("nck_t *"), machine.pointer, given, len(text), times)
    )
    return np.maximum(ns[: times.count].astype(np.int64) - lib.nck_host_bench_clock(), 0)


def window(segs, machine):
    """Send segs through the look-ahead's window alone.

    Parameters
    ----------
    segs : numpy.ndarray
        Of dtype ``nck_seg_t``, as a plan has them.
    machine : Machine

    Returns
    -------
    ns : int
        Time of all [ns].
    pieces : int
        Nodes that came out.
    """
    lookahead, pieces = ffi.new("nck_lookahead_t *"), ffi.new("size_t *")
    ns = lib.nck_host_bench_window(
        lookahead, machine.pointer, pointer("nck_seg_t", segs), len(segs), pieces
    )
    return ns, pieces[0]


def segs_of(text, machine):
    """Return all segs of a program, of dtype ``nck_seg_t``."""
    pieces = [segs.copy() for segs, *_ in kernel.Planner(text, machine).pieces()]
    return np.concatenate(pieces, dtype=dtype("nck_seg_t"))  # else NumPy drops the padding


def jerk(problem, runs, period_s=1e-3):
    """Plan the jerk-limited profile of a path again and again.

    Parameters
    ----------
    problem : dict
        length_mm, v_cap, a_max, j_max, v_node as `pycnc.stages.slope` takes them.
    runs : int
    period_s : float

    Returns
    -------
    float
        The least time of a run [ns].
    """
    arrays = stages.checked_path(**problem)
    planner = stages.JerkPlanner(arrays, period_s, None, 0.0)
    planner.profile()  # makes room
    ns = lib.nck_host_measure_jerk(*planner.arguments, runs)
    check(min(ns, 0))
    return float(ns)
