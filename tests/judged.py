# SPDX-License-Identifier: MIT
"""Run a program through pycnc once and keep what the tests of physics need to know of it."""

import hashlib
from dataclasses import dataclass

import checker
import numpy as np

from pycnc import kernel
from pycnc.report import path_error
from pycnc.machine import Machine
from pycnc.planning import whole
from pycnc.program import Program


@dataclass
class Run:
    """What a run was like."""

    program: Program
    ticks: int
    starved_ticks: int
    digest: str
    judge: checker.Checker


LINEAR_EXACT = ("path.slope=linear", "path.tolerance_mm=0")


def load(case, change=()):
    """Return the decoded program of a case or of a file of the corpus."""
    machine = Machine.load(case.machine, set=(*change, *case.set))
    text = case.path.read_bytes() if hasattr(case, "path") else case.text.encode()
    return Program(text, machine, file=str(case))


def load_exact(case):
    """Return a program under the linear slope, on the exact path wherever it gives no tolerance."""
    return load(case, LINEAR_EXACT)


def rows_of(program, prep_steps=kernel.PREP_STEPS, commands=()):
    """Return all rows of a run in one array; for short programs."""
    controller = kernel.Simulation(program.text, program.machine, prep_steps, commands)
    return np.concatenate([rows.copy() for rows, _ in controller.pieces()])


def digest_of(program, prep_steps=kernel.PREP_STEPS):
    """Return a hash of every byte of a run."""
    controller = kernel.Simulation(program.text, program.machine, prep_steps)
    digest = hashlib.blake2b()
    for rows, _ in controller.pieces():
        digest.update(rows.tobytes())
    return digest.hexdigest()


def run(program, prep_steps=kernel.PREP_STEPS, commands=(), answer=None):
    """Run a program under the checker's eyes.

    Raises
    ------
    checker.PhysicsError
        At the first promise that the run breaks.
    """
    late = prep_steps < kernel.PREP_STEPS
    judge = checker.Checker(program.blocks, program.machine.record, commands, answer, late=late)
    controller = kernel.Simulation(program.text, program.machine, prep_steps, commands)
    digest = hashlib.blake2b()
    for rows, _ in controller.pieces():
        judge.add(rows)
        digest.update(rows.tobytes())
    judge.finish()
    missed = missed_by(program)
    if missed > 1 + checker.SHARE:
        raise checker.PhysicsError(f"the path misses a programmed point by {missed} P")
    return Run(program, judge.ticks, controller.starved_ticks, digest.hexdigest(), judge)


def run_whole(program, motion):
    """Run a motion that the host has planned whole under the checker's eyes; its totals hold.

    Raises
    ------
    checker.PhysicsError
        At the first promise that the run breaks.
    """
    judge = checker.Checker(program.blocks, program.machine.record)
    simulation = whole.Simulation(motion)
    for rows, _ in simulation.pieces():
        judge.add(rows)
    judge.finish()
    if simulation.starved_ticks or judge.ticks != motion.totals["ticks"] * (len(motion.segs) > 0):
        raise checker.PhysicsError(f"{judge.ticks} ticks, starved {simulation.starved_ticks}")
    missed = missed_by(program)
    if missed > 1 + checker.SHARE:
        raise checker.PhysicsError(f"the path misses a programmed point by {missed} P")
    return judge


def missed_by(program):
    """Return how far the path misses a point of a program at most, in shares of its tolerance."""
    error = path_error.PathError(program)
    for segs, _ in kernel.Planner(program.text, program.machine, records=("seg",)).pieces():
        error.add_segs(segs)
    error.finish_segs()
    return error.missed


def plan(program):
    """Return (totals, segs, nodes, cells) of a whole program."""
    planner = kernel.Planner(program.text, program.machine)
    pieces = [[array.copy() for array in arrays] for *arrays, _ in planner.pieces()]
    return planner.totals, *(np.concatenate(each) for each in zip(*pieces, strict=True))


def judge(program, rows):
    """Ask the checker about rows at hand, in pieces; raises PhysicsError."""
    judge = checker.Checker(program.blocks, program.machine.record)
    for piece in np.array_split(rows, 7):
        judge.add(piece)
    judge.finish()


def rounded(rows):
    """Make the joints of spoilt poses fit."""
    rows["axes"]["joint_nm"][:, :3] = np.round(rows["pose"]["axis"][:, :3] * 1e6)
    return rows


def retimed(rows):
    """Number the periods of spoilt rows anew."""
    rows["t_s"] = np.arange(1, len(rows) + 1) * 1e-3
    return rows
