# SPDX-License-Identifier: MIT
"""The paths of the experiments, and look-ahead over N segments on them: arrays and numbers.

`pycnc lab bench cao`, `pycnc lab bench keinert` and docs/papers.md show them.
"""

import json
import time
from dataclasses import dataclass
from importlib import resources

import numpy as np

from pycnc import stages
from pycnc.planning import grades
from pycnc.machine import Machine
from pycnc.planning.plan import plan

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
    angle = grades.link_angles(segs)
    angle[angle < 1e-9] = 0  # tangent but for the digits of the program
    with np.errstate(divide="ignore"):
        return a_max * period_s / (2 * np.sin(angle / 2))


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


# Keinert et al.: a workpiece of many short blocks, for theirs is not given.

FREEFORM_FEED_MM_S = 100.0
FREEFORM_A_MAX = 1000.0
FREEFORM_J_MAX = 50000.0
FREEFORM_PERIOD_S = 0.001
_ROW_MM, _STEP_MM = 60.0, 0.5  # length of a pass over the surface, distance to the next
_CHORD_ERROR_MM = 0.0005


def freeform(blocks):
    """Return the points of a wavy surface, milled in passes to and fro.

    z = 4 sin(x/7) cos(y/9), with chords as long as an error of 0.5 µm allows, at most 0.6 mm in x.

    Parameters
    ----------
    blocks : int
        Moves, at least 1.

    Returns
    -------
    numpy.ndarray
        (blocks + 1, 3) [mm].
    """
    rows, count, row = [], 0, 0
    while count < blocks + 1:
        y = row * _STEP_MM
        curvature = np.abs(4 / 49 * np.sin(np.linspace(0, _ROW_MM, 4001) / 7) * np.cos(y / 9))
        chord = np.minimum(np.sqrt(8 * _CHORD_ERROR_MM / np.maximum(curvature, 1e-9)), 0.6)
        index = np.concatenate([[0], np.cumsum(_ROW_MM / 4000 / chord)])
        x = np.interp(np.arange(0, index[-1]), index[:4001], np.linspace(0, _ROW_MM, 4001))
        x = x if row % 2 == 0 else x[::-1]
        rows.append(np.stack([x, np.full_like(x, y), 4 * np.sin(x / 7) * np.cos(y / 9)], axis=1))
        count, row = count + len(x), row + 1
    return np.concatenate(rows)[: blocks + 1]


def polyline_limits(points, feed, a_max, period_s):
    """Return (vv_cap, h) of a polyline as Keinert et al. plan it: V1 by angle, V2 by length, VC.

    Parameters
    ----------
    points : numpy.ndarray
        (n + 1, 3) [mm].
    feed, a_max, period_s : float
        Programmed feed [mm/s], path acceleration [mm/s²], sampling time [s].

    Returns
    -------
    vv_cap : numpy.ndarray
        (n + 1,) smallest of V1² and VC² at every point, 0 at both ends [mm²/s²].
    h : numpy.ndarray
        (n,) 2 a·length of every block [mm²/s²].
    """
    along = np.diff(points, axis=0)
    length = np.linalg.norm(along, axis=1)
    unit = along / length[:, None]
    turn = np.linalg.norm(np.diff(unit, axis=0), axis=1)
    corner = a_max * period_s / np.maximum(turn, a_max * period_s / feed)
    return np.concatenate([[0], corner**2, [0]]), 2 * a_max * length


def reach_rows(blocks=20000, lookaheads=(0, 1, 2, 6, 10, 20, 50, 100, None)):
    """Return time and cost over N on a path of many short blocks: when is N enough?

    Returns
    -------
    list of dict
        kind, lookahead (None: the whole path), time_s, ns_per_block of planning.
    """
    vv_cap, h = polyline_limits(
        freeform(blocks), FREEFORM_FEED_MM_S, FREEFORM_A_MAX, FREEFORM_PERIOD_S
    )
    length, v_node, rows = h / (2 * FREEFORM_A_MAX), np.sqrt(vv_cap), []
    for kind in ("linear", "sshape"):
        for n in lookaheads:
            walls = []
            for _ in range(3):
                begun = time.perf_counter()
                profile = stages.slope(
                    length, FREEFORM_FEED_MM_S, FREEFORM_A_MAX, FREEFORM_J_MAX, v_node,
                    kind=kind, lookahead=n,
                )  # fmt: skip
                walls.append(time.perf_counter() - begun)
            rows.append({
                "kind": kind,
                "lookahead": n,
                "time_s": round(profile.time_s, 3),
                "ns_per_block": round(min(walls) / blocks * 1e9),
            })  # fmt: skip
    return rows
