# SPDX-License-Identifier: MIT
"""More rows of `pycnc lab bench linuxcnc --live`: programs that LinuxCNC ships, tolerances, jerks,
kinematics.

stock_s: with LinuxCNC's own planner, which keeps no jerk; nck_s: with this one and a jerk of j for
each axis. Peaks are its shares of an axis' limits; stock_j_peak is what LinuxCNC's planner takes of
the jerk that this one keeps. Of kinematics, of axes and not of joints. An hour and a half on an
idle computer; nck_tp has to be installed.
"""

import tempfile
from pathlib import Path

import numpy as np

from pycnc.bench import programs
from pycnc.linuxcnc import live

OURS = "nck_tp"
EXAMPLES = Path("/usr/share/linuxcnc/ncfiles")
SAMPLES = Path("/usr/share/doc/linuxcnc/examples/sample-configs/sim/axis")
LONG_S = 400.0
JERKS = (5000, 10_000, 20_000, 50_000, 100_000)
FEW_JERKS = (10_000, 50_000)
TOLERANCES = (0.01, 0.05, 0.1)
SHIPPED = (  # (program, axes, jerks)
    ("comp.ngc", "XYZ", JERKS), ("3dtest.ngc", "XYZ", JERKS), ("polar.ngc", "XYZ", FEW_JERKS),
    ("hole-circle.ngc", "XYZ", FEW_JERKS), ("systems.ngc", "XYZ", FEW_JERKS),
    ("daisy.ngc", "XYZABC", FEW_JERKS), ("comp-g1.ngc", "XYZ", FEW_JERKS),
    ("b-index.ngc", "XYZABC", FEW_JERKS), ("toplevel.ngc", "XYZ", FEW_JERKS),
    ("lathe_g7x_face_boring.ngc", "XZ", FEW_JERKS),
    ("lathe_g7x_quadrants.ngc", "XZ", FEW_JERKS),
    ("lathecomp.ngc", "XZ", FEW_JERKS),
)  # fmt: skip
SHAPES = (
    ("micro-segments", programs.micro), ("zigzag 1 mm", programs.zigzag),
    ("zigzag 10 mm", lambda mode: programs.zigzag(mode, 100, 10.0)),
)  # fmt: skip
# Moves about the place where the joints begin, so far along the axes that there are.
AROUND = """G21 G91 G17 G64 P0.05
G1 F{feed} X{w} Y{w}
X{w} Y-{w}
G2 X-{w} Y-{w} R{w}
G3 X-{w} Y{w} R{w}
G1 Z{h}
{turns}
X{w}
Y-{w} Z-{h}
X-{w} Y{w}
M2
"""
KINDS = (  # (name, kinematics, axes, limits, way, height, moves that turn)
    ("5axis", live.Kinematics("5axiskins", angular="34"), "XYZBCW", live.Limits(60, 200, 4000), 20,
     5, "X10 B10 C20\nY5 B-20\nX-10 Y-5 B10 C-20"),
    ("xyzac", live.Kinematics("xyzac-trt-kins", angular="34"), "XYZAC", live.Limits(20, 300, 3000),
     20, 5, "X10 A10 C20\nY5 A-20\nX-10 Y-5 A10 C-20"),
    ("delta", live.Kinematics("lineardeltakins", (270, 270, 270)), "XYZ",
     live.Limits(100, 1000, 10_000), 20, 5, "X5"),
    ("hexapod", live.Kinematics("genhexkins", (29.7466,) * 6,
                                hal=f"source {SAMPLES}/vismach/hexapod-sim/kinematics.hal\n"),
     "XYZABC", live.Limits(20, 200, 2000), 1, 0.5, "A1 B1\nA-1 C2\nB-1 C-2"),
    ("scara", live.Kinematics("scarakins", (-40, 80, 100, 0, 0, 0), angular="01345"), "XYZABC",
     live.Limits(30, 200, 2000), 20, 5, "X5 C10\nC-10"),
)  # fmt: skip


def _run(text, planner, axes, limits, kinematics=live.TRIVIAL):
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)
        return live.run(folder, text, planner=planner, axes=axes, limits=limits,
                        kinematics=kinematics, limit_s=LONG_S)  # fmt: skip


def _row(name, mode, limits, own, ours):
    v, a, j = ours.peaks(limits)
    return {
        "program": name, "mode": mode, "j": limits.j, "stock_s": own.time_s, "nck_s": ours.time_s,
        "nck/stock": ours.time_s / own.time_s, "v_peak": v, "a_peak": a, "j_peak": j,
        "stock_j_peak": own.peaks(limits)[2],
        "ends_apart_mm": float(np.abs(own.places[-1] - ours.places[-1]).max()),
    }  # fmt: skip


def _rows(name, mode, text, axes, jerks):
    """Yield a row of each jerk; LinuxCNC's own planner knows none."""
    own = _run(text, "", axes, live.Limits())
    for j in jerks:
        limits = live.Limits(j=j)
        yield _row(name, mode, limits, own, _run(text, OURS, axes, limits))


def each_shipped_row(shipped=SHIPPED):
    """Yield rows of programs that LinuxCNC ships, each as soon as it is there."""
    for name, axes, jerks in shipped:
        text = (EXAMPLES / name).read_text(encoding="utf-8", errors="replace")
        yield from _rows(name, "its own", text, axes, jerks)


def each_tolerance_row(shapes=SHAPES, tolerances=TOLERANCES, jerks=JERKS):
    """Yield rows of three shapes within three tolerances, with five jerks."""
    for name, make in shapes:
        for tolerance in tolerances:
            mode = f"G64 P{tolerance}"
            yield from _rows(name, mode, make(mode).decode(), "XYZ", jerks)


def each_kinematics_row(kinds=KINDS):
    """Yield a row of each kind of kinematics: moves about where its joints begin."""
    for name, kinematics, axes, limits, way, height, turns in kinds:
        text = AROUND.format(feed=60 * limits.v, w=way, h=height, turns=turns)
        runs = (_run(text, planner, axes, limits, kinematics) for planner in ("", OURS))
        yield _row(name, "G64 P0.05", limits, *runs)


def bench_wide_rows():
    """Return rows {program, mode, j, stock_s, nck_s, nck/stock, v_peak, a_peak, j_peak,
    stock_j_peak, ends_apart_mm}."""
    return [*each_shipped_row(), *each_tolerance_row(), *each_kinematics_row()]
