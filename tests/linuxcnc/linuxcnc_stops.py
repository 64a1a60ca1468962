# SPDX-License-Identifier: MIT
"""The cases of tests/stop_gate.py in the stand-in for LinuxCNC: what its operator asks for first,
and the rest that he asks for then. Bound and judging are that gate's.

    .venv/bin/python tests/linuxcnc/linuxcnc_stops.py 1000          so many seeds from 0 on
    .venv/bin/python tests/linuxcnc/linuxcnc_stops.py 1 700 -v      one case, told whatever it does

The host feeds moves all at once or one every so many servo cycles, and none once the rest is asked
for. Its soft limits are those of joints: it aborts where one has been left, and from then on the
time counts. prep works in the servo cycle, so it cannot die.
"""

import sys
import tempfile
from dataclasses import replace
from itertools import chain
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))

import numpy as np
import stop_gate
from linuxcnc_stand_in import Machine, StandIn

from pycnc import stages
from pycnc.kernel.records import enum

MOVING = 30  # cycles at least, of a program that is tried
# What the operator does first, by a share of 0.2 to 200 %; and how he takes it back, halfway.
FIRST = {
    "none": ("", ""), "feed": ("feed {}", ""), "up": ("feed {}", "feed 1"),
    "rapids": ("rapids {}", ""), "adaptive": ("adaptive {}", ""), "vlimit": ("vlimit {}00", ""),
    "feedhold": ("feedhold 1", "feedhold 0"), "pause": ("pause", "resume"),
    "step": ("pause", "step"),
}  # fmt: skip
LAST = {
    "pause": ["pause"], "abort": ["abort"], "feed": ["feed 0", "rapids 0"],
    "feedhold": ["feedhold 1"], "adaptive": ["adaptive 0"], "vlimit": ["vlimit 0"],
}  # fmt: skip
GOES_ON = ["feed 1", "rapids 1", "feedhold 0", "adaptive 1", "vlimit 1000", "resume"]
NO_SHARE_ABOVE_1 = ("rapids", "adaptive")  # what LinuxCNC does not offer
BLOCK = enum("nck_block_kind_t")


def draw(seed):
    """Return the case of a seed, and how many cycles the host is between two moves."""
    case = stop_gate.draw(seed)
    rng = np.random.default_rng([seed, 2612])
    first, last = str(rng.choice(list(FIRST))), str(rng.choice([*LAST, "soft"]))
    slope = "linear" if case.slope == "linear" else "optimal"
    value = min(case.value, 1.0) if first in NO_SHARE_ABOVE_1 else case.value
    pace = int(rng.choice([0, 0, 0, 1, 5, 25]))
    return replace(case, first=first, last=last, slope=slope, value=value, dead=False), pace


def moves_of(case):
    """Return the moves of its program, as LinuxCNC's interpreter hands them to the planner, and how
    far along the way the end of each is."""
    blocks, _ = stages.decode(case.text.encode(), case.machine())
    blocks = blocks[blocks["kind"] <= BLOCK.ARC]
    ends = blocks["target_nm"][:, :3] * 1e-6
    ways = np.linalg.norm(np.diff(ends, axis=0, prepend=np.zeros((1, 3))), axis=1)
    moves = []
    for n, block in enumerate(blocks):
        end, v = " ".join(f"{x:.7f}" for x in ends[n]), block["feed"] / 60
        if block["kind"] == BLOCK.RAPID:
            moves.append(f"rapid {stop_gate.V_MAX} {end}")
        elif block["kind"] == BLOCK.LINE:
            moves.append(f"line {v:.9f} {end}")
        else:
            x, y = block["centre_mm"]
            turn = 0 if block["sweep_rad"] > 0 else -1
            moves.append(f"arc {v:.9f} {end} 0 0 0 0 0 0 {x:.9f} {y:.9f} 0 0 0 1 {turn}")
            round_mm = np.hypot(*(ends[n, :2] - (x, y))) * block["sweep_rad"]
            ways[n] = np.hypot(round_mm, ends[n, 2] - (ends[n - 1, 2] if n else 0))
    return moves, np.cumsum(ways)


def speeds_of(case, ways, run):
    """Return the speed along the programmed way, which a path within a tolerance cuts short."""
    move = np.clip(run.column("id").astype(int) - 1, 0, len(ways) - 1)
    at = ways[move] - run.column("to_go")
    along = np.diff(at, prepend=0.0) / case.period_s
    tool = run.column("speed")
    return np.where(tool > 0, np.maximum(tool, along), 0.0)


def machine_of(case):
    """Return its machine, as an INI file tells it."""
    traj = f"NCK_PLANNER = {case.slope}\nNCK_BUDGET = {4 * case.prep_steps}"
    return Machine(v=stop_gate.V_MAX, a=case.a, j=case.j, traj=traj)


def script_of(case, moves, pace, acts, end):
    """Return the script that feeds the program and does what `acts` says in which cycle."""
    mode = case.text.split("\n", 1)[0].split()
    term = f"term 2 {mode[-1][1:]}" if mode[-1].startswith("P") else "term 1 0"
    fed = ((n * pace, [move]) for n, move in enumerate(moves) if n * pace < end)
    script, now = [f"period {case.period_s}", term], 0
    for cycle, lines in sorted(chain(fed, acts), key=lambda each: each[0]):
        if cycle > now:
            script.append(f"run {cycle - now}")
            now = cycle
        script += lines
    return [*script, f"run {end - now}"]


def try_case(stand_in, case, pace):
    """Return how it goes; None where nothing moves when the rest is asked for."""
    rng = np.random.default_rng([case.seed, 8])
    machine, (moves, ways) = machine_of(case), moves_of(case)
    plain = stand_in.run(script_of(case, moves, pace, [], stop_gate.MOMENTS), machine)
    moving = np.flatnonzero(plain.column("speed") > 0)
    if len(moving) < MOVING:
        return None
    at, then = (int(cycle) for cycle in np.sort(rng.choice(moving, 2, replace=False)))
    first, back = (words.format(f"{case.value:.6f}") for words in FIRST[case.first])
    acts = [(at, [first]), (at + (then - at) // 2, [back])]
    asked = LAST.get(case.last) or soft_limits(plain.places[at], plain.places[then])
    before = script_of(case, moves, pace, acts, then)
    run = stand_in.run([*before, *asked, *ending(case)], machine)
    if case.last == "soft":
        met = [int(told[0]) + 1 for told in run.told("limit")]
        if not met or met[0] + longest(case) > len(run.places):
            return None
        then = met[0]
    v = speeds_of(case, ways, run)
    return stop_gate.judge(case, v, run.places, then) if v[then - 1] > 0 else None


def try_seed(stand_in, seed):
    """Return how the case of a seed goes; None where nothing moves."""
    return try_case(stand_in, *draw(seed))


def soft_limits(before, place):
    """Return limits of the joint that moved most until a place, which is about to leave them."""
    k = int(np.argmax(np.abs(place - before)))
    low, high = (place[k], 1e6) if place[k] < before[k] else (-1e6, place[k])
    return [f"soft {k} {low:.9f} {high:.9f}"]


def longest(case):
    """Return how many cycles are more than any rest in time takes."""
    bound = case.least_s(stop_gate.V_MAX, case.a) / case.period_s + 2 * stop_gate.PERIODS
    return int(case.most() * bound)


def ending(case):
    """Return the script from the asking on: a rest's longest, twice that where a limit comes later.

    A path that stands between two moves is still, and goes on to the limit.
    """
    if case.last == "soft":
        return [f"run {2 * longest(case) + stop_gate.SETTLES}"]
    goes_on = [f"run {case.patience}", *GOES_ON] if case.goes_on_again() else []
    return [*goes_on, f"still {longest(case)}", f"run {stop_gate.SETTLES}"]


def main():
    """Try the seeds that are asked for."""
    with tempfile.TemporaryDirectory() as folder:
        stand_in = StandIn(folder)
        return stop_gate.search(lambda seed: try_seed(stand_in, seed), 1000)


if __name__ == "__main__":
    sys.exit(main())
