# SPDX-License-Identifier: MIT
"""The kernel as the planner of the LinuxCNC that is installed here: a smoke run, no screen."""

import os

import numpy as np
import pytest

from pycnc import linuxcnc
from pycnc.linuxcnc import live

PROGRAM = """G21 G90 G64 P0.01
G1 F6000 X10 Y0
X20 Y10
M62 P0
G2 X40 Y10 I10 J0
G3 X40 Y10 I-5 J0 Z-2
M63 P0
G0 X0 Y0 Z0
M2
"""


@pytest.fixture(scope="module")
def planner(tmp_path_factory):
    if reason := live.absent():
        pytest.skip(reason)
    if not linuxcnc.PARTS.is_file():
        pytest.skip("linuxcnc-uspace-dev is not installed")
    place = linuxcnc.MODULES / linuxcnc.MODULE
    if not os.access(linuxcnc.MODULES, os.W_OK):
        pytest.skip(f"{linuxcnc.MODULES} may not be written: LinuxCNC loads modules from there")
    was_there = place.is_file()
    linuxcnc.install(linuxcnc.build(tmp_path_factory.mktemp("module")))
    yield "nck_tp"
    if not was_there:
        place.unlink()


@pytest.fixture
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("live")
    for each in (folder, *folder.parents[:2]):
        each.chmod(0o755)  # LinuxCNC runs as another user
    return folder


def test_a_program_runs_to_its_end_within_all_limits(planner, folder):
    log = live.run(folder, PROGRAM, planner=planner)
    assert max(log.peaks(live.Limits())) <= 1 + 1e-3  # the log counts nanometres
    assert log.places[-1] == pytest.approx([0, 0, 0], abs=1e-5)
    lines = [int(line) for line in dict.fromkeys(log.line) if line]
    assert lines == sorted(lines) and lines[-1] == 8
    on = log.places[np.flatnonzero(log.output)]
    assert on[0] == pytest.approx([20, 10, 0], abs=0.1)
    assert on[-1] == pytest.approx([40, 10, -2], abs=0.1)


def test_what_is_missing_in_the_ini_is_in_linuxcncs_log(planner, folder, monkeypatch):
    monkeypatch.setattr(live, "AXIS", live.AXIS.replace("MAX_JERK = {j}\n", ""))
    with pytest.raises(live.errors.StateError, match="MAX_JERK is missing"):
        live.run(folder, PROGRAM, planner=planner)


def test_an_unknown_parameter_does_not_load(planner, folder):
    with pytest.raises(live.errors.StateError, match="swing"):
        live.run(folder, PROGRAM, planner="nck_tp swing=1")
