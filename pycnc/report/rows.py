# SPDX-License-Identifier: MIT
"""Rows of a run, one a tick: of one that was just made, or of a file."""

import numpy as np

from pycnc import errors
from pycnc.machine.schema import AXES, position_key
from pycnc.program import shown
from pycnc.report import trace_file

# Order of the derivative → column before the axis, and what stands behind it.
_DERIVED = {1: ("vel", "_s"), 2: ("acc", "_s2"), 3: ("jerk", "_s3")}


class Rows(shown.Tables):
    """Rows of a run: what a `Trace` keeps, and what `Trace.load` finds in a file.

    ``rows["pos_x_mm"]`` is a column. Speed, acceleration and jerk of every axis are made when they
    are asked for: ``rows["vel_x_mm_s"]``, ``rows["acc_x_mm_s2"]``, ``rows["jerk_x_mm_s3"]`` are
    differences of the positions of neighbouring ticks over the period, at rest before the first.

    Attributes
    ----------
    columns : dict
        Column → array, as files have them.
    """

    def __init__(self, columns, units, names, facts):
        self.columns, self._units, self._names, self._facts_of_file = columns, units, names, facts

    @classmethod
    def load(cls, path):
        """Read a trace from its file.

        Parameters
        ----------
        path : path
            .npz, .csv or .parquet.

        Returns
        -------
        Rows

        Raises
        ------
        ArgumentError
            If it is no trace, or not whole.
        AbsentError
            If the format needs a package that is not installed.
        OSError
            If it cannot be read.

        Examples
        --------
        >>> trace.to_npz("run.npz")
        >>> rows = Trace.load("run.npz")
        >>> bool((rows["pos_x_mm"] == trace["pos_x_mm"]).all())
        True
        """
        return Rows(*trace_file.read(path))

    def metadata(self):
        """Return what stands in a file beside the rows: version, machine, program, period."""
        return dict(self._facts_of_file)

    def __getitem__(self, name):
        if name in self.columns or name not in self._derived_names():
            return self.columns[name]
        letter, order = self._derived_names()[name]
        return self._derivative(letter, order)

    def __len__(self):
        return len(self.columns.get("t_s", ()))

    def _derived_names(self):
        """Return column → (axis, order of the derivative)."""
        return {
            f"{before}_{position_key(letter)}{behind}": (letter, order)
            for order, (before, behind) in _DERIVED.items()
            for letter in AXES
            if f"pos_{position_key(letter)}" in self.columns
        }

    def _derivative(self, letter, order):
        period_s = self.metadata().get("period_s")
        if period_s is None:
            raise errors.StateError("the file does not tell its period", id="state")
        places = np.asarray(self.columns[f"pos_{position_key(letter)}"], np.float64)
        whole = np.concatenate([np.repeat(places[:1], order), places])
        return np.diff(whole, order) / period_s**order

    def derived(self):
        """Return column → array: speed, acceleration and jerk of every axis.

        In mm or degrees, a second, a second squared, a second cubed.
        """
        return {name: self[name] for name in self._derived_names()}

    def names(self):
        """Return column of codes → {code: name}."""
        return self._names

    def limit_names(self):
        """Return the names of the codes in the column ``limit``, code → name."""
        return self.names().get("limit", {})

    def _table(self, kind):
        self._have_rows()
        return shown.frame({**self.columns, **self.derived()}, self.names(), kind)

    def _have_rows(self):
        if not self.columns:
            raise errors.StateError("the run kept no rows", id="state")

    def to_npz(self, path):
        """Write the rows as a NumPy archive: an array a column, and ``metadata`` as JSON text."""
        self._write(path, ".npz")

    def to_csv(self, path):
        """Write the rows as text: metadata in # lines, then names, then a line a tick."""
        self._write(path, ".csv")

    def to_parquet(self, path):
        """Write the rows as a Parquet file (needs pyarrow)."""
        self._write(path, ".parquet")

    def _write(self, path, ending):
        self._have_rows()
        sink = trace_file.WRITERS[ending](path, self._shape(), self.metadata())
        try:
            sink.write(self.columns)
            sink.close()
        except BaseException:
            sink.discard()
            raise

    def _shape(self):
        return trace_file.Shape(self._units, self.names())

    def __repr__(self):
        facts = self.metadata()
        told = ", ".join(f"{key} {facts[key]}" for key in ("file", "machine") if key in facts)
        return f"<Rows of {told or 'a run'}: {len(self):,} ticks>"

    def _repr_html_(self):
        told = {**self.metadata(), "ticks": f"{len(self):,}", "columns": ", ".join(self.columns)}
        return shown.facts_table(told.items())
