# SPDX-License-Identifier: MIT
"""Tool tables in the format of LinuxCNC's ``tool.tbl``: ``T1 P1 Z51.2 D6 ;end mill``."""

import re
from decimal import Decimal, InvalidOperation

# letter of the table → key of [tool.N]
_KEYS = {"X": "x_mm", "Y": "y_mm", "Z": "length_mm", "D": "radius_mm", "Q": "orientation"}
_IGNORED = frozenset("PABCUVWIJ")  # pocket, other offsets, front and back angle
# Where a tip points: LinuxCNC's number → Fanuc's, and the other way; 0, 5, 7 and 9 are alike.
TURNED = {1: 4, 4: 1, 2: 3, 3: 2, 6: 8, 8: 6}
_WORD = re.compile(r"\s*([A-Za-z])\s*([-+]?[0-9.]+)")


def read(text):
    """Read a tool table.

    Parameters
    ----------
    text : str
        The file; lengths in mm, D is a diameter.

    Returns
    -------
    tools : dict
        Tool number (as text) → keys of a ``[tool.N]`` table.
    problems : list of (str, str)
        Where (``line 3``) and what is wrong.
    """
    tools, problems = {}, []
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split(";", 1)[0].strip()
        if not words:
            continue
        try:
            name, tool = _tool(words)
        except ValueError as cause:
            problems.append((f"line {number}", str(cause)))
            continue
        if name in tools:
            problems.append((f"line {number}", f"tool {name} is there twice"))
        tools[name] = tool
    if not tools and not problems:
        problems.append(("the file", "holds no tool (a line such as: T1 P1 Z51.2 D6)"))
    return tools, problems


def _tool(words):
    tool, name, position = {}, None, 0
    while position < len(words):
        word = _WORD.match(words, position)
        if not word:
            raise ValueError(
                f"cannot read {words[position : position + 20]!r}; "
                "allowed are words such as T1 P1 Z51.2 D6"
            )
        position = word.end()
        letter, value = word[1].upper(), _number(word[2])
        if letter == "T":
            name = str(_whole(letter, value))
        elif letter in _KEYS:
            tool[_KEYS[letter]] = _in_machine_units(letter, value)
        elif letter not in _IGNORED:
            raise ValueError(f"a tool table has no {letter} word")
    if name is None:
        raise ValueError("a tool without a T word")
    return name, tool


def _number(text):
    try:
        return Decimal(text)
    except InvalidOperation:
        raise ValueError(f"{text!r} is no number") from None


def _whole(letter, value):
    if value != int(value):
        raise ValueError(f"{letter}{value} must be a whole number")
    return int(value)


def _in_machine_units(letter, value):
    if letter == "Q":
        return _whole(letter, value)
    return value / 2 if letter == "D" else value
