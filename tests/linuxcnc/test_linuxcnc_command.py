# SPDX-License-Identifier: MIT
"""`pycnc linuxcnc`: what a machine's owner is told, before anything runs."""

import json

import pytest
from command_line import pycnc
from linuxcnc_stand_in import Machine

from pycnc import errors, linuxcnc

WITHOUT_JERK = Machine().ini.replace("MAX_JERK = 10000.0\n", "")


@pytest.fixture
def ini(tmp_path):
    def write(text):
        path = tmp_path / "machine.ini"
        path.write_text(text, encoding="utf-8")
        return str(path)

    return write


def test_what_an_ini_file_lacks_is_told(ini):
    done = pycnc("linuxcnc", "ini", ini(WITHOUT_JERK))
    assert done.code == 0
    for words in ("[TRAJ]\nTPMOD = nck_tp\n", "[AXIS_X]\nMAX_JERK = 10000\n", "[AXIS_Z]\n"):
        assert words in done.out


def test_an_ini_file_with_all_of_it_needs_nothing(ini):
    done = pycnc("linuxcnc", "ini", ini(Machine(traj="TPMOD = nck_tp").ini))
    assert done.code == 0 and "nothing to add" in done.out


@pytest.mark.parametrize(("traj", "joint"), [
    ("TPMOD = nck_tp\nMAX_LINEAR_JERK = 5000", ""),
    ("TPMOD = nck_tp", "".join(f"[JOINT_{n}]\nMAX_JERK = 1\n" for n in range(3))),
])  # fmt: skip
def test_jerk_may_stand_in_other_places(ini, traj, joint):
    text = Machine(traj=traj).ini.replace("MAX_JERK = 10000.0\n", "") + joint
    assert "nothing to add" in pycnc("linuxcnc", "ini", ini(text)).out


@pytest.mark.parametrize(("line", "told"), [
    ("MAX_VELOCITY = 100.0\n", "error: [AXIS_X] MAX_VELOCITY is missing"),
    ("COORDINATES = X Y Z\n", "error: [TRAJ] COORDINATES is missing"),
])  # fmt: skip
def test_what_keeps_the_module_from_loading_is_an_error(ini, line, told):
    done = pycnc("linuxcnc", "ini", ini(Machine().ini.replace(line, "")))
    assert done.code == 1 and told in done.out


def test_other_kinematics_and_another_planner_are_noted(ini):
    text = Machine(traj="TPMOD = other").ini.replace("trivkins coordinates=xyz", "genserkins")
    done = pycnc("linuxcnc", "ini", ini(text), "--json")
    found = json.loads(done.out)
    assert [len(found[key]) for key in ("errors", "notes", "add")] == [0, 2, 1]


def test_a_file_that_is_not_there_is_told():
    assert pycnc("linuxcnc", "ini", "absent.ini").code != 0


def test_a_module_is_put_where_linuxcnc_looks(tmp_path):
    module = tmp_path / "built.so"
    module.write_bytes(b"module")
    assert linuxcnc.install(module, tmp_path).read_bytes() == b"module"
    with pytest.raises(errors.StateError, match="is not there"):
        linuxcnc.install(module, tmp_path / "absent")
