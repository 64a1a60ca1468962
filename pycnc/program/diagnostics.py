# SPDX-License-Identifier: MIT
"""What is wrong with a program, in words: the kernel gives ids and numbers, this file words."""

import re
from collections import Counter, defaultdict
from dataclasses import dataclass, replace
from decimal import Decimal

import numpy as np

from pycnc.kernel.bind import diagnostic_id, lib
from pycnc.program.shown import Tables, frame, rows_table
from pycnc.program.wording import META, WORDING

SHOWN_PER_ID = 20  # findings of one id that are told in full; the rest is counted
_LINES_NAMED = 5  # of those that say the same
_EXCERPT = 100  # characters of a source line that are shown around the column
_NUMBER = 40  # characters of a number that are shown
_DIALECTS = {1: "Heidenhain Klartext", 2: "Sinumerik", 3: "Okuma", 4: "ShopBot"}
_FEED_UNITS = {"linuxcnc": "before it"}  # whose units F has beside G20 or G21; else of its line

_TONGUES = (
    (lib.NCK_TONGUE_LINUXCNC, "linuxcnc"),
    (lib.NCK_TONGUE_FANUC | lib.NCK_TONGUE_TURNING, "fanuc"),
    (lib.NCK_TONGUE_FANUC, "fanuc (mills)"),
    (lib.NCK_TONGUE_TURNING, "fanuc (lathes)"),
    (lib.NCK_TONGUE_GRBL, "grbl"),
    (lib.NCK_TONGUE_MARLIN, "marlin"),
)
_WARNINGS = frozenset({"abort", "after-end", "comp-left", "comp-way", "own-left",
                       "travel-end"})  # fmt: skip
KEYS = ("file", "line", "col", "id", "severity", "message", "help")  # of Diagnostic.as_dict


@dataclass(frozen=True)
class Diagnostic:
    """One finding.

    Attributes
    ----------
    file : str
    line, col : int
        1-based; col counts bytes; 0 where the whole line, or the whole file, is meant.
    id : str
        Stable id, such as ``"arc-radius"``.
    severity : {"error", "warning", "note"}
    message, help : str
        help may be empty.
    source : bytes
        The source line, without its end.
    """

    file: str
    line: int
    col: int
    id: str
    severity: str
    message: str
    help: str = ""
    source: bytes = b""

    def as_dict(self):
        """Return what ``--json`` tells."""
        return {key: getattr(self, key) for key in KEYS}

    def text(self, colour=False):
        """Return the finding as lines of text: head, source line, caret, help."""
        place = ":".join([self.file] + [str(n) for n in (self.line, self.col) if n])
        head = f"{_paint(place, 'bold', colour)}: {_tag(self.severity, self.id, colour)}"
        lines = [f"{head}: {_paint(self.message, 'bold', colour)}"]
        if self.line and self.source:
            lines += self._excerpt(colour)
        if self.help:
            lines.append(f"  {_paint('help:', 'cyan', colour)} {self.help}")
        return "\n".join(lines)

    def _excerpt(self, colour):
        before, after = (
            _printable(self.source[: max(self.col - 1, 0)]),
            _printable(self.source[max(self.col - 1, 0) :][: 4 * _EXCERPT]),
        )
        cut = max(0, len(before) - _EXCERPT // 2)
        room = _EXCERPT - (len(before) - cut)
        shown = ("…" if cut else "") + before[cut:] + after[:room] + ("…" if after[room:] else "")
        if not self.col:
            return [f"  {shown}"]
        caret = " " * (len(before) - cut + bool(cut)) + "^"
        return [f"  {shown}", f"  {_paint(caret, 'green', colour)}"]


class Diagnostics(Tables):
    """All findings of a program, in the order of the source; the many of one kind are counted.

    Attributes
    ----------
    shown : list of Diagnostic
        At most SHOWN_PER_ID of each id.
    counts : collections.Counter
        Id → how many there are.
    errors : int
        How many errors there are.
    """

    def __init__(self):
        self.shown, self.counts, self.errors = [], Counter(), 0

    def add(self, finding, count=1):
        """Add a finding; count: how many of its kind it stands for."""
        if self.counts[finding.id] < SHOWN_PER_ID:
            self.shown.append(finding)
        self.counts[finding.id] += count
        self.errors += count * (finding.severity == "error")

    def lead(self, finding, cured):
        """Put a finding before all others; of the ids that it explains one each is shown, whose
        remedy is its."""
        seen, kept = set(), []
        for each in self.shown:
            if each.id not in cured:
                kept.append(each)
            elif each.id not in seen:
                kept.append(replace(each, help=finding.help))
            seen.add(each.id)
        self.shown = [finding, *kept]
        self.counts[finding.id] += 1

    def hidden(self):
        """Yield (id, severity, how many) of what is counted and not shown."""
        shown = Counter(finding.id for finding in self.shown)
        severities = {finding.id: finding.severity for finding in self.shown}
        for name, count in self.counts.items():
            if count > shown[name]:
                yield name, severities[name], count - shown[name]

    def text(self, file, colour=False, without=()):
        """Return all of it as text but for some ids, empty if there is nothing to say."""
        told, again = {}, defaultdict(list)  # what is said in the same words is said once
        for finding in self.shown:
            same = finding.id, finding.message
            if same in told:
                again[finding.id].append(finding.line)
            elif finding.id not in without:
                told[same] = finding
        lines = [finding.text(colour) for finding in told.values()]
        severities = {finding.id: finding.severity for finding in told.values()}
        once = Counter(finding.id for finding in told.values())
        for name, severity in severities.items():
            if count := self.counts[name] - once[name]:
                places = _places(again[name], count)
                lines.append(
                    f"{file}: {_tag(severity, name, colour)}: {count} more like this are not shown"
                    f"{places}"
                )
        return "\n".join(lines)

    def as_list(self):
        """Return what ``--json`` tells."""
        return [finding.as_dict() for finding in self.shown]

    def _table(self, kind):
        return frame({name: [each[name] for each in self.as_list()] for name in KEYS}, kind=kind)

    def __repr__(self):
        told = ", ".join(f"{name} ({n})" if n > 1 else name for name, n in self.counts.items())
        return f"<Diagnostics: {self.errors} errors{', ' if told else ''}{told}>"

    def _repr_html_(self):
        rows = [[each[name] for name in KEYS] for each in self.as_list()]
        rows += [["", "", "", name, severity, f"{count} more like this are not shown", ""]
                 for name, severity, count in self.hidden()]  # fmt: skip
        return rows_table(KEYS, rows)

    def __len__(self):
        return sum(self.counts.values())

    def __iter__(self):
        return iter(self.shown)


class Wording:
    """Puts the kernel's findings about one program into words."""

    def __init__(self, file, lines, machine, places=()):
        self._file, self._lines, self._machine = file, lines, machine
        self._places = places  # (line of its remark, file) of programs of other files

    def _place(self, line):
        """Return (file, line there) of a line of the text."""
        before = [each for each in self._places if each[0] < line]
        return (before[-1][1], line - before[-1][0]) if before else (self._file, line)

    def add(self, diagnostics, rows):
        """Add findings of the kernel to a collection.

        Parameters
        ----------
        diagnostics : Diagnostics
        rows : numpy.ndarray
            Of dtype ``nck_diagnostic_t``.
        """
        kept, extra = [], []
        for code in sorted(set(rows["code"].tolist())):  # np.unique imports numpy.ma for it
            of_code = np.flatnonzero(rows["code"] == code)
            room = max(SHOWN_PER_ID - diagnostics.counts[diagnostic_id(code)], 0)
            kept.extend(of_code[:room])
            if len(of_code) > room:
                extra.append((of_code[room], len(of_code) - room))
        for index in sorted(kept):
            diagnostics.add(self._finding(rows[index]))
        for index, count in extra:
            diagnostics.add(self._finding(rows[index]), count)

    def _finding(self, row):
        name = diagnostic_id(int(row["code"]))
        line, column = int(row["line"]), int(row["column"])
        source = self._lines[line]
        fields = self._fields(name, row, source)
        words = META if fields["meta"] and name in _OF_META else _wording(name, fields)
        message, remedy = (each.format_map(fields) for each in words)
        severity = severity_of(name)
        return Diagnostic(*self._place(line), column, name, severity, message, remedy, source)

    def _fields(self, name, row, source):
        letter, column = chr(row["letter"]) if row["letter"] else "", int(row["column"])
        value, limit = _Number(row["value"]), _Number(row["limit"])
        value.text = _number_at(source, column, letter, value)
        settings, axis = self._machine.settings, letter.lower()
        language = settings.dialect.base
        unit = "deg" if letter in "ABC" and letter else "mm"
        if letter == "U" and language == "marlin" and b"U" not in source.upper():
            letter = "E"  # as the text has it
        return {
            "value": value,
            "limit": limit,
            "letter": letter or "?",
            "found": _word(source, column),
            "miss": abs(value - limit),
            "tolerance": float(settings.path.arc_radius_mm),
            "machine": self._machine.name,
            "slope": settings.path.slope,
            "unit": unit,
            "axis": axis,
            "key": f"{axis}_{unit}",
            "end": "max" if value > limit else "min",
            "bound": _bound(letter, value, limit),
            "own_key": " ($30)" * (settings.control.kind in ("grbl", "grblhal")),
            "dialect": _DIALECTS.get(int(value), "a language of its own"),
            "remark": _remark(source, column),
            "key_of_g": f"{float(value):g}".replace(".", "_"),
            "base": language,
            "feed_units": _FEED_UNITS.get(language, "of its line"),
            **_whose(int(limit) if name == "other-base" else 0),
            "units": "inches (G20)" if settings.dialect.units == "inch" else "mm (G21)",
            "plane": settings.dialect.plane,
            "lathe": settings.kinematics.type == "lathe_xz" and settings.dialect.base == "fanuc",
            "arc_centre": settings.dialect.arc_centre,
            "asks": _ASKS.search(source),
            "meta": _meta(source, language),
        }


class _Number(float):
    """A number of a program, which is told as a program says it: with all its digits."""

    text = None  # as it is written, if it is

    def __format__(self, spec):
        """Return it by the spec; without one as it is written, without an exponent."""
        if spec:
            return super().__format__(spec)
        told = self.text or f"{Decimal(super().__format__('.15g')) + 0:f}"
        return told if len(told) <= _NUMBER else told[:_NUMBER] + "…"


def _bound(letter, value, limit):
    """Return what the limit of a number is, where the kernel's numbers say it."""
    if abs(value) > abs(limit) > 0:
        return "most"
    return "least" if letter == "F" and 0 < value < limit else "limit"


def _number_at(source, column, letter, value):
    """Return the number as it is written at a column of a source line; None: it is not."""
    word = re.match(rb"([A-Za-z#])([-+.0-9\s]+)", source[max(column - 1, 0) :])
    if not word or word[1].decode().upper() != letter:
        return None
    text = "".join(word[2].decode().split())
    try:
        return text if float(text) == value else None
    except ValueError:
        return None


# Of LinuxCNC's own names those that nothing here answers.
_ASKS = re.compile(
    rb"# *<_((hal|ini)\[|(vmajor|vminor|line|ccomp|inverse_time|units_per_minute|units_per_rev|"
    rb"tool_offset|retract_r_plane|retract_old_z|spindle_rpm_mode|spindle_css_mode|"
    rb"lathe_radius_mode|spindle_cw|mist|flood|speed_override|feed_override|adaptive_feed|"
    rb"feed_hold|abs_[xyzabcuvw]|current_pocket|selected_pocket|call_level|remap_level)>)",
    re.IGNORECASE,
)
_META = re.compile(
    rb"[ \t]*(if|elif|else|while|break|continue|abort|echo|var|global|set)\b|[^;]*?(\{)"
)
_OF_META = frozenset({"number", "character", "other-base", "expression", "word-unknown"})


def _meta(source, language):
    """Return what of RepRapFirmware's meta commands is in a printer's line; empty: nothing."""
    found = _META.match(source) if language == "marlin" else None
    return (found[1] or found[2]).decode() if found else ""


def _whose(tongues):
    """Return whose a word is, as a person says it and as ``--dialect`` does."""
    names = [name for bits, name in _TONGUES if tongues & bits == bits]
    names = [name for name in names if "(" not in name or "fanuc" not in names]
    bases = dict.fromkeys(name.split(" ")[0] for name in names)
    *first, last = names or ["another one"]
    others = f"{', '.join(first)} and {last}" if first else last
    return {"others": others, "dialects": " or ".join(bases)}


def _wording(name, fields):
    letter = fields["letter"]
    word = f"{name}:{letter}{fields['value']:.15g}"
    own = f"{name}:own" if fields["asks"] else f"{name}:{letter}:{fields['base']}"
    for key in (f"{word}:lathe" * fields["lathe"], word, own, f"{name}:{letter}"):
        if key in WORDING:
            return WORDING[key]
    return WORDING[name]


def _places(lines, count):
    """Return the lines of findings that are not shown, the first ones of so many."""
    some = ", ".join(f"{line}" for line in lines[:_LINES_NAMED] if line)
    more = " …" if count > len(lines[:_LINES_NAMED]) else ""
    return f": line{'s' * (count > 1)} {some}{more}" if some else ""


def _codes(prefix):
    return sorted((getattr(lib, name) for name in dir(lib) if name.startswith(prefix)), key=abs)


def ids():
    """Return the ids of all errors and notes that the kernel may tell, errors first."""
    return [diagnostic_id(code) for code in _codes("NCK_E_")] + sorted(_NOTES)


def severity_of(name):
    """Return "error", "warning" or "note" for an id of the kernel."""
    if name in _NOTES:
        return "warning" if name in _WARNINGS else "note"
    return "error"


def _word(source, column):
    """Return the word of a source line that begins at a column, as a person would quote it."""
    rest = source[max(column - 1, 0) :][:40].decode("utf-8", errors="replace")
    word = re.match(r"[A-Za-z#]\s*[-+]?[0-9.]+|[A-Za-z]+|.", rest)
    return _printable(word[0].replace(" ", "").encode()) if word else "this"


def _remark(source, column):
    """Return what (abort, …) at a column of a source line says."""
    text = source[max(column - 1, 0) :].split(b")", 1)[0].split(b",", 1)
    return _printable(text[-1]).strip()


def _printable(data):
    """Return bytes as text of one column a character: no control reaches the terminal."""
    text = data.decode("utf-8", errors="replace")
    return "".join(
        c if c.isprintable() else " " if c == "\t" else "\N{REPLACEMENT CHARACTER}" for c in text
    )


_COLOURS = {"bold": "1", "red": "1;31", "yellow": "1;33", "cyan": "36", "green": "1;32"}
_SEVERITY_COLOURS = {"error": "red", "warning": "yellow", "note": "cyan"}


def _paint(text, colour, on):
    return f"\x1b[{_COLOURS[colour]}m{text}\x1b[0m" if on else text


def _tag(severity, name, colour):
    return _paint(f"{severity}[{name}]", _SEVERITY_COLOURS[severity], colour)


_NOTES = frozenset(diagnostic_id(code) for code in _codes("NCK_NOTE_"))
