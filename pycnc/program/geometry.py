# SPDX-License-Identifier: MIT
"""Where the moves of a program run: lines, arcs and helices of its blocks, in NumPy.

Made from the decoded blocks alone, not from the kernel's segs.
All coordinates are machine coordinates with the tool offset in them: where the axes are.
"""

import numpy as np

from pycnc.kernel.bind import lib
from pycnc.kernel.records import counts_per_unit

_PLANE_AXES = {17: (0, 1), 18: (2, 0), 19: (1, 2)}
_MOVES = (lib.NCK_BLOCK_RAPID, lib.NCK_BLOCK_LINE, lib.NCK_BLOCK_ARC)


def is_move(blocks):
    """Tell of blocks whether they move axes, passes of threads among them."""
    return np.isin(blocks["kind"], (*_MOVES, lib.NCK_BLOCK_THREAD))


class Moves:
    """The moves of decoded blocks.

    Parameters
    ----------
    blocks : numpy.ndarray
        Of dtype ``nck_block_t``.
    machine : Machine
    begin : numpy.ndarray, optional
        (axes,) where the first move begins [mm, deg]; without it where the machine is at the start.

    Attributes
    ----------
    start, end : numpy.ndarray
        (blocks, axes) where every block begins and ends [mm, deg].
    is_arc : numpy.ndarray
        (blocks,) bool.
    """

    def __init__(self, blocks, machine, begin=None):
        position = blocks["target_nm"].astype(np.int64)
        position[:, :3] += blocks["tool_nm"]
        # A thread's pass is no path: it is in step with the spindle.
        self._is_path = blocks["kind"] != lib.NCK_BLOCK_THREAD
        last = np.maximum.accumulate(np.where(is_move(blocks), np.arange(len(blocks)), -1))
        counts = counts_per_unit(machine.record["axis"]["rotary"])
        self._begin = machine.record["start_nm"] / counts if begin is None else begin
        self.end = np.where((last >= 0)[:, None], position[last] / counts, self._begin)
        self.start = np.concatenate([[self._begin], self.end])[:-1]
        self.is_arc = blocks["kind"] == lib.NCK_BLOCK_ARC
        self._arcs(blocks)

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

    def bounds(self):
        """Return the smallest and the largest coordinate of every axis, arcs included.

        Returns
        -------
        low, high : numpy.ndarray
            (axes,) [mm, deg].
        """
        every, _ = self.corners()
        return every.min(axis=0), every.max(axis=0)

    def corners(self):
        """Return (points, the block of each) that no move reaches beyond: -1 is the start's.

        Every arc has as many, whichever quadrants it crosses: its end stands for the others.
        """
        corners = [self._begin[None], self.end]
        owners = [np.arange(-1, len(self.end))]
        arc = np.flatnonzero(self.is_arc)
        for quarter in range(4):  # an arc reaches beyond its ends only on its quadrants
            angle = quarter * np.pi / 2 - self._angle[arc]
            sweep = self._sweep[arc]
            ahead = np.mod(np.where(sweep > 0, angle, -angle), 2 * np.pi)
            inside = ahead < np.abs(sweep)
            points = self.end[arc]
            points[inside] = self.point(arc[inside], ahead[inside] / np.abs(sweep[inside]))
            corners.append(points)
            owners.append(arc)
        return np.concatenate(corners), np.concatenate(owners)

    def length(self):
        """Return the length of all moves [mm of the path metric]."""
        lengths = np.where(self._is_path, self.lengths(), 0.0).cumsum()
        return float(lengths[-1]) if len(lengths) else 0.0

    def lengths(self, axes=slice(None)):
        """Return the length of each move [mm of the path metric], of some axes alone if asked."""
        straight = self.end - self.start
        arc = np.flatnonzero(self.is_arc)
        straight[arc[:, None], self._axes[arc]] = 0
        turned = np.where(self.is_arc, self._radius * self._sweep, 0)
        straight = straight[:, axes]
        return np.sqrt(np.einsum("ij,ij->i", straight, straight) + turned**2)
