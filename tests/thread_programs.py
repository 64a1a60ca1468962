# SPDX-License-Identifier: MIT
"""Random programs with threads and taps, whose waits for the spindle's angle are to be planned.

    python tests/thread_programs.py --count 2000 --seed 1

plans and runs them, and tells those whose times are not equal; exit 1 if there is one. Threads wait
for the spindle at periods of 0.25 ms, too: 300 of every family take a quarter of an hour on two
quiet cores.
"""

import argparse
import random
import sys
from concurrent.futures import ProcessPoolExecutor
from functools import partial

import pycnc
from pycnc.machine import Machine

FAMILIES = ("g33", "chain", "g76", "tap", "g32", "starts", "g92", "g76_two", "holes")
_FANUC = ("g32", "starts", "g92", "g76_two")
_NEAR_S = 2e-3  # by which plan and run may differ


class _Writer:
    """Writes one program of a family."""

    def __init__(self, family, seed):
        self.source = random.Random(f"{family} {seed}")
        self.family, self.fanuc = family, family in _FANUC
        self.mill = family in ("tap", "holes")
        self.rpm = self.source.choice([150, 333, 480, 600, 777.7, 900])

    def pick(self, *choices):
        return self.source.choice(choices)

    def z(self):
        return f"Z{self.source.uniform(-60, -35):.3f}"

    def lead(self):
        return self.pick(0.5, 0.75, 1, 1.5, 2.117)

    def between(self):
        """Yield what shifts the spindle's angle by time: moves, rests, speeds, surface speed."""
        for _ in range(self.source.randint(0, 3)):
            kind = self.source.randint(0, 6)
            if kind == 0:
                yield f"G1 F{self.source.randint(80, 900)} X{self.source.uniform(25, 60):.2f}"
            elif kind == 1:
                yield f"G4 {'X' if self.fanuc else 'P'}{self.source.uniform(0.01, 0.7):.3f}"
            elif kind == 2:
                self.rpm = self.pick(150, 250, 600, 850)
                yield f"S{self.rpm}"
            elif kind == 3:  # the speed changes while it moves
                self.rpm = self.pick(200, 650)
                yield f"G1 F300 X41 S{self.rpm}"
                yield f"G1 X{self.source.uniform(42, 50):.3f}"
            elif kind == 4 and not self.mill:
                yield from ("G50 S1500", "G96 S90") if self.fanuc else ("G96 S90 D1500",)
                yield f"G1 F400 X{self.source.uniform(8, 70):.2f}"
                yield f"G97 S{self.rpm}"
            elif kind == 5:
                yield self.pick("M0", "M5\nM3", "M4", "M3")
            else:
                yield f"G0 X{self.source.uniform(25, 70):.3f}"

    def thread(self):
        lead, z = self.lead(), self.z()
        angle = self.pick("", f" Q{self.source.randrange(0, 360_000, 500)}")
        if self.family == "g33":
            return [f"G33 {z} {self.pick('', 'X22 ')}K{lead}"]
        if self.family == "chain":
            return [f"G33 Z-20 K{lead}", f"G33 Z-50 K{self.lead()}"]
        if self.family == "g76":
            tail = self.pick("", "H2", "L2 E2", "L3 E3 H1")
            return [f"G76 P{lead} {z} I-3 J0.3 K0.92 R1.8 Q29.5 {tail}"]
        if self.family == "tap":
            return [f"G33.1 {z} K{lead}", f"G33.1 X{self.pick(3, 7)} {z} K{lead}"]
        if self.family == "holes":
            return ["M3", f"F{lead * self.rpm:.4f}",
                    f"G84 X10 {z} R5 P{self.pick(0, 0.2)}", "X20 Y4", "G80"]  # fmt: skip
        if self.family == "g32":
            return [f"G32 {z} F{lead}{angle}"]
        if self.family == "starts":
            count = self.pick(2, 3, 4)
            turns = [f"Q{360_000 * k // count}" for k in range(count)]
            return [f"G0 X24 Z5\nG32 {z} F{lead} {q}\nG0 X30" for q in turns]
        if self.family == "g92":
            return [f"G92 X23 {z} F{lead}{angle}", "X22.5", "X22.3 R-0.4"]
        return ["G76 P020060 Q100 R0.05", f"G76 X20.05 {z} P920 Q300 F{lead}"]

    def program(self):
        first = "G21 G98" if self.fanuc else f"G21 G90 G94 {self.pick('G61', '', 'G64')}"
        plane = "G17 G98" if self.mill else "G18"
        lines = [first, f"{plane} F{self.rpm:.0f}", f"G97 S{self.rpm} M3"]
        for _ in range(self.source.randint(1, 3)):
            lines += ["G0 X24 Z5", *self.between(), f"S{self.rpm}", "G0 X24 Z5", *self.thread()]
            lines += ["G0 X30", *self.between()]
        return "\n".join([*lines, "M30" if self.fanuc else "M2", ""])

    def machine(self):
        change = [f"path.slope={self.pick('jerk', 'linear')}",
                  f"kernel.period_ms={self.pick(0.25, 0.5, 1, 1, 2, 4, 10)}"]  # fmt: skip
        if self.mill:
            return Machine.load("mill3", set=("dialect.base=linuxcnc", *change))
        if self.fanuc:
            return Machine.load("cak6150n", set=("dialect.system=A", *change))
        return Machine.load("cak6150n", set=("dialect.base=linuxcnc", *change))


def write(family, seed):
    """Return (text, machine) of a program; it may have errors: threads that are too short."""
    writer = _Writer(family, seed)
    machine = writer.machine()
    return writer.program(), machine


def judge(family, seed):
    """Return what is wrong with the times of a program; None: it has errors; []: nothing."""
    text, machine = write(family, seed)
    program = pycnc.load(text, machine=machine)
    if program.diagnostics.errors:
        return None
    plan, found, summary = pycnc.plan(program), pycnc.why(program), pycnc.run(program).summary
    told = []
    for name, seen in (("plan", plan.time_s), ("why", found.time_s)):
        if abs(seen - summary["time_s"]) > _NEAR_S:
            told.append(f"{name} {seen:.6f} s, run {summary['time_s']:.6f} s")
    for sums in (summary["limit_time_s"], plan.totals["limit_time_s"]):
        if sums["starved"] or not sums["thread"] > 0:
            told.append(f"starved {sums['starved']:.6f} s, thread {sums['thread']:.6f} s")
        if abs(sum(sums.values()) - summary["time_s"]) > _NEAR_S:
            told.append(f"limits add up to {sum(sums.values()):.6f} s")
    return told


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, default=200, help="programs of every family")
    parser.add_argument("--seed", type=int, default=1, help="of the first one")
    given = parser.parse_args()
    judged = bad = 0
    seeds = range(given.seed, given.seed + given.count)
    with ProcessPoolExecutor() as pool:
        for family in FAMILIES:
            for seed, found in zip(seeds, pool.map(partial(judge, family), seeds), strict=True):
                judged += found is not None
                if found:
                    bad += 1
                    print(f"{family} {seed}: {'; '.join(found)}", flush=True)
            print(f"{family}: {given.count} programs tried", flush=True)
    print(f"{judged} programs judged, {bad} of them with other times than planned")
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())
