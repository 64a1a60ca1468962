# SPDX-License-Identifier: MIT
"""Every ordered pair of answers at drawn moments: does the path rest in time, and within limits?

    .venv/bin/python tests/stop_gate.py 20000          so many seeds from 0 on
    .venv/bin/python tests/stop_gate.py 1 7000 -v      one case, told whatever it does

The same cases run live: tests/linuxcnc/linuxcnc_stops.py, tests/controller/firmware_stops.py.

A seed draws a program, a feed from F1 to F12000, limits, a period from 0.25 to 10 ms, a slope, how
much prep may do in a period, what the operator does first, and the rest that he asks for then. In
one case of four prep is dead from that moment on. In another the operator wants to go on after a
while, be the path at rest or not.

The time to rest counts from the moment of asking. It is held against what the speed and the
acceleration of then need along a line, with the limits of an axis, and 20 periods:

    v/a + a/j, or 2√(v/j) where a is not reached; before that a/j for what it gains speed by

Bends take acceleration and jerk of an axis, too: there a brake has to wait for what the axis has
across the path to turn, a/j as well.
"""

import sys
from dataclasses import dataclass

import numpy as np

from pycnc import kernel
from pycnc.errors import InternalError
from pycnc.kernel import dtype, ffi, lib, pointer
from pycnc.machine import Machine

PERIODS = 20
MOST = 1.5  # of the bound
BENT_MOST = 2.2  # … within a tolerance, where bends may leave a brake nothing for a while
SOME_BENT = 0.01  # of the rests may take more than MOST of it there
SOME = 1e-3  # of the rests may pass a limit: where a brake meets the plan's own
SAMPLE_SOME = 1 / 12  # … of a dozen or more in the suite, which knows no thousands
LIMIT = 1.05  # of an axis' acceleration and jerk, where the tick brakes by itself
MOMENTS = 8000  # ticks: the last one of a first answer
V_MAX = 250.0  # mm/s: of every axis
CORNER_MM = 0.6  # twice the widest tolerance that is drawn
RESTS = 6000  # ticks that a rest may take at most
SETTLES = 12  # ticks at rest that are looked at
FIRST = ("none", "override", "up", "rapid", "speed", "hold", "resume", "single_block")
LAST = ("hold", "abort", "override", "rapids", "speed", "travel")
FREE, CALLS = 2**32 - 1, 1_000_000  # no limit of speed; 100 % in millionths


def lines(rng, feed):
    """Return one long move or a few."""
    points = np.cumsum(rng.uniform(-80, 80, (rng.integers(1, 5), 3)), 0)
    return [f"G1 X{x:.3f} Y{y:.3f} Z{z:.3f} F{feed}" for x, y, z in points]


def polygon(rng, feed):
    """Return short lines that turn."""
    turns = np.cumsum(rng.normal(0, rng.choice([0.05, 0.4, 1.5]), 120))
    steps = rng.choice([0.05, 0.5, 3.0, 12.0]) * rng.uniform(0.3, 1.7, 120)
    points = np.cumsum(np.column_stack((steps * np.cos(turns), steps * np.sin(turns))), 0)
    return [f"F{feed}", *(f"G1 X{x:.4f} Y{y:.4f}" for x, y in points)]


def arcs(rng, feed):
    """Return a chain of tangent arcs, some of them helices."""
    out, x, y, way = [f"F{feed}"], 0.0, 0.0, 0.0
    for _ in range(rng.integers(2, 30)):
        radius, sweep, side = rng.uniform(0.5, 30), rng.uniform(0.3, 3.0), rng.choice([-1, 1])
        i, j = -side * radius * np.sin(way), side * radius * np.cos(way)
        way += side * sweep
        x, y = x + i + side * radius * np.sin(way), y + j - side * radius * np.cos(way)
        down = f" Z{-rng.uniform(0, 5):.3f}" if rng.random() < 0.2 else ""
        out.append(f"{'G3' if side > 0 else 'G2'} X{x:.5f} Y{y:.5f} I{i:.5f} J{j:.5f}{down}")
    return out


def wave(rng, feed):
    """Return the chords of a smooth curve."""
    t = np.linspace(0, rng.uniform(2, 9), rng.integers(200, 1200))
    y = rng.uniform(1, 15) * np.sin(rng.uniform(0.5, 4) * t)
    return [f"F{feed}", *(f"G1 X{a:.4f} Y{b:.4f}" for a, b in zip(20 * t, y, strict=True))]


def rapids(rng, feed):
    """Return rapids and feeds by turns."""
    points = enumerate(np.cumsum(rng.uniform(-40, 40, (9, 2)), 0))
    return [f"{'G0' if k % 2 else f'G1 F{feed}'} X{x:.3f} Y{y:.3f}" for k, (x, y) in points]


FAMILIES = (lines, polygon, arcs, wave, rapids)


@dataclass
class Case:
    """What a seed draws."""

    seed: int
    family: str
    text: str
    exact: bool
    slope: str
    period_s: float
    a: float
    j: float
    prep_steps: int
    dead: bool
    goes_on: bool
    patience: int
    first: str
    value: float
    last: str
    where: str = ""  # what runs it, where that is drawn, too

    def machine(self):
        """Return its machine."""
        axes = "".join(
            f"[axis.{x}]\nv_max_mm_s = {V_MAX:g}\na_max_mm_s2 = {self.a}\nj_max_mm_s3 = {self.j}\n"
            for x in "xyz"
        )
        kernel_, path = f"period_ms = {self.period_s * 1e3}", f'slope = "{self.slope}"'
        return Machine.from_text(f"[kernel]\n{kernel_}\n[path]\n{path}\n{axes}", f"{self.seed}")

    def goes_on_again(self):
        """Tell whether the operator wants to go on after a while: from most rests he can."""
        return self.goes_on and self.last not in ("abort", "travel", "soft")

    def keeps_jerk(self):
        """Tell whether every axis keeps its jerk all along: no junctions of an exact path."""
        is_line = self.slope != "linear" and self.text.count("\nG1") == 1
        return is_line or self.bends()

    def bends(self):
        """Tell whether its acceleration across the path is to be seen: junctions of an exact path
        are passed by jumps."""
        return self.slope == "optimal" and not self.exact

    def most(self):
        """Return how much of the bound a rest may take."""
        return BENT_MOST if self.bends() else MOST

    def least_s(self, v, a, across=0.0):
        """Return how long the speed v and the acceleration a take along a line; across: the most
        of an axis' acceleration, in a bend."""
        if self.slope == "linear":
            return v / self.a
        gained = max(a, 0) / self.j
        v += gained * max(a, 0) / 2
        waits = max(gained, min(across, self.a) / self.j)
        reached = v > self.a**2 / self.j
        return waits + (v / self.a + self.a / self.j if reached else 2 * np.sqrt(v / self.j))


def draw(seed):
    """Return the case of a seed."""
    rng = np.random.default_rng([seed, 2611])
    family = FAMILIES[rng.integers(len(FAMILIES))]
    feed = round(10 ** rng.uniform(0, 4.08) if rng.random() < 0.5 else rng.uniform(600, 12000))
    exact = bool(rng.random() < 0.5)
    mode = "G61" if exact else f"G64 P{rng.choice([0.001, 0.01, 0.05, 0.3])}"
    a = float(round(10 ** rng.uniform(2.5, 4)))
    ending = rng.choice(["dead", "goes on", "stays", "stays"])
    return Case(
        seed, family.__name__, "\n".join([f"G17 G21 G90 G94 {mode}", *family(rng, feed), "M2\n"]),
        exact, str(rng.choice(["linear", "jerk", "optimal"])),
        float(rng.choice([0.25, 0.5, 1, 2, 4, 10])) * 1e-3, a,
        float(round(a * 10 ** rng.uniform(0.5, 2))),
        int(rng.choice([2, 8, kernel.PREP_STEPS, kernel.PREP_STEPS])), ending == "dead",
        ending == "goes on", int(10 ** rng.uniform(0, 3)), str(rng.choice(FIRST)),
        float(10 ** rng.uniform(-2.7, 0.3)), str(rng.choice(LAST)),
    )  # fmt: skip


class Run:
    """A run, tick by tick where something happens."""

    def __init__(self, case):
        self._case, self._pieces, self.ticks = case, [], 0
        self._run = kernel.Simulation(case.text.encode(), case.machine(), case.prep_steps)
        self._nck, self._sim = self._run._nck, self._run._sim
        self._rests = False  # the simulation takes some rests for a fault
        self._rows = np.empty(256, dtype("sim_row_t"))

    def go(self, ticks):
        """Go on for at most so many ticks; return whether there was an end."""
        count, end = ffi.new("size_t *"), self.ticks + ticks
        while self.ticks < end:
            most = min(len(self._rows), end - self.ticks)
            status = lib.sim_run(self._sim, pointer("sim_row_t", self._rows), most, count)
            self._pieces.append(self._rows["pose"][: count[0]].copy())
            self.ticks += count[0]
            if status == lib.NCK_E_INTERNAL and not self._rests:
                raise InternalError(f"seed {self._case.seed} stands still", id="internal")
            if status != lib.NCK_OK or self._sim.end:
                return True
        return False

    def poses(self):
        """Return what it has done so far."""
        return np.concatenate(self._pieces)

    def die(self):
        """Let prep do nothing any more."""
        self._sim.prep_steps = 0

    def live(self):
        """Let prep work again."""
        self._sim.prep_steps = self._case.prep_steps

    def first(self, name, value):
        """Do what the operator does first."""
        ppm = max(1, round(value * CALLS))
        if name in ("override", "up"):
            lib.nck_set_override(self._nck, ppm, CALLS)
        elif name == "rapid":
            lib.nck_set_override(self._nck, CALLS, min(ppm, CALLS))
        elif name == "speed":
            lib.nck_set_speed(self._nck, max(1, round(value * 1e5)))
        elif name == "hold":
            lib.nck_hold(self._nck)
        elif name == "resume":
            lib.nck_resume(self._nck)
        elif name == "single_block":
            lib.nck_set_single_block(self._nck, 1)

    def between(self, name):
        """Take it back, where it is of those that are."""
        self._sim.rest_ticks = 0
        if name == "up":
            lib.nck_set_override(self._nck, CALLS, CALLS)
        if name == "hold":
            lib.nck_resume(self._nck)

    def rest(self, name, box):
        """Ask for rest."""
        self._rests = True
        if name == "hold":
            lib.nck_hold(self._nck)
        elif name == "abort":
            lib.nck_abort(self._nck)
        elif name == "travel":
            for axis, (low, high) in enumerate(box):
                lib.nck_set_travel(self._nck, axis, low, high)
        elif name == "speed":
            lib.nck_set_speed(self._nck, 0)
        else:
            lib.nck_set_override(self._nck, 0, 0)

    def go_on(self):
        """End every rest but an abort's."""
        self._rests = False
        self._sim.end = self._sim.rest_ticks = 0
        lib.nck_set_speed(self._nck, FREE)
        lib.nck_set_override(self._nck, CALLS, CALLS)
        lib.nck_set_single_block(self._nck, 0)
        lib.nck_resume(self._nck)


@dataclass
class Told:
    """How a case went; None of what was not to be seen."""

    case: Case
    v: float  # when the rest was asked for
    rest_s: float
    share: float  # of the bound; soft limits: 0, for they are met later
    outside_mm: float  # of the soft limits
    fast: float  # the most of an axis' limit of speed from then on
    a: float  # … of acceleration
    j: float  # … of jerk

    def is_late(self):
        """Tell whether the path rested too late."""
        return self.share > self.case.most()

    def is_beyond(self):
        """Tell whether an axis passed a limit."""
        jerks = self.case.keeps_jerk() and self.j > LIMIT
        return max(self.fast, self.a) > LIMIT or jerks or self.outside_mm > 1e-6


def _box(case, plain, pose):
    """Return soft limits that the path leaves in what a brake may take at its most, and a little.

    They are those of the way until then, which goes a little further out at another speed: corners
    lie between two ticks, and are cut by less. None where no way is known that leaves them.
    """
    v = V_MAX
    brake = v * (v / case.a + case.a / case.j + 31 * case.period_s) + 1.0
    behind = plain["s"] >= pose["s"] + brake
    if not behind.any():
        return None
    way = plain["axis"][: int(np.argmax(behind)) + 1, :3]
    box = [(np.iinfo(np.int64).min, np.iinfo(np.int64).max)] * 3
    axis = int(np.argmax(np.ptp(way, axis=0)))
    further = v * case.period_s + CORNER_MM
    ends = way[:, axis].min() - further, way[:, axis].max() + further
    box[axis] = tuple(int(round(end * 1e6)) for end in ends)
    return box


def _outside(axes, box):
    low, high = (np.array([side[k] for side in box], float) / 1e6 for k in (0, 1))
    return max(0.0, float((low - axes).max()), float((axes - high).max()))


@dataclass
class Moments:
    """When the operator does what, and how far it has come then."""

    at: int  # ticks: his first answer
    then: int  # the rest that he asks for
    run: Run  # until then
    box: list | None  # the soft limits that are to stop it


def moments(case):
    """Return when he does what; None where nothing moves when the rest is asked for."""
    rng = np.random.default_rng([case.seed, 7])
    plain = Run(case)
    plain.go(MOMENTS)
    moving = np.flatnonzero(plain.poses()["v"] > 0)
    if len(moving) < 30:
        return None
    at, then = (int(tick) for tick in np.sort(rng.choice(moving, 2, replace=False)))
    run = Run(case)
    run.go(at)
    run.first(case.first, case.value)
    run.go((then - at) // 2)
    run.between(case.first)
    if run.go(then - run.ticks) or not run.poses()["v"][-1] > 0:
        return None
    box = _box(case, plain.poses(), run.poses()[-1]) if case.last == "travel" else None
    if case.last == "travel" and box is None:
        return None
    return Moments(at, then, run, box)


def try_case(case):
    """Return how it goes; None where nothing moves when the rest is asked for."""
    drawn = moments(case)
    if drawn is None:
        return None
    drawn.run.rest(case.last, drawn.box)
    if case.dead and case.last != "travel":
        drawn.run.die()
    return _rest_of(case, drawn.run, drawn.box)


def _rest_of(case, run, box):
    """Let it come to rest, and go on where it is to; judge it."""
    then, poses = run.ticks, run.poses()
    again = case.goes_on_again()
    longest = case.most() * bound_of(case, poses["v"], poses["axis"][:, :3], then) / case.period_s
    run.go(case.patience if again else max(RESTS, int(longest) + SETTLES))
    if again:
        run.go_on()
        run.go(RESTS)
    poses = run.poses()
    return judge(case, poses["v"], poses["axis"][:, :3], then, box)


def bound_of(case, v, axes, then):
    """Return how long a rest may take that is asked for before a tick, at its speeds and axes [s].
    """
    gained = (v[then - 1] - v[max(0, then - 2)]) / case.period_s
    bend = np.abs(np.diff(axes[max(0, then - 3) : then], 2, axis=0)).max(initial=0)
    across = bend / case.period_s**2 if case.bends() else 0.0
    least_s = case.least_s(float(v[then - 1]), float(gained), float(across))
    return least_s + PERIODS * case.period_s


def judge(case, v, axes, then, box=None, grain=0.0):
    """Return how a case went, by its speeds and axes, a row a tick, from the tick before which it
    was asked for rest on. grain: to which the axes are rounded [mm]."""
    again = case.goes_on_again()
    asked = v[then : then + case.patience] if again else v[then:]
    rests = np.flatnonzero(asked <= 0)
    rest_s = (int(rests[0]) if len(rests) else len(asked)) * case.period_s
    share = rest_s / bound_of(case, v, axes, then) if len(rests) or again else np.inf
    near = axes[max(0, then - 3) :]

    def most(order, limit):
        moved = np.abs(np.diff(near, order, axis=0)).max(initial=0) - 2**order * grain / 2
        return float(moved / case.period_s**order / limit)

    outside, share = (_outside(near, box), 0.0) if box else (0.0, share)
    peaks = most(1, V_MAX), most(2, case.a), most(3, case.j)
    return Told(case, float(v[then - 1]), rest_s, share, outside, *peaks)


def try_seed(seed):
    """Return how the case of a seed goes; None where nothing moves."""
    return try_case(draw(seed))


def tell(told):
    """Print how a case went."""
    case = told.case
    outside = f", {told.outside_mm} mm outside" if told.outside_mm else ""
    verdict = f"{' LATE' if told.is_late() else ''}{' BEYOND' if told.is_beyond() else ''}"
    print(
        f"{case.seed:6} {case.where and case.where + ' '}{case.family:8}"
        f"{'G61' if case.exact else 'G64'} {case.slope:6} "
        f"T {case.period_s * 1e3:<5g} a {case.a:<6g} j {case.j:<7g} prep {case.prep_steps:<5}"
        f"{'dead ' if case.dead else ''}{case.first} {case.value:.3f}, {case.last}: "
        f"{told.share:.2f} of the bound, {told.rest_s:.3f} s from {told.v:.2f} mm/s; "
        f"v {told.fast:.3f}, a {told.a:.3f}, j {told.j:.3f}"
        f"{outside}{verdict}", flush=True,
    )  # fmt: skip


def hold(try_seed, seeds):
    """Assert that no rest of these seeds is late, and that few are beyond a limit."""
    told = [each for each in map(try_seed, seeds) if each]
    assert [each.case.seed for each in told if each.is_late()] == []
    beyond = [each.case.seed for each in told if each.is_beyond()]
    assert len(beyond) <= SAMPLE_SOME * max(12, len(seeds)), beyond


def search(try_seed, count):
    """Try the seeds of the command line, `count` by default; tell what is late or beyond a limit.

    Returns 1 if a rest is late, or more than a few are beyond a limit or wait for bends.
    """
    numbers = [int(word) for word in sys.argv[1:] if word.isdigit()]
    count, begin = [*numbers, *(count, 0)[len(numbers) :]]
    every = []
    for seed in range(begin, begin + count):
        told = try_seed(seed)
        if told is None:
            continue
        every.append(told)
        if told.is_late() or told.is_beyond() or "-v" in sys.argv:
            tell(told)
    late, beyond = sum(told.is_late() for told in every), sum(told.is_beyond() for told in every)
    shares = [told.share for told in every] or [0]
    shares = np.percentile(shares, [50, 90, 99, 100], method="higher")
    print(f"{len(every)} rests of {count} seeds from {begin} on: {late} late, "
          f"{beyond} beyond a limit")  # fmt: skip
    print(f"of the bound, half of them, 90 %, 99 %, all: {shares.round(2).tolist()}; the latest:")
    if every:
        tell(max(every, key=lambda told: told.share))
    bent = sum(told.share > MOST for told in every)
    print(f"{bent} take more than {MOST} times the bound, where bends leave a brake little")
    return int(late > 0 or beyond > len(every) * SOME or bent > len(every) * SOME_BENT)


if __name__ == "__main__":
    sys.exit(search(try_seed, 20000))
