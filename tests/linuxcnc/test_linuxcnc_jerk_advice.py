# SPDX-License-Identifier: MIT
"""`pycnc linuxcnc jerk`: what jerk costs and buys, and the line that is recommended."""

import re

import pytest
from command_line import pycnc
from linuxcnc_stand_in import Machine

from pycnc import machine
from pycnc.linuxcnc import advice, configuration

PART = "G21 G90 G64 P0.01\n" + "".join(
    f"G1 F3000 X{7 * n} Y{5 * (n % 3)}\n" for n in range(1, 30)) + "M2\n"  # fmt: skip


@pytest.fixture
def told(tmp_path):
    """Run the verb on an INI file's text; return it, the picture and what was printed."""

    def tell(ini, *more):
        (tmp_path / "machine.ini").write_text(ini, encoding="utf-8")
        (tmp_path / "part.ngc").write_text(PART, encoding="utf-8")
        return pycnc("linuxcnc", "jerk", str(tmp_path / "machine.ini"),
                     str(tmp_path / "part.ngc"), *more)  # fmt: skip

    return tell


def rows(out):
    """Return [(jerk, time)] of the table."""
    found = re.findall(r"^\s*(\d+)\s+[\d.]+ s\s+([\d.]+) s", out, re.M)
    return [(float(jerk), float(time)) for jerk, time in found]


def test_more_jerk_takes_less_time_and_one_line_is_recommended(told, tmp_path):
    done = told(Machine().ini, "-o", str(tmp_path / "jerk.svg"))
    assert done.code == 0
    jerks, times = zip(*rows(done.out), strict=True)
    assert [1000 / jerk for jerk in jerks] == pytest.approx(advice.RAMPS_S)
    assert list(times) == sorted(times, reverse=True) and times[0] > 1.05 * times[-1]
    (line,) = re.findall(r"^MAX_LINEAR_JERK = (\d+)$", done.out, re.M)
    k = jerks.index(float(line))
    saved = [(slow - fast) / slow for slow, fast in zip(times, times[1:], strict=False)]
    assert all(each >= advice.WORTH - 1e-3 for each in saved[:k]) and saved[k] < advice.WORTH
    assert "[AXIS_X] MAX_JERK counts first" in done.out
    assert (tmp_path / "jerk.svg").read_text(encoding="utf-8").count("<svg") == 1


def test_without_a_limit_the_planner_is_linear_and_the_table_says_what_that_costs(told, tmp_path):
    told(Machine().ini)
    dense = "".join(f"G1 F6000 X{0.4 * n:.1f} Y{0.3 * (n % 2)}\n" for n in range(1, 200))
    (tmp_path / "dense.ngc").write_text(f"G21 G90 G64 P0.05\n{dense}M2\n", encoding="utf-8")
    files = [str(tmp_path / name) for name in ("machine.ini", "dense.ngc")]
    out = pycnc("linuxcnc", "jerk", *files).out
    (line,) = re.findall(r"^ *none .*", out, re.M)
    assert float(re.search(r"\+([\d.]+)%", line)[1]) > 10


def test_an_ini_file_without_a_limit_is_planned_as_the_module_does_and_advised_all_the_same(
    told, tmp_path
):
    ini = Machine(traj="TPMOD = nck_tp").ini
    table = rows(told(ini).out)
    none = ini.replace("MAX_JERK = 10000.0", "MAX_JERK = 0")
    assert rows(told(none).out) == table
    files = [str(tmp_path / name) for name in ("part.ngc", "machine.ini")]
    assert "slope linear" in pycnc("time", files[0], "-m", files[1]).out
    one = none.replace("MAX_JERK = 0", "MAX_JERK = 10000", 1)
    (tmp_path / "machine.ini").write_text(one, encoding="utf-8")
    assert "slope optimal" in pycnc("time", files[0], "-m", files[1]).out
    limits = machine.Machine.load(files[1]).limits("j_max")
    assert limits.tolist() == [10_000, 2e6, 2e6]  # 1000 mm/s² turned round within 1 ms


def test_a_program_to_which_jerk_is_all_one_is_told_what_ini_proposes(told, tmp_path):
    ini = Machine(a=4000).ini
    (tmp_path / "long.ngc").write_text("G21 G1 F600 X90\nX0\nM2\n", encoding="utf-8")
    told(ini)
    out = pycnc("linuxcnc", "jerk", str(tmp_path / "machine.ini"), str(tmp_path / "long.ngc")).out
    assert re.findall(r"^MAX_LINEAR_JERK = (\d+)$", out, re.M) == ["40000"]


def test_the_recommended_line_is_all_that_the_file_lacks(told):
    ini = Machine(traj="TPMOD = nck_tp").ini.replace("MAX_JERK = 10000.0\n", "")
    out = told(ini).out
    line = re.search(r"^MAX_LINEAR_JERK = \d+$", out, re.M)[0]
    assert "counts first" not in out
    found = configuration.look_at(ini.replace("[KINS]", f"{line}\n[KINS]"))
    assert found["add"] == {} and found["errors"] == []


def test_rotary_axes_have_a_line_of_their_own(told):
    out = told(Machine(axes="XYZA").ini).out
    linear, angular = (float(each) for each in re.findall(r"^MAX_\w+_JERK = (\d+)$", out, re.M))
    assert linear == angular  # their accelerations are


def test_inches_are_told_in_inches(told):
    ini = Machine(v=4, a=40, units="inch").ini
    assert [40 / jerk for jerk, _ in rows(told(ini).out)] == pytest.approx(advice.RAMPS_S)


@pytest.mark.parametrize(("ini", "more", "words"), [
    (Machine().ini.replace("MAX_VELOCITY = 100.0\n", ""), [], "[AXIS_X] MAX_VELOCITY is missing"),
    ("nothing", [], "error[import]"), (Machine().ini, ["-o", "x.txt"], "error[format]"),
])  # fmt: skip
def test_what_cannot_be_told_is_one_clear_error(told, ini, more, words):
    done = told(ini, *more)
    assert done.code in (1, 2) and words in done.err and "Traceback" not in done.err
