# SPDX-License-Identifier: MIT
"""A control's own configuration in a machine file's place, and what is in force at its start."""

import random
import tomllib

import configurations
import pytest
from command_line import pycnc

from pycnc.machine import Machine, MachineFileError, imported

PART = b"G21 G90\nG0 X1\nG1 X2 F600\n"
INI = """\
[RS274NGC]
RS274NGC_STARTUP_CODE = {code}
[TRAJ]
COORDINATES = {axes}
LINEAR_UNITS = {unit}
MAX_LINEAR_VELOCITY = 20
MAX_LINEAR_ACCELERATION = 200
"""


def written(case, folder):
    """Write a case; return the path of the file that is read."""
    for name, data in case.files.items():
        (folder / name).write_bytes(data)
    return folder / next(iter(case.files))


@pytest.mark.sample(6)
@pytest.mark.parametrize("number", range(60))
@pytest.mark.parametrize("kind", configurations.KINDS)
def test_a_configuration_is_the_machine_that_its_import_is(kind, number, draw_seed, tmp_path):
    case = getattr(configurations, kind)(draw_seed + number)
    file = written(case, tmp_path)
    units = ["--units", case.units] if case.units else []
    imported = pycnc("machine", "import", file, *units)
    assert imported.code == 0
    if units:
        with pytest.raises(MachineFileError, match="pycnc machine import") as told:
            Machine.load(file)
        assert "--units mm or --units inch" in str(told.value)
        return
    machine = Machine.load(file)
    assert machine.sha256 == Machine.from_text(imported.out).sha256
    assert set(machine.not_imported) <= {
        line.partition("note[not-imported]: ")[2] for line in imported.err.splitlines()
    }
    timed = pycnc("check", "-", "-m", file, stdin=PART)
    assert all(f"{file}: note[not-imported]: {words}" in timed.err.splitlines()
               for words in machine.not_imported)  # fmt: skip
    assert "not-imported" not in pycnc("check", "-q", "-", "-m", file, stdin=PART).err


def test_a_configuration_that_is_toml_too_is_one(tmp_path):
    file = tmp_path / "printer.cfg"
    rows = ["[printer]", 'kinematics = "cartesian"', "max_velocity = 300", "max_accel = 3000"]
    rows += [row for at in "xyz" for row in (f"[stepper_{at}]", "position_max = 200")]
    file.write_text("\n".join([row.replace('"', "") for row in rows] + [""]))
    machine = Machine.load(file)
    file.write_text("\n".join([*(row for row in rows if "kinem" not in row), ""]))
    assert Machine.load(file).sha256 == machine.sha256


@pytest.mark.sample(20)
@pytest.mark.parametrize("number", range(200))
def test_a_start_up_code_says_what_is_in_force(number, draw_seed):
    pen = random.Random(draw_seed + number)
    unit, units = pen.choice(["mm", "inch"]), pen.choice(["", "G20", "G21"])
    plane, centre = pen.choice(["", "G17", "g 18", "G19"]), pen.choice(["", "G90.1", "G91.1"])
    within = pen.choice(["", "G64", "G61", f"G64 P0.0{pen.randrange(1, 9)}"])
    feed = pen.choice(["", f"F{pen.randrange(1, 900)}"])
    words = [each for each in (units, plane, centre, within, feed, "G40", "(G55)", "G80") if each]
    pen.shuffle(words)
    settings = of_ini(" ".join(words) + pen.choice(["", "  # G91"]), unit).settings
    scale = {"G20": 25.4, "G21": 1}.get(units, 25.4 if unit == "inch" else 1)
    dialect, path = settings.dialect, settings.path
    assert dialect.units == {"G20": "inch", "G21": "mm"}.get(units, unit)
    assert dialect.plane == int(plane[-2:] or 17)
    assert dialect.arc_centre == ("absolute" if centre == "G90.1" else "incremental")
    assert float(dialect.feed_default_mm_min) == pytest.approx(float(feed[1:] or 0) * scale)
    is_said = within in ("G61",) or "P" in within
    assert settings.control.g64_without_p == ("tolerance" if is_said else "length")
    if is_said:
        told = float(within[5:] or 0) * scale
        assert float(path.tolerance_mm) == pytest.approx(told)


def of_ini(code, unit="mm", axes="XYZ", folder=None):
    """Return the machine of an INI with a start-up code."""
    text = INI.format(code=code, unit=unit, axes=axes)
    return Machine.from_text(imported(text, "mill.ini", folder)[1])


@pytest.mark.sample(20)
@pytest.mark.parametrize("number", range(200))
def test_a_start_up_code_that_a_machine_file_cannot_say_is_refused(number, draw_seed):
    """A call may set what it likes, and an expression's number is not known."""
    pen = random.Random(draw_seed + number)
    odd = pen.choice(["G91", "G92", "G93", "G95", "G61.1", "G10 L2 P1 X0", "G92 X-3", "o<go> call",
                      "G64 P[0.5/10]", "G64 P#5", "F[2*3]"])  # fmt: skip
    words = pen.sample(["G17", "G21", "g 40", "G80", "(G64)", "T1", "M5"], pen.randrange(4))
    words.insert(pen.randrange(len(words) + 1), odd)
    with pytest.raises(MachineFileError, match="RS274NGC_STARTUP_CODE: .*a machine file cannot"):
        of_ini(" ".join(words))


@pytest.mark.parametrize("code", ["G55", "G59.1", "G20 G59"])
def test_a_start_up_code_with_a_work_system_says_so(code):
    text = INI.format(code=code, unit="mm", axes="XZ")
    draft, _ = imported(text, "mill.ini")
    assert f"start-up code {code}: {code.split()[-1]}" in "\n".join(draft.left)


@pytest.mark.parametrize("seed", range(40))
def test_a_laser_of_fluidnc_is_one_where_it_is_its_first_tool(seed, tmp_path):
    pen = random.Random(seed)
    spindles = pen.sample(["laser", "pwm", "huanyang", "besc", "10V"], pen.randrange(1, 4))
    numbers = {name: pen.choice([None, *range(4)]) for name in spindles}
    rows = ["axes:", "  x:", "    max_rate_mm_per_min: 6000"]
    for name in spindles:
        rows += [f"{pen.choice([name, name.title()])}:", "  pwm_hz: 5000"]
        rows += [f"  tool_num: {numbers[name]}"] * (numbers[name] is not None)
    file = tmp_path / "config.yaml"
    file.write_text("\n".join([*rows, ""]))
    first = min(number or 0 for number in numbers.values())
    is_laser = "laser" in numbers and (numbers["laser"] or 0) == first
    assert Machine.load(file).settings.control.laser_mode == is_laser


@pytest.mark.sample(20)
@pytest.mark.parametrize("number", range(200))
def test_g28_of_a_printer_leads_to_where_it_homes(number, draw_seed):
    pen = random.Random(draw_seed + number)
    low, high = pen.randrange(-20, 1), pen.randrange(150, 300)
    at = {letter: pen.choice([None, low, high, high + 7, pen.randrange(1, 99)]) for letter in "xyz"}
    rows = ["[printer]", "kinematics: corexy", "max_velocity: 300", "max_accel: 3000"]
    for letter, end in at.items():
        rows += [f"[stepper_{letter}]", f"position_max: {high}", f"position_min: {low}"]
        rows += [f"position_endstop: {end}"] * (end is not None)
    safe = pen.random() < 0.5
    rows += ["[safe_z_home]", "home_xy_position: 110, 120.5"] * safe
    made = imported("\n".join([*rows, ""]), "printer.cfg")[1]
    settings = Machine.from_text(made).settings
    for letter, end in at.items():
        wanted = end if end is not None and low <= end <= high else 0
        if safe and letter in "xy":
            wanted = {"x": 110, "y": 120.5}[letter]
        assert float(settings.home.g28.along(letter)) == wanted
        assert settings.start.along(letter) == 0  # where programs without G28 begin


@pytest.mark.parametrize(("switch", "wanted"), [
    ("M574 X1 Y2 Z1 S1", (-5, 210, 0)), ('M574 X2 S1 P"a"\nM574 Y1 P"b"', (230, 0, 0)),
    ("", (0, 0, 0)),
])  # fmt: skip
def test_g28_of_reprap_leads_to_its_switches(switch, wanted):
    text = ("M584 X0 Y1 Z2 E3\nM203 X6000 Y6000 Z180 E1200\nM201 X500 Y500 Z20 E250\n"
            "M566 X9 Y9 Z6 E12\nM208 X-5 Y0 Z0 S1\nM208 X230 Y210 Z200 S0\n")
    text += f"{switch}\n"
    home = Machine.from_text(imported(text, "config.g")[1]).settings.home.g28
    assert tuple(float(home.along(letter)) for letter in "xyz") == wanted


@pytest.mark.parametrize("up", [False, True])
def test_an_axis_free_on_one_side_begins_within_the_other(up):
    at = -10 if up else 10
    axis = f"axes:\n  x:\n    max_travel_mm: 1e30\n    homing:\n      mpos_mm: {at}\n"
    text = f"{axis}      positive_direction: {str(up).lower()}\n"
    data = tomllib.loads(pycnc("machine", "import", "-", stdin=text.encode()).out)
    assert data["start"]["x_mm"] == at
