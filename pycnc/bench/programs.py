# SPDX-License-Identifier: MIT
"""Programs that benches run, and the machine of the comparison with LinuxCNC."""

import math

import numpy as np

from pycnc.bench import butterfly as curve
from pycnc.machine import Machine

MACHINE = """\
description = "the same limits on every axis, travel free"

[kernel]
period_ms = 1

[path]
tolerance_mm = 0
slope = "{slope}"
"""
AXIS = """
[axis.{axis}]
v_max_mm_s = 100
a_max_mm_s2 = {a}
j_max_mm_s3 = {j}
"""


def machine(slope="optimal", a=1000, j=10_000):
    """Return the machine of the comparison: three axes of 100 mm/s, a period of 1 ms.

    Parameters
    ----------
    slope : {"optimal", "jerk", "linear"}
    a, j : int
        Acceleration [mm/s²] and jerk [mm/s³] of every axis.

    Examples
    --------
    >>> machine("linear").axes
    'xyz'
    """
    text = MACHINE.format(slope=slope) + "".join(AXIS.format(axis=axis, a=a, j=j) for axis in "xyz")
    return Machine.from_text(text, name="comparison")


def head(mode):
    """Return the first line of a program: mm, plane XY, absolute, and how the path is followed."""
    return f"G21 G17 G90 G94 {mode}\n"


def micro(mode, count=12_566):
    """Return chords of 0.055 mm around a waved ring, four decimals.

    Parameters
    ----------
    mode : str
        ``"G61"``, ``"G64 P0.01"``, …
    count : int
        Chords; 6283 are once around.
    """
    lines = [f"{head(mode)}G0 X50 Y0 Z0\nG1 F6000"]
    for k in range(1, count + 1):
        t = k * 0.001
        r = 50 + 3 * math.sin(9 * t)
        x, y, z = r * math.cos(t), r * math.sin(t), 2 * math.sin(5 * t)
        lines.append(f"G1 X{x:.4f} Y{y:.4f} Z{z:.4f}")
    return "\n".join([*lines, "M2", ""]).encode()


def zigzag(mode, count=400, step=1.0):
    """Return a staircase of right angles; X turns back after every 100 stairs.

    Parameters
    ----------
    mode : str
        As for `micro`.
    count : int
        Edges.
    step : float
        Length of an edge [mm].
    """
    lines, x, y = [f"{head(mode)}G0 X0 Y0 Z0\nG1 F6000"], 0.0, 0.0
    for k in range(count):
        if k % 2:
            y += step
        else:
            x += step if k // 200 % 2 == 0 else -step
        lines.append(f"G1 X{x:.4f} Y{y:.4f}")
    return "\n".join([*lines, "M2", ""]).encode()


def butterfly(mode, chord_error_mm, feed=6000):
    """Return the butterfly in chords, six decimals.

    Parameters
    ----------
    mode : str
        As for `micro`.
    chord_error_mm : float
        How far a chord may leave the curve [mm].
    feed : float
        [mm/min].
    """
    points = curve.polygon(chord_error_mm)
    lines = [f"{head(mode)}G0 X{points[0, 0]:.6f} Y{points[0, 1]:.6f}\nG1 F{feed}"]
    lines += [f"X{x:.6f} Y{y:.6f}" for x, y in np.round(points[1:], 6).tolist()]
    return "\n".join([*lines, "M2", ""]).encode()
