# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench bubble`: the largest grades by sweeps and by scans, in C and on devices.

Wrong would make it: other work on the cores, and a first call that compiles (every variant is
called once before it is timed). Copies to a device and back are part of its time.
"""

import time

import numpy as np

from pycnc import device, errors
from pycnc.device import grades as device_grades
from pycnc.planning import grades

SIZES = (1_000, 10_000, 100_000, 1_000_000)
GRADES = 64  # as many as a table may have
SECONDS = 0.1  # of repetition for each variant


def cases(n):
    """Return name → preplanned grades of n points.

    ``random``: every cap at random, settled after a few sweeps. ``rare``: a low cap now and then
    and the top grade between, as on a path with corners; the worst for sweeps, which must carry
    each corner as far as its ramp reaches.
    """
    rng = np.random.default_rng(2014)
    rare = np.where(rng.random(n) < 1 / (4 * GRADES), 0, GRADES - 1)
    rare[[0, -1]] = 0
    return {
        "random": rng.integers(0, GRADES, n).astype(np.int32),
        "rare": rare.astype(np.int32),
    }


def variants():
    """Return name → function of preplanned grades to (grades, rounds), C first."""
    found = {
        "C scan": lambda p: grades.bubble(p),
        "C sweeps": lambda p: grades.bubble(p, method="sweeps"),
    }
    try:
        there = [each for each in device.devices() if each.kind != "oclgrind"]
    except errors.DeviceError:
        there = []
    for each in there:
        for method in ("scan", "sweep", "fused"):
            found[f"{each.kind} {method}"] = _on(each, method)
    return found


def _on(where, method):
    return lambda p: device_grades.bubble(p, method, where)


def bench_bubble_rows(sizes=SIZES, seconds=SECONDS):
    """Return rows {case, n, variant, rounds, ns_per_point, ratio_to_scan, equal}.

    Parameters
    ----------
    sizes : iterable of int
        Points.
    seconds : float
        Least time of repetition for each variant.

    Returns
    -------
    list of dict
        rounds: sweeps or launches, the last of which changed nothing. ratio_to_scan: how many times
        as long as the scan in C, in the same run. equal: the grades are those of the scan in C.
    """
    rows = []
    for n in sizes:
        for name, preplanned in cases(n).items():
            rows += _rows_of(name, preplanned, seconds)
    return rows


def _rows_of(name, preplanned, seconds):
    right, scan_ns, rows = grades.bubble(preplanned)[0], None, []
    for variant, settle in variants().items():
        settled, rounds = settle(preplanned)
        ns = _least_ns(settle, preplanned, seconds) / len(preplanned)
        scan_ns = scan_ns or ns
        rows.append({
            "case": name,
            "n": len(preplanned),
            "variant": variant,
            "rounds": int(rounds),
            "ns_per_point": round(ns, 3),
            "ratio_to_scan": round(ns / scan_ns, 2),
            "equal": bool(np.array_equal(settled, right)),
        })  # fmt: skip
    return rows


def _least_ns(settle, preplanned, seconds):
    """Return the least time of a call [ns]."""
    least, begun = np.inf, time.perf_counter()
    while least == np.inf or time.perf_counter() - begun < seconds:
        t = time.perf_counter_ns()
        settle(preplanned)
        least = min(least, time.perf_counter_ns() - t)
    return float(least)
