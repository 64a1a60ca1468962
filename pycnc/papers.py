# SPDX-License-Identifier: MIT
"""The experiments of Cao et al. 2014 and Keinert et al. 2014, as data: arrays and numbers.

`pycnc bench cao`, `pycnc bench keinert` and docs/papers.md show them.
"""

import json
from dataclasses import dataclass
from importlib import resources

import numpy as np

from pycnc import stages
from pycnc._bind import lib
from pycnc.machine import Machine
from pycnc.planning import plan

LOOKAHEADS = (0, 1, 2, 6)  # of Cao's figures 14 and table 2
PRINTED_MS = {0: 31636, 1: 7456, 2: 7208}  # Cao, section 8: total time by look-ahead segments
TIME_CONSTANT_S = 1.0  # Cao, section 8: t0; a ramp of fixed duration lasts 2 t0
_TICK_TOLERANCE = 1e-9  # of a period: a time that is whole but for rounding counts as whole


@dataclass(frozen=True)
class SegmentPath:
    """A path of few segments and the limits it is planned with.

    Attributes
    ----------
    length : numpy.ndarray
        (n,) of every segment [mm].
    v_node : numpy.ndarray
        (n + 1,) cap at every junction [mm/s]; rest at both ends.
    v_max, a_max, j_max : float
        Speed [mm/s], tangential acceleration [mm/s²] and jerk [mm/s³] along the path.
    period_s : float
        Interpolation period [s].
    """

    length: np.ndarray
    v_node: np.ndarray
    v_max: float
    a_max: float
    j_max: float
    period_s: float

    def profile(self, kind, lookahead):
        """Return the Profile of one kind of ramp with N look-ahead segments."""
        return stages.slope(
            self.length, self.v_max, self.a_max, self.j_max, self.v_node,
            kind=kind, lookahead=lookahead, ramp_s=2 * TIME_CONSTANT_S,
        )  # fmt: skip

    def segment_ms(self, profile):
        """Return the time of every segment in whole periods [ms]."""
        periods = np.ceil(profile.segment_s / self.period_s - _TICK_TOLERANCE)
        return np.round(periods * self.period_s * 1000, 6)


def lathe8_table():
    """Return the shipped path of eight segments as it is stored, with the tables it gives.

    It is one path that gives the printed totals of 7456 and 7208 ms; the paper's own table of
    segments is lost.
    """
    text = resources.files("pycnc").joinpath("examples/lathe8.json").read_text("utf-8")
    return json.loads(text)


def lathe8_program():
    """Return the path of eight segments as NC text."""
    lines = ["G21 G17 G90 G91.1 G94 F500"]
    for segment in lathe8_table()["segments"]:
        words = [segment["type"], *(f"{a}{x:.9f}" for a, x in zip("XY", segment["end"]))]
        words += [f"{letter}{segment[letter]:.9f}" for letter in "IJ" if letter in segment]
        lines.append(" ".join(words))
    return "\n".join([*lines, "M2", ""])


def lathe8():
    """Return the path of eight segments with the limits of the machine cao2014."""
    machine = Machine.load("cao2014")
    segs = plan(lathe8_program(), machine=machine).segs
    limits = machine.settings.path
    v_max, a_max = float(limits.feed_max_mm_min) / 60, float(limits.a_max_mm_s2)
    corner = corner_speeds(segs, a_max, machine.period_s)
    return SegmentPath(
        length=segs["length"].copy(),
        v_node=np.concatenate([[0], np.minimum(corner, v_max), [0]]),
        v_max=v_max,
        a_max=a_max,
        j_max=a_max**2 / v_max,  # with it a ramp from rest to v_max just reaches a_max
        period_s=machine.period_s,
    )


def corner_speeds(segs, a_max, period_s):
    """Return the transfer speed at every inner junction: v = a T/(2 sin(α/2)).

    α is the linking vector angle; this is Keinert's V1, and Cao's (14) for the path as a whole.

    Parameters
    ----------
    segs : numpy.ndarray
        (n,) of dtype ``nck_seg_t``.
    a_max : float
        [mm/s²].
    period_s : float
        Interpolation period T [s].

    Returns
    -------
    numpy.ndarray
        (n − 1,) [mm/s]; infinite where the tangent does not turn.
    """
    begin, end = _tangents(segs, "start"), _tangents(segs, "end")
    turn = np.linalg.norm(end[:-1] - begin[1:], axis=1)  # 2 sin(α/2)
    turn[turn < 1e-9] = 0  # tangent but for the digits of the program
    with np.errstate(divide="ignore"):
        return a_max * period_s / turn


def _tangents(segs, where):
    """Return (n, axes) unit tangents of flat arcs and lines at their starts or ends."""
    tangents = segs["end"] - segs["start"]
    for k in np.flatnonzero(segs["kind"] == lib.NCK_SEG_ARC):
        seg = segs[k]
        axes = [seg["axis_u"], seg["axis_v"]]
        u, v = seg[where][axes] - (seg["centre_u"], seg["centre_v"])
        tangents[k] = 0
        tangents[k, axes] = np.copysign(1, seg["sweep"]) * np.array([-v, u])
    return tangents / np.linalg.norm(tangents, axis=1, keepdims=True)


def lookahead_rows(path, lookaheads=(0, 1, 2, 3, 4, 6, 8)):
    """Return total time and end speeds by kind of ramp and look-ahead segments.

    Returns
    -------
    list of dict
        kind, lookahead, total_ms, printed_ms (None where the paper prints nothing), end speeds
        [mm/min] of the segments.
    """
    kinds = [("linear", n) for n in lookaheads] + [("sshape", n) for n in lookaheads]
    kinds += [("whole", n) for n in lookaheads] + [("fixed", 0)]
    rows = []
    for kind, n in kinds:
        profile = path.profile(kind, n)
        rows.append({
            "kind": kind,
            "lookahead": n,
            "total_ms": int(round(path.segment_ms(profile).sum())),
            "printed_ms": PRINTED_MS[min(n, 2)],
            "end_speed_mm_min": [round(float(v) * 60, 2) for v in profile.v_node[1:]],
        })  # fmt: skip
    return rows
