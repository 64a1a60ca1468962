# SPDX-License-Identifier: MIT
"""What searches of the planner module's calls share: limits that are held, words of a script."""

from linuxcnc_stand_in import BY_TICK

ROUNDING = 1e-6  # of a limit, on doubles


def held(run, rows=slice(None)):
    """Return what is wrong with the limits of the axes, in words."""
    most = {"speed": 1 + ROUNDING, "acceleration": 1 + ROUNDING, "jerk": BY_TICK}
    told = zip(most, run.peaks(rows), strict=True)
    return [f"{name} {peak:.4f} of its limit" for name, peak in told if peak > most[name]]


def words_of(*numbers):
    """Return the words of numbers."""
    return " ".join(f"{x:.4f}" for x in numbers)
