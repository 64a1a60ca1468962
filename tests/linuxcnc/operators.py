# SPDX-License-Identifier: MIT
"""Random operators in the LinuxCNC that is installed here; fixed seeds, some minutes.

    .venv/bin/python tests/linuxcnc/operators.py [FIRST [COUNT]]

Each one runs a random program, holds, goes on, changes overrides, pauses, steps, aborts, jogs,
enters blocks by hand, and begins again. Every cycle of the planner keeps the limits (on the exact
path, G61, those of speed and acceleration), the last block by hand ends where it says, and nothing
hangs. nck_tp has to be installed (docs/linuxcnc.md).
"""

import random
import sys
import tempfile
from pathlib import Path

import numpy as np

from pycnc.linuxcnc import live

ROUNDING = 2e-3  # of a limit: the log counts nanometres
LAST = (1.0, 2.0, 3.0)
COUNT = 20


def program(draw):
    """Return a program of some seconds."""
    place, lines = [0.0, 0.0, 0.0], [f"G21 G90 {draw.choice(['G64 P0.01', 'G64 P0.1', 'G61'])}"]
    lines.append("G1 F6000")
    for _ in range(draw.randrange(30, 80)):
        size = draw.choice([0.1, 2, 10, 30])
        place = [min(max(x + draw.uniform(-size, size), -100), 100) for x in place]
        word = draw.choice(["G1", "G1", "G1", "G0"])
        lines.append(f"{word} X{place[0]:.4f} Y{place[1]:.4f} Z{place[2]:.4f}")
        if draw.random() < 0.1:
            lines.append(draw.choice(["M62 P0", "M63 P0"]))
    return "\n".join([*lines, "M2", ""])


def operator(draw):
    """Return what an operator does while it runs."""
    script = []
    for _ in range(draw.randrange(3, 7)):
        wait = draw.uniform(0.05, 0.6)
        script += draw.choice([
            [(wait, "hold"), (draw.uniform(0, 0.8), "go on")],
            [(wait, "pause"), (draw.uniform(0, 0.8), "resume")],
            [(wait, "pause"), (0.8, "step"), (0.6, "step"), (0.6, "resume")],
            [(wait, "override", draw.choice([0.0, 0.1, 0.7, 1.3])), (0.5, "override", 1.0)],
            [(wait, "rapids", draw.choice([0.0, 0.2, 0.6])), (0.5, "rapids", 1.0)],
            [(wait, "abort"), (0, "jog", draw.randrange(3), draw.choice([-30, 20]), 0.3),
             (0, "run")],
            [(wait, "abort"), (0, "mdi", f"G0 X{draw.uniform(-9, 9):.3f}"), (0, "run")],
        ])  # fmt: skip
    return [*script, (0.1, "go on"), (0, "override", 1.0), (0, "rapids", 1.0), (0, "abort"),
            (0, "mdi", "G0 G90 X{} Y{} Z{}".format(*LAST))]  # fmt: skip


def shares(log):
    """Return the peaks of speed, acceleration and jerk where the planner has led all the while."""
    found, peaks = log.places, []
    for k, limit in enumerate(live.Limits()):
        found = np.diff(found, axis=0) / live.CYCLE_S
        ours = np.lib.stride_tricks.sliding_window_view(log.coordinated, k + 4).all(axis=1)
        ours = ours[: len(found)]
        peaks.append(float(np.abs(found[: len(ours)][ours]).max()) / limit)
    return peaks


def failures(seed):
    """Run one operator; return what was wrong, in words."""
    draw = random.Random(seed)
    text = program(draw)
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)
        log = live.run(folder, text, planner="nck_tp", script=operator(draw))
    peaks = shares(log)
    limited = peaks[:2] if "G61" in text else peaks
    wrong = [f"{name} {peak:.4f} of its limit"
             for name, peak in zip(("speed", "acceleration", "jerk"), limited, strict=False)
             if peak > 1 + ROUNDING]  # fmt: skip
    if np.abs(log.places[-1] - LAST).max() > 1e-5:
        wrong.append(f"it ends at {log.places[-1]}")
    wrong += [line for line in log.text.splitlines() if line.startswith("late")]
    shown = " ".join(f"{peak:.3f}" for peak in peaks)
    print(f"seed {seed}: {len(log.line)} cycles, {shown}", *wrong, sep="; ", flush=True)
    return wrong


def main():
    """Run the operators that are asked for; 1 if one of them found something."""
    given = [int(word) for word in sys.argv[1:]]
    first, count = [*given, *[0, COUNT][len(given):]]
    return int(any([failures(seed) for seed in range(first, first + count)]))


if __name__ == "__main__":
    sys.exit(main())
