# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench optimum`: how near a jerk-limited profile is to the fastest there is.

With --paths: every NAME.npz of a folder beside the optimum in NAME.opt.npz, if that is there.
Without: random problems with fixed seeds, beside an optimum that `pycnc.bench.numeric` finds; its
cells make it up to 0.1 % faster than the true one, so ratios are that much too large. Peaks are
taken from the path coordinate alone, sampled every period: its differences over the largest cap of
the segments that they touch. ns_per_node is the time of a whole plan over its nodes, beside the
exact two-pass envelope (speed and acceleration alone) over as many. Wrong would make it: other work
on the cores, for these two columns only.
"""

from pathlib import Path

import numpy as np

from pycnc import errors, stages
from pycnc.planning import parallel
from pycnc.bench import numeric, timing

PERIOD_S = 1e-3
FINE = 20  # samples in a period, to find the speed at a junction
RUNS = 5  # the least time counts
ENVELOPE_S = 0.01  # of repetition
PROBLEMS = 40
CELLS = 720  # of the numerical optimum
KEYS = {"length_mm": "L", "v_cap": "F", "a_max": "A", "j_max": "J", "v_node": "Vj"}


def bench_optimum_rows(paths=None, *, problems=PROBLEMS, kind="jerk"):
    """Return rows {path, segments, nodes, time_s, t_opt_s, ratio, v_peak, a_peak, j_peak,
    junction_over_mm_s, ns_per_node, envelope_ns_per_node}.

    Parameters
    ----------
    paths : path, optional
        Folder with problems.
    problems : int
        Random problems, if there is no folder.
    kind : str
        As `pycnc.stages.slope` takes it.
    """
    found = _random(problems) if paths is None else _stored(Path(paths))
    rows = [_row(name, problem, optimum, kind) for name, problem, optimum in found]
    if paths is None:
        rows.append(_median(rows))
    return rows


def _stored(folder):
    """Yield (name, problem, optimum or None) of every problem in a folder."""
    files = sorted(file for file in folder.glob("*.npz") if not file.name.endswith(".opt.npz"))
    if not files:
        raise errors.ArgumentError(f"{folder}: no problem NAME.npz is there", id="paths")
    for file in files:
        with np.load(file) as arrays:
            missing = [key for key in KEYS.values() if key not in arrays]
            if missing:
                raise errors.ArgumentError(f"{file}: lacks {', '.join(missing)}", id="paths")
            problem = {name: np.asarray(arrays[key], float) for name, key in KEYS.items()}
        solved = file.with_suffix(".opt.npz")
        optimum = None
        if solved.exists():
            with np.load(solved) as arrays:
                optimum = float(arrays["T"])
        yield file.stem, problem, optimum


def random_problem(seed):
    """Return a problem of up to twelve segments; of every second one the limits vary.

    Examples
    --------
    >>> sorted(random_problem(7)) == sorted(KEYS)
    True
    """
    rng = np.random.default_rng([1155, seed])
    n = int(rng.integers(1, 13))
    vary = rng.uniform(0.5, 1, (2, n)) if seed % 2 else np.ones((2, n))
    v_cap = 10 ** rng.uniform(1.3, 2.4, n)
    v_node = np.append(np.minimum(v_cap, np.append(np.inf, v_cap[:-1])), 0.0)
    v_node *= rng.uniform(0, 1.2, n + 1)
    v_node[[0, -1]] = 0
    return {
        "length_mm": 10 ** rng.uniform(-0.5, 1.5, n),
        "v_cap": v_cap,
        "a_max": 10 ** rng.uniform(2.5, 3.7) * vary[0],
        "j_max": 10 ** rng.uniform(4, 5.3) * vary[1],
        "v_node": v_node,
    }


def _random(problems):
    for seed in range(problems):
        problem = random_problem(seed)
        cell_mm = problem["length_mm"].sum() / CELLS
        _, optimum = numeric.fastest(numeric.grid_of(**problem, cell_mm=cell_mm))
        yield f"random {seed}", problem, optimum


def _row(name, problem, optimum, kind):
    profile = stages.slope(**problem, kind=kind, period_s=PERIOD_S)
    nodes = int(np.count_nonzero(profile.cells["length"])) + 1
    ns = timing.jerk(problem, RUNS, PERIOD_S) if kind == "jerk" else None
    return {
        "path": name,
        "segments": len(problem["length_mm"]),
        "nodes": nodes,
        "time_s": profile.time_s,
        "t_opt_s": optimum,
        "ratio": None if optimum is None else profile.time_s / optimum,
        **peaks(problem, profile),
        "ns_per_node": None if ns is None else ns / nodes,
        "envelope_ns_per_node": _envelope_ns(nodes) / nodes,
    }


def _envelope_ns(nodes):
    """Return the time of the exact two-pass envelope over so many nodes [ns]."""
    vv_cap, h = parallel.sample("double", nodes)
    vv = np.empty_like(vv_cap)
    return parallel.time_envelope(
        "double", vv_cap=vv_cap, h=h, vv=vv, backend="c", seconds=ENVELOPE_S
    )


def peaks(problem, profile):
    """Return {v_peak, a_peak, j_peak, junction_over_mm_s} of a profile.

    Parameters
    ----------
    problem : dict
        What `pycnc.stages.slope` was given.
    profile : pycnc.stages.Profile
    """
    ends = np.cumsum(problem["length_mm"])
    s, _, _ = profile.sample(PERIOD_S)
    s = np.concatenate([np.zeros(3), s, np.repeat(s[-1:], 3)])
    first, last = _segments(ends, s, "right"), _segments(ends, s, "left")
    found, step = {}, s
    for order, (name, cap) in enumerate((("v", "v_cap"), ("a", "a_max"), ("j", "j_max")), 1):
        step = np.diff(step)
        most = _largest_caps(problem[cap], first, last, order)
        found[f"{name}_peak"] = float(np.max(np.abs(step) / PERIOD_S**order / most))
    return found | {"junction_over_mm_s": _junction_over(problem, profile, ends)}


def _segments(ends, s, side):
    """Return the segment of every sample; at a junction the one before ("left") or behind."""
    return np.minimum(np.searchsorted(ends, s, side), len(ends) - 1)


def _largest_caps(cap, first, last, order):
    """Return the largest cap of the segments that each difference of so many steps touches."""
    count = len(first) - order
    low = np.minimum(first, last)[:count]
    high = np.maximum(first, last)[order:]
    most = cap[low]
    for k in range(int(np.max(high - low)) + 1):
        most = np.maximum(most, cap[np.minimum(low + k, high)])
    return most


def _junction_over(problem, profile, ends):
    """Return by how much the speed at a junction passes its cap at most [mm/s]."""
    s, v, a = profile.sample(PERIOD_S / FINE)
    k = np.searchsorted(s, ends[:-1]) - 1  # the last sample before each junction
    speed = np.sqrt(np.maximum(v[k] ** 2 + 2 * a[k] * (ends[:-1] - s[k]), 0))
    return float(np.max(speed - problem["v_node"][1:-1], initial=0.0))


def _median(rows):
    """Return a row of medians, and of the largest peaks."""
    row = dict.fromkeys(rows[0], None)
    row["path"] = "median, largest peaks"
    row["ratio"] = float(np.median([each["ratio"] for each in rows]))
    for key in ("ns_per_node", "envelope_ns_per_node"):
        row[key] = float(np.median([each[key] for each in rows]))
    for key in ("v_peak", "a_peak", "j_peak", "junction_over_mm_s"):
        row[key] = max(each[key] for each in rows)
    return row
