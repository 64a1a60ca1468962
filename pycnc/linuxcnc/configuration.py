# SPDX-License-Identifier: MIT
"""What a configuration of LinuxCNC lacks for this planner."""

import re

LETTERS = "XYZABCUVW"
RAMP_S = 0.1  # until an axis has its acceleration: what jerk is proposed


def settings(text):
    """Return {(section, WORD): first value} of an INI file's text."""
    found, section = {}, ""
    for line in text.splitlines():
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


def _jerk(found, axis, joints):
    """Return the jerk that is in force for an axis; None if there is none."""
    own = _number(found, f"AXIS_{axis}", "MAX_JERK")
    of_joints = [_number(found, f"JOINT_{n}", "MAX_JERK") for n in joints]
    every = "MAX_ANGULAR_JERK" if axis in "ABC" else "MAX_LINEAR_JERK"
    least = min((jerk for jerk in of_joints if jerk), default=None)
    return own or least or _number(found, "TRAJ", every)


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
    for axis in axes:
        for word in ("MAX_VELOCITY", "MAX_ACCELERATION"):
            if not _number(found, f"AXIS_{axis}", word):
                wrong.append(f"[AXIS_{axis}] {word} is missing or no number above zero")
        a_max = _number(found, f"AXIS_{axis}", "MAX_ACCELERATION")
        if a_max and not _jerk(found, axis, (joints or {}).get(axis, [])):
            add[f"AXIS_{axis}"] = [f"MAX_JERK = {a_max / RAMP_S:g}"]
    return {"add": add, "errors": wrong, "notes": notes}
