# SPDX-License-Identifier: MIT
"""Machine files from other controls' configurations, and new ones."""

import math
import random
import time
import tomllib

import configurations
import pytest
from command_line import pycnc

from pycnc.errors import ArgumentError
from pycnc.machine import Machine, MachineFileError, importer
from pycnc.program import load

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
    assert data["control"]["kind"] == "klipper" and data["control"]["max_accel"] == 3000
    assert "square_corner_velocity = 5 # line 16: square_corner_velocity: 5.0" in result.out
    assert "minimum_cruise_ratio = 0.5 # not in the source: the control's own default" in result.out


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


@pytest.mark.parametrize("seed", range(8))
def test_arcs_of_linuxcnc_miss_their_circle_by_its_tolerance(tmp_path, seed):
    rng, said = random.Random(seed), seed % 4
    unit, scale = rng.choice((("mm", 1.0), ("inch", 25.4)))
    most = 0.02 * math.sqrt(2) / (1 if unit == "mm" else 10)
    told = (None, most * rng.uniform(0.1, 0.9), most * rng.uniform(1.1, 9), 1e-6)[said]
    key = f"CENTER_ARC_RADIUS_TOLERANCE_{unit.upper()}"
    lines = ["[EMC]", "[TRAJ]", "COORDINATES = X Y Z", f"LINEAR_UNITS = {unit}", "[RS274NGC]",
             *([f"{key} = {told:.7f}"] if told else [])]  # fmt: skip
    draft = importer.read("\n".join([*lines, ""]), "machine.ini", tmp_path)
    machine = Machine.from_text(draft.text())
    within = scale * (told if said == 1 else most)
    assert float(machine.settings.path.arc_radius_mm) == pytest.approx(within, rel=1e-5)
    free = {f"axis.{letter}.{end}_mm": "free" for letter in "xyz" for end in ("min", "max")}
    loose, radius = Machine.load(machine, set=free), 500 * within  # a thousandth of it is less
    for share, good in ((0.98, True), (1.02, False)):
        end = 2 * radius + share * within
        text = f"G21\nG17\nG1 F30 X0\nG2 X{end:.6f} I{radius:.6f}\nM2\n"
        found = {each.id for each in load(text.encode(), loose).diagnostics}
        assert ("arc-radius" not in found) == good, (share, found)


def test_grbl():
    data, result = imported(GRBL)
    assert data["axis"]["x"]["v_max_mm_s"] == 100
    assert (data["axis"]["x"]["min_mm"], data["axis"]["x"]["max_mm"]) == (-300, 0)
    assert "min_mm" not in data["axis"]["y"]
    assert (data["path"]["chord_error_mm"], data["spindle"]["rpm_max"]) == (0.002, 12000)
    assert data["control"]["kind"] == "grbl" and "junction_deviation" in data["control"]


def test_fluidnc():
    data, _ = imported(FLUIDNC)
    assert (data["axis"]["x"]["min_mm"], data["axis"]["x"]["max_mm"]) == (10, 410)
    assert (data["axis"]["z"]["min_mm"], data["axis"]["z"]["max_mm"]) == (-90, 0)
    assert data["home"]["g28"]["x_mm"] == 10
    assert set(data["axis"]) == {"x", "z"}


DELTA = """\
[printer]
kinematics: delta
max_velocity: 300
max_accel: 3000
max_accel_to_decel: 1200
max_z_velocity: 150
minimum_z_position: -2
delta_radius: 120
print_radius: 100
[stepper_a]
position_endstop: 310.5
arm_length: 250
[stepper_b]
[stepper_c]
position_endstop: 309
"""


def test_a_delta_is_told_by_its_name():
    data, result = imported(DELTA)
    ends = {k: (axis["min_mm"], axis["max_mm"]) for k, axis in data["axis"].items()}
    assert ends == {"x": (-100, 100), "y": (-100, 100), "z": (-2, 309)}
    assert data["axis"]["z"]["v_max_mm_s"] == 150
    assert data["control"]["minimum_cruise_ratio"] == pytest.approx(0.6)
    assert "kinematics delta: three towers; Klipper is slower near the edge" in result.err
    for name, words in (("polar", "a bed that turns"), ("winch", "cables"),
                        ("rotary_delta", "three arms"), ("deltesian", "two towers")):  # fmt: skip
        _, result = imported(DELTA.replace("delta\nmax_vel", f"{name}\nmax_vel"))
        assert f"kinematics {name}: {words}" in result.err


@pytest.mark.parametrize("number, words", [
    (1, "CoreXY"), (4, "a SCARA of two arms"), (10, "a rotary delta"), (99, "M669 K99"),
])  # fmt: skip
def test_kinematics_of_reprap_are_told_by_their_name(number, words):
    text = f"M669 K{number}\nM584 X0\nM203 X60 Y60 Z60 E6\nM201 X9 Y9 Z9 E9\nM665 R1\n"
    _, result = imported(text)
    assert f"kinematics: {words}; planned is the tool's path" in result.err
    data, _ = imported(text.replace(f"M669 K{number}", "M665 B80 H200"))
    assert (data["axis"]["x"]["min_mm"], data["axis"]["x"]["max_mm"]) == (-80, 80)


def test_kinematics_of_linuxcnc_are_told_by_their_name():
    for name, words in (("lineardeltakins", "three towers"), ("scarakins", "a SCARA"),
                        ("corexykins", "CoreXY"), ("xyzac-trt-kins", "a mill with a table"),
                        ("mine", "joints")):  # fmt: skip
        _, result = imported(f"{LINUXCNC}[KINS]\nKINEMATICS = {name} coordinates=xyza\n")
        assert f"kinematics {name}: " in result.err and words in result.err
    _, result = imported(f"{LINUXCNC}[KINS]\nKINEMATICS = trivkins\n")
    assert "kinematics" not in result.err


def test_what_is_absent_is_the_controls_own_default_and_told():
    data, result = imported(LINUXCNC.replace("MAX_VELOCITY = 90\nMAX_ACCELERATION = 1200\n", ""))
    assert (data["axis"]["a"]["v_max_deg_s"], data["axis"]["a"]["a_max_deg_s2"]) == (1, 1)
    assert "v_max_deg_s = 1 # not in the source: the control's own default" in result.out
    data, _ = imported("axes:\n  x:\n    max_travel_mm: 90\n")
    assert data["axis"]["x"]["a_max_mm_s2"] == 25
    data, _ = imported(LINUXCNC.replace("[AXIS_X]", "[AXIS_X]\nOFFSET_AV_RATIO = 0.25"))
    assert data["axis"]["x"]["v_max_mm_s"] == pytest.approx(76.2 * 0.75)


def test_junction_deviation_of_marlin_is_asked_for():
    text = "M203 X9 Y9\nM201 X9 Y9\nM205 J{0}\n"
    data, _ = imported(text.format("0.01"), "--junction-deviation", "0.013")
    assert data["control"]["junction_deviation"] == 0.013
    for told in ("0.013", "0.00"):
        data, _ = imported(text.format(told))
        assert data["control"]["junction_deviation"] == float(told)


def test_nobody_knows_where_the_work_of_a_mill_lies():
    for text in (LINUXCNC, GRBL, FLUIDNC):
        assert imported(text)[0]["work"] == {"zero": "unknown"}
    assert "work" not in imported(KLIPPER)[0]


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
        (KLIPPER.replace("corexy", "none"), "none moves no axes that are known here; known: "),
        ("[gcode_macro A]\ngcode:\n  G28\n", "no [printer]: it is a part of a configuration"),
        ("M203 X9 Y9\nM201 X9 Y9\nM205 J0.01\n", "J0.01: M503 prints two decimals of J: add"),
        ("M584 X0\nM203 X9\n", "axis.x: no a_max"),
        ("M584 X0\nG20\nM203 X9\nM201 X9\n", "in inches (G20)"),
        (KLIPPER.replace("3000", "fast"), "line 13: 'fast' is no number: max_accel: fast"),
        (LINUXCNC.replace("= 30\n", "= nan\n"), "'nan' is no number"),
        (f"{LINUXCNC}[JOINT_0]\nMAX_LIMIT = 3,5\n", "'3,5' is no number"),
        (GRBL.replace("$120=200.000", "$120="), "axis.x: no a_max"),
        (GRBL.replace("$130=300", "$130=-300"), "has no sign"),
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


# What a file says, wherever it says it


@pytest.mark.sample(60)
@pytest.mark.parametrize("kind", configurations.KINDS)
@pytest.mark.parametrize("number", range(300))
def test_what_is_written_is_read_and_every_line_is_told(kind, number, draw_seed, tmp_path):
    case = getattr(configurations, kind)(draw_seed + number)
    assert configurations.faults(case, tmp_path) == []


@pytest.mark.sample(30)
@pytest.mark.parametrize("number", range(300))
def test_a_damaged_configuration_is_imported_or_refused(number, draw_seed, tmp_path):
    pen = random.Random(draw_seed + number)
    case = getattr(configurations, pen.choice(configurations.KINDS))(draw_seed + number)
    for name, data in case.files.items():
        damaged = bytearray(data)
        for _ in range(pen.randrange(1, 6)):
            at = pen.randrange(len(damaged))
            damaged[at : at + pen.randrange(4)] = pen.randbytes(pen.randrange(4))
        (tmp_path / name).write_bytes(damaged)
    result = pycnc("machine", "import", tmp_path / next(iter(case.files)))
    assert result.code in (0, 2)
    if result.code == 0:
        Machine.from_text(result.out)


def test_keys_may_be_indented():
    data, _ = imported(LINUXCNC.replace("\nM", "\n\t M").replace("\nL", "\n   L"))
    assert data == imported(LINUXCNC)[0]


@pytest.mark.parametrize("units", ["mm", "inch"])
def test_units_are_found_or_asked_for(units):
    text = LINUXCNC.replace("LINEAR_UNITS = inch\n", "")
    result = pycnc("machine", "import", "-", stdin=text.encode())
    assert (result.code, result.out) == (2, "")
    assert "the file does not say them: add --units mm or --units inch" in result.err
    data, _ = imported(text, "--units", units)
    assert data["axis"]["x"]["v_max_mm_s"] == {"mm": 3, "inch": 76.2}[units]
    result = pycnc("machine", "import", "-", "--units", "mm", stdin=LINUXCNC.encode())
    assert (result.code, result.out) == (2, "") and "the file says otherwise" in result.err


def test_a_unit_may_be_a_number():
    data, _ = imported(LINUXCNC.replace("= inch", "= 0.03937007874015748"))
    assert data == imported(LINUXCNC)[0]


def test_angles_have_their_unit_too():
    text = LINUXCNC.replace("[EMCMOT]", "ANGULAR_UNITS = radian\n[EMCMOT]")
    text = text.replace("= 90\n", "= 1.5707963267948966\n").replace("= 1200", "= 20")
    data, _ = imported(text)
    assert data["axis"]["a"]["v_max_deg_s"] == pytest.approx(90)
    assert data["axis"]["a"]["a_max_deg_s2"] == pytest.approx(1145.91559)


# Both forbid: who read the axis' alone went beyond its joint's.
@pytest.mark.parametrize(
    ("joint", "kinematics", "ends"),
    [
        ("MIN_LIMIT = -4\nMAX_LIMIT = 20", "", (-101.6, 266.7)),
        ("MIN_LIMIT = -40\nMAX_LIMIT = 3.5", "KINEMATICS = trivkins", (-254, 88.9)),
        ("MIN_LIMIT = -4\nMAX_LIMIT = 3", "KINEMATICS = corexykins", (-254, 266.7)),
    ],
)
def test_the_travel_is_the_tighter_one_of_an_axis_and_its_joint(joint, kinematics, ends):
    data, _ = imported(f"{LINUXCNC}[JOINT_0]\n{joint}\n[KINS]\n{kinematics}\n")
    x = data["axis"]["x"]
    assert (x["min_mm"], x["max_mm"]) == pytest.approx(ends)


@pytest.mark.parametrize(
    ("words", "name"),
    [("", ""), ("M665 L218.00 R101.00 H230.00 S80.00", "a delta of three towers"),
     ("M665 S80.00 P0.00 T0.00 Z0.00", "a SCARA")],
)  # fmt: skip
def test_motors_of_marlin_that_are_no_axes_are_named(words, name):
    axes = " X300.00 Y300.00 Z300.00\n"
    text = f"M92{axes}M203{axes}M201{axes}{words}"
    told = [each for each in importer.read(text, "m503.txt").left if "kinematics" in each]
    assert len(told) == bool(name) and all(name in each for each in told)


def test_two_joints_of_an_axis_do_not_move_the_next():
    text = LINUXCNC.replace("X Y Z A", "X Y Y Z").replace("[JOINT_2]", "[JOINT_3]")
    data, _ = imported(text)
    assert data["axis"]["z"]["v_max_mm_s"] == 50.8


def test_linuxcnc_goes_on_without_what_cannot_be_included(tmp_path):
    (tmp_path / "a.ini").write_text(f"#INCLUDE no.inc\n{LINUXCNC}#INCLUDE b.inc\n")
    (tmp_path / "b.inc").write_text("#INCLUDE c.inc\n[AXIS_Z]\nMAX_LIMIT = 1\n")
    result = pycnc("machine", "import", tmp_path / "a.ini")
    assert result.code == 0
    assert "line 1: #INCLUDE no.inc (No such file or directory: not read)" in result.out
    assert "b.inc line 1: #INCLUDE c.inc (LinuxCNC does not read it there)" in result.out
    assert "max_mm = 25.4 # b.inc line 3: MAX_LIMIT = 1" in result.out


def test_of_several_values_the_one_counts_that_the_control_takes():
    twice = LINUXCNC.replace("MAX_VELOCITY = 3\n", "MAX_VELOCITY = 3\nMAX_VELOCITY = 4\n")
    data, result = imported(twice)
    assert data["axis"]["x"]["v_max_mm_s"] == 76.2
    assert "line 13: MAX_VELOCITY = 4 (line 12 counts)" in result.out
    data, result = imported(KLIPPER + "[printer]\nmax_accel: 5000\n")
    assert data["axis"]["x"]["a_max_mm_s2"] == 5000
    assert "line 13: max_accel: 3000 (line 18 counts)" in result.out


def test_what_goes_on_under_a_key_of_klipper_is_no_key():
    data, result = imported(KLIPPER + "[gcode_macro a]\ngcode:\n  max_velocity: 7\n")
    assert data["axis"]["x"]["v_max_mm_s"] == 300
    assert "#   line 19: max_velocity: 7" in result.out


@pytest.mark.parametrize("number", ["1_000", "１", "0x10", "1e9999", "infinity", "--1", "3,5"])
def test_a_number_is_written_as_the_controls_write_it(number):
    text = KLIPPER.replace("max_accel: 3000", f"max_accel: {number}")
    result = pycnc("machine", "import", "-", stdin=text.encode())
    assert (result.code, result.out) == (2, "")
    assert "is no number" in result.err


@pytest.mark.thorough
def test_many_empty_lines_take_no_time():
    began = time.process_time()
    for text in (LINUXCNC, KLIPPER, GRBL, FLUIDNC, "[path]\nslope = \n"):
        lines = "\n" * 200_000 + text + " \n" * 200_000
        try:
            importer.read(lines, "x", None, "mm" if "LINEAR" not in text else None)
        except ArgumentError:
            pass
        with pytest.raises(MachineFileError):
            Machine.from_text(lines)
    assert time.process_time() - began < 20, "five texts of 400 000 lines, read twice"


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


@pytest.mark.parametrize(("old", "new", "words"), [
    ("position_max: 250", "position_max: 2,5", "'2,5' is no number"),
    ("max_accel: 3000", "max_accel: 3000;fast", "'3000;fast' is no number"),
])  # fmt: skip
def test_what_cannot_be_read_is_told_once(old, new, words):
    text = f"[printer]\nkinematics: cartesian\nmax_velocity: 300\nmax_accel: 3000\n{_STEPPERS}"
    (problem,) = importer.read(text.replace(old, new, 1), "printer.cfg").problems
    assert words in problem[1]


_STEPPERS = "".join(f"[stepper_{axis}]\nposition_max: 250\n" for axis in "xyz")
_DOLLARS = "".join(f"${110 + k}=500\n${120 + k}=10\n${130 + k}=200\n" for k in range(3))


def test_a_travel_of_grbl_with_a_sign_is_refused_and_one_of_zero_is_told():
    (problem,) = importer.read(_DOLLARS.replace("$130=200", "$130=-200"), "g.txt").problems
    assert problem[0].startswith("line 3") and "has no sign" in problem[1]
    draft = importer.read(_DOLLARS.replace("$132=200", "$132=0"), "g.txt")
    assert [each for each in draft.left if "travel of Z" in each] and not draft.problems
    assert draft.limit("z", "min") is None


def test_an_empty_travel_is_told_without_the_places_in_it():
    with pytest.raises(MachineFileError) as caught:
        Machine.load("mill3", set={"axis.x.min_mm": 400})
    assert str(caught.value).count("error[machine]") == 1


def test_a_number_out_of_range_is_told_without_what_follows_from_it(tmp_path):
    (tmp_path / "g.txt").write_text(_DOLLARS.replace("$121=10", "$121=1e30"))
    told = pycnc("machine", "import", tmp_path / "g.txt").err
    assert told.count("error[") == 1 and "$121" in told
