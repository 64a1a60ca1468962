# SPDX-License-Identifier: MIT
"""Where the tool is as the part sees it, where rotary axes turn one of the two.

    place of the axes ─▶ the tool's point, from the program's zero ─▶ turned about X by A, about Y
    by B, about Z by C ─▶ place on the part

A positive angle turns the tool about the part by the right hand (ISO 841), so a table turns the
other way. C is nearest to the part. A machine file does not tell where the axes of rotation are:
they are taken to meet in the zero of the work system, as programs of a 4th axis have it.
"""

import numpy as np

from pycnc.kernel.records import counts_per_unit
from pycnc.machine.schema import AXES, ROTARY_AXES

_NM = 1e-6  # mm
_PLANES = ((1, 2), (2, 0), (0, 1))  # that A, B and C turn in


def turns(machine):
    """Return whether a machine has rotary axes beside X, Y and Z."""
    return any(letter in machine.axes for letter in ROTARY_AXES)


class Turning:
    """Turns places of the axes into places on the part.

    Parameters
    ----------
    program : Program
        Its tool offsets are taken from its blocks, by their source lines.

    Attributes
    ----------
    axes : list of int
        Which of A, B and C turn anywhere in it.
    """

    def __init__(self, program):
        record = program.machine.record
        rotary = [AXES.index(letter) for letter in ROTARY_AXES]
        zero = record["work_nm"][int(record["work_system"])] / counts_per_unit(
            record["axis"]["rotary"]
        )
        self._zero, self._angles = zero[:3], zero[rotary]
        start, moved = record["start_nm"][rotary], np.zeros(3, bool)
        lines, offsets = [0], [np.zeros(3)]
        for blocks in program.pieces():
            moved |= (blocks["target_nm"][:, rotary] != start).any(axis=0)
            tool = blocks["tool_nm"] * _NM
            known = np.vstack([offsets[-1], tool])
            for k in np.flatnonzero((np.diff(known, axis=0) != 0).any(axis=1)):
                lines.append(int(blocks["line"][k]))
                offsets.append(tool[k].copy())
        self.axes = [int(k) for k in np.flatnonzero(moved)]
        self._lines, self._offsets = np.array(lines), np.array(offsets)

    def on_part(self, xyz, abc, line):
        """Return places of the tool's point on the part, (n, 3) [mm].

        Parameters
        ----------
        xyz, abc : numpy.ndarray
            (n, 3) places of the axes [mm, deg].
        line : numpy.ndarray
            (n,) source lines.
        """
        order = np.argsort(self._lines, kind="stable")
        row = np.searchsorted(self._lines[order], line, side="right") - 1
        place = xyz - self._offsets[order][row] - self._zero
        angles = np.radians(abc - self._angles)
        for k, (one, other) in enumerate(_PLANES):
            cos, sin = np.cos(angles[:, k]), np.sin(angles[:, k])
            place[:, one], place[:, other] = (
                cos * place[:, one] - sin * place[:, other],
                sin * place[:, one] + cos * place[:, other],
            )
        return place + self._zero
