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
from pycnc.machine.schema import AXES
from pycnc.program.geometry import Along, Moves

_SEG_KINDS = enum("nck_seg_kind_t")
_PATH_MODES = enum("nck_path_mode_t")
_ARC_STEP = np.pi / 12  # from one point of an arc to the next, at most
_GRID = np.linspace(0, 1, 33)  # a seg is searched so, and once more between two points of it
_BATCH = 256  # points of the program that are searched for at a time
_SEGS = 8192  # segs that are looked at at a time
_OF_MARKS = {"s": (), "point": (len(AXES),), "tolerance": ()}
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
        self._along, self._marks = Along(program), _Marks(program)
        self._segs = join("nck_seg_t", [])
        self.largest_mm = self.missed = 0.0

    def add(self, rows):
        """Measure the next rows of a run (dtype ``sim_row_t``) against the program."""
        pose = rows["pose"]
        begun = (pose["line"] > 0) & (pose["kind"] < _SEG_KINDS.THREAD)
        if not begun.any():
            return
        s, points, k = pose["s_program"][begun], pose["axis"][begun], 0
        while k < len(s):
            self._along.go_to(s[k])
            some = slice(k, k + max(1, int(np.searchsorted(s[k:], self._along.until))))
            block = self._along.moves.block_at(s[some])
            apart = self._along.moves.nearest(block, points[some])
            self.largest_mm = max(self.largest_mm, float(apart.max()))
            k = some.stop

    def add_segs(self, segs):
        """Measure the program against the next segs of its path (dtype ``nck_seg_t``)."""
        for k in range(0, len(segs), _SEGS):
            self._add_some(segs[k : k + _SEGS])

    def _add_some(self, segs):
        moving = segs[segs["length"] > 0]
        if not len(moving):
            return
        marks, ahead = self._marks, moving["s_program"][-1]
        self._segs = join("nck_seg_t", [self._segs, moving])
        is_whole = not moving["blend"][-1]  # the last blend is there to its end
        marks.reach(ahead)
        if is_whole:
            self._measure(int(np.searchsorted(marks.judged, ahead)))
        needed = marks.needed()
        keep = np.searchsorted(self._segs["s_program"] + self._segs["program"], needed)
        keep = np.array([min(keep, len(self._segs) - 1)])
        self._segs = self._segs[self._whole_blends(keep, keep)[0][0] :]

    def finish_segs(self):
        """There are no more segs: measure what is left of the program."""
        if len(self._segs):
            reached = self._segs["s_program"][-1] + self._segs["program"][-1] + ON_PATH_MM
            self._marks.reach(reached)
            self._measure(int(np.searchsorted(self._marks.s, reached)))

    def _measure(self, count):
        """Measure the first marks, and drop them."""
        if count == 0:
            return
        self._compare(np.arange(count))
        self._marks.drop(count)

    def _compare(self, here):
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
    """The points of a program that its path is to come near to, in order, as far as it is read.

    Attributes
    ----------
    s, point, tolerance, low, high, judged : numpy.ndarray
        Path coordinate, place, tolerance there; from where to where the path is to be near; and how
        far it must be known to judge this point and all before it. The first one is the next to be
        judged.
    """

    def __init__(self, program):
        self._machine, self._pieces = program.machine, program.pieces()
        self._most = program.tolerance_most_mm
        self._end, self._before, self._all_read = (None, 0.0), 0.0, False
        self._held = {name: np.empty((0, *shape)) for name, shape in _OF_MARKS.items()}
        self.s, self.tolerance, self.low, self.high, self.judged = (np.empty(0) for _ in range(5))
        self.point = np.empty((0, *_OF_MARKS["point"]))

    def reach(self, s):
        """Read on until a point lies behind a path coordinate [mm]."""
        while not self._all_read and not (len(self.s) and self.s[-1] > s):
            blocks = next(self._pieces, None)
            self._all_read = blocks is None
            if blocks is None:
                self._add(self._held, tolerance_next=self._held["tolerance"], way_next=np.zeros(1))
            else:
                self._read(blocks)

    def _read(self, blocks):
        moves = Moves(blocks, self._machine, *self._end)
        self._end = moves.end_nm, moves.end_s
        block, share, s = moves.marks(_ARC_STEP)
        smoothed = blocks["path_mode"] == _PATH_MODES.CONTINUOUS
        tolerance = np.where(smoothed, blocks["tolerance_mm"], 0.0)[block]
        read = {"s": s, "point": moves.point(block, share), "tolerance": tolerance}
        marks = {name: np.concatenate([self._held[name], read[name]]) for name in read}
        self._held = {name: marks[name][-1:] for name in marks}  # what follows it is not known
        known = {name: marks[name][:-1] for name in marks}
        self._add(known, marks["tolerance"][1:], np.diff(marks["s"]))

    def _add(self, marks, tolerance_next, way_next):
        s, count = marks["s"], len(marks["s"])
        if count == 0:
            return
        tolerance = np.minimum(marks["tolerance"], tolerance_next)
        low = s - np.maximum(tolerance, 0.5 * np.diff(s, prepend=self._before))
        high = s + np.maximum(tolerance, 0.5 * way_next[:count])
        self._before = s[-1]
        judged = np.maximum.accumulate(np.append(self.judged[-1:], high))[-count:]
        new = {"s": s, "point": marks["point"], "tolerance": tolerance, "low": low, "high": high,
               "judged": judged}  # fmt: skip
        for name, array in new.items():
            setattr(self, name, np.concatenate([getattr(self, name), array]))

    def needed(self):
        """Return from where on the path is needed for the points that are left [mm]."""
        least = self.low.min(initial=np.inf)
        return least if self._all_read else min(least, self._before - self._most)

    def drop(self, count):
        """Forget the first points."""
        for name in ("s", "point", "tolerance", "low", "high", "judged"):
            setattr(self, name, getattr(self, name)[count:])


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
