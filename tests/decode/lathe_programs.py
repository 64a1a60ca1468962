# SPDX-License-Identifier: MIT
"""Random programs of lathes and of taps, as RS274NGC has them."""

import math
import random
from dataclasses import replace


class Lathe:
    """Writes one program: diameters, arcs in G18, G95, G96, threads alone and in cycles."""

    def __init__(self, seed):
        self.source = random.Random(seed)
        self.inch, self.diameter = False, False
        self.lines = ["G21 G18 G90 G94 G8 F200", "M3 S600", "G0 X40 Z10"]

    def number(self, low, high):
        """Return a number in the units in force; low and high are in mm."""
        scale = 25.4 if self.inch else 1.0
        return f"{self.source.uniform(low / scale, high / scale):.{self.source.randint(3, 5)}f}"

    def place(self):
        letters = self.source.sample("XZ", self.source.randint(1, 2))
        return " ".join(letter + self.number(-60, 60) for letter in letters)

    def arc(self):
        a, b = self.source.uniform(0.5, 15), self.source.uniform(0.5, 15)
        radius = math.hypot(a, b) * self.source.uniform(0.55, 2)
        if self.source.random() < 0.5:
            return f"G{self.source.choice('23')} Z{a:.4f} X{b:.4f} R{radius:.4f}"
        k, turn = radius / 25, self.source.uniform(0.3, 5)
        z, x = 20 * k * (math.cos(turn) - 1), 20 * k * math.sin(turn)
        return f"G3 Z{z:.5f} X{x:.5f} K{-20 * k:.5f} I0"

    def mode(self):
        kind = self.source.randint(0, 5)
        if kind == 0:
            self.lines.append(self.source.choice(["G90", "G91"]))
        elif kind == 1:
            self.lines.append(self.source.choice(["G7", "G8"]))
        elif kind == 2:
            self.inch = self.source.random() < 0.4
            self.lines += ["G20" if self.inch else "G21", f"F{self.source.randint(5, 300)}"]
        elif kind == 3:
            speed = self.source.choice(["G96 D1500 S120", "G97 S600", "S400", "G96 D900 S90"])
            self.lines.append(speed)
        elif kind == 4:
            self.lines.append(self.source.choice(["G95 F.2", "G94 F150", "G54", "G55", "G92.1"]))
        else:
            code = self.source.choice(["G92", f"G10 L2 P{self.source.randint(1, 3)}"])
            self.lines.append(f"{code} {self.place()}")

    def thread(self):
        """A pass, or a tap, long enough to get up to speed."""
        lead = self.number(0.5, 1.5)
        z, x = self.number(-60, -30), self.number(-3, 3)
        code = self.source.choice(["G33", "G33", "G33.1"])
        taper = f" X{x}" if self.source.random() < 0.4 else ""
        self.lines += ["G97 S500 M3", f"G91 {code} Z{z}{taper} K{lead}", "G90"]

    def cuts(self):
        """Return R, J and K; a whole number of cuts but for rounding is not written."""
        power, cuts = self.source.choice(["1", "1.5", "2"]), 0.0
        while abs(cuts - round(cuts)) < 0.01:
            first, full = self.number(0.1, 0.3), self.number(0.6, 1.2)
            cuts = (float(full) / float(first)) ** float(power)
        return power, first, full

    def cycle(self):
        """G76, outside or inside; the drive line is where the tool stands."""
        inside = self.source.random() < 0.4
        crest, end = self.number(1, 4), self.number(-60, -30)
        power, first, full = self.cuts()
        words = [
            "P" + self.number(0.8, 2), "Z" + end, f"I{'' if inside else '-'}{crest}",
            "J" + first, "K" + full, f"H{self.source.randint(0, 3)}",
        ]  # fmt: skip
        if power != "1" or self.source.random() < 0.6:
            words.append(f"R{power}")
        if self.source.random() < 0.6:
            words.append(f"Q{self.source.choice(['0', '29.5', '30'])}")
        self.source.shuffle(words)
        self.lines += ["G97 S400 M3", f"G90 G0 X{self.number(20, 40)} Z{self.number(3, 9)}"]
        self.lines += [f"(screw {1 if inside else -1})", "G76 " + " ".join(words), "(plain)"]

    def program(self):
        for _ in range(40):
            kind = self.source.randint(0, 9)
            if kind <= 3:
                self.lines.append(f"G{self.source.randint(0, 1)} {self.place()}")
            elif kind == 4:
                self.lines += ["G8", f"G91 {self.arc()}", "G90"]
            elif kind <= 7:
                self.mode()
            else:
                self.source.choice([self.thread, self.cycle])()
        return "\n".join([*self.lines, "M2", ""]).encode()


def lathe(seed):
    """Return a random program of a lathe."""
    return Lathe(seed).program()


def taps(seed):
    """Return a random program with taps of all kinds in G17, where rs274 taps along Z."""
    source = random.Random(seed)
    lines, steps = ["G21 G17 G90 G94 G98", "G0 X0 Y0 Z30"], False
    place = lambda: f"X{source.uniform(-50, 50):.3f} Y{source.uniform(-50, 50):.3f}"  # noqa: E731
    for _ in range(12):
        speed, lead = source.randint(200, 600), source.uniform(0.4, 1.6)
        code, turn = source.choice([("G84", "M3"), ("G74", "M4"), ("G33.1", "M3")])
        steps = source.random() < 0.4
        lines += ["G80", "G90", f"G0 {place()} Z{source.uniform(20, 40):.3f}"]
        lines += [f"S{speed} {turn} F{speed * lead:.2f}", "(tap)", "G91" if steps else "G90"]
        if code == "G33.1":
            lines += [f"G91 G33.1 {aside(source)}Z-{source.uniform(15, 40):.3f} K{lead:.3f}"]
            continue
        r, depth = source.uniform(2, 9), source.uniform(-30, -15)
        words = [f"R{r - 19 if steps else r:.3f}", f"Z{depth:.3f}", place()]
        count = [[f"L{source.randint(1, 3)}"]] if code == "G84" else []  # rs274: none of G74
        words += source.choice([[], ["P0.2"], *count])
        source.shuffle(words)
        lines += [source.choice(["G98", "G99"]), f"{code} {' '.join(words)}"]
        lines += ["G99", *[place() for _ in range(source.randint(0, 3))]]
    return "\n".join([*lines, "G80", "(plain)", "G90 G0 X1 Y2", "M2", ""]).encode()


def aside(source):
    return f"X{source.uniform(-5, 5):.3f} " if source.random() < 0.4 else ""


def told_taps(moves):
    """Return moves of rs274 where G84 and G74 have their lead, and leave the thread at R.

    rs274 cuts them at feed, with G98 up to its level.
    """
    told, r = [], 0.0
    for move in moves:
        cuts = move.remark == "tap" and move.kind == "line" and not move.lead
        at = told[-1].end if told else move.end
        if cuts:
            move.lead = move.feed * move.unit / move.rpm
        if cuts and move.end[2] < at[2]:
            r = at[2]
        elif cuts and move.end[2] > r:
            told.append(replace(move, end=[*move.end[:2], r, *move.end[3:]]))
            move.kind, move.lead = "rapid", 0.0
        told.append(move)
    return told


def told_lathe(moves):
    """Return moves of rs274 where G76 goes back to the drive line, as LinuxCNC's manual draws it.

    rs274 rises over it by what a pass is less deep than the thread.
    """
    for k, move in enumerate(moves):
        words = move.remark.split()
        if words[0:1] == ["screw"] and moves[k - 1].remark != move.remark:
            line = moves[k - 1].end[0]
        if words[0:1] == ["screw"] and (move.end[0] - line) * int(words[1]) < 0:
            move.end[0] = line
    return moves
