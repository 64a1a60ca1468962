# SPDX-License-Identifier: MIT
"""Two runs side by side: programs, traces or measured logs, by time, path and line."""

import csv
import math
from pathlib import Path

import numpy as np

from pycnc import errors
from pycnc.kernel.records import counts_per_unit
from pycnc.machine.schema import AXES, ROTARY_AXES, position_key
from pycnc.report import trace_file

MOVES = 0.05  # places of A a sample: less is at rest
STILL_MM = 1e-6  # nearer together two samples are one place
FORWARD, BACK = 400, 20  # places of A among which the next sample of B is looked for
SAMPLES_MAX = 40_000  # of B that are looked for: of more every second, third …
_UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "mm": 1.0, "um": 1e-3, "m": 1e3, "inch": 25.4,
          "deg": 1.0, "rad": 180 / math.pi}  # fmt: skip
MISFIT = 0.05  # of A's time: what a clock that fits leaves at most
GAP = 20  # times the usual step: so long without a sample while it moves is a gap
ALIKE = 0.02  # extents whose ratio is that of two units to this share are of other units
_TIME_UNITS = frozenset({"s", "ms", "us"})


class Side:
    """A run as it is compared.

    Attributes
    ----------
    name : str
    t : numpy.ndarray
        (n,) time [s], rising.
    places : dict
        Axis letter → (n,) position [mm, deg].
    line : numpy.ndarray or None
        (n,) source line; a measured log has none.
    zero : dict or None
        Axis letter → where the program's zero lies; None: nobody says.
    is_laid : bool
        Whether it lies there because nobody knows where the work is.
    """

    def __init__(self, name, t, places, line=None):
        self.name, self.t, self.places, self.line = name, t, places, line
        self.zero, self.is_laid = None, False
        if len(t) < 2:
            raise errors.ArgumentError(f"{name}: has less than two samples", id="log")
        for what, array in (("time", t), *places.items()):
            bad = np.flatnonzero(~np.isfinite(array))
            if bad.size:
                raise errors.ArgumentError(
                    f"{name}: sample {bad[0] + 1}: {what} is no number", id="log"
                )
        back = np.flatnonzero(np.diff(t) <= 0)
        if back.size:
            raise errors.ArgumentError(
                f"{name}: sample {back[0] + 2}: time does not go on ({t[back[0]]:g} s, then "
                f"{t[back[0] + 1]:g} s)", id="log",
            )  # fmt: skip

    @property
    def time_s(self):
        """From the first sample to the last [s]; of a run with ticks one period more."""
        return float(self.t[-1] - self.t[0])


def of_trace(trace, name, is_laid=False):
    """Return the side of a run that kept its rows.

    is_laid: its machine does not know where the work lies.
    """
    side, record = _of_columns(name, trace.columns), trace.program.machine.record
    zeros = record["work_nm"][int(record["work_system"])]
    zeros = zeros / counts_per_unit(record["axis"]["rotary"])
    side.zero, side.is_laid = dict(zip(AXES, zeros.tolist(), strict=False)), is_laid
    return side


def _from_zero(a, b):
    """Return both runs with places from their programs' zeros, where those are what is alike."""
    if not (a.is_laid or b.is_laid) or a.zero is None or b.zero is None:
        return a, b
    moved = []
    for side in (a, b):
        places = {letter: at - side.zero[letter] for letter, at in side.places.items()}
        moved.append(Side(side.name, side.t, places, side.line))
    return moved


def _of_columns(name, columns):
    places = {letter: columns[f"pos_{position_key(letter)}"] for letter in AXES
              if f"pos_{position_key(letter)}" in columns}  # fmt: skip
    if "t_s" not in columns or not places:
        raise errors.ArgumentError(f"{name}: is no trace of pycnc (no t_s, no pos_…)", id="log")
    t = np.asarray(columns["t_s"], np.float64)
    return Side(name, t, {k: np.asarray(v, np.float64) for k, v in places.items()},
                np.asarray(columns["line"]) if "line" in columns else None)  # fmt: skip


def read(file, columns=None):
    """Read a trace, or a measured log.

    Parameters
    ----------
    file : path
        .npz or .parquet: a trace. .csv: a trace, or with `columns` any table with a line of names.
    columns : dict, optional
        ``t`` and axis letters → column, or column:unit (s, ms, us; mm, um, m, inch, deg, rad).

    Raises
    ------
    ArgumentError
        With file, line and what is wrong.
    OSError
    """
    path, name = Path(file), str(file)
    ending = path.suffix.lower()
    if ending in (".npz", ".parquet"):
        return _of_columns(name, trace_file.read(path, _is_compared)[0])
    names, rows, begin = _table(path, name)
    if columns is None:
        columns = {"t": "t_s", **_own_positions(names)}
        if "t_s" not in names or len(columns) < 2:
            raise errors.ArgumentError(
                f"{name}: is no trace of pycnc; of a measured log tell the columns: --map "
                f"t=Time,x=PosX (it has: {', '.join(names)})", id="map",
            )  # fmt: skip
    taken = {key: _column(name, names, rows, begin, key, asked)
             for key, asked in columns.items()}  # fmt: skip
    line = None
    if "line" in names and "t_s" in names:
        line = _column(name, names, rows, begin, "line", "line").astype(np.int64)
    return Side(name, taken.pop("t"), taken, line)


def _is_compared(column):
    return column in ("t_s", "line") or column.startswith("pos_")


def _own_positions(names):
    keys = {letter: f"pos_{position_key(letter)}" for letter in AXES}
    return {letter: key for letter, key in keys.items() if key in names}


def _table(path, name):
    """Return (names, rows, line of the first row) of a CSV; # lines before the names are passed."""
    lines = path.read_text(encoding="utf-8-sig", errors="replace").splitlines()
    begin = next((k for k, line in enumerate(lines) if line.strip() and line[:1] != "#"), None)
    if begin is None:
        raise errors.ArgumentError(f"{name}: is empty", id="log")
    mark = ";" if lines[begin].count(";") > lines[begin].count(",") else ","
    rows = list(csv.reader(lines[begin:], delimiter=mark))
    return [cell.strip() for cell in rows[0]], rows[1:], begin + 2


def _column(name, names, rows, begin, key, asked):
    """Return a column of a table as numbers in s, mm or degrees."""
    column, _, unit = asked.partition(":")
    if column not in names:
        raise errors.ArgumentError(
            f"{name}: has no column {column!r}; it has: {', '.join(names)}", id="map"
        )
    if unit and (unit not in _UNITS or (unit in _TIME_UNITS) != (key == "t")):
        raise errors.ArgumentError(f"--map {key}={asked}: {unit!r} is no unit of it", id="map")
    place, values = names.index(column), np.empty(len(rows))
    for k, row in enumerate(rows):
        try:
            values[k] = float(row[place])
        except (ValueError, IndexError):
            given = row[place] if place < len(row) else "nothing"
            raise errors.ArgumentError(
                f"{name}:{begin + k}: {column} is {given!r}, no number", id="log"
            ) from None
    return values * _UNITS[unit] if unit else values


def columns_of(words):
    """Return what ``--map t=Time,x=PosX:inch`` says, key → column."""
    pairs = dict(pair.partition("=")[::2] for pair in words.split(","))
    known = {"t", *AXES}
    if "t" not in pairs or len(pairs) < 2 or not (pairs.keys() <= known and all(pairs.values())):
        raise errors.ArgumentError(
            f"--map {words!r}: must look like t=Time,x=PosX,y=PosY (t and axes: "
            f"{', '.join(AXES)}; with a unit: t=Time:ms)", id="map",
        )  # fmt: skip
    return pairs


class Comparison:
    """How two runs differ.

    Attributes
    ----------
    a, b : Side
    time_s : float
        How much longer B takes [s].
    distance_mm, distance_line, distance_t_s : float, int, float
        The largest distance of B from A's path, its line and its time in B.
    mean_mm : float
    shift_s, rate : float
        B's clock against A's: t_B = shift_s + rate·t_A, by least squares over what moves.
    residual_s : float
        What is left of the differences of time behind that, in the mean [s].
    lines : list of (int, float, float)
        Source line, time in A and in B [s], the largest differences first.
    notes : list of str
        What makes one doubt the rest: gaps, other units.
    """

    def __init__(self, a, b):
        shared = [letter for letter in AXES if letter in a.places and letter in b.places]
        if not shared:
            raise errors.ArgumentError("the two have no axis in common", id="map")
        a, b = _from_zero(a, b)
        self.a, self.b, self.axes = a, b, "".join(shared)
        self.time_s = b.time_s - a.time_s
        path_a, path_b = (np.stack([side.places[k] for k in shared], axis=1) for side in (a, b))
        step = max(1, math.ceil(len(path_b) / SAMPLES_MAX))
        self._t_b, path_b = b.t[::step], path_b[::step]
        moved = np.linalg.norm(np.diff(path_a, axis=0), axis=1) > STILL_MM
        self._kept = np.flatnonzero(np.append(True, moved))
        place, distance = _follow(path_a[self._kept], a.t[self._kept], path_b, self._t_b)
        worst = int(np.argmax(distance))
        self.distance_mm, self.mean_mm = float(distance[worst]), float(distance.mean())
        self.distance_t_s = float(self._t_b[worst] - b.t[0])
        self._t_a = np.interp(place, np.arange(len(self._kept)), a.t[self._kept])
        self.distance_line = self._line_at(place[worst])
        self._fit_clock(place, path_a[self._kept])
        self.lines = self._by_line(place)
        self.notes = [*_gaps(a, shared), *_gaps(b, shared), *_units(a, b, shared)]

    @property
    def keeps_time(self):
        """Whether B passes A's places by some clock: else nothing is told of clock and lines."""
        return self.b.line is not None or self.residual_s <= MISFIT * self.a.time_s

    def _line_at(self, place):
        index = self._kept[min(round(float(place)), len(self._kept) - 1)]
        return int(self.a.line[index]) if self.a.line is not None else None

    def _fit_clock(self, place, path_a):
        """Fit t_B = shift_s + rate·t_A. The faster the path, the better its time is known."""
        forward = np.diff(place, prepend=place[0], append=place[-1]) > MOVES
        moves = forward[:-1] & forward[1:]  # before and behind: no end of a rest
        if moves.sum() < 3:
            moves[:] = True
        steps = np.linalg.norm(np.diff(path_a, axis=0), axis=1)
        weight = np.append(steps, 0.0)[np.rint(place[moves]).astype(int)] ** 2 + STILL_MM**2
        t_a, t_b = self._t_a[moves], self._t_b[moves]
        middle_a, middle_b = (np.average(t, weights=weight) for t in (t_a, t_b))
        spread = (weight * (t_a - middle_a) ** 2).sum()
        rise = (weight * (t_a - middle_a) * (t_b - middle_b)).sum()
        self.rate = float(rise / spread) if spread > 0 else 1.0
        self.shift_s = float(middle_b - self.rate * middle_a)
        left = t_b - self.shift_s - self.rate * t_a
        self.residual_s = float(np.sqrt(np.average(left**2, weights=weight)))

    def _by_line(self, place):
        if self.a.line is None:
            return []
        if self.b.line is not None:
            in_a, in_b = (_line_times(side.line, side.t) for side in (self.a, self.b))
        else:  # a rest counts to the move before it: a log does not tell them apart
            in_a = _line_times(self.a.line[self._kept], self.a.t[self._kept])
            nearest = np.clip(np.rint(place).astype(int), 0, len(self._kept) - 1)
            in_b = _line_times(self.a.line[self._kept[nearest]], self._t_b)
        rows = [(line, in_a.get(line, 0.0), in_b.get(line, 0.0)) for line in in_a.keys() | in_b]
        return sorted(rows, key=lambda row: (-abs(row[2] - row[1]), row[0]))

    def as_dict(self, lines=50):
        """Return what ``pycnc compare --json`` tells."""
        return {
            "a": self.a.name,
            "b": self.b.name,
            "axes": self.axes,
            "time_a_s": self.a.time_s,
            "time_b_s": self.b.time_s,
            "time_difference_s": self.time_s,
            "distance_mm": self.distance_mm,
            "distance_mean_mm": self.mean_mm,
            "distance_line": self.distance_line,
            "distance_t_s": self.distance_t_s,
            "clock_shift_s": self.shift_s,
            "clock_rate": self.rate,
            "clock_residual_s": self.residual_s,
            "notes": self.notes,
            "lines": [
                {"line": line, "time_a_s": a, "time_b_s": b, "difference_s": b - a}
                for line, a, b in self.lines[:lines]
            ],
        }

    def __repr__(self):
        return (
            f"<Comparison of {self.a.name} and {self.b.name}: {self.time_s:+.3f} s, "
            f"{self.distance_mm:.4f} mm>"
        )


def _gaps(side, axes):
    """Yield what is told of the longest time without a sample, if it is a gap."""
    steps = np.diff(side.t)
    moved = np.max([np.abs(np.diff(side.places[letter])) for letter in axes], axis=0)
    steps = np.where(moved > STILL_MM, steps, 0.0)
    worst, usual = int(np.argmax(steps)), float(np.median(np.diff(side.t)))
    if steps[worst] > GAP * usual:
        yield (
            f"{side.name}: no sample for {steps[worst]:.3f} s behind sample {worst + 1} "
            f"({side.t[worst]:g} s), while it moves: what is told behind it may be wrong"
        )


def _units(a, b, axes):
    """Yield what is told if all linear axes of B have the extents of A in another unit."""
    extents = [(np.ptp(a.places[letter]), np.ptp(b.places[letter]))
               for letter in axes if letter not in ROTARY_AXES]  # fmt: skip
    ratios = np.array([of_a / of_b for of_a, of_b in extents if min(of_a, of_b) > STILL_MM])
    for unit in ("inch", "um", "m"):
        if len(ratios) and np.all(np.abs(ratios / _UNITS[unit] - 1) < ALIKE):
            yield (
                f"{b.name}: its axes go {1 / ratios[0]:.4g} times as far as those of A: is it in "
                f"{unit}? (--map {axes[0]}=…:{unit})"
            )


def _line_times(line, t):
    """Return line → time of the samples that are there [s]."""
    spans = np.diff(t, append=t[-1])
    lines, where = np.unique(line, return_inverse=True)
    return dict(zip(lines.tolist(), np.bincount(where, spans).tolist(), strict=True))


def _follow(path_a, t_a, path_b, t_b):
    """Return for every point of B (where A's path is nearest, as index and share; the distance).

    It is looked for from the furthest place that was found, as far ahead as A may have gone
    meanwhile; of the places that are near, the one most in time: a path that meets itself stays in
    order. If another one is nearer by more than A goes there in a sample, it is that one: behind a
    turn back.
    """
    place, distance, at, high = np.empty(len(path_b)), np.empty(len(path_b)), 0, 0
    passed, chords = np.diff(t_b, prepend=t_b[0]), np.linalg.norm(np.diff(path_a, axis=0), axis=1)
    for k, point in enumerate(path_b):
        due = int(np.searchsorted(t_a, t_a[at] + passed[k]))
        low = max(high - BACK, 0)
        looked = slice(low, max(at + FORWARD, 2 * due - at))
        away = np.linalg.norm(path_a[looked] - point, axis=1)
        near = np.flatnonzero(away <= away.min() + chords[looked].max(initial=0.0)) + low
        at, found = _most_in_time(path_a, near, due, low, point)
        if found[1] - away.min() > chords[max(at - 1, 0) : at + 1].max(initial=0.0):
            near = np.flatnonzero(away < found[1]) + low
            at, found = _most_in_time(path_a, near, due, low, point)
        place[k], distance[k] = found
        high = max(high, at)
    return place, distance


def _most_in_time(path, near, due, low, point):
    """Return the vertex of `near` that is next to what is due, settled, and the place beside it."""
    at = _settle(path, int(near[np.argmin(np.abs(near - due))]), low, point)
    return at, _on_polyline(path, at, point)


def _settle(path, at, low, point):
    """Return the vertex nearest to a point, from `low` on, vertex by vertex without one that
    is farther: where a path goes back the way that it came, it stays on its own side."""
    best = float(np.linalg.norm(path[at] - point))
    for step, end in ((1, len(path)), (-1, low - 1)):
        while at + step != end:
            away = float(np.linalg.norm(path[at + step] - point))
            if away >= best:
                break
            at, best = at + step, away
    return at


def _on_polyline(path, near, point):
    """Return (index and share, distance) of the nearest point on the two chords at a vertex."""
    best = (float(near), float(np.linalg.norm(path[near] - point)))
    for first in (near - 1, near):
        if 0 <= first < len(path) - 1:
            chord = path[first + 1] - path[first]
            share = float(np.dot(point - path[first], chord) / max(np.dot(chord, chord), 1e-300))
            share = min(max(share, 0.0), 1.0)
            away = float(np.linalg.norm(path[first] + share * chord - point))
            if away < best[1]:
                best = (first + share, away)
    return best


def lines_of(found, shown=8):
    """Yield what is told of a comparison on the terminal."""
    a, b = found.a, found.b
    share = found.time_s / max(a.time_s, 1e-9)
    yield f"A  {a.time_s:.3f} s  {a.name}"
    yield f"B  {b.time_s:.3f} s  {b.name}"
    yield f"time   B takes {abs(found.time_s):.3f} s {'more' if found.time_s >= 0 else 'less'}" \
          f" ({share:+.2%})"  # fmt: skip
    if b.line is None:
        yield _clock_line(found)
    if found.distance_mm < STILL_MM:
        yield f"path   B is on A's path; axes {found.axes.upper()}"
    else:
        line = f" at line {found.distance_line}" if found.distance_line else ""
        yield (
            f"path   B is {found.distance_mm:.4f} mm from A at most{line}, {found.distance_t_s:.3f}"
            f" s behind its start; {found.mean_mm:.4f} mm in the mean; axes {found.axes.upper()}"
        )
    yield from (f"note   {note}" for note in found.notes)
    told = [row for row in found.lines if abs(row[2] - row[1]) >= 5e-4][:shown]
    told = told if found.keeps_time else []
    if told:
        yield "most by line    A [s]     B [s]  difference [s]"
        for number, in_a, in_b in told:
            yield f"  line {number:6} {in_a:8.3f}  {in_b:8.3f}  {in_b - in_a:+14.3f}"


def _clock_line(found):
    if not found.keeps_time:
        return "clock  no clock fits: B does not pass A's places in their order"
    slow = found.rate - 1
    return (
        f"clock  B is {abs(found.shift_s) * 1e3:.2f} ms "
        f"{'late' if found.shift_s >= 0 else 'early'} at A's places and {abs(slow):.3%} "
        f"{'slower' if slow >= 0 else 'faster'}; "
        f"{found.residual_s * 1e3:.2f} ms are left in the mean"
    )
