# SPDX-License-Identifier: MIT
"""Switches of a machine: homing and probing repeat to one step, and every fault is told."""

import pytest
import switching_runs
from serving_runs import Talk, mill


@pytest.mark.sample(5, quick=2)
@pytest.mark.parametrize("seed", range(1, 201))
def test_homing_repeats_to_a_step(seed):
    switching_runs.homes(seed)


@pytest.mark.sample(5, quick=2)
@pytest.mark.parametrize("seed", range(1, 201))
def test_a_probe_tells_where_it_touches_to_a_step(seed):
    switching_runs.probes(seed)


@pytest.mark.sample(8, quick=3)
@pytest.mark.parametrize("seed", range(1, 301))
def test_limits_doors_and_broken_wires_are_told(seed):
    switching_runs.limits(seed)


@pytest.mark.sample(6, quick=2)
@pytest.mark.parametrize("seed", range(1, 201))
def test_the_path_waits_for_the_spindle_and_m66_is_answered(seed):
    switching_runs.waits(seed)


def test_settings_of_homing_are_listed_and_set():
    talk = Talk(mill())
    talk.session.connect({"homes": 0})
    talk.said.clear()
    assert talk.ask("$H") == ["error:5"]
    for line in ("$22=1", "$23=3", "$24=30.5", "$25=800", "$26=12", "$27=2.25", "$21=1"):
        assert talk.ask(line) == ["ok"]
    listed = talk.ask("$$")
    for line in ("$21=1", "$22=1", "$23=3", "$24=30.500", "$25=800.000", "$26=12", "$27=2.250"):
        assert line in listed
    assert talk.ask("$27=0") == ["error:3"] and "$27=2.250" in talk.ask("$$")


def test_a_machine_without_switches_refuses_what_needs_them():
    talk = Talk(mill())
    talk.said.clear()
    assert talk.ask("$H") == ["error:5"]
    assert talk.ask("G38.2 Z-5 F100") == ["error:20"]
    assert "$22=0" in talk.ask("$$")


def test_overrides_and_modes_are_as_before_behind_homing():
    talk = Talk(mill())
    talk.session.connect({"homes": 1, "seek": 3000.0}, wired=7, place_nm=[9_000_000] * 3)
    talk.ask("$X")
    talk.send(b"\x91")
    modes = talk.ask("G20G91F7") and talk.ask("$G")
    talk.send(b"$H\n")
    assert switching_runs.lines_of(talk) == ["ok"]
    assert talk.ask("$G") == modes
    assert talk.ask("G21G90G1X0F600") == ["ok"]
    talk.settle()
    assert talk.session.joints_nm[0] == 0
