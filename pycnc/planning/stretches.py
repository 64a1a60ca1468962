# SPDX-License-Identifier: MIT
"""A run on another control: its plan, told once a period.

    stretches of constant acceleration ─▶ place, speed, acceleration at a time, in closed form

None of these controls limits jerk, so none is told, and what steps at a corner is no acceleration.
What they send to their motors, step by step, is not made.
"""

import math
from typing import NamedTuple

import numpy as np

from pycnc import errors, kernel
from pycnc.kernel.bind import lib
from pycnc.kernel.records import counts_per_unit, dtype, enum
from pycnc.machine.control import PRINTERS
from pycnc.machine.schema import AXES
from pycnc.planning import control

_ROWS = 16384  # samples at a time
_LATE = 1e-9  # of a period: so near its end a sample is on it
_MM, _RPM = 1e-9, 60.0
_STATES = enum("nck_tick_state_t")
_XYZ = slice(0, 3)


def simulation(program, prep_steps=kernel.PREP_STEPS, commands=()):
    """Return the run of a program on its machine's control, ours or another.

    Returns
    -------
    kernel.Simulation or Samples

    Raises
    ------
    ArgumentError
        If it is another control's, and something is asked for that this kernel alone does.
    """
    machine = program.machine
    if not control.is_foreign(machine):
        return kernel.Simulation(program.text, machine, prep_steps, commands)
    if commands:
        control.refuse(machine, "what an operator does meanwhile is told of")
    if prep_steps != kernel.PREP_STEPS:
        control.refuse(machine, "late preparation (--prep-steps) is told of")
    return Samples(program)


def limits_of(machine):
    """Return the highest speeds, and accelerations, of each axis and of the path.

    Returns
    -------
    v, a : numpy.ndarray
        In the order of the machine's axes, the path last [mm/s, mm/s², degrees]; infinite where
        the control has no such limit.
    """
    value = control.rule_of(machine)["value"][0].astype(float)
    places = [AXES.index(letter) for letter in machine.axes]
    v, a = (value[first : first + len(AXES)][places]
            for first in (lib.NCK_CONTROL_V, lib.NCK_CONTROL_A))  # fmt: skip
    along = [lib.NCK_CONTROL_A_PATH]
    if machine.settings.control.kind == "marlin":
        along += [lib.NCK_CONTROL_A_TRAVEL, lib.NCK_CONTROL_A_RETRACT]
    path = np.array([value[lib.NCK_CONTROL_V_PATH], value[along].max()])
    if machine.settings.control.kind == "klipper":
        tool = np.array([letter in "xyz" for letter in machine.axes])
        for limits, most in zip((v, a), path, strict=True):  # an axis has no more than the path
            limits[tool] = np.minimum(limits[tool], most)
    both = (np.append(v, path[0]), np.append(a, path[1]))
    return tuple(np.where(limits < control.FREE, limits, np.inf) for limits in both)


def _row_dtype(axes):
    """Return the dtype ``sim_row_t`` with speed and acceleration of the axes and of the path."""
    fields = dtype("sim_row_t").fields
    rates = [(name, "f8", (axes + 1,)) for name in ("speed", "acceleration")]
    return np.dtype([*((name, fields[name][0]) for name in fields), *rates])


class _Way(NamedTuple):
    """Where stretches begin, on the way and along the program, and how far they go on."""

    place: np.ndarray
    way: np.ndarray
    s: np.ndarray
    more: np.ndarray


class Samples:
    """A run of a program on another control, in the place of `kernel.Simulation`.

    Attributes
    ----------
    starved_ticks, end
        As of `kernel.Simulation`: no sample comes late, and the program ends.
    """

    starved_ticks, end = 0, "done"

    def __init__(self, program):
        self._program, machine = program, program.machine
        self._period, self._tick = machine.period_s, 0
        self._places = [AXES.index(letter) for letter in machine.axes]
        self._dtype = _row_dtype(len(self._places))
        rotary = machine.record["axis"]["rotary"]
        self._counts = counts_per_unit(rotary)[self._places]
        self._prints = machine.settings.control.kind in PRINTERS
        self._at, self._s = machine.record["start_nm"] / counts_per_unit(rotary), 0.0

    def pieces(self):
        """Yield (rows, bytes used): one row a period, as `kernel.Simulation.pieces` does.

        The rows have speed and acceleration beside: within a line, as it is planned.
        """
        planner = control.Planner(self._program, traced=True)
        size, count, done = len(self._program.text), max(self._program.block_count, 1), 0
        last = None
        for stretches, _ in planner.pieces():
            if not len(stretches):
                continue
            done = int(stretches["block"][-1])
            for rows in self._sampled(stretches):
                yield rows, min(size, size * done // count)
            last = stretches[-1:].copy()
        if last is not None and self._tick < self._ticks(last["end"]["t"][0], math.ceil):
            yield self._last(last), size

    def _ticks(self, time_s, whole):
        """Return how many periods a time has: `whole` rounds."""
        nearest = round(time_s / self._period)
        near = abs(time_s - nearest * self._period) <= _LATE * self._period
        return nearest if near else whole(time_s / self._period)

    def _last(self, stretch):
        """Return the row behind the end of the program: at rest where it has come to."""
        begun = _Way(self._at[None], np.zeros((1, len(AXES))), np.array([self._s]), np.zeros(1))
        row = self._rows(stretch, begun, stretch["duration"])
        row["pose"]["v"] = row["speed"] = row["acceleration"] = 0
        return row

    def _sampled(self, stretches):
        """Yield rows of the periods that end in stretches."""
        ends, places = stretches["end"]["t"], np.vstack([self._at, _places(stretches)])
        ways = np.diff(places, axis=0)
        s = np.append(self._s, stretches["s"])
        last = self._ticks(ends[-1], math.floor)
        while self._tick < last:
            count = min(_ROWS, last - self._tick)
            t = (self._tick + 1 + np.arange(count)) * self._period
            k = np.minimum(np.searchsorted(ends, t), len(ends) - 1)
            tau = t - ends[k] + stretches["duration"][k]
            yield self._rows(stretches[k], _Way(places[k], ways[k], s[k], np.diff(s)[k]), tau)
        self._at, self._s = places[-1], s[-1]

    def _rows(self, some, begun, tau):
        """Return rows of samples, of times since their stretches have begun."""
        rows, (share, v) = np.zeros(len(some), self._dtype), _share(some, tau)
        end, pose = some["end"], rows["pose"]
        rows["t_s"] = (self._tick + 1 + np.arange(len(rows))) * self._period
        self._tick += len(rows)
        for name, values in (
            ("line", end["line"]), ("block", some["block"]), ("kind", some["kind"]),
            ("rapid", end["rapid"]), ("limit", end["limit"]), ("v", v), ("feed", end["feed"]),
            ("feed_scale", 1.0), ("spindle_rpm", some["spindle_rpm"]),
            ("state", np.where(end["rests"] == 1, _STATES.DWELL, _STATES.MOVE)),
            ("s", begun.s + share * begun.more),
        ):  # fmt: skip
            pose[name] = values
        places = begun.place + share[:, None] * begun.way
        pose["axis"][:, : len(AXES)] = places
        junctions = np.rint(places[:, self._places] * self._counts)
        rows["axes"]["joint_nm"][:, : len(self._places)] = junctions
        rows["spindle_rpm"] = some["spindle_rpm"]
        rows["feed_percent"] = rows["rapid_percent"] = 100
        self._put_rates(rows, some, begun.way, v)
        return rows

    def _put_rates(self, rows, some, way, v):
        """Speed and acceleration: along the stretch, and of it the axes' shares."""
        length = 0.5 * (some["v_begin"] + some["end"]["v"]) * some["duration"]
        moves = length > _MM
        safe = np.where(moves, length, 1.0)
        change = some["end"]["v"] - some["v_begin"]
        a = np.where(moves, change / np.where(moves, some["duration"], 1.0), 0.0)
        units = np.where(moves[:, None], way / safe[:, None], 0.0)[:, self._places]
        along = np.ones(len(some))
        if self._prints:  # filament alone is none of the path's
            along = (np.abs(way[:, _XYZ]).max(axis=1) > _MM).astype(float)
        units = np.column_stack([units, along])
        rows["speed"], rows["acceleration"] = (rate[:, None] * units for rate in (v, a))


def _places(stretches):
    """Return where stretches end, a column for each axis."""
    end = stretches["end"]
    return np.hstack([end["xyz"], end["abc"], stretches["uvw"]])


def _share(some, tau):
    """Return how far along stretches times in them are, 0 … 1, and the speeds there."""
    duration, v_begin = some["duration"], some["v_begin"]
    tau = np.clip(tau, 0.0, duration)
    whole = np.where(duration > 0, duration, 1.0)
    rise = (some["end"]["v"] - v_begin) / whole
    length = 0.5 * (v_begin + some["end"]["v"]) * duration
    way = (v_begin + 0.5 * rise * tau) * tau
    # Without a speed it is at rest, or with the spindle.
    share = np.where(length > 0, way / np.where(length > 0, length, 1.0), tau / whole)
    return np.clip(share, 0.0, 1.0), v_begin + rise * tau
