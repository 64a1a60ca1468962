# SPDX-License-Identifier: MIT
"""Geometry without text: points and moves become rows that the kernel takes in place of lines."""

import numpy as np

from pycnc import errors
from pycnc.kernel.records import dtype, enum
from pycnc.names import AXES

_KINDS = {member.name.lower(): member.value for member in enum("nck_in_kind_t")}
_FEED_MODES = {"per_minute": 0, "inverse": 1, "per_rev": 2}
_PATHS = {"exact": 0, "stop": 1}
_CONTINUOUS = 2
_SETS_FEED, _SETS_PATH = 1, 2
_MOVES = ("rapid", "line", "arc")
_VALUES = {"dwell": "seconds", "m": "code", "s": "rpm", "t": "number"}
_COMMON = ("kind", "id", "feed", "feed_mode", "path", "tolerance")


def _refuse(message):
    raise errors.ArgumentError(message, id="argument")


def _numbers(name, values):
    try:
        return np.asarray(values, float)
    except (TypeError, ValueError) as cause:
        _refuse(f"{name}: {cause}")


def of_points(points, feed, axes, tolerance):
    """Return the rows of `Program.from_points`."""
    points, feed = _numbers("points", points), _numbers("feed", feed)
    letters = [letter for letter in AXES if letter in axes]
    if points.ndim != 2 or not 1 <= points.shape[1] <= len(letters) or len(points) == 0:
        _refuse(
            f"points: an array of shape (n, k), n from 1, k from 1 to {len(letters)} "
            f"({' '.join(letters).upper()}), not {points.shape}"
        )
    feed = np.full(len(points), feed) if feed.ndim == 0 else feed
    if feed.shape != (len(points),):
        _refuse(f"feed: one number, or one for each of {len(points)} points")
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1) | ~(feed > 0) | ~np.isfinite(feed))
    if len(bad):
        _refuse(f"point {bad[0]}: coordinates must be finite and feeds above 0, not "
                f"{points[bad[0]].tolist()} at {feed[bad[0]]}")  # fmt: skip
    rows = np.zeros(len(points), dtype("nck_block_in_t"))
    rows["id"] = np.arange(1, len(points) + 1)
    rows["kind"], rows["kind"][0] = _KINDS["line"], _KINDS["rapid"]
    columns = [AXES.index(letter) for letter in letters[: points.shape[1]]]
    rows["axes"] = sum(1 << column for column in columns)
    rows["target"][:, columns] = points
    rows["feed"], rows["sets"] = feed, _SETS_FEED
    if tolerance is not None:
        rows["sets"][0] |= _SETS_PATH
        _set_tolerance(rows[0], tolerance)
    return rows


def rows_of(sequence):
    """Return the rows of `Program.from_moves`."""
    if isinstance(sequence, np.ndarray) and sequence.dtype == dtype("nck_block_in_t"):
        return np.ascontiguousarray(sequence)
    sequence = list(sequence)
    rows = np.zeros(len(sequence), dtype("nck_block_in_t"))
    for place, move in enumerate(sequence):
        try:
            _fill(rows[place], dict(move), place + 1)
        except (TypeError, ValueError, OverflowError) as cause:
            _refuse(f"move {place} (counted from 0): {cause}: {move}")
    return rows


def _set_tolerance(row, tolerance):
    row["path_mode"] = _CONTINUOUS if tolerance > 0 else _PATHS["exact"]
    row["tolerance"] = tolerance


def _check_keys(kind, move):
    if kind not in _KINDS:
        raise ValueError(f"no kind {kind!r}; there are: {', '.join(_KINDS)}")
    own = {"arc": ("centre", "turns", "plane"), "set": ()}.get(kind, ())
    known = (*_COMMON, *own, *(AXES if kind in _MOVES else ()))
    known += (_VALUES[kind],) if kind in _VALUES else ()
    if strange := [key for key in move if key not in known]:
        raise ValueError(f"no {strange[0]!r} in a {kind}; there are: {', '.join(known)}")


def _needed(move, key):
    if key not in move:
        raise ValueError(f"{key!r} is missing")
    return move[key]


def _fill(row, move, place):
    kind = move.get("kind")
    _check_keys(kind, move)
    row["id"], row["kind"] = move.get("id", place), _KINDS[kind]
    _set(row, move)
    if kind in _VALUES:
        row["value"] = _needed(move, _VALUES[kind])
    for axis, letter in enumerate(AXES):
        if letter in move:
            row["axes"] |= 1 << axis
            row["target"][axis] = move[letter]
    if kind == "arc":
        row["centre"], row["turns"] = _needed(move, "centre"), _needed(move, "turns")
        row["plane"] = move.get("plane", 17)


def _set(row, move):
    """Feed and path, which stay in force."""
    if "feed" in move:
        row["sets"] |= _SETS_FEED
        row["feed"], mode = move["feed"], move.get("feed_mode", "per_minute")
        if mode not in _FEED_MODES:
            raise ValueError(f"no feed_mode {mode!r}; there are: {', '.join(_FEED_MODES)}")
        row["feed_mode"] = _FEED_MODES[mode]
    if "path" in move or "tolerance" in move:
        row["sets"] |= _SETS_PATH
        path = move.get("path")
        if path is None:
            _set_tolerance(row, move["tolerance"])
        elif path not in _PATHS or "tolerance" in move:
            raise ValueError(f"path is one of {', '.join(_PATHS)}, or a tolerance stands alone")
        else:
            row["path_mode"] = _PATHS[path]
