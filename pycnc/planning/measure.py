# SPDX-License-Identifier: MIT
"""What a run did, measured from its setpoints piece by piece: peaks, times.

Nothing here asks the planner: speed, acceleration and jerk are finite differences of the emitted
positions.
"""

from collections import Counter

import numpy as np

from pycnc.machine.schema import AXES
from pycnc.kernel.records import counts_per_unit, enum
from pycnc.planning import stretches

LIMITS = enum("nck_limit_t")
# Codes of a trace's column `kind`.
KINDS = ("idle", "rapid", "line", "arc", "dwell", "wait", "spline", "thread", "tap")
_TICK_STATES, _SEGS = enum("nck_tick_state_t"), enum("nck_seg_kind_t")
_PAGE = 4096  # lines whose ticks are counted in one array


def limit_names(machine):
    """Return the names of all limits that can hold this machine, code → name, in code order.

    Examples
    --------
    >>> limit_names(Machine.load("cao2014"))[2]
    'corner'
    """
    names = {int(limit): limit.name.lower() for limit in LIMITS if limit != LIMITS.AXIS_V}
    for letter in machine.axes:
        names[LIMITS.AXIS_V + AXES.index(letter)] = f"axis_v:{letter}"
    return names


class Derivatives:
    """Speed, acceleration and jerk of every axis and of the path, tick by tick. On a clocked path
    the coordinate is that of the program: its speed is nobody's. Where the path has limits of its
    own, what of the axes' acceleration and jerk lies along the last steps stands there, else
    nothing."""

    def __init__(self, machine):
        self._axes = [AXES.index(letter) for letter in machine.axes]
        counts = counts_per_unit(machine.record["axis"]["rotary"])
        start = (machine.record["start_nm"] / counts)[self._axes]
        self._tail = np.tile(np.append(start, 0.0), (3, 1))  # at rest before the first tick
        self._flags = np.zeros(3, bool)  # on a clocked path
        self._clocks = machine.settings.path.slope == "optimal"
        self._period, self._limited = machine.period_s, machine.limits_path

    def of(self, rows):
        """Yield those of the next rows of a run (dtype ``sim_row_t``): v, then a, then j.

        Each has a row for each of `rows`, and a column for each axis and for the path. Where
        another control plans, the rows have v and a, as it means them, and there is no j.
        """
        if "speed" in rows.dtype.names:
            yield from (rows["speed"], rows["acceleration"])
            return
        now = np.column_stack([rows["pose"]["axis"][:, self._axes], rows["pose"]["s"]])
        track = np.concatenate([self._tail, now])
        told = self._clocks & (rows["pose"]["kind"] == _SEGS.SPLINE)
        flags = all_flags = np.concatenate([self._flags, told])
        self._tail, self._flags, step = track[-3:], all_flags[-3:], track
        for order in range(1, 4):
            step, flags = np.diff(step, axis=0), flags[1:] | flags[:-1]
            rate = step[3 - order :] / self._period**order
            clocked = flags[3 - order :]
            rate[clocked, -1] = 0
            if self._limited and order > 1 and clocked.any():
                chord = track[3:, :-1] - track[3 - order : -order, :-1]
                rate[clocked, -1] = _along(rate[clocked, :-1], chord[clocked])
            yield rate


def _along(rates, ways):
    """Return what of rates has the direction of ways, a row each."""
    size = np.linalg.norm(ways, axis=1)
    return np.einsum("ij,ij->i", rates, ways) / np.where(size > 0, size, 1)


class Peaks:
    """Largest speed, acceleration and jerk of every axis and of the path, over their limits."""

    def __init__(self, machine):
        self._machine, self._derivatives = machine, Derivatives(machine)
        self._peaks = np.zeros((3, len(machine.axes) + 1))  # v, a, j of the axes and of s
        self._orders = 3

    def add(self, rows):
        """Measure the next rows of a run (dtype ``sim_row_t``)."""
        for order, rate in enumerate(self._derivatives.of(rows)):
            self._orders = order + 1
            if len(rate):
                np.maximum(self._peaks[order], np.abs(rate).max(axis=0), out=self._peaks[order])

    def result(self):
        """Return {"x": {"v", "a", "j"}, …, "path": {"a", "j"}}: 1 means at the limit.

        Where another control plans, only of limits that it has.
        """
        if self._orders == 2:
            return self._foreign()
        limits = np.stack([self._machine.limits(kind) for kind in ("v_max", "a_max", "j_max")])
        ratios = self._peaks[:, :-1] / limits
        peaks = {
            letter: dict(zip("vaj", map(float, ratios[:, k]), strict=True))
            for k, letter in enumerate(self._machine.axes)
        }
        path = self._machine.record["path"]
        peaks["path"] = {
            "a": float(self._peaks[1, -1] / path["a_max"]),
            "j": float(self._peaks[2, -1] / path["j_max"]),
        }
        return peaks

    def _foreign(self):
        limits, peaks = stretches.limits_of(self._machine), {}
        for k, track in enumerate([*self._machine.axes, "path"]):
            told = {kind: float(peak[k] / most[k])
                    for kind, most, peak in zip("va", limits, self._peaks, strict=False)
                    if np.isfinite(most[k])}  # fmt: skip
            peaks |= {track: told} if told else {}
        return peaks


class Ticks:
    """Where the ticks of a run went: to which limit, and at which source lines."""

    def __init__(self, machine):
        self._names, self._period = limit_names(machine), machine.period_s
        self._pages = {}  # limit code → number of a page of lines → ticks of each of them
        self.count = 0
        self.length_mm = 0.0

    def add(self, rows):
        """Count the next rows of a run (dtype ``sim_row_t``)."""
        pose = rows["pose"]
        self.count += len(rows)
        if len(rows):
            self.length_mm = float(pose["s"][-1])
        moves = pose["state"] != _TICK_STATES.IDLE
        codes, lines = pose["limit"][moves], pose["line"][moves].astype(np.int64)
        for code in np.unique(codes):
            self._count(self._pages.setdefault(int(code), {}), lines[codes == code])

    def _count(self, pages, lines):
        of_line = lines // _PAGE
        for page in np.unique(of_line):
            ticks = np.bincount(lines[of_line == page] - page * _PAGE, minlength=_PAGE)
            known = pages.setdefault(int(page), np.zeros(_PAGE, np.uint32))
            known += ticks.astype(np.uint32)

    @property
    def time_s(self):
        """Time of all ticks [s]."""
        return self.count * self._period

    def limit_time_s(self):
        """Return the time that each limit held the path [s], all names."""
        ticks = {
            code: sum(int(page.sum()) for page in pages.values())
            for code, pages in self._pages.items()
        }
        return {name: ticks.get(code, 0) * self._period for code, name in self._names.items()}

    def worst_lines(self, count=3):
        """Return limit name → [(source line, time in s)], the lines that it held longest."""
        worst = {}
        for code, pages in self._pages.items():
            found = []
            for page, ticks in pages.items():
                some = np.argsort(-ticks.astype(np.int64), kind="stable")[:count]
                found += [(-int(ticks[k]), page * _PAGE + int(k)) for k in some if ticks[k]]
            worst[self._names[code]] = [
                (line, -ticks * self._period) for ticks, line in sorted(found)[:count]
            ]
        return worst


def worst_lines(causes, machine, count=3):
    """Return limit name → [(source line, time lost there in s)], the worst low points' lines.

    Feeds and rapids are left out: what they hold most is not where they change.

    Parameters
    ----------
    causes : numpy.ndarray
        Of dtype ``nck_host_cause_t``.
    machine : Machine
    """
    names, found = limit_names(machine), {}
    for cause in causes:
        lines = found.setdefault(names[int(cause["limit"])], Counter())
        for place in cause["places"][: cause["place_count"]]:
            lines[int(place["line_worst"])] += float(place["lost_s"])
    held = found.keys() - {"feed", "rapid"}
    return {name: found[name].most_common(count) for name in held if found[name]}


def extra_times(tool_changes, spindle_starts, machine):
    """Return what takes time that no axis makes [s]."""
    times = machine.settings.times
    return {
        "tool_change_s": int(tool_changes) * float(times.tool_change_s),
        "spindle_s": int(spindle_starts) * float(times.spindle_start_s),
    }


def plan_times(totals, machine):
    """Return the sums of a plan as the JSON of ``time`` has them.

    Parameters
    ----------
    totals : numpy.void
        Of dtype ``nck_host_totals_t``.
    machine : Machine

    Returns
    -------
    dict
        Times in s, lengths in mm. ``time_s`` is that of the axes and of dwells, to the tick;
        ``total_s`` is it with tool changes and spindle starts.
    """
    names = ("time_s", "cut_s", "rapid_s", "dwell_s", "accelerate_s", "cruise_s", "decelerate_s")
    times = {name: float(totals[name]) for name in names}
    limits = {name: float(totals["limit_s"][code]) for code, name in limit_names(machine).items()}
    own = extra_times(totals["tool_changes"], totals["spindle_starts"], machine)
    return {
        **times,
        **own,
        "total_s": times["time_s"] + sum(own.values()),
        "tool_changes": int(totals["tool_changes"]),
        "spindle_starts": int(totals["spindle_starts"]),
        "blocks": int(totals["blocks"]),
        "segments": int(totals["segs"]),
        "length_mm": float(totals["length_mm"]),
        "limit_time_s": limits,
    }
