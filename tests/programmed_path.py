# SPDX-License-Identifier: MIT
"""What a run is judged by: the machine's limits, and the programmed path made again from decoded
blocks: lines, arcs and helices in machine coordinates. NumPy, and nothing of the planner's."""

import math
from dataclasses import dataclass

import numpy as np

COUNTS = np.array([1e6] * 3 + [1e9] * 3 + [1e6] * 3)  # nm in a mm, ndeg in a degree: X Y Z A … W
RAPID, LINE, ARC, DWELL, WAIT, OUTPUT, END = range(7)  # block kinds
EXACT_STOP, CONTINUOUS, TURNS = 1, 2, 3  # path modes G61.1, G64, a cycle's under G64 P
LINEAR, OPTIMAL = 0, 2  # slope kinds
NEARER_MM = 1e-7  # a point this far from an arc may be nearer to another place of a helix
NEWTON_STEPS = 3
SHORT = 1e-4  # share of an arc over which derivatives are differences
PLANES = {17: (0, 1), 18: (2, 0), 19: (1, 2)}


@dataclass
class Limits:
    """What the machine allows; arrays have one item for each of the nine axes."""

    period_s: float
    present: np.ndarray
    v_max: np.ndarray
    rapid: np.ndarray
    a_max: np.ndarray
    j_max: np.ndarray
    path_a_max: float
    slope: int  # nck_slope_kind_t
    path_j_max: float  # infinite for the linear slope, which does not limit it
    feed_max: float
    start_nm: np.ndarray
    travel: tuple  # its two ends
    joint_axes: list

    @classmethod
    def of(cls, record):
        """Read them from an item of dtype ``nck_machine_t``."""
        axis, present = record["axis"], record["axis"]["present"] == 1
        lathe = record["kinematics"] == 1
        limited = record["slope"] != LINEAR
        return cls(
            period_s=float(record["period_s"]),
            present=present,
            v_max=np.where(present, axis["v_max"], np.inf),
            rapid=np.where(present, axis["rapid"], np.inf),
            a_max=np.where(present, axis["a_max"], np.inf),
            j_max=np.where(present & limited, axis["j_max"], np.inf),
            slope=int(record["slope"]),
            path_a_max=float(record["path"]["a_max"]),
            path_j_max=float(record["path"]["j_max"]) if limited else np.inf,
            feed_max=float(record["path"]["feed_max"]),
            start_nm=record["start_nm"].astype(np.int64),
            travel=(axis["min_nm"] / COUNTS, axis["max_nm"] / COUNTS),
            joint_axes=[0, 2] if lathe else list(np.flatnonzero(present)),
        )


class Path:
    """The programmed path: blocks as lines, arcs and helices, in machine coordinates."""

    def __init__(self, blocks, limits):
        is_move = blocks["kind"] <= ARC
        at = np.maximum.accumulate(np.where(is_move, np.arange(len(blocks)), -1))
        reached = blocks["target_nm"].astype(np.int64)
        reached[:, :3] += blocks["tool_nm"]
        self.end_nm = np.where(at[:, None] >= 0, reached[at], limits.start_nm)
        self.start_nm = np.concatenate([limits.start_nm[None], self.end_nm])[: len(blocks)]
        self.start, self.end = self.start_nm / COUNTS, self.end_nm / COUNTS
        self.is_arc = blocks["kind"] == ARC
        self._bend(blocks)
        self.length, meant = self._lengths()
        self.begin = np.concatenate([[0.0], np.cumsum(self.length)])  # path coordinates
        is_smoothed = (blocks["path_mode"] == CONTINUOUS) & (limits.slope == OPTIMAL)
        self.tolerance = np.where(is_smoothed, blocks["tolerance_mm"], 0.0)
        self.keeps_jerk = (self.tolerance > 0) | (blocks["path_mode"] == TURNS)
        self._feed, self._most = self._speeds(blocks, limits, meant)
        self._is_rapid = blocks["kind"] == RAPID
        self.is_stop = self._stops(blocks)
        self.dwell_s = np.where(blocks["kind"] == DWELL, blocks["dwell_s"], 0.0)
        self.is_dwell = blocks["kind"] == DWELL
        self.line = blocks["line"]

    def _bend(self, blocks):
        rows = np.arange(len(blocks))
        plane = np.where(self.is_arc, blocks["plane"], 17)
        self.u, self.v = np.array([PLANES[p] for p in plane.tolist()]).reshape(-1, 2).T
        offset = np.zeros((len(blocks), 9))
        offset[:, :3] = blocks["tool_nm"] / COUNTS[:3]
        self.centre_u = blocks["centre_mm"][:, 0] + offset[rows, self.u]
        self.centre_v = blocks["centre_mm"][:, 1] + offset[rows, self.v]
        du = self.start[rows, self.u] - self.centre_u
        dv = self.start[rows, self.v] - self.centre_v
        self.radius = np.where(self.is_arc, np.hypot(du, dv), 1.0)
        self.angle = np.arctan2(dv, du)
        self.sweep = np.where(self.is_arc, blocks["sweep_rad"], 0.0)

    def _lengths(self):
        """Return path lengths, and the lengths that a feed is meant for."""
        square = (self.end - self.start) ** 2
        arc = np.flatnonzero(self.is_arc)
        square[arc, self.u[arc]] = (self.radius[arc] * self.sweep[arc]) ** 2
        square[arc, self.v[arc]] = 0
        xyz, abc, uvw = (square[:, k : k + 3].sum(axis=1) for k in (0, 3, 6))
        meant = np.where(xyz > 0, xyz, np.where(uvw > 0, uvw, abc))
        return np.sqrt(square.sum(axis=1)), np.sqrt(meant)

    def _speeds(self, blocks, limits, meant):
        """Return the speeds that the program asks for, and the most that the machine gives."""
        with np.errstate(divide="ignore", invalid="ignore"):
            scale = self.length / meant
            by_mode = np.stack([
                blocks["feed"] / 60 * scale,
                blocks["feed"] / 60 * self.length,
                blocks["feed"] * blocks["spindle_rpm"] / 60 * scale,
            ])
            feed = np.take_along_axis(by_mode, blocks["feed_mode"][None].astype(np.intp), 0)[0]
            cosine = np.abs(self.end - self.start) / self.length[:, None]
            rapid = np.where(cosine > 0, limits.rapid / cosine, np.inf).min(axis=1)
            # Within a tolerance its way is another one: shorter, and in another direction. Then the
            # axes alone are its limit.
            rapid = np.where(self.tolerance > 0, np.inf, rapid)
            wanted = np.where(blocks["kind"] == RAPID, rapid, feed)
            return wanted, np.where(blocks["kind"] == RAPID, rapid, limits.feed_max * scale)

    def tool_speeds(self, from_s, to_s, feed=1.0):
        """Return how fast the tool may be from places to places [mm/s]: the largest feed of the
        blocks between them; without limit where one of them is a rapid."""
        speed = np.where(self._is_rapid, np.inf, np.where(self.length > 0, self._feed * feed, 0.0))
        first, last = (self._blocks_at(s) for s in (from_s, to_s))
        return np.array([speed[a : b + 1].max() for a, b in zip(first, last, strict=True)])

    def _blocks_at(self, s):
        return np.clip(np.searchsorted(self.begin, s, "right") - 1, 0, len(self.length) - 1)

    def least_times(self, feed=1.0, rapid=1.0):
        """Return the time at which every block can begin at the earliest, and the end's [s].

        feed, rapid: overrides, 1 being 100 %.
        """
        speed = np.minimum(self._feed * np.where(self._is_rapid, rapid, feed), self._most)
        spent = np.divide(self.length, speed, out=np.zeros(len(speed)), where=self.length > 0)
        return np.concatenate([[0.0], np.cumsum(spent)])

    def _stops(self, blocks):
        """Return which blocks end in an exact stop: G61.1, or before a dwell, a wait or the end."""
        moves = np.flatnonzero(self.length > 0)
        stop = np.zeros(len(blocks), bool)
        stop[moves] = blocks["path_mode"][moves] == EXACT_STOP
        rests = np.flatnonzero(np.isin(blocks["kind"], (DWELL, WAIT, END)))
        before = np.searchsorted(moves, rests) - 1
        stop[moves[before[before >= 0]]] = True
        if len(moves):
            stop[moves[-1]] = True
        return stop

    def point(self, block, q):
        """Return the points of blocks where the share q of each is done."""
        points = self.start[block] + q[:, None] * (self.end[block] - self.start[block])
        arc = np.flatnonzero(self.is_arc[block])
        b = block[arc]
        phi = self.angle[b] + q[arc] * self.sweep[b]
        points[arc, self.u[b]] = self.centre_u[b] + self.radius[b] * np.cos(phi)
        points[arc, self.v[b]] = self.centre_v[b] + self.radius[b] * np.sin(phi)
        return points

    def tolerance_at(self, s, rounding=1e-7):
        """Return the tolerances of the blocks where s is; the larger where two blocks meet."""
        last = len(self.length) - 1
        before, behind = (
            np.clip(np.searchsorted(self.begin, s + away, "right") - 1, 0, last)
            for away in (-rounding, rounding)
        )
        return np.maximum(self.tolerance[before], self.tolerance[behind])

    def along(self, block, s, points):
        """Return the shares of blocks that are done at points, unclipped.

        s: path coordinates, which tell the turns of an arc apart.
        """
        q = self._along_lines(block, points)
        arc = np.flatnonzero(self.is_arc[block])
        b, sweep = block[arc], np.abs(self.sweep[block[arc]])
        du = points[arc, self.u[b]] - self.centre_u[b]
        dv = points[arc, self.v[b]] - self.centre_v[b]
        phi = np.sign(self.sweep[b]) * (np.arctan2(dv, du) - self.angle[b])
        near = np.clip((s[arc] - self.begin[b]) / self.length[b], 0, 1) * sweep
        q[arc] = (phi + 2 * math.pi * np.round((near - phi) / (2 * math.pi))) / sweep
        return q

    def _along_lines(self, block, points):
        way = self.end[block] - self.start[block]
        square = np.einsum("ij,ij->i", way, way)
        done = np.einsum("ij,ij->i", points - self.start[block], way)
        return np.divide(done, square, out=np.zeros(len(block)), where=square > 0)

    def apart(self, block, s, points):
        """Return how far points are from blocks [mm]."""
        q = np.clip(self.along(block, s, points), 0, 1)
        found = np.linalg.norm(points - self.point(block, q), axis=1)
        steep = np.flatnonzero(self.is_arc[block] & (found > NEARER_MM))
        for _ in range(NEWTON_STEPS):  # of a helix, the nearest point is not at the same angle
            b = block[steep]
            here = self.point(b, q[steep])
            ahead = self.point(b, q[steep] + SHORT) - here
            behind = self.point(b, q[steep] - SHORT) - here
            away = here - points[steep]
            slope = np.einsum("ij,ij->i", away, ahead - behind)
            bend = np.einsum("ij,ij->i", ahead - behind, ahead - behind) / 2
            bend += 2 * np.einsum("ij,ij->i", away, ahead + behind)
            step = np.divide(-slope * SHORT, bend, out=np.zeros(len(b)), where=bend > 0)
            q[steep] = np.clip(q[steep] + step, 0, 1)
            nearer = np.linalg.norm(points[steep] - self.point(b, q[steep]), axis=1)
            found[steep] = np.minimum(found[steep], nearer)
        return found

    def nearest(self, s, points, near, reach=50.0):
        """Return how far points are from the path around the coordinates s [mm].

        Where the block of s itself is as near as `near` asks (one number a point), that is it; else
        its neighbours are looked at too, as far as `reach` along the path.
        """
        last = len(self.length) - 1
        home = np.clip(np.searchsorted(self.begin, s, "right") - 1, 0, last)
        best = self.apart(home, s, points)
        far, k = np.flatnonzero(best > near), 0
        while len(far):
            k += 1
            below, above = np.maximum(home[far] - k, 0), np.minimum(home[far] + k, last)
            for block in (below, above):
                best[far] = np.minimum(best[far], self.apart(block, s[far], points[far]))
            inside = (self.begin[below + 1] > s[far] - reach) & (home[far] >= k)
            inside |= (self.begin[above] < s[far] + reach) & (home[far] + k <= last)
            far = far[inside & (best[far] > near[far])]
        return best
