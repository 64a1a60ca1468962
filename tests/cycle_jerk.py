# SPDX-License-Identifier: MIT
"""Runs programs with canned cycles, threads and contours within a tolerance, from a seed, and tells
where an axis passes its speed, its acceleration or its jerk anywhere; exit 1 if one does.

    python tests/cycle_jerk.py --count 2000 --seed 1
"""

import argparse
import math
import random
import sys
from dataclasses import dataclass

import contour_programs
import numpy as np
from checker import ROUNDING, SHARE, SUMS
from programmed_path import COUNTS

from pycnc import kernel
from pycnc.errors import NckError
from pycnc.machine import Machine
from pycnc.program import Program

PLANES = {17: "XYZ", 18: "ZXY", 19: "YZX"}  # of the plane, and of the drill
MILL_BASES = ("linuxcnc", "fanuc")  # the languages that have cycles
STILL = 4  # ticks at rest before the first one, and behind the last


@dataclass(frozen=True)
class Case:
    """A program, and the machine that it is for."""

    text: str
    machine: str
    set: tuple


class Writer:
    """Draws numbers and writes lines."""

    def __init__(self, seed, base="fanuc"):
        self.source, self.base = random.Random(seed), base
        self.lines = []
        self.p = 10 ** self.source.uniform(-3.5, -0.5)

    def number(self, low, high, digits=3):
        return f"{self.source.uniform(low, high):.{digits}f}"

    def one_of(self, *items):
        return self.source.choice(items)

    def mode(self):
        """Return the words of a tolerance: P is LinuxCNC's, Fanuc's is the machine's."""
        if self.base == "fanuc":
            return "G64"
        return f"G64 P{10 ** self.source.uniform(-3.5, -0.5):.5f}" + self.one_of("", "", " Q0")

    def settings(self, *more):
        """Return a machine's settings: tolerance and period."""
        settings = ["path.slope=optimal", f"path.tolerance_mm={self.p:.5f}"]
        if self.source.random() < 0.3:
            settings.append(f"kernel.period_ms={self.one_of('0.5', '2', '4')}")
        return (*settings, *more)

    def jerks(self, axes):
        """Return limits of jerk for axes, at times other than the machine's."""
        if self.source.random() < 0.5:
            return ()
        return tuple(
            f"axis.{axis}.j_max_mm_s3={10 ** self.source.uniform(3.3, 5.3):.0f}" for axis in axes
        )

    def feed(self):
        return f"F{10 ** self.source.uniform(1.5, 3.8):.0f}"


class Drill(Writer):
    """Holes of every cycle, with lines and arcs between."""

    def hole(self, fanuc, plane):
        u, v, drill = PLANES[plane]
        code = self.one_of("G73", "G81", "G82", "G83", "G85", "G86", "G89", "G84", "G74")
        words = [code, f"{u}{self.number(-30, 30)}", f"{v}{self.number(-30, 30)}"]
        depth = self.source.uniform(2, 12)
        words += [f"R{self.number(0.5, 4)}", f"{drill}{-depth:.3f}"]
        if code in ("G82", "G86", "G89"):
            words.append(f"P{self.one_of(0, 20) if fanuc else self.one_of(0, 0.02)}")
        if code in ("G73", "G83"):
            words.append(f"Q{self.number(depth / 5, depth)}")
        if code in ("G84", "G74"):
            self.lines += [f"S{self.one_of(200, 500)} {'M3' if code == 'G84' else 'M4'}"]
            words += [f"F{self.one_of(150, 300)}"]
        else:
            words.append(self.feed())
        return words

    def program(self):
        plane = self.one_of(17, 17, 17, 18, 19)
        base = self.base = self.one_of(*MILL_BASES)
        u, v, drill = PLANES[plane]
        self.lines = [f"G21 G{plane} G90 G94 {self.mode()} F900", "M3 S500",
                      f"G0 {drill}{self.number(5, 20)}"]  # fmt: skip
        for _ in range(self.source.randint(1, 4)):
            if self.source.random() < 0.2:
                self.lines.append(self.mode())
            words = self.hole(base == "fanuc", plane)
            self.lines.append(f"{self.one_of('G98', 'G99')} {' '.join(words)}")
            for _ in range(self.source.randint(0, 2)):
                self.lines.append(f"{u}{self.number(-30, 30)}" + self.one_of("", f" {v}5.5"))
            if self.source.random() < 0.3:
                self.lines.append(f"G91 {u}{self.number(1, 8)} L{self.source.randint(1, 3)}")
                self.lines.append("G90")
            self.between(u, v, drill)
        self.lines += ["G80", f"G0 {drill}20", "M30", ""]
        sets = self.settings(f"dialect.base={base}", *self.jerks("xyz"))
        return Case("\n".join(self.lines), "mill3", sets)

    def between(self, u, v, drill):
        """Lines and arcs of the program's own, which the next cycle follows."""
        for _ in range(self.source.randint(0, 3)):
            kind = self.source.randint(0, 3)
            if kind == 0:
                self.lines.append(f"G0 {drill}{self.number(3, 20)}")
            elif kind == 1:
                self.lines.append(f"G1 {u}{self.number(-30, 30)} {v}{self.number(-30, 30)} F2000")
            elif kind == 2:
                letter = {"X": "I", "Y": "J", "Z": "K"}[u]
                self.lines.append(f"G{self.one_of(2, 3)} {letter}{self.number(0.3, 9)} F1500")
            else:
                self.lines += ["G61", f"G1 {u}{self.number(-30, 30)} F900", self.mode(),
                               f"G1 {v}{self.number(-30, 30)}"]  # fmt: skip


class Lathe(Writer):
    """Turning, pecking and threads of Fanuc's lathes, and LinuxCNC's threads."""

    def turning(self, system):
        along, across = {"A": ("G90", "G94"), "B": ("G77", "G79"), "C": ("G20", "G24")}[system]
        code, taper = self.one_of(along, across), ""
        if self.source.random() < 0.4:
            taper = f" R{self.number(-2, -0.2)}"
        self.lines += [f"G0 X{self.number(50, 60)} Z{self.number(2, 5)}",
                       f"{code} X{self.number(30, 45)} Z{self.number(-30, -5)}{taper} F0.3",
                       f"X{self.number(20, 30)}"]  # fmt: skip

    def pecking(self, system):
        z, x = {"A": ("G74", "G75"), "B": ("G74", "G75"), "C": ("G76", "G77")}[system]
        code = self.one_of(z, x)
        self.lines += [f"G0 X{self.number(40, 50)} Z{self.number(1, 3)}", f"{code} R0.5",
                       f"{code} X{self.number(20, 35)} Z{self.number(-15, -5)} "
                       f"P{self.source.randint(2000, 4000)} Q{self.source.randint(2000, 5000)} "
                       "F0.2"]  # fmt: skip

    def thread(self, system):
        code, single = {"A": ("G76", "G92"), "B": ("G76", "G78"), "C": ("G78", "G21")}[system]
        r = self.number(0, 1.2)
        lead = self.number(0.5, 1.5)
        self.lines += [f"G97 S{self.one_of(200, 400)}", f"G0 X{self.number(28, 32)} Z12"]
        if self.source.random() < 0.5:
            self.lines.append(f"{single} X{self.number(23, 25)} Z-30 F{lead}")
        else:
            pull = self.one_of("00", "05", "12")
            self.lines += [f"{code} P01{pull}60 Q150 R0.1",
                           f"{code} X22 Z-30 R{self.one_of('0', '-' + r)} P900 Q350 "
                           f"F{lead}"]  # fmt: skip

    def fanuc(self):
        system = self.one_of("A", "B", "C")
        metric = "G71" if system == "C" else "G21"
        rev = {"A": "G99", "B": "G95", "C": "G95"}[system]
        self.lines = [f"{metric} {rev} {self.mode()}", "G97 S600 M3"]
        for _ in range(self.source.randint(1, 3)):
            self.one_of(self.turning, self.pecking, self.thread)(system)
            if self.source.random() < 0.4:
                self.lines.append(f"G1 X{self.number(30, 50)} Z{self.number(1, 4)} F0.4")
        self.lines += ["G0 X60 Z20", "M30", ""]
        sets = self.settings("dialect.base=fanuc", f"dialect.system={system}", *self.jerks("xz"))
        return Case("\n".join(self.lines), "cak6150n", sets)

    def linuxcnc(self):
        self.lines = [f"G21 G18 G90 G8 {self.mode()} F300", "S300 M3", "G0 X30 Z12"]
        for _ in range(self.source.randint(1, 2)):
            more = self.one_of("", f" R{self.one_of('1', '2')}", f" E{self.number(1, 3)} L2",
                               f" E{self.number(1, 3)} L{self.one_of(1, 3)}")  # fmt: skip
            self.lines.append(f"G76 P{self.number(0.8, 1.6)} Z-30 I-{self.number(1, 3)} "
                              f"J{self.number(0.2, 0.4)} K0.9 Q{self.one_of(0, 29.5)} "
                              f"H{self.one_of(0, 1)}{more}")  # fmt: skip
            self.lines.append(self.one_of(
                "G0 Z12", "G1 X31 F400\nG0 Z12", "G0 X28\nG33 Z-30 K1\nG0 X30\nZ12",
                "G0 X12\nG33.1 Z-15 K1\nG0 X30\nZ12",
                "G0 Z12\nG3 X36 Z6 R9 F500\nG0 X30 Z12"))  # fmt: skip
        self.lines += ["G0 X60 Z20", "M2", ""]
        return Case("\n".join(self.lines), "cak6150n",
                    self.settings("dialect.base=linuxcnc", *self.jerks("xz")))  # fmt: skip


def rough(seed):
    """Return a roughing cycle of Fanuc's on a random contour of lines and arcs, and G70 behind."""
    writer = Writer(seed)
    drawn = contour_programs.contour(seed, pockets=False)
    x, z = drawn.start
    code, deep, along = ("G72", "W", "U") if drawn.facing else ("G71", "U", "W")
    spare = writer.number(0.1, 0.5) if writer.source.random() < 0.5 else "0"
    away = drawn.signs[1] * float(spare)
    lines = list(drawn.lines)
    lines[0], lines[-1] = f"N1 {lines[0]}", f"N2 {lines[-1]}"
    begin = f"{code} {deep}{writer.number(4, 9)} R0.5"
    text = [f"G21 G18 G98 F{writer.one_of(300, 900, 3000)} {writer.mode()}", "M3 S500",
            f"G0 X{x:.6f} Z{z:.6f}", begin, f"{code} P1 Q2 {deep}{away:.3f} {along}0", *lines,
            "G70 P1 Q2", "M30", ""]  # fmt: skip
    sets = writer.settings("dialect.base=fanuc", "dialect.system=A", "dialect.diameter=false",
                           *writer.jerks("xz"))  # fmt: skip
    return Case("\n".join(text), "cak6150n", sets)


FAMILIES = {
    "holes": lambda seed: Drill(seed).program(),
    "turning": lambda seed: Lathe(seed).fanuc(),
    "threads": lambda seed: Lathe(seed, "linuxcnc").linuxcnc(),
    "contours": rough,
}


def case(name, seed):
    """Return a case of a family."""
    return FAMILIES[name](seed)


def shares(program):
    """Return the largest v, a and j of any axis anywhere, over its limits, as (share, axis)."""
    limits = program.machine.record["axis"]
    period = float(program.machine.record["period_s"])
    rows = [rows["pose"]["axis"].copy() for rows, _ in
            kernel.Simulation(program.text, program.machine).pieces()]  # fmt: skip
    track = np.concatenate(rows)
    start = program.machine.record["start_nm"][None] / COUNTS
    track = np.concatenate([start] * STILL + [track] + [track[-1:]] * STILL)
    noise = ROUNDING * np.abs(track).max(axis=0)
    found = []
    for order, name in enumerate(("v_max", "a_max", "j_max"), 1):
        values = np.abs(np.diff(track, n=order, axis=0)) - SUMS[order - 1] * noise
        most = np.where(limits["present"], limits[name], math.inf)
        if name == "v_max":
            most = np.maximum(most, np.where(limits["present"], limits["rapid"], 0))
        each = values.max(axis=0) / period**order / most
        found.append((float(each.max()), int(each.argmax())))
    return found


def judge(case):
    """Return what is wrong with a case, in words; None: it is refused."""
    machine = Machine.load(case.machine, set=case.set)
    program = Program(case.text.encode(), machine, file="cycle")
    try:
        program.check()
    except NckError:
        return None
    return [
        f"{what} of axis {'XYZABCUVW'[axis]} is {share:.4f} of its limit"
        for what, (share, axis) in zip(("speed", "acceleration", "jerk"), shares(program),
                                       strict=True)
        if share > 1 + SHARE
    ]  # fmt: skip


def main(arguments=None):
    """Run the command line; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--family", choices=list(FAMILIES))
    options = parser.parse_args(arguments)
    names = [options.family] if options.family else list(FAMILIES)
    bad = refused = 0
    for seed in range(options.seed, options.seed + options.count):
        name = names[seed % len(names)]
        one = case(name, seed)
        found = judge(one)
        refused += found is None
        if found:
            bad += 1
            print(f"=== {name} {seed}: {'; '.join(found)}\n{one.machine} {one.set}\n{one.text}")
    print(f"{options.count} programs, {refused} of them refused, {bad} pass a limit")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
