# SPDX-License-Identifier: MIT
"""Where the time of a program goes: to which tools, sections or lines."""

import re

import numpy as np

from pycnc import errors
from pycnc.planning import measure

KINDS = ("tool", "section", "line")
TOOLS_MAX = 256  # tools of a program that are told apart
_COMMENT = re.compile(rb"\s*(?:N\d+\s*)?(?:\(([^()]*)\)|;(.*))\s*$", re.I)
_PARTS = ("cut_s", "rapid_s", "dwell_s")


def ask(program, by):
    """Return what the planner is asked for, and the names of its rows.

    Parameters
    ----------
    program : Program
    by : {"tool", "section", "line"}
        A section begins at a comment that has a line of its own; those of the same words are one.

    Returns
    -------
    shares : int or numpy.ndarray
        As `kernel.Planner` takes it.
    names : list of str
        Of the rows; empty for tools.
    """
    if by not in KINDS:
        raise errors.ArgumentError(f"no parts by {by!r}; there are: {', '.join(KINDS)}", id="by")
    if by == "tool":
        return TOOLS_MAX, []
    lines = program.lines
    count = len(lines) if lines else program.block_count
    if by == "line":
        texts = [b"", *lines] if lines else [b""] * (count + 1)
        return np.arange(count + 1, dtype=np.uint32), texts
    rows, names = np.zeros(count + 1, np.uint32), {"before the first comment": 0}
    row = 0
    for number, line in enumerate(lines, 1):
        comment = _COMMENT.match(line)
        words = comment and _words(comment[1] or comment[2] or b"")
        if words:
            row = names.setdefault(words, len(names))
        rows[number] = row
    return rows, list(names)


def _words(data):
    return " ".join(data.decode("utf-8", errors="replace").split())


def table(program, by, rows, names):
    """Return the parts of a plan's time, the longest first.

    Parameters
    ----------
    rows : numpy.ndarray
        Of dtype ``nck_host_share_t``, as the planner filled them.

    Returns
    -------
    list of dict
        ``name``, ``line`` (the first one), times in s, and ``time_s``, what they add up to. Rows
        without time are left out.
    """
    told = []
    for place, row in enumerate(rows):
        times = {name: float(row[name]) for name in _PARTS}
        times |= measure.extra_times(row["tool_changes"], row["spindle_starts"], program.machine)
        if row["line"]:
            name = _name(by, place, row, names)
            told.append({"name": name, "line": int(row["line"]), **times,
                         "time_s": sum(times.values())})  # fmt: skip
    return sorted(told, key=lambda part: -part["time_s"])


def _name(by, place, row, names):
    if by == "tool":
        return f"T{int(row['key'])}" if row["key"] else "no tool"
    return names[place] if by == "section" else _words(names[place])


def left(program, parts, line):
    """Return the time [s] from where a program first comes to a line, or behind it, to its end.

    Parameters
    ----------
    parts : list of dict
        Of the lines, as `table` returns them.

    Raises
    ------
    ArgumentError
        If lines come again, so that a line does not say how far the program is; or if the program
        ends before the line.
    """
    if line > (end := program.end_line):
        raise errors.ArgumentError(
            f"the program ends at line {end}: it never comes to line {line}, and nothing is left "
            f"there; choose a line up to {end}", id="left",
        )  # fmt: skip
    last = 0
    for blocks in program.pieces():
        lines = np.concatenate([[last], blocks["line"]])
        back = np.flatnonzero(np.diff(lines) < 0)
        if back.size:
            raise errors.ArgumentError(
                f"line {lines[back[0] + 1]} comes behind line {lines[back[0]]}: in a program with "
                "loops or subprograms a line does not say how far it is", id="left",
            )  # fmt: skip
        last = int(lines[-1])
    return sum(part["time_s"] for part in parts if part["line"] >= line)
