# SPDX-License-Identifier: MIT
"""Which jerk? What programs take with each on the machine of an INI file, and a line for it."""

import os
from pathlib import Path
from typing import NamedTuple

from pycnc import errors
from pycnc.extras import need
from pycnc.files import Part
from pycnc.linuxcnc import configuration
from pycnc.machine import Machine, MachineFileError, importer
from pycnc.planning.plan import Plan
from pycnc.program import Program

RAMPS_S = (0.4, 0.2, 0.1, 0.05, 0.025, 0.0125, 0.00625)  # until an axis has its acceleration
WORTH = 0.03  # of the time, which half of a ramp is to save at least
LONGEST_S = 0.1  # a ramp that is recommended, as `ini` has it: holds take as much longer
_TOLERANCE_MM = 0.05  # of G64 without P, as the module has it
_INCH_MM = 25.4
_INK, _TIME, _CHOSEN = "#20242c", "#1f6feb", "#d1495b"


class Row(NamedTuple):
    """What the programs take with one jerk; units are those of the INI file."""

    ramp_s: float  # of the axis with the least acceleration; 0: no limit of jerk
    jerk: float  # of linear axes; 0: none
    angular: float  # of rotary axes; 0: none, or no such axis
    time_s: float

    @property
    def quiet_hz(self):
        """From which frequency on such a ramp leaves no vibration, but for what is in between."""
        return 1 / self.ramp_s if self.ramp_s else None


def machine_of(text, name, folder):
    """Return the machine of an INI file as the planner module has it.

    Parameters
    ----------
    text : str
    name : str
        Of the file.
    folder : path
        Where it lies.

    Raises
    ------
    MachineFileError
        If the file lacks what the module needs.
    """
    draft = importer.read(text, name, folder)
    problems = draft.problems + [("", words) for words in configuration.look_at(text)["errors"]]
    if problems:
        raise MachineFileError(name, problems)
    told = configuration.settings(text).get(("TRAJ", "NCK_TOLERANCE"))
    slope, *_ = draft.values.get("path.slope", ("optimal",))
    with_jerk = "optimal" if slope == "linear" else slope  # which has none, or is what none brings
    changes = ["control.kind=nck_tp", f"path.slope={with_jerk}"]
    if not told:
        changes.append(f"path.tolerance_mm={_TOLERANCE_MM}")
    machine = Machine.from_text(draft.text([]), name=Path(name).stem)
    return Machine.load(machine, set=changes)


def _accelerations(machine, unit):
    """Return axis → acceleration of those axes that have this unit."""
    key = f"a_max_{unit}_s2"
    axes = ((axis, getattr(machine.settings.axis, axis)) for axis in machine.axes)
    return {axis: float(getattr(limits, key)) for axis, limits in axes if hasattr(limits, key)}


def _jerk_of(accelerations, ramp_s):
    """Return the jerk that gives the least of some accelerations in that time; 0: none."""
    return min(accelerations.values()) / ramp_s if accelerations and ramp_s else 0.0


def rows_of(machine, texts, unit_mm, progress=None):
    """Return what programs take with each jerk, the least first; the last row has no limit.

    Without one the module's planner is linear, which may take longer than any.

    Parameters
    ----------
    machine : Machine
    texts : dict
        Name → program.
    unit_mm : float
        The INI file's unit of length.
    progress : callable, optional
        Called with how many plans are made, and of how many.
    """
    straight, turning = (_accelerations(machine, kind) for kind in ("mm", "deg"))
    if not straight:
        raise errors.ArgumentError(f"{machine.name}: it has no linear axis", id="axes")
    rows = []
    for n, ramp in enumerate([*RAMPS_S, 0.0]):
        jerk, angular = (_jerk_of(each, ramp) for each in (straight, turning))
        changes = [f"axis.{axis}.j_max_mm_s3={jerk}" for axis in straight]
        changes += [f"axis.{axis}.j_max_deg_s3={angular}" for axis in turning]
        changes = changes if ramp else ["path.slope=linear"]
        changed = Machine.load(machine, set=changes)
        programs = (Program(text, changed, file=name, keep=False).check()
                    for name, text in texts.items())  # fmt: skip
        time_s = sum(Plan(program, keep=False).time_s for program in programs)
        rows.append(Row(ramp, jerk / unit_mm, angular, time_s))
        if progress:
            progress(n + 1, len(RAMPS_S) + 1)
    return rows


def choose(rows):
    """Return the row to begin with: half of its ramp saves less than WORTH of the time, and it is
    no longer than LONGEST_S."""
    for row, harder in zip(rows, rows[1:-1], strict=False):
        if row.ramp_s <= LONGEST_S and row.time_s - harder.time_s < WORTH * row.time_s:
            return row
    return rows[-2]


def lines_for(row, found):
    """Return what to write into an INI file, and what stands there that would count first."""
    add = [f"MAX_LINEAR_JERK = {row.jerk:g}"]
    add += [f"MAX_ANGULAR_JERK = {row.angular:g}"] if row.angular else []
    first = [f"[{section}] {word}" for section, word in found
             if word == "MAX_JERK" and section.startswith(("AXIS_", "JOINT_"))]  # fmt: skip
    return add, first


def unit_mm(found):
    """Return the unit of length of an INI file's settings [mm]."""
    word = found.get(("TRAJ", "LINEAR_UNITS"), "mm").lower()
    return _INCH_MM if word.startswith("in") else 1.0


def draw(rows, chosen, name, path):
    """Draw what jerk costs and buys into a file: png, svg or pdf, by its ending; return its name.

    Parameters
    ----------
    rows : list of Row
    chosen : Row
    name : str
        Of the machine.
    path : path
    """
    figure = need("matplotlib.figure").Figure(
        figsize=(8, 4.5), dpi=110, layout="constrained", facecolor="white"
    )
    axes = figure.add_subplot()
    limited = rows[:-1]
    jerks = [row.jerk for row in limited]
    axes.semilogx(jerks, [row.time_s for row in limited], "o-", color=_TIME)
    axes.axhline(rows[-1].time_s, color=_INK, linewidth=0.8, linestyle=":")
    axes.text(jerks[0], rows[-1].time_s, "no limit: linear", color=_INK, va="bottom")
    axes.semilogx([chosen.jerk], [chosen.time_s], "o", markersize=12, color=_CHOSEN, zorder=3)
    axes.set_ylim(bottom=0)
    axes.set_xlabel("jerk of linear axes [units/s³]", color=_INK)
    axes.set_ylabel("time [s]", color=_INK)
    above = axes.secondary_xaxis("top")
    above.set_xticks(jerks, [f"{row.quiet_hz:g}" for row in limited])
    above.set_xlabel("leaves no vibration above [Hz]", color=_INK)
    figure.suptitle(f"{name}   ·   MAX_LINEAR_JERK = {chosen.jerk:g}", color=_INK)
    target = os.fspath(path)
    with Part(target) as part:
        figure.savefig(part.file, format=Path(target).suffix[1:] or "png")
    return target
