# SPDX-License-Identifier: MIT
"""The page of a program on another control: its time, what it is felt as, and no jerk."""

import pytest
from browser import SOFTWARE_GL
from test_felt import DRAWN
from test_page import browse  # noqa: F401
from test_report import Unpacked

from pycnc import load
from pycnc.machine import Machine
from pycnc.planning.plan import plan
from pycnc.report import page
from pycnc.report.plot import duration
from pycnc.report.trace import Trace

MACHINES = {"router": "M3 S8000\n", "printer_klipper": "M83\n", "printer_marlin": "M83\n"}
MOVES = "G21\nG90\n{}G1 F3000 X40\nG1 Y40\nG2 X60 Y60 I20 J0\nG4 P0.2\nG0 Z5\nG1 X0 Y0\n"


def program_for(name):
    """Return a program of lines, an arc, a rest and a rapid."""
    return load(MOVES.format(MACHINES[name]).encode(), Machine.load(name))


@pytest.mark.parametrize("name", MACHINES)
def test_what_is_drawn_is_what_a_run_tells(name):
    program = program_for(name)
    made = Unpacked(page.make(program)[0])
    assert made.facts["time_s"] == plan(program).time_s
    assert made.column("t")[-1] == pytest.approx(made.facts["time_s"], abs=2e-6)
    assert made.facts["j_max"] is None and made.facts["felt"]["kinds"] == ["a"]
    assert not [column for column in made.facts["columns"] if "_j" in column]
    peaks = Trace(program, keep=False).summary["peaks"]
    tracks = {track["name"]: track["a"] for track in made.facts["felt"]["tracks"]}
    assert set(tracks) <= {track for track, peak in peaks.items() if "a" in peak} and tracks
    for track in tracks:
        least = made.column(f"felt_{track}_a")
        largest = least + made.column(f"felt_{track}_a_span")
        drawn = max(-least.min(), largest.max())
        assert drawn == pytest.approx(peaks[track]["a"], abs=DRAWN), track


@pytest.mark.parametrize("name", ["router", "printer_klipper"])
def test_it_opens_in_a_browser(browse, tmp_path, name):  # noqa: F811
    program, file = program_for(name), tmp_path / "page.html"
    page.write(program, file)
    with browse(file, *SOFTWARE_GL) as visit:
        assert visit.text("#total") == duration(plan(program).totals["total_s"])
        assert visit.ask("report.curves.plots.length") == 2, "speed and acceleration, no jerk"
        assert visit.complaints == []
