# SPDX-License-Identifier: MIT
"""Overrides that come down a little, before moves that are faster: the tool keeps to the feed that
is left, and every limit holds at every tick.

    python tests/slope/test_lowered_feeds.py 1000 0     so many seeds from 0 on
"""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1]))

import checker

from pycnc import kernel
from pycnc.machine import Machine
from pycnc.program import Program

TICKS_MOST = 60_000  # a longer run waits for the campaign of stops
OVERRIDES = (99, 97, 95, 90, 80, 60, 30)  # [%]


def _machine(rng):
    a = 10 ** rng.uniform(1.5, 3.7)
    j = a * 10 ** rng.uniform(0.5, 2)
    period = rng.choice([0.5, 1, 2, 10])
    own = f"j_max_mm_s3 = {j * rng.uniform(0.2, 1):.5g}\n" if rng.random() < 0.3 else ""
    axes = "".join(
        f"[axis.{letter}]\nv_max_mm_s = {rng.uniform(50, 400):.4g}\na_max_mm_s2 = {a:.5g}\n"
        f"j_max_mm_s3 = {j:.5g}\n"
        for letter in "xyz"
    )
    text = f'[kernel]\nperiod_ms = {period}\n[path]\nslope = "optimal"\n{own}{axes}'
    return Machine.from_text(text, "drawn")


def _text(rng):
    """Return two to eight moves that turn a little or much, some of them rapids."""
    place, angle = np.zeros(3), rng.uniform(0, 2 * np.pi)
    lines = [f"G21 G90 G17 G64 P{10 ** rng.uniform(-2.5, -0.1):.5f}"]
    for _ in range(rng.integers(2, 9)):
        angle += rng.normal(0, rng.choice([0.02, 0.3, 1.5]))
        way = 10 ** rng.uniform(0, 1.9)
        place = place + way * np.array([np.cos(angle), np.sin(angle), rng.normal(0, 0.2)])
        word = "G0" if rng.random() < 0.3 else "G1"
        x, y, z = place
        lines.append(f"{word} X{x:.4f} Y{y:.4f} Z{z:.4f} F{10 ** rng.uniform(1.5, 4):.0f}")
    return "\n".join([*lines, "M2", ""]).encode()


def _commands(rng, ticks):
    commands, at = [], 0
    for _ in range(rng.integers(1, 4)):
        at += int(rng.uniform(0, ticks) / 2) + 1
        feed = int(rng.choice(OVERRIDES))
        commands.append((at, "override", feed, int(rng.choice([feed, 100, 95]))))
    return commands


def judge(seed):
    """Run a seed's program under its overrides; a PhysicsError tells what it breaks."""
    rng = np.random.default_rng([77, seed])
    machine, text = _machine(rng), _text(rng)
    program = Program(text, machine, file="drawn.ngc").check()
    planner = kernel.Planner(program.text, machine)
    for _ in planner.pieces():
        pass
    ticks = int(planner.totals["ticks"])
    if ticks > TICKS_MOST:
        return
    commands = _commands(rng, ticks)
    found = checker.Checker(program.blocks, machine.record, commands, None)
    for rows, _ in kernel.Simulation(text, machine, kernel.PREP_STEPS, commands).pieces():
        found.add(rows)
    found.finish()


@pytest.mark.sample(12)
@pytest.mark.parametrize("seed", [*range(300), 1000, 1145, 1243])
def test_a_feed_that_comes_down_is_kept_and_so_is_every_limit(seed):
    judge(seed)


def main(count, first):
    """Judge seeds; return how many break something."""
    broken = 0
    for seed in range(first, first + count):
        try:
            judge(seed)
        except checker.PhysicsError as error:
            broken += 1
            print(f"{seed}: {error}", flush=True)
    print(f"{count} programs, {broken} broken")
    return broken


if __name__ == "__main__":
    sys.exit(1 if main(*map(int, sys.argv[1:])) else 0)
