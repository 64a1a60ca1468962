# SPDX-License-Identifier: MIT
"""Times of other controls' own planners, measured, against the machine files that are imported of
their settings."""

import csv
import statistics
from pathlib import Path

import pytest

from pycnc.machine import Machine, importer
from pycnc.planning.plan import plan
from pycnc.program import Program

SHARED = Path(__file__).resolve().parents[3] / "shared"
TIMES, CONTROLS = SHARED / "reference" / "control_times.tsv", SHARED / "reference" / "controls"
# Nobody says where the work lies, and grbl clips what is above $30.
_FREE = {f"axis.{letter}.{end}_mm": "free" for letter in "xyz" for end in ("min", "max")}
_MORE = {
    "grblHAL": {"control.kind": "grblhal"},
    "grbl (36 blocks)": {"control.planner_blocks": 36},
    "grbl (128 blocks)": {"control.planner_blocks": 128},
}
_STARTUP = {  # the start-up code was the first line
    "linuxcnc_g61.ini": "G61", "linuxcnc_g64.ini": "G64",
    "linuxcnc_p001.ini": "G64 P0.01", "linuxcnc_p01.ini": "G64 P0.1",
}  # fmt: skip

needs_times = pytest.mark.skipif(not TIMES.is_file(), reason="../shared has no control_times.tsv")


def _machine(row):
    file = CONTROLS / "settings" / row["settings"]
    draft = importer.read(file.read_text(), file.name, file.parent)
    assert not draft.problems
    changes = _FREE | _MORE.get(row["control"], {})
    if row["control"].startswith("grbl"):
        changes |= {"spindle.rpm_max": 0, "path.arc_radius_mm": 0.05}
    changes |= {f"start.{letter}_mm": 0 for letter in "xyz"}
    return Machine.load(Machine.from_text(draft.text()), set=changes)


def _text(row):
    file = CONTROLS / "programs" / row["program"]
    text = (file if file.is_file() else SHARED / "corpus" / row["program"]).read_bytes()
    # As they were measured: these controls have no G94.
    prints = row["control"].startswith(("Klipper", "Marlin"))
    if row["control"] == "LinuxCNC" and row["settings"] in _STARTUP:
        return f"{_STARTUP[row['settings']]}\n".encode() + text
    return text.replace(b"G94\n", b"\n") if prints else text


def _misses(control, settings=None):
    """Return (how far from the measured time [%], settings, program) of a control's rows."""
    with TIMES.open(encoding="utf-8") as lines:
        rows = [row for row in csv.DictReader(lines, delimiter="\t") if row["control"] == control]
    rows = [row for row in rows if settings is None or row["settings"] in settings]
    found = []
    for row in rows:
        program = Program(_text(row), _machine(row), file=row["program"], keep=False)
        ratio = plan(program).time_s / float(row["time_s"])
        found.append((100 * abs(ratio - 1), row["settings"], row["program"]))
    return found


@needs_times
@pytest.mark.parametrize("control, count, most", [
    ("Klipper", 74, 0.5), ("grbl", 43, 1), ("grblHAL", 42, 1), ("grbl (36 blocks)", 8, 1),
    ("grbl (128 blocks)", 8, 1),
])  # fmt: skip
def test_every_row_is_met(control, count, most):
    found = _misses(control)
    assert len(found) == count
    assert max(found)[0] <= most, max(found)


@needs_times
def test_marlin_is_met_in_the_median():
    found = _misses("Marlin") + _misses("Marlin (S-curve)")
    assert len(found) == 42 + 14
    assert statistics.median(miss for miss, *_ in found) <= 1
    assert max(found)[0] <= 10, max(found)


@needs_times
@pytest.mark.parametrize("settings, count", [
    (("linuxcnc_p001.ini", "linuxcnc_p01.ini"), 14), (("linuxcnc_g61.ini",), 7),
    (("linuxcnc_mill3.ini",), 4), (("linuxcnc_g64.ini",), 7),
])  # fmt: skip
def test_linuxcnc_is_met_in_the_median(settings, count):
    found = _misses("LinuxCNC", settings)
    assert len(found) == count
    assert statistics.median(miss for miss, *_ in found) <= 2
    assert max(found)[0] <= 6, max(found)
