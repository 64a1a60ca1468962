# SPDX-License-Identifier: MIT
"""What a program of LinuxCNC's language says to its operator: (MSG, …), (DEBUG, …), (PRINT, …).

They are found in the text, not where it goes at a run: a line in a branch that is not taken is
told, too, and numbers that DEBUG and PRINT put in are told as they are written.
"""

import re

_SPEAKS = re.compile(rb"\([ \t]*(MSG|DEBUG|PRINT)[ \t]*,([^()\n]*)\)", re.I)
_COMMENT = re.compile(rb"\([^()\n]*\)|;[^\n]*")
_NUMBERS = re.compile(rb"#|%")


def found(text, machine, last):
    """Yield (line, column, words) of what a program says, up to a line; 0: to its end.

    Of several comments of a line the last one counts, as in LinuxCNC.
    """
    dialect = machine.settings.dialect
    number, seen = 1, 0
    for remark in _SPEAKS.finditer(text) if dialect.base == "linuxcnc" else ():
        number += text.count(b"\n", seen, remark.start())
        seen = remark.start()
        if last and number > last:
            return
        begin, end = text.rfind(b"\n", 0, seen) + 1, text.find(b"\n", seen)
        line = text[begin : end if end >= 0 else len(text)]
        skipped = dialect.block_skip and line.lstrip().startswith(b"/")
        *_, comment = _COMMENT.finditer(line)  # the remark itself is one, or in one
        if not skipped and begin + comment.start() == seen:
            yield number, seen - begin + 1, _words(remark[1].upper(), remark[2].strip())


def _words(kind, text):
    said = text.decode("utf-8", errors="replace")
    if kind == b"MSG" or not _NUMBERS.search(text):
        return f"says: {said}"
    return f"says, with the numbers that hold then: {said}"
