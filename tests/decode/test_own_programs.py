# SPDX-License-Identifier: MIT
"""Room 1: the programs that LinuxCNC ships, move for move against its rs274.

    .venv/bin/python tests/decode/test_own_programs.py      all of them, as a table
"""

import collections
import functools
import hashlib
import multiprocessing
import re
import sys
import tempfile
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))

import pytest
import rs274_oracle

from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

FOLDERS = [Path("/usr/share/linuxcnc/ncfiles"), Path("/usr/share/doc/linuxcnc/examples")]
TOOLS = dict.fromkeys(range(1, 13), (0.0, 0.0))
ROUNDING = 2e-4  # of chains of steps in four decimals [mm]
_SPLINE = re.compile(rb"\s*(N\d+)?\s*G0*5(\.1)?\s*[XYIJ]", re.I)

# Where both differ on purpose, as docs/words.md and docs/lathe.md have it.
OTHERWISE = {
    "m106.ngc": "its endsub is another sub's",
    "g76.ngc": "G76 along the drive line, depths in whole nanometres",
    "gridprobe.ngc": "rs274 alone misses and goes on at G38.2",
    "lathe_g70_71_demo.ngc": "cuts of G70 and G71", "lathe_g7x_face_boring.ngc": "the same",
    "lathe_g7x_quadrants.ngc": "the same", "smartprobe.ngc": "a G38.2 that misses",
}  # fmt: skip


@functools.cache
def programs():
    """Return the programs, each content once, by their path below its folder."""
    found, seen = {}, set()
    for folder in FOLDERS:
        for path in sorted(folder.rglob("*.ngc")):
            content = hashlib.sha256(path.read_bytes()).digest()
            if content not in seen:
                seen.add(content)
                found[str(path.relative_to(folder))] = path
    return found


@functools.cache
def machine():
    """Return a machine with all axes, no end of travel, and the tools of rs274's table."""
    lines = ["[path]", "arc_radius_mm = 0.005", "[dialect]", 'probe = "misses"', "[kinematics]",
             'type = "identity"']  # fmt: skip
    for axis in "xyzabcuvw":
        unit = "deg" if axis in "abc" else "mm"
        limits = zip(("v_max", "a_max", "j_max"), ("s", "s2", "s3"), (100, 1e3, 1e4), strict=True)
        lines += [f"[axis.{axis}]", *(f"{name}_{unit}_{s} = {n}" for name, s, n in limits)]
    for number in TOOLS:
        lines += [f"[tool.{number}]", "length_mm = 0", "radius_mm = 0"]
    return Machine.from_text("\n".join(lines))


def judge(name, folder):
    """Return "equal", "refused" (by both), or what differs."""
    path = programs()[name]
    theirs, complaint = rs274_oracle.run(path, folder, TOOLS)
    if "no percent sign or program end" in complaint:
        complaint = ""  # a subprogram, all of which was read
    blocks, found = stages.decode(path.read_bytes(), machine())
    errors = [(status_id(int(e["code"])), int(e["line"])) for e in found if e["code"] < 0]
    if errors or complaint:
        both = bool(errors) and bool(complaint)
        return "refused" if both else f"ours: {errors[:2]}, theirs: {complaint}"
    for move in theirs:
        move.tolerance += ROUNDING
    ours = rs274_oracle.from_blocks(blocks, lib.NCK_COUNTS_PER_DEG)
    words = rs274_oracle.difference(ours, theirs)[1]
    if words:
        words = rs274_oracle.difference(ours, rs274_oracle.drill_upright(theirs))[1]
    if words:
        ours = _without_splines(ours, path.read_bytes())
        words = rs274_oracle.difference(ours, theirs)[1]
    return words or "equal"


def _without_splines(moves, text):
    """Return moves but for those of G5 and G5.1, of which rs274 tells nothing."""
    rows = text.split(b"\n")
    return [move for move in moves if not _SPLINE.match(rows[move.line - 1])]


def is_otherwise(name, words):
    """Say whether a difference is one that the pages tell; UVW are no axes of rs274's."""
    return Path(name).name in OTHERWISE or re.search(r"Bad character '[uvw]'", words) is not None


@pytest.mark.sample(12)
@pytest.mark.parametrize("name", programs())
def test_a_program_of_linuxcnc_does_what_rs274_does(name, tool, tmp_path):
    tool("rs274")
    words = judge(name, tmp_path)
    assert words in ("equal", "refused") or is_otherwise(name, words), words


def _one(name):
    with tempfile.TemporaryDirectory() as folder:
        return name, judge(name, Path(folder))


if __name__ == "__main__":
    counts = collections.Counter()
    with multiprocessing.Pool(2) as pool:
        for name, words in pool.imap(_one, programs(), chunksize=4):
            told = words in ("equal", "refused")
            kind = words if told else "on purpose" if is_otherwise(name, words) else "differs"
            counts[kind] += 1
            if not told:
                print(f"{kind} {name}: {words[:200]}")
    print(dict(counts), "of", sum(counts.values()))
    sys.exit(3 if counts["differs"] else 0)
