# SPDX-License-Identifier: MIT
"""Subprograms in files of their own: those that a text calls and does not hold are put behind it.

A remark before each says where it came from, so that its lines are told by their own file.
"""

import re
from pathlib import Path
from urllib.parse import quote, unquote

from pycnc import files

_FANUC = "fanuc"
_ENDINGS = {"", ".nc", ".ngc", ".cnc", ".tap", ".txt", ".prg", ".mpf"}
_LAST_DIGITS = 10_000  # M98 P31000: three times 1000
_MARK = re.compile(rb"(?:O\d+ )?\(program of ([^)]*)\)")
_ENDS = re.compile(rb"^[^(;]*\bM *(?:0?2|30|99)\b|^\s*%\s*$", re.IGNORECASE | re.MULTILINE)
_REMARK = re.compile(rb"\([^)]*\)|;.*")
# What calls one, and what begins one.
_CALLS = {
    True: re.compile(rb"\b(?:M *98|G *6[56])\b[^(;]*?P *(\d{1,8})", re.IGNORECASE),
    False: re.compile(rb"O *(<[^>]+>|\d+) *CALL\b|\bM *98\b[^(;]*?P *(\d{1,8})", re.IGNORECASE),
}
_BEGINS = re.compile(rb"[\s/]*(?:N *\d+ *)?[O:] *(<[^>]+>|\d+) *(?:SUB\b|[(;]|$)", re.IGNORECASE)


class FolderError(ValueError):
    """A folder of programs that cannot be used."""


def _first(known, names):
    """Return the first of these names that a file has, and it; else the last, and None."""
    found = ((name, _find(known, name)) for name in names)
    return next((each for each in found if each[1]), (names[-1], None))


def joined(text, folder, base):
    """Return a text with the programs of a folder that it calls and does not hold.

    Parameters
    ----------
    text : bytes
    folder : str
    base : str
        The language, as ``dialect.base`` names it.
    """
    here = Path(folder)
    if not here.is_dir():
        raise FolderError(f"{folder} is no folder")
    known = sorted(each for each in here.iterdir() if each.suffix.lower() in _ENDINGS)
    fanuc, pieces, at = base == _FANUC, [text], 0
    there = set(_begun(text))
    while at < len(pieces):
        for names in _called(pieces[at], fanuc):
            if there.intersection(names):
                continue
            name, file = _first(known, names)
            there.add(name)
            if file:
                pieces.append(_read(file, name))
                there.update(_begun(pieces[-1]))
        at += 1
    if len(pieces) == 1:
        return text
    if not _ENDS.search(text):
        pieces.insert(1, b"M30")  # what follows is called, and not run into
    return b"\n".join([pieces[0].rstrip(b"\r\n"), *pieces[1:]])


def places(text):
    """Return [(number of the remark's line, file)] of the programs that `joined` has added."""
    if not _MARK.search(text):
        return []
    found = ((number, _MARK.fullmatch(line)) for number, line in enumerate(text.splitlines(), 1))
    return [(number, unquote(match[1].decode())) for number, match in found if match]


def _name(word):
    """Return a program's name as a key: a number, or what stands in < >."""
    plain = word.strip(b"<>").decode("utf-8", "replace").replace(" ", "").lower()
    return str(int(plain)) if plain.isdecimal() and plain.isascii() else plain


def _called(text, fanuc):
    """Yield the names of what is called: the first that there is counts."""
    for line in text.splitlines():
        for match in _CALLS[fanuc].finditer(_REMARK.sub(b"", line)):
            name = _name(next(filter(None, match.groups())))
            number = int(name) if name.isdecimal() else 0
            splits = fanuc and number >= _LAST_DIGITS
            yield (name, str(number % _LAST_DIGITS)) if splits else (name,)


def _begun(text):
    for line in text.splitlines():
        if match := _BEGINS.match(line):
            yield _name(match[1])


def _find(known, name):
    """Return the file of a program: O9000.nc, 9000.ngc, name.ngc; None: there is none."""
    number = name.lstrip("0") or "0"
    found = [each for each in known
             if each.stem.lower() == name
             or (name.isdecimal() and re.fullmatch(rf"o?0*{number}", each.stem, re.IGNORECASE))]
    if len(found) > 1:
        raise FolderError(f"{name} is in two files: {found[0].name}, {found[1].name}")
    return found[0] if found else None


def _read(file, name):
    """Return the program of a file behind its remark; what opens and closes a tape is blank."""
    text = files.read(str(file), files.SETTINGS_MOST)
    lines = [b"" if line.strip().startswith(b"%") else line for line in text.splitlines()]
    begins = any(_name(match[1]) == name for match in map(_BEGINS.match, lines) if match)
    mark = f"(program of {quote(str(file))})".encode()
    if not begins and name.isdecimal():
        mark = b"O" + name.encode() + b" " + mark
    return b"\n".join([mark, *lines, b""])
