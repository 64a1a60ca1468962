# SPDX-License-Identifier: MIT
"""The cases of tests/stop_gate.py on Cortex-M7 and Cortex-M4F under QEMU: the controller of
firmware_sim, its tasks and as many instructions as it has. Bound and judging are that gate's.

    .venv/bin/python tests/controller/firmware_stops.py 1000          so many seeds from 0 on
    .venv/bin/python tests/controller/firmware_stops.py 1 700 -v      one case, whatever it does

Seeds that are even have an M7, the others an M4F. Where prep is to die, its task or the supervisor
keeps the processor from then on, or prep's stack is broken. What the controller does not offer is
left out: shares of a percent, a cap of the tool's speed. The same case in the host simulation says
when it moves, and how fast its path is when the rest is asked for.
"""

import sys
from dataclasses import replace
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))

import numpy as np
import stop_gate

from pycnc import controller, kernel

GRAIN_MM = 1e-6  # of the setpoints
STILL = 16  # ticks without a step of the drives that are a rest
SUPERVISOR, PREP, EVER = 1, 5, 2**32 - 1  # priorities of tasks; units of the clock: minutes
DEATHS = {
    "prep": ("task_work", PREP, EVER), "supervisor": ("task_work", SUPERVISOR, EVER),
    "stack": ("stack_work", PREP),
}  # fmt: skip
INSTRUCTIONS_NS = {"m7": (4, 8), "m4f": (8,)}
NOT_OFFERED = ("speed",)


def draw(seed):
    """Return the case of a seed, what an instruction takes [ns], and how prep dies, "" if not."""
    case = stop_gate.draw(seed)
    rng = np.random.default_rng([seed, 2613])
    core = ("m7", "m4f")[seed % 2]
    first = "none" if case.first in NOT_OFFERED else case.first
    value = max(1, round(100 * case.value)) / 100
    took, death = int(rng.choice(INSTRUCTIONS_NS[core])), str(rng.choice(list(DEATHS)))
    dies = case.dead and case.last != "travel"
    where = f"{core} {took} ns{f' {death}' if dies else ''}"
    return replace(case, first=first, value=value, where=where), took, death if dies else ""


def firsts(case, at, then):
    """Return the commands of what the operator does first."""
    percent = round(100 * case.value)
    middle = at + (then - at) // 2
    everything = (middle, "override", 100, 100)
    return {
        "none": [], "override": [(at, "override", percent, 100)],
        "up": [(at, "override", percent, 100), everything],
        "rapid": [(at, "override", 100, min(percent, 100))],
        "hold": [(at, "hold"), (middle, "resume")], "resume": [(at, "resume")],
        "single_block": [(at, "single_block", 1)],
    }[case.first]  # fmt: skip


def lasts(case, then, death, box):
    """Return the commands that ask for rest, and let go on."""
    asked = [(then, case.last)] if case.last in ("hold", "abort") else [(then, "override", 0, 0)]
    if box:
        free = np.iinfo(np.int64).min
        asked = [(then, "travel", k, *side) for k, side in enumerate(box) if side[0] != free]
    again = then + case.patience
    goes_on = [(again, "override", 100, 100), (again, "single_block", 0), (again, "resume")]
    harm = [(then, *DEATHS[death])] if death else []
    return [*asked, *harm, *(goes_on if case.goes_on_again() else [])]


def speeds_of(case, twin, joints):
    """Return the speed in each tick, 0 in a rest: the path's of a twin, or the tool's."""
    step = np.linalg.norm(np.diff(joints, axis=0, prepend=np.zeros((1, 3))), axis=1)
    still = np.append(step == 0, np.ones(STILL, bool))
    rests = np.lib.stride_tricks.sliding_window_view(still, STILL).all(axis=1)[: len(step)]
    rests |= np.append(False, rests[:-1]) & (step == 0)
    v = np.where(rests, 0.0, np.maximum(step, GRAIN_MM) / case.period_s)
    known = min(len(twin), len(v))
    v[:known] = np.where(v[:known] > 0, np.maximum(v[:known], twin[:known]), 0.0)
    return v


def run_until(case, took, commands, end):
    """Return the positions of the tool at every tick until a tick [mm], where all is switched
    off."""
    steps = 0 if case.prep_steps == kernel.PREP_STEPS else case.prep_steps
    outcome = controller.open(case.where.split()[0]).run(
        case.text, case.machine(), [*commands, (end, "estop")], trace=True,
        instruction_ns=took, prep_steps=steps,
    )  # fmt: skip
    return outcome.rows["joint_nm"][:end] * GRAIN_MM


def try_case(case, took, death):
    """Return how it goes; None where nothing moves when the rest is asked for.

    A controller that starves is elsewhere than its twin, and may be faster: then it is run once
    more, for as long as its own speed asks for.
    """
    drawn = stop_gate.moments(case)
    if drawn is None:
        return None
    then, twin, box = drawn.then, drawn.run.poses()["v"], drawn.box
    again = case.patience if case.goes_on_again() else 0
    commands = [*firsts(case, drawn.at, then), *lasts(case, then, death, box)]

    def end_by(v, joints):
        bound_s = stop_gate.bound_of(case, v, joints, then)
        longest = int(case.most() * bound_s / case.period_s)
        return then + again + (stop_gate.RESTS if box else longest + 2 * STILL)

    end, v, joints = 0, twin, drawn.run.poses()["axis"][:, :3]
    while end < end_by(v, joints):
        end = end_by(v, joints)
        joints = run_until(case, took, commands, end)
        v = speeds_of(case, twin, joints)
        if len(v) <= then or not v[then - 1] > 0:
            return None
    return stop_gate.judge(case, v, joints, then, box, GRAIN_MM)


def try_seed(seed):
    """Return how the case of a seed goes; None where nothing moves."""
    return try_case(*draw(seed))


if __name__ == "__main__":
    sys.exit(stop_gate.search(try_seed, 1000))
