# SPDX-License-Identifier: MIT
"""Programs along clocked paths, which the slope `optimal` plans by convex optimisation: what they
promise.

    .venv/bin/python tests/clocked.py 1000 [FIRST]      so many programs by seed
    .venv/bin/python tests/clocked.py stops 300 [FIRST] rests asked for along the way (stop_gate.py)

A program is lines and arcs in two or three axes, from smooth to jagged, with other feeds, rapids,
tolerances, exact blocks, dwells and spindle words in between. It is judged by tests/checker.py, and
must end.
"""

import dataclasses
import sys
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parent))

import checker
import stop_gate

from pycnc import kernel
from pycnc.bench import programs
from pycnc.machine import Machine
from pycnc.planning.plan import Plan
from pycnc.program import Program

TRAVEL = 190.0  # mm: of every axis, less a bit
LOWERED_TICKS, LOWERED_MOST, LOWERED_NEAR = 3000, 5, 0.02  # of a run; bounds; of the feed
RUN_SHARE, RUN_TICKS = 30, 5000  # a run takes so many times its plan at most, and these


def _words(rng, tolerance):
    """Yield what stands between two moves, seldom."""
    if rng.random() < 0.02:
        yield "G61"
        if rng.random() < 0.5:
            yield f"G64 P{tolerance}"
    if rng.random() < 0.02:
        yield f"G64 P{rng.choice([0.002, 0.01, 0.05])}"
    if rng.random() < 0.02:
        yield "G4 P0.05"
    if rng.random() < 0.02:
        yield "S1000 M3"


def _point(place):
    return " ".join(f"{axis}{x:.5f}" for axis, x in zip("XYZ", place, strict=True))


def text_of(seed):
    """Return the program of a seed."""
    rng = np.random.default_rng([7, seed])
    count, axes = int(rng.integers(3, 60)), int(rng.integers(2, 4))
    scale, turn = 10 ** rng.uniform(-1.5, 1.5), rng.choice([0.05, 0.3, 1.0, 3.0])
    tolerance, feed = float(rng.choice([0.002, 0.01, 0.05])), float(rng.choice([300, 1500, 6000]))
    lines = [f"G21 G17 G90 G94 G64 P{tolerance}", f"F{feed:g}"]
    place, along = np.zeros(3), rng.normal(size=3) * (np.arange(3) < axes)
    for _ in range(count):
        along = along / np.linalg.norm(along) + turn * rng.normal(size=3) * (np.arange(3) < axes)
        step = scale * 10 ** rng.uniform(-0.7, 0.7) * along / np.linalg.norm(along)
        end = np.round(np.clip(place + step, -TRAVEL, TRAVEL), 5)
        chord = np.linalg.norm((end - place)[:2])
        if rng.random() < (0.15 if axes == 2 else 0.08) and chord > 1e-3:
            word = f"G{rng.integers(2, 4)} {_point(end)} R{chord * rng.uniform(0.55, 3):.6f}"
        elif rng.random() < 0.05:
            word = f"G0 {_point(end)}"
        else:
            other = f" F{feed * rng.uniform(0.3, 1):.1f}" if rng.random() < 0.1 else ""
            word = f"G1 {_point(end)}{other}"
        lines += [word, *_words(rng, tolerance)]
        place = end
    return "\n".join([*lines, "M2", ""])


def short_of(seed):
    """Return a program with lines that last less than a knot, slower than those around them."""
    rng = np.random.default_rng([8, seed])
    feed, slower = rng.uniform(200, 3000), rng.uniform(0.5, 0.95)
    way = np.cumsum(rng.normal(0, 0.02, 120))
    last_s = np.where(np.arange(120) % 2, rng.uniform(0.002, 0.0035, 120), rng.uniform(0.01, 0.02))
    feeds = feed * np.where(np.arange(120) % 2, slower, 1.0)
    steps = (last_s * feeds / 60)[:, None]
    points = np.cumsum(steps * np.column_stack([np.cos(way), np.sin(way)]), axis=0)
    lines = [f"G21 G17 G90 G94 G64 P{rng.choice([0.002, 0.01, 0.05])}"]
    for (x, y), f in zip(points, feeds, strict=True):
        lines.append(f"G1 X{x:.5f} Y{y:.5f} F{f:.1f}")
    return "\n".join([*lines, "M2", ""])


def machine_of(seed):
    """Return the machine of a seed: every third has limits of its path, 0.1 to 1.4 of its axes'."""
    if seed % 3:
        return programs.machine("optimal")
    rng = np.random.default_rng([9, seed])
    text = programs.MACHINE.format(slope="optimal")
    for key, most in (("a_max_mm_s2", 1000), ("j_max_mm_s3", 10_000)):
        text += f"{key} = {most * 10 ** rng.uniform(-1, 0.15)}\n"
    text += "".join(programs.AXIS.format(axis=axis, a=1000, j=10_000) for axis in "xyz")
    return Machine.from_text(text, name="comparison with limits of its path")


def operated(seed):
    """Return what an operator does to the program of a seed: overrides, holds that are resumed."""
    rng, tick, commands = np.random.default_rng([10, seed]), 0, []
    for _ in range(int(rng.integers(1, 6))):
        tick += int(10 ** rng.uniform(1.0, 3.3))
        if rng.random() < 0.5:
            commands.append((tick, "override", int(rng.integers(10, 200)), 100))
        else:
            commands.append((tick, "hold"))
            tick += int(10 ** rng.uniform(1.0, 3.0))
            commands.append((tick, "resume"))
    return [*commands, (tick + 2000, "override", 100, 100)]


def slowed(seed):
    """Return what an operator does who lowers overrides around holds: before they rest, at rest,
    and as the tool sets off."""
    rng, tick, commands = np.random.default_rng([11, seed]), 0, []
    for _ in range(int(rng.integers(1, 5))):
        hold = tick + int(10 ** rng.uniform(1.5, 3.2))
        lowered, resumed = hold + int(rng.integers(-30, 600)), hold + int(rng.integers(10, 600))
        tick = max(lowered, resumed)
        some = [(hold, "hold"), (resumed, "resume"),
                (max(lowered, 0), "override", int(rng.integers(1, 60)), 100)]  # fmt: skip
        commands += sorted(some)
        tick += int(rng.integers(1, 800))
        commands.append((tick, "override", 100, 100))
    return commands


def findings(seed, make=text_of, operate=None):
    """Return what is wrong with the run of a seed's program, in words; empty: nothing."""
    machine = machine_of(seed)
    program = Program(make(seed).encode(), machine).check()
    commands, answer = (operate(seed), np.inf) if operate else ((), None)
    # Where the tick brakes along a plan it may take a little more, so that it can leave that.
    judge = checker.Checker(program.blocks, machine.record, commands, answer, late=bool(operate))
    most = RUN_SHARE * Plan(program).time_s / machine.period_s + RUN_TICKS
    try:
        for rows, _ in kernel.Simulation(
            program.text, machine, kernel.PREP_STEPS, commands
        ).pieces():
            judge.add(rows)
            if judge.ticks > most:
                return "no end"
        judge.finish()
    except checker.PhysicsError as error:
        return str(error)
    return ""


def try_rest(seed):
    """Return how a rest goes; None where nothing moves, or on the exact path."""
    case = dataclasses.replace(stop_gate.draw(seed), slope="optimal")
    return None if case.exact else stop_gate.try_case(case)


def try_off(seed):
    """Return how a run goes that rests while prep is dead, and goes on once it works again."""
    case = dataclasses.replace(stop_gate.draw(seed), slope="optimal", dead=True, last="hold")
    drawn = None if case.exact else stop_gate.moments(case)
    if drawn is None:
        return None
    run = drawn.run
    run.rest("hold", None)
    run.die()
    run.go(stop_gate.RESTS)
    run.live()
    run.go_on()
    run.go(stop_gate.RESTS)
    poses = run.poses()
    return stop_gate.judge(case, poses["v"], poses["axis"][:, :3], drawn.then)


def try_lowered(seed):
    """Return how long a lowered override takes to be kept to 2 % of the feed, of what a brake may
    take along a line; None where nothing moves, or on the exact path."""
    case = stop_gate.draw(seed)
    if case.exact or case.family == "rapids":
        return None
    case = dataclasses.replace(case, slope="optimal", prep_steps=kernel.PREP_STEPS)
    rng = np.random.default_rng([seed, 41])
    plain = stop_gate.Run(case)
    plain.go(LOWERED_TICKS)
    fast = np.flatnonzero(plain.poses()["v"] > 1.0)
    if len(fast) < 100:
        return None
    at, share = int(rng.choice(fast[:-20])), float(rng.choice([0.01, 0.03, 0.1, 0.3]))
    run = stop_gate.Run(case)
    run.go(at)
    run.first("override", share)
    poses = run.poses()
    bound_s = stop_gate.bound_of(case, poses["v"], poses["axis"][:, :3], at)
    run.go(int(LOWERED_MOST * bound_s / case.period_s) + 1)
    poses = run.poses()[at:]
    kept = np.flatnonzero(poses["v"] <= (share + LOWERED_NEAR) * poses["feed"])
    return (int(kept[0]) if len(kept) else len(poses)) * case.period_s / bound_s


def main():
    """Try what the command line says; return 1 if something is wrong."""
    if sys.argv[1:2] == ["stops"]:
        return stop_gate.search(try_rest, 300)
    if sys.argv[1:2] == ["offs"]:
        return stop_gate.search(try_off, 300)
    count, first = [*(int(word) for word in sys.argv[1:]), *(1000, 0)[len(sys.argv) - 1 :]]
    wrong = 0
    for seed in range(first, first + count):
        if found := findings(seed):
            wrong += 1
            print(f"{seed}: {found}", flush=True)
    print(f"{wrong} of {count} programs from seed {first} on")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
