# SPDX-License-Identifier: MIT
"""A trace: one row per tick of a run, and its files (npz, csv, parquet), written in pieces."""

import errno
import json
import os
import shutil
import tempfile
import time
import zipfile
from pathlib import Path

import numpy as np

from pycnc import errors, kernel
from pycnc.planning import grades, measure
from pycnc.extras import need
from pycnc.machine.schema import AXES, position_key, unit_of
from pycnc.planning.measure import KINDS
from pycnc.report.path_error import PathError
from pycnc.planning.plan import Plan, check_backend, for_machine, for_plan
from pycnc.kernel.records import enum

FORMATS = (".npz", ".csv", ".parquet")
_JOINT_UNITS = {"mm": "nm", "deg": "ndeg"}
_SEG_KINDS = enum("nck_seg_kind_t")
_STATES = enum("nck_tick_state_t")


class Columns:
    """The columns of a machine's trace.

    Attributes
    ----------
    units : dict
        Column → unit, in column order.
    names : dict
        Column of codes → {code: name}.
    """

    def __init__(self, machine):
        self._axes = machine.axes
        self._period = machine.period_s
        self.units = {"t_s": "s", "line": "", "block": "", "kind": "", "s_mm": "mm"}
        self.units |= {f"pos_{position_key(letter)}": unit_of(letter) for letter in self._axes}
        self.units |= {f"joint_{k}_nm": _JOINT_UNITS[unit_of(a)] for k, a in enumerate(self._axes)}
        self.units |= {"vel_mm_s": "mm/s", "feed_cmd_mm_min": "mm/min", "override": ""}
        self.units |= {"limit": "", "queue_cells": "", "spindle_rpm": "1/min"}
        self.names = {
            "kind": dict(enumerate(KINDS)),
            "limit": measure.limit_names(machine),
        }

    def of(self, rows):
        """Return column → array for rows of dtype ``sim_row_t``."""
        pose = rows["pose"]
        columns = {
            "t_s": rows["t_s"].copy(),
            "line": pose["line"].copy(),
            "block": pose["block"].copy(),
            "kind": _kinds(pose),
            "s_mm": pose["s"].copy(),
        }
        for letter in self._axes:
            columns[f"pos_{position_key(letter)}"] = pose["axis"][:, AXES.index(letter)].copy()
        for k in range(len(self._axes)):
            columns[f"joint_{k}_nm"] = rows["axes"]["joint_nm"][:, k].copy()
        columns["vel_mm_s"] = pose["v"] * pose["feed_scale"]
        columns["feed_cmd_mm_min"] = pose["feed"] * pose["feed_scale"] * 60
        percent = np.where(pose["rapid"] == 1, rows["rapid_percent"], rows["feed_percent"])
        columns["override"] = percent / 100
        columns["limit"] = pose["limit"].copy()
        columns["queue_cells"] = rows["queue_cells"].copy()
        columns["spindle_rpm"] = rows["spindle_rpm"].copy()
        return columns


def _kinds(pose):
    """Return the codes of KINDS."""
    moves = np.where(pose["kind"] == _SEG_KINDS.SPLINE, KINDS.index("spline"), KINDS.index("line"))
    moves = np.where(pose["rapid"] == 1, KINDS.index("rapid"), moves)
    moves = np.where(pose["kind"] == _SEG_KINDS.ARC, KINDS.index("arc"), moves)
    moves = np.where(pose["kind"] == _SEG_KINDS.DWELL, KINDS.index("dwell"), moves)
    moves = np.where(pose["kind"] == _SEG_KINDS.WAIT, KINDS.index("wait"), moves)
    return np.where(pose["state"] == _STATES.IDLE, KINDS.index("idle"), moves).astype(np.uint8)


class _Part:
    """A file that appears under its name once it is complete."""

    def __init__(self, path):
        self._path, self.part = Path(path), Path(f"{path}.part")
        if self._path.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
        self.file = open(self.part, "wb")  # noqa: SIM115

    def close(self):
        self.file.close()
        os.replace(self.part, self._path)

    def discard(self):
        self.file.close()
        self.part.unlink(missing_ok=True)


class _Npz:
    """Columns as they come go to a file each; the archive is put together at the end."""

    def __init__(self, path, columns, metadata):
        self._part = _Part(path)
        self._facts = {**metadata, "units": columns.units, "names": columns.names}
        self._folder = tempfile.TemporaryDirectory()
        self._files, self._dtypes, self._rows = {}, {}, 0

    def write(self, columns):
        for name, array in columns.items():
            if name not in self._files:
                self._files[name] = open(Path(self._folder.name) / name, "w+b")  # noqa: SIM115
                self._dtypes[name] = array.dtype
            array.tofile(self._files[name])
        self._rows += len(columns["t_s"])

    def close(self):
        with zipfile.ZipFile(
            self._part.file, "w", zipfile.ZIP_DEFLATED, compresslevel=1
        ) as archive:
            with archive.open("metadata.npy", "w") as member:
                np.lib.format.write_array(member, np.array(json.dumps(self._facts)))
            for name, file in self._files.items():
                with archive.open(f"{name}.npy", "w", force_zip64=True) as member:
                    self._member(member, name, file)
        self._part.close()
        self._drop()

    def _member(self, member, name, file):
        header = {
            "descr": np.lib.format.dtype_to_descr(self._dtypes[name]),
            "fortran_order": False,
            "shape": (self._rows,),
        }
        np.lib.format.write_array_header_1_0(member, header)
        file.flush()
        file.seek(0)
        shutil.copyfileobj(file, member, 1 << 20)

    def _drop(self):
        for file in self._files.values():
            file.close()
        self._folder.cleanup()

    def discard(self):
        self._part.discard()
        self._drop()


class _Csv:
    """Comment lines with the metadata, one line of names, one line a tick."""

    def __init__(self, path, columns, metadata):
        self._part, self._names = _Part(path), columns.names
        facts = {**metadata, "units": json.dumps(columns.units)}
        head = [f"# {key}: {value}\n" for key, value in facts.items()]
        self._text("".join(head) + ",".join(columns.units) + "\n")
        self.close, self.discard = self._part.close, self._part.discard

    def _text(self, text):
        self._part.file.write(text.encode("utf-8", errors="surrogateescape"))

    def write(self, columns):
        texts = [self._cells(name, array) for name, array in columns.items()]
        self._text("".join(f"{','.join(row)}\n" for row in zip(*texts, strict=True)))

    def _cells(self, name, array):
        if name in self._names:
            return [self._names[name][code] for code in array.tolist()]
        return map(repr, array.tolist())


class _Parquet:
    """Row groups by pyarrow; units in the fields' metadata, the rest in the schema's."""

    def __init__(self, path, columns, metadata):
        self._arrow, self._parquet = need("pyarrow"), need("pyarrow.parquet")
        self._columns, self._metadata, self._part = columns, metadata, _Part(path)
        self._writer = None

    def write(self, columns):
        arrays = [self._array(name, values) for name, values in columns.items()]
        if self._writer is None:
            fields = [
                self._arrow.field(name, array.type, metadata={"unit": self._columns.units[name]})
                for name, array in zip(columns, arrays, strict=True)
            ]
            texts = {key: str(value) for key, value in self._metadata.items()}
            self._schema = self._arrow.schema(fields, metadata=texts)
            self._writer = self._parquet.ParquetWriter(self._part.file, self._schema)
        self._writer.write_table(self._arrow.table(arrays, schema=self._schema))

    def _array(self, name, values):
        if name not in self._columns.names:
            return self._arrow.array(values)
        names = self._columns.names[name]
        codes = np.full(max(names) + 1, 0, np.int32)
        codes[list(names)] = np.arange(len(names))
        return self._arrow.DictionaryArray.from_arrays(codes[values], list(names.values()))

    def close(self):
        if self._writer:
            self._writer.close()
        self._part.close()

    def discard(self):
        self._part.discard()


_WRITERS = {".npz": _Npz, ".csv": _Csv, ".parquet": _Parquet}


def writer(path, columns, metadata):
    """Return a writer of a trace file: an object with ``write(columns)``, ``close``, ``discard``.

    Parameters
    ----------
    path : path
        Its ending chooses the format: .npz, .csv or .parquet.
    columns : Columns
    metadata : dict
        Goes into the file.

    Raises
    ------
    ArgumentError
        If the ending is none of these.
    AbsentError
        If the format needs a package that is not installed.
    OSError
        If the file cannot be written.
    """
    ending = Path(path).suffix.lower()
    if ending not in _WRITERS:
        raise errors.ArgumentError(
            f"cannot tell the format of {str(path)!r}; endings: {', '.join(FORMATS)}", id="format"
        )
    return _WRITERS[ending](path, columns, metadata)


class Trace:
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
        self._layout = Columns(program.machine)
        sink = writer(output, self._layout, self.metadata()) if output is not None else None
        try:
            self._path_error = PathError(program)
            look = self._path_error.add_segs
            self.plan = Plan(program, plan=plan, backend=backend, keep=False, look=look)
            self._path_error.finish_segs()
            self._run(prep_steps, commands, keep, sink, progress)
        except BaseException:
            if sink:
                sink.discard()
            raise
        if sink:
            sink.close()
        self.summary = self._summary(time.perf_counter() - begun)

    def _run(self, prep_steps, commands, keep, sink, progress):
        program, machine = self.program, self.program.machine
        controller = self._controller(prep_steps, commands)
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
        self.worst_lines = self._ticks.worst_lines()
        self.columns = {
            name: np.concatenate([columns[name] for columns in kept])
            for name in self._layout.units
            if kept
        }

    def _controller(self, prep_steps, commands):
        if self.plan.grades is not None:
            if commands:
                raise errors.ArgumentError("a plan by grades takes no commands", id="command")
            return grades.Simulation(self.plan.grades, prep_steps)
        return kernel.Simulation(self.program.text, self.program.machine, prep_steps, commands)

    def _summary(self, run_s):
        plan = self.plan.as_dict()
        diagnostics = plan.pop("diagnostics")
        return {
            **plan,
            "time_s": self._ticks.time_s,
            "ticks": self._ticks.count,
            "length_mm": self._ticks.length_mm,
            "run_s": run_s,
            "peaks": self._peaks.result(),
            "path_error_mm": self._path_error.largest_mm,
            "starved_ticks": int(self._starved_ticks),
            "end": self._end,
            "limit_time_s": self._ticks.limit_time_s(),
            "diagnostics": diagnostics,
        }

    def metadata(self):
        """Return what is written into every trace file beside the rows."""
        machine = self.program.machine
        return {
            "version": kernel.version(),
            "file": self.program.file,
            "program_sha256": self.program.sha256,
            "machine": machine.name,
            "machine_sha256": machine.sha256,
            "dialect": machine.settings.dialect.base,
            "period_s": machine.period_s,
        }

    def __getitem__(self, name):
        return self.columns[name]

    def __len__(self):
        return self._ticks.count

    def limit_names(self):
        """Return the names of the codes in the column ``limit``, code → name."""
        return self._layout.names["limit"]

    def to_npz(self, path):
        """Write the rows as a NumPy archive: an array a column, and ``metadata`` as JSON text."""
        self._write(path, _Npz)

    def to_csv(self, path):
        """Write the rows as text: metadata in # lines, then names, then a line a tick."""
        self._write(path, _Csv)

    def to_parquet(self, path):
        """Write the rows as a Parquet file (needs pyarrow)."""
        self._write(path, _Parquet)

    def _write(self, path, kind):
        if not self.columns:
            raise errors.StateError("the run kept no rows", id="state")
        sink = kind(path, self._layout, self.metadata())
        sink.write(self.columns)
        sink.close()

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


def run(program, machine=None, *, slope=None, prep_steps=kernel.PREP_STEPS, commands=(),
        backend="auto", plan="exact"):  # fmt: skip
    """Run a whole program in the simulation, tick by tick.

    Parameters
    ----------
    program : Program, path, str or bytes
        What `load` takes, or a loaded program.
    machine : str, path or Machine, optional
        Another machine than the program's.
    slope : {"linear", "jerk", "sshape"}, optional
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
