# SPDX-License-Identifier: MIT
"""The switches that a machine file has: its owner homes, probes and meets limits as they are."""

import random
import pytest
import switching_runs
from serving_runs import HOLD, Talk

from pycnc.machine import Machine, MachineFileError

AXIS = "v_max_mm_s = 100\na_max_mm_s2 = 1000\nj_max_mm_s3 = 20000\nmin_mm = -150\nmax_mm = 50\n"
INPUTS = """
[inputs]
limits = true
seek_mm_min = 3000
feed_mm_min = 60
pull_off_mm = 2
bounce_ms = 3
plate_mm = -40.25
[inputs.x]
far = -149
[inputs.y]
end = "least"
at = -148.5
[inputs.z]
"""


def machine(inputs=INPUTS, **changes):
    """Return a mill with inputs, as a file would make it."""
    axes = "".join(f"[axis.{letter}]\n{AXIS}" for letter in "xyz")
    text = f'[path]\nslope = "jerk"\n[dialect]\nbase = "grbl"\n{axes}{inputs}'
    mill = Machine.from_text(text)
    return Machine.load(mill, set=changes) if changes else mill


def homed():
    """Return a session that is homed."""
    talk = Talk(machine())
    assert talk.said.pop(0).startswith("Grbl") and "$H" in talk.said.pop(0)
    assert talk.ask("G1X1F100") == ["error:9"]
    assert switching_runs.home(talk) == ["ok"]
    return talk


def test_homing_takes_the_order_the_ends_and_the_places_of_the_file():
    talk = homed()
    assert talk.session.joints_nm == (48_000_000, -148_000_000, 48_000_000)
    miss = [a - b for a, b in zip(talk.session.real_nm, (48e6, -146.5e6, 48e6), strict=False)]
    assert max(map(abs, miss)) <= switching_runs.STEP_NM
    listed = talk.ask("$$")
    for line in ("$21=1", "$22=1", "$23=2", "$24=60.000", "$25=3000.000", "$26=25", "$27=2.000"):
        assert line in listed


@pytest.mark.parametrize("skew", [6, 2])
def test_the_second_motor_of_a_gantry_is_squared_in_homing(skew):
    """The second motor's switch closes 3.25 mm sooner; one goes on alone as far as it may."""
    said = f"[inputs]\nskew_mm = {skew}\nfeed_mm_min = 60\nbounce_ms = 3\n"
    talk = Talk(machine(f"{said}[inputs.x]\n[inputs.y]\nsecond = 46.75\n[inputs.z]\n"))
    talk.said.clear()
    alarm = [] if skew > 3.25 else ["ALARM:15"]
    assert switching_runs.home(talk) == [*alarm, "ok"]
    if alarm:
        return
    switches = talk.session._host.switches
    assert abs(switches.real_nm[1] - 49_000_000) <= switching_runs.STEP_NM
    assert abs(switches.mate_nm - 45_750_000) <= switching_runs.STEP_NM


def test_the_plate_is_where_the_file_has_it():
    talk = homed()
    talk.ask("G21G90G0Z-38")
    talk.settle()
    talk.send(b"G38.2Z-60F60\n")
    touched, answer = switching_runs.lines_of(talk)
    assert answer == "ok" and touched.endswith(":1]")
    # what the Z axis was off when it was homed is off here, too
    off = talk.session.real_nm[2] - talk.session.joints_nm[2]
    assert abs(switching_runs.told_of(touched, 1) + off + 40_250_000) <= switching_runs.STEP_NM


def test_a_hold_outlasts_the_plate_that_its_brake_meets():
    talk = Talk(machine(INPUTS.replace("-40.25", "-1")))
    talk.ask("$X")
    talk.send(b"G21G91G38.2Z-9F999\n")
    while talk.session.joints_nm[2] > -900_000:
        talk.wait(1)
    talk.send(HOLD)
    touched, answer = switching_runs.lines_of(talk)[-2:]
    assert answer == "ok" and touched.endswith(":1]")
    at = talk.session.joints_nm
    assert talk.ask("G1X3F900") == ["ok"]
    talk.wait(1000)
    assert talk.status()["state"] == "Hold:0" and talk.session.joints_nm == at
    talk.settle()
    assert talk.session.joints_nm[0] == at[0] + 3_000_000


def test_a_door_that_is_open_keeps_the_lock_and_is_heeded_behind_it():
    talk = Talk(machine(INPUTS))
    talk.said.clear()
    talk.session.push("door", True)
    talk.wait(100)
    assert talk.status()["state"] == "Alarm"
    assert talk.ask("$X") == talk.ask("$H") == ["error:13"]
    talk.session.push("door", False)
    talk.wait(100)
    assert talk.ask("$X") == ["[MSG:Caution: Unlocked]", "ok"]
    talk.session.push("door", True)
    talk.wait(100)
    assert talk.status()["state"] == "Door:0" and talk.ask("$X") == ["ok"]


def test_an_emergency_stop_ends_no_check():
    talk = Talk(machine())
    talk.ask("$X"), talk.ask("$C")
    talk.session.push("emergency", True)
    talk.wait(50)
    talk.session.push("emergency", False)
    talk.wait(50)
    talk.ask("$X")
    assert talk.ask("G21G91G1X-5F900") == ["ok"]
    talk.wait(1000)
    assert talk.status()["state"] == "Check" and talk.session.moving == 0


@pytest.mark.parametrize(("way", "letter"), [("X-197.5", "X"), ("X3", "X")])
def test_both_ends_of_an_axis_are_limits(way, letter):
    talk = homed()
    talk.ask(f"$J=G91{way if way != 'X3' else 'X1'}F6000")
    if way == "X3":  # within the travel, and the switch is pushed from there by hand
        talk.session.wire("place_nm", [talk.session.real_nm[0]])
    talk.wait(4000)
    assert "ALARM:1" in talk.said and letter in talk.status()["Pn"]


def test_a_switch_for_home_alone_is_no_limit():
    talk = Talk(machine(INPUTS.replace("[inputs.z]", "[inputs.z]\nlimit = false\nat = 40")))
    talk.ask("$X")
    talk.said.clear()
    assert talk.ask("G1Z45F3000") == ["ok"]
    talk.settle()
    assert "ALARM:1" not in talk.said and talk.status()["Pn"] == "Z"


def test_door_and_emergency_stop_are_as_the_file_says_when_it_begins():
    talk = Talk(machine(**{"inputs.door": "open", "inputs.homing": False}))
    talk.wait(50)
    assert talk.status()["Pn"] == "D"
    talk.session.push("door", False)
    talk.wait(50)
    talk.settle()
    talk = Talk(machine(**{"inputs.emergency": "pushed"}))
    talk.wait(50)
    assert "ALARM:10" in talk.said


@pytest.mark.parametrize(("inputs", "key", "words"), [
    ("[inputs]\n[inputs.a]\n", "inputs.a", "no A axis"),
    ("[inputs]\norder = \"xx\"\n[inputs.x]\n", "inputs.order", "each once"),
    ("[inputs]\norder = \"y\"\n[inputs.x]\n", "inputs.order", "each once"),
    ("[inputs]\n", "inputs.homing", "no axis has a switch"),
    ("[inputs]\npull_off_mm = 41\n[inputs.x]\n", "inputs.pull_off_mm", "travel of X"),
    ("[inputs]\n[inputs.x]\nfar = 60\n", "inputs.x.far", "below the home switch at 50"),
    ("[inputs]\n[inputs.x]\nend = \"left\"\n", "inputs.x.end", "'least' or 'most'"),
    ("[inputs]\nseek_mm_min = 0\n[inputs.x]\n", "inputs.seek_mm_min", "at least"),
    ("[inputs]\nbounce_ms = nan\n[inputs.x]\n", "inputs.bounce_ms", "finite"),
    ("[inputs]\n[inputs.x]\nsecond = 49\n[inputs.y]\nsecond = 49\n", "inputs.y.second", "one axis"),
    ("[inputs]\nfoo = 1\n[inputs.x]\n", "inputs.foo", "unknown key"),
    ("[inputs]\n[inputs.x]\nat = \"here\"\n", "inputs.x.at", "number"),
])  # fmt: skip
def test_bad_inputs_are_one_error_at_their_key(inputs, key, words):
    with pytest.raises(MachineFileError) as caught:
        machine(inputs)
    assert [found for found, _ in caught.value.problems] == [key]
    assert words in caught.value.problems[0][1]


@pytest.mark.parametrize("end", ["least", "most"])
def test_a_free_axis_needs_the_place_of_its_switch(end):
    text = machine('[inputs]\nhoming = false\n[inputs.x]\nend = "%s"\n' % end).text
    key = {"least": "min_mm = -150", "most": "max_mm = 50"}[end]
    with pytest.raises(MachineFileError, match="travel of X is free"):
        Machine.from_text(text.replace(key, "", 1))


@pytest.mark.sample(4, quick=1)
@pytest.mark.parametrize("seed", range(1, 41))
def test_a_stop_by_a_switch_leaves_spindle_and_coolant_off(seed):
    draw, talk = random.Random(seed), homed()
    for line in draw.sample(("M3S1000", "M4S200", "M7", "M8", "G55", "$20=0"), 5):
        talk.ask(line)
    talk.ask("$20=0")
    pushes = draw.random() < 0.5
    talk.send(f"G91G1{draw.choice(('X300', 'Y-300', 'Z300'))}F3000\n".encode())
    talk.wait(draw.choice((0, 1, 50, 2000)) if pushes else 9000)
    if pushes:
        talk.session.push("emergency", True)
        talk.wait(draw.choice((20, 400)))
        assert "E" in talk.status()["Pn"] and talk.status()["FS"].endswith(",0")
        talk.session.push("emergency", False)
    talk.wait(1000)
    told = [talk.status() for _ in range(4)]
    assert {each["state"] for each in told} == {"Alarm"} and told[-1]["FS"] == "0,0"
    assert [each["A"] for each in told if "A" in each] == []
    talk.said.clear()
    assert talk.ask("$X")[-1] == "ok" and " M5 M9 " in talk.ask("$G")[0]
