# SPDX-License-Identifier: MIT
"""Why a program takes its time: what it loses to which cause, and what a cure would gain."""

import csv
import functools
import io
import math
import re
from decimal import Decimal

import numpy as np

from pycnc import errors, kernel
from pycnc.files import Part
from pycnc.machine import Machine, MachineFileError
from pycnc.machine.schema import AXES, unit_of
from pycnc.planning import control, feeds, measure
from pycnc.program import Program, shown

TOLERANCE_MM = Decimal("0.01")  # of the cure "within 0.01 mm"
LEAST_S = 1e-6  # lost: less is no row of its own
COLUMNS = (  # of `Why.rows`
    "cause", "words", "lost_s", "count", "line_first", "line_last", "line_worst", "worst_s", "axis",
    "angle_deg", "text",
)  # fmt: skip
WORDS = {
    "feed": "changes of feed",
    "rapid": "rapids that meet a slower move",
    "curvature": "arcs and bends, acceleration",
    "chord": "arcs and bends, chord error",
    "jerk": "bends, jerk",
    "exact_stop": "stops at sharp corners",
    "dwell": "slowing down for dwells",
    "wait": "slowing down for M0, M1, M6 etc.",
    "lookahead": "the length of the look-ahead",
    "feed_max": "the machine's highest feed",
    "spindle": "the spindle's speed",
    "thread": "threads: the spindle, and the wait for its angle",
    "mode": "stops where smoothing begins or ends",
}
_ENDS = "start and end of the program"
_ASKED = "stops that G61.1 and G9 ask for"
_STOPS = re.compile(rb"\([^()]*\)|;[^\n]*|G\s*61\s*\.\s*1(?!\d)|G\s*0*9(?![\d.])", re.I)


def changed_machines(machine, changes):
    """Yield (change, the machine that has it) of changes that are asked for, as ``KEY=VALUE``.

    Raises
    ------
    MachineFileError
        What is wrong with a change, told of it.
    """
    for change in changes:
        try:
            yield change, Machine.load(machine, set=[change])
        except MachineFileError as cause:
            raise MachineFileError(f"--what-if {change}", cause.problems) from None


class Why(shown.Tables):
    """What the time of a plan goes to.

    `ideal_s` and the `lost_s` of all causes add up to ``time_s``: the ideal is the time at the
    programmed feeds, at the speed of rapids, and of dwells.

    Attributes
    ----------
    plan : Plan
    time_s, ideal_s : float
        [s].
    causes : list of dict
        What time is lost to, the worst first: ``cause`` (a name of ``limit_time_s``, or "ends"),
        ``words``, ``lost_s``, ``share`` of the time, ``count`` of low points, ``axis`` that holds
        most of them (None: no single one), ``axis_s``, ``angle_deg`` (least and most of corners,
        else None), ``places``: the worst ones, as line ranges.
    cures : list of dict
        From `what_if`, the best first; empty before.
    """

    def __init__(self, plan):
        if plan.lost is None:
            raise errors.ArgumentError("only an exact plan is explained", id="plan")
        self.plan, self.program, found = plan, plan.program, plan.lost
        self.time_s = self.plan.time_s
        self.ideal_s = math.fsum(found[name] for name in ("cut_s", "rapid_s", "dwell_s"))
        self._ideal = {name: found[name] for name in ("cut_s", "rapid_s", "dwell_s")}
        self.cures = []
        self._free = self._without_stops()
        names = measure.limit_names(self.program.machine)
        rows = [self._cause(row, names) for row in found["causes"]]
        self.causes = sorted(rows, key=lambda cause: -cause["lost_s"])

    @functools.cached_property
    def slow_feeds(self):
        """Programmed feeds far below the rest that the ideal time goes to, see `feeds.slow`."""
        return feeds.slow(self.program, self.time_s)

    def _cause(self, row, names):
        name = "ends" if row["ends"] else names[int(row["limit"])]
        lost_s = float(row["lost_s"]["sum"] + row["lost_s"]["rest"])
        axis_s = {
            letter: float(row["axis_s"][AXES.index(letter)])
            for letter in self.program.machine.axes
            if row["axis_s"][AXES.index(letter)] > 0
        }
        corner, asked = name == "corner", name == "exact_stop" and self._free != self.program.text
        angles = [math.degrees(row[end]) for end in ("angle_least", "angle_most")]
        return {
            "cause": name,
            "words": _ASKED if asked else _words(name, angles, self.program.machine),
            "lost_s": lost_s,
            "share": lost_s / max(self.time_s, 1e-9),
            "count": int(row["count"]),
            "axis": max(axis_s, key=axis_s.get) if axis_s else None,
            "axis_s": axis_s,
            "angle_deg": angles if corner else None,
            "places": [self._place(each, corner) for each in row["places"][: row["place_count"]]],
        }

    def _place(self, row, corner):
        line = int(row["line_worst"])
        text = self.program.lines[line]
        axis = int(row["axis"])
        return {
            "line_first": int(row["line_first"]),
            "line_last": int(row["line_last"]),
            "line_worst": line,
            "count": int(row["count"]),
            "lost_s": float(row["lost_s"]),
            "worst_s": float(row["worst_s"]),
            "axis": AXES[axis] if axis < len(AXES) else None,
            "angle_deg": math.degrees(row["angle"]) if corner else None,
            "text": " ".join(text.decode("utf-8", errors="replace").split()),
        }

    def what_if(self, progress=None, changes=(), cures=True):
        """Plan the program again with each cure, and return what it gains.

        Twice the acceleration, jerk and speed, of all axes and of each; a tolerance of 0.01 mm,
        or twice the machine's where it has that; under the slope `optimal`, where `jerk` is in
        force; without the stops of G61.1 and G9.

        Parameters
        ----------
        progress : callable, optional
            Called with (plans done, of so many).
        changes : iterable of str
            Of the machine, each tried by itself: ``"control.kind=nck"``.
        cures : bool
            Whether the cures are tried.

        Returns
        -------
        list of dict
            ``cure``, ``time_s``, ``total_s`` with tool changes and spindle starts,
            ``gain_s`` of that (negative: it is slower), the best first; `cures`.

        Raises
        ------
        MachineFileError
            If a change is none that the machine can have.
        ProgramError
            If the program has an error on the changed machine.
        """
        wanted = [*self._asked(changes), *(self._cures() if cures else ())]
        self.cures = []
        for done, (cure, program) in enumerate(wanted):
            if progress:
                progress(done, len(wanted))
            told = type(self.plan)(program, keep=False).totals
            gain_s = self.plan.totals["total_s"] - told["total_s"]
            self.cures.append({"cure": cure, "time_s": told["time_s"],
                               "total_s": told["total_s"], "gain_s": gain_s})  # fmt: skip
        self.cures.sort(key=lambda cure: -cure["gain_s"])
        return self.cures

    def _asked(self, changes):
        """Yield (change, program that has it)."""
        for change, machine in changed_machines(self.program.machine, changes):
            try:
                yield change, self._with(machine).check()
            except errors.ProgramError as cause:
                raise errors.ProgramError(
                    f"--what-if {change}: {cause}", id=cause.id, line=cause.line,
                    column=cause.column,
                ) from None  # fmt: skip

    def _cures(self):
        """Yield (cure in words, program that has it)."""
        machine = self.program.machine
        changes = control.cures if control.is_foreign(machine) else _limits_twice
        for words, change in changes(machine):
            yield words, self._on(change)
        if control.is_foreign(machine):
            return
        has = machine.settings.path.tolerance_mm
        if machine.settings.path.slope == "optimal":
            tolerance = TOLERANCE_MM if has < TOLERANCE_MM else 2 * has
            yield f"within {tolerance:g} mm", self._on({"path.tolerance_mm": tolerance})
        else:
            tolerance = max(TOLERANCE_MM, has)
            yield f"slope optimal within {tolerance:g} mm", self._on(
                {"path.slope": "optimal", "path.tolerance_mm": tolerance}
            )
        if self._free != self.program.text:
            free = Program(self._free, machine, file=self.program.file, keep=False)
            yield "without G61.1 and G9", free

    def _without_stops(self):
        text = self.program.text
        return text if isinstance(text, kernel.Blocks) else _STOPS.sub(_unless_comment, text)

    def _on(self, changes):
        return self._with(Machine.load(self.program.machine, set=changes))

    def _with(self, machine):
        return Program(self.program.text, machine, file=self.program.file, keep=False)

    def as_dict(self):
        """Return what ``pycnc why --json`` tells."""
        facts = self.plan.as_dict()
        names = ("file", "machine", "version", "schema_version", "period_s", "slope", "control",
                 "time_s", "total_s", "tool_change_s", "spindle_s", "limit_time_s",
                 "diagnostics")  # fmt: skip
        return {
            **{name: facts[name] for name in names},
            "ideal_s": self.ideal_s,
            "ideal": self._ideal,
            "slow_feeds": self.slow_feeds,
            "causes": self.causes,
            "what_if": self.cures,
        }

    def rows(self):
        """Return one flat dict a place, the causes' worst first: for tables and CSV.

        What a cause loses outside of the places that it keeps is a row without lines.
        """
        return [row for cause in self.causes for row in _rows_of(cause)]

    def to_csv(self, path):
        """Write `rows` as CSV, a line of names first."""
        text = io.StringIO(newline="")
        table = csv.DictWriter(text, COLUMNS)
        table.writeheader()
        table.writerows(self.rows())
        with Part(path) as part:
            part.write(text.getvalue())

    def _table(self, kind):
        rows = self.rows()
        return shown.frame({name: [row[name] for row in rows] for name in COLUMNS}, kind=kind)

    def _repr_html_(self):
        names = ("lost [s]", "to", "places", "lines", "worst at line", "text")
        rows = [
            (f"{cause['lost_s']:.3f}", cause["words"], cause["count"],
             f"{place['line_first']}-{place['line_last']}", place["line_worst"], place["text"])
            for cause in self.causes for place in cause["places"][:1]
        ]  # fmt: skip
        return shown.rows_table(names, rows)

    def __repr__(self):
        lost = self.time_s - self.ideal_s
        worst = f", most to {self.causes[0]['words']}" if self.causes else ""
        return f"<Why of {self.program.file}: {self.time_s:.3f} s, {lost:.3f} s lost{worst}>"


def _words(name, angles, machine):
    if name == "ends":
        return _ENDS
    if control.is_foreign(machine):
        return control.words(name, machine, _angle_words(*angles)) or _own_words(name)
    if name == "corner":
        return f"corners of {_angle_words(*angles)}, acceleration"
    return _own_words(name)


def _own_words(name):
    kind, _, axis = name.partition(":")
    return f"the top speed of {axis.upper()}" if axis else WORDS.get(kind, kind)


def _angle_words(least, most):
    if most - least <= max(0.5, 0.15 * most):
        return f"{(least + most) / 2:.2g}°" if most < 10 else f"{(least + most) / 2:.0f}°"
    return f"{least:.2g}° to {most:.3g}°"


def _limits_twice(machine):
    """Yield (words, changes) of twice the limits of all axes, and of each."""
    for words, kinds, path in (
        ("acceleration", ("a_max",), "a_max_mm_s2"), ("jerk", ("j_max",), "j_max_mm_s3"),
        ("speed", ("v_max", "rapid"), "feed_max_mm_min"),
    ):  # fmt: skip
        twice = {letter: _twice(machine, letter, kinds) for letter in machine.axes}
        whole = {key: value for one in twice.values() for key, value in one.items()}
        most = getattr(machine.settings.path, path)
        if most is not None:
            whole[f"path.{path}"] = 2 * most
        yield f"{words} x 2", whole
        if len(twice) > 1:
            yield from ((f"{words} of {x.upper()} x 2", one) for x, one in twice.items())


def _twice(machine, letter, kinds):
    """Return the changes that double limits of an axis."""
    unit = unit_of(letter)
    ends = {"v_max": "_s", "rapid": "_s", "a_max": "_s2", "j_max": "_s3"}
    axis = machine.settings.axis.present()[letter]
    keys = {kind: f"{kind}_{unit}{ends[kind]}" for kind in kinds}
    values = {key: getattr(axis, key) for key in keys.values()}
    return {f"axis.{letter}.{key}": 2 * value for key, value in values.items() if value is not None}


def _unless_comment(match):
    """Blank out a stop, so that columns stay; leave comments."""
    return match[0] if match[0][:1] in b"(;" else b" " * len(match[0])


def _rows_of(cause):
    blank = dict.fromkeys(COLUMNS) | {name: cause[name] for name in ("cause", "words")}
    yield from (blank | place for place in cause["places"])
    rest = cause["lost_s"] - math.fsum(place["lost_s"] for place in cause["places"])
    count = cause["count"] - sum(place["count"] for place in cause["places"])
    if count > 0 or abs(rest) > LEAST_S:
        yield blank | {"count": count, "lost_s": rest, "text": ""}
