# SPDX-License-Identifier: MIT
"""The kernel as the planner of the LinuxCNC that is installed here: a smoke run, no screen."""

import os
import re

import lathe_live
import numpy as np
import pytest
from linuxcnc_stand_in import built_module

from pycnc import errors, linuxcnc
from pycnc.bench import linuxcnc_live as bench
from pycnc.linuxcnc import live

pytestmark = pytest.mark.thorough  # each start of LinuxCNC takes 5 to 12 s

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

SIGNALS = """G21 G90 G61
G0 X1
M68 E0 Q0.25
G4 P0.6
M3 S600
G1 F600 X10
M67 E0 Q0.75
G1 X15
M66 P0 L3 Q20
M64 P0
G1 F3000 X30
M65 P0
G1 X40
M5
M2
"""
TURNED = """G21 G90 G18 G64 P0.01
M3 S200
G95 F1
G1 Z-3
S2000 F0.5
G1 Z-22
G94 S600
G0 Z-24
G33 Z-40 K1
G33 Z-56 K2
G0 X1
M5
M2
"""
AT_SPEED, INPUT = "spindle.0.at-speed", "motion.digital-in-00"
OPERATOR = [(0, "set", AT_SPEED, "0"), (1.6, "set", AT_SPEED, "1"), (0.4, "show", "nck-tp"),
            (1.6, "set", INPUT, "1")]  # fmt: skip


@pytest.fixture(scope="module")
def planner():
    if reason := live.absent():
        pytest.skip(reason)
    if not linuxcnc.PARTS.is_file():
        pytest.skip("linuxcnc-uspace-dev is not installed")
    place = linuxcnc.MODULES / linuxcnc.MODULE
    if not os.access(linuxcnc.MODULES, os.W_OK):
        pytest.skip(f"{linuxcnc.MODULES} may not be written: LinuxCNC loads modules from there")
    was_there = place.is_file()
    linuxcnc.install(built_module())
    yield "nck_tp"
    if not was_there:
        place.unlink()


def test_a_run_without_the_installed_module_says_how_to_install_it(monkeypatch, tmp_path):
    if reason := live.absent():
        pytest.skip(reason)
    monkeypatch.setattr(live, "MODULES", tmp_path)
    with pytest.raises(errors.AbsentError, match="pycnc linuxcnc install"):
        live.run(tmp_path, PROGRAM, planner="nck_tp planner=linear")


def opened(tmp_path_factory):
    folder = tmp_path_factory.mktemp("live")
    for each in (folder, *folder.parents[:3]):  # up to pytest's own, one more beside xdist
        if each.stat().st_mode & 0o7777 == 0o700:
            each.chmod(0o755)  # LinuxCNC runs as another user
    return folder


@pytest.fixture
def folder(tmp_path_factory):
    return opened(tmp_path_factory)


@pytest.fixture(scope="module")
def signals(planner, tmp_path_factory):
    return live.run(opened(tmp_path_factory), SIGNALS, planner=planner, script=OPERATOR)


def test_a_program_runs_to_its_end_within_all_limits(planner, folder):
    log = live.run(folder, PROGRAM, planner=planner)
    assert max(log.peaks(live.Limits())) <= 1 + 1e-3  # the log counts nanometres
    assert log.places[-1] == pytest.approx([0, 0, 0], abs=1e-5)
    lines = [int(line) for line in dict.fromkeys(log.line) if line]
    assert lines == sorted(lines) and lines[-1] == 8
    on = log.places[np.flatnonzero(log.output)]
    assert on[0] == pytest.approx([20, 10, 0], abs=0.1)
    assert on[-1] == pytest.approx([40, 10, -2], abs=0.1)


def test_signals_and_waits_come_in_step_with_the_motion(signals):
    x = signals.places[:, 0]
    assert (np.abs(x - 1) < 1e-5).sum() > 1000  # M3 waits for the spindle
    assert (np.abs(x - 15) < 1e-5).sum() > 200  # M66 for its input
    assert x[-1] == pytest.approx(40, abs=1e-5)
    assert (signals.analog[(x > 1.001) & (x < 9.9)] == 0.25).all()
    assert x[np.argmax(signals.analog == 0.75)] == pytest.approx(10, abs=0.02)
    on = np.flatnonzero(signals.output)
    assert x[on[[0, -1]]] == pytest.approx([15, 30], abs=1e-5)  # M64, M65: at rest
    assert (np.diff(on) == 1).all()


def test_the_pins_tell_what_the_page_says(signals, root):
    found = re.findall(r"^ *\d+ +\w+ +\S+ +(\S+) +(nck-tp\.\S+)", signals.text, re.M)
    pins = {name: float(value) for value, name in found}
    page = (root / "docs/linuxcnc.md").read_text(encoding="utf-8")
    told = re.search(r"^## Pins.*?^## ", page, re.M | re.S)[0]
    names = {f"nck-tp{end}" for end in re.findall(r"`(?:nck-tp)?(\.[\w-]+)`", told)}
    assert set(pins) == names
    assert pins["nck-tp.speed"] == pytest.approx(10, abs=1e-3)
    assert abs(pins["nck-tp.acceleration"]) < 0.1 and abs(pins["nck-tp.jerk"]) < 10
    assert pins["nck-tp.limit"] == 0  # the feed that is programmed
    assert pins["nck-tp.queue"] >= 1 and pins["nck-tp.work"] >= 0
    assert 0 < pins["nck-tp.time"] <= pins["nck-tp.time-max"] < 1e9


def test_a_thread_follows_the_spindle(planner, folder):
    log = live.run(folder, bench.thread(dict(bench.THREADS)["G33"]), planner=planner)
    assert max(log.peaks(live.Limits())) <= 1 + 1e-3
    assert bench.phase_um(log) < 5


def per_rev(log, first, last):
    """Return the way a revolution between two places of Z that is cut downward."""
    z = log.places[:, 2]
    a, b = (np.argmax(z <= place) for place in (first, last))
    return (z[a] - z[b]) / (log.turns[b] - log.turns[a])


def test_feeds_and_threads_are_what_is_programmed_a_revolution(planner, folder):
    log = live.run(folder, TURNED, planner=planner)
    assert max(log.peaks(live.Limits())) <= 1 + 1e-3
    for first, last, lead in ((-1, -2.5, 1), (-10, -20, 0.5), (-32, -38, 1), (-44, -54, 2)):
        assert per_rev(log, first, last) == pytest.approx(lead, rel=5e-3)
    cut = (log.places[:, 2] < -32) & (log.places[:, 2] > -54)
    assert (np.diff(log.places[cut, 2]) < 0).all()  # no rest where the lead changes


@pytest.mark.sample(1)
@pytest.mark.parametrize("chapter", lathe_live.MANUAL)
def test_the_manuals_lathe_examples_cut_one_groove_of_their_lead(planner, folder, chapter):
    wrong, count = lathe_live.try_text(folder, lathe_live.MANUAL[chapter], planner)
    assert wrong == [] and count > 0


def test_what_is_missing_in_the_ini_is_in_linuxcncs_log(planner, folder, monkeypatch):
    monkeypatch.setattr(live, "AXIS", live.AXIS.replace("MAX_JERK = {j}\n", ""))
    with pytest.raises(live.errors.StateError, match="MAX_JERK is missing"):
        live.run(folder, PROGRAM, planner=planner, limit_s=30)


@pytest.mark.parametrize("period", [0, 9000])
def test_a_servo_period_out_of_range_is_in_linuxcncs_log(planner, folder, monkeypatch, period):
    ini = live.INI.replace("SERVO_PERIOD = 1000000", f"SERVO_PERIOD = {period}")
    monkeypatch.setattr(live, "INI", ini)
    with pytest.raises(live.errors.StateError, match="write 10000 to 100000000 nanoseconds"):
        live.run(folder, PROGRAM, planner=planner, limit_s=30)


@pytest.mark.parametrize(("parameter", "told"), [
    ("swing=1", "swing"), ("jerk=-1", "above zero"), ("budget=-1", "above zero"),
    ("planner=fast", "write jerk, optimal or linear"),
])  # fmt: skip
def test_a_parameter_that_is_none_does_not_load(planner, folder, parameter, told):
    with pytest.raises(live.errors.StateError, match=told):
        live.run(folder, PROGRAM, planner=f"{planner} {parameter}")


TO_AND_FRO = """G21 G90 G64 P0.01
M52 P1
G1 F3000 X40 Y0
X40 Y40
G3 X0 Y40 I-20 J0
G1 X0 Y60
M2
"""
FEED = "motion.adaptive-feed"


def test_adaptive_feed_below_zero_runs_back(planner, folder):
    script = [(0, "set", FEED, "1"), (1.5, "set", FEED, "-0.8"), (4, "set", FEED, "1")]
    log = live.run(folder, TO_AND_FRO, planner=planner, script=script)
    assert max(log.peaks(live.Limits())) <= 1 + 1e-3
    assert log.places[-1] == pytest.approx([0, 60, 0], abs=1e-5)
    begun = np.flatnonzero(np.abs(log.places).max(axis=1) > 20)[0]
    assert np.abs(log.places[begun:]).max(axis=1).min() < 1e-4  # it has come back to where it began
