# SPDX-License-Identifier: MIT
"""How results show themselves: in a notebook, and as a pandas.DataFrame."""

import html

import numpy as np

from pycnc.extras import need
from pycnc.kernel.records import dtype, enum
from pycnc.machine.schema import AXES, unit_of

_CODES = {  # member of a record → enumeration that names its codes
    "kind": "nck_seg_kind_t",
}
_HIDDEN = {"reserved", "shape"}


def _standstill(nodes):
    """Return how long a rest lasts; what a moving piece has of a and j at standstill."""
    rests = nodes["length"] == 0
    dwell = np.ascontiguousarray(nodes["standstill"]["dwell_s"])
    left = dwell.view(dtype("nck_left_t"))  # the same bytes: a union
    return {
        "dwell_s": np.where(rests, dwell, 0),
        "a_rest": np.where(rests, 0, left["a"]),
        "j_rest": np.where(rests, 0, left["j"]),
    }


def _q_rest(nodes):
    """Return the quotient that a node has as the upper half of a float's bits."""
    return {"q_rest": (nodes["q_rest"].astype(np.uint32) << 16).view(np.float32)}


_PACKED = {"standstill": _standstill, "q_rest": _q_rest}  # member → its columns, from the records


def facts_table(facts):
    """Return facts as HTML: a row each, name and value.

    Parameters
    ----------
    facts : iterable of (str, str)
        Text, as it is: marks in it stay inert.

    Examples
    --------
    >>> facts_table([("file", "<b>.nc")])
    '<table><tr><th>file</th><td>&lt;b&gt;.nc</td></tr></table>'
    """
    rows = (
        f"<tr><th>{html.escape(str(name))}</th><td>{html.escape(str(value))}</td></tr>"
        for name, value in facts
    )
    return f"<table>{''.join(rows)}</table>"


def rows_table(names, rows):
    """Return rows as HTML under their names: text, as it is."""
    head = "".join(f"<th>{html.escape(name)}</th>" for name in names)
    body = (
        f"<tr>{''.join(f'<td>{html.escape(str(cell))}</td>' for cell in row)}</tr>" for row in rows
    )
    return f"<table><tr>{head}</tr>{''.join(body)}</table>"


class Tables:
    """What hands out a table in each of the ways that there are."""

    def to_pandas(self):
        """Return a row each as a pandas.DataFrame (needs pandas): names in place of codes."""
        return self._table("pandas")

    def to_polars(self):
        """Return a row each as a polars.DataFrame (needs polars): names in place of codes."""
        return self._table("polars")

    def to_arrow(self):
        """Return a row each as a pyarrow.Table (needs pyarrow): names in place of codes."""
        return self._table("arrow")


def frame(columns, names=None, kind="pandas"):
    """Return columns as a table, codes by their names.

    Parameters
    ----------
    columns : dict
        Name → array or list.
    names : dict, optional
        Column of codes → {code: name}.
    kind : {"pandas", "polars", "arrow"}
        What makes it; each needs its package.
    """
    make, coded = {"pandas": _pandas, "polars": _polars, "arrow": _arrow}[kind]()
    made = {
        name: coded(*_places(array, names[name])) if name in (names or {}) else array
        for name, array in columns.items()
    }
    return make(made)


def _places(codes, names):
    """Return codes as places in a list of names, which it returns too: a byte or two a row."""
    place = np.full(max(names) + 1, -1, np.int16)
    place[list(names)] = np.arange(len(names))
    return place[codes], list(names.values())


def _pandas():
    pandas = need("pandas")
    return pandas.DataFrame, lambda at, names: pandas.Categorical.from_codes(at, categories=names)


def _polars():
    polars = need("polars")

    def coded(at, names):
        words = polars.Series(names, dtype=polars.Enum(list(dict.fromkeys(names))))
        return words.gather(polars.Series(at))

    return polars.DataFrame, coded


def _arrow():
    arrow = need("pyarrow")
    return arrow.table, lambda at, names: arrow.DictionaryArray.from_arrays(at, names)


def columns_of(records, machine, limits):
    """Return the members of records as columns, and the names of their codes.

    Parameters
    ----------
    records : numpy.ndarray
        Of dtype ``nck_seg_t``, ``nck_node_t`` or ``nck_cell_t``.
    machine : Machine
        Its axes name what a record has for each.
    limits : dict
        Code of ``nck_limit_t`` → name.

    Returns
    -------
    columns, names : dict
        As `frame` takes them.
    """
    columns, names = {}, {}
    for member in records.dtype.names:
        if member in _HIDDEN:
            continue
        if member in _PACKED:
            columns.update(_PACKED[member](records))
            continue
        array = np.ascontiguousarray(records[member])
        if array.ndim == 2:
            for letter in machine.axes:
                key = f"{member}_{letter}_{unit_of(letter)}"
                columns[key] = array[:, AXES.index(letter)]
            continue
        columns[member] = array
        if member.startswith("limit"):
            names[member] = limits
        if member in _CODES:
            codes = enum(_CODES[member])
            names[member] = {int(code): code.name.lower() for code in codes}
    return columns, names
