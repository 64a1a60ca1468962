# SPDX-License-Identifier: MIT
"""Does a run come near enough to every point that the program names?

The other way round, how far the run is from the program, cannot see a tip that is cut off: the two
lines of a spike are nearly one. So the corners of the program, and points on its arcs, are looked
for on the run: where the run's coordinate of the program says, or half the way to the next such
point before and behind it, so that the order of the points is kept.

Between ticks the run is the cubic through the four setpoints about it. What that may miss, a bend
shorter than a period, is a part of the second differences of the setpoints about, and is granted
on top of the tolerance: a micrometre for 2 m/s² and a period of 1 ms. Where the setpoints about
pass more than one such point they tell nothing of either; none is judged then.
"""

import numpy as np

ARC_STEP = np.pi / 12  # from one point of an arc to the next, at most
ROUNDING_MM = 1e-9  # of two coordinates that go on alike
PARTS = 16  # of a period, when the nearest place in it is looked for
# Of the second difference: how far the cubic may be off. A corner at the share q of a period where
# the speed turns by w is q (1 − q) |w| T off its chord, and the larger second difference about it
# is max(q, 1 − q) |w| T.
MISSED = 1 / 2
CUBIC = np.array([  # of four setpoints, by 1, u, u², u³: u is the share of the middle period
    [0, 1, 0, 0],
    [-1 / 3, -1 / 2, 1, -1 / 6],
    [1 / 2, -1, 1 / 2, 0],
    [-1 / 6, 1 / 2, -1 / 2, 1 / 6],
])


class Marks:
    """The points of a program that a run has to come near to, in order.

    Attributes
    ----------
    s : numpy.ndarray
        (marks,) coordinates of the programmed path [mm].
    point : numpy.ndarray
        (marks, 9) [mm, deg].
    tolerance : numpy.ndarray
        (marks,) the smallest of the blocks that meet there [mm].
    low, high : numpy.ndarray
        (marks,) coordinates between which the run has to come near.
    line : numpy.ndarray
        (marks,) source lines.
    """

    def __init__(self, path, arc_step=ARC_STEP):
        moves = np.flatnonzero(path.length > 0)
        turn = np.abs(path.sweep[moves])
        count = np.maximum(1, np.ceil(turn / arc_step)).astype(np.intp)
        block = np.repeat(moves, count)
        first = np.repeat(np.cumsum(count) - count, count)
        share = (np.arange(len(block)) - first + 1) / np.repeat(count, count)
        self.s = path.begin[block] + share * path.length[block]
        self.point = path.point(block, share)
        ends = share == 1
        self.point[ends] = path.end[block[ends]]
        self.line = path.line[block]
        after = path.tolerance[np.append(block[1:], block[-1:])]
        self.tolerance = np.minimum(path.tolerance[block], after)
        way = np.diff(self.s, prepend=0.0)
        reach = np.maximum(self.tolerance, 0.5 * way)
        self.low = self.s - reach
        self.high = self.s + np.maximum(self.tolerance, 0.5 * np.append(way[1:], 0.0))


class Visits:
    """Takes a run in pieces and tells how near it came to the marks within a tolerance.

    It keeps the setpoints: 88 bytes a tick.

    Parameters
    ----------
    path : Path
    start : numpy.ndarray
        (9,) where the machine stands before the first tick.
    """

    def __init__(self, path, start):
        self._marks = Marks(path)
        self._pieces = [(np.zeros(1), start[None])]
        self.largest = 0.0  # share of the tolerance

    def add(self, s, poses):
        """Take the next rows: path coordinates and poses.

        Copies: the rows of a run are filled again by its next piece.
        """
        self._pieces.append((s.copy(), poses.copy()))

    def finish(self):
        """Return None, or (tick, line, words) of the first mark missed by the run so far."""
        self._s, self._poses = map(np.concatenate, zip(*self._pieces, strict=True))
        marks = self._marks
        here = np.flatnonzero((marks.tolerance > 0) & (marks.high <= self._s[-1] + ROUNDING_MM))
        here = here[self._is_alone(here)]
        if not len(here):
            return None
        apart, granted = self._where_told(here)
        for k in np.flatnonzero(apart > marks.tolerance[here]):
            apart[k], granted[k] = self._nearest(here[k])
        share = (apart - granted) / marks.tolerance[here]
        self.largest = float(share.max())
        return self._first_missed(here, share)

    def _first_missed(self, marks, share):
        over = np.flatnonzero(share > 1 + 1e-6)
        if not len(over):
            return None
        mark = marks[over[0]]
        tick = int(np.searchsorted(self._s, self._marks.s[mark]))
        most = self._marks.tolerance[mark]
        words = f"missed by {share[over[0]] * most:.9g} mm, tolerance {most:g}"
        return tick, int(self._marks.line[mark]), words

    def _around(self, k):
        """Return six setpoints about each of the periods k → k + 1: (6, periods, 9)."""
        last = len(self._s) - 1
        return np.stack([self._poses[np.clip(k + n, 0, last)] for n in range(-2, 4)])

    def _is_alone(self, marks):
        """Return which marks are the only ones that the setpoints about them pass."""
        s, every = self._marks.s[marks], self._marks.s
        k = np.searchsorted(self._s, s, "right") - 1
        last = len(self._s) - 1
        begin, end = self._s[np.clip(k - 2, 0, last)], self._s[np.clip(k + 3, 0, last)]
        before = np.append(-np.inf, every)[marks]
        behind = np.append(every, np.inf)[marks + 1]
        return (before < begin) & (behind > end)

    def _where_told(self, marks):
        """Return how far the run is from marks where its coordinate is theirs, and what of that
        may be the cubic's."""
        s = self._marks.s[marks]
        k = np.clip(np.searchsorted(self._s, s, "right") - 1, 0, len(self._s) - 2)
        way = self._s[k + 1] - self._s[k]
        u = np.clip(np.divide(s - self._s[k], way, out=np.zeros(len(k)), where=way > 0), 0, 1)
        six = self._around(k)
        weights = np.stack([u**0, u, u**2, u**3], axis=1) @ CUBIC
        points = np.einsum("kn,nkx->kx", weights, six[1:5])
        return np.linalg.norm(points - self._marks.point[marks], axis=1), granted(six)

    def _nearest(self, mark):
        """Return the same of the place that is nearest to one mark."""
        low = max(np.searchsorted(self._s, self._marks.low[mark], "left") - 1, 0)
        high = min(np.searchsorted(self._s, self._marks.high[mark], "right"), len(self._s) - 1)
        k = np.arange(low, max(high, low + 1))
        u = np.linspace(0, 1, PARTS + 1)
        six = self._around(k)
        weights = np.stack([u**0, u, u**2, u**3], axis=1) @ CUBIC
        points = np.einsum("un,nkx->kux", weights, six[1:5]) - self._marks.point[mark]
        begin, way = points[:, :-1], np.diff(points, axis=1)
        square = np.einsum("kux,kux->ku", way, way)
        ahead = -np.einsum("kux,kux->ku", begin, way)
        q = np.clip(np.divide(ahead, square, out=np.zeros_like(ahead), where=square > 0), 0, 1)
        apart = np.linalg.norm(begin + q[..., None] * way, axis=2).min(axis=1)
        best = np.argmin(apart - granted(six))
        return apart[best], granted(six)[best]


def granted(six):
    """Return how far the cubics in the middle of six setpoints each may be off the run there."""
    second = np.diff(six, n=2, axis=0)
    return MISSED * np.linalg.norm(second, axis=2).max(axis=0)
