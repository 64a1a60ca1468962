# SPDX-License-Identifier: MIT
"""What `pycnc time` tells of a program is what the module takes for it in LinuxCNC."""

import math
import random
import subprocess

import numpy as np
import pytest
from linuxcnc_stand_in import CYCLE_S, EVER, Machine, StandIn, told_by_the_same_build

from pycnc import machine
from pycnc.machine.schema import SLOPES
from pycnc.planning.plan import Plan
from pycnc.program import Program

SAME_SHARE = 1e-3  # of the time, by the same build: 38 of 40 are the same to the period
SAME_EXACT_SHARE = 1e-3  # the same along the exact path
SHARE = 1e-3  # as `pycnc time -m machine.ini` tells it: 39 of 40 are within 0.0002
EXACT_SHARE = 1e-3  # the same along the exact path
SHORT_EXACT_SHARE = 0.006  # which a module for short periods plans with a longer window
PERIOD_SHARE = 0.06  # the same beside a servo period of 1 ms
# Seeds that take less by more, with short periods: their windows begin before the program is known.
SOONER = {37: 0.015}
PROGRAMS, SERVO_PROGRAMS = 40, 12
LEAST_S = 20.0  # a shorter program has no time to speak of, but for its begin and its end


@pytest.fixture(scope="module")
def stand_in(tmp_path_factory):
    return StandIn(tmp_path_factory.mktemp("linuxcnc"))


@pytest.fixture(scope="module")
def short(tmp_path_factory):
    return StandIn(tmp_path_factory.mktemp("short"), short_servo=True)


def places(draw, size_mm, count):
    """Return places whose moves are so long about, in a kind of path that is drawn."""
    kind = draw.choice(["random", "zigzag", "wave"])
    if kind == "random":
        return [[draw.uniform(-size_mm, size_mm) for _ in range(3)] for _ in range(count)]
    if kind == "zigzag":
        rise = draw.uniform(0.2, 1) * size_mm
        return [[size_mm * n, rise * (n % 2), 0.0] for n in range(1, count + 1)]
    turn = size_mm / draw.uniform(5, 50)
    return [[size_mm * n, size_mm / turn * math.sin(turn * n), 3 * math.cos(turn * n)]
            for n in range(1, count + 1)]  # fmt: skip


def program(seed):
    """Return (NC text, script) of the same moves, 3 ms long at least, and more than LEAST_S."""
    draw = random.Random(seed)
    tolerance = draw.choice([0.01, 0.05, 0.1])
    text, script = ["G21 G90"], []
    text.append(f"G64 P{tolerance}")
    script.append(f"term 2 {tolerance}")
    way = 0.0
    at = [0.0, 0.0, 0.0]
    while way < LEAST_S * 100:
        speed, size = draw.choice([40, 80, 100]), draw.choice([0.4, 2, 8, 25])
        for place in places(draw, size, draw.randrange(20, 80)):
            x, y, z = (round(each, 4) for each in place)
            way += math.dist(at, (x, y, z)) * 100 / speed
            at = [x, y, z]
            text.append(f"G1 F{speed * 60} X{x} Y{y} Z{z}")
            script += [f"line {speed} {x} {y} {z}", "run 1"]
    return "\n".join([*text, "M2", ""]).encode(), script


def time_taken(stand_in, script, period_s=CYCLE_S):
    """Return how long a script's moves take; one is handed over each millisecond, at most."""
    cycles = round(1e-3 / period_s)
    paced = [line.replace("run 1", f"run {cycles}") for line in script]
    if not cycles:  # two in a cycle
        paced = [line for n, line in enumerate(script) if line != "run 1" or n % 4 == 0]
    run = stand_in.run([f"period {period_s}", *paced, f"rest {4 * EVER}"])
    moves = np.flatnonzero(np.abs(np.diff(run.places, axis=0)).max(axis=1) > 0)
    return (moves[-1] - moves[0] + 1) * period_s


@pytest.fixture(scope="module")
def told(tmp_path_factory):
    """Return what `pycnc time -m machine.ini` tells of a text, by slope [s]."""
    path = tmp_path_factory.mktemp("told") / "machine.ini"

    def time_s(text, slope="optimal"):
        lines = f"TPMOD = nck_tp\nNCK_PLANNER = {slope}"
        path.write_text(Machine(traj=lines).ini, encoding="utf-8")
        return Plan(Program(text, machine.Machine.load(path)), keep=False).time_s

    return time_s


def told_by_the_same(text, slope="optimal", *, short_servo=False):
    """Return the time that the kernel with the module's capacities tells of a program [s]."""
    command = [told_by_the_same_build(short_servo=short_servo), str(SLOPES.index(slope))]
    return float(subprocess.run(command, input=text, capture_output=True, check=True).stdout)


@pytest.mark.sample(8)
@pytest.mark.parametrize("seed", range(PROGRAMS))
def test_time_told_is_time_taken(stand_in, told, seed):
    text, script = program(seed)
    told_s, same, taken = told(text), told_by_the_same(text), time_taken(stand_in, script)
    print(f"seed {seed}: told {told_s:.3f} s, by the same build {same:.3f} s, taken {taken:.3f} s")
    assert taken == pytest.approx(same, rel=SAME_SHARE)
    assert taken == pytest.approx(told_s, rel=SHARE)


@pytest.mark.sample(4)
@pytest.mark.parametrize("seed", range(PROGRAMS))
def test_time_told_is_time_taken_with_short_periods(short, seed):
    text, script = program(seed)
    told = told_by_the_same(text, short_servo=True)
    least = told * (1 - SOONER.get(seed, SAME_SHARE))
    assert least <= time_taken(short, script) <= told * (1 + SAME_SHARE)


@pytest.mark.sample(8)
@pytest.mark.parametrize("seed", range(PROGRAMS))
def test_time_told_is_time_taken_along_the_exact_path(stand_in, short, told, seed):
    text, script = program(seed)
    told_s, same = told(text, "jerk"), told_by_the_same(text, "jerk")
    taken = time_taken(stand_in.exact(), script)
    print(f"seed {seed}: exact {told_s:.3f} s, by the same build {same:.3f} s, taken {taken:.3f} s")
    assert taken == pytest.approx(same, rel=SAME_EXACT_SHARE)
    assert taken == pytest.approx(told_s, rel=EXACT_SHARE)
    assert time_taken(short.exact(), script) == pytest.approx(told_s, rel=SHORT_EXACT_SHARE)


@pytest.mark.sample(4)
@pytest.mark.parametrize("seed", range(SERVO_PROGRAMS))
@pytest.mark.parametrize("period_s", [0.25e-3, 0.5e-3, 2e-3])
def test_a_servo_period_costs_little(stand_in, short, period_s, seed):
    """The look-ahead and the budget are seconds, whatever the period."""
    _, script = program(seed)
    some = script[: 2 * 60 + 1]
    each = time_taken(stand_in, some)
    taken = time_taken(short if period_s < CYCLE_S else stand_in, some, period_s)
    print(f"seed {seed}: {period_s * 1e3} ms {taken:.3f} s, 1 ms {each:.3f} s")
    assert taken <= (1 + PERIOD_SHARE) * each


def test_dense_chords_take_the_same_time_at_a_short_period(stand_in, short):
    t = np.arange(1500) * 0.2 / 50
    r = 50 + 3 * np.sin(9 * t)
    ends = zip(r * np.cos(t) - 50, r * np.sin(t), strict=True)
    chords = ["term 2 0.01", *(f"line 100 {x:.4f} {y:.4f} 0\nrun 1" for x, y in ends)]
    each, taken = time_taken(stand_in, chords), time_taken(short, chords, 0.25e-3)
    assert taken == pytest.approx(each, rel=0.03)  # 1.31 times as long while cycles were counted
