# SPDX-License-Identifier: MIT
"""The columns of a trace, and its files (npz, csv, parquet): written in pieces, read whole."""

import csv
import json
import shutil
import tempfile
import zipfile
import zlib
from pathlib import Path
from typing import NamedTuple

import numpy as np

from pycnc import errors
from pycnc.extras import need
from pycnc.files import Part
from pycnc.kernel.records import enum
from pycnc.machine.schema import AXES, position_key, unit_of
from pycnc.planning import measure
from pycnc.planning.measure import KINDS

FORMATS = (".npz", ".csv", ".parquet")
_JOINT_UNITS = {"mm": "nm", "deg": "ndeg"}
_SEG_KINDS = enum("nck_seg_kind_t")
_STATES = enum("nck_tick_state_t")
_TEXTS = ("kind", "limit")  # columns of codes
_WHOLE = ("line", "block", "queue_cells")


class Shape(NamedTuple):
    """What a writer must know of columns: their units, and the names of codes."""

    units: dict
    names: dict


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
    moves = np.where(pose["kind"] == _SEG_KINDS.THREAD, KINDS.index("thread"), moves)
    moves = np.where(pose["kind"] == _SEG_KINDS.TAP, KINDS.index("tap"), moves)
    return np.where(pose["state"] == _STATES.IDLE, KINDS.index("idle"), moves).astype(np.uint8)


class _Npz:
    """Columns as they come go to a file each; the archive is put together at the end."""

    def __init__(self, path, columns, metadata):
        self._part = Part(path)
        self._facts = {**metadata, "units": columns.units, "names": columns.names}
        self._folder = tempfile.TemporaryDirectory()
        self._files, self._dtypes, self._rows = {}, {}, 0

    def write(self, columns):
        for name, array in columns.items():
            if name not in self._files:
                self._files[name] = open(Path(self._folder.name) / name, "w+b")  # noqa: SIM115
                self._dtypes[name] = array.dtype
            self._files[name].write(np.ascontiguousarray(array).data)
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
        self._part, self._names = Part(path), columns.names
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
        self._columns, self._metadata, self._part = columns, metadata, Part(path)
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


WRITERS = {".npz": _Npz, ".csv": _Csv, ".parquet": _Parquet}


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
    if ending not in WRITERS:
        raise errors.ArgumentError(
            f"cannot tell the format of {str(path)!r}; endings: {', '.join(FORMATS)}", id="format"
        )
    return WRITERS[ending](path, columns, metadata)


def read(path, wanted=None):
    """Read the file of a trace.

    Parameters
    ----------
    path : path
        Its ending tells the format.
    wanted : callable, optional
        Tells of a column's name whether it is read; without it all are.

    Returns
    -------
    columns : dict
        Column → array, as they were written.
    units, names : dict
        Column → unit; column of codes → {code: name}.
    facts : dict
        What else stands in the file.

    Raises
    ------
    ArgumentError
        If it is none, or not whole.
    AbsentError
        If the format needs a package that is not installed.
    OSError
        If it cannot be read.
    """
    readers = {".npz": _read_npz, ".csv": _read_csv, ".parquet": _read_parquet}
    ending = Path(path).suffix.lower()
    if ending not in readers:
        raise errors.ArgumentError(
            f"cannot tell the format of {str(path)!r}; endings: {', '.join(FORMATS)}", id="format"
        )
    columns, units, names, facts = readers[ending](Path(path), wanted or (lambda _: True))
    if "t_s" not in columns or not any(name.startswith("pos_") for name in columns):
        raise errors.ArgumentError(f"{path}: is no trace of pycnc (no t_s, no pos_…)", id="log")
    if facts.get("period_s") is not None:
        facts["period_s"] = float(facts["period_s"])
    return columns, units, names, facts


def _read_npz(path, wanted):
    try:
        with path.open("rb") as data, np.lib.npyio.NpzFile(data) as archive:
            columns = {name: archive[name] for name in archive.files
                       if name != "metadata" and wanted(name)}  # fmt: skip
            facts = json.loads(str(archive["metadata"])) if "metadata" in archive.files else {}
    except (ValueError, EOFError, zipfile.BadZipFile, zlib.error) as cause:
        raise errors.ArgumentError(f"{path}: is no NumPy archive: {cause}", id="log") from None
    names = {column: {int(code): name for code, name in told.items()}
             for column, told in facts.pop("names", {}).items()}  # fmt: skip
    return columns, facts.pop("units", {}), names, facts


def _cells(path):
    """Return (facts in the lines before the head, the head, rows of cells) of a text."""
    facts = {}
    with path.open(encoding="utf-8", errors="surrogateescape", newline="") as file:
        place = file.tell()
        while (line := file.readline()).startswith("#"):
            key, _, value = line[1:].strip().partition(": ")
            facts[key], place = value, file.tell()
        file.seek(place)
        heads, *rows = list(csv.reader(file)) or [[]]
    for line, row in enumerate(rows, len(facts) + 2):
        if len(row) != len(heads):
            raise errors.ArgumentError(
                f"{path}:{line}: has {len(row)} cells, not {len(heads)}: the file is not whole",
                id="log",
            )
    return facts, heads, rows


def _read_csv(path, wanted):
    """Read text: its words become codes by their order of appearance."""
    facts, heads, rows = _cells(path)
    names, columns = {}, {}
    cells_of = zip(*rows, strict=True) if rows else [()] * len(heads)
    for name, cells in zip(heads, cells_of, strict=True):
        if not wanted(name):
            continue
        if name in _TEXTS:
            known = {word: code for code, word in enumerate(dict.fromkeys(cells))}
            names[name] = {code: word for word, code in known.items()}
            columns[name] = np.array([known[word] for word in cells], np.uint8)
            continue
        columns[name] = _numbers(path, name, cells)
    units = json.loads(facts.pop("units", "{}"))
    return columns, units, names, facts


def _numbers(path, name, cells):
    kind = np.int64 if name in _WHOLE or name.startswith("joint_") else np.float64
    try:
        return np.array(cells, kind)
    except ValueError as cause:
        raise errors.ArgumentError(f"{path}: column {name}: {cause}", id="log") from None


def _read_parquet(path, wanted):
    arrow, parquet = need("pyarrow"), need("pyarrow.parquet")
    try:
        with parquet.ParquetFile(path) as file:
            table = file.read(list(filter(wanted, file.schema_arrow.names)))
    except arrow.ArrowInvalid as cause:
        raise errors.ArgumentError(f"{path}: is no Parquet file: {cause}", id="log") from None
    names, columns = {}, {}
    for name in table.column_names:
        column = table[name].combine_chunks()
        if arrow.types.is_dictionary(column.type):
            names[name] = dict(enumerate(column.dictionary.to_pylist()))
            columns[name] = column.indices.to_numpy().astype(np.uint8)
        else:
            columns[name] = column.to_numpy(zero_copy_only=False)
    units = {field.name: (field.metadata or {}).get(b"unit", b"").decode()
             for field in table.schema}  # fmt: skip
    facts = {key.decode(): value.decode(errors="surrogateescape")
             for key, value in (table.schema.metadata or {}).items()}  # fmt: skip
    return columns, units, names, facts
