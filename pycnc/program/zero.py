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
from pycnc.kernel.bind import lib
from pycnc.machine import Machine
from pycnc.machine.quantity import TRAVEL_LIMIT
from pycnc.machine.schema import AXES, WORK_SYSTEMS, position_key, unit_of
from pycnc.program.reach import free_reach_of, line_beyond, reach_of

# Words that lead to places of the machine, which stay where they are when the work is moved.
_OF_MACHINE = re.compile(rb"G *0*(28|30|53)(?![\d])", re.I)
# Fanuc's further work systems: G54.1 P, G54 P; Haas' G154 P, of which G110 … are the first ones.
_FURTHER = re.compile(rb"G *0*(?:(?:54(?:\.1)?|154) *P *0*(\d+)|1([12]\d)(?![\d.]))", re.I)
# Two places of the zero by which those are told from the work's, and no program has them. [mm]
_ZEROS = Decimal("137.035999"), Decimal("271.828183")
_FREE = Decimal(-TRAVEL_LIMIT), Decimal(TRAVEL_LIMIT)
_REMEDY = "--zero X,Y,Z says where the program's zero lies, in machine coordinates"


class Placed(NamedTuple):
    """What came of it: a machine, and what is to be said."""

    machine: Machine
    identity: str = ""
    severity: str = ""
    message: str = ""
    remedy: str = ""
    line: int = 0


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


def _numbers_further(text, work):
    """Return the further work systems that a text names and nobody has laid, as many as fit."""
    named = {int(p or int(g) - 9) for p, g in _FURTHER.findall(text)}
    laid = set(map(int, work.p))
    numbers = sorted(named.intersection(range(1, lib.NCK_WORK_MOST + 1)) - laid)
    return numbers[: lib.NCK_OWN_M_MAX - len(laid)]


def further(text, machine):
    """Return a machine whose further work systems lie where all others do.

    Of those that the text names and nobody has laid elsewhere. Where the others lie apart, nothing
    is known of them.
    """
    work = machine.settings.work
    if machine.settings.dialect.base != "fanuc":
        return machine
    first, *others = (getattr(work, name) for name in WORK_SYSTEMS)
    numbers = _numbers_further(text, work)
    if not numbers or others != [first] * len(others):
        return machine
    at = {position_key(letter): first.along(letter) for letter in machine.axes}
    told = {f"work.p.{number}.{key}": value for number in numbers for key, value in at.items()}
    return Machine.load(machine, set=told)


def place(text, machine):
    """Return a machine with a zero from which a program fits its travel, as `Placed`.

    It begins at that zero; where the travel does not have it, a program that goes elsewhere by
    rapids first begins at the end of the first one.
    """
    ends = _ends(machine.settings)
    zeros = {letter: _zero(machine.settings, letter) for letter in machine.axes}
    if not ends:
        return Placed(_laid(machine, zeros))
    bare = {key: "free" for letter in ends for key in _end_keys(letter)}
    bare["dialect.from_line"] = 0  # wherever it begins, the work lies where the whole of it fits
    where = _zeros_tried(text)
    found = reach_of(text, [_at(machine, at, bare) for at in where], _floats(where))
    if found.has_errors:  # they are told where they are, and no others that come of them
        return Placed(_laid(machine, zeros, bare))
    return _within(text, machine, bare, ends, found, zeros)


def _within(text, machine, bare, ends, found, zeros):
    """Return a machine whose travel has what a program reaches, or what is too large."""
    needs = {letter: found.need(letter, found.cuts[AXES.index(letter)]) for letter in ends}
    spans = {letter: found.need(letter, True) for letter in ends}
    begins = _begins(text, machine, bare, _narrow(spans, ends), needs, ends)
    spans |= {letter: needs[letter] for letter in begins}
    narrow = _narrow(spans, ends)
    if not narrow:
        zeros |= {letter: _between(spans[letter], ends[letter], zeros[letter]) for letter in ends}
        return _fitting(machine, zeros, begins, needs, ends)
    too_long = _narrow(needs, ends)
    begun = [each for each in narrow if found.cuts[AXES.index(each)] or each not in too_long]
    needs |= {letter: spans[letter] for letter in begun}
    begin = [0.0] if narrow[0] in begun else []
    line = _line_beyond(text, machine, bare, narrow[0], ends, begin)
    return _too_large(_laid(machine, zeros, bare), needs, ends, narrow, line, begun)


def _ends(settings):
    """Return letter → both ends of its travel, of the axes that have any."""
    ends = {letter: _travel(axis, letter) for letter, axis in settings.axis.present().items()}
    return {letter: pair for letter, pair in ends.items() if pair != _FREE}


def _narrow(needs, ends):
    """Return the axes whose travel is less than what a program needs."""
    return [letter for letter in ends if not _fits(needs[letter], ends[letter])]


def _fitting(machine, zeros, begins, needs, ends):
    """Return a machine whose work lies there, and what is said of it."""
    start = {letter: at + zeros[letter] * is_work for letter, (at, is_work) in begins.items()}
    words = f"needs {_size(needs)}: fits into {_size(ends)}"
    words += "; where the work lies is not known, and it is taken to lie so"
    if start:
        words += f"; where {_named(start)} begins neither: the first way there is not counted"
    return Placed(_laid(machine, zeros, (), start), "work-zero", "note", words, _REMEDY)


def _begins(text, machine, bare, narrow, needs, ends):
    """Return letter → (place, whether it is the work's) where axes begin that may do so anywhere.

    What these need is put among the needs.
    """
    if not narrow:
        return {}
    where, off = _zeros_tried(text), _ZEROS[1] - _ZEROS[0]
    start = {letter: where[0] + off for letter in narrow}
    machines = [*(_at(machine, at, bare) for at in where), _at(machine, where[0], bare, start)]
    shift = np.array([float(off) if letter in narrow else 0.0 for letter in AXES])
    found = free_reach_of(text, machines, _floats([*where, where[0]]), shift)
    begins = {}
    for letter in narrow:
        k = AXES.index(letter)
        need = found.need(letter, False)
        if k not in found.first or found.hangs[k] or found.cuts[k]:
            continue
        needs[letter] = need
        if _fits(need, ends[letter]):
            at, is_work = found.first[k]
            begins[letter] = round(Decimal(at if is_work else at + float(where[0])), 6), is_work
    return begins


def _line_beyond(text, machine, bare, letter, ends, begin):
    room, at = float(ends[letter][1] - ends[letter][0]), _ZEROS[0]
    return line_beyond(text, _at(machine, at, bare), float(at), letter, room, begin)


def _zeros_tried(text):
    """Return places of the zero by which the machine's places are told from the work's."""
    plain = isinstance(text, kernel.Blocks) or not _OF_MACHINE.search(text)
    return _ZEROS[:1] if plain else _ZEROS


def _at(machine, at, more, start=()):
    return _laid(machine, dict.fromkeys(machine.axes, at), more, start)


def _floats(places):
    return [float(at) for at in places]


def _fits(need, ends):
    return need[1] - need[0] <= ends[1] - ends[0]


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


def _laid(machine, zeros, more=(), start=()):
    """Return a machine whose work lies elsewhere: letter → zero. It begins there; start: or here"""
    told = {"work.zero": "told"} | _zeros(machine, zeros) | dict(more)
    begin = zeros | dict(start)
    told |= {f"start.{position_key(letter)}": at for letter, at in begin.items()}
    return Machine.load(machine, set=told)


def _between(span, ends, zero):
    """Return a zero from which a span is within the travel: near its own one, whole if it can be.

    A whole number keeps whole steps what they are.
    """
    low, high = ends[0] - span[0], ends[1] - span[1]
    at = min(max(zero, low), high)
    whole = at.to_integral_value(ROUND_FLOOR if at == high else ROUND_CEILING)
    return whole if low <= whole <= high and at != zero else at


def _size(spans):
    sizes = (high - low for low, high in spans.values())
    told = (f"{float(round(size, 2)):g}" if size < TRAVEL_LIMIT else "free" for size in sizes)
    return f"{' × '.join(told)} {_units(spans)}"


def _units(spans):
    return "/".join(dict.fromkeys(unit_of(letter) for letter in spans))


def _too_large(machine, needs, ends, narrow, line, begun):
    """Say once that a program needs more room than there is, and by which line."""
    lacks = ", ".join(
        f"{letter.upper()} has {float(ends[letter][1] - ends[letter][0]):g}" for letter in narrow
    )
    counted = f", with its zero, where {_named(begun)} begins" if begun else ""
    message = f"needs {_size(needs)}{counted}: does not fit, {lacks}"
    key = f"axis.{narrow[0]}.max_{unit_of(narrow[0])}"
    remedy = f"if the machine has more: --set {key}=…; another unit than the program's: G20, G21"
    return Placed(machine, "travel", "error", message, remedy, line)


def _named(letters):
    return " and ".join(letter.upper() for letter in letters)
