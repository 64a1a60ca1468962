# SPDX-License-Identifier: MIT
"""Controllers come to rest in time, preparation and all: on the host and on a Cortex-M7, by a hold,
an abort, an overrun and before a soft limit; and an override never starves the path."""

import re

import firmware_runs
import pytest

from pycnc import controller
from pycnc.bench import programs, stops
from pycnc.bench import stops_controllers as bench

TOLD = r"(?:at rest|[\d.]+(?: \w+)?)"


def told(board, slope, name, events, tool):
    firmware_runs.opened(board, tool)
    return bench.row(board, slope, name, events)


@pytest.mark.sample(2)
@pytest.mark.parametrize("board", ["host", "m7"])
@pytest.mark.parametrize("slope", stops.SLOPES)
def test_a_line_is_left_in_time(board, slope, tool):
    events = ("hold", "abort", "overrun")
    found = told(board, slope, "a line of 1 m", events, tool)
    for event in events:  # a number alone: it ended in the state of the event
        assert int(found[event]) <= found["least_ms"] + (25 if board == "host" else 45)


@pytest.mark.sample(quick=4)
@pytest.mark.parametrize("slope", stops.SLOPES)
@pytest.mark.parametrize("name", stops.PROGRAMS)
def test_a_soft_limit_is_kept_without_a_jump(slope, name, tool):
    found = told("host", slope, name, ("travel",), tool)
    assert re.fullmatch(r"\d+\.\d\d", found["travel"])


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("name", ["a line of 1 m", "micro-segments, exact"])
def test_a_soft_limit_is_kept_on_a_cortex_m7(name, tool):
    found = told("m7", "jerk", name, ("travel",), tool)
    assert re.fullmatch(r"\d+\.\d\d", found["travel"])


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("percent, tick", [(50, 1000), (80, 400), (120, 1700)])
def test_an_override_on_micro_segments_never_starves_a_cortex_m7(percent, tick, tool):
    machine = programs.machine("jerk", stops.A, stops.J)
    commands = [(tick, "override", percent, 100), (tick + 700, "override", 100, 100)]
    outcome = firmware_runs.opened("m7", tool).run(
        stops.PROGRAMS["micro-segments, P0.01"](), machine, commands, max_ticks=3000
    )
    assert outcome.starved_ticks == 0


def test_the_page_has_a_row_for_every_slope_and_program(root):
    page = (root / "docs" / "controller.md").read_text(encoding="utf-8")
    cell = rf" +{TOLD} / {TOLD} / {TOLD} / {TOLD} \|"
    rows = re.findall(rf"^\| `(\w+)`, (.+?) \|(?:{cell}){{3}}$", page, re.M)
    assert rows == [(slope, name) for slope in stops.SLOPES for name in stops.EXACT]
    assert controller.CONTROLLERS == ("host", "m4f", "m7")
