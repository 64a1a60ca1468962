# SPDX-License-Identifier: MIT
"""Draws nasty cases: a machine, a program that takes a few thousand periods on it, an operator."""

import math

import numpy as np
from nasty_programs import (
    CONTINUOUS, EXACT, NM, PLANES, STOP, Case, Coolant, Feed, Mode, Move, Pause, Turn,
)  # fmt: skip

PERIODS_MS = (0.25, 0.5, 1, 2, 4, 10)
PERIODS = 4000  # of a program, about
TINY = 1e-6  # the shortest move [mm]
LONGEST = 1000.0  # [mm]
SLOPES = ("jerk", "linear")
COMMANDS = ("hold", "resume", "resume", "override", "override", "single_block", "abort")


def case(slope, seed, number, family="all"):
    """Return case `number` of a seed for a slope."""
    return FAMILIES[family](slope, np.random.default_rng([seed, number])).case()


class Author:
    """Draws one case."""

    _periods_ms = PERIODS_MS

    def __init__(self, slope, rng):
        self._slope, self._rng = slope, rng
        self._items, self._at, self._way = [], np.zeros(9, np.int64), np.array([1.0, 0, 0])

    def case(self):
        machine = self._machine()
        count = int(self._rng.integers(5, 41))
        self._budget = PERIODS * self._period / count  # of a move [s]
        v, a, j = (self._least[k] for k in range(3))
        t = self._budget
        self._longest = min(v * t, a * t * t / 4, j * t**3 / 32 if j else math.inf, LONGEST)
        self._longest = max(self._longest, 10 * TINY)
        small = TINY if self._rng.random() < 0.4 else self._longest / 30
        self._size = self._log(small, self._longest)
        style = self._rng.random()
        self._is_smooth = style < 0.5  # G64 all along, and no pause
        self._is_exact = style > 0.85  # no G64 at all
        self._items += [self._mode(), self._feed()]
        while len(self._items) < count:
            self._figure()
        commands = self._operator()
        steps = self._prep_steps()
        relative = bool(self._rng.random() < 0.2)
        return Case(machine, tuple(self._items), relative, commands, steps)

    # Numbers

    def _log(self, low, high):
        return float(np.exp(self._rng.uniform(math.log(low), math.log(max(high, low)))))

    def _one_of(self, *choices):
        return choices[int(self._rng.integers(len(choices)))]

    def _length(self):
        """Return a length [mm]: about the program's usual one, or any."""
        usual = min(self._size * self._log(0.3, 3), self._longest)
        return usual if self._rng.random() < 0.6 else self._log(TINY, self._longest)

    def _direction(self):
        way = self._rng.normal(size=3)
        way[int(self._rng.integers(0, 4)) :] = 0  # in the first axes alone, now and then
        if not way.any() or self._rng.random() < 0.2:
            way = np.eye(3)[int(self._rng.integers(3))] * self._one_of(-1, 1)
        return way / np.linalg.norm(way)

    def _turned(self, angle):
        """Return the last direction, turned by an angle."""
        aside = np.cross(self._way, self._rng.normal(size=3))
        size = np.linalg.norm(aside)
        aside = aside / size if size > 0 else np.roll(self._way, 1)
        return self._way * math.cos(angle) + aside * math.sin(angle)

    # The machine

    def _machine(self):
        rng = self._rng
        self._period = self._one_of(*self._periods_ms) * 1e-3
        base = [self._log(5, 5000), self._log(20, 20000), 0]
        base[2] = base[1] * self._log(5, 500)
        if rng.random() < 0.3:  # a milling machine
            self._period, base = 1e-3, [250, 2500, 50000]
        lines = [f"[kernel]\nperiod_ms = {self._period * 1e3:g}"]
        lines.append(f'[path]\nslope = "{self._slope}"')
        if rng.random() < 0.2:
            lines.append(f"a_max_mm_s2 = {base[1] * self._log(0.2, 2):.5g}")
        if rng.random() < 0.2:
            lines.append(f"j_max_mm_s3 = {base[2] * self._log(0.2, 2):.5g}")
        if rng.random() < 0.2:
            lines.append(f"feed_max_mm_min = {60 * base[0] * self._log(0.2, 2):.5g}")
        if rng.random() < 0.2:
            lines.append(f"lookahead_blocks = {self._one_of(2, 3, 5, 20)}")
        spread = self._one_of(1, 1, 3, 30)
        limits = []
        self._letters = "xyzac" if rng.random() < 0.25 else "xyz"
        for letter in self._letters:
            limits.append([one * self._log(1 / spread, 1) for one in base])
            unit = "deg" if letter in "ac" else "mm"
            values = zip(("v", "a", "j"), limits[-1], strict=True)
            keys = (f"{k}_max_{unit}_s{'' if k == 'v' else '23'[k == 'j']} = {n:.5g}"
                    for k, n in values)  # fmt: skip
            lines.append("\n".join([f"[axis.{letter}]", *keys]))
        self._least = np.array(limits).min(axis=0)
        if self._slope == "linear":
            self._least[2] = 0
        return "\n".join([*lines, ""])

    # Words

    def _mode(self):
        kind = 1.0 if self._is_smooth else self._rng.random() * (0.25 if self._is_exact else 1)
        if kind < 0.15:
            return Mode(EXACT)
        if kind < 0.25:
            return Mode(STOP)
        p = round(NM * self._one_of(self._log(1e-4, 1.0), self._log(1e-4, 1e-3), self._log(0.1, 1)))
        if self._rng.random() < 0.3:  # about what fits the lengths
            p = max(round(NM * min(self._size * self._log(1e-3, 1), 1)), 100)
        q = self._one_of(None, None, 0, round(p * self._log(0.01, 3)))
        return Mode(CONTINUOUS, p, q)

    def _feed(self):
        speed = self._longest / self._budget * self._log(0.3, 50)
        return Feed(round(60 * max(speed, TINY), 3) + 0.001, self._one_of(94, 94, 94, 94, 93, 95))

    def _word(self):
        kind = self._rng.random()
        if kind < 0.7:
            return self._feed()
        if kind < 0.85 and not self._is_smooth:
            return Pause(self._one_of(None, self._log(1e-4, 20 * self._period)))
        return Coolant(self._one_of(7, 8, 9))

    # Figures

    def _figure(self):
        figures = (
            (self._line, 4), (self._reversal, 3), (self._near, 3), (self._arc, 4), (self._steps, 1),
            (self._bend, 1), (self._split, 1), (self._loosen, 1), (self._spike, 1), (self._home, 1),
            (self._still, 0.5),
            (lambda: self._items.append(self._word()), 2),
        )  # fmt: skip
        weights = np.array([weight for _, weight in figures])
        figures[int(self._rng.choice(len(figures), p=weights / weights.sum()))][0]()

    def _go(self, way, length):
        """Add a straight move; now and then a rapid, or one with rotary axes."""
        self._way = way
        target = self._at.copy()
        target[:3] += np.round(way * length * NM).astype(np.int64)
        if "a" in self._letters and self._rng.random() < 0.3:
            for axis in (3, 5):
                turned = self._one_of(0, 1, 1) * length * self._rng.normal()
                target[axis] += round(turned * NM) * 1000
        self._to(target, rapid=self._rng.random() < 0.08)

    def _to(self, target, rapid=False):
        if self._rng.random() < 0.2:  # in the middle of a figure too
            self._items.append(self._one_of(self._mode, self._feed)())
        self._at = target
        self._items.append(Move(tuple(int(n) for n in target), rapid))

    def _line(self):
        self._go(self._direction(), self._length())

    def _reversal(self):
        """To and fro on one line, to the nanometre or not quite as far."""
        way, length = self._direction(), self._length()
        start = self._at.copy()
        self._go(way, length)
        if self._rng.random() < 0.5:
            self._way = -way
            self._to(start)
        else:
            self._go(-way, length * self._one_of(1, 1.5, self._rng.random()))

    def _near(self):
        """Nearly straight on, or nearly back."""
        angle = self._log(1e-8, 0.3)
        self._go(self._turned(angle if self._rng.random() < 0.5 else math.pi - angle),
                 self._length())  # fmt: skip

    def _steps(self):
        """Teeth or stairs of one size."""
        ways, length = (self._direction(), self._direction()), self._length()
        for k in range(int(self._rng.integers(3, 9))):
            self._go(ways[k % 2], length)

    def _bend(self):
        """Chords of a bend."""
        length, angle = self._length(), self._log(1e-3, 1.0)
        for _ in range(int(self._rng.integers(3, 9))):
            self._go(self._turned(angle), length)

    def _split(self):
        """One straight line in unequal pieces."""
        way, length = self._direction(), self._length()
        start, count = self._at.copy(), int(self._rng.integers(1, 5))
        shares = np.sort(self._rng.random(count) ** 2)
        for share in (*shares, 1.0):
            target = start.copy()
            target[:3] += np.round(way * length * share * NM).astype(np.int64)
            self._way = way
            self._to(target)

    def _loosen(self):
        """Another tolerance in the middle of a line that ends in a corner."""
        way, length = self._direction(), self._length()
        self._go(way, length)
        self._items.append(self._mode())
        self._go(way, length * self._log(1e-3, 1))
        self._go(self._direction(), self._length())

    def _spike(self):
        """Out and back beside it."""
        length, angle = self._length(), self._log(1e-3, 0.5)
        self._go(self._direction(), length)
        self._go(self._turned(math.pi - angle), length)

    def _home(self):
        """Back to where the program has been."""
        been = [item for item in self._items if isinstance(item, Move | Turn)]
        if not been:
            return
        target = np.array(self._one_of(*been).target, np.int64)
        way = (target - self._at)[:3] / NM
        if 0 < np.linalg.norm(way) <= 3 * self._longest:
            self._way = way / np.linalg.norm(way)
            self._to(target)

    def _still(self):
        self._to(self._at.copy())

    def _arc(self):
        plane = int(self._rng.integers(17, 20))
        u, v, _, _ = PLANES[plane]
        sweep = self._one_of(2 * math.pi, math.pi, math.pi / 2, self._log(1e-3, 5.8))
        radius = self._length() / max(sweep, 1)
        if self._rng.random() < 0.3:  # flat and wide
            radius = self._length() / sweep
        if radius < 1e-4 or radius > 1e5:
            return
        clockwise = bool(self._rng.random() < 0.5)
        first = self._rng.uniform(0, 2 * math.pi)
        tangent = self._way[u], self._way[v]
        if self._rng.random() < 0.5 and math.hypot(*tangent) > 0.1:
            first = math.atan2(tangent[1], tangent[0]) + math.pi / 2 * (1 if clockwise else -1)
        self._add_arc(plane, radius, first, -sweep if clockwise else sweep)

    def _add_arc(self, plane, radius, first, sweep):
        u, v, _, _ = PLANES[plane]
        centre = (
            round(self._at[u] - NM * radius * math.cos(first)),
            round(self._at[v] - NM * radius * math.sin(first)),
        )
        target, last = self._at.copy(), first + sweep
        if abs(sweep) < 2 * math.pi:
            real = math.dist(centre, (self._at[u], self._at[v]))
            first = math.atan2(self._at[v] - centre[1], self._at[u] - centre[0])
            target[u] = round(centre[0] + real * math.cos(first + sweep))
            target[v] = round(centre[1] + real * math.sin(first + sweep))
            if (target == self._at).all():
                return
        if self._rng.random() < 0.25:
            target[3 - u - v] += round(NM * self._length() * self._one_of(-1, 1))
        self._items.append(Turn(tuple(int(n) for n in target), plane, centre, bool(sweep < 0)))
        self._at = target
        turn = 1 if sweep > 0 else -1
        self._way = np.zeros(3)
        self._way[u], self._way[v] = -turn * math.sin(last), turn * math.cos(last)

    # The operator

    def _prep_steps(self):
        return 256 if self._rng.random() < 0.6 else int(self._rng.choice((1, 2, 3, 7, 20)))

    def _operator(self):
        if self._rng.random() < 0.6:
            return ()
        commands = []
        last = self._log(10, PERIODS)
        for _ in range(int(self._rng.integers(1, 6))):
            name = self._one_of(*COMMANDS)
            numbers = ()
            if name == "override":
                numbers = (int(self._rng.integers(10, 201)), int(self._rng.integers(10, 101)))
            if name == "single_block":
                numbers = (int(self._rng.random() < 0.7),)
            commands.append((int(self._rng.uniform(0, last)), name, *numbers))
        return tuple(sorted(commands))


class HeldArcs(Author):
    """Arcs on the exact path with long periods, where prep is late and the tick has to brake."""

    _periods_ms = (2, 4, 4, 10)

    def _mode(self):
        return Mode(EXACT)

    def _figure(self):
        self._one_of(self._arc, self._arc, self._arc, self._line, self._bend)()

    def _prep_steps(self):
        return int(self._rng.choice((1, 1, 2, 3)))

    def _operator(self):
        """Rests at random moments, each given up behind a while but the last one."""
        commands, at = [], 0.0
        for _ in range(int(self._rng.integers(1, 6))):
            at += self._log(5, 400)
            commands.append((int(at), "hold"))
            at += self._log(5, 400)
            commands.append((int(at), "resume"))
        if self._rng.random() < 0.5:
            commands[-1] = (commands[-1][0], "abort")
        return tuple(commands)


FAMILIES = {"all": Author, "held_arcs": HeldArcs}
