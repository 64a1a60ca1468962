# SPDX-License-Identifier: MIT
"""The lines of another control's configuration: which settings they make, and which make none.

Every form is read as its own control reads it: what continues a line, what an indentation means,
which of two values counts, and what stands in other files.
"""

import codecs
import glob
import os
import re
import stat
from pathlib import Path
from typing import NamedTuple

_MOST_BYTES = 16 << 20  # of all files that are included; configurations have kilobytes
_PAGES = frozenset({"mainsail.cfg", "fluidd.cfg", "timelapse.cfg"})  # macros of Klipper's pages
_BESIDE = "put it beside, or take the line out if no axis is in it"
_MOST_FILES = 100  # files that are included, one in another or again
_MARKS = {  # first bytes of a file → how the rest is written
    codecs.BOM_UTF8: "utf-8", codecs.BOM_UTF16_LE: "utf-16-le", codecs.BOM_UTF16_BE: "utf-16-be",
}  # fmt: skip
_COMMENT = re.compile(r"(?:^|\s)[#;].*")
_HEAD = re.compile(r"\[([^\]]+)\]")


class Row(NamedTuple):
    """A line of a file that says something."""

    place: str  # "line 7", in an included file "z.inc line 7"
    text: str  # the line, blanks joined
    raw: str


class Setting(NamedTuple):
    """A value, and the lines that it comes from."""

    value: str
    rows: tuple

    @property
    def told(self):
        """Return where the value comes from, for a comment."""
        return f"{self.rows[0].place}: {' '.join(row.text for row in self.rows)}"


class Form:
    """What the lines of a file come to.

    Attributes
    ----------
    settings : dict
        (section, key), both in lower case → Setting.
    rows : list of Row
        All lines but comments and empty ones, in their order.
    heads : dict
        id of the row of a [section] → its section.
    notes : dict
        id of a row → what to say of it.
    problems : list of (str, str)
        Place, and why the whole cannot be taken.
    """

    def __init__(self):
        self.settings, self.rows, self.heads = {}, [], {}
        self.notes, self.problems = {}, []

    def put(self, key, value, rows, last_counts):
        """Take a value of a key; of several the control takes the last, or the first."""
        setting, earlier = Setting(value, tuple(rows)), self.settings.get(key)
        if earlier is None or last_counts:
            self.settings[key] = setting
        if earlier is not None:
            loser, winner = (earlier, setting) if last_counts else (setting, earlier)
            self.note(loser.rows[0], f"{winner.rows[0].place} counts")

    def note(self, row, words):
        """Say something of a row, where it is listed."""
        self.notes[id(row)] = words


def decode(data):
    """Return the text of a file, lines ended by a line feed: UTF-8, UTF-16 by its mark, Latin-1."""
    mark = next((mark for mark in _MARKS if data.startswith(mark)), b"")
    code, data = _MARKS.get(mark, "utf-8"), data[len(mark) :]
    try:
        text = data.decode(code, errors="replace" if mark else "strict")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _rows(text, name=""):
    """Yield (number, row) of all lines, the empty ones too."""
    before = f"{name} " if name else ""
    for number, raw in enumerate(text.split("\n"), 1):
        shown = "".join(c if c.isprintable() else " " for c in raw)
        yield Row(f"{before}line {number}", " ".join(shown.split()), raw)


class _Included:
    """Files that a configuration names: read from its folder, a bounded number of times."""

    def __init__(self, form, place):
        self.form, self.folder = form, place and place.parent
        self.count, self.bytes, self.is_over = 0, 0, False
        self._open = [place and place.resolve()]  # one in another

    def rows(self, row, names, folder, must):
        """Yield (rows, folder) of the files that a line names; say what cannot be read."""
        for name in names:
            if self.is_over:
                return
            path = Path(folder, os.path.expanduser(name))
            self.count += 1
            words = self._why_not(path)
            if not words:
                shown = os.path.relpath(path, self.folder)
                self._open.append(path.resolve())
                yield _rows(decode(path.read_bytes()), shown), path.parent
                self._open.pop()
            elif must and (path.name not in _PAGES or path.exists()):
                self.form.problems.append((row.place, f"{row.text}: {name}: {words}; {_BESIDE}"))
            else:
                self.form.note(row, f"{words}: not read")

    def _why_not(self, path):
        """Return why a file cannot be read; "" if it can."""
        if self.count > _MOST_FILES:
            self.is_over = True
            return f"more than {_MOST_FILES} files are included"
        try:
            if path.resolve() in self._open:
                self.is_over = True
                return "includes itself, which no control takes; name the files that are meant"
            found = path.stat()
            if not stat.S_ISREG(found.st_mode):
                return "no file"
            self.bytes += found.st_size
            if self.bytes > _MOST_BYTES:
                self.is_over = True
                return f"more than {_MOST_BYTES >> 20} MB are included"
            with path.open("rb"):
                return ""
        except (OSError, ValueError) as cause:
            return getattr(cause, "strerror", None) or str(cause)


# ---- LinuxCNC: key = value, # and ; before comments, a backslash before what goes on


def linuxcnc(text, place):
    """Read an INI of LinuxCNC; `#INCLUDE FILE` in it, but not in what is included.

    place: path of the file, or None; what it includes is seen from there.
    """
    form = Form()
    section, begun = "", []
    for row in _with_includes(form, text, place):
        bare = _COMMENT.sub("", " ".join(row.raw.replace("\0", " ").split()))
        if not bare and not begun:
            continue
        form.rows.append(row)
        begun.append((row, bare))
        if bare.endswith("\\"):
            continue
        section = _take_ini(form, section, begun)
        begun = []
    if begun:
        _take_ini(form, section, begun)
    return form


def _with_includes(form, text, place):
    """Yield the lines of an INI and of the files that it includes."""
    files = _Included(form, place)
    for row in _rows(text):
        found = re.match(r"\s*#INCLUDE\b\s*(.*)", row.raw)
        if not found:
            yield row
            continue
        names = re.sub(r"\s#.*", "", found[1]).split()[:1]
        if place is None or not names:
            form.rows.append(row)
            form.note(row, "what stands there is not read")
            continue
        told = len(form.notes)
        for rows, _ in files.rows(row, names, place.parent, must=False):
            yield from _without_includes(form, rows)
        if len(form.notes) > told:
            form.rows.append(row)


def _without_includes(form, rows):
    for row in rows:
        if re.match(r"\s*#INCLUDE\b", row.raw):
            form.rows.append(row)
            form.note(row, "LinuxCNC does not read it there")
        else:
            yield row


def _take_ini(form, section, begun):
    """Take a line with what goes on behind it; return the section that is in force now."""
    rows = [row for row, _ in begun]
    bare = " ".join(part.removesuffix("\\").strip() for _, part in begun).strip()
    if head := _HEAD.fullmatch(bare):
        form.heads[id(rows[0])] = head[1].strip().lower()
        return head[1].strip().lower()
    key, equals, value = bare.partition("=")
    if equals and key.strip():
        form.put((section, key.strip().lower()), value.strip(), rows, last_counts=False)
    return section


# ---- Klipper: key: value or key = value; what is indented further goes on


def klipper(text, place):
    """Read a printer.cfg of Klipper; `[include FILES]` in it and in what is included.

    place: path of the file, or None; what it includes is seen from there.
    """
    form = Form()
    reader = _Klipper(form, _Included(form, place))
    reader.read(_rows(text), place and place.parent)
    reader.end_value()
    return form


class _Klipper:
    """Where in a printer.cfg one stands."""

    def __init__(self, form, files):
        self.form, self.files = form, files
        self.section, self.key, self.indent = None, None, 0
        self.values, self.value_rows = [], []

    def read(self, rows, folder):
        """Read lines, and the files that they include."""
        for row in rows:
            raw = re.sub(r"^#\*#( |$)", "", row.raw)  # what Klipper has saved there by itself
            bare = _COMMENT.sub("", raw.partition("#")[0]).strip()
            if not bare:
                continue
            indent = len(raw) - len(raw.lstrip())
            if self.key is not None and indent > self.indent:
                self.form.rows.append(row)
                self.values.append(bare)
                self.value_rows.append(row)
                continue
            self.indent = indent
            self._begin(row, bare, folder)

    def _begin(self, row, bare, folder):
        """Take a line that goes on with nothing."""
        self.end_value()
        head = re.match(r"\[(.+)\]", bare)
        if head and head[1].split(None, 1)[0].lower() == "include":
            self._include(row, head[1].split(None, 1)[1:], folder)
            return
        self.form.rows.append(row)
        pair = re.match(r"(.*?)\s*[:=]\s*(.*)", bare)
        if head:
            self.section = head[1].strip().lower()
            self.form.heads[id(row)] = self.section
        elif pair and pair[1] and self.section is not None:
            self.key, self.values, self.value_rows = pair[1].lower(), [pair[2]], [row]

    def end_value(self):
        """Keep the value that is being read."""
        if self.key is not None:
            value = "\n".join(self.values).strip()
            self.form.put((self.section, self.key), value, self.value_rows, last_counts=True)
        self.key = None

    def _include(self, row, words, folder):
        self.section = None
        if folder is None or not words:
            self.form.rows.append(row)
            self.form.note(row, "what stands there is not read")
            return
        many = glob.has_magic(words[0])
        names = sorted(glob.glob(words[0], root_dir=folder)) if many else words
        if not names:
            self.form.rows.append(row)
            self.form.note(row, "no such files")
        if any(Path(name).name in _PAGES and not Path(folder, name).exists() for name in names):
            self.form.rows.append(row)  # where that is told
        for rows, inner in self.files.rows(row, names, folder, must=True):
            self.read(rows, inner)
            self.end_value()
            self.section = None


_STAMP = re.compile(r"^\s*(\[?\d\d?:\d\d:\d\d(\.\d+)?\]?\s*)?((->|>+)\s*)?")  # of a terminal


# ---- grbl: $110=500.000, and of $I what it says of the build


def grbl(text, place):
    """Read what $$ and $I print, or what is sent to set it; grbl has no other files."""
    del place
    form = Form()
    for row in _rows(text):
        if not row.text:
            continue
        form.rows.append(row)
        bare = _STAMP.sub("", row.raw)
        pair = re.match(r"\$(\d+)\s*=\s*([^\s(;]+)", bare, re.ASCII)
        if pair:
            form.put(("$", str(int(pair[1]))), pair[2], [row], last_counts=True)
        build = re.match(r"\[OPT:[^,\]]*,(\d+)", bare, re.ASCII)
        if build:
            form.put(("i", "blocks"), build[1], [row], last_counts=True)
        if re.match(r"\[FIRMWARE:\s*grblHAL", bare, re.I):
            form.put(("i", "firmware"), "grblHAL", [row], last_counts=True)
    return form


# ---- Marlin: M203 X300.00 Y300.00 Z20.00 E60.00


def marlin(text, place):
    """Read what M503 prints, or what is sent to set it: M words with a number behind each letter.

    Of another extruder (T1) the line is told and not read, and so is what Prusa's printers have
    of their stealth mode, under a heading of its own.
    """
    del place
    form, is_stealth = Form(), False
    for row in _rows(text):
        sent = _STAMP.sub("", row.raw)
        bare = re.sub(r";.*", "", re.sub(r"^(Recv:\s*)?(echo:)?", "", sent, flags=re.I)).strip()
        if not bare:
            continue
        form.rows.append(row)
        words = re.match(r"([GM]\d+)\b(.*)", bare, re.I)
        if not words:
            is_stealth = "- stealth" in bare.lower()
            continue
        if is_stealth:
            form.note(row, "of the stealth mode; the normal one counts")
            continue
        if re.search(r"\bT[1-9]", words[2]) and words[1].upper() != "M204":
            continue
        if words[1].upper() == "G20":
            form.put(("", "g20"), "G20", [row], last_counts=True)
        for letter, value in re.findall(r"([A-Za-z])\s*([^\sA-Za-z]+)", words[2]):
            key = (words[1].lower(), letter.lower())
            form.put(key, value, [row], last_counts=True)
    return form


# ---- RepRapFirmware: M203 X12000 Y12000:12000 E4200:4200


_REPRAP = frozenset(f"m{code}" for code in (92, 201, 203, 204, 208, 566, 665, 667, 669))
_ELSEWHERE = frozenset(("m98", "m501", "m505"))  # other files, whose words hold, too
_WHETHER = re.compile(r"(if|elif|else|while)\b")


def reprap(text, place):
    """Read a config.g: M words with a number behind each letter, of several drivers the first's.

    Of M208 "m208.1" are the lower ends, "m208.0" the upper ones; X-5:210 says both. What an
    expression or a condition decides cannot be known.
    """
    del place
    form, above = Form(), None
    for row in _rows(text):
        bare = re.sub(r";.*", "", row.raw).expandtabs().rstrip()
        if not bare.strip():
            continue
        form.rows.append(row)
        indent = len(bare) - len(bare.lstrip())
        above = None if above is not None and indent <= above else above
        if _WHETHER.match(bare.lstrip()):
            above = indent if above is None else above
            continue
        commands = re.split(r"(?<!\S)(?=[GM]\d)", re.sub(r'"[^"]*"', "", bare), flags=re.I)
        for command in commands:
            words = re.match(r"([GM]\d+(?:\.\d+)?)(?![\d.])(.*)", command.strip(), re.I)
            if words:
                _take_command(form, words[1].lower(), words[2], row, above is not None)
    return form


def _take_command(form, code, words, row, depends):
    if code == "g20":
        form.put(("", "g20"), "G20", [row], last_counts=True)
    elif code in _ELSEWHERE:
        form.note(row, "what stands there is not read")
    elif code in _REPRAP and (depends or "{" in words):
        why = "holds only on a condition" if depends else "has an expression"
        problem = row.place, f"{row.text}: {why}; say it once, in numbers"
        form.problems += [problem] * (problem not in form.problems)
    else:
        _take_words(form, code, words, row)


def _take_words(form, code, words, row):
    pairs = [(letter.lower(), value) for letter, value in
             re.findall(r"([A-Za-z])\s*([-+.:\d]+)", words)]  # fmt: skip
    lower = dict(pairs).get("s") == "1"
    for letter, value in pairs:
        first, _, more = value.partition(":")
        if code == "m208" and letter != "s":
            if more:
                form.put(("m208.1", letter), first, [row], last_counts=True)
            upper = more or first
            key = "m208.1" if lower and not more else "m208.0"
            form.put((key, letter), upper, [row], last_counts=True)
        else:
            form.put((code, letter), first, [row], last_counts=True)


# ---- FluidNC: maps of YAML


def fluidnc(text, place):
    """Read the maps of YAML: the section of a key is the keys that it stands under."""
    del place
    form, above = Form(), []
    for row in _rows(text):
        bare = re.sub(r"(?:^|\s)#.*", "", row.raw).rstrip()
        if not bare:
            continue
        form.rows.append(row)
        pair = re.match(r"(\s*)([\w.\-]+|\"[\w.\-]+\"|'[\w.\-]+')\s*:(?:\s+(.*)|$)", bare)
        if not pair:
            continue
        depth, name = len(pair[1].expandtabs()), pair[2].strip("\"'").lower()
        above = [each for each in above if each[0] < depth]
        section = ".".join(key for _, key in above)
        if pair[3]:
            form.put((section, name), pair[3].strip("\"'"), [row], last_counts=True)
        else:
            above.append((depth, name))
            form.heads[id(row)] = ".".join(key for _, key in above)
    return form


FORMS = {
    "LinuxCNC (INI)": linuxcnc, "grbl or grblHAL ($$)": grbl, "Klipper (printer.cfg)": klipper,
    "FluidNC (YAML)": fluidnc, "RepRapFirmware (config.g)": reprap, "Marlin (M503)": marlin,
}  # fmt: skip
