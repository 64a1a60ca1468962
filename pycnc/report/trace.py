# SPDX-License-Identifier: MIT
"""A trace: a run of a program in the simulation, one row a tick."""

import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from pycnc import errors, kernel
from pycnc.planning import control, measure, stretches, whole
from pycnc.report.path_error import PathError
from pycnc.planning.plan import BY, Plan, check_backend, for_machine, for_plan
from pycnc.report.rows import Rows
from pycnc.report.trace_file import Columns, writer
from pycnc.names import SCHEMA
from pycnc.program import shown


class _Stopped(BaseException):
    """The run has been broken off, and so is its plan."""


class Trace(Rows):
    """A run of a program in the simulation.

    Attributes
    ----------
    program : Program
    plan : Plan
        The same program's plan, without its arrays.
    columns : dict
        Column → array, one row a tick; empty if rows were not kept. ``trace["t_s"]`` is the same.
    summary : dict
        What ``pycnc run --json`` tells.
    worst_lines : dict
        Limit → [(source line, time in s)], the lines that it held longest.
    """

    def __init__(self, program, *, prep_steps=kernel.PREP_STEPS, keep=True, output=None,
                 plan="exact", backend="auto", commands=(), progress=None):  # fmt: skip
        check_backend(backend, plan)
        begun = time.perf_counter()
        self.program = program = for_plan(program.check(), plan)
        self._is_foreign = plan == "exact" and control.is_foreign(program.machine)
        self._layout = Columns(program.machine)
        sink = writer(output, self._layout, self.metadata()) if output is not None else None
        try:
            self._path_error = PathError(program)
            if plan == "exact":
                simulation = stretches.simulation(program, prep_steps, commands)
                self._run_beside_plan(simulation, keep, sink, progress)
            else:
                self._refuse(commands, plan)
                self._make_plan(plan, backend)
                simulation = whole.Simulation(self.plan.motion, prep_steps)
                self._run(simulation, keep, sink, progress)
            self._tell_limits(commands)
            if sink:
                sink.close()
        except BaseException:
            if sink:
                sink.discard()
            raise
        self.summary = self._summary(time.perf_counter() - begun)

    def _make_plan(self, plan="exact", backend="auto", progress=None):
        look = self._path_error.add_segs
        self.plan = Plan(
            self.program, plan=plan, backend=backend, keep=False, look=look, progress=progress
        )
        if not self._is_foreign:  # else there are no segs
            self._path_error.finish_segs()

    def _run_beside_plan(self, *run):
        """Plan on a second thread while the simulation runs: neither needs the other."""
        stop = threading.Event()

        def heed(used, size):
            if stop.is_set():
                raise _Stopped

        with ThreadPoolExecutor(1) as beside:
            planned = beside.submit(self._make_plan, progress=heed)
            try:
                self._run(*run)
                planned.result()
            except Exception:
                planned.result()  # what planning finds wrong is told first
                raise
            except BaseException:
                stop.set()
                raise

    def _run(self, controller, keep, sink, progress):
        program, machine = self.program, self.program.machine
        self._peaks, self._ticks = measure.Peaks(machine), measure.Ticks(machine)
        kept = []
        for rows, used in controller.pieces():
            for measured in (self._peaks, self._ticks, self._path_error):
                measured.add(rows)
            if keep or sink:
                columns = self._layout.of(rows)
                if sink:
                    sink.write(columns)
                if keep:
                    kept.append(columns)
            if progress:
                progress(used, len(program.text))
        self._starved_ticks, self._end = controller.starved_ticks, controller.end
        self.columns = {
            name: np.concatenate([columns[name] for columns in kept])
            for name in self._layout.units
            if kept
        }

    def _tell_limits(self, commands):
        """Say what held the path: as the plan does, if the run was as planned.

        A tick knows no low point that its ramp serves. Where an operator or late preparation made
        other ramps than the plan's, they stay what the ticks call them: ``accel`` and ``jerk``.
        """
        self.worst_lines, self._limit_time_s = self._ticks.worst_lines(), self._ticks.limit_time_s()
        self.as_planned = not (commands or self._starved_ticks or self.plan.lost is None)
        if not self.as_planned:
            return
        self._limit_time_s = dict(self.plan.totals["limit_time_s"])
        at_rest = self._time_s - self.plan.time_s  # few prep steps: no plan behind a WAIT
        self._limit_time_s["wait" if self._limit_time_s["wait"] else "starved"] += at_rest
        self.worst_lines |= measure.worst_lines(self.plan.lost["causes"], self.program.machine)

    def _refuse(self, commands, plan):
        if commands:
            raise errors.ArgumentError(
                f"a plan {BY[plan]} takes no commands: it is made whole before the run, and only "
                'the kernel\'s own (plan="exact") makes another on the way', id="command",
            )  # fmt: skip

    @property
    def _time_s(self):
        """Whole periods; of another control, which rests at no tick of ours, the plan's."""
        return self.plan.time_s if self._is_foreign else self._ticks.time_s

    def _summary(self, run_s):
        plan = self.plan.as_dict()
        diagnostics = plan.pop("diagnostics")
        return {
            **plan,
            "time_s": self._time_s,
            "total_s": self._time_s + plan["tool_change_s"] + plan["spindle_s"],
            "ticks": self._ticks.count,
            "length_mm": self._ticks.length_mm,
            "run_s": run_s,
            "peaks": self._peaks.result(),
            "path_error_mm": self._path_error.largest_mm,
            "starved_ticks": int(self._starved_ticks),
            "end": self._end,
            "limit_time_s": self._limit_time_s,
            "diagnostics": diagnostics,
        }

    def metadata(self):
        """Return what is written into every trace file beside the rows."""
        machine = self.program.machine
        return {
            "version": kernel.version(),
            "schema_version": SCHEMA,
            "file": self.program.file,
            "program_sha256": self.program.sha256,
            "machine": machine.name,
            "machine_sha256": machine.sha256,
            "dialect": machine.settings.dialect.base,
            "period_s": machine.period_s,
            "control": machine.settings.control.kind,
        }

    def __len__(self):
        return self._ticks.count

    def names(self):
        """Return column of codes → {code: name}."""
        return self._layout.names

    def _shape(self):
        return self._layout

    def plot(self, path=None):
        """Draw the path coloured by speed, and speed and acceleration over time.

        Parameters
        ----------
        path : path, optional
            Where to write a picture.

        Returns
        -------
        matplotlib.figure.Figure
        """
        from pycnc.report import plot

        figure = plot.draw(self)
        if path is not None:
            figure.savefig(path)
        return figure

    def __repr__(self):
        time_s, ticks, end = (self.summary[name] for name in ("time_s", "ticks", "end"))
        early = "" if end == "done" else f", ended by {end}"
        return f"<Trace of {self.program.file}: {time_s:.3f} s, {ticks:,} ticks{early}>"

    def _facts(self):
        yield "file", self.program.file
        yield "machine", f"{self.program.machine.name}, {control.title(self.program.machine)}"
        for name in ("time_s", "ticks", "starved_ticks", "end", "path_error_mm"):
            value = self.summary[name]
            yield name, f"{value:.6g}" if isinstance(value, float) else str(value)
        for axis, peak in self.summary["peaks"].items():
            told = ", ".join(f"{kind} {ratio:.1%}" for kind, ratio in peak.items())
            yield f"peaks of {axis.upper() if axis != 'path' else axis}, of the limit", told

    def _repr_html_(self):
        return shown.facts_table(self._facts())


def run(program, machine=None, *, slope=None, prep_steps=kernel.PREP_STEPS, commands=(),
        backend="auto", plan="exact"):  # fmt: skip
    """Run a whole program in the simulation, tick by tick.

    Parameters
    ----------
    program : Program, path, str or bytes
        What `load` takes, or a loaded program.
    machine : str, path or Machine, optional
        Another machine than the program's.
    slope : {"linear", "jerk", "optimal"}, optional
        Another velocity profile than the machine's (``path.slope``).
    prep_steps : int
        Prep steps between two ticks, 1 at least; few of them starve the tick.
    commands : iterable of tuple
        What the operator does: (tick, name, numbers…), behind the setpoint of that tick, 0 being
        before the first. Names: "hold", "resume", "override" (feed 0 … 200 %, and rapids
        0 … 100 %, which are 100 unless told), "single_block" (1 or 0), "abort". The run ends at
        rest where no command is left to go on; ``summary["end"]`` says how: "done", "hold",
        "single_block", "override" (of 0) or "aborted".
    backend : {"auto", "c", "opencl"}
        Where it is computed; OpenCL plans by grades only.
    plan : {"exact", "grades"}
        By the exact envelope, or by velocity grades (Cao et al. 2014), which report the peaks of
        acceleration and do not promise them, under the linear slope and without the machine's
        tolerance.

    Returns
    -------
    Trace
        With all rows in memory, about 200 bytes a tick.

    Raises
    ------
    ProgramError
        If the program has an error: nothing is run then.
    ArgumentError
        If there is no such slope, command, backend or kind of planning.
    InternalError
        If the run stands still although nobody holds it: a defect.

    Examples
    --------
    >>> trace = run("G21 G90 G1 X10 F600\\nM2\\n")
    >>> float(trace["pos_x_mm"][-1])
    10.0
    """
    program = for_machine(program, machine, slope)
    return Trace(
        program, prep_steps=prep_steps, commands=tuple(commands), backend=backend, plan=plan
    )
