# SPDX-License-Identifier: MIT
"""The curve within P from Python, in double or single floats, for tests and measurements."""

import ctypes
import subprocess
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
ROOM = ROOT / "csrc" / "nck" / "prep" / "3_smooth"
BASE = ROOT / "csrc" / "nck" / "base"
PARTS = ("fair", "track", "timing", "timing_make", "best", "reference", "sample", "stream")
SOURCES = (
    Path(__file__).with_suffix(".c"),
    *(ROOM / f"{name}.c" for name in PARTS),
    *sorted(BASE.glob("motion*.c")), BASE / "path.c", BASE / "trig.c",
)  # fmt: skip


class Run(ctypes.Structure):
    """What is asked, and what has come of it: curve_run_t of curve_door.c."""

    _fields_ = [
        *((name, ctypes.c_int) for name in ("points", "axes", "rounds", "room")),
        *((name, ctypes.c_double)
          for name in ("tau", "longest", "tolerance", "feed", "v", "a", "j")),
        ("pieces", ctypes.c_int), ("told", ctypes.c_double * 8),
    ]  # fmt: skip


def build(compiler, folder, number="double"):
    """Compile the curve as the kernel is compiled; return the library."""
    library = Path(folder) / f"curve_{number}.so"
    options = ["-std=c99", "-O2", "-ffp-contract=off", "-fno-math-errno", "-fPIC", "-shared"]
    # The window of a build without the slope: a short one tells chords apart by a knot in twenty.
    sizes = [f"-DNCK_NUM={number}", "-DNCK_CLOCKED=0"]
    command = [compiler, *options, *sizes, f"-I{ROOT / 'csrc'}", *SOURCES]
    subprocess.run([*command, "-lm", "-o", library], check=True)
    return ctypes.CDLL(str(library))


def smooth(library, points, tolerance, **asked):
    """Smooth a polygon; return control points, s at knots [mm] and the run."""
    points = np.ascontiguousarray(points, float)
    given = {"tau": 0.004, "longest": 6.0, "feed": 100.0, "v": 100.0, "a": 1e3, "j": 1e4}
    given |= {"rounds": 4} | asked
    run = Run(points=len(points), axes=points.shape[1], room=100000, tolerance=tolerance, **given)
    control = np.zeros((run.room + 3, run.axes))
    s = np.zeros(run.room + 1)
    pointers = [array.ctypes.data_as(ctypes.c_void_p) for array in (points, control, s)]
    status = library.curve_run(ctypes.byref(run), *pointers)
    assert status == 3, status  # NCK_DONE
    return control[: run.pieces + 3], s[: run.pieces + 1], run
