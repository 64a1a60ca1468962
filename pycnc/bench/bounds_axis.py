# SPDX-License-Identifier: MIT
"""The fastest motion along a given path of lines and splines, from rest to rest: under the limits
of its axes, signed, or under caps of the path coordinate.

The path coordinate is cut into pieces of constant jerk, between places that do not move: the ends
of the path's segs, and where the known motion is at each step. Unknown is how long each takes. At
both ends of each, with p its path: |p′v| ≤ V, |p′a + p″v²| ≤ A, |p′j + 3p″va + p‴v³| ≤ J of every
axis. Where the tangent jumps the motion rests.
"""

import numpy as np

from pycnc.bench.bounds_solve import EXACT, Motion, Problem, states

JUMP = 1e-5  # of the tangent: less is smooth
NEAR = 0.3  # of a step: a place nearer to a seg's end is left out
FREE = 1e3  # times a limit: what an unknown may be


class Path:
    """Segs of a plan (lines and splines that have a length) as one curve.

    Attributes
    ----------
    ends : numpy.ndarray
        (n + 1,) path coordinates of the segs' ends [mm].
    """

    def __init__(self, segs, axes):
        is_spline = (segs["kind"] == 2)[:, None]
        start, end = segs["start"][:, :axes], segs["end"][:, :axes]
        inner = [segs["shape"]["inner"][:, k, :axes] for k in (0, 1)]
        first = np.where(is_spline, inner[0], start + (end - start) / 3)
        second = np.where(is_spline, inner[1], end - (end - start) / 3)
        self._points = np.stack([start, first, second, end])
        self.lengths = segs["length"]
        self.ends = np.concatenate([[0.0], np.cumsum(self.lengths)])

    def seg_at(self, s):
        """Return the index of the seg at path coordinates."""
        return np.clip(np.searchsorted(self.ends, s, "right") - 1, 0, len(self.lengths) - 1)

    def at(self, s, seg):
        """Return p, p′, p″, p‴, each (m, D), at places of segs."""
        points, length = self._points[:, seg], self.lengths[seg][:, None]
        u, found = (s[:, None] - self.ends[seg][:, None]) / length, []
        for order in range(4):
            level = points
            while len(level) > 1:
                level = (1 - u) * level[:-1] + u * level[1:]
            found.append(level[0])
            points = (3 - order) * np.diff(points, axis=0) / length
        return found


def fastest(path, limits, seen, step_s, caps=None):
    """Find the fastest motion along a path.

    Parameters
    ----------
    path : Path
    limits : Limits
    seen : Seen
    step_s : float
        Between places, in the motion that is known.
    caps : callable, optional
        From path coordinates to caps of v, a and j there; they take the place of `limits`.

    Returns
    -------
    Motion
    """
    s, t = _places(path, seen, step_s)
    seg = path.seg_at((s[:-1] + s[1:]) / 2)
    begin, end = path.at(s[:-1], seg), path.at(s[1:], seg)
    free = np.ones((len(s), 1))
    jumps = np.abs(end[1][:-1] - begin[1][1:]).max(axis=1) > JUMP
    free[np.concatenate([[True], jumps, [True]])] = 0
    problem = Problem()
    unit = limits.v.max(), limits.a.max(), limits.j.max()
    h, v, a, j = _unknowns(problem, (s, t), seen, free, unit)
    if caps is None:
        _axes(problem, begin, limits, (v[:-1], a[:-1], j))
        _axes(problem, end, limits, (v[1:], a[1:], j))
    else:
        v_cap, a_cap, j_cap = (problem.ca.DM(x) for x in caps((s[:-1] + s[1:]) / 2))
        for k in (slice(None, -1), slice(1, None)):
            problem.hold(v[k] / v_cap, -np.inf, 1)
            problem.hold(a[k] / a_cap, -1, 1)
        problem.hold(j / j_cap, -1, 1)
    cost = 10 * problem.ca.sum1(h) / seen.t[-1]
    (h, j), status = problem.solve(cost, [h, j])
    return _along(path, h[:, 0], j[:, 0], status)


def _places(path, seen, step_s):
    """Return the pieces' ends: places, and when the known motion is there."""
    rising = seen.s + 1e-12 * np.arange(len(seen.s))
    steps = np.linspace(0, seen.t[-1], int(np.ceil(seen.t[-1] / step_s)) + 1)[1:-1]
    passed = np.interp(path.ends, rising, seen.t)
    after = np.searchsorted(passed, steps).clip(1, len(passed) - 1)
    apart = np.minimum(np.abs(passed[after] - steps), np.abs(passed[after - 1] - steps))
    inside = np.interp(steps[apart > NEAR * step_s], seen.t, seen.s)
    s = np.unique(np.concatenate([path.ends, inside[inside < path.ends[-1]]]))
    s = s[np.append(True, np.diff(s) > 1e-10)]
    return s, np.interp(s, rising, seen.t)


def _unknowns(problem, places, seen, free, unit):
    """Return durations, speeds, accelerations and jerks of pieces that hold together."""
    s, t = places
    lasts = np.maximum(np.diff(t), 1e-5)
    half = np.median(lasts) / 2

    def speeds(x):
        ahead, behind = (np.interp(x + k * half, seen.t, seen.s) for k in (1, -1))
        return (ahead - behind) / (2 * half)

    v0 = speeds(t)[:, None] * free
    a0 = (speeds(t + half) - speeds(t - half))[:, None] / (2 * half) * free
    j0 = np.clip(np.diff(a0, axis=0) / lasts[:, None], -unit[2], unit[2])
    h = problem.unknown(np.ones((len(lasts), 1)), 1e-4, np.inf) * problem.ca.DM(lasts)
    v = problem.unknown(v0 / unit[0], 0, FREE * free) * unit[0]
    a = problem.unknown(a0 / unit[1], -FREE * free, FREE * free) * unit[1]
    j = problem.unknown(j0 / unit[2], -FREE, FREE) * unit[2]
    problem.hold(EXACT * (a[1:] - a[:-1] - j * h) / unit[1], 0, 0)
    problem.hold(EXACT * (v[1:] - v[:-1] - (a[1:] + a[:-1]) / 2 * h) / unit[0], 0, 0)
    way = v[:-1] * h + a[:-1] * h**2 / 2 + j * h**3 / 6
    problem.hold(way / problem.ca.DM(np.diff(s)) - 1, 0, 0)
    return h, v, a, j


def _axes(problem, at, limits, motion):
    """Hold the limits of every axis, and the feed, where the path has these derivatives."""
    (_, first, second, third), (v, a, j) = at, motion
    for d in range(first.shape[1]):
        p1, p2, p3 = (problem.ca.DM(p[:, d]) for p in (first, second, third))
        problem.hold(p1 * v / limits.v[d], -1, 1)
        problem.hold((p1 * a + p2 * v**2) / limits.a[d], -1, 1)
        problem.hold((p1 * j + 3 * p2 * v * a + p3 * v**3) / limits.j[d], -1, 1)
    stretch = np.linalg.norm(first, axis=1)
    problem.hold(problem.ca.DM(stretch) * v / limits.feed, -np.inf, 1)


def _along(path, h, j, status):
    """Return the motion along a path of pieces that last `h` and have the jerk `j`, from rest."""
    ends, (s, v, a) = np.cumsum(h), states(h, j)

    def places(t):
        k = np.minimum(np.searchsorted(ends, t), len(h) - 1)
        x = np.asarray(t) - ends[k] + h[k]
        there = np.clip(s[k] + x * (v[k] + x * (a[k] / 2 + x * j[k] / 6)), 0, path.ends[-1])
        return path.at(there, path.seg_at(there))[0]

    return Motion(float(ends[-1]), places, status)
