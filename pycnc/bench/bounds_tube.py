# SPDX-License-Identifier: MIT
"""The fastest motion anywhere within the tolerance of a program of straight moves.

The motion is cut into pieces of constant jerk, axis by axis. Each move of the program has its own
pieces, all equally long in time, and how long they are is unknown. So limits of a and j hold
everywhere. The tolerance is kept both ways. Where one move's pieces end, the motion is within P of
the program's point; all control points of a piece are within P of its move. That place (a capsule)
is convex, so the whole piece is in it; and since the motion goes from one end of the move to the
other, every point of the move has the motion within P, too. What is found exists, so the true
optimum is never above it; how far it is below, a finer step shows.
"""

import numpy as np

from pycnc.bench.bounds_solve import EXACT, Motion, Problem, states

LEAST_S = 1e-5  # of a piece, at the start


class _Pieces:
    """Which move every piece belongs to, and the known motion at their ends."""

    def __init__(self, points, seen, step_s):
        lasts = np.maximum(np.diff(seen.corners_s), LEAST_S)
        self.counts = np.maximum(1, np.ceil(lasts / step_s - 1e-9).astype(int))
        self.move = np.repeat(np.arange(len(lasts)), self.counts)
        self.each_s = lasts / self.counts
        self.begins = np.concatenate([[0], np.cumsum(self.counts)])  # of moves
        t = np.concatenate([[0.0], np.cumsum(self.each_s[self.move])])
        t *= seen.t[-1] / t[-1]
        half = self.each_s.mean() / 2

        def places(x):
            return np.column_stack([np.interp(x, seen.t, q) for q in seen.places.T])

        def speeds(x):
            return (places(x + half) - places(x - half)) / (2 * half)

        self.q, self.v = places(t), speeds(t)
        self.a = (speeds(t + half) - speeds(t - half)) / (2 * half)
        self.v[[0, -1]] = self.a[[0, -1]] = 0
        self.base = points[np.append(self.move, len(lasts) - 1)]  # what places are told from


def fastest(points, tolerance, limits, seen, step_s):
    """Find the fastest motion within a tolerance of a polygon, from rest to rest.

    Parameters
    ----------
    points : numpy.ndarray
        (K + 1, D) of the program [mm], D = 2 or 3; it begins and ends on the first and the last.
    tolerance : float
        P [mm].
    limits : Limits
    seen : Seen
    step_s : float
        A piece is no longer than this in the motion that is known.

    Returns
    -------
    Motion
    """
    problem, pieces = Problem(), _Pieces(points, seen, step_s)
    ca, at, n = problem.ca, pieces.move, len(pieces.move)
    unit_s = float(np.median(pieces.each_s))
    each = problem.unknown(pieces.each_s[:, None] / unit_s, 1e-6, np.inf) * unit_s
    h = ca.vec(each[at.tolist()])
    free = np.ones((n + 1, 1))
    free[[0, -1]] = 0
    ends = np.zeros((n + 1, points.shape[1]))
    ends[-1] = (points[-1] - pieces.base[-1]) / tolerance
    off = (pieces.q - pieces.base) / tolerance
    far = np.where(free, np.inf, 0)
    e = problem.unknown(np.where(free, off, ends), ends - far, ends + far)
    v = problem.unknown(pieces.v / limits.v, -free, free)
    a = problem.unknown(pieces.a / limits.a, -free, free)
    guess = np.diff(pieces.a, axis=0) / pieces.each_s[at, None] / limits.j
    j = problem.unknown(guess, -1, 1)
    inner = _motion(problem, (e, v, a, j, h), pieces, tolerance, limits)
    _feed(problem, v, limits)
    moves = np.diff(points, axis=0) / tolerance
    for coordinates in zip(*inner, strict=True):
        _capsule(problem, coordinates, moves[at])
    later = np.setdiff1d(np.arange(1, n), pieces.begins)
    if len(later):
        _capsule(problem, ca.horzsplit(e[later.tolist(), :]), moves[at[later]])
    corners = pieces.begins[1:-1].tolist()
    if corners:
        problem.hold(ca.sum2(e[corners, :] ** 2), -np.inf, 1)
    cost = 10 * ca.sum1(h) / seen.t[-1]
    (h, j), status = problem.solve(cost, [h, j])
    return _of_pieces(points[0], h[:, 0], j * limits.j, status)


def _motion(problem, unknowns, pieces, tolerance, limits):
    """Hold the pieces together; return their inner control points, (first, second) of each axis,
    from the begin of their move in units of P."""
    (e, v, a, j, h), inner = unknowns, []
    for d in range(e.shape[1]):
        speed, acceleration = v[:, d] * limits.v[d], a[:, d] * limits.a[d]
        jerk, step = j[:, d] * limits.j[d], problem.ca.DM(np.diff(pieces.base[:, d]) / tolerance)
        here, there = e[:-1, d], e[1:, d] + step
        before, behind = speed[:-1], speed[1:]
        at, to = acceleration[:-1], acceleration[1:]
        problem.hold(EXACT * (to - at - jerk * h) / limits.a[d], 0, 0)
        problem.hold(EXACT * (behind - before - (at + to) / 2 * h) / limits.v[d], 0, 0)
        way = before * h + at * h**2 / 2 + jerk * h**3 / 6
        problem.hold(there - here - way / tolerance, 0, 0)
        problem.hold((before + at * h / 2) / limits.v[d], -1, 1)  # the control point of v
        inner.append((here + before * h / 3 / tolerance, there - behind * h / 3 / tolerance))
    return inner


def _feed(problem, v, limits):
    speed = sum((v[:, d] * limits.v[d] / limits.feed) ** 2 for d in range(v.shape[1]))
    problem.hold(speed, -np.inf, 1)


def _capsule(problem, coordinates, moves):
    """Keep points within 1 of their moves: `coordinates` from the begin of each, axis by axis."""
    ca, length = problem.ca, np.linalg.norm(moves, axis=1)
    way = [ca.DM(column) for column in (moves / length[:, None]).T]
    along = sum(x * u for x, u in zip(coordinates, way, strict=True))
    aside = 0
    for k in range(len(way)):
        for i in range(k):
            aside += (coordinates[k] * way[i] - coordinates[i] * way[k]) ** 2
    beyond = ca.fmax(0, -along) ** 2 + ca.fmax(0, along - ca.DM(length)) ** 2
    problem.hold(aside + beyond, -np.inf, 1)


def _of_pieces(begin, h, j, status):
    """Return the motion of pieces that last `h` and have the jerk `j`, from rest."""
    ends, (q, v, a) = np.cumsum(h), states(h, j)

    def places(t):
        k = np.minimum(np.searchsorted(ends, t), len(h) - 1)
        x = (np.asarray(t) - ends[k] + h[k])[:, None]
        return begin + q[k] + x * (v[k] + x * (a[k] / 2 + x * j[k] / 6))

    return Motion(float(ends[-1]), places, status)
