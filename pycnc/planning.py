# SPDX-License-Identifier: MIT
"""A plan: speeds along the whole path, as the kernel's look-ahead and slope give them."""

import time

import numpy as np

from pycnc import errors, kernel, measure
from pycnc.machine import Machine
from pycnc.program import Program, load
from pycnc.records import dtype

BACKENDS = ("auto", "c")


class BackendError(errors.ArgumentError):
    """A backend that is not there."""


def check_backend(backend):
    """Return the backend that `auto` or a name stands for.

    Raises
    ------
    BackendError
        If it is not one of those that are built.
    """
    if backend not in BACKENDS:
        raise BackendError(
            f"backend {backend!r} is not available; available: {', '.join(BACKENDS)}", id="backend"
        )
    return "c"


def for_machine(program, machine):
    """Return a program for a machine: the same one if that is its machine already."""
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
    segs, nodes, cells : numpy.ndarray
        Of dtypes ``nck_seg_t``, ``nck_node_t``, ``nck_cell_t``; empty if they were not kept.
    """

    def __init__(self, program, *, backend="auto", keep=True, progress=None):
        check_backend(backend)
        self.program = program.check()
        begun, planner = time.perf_counter(), kernel.Planner(program.text, program.machine)
        kept = {name: [np.empty(0, dtype(f"nck_{name}_t"))] for name in ("seg", "node", "cell")}
        for *pieces, used in planner.pieces():
            if keep:
                for arrays, piece in zip(kept.values(), pieces, strict=True):
                    arrays.append(piece.copy())
            if progress:
                progress(used, len(program.text))
        self.segs, self.nodes, self.cells = (np.concatenate(arrays) for arrays in kept.values())
        self.totals = measure.plan_times(planner.totals, program.machine)
        self.time_s = self.totals["time_s"]
        self.plan_s = time.perf_counter() - begun

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
            "plan_s": self.plan_s,
            "diagnostics": self.program.diagnostics.as_list(),
        }

    def __repr__(self):
        return f"<Plan of {self.program.file}: {self.time_s:.3f} s, {len(self.cells):,} cells>"


def plan(program, machine=None, slope="linear", backend="auto"):
    """Plan a whole program.

    Parameters
    ----------
    program : Program, path, str or bytes
        What `load` takes, or a loaded program.
    machine : str, path or Machine, optional
        Another machine than the program's.
    slope : {"linear"}
        Velocity profile: acceleration-limited.
    backend : {"auto", "c"}
        Where it is computed.

    Returns
    -------
    Plan

    Raises
    ------
    ProgramError
        If the program has an error.
    ArgumentError
        If the slope or the backend is not built.

    Examples
    --------
    >>> plan("G21 G90 G1 X10 F600\\nM2\\n").time_s > 1.0
    True
    """
    if slope != "linear":
        raise errors.ArgumentError(
            f"slope {slope!r} is not built yet; available: linear", id="slope"
        )
    return Plan(for_machine(program, machine), backend=backend)
