# SPDX-License-Identifier: MIT
"""Judges one nasty case: is it read as it is meant, is its plan finite and near enough to the
program, does its run keep every promise and come to an end, is it no slower than with stops."""

import math

import checker
import numpy as np
from nasty_programs import ARC, DWELL, Turn

from visits import Marks

from pycnc import kernel
from pycnc.report import path_error
from pycnc.errors import NckError
from pycnc.machine import Machine
from pycnc.program import Program

SLOWER = 1.05  # than with exact stops
SLOWER_PERIODS = 4  # and so many periods: of a stop and of the filter
HOLD = 5  # state of a tick
TURN_SHARE = 1e-6  # of sweep and centre of an arc, as printed
RUN_SHARE = 30  # a run takes so many times its plan at most, whatever the operator does …
RUN_STEPS = 300  # … or while prep makes so many steps for a planned period
RUN_PERIODS = 5000
COMPARED = ("line", "kind", "path_mode", "target_nm")


def machine_of(case):
    """Return a case's machine."""
    return Machine.from_text(case.machine, "nasty")


def find(case):
    """Return what is wrong with a case, one line for each thing."""
    found = []
    try:
        machine = machine_of(case)
        text, blocks = case.written()
        program = Program(text.encode(), machine, file="nasty.ngc").check()
        _same(program.blocks, blocks)
        plan = _plan(program, found)
        _run(case, program, blocks, plan, found)
        where = "within tolerances" if (blocks["tolerance_mm"] > 0).any() else "on the exact path"
        _compare(case, machine, (plan["ticks"], where), found)
    except (checker.PhysicsError, NckError) as error:
        found.append(str(error))
    return found


def _hold(good, words):
    if not good:
        raise checker.PhysicsError(words)


def _compare(case, machine, run, found):
    """Nothing is slower than with a stop at the end of every move, given all of the window.

    Arcs apart: within a tolerance their axes keep to their jerk, on the exact path they do not.
    """
    ticks, where = run
    if machine.settings.path.lookahead_blocks or any(isinstance(item, Turn) for item in case.items):
        return
    stopping = Program(case.exact_stops().written()[0].encode(), machine).check()
    stops = _plan(stopping, [])["ticks"]
    if ticks > SLOWER * stops + SLOWER_PERIODS:
        found.append(f"slower {where} than with exact stops: {ticks} ticks, {stops}")


def _same(read, meant):
    """The kernel reads what was written."""
    _hold(len(read) == len(meant), f"read as {len(read)} blocks, not {len(meant)}")
    moves = meant["kind"] <= ARC
    for name in COMPARED:
        _hold((read[name] == meant[name]).all(), f"{name} is read as something else")
    for name in ("feed", "feed_mode", "spindle_rpm"):
        _hold((read[name] == meant[name])[moves].all(), f"{name} is read as something else")
    for name in ("tolerance_mm", "merge_mm"):
        near = np.isclose(read[name], meant[name], rtol=1e-12, atol=0)
        _hold(near[moves].all(), f"{name} is read as something else")
    near = np.isclose(read["sweep_rad"], meant["sweep_rad"], rtol=TURN_SHARE, atol=1e-12)
    _hold(near.all(), "an arc is read as something else")
    dwells = meant["kind"] == DWELL
    _hold((read["dwell_s"] == meant["dwell_s"])[dwells].all(), "a dwell is read as something else")


def _plan(program, found):
    """Return the totals of a plan that is finite; it is near enough to the program, or found."""
    planner = kernel.Planner(program.text, program.machine)
    error = path_error.PathError(program)
    for segs, nodes, cells, _ in planner.pieces():
        error.add_segs(segs)
        moving = segs[segs["kind"] < 3]
        _hold((moving["length"] > 0).all(), "a seg of no length")
        for name, array in (("seg", segs), ("node", nodes), ("cell", cells)):
            _finite(name, array)
    error.finish_segs()
    smoothed = np.where(program.blocks["path_mode"] == 2, program.blocks["tolerance_mm"], 0)
    most = max(float(smoothed.max()) * (1 + checker.SHARE), checker.PATH_ERROR_MM)
    if error.missed > 1 + checker.SHARE:
        found.append(f"the path misses a programmed point by {error.missed:.6g} P")
    elif error.largest_mm > most:
        found.append(f"the path misses the program by {error.largest_mm:.6g} mm")
    totals = planner.totals
    _hold(math.isfinite(totals["time_s"]), "a plan without a time")
    return totals


def _finite(name, array):
    for key in array.dtype.names:
        if array.dtype[key].base.kind == "f":
            _hold(np.isfinite(array[key]).all(), f"a {name} with {key} that is no number")


def _answer(case):
    """Return the ticks in which a hold must have come to rest; None: the checker's own."""
    return math.inf if case.prep_steps < kernel.PREP_STEPS else None


def _run(case, program, blocks, plan, found):
    machine = program.machine
    judge = checker.Checker(
        blocks, machine.record, case.commands, _answer(case), visits=not found,
        late=case.prep_steps < kernel.PREP_STEPS,
    )
    controller = kernel.Simulation(program.text, machine, case.prep_steps, case.commands)
    last = max((tick for tick, *_ in case.commands), default=0)
    share = max(RUN_SHARE, RUN_STEPS / case.prep_steps)
    most = share * int(plan["ticks"]) + last + RUN_PERIODS
    rests = SingleBlock(case.commands, judge.path)
    try:
        for rows, _ in controller.pieces():
            _hold(np.isfinite(rows["pose"]["axis"]).all(), "a setpoint that is no number")
            judge.add(rows)
            rests.add(rows)
            _hold(judge.ticks <= most, f"no end after {judge.ticks} ticks, {plan['ticks']} planned")
        judge.finish()
    except checker.PhysicsError as error:
        found.append(str(error))
        return
    if not case.commands and case.prep_steps == kernel.PREP_STEPS:
        longer = judge.ticks - int(plan["ticks"])
        stops = np.count_nonzero(blocks["kind"] > ARC)
        if not 0 <= longer <= stops:
            found.append(f"{judge.ticks} ticks are run, {plan['ticks']} planned")


class SingleBlock:
    """Where a run rests that nothing but single block holds: at the end of a move, within its
    tolerance."""

    def __init__(self, commands, path):
        names = {name for _, name, *_ in commands}
        self._judged = "single_block" in names and names <= {"single_block", "resume"}
        self._marks, self._before = Marks(path, arc_step=np.inf), None

    def add(self, rows):
        """Judge the rests among the next rows."""
        pose = rows["pose"]
        if not self._judged or not len(rows):
            return
        s = pose["s"]
        still = np.diff(s, prepend=-1.0 if self._before is None else self._before) == 0
        self._before = s[-1]
        at = np.unique(s[still & (pose["state"] == HOLD)], return_index=True)
        held = np.flatnonzero(still & (pose["state"] == HOLD))[at[1]]
        marks = self._marks
        for k in held:
            near = np.flatnonzero((marks.low <= s[k]) & (s[k] <= marks.high))
            apart = np.linalg.norm(marks.point[near] - pose["axis"][k], axis=1)
            allowed = np.maximum(marks.tolerance[near] * (1 + checker.SHARE), checker.PATH_ERROR_MM)
            words = f"single block rests {apart.min(initial=np.inf):.6g} mm from the end of a move"
            _hold((apart <= allowed).any(), f"line {pose['line'][k]}: {words}")
