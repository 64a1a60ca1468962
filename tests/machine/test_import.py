# SPDX-License-Identifier: MIT
"""Machine files from other controls' configurations, and new ones."""

import tomllib

import pytest
from command_line import pycnc

from pycnc.machine import Machine

KLIPPER = """\
# a printer
[stepper_x]
step_pin: PF0
position_max: 220
[stepper_y]
position_max = 200  ; behind a mark
position_min: -5
[stepper_z]
position_max: 250
[printer]
kinematics: corexy
max_velocity: 300   # mm/s
max_accel: 3000
max_z_velocity: 10
max_z_accel: 100
square_corner_velocity: 5.0
"""
LINUXCNC = """\
[EMC]
MACHINE = mymill
[TRAJ]
COORDINATES = X Y Z A
LINEAR_UNITS = inch
MAX_LINEAR_VELOCITY = 4
[EMCMOT]
SERVO_PERIOD = 2000000
[AXIS_X]
MIN_LIMIT = -10
MAX_LIMIT = 10.5
MAX_VELOCITY = 3
MAX_ACCELERATION = 30
[AXIS_Y]
MIN_LIMIT = 2
MAX_VELOCITY = 3
MAX_ACCELERATION = 30
[JOINT_2]
MAX_VELOCITY = 2
MAX_ACCELERATION = 20
BACKLASH = 0.001
[AXIS_A]
MAX_VELOCITY = 90
MAX_ACCELERATION = 1200
MIN_LIMIT = -1E99
"""
GRBL = """\
Grbl 1.1h ['$' for help]
$11=0.010
$12=0.002
$30=12000
$110=6000.000 (x max rate, mm/min)
$111=6000
$112=600
$120=200.000
$121=200.000
$122=50
$130=300
ok
"""
FLUIDNC = """\
name: "Router"
arc_tolerance_mm: 0.002
axes:
  x:
    max_rate_mm_per_min: 6000
    acceleration_mm_per_sec2: 300
    max_travel_mm: 400
    homing:
      positive_direction: false
      mpos_mm: 10
  z:
    max_rate_mm_per_min: 1200
    acceleration_mm_per_sec2: 100
    max_travel_mm: 90
"""


def imported(text, *options):
    result = pycnc("machine", "import", "-", *options, stdin=text.encode())
    assert result.code == 0, result.err
    return tomllib.loads(result.out), result


def test_klipper():
    data, result = imported(KLIPPER)
    assert data["axis"]["x"] == {
        "v_max_mm_s": 300, "a_max_mm_s2": 3000, "j_max_mm_s3": 60000, "min_mm": 0, "max_mm": 220,
    }  # fmt: skip
    assert data["axis"]["y"]["min_mm"] == -5
    assert (data["axis"]["z"]["v_max_mm_s"], data["axis"]["z"]["a_max_mm_s2"]) == (10, 100)
    assert data["path"] == {"feed_max_mm_min": 18000, "a_max_mm_s2": 3000}
    assert data["dialect"]["base"] == "marlin"
    assert "v_max_mm_s = 10 # line 14: max_z_velocity: 10" in result.out
    assert "square_corner_velocity: 5.0" in result.err
    assert "#   line 16: square_corner_velocity: 5.0" in result.out


def test_linuxcnc_in_inches():
    data, result = imported(LINUXCNC)
    x, y, z, a = (data["axis"][letter] for letter in "xyza")
    assert (x["v_max_mm_s"], x["a_max_mm_s2"]) == (76.2, 762)
    assert (x["min_mm"], x["max_mm"]) == (-254, 266.7)
    assert z["v_max_mm_s"] == 50.8, "of its joint"
    assert (a["v_max_deg_s"], a["a_max_deg_s2"], a["min_deg"]) == (90, 1200, "free")
    assert data["start"]["y_mm"] == y["min_mm"] == 50.8, "a start within the travel"
    assert data["kernel"]["period_ms"] == 2
    assert data["path"]["feed_max_mm_min"] == 4 * 60 * 25.4
    assert data["dialect"]["units"] == "inch"
    assert "BACKLASH = 0.001" in result.err


def test_grbl():
    data, result = imported(GRBL)
    assert data["axis"]["x"]["v_max_mm_s"] == 100
    assert (data["axis"]["x"]["min_mm"], data["axis"]["x"]["max_mm"]) == (-300, 0)
    assert "min_mm" not in data["axis"]["y"]
    assert (data["path"]["chord_error_mm"], data["spindle"]["rpm_max"]) == (0.002, 12000)
    assert "junction deviation" in result.err


def test_fluidnc():
    data, _ = imported(FLUIDNC)
    assert (data["axis"]["x"]["min_mm"], data["axis"]["x"]["max_mm"]) == (10, 410)
    assert (data["axis"]["z"]["min_mm"], data["axis"]["z"]["max_mm"]) == (-90, 0)
    assert data["home"]["g28"]["x_mm"] == 10
    assert set(data["axis"]) == {"x", "z"}


@pytest.mark.parametrize("text", [KLIPPER, LINUXCNC, GRBL, FLUIDNC])
def test_what_is_imported_is_a_machine_and_moves(text, tmp_path):
    source, target = tmp_path / "source", tmp_path / "machine.toml"
    source.write_text(text)
    result = pycnc("machine", "import", source, "-o", target)
    assert (result.code, result.out) == (0, f"{target}\n")
    assert Machine.load(target).axes
    program = b"G21 G90\nG1 X11 F600\nM2\n"
    assert pycnc("time", "-", "-m", target, "-q", stdin=program).code in (0, 1)
    again = pycnc("machine", "import", source, "-o", target)
    assert again.code == 2 and "cannot write it: File exists" in again.err


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "is no configuration that can be imported"),
        ("[path]\nslope = 1\n", "LinuxCNC (INI), grbl or grblHAL ($$), Klipper"),
        (KLIPPER.replace("max_accel: 3000\n", ""), "axis.x: no a_max for it in the file"),
        (KLIPPER.replace("corexy", "delta"), "delta has no equal here"),
        (KLIPPER.replace("3000", "fast"), "line 13: 'fast' is no number: max_accel: fast"),
        (LINUXCNC.replace("= 30\n", "= nan\n"), "'nan' is no number"),
        (GRBL.replace("$120=200.000", "$120="), "axis.x: no a_max"),
        (GRBL.replace("$130=300", "$130=-300"), "axis.x.min_mm"),
        ("axes:\n  x:\n    max_rate_mm_per_min: 5", "axis.x: no a_max"),
        ("axes:\n", "no axis found"),
        (LINUXCNC.replace("LINEAR_UNITS = inch", "LINEAR_UNITS = ell"), "'ell' is none of mm, "),
        (LINUXCNC.replace("= 30\n", "= -30\n"), "is -762); line "),
        ("[printer]\nmax_velocity: -1\nmax_accel: 1\n[stepper_x]\n", "axis.x.v_max_mm_s"),
    ],
)
def test_what_is_wrong_with_a_configuration_is_told(text, words):
    result = pycnc("machine", "import", "-", stdin=text.encode())
    assert (result.code, result.out) == (2, "")
    assert words in result.err
    assert "Traceback" not in result.err


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[include z.cfg]\n" + KLIPPER, "line 1: [include z.cfg] (what stands there is not read)"),
        (LINUXCNC + "#INCLUDE z.inc\n", "#INCLUDE z.inc (what stands there is not read)"),
    ],
)
def test_what_stands_in_another_file_is_told(text, words):
    _, result = imported(text)
    assert words in result.err
    assert words in result.out


def test_a_name_cannot_leave_its_string():
    data, _ = imported('[printer]\nmax_velocity: 9\nmax_accel: 9\n[stepper_x]\na"]\n[x: "1"\n')
    assert set(data["axis"]) == {"x"}


def test_a_new_machine_has_every_key_with_its_meaning(tmp_path):
    file = tmp_path / "mine.toml"
    made = pycnc("machine", "new", "mine", "--travel", "x=-300:300,z=-200:-1", "-o", file)
    assert made.code == 0
    machine = Machine.load(file)
    assert (machine.axes, machine.settings.axis.x.max_mm) == ("xyz", 300)
    assert machine.settings.start.z_mm == -1
    text = file.read_text()
    for key in ("tool_change_s", "# tolerance_mm = 0.01", "# rapid_mm_s =", "# Highest jerk"):
        assert key in text
    plain = "\n".join(line.removeprefix("# ") if " = " in line and line[:2] == "# " and
                      line.split()[1].isidentifier() else line for line in text.splitlines())
    assert Machine.from_text(plain).settings == machine.settings, "what is commented is a default"


def test_a_new_lathe_and_wrong_flags():
    assert 'type = "lathe_xz"' in pycnc("machine", "new", "l", "--axes", "xz").out
    for flags in (["--axes", "xq"], ["--travel", "x=1"], ["--travel", "q=0:1"], ["--a-max", "-1"],
                  ["--travel", "x=5:1"], ["--travel", "x=nan:1"], ["--travel", "x=0:inf"],
                  ["--v-max", "nan"], ["--j-max", "inf"]):  # fmt: skip
        result = pycnc("machine", "new", "m", *flags)
        assert (result.code, result.out) == (2, ""), flags
