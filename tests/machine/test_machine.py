# SPDX-License-Identifier: MIT
"""Machine files: every number reaches the kernel exactly, every mistake is told at once."""

import importlib.util
import math
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest
from command_line import pycnc
from hypothesis import given
from hypothesis import strategies as st

from pycnc import load
from pycnc.kernel.bind import lib, pointer
from pycnc.kernel.records import dtype, quantity_range
from pycnc.machine import Machine, MachineFileError, shipped
from pycnc.machine.schema import AXES

DOCS = Path(__file__).resolve().parents[2] / "docs"
SMALL = """\
[axis.x]
v_max_mm_s = 100
a_max_mm_s2 = 1000
j_max_mm_s3 = 10000
"""
EVERYTHING = """\
[kernel]
period_ms = 0.5
[path]
feed_max_mm_min = 600
a_max_mm_s2 = 21
j_max_mm_s3 = 22
chord_error_mm = 0.25
tolerance_mm = 0.5
arc_radius_mm = 0.125
lookahead_blocks = 40
[axis.x]
v_max_mm_s = 11
rapid_mm_s = 10
a_max_mm_s2 = 12
j_max_mm_s3 = 13
min_mm = -1
max_mm = 2.000001
[axis.c]
v_max_deg_s = 14
a_max_deg_s2 = 15
j_max_deg_s3 = 16
[spindle]
rpm_max = 17
[dialect]
base = "marlin"
units = "inch"
plane = 19
arc_centre = "absolute"
block_skip = true
optional_stop = true
feed_default_mm_min = 18
[start]
x_mm = 1
work_system = "g59_2"
[home.g30]
c_deg = -0.5
[work.g55]
x_mm = 3
[tool.42]
length_mm = 50.5
x_mm = -1
radius_mm = 3
orientation = 7
"""


def problems(text, **options):
    """Return key → message of a machine file that is wrong."""
    with pytest.raises(MachineFileError) as caught:
        Machine.load(Machine.from_text(text), **options)
    return dict(caught.value.problems)


# The shipped machines


def test_the_promised_machines_are_shipped():
    assert {
        "cak6150n", "cao2014", "haas_vf2", "laser", "lathe_fanuc", "mill3", "mill4",
        "mill5_xyzac", "printer", "printer_klipper", "printer_marlin", "router",
    } <= set(shipped())  # fmt: skip


@pytest.mark.parametrize("name", shipped())
def test_a_shipped_machine_is_good_and_described(name):
    machine = Machine.load(name)
    assert machine.settings.description
    assert machine.period_s == 1e-3


@pytest.mark.parametrize(
    ("name", "tolerance"),
    [("mill3", 0.01), ("mill5_xyzac", 0.01), ("cak6150n", 0.005), ("lathe_fanuc", 0.005),
     ("printer", 0.05)],
)
def test_a_shipped_machine_limits_jerk_and_rounds_corners(name, tolerance):
    machine = Machine.load(name)
    assert machine.settings.path.slope == "optimal"
    assert machine.record["path"]["tolerance"] == tolerance
    ramp_s = machine.limits("a_max") / machine.limits("j_max")
    assert ((ramp_s >= 0.01) & (ramp_s <= 0.1)).all(), "full acceleration within 10 to 100 ms"


def test_the_experiment_is_acceleration_limited_on_the_exact_path():
    path = Machine.load("cao2014").settings.path
    assert (path.slope, path.tolerance_mm) == ("linear", 0)


def test_a_file_that_says_nothing_has_the_defaults_of_the_kernel():
    record, kernel = Machine.from_text(SMALL).record, np.zeros(1, dtype("nck_machine_t"))
    lib.nck_machine_default(pointer("nck_machine_t", kernel))
    for name in ("period_s", "slope", "kinematics", "lookahead_blocks"):
        assert record[name] == kernel[0][name], name
    for name in ("chord_error", "tolerance", "arc_radius"):
        assert record["path"][name] == kernel[0]["path"][name], name
    assert kernel[0]["dialect"]["probe"] == lib.NCK_PROBE_REFUSED  # a machine that moves
    kernel[0]["dialect"]["probe"] = lib.NCK_PROBE_MISSES  # a simulation
    assert record["dialect"] == kernel[0]["dialect"]


def test_the_lathe_has_rapids_of_15_m_per_minute_and_programs_diameters():
    record = Machine.load("cak6150n").record
    x, z = AXES.index("x"), AXES.index("z")
    assert record["axis"]["rapid"][[x, z]].tolist() == [15000 / 60, 15000 / 60]
    assert record["dialect"]["diameter"] == 1
    assert record["dialect"]["plane"] == 18


def test_a_fanuc_lathe_is_switched_on_per_revolution_in_diameters_and_in_system_a():
    text = "G50 S3000\nT0202\nG97 S1200 M3\nG21\nG0 X40. Z2.\nG1 Z-20. F.25\nX50.\nG28 U0 W0\nM30\n"
    program = load(text.encode(), Machine.load("lathe_fanuc"))
    assert list(program.diagnostics) == []
    places = [AXES.index("x"), AXES.index("z")]
    cut, rapid = (program.blocks[program.blocks["kind"] == kind]
                  for kind in (lib.NCK_BLOCK_LINE, lib.NCK_BLOCK_RAPID))  # fmt: skip
    assert set(cut["feed_mode"]) == {lib.NCK_FEED_PER_REV} and set(cut["feed"]) == {0.25}
    assert cut["target_nm"][:, places].tolist() == [[20e6, 180e6], [25e6, 180e6]]
    assert rapid["target_nm"][-1, places].tolist() == [240e6, 850e6]


def test_the_experiment_has_the_numbers_of_its_paper():
    machine = Machine.load("cao2014")
    assert machine.record["path"]["feed_max"] == 500 / 60
    assert machine.record["path"]["a_max"] == 25
    assert machine.axes == "xy"
    centripetal = (500 / 60) ** 2 / 1.5  # on the smallest arc of the illustration
    assert machine.limits("a_max").min() > 25 + centripetal


# From decimal text to the kernel's numbers


@given(st.decimals(-(10**6), 10**6, places=9))
def test_a_position_is_rounded_half_even_to_the_nanometre(value):
    machine = Machine.from_text(f"{SMALL}[work.g54]\nx_mm = {value:f}\n")
    exact = value.scaleb(6)
    got = Decimal(int(machine.record["work_nm"][0][0]))
    assert abs(got - exact) <= Decimal("0.5")
    if abs(got - exact) == Decimal("0.5"):
        assert got % 2 == 0


def test_every_setting_reaches_its_field():
    record = Machine.from_text(EVERYTHING).record
    x, c = record["axis"][0], record["axis"][AXES.index("c")]
    assert record["period_s"] == 0.0005
    assert record["path"].tolist()[:3] == (10.0, 21.0, 22.0)
    assert [record["path"][k] for k in ("chord_error", "tolerance", "arc_radius")] == [
        0.25, 0.5, 0.125,
    ]  # fmt: skip
    assert record["lookahead_blocks"] == 40
    assert [x[k] for k in ("v_max", "rapid", "a_max", "j_max")] == [11, 10, 12, 13]
    assert (x["min_nm"], x["max_nm"], x["rotary"]) == (-1_000_000, 2_000_001, 0)
    assert [c[k] for k in ("v_max", "rapid", "a_max", "j_max")] == [14, 14, 15, 16]
    assert (c["min_nm"], c["max_nm"], c["rotary"]) == (-(2**63), 2**63 - 1, 1)
    assert record["spindle"]["rpm_max"] == 17
    flags = ("base", "inch", "plane", "arc_absolute", "block_skip", "optional_stop")
    assert [int(record["dialect"][k]) for k in flags] == [3, 1, 19, 1, 1, 1]
    assert record["dialect"]["feed_default"] == 18
    assert record["start_nm"][0] == 1_000_000
    assert record["work_system"] == 7
    assert record["home_nm"][1][AXES.index("c")] == -500_000_000
    assert record["work_nm"][1][0] == 3_000_000
    tool = record["tool"][0]
    assert (record["tool_count"], tool["number"], tool["orientation"]) == (1, 42, 7)
    assert tool["offset_nm"].tolist() == [-1_000_000, 0, 50_500_000]
    assert tool["radius_mm"] == 3


def test_path_limits_that_are_left_out_never_bind():
    machine = Machine.from_text(SMALL + SMALL.replace("axis.x", "axis.y"))
    assert machine.record["path"]["a_max"] == pytest.approx(1000 * math.sqrt(2))
    assert machine.record["path"]["feed_max"] == pytest.approx(100 * math.sqrt(2))


def test_equal_settings_have_equal_hashes_and_others_do_not():
    one = Machine.from_text(SMALL)
    same = Machine.from_text("# a comment\n" + SMALL.replace("100\n", "100.0\n", 1))
    other = Machine.load(one, set={"axis.x.v_max_mm_s": 101})
    assert one.sha256 == same.sha256 != other.sha256


# Ranges

QUANTITIES = {
    "kernel.period_ms": ("period", 1000), "path.feed_max_mm_min": ("speed", 60),
    "path.a_max_mm_s2": ("acceleration", 1), "path.j_max_mm_s3": ("jerk", 1),
    "path.chord_error_mm": ("error", 1), "path.tolerance_mm": ("size", 1),
    "path.arc_radius_mm": ("error", 1), "axis.x.v_max_mm_s": ("speed", 1),
    "axis.x.rapid_mm_s": ("speed", 1), "axis.x.a_max_mm_s2": ("acceleration", 1),
    "axis.x.j_max_mm_s3": ("jerk", 1), "axis.c.v_max_deg_s": ("speed", 1),
    "axis.c.a_max_deg_s2": ("acceleration", 1), "axis.c.j_max_deg_s3": ("jerk", 1),
    "axis.c.rapid_deg_s": ("speed", 1), "spindle.rpm_max": ("rotation", 1),
    "dialect.feed_default_mm_min": ("feed", 1), "tool.42.radius_mm": ("size", 1),
}  # fmt: skip


@pytest.mark.parametrize("end", [0, 1])
def test_the_file_takes_what_the_kernel_takes(end):
    ends = {key: quantity_range(name)[end] * units for key, (name, units) in QUANTITIES.items()}
    machine = Machine.load(Machine.from_text(EVERYTHING), set=ends)
    assert lib.nck_machine_check(machine.pointer) == lib.NCK_OK


@pytest.mark.parametrize("key", QUANTITIES)
def test_what_the_kernel_refuses_is_told_with_its_key(key):
    name, units = QUANTITIES[key]
    low, high = (end * units for end in quantity_range(name))
    for value, words in ((low - Decimal("1e-12"), "at least"), (high + 1, "at most")):
        assert words in problems(EVERYTHING, set={key: value})[key]


# Mistakes


@pytest.mark.parametrize(
    ("line", "key", "words"),
    [
        ("v_max = 3", "axis.x.v_max", "v_max_mm_s"),
        ("v_max_deg_s = 3", "axis.x.v_max_deg_s", "did you mean v_max_mm_s"),
        ("rapid_mm_s = -5", "axis.x.rapid_mm_s", "0.000001 at least (is -5)"),
        ("[path]\nj_max_mm_s3 = 2.3e12", "path.j_max_mm_s3", "1000000000000 at most"),
        ("[path]\na_max_mm_s2 = 2.2e-308", "path.a_max_mm_s2", "0.001 at least"),
        ("rapid_mm_s = nan", "axis.x.rapid_mm_s", "finite"),
        ("rapid_mm_s = inf", "axis.x.rapid_mm_s", "finite"),
        ("rapid_mm_s = 200", "axis.x.rapid_mm_s", "v_max_mm_s = 100"),
        ("rapid_mm_s = true", "axis.x.rapid_mm_s", "a number"),
        ('min_mm = "left"', "axis.x.min_mm", "a number"),
        ("min_mm = 5\nmax_mm = 5", "axis.x.min_mm", "below max_mm"),
        ("min_mm = 5", "start.x_mm", "within the travel 5 … free (is 0"),
        ('[path]\nslope = "round"', "path.slope", "'linear', 'jerk' or 'optimal' (is 'round')"),
        ('[path]\nslope = "sshape"', "path.slope", "planning, pycnc lab time --plan sshape"),
        ("[path]\nlookahead_blocks = 1", "path.lookahead_blocks", "2 at least"),
        ("[path]\nlookahead_blocks = 1.5", "path.lookahead_blocks", "whole number"),
        ("[path]\nlookahead_blocks = 99999999", "path.lookahead_blocks", "at most"),
        ("[kernel]\nperiod_ms = 0", "kernel.period_ms", "0.01"),
        ("[axis.a]\nv_max_deg_s = 1", "axis.a.a_max_deg_s2", "missing"),
        ("[axis.q]\nv_max_mm_s = 1", "axis.q", "unknown key"),
        ('[kinematics]\ntype = "lathe_xz"', "kinematics.type", "X and Z"),
        ('[dialect]\nbase = "heidenhain"', "dialect.base", "linuxcnc"),
        ("[dialect]\ndiameter = 1", "dialect.diameter", "true or false"),
        ("[work.g54]\ny_mm = 1", "work.g54.y_mm", "no Y axis"),
        ("[work.g60]\nx_mm = 1", "work.g60", "unknown key"),
        ("[tool.T1]\nradius_mm = 1", "tool.T1", "number"),
        ("[tool.1]\nradius_mm = -1", "tool.1.radius_mm", "0 at least"),
        ("[tool.1]\nlength = 1", "tool.1.length", "length_mm"),
        ("[colour]\nred = 1", "colour", "unknown key"),
        ('[m.M8]\naction = "wait"', "m.M8", "its number"),
        ('[m.8]\naction = "wait"', "m.8", "executes itself"),
        ('[m.1000]\naction = "wait"', "m.1000", "999 at most"),
        ("[m.88]\nwaits = true", "m.88.waits", "allowed: action"),
    ],
)
def test_a_mistake_is_told_with_its_key_and_what_is_allowed(line, key, words):
    found = problems(SMALL + line + "\n")
    assert words in found[key]


def test_all_mistakes_are_told_at_once():
    found = problems("[axis.x]\nv_max_mm_s = -1\nspeed = 3\n[path]\nslope = 7\n[foo]\n")
    assert set(found) == {
        "axis.x.v_max_mm_s", "axis.x.a_max_mm_s2", "axis.x.j_max_mm_s3", "axis.x.speed",
        "path.slope", "foo",
    }  # fmt: skip


@pytest.mark.parametrize("text", ["", "[axis]\n", "axis = 3\n", "[[[\n", "x = 1e999999999999\n"])
def test_a_file_without_a_machine_is_refused(text):
    with pytest.raises(MachineFileError):
        Machine.from_text(text)


@given(st.text())
def test_any_text_is_a_machine_or_a_list_of_problems(text):
    try:
        Machine.from_text(text)
    except MachineFileError as cause:
        assert cause.problems


# Changes


def test_a_change_wins_over_the_file_and_says_so():
    machine = Machine.load("mill3", set=["axis.x.max_mm=400.5", "axis.y.max_mm=free"])
    values = {key: (value, source) for key, value, source in machine.effective()}
    assert values["axis.x.max_mm"] == (Decimal("400.5"), "--set")
    assert values["axis.y.max_mm"] == (None, "--set")
    assert values["axis.x.min_mm"] == (Decimal(-300), "file")
    assert values["path.lookahead_blocks"] == (0, "default")
    assert machine.record["axis"]["max_nm"][0] == 400_500_000


def test_changes_add_up_from_machine_to_machine():
    first = Machine.load("mill3", set={"axis.x.max_mm": 400})
    second = Machine.load(first, set={"axis.y.max_mm": 500}, dialect="grbl")
    assert second.record["axis"]["max_nm"][:2].tolist() == [400_000_000, 500_000_000]
    assert second.settings.dialect.base == "grbl"


@pytest.mark.parametrize("change", ["axis.x.max_mm", "=5", "axis.x.max_mm.deep=5", "axis=5", "=="])
def test_a_change_that_makes_no_sense_is_refused(change):
    with pytest.raises(MachineFileError):
        Machine.load("mill3", set=[change])


@pytest.mark.parametrize(
    ("change", "place", "words"),
    [
        ("axis.x.amax=5", "--set axis.x.amax=5", "unknown key; did you mean a_max_mm_s2?"),
        ("axis.x.jmax=5", "--set axis.x.jmax=5", "did you mean j_max_mm_s3?"),
        ("axs.x.amax=5", "--set axs.x.amax=5", "axs: unknown key; did you mean axis?"),
        ("axis.q.v=5", "--set axis.q.v=5", "axis.q: unknown key; allowed: x, y, z"),
        ("path.slope=jrek", "--set path.slope=jrek", "'jrek'"),
        ("axis.z.max_mm=13", "mill3.toml with --set axis.z.max_mm=13", "home.g28.z_mm: must be"),
        ("axis.a.v_max_deg_s=9", "mill3.toml with --set axis.a.v_max_deg_s=9", "is missing"),
    ],
)
def test_a_change_is_blamed_for_what_it_breaks(change, place, words):
    with pytest.raises(MachineFileError) as caught:
        Machine.load("mill3", set=["path.tolerance_mm=0.5", change])
    line = str(caught.value).splitlines()[0]
    assert words in line
    if place.startswith("--set"):
        assert line.startswith(f"{place}: error[machine]: ")
    else:
        named = place.replace("with --set ", "with --set path.tolerance_mm=0.5, ")
        assert f"{named}: error[machine]: " in line


def test_a_mistake_of_the_file_is_blamed_on_the_file_whatever_is_changed(tmp_path):
    file = tmp_path / "small.toml"
    file.write_text(f"{SMALL}speed = 3\n")
    with pytest.raises(MachineFileError) as caught:
        Machine.load(file, set=["path.tolerance_mm=0.5", "axis.x.amax=3"])
    places = dict(zip(dict(caught.value.problems), caught.value.places, strict=True))
    assert places == {"axis.x.speed": str(file), "axis.x.amax": "--set axis.x.amax=3"}


def test_a_tool_table_is_read_in_mm_with_diameters(tmp_path):
    table = tmp_path / "tool.tbl"
    table.write_text("T1 P1 Z51.25 D6 ;end mill\n\nT7 P2 X-1.5 Z0.1 D0.8 Q3 I10 J95\n")
    machine = Machine.load("mill3", tools=table)
    tools = {int(t["number"]): t for t in machine.record["tool"][: machine.record["tool_count"]]}
    assert tools[1]["offset_nm"].tolist() == [0, 0, 51_250_000]
    assert tools[1]["radius_mm"] == 3
    assert tools[7]["offset_nm"].tolist() == [-1_500_000, 0, 100_000]
    assert tools[7]["orientation"] == 3


@pytest.mark.parametrize("text", ["", "hello\n", "Z5\n", "T1 Z5\nT1 Z6\n", "T1.5 Z1\n", "T1 Zx\n"])
def test_a_tool_table_that_is_wrong_is_refused(text, tmp_path):
    table = tmp_path / "tool.tbl"
    table.write_text(text)
    with pytest.raises(MachineFileError):
        Machine.load("mill3", tools=table)


# The command line


def test_the_effective_settings_are_a_machine_file_themselves():
    shown = pycnc("machine", "show", "mill5_xyzac", "--effective", "--set", "axis.x.max_mm=310")
    again = Machine.from_text(shown.out)
    assert again.sha256 == Machine.load("mill5_xyzac", set={"axis.x.max_mm": 310}).sha256
    assert "max_mm = 310" in shown.out
    assert shown.out.count("# --set") == 1


def test_validate_tells_every_problem_and_exits_2(tmp_path):
    file = tmp_path / "bad.toml"
    file.write_text("[axis.x]\nv_max_mm_s = -1\n")
    result = pycnc("machine", "validate", file, "mill3")
    assert result.code == 2
    assert result.out.count(f"{file}: error[machine]: axis.x.") == 3
    assert "mill3.toml: good" in result.out


# The page


def test_the_pages_say_what_the_code_does():
    spec = importlib.util.spec_from_file_location("make_pages", DOCS / "make_pages.py")
    make_pages = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(make_pages)
    for name, page in make_pages.PAGES.items():
        assert (DOCS / name).read_text(encoding="utf-8") == page(), (
            f"run docs/make_pages.py: {name}"
        )
