# SPDX-License-Identifier: MIT
"""What a text is for: a print, turning, an axis that turns, a laser; and who reads it."""

import re
from collections import namedtuple

from pycnc.program.guess import beginning, dialect_of

_REMARKS = re.compile(rb"\([^)]*\)|;.*")
_MACROS = re.compile(
    rb"(EXCLUDE_OBJECT|PRINT_START|START_PRINT|BED_MESH|SET_[A-Z]{2})\w*( |$)", re.IGNORECASE
)
_PRINTS = re.compile(
    rb"(N\d+ *)?(M(104|109|140|190)\b(?! *P)(?=.*[SR] *\d)|G1 .*\bE-?[\d.])|" + _MACROS.pattern,
    re.IGNORECASE,
)  # fmt: skip
_TURNS = re.compile(rb"G96\b|G50 *S|\bT\d{4}\b|G7[0-3]\b.*\b[PQ] *\d+|\b[UW]-?[\d.]", re.IGNORECASE)
_FANUCS_TURNS = re.compile(rb"G50 *S|\bT\d{4}\b|\b[UW]-?[\d.]", re.IGNORECASE)
_CROSS = re.compile(rb"\bY *-?[\d.]", re.IGNORECASE)
_ROTARY = re.compile(rb"(?<![A-Z,])([ABC]) *-?[\d.]", re.IGNORECASE)

_SPINDLE = re.compile(rb"(?<![A-Z])M0?[34](?!\d)", re.IGNORECASE)
_SPEED = re.compile(rb"(?<![A-Z])S *(?!0*\.?0*(?:[^\d.]|$))[\d.]+", re.IGNORECASE)
_HEIGHT = re.compile(rb"(?<![A-Z])Z *[-+]?[\d.]", re.IGNORECASE)
_BEAM = re.compile(rb"(?:N\d+ *)?(?:G0?1(?!\d)|[XY] *-?[\d.])[^S]*S *(\d+\.?\d*)", re.IGNORECASE)
_DEPTH = re.compile(rb"Z *-", re.IGNORECASE)
_BEAMS, _POWERS = 3, 2  # cuts that say S, and with how many values, that no spindle is told

# name: as a person says it; line, source: where it shows; options: of the command that reads it;
# cures: the ids of the findings that this command has not; none: it is said without one, too.
Kind = namedtuple("Kind", "name line source options cures")

_STRANGE_TO_MACROS = frozenset({"expression"})
_STRANGE_TO_LATHES = frozenset({"tool-unknown", "comp-radius", "comp-entry"})
_STRANGE = frozenset({"axis-unknown", "word-unknown", "other-base", "m-unknown", "word-unused",
                      "number", "character", "unsupported"})  # fmt: skip


def kind_of(text, machine):
    """Return what a text is for if the machine is no such one; None: nothing tells, or it is."""
    lines = [_REMARKS.sub(b"", line).strip() for line in beginning(text)]
    kinds = (_print, _turning, _rotary, _laser, _fanuc)
    return next((seen for kind in kinds if (seen := kind(lines, machine))), None)


def _first(lines, sign):
    return next(((n, line) for n, line in enumerate(lines, 1) if sign.match(line)), None)


def _print(lines, machine):
    found = _first(lines, _MACROS)
    if found and machine.settings.control.kind != "klipper":
        cures = _STRANGE | _STRANGE_TO_MACROS
        return Kind("a Klipper print", *found, "-m printer_klipper", cures)
    found = _first(lines, _PRINTS)
    if not found or (machine.settings.dialect.base == "marlin" and "u" in machine.axes):
        return None
    return Kind("a print", *found, "-m printer_marlin", _STRANGE)


def _turning(lines, machine):
    sign = next(((n, line) for n, line in enumerate(lines, 1) if _TURNS.search(line)), None)
    across = any(_CROSS.search(line) for line in lines)
    lathe = machine.settings.kinematics.type == "lathe_xz"
    if lathe or across or not sign:
        return None
    dialect, told, _ = dialect_of(b"\n".join(lines))
    fanuc = dialect == "fanuc" or (not told and any(map(_FANUCS_TURNS.search, lines)))
    options = "-m lathe_fanuc" if fanuc else "-m cak6150n --dialect linuxcnc"
    return Kind("a lathe's program", *sign, options, _STRANGE | _STRANGE_TO_LATHES)


def _rotary(lines, machine):
    found = [(number, line) for number, line in enumerate(lines, 1) if _ROTARY.search(line)]
    letters = {match[1].decode().lower() for _, line in found for match in _ROTARY.finditer(line)}
    if len(found) < 2 or letters <= set(machine.axes) or not letters <= {"a", "c"}:
        return None
    options = "-m mill4" if letters == {"a"} else "-m mill5_xyzac"
    if dialect_of(b"\n".join(lines))[0] == "fanuc":
        options += " --dialect fanuc"
    return Kind("a program for axes that turn", *found[0], options, {"axis-unknown"})


def _laser(lines, machine):
    found = [(n, line, power[1]) for n, line in enumerate(lines, 1) if (power := _BEAM.match(line))]
    deep = any(_DEPTH.search(line) for line in lines)
    laser = machine.settings.control.laser_mode or machine.settings.kinematics.type == "lathe_xz"
    varies = len(found) >= _BEAMS and len({power for *_, power in found}) >= _POWERS
    if laser or deep or not found or not (varies or _is_flat(lines)):
        return None
    return Kind("a laser's program", *found[0][:2], "-m laser", frozenset())


def _fanuc(lines, machine):
    """Return what a mill's program of Fanuc's language is, which RS274NGC's words do not read."""
    dialect, number, _ = dialect_of(b"\n".join(lines))
    base, is_lathe = machine.settings.dialect.base, "y" not in machine.axes
    if dialect != "fanuc" or base == "fanuc" or is_lathe:
        return None
    turns = any(map(_ROTARY.search, lines))
    options = "--dialect fanuc" if turns else "-m haas_vf2"
    return Kind("a program for Fanuc's control, or Haas'", number, lines[number - 1], options,
                {"other-base", "word-unused", "word-missing", "spline"})  # fmt: skip


def _is_flat(lines):
    """Tell whether a text has no height, and a power that is first said by a cut, as no spindle's
    speed is."""
    first = next((line for line in lines if _SPEED.search(line)), b"")
    turns, high = (any(map(sign.search, lines)) for sign in (_SPINDLE, _HEIGHT))
    return bool(_BEAM.match(first)) and turns and not high
