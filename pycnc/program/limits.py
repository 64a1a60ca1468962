# SPDX-License-Identifier: MIT
"""Limits that a program itself sets (M201 to M205, SET_VELOCITY_LIMIT), and Klipper's macros."""

import re
from collections import Counter

import numpy as np

from pycnc.kernel.bind import lib
from pycnc.kernel.records import dtype
from pycnc.machine.control import NCKS, PRINTERS
from pycnc.machine.schema import AXES
from pycnc.program.states import RESTORE, restored

# Commands of Klipper that move nothing, by how their names begin.
STILL = (
    "SET_VELOCITY_LIMIT", "SET_PRESSURE_ADVANCE", "EXCLUDE_OBJECT", "SET_INPUT_SHAPER", "SET_PIN",
    "SET_HEATER_TEMPERATURE", "SET_TEMPERATURE", "SET_FAN_SPEED", "SET_LED", "SET_DISPLAY",
    "SET_GCODE_VARIABLE", "SAVE_VARIABLE", "SAVE_GCODE_STATE", "SET_RETRACTION", "SET_TMC",
    "SET_IDLE_TIMEOUT", "SET_PRINT_STATS_INFO", "SET_STEPPER_ENABLE", "TURN_OFF_HEATERS",
    "TEMPERATURE_WAIT", "ACTIVATE_EXTRUDER", "BED_MESH_PROFILE", "BED_MESH_CLEAR", "RESPOND",
    "STATUS", "M211", "SET_FILAMENT_SENSOR", "QUERY", "GET_POSITION", "SET_SERVO", "SET_DIGIPOT",
    "SET_SKEW", "SKEW_PROFILE", "SYNC_EXTRUDER_MOTION", "SET_EXTRUDER_ROTATION_DISTANCE",
)  # fmt: skip
# Long enough to be no word of a letter and a number, and no O word; M211 Klipper does not know.
_MACRO = re.compile(
    rb"(?m)^([ \t]*)([A-Za-z_][A-Za-z_][A-Za-z0-9_]*|[Mm]211|@\w+)(?=[ \t;#\r\n]|\Z)"
)
# Bambu's firmware is Marlin's but for these: codes of its own, and others with words of its own.
_IS_BAMBU = re.compile(rb"(?m)^[ \t]*M1002\b")
_BEGINNING = 1 << 18  # bytes in which a print shows whose it is
_BAMBU = re.compile(
    rb"(?m)^([ \t]*)(M(?:73\.2|62\d(?:\.\d+)?|63\d|9[6-9]\d{1,2}(?:\.\d+)?|100\d)|T255|T1000"
    rb"|G(?:29\.\d|38[03]|39(?:\.\d|2)?|150\.\d|2814)|M221(?=[ \t]+[XYZ])|M400(?=[ \t]+[SPU])"
    rb"|G28(?=[^\n;]*[ \t][PT]\d))(?=[ \t;\r\n]|\Z)"
)
_BAMBU_STILL = frozenset(
    "M1002 M1003 M1004 M1006 M1007 M73.2 M960 M975 M981 M982 M982.2 M982.4 M991 M622 M623 M624 "
    "M625 M628 M629 M630 M221 G29.1 G29.2 G392 T255 T1000".split()
)
# What a host hears, and never sends; ways of Prusa's firmware with filament; RepRapFirmware's
# macros, which lie in files of the printer.
_HOST = re.compile(
    rb"(?m)^([ \t]*)(@\w+|T[xc?](?=[ \t;\r\n]|\Z)|M70[12](?![\d.])|M98(?=[ \t]*P[ \t]*\"))"
)
_LIMIT = re.compile(
    rb"(?im)^[ \t]*(?:N\d+[ \t]*)?(?:M[ \t]*(20[1345]|566)(?![.\d])|(SET_VELOCITY_LIMIT)\b)"
    rb"([^\n;(]*)"
)
_WORD = re.compile(rb"([A-Z])[ \t]*([+-]?(?:\d+\.?\d*|\.\d+))")
_PAIR = re.compile(rb"(\w+)[ \t]*=[ \t]*([+-]?(?:\d+\.?\d*|\.\d+))")
_VELOCITY_LIMIT = {
    b"VELOCITY": lib.NCK_CONTROL_V_PATH,
    b"ACCEL": lib.NCK_CONTROL_A_PATH,
    b"SQUARE_CORNER_VELOCITY": lib.NCK_CONTROL_CORNER,
    b"MINIMUM_CRUISE_RATIO": lib.NCK_CONTROL_CRUISE_RATIO,
}
_BY_AXIS = {b"201": lib.NCK_CONTROL_A, b"203": lib.NCK_CONTROL_V, b"205": lib.NCK_CONTROL_JERK}


class Veiled(bytes):
    """A text whose macros are comments, so that what moves can be read; `original` has them."""


def _macros(text, machine):
    """Return (what finds lines that a control's firmware alone knows, which of them move nothing,
    whether a name stands for all that begin with it and _)."""
    kind = machine.settings.control.kind
    if kind == "klipper":
        return _MACRO, STILL, True
    if kind == "marlin" and _IS_BAMBU.search(text[:_BEGINNING]):
        return _BAMBU, _BAMBU_STILL, False
    is_print = machine.settings.dialect.base == "marlin"
    if is_print and (b"@" in text or _HOST.search(text[:_BEGINNING])):
        return _HOST, (), False
    return None, (), False


def veil(text, machine):
    """Return (text for the kernel, findings) of a program for a machine.

    A finding is (line, id, name, how many lines): of each macro its first line. Klipper has macros:
    of its own commands some are known to move nothing, of the printer's own macros the machine file
    tells (``control.still_macros``). So it is with codes that Bambu's firmware alone has.
    """
    original = getattr(text, "original", text)
    found, known, begins = _macros(original, machine)
    if found is None:
        return text, []
    still = {name.upper() for name in machine.settings.control.still_macros}
    counts, firsts = Counter(), {}

    def hide(match):
        name = match[2].decode().upper()
        if name == "M400" and match.string[match.end() :].lstrip()[:1] in b"SP":
            return match[1] + b"  G4"  # M400 S5 waits so long
        counts[name] += 1
        firsts.setdefault(name, match.start())
        return match[1] + b";" + match[2][1:]

    plain, places = restored(original) if begins else (original, [])
    hidden = found.sub(hide, plain)
    if hidden == original and not places:
        return original, []
    veiled = Veiled(hidden)
    veiled.original = original
    findings = []
    for name, place in sorted(firsts.items(), key=lambda item: item[1]):
        is_known = any(f"{name}_".startswith(f"{each}_") if begins else name == each
                       for each in known)  # fmt: skip
        is_known |= name[0] == "@"
        line = original.count(b"\n", 0, place) + 1
        identity = "macro-still" if is_known or name in still else "macro-own"
        findings.append((line, identity, name, counts[name]))
    if places:
        line = original.count(b"\n", 0, places[0]) + 1
        findings.append((line, "macro-still", RESTORE, len(places)))
    return veiled, findings


def words_of(identity, name, count):
    """Return what is said of a macro, and the remedy."""
    lines = f"on {count:,} lines" if count > 1 else "on one line"
    if name == "M622":
        return f"{name}, {lines}: what follows up to M623 is taken as done", ""
    if name == "SET_VELOCITY_LIMIT":
        return f"{name}, {lines}: moves nothing; its limits hold from there on", ""
    if identity == "macro-still" and name == RESTORE:
        return f"{name}, {lines}: moves nothing; what was saved holds from there on", ""
    if identity == "macro-still":
        return f"{name}, {lines}: moves nothing, and is skipped", ""
    return (
        f"{name}, {lines}: a macro of the printer's own, whose moves are not in the time",
        f'if it moves nothing, say so: control.still_macros = ["{name}"]',
    )


def heard(findings, machine):
    """Return what holds of the kernel's findings (dtype ``nck_diagnostic_t``) with a machine's
    control: no slope is in force where another one plans; of a printer's planner the limits that a
    program sets are, and no note; Klipper takes no feed of 0 or less and no place out of range, and
    ends the print there."""
    kind = machine.settings.control.kind
    if kind not in NCKS:
        of_slope = (findings["code"] == lib.NCK_NOTE_TOLERANCE) & (findings["letter"] == ord("G"))
        findings = findings[~of_slope]
    if kind not in PRINTERS:
        return findings
    kept = findings[findings["code"] != lib.NCK_NOTE_LIMITS]
    if kind == "klipper":
        kept["code"][kept["code"] == lib.NCK_NOTE_FEED_KEPT] = lib.NCK_E_NUMBER_RANGE
        kept["code"][kept["code"] == lib.NCK_NOTE_CLAMPED] = lib.NCK_E_TRAVEL
    return kept


def changes(text, machine):
    """Return what a program changes of a control's limits, of dtype ``nck_host_control_change_t``.

    Each holds from its line on.
    """
    kind = machine.settings.control.kind
    read = {"klipper": _Klipper(machine).changes, "marlin": _of_marlin}.get(kind)
    if machine.settings.control.reprap:
        read = _of_reprap
    original, rows, line, seen = getattr(text, "original", text), [], 1, 0
    for match in _LIMIT.finditer(original) if read else ():
        line += original.count(b"\n", seen, match.start())
        seen = match.start()
        rows += [(line, value, to) for value, to in read(match[1], match[3].upper())]
    return np.array(rows, dtype("nck_host_control_change_t"))


class _Klipper:
    """What Klipper's commands change; of ACCEL_TO_DECEL it makes a ratio of the acceleration in
    force."""

    def __init__(self, machine):
        control, path = machine.settings.control, machine.settings.path
        self._accel = float(control.max_accel or path.a_max_mm_s2 or 0)

    def changes(self, code, words):
        """Return [(value, to)] of a command."""
        found = _of_m204(code, words) if code else self._of_command(words)
        self._accel = dict(found).get(lib.NCK_CONTROL_A_PATH, self._accel)
        return found

    def _of_command(self, words):
        said = {name: float(to) for name, to in _PAIR.findall(words)}
        slow, accel = said.pop(b"ACCEL_TO_DECEL", 0.0), said.get(b"ACCEL", 0.0) or self._accel
        if slow > 0 and accel > 0:
            said.setdefault(b"MINIMUM_CRUISE_RATIO", 1 - min(1, slow / accel))
        return [(_VELOCITY_LIMIT[name], to) for name, to in said.items()
                if name in _VELOCITY_LIMIT and _is_good(name, to)]  # fmt: skip


def _of_m204(code, words):
    said = dict(_WORD.findall(words))
    if code != b"204":
        return []
    if b"S" in said:
        return [(lib.NCK_CONTROL_A_PATH, float(said[b"S"]))] if float(said[b"S"]) > 0 else []
    if b"P" in said and b"T" in said:
        least = min(float(said[b"P"]), float(said[b"T"]))
        return [(lib.NCK_CONTROL_A_PATH, least)] if least > 0 else []
    return []


def _is_good(name, to):
    """Tell whether Klipper takes a value; what it does not take it refuses, and nothing changes."""
    if name == b"MINIMUM_CRUISE_RATIO":
        return 0 <= to < 1
    return to >= 0 if name == b"SQUARE_CORNER_VELOCITY" else to > 0


def _accelerations(said):
    """Yield what M204 changes: S is of printing moves and travel."""
    for letters, value in (
        ("SP", lib.NCK_CONTROL_A_PATH), ("ST", lib.NCK_CONTROL_A_TRAVEL),
        ("R", lib.NCK_CONTROL_A_RETRACT),
    ):  # fmt: skip
        yield from ((value, said[letter]) for letter in letters if said.get(letter, 0) > 0)


# What M205 says beside jerks of axes: the number, and its unit here.
_CORNERS = {"J": (lib.NCK_CONTROL_DEVIATION, 1.0), "B": (lib.NCK_CONTROL_SEGMENT_S, 1e-6)}


def _of_reprap(code, words):
    """RepRapFirmware's: as Marlin's, but for speeds in mm/min, and M566 in place of M205."""
    scale = 1 / 60 if code in (b"203", b"566") else 1
    changed = _of_marlin(b"205" if code == b"566" else code, words)
    return [(number, value * scale) for number, value in changed]


def _of_marlin(code, words):
    if code not in (b"201", b"203", b"204", b"205"):
        return
    said = {letter.decode(): float(to) for letter, to in _WORD.findall(words) if float(to) >= 0}
    if code == b"204":
        yield from _accelerations(said)
        return
    is_corner = code == b"205"
    for letter, to in said.items():
        if to == 0 and not is_corner:  # nothing would move any more
            continue
        if letter in "XYZABCE":
            yield _BY_AXIS[code] + AXES.index("u" if letter == "E" else letter.lower()), to
        elif is_corner and letter in _CORNERS:
            number, unit = _CORNERS[letter]
            yield number, to * unit
