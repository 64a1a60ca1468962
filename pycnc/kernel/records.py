# SPDX-License-Identifier: MIT
"""The kernel's records as NumPy dtypes, its enumerations as Python's: read from the module."""

import enum as _enum
import functools
import os
from decimal import Decimal

import numpy as np

from pycnc import errors
from pycnc.kernel.bind import ffi, lib

_MEMORY_SHARE = 0.8  # of the memory that is free: what an array may take


def names():
    """Return the C names of all records, sorted."""
    typedefs, _, _ = ffi.list_types()
    return sorted(name for name in typedefs if ffi.typeof(name).kind == "struct")


@functools.cache
def dtype(name):
    """Return the NumPy dtype of a C type, laid out as the compiler laid it out.

    Parameters
    ----------
    name : str
        C name of a record or a number: ``"nck_cell_t"``, ``"sim_row_t"``, ``"int64_t"``.

    Returns
    -------
    numpy.dtype
        Nested records and arrays are nested dtypes; a pointer is an unsigned integer of its size;
        a union is its largest member.

    Examples
    --------
    >>> cells = np.empty(16, dtype("nck_cell_t"))
    >>> cells["length"].dtype
    dtype('float64')
    """
    return _dtype(ffi.typeof(name))


def _dtype(ctype):
    if ctype.kind in ("struct", "union"):
        return _record(ctype, _members(ctype))
    if ctype.kind == "array":
        return np.dtype((_dtype(ctype.item), (ctype.length,)))
    size = ffi.sizeof(ctype)
    if ctype.kind in ("pointer", "function"):
        return np.dtype(f"u{size}")
    if ctype.cname in ("float", "double"):
        return np.dtype(f"f{size}")
    signed = int(ffi.cast(ctype, -1)) < 0
    return np.dtype(f"{'i' if signed else 'u'}{size}")


def _members(ctype):
    """Return (name, field) of a record; of a union the largest member, for others would overlap."""
    if ctype.kind == "struct":
        return ctype.fields
    return [max(ctype.fields, key=lambda member: ffi.sizeof(member[1].type))]


def _record(ctype, fields):
    return np.dtype(
        {
            "names": [name for name, _ in fields],
            "formats": [_dtype(field.type) for _, field in fields],
            "offsets": [field.offset for _, field in fields],
            "itemsize": ffi.sizeof(ctype),
        }
    )


@functools.cache
def enum(name):
    """Return an enumeration as an IntEnum, without the prefix that all its names share.

    Parameters
    ----------
    name : str
        C name of the enumeration: ``"nck_limit_t"``.

    Examples
    --------
    >>> enum("nck_limit_t").CORNER.name
    'CORNER'
    """
    values = sorted(ffi.typeof(name).relements.items(), key=lambda item: item[1])
    return _enum.IntEnum(name, _short_names(dict(values)), module=__name__)


def _short_names(values):
    """Drop the words that all names begin with: NCK_LIMIT_FEED and its kin give FEED."""
    words = [name.split("_")[:-1] for name in values]
    shared = 0
    while all(len(w) > shared for w in words) and len({w[shared] for w in words}) == 1:
        shared += 1
    return {"_".join(name.split("_")[shared:]): value for name, value in values.items()}


def join(name, pieces):
    """Return arrays of one record as one array that C can read, padding kept.

    Parameters
    ----------
    name : str
        C name of the record.
    pieces : sequence of numpy.ndarray
        May be empty.

    Examples
    --------
    >>> join("nck_cell_t", []).dtype == dtype("nck_cell_t")
    True
    """
    rows = [np.empty(0, dtype(name)), *pieces]
    return np.concatenate([_as_bytes(each) for each in rows]).view(dtype(name))


def copied(rows):
    """Return a copy of rows of one record, padding kept."""
    return _as_bytes(rows).copy().view(rows.dtype)


def _as_bytes(rows):
    """Return rows, one behind the other, as bytes: NumPy would copy them member by member."""
    return rows.view(np.dtype((np.void, rows.itemsize)))


def free_memory():
    """Return the bytes of memory that nobody uses."""
    return os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")


def room(what, count, name, remedy):
    """Return an array of zeros, if there is the memory for it.

    Parameters
    ----------
    what : str
        Whose items they are, in words.
    count : int
    name : str
        C type of an item.
    remedy : str
        What to do where there is not enough.

    Raises
    ------
    ArgumentError

    Examples
    --------
    >>> room("a plan", 2, "double", "plan less")
    array([0., 0.])
    """
    type_ = dtype(name)
    if count * type_.itemsize > _MEMORY_SHARE * free_memory():
        size = count * type_.itemsize / 2**30
        raise errors.ArgumentError(
            f"{count:,} items of {what} need {size:.1f} GiB, more than there is: {remedy}",
            id="memory",
        )
    return np.zeros(count, type_)


def counts_per_unit(rotary):
    """Return the counts of the kernel's fixed point: in a millimetre, or in a degree.

    Parameters
    ----------
    rotary : array_like of bool

    Returns
    -------
    numpy.ndarray
        int64, of the same shape: nanometres in a millimetre, nanodegrees in a degree.

    Examples
    --------
    >>> counts_per_unit([False, True])
    array([   1000000, 1000000000])
    """
    return np.where(rotary, lib.NCK_COUNTS_PER_DEG, lib.NCK_COUNTS_PER_MM)


def quantity_range(name):
    """Return the range of what a machine is measured in, as the kernel has it.

    Parameters
    ----------
    name : str
        Of ``nck_quantity_t``, without prefix, lower case.

    Returns
    -------
    low, high : Decimal
        The least and the most that the kernel takes, in its units.

    Examples
    --------
    >>> quantity_range("period")
    (Decimal('0.00001'), Decimal('0.1'))
    """
    ends = ffi.new("nck_range_t *")
    lib.nck_machine_range(getattr(lib, f"NCK_QUANTITY_{name.upper()}"), ends)
    return tuple(Decimal(repr(end)).normalize() for end in (ends.low, ends.high))
