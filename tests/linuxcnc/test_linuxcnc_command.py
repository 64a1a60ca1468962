# SPDX-License-Identifier: MIT
"""`pycnc linuxcnc`: what a machine's owner is told, before anything runs."""

import json
import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest
from command_line import pycnc
from linuxcnc_stand_in import OWN, Machine

from pycnc import errors, linuxcnc
from pycnc.linuxcnc import configuration, package

WITHOUT_JERK = Machine().ini.replace("MAX_JERK = 10000.0\n", "")


@pytest.fixture
def ini(tmp_path):
    def write(text):
        path = tmp_path / "machine.ini"
        path.write_text(text, encoding="utf-8")
        return str(path)

    return write


@pytest.mark.parametrize(("words", "kind", "slope"), [
    ("TPMOD = nck_tp", "nck_tp", "optimal"), ("TPMOD = nck_tp planner=jerk", "nck_tp", "jerk"),
    ("TPMOD = nck_tp\nNCK_PLANNER = Linear", "nck_tp", "linear"),
    ("TPMOD = tpmod", "linuxcnc", None),
])  # fmt: skip
def test_a_machine_that_is_imported_has_the_planner_that_is_loaded(ini, words, kind, slope):
    text = Machine(traj=words).ini + "MIN_LIMIT = -100\nMAX_LIMIT = 100\n"
    done = pycnc("machine", "import", ini(text))
    data = tomllib.loads(done.out)
    assert data["control"]["kind"] == kind
    assert data.get("path", {}).get("slope") == slope


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


@pytest.mark.parametrize(("jerk", "code"), [("0", 0), ("0.0", 0), ("-1", 1), ("much", 1),
                                            ("5000 # a comment", 0)])  # fmt: skip
def test_no_jerk_is_no_error_and_a_wrong_one_is(ini, jerk, code):
    text = Machine(traj="TPMOD = nck_tp").ini.replace("MAX_JERK = 10000.0", f"MAX_JERK = {jerk}")
    done = pycnc("linuxcnc", "ini", ini(text))
    assert done.code == code
    assert ("[AXIS_X] MAX_JERK is no number above zero" in done.out) == bool(code)
    assert ("nothing to add" in done.out) != bool(code)


def test_a_short_servo_period_wants_a_build_of_its_own(ini):
    text = Machine(traj="TPMOD = nck_tp").ini
    for period_ns, noted in ((250_000, True), (1_000_000, False)):
        done = pycnc("linuxcnc", "ini", ini(f"{text}[EMCMOT]\nSERVO_PERIOD = {period_ns}\n"))
        assert ("build --short-servo" in done.out) == noted


def test_what_an_ini_file_includes_counts(ini, tmp_path):
    whole = Machine(traj="TPMOD = nck_tp").ini
    at = whole.index("[AXIS_Y]")
    (tmp_path / "axes.inc").write_text(whole[at:], encoding="utf-8")
    file = ini(whole[:at] + "#INCLUDE axes.inc\n#include axes.absent\n")
    assert "nothing to add" in pycnc("linuxcnc", "ini", file).out
    (tmp_path / "axes.inc").unlink()
    done = pycnc("linuxcnc", "ini", file)
    line = whole[:at].count("\n") + 1
    assert done.code == 1 and f"note: line {line}: #INCLUDE axes.inc: No such file" in done.out


def test_lines_that_go_on_are_one(ini):
    text = Machine(traj="TPMOD = \\\n nck_tp").ini.replace("X Y Z", "X \\\nY Z")
    assert "nothing to add" in pycnc("linuxcnc", "ini", ini(text)).out


SHIPPED = Path("/usr/share/doc/linuxcnc/examples/sample-configs")


def test_every_shipped_ini_file_is_read_with_what_it_includes():
    files = sorted(SHIPPED.rglob("*.ini")) if SHIPPED.is_dir() else []
    if not files:
        pytest.skip("linuxcnc-uspace is not installed")
    includes = 0
    for path in files:
        text = path.read_text(encoding="utf-8", errors="replace")
        whole, notes = configuration.expand(text, path.parent)
        assert not notes or path.parent.name == "ini_with_includes"  # a demonstration of mistakes
        includes += whole.count("\n") > text.count("\n")
        found = configuration.look_at(whole)
        if "[TRAJ]" in whole and not found["errors"]:
            assert found["add"], path  # none names this planner
    assert includes > 20


def test_a_debian_package_has_the_module_where_linuxcnc_looks(tmp_path):
    if not shutil.which("dpkg-deb") or not OWN.is_file():
        pytest.skip("it needs dpkg and linuxcnc-uspace")
    (tmp_path / linuxcnc.MODULE).write_bytes(b"module")
    made = package.pack(tmp_path, tmp_path)
    subprocess.run(["dpkg-deb", "-x", made, tmp_path / "root"], check=True)
    root = tmp_path / "root"
    assert (root / "usr/lib/linuxcnc/modules" / linuxcnc.MODULE).read_bytes() == b"module"
    control = subprocess.run(["dpkg-deb", "-f", made], capture_output=True, text=True).stdout
    assert "Package: nck-tp" in control and "linuxcnc-uspace (>= 2.9~)" in control
    assert (root / "usr/share/doc/nck-tp/copyright").is_file()
    assert (root / "usr/share/man/man9/nck_tp.9.gz").is_file()
    owners = subprocess.run(["dpkg-deb", "-c", made], capture_output=True, text=True).stdout
    assert all(line.split()[1] == "root/root" for line in owners.splitlines())


@pytest.mark.parametrize(("version", "series"), [
    ("2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2", ("2.9", "2.10")),
    ("1:2.10.1", ("2.10", "2.11")),
])  # fmt: skip
def test_a_package_is_for_the_series_that_it_was_built_for(version, series):
    assert package.series_of(version) == series


def test_a_package_without_a_module_is_refused(tmp_path):
    with pytest.raises(errors.AbsentError, match="pycnc linuxcnc build"):
        package.pack(tmp_path, tmp_path)


@pytest.mark.parametrize("verb", ["install", "package"])
def test_who_has_not_built_is_told_to(tmp_path, verb):
    done = pycnc("linuxcnc", verb, str(tmp_path))
    assert done.code == 2 and f"pycnc linuxcnc build {tmp_path}" in done.err
    assert "report" not in done.err


def test_who_may_not_install_is_told_what_root_is_to_say(tmp_path, monkeypatch):
    def refuse(*_):
        raise PermissionError

    monkeypatch.setattr(shutil, "copyfile", refuse)
    (tmp_path / "a b.so").touch()
    with pytest.raises(errors.AbsentError) as told:
        linuxcnc.install(tmp_path / "a b.so", tmp_path)
    assert f"sudo install -m 644 '{tmp_path}/a b.so' {tmp_path}/nck_tp.so" in str(told.value)


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
    with pytest.raises(errors.AbsentError, match="is not there"):
        linuxcnc.install(module, tmp_path / "absent")
