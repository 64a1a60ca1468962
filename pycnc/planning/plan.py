# SPDX-License-Identifier: MIT
"""A plan: speeds along the whole path, as the kernel's look-ahead and slope give them."""

import time

import numpy as np

from pycnc import errors, kernel
from pycnc.planning import control, measure, pipeline, shares
from pycnc.machine import Machine
from pycnc.machine.schema import SLOPES
from pycnc.program import Program, load, shown
from pycnc.names import SCHEMA
from pycnc.kernel.records import copied, dtype, join

RECORDS = ("segs", "nodes", "cells")
_KEPT = ("seg", "node", "cell")
_CELLS_AT_ONCE = 1 << 20  # 56 MB: a plan has a cell for every two periods of its time
# Of every kind of planning.
BACKENDS = {
    "exact": ("auto", "c"), "grades": ("auto", "c", "opencl"), "sshape": ("auto", "c"),
}  # fmt: skip
# The slope under which the kernel makes the path and caps of the kinds that are not its own.
_SLOPE_OF = {"grades": "linear", "sshape": "jerk"}
BY = {"exact": "", "grades": "by grades", "sshape": "by the S-shape"}  # for people


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
        raise errors.BackendError(
            f"backend {backend!r} is not available; available: {', '.join(BACKENDS[plan])}",
            id="backend",
        )


def for_machine(program, machine, slope=None):
    """Return a program for a machine and a slope: the same one if they are its own already."""
    program = _for_machine(program, machine)
    if slope not in (None, *SLOPES):
        moved = ": the S-shape is a kind of planning, plan='sshape'" if slope == "sshape" else ""
        raise errors.ArgumentError(
            f"no slope {slope!r}; there are: {', '.join(SLOPES)}{moved}", id="slope"
        )
    if slope is None or slope == program.machine.settings.path.slope:
        return program
    changed = Machine.load(program.machine, set={"path.slope": slope})
    return Program(program.text, changed, file=program.file)


def for_plan(program, plan):
    """Return a program for a kind of planning: what is not the kernel's is as published, on the
    exact path wherever the program says nothing else; grades limit acceleration and no jerk."""
    path = program.machine.settings.path
    if plan not in _SLOPE_OF or (path.slope, path.tolerance_mm) == (_SLOPE_OF[plan], 0):
        return program
    changes = {"path.slope": _SLOPE_OF[plan], "path.tolerance_mm": 0}
    plain = Machine.load(program.machine, set=changes)
    return Program(program.text, plain, file=program.file)


def _for_machine(program, machine):
    if not isinstance(program, Program):
        return load(program, machine) if machine is not None else load(program)
    if machine is None or machine is program.machine:
        return program
    return Program(program.text, Machine.load(machine), file=program.file)


def _records(keep, look, trail):
    """Return the kinds of records that a planner hands out."""
    kinds = _KEPT if keep else _KEPT[:1] if look else ()
    return kinds + (("host_point", "host_foot") if trail else ())


def _keep(kept, pieces, cells):
    """Add pieces to what is kept, of cells so many alone; return how many cells there were."""
    cells += len(pieces[2])
    few = len(kept) if cells <= _CELLS_AT_ONCE else len(kept) - 1
    for arrays, piece in zip(list(kept.values())[:few], pieces, strict=False):
        arrays.append(copied(piece))
    return cells


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
        ``"exact"``: by the machine's slope; ``"grades"``: velocity grades, ``"sshape"``: the
        classical S-shape (both Cao et al. 2014).
    motion : Grades, SShape or None
        Units and grades, or hops and speeds, if it was planned by those.
    exact_time_s : float
        Machining time by the kernel's own plan [s].
    segs, nodes, cells : numpy.ndarray
        Of dtypes ``nck_seg_t``, ``nck_node_t``, ``nck_cell_t``; empty if they were not kept. A
        million cells and more are planned again when they are first asked for.

    parts : list of dict or None
        Where the time goes, if it was asked for, the longest first: see `shares.table`.
    lost : dict or None
        What it is lost to, as `kernel.Planner.why` has it; None but of an exact plan.

    `look` is called with the segs as they come, kept or not, of which another control has none;
    `trail` with the points and the low points of the path (``nck_host_point_t``,
    ``nck_host_foot_t``), of an exact plan; `by` is "tool", "section" or "line"; `override` is that
    of the feed where another control plans; `beside` is the `Pipeline` that has planned the program
    while it was read. Without all of these, and `keep`, the rooms of a big program work side by
    side.
    """

    def __init__(self, program, *, plan="exact", backend="auto", keep=True, progress=None,
                 look=None, trail=None, by=None, beside=None, override=1.0):  # fmt: skip
        check_backend(backend, plan)
        if by is not None and plan != "exact":
            raise errors.ArgumentError(f"a plan {BY[plan]} is not told by parts", id="by")
        self.program, self.kind, self.motion = for_plan(program.check(), plan), plan, None
        self.parts = self.lost = None
        self._override = override
        begun = beside.begun if beside else time.perf_counter()
        if plan == "exact":
            totals = exact = self._exactly(keep, progress, look, trail, by, beside)
        else:
            totals, exact = self._whole(backend, keep, progress)
            if look:
                look(self.segs)
        self.totals = measure.plan_times(totals, program.machine)
        self.time_s, self.exact_time_s = self.totals["time_s"], float(exact["time_s"])
        self.plan_s = time.perf_counter() - begun

    @property
    def grades(self):
        """The motion, if it is by grades; there are no nodes then."""
        return self.motion if self.kind == "grades" else None

    def _whole(self, backend, keep, progress):
        """Plan all of it at once, as the kernel does not."""
        from pycnc.planning import grades, sshape

        text, machine = self.program.text, self.program.machine
        given = {"threads": self.program.has_threads, "progress": progress}
        if self.kind == "grades":
            self.motion, exact = grades.of_text(text, machine, backend=backend, **given)
        else:
            self.motion, exact = sshape.of_text(text, machine, **given)
        self.segs = self.motion.segs
        self.nodes = self.motion.nodes
        self._cells = self.motion.cells() if keep else np.empty(0, dtype("nck_cell_t"))
        totals = self.motion.totals
        for name in ("blocks", "tool_changes", "spindle_starts"):
            totals[name] = exact[name]
        return totals, exact

    def _as_control(self, progress, trail, by):
        """Plan it by another control's rules, which keep no records."""
        asked, names = shares.ask(self.program, by) if by else (None, [])
        planner = control.Planner(self.program, asked, self._override, trail is not None)
        for stretches, feet in planner.pieces(progress):
            if trail:
                trail(stretches["end"], feet)
        self.parts = shares.table(self.program, by, planner.shares, names) if by else None
        return planner

    def _exactly(self, keep, progress, look, trail, by, beside):
        planner = None
        if control.is_foreign(self.program.machine):
            planner = self._as_control(progress, trail, by)
        elif not (keep or look or trail or by):
            planner = self._side_by_side(progress, beside)
        if planner is None:
            planner = self._on_one_core(keep, progress, look, trail, by)
        else:
            self.segs, self.nodes, self._cells = (join(f"nck_{name}_t", []) for name in _KEPT)
        self.lost = planner.why
        return planner.totals

    def _side_by_side(self, progress, before):
        """Return the planner of all of it, if it is big and there is more than one core.

        before: the pipeline that planned what was read so far; None without one.
        """
        program, done = self.program, 0
        planner = before.end() if before else None
        if planner is not None or (before and not before.is_left):
            return planner
        if not pipeline.is_worth(program):
            return None
        with pipeline.Pipeline() as beside:
            for blocks in program.pieces(beside.another):
                beside.take(program.machine, blocks)
                done += len(blocks)
                if progress:
                    progress(done, program.block_count)
            return beside.end()

    def _on_one_core(self, keep, progress, look, trail, by):
        program = self.program
        asked, names = shares.ask(program, by) if by else (None, [])
        planner = kernel.Planner(
            program.text, program.machine, _records(keep, look, trail), shares=asked,
            threads=program.has_threads,
        )  # fmt: skip
        kept = {"nck_seg_t": [], "nck_node_t": [], "nck_cell_t": []}
        cells = 0
        for *pieces, used in planner.pieces():
            if keep:
                cells = _keep(kept, pieces, cells)
            if trail:
                trail(*pieces[-2:])
            if look:
                look(pieces[0])
            if progress:
                progress(used, len(program.text))
        if cells > _CELLS_AT_ONCE:
            kept["nck_cell_t"].clear()
        self.segs, self.nodes, some = (join(*record) for record in kept.items())
        self._cells, self._later = (None, cells) if cells > _CELLS_AT_ONCE else (some, 0)
        self.parts = shares.table(program, by, planner.shares, names) if by else None
        return planner

    @property
    def cells(self):
        """The cells; many are planned again, when they are first asked for."""
        if self._cells is None:
            planner = kernel.Planner(self.program.text, self.program.machine, ("cell",))
            self._cells = join("nck_cell_t", [copied(piece) for piece, _ in planner.pieces()])
        return self._cells

    @property
    def _counts(self):
        """How many records of each kind there are to be had."""
        cells = self._later if self._cells is None else len(self._cells)
        return {"segs": len(self.segs), "nodes": len(self.nodes), "cells": cells}

    def as_dict(self):
        """Return what ``pycnc time --json`` tells."""
        machine = self.program.machine
        return {
            "file": self.program.file,
            "machine": machine.name,
            "version": kernel.version(),
            "schema_version": SCHEMA,
            "period_s": machine.period_s,
            **self.totals,
            "slope": machine.settings.path.slope,
            "control": machine.settings.control.kind,
            "plan": self.kind,
            "backend": self.motion.backend if self.motion else "c",
            "plan_s": self.plan_s,
            **({} if self.parts is None else {"parts": self.parts}),
            "diagnostics": self.program.diagnostics.as_list(),
        }

    def why(self):
        """Return what the time goes to, a `Why`."""
        from pycnc.planning.why import Why

        return Why(self)

    def to_pandas(self, records="nodes"):
        """Return records as a pandas.DataFrame (needs pandas), codes by their names.

        Parameters
        ----------
        records : {"segs", "nodes", "cells"}
            What has a value for each axis is a column for each of the machine's.
        """
        return self._table("pandas", records)

    def to_polars(self, records="nodes"):
        """Return records as a polars.DataFrame (needs polars), as `to_pandas` does."""
        return self._table("polars", records)

    def to_arrow(self, records="nodes"):
        """Return records as a pyarrow.Table (needs pyarrow), as `to_pandas` does."""
        return self._table("arrow", records)

    def _table(self, kind, records):
        if records not in RECORDS:
            raise errors.ArgumentError(
                f"no records {records!r}; there are: {', '.join(RECORDS)}", id="records"
            )
        machine = self.program.machine
        rows = getattr(self, records)
        columns, names = shown.columns_of(rows, machine, measure.limit_names(machine))
        return shown.frame(columns, names, kind)

    def _facts(self):
        totals, machine = self.totals, self.program.machine
        yield "file", self.program.file
        yield "machine", f"{machine.name}, {control.title(machine)}"
        for name in ("total", "time", "cut", "rapid", "dwell", "tool_change", "spindle"):
            yield f"{name.replace('_', ' ')} [s]", f"{totals[f'{name}_s']:.3f}"
        held = sorted(totals["limit_time_s"].items(), key=lambda item: -item[1])
        yield "held by", ", ".join(f"{name} {time:.3f} s" for name, time in held[:3] if time > 0)
        for name, count in self._counts.items():
            yield name, f"{count:,}"

    def __repr__(self):
        cells = self._counts["cells"]
        return f"<Plan of {self.program.file}: {self.time_s:.3f} s, {cells:,} cells>"

    def _repr_html_(self):
        return shown.facts_table(self._facts())


def plan(program, machine=None, slope=None, backend="auto", plan="exact"):
    """Plan a whole program.

    Parameters
    ----------
    program : Program, path, str or bytes
        What `load` takes, or a loaded program.
    machine : str, path or Machine, optional
        Another machine than the program's.
    slope : {"linear", "jerk", "optimal"}, optional
        Another velocity profile than the machine's (``path.slope``).
    backend : {"auto", "c", "opencl"}
        Where it is computed; OpenCL plans by grades only.
    plan : {"exact", "grades", "sshape"}
        By the machine's slope; or as Cao et al. 2014, without the machine's tolerance: by velocity
        grades, under the linear slope, or by the classical S-shape, acceleration zero at every
        junction, under the limits of the slope jerk.

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


def why(program, machine=None, slope=None, *, what_if=False):
    """Tell what the time of a whole program goes to.

    Parameters
    ----------
    program : Program, path, str or bytes
        What `load` takes, or a loaded program.
    machine : str, path or Machine, optional
        Another machine than the program's.
    slope : {"linear", "jerk", "optimal"}, optional
        Another velocity profile than the machine's.
    what_if : bool or list of str
        Plan it again with each cure, or with each of these changes: ``["control.kind=nck"]``.

    Returns
    -------
    Why

    Raises
    ------
    ProgramError
        If the program has an error.

    Examples
    --------
    >>> found = why("G21 G90 G61 G1 X10 F6000\\nY10\\nM2\\n")
    >>> found.time_s > found.ideal_s
    True
    """
    found = Plan(for_machine(program, machine, slope), keep=False).why()
    if what_if:
        cures = what_if is True
        found.what_if(changes=() if cures else what_if, cures=cures)
    return found
