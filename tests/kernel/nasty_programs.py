# SPDX-License-Identifier: MIT
"""Nasty programs, machines and operators from a seed; each knows what it means.

A program is a list of moves in nanometres and of words between. Its text is printed from that list,
and so are the blocks that it is judged by: nobody reads the text again. An item that is left out
leaves a program that is still one, which is what makes a finding small.
"""

import math
from dataclasses import dataclass, field, replace

import numpy as np

from pycnc.kernel.records import dtype

NM = 1_000_000  # in a mm; thousandths of a microdegree in a degree are a thousand times more
LETTERS = "XYZABCUVW"
PLANES = {17: (0, 1, "I", "J"), 18: (2, 0, "K", "I"), 19: (1, 2, "J", "K")}
EXACT, STOP, CONTINUOUS = 0, 1, 2
RAPID, LINE, ARC, DWELL, WAIT, OUTPUT, END = range(7)
OUTPUT_SPEED, OUTPUT_M = 0, 1
FEED_MODES = {94: 0, 93: 1, 95: 2}
MOST_FEED = 1e8  # of any unit
ROUND_NM = 3  # the two radii of an arc differ by so much at most, or it becomes a line


@dataclass(frozen=True)
class Move:
    """Straight to a point; rapid: G0. target: (9,) of nm, ndeg."""

    target: tuple
    rapid: bool = False


@dataclass(frozen=True)
class Turn:
    """An arc or a helix to a point about a centre (nm, in the plane's axes)."""

    target: tuple
    plane: int
    centre: tuple
    clockwise: bool


@dataclass(frozen=True)
class Mode:
    """G61, G61.1, or G64 with P and Q in nm; a Q that is not told is P."""

    mode: int
    p: int = 0
    q: int | None = None


@dataclass(frozen=True)
class Feed:
    """A feed in mm/min, and the mode that it is told in: 93, 94, 95."""

    value: float
    mode: int = 94


@dataclass(frozen=True)
class Pause:
    """G4, or M0 where seconds is None."""

    seconds: float | None


@dataclass(frozen=True)
class Coolant:
    """M7, M8 or M9."""

    code: int


@dataclass(frozen=True)
class Case:
    """A machine file, a program for it, what the operator does, and how fast preparation is."""

    machine: str
    items: tuple
    relative: bool = False
    commands: tuple = ()
    prep_steps: int = 256

    def written(self):
        """Return the program's text, and its blocks."""
        return Writer(self.relative).write(self.items)

    def exact_stops(self):
        """Return the same program with a stop at the end of every move."""
        kept = [item for item in self.items if not isinstance(item, Mode)]
        return replace(self, items=(Mode(STOP), *kept))


@dataclass
class Writer:
    """Prints items and keeps what they mean."""

    relative: bool
    lines: list = field(default_factory=list)
    blocks: list = field(default_factory=list)
    at: tuple = (0,) * 9
    mode: Mode = Mode(EXACT)
    wanted: Feed = Feed(1000.0)
    told: tuple = (94, None)  # feed mode and F in force
    rpm: float = 0.0

    def write(self, items):
        """Return (text, blocks of dtype ``nck_block_t``)."""
        self.lines.append(f"G17 G21 G91.1 G94 G61 {'G91' if self.relative else 'G90'}")
        for item in items:
            getattr(self, f"_{type(item).__name__.lower()}")(item)
        self.lines.append("M2")
        self._block(END, output=(0, 0, OUTPUT_M, 0, 2.0))
        return "\n".join([*self.lines, ""]), np.array(self.blocks, dtype("nck_block_t"))

    def _block(self, kind, **more):
        row = np.zeros(1, dtype("nck_block_t"))[0]
        row["line"], row["kind"], row["path_mode"] = len(self.lines), kind, self.mode.mode
        row["plane"], row["feed_mode"] = 17, FEED_MODES[self.told[0]]
        row["target_nm"], row["spindle_rpm"] = self.at, self.rpm
        p, q = self.mode.p, self.mode.q
        row["tolerance_mm"], row["merge_mm"] = p / NM, (p if q is None else q) / NM
        for name, value in more.items():
            row[name] = value
        self.blocks.append(row)

    def _feed(self, item):
        self.wanted = item

    def _mode(self, item):
        self.mode = item
        q = "" if item.q is None else f" Q{decimals(item.q)}"
        words = {EXACT: "G61", STOP: "G61.1", CONTINUOUS: f"G64 P{decimals(item.p)}{q}"}
        self.lines.append(words[item.mode])

    def _pause(self, item):
        if item.seconds is None:
            self.lines.append("M0")
            self._block(WAIT, output=(0, len(self.lines), OUTPUT_M, 0, 0.0))
            return
        self.lines.append(f"G4 P{item.seconds:.6f}")
        self._block(DWELL, dwell_s=float(f"{item.seconds:.6f}"))

    def _coolant(self, item):
        self.lines.append(f"M{item.code}")
        self._block(OUTPUT, output=(0, len(self.lines), OUTPUT_M, 0, float(item.code)))

    def _move(self, item):
        words = self._words(item.target, LETTERS)
        if item.rapid:
            self.lines.append(f"G0{words}")
            self.at = item.target
            self._block(RAPID, feed=0.0)
            return
        length = self._length(item.target, None)
        self._cut(f"G1{words}", length)
        self.at = item.target
        self._block(LINE, feed=self.told[1])

    def _turn(self, item):
        u, v, i, j = PLANES[item.plane]
        start, end = (self.at[u], self.at[v]), (item.target[u], item.target[v])
        radii = [math.dist(point, item.centre) for point in (start, end)]
        if abs(radii[0] - radii[1]) > ROUND_NM or min(radii) < 10 * ROUND_NM:
            self._move(Move(item.target))
            return
        centre, sweep = circle(start, end, item.centre, item.clockwise)
        turned = abs(sweep) * math.dist(start, centre) / NM
        away = f" {i}{decimals(item.centre[0] - start[0])} {j}{decimals(item.centre[1] - start[1])}"
        words = self._words(item.target, LETTERS, always=(u, v))
        head = f"G{item.plane} G{2 if item.clockwise else 3}"
        self._cut(f"{head}{words}{away}", self._length(item.target, (u, v), turned))
        self.at = item.target
        self._block(
            ARC, feed=self.told[1], plane=item.plane, sweep_rad=sweep,
            centre_mm=(centre[0] / NM, centre[1] / NM),
        )  # fmt: skip

    def _words(self, target, letters, always=()):
        words = ""
        for axis, letter in enumerate(letters):
            if target[axis] != self.at[axis] or axis in always:
                value = target[axis] - self.at[axis] * self.relative
                words += f" {letter}{decimals(value, 9 if letter in 'ABC' else 6)}"
        return words or f" X{decimals(target[0] - self.at[0] * self.relative)}"

    def _length(self, target, plane, turned=0.0):
        """Return the length that a feed is meant for [mm, deg]."""
        away = [(b - a) / NM for a, b in zip(self.at, target, strict=True)]
        if plane is not None:
            away[plane[0]], away[plane[1]] = turned, 0.0
        return math.hypot(*away[:3]) or math.hypot(*away[6:]) or math.hypot(*away[3:6]) / 1000

    def _cut(self, words, length):
        """Print a cut, with the words that make its feed the wanted one."""
        mode = self.wanted.mode
        if mode != self.told[0]:
            self._change(mode)
        value = {93: self.wanted.value / max(length, 1e-6), 94: self.wanted.value,
                 95: self.wanted.value / max(self.rpm, 1)}[mode]  # fmt: skip
        value = min(max(float(f"{value:.6f}"), 1e-6), MOST_FEED)
        if mode == 93 or self.told[1] != value:
            words += f" F{value:.6f}"
        self.told = (mode, value)
        self.lines.append(words)

    def _change(self, mode):
        self.told = (mode, None)
        if mode != 95 or self.rpm > 0:
            self.lines.append(f"G{mode}")
            return
        self.rpm = 600.0
        self.lines.append("G95 S600 M3")
        number = len(self.lines)
        speed, on = (0, number, OUTPUT_SPEED, 0, 600.0), (0, number, OUTPUT_M, 0, 3.0)
        self._block(OUTPUT, output=speed, spindle_rpm=0.0)
        self._block(OUTPUT, output=on)


def decimals(count, digits=6):
    """Return nm (or ndeg, with 9 digits) as a decimal number of mm (deg)."""
    sign, size = "-" if count < 0 else "", abs(count)
    return f"{sign}{size // 10**digits}.{size % 10**digits:0{digits}d}"


def circle(start, end, centre, clockwise):
    """Return centre [nm] and sweep of the arc through both ends whose centre is nearest."""
    du, dv = end[0] - start[0], end[1] - start[1]
    sign = -1 if clockwise else 1
    square = du * du + dv * dv
    if square == 0:
        return centre, sign * 2 * math.pi
    middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    off = ((centre[0] - middle[0]) * -dv + (centre[1] - middle[1]) * du) / square
    found = (middle[0] - off * dv, middle[1] + off * du)
    first = math.atan2(start[1] - found[1], start[0] - found[0])
    last = math.atan2(end[1] - found[1], end[0] - found[0])
    return found, sign * (sign * (last - first) % (2 * math.pi))
