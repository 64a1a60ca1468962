# SPDX-License-Identifier: MIT
"""The programs beside the checkout, corpus and trials: each is read as it is or with its owner's
words, which machine, language, travel and tools it is for, or it is refused for a reason."""

import cases
import pytest

import pycnc
from pycnc.machine import Machine

SHARED = cases.CORPUS.parent
FOLDERS = ("corpus", "programs", "trials/faults", "reference/controls/programs")
SUFFIXES = {".nc", ".ngc", ".gcode", ".gc"}
_FREE = tuple(f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max"))
# What those need that the corpus' table (cases.py) does not have.
WORDS = {
    "klipper_zigzag.gcode": ("printer_klipper", ()),
    "prusaslicer_start.gcode": ("printer_klipper", ()),
    "part.gcode": ("printer_klipper", ()),
    "limits_klipper.gcode": ("printer_klipper", ("axis.x.max_mm=400",)),
    "limits_m204.gcode": ("printer_marlin", ("axis.x.max_mm=400",)),
    "zig8.nc": ("mill3", _FREE),
    "F3_nose_orientation.nc": ("lathe_fanuc", ()),
    "fanuc_lookahead_words.nc": ("mill3", ("dialect.base=fanuc",)),
    "fluidnc_m62.nc": ("mill3", ("dialect.base=grbl",)),
    "lathe_g76_thread_part.ngc": (
        "cak6150n", ("dialect.base=linuxcnc", "dialect.diameter=false", "tool.9.radius_mm=0.2")),
    "mill_haas_threadmill.nc": (
        "mill3", ("dialect.base=fanuc", *_FREE, "m.88.action=output", "m.89.action=output",
                  "tool.4.radius_mm=2", "tool.14.radius_mm=5", "tool.24.radius_mm=5",
                  "dialect.d_offset=radius")),
}  # fmt: skip
# Its first error: a language of another kind, lines that are broken, LinuxCNC's own refusal, and
# tool centre point, which is not built.
REFUSED = {
    "unsupported_sinumerik840d.nc": "dialect", "bad_longmill_invalid.nc": "word-unknown",
    "F7_nested_comment.ngc": "comment", "mill5_fanuc_g43_4_tcp.nc": "unsupported",
}  # fmt: skip


def _files():
    return sorted(each for folder in FOLDERS for each in (SHARED / folder).glob("*")
                  if each.suffix in SUFFIXES)  # fmt: skip


def _table():
    """Return {file: (machine, what is set)} of the corpus' table: what runs, else the first row."""
    rows = {}
    for row in cases.CORPUS_FILES:
        if row.file not in rows or row.ends is None:
            rows[row.file] = row.machine, row.set
    return rows | WORDS


def test_nothing_is_there_that_nobody_looks_at():
    if not cases.CORPUS.exists():
        pytest.skip(f"{cases.CORPUS} is not here")
    files = _files()
    assert len(files) == 62
    assert {*WORDS, *REFUSED} <= {file.name for file in files}
    assert (len(files) - len(REFUSED)) / len(files) >= 52 / 57


@pytest.mark.parametrize("file", _files(), ids=lambda file: file.name)
def test_a_program_is_read_or_refused_for_its_reason(file):
    machine, change = _table().get(file.name, ("mill3", ()))
    program = pycnc.load(file, Machine.load(machine, set=change))
    errors = [each for each in program.diagnostics if each.severity == "error"]
    assert (errors[0].id if errors else None) == REFUSED.get(file.name), errors
    assert file.name in REFUSED or program.block_count > 0
