# SPDX-License-Identifier: MIT
"""``run``, ``plot``, ``report`` and ``compare`` of machines with another control's planner."""

import json

import numpy as np
import pytest
from command_line import pycnc

from pycnc.report.trace import Trace

MOVES = "G21\nG90\nG1 F3000 X40\nG1 Y40\nG4 P0.2\nG1 X0 Y0\n"
MACHINES = ("router", "laser", "printer_klipper", "printer_marlin")


@pytest.fixture(scope="module")
def part(tmp_path_factory):
    file = tmp_path_factory.mktemp("controls") / "part.ngc"
    file.write_text(MOVES)
    return file


@pytest.mark.parametrize("machine", MACHINES)
def test_every_verb_tells_the_same_time(part, tmp_path, machine):
    picture, rows = tmp_path / "part.png", tmp_path / "part.npz"
    told = json.loads(pycnc("time", part, "-m", machine, "--json").out)
    html = tmp_path / "part.html"
    for verb, *more in (("run", "-o", rows, "--plot", picture), ("report", "-o", html),
                        ("plot", "-o", picture), ("why",)):  # fmt: skip
        found = pycnc(verb, part, "-m", machine, *more, "--json")
        assert found.code == 0, found.err
        facts = json.loads(found.out)
        assert (facts["time_s"], facts["total_s"]) == (told["time_s"], told["total_s"]), verb
        assert facts["control"] == told["control"] != "nck"
    assert picture.stat().st_size > 10_000
    trace = Trace.load(rows)
    assert trace.metadata()["control"] == told["control"]
    assert trace["t_s"][-1] == pytest.approx(told["time_s"], abs=trace.metadata()["period_s"])
    assert {3, 4, 6} <= set(np.unique(trace["line"]).tolist()) <= {3, 4, 5, 6}
    assert "slope" not in pycnc("run", part, "-m", machine).out.splitlines()[0]


@pytest.mark.parametrize("machine", MACHINES)
def test_by_line_and_left_add_up(part, machine):
    told = json.loads(pycnc("time", part, "-m", machine, "--by", "line", "--json").out)
    assert sum(row["time_s"] for row in told["parts"]) == pytest.approx(told["total_s"], rel=1e-9)
    left = json.loads(pycnc("time", part, "-m", machine, "--left", 5, "--json").out)["left_s"]
    after = sum(row["time_s"] for row in told["parts"] if row["line"] >= 5)
    assert left == pytest.approx(after, rel=1e-9)


@pytest.mark.parametrize("machine", MACHINES)
def test_a_comparison_with_our_own_machine(part, machine):
    found = pycnc("compare", part, part, "-m", machine, "--machine-b", "mill3", "--json")
    assert found.code == 0, found.err
    told = json.loads(found.out)
    theirs = json.loads(pycnc("time", part, "-m", machine, "--json").out)["time_s"]
    ours = json.loads(pycnc("time", part, "-m", "mill3", "--json").out)["time_s"]
    assert told["time_difference_s"] == pytest.approx(ours - theirs, abs=0.003)
    # Nobody knows where a router's work lies: both are told from the program's zero.
    assert told["distance_mm"] < 0.1
    assert {row["line"] for row in told["lines"]} >= {3, 4, 6}


def test_what_is_this_kernel_s_alone_is_refused(part):
    found = pycnc("lab", "run", part, "-m", "router", "--prep-steps", 1)
    assert found.code == 2 and "--set control.kind=nck" in found.err
    assert len(found.err.splitlines()) == 1
