# SPDX-License-Identifier: MIT
"""Where the moves of a program run: lines, arcs and helices of its blocks, in NumPy.

Made from the decoded blocks alone, not from the kernel's segs, so that it can judge the kernel.
All coordinates are machine coordinates with the tool offset in them: where the axes are.
"""

import numpy as np

from pycnc.kernel.bind import lib
from pycnc.kernel.records import counts_per_unit

_PLANE_AXES = {17: (0, 1), 18: (2, 0), 19: (1, 2)}
_MOVES = (lib.NCK_BLOCK_RAPID, lib.NCK_BLOCK_LINE, lib.NCK_BLOCK_ARC)
_NEWTON_STEPS = 3  # from a start within 1e-3 of the helix: the third step is below rounding
ON_PATH_MM = 1e-9  # nearer needs no better
_BY_BLOCK = (
    "start", "end", "is_arc", "_is_thread", "_axes", "_centre", "_sweep", "_angle", "_radius",
)  # fmt: skip
REACH = 3.0  # of a distance: how much longer the way along the path to the nearest point may be


class Moves:
    """The moves of decoded blocks.

    Parameters
    ----------
    blocks : numpy.ndarray
        Of dtype ``nck_block_t``.
    machine : Machine
    start_nm : numpy.ndarray, optional
        (axes,) int64: where the first block begins; without it the machine's start.
    begin_s : float
        Path coordinate there [mm].

    Attributes
    ----------
    start, end : numpy.ndarray
        (blocks, axes) where every block begins and ends [mm, deg].
    end_nm : numpy.ndarray
        (axes,) int64: where the last block ends.
    is_arc : numpy.ndarray
        (blocks,) bool.
    """

    def __init__(self, blocks, machine, start_nm=None, begin_s=0.0):
        start_nm = machine.record["start_nm"] if start_nm is None else start_nm
        position = blocks["target_nm"].astype(np.int64)
        position[:, :3] += blocks["tool_nm"]
        # A thread's pass is no path: it is in step with the spindle.
        self._is_thread = blocks["kind"] == lib.NCK_BLOCK_THREAD
        is_move = np.isin(blocks["kind"], _MOVES) | self._is_thread
        last = np.maximum.accumulate(np.where(is_move, np.arange(len(blocks)), -1))
        end_nm = np.where((last >= 0)[:, None], position[last], start_nm)
        counts = counts_per_unit(machine.record["axis"]["rotary"])
        self.end, self.end_nm = end_nm / counts, end_nm[-1] if len(end_nm) else start_nm
        self.start = np.concatenate([[start_nm / counts], self.end])[:-1]
        self.is_arc = blocks["kind"] == lib.NCK_BLOCK_ARC
        self._arcs(blocks)
        length = np.where(self._is_thread, 0.0, self._lengths())
        self._begin = np.cumsum(np.append(begin_s, length))

    def _arcs(self, blocks):
        """Prepare the arcs: centre in the machine, start angle, radius."""
        pairs = np.array([_PLANE_AXES.get(plane, (0, 1)) for plane in range(20)])
        self._axes = pairs[np.minimum(blocks["plane"], 19)]
        tool = np.take_along_axis(blocks["tool_nm"], self._axes, axis=1) / lib.NCK_COUNTS_PER_MM
        self._centre = blocks["centre_mm"] + tool
        self._sweep = blocks["sweep_rad"]
        radius = np.take_along_axis(self.start, self._axes, axis=1) - self._centre
        self._angle = np.arctan2(radius[:, 1], radius[:, 0])
        self._radius = np.hypot(radius[:, 0], radius[:, 1])

    @classmethod
    def join(cls, pieces):
        """Return the moves of pieces that follow each other as one.

        Parameters
        ----------
        pieces : sequence of Moves
            One at least.
        """
        whole = object.__new__(cls)
        for name in _BY_BLOCK:
            setattr(whole, name, np.concatenate([getattr(piece, name) for piece in pieces]))
        begins = [piece._begin[1:] for piece in pieces]
        whole._begin = np.concatenate([pieces[0]._begin[:1], *begins])
        whole.end_nm = pieces[-1].end_nm
        return whole

    def point(self, block, q):
        """Return points of moves.

        Parameters
        ----------
        block : numpy.ndarray
            (n,) indices of blocks.
        q : numpy.ndarray
            (n,) how far along each move, 0 … 1.

        Returns
        -------
        numpy.ndarray
            (n, axes) [mm, deg].
        """
        points = self.start[block] + q[:, None] * (self.end[block] - self.start[block])
        arc = np.flatnonzero(self.is_arc[block])
        index = block[arc]
        angle = self._angle[index] + q[arc] * self._sweep[index]
        around = np.stack([np.cos(angle), np.sin(angle)], axis=1) * self._radius[index, None]
        rows = arc[:, None]
        points[rows, self._axes[index]] = self._centre[index] + around
        return points

    def distance(self, block, points):
        """Return how far points are from their moves, in the path metric (1 deg counts as 1 mm).

        Parameters
        ----------
        block : numpy.ndarray
            (n,) index of the block that each point belongs to.
        points : numpy.ndarray
            (n, axes) [mm, deg].

        Returns
        -------
        numpy.ndarray
            (n,) [mm].
        """
        q = np.empty(len(block))
        arc = self.is_arc[block]
        q[~arc] = self._nearest_on_line(block[~arc], points[~arc])
        q[arc] = self._nearest_on_helix(block[arc], points[arc])
        return np.linalg.norm(points - self.point(block, q), axis=1)

    def marks(self, arc_step):
        """Return points of the moves, in order: every move's end, and points on arcs between.

        Parameters
        ----------
        arc_step : float
            Angle from one point of an arc to the next, at most [rad].

        Returns
        -------
        block : numpy.ndarray
            (n,) indices of blocks that have a length.
        q : numpy.ndarray
            (n,) how far along each of them, 0 … 1.
        s : numpy.ndarray
            (n,) path coordinates [mm].
        """
        moves = np.flatnonzero(np.diff(self._begin) > 0)
        turn = np.where(self.is_arc[moves], np.abs(self._sweep[moves]), 0)
        count = np.maximum(1, np.ceil(turn / arc_step)).astype(np.intp)
        block = np.repeat(moves, count)
        done = np.arange(len(block)) - np.repeat(np.cumsum(count) - count, count) + 1
        q = done / np.repeat(count, count)
        return block, q, self._begin[block] + q * np.diff(self._begin)[block]

    def block_at(self, s):
        """Return the blocks in which path coordinates are [mm]."""
        block = np.searchsorted(self._begin, s, "right") - 1
        return np.clip(block, 0, len(self.is_arc) - 1)

    def nearest(self, block, points):
        """Return how far points are from the path about a block: it, and its neighbours.

        Neighbours are looked at as far along the path as `REACH` times the distance from the block.

        Parameters
        ----------
        block : numpy.ndarray
            (n,) index of the block that each point is about.
        points : numpy.ndarray
            (n, axes) [mm, deg].

        Returns
        -------
        numpy.ndarray
            (n,) [mm].
        """
        best = self.distance(block, points)
        begin, last = self._begin, len(self.is_arc) - 1
        far, k = np.flatnonzero(best > ON_PATH_MM), 0
        reach = REACH * best
        while len(far):
            k += 1
            own = block[far]
            below, above = np.maximum(own - k, 0), np.minimum(own + k, last)
            for other in (below, above):
                best[far] = np.minimum(best[far], self.distance(other, points[far]))
            again = (begin[own] - begin[below] <= reach[far]) & (own > k)
            again |= (begin[above + 1] - begin[own + 1] <= reach[far]) & (own + k < last)
            far = far[again & (best[far] > ON_PATH_MM)]
        return best

    def _nearest_on_line(self, block, points):
        along = self.end[block] - self.start[block]
        square = np.einsum("ij,ij->i", along, along)
        ahead = np.einsum("ij,ij->i", points - self.start[block], along)
        return np.clip(np.divide(ahead, square, out=np.zeros(len(block)), where=square > 0), 0, 1)

    def _nearest_on_helix(self, block, points):
        sweep = self._sweep[block]
        q = self._turn(block, points) / sweep
        for _ in range(_NEWTON_STEPS):
            along = self._tangent(block, q)
            apart = points - self.point(block, q)
            q += np.einsum("ij,ij->i", apart, along) / np.einsum("ij,ij->i", along, along)
        return np.clip(q, 0, 1)

    def _turn(self, block, points):
        """Return the angle from the start to each point, on the turn of the helix it is on."""
        sweep, around = self._sweep[block], 2 * np.pi
        local = np.take_along_axis(points, self._axes[block], axis=1) - self._centre[block]
        angle = np.arctan2(local[:, 1], local[:, 0]) - self._angle[block]
        straight = self.end[block] - self.start[block]
        np.put_along_axis(straight, self._axes[block], 0, axis=1)
        square = np.einsum("ij,ij->i", straight, straight)
        ahead = np.einsum("ij,ij->i", points - self.start[block], straight)
        q = np.divide(ahead, square, out=np.full(len(block), 0.5), where=square > 0)
        expected = q * sweep  # of a flat arc: its middle, the angle that is nearest to all of it
        return angle + around * np.round((expected - angle) / around)

    def _tangent(self, block, q):
        """Return the derivative of point by q."""
        along = self.end[block] - self.start[block]
        angle = self._angle[block] + q * self._sweep[block]
        turn = np.stack([-np.sin(angle), np.cos(angle)], axis=1)
        np.put_along_axis(
            along,
            self._axes[block],
            turn * (self._radius[block] * self._sweep[block])[:, None],
            axis=1,
        )
        return along

    def bounds(self):
        """Return the smallest and the largest coordinate of every axis, arcs included.

        Returns
        -------
        low, high : numpy.ndarray
            (axes,) [mm, deg].
        """
        corners = [self.start[:1], self.end]
        arc = np.flatnonzero(self.is_arc)
        for quarter in range(4):  # an arc reaches beyond its ends only on its quadrants
            angle = quarter * np.pi / 2 - self._angle[arc]
            sweep = self._sweep[arc]
            ahead = np.mod(np.where(sweep > 0, angle, -angle), 2 * np.pi)
            inside = ahead < np.abs(sweep)
            hit = arc[inside]
            corners.append(self.point(hit, ahead[inside] / np.abs(sweep[inside])))
        every = np.concatenate(corners)
        return every.min(axis=0), every.max(axis=0)

    def length(self):
        """Return the length of all moves [mm of the path metric]."""
        return float(self._begin[-1] - self._begin[0])

    @property
    def end_s(self):
        """Path coordinate behind the last block [mm]."""
        return float(self._begin[-1])

    def _lengths(self):
        straight = self.end - self.start
        arc = np.flatnonzero(self.is_arc)
        straight[arc[:, None], self._axes[arc]] = 0
        turned = np.where(self.is_arc, self._radius * self._sweep, 0)
        return np.sqrt(np.einsum("ij,ij->i", straight, straight) + turned**2)


class Along:
    """The moves of a program about a place that goes along its path.

    Of a long program only those are in memory: the place's piece of blocks, the one before it and
    the one behind it.

    Parameters
    ----------
    program : Program

    Attributes
    ----------
    moves : Moves
        Those about the place.
    until : float
        As long as the place is before this path coordinate they stay [mm].
    """

    def __init__(self, program):
        self._machine, self._pieces = program.machine, program.pieces()
        self._window, self._end = [], (None, 0.0)
        self.moves, self.until = None, -np.inf

    def go_to(self, s):
        """Move the place on to a path coordinate [mm]."""
        while s >= self.until:
            blocks = next(self._pieces, None)
            if blocks is None:
                self.until = np.inf
                break
            self.until = self._end[1] if self._window else -np.inf
            self._window = [*self._window[-2:], Moves(blocks, self._machine, *self._end)]
            self._end = self._window[-1].end_nm, self._window[-1].end_s
            self.moves = None
        if self.moves is None:
            self.moves = Moves.join(self._window)
