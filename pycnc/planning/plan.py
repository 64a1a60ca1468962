# SPDX-License-Identifier: MIT
"""A plan: speeds along the whole path, as the kernel's look-ahead and slope give them."""

import time
import typing

import numpy as np

from pycnc import errors, kernel
from pycnc.planning import grades, measure
from pycnc.machine import Machine
from pycnc.machine.schema import Slope
from pycnc.program import Program, load
from pycnc.kernel.records import dtype, join

SLOPES = typing.get_args(Slope)
BACKENDS = {"exact": ("auto", "c"), "grades": grades.BACKENDS}  # of every kind of planning


class BackendError(errors.ArgumentError):
    """A backend that is not there."""


def check_backend(backend, plan="exact"):
    """Refuse a backend or a kind of planning that is not built.

    Raises
    ------
    BackendError
        If planning of that kind does not know the backend.
    ArgumentError
        If there is no such kind.
    """
    if plan not in BACKENDS:
        raise errors.ArgumentError(
            f"no plan {plan!r}; there are: {', '.join(BACKENDS)}", id="plan"
        )
    if backend not in BACKENDS[plan]:
        raise BackendError(
            f"backend {backend!r} is not available; available: {', '.join(BACKENDS[plan])}",
            id="backend",
        )


def for_machine(program, machine, slope=None):
    """Return a program for a machine and a slope: the same one if they are its own already."""
    program = _for_machine(program, machine)
    if slope not in (None, *SLOPES):
        raise errors.ArgumentError(
            f"no slope {slope!r}; there are: {', '.join(SLOPES)}", id="slope"
        )
    if slope is None or slope == program.machine.settings.path.slope:
        return program
    changed = Machine.load(program.machine, set={"path.slope": slope})
    return Program(program.text, changed, file=program.file)


def for_plan(program, plan):
    """Return a program for a kind of planning: grades are as published, accelerations and no
    jerk, the exact path wherever the program says nothing else."""
    path = program.machine.settings.path
    if plan != "grades" or (path.slope, path.tolerance_mm) == ("linear", 0):
        return program
    plain = Machine.load(program.machine, set={"path.slope": "linear", "path.tolerance_mm": 0})
    return Program(program.text, plain, file=program.file)


def _for_machine(program, machine):
    if not isinstance(program, Program):
        return load(program, machine) if machine is not None else load(program)
    if machine is None or machine is program.machine:
        return program
    return Program(program.text, Machine.load(machine), file=program.file)


class Plan:
    """The plan of a whole program.

    Attributes
    ----------
    program : Program
    time_s : float
        Machining time, whole interpolation periods [s].
    totals : dict
        What ``pycnc time --json`` tells: times in s, counts, length in mm, time for each limit.
    plan_s : float
        Wall time that planning took [s].
    kind : str
        ``"exact"``: the exact envelope; ``"grades"``: velocity grades (Cao et al. 2014).
    grades : Grades or None
        The units and grades, if it was planned by them; there are no nodes then.
    exact_time_s : float
        Machining time by the exact envelope [s].
    segs, nodes, cells : numpy.ndarray
        Of dtypes ``nck_seg_t``, ``nck_node_t``, ``nck_cell_t``; empty if they were not kept.

    `look` is called with the segs as they come, kept or not.
    """

    def __init__(self, program, *, plan="exact", backend="auto", keep=True, progress=None,
                 look=None):  # fmt: skip
        check_backend(backend, plan)
        self.program, self.kind, self.grades = for_plan(program.check(), plan), plan, None
        begun = time.perf_counter()
        if plan == "grades":
            totals, exact = self._by_grades(backend, keep, progress)
            if look:
                look(self.segs)
        else:
            totals, exact = self._exactly(keep, progress, look)
        self.totals = measure.plan_times(totals, program.machine)
        self.time_s, self.exact_time_s = self.totals["time_s"], float(exact["time_s"])
        self.plan_s = time.perf_counter() - begun

    def _by_grades(self, backend, keep, progress):
        text, machine = self.program.text, self.program.machine
        self.grades, exact = grades.of_text(text, machine, backend=backend, progress=progress)
        self.segs = self.grades.segs
        self.nodes = np.empty(0, dtype("nck_node_t"))
        self.cells = self.grades.cells() if keep else np.empty(0, dtype("nck_cell_t"))
        totals = self.grades.totals
        totals["blocks"] = exact["blocks"]
        return totals, exact

    def _exactly(self, keep, progress, look):
        program = self.program
        planner = kernel.Planner(program.text, program.machine)
        kept = {"nck_seg_t": [], "nck_node_t": [], "nck_cell_t": []}
        for *pieces, used in planner.pieces():
            if keep:
                for arrays, piece in zip(kept.values(), pieces, strict=True):
                    arrays.append(piece.copy())
            if look:
                look(pieces[0])
            if progress:
                progress(used, len(program.text))
        self.segs, self.nodes, self.cells = (join(*record) for record in kept.items())
        return planner.totals, planner.totals

    def as_dict(self):
        """Return what ``pycnc time --json`` tells."""
        machine = self.program.machine
        return {
            "file": self.program.file,
            "machine": machine.name,
            "version": kernel.version(),
            "period_s": machine.period_s,
            **self.totals,
            "slope": machine.settings.path.slope,
            "plan": self.kind,
            "backend": self.grades.backend if self.grades else "c",
            "plan_s": self.plan_s,
            "diagnostics": self.program.diagnostics.as_list(),
        }

    def __repr__(self):
        return f"<Plan of {self.program.file}: {self.time_s:.3f} s, {len(self.cells):,} cells>"


def plan(program, machine=None, slope=None, backend="auto", plan="exact"):
    """Plan a whole program.

    Parameters
    ----------
    program : Program, path, str or bytes
        What `load` takes, or a loaded program.
    machine : str, path or Machine, optional
        Another machine than the program's.
    slope : {"linear", "jerk", "sshape"}, optional
        Another velocity profile than the machine's (``path.slope``).
    backend : {"auto", "c", "opencl"}
        Where it is computed; OpenCL plans by grades only.
    plan : {"exact", "grades"}
        By the exact envelope, or by velocity grades (Cao et al. 2014): these under the linear
        slope and without the machine's tolerance.

    Returns
    -------
    Plan

    Raises
    ------
    ProgramError
        If the program has an error.
    ArgumentError
        If there is no such slope, backend or kind of planning.

    Examples
    --------
    >>> plan("G21 G90 G1 X10 F600\\nM2\\n").time_s > 1.0
    True
    """
    return Plan(for_machine(program, machine, slope), plan=plan, backend=backend)
