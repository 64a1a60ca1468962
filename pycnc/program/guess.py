# SPDX-License-Identifier: MIT
"""Which dialect a text is written in, by what only that dialect says."""

import re

LINES = 1000  # of the text's beginning: who speaks a dialect shows it there
FALLBACK = "linuxcnc"

# Dialect → what no other one has. The first that is found decides; the order settles a text that
# has signs of two: a printer's words, named subprograms, then Fanuc's macros and names.
_SIGNS = {
    "marlin": (
        (rb"^;\s*FLAVOR:\s*Marlin", "its slicer says so"),
        (rb"^(N\d+ *)?M(104|109|140|190|106|107)\b(?! *P *\d+ *$)", "a printer's M code"),
        (rb"^(N\d+ *)?G1 [^;(]*\bE-?[\d.]", "E moves an extruder"),
    ),
    "linuxcnc": (
        (rb"^(N\d+ *)?O *(<[^>]+>|\d+) *(SUB|CALL|IF|WHILE|DO|REPEAT)\b", "a controlling O word"),
        (rb"#<\w+>", "a named parameter"),
        (rb"^[^;(]*G(64 *P|33\.1|43\.2|59\.[123]|7[0123]\.[0-9]|9[0123]\.[0-9])", "{found}"),
        (rb"^[^;(]*G9[56][^;(]* D\d", "G96 with D"),
    ),
    "fanuc": (
        (rb"^[O:]\d{2,}\s*(\(.*)?$", "{found} names the program"),
        (rb"^(N\d+ *)?(IF *\[|WHILE *\[|GOTO *\d|#\d+ *= *|G65\b|G66\b)", "a macro: {found}"),
        (rb"^[^;(]*\bM98 *P", "M98 calls a subprogram"),
        (rb"^[^;(]*\bG(50 *S|43\.4|0?5(\.1)? *[PQ]\d|0?8 *P\d|54\.1|154 *P|187|28 *U)", "{found}"),
    ),
    "grbl": (
        (rb"\bgrbl\b", "the text names it"),
        (rb"^\$[HX$0-9]", "{found} is for grbl"),
    ),
}  # fmt: skip
_SIGNS = {
    dialect: [(re.compile(sign, re.IGNORECASE), reason) for sign, reason in signs]
    for dialect, signs in _SIGNS.items()
}


def beginning(text):
    """Return the first lines of a text."""
    return text[: 200 * LINES].splitlines()[:LINES]


def dialect_of(text):
    """Return (dialect, line, reason) of a text.

    Parameters
    ----------
    text : bytes

    Returns
    -------
    dialect : str
        A value of ``dialect.base``.
    line : int
        Where its sign stands, from 1; 0 if nothing tells.
    reason : str
        In words.
    """
    lines = [line.strip().lstrip(b"/") for line in beginning(text)]
    for dialect, signs in _SIGNS.items():
        for number, line in enumerate(lines, 1):
            for sign, reason in signs:
                if match := sign.search(line):
                    found = match[0].decode("utf-8", "replace").strip()
                    return dialect, number, reason.format(found=found)
    return FALLBACK, 0, "nothing in the text tells its dialect"
