# SPDX-License-Identifier: MIT
"""How far the path that was run and the program are apart, both ways.

From the run to the program: the distance of every setpoint from the programmed moves. From the
program to the run: the distance of every corner of the program, and of points on its arcs, from the
path that the kernel made, in closed form: ticks do not come into it, so nothing is lost between
them. The second way sees a tip that is cut off, where the two lines of a spike are nearly one. Of
the path only the part counts that stands for the program about such a point, half the way to the
next one at most or as far as the tolerance: what comes by there later does not. A blend stands for
the program as a whole: where the tool all but parks, the program's coordinate runs on evenly.
"""

import numpy as np

from pycnc.kernel.records import dtype, enum, join

_SEG_KINDS = enum("nck_seg_kind_t")
_PATH_MODES = enum("nck_path_mode_t")
_ARC_STEP = np.pi / 12  # from one point of an arc to the next, at most
_GRID = np.linspace(0, 1, 33)  # a seg is searched so, and once more between two points of it
_BATCH = 256  # points of the program that are searched for at a time
ON_PATH_MM = 1e-9  # nearer needs no better


class PathError:
    """Largest distance of the path run from the program, and of the program from that path.

    Parameters
    ----------
    program : Program

    Attributes
    ----------
    largest_mm : float
        The larger of both ways [mm].
    missed : float
        How far the path misses a point of the program at most, as a share of the tolerance in force
        there; 0 where there is none.
    """

    def __init__(self, program):
        self._moves, self._marks = program.moves, _Marks(program)
        self._next, self._segs = 0, join("nck_seg_t", [])
        self.largest_mm = self.missed = 0.0

    def add(self, rows):
        """Measure the next rows of a run (dtype ``sim_row_t``) against the program."""
        pose = rows["pose"]
        begun = pose["line"] > 0
        if not begun.any():
            return
        block = self._moves.block_at(pose["s_program"][begun])
        apart = self._moves.nearest(block, pose["axis"][begun])
        self.largest_mm = max(self.largest_mm, float(apart.max()))

    def add_segs(self, segs):
        """Measure the program against the next segs of its path (dtype ``nck_seg_t``)."""
        moving = segs[segs["length"] > 0]
        if not len(moving):
            return
        marks, ahead = self._marks, moving["s_program"][-1]
        self._segs = join("nck_seg_t", [self._segs, moving])
        is_whole = not moving["blend"][-1]  # the last blend is there to its end
        if is_whole:
            self._measure(np.arange(self._next, np.searchsorted(marks.judged, ahead)))
        left = marks.needed[self._next : self._next + 1]
        needed = left[0] if len(left) else np.inf
        keep = np.searchsorted(self._segs["s_program"] + self._segs["program"], needed)
        keep = np.array([min(keep, len(self._segs) - 1)])
        self._segs = self._segs[self._whole_blends(keep, keep)[0][0] :]

    def finish_segs(self):
        """There are no more segs: measure what is left of the program."""
        if len(self._segs):
            reached = self._segs["s_program"][-1] + self._segs["program"][-1] + ON_PATH_MM
            self._measure(np.arange(self._next, np.searchsorted(self._marks.s, reached)))

    def _measure(self, here):
        if not len(here):
            return
        self._next = here[-1] + 1
        marks, segs = self._marks, self._segs
        at = np.searchsorted(segs["s_program"], marks.s[here], "right") - 1
        at = np.clip(at, 0, len(segs) - 1)
        share = (marks.s[here] - segs["s_program"][at]) / segs["program"][at]
        points = _points(segs[at], np.clip(share, 0, 1)[:, None])[:, 0]
        most = np.linalg.norm(points - marks.point[here], axis=1)
        tolerance = marks.tolerance[here]
        shares = np.divide(most, tolerance, out=np.zeros(len(here)), where=tolerance > 0)
        order = np.argsort(-np.maximum(shares, most))
        for k in range(0, len(order), _BATCH):
            some = order[k : k + _BATCH]
            more = (most[some] > self.largest_mm) | (shares[some] > self.missed)
            some = some[more & (most[some] > ON_PATH_MM)]
            if not len(some):
                continue
            found = np.minimum(most[some], self._nearest(here[some]))
            self.largest_mm = max(self.largest_mm, float(found.max()))
            here_missed = (shares[some] * found / most[some]).max()
            self.missed = max(self.missed, float(here_missed))

    def _nearest(self, marks):
        """Return how far marks are from the segs about them."""
        begin, last = self._segs["s_program"], len(self._segs) - 1
        first = np.searchsorted(begin, self._marks.low[marks], "right") - 1
        end = np.searchsorted(begin, self._marks.high[marks], "left") - 1
        first, end = self._whole_blends(np.clip(first, 0, last), np.clip(end, 0, last))
        count = np.maximum(end - first, 0) + 1
        which = np.repeat(np.arange(len(marks)), count)
        at = np.arange(len(which)) - np.repeat(np.cumsum(count) - count - first, count)
        found = np.full(len(marks), np.inf)
        for k in range(0, len(which), _BATCH):
            pair = slice(k, k + _BATCH)
            apart = _distance(self._segs[at[pair]], self._marks.point[marks[which[pair]]])
            np.minimum.at(found, which[pair], apart)
        return found


    def _whole_blends(self, first, end):
        """Return the first and the last seg, made more where they are in the middle of a blend."""
        n, is_blend = np.arange(len(self._segs)), self._segs["blend"] == 1
        begins = np.maximum.accumulate(np.where(is_blend & np.append(False, is_blend[:-1]), 0, n))
        inside = is_blend & np.append(is_blend[1:], False)
        ends = np.minimum.accumulate(np.where(inside, n[-1], n)[::-1])[::-1]
        return begins[first], ends[end]


class _Marks:
    """The points of a program that its path is to come near to, in order."""

    def __init__(self, program):
        moves, blocks = program.moves, program.blocks
        block, share, self.s = moves.marks(_ARC_STEP)
        self.point = moves.point(block, share)
        smoothed = blocks["path_mode"] == _PATH_MODES.CONTINUOUS
        tolerance = np.where(smoothed, blocks["tolerance_mm"], 0.0)[block]
        self.tolerance = np.minimum(tolerance, np.append(tolerance[1:], tolerance[-1:]))
        way = np.diff(self.s, prepend=0.0)
        self.low = self.s - np.maximum(self.tolerance, 0.5 * way)
        self.high = self.s + np.maximum(self.tolerance, 0.5 * np.append(way[1:], 0.0))
        self.judged = np.maximum.accumulate(self.high)
        self.needed = np.minimum.accumulate(self.low[::-1])[::-1]


def _points(segs, share):
    """Return the points of segs, (n, m, axes), where shares of them, (n, m), are done."""
    f = share[..., None]
    start, end = segs["start"][:, None], segs["end"][:, None]
    points = start + (end - start) * f
    curved = np.flatnonzero(segs["kind"] == _SEG_KINDS.SPLINE)
    if len(curved):
        f, first, last = f[curved], start[curved], end[curved]
        inner = segs["shape"]["inner"][curved]
        points[curved] = (
            first * (1 - f) ** 3 + 3 * inner[:, None, 0] * f * (1 - f) ** 2
            + 3 * inner[:, None, 1] * f**2 * (1 - f) + last * f**3
        )  # fmt: skip
    arc = np.flatnonzero(segs["kind"] == _SEG_KINDS.ARC)
    if len(arc):
        _turn(segs[arc], share[arc], points, arc)
    return points


def _turn(segs, share, points, rows):
    """Put the points of arcs, in the axes of their planes, into rows of points."""
    n = np.arange(len(segs))
    shape = segs["shape"]["inner"].reshape(len(segs), -1)  # the numbers of an arc lie there, too
    width = dtype("nck_seg_arc_t").itemsize // shape.itemsize
    arc = np.ascontiguousarray(shape[:, :width]).view(dtype("nck_seg_arc_t"))[:, 0]
    u, v = arc["axis_u"], arc["axis_v"]
    ru = (segs["start"][n, u] - arc["centre_u"])[:, None]
    rv = (segs["start"][n, v] - arc["centre_v"])[:, None]
    phi = arc["sweep"][:, None] * share
    points[rows, :, u] = arc["centre_u"][:, None] + ru * np.cos(phi) - rv * np.sin(phi)
    points[rows, :, v] = arc["centre_v"][:, None] + ru * np.sin(phi) + rv * np.cos(phi)


def _distance(segs, points):
    """Return how far points are from segs, one to one: searched on a grid, then on a finer one."""
    share = np.tile(_GRID, (len(segs), 1))
    for _ in range(2):
        apart = _points(segs, share) - points[:, None]
        best = np.argmin(np.einsum("nmx,nmx->nm", apart, apart), axis=1)
        step = share[:, 1] - share[:, 0]
        middle = share[np.arange(len(segs)), best]
        share = np.clip(middle[:, None] + (2 * _GRID - 1) * step[:, None], 0, 1)
    begin, way = apart[:, :-1], np.diff(apart, axis=1)
    square = np.einsum("nmx,nmx->nm", way, way)
    ahead = -np.einsum("nmx,nmx->nm", begin, way)
    q = np.clip(np.divide(ahead, square, out=np.zeros_like(ahead), where=square > 0), 0, 1)
    return np.linalg.norm(begin + q[..., None] * way, axis=2).min(axis=1)
