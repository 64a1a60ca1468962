# SPDX-License-Identifier: MIT
"""The fastest jerk-limited profile of a path, found numerically: slow, and nobody's planner.

The path coordinate is cut into cells of constant acceleration. Unknown is v² at the nodes. The
time Σ 2h/(v + v') is convex in v², the limits of speed and acceleration are linear, and of the jerk
rule |a' − a| ≤ J (q + q')/2 only the durations q are not: they are convex in v², so their tangent
at a feasible profile lies below them, and the rule with the tangent is linear and stricter. So
every profile on the way is feasible (the convex-concave procedure: Lipp and Boyd, "Variations and
extension of the convex-concave procedure", 2016), and Newton steps along a logarithmic barrier
(Boyd and Vandenberghe, "Convex Optimization", section 11.3) lead to one that no small change makes
faster.
"""

from dataclasses import dataclass

import numpy as np

INSIDE = 0.95  # of the way to the nearest limit that a Newton step may go
FALL = 0.3  # of the barrier's weight, from one round to the next
STEPS = 15  # Newton steps in a round at most
GAP = 1e-5  # of the time: what the barrier costs at the end


@dataclass
class Grid:
    """A path cut into cells.

    Attributes
    ----------
    h : numpy.ndarray
        (n,) lengths [mm].
    vv_cap : numpy.ndarray
        (n + 1,) largest v² [mm²/s²], 0 at both ends.
    a, j : numpy.ndarray
        (n,) limits of acceleration [mm/s²] and jerk [mm/s³].
    """

    h: np.ndarray
    vv_cap: np.ndarray
    a: np.ndarray
    j: np.ndarray


def grid_of(length_mm, v_cap, a_max, j_max, v_node, cell_mm):
    """Cut segments into cells, the shorter the nearer to a junction.

    Parameters
    ----------
    length_mm, v_cap, a_max, j_max : numpy.ndarray
        (n,) of the segments, as `pycnc.stages.slope` takes them.
    v_node : numpy.ndarray
        (n + 1,) caps at the junctions [mm/s].
    cell_mm : float
        Mean length of a cell of a long segment [mm].

    Returns
    -------
    Grid
    """
    parts, owner = [], []
    for k, length in enumerate(length_mm):
        count = max(6, int(np.ceil(length / cell_mm)))
        x = np.linspace(0, 1, count + 1)
        parts.append(np.diff(length * x * x * (3 - 2 * x)))
        owner += [k] * count
    owner, h = np.array(owner), np.concatenate(parts)
    inside = np.minimum(v_cap[owner[:-1]], v_cap[owner[1:]])
    is_junction = np.diff(owner) == 1
    inside[is_junction] = np.minimum(inside[is_junction], v_node[1:-1])
    vv_cap = np.concatenate([[0.0], inside**2, [0.0]])
    return Grid(h, vv_cap, a_max[owner], j_max[owner])


def _durations(h, vv):
    """Return the time of every cell and its derivatives by vv at both ends; 0 where vv is fixed."""
    v = np.sqrt(vv)
    q = 2 * h / (v[:-1] + v[1:])
    with np.errstate(divide="ignore"):
        left, right = -q / (2 * v[:-1] * (v[:-1] + v[1:])), -q / (2 * v[1:] * (v[:-1] + v[1:]))
    left[0] = right[-1] = 0
    return q, left, right


def _time_bands(h, vv):
    """Return the Hessian of the time by vv: its diagonal, and the next one."""
    v = np.sqrt(vv)
    a, b = v[:-1], v[1:]
    with np.errstate(divide="ignore", invalid="ignore"):
        left = h * (3 * a + b) / (2 * a**3 * (a + b) ** 3)
        right = h * (3 * b + a) / (2 * b**3 * (a + b) ** 3)
        across = h / (a * b * (a + b) ** 3)
    return np.append(left, 0) + np.append(0, right), across


class _Rules:
    """All limits as rows of three coefficients, those of the nodes around `node`, and bounds."""

    def __init__(self, grid, vv):
        n, zero = len(grid.h), np.zeros(1)
        slope = 0.5 / grid.h  # of an acceleration, by vv
        before, behind = np.append(zero, slope), np.append(slope, zero)
        change = np.stack([before, -before - behind, behind], axis=1)
        jerk = np.minimum(np.append(grid.j, np.inf), np.append(np.inf, grid.j)) / 2
        q, left, right = (np.append(zero, np.append(x, zero)) for x in _durations(grid.h, vv))
        tangent = jerk[:, None] * np.stack([left[:-1], right[:-1] + left[1:], right[1:]], axis=1)
        rest = jerk * (q[:-1] + q[1:]) - _products(tangent, vv, np.arange(n + 1))
        accel = np.stack([np.zeros(n), -slope, slope], axis=1)
        cap = np.tile([0.0, 1.0, 0.0], (n - 1, 1))
        self.rows = np.concatenate([cap, accel, -accel, change - tangent, -change - tangent])
        self.bound = np.concatenate([grid.vv_cap[1:-1], grid.a, grid.a, rest, rest])
        nodes, cells = np.arange(n + 1), np.arange(n)
        self.node = np.concatenate([nodes[1:-1], cells, cells, nodes, nodes])

    def products(self, vv):
        return _products(self.rows, vv, self.node)

    def slack(self, vv):
        return self.bound - self.products(vv)

    def gradient(self, weights, n):
        """Return the sum of all rows, each times its weight, by node."""
        total = np.zeros(n + 3)
        for k in range(3):
            total += np.bincount(self.node + k, self.rows[:, k] * weights, minlength=n + 3)
        return total[1:-1]

    def hessian(self, weights, n):
        """Return the bands of the sum of the rows' squares, each times its weight."""
        bands = np.zeros((3, n + 3))
        for i in range(3):
            for k in range(i, 3):
                product = self.rows[:, i] * self.rows[:, k] * weights
                bands[k - i] += np.bincount(self.node + i, product, minlength=n + 3)
        return bands[:, 1:-1]


def _solve(bands, right):
    """Solve a symmetric system of five diagonals by elimination.

    bands: the diagonal and the two next to it, each from its first row on.
    """
    (d, e, f), x = (band.tolist() for band in bands), right.tolist()
    n = len(x)
    for k in range(n - 1):
        share = e[k] / d[k]
        d[k + 1] -= share * e[k]
        x[k + 1] -= share * x[k]
        if k + 2 < n:
            e[k + 1] -= share * f[k]
            share = f[k] / d[k]
            d[k + 2] -= share * f[k]
            x[k + 2] -= share * x[k]
    for k in range(n - 1, -1, -1):
        behind = (e[k] * x[k + 1] if k + 1 < n else 0) + (f[k] * x[k + 2] if k + 2 < n else 0)
        x[k] = (x[k] - behind) / d[k]
    return np.array(x)


def _products(rows, vv, node):
    padded = np.concatenate([[0.0], vv, [0.0]])
    return (rows * padded[node[:, None] + np.arange(3)]).sum(axis=1)


def _newton(grid, vv, weight):
    """Return vv after one Newton step towards the barrier's centre, and how much that gains."""
    rules, n = _Rules(grid, vv), len(grid.h)
    inverse = 1 / rules.slack(vv)
    _, left, right = _durations(grid.h, vv)
    gradient = np.append(left, 0) + np.append(0, right) + weight * rules.gradient(inverse, n)
    bands = weight * rules.hessian(inverse**2, n)
    diagonal, across = _time_bands(grid.h, vv)
    bands[0, 1:-1] += diagonal[1:-1]
    bands[1, 1:-2] += across[1:-1]
    step = np.zeros(n + 1)
    step[1:-1] = -_solve(bands[:, 1:-1], gradient[1:-1])
    limits = np.append(rules.products(step) * inverse, -step[1:-1] / vv[1:-1])
    most = min(1.0, INSIDE / max(limits.max(), 1e-12))
    return vv + most * step, -float(gradient @ step)


def _slow_start(grid):
    """Return a profile strictly inside all limits: with v, jerk falls as its third power."""
    s = np.concatenate([[0.0], np.cumsum(grid.h)])
    vv = np.minimum(s, s[-1] - s) ** (4 / 3)  # of constant jerk from rest
    vv *= 0.9 * np.min(grid.vv_cap[1:-1] / vv[1:-1])
    while (_Rules(grid, vv).slack(vv) <= 0).any():
        vv = 0.7 * vv
    return vv


def fastest(grid):
    """Find the fastest profile.

    Parameters
    ----------
    grid : Grid

    Returns
    -------
    vv : numpy.ndarray
        (n + 1,) v² at the nodes [mm²/s²].
    time_s : float

    Examples
    --------
    >>> one, ends = np.ones(1), np.zeros(2)
    >>> grid = grid_of(10 * one, 100 * one, 1000 * one, 10000 * one, ends, 0.1)
    >>> round(fastest(grid)[1], 2)  # four phases of constant jerk: (32 s / J)^(1/3)
    0.32
    """
    vv = _slow_start(grid)
    limits, time_s = 5 * len(grid.h), _durations(grid.h, vv)[0].sum()
    weight = time_s / limits
    while weight * limits > GAP * time_s:
        for _ in range(STEPS):
            vv, gain = _newton(grid, vv, weight)
            if gain < weight:
                break
        time_s = _durations(grid.h, vv)[0].sum()
        weight *= FALL
    return vv, float(time_s)
