# SPDX-License-Identifier: MIT
"""What a configuration of LinuxCNC lacks for this planner."""

import os
import re
from pathlib import Path

LETTERS = "XYZABCUVW"
SERVO_NS = 990_000  # a shorter servo period wants another build
RAMP_S = 0.1  # until an axis has its acceleration: what jerk is proposed


def expand(text, folder):
    """Return (text, notes) of an INI file with what its ``#INCLUDE`` lines name in their place.

    As LinuxCNC does it: names are relative to the file's folder, ``~`` and ``$NAME`` count, and
    what is included includes nothing more. What cannot be read it leaves out.
    """
    lines, notes = [], []
    for number, line in enumerate(text.splitlines(), 1):
        word, _, name = line.strip().partition(" ")
        if word != "#INCLUDE":
            lines.append(line)
            continue
        path = Path(folder) / Path(os.path.expandvars(name.strip().strip("\"'"))).expanduser()
        try:
            lines += path.read_text(encoding="utf-8", errors="replace").splitlines()
        except OSError as cause:
            notes.append(f"line {number}: #INCLUDE {name}: {cause.strerror}")
    return "\n".join(lines), notes


def settings(text):
    """Return {(section, WORD): first value} of an INI file's text."""
    found, section = {}, ""
    for line in re.sub(r"\\\r?\n", "", text).splitlines():
        line = line.strip()
        if line.startswith("["):
            section = line[1:].partition("]")[0]
        elif "=" in line and line[0] not in "#;":
            word, _, value = line.partition("=")
            found.setdefault((section, word.strip()), value.strip())
    return found


def _number(found, section, word):
    """Return a number above zero; None if there is none."""
    try:
        number = float(found.get((section, word), "").split()[0])
    except (ValueError, IndexError):
        return None
    return number if 0 < number < 1e15 else None


def _joints(found, axes):
    """Return {letter: numbers of its joints} of trivial kinematics; None for others."""
    words = found.get(("KINS", "KINEMATICS"), "").split()
    if not words or words[0] != "trivkins":
        return None
    order = re.search(r"coordinates=(\S+)", " ".join(words))
    letters = order[1].upper() if order else LETTERS
    return {axis: [n for n, letter in enumerate(letters) if letter == axis] for axis in axes}


def _places_of_jerk(found, axis, joints):
    """Return where the jerk of an axis is told, [(section, WORD)]."""
    every = "MAX_ANGULAR_JERK" if axis in "ABC" else "MAX_LINEAR_JERK"
    places = [(f"AXIS_{axis}", "MAX_JERK"), *((f"JOINT_{n}", "MAX_JERK") for n in joints)]
    return [place for place in [*places, ("TRAJ", every)] if place in found]


def _is_none(text):
    """Return whether a value is zero: no limit."""
    try:
        return float(text.split()[0]) == 0
    except (ValueError, IndexError):
        return False


def _of_axis(found, axis, joints):
    """Return (lines to add to an axis' section, what is wrong with its limits)."""
    wrong = [
        f"[AXIS_{axis}] {word} is missing or no number above zero"
        for word in ("MAX_VELOCITY", "MAX_ACCELERATION")
        if not _number(found, f"AXIS_{axis}", word)
    ]
    places = _places_of_jerk(found, axis, joints)
    wrong += [
        f"[{section}] {word} is no number above zero; 0 means none"
        for section, word in places
        if not _number(found, section, word) and not _is_none(found[section, word])
    ]
    a_max = _number(found, f"AXIS_{axis}", "MAX_ACCELERATION")
    return [f"MAX_JERK = {a_max / RAMP_S:g}"] if a_max and not places else [], wrong


def look_at(text):
    """Look through an INI file.

    Parameters
    ----------
    text : str
        Of the file.

    Returns
    -------
    dict
        ``add``: lines to add, by section; ``errors``: what keeps the module from loading;
        ``notes``: what the owner should know.
    """
    found = settings(text)
    add, wrong, notes = {}, [], []
    planner = found.get(("TRAJ", "TPMOD"), "")
    if planner.split()[:1] != ["nck_tp"]:
        add["TRAJ"] = ["TPMOD = nck_tp"]
        if planner:
            notes.append(f"[TRAJ] TPMOD = {planner}: another planner; replace the line")
    coordinates = found.get(("TRAJ", "COORDINATES"), "").upper()
    axes = [letter for letter in LETTERS if letter in coordinates]
    if not axes:
        wrong.append("[TRAJ] COORDINATES is missing: write the machine's axes, as X Y Z")
    joints = _joints(found, axes)
    if joints is None:
        notes.append("the kinematics are no trivkins: limits hold for axes, not for joints")
    period_ns = _number(found, "EMCMOT", "SERVO_PERIOD")
    if period_ns and period_ns < SERVO_NS:
        notes.append(
            f"[EMCMOT] SERVO_PERIOD = {period_ns:g}: pycnc linuxcnc build --short-servo, or "
            "dense programs are slow"
        )
    for axis in axes:
        lines, bad = _of_axis(found, axis, (joints or {}).get(axis, []))
        wrong += bad
        if lines:
            add[f"AXIS_{axis}"] = lines
    return {"add": add, "errors": wrong, "notes": notes}
