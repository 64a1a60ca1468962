# SPDX-License-Identifier: MIT
"""What a time is made of, in the same words and order whichever verb tells it."""

from pycnc.planning.control import title
from pycnc.report.plot import duration

# A wait is the period in which the path rests for M0, M1 or M6, or where smoothing begins.
KINDS = {"cut": "cut", "rapid": "rapid", "dwell": "dwells and waits",
         "tool_change": "tool changes", "spindle": "spindle starts"}  # fmt: skip
EXTRAS = ("tool_change", "spindle")  # no axis moves meanwhile
MOTIONS = {"accelerate": "speeding up", "cruise": "steady", "decelerate": "braking"}


def head(program, total_s, by=""):
    """Return what is told first of a program: its machine, and its whole time."""
    machine = program.machine
    return f"{program.file} on {machine.name}, {title(machine)}{by}: {duration(total_s)}"


def told(facts, names):
    """Return (word, time in words) of parts of a time, those that there are.

    Parameters
    ----------
    facts : dict
        Times by their names, ``cut_s``.
    names : iterable of str
        Of `KINDS` and `MOTIONS`.
    """
    words = KINDS | MOTIONS
    return [(words[name], duration(facts[f"{name}_s"])) for name in names if facts[f"{name}_s"] > 0]
