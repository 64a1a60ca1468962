# SPDX-License-Identifier: MIT
"""The physics of a run, judged from its setpoints alone: NumPy, and nothing of the planner's.

What goes in: decoded blocks (what the program says), the machine's limits, and the rows of a run in
pieces of any size. The path is made of the blocks again; every speed and acceleration is a finite
difference of setpoints.

- every axis keeps its speed and acceleration, in the double poses and in the integer joints;
- every pose is on the programmed path, which is gone along forward, whole, and at the feed at most;
- exact stops land on their end points to the nanometre, dwells last as long as they are to;
- the path is not accelerated harder than the machine allows;
- the last pose is the program's end.
"""

import math
from dataclasses import dataclass

import numpy as np

SHARE = 1e-6  # how far a limit may be passed
ROUNDING = 8 * 2.0**-52  # of a coordinate, 8 ulp at most; felt in accelerations by 1/T²
PATH_ERROR_MM = 1e-6
BACKWARD_MM = 1e-9  # steps back that are rounding
COUNTS = np.array([1e6] * 3 + [1e9] * 3 + [1e6] * 3)  # nm in a mm, ndeg in a degree: X Y Z A … W
RAPID, LINE, ARC, DWELL, WAIT, OUTPUT, END = range(7)  # block kinds
EXACT_STOP = 1  # path mode G61.1
PLANES = {17: (0, 1), 18: (2, 0), 19: (1, 2)}


class PhysicsError(AssertionError):
    """A run breaks a promise."""


@dataclass
class Limits:
    """What the machine allows; arrays have one item for each of the nine axes."""

    period_s: float
    present: np.ndarray
    v_max: np.ndarray
    rapid: np.ndarray
    a_max: np.ndarray
    path_a_max: float
    feed_max: float
    start_nm: np.ndarray
    joint_axes: list

    @classmethod
    def of(cls, record):
        """Read them from an item of dtype ``nck_machine_t``."""
        axis, present = record["axis"], record["axis"]["present"] == 1
        lathe = record["kinematics"] == 1
        return cls(
            period_s=float(record["period_s"]),
            present=present,
            v_max=np.where(present, axis["v_max"], np.inf),
            rapid=np.where(present, axis["rapid"], np.inf),
            a_max=np.where(present, axis["a_max"], np.inf),
            path_a_max=float(record["path"]["a_max"]),
            feed_max=float(record["path"]["feed_max"]),
            start_nm=record["start_nm"].astype(np.int64),
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
        self.speed = self._speeds(blocks, limits, meant)
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
        """Return the highest path speed that the program allows in every block."""
        with np.errstate(divide="ignore", invalid="ignore"):
            scale = self.length / meant
            by_mode = np.stack([
                blocks["feed"] / 60 * scale,
                blocks["feed"] / 60 * self.length,
                blocks["feed"] * blocks["spindle_rpm"] / 60 * scale,
            ])
            feed = np.minimum(
                np.take_along_axis(by_mode, blocks["feed_mode"][None].astype(np.intp), 0)[0],
                limits.feed_max * scale,
            )
            cosine = np.abs(self.end - self.start) / self.length[:, None]
            rapid = np.where(cosine > 0, limits.rapid / cosine, np.inf).min(axis=1)
        return np.where(blocks["kind"] == RAPID, rapid, feed)

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

    def turned(self, block, points):
        """Return how far around their arcs points are, 0 … 2π, in the sense of the motion."""
        rows = np.arange(len(block))
        du = points[rows, self.u[block]] - self.centre_u[block]
        dv = points[rows, self.v[block]] - self.centre_v[block]
        phi = np.sign(self.sweep[block]) * (np.arctan2(dv, du) - self.angle[block])
        phi = np.mod(phi, 2 * math.pi)
        rounding = np.minimum(0.01, 1e-5 / self.radius[block])
        return np.where(phi > 2 * math.pi - rounding, phi - 2 * math.pi, phi)

    def along_lines(self, block, points):
        """Return the share of each line that is done at points."""
        way = self.end[block] - self.start[block]
        square = np.einsum("ij,ij->i", way, way)
        done = np.einsum("ij,ij->i", points - self.start[block], way)
        return np.divide(done, square, out=np.zeros(len(block)), where=square > 0)


class Checker:
    """Takes the rows of a run piece by piece; raises PhysicsError at the first broken promise.

    Parameters
    ----------
    blocks : numpy.ndarray
        Of dtype ``nck_block_t``: the whole program, or what stands before its error.
    machine : numpy.void
        Of dtype ``nck_machine_t``.

    Attributes
    ----------
    v, a : numpy.ndarray
        Largest share of each axis' limit so far.
    path_error_mm : float
    ticks : int
    """

    def __init__(self, blocks, machine):
        self._limits = Limits.of(machine)
        self._path = Path(blocks, self._limits)
        self._axes = np.flatnonzero(self._limits.present)
        start = self._limits.start_nm
        self._poses = np.repeat(start[None] / COUNTS, 2, axis=0)
        self._joints = np.repeat(start[self._limits.joint_axes][None], 2, axis=0)
        self._block, self._q, self._step = 0, 0.0, 0.0
        self._phi = 0.0  # around the arc, at the last tick
        self._dwelt = np.zeros(len(blocks), np.int64)
        self.v, self.a = np.zeros(9), np.zeros(9)
        self.path_error_mm, self.ticks = 0.0, 0

    def add(self, rows):
        """Judge the next rows (dtype ``sim_row_t``)."""
        if not len(rows):
            return
        begun = rows["pose"]["line"] > 0
        block = np.where(begun, rows["pose"]["block"], 0).astype(np.intp)
        self._lines = rows["pose"]["line"]
        poses = np.ascontiguousarray(rows["pose"]["axis"])
        joints = rows["axes"]["joint_nm"][:, : len(self._limits.joint_axes)]
        self._clock(rows["t_s"])
        self._axis_limits(poses, joints)
        self._on_path(block, poses)
        self._stops(block, joints)
        self._poses = np.concatenate([self._poses, poses])[-2:]
        self._joints = np.concatenate([self._joints, joints])[-2:]
        self.ticks += len(rows)

    def finish(self):
        """Judge the end of the run: at rest, and everything done."""
        self._rest()
        last = len(self._path.end_nm) - 1
        if last < 0:
            return
        end = self._path.end_nm[last, self._limits.joint_axes]
        self._hold(np.array([(self._joints[-1] == end).all()]), f"end {end} is not reached")
        left = self._path.length[self._block :].sum() - self._q * self._path.length[self._block]
        self._hold(np.array([abs(left) <= BACKWARD_MM]), f"{left} mm of path are left out")
        self._dwells()

    # One promise each

    def _hold(self, good, what):
        """Raise at the first item that is False."""
        if good.all():
            return
        k = int(np.flatnonzero(~good)[0])
        line = self._lines[k] if k < len(self._lines) else "?"
        raise PhysicsError(f"tick {self.ticks + k + 1}, line {line}: {what}")

    def _clock(self, t_s):
        ticks = np.arange(self.ticks + 1, self.ticks + len(t_s) + 1)
        self._hold(t_s == ticks * self._limits.period_s, "time is not tick number times period")

    def _axis_limits(self, poses, joints):
        t, axes = self._limits.period_s, self._limits.joint_axes
        v_max, a_max = self._limits.v_max, self._limits.a_max
        v = np.diff(np.concatenate([self._poses[-1:], poses]), axis=0) / t
        a = np.diff(np.concatenate([self._poses, poses]), n=2, axis=0) / t**2
        noise = ROUNDING * np.abs(poses).max(axis=0)
        self._within(v, v_max, v_max * SHARE + 2 * noise / t, "speed")
        self._within(a, a_max, a_max * SHARE + 4 * noise / t**2, "acceleration")
        self.v = np.maximum(self.v, np.abs(v / v_max).max(axis=0))
        self.a = np.maximum(self.a, np.abs(a / a_max).max(axis=0))
        nm = 1 / COUNTS[axes]
        rounding = np.abs(joints - poses[:, axes] / nm).max(axis=1)
        self._hold(rounding <= 0.5 + 1e-3, "a joint is not the rounded pose")
        v = np.diff(np.concatenate([self._joints[-1:], joints]), axis=0) * nm / t
        a = np.diff(np.concatenate([self._joints, joints]), n=2, axis=0) * nm / t**2
        v_max, a_max = v_max[axes], a_max[axes]
        self._within(v, v_max, v_max * SHARE + 2 * 0.5 * nm / t, "joint speed")
        self._within(a, a_max, a_max * SHARE + 4 * 0.5 * nm / t**2, "joint acceleration")

    def _within(self, values, limit, more, what):
        size = np.abs(values)
        excess = (size > limit + more) | ~np.isfinite(size)
        if excess.any():
            k, axis = np.argwhere(excess)[0]
            self._hold(~excess.any(axis=1),
                       f"{what} {values[k, axis]:.9g} of axis {axis}, limit {limit[axis]:g}")

    def _on_path(self, block, poses):
        self._hold(block < len(self._path.length), "a block that the program has not")
        self._hold(np.diff(block, prepend=self._block) >= 0, "back to an earlier block")
        q = self._path.along_lines(block, poses)
        arc = np.flatnonzero(self._path.is_arc[block])
        phi = self._unwrapped(block[arc], poses[arc], np.diff(arc, prepend=-1) == 1)
        q[arc] = phi / np.abs(self._path.sweep[block[arc]])
        q = np.clip(q, 0.0, 1.0)
        apart = np.linalg.norm(poses - self._path.point(block, q), axis=1)
        self._hold(apart <= PATH_ERROR_MM, f"{apart.max()} mm off the path")
        self.path_error_mm = max(self.path_error_mm, float(apart.max()))
        self._progress(block, q, ROUNDING * np.abs(poses).max())
        self._block, self._q = int(block[-1]), float(q[-1])
        self._phi = float(phi[-1]) if len(arc) and arc[-1] == len(block) - 1 else 0.0

    def _unwrapped(self, block, points, follows):
        """Return the angles done around arcs, whole turns counted from each arc's first tick.

        follows: the tick before is on an arc too.
        """
        if not len(block):
            return np.zeros(0)
        phi = self._path.turned(block, points)
        same = follows & (np.diff(block, prepend=self._block) == 0)
        before = np.concatenate([[self._phi], phi[:-1]])
        step = phi - before
        step -= 2 * math.pi * np.round(step / (2 * math.pi))
        way = np.cumsum(np.where(same, step, 0.0))
        first = np.maximum.accumulate(np.where(~same, np.arange(len(block)), -1))
        begin = np.where(first >= 0, phi[first] - way[first], self._phi)
        return phi + 2 * math.pi * np.round((begin + way - phi) / (2 * math.pi))

    def _progress(self, block, q, noise):
        """Forward, not faster than the program says, not accelerated harder than the path may.

        noise: of a coordinate [mm].
        """
        low = self._block
        length, speed = self._path.length[low:], self._path.speed[low:]
        spent = np.divide(length, speed, out=np.zeros(len(length)), where=length > 0)
        top = int(block[-1]) - low + 1
        for part, what in ((length[:top], "length"), (spent[:top], "time")):
            before = np.concatenate([[0.0], np.cumsum(part)])[:-1]
            here = before[block - low] + q * part[block - low]
            step = np.diff(here, prepend=self._q * part[0])
            if what == "time":
                most = self._limits.period_s * (1 + SHARE)
                self._hold(step <= most, f"faster than its feed by {step.max() / most}")
                continue
            self._hold(step >= -BACKWARD_MM, "the run goes backward on the path")
            accel = np.abs(np.diff(step, prepend=self._step)) / self._limits.period_s**2
            most = self._limits.path_a_max * (1 + SHARE) + 4 * noise / self._limits.period_s**2
            self._hold(accel <= most, f"path acceleration {accel.max()}")
            self._step = float(step[-1])

    def _stops(self, block, joints):
        path, axes = self._path, self._limits.joint_axes
        came_from = np.concatenate([[self._came_from], block[:-1]])
        stood = np.concatenate([self._joints[-1:], joints[:-1]])
        count = np.concatenate([[0], np.cumsum(path.is_stop)])
        left = block != came_from
        passed = count[block] - count[came_from] - path.is_stop[came_from]
        self._hold(~left | (passed == 0), "an exact stop is passed without a tick on it")
        landed = (stood == path.end_nm[came_from][:, axes]).all(axis=1)
        self._hold(~left | ~path.is_stop[came_from] | landed, "an exact stop is left out")
        dwelling = block[path.is_dwell[block]]
        np.add.at(self._dwelt, dwelling, 1)
        self._came_from = int(block[-1])

    _came_from = 0

    def _dwells(self):
        for block in np.flatnonzero(self._path.is_dwell):
            t, period = self._path.dwell_s[block], self._limits.period_s
            ticks = max(1, math.ceil(t / period - 1e-6))
            if self._dwelt[block] != ticks:
                line = self._path.line[block]
                raise PhysicsError(f"line {line}: dwells {self._dwelt[block]} ticks, not {ticks}")

    def _rest(self):
        """After the last tick the machine stands: the step to rest is an acceleration too."""
        poses = np.repeat(self._poses[-1:], 2, axis=0)
        joints = np.repeat(self._joints[-1:], 2, axis=0)
        self._lines = np.array([0, 0])
        self._axis_limits(poses, joints)
