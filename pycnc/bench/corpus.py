# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench corpus`: what a jerk limit costs on real programs.

Every file of the corpus that runs: jerk_s, its machining time under the jerk-limited slope within
0.01 mm, over linear_s, that under the linear slope on the exact path; the last row has the sums.
What a file itself says of its path (G61, G64 P) wins. --paths: the folder of the corpus. These
numbers are the same on every computer.
"""

from pathlib import Path

from pycnc.machine import Machine
from pycnc.planning.plan import Plan
from pycnc.program import load

FOLDER = Path(__file__).resolve().parents[3] / "shared" / "corpus"
TURNTABLE = ("axis.a.min_deg=free", "axis.a.max_deg=free", "axis.x.max_mm=1000")
BOAT = ("m.428.action=output", "m.429.action=output")
PAWN = ("dialect.base=linuxcnc", "dialect.diameter=false")
# What the file leaves to its machine: G-code system, what F means, a gear, a fifth tool.
FANUC0T = (
    "dialect.system=A", "dialect.feed=per_rev", "m.41.action=output", "tool.5.radius_mm=0.2",
)  # fmt: skip

# The files that run and no spindle leads: name, machine, what is set.
RUNNING = (
    ("arcs_rword.gcode", "mill3", ()),
    ("ax4_rotation_51k.nc", "mill5_xyzac", TURNTABLE),
    ("ax4_spiral_flutes.nc", "mill5_xyzac", TURNTABLE),
    ("ax5_boat_xyzac_g93.ngc", "mill5_xyzac", BOAT),
    ("laser_tball_engrave.gcode", "mill3", ()),
    ("lathe_fanuc0t_css.nc", "cak6150n", FANUC0T),
    ("lathe_g71_g70_pawn.ngc", "cak6150n", PAWN),
    ("mill_camotics_locket.ngc", "mill3", ()),
    ("mill_cutcomp_semicolon.ngc", "mill3", ()),
    ("mill_fanuc_3dparallel_g19.nc", "mill3", ()),
    ("mill_fanuc_g17_18_19.nc", "mill3", ()),
    ("mill_fanuc_g81_g91.nc", "mill3", ("dialect.base=fanuc",)),
    ("mill_fanuc_m98_vars.ngc", "mill3", ()),
    ("mill_fusion_grbl_helix.nc", "mill3", ("dialect.feed_default_mm_min=1000",)),
    ("mill_nist_circle_diamond_square.ngc", "mill3", ()),
    ("nurbs_g5_butterfly.ngc", "mill3", ()),
    ("odd_no_spaces.gcode", "mill3", ()),
    ("print_cura_bp_case_56k.gcode", "printer", ()),
    ("surf_la_peinture_180k.gc", "mill3", ()),
    ("surf_webgcode_46k.ngc", "mill3", ()),
    ("tp_random_lines_0.001in.ngc", "mill3", ()),
    ("tp_trochoidal.ngc", "mill3", ()),
    ("tp_zigzag.ngc", "mill3", ()),
)


def bench_corpus_rows(paths=None, *, files=RUNNING):
    """Return rows {file, jerk_s, linear_s, ratio}, the sums last.

    Parameters
    ----------
    paths : path, optional
        The folder of the corpus.
    files : iterable of (str, str, tuple of str)
        As `RUNNING`.
    """
    folder = Path(paths) if paths is not None else FOLDER
    rows = [_row(folder / name, machine, changes) for name, machine, changes in files]
    timed = [row for row in rows if row["jerk_s"]]
    sums = {key: sum(row[key] for row in timed) for key in ("jerk_s", "linear_s")}
    ratio = sums["jerk_s"] / sums["linear_s"] if timed else None
    return [*rows, {"file": "sum", **sums, "ratio": ratio}]


def _row(file, machine, changes):
    if not file.exists():
        return {"file": f"{file.name}: not there", "jerk_s": None, "linear_s": None, "ratio": None}
    jerk_s = time_of(file, machine, (*changes, "path.slope=jerk", "path.tolerance_mm=0.01"))
    linear_s = time_of(file, machine, (*changes, "path.slope=linear", "path.tolerance_mm=0"))
    ratio = jerk_s / linear_s if linear_s else None
    return {"file": file.name, "jerk_s": jerk_s, "linear_s": linear_s, "ratio": ratio}


def time_of(file, machine, changes):
    """Return the machining time of a file on a changed machine [s]."""
    program = load(file, Machine.load(machine, set=changes))
    return Plan(program, keep=False).time_s
