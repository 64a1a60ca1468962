# SPDX-License-Identifier: MIT
"""Where the work lies, if nobody says: its zero is laid so that the program fits the travel.

A configuration of a control has no work zero: whoever clamps the work sets it. What can be told
without it is how much room a program needs, and whether the machine has it.
"""

import re
from decimal import ROUND_CEILING, ROUND_FLOOR, Decimal
from typing import NamedTuple

import numpy as np

from pycnc import errors, kernel
from pycnc.kernel.records import copied, join
from pycnc.machine import Machine
from pycnc.machine.quantity import TRAVEL_LIMIT
from pycnc.machine.schema import AXES, WORK_SYSTEMS, position_key, unit_of
from pycnc.program.geometry import Moves, is_move

# Words that lead to places of the machine, which stay where they are when the work is moved.
_OF_MACHINE = re.compile(rb"G *0*(28|30|53)(?![\d])", re.I)
# Two places of the zero by which those are told from the work's, and no program has them. [mm]
_ZEROS = Decimal("137.035999"), Decimal("271.828183")
_FREE = Decimal(-TRAVEL_LIMIT), Decimal(TRAVEL_LIMIT)
_SAME = 1e-6  # mm: the kernel counts nanometres
_REMEDY = "--zero X,Y,Z says where the program's zero lies, in machine coordinates"


class Placed(NamedTuple):
    """What came of it: a machine, and what is to be said."""

    machine: Machine
    identity: str = ""
    severity: str = ""
    message: str = ""
    remedy: str = ""


def changes(words, machine):
    """Return the changes that say where the zero of all work systems lies.

    Parameters
    ----------
    words : str
        ``X,Y,Z``, as many as wanted of the machine's axes, in their order.

    Raises
    ------
    ArgumentError
    """
    try:
        places = [Decimal(word) for word in words.split(",")]
        good = all(place.is_finite() for place in places)
    except ArithmeticError:
        places, good = [], False
    letters = machine.axes
    if not good or len(places) > len(letters):
        named = ",".join(letters).upper()
        raise errors.ArgumentError(
            f"--zero {words!r}: must be numbers such as -200,-150,-40, one for each of {named}",
            id="zero",
        )
    said = dict(zip(letters, places, strict=False))
    return {"work.zero": "told"} | _zeros(machine, said)


def _narrow(needs, ends):
    """Return the axes whose travel is less than what a program needs."""
    return [letter for letter, (low, high) in needs.items()
            if high - low > ends[letter][1] - ends[letter][0]]  # fmt: skip


def place(text, machine):
    """Return a machine with a zero from which a program fits its travel, as `Placed`."""
    settings = machine.settings
    ends = {letter: _travel(axis, letter) for letter, axis in settings.axis.present().items()}
    ends = {letter: pair for letter, pair in ends.items() if pair != _FREE}
    begin = {letter: _zero(settings, letter) for letter in machine.axes}
    free = {key: "free" for letter in ends for key in _end_keys(letter)}
    if not ends:
        return Placed(_laid(machine, begin))
    low, high = _reach(text, machine, free)
    needs = {letter: _need(low, high, letter) for letter in ends}
    if narrow := _narrow(needs, ends):
        return _too_large(_laid(machine, begin, free), needs, ends, narrow)
    begin |= {letter: _between(needs[letter], ends[letter], begin[letter]) for letter in ends}
    size = f"needs {_size(needs)}: fits into {_size(ends)}"
    return Placed(
        _laid(machine, begin, (), ends), "work-zero", "note",
        f"{size}; where the work lies is not known, and it is taken to lie so", _REMEDY,
    )  # fmt: skip


def _zeros(machine, places):
    """Return the changes that lay the zero of every work system: letter → its place."""
    names = [*WORK_SYSTEMS, *(f"p.{number}" for number in machine.settings.work.p)]
    return {f"work.{name}.{position_key(letter)}": at
            for name in names for letter, at in places.items()}  # fmt: skip


def _travel(axis, letter):
    ends = (getattr(axis, f"{end}_{unit_of(letter)}") for end in ("min", "max"))
    return tuple(free if end is None else end for end, free in zip(ends, _FREE, strict=True))


def _end_keys(letter):
    return [f"axis.{letter}.{end}_{unit_of(letter)}" for end in ("min", "max")]


def _zero(settings, letter):
    """Return where the zero of the work system in force lies, as the file has it."""
    return getattr(settings.work, settings.start.work_system).along(letter)


def _need(low, high, letter):
    """Return from where to where a program goes along an axis; nowhere: (0, 0)."""
    k = AXES.index(letter)
    if low[k] > high[k]:
        return Decimal(0), Decimal(0)
    return tuple(round(Decimal(float(end)), 6) for end in (low[k], high[k]))


def _reach(text, machine, free):
    """Return the least and the largest place of the work along every axis, from its zero."""
    zeros = _ZEROS
    if isinstance(text, kernel.Blocks) or not _OF_MACHINE.search(text):
        zeros = _ZEROS[:1]
    machines = [_laid(machine, dict.fromkeys(machine.axes, at), free) for at in zeros]
    low, high = np.full(len(AXES), np.inf), np.full(len(AXES), -np.inf)
    for points, is_work in _corners(text, machines, [float(at) for at in zeros]):
        low = np.minimum(low, np.where(is_work, points, np.inf).min(axis=0, initial=np.inf))
        high = np.maximum(high, np.where(is_work, points, -np.inf).max(axis=0, initial=-np.inf))
    return low, high


def _laid(machine, zeros, more=(), ends=None):
    """Return a machine whose work lies elsewhere: letter → zero. It begins there, or near it."""
    start = dict(zeros)
    for letter, (low, high) in (ends or {}).items():
        start[letter] = min(max(zeros[letter], low), high)
    told = {"work.zero": "told"} | _zeros(machine, zeros) | dict(more)
    told |= {f"start.{position_key(letter)}": at for letter, at in start.items()}
    return Machine.load(machine, set=told)


def _corners(text, machines, zeros):
    """Yield (points from the zero, which of them are the work's) of a program, piece by piece."""
    before = [None] * len(machines)
    for pieces in zip(*(kernel.decode(text, each) for each in machines), strict=False):
        found = []
        for k, (blocks, *_) in enumerate(pieces):
            rows = copied(blocks)
            if before[k] is not None:
                rows = join("nck_block_t", [before[k], rows])
            moves = Moves(rows, machines[k])
            points, owners = moves.corners()
            found.append(points[owners >= (before[k] is not None)] - zeros[k])
            before[k] = _last_move(rows)
        if len({len(points) for points in found}) > 1:  # where they part nothing is known
            return
        is_work = np.ones(found[0].shape, bool)
        for points in found[1:]:
            is_work &= np.abs(points - found[0]) < _SAME
        yield found[0], is_work


def _last_move(rows):
    """Return the last block that moves, where the next piece begins; None: none yet."""
    moves = np.flatnonzero(is_move(rows))
    return rows[moves[-1] : moves[-1] + 1] if moves.size else None


def _between(need, ends, zero):
    """Return a zero from which a need is within the travel: near its own one, whole if it can be.

    A whole number keeps whole steps what they are.
    """
    down, up = min(need[0], Decimal(0)), max(need[1], Decimal(0))
    if up - down > ends[1] - ends[0]:
        down, up = need
    low, high = ends[0] - down, ends[1] - up
    at = min(max(zero, low), high)
    whole = at.to_integral_value(ROUND_FLOOR if at == high else ROUND_CEILING)
    return whole if low <= whole <= high and at != zero else at


def _size(spans):
    sizes = (high - low for low, high in spans.values())
    told = (f"{float(round(size, 2)):g}" if size < TRAVEL_LIMIT else "free" for size in sizes)
    return f"{' × '.join(told)} {_units(spans)}"


def _units(spans):
    return "/".join(dict.fromkeys(unit_of(letter) for letter in spans))


def _too_large(machine, needs, ends, narrow):
    """Say once that a program needs more room than there is."""
    lacks = ", ".join(
        f"{letter.upper()} has {float(ends[letter][1] - ends[letter][0]):g}" for letter in narrow
    )
    message = f"needs {_size(needs)}: does not fit, {lacks}"
    key = f"axis.{narrow[0]}.max_{unit_of(narrow[0])}"
    remedy = f"if the machine has more: --set {key}=…; another unit than the program's: G20, G21"
    return Placed(machine, "travel", "error", message, remedy)
