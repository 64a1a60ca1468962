# SPDX-License-Identifier: MIT
"""Limits that change while a program runs, and an answer behind that: is the path what it was?

    .venv/bin/python tests/new_limits.py 1000 [FIRST] [SLOPE]  so many seeds, of one slope
    .venv/bin/python tests/new_limits.py 1 70 -v               one case, told whatever it does

A seed draws a case of tests/stop_gate.py, other accelerations and jerks, and three moments: from
one on nck_set_limits is called between the ticks until it is taken, at the others the operator
wants something, and goes on, again and again. The second half of the program comes behind the
change. Every axis keeps to the larger one of both limits all along; by far, nowhere: that would be
a jump.
"""

import dataclasses
import sys
from dataclasses import dataclass

import numpy as np
import stop_gate

from pycnc.kernel import check, ffi, lib

PREP_STEPS = 4096  # between two ticks
TICKS = 3000  # of a case
PAUSE = 50  # ticks, from when the operator goes on until he begins to count again
SLOPES = ("linear", "jerk", "optimal")
ANSWERS = ("hold", "override", "speed")
SHARE = 1.05  # of a limit, as in stop_gate.py
SOME = 0.005  # of the cases may pass it: where the tick goes on again
JUMP = 5  # times a jerk: what passes it is a jump


class Live:
    """A kernel between whose ticks anything may be called."""

    def __init__(self, machine):
        self._memory = ffi.new("double[]", lib.nck_size() // 8 + 1)
        self.nck = lib.nck_place(self._memory, 8 * len(self._memory))
        check(lib.nck_init(self.nck, machine.pointer, ffi.NULL))
        self._pose, self._axes = ffi.new("nck_pose_t *"), ffi.new("nck_axes_t *")
        self._used, self._text = ffi.new("size_t *"), ffi.new("char[]", 0)
        self._read = 0
        self.places = []

    def push(self, text):
        """Have a text read as there is room for it; the one before has been read."""
        self._text, self._read = ffi.new("char[]", text.encode()), 0

    def tick(self):
        """Go one period on."""
        size = len(self._text) - 1
        for _ in range(PREP_STEPS):
            if self._read < size:
                text = self._text + self._read
                lib.nck_push(self.nck, text, size - self._read, self._used)
                self._read += self._used[0]
            status = lib.nck_prep(self.nck)
            if status != lib.NCK_OK and (status != lib.NCK_EMPTY or self._read == size):
                break
        check(min(status, lib.NCK_OK))
        lib.nck_tick(self.nck, self._pose, self._axes)
        self.places.append(tuple(self._pose.axis[0:3]))

    def takes_limits(self, machine):
        """Offer the limits of another machine; return whether they are in force."""
        if self._read < len(self._text) - 1:
            return False
        status = lib.nck_set_limits(self.nck, machine.pointer)
        check(min(status, lib.NCK_OK))
        return status == lib.NCK_OK

    def answer(self, name, share):
        """Do what the operator wants."""
        if name == "hold":
            lib.nck_hold(self.nck)
        elif name == "override":
            lib.nck_set_override(self.nck, round(share * stop_gate.CALLS), stop_gate.CALLS)
        else:
            lib.nck_set_speed(self.nck, max(1, round(share * 1e5)))

    def go_on(self):
        """Take it back."""
        lib.nck_set_override(self.nck, stop_gate.CALLS, stop_gate.CALLS)
        lib.nck_set_speed(self.nck, stop_gate.FREE)
        lib.nck_resume(self.nck)


@dataclass
class Told:
    """How a case went."""

    case: stop_gate.Case  # with the limits before
    other: stop_gate.Case  # … and behind
    ticks: tuple  # when they were offered, taken (-1: never); the operator wanted …
    wish: tuple  # … this, and went on
    fast: float  # the most of an axis' limit of speed, …
    a: float  # … the larger one of acceleration, …
    j: float  # … and of jerk

    def jumps(self):
        """Tell whether the tool jumped."""
        jerks = self.case.keeps_jerk() and self.j > JUMP
        return max(self.fast, self.a) > SHARE or jerks

    def is_beyond(self):
        """Tell whether an axis passed its limits."""
        jerks = self.case.keeps_jerk() and self.j > SHARE
        return max(self.fast, self.a) > SHARE or jerks


def draw(seed, slope=None):
    """Return the case of a seed, with other limits, and what happens when; slope: another one."""
    case = stop_gate.draw(seed)
    rng = np.random.default_rng([seed, 3319])
    a, j = (limit * 10 ** rng.uniform(-0.7, 0.7) for limit in (case.a, case.j))
    ticks = np.cumsum(10 ** rng.uniform((0.5, 0, 1.3), (2.7, 2.7, 2.5))).astype(int)
    case = dataclasses.replace(case, slope=slope or case.slope)
    wish = ANSWERS[rng.integers(3)], 10 ** rng.uniform(-2.7, 0.3)
    return case, dataclasses.replace(case, a=a, j=j), ticks, wish


def try_seed(seed, slope=None):
    """Return how the case of a seed goes."""
    case, other, (offered, wants, goes_on), wish = draw(seed, slope)
    lines = case.text.splitlines()
    half = 1 + len(lines) // 2
    live, machine, taken = Live(case.machine()), other.machine(), -1
    live.push("\n".join([*lines[:half], ""]))
    for tick in range(TICKS):
        if tick >= offered and taken < 0 and live.takes_limits(machine):
            taken = tick
            live.push("\n".join([*lines[half:], ""]))
        again = tick % (goes_on + PAUSE)
        if again == wants:
            live.answer(*wish)
        if again == goes_on:
            live.go_on()
        live.tick()
    places, period = np.array(live.places), case.period_s

    def most(order, limit):
        return float(np.abs(np.diff(places, order, axis=0)).max() / period**order / limit)

    peaks = most(1, stop_gate.V_MAX), most(2, max(case.a, other.a)), most(3, max(case.j, other.j))
    return Told(case, other, (offered, taken, wants, goes_on), wish, *peaks)


def tell(told):
    """Print how a case went."""
    case, other, (offered, taken, wants, goes_on) = told.case, told.other, told.ticks
    print(
        f"{case.seed:6} {case.family:8}{'G61' if case.exact else 'G64'} {case.slope:7} "
        f"T {case.period_s * 1e3:<5g} a {case.a:.0f} to {other.a:.0f}, j {case.j:.0f} to "
        f"{other.j:.0f} from tick {offered} on, in force from {taken}; {told.wish[0]} "
        f"{told.wish[1]:.3f} at {wants} to {goes_on}: v {told.fast:.3f}, a {told.a:.3f}, "
        f"j {told.j:.3f}{' BEYOND' if told.is_beyond() else ''}", flush=True,
    )  # fmt: skip


def main():
    """Try the seeds of the command line; return 1 if more than some pass a limit."""
    numbers = [int(word) for word in sys.argv[1:] if word.isdigit()]
    count, first = [*numbers, *(1000, 0)[len(numbers) :]]
    slope = next((word for word in sys.argv[1:] if word in SLOPES), None)
    every = []
    for seed in range(first, first + count):
        told = try_seed(seed, slope)
        every.append(told)
        if told.is_beyond() or "-v" in sys.argv:
            tell(told)
    taken = sum(told.ticks[1] >= 0 for told in every)
    pairs = ((told.is_beyond(), told.jumps()) for told in every)
    beyond, jumps = (sum(told) for told in zip(*pairs, strict=True))
    print(f"{count} cases from {first} on: limits taken in {taken}, {beyond} beyond one, "
          f"{jumps} jump")  # fmt: skip
    return int(jumps or beyond > SOME * count)


if __name__ == "__main__":
    sys.exit(main())
