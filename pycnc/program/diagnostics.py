# SPDX-License-Identifier: MIT
"""What is wrong with a program, in words: the kernel gives ids and numbers, this file words."""

import re
from collections import Counter
from dataclasses import dataclass

import numpy as np

from pycnc.kernel.bind import lib, note_id, status_id

SHOWN_PER_ID = 20  # findings of one id that are told in full; the rest is counted
_EXCERPT = 100  # characters of a source line that are shown around the column
_DIALECTS = {1: "Heidenhain Klartext", 2: "Sinumerik", 3: "Okuma"}

_TAPPING = (
    "tapping is not supported yet: the spindle is not in step with the axes",
    "tap on another machine or by hand, or mill the thread; nothing is skipped in silence",
)
_CYCLE_HELP = (
    "write a cycle as G0 and G1 moves; where the mode is meant, let a motion stand behind the "
    "code, as in G90 G0 X50; a program made for RS274NGC: --dialect linuxcnc"
)

# id, or id:letter or id:code where one word or code needs its own, → (message, help). Fields: see
# Wording._fields.
WORDING = {
    "character": (
        "{found} starts no word",
        "a block is made of words such as G1 X10 F200; comments stand in ( ) or after ;",
    ),
    "number": (
        "{letter} has no number that can be read",
        "write the number right after the letter: {letter}12.5 (a decimal point, no comma)",
    ),
    "number:?": (
        "a number without a letter",
        "write the letter that the number belongs to, such as X12.5",
    ),
    "number-range": (
        "{letter}{value:g} is out of range (limit {limit:g})",
        "check the number and the units in force (G20 inch, G21 mm)",
    ),
    "number-range:S": (
        "S{value:g} is out of range (limit {limit:g})",
        "choose another speed, or set the machine's: --set spindle.rpm_max=…",
    ),
    "number-range:R": (
        "R{value:g} is out of range (limit {limit:g})",
        "check the number and the units in force; in a cycle R lies above the bottom of its hole",
    ),
    "number-range:Q": (
        "Q{value:g} is out of range (limit {limit:g})",
        "Q is the depth of a peck: more than 0, without a sign",
    ),
    "line-length": (
        "the line is longer than {value:.0f} bytes",
        "split the block into several lines or shorten its comment",
    ),
    "comment": (
        "the comment is not closed",
        "close it with ) on the same line, or begin it with ;",
    ),
    "word-unknown": (
        "the language has no {letter} word",
        "remove the word, or put it into a comment: ( )",
    ),
    "word-twice": (
        "{letter} stands twice in one block",
        "keep one of the two, or make two lines of the block",
    ),
    "word-unused": (
        "no code of this block uses {found}",
        "remove the word, or add the code that it belongs to",
    ),
    "word-missing": (
        "a word is missing in this block: {letter}",
        "add {letter} with its number to the block",
    ),
    "word-missing:X": (
        "{found} names no axis",
        "add the axes with their numbers, such as X0, to the block",
    ),
    "word-missing:M": (
        "G86 stops the spindle, and the spindle stands",
        "start it before the cycle, as in S800 M3",
    ),
    "word-shared": (
        "two codes of this block use {found}",
        "put one of the two codes on a line of its own",
    ),
    "word-missing:G": (
        "{found} without a straight move",
        "add G0 or G1 to the block",
    ),
    "g-unknown": (
        "G{value:g} is no G code that the kernel knows",
        "look up the code in the manual of the control that the program was made for",
    ),
    "m-unknown": (
        "M{value:g} is no M code that the kernel knows",
        "remove the code, or if the machine has it, tell so in its file: [m.{value:.0f}] "
        'action = "output"',
    ),
    "modal-group": (
        "{found} excludes another code of its block (both set the same, or both move)",
        "put one of the two codes on a line of its own",
    ),
    "unsupported": (
        "{found} is not supported yet",
        "have the post-processor write plain moves instead; nothing is skipped in silence",
    ),
    "unsupported:G74": _TAPPING,
    "unsupported:G84": _TAPPING,
    "unsupported:G87": (
        "G87 needs a spindle that stops at an angle, which the kernel does not have yet",
        "bore from above, or write the cycle as moves with M19 of the machine's own",
    ),
    "unsupported:G88": (
        "G88 has the operator draw the tool out by hand, behind which nobody knows where it is",
        "use G86 or G89, or write M0 and the move out",
    ),
    "unsupported:G93": (
        "a canned cycle has many moves, and inverse time (G93) is the time of one",
        "put G94 and an F before the cycle",
    ),
    "unsupported:G90": (
        "G90 may be a turning cycle (Fanuc's G-code system A) or absolute distances (system B): "
        "on a lathe it is not supported yet before axis words",
        _CYCLE_HELP,
    ),
    "unsupported:G92": (
        "G92 may limit the spindle's speed (with S), be a threading cycle (Fanuc's G-code system "
        "A) or shift the zero (system B): here it is not supported yet",
        "limit the speed by --set spindle.rpm_max=…, write a cycle as moves, shift the zero by "
        "G10 L2 or G54 … G59; a program made for RS274NGC: --dialect linuxcnc",
    ),
    "unsupported:G94": (
        "G94 may be a facing cycle (Fanuc's G-code system A) or feed per minute (system B): "
        "on a lathe it is not supported yet before axis words",
        _CYCLE_HELP,
    ),
    "incremental": (
        "{found} names a machine position while distances are incremental (G91)",
        "put G90 into the block or before it",
    ),
    "feed-missing": (
        "a cut without feed",
        "put F on this line or before it, or give a default: --set dialect.feed_default_mm_min=500",
    ),
    "feed-missing:S": (
        "feed per revolution (G95) while the spindle stands",
        "start the spindle before it, as in S800 M3, or program G94 with F in mm/min",
    ),
    "arc-radius": (
        "arc ends {miss:.3f} mm off its circle "
        "(start radius {limit:.3f}, end radius {value:.3f}, tolerance {tolerance:.3g})",
        "check I J K and G90.1/G91.1, write more decimals, or set path.arc_radius_mm",
    ),
    "arc-mode": (
        "arc ends {miss:.3f} mm off its circle as it is read, and on one if I J K counted from "
        "the start (G91.1)",
        "--set dialect.arc_centre=incremental, or G91.1 in the program",
    ),
    "arc-mode:A": (
        "arc ends {miss:.3f} mm off its circle as it is read, and on one if I J K counted from "
        "the program's zero (G90.1)",
        "--set dialect.arc_centre=absolute, or G90.1 in the program",
    ),
    "arc-centre": (
        "the arc has no centre, or its radius is zero",
        "give the centre by I J K in the plane in force (G17: I J, G18: I K, G19: J K), or R",
    ),
    "arc-chord": (
        "R{value:g} is shorter than half of the chord, {limit:.4f} mm",
        "check R, the end point and the units in force",
    ),
    "axis-unknown": (
        "the machine {machine} has no {letter} axis",
        "choose a machine that has it (--machine), or remove the word",
    ),
    "travel": (
        "{letter} reaches {value:.3f} {unit}, its travel ends at {limit:.3f} {unit}",
        "move the work zero (--set work.g54.{key}=…), or if the machine has more travel: "
        "--set axis.{axis}.{end}_{unit}=…",
    ),
    "tool-unknown": (
        "tool {value:.0f} is not in the tool table",
        "add [tool.{value:.0f}] to the machine file, or give a tool table: --tools tool.tbl",
    ),
    "no-motion": (
        "axis words while no motion is in force",
        "begin the block with G0, G1, G2 or G3",
    ),
    "dialect": (
        "this is a program in {dialect}, which pycnc does not read",
        "have the post-processor write G-code as RS274NGC, Fanuc, grbl or Marlin have it",
    ),
    "binary": (
        "this is no NC program: it holds a NUL byte",
        "give a text file",
    ),
    "no-program": (
        "the text holds no block",
        "give a program with one word at least",
    ),
    "expression": (
        "{found} cannot be read here",
        "an expression is made of numbers, #parameters, [ ] and functions such as SIN[30]; an O "
        "word needs sub, call, if, while, repeat, do or their ends behind it",
    ),
    "value": (
        "an expression without a value: it divides by zero, or a function has none for {value:g}",
        "check the parameters that it is made of",
    ),
    "parameter-unset": (
        "the named parameter was never set",
        "set it before, or ask for it by EXISTS[#<name>]",
    ),
    "parameters-full": (
        "more than {limit:.0f} parameters are set at once",
        "build the kernel with a larger NCK_VARIABLES",
    ),
    "call-depth": (
        "more than {limit:.0f} calls and loops in one another",
        "end the recursion, or build the kernel with a larger NCK_CALL_DEPTH",
    ),
    "label-missing": (
        "what is called or jumped to is not in the text",
        "add the subprogram (O…) or the line (N…) to the same file",
    ),
    "flow": (
        "a control word without its other end",
        "every sub, if, while, repeat, do and DO needs its end, with the same number",
    ),
    "no-seek": (
        "a jump backward in text that is only pushed",
        "give the kernel the text to read (nck_read)",
    ),
    "alarm": ("the program stops with alarm {value:.0f} (#3000)", "see the remark on its line"),
    "endless": (
        "{limit:.0f} lines were read and no block came",
        "a loop without a move never ends: check its condition",
    ),
    "argument": ("a call to the kernel had a number outside of its range", "please report this"),
    "machine": ("the kernel refuses a number of the machine", "pycnc machine validate tells which"),
    "state": ("a call to the kernel came at the wrong time", "please report this"),
    "internal": ("an invariant of the kernel is broken", "please report this with the program"),
    "assumed-units": ("no G20 or G21 before the first motion: {units} assumed", ""),
    "assumed-plane": ("no G17, G18 or G19 before the first arc: G{plane} assumed", ""),
    "assumed-distance": ("no G90 or G91 before the first motion: absolute (G90) assumed", ""),
    "assumed-centre": ("no G90.1 or G91.1 before I J K: {arc_centre} centres assumed", ""),
    "no-tolerance": (
        "G64 without P means the machine's tolerance, and that is 0: the path is exact",
        "give P, as in G64 P0.01, or the machine a tolerance: --set path.tolerance_mm=0.01",
    ),
    "no-end": ("the text ends without M2, M30 or a closing %", ""),
    "after-end": ("what follows the program's end is not read", "remove the text or the M2 / M30"),
    "called-from": ("called from here", ""),
    "feed-units": (
        "F beside a change of units is read in the units that its own line begins",
        "put G20 or G21 on a line before: LinuxCNC reads such an F in the units before the line",
    ),
}
_WARNINGS = frozenset({"after-end"})


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
        keys = ("file", "line", "col", "id", "severity", "message", "help")
        return {key: getattr(self, key) for key in keys}

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


class Diagnostics:
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

    def hidden(self):
        """Yield (id, severity, how many) of what is counted and not shown."""
        shown = Counter(finding.id for finding in self.shown)
        severities = {finding.id: finding.severity for finding in self.shown}
        for name, count in self.counts.items():
            if count > shown[name]:
                yield name, severities[name], count - shown[name]

    def text(self, file, colour=False):
        """Return all of it as text, empty if there is nothing to say."""
        lines = [finding.text(colour) for finding in self.shown]
        for name, severity, count in self.hidden():
            lines.append(
                f"{file}: {_tag(severity, name, colour)}: {count} more like this are not shown"
            )
        return "\n".join(lines)

    def as_list(self):
        """Return what ``--json`` tells."""
        return [finding.as_dict() for finding in self.shown]

    def __len__(self):
        return sum(self.counts.values())

    def __iter__(self):
        return iter(self.shown)


class Wording:
    """Puts the kernel's findings about one program into words."""

    def __init__(self, file, text, machine):
        self._file, self._text, self._machine = file, text, machine
        self._lines = None

    def add(self, diagnostics, rows):
        """Add findings of the kernel to a collection.

        Parameters
        ----------
        diagnostics : Diagnostics
        rows : numpy.ndarray
            Of dtype ``nck_diagnostic_t``.
        """
        kept, extra = [], []
        for code in np.unique(rows["code"]):
            of_code = np.flatnonzero(rows["code"] == code)
            room = max(SHOWN_PER_ID - diagnostics.counts[_id(int(code))], 0)
            kept.extend(of_code[:room])
            if len(of_code) > room:
                extra.append((of_code[room], len(of_code) - room))
        for index in sorted(kept):
            diagnostics.add(self._finding(rows[index]))
        for index, count in extra:
            diagnostics.add(self._finding(rows[index]), count)

    def _finding(self, row):
        name = _id(int(row["code"]))
        line, column = int(row["line"]), int(row["column"])
        source = self._source(line)
        fields = self._fields(row, source)
        message, remedy = (words.format_map(fields) for words in _wording(name, fields))
        severity = severity_of(name)
        return Diagnostic(self._file, line, column, name, severity, message, remedy, source)

    def _source(self, line):
        if self._lines is None:
            self._lines = self._text.splitlines()  # of bytes: at LF, CR LF and CR, as the kernel
        return self._lines[line - 1] if 0 < line <= len(self._lines) else b""

    def _fields(self, row, source):
        value, limit = float(row["value"]), float(row["limit"])
        letter = chr(row["letter"]) if row["letter"] else ""
        settings, axis = self._machine.settings, letter.lower()
        unit = "deg" if letter in "ABC" and letter else "mm"
        return {
            "value": value,
            "limit": limit,
            "letter": letter or "?",
            "found": _word(source, int(row["column"])),
            "miss": abs(value - limit),
            "tolerance": float(settings.path.arc_radius_mm),
            "machine": self._machine.name,
            "unit": unit,
            "axis": axis,
            "key": f"{axis}_{unit}",
            "end": "max" if value > limit else "min",
            "dialect": _DIALECTS.get(int(value), "a language of its own"),
            "units": "inches (G20)" if settings.dialect.units == "inch" else "mm (G21)",
            "plane": settings.dialect.plane,
            "arc_centre": settings.dialect.arc_centre,
        }


def _wording(name, fields):
    letter = fields["letter"]
    for key in (f"{name}:{letter}{fields['value']:g}", f"{name}:{letter}"):
        if key in WORDING:
            return WORDING[key]
    return WORDING[name]


def _id(code):
    return status_id(code) if code < 0 else note_id(code)


def _codes(prefix):
    return sorted((getattr(lib, name) for name in dir(lib) if name.startswith(prefix)), key=abs)


def ids():
    """Return the ids of all errors and notes that the kernel may tell, errors first."""
    return [status_id(code) for code in _codes("NCK_E_")] + sorted(_NOTES)


def severity_of(name):
    """Return "error", "warning" or "note" for an id of the kernel."""
    if name in _NOTES:
        return "warning" if name in _WARNINGS else "note"
    return "error"


def _word(source, column):
    """Return the word of a source line that begins at a column, as a person would quote it."""
    rest = source[max(column - 1, 0) :][:40].decode("utf-8", errors="replace")
    word = re.match(r"[A-Za-z]\s*[-+]?[0-9.]+|[A-Za-z]+|.", rest)
    return _printable(word[0].replace(" ", "").encode()) if word else "this"


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


_NOTES = frozenset(note_id(code) for code in _codes("NCK_NOTE_"))
