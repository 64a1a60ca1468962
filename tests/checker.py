# SPDX-License-Identifier: MIT
"""The physics of a run, judged from its setpoints alone: NumPy, and nothing of the planner's.

What goes in: decoded blocks (what the program says), the machine's limits, what the operator did,
and the rows of a run in pieces of any size. The path is made of the blocks again; every speed,
acceleration and jerk is a finite difference of setpoints.

- every axis keeps its speed and acceleration, in the double poses and in the integer joints;
- no axis leaves its travel, but where the program does;
- the path coordinate goes forward, to the end, at the feed at most, within the acceleration and,
  under a jerk-limited slope, the jerk that the machine allows on the path; on a clocked path, whose
  coordinate is the program's, what of the axes' acceleration and jerk lies along it does;
- every pose is on the programmed path where its coordinate says, or within the tolerance in force
  there, and no longer way is gone than the coordinate's;
- within a tolerance the run comes as near to every corner of the program and every part of an arc,
  in their order;
- under a jerk-limited slope every axis keeps its jerk wherever a tolerance is in force, and inside
  every block of the exact path, straight or arc;
- exact stops land on their end points to the nanometre, dwells last as long as they are to, or
  longer where there is a hold or, under a jerk-limited slope, a plan that is late;
- a hold and an abort come to rest in time; the last pose is the program's end.
"""

import math

import numpy as np
from programmed_path import COUNTS, Limits, Path
from visits import Visits

SHARE = 1e-6  # how far a limit may be passed
# … by acceleration and jerk where a late prep lets the tick brake by itself: it goes by the steps
# of a plan that it follows (csrc/nck/tick/6_interpolate/README.md, "The clock").
LATE_SHARE = 0.05
SPLINE = 2  # nck_seg_kind_t: an interval of a clocked path
STRETCH = 2.5  # a smoothed path may be as much longer than its coordinate somewhere
ROUNDING = 8 * 2.0**-52  # of a coordinate, 8 ulp at most; felt in accelerations by 1/T²
PATH_ERROR_MM = 1e-6
STANDS_MM = 1e-9  # a step that has no direction
COORDINATE_MM = 1e-7  # between a path coordinate and the pose it belongs to
BACKWARD_MM = 1e-9  # steps back that are rounding
ORDERS = ("speed", "acceleration", "jerk")
SUMS = (2, 4, 8)  # of the absolute coefficients of the differences
SPREAD = (1 / 12, 1 / 6, 1 / 4)  # the variance of their weights, in periods²
SETTLED = 24  # ticks in a block after which no output filter mixes in what came before
ANSWER_S = 0.2  # to a command, before braking begins
# The mean over four periods, which the jerk-limited slope hands out, raises the speed at a kink of
# the profile by J τ²/24, and cells of one period by J q²/8 more
# (csrc/nck/prep/5_slope/README.md, "Output filter").
# A feed may be passed by so much where a faster block begins; no limit of an axis may.
FILTER_PERIODS, CELL_PERIODS = 4, 1.35


def _units(ways):
    """Return the directions of ways; of none, zero."""
    size = np.linalg.norm(ways, axis=1, keepdims=True)
    return np.divide(ways, size, out=np.zeros_like(ways), where=size > STANDS_MM)


def _changes(rate):
    """Return by how much rates change from or to the next one."""
    change = np.linalg.norm(np.diff(rate, axis=0), axis=1)
    return np.maximum(np.append(change, 0.0), np.insert(change, 0, 0.0))


class PhysicsError(AssertionError):
    """A run breaks a promise."""


class Operator:
    """What the operator did: overrides and holds over ticks.

    Parameters
    ----------
    commands : iterable of tuple
        (tick, name, numbers…), as `pycnc.run` takes them.
    limits : Limits
    answer : float, optional
        Ticks within which a command must have shown; None: what braking takes, and ANSWER_S.
    """

    def __init__(self, commands, limits, answer=None):
        self.commands = sorted(commands, key=lambda command: command[0])
        axes = limits.present
        ramp_s = np.max(limits.v_max[axes] / limits.a_max[axes])
        if np.isfinite(limits.j_max[axes]).all():
            ramp_s += np.max(limits.a_max[axes] / limits.j_max[axes])
        braked = math.ceil((ANSWER_S + 2 * ramp_s) / limits.period_s)
        self.answer = braked if answer is None else answer
        self.aborted = any(name == "abort" for _, name, *_ in self.commands)
        self._overrides = [(0, 1.0, 1.0)]
        self._held = []  # (from, to) in ticks
        held_at, single, at_end = None, False, False  # at_end: may rest at the end of a block
        for tick, name, *numbers in self.commands:
            if name == "override":
                self._overrides.append((tick, *(number / 100 for number in numbers)))
            if name in ("hold", "abort") and held_at is None:
                held_at = tick
            if name == "single_block":
                single, at_end = bool(numbers[0]), at_end or bool(numbers[0])
            if name == "resume":
                at_end = single
            if name == "resume" and held_at is not None and not self._aborted_before(tick):
                self._held.append((held_at, tick))
                held_at = None
        if held_at is not None:
            self._held.append((held_at, math.inf))
        last = self._overrides[-1]
        self.ends_held = held_at is not None or at_end or 0 in last[1:]

    def _aborted_before(self, tick):
        return any(name == "abort" and at <= tick for at, name, *_ in self.commands)

    def overrides(self, ticks):
        """Return the largest overrides of feed and rapids that may still be felt at ticks."""
        feed, rapid = np.zeros(len(ticks)), np.zeros(len(ticks))
        ends = [at for at, *_ in self._overrides[1:]] + [math.inf]
        for (begin, *shares), end in zip(self._overrides, ends, strict=True):
            felt = (ticks > begin) & (ticks <= end + self.answer)
            feed = np.where(felt, np.maximum(feed, shares[0]), feed)
            rapid = np.where(felt, np.maximum(rapid, shares[-1] if len(shares) > 1 else 1.0), rapid)
        return feed, rapid

    def at_rest(self, ticks):
        """Return whether a hold or an abort must have come to rest before ticks."""
        rest = np.zeros(len(ticks), bool)
        for begin, end in self._held:
            rest |= (ticks > begin + self.answer) & (ticks <= end)
        return rest


class Checker:
    """Takes the rows of a run piece by piece; raises PhysicsError at the first broken promise.

    Parameters
    ----------
    blocks : numpy.ndarray
        Of dtype ``nck_block_t``: the whole program, or what stands before its error.
    machine : numpy.void
        Of dtype ``nck_machine_t``.
    commands : iterable of tuple
        What the operator did, as `pycnc.run` takes it.
    answer : float, optional
        See `Operator`.
    late : bool
        The preparation may be late: a dwell may last longer.
    visits : bool
        Whether to ask how near the run comes to the points of the program.

    Attributes
    ----------
    path : Path
    v, a, j : numpy.ndarray
        Largest share of each axis' limit so far; j: where it is promised.
    path_a, path_j : float
        The same of the path.
    path_error_mm : float
    tolerance_used : float
        Largest share of the tolerance in force that the path was left by, or missed by.
    ticks : int
    """

    def __init__(self, blocks, machine, commands=(), answer=None, *, visits=True, late=False):
        self._late = late
        self._limits = Limits.of(machine)
        self.path = Path(blocks, self._limits)
        self._operator = Operator(commands, self._limits, answer)
        start = self._limits.start_nm
        self._poses = np.repeat(start[None] / COUNTS, 3, axis=0)
        self._joints = np.repeat(start[self._limits.joint_axes][None], 3, axis=0)
        self._s, self._block, self._settled = np.zeros(3), np.zeros(3, np.intp), 0
        points = np.concatenate([start[None], self.path.end_nm]) / COUNTS
        low, high = self._limits.travel
        is_left = (points < low).any(axis=0) | (points > high).any(axis=0)
        self._least, self._most = np.where(is_left, -np.inf, low), np.where(is_left, np.inf, high)
        self._visits = Visits(self.path, self._poses[0]) if visits else None
        self._clocked_before = self._clocked_next = np.zeros(3, bool)
        self._exact = np.concatenate(
            [[0], np.cumsum((self.path.length > 0) & ~self.path.keeps_jerk)]
        )
        self._dwelt = np.zeros(len(blocks), np.int64)
        self._times = {}
        self._raise = self._filter_raise()
        self.v, self.a, self.j = np.zeros(9), np.zeros(9), np.zeros(9)
        self.path_a = self.path_j = self.path_error_mm = self.tolerance_used = 0.0
        self.ticks = 0

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
        self._hold(block < len(self.path.length), "a block that the program has not")
        self._hold(np.diff(block, prepend=self._block[-1]) >= 0, "back to an earlier block")
        self._axis_limits(poses, joints, block)
        over = np.maximum(poses - self._most, self._least - poses).max(axis=1)
        self._hold(over <= PATH_ERROR_MM, f"an axis leaves its travel by {over.max():.9g}")
        s = rows["pose"]["s"]
        way = np.linalg.norm(np.diff(np.concatenate([self._poses[-1:], poses]), axis=0), axis=1)
        clocked = rows["pose"]["kind"] == SPLINE  # its coordinate is not the path's length
        self._along_limits(poses, clocked)
        self._progress(s, poses, np.where(clocked, 0, way), clocked)
        self._feed(s, way, clocked)
        self._on_path(block, s, poses)
        if self._visits:
            self._visits.add(s, poses)
        self._stops(block, joints)
        self._poses = np.concatenate([self._poses, poses])[-3:]
        self._joints = np.concatenate([self._joints, joints])[-3:]
        self._s = np.concatenate([self._s, s])[-3:]
        self._clocked_before = self._clocked_next
        self._block = np.concatenate([self._block, block])[-3:]
        self.ticks += len(rows)

    def finish(self):
        """Judge the end of the run: at rest, and everything done."""
        self._rest()
        if self._visits:
            self._visited(self._visits.finish())
        if self._operator.aborted or self._operator.ends_held or not len(self.path.length):
            return
        end = self.path.end_nm[-1, self._limits.joint_axes]
        self._hold(np.array([(self._joints[-1] == end).all()]), f"end {end} is not reached")
        left = self.path.begin[-1] - self._s[-1]
        self._hold(np.array([abs(left) <= COORDINATE_MM]), f"{left} mm of path are left out")
        self._dwells()

    def _filter_raise(self):
        """Return how much further than its feed a period may go [mm]."""
        j, t = self._limits.path_j_max, self._limits.period_s
        if not np.isfinite(j):
            return 0.0
        return j * (FILTER_PERIODS**2 / 24 + CELL_PERIODS**2 / 8) * t**3

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

    def _axis_limits(self, poses, joints, block):
        limits, axes = self._limits, self._limits.joint_axes
        nm = 1 / COUNTS[axes]
        rounding = np.abs(joints - poses[:, axes] / nm).max(axis=1)
        self._hold(rounding <= 0.5 + 1e-3, "a joint is not the rounded pose")
        track = np.concatenate([self._poses, poses])
        counted = np.concatenate([self._joints, joints])
        noise, judged = ROUNDING * np.abs(poses).max(axis=0), np.ones(len(poses), bool)
        bounds = (limits.v_max, limits.a_max, limits.j_max)
        for order, (what, most, found) in enumerate(
            zip(ORDERS, bounds, (self.v, self.a, self.j), strict=True)
        ):
            if order == 2:
                judged = self._jerk_promised(block)
            unit = limits.period_s ** (order + 1)
            values = np.diff(track[2 - order :], n=order + 1, axis=0)[judged] / unit
            more = SUMS[order] * noise / unit + self._late_more(order, most)
            self._within(values, most, more, what, judged)
            np.maximum(found, np.abs(values / most).max(axis=0, initial=0.0), out=found)
            values = np.diff(counted[2 - order :], n=order + 1, axis=0)[judged] * nm / unit
            more = SUMS[order] * 0.5 * nm / unit + self._late_more(order, most[axes])
            self._within(values, most[axes], more, f"joint {what}", judged)

    def _late_more(self, order, most):
        late = self._late and self._operator.commands and order > 0
        return LATE_SHARE * most if late else 0.0

    def _within(self, values, limit, more, what, judged):
        size = np.abs(values)
        excess = (size > limit * (1 + SHARE) + more) | ~np.isfinite(size)
        if excess.any():
            k, axis = np.argwhere(excess)[0]
            good = np.ones(len(judged), bool)
            good[judged] = ~excess.any(axis=1)
            self._hold(good, f"{what} {values[k, axis]:.9g} of axis {axis}, limit {limit[axis]:g}")

    def _jerk_promised(self, block):
        """Return at which ticks the axes' jerk is limited: four poses within tolerances or on the
        moves of cycles there, or on one block that no filter reaches out of."""
        before = np.concatenate([self._block, block])[: len(block)]
        smoothed = self._exact[block + 1] == self._exact[before]
        here = np.arange(len(block))
        entered = np.diff(block, prepend=self._block[-1]) != 0
        age = here - np.maximum.accumulate(np.where(entered, here, -1 - self._settled))
        self._settled = int(age[-1]) + 1
        return smoothed | ((self.path.length[block] > 0) & (age >= SETTLED))

    def _along_limits(self, poses, clocked):
        """What of acceleration and jerk lies along a clocked path keeps to the path's own limits.

        The direction is that of the chord over the same poses: where it turns by the angle φ within
        them, what lies across leaks in by φ²/8 at most, and what that changes by in a period by φ
        times the variance of a difference's weights. A step is a chord, too, shorter than its way
        by φ²/24: that much may come and go from one to the next.
        """
        limits, track = self._limits, np.concatenate([self._poses, poses])
        here = np.concatenate([self._clocked_before, clocked])
        bounds = ((limits.a_max, limits.path_a_max), (limits.j_max, limits.path_j_max))
        for order, (of_axes, most) in enumerate(bounds, 1):
            if most >= np.linalg.norm(of_axes[limits.present]) * (1 - SHARE):
                continue
            points = track[2 - order :]
            step, chord = np.diff(points, axis=0), points[order + 1 :] - points[: -order - 1]
            rate = np.diff(points, n=order + 1, axis=0) / limits.period_s ** (order + 1)
            along = np.abs(np.einsum("ij,ij->i", rate, _units(chord)))
            turn = np.linalg.norm(_units(step[order:]) - _units(step[:-order]), axis=1)
            noise = SUMS[order] * ROUNDING * np.abs(poses).max() / limits.period_s ** (order + 1)
            more = noise + turn**2 / 8 * np.linalg.norm(rate, axis=1)
            more += turn * SPREAD[order] * _changes(rate)
            way = np.linalg.norm(step, axis=1)
            short = np.maximum(way[order:], way[:-order]) * (turn / order) ** 2 / 24
            more += order * short / limits.period_s ** (order + 1)
            more += self._late_more(order, most)
            judged = here[3:]
            for k in range(1, order + 2):
                judged = judged & here[3 - k : -k]
            what = f"along the path {ORDERS[order]} {along.max():.9g}, limit {most:g}"
            self._hold(~judged | (along <= most * (1 + SHARE) + more), what)

    def _progress(self, s, poses, way, clocked):
        """Forward, within acceleration and jerk of the path; and no pose goes further than its
        coordinate, by as much as a smoothed path may be longer."""
        limits, period = self._limits, self._limits.period_s
        track, noise = np.concatenate([self._s, s]), ROUNDING * np.abs(s).max()
        step = np.diff(track[2:])
        self._hold(step >= -BACKWARD_MM, "the run goes backward on the path")
        rounding = 4 * ROUNDING * np.abs(poses).max() + 2 * noise
        longer = STRETCH if (self.path.tolerance > 0).any() else 1 + SHARE
        self._hold(way <= step * longer + rounding, "further than its path coordinate")
        for order, most in enumerate((limits.path_a_max, limits.path_j_max), 1):
            unit = period ** (order + 1)
            values = np.abs(np.diff(track[2 - order :], n=order + 1)) / unit
            values = np.where(self._near(clocked), 0, values)
            more = SUMS[order] * noise / unit + self._late_more(order, most)
            what = f"path {ORDERS[order]} {values.max():.9g}, limit {most:g}"
            self._hold(values <= most * (1 + SHARE) + more, what)
            name = ("path_a", "path_j")[order - 1]
            setattr(self, name, max(getattr(self, name), float((values / most).max())))

    def _near(self, clocked):
        """Return where one of the last poses is on a clocked path."""
        here = np.concatenate([self._clocked_before, clocked])
        self._clocked_next = here[-3:]
        return here[3:] | here[2:-1] | here[1:-2] | here[:-3]

    def _feed(self, s, way, clocked):
        """Neither the path nor the tool on it faster than the program says; at rest when the
        operator holds."""
        step = np.diff(s, prepend=self._s[-1])
        ticks = np.arange(self.ticks + 1, self.ticks + len(s) + 1)
        feed, rapid = self._operator.overrides(ticks)
        for pair in set(zip(feed.tolist(), rapid.tolist(), strict=True)):
            here = (feed == pair[0]) & (rapid == pair[1])
            if pair not in self._times:
                self._times[pair] = self.path.least_times(*pair)
            times, begin = self._times[pair], self.path.begin
            from_s = np.append(self._s[-1], s[:-1])
            at = np.interp(from_s, begin, times) + self._limits.period_s
            most = np.interp(at, times, begin) - from_s
            tool = self.path.tool_speeds(from_s, s, pair[0]) * self._limits.period_s
            path = np.where(clocked, 0, step)
            for what, gone, bound in (("path", path, most), ("tool", way, tool)):
                good = gone <= bound * (1 + SHARE) + self._raise + BACKWARD_MM
                over = np.max((gone - bound)[here]) / self._limits.period_s
                self._hold(good | ~here, f"{what} faster than its feed, by {over} mm/s")
        rests = ~self._operator.at_rest(ticks) | (np.abs(step) <= BACKWARD_MM)
        self._hold(rests, "a hold or an abort does not come to rest")

    def _on_path(self, block, s, poses):
        """On the path where the coordinate says, or within the tolerance in force."""
        path, tolerance = self.path, self.path.tolerance[block]
        exact, smoothed = np.flatnonzero(tolerance == 0), np.flatnonzero(tolerance > 0)
        tolerance[smoothed] = path.tolerance_at(s[smoothed])
        apart = np.zeros(len(block))
        apart[exact] = path.apart(block[exact], s[exact], poses[exact])
        apart[smoothed] = path.nearest(s[smoothed], poses[smoothed], tolerance[smoothed])
        off = f"{apart.max()} mm off the path"
        self._hold(apart <= np.maximum(tolerance * (1 + SHARE), PATH_ERROR_MM), off)
        self.path_error_mm = max(self.path_error_mm, float(apart.max()))
        smoothed = smoothed[tolerance[smoothed] > 0]  # where pieces end within none is left
        used = apart[smoothed] / tolerance[smoothed]
        self.tolerance_used = max(self.tolerance_used, float(used.max(initial=0.0)))
        q = np.clip(path.along(block[exact], s[exact], poses[exact]), 0, 1)
        here = path.begin[block[exact]] + q * path.length[block[exact]]
        agree = np.ones(len(block), bool)
        agree[exact] = np.abs(here - s[exact]) <= COORDINATE_MM
        self._hold(agree, "pose and path coordinate are two places")

    def _visited(self, missed):
        """The run comes near to the points that the program names; missed: where it does not."""
        self.tolerance_used = max(self.tolerance_used, self._visits.largest)
        if missed is not None:
            tick, line, words = missed
            raise PhysicsError(f"tick {tick}, line {line}: a programmed point is {words}")

    def _stops(self, block, joints):
        """Of blocks that share a tick, one stops at most: where the last tick of them stood."""
        path, axes = self.path, self._limits.joint_axes
        came_from = np.concatenate([self._block[-1:], block[:-1]])
        stood = np.concatenate([self._joints[-1:], joints[:-1]])
        count = np.concatenate([[0], np.cumsum(path.is_stop)])
        passed = count[block] - count[came_from]
        self._hold(passed <= 1, "an exact stop is passed without a tick on it")
        numbers = np.where(path.is_stop, np.arange(len(path.is_stop)), 0)
        stop = np.concatenate([[0], np.maximum.accumulate(numbers)])[block]
        landed = (stood == path.end_nm[stop][:, axes]).all(axis=1)
        self._hold((passed == 0) | landed, "an exact stop is left out")
        np.add.at(self._dwelt, block[path.is_dwell[block]], 1)

    def _dwells(self):
        for block in np.flatnonzero(self.path.is_dwell):
            t, period = self.path.dwell_s[block], self._limits.period_s
            ticks = max(1, math.ceil(t / period - 1e-6))
            good = self._dwelt[block] == ticks
            if self._late or self._operator.commands or np.isfinite(self._limits.path_j_max):
                good = self._dwelt[block] >= ticks  # a hold, or a plan that is late
            if not good:
                line = self.path.line[block]
                raise PhysicsError(f"line {line}: dwells {self._dwelt[block]} ticks, not {ticks}")

    def _rest(self):
        """After the last tick the machine stands: the steps to rest are judged too."""
        self._lines = np.zeros(3, np.int64)
        still = np.repeat(self._poses[-1:], 3, axis=0)
        self._axis_limits(still, np.repeat(self._joints[-1:], 3, axis=0), self._block[[-1] * 3])
        self._progress(np.repeat(self._s[-1:], 3), still, np.zeros(3), np.zeros(3, bool))
