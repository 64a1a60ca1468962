# SPDX-License-Identifier: MIT
"""``pycnc why``: what time is lost to, on which lines, and what a cure gains."""

import csv
import json
import math
import re

import numpy as np
import pytest
from cases import CORPUS, FAMILIES
from command_line import pycnc

import pycnc as package
from pycnc import load, run, why
from pycnc.machine import Machine
from pycnc.planning import feeds, measure
from pycnc.planning import why as planning_why
from pycnc.planning.plan import Plan
from pycnc.program import Program
from pycnc.report import summary

EXACT = {"path.tolerance_mm": 0}
JERK = {"path.slope": "jerk"}


def circle(turns=12, radius=5.0, points=100):
    """Return a program of chords with equal small angles between them."""
    lines = ["G21 G90 G17", "G1 F3000"]
    for k in range(turns * points + 1):
        angle = 2 * math.pi * k / points
        lines.append(f"X{radius * math.cos(angle) - radius:.6f} Y{radius * math.sin(angle):.6f}")
    return "\n".join([*lines, "M2", ""])


def cause_of(found, name):
    return next(cause for cause in found.causes if cause["cause"] == name)


@pytest.mark.parametrize("slope", ["jerk", "linear", "optimal"])
@pytest.mark.parametrize("tolerance", [0, 0.01])
@pytest.mark.parametrize("family", FAMILIES)
def test_ideal_and_causes_add_up_to_the_time(slope, tolerance, family):
    make, count = FAMILIES[family]
    text = make(np.random.default_rng(7), count // 2)
    machine = Machine.load("mill3", set={"path.slope": slope, "path.tolerance_mm": tolerance})
    found = why(text, machine)
    total = found.ideal_s + math.fsum(cause["lost_s"] for cause in found.causes)
    assert total == pytest.approx(found.time_s, abs=1e-9)
    assert math.fsum(found.plan.totals["limit_time_s"].values()) == pytest.approx(
        found.time_s, abs=1e-9
    )
    assert min(cause["lost_s"] for cause in found.causes) > -1e-6
    assert found.time_s == Plan(found.program, keep=False).time_s


def test_many_small_corners_are_one_row_and_come_first():
    found = why(circle(), Machine.load("mill3", set=EXACT))
    worst = found.causes[0]
    assert worst["words"] == "corners of 3.6°, acceleration"
    assert worst["share"] > 0.2
    assert worst["count"] > 1100
    assert [len(worst["places"]), worst["places"][0]["line_first"] <= 10] == [1, True]
    assert worst["places"][0]["count"] == worst["count"]
    limits = found.plan.totals["limit_time_s"]
    assert max(limits, key=limits.get) == "corner"
    assert limits["jerk"] == limits["accel"] == 0


def test_the_gain_of_a_cure_is_that_of_a_plan_with_it():
    machine = Machine.load("mill3", set=EXACT | JERK)
    found = why(circle(turns=2), machine, what_if=True)
    gains = {cure["cure"]: cure["gain_s"] for cure in found.cures}
    changed = Machine.load("mill3", set={**EXACT, "path.tolerance_mm": "0.01"} | EXACT | JERK)
    assert changed.settings == machine.settings
    within = Plan(load(circle(turns=2), Machine.load("mill3")), keep=False).time_s
    assert gains["slope optimal within 0.01 mm"] == pytest.approx(found.time_s - within, abs=1e-12)
    assert gains["acceleration x 2"] > 0.5 * found.causes[0]["lost_s"]
    assert {"jerk of X x 2", "speed of Z x 2", "acceleration of Y x 2"} <= set(gains)
    assert [cure["gain_s"] for cure in found.cures] == sorted(gains.values(), reverse=True)


def test_a_ramp_belongs_to_the_low_point_that_it_serves():
    text = "G21 G90 G17\nG1 X50 F6000\nX100 F600\nX150 F6000\nG4 P0.5\nX200\nM2\n"
    found = why(text, Machine.load("mill3", set=EXACT), "linear")
    machine = Machine.load("mill3")
    fast, slow, a = 100.0, 10.0, float(machine.settings.axis.x.a_max_mm_s2)
    ramp = (fast - slow) ** 2 / (2 * a * fast)  # lost on a ramp between the two feeds
    feed = cause_of(found, "feed")
    assert feed["lost_s"] == pytest.approx(2 * ramp, rel=0.02)
    assert {place["line_worst"] for place in feed["places"]} == {3}, "the slower feed's line"
    stop = fast / (2 * a)
    assert cause_of(found, "dwell")["lost_s"] == pytest.approx(2 * stop, rel=0.03)
    assert cause_of(found, "ends")["lost_s"] == pytest.approx(2 * stop, rel=0.03)
    assert found.as_dict()["ideal"]["dwell_s"] == pytest.approx(0.5, abs=1e-3)


def test_an_arc_loses_what_its_own_cap_costs():
    text = "G21 G90 G17 G61\nG1 X50 F6000\nG3 X50 Y4 J2\nG1 X0\nM2\n"
    found = why(text, "mill3", "linear")
    arc = cause_of(found, "curvature")
    assert arc["places"][0]["line_worst"] == 3
    radius, a = 2, float(Machine.load("mill3").settings.axis.x.a_max_mm_s2)
    at_cap = math.pi * radius / math.sqrt(0.8 * a * radius) - math.pi * radius / 100
    assert arc["lost_s"] > at_cap


def test_stops_that_the_program_asks_for_are_told_and_their_cure_too():
    text = "G21 G90 G17 G61.1 (G61.1 here is a comment)\nG1 F3000 X20\nX40\nG9 X60\nX80\nM2\n"
    found = why(text, what_if=True)
    gains = {cure["cure"]: cure["gain_s"] for cure in found.cures}
    stops = cause_of(found, "exact_stop")
    assert stops["count"] == 3
    assert gains["without G61.1 and G9"] == pytest.approx(stops["lost_s"], rel=0.1)


def test_the_axis_that_holds_is_told():
    text = "G21 G90 G17\nG1 F3000 X30\nZ20\nX60\nM2\n"
    found = why(text, Machine.load("mill3", set={**EXACT, "axis.z.a_max_mm_s2": 100}))
    corner = cause_of(found, "corner")
    assert (corner["axis"], corner["angle_deg"]) == ("z", pytest.approx([90, 90]))
    assert corner["places"][0]["axis"] == "z"


def zigzag(teeth, wide, high):
    """Return a program of strokes to and fro."""
    ways = "\n".join(f"G1 X{wide * k} Y{high * (k % 2)}" for k in range(1, teeth + 1))
    return f"G21 G90 G17 G64 P0.01\nF6000\n{ways}\nM2\n"


@pytest.mark.parametrize("seed", range(6))
def test_bends_of_a_clocked_path_are_its_low_points(seed):
    rng = np.random.default_rng([33, seed])
    teeth, wide, high = int(rng.integers(4, 12)), rng.uniform(0.2, 6), rng.uniform(10, 30)
    found = why(zigzag(teeth, round(wide, 3), round(high, 3)), "mill3", "optimal")
    bends = [each for each in found.causes if each["cause"] in ("jerk", "curvature")]
    assert sum(each["count"] for each in bends) == teeth - 1
    lines = {place["line_worst"] for each in bends for place in each["places"]}
    assert lines <= set(range(3, 3 + teeth))
    assert {each["axis"] for each in bends} <= {"x", "y"}
    ends = cause_of(found, "ends")
    assert math.fsum(each["lost_s"] for each in (*bends, ends)) == pytest.approx(
        found.time_s - found.ideal_s, rel=0.05
    )


def test_what_holds_a_clocked_path_has_its_name():
    slow_x = {"axis.x.v_max_mm_s": 20, "axis.x.rapid_mm_s": 20}
    text = "G21 G90 G17 G64 P0.01 F6000\nG1 X40 Y1\nX80\nM2\n"
    limits = run(text, Machine.load("mill3", set=slow_x), slope="optimal").summary["limit_time_s"]
    assert max(limits, key=limits.get) == "axis_v:x"
    limits = run(text.replace("F6000", "F600"), "mill3", slope="optimal").summary["limit_time_s"]
    assert max(limits, key=limits.get) == "feed"
    assert limits["feed"] > 0.9 * sum(limits.values())
    assert limits["lookahead"] == 0


def test_where_smoothing_begins_and_ends_is_no_dwell_and_no_corner():
    text = "G21 G90 G17 F6000\nG64 P0.01 G1 X40\nX80\nG61 X120\nX160\nG64 P0.01 X200\nM2\n"
    found = why(text, "mill3", "optimal")
    mode = cause_of(found, "mode")
    assert mode["words"] == "stops where smoothing begins or ends"
    assert (mode["places"][0]["line_first"], mode["places"][0]["line_last"]) == (4, 6)
    assert {each["cause"] for each in found.causes if each["lost_s"] > 1e-6} <= {"ends", "mode"}
    limits = found.plan.totals["limit_time_s"]
    assert limits["mode"] > mode["lost_s"] > 0 == limits["dwell"]


def drawn_program(rng, bends, rests):
    """Return lines with path modes, feeds and rapids at random, and bends or rests if asked."""
    x, y, lines = 0.0, 0.0, ["G21 G90 G17 G94 F3000 S100 M3"]
    for _ in range(int(rng.integers(5, 40))):
        if rng.random() < 0.3:
            modes = ["G61", "G64", "G64 P0.01", "G64 P0.1", "S200", "M8", "F500", "F6000"]
            lines.append(str(rng.choice(modes)))
        if rests and rng.random() < 0.2:
            lines.append(str(rng.choice(["G4 P0.1", "G4 P0"])))
        x += rng.uniform(0.01, 7)
        y += rng.uniform(-10, 10) if bends else 0.0
        lines.append(f"G{rng.integers(0, 2)} X{x:.3f} Y{y:.3f}")
    return "\n".join([*lines, "M2", ""])


@pytest.mark.sample(12)
@pytest.mark.parametrize("seed", range(400))
def test_no_cause_is_told_that_the_program_does_not_have(seed):
    rng = np.random.default_rng([71, seed])
    bends, rests = rng.random(2) < 0.5
    text = drawn_program(rng, bends, rests)
    slope = str(rng.choice(["linear", "jerk", "optimal"]))
    tolerance = float(rng.choice([0, 0.01]))
    machine = Machine.load("mill3", set={"path.slope": slope, "path.tolerance_mm": tolerance})
    found = why(text, machine)
    told = {each["cause"] for each in found.causes}
    assert bends or not told & {"corner", "exact_stop", "curvature"}
    assert "G4" in text or "dwell" not in told
    assert ("G4 P0.1" in text) <= (found.plan.totals["limit_time_s"]["dwell"] > 0) <= ("G4" in text)
    assert "mode" not in told or slope == "optimal"


def test_far_places_are_apart_and_the_worst_comes_first():
    straight = "\n".join(f"G1 X{k}" for k in range(100, 160))
    text = f"G21 G90 G17\nG1 F3000\nX50\nY10\n{straight}\nY60\nX0\nY0\nM2\n"
    places = cause_of(why(text, Machine.load("mill3", set=EXACT)), "corner")["places"]
    assert [place["lost_s"] for place in places] == sorted(
        (place["lost_s"] for place in places), reverse=True
    )
    spans = sorted((place["line_first"], place["line_last"]) for place in places)
    assert spans == [(4, 5), (65, 67)]


def test_a_run_tells_the_limits_as_the_plan_does_if_nobody_interferes():
    machine, text = Machine.load("mill3", set=EXACT), circle(turns=2)
    planned = Plan(load(text, machine), keep=False).totals["limit_time_s"]
    done = run(text, machine)
    assert done.summary["limit_time_s"] == pytest.approx(planned, abs=1e-9)
    assert done.worst_lines["corner"]
    held = run(text, machine, commands=[(200, "hold"), (900, "resume")]).summary
    assert sum(held["limit_time_s"].values()) == pytest.approx(held["time_s"])


def test_memory_does_not_grow_with_the_program():
    found = why(circle(turns=30), Machine.load("mill3", set=EXACT))
    assert max(len(cause["places"]) for cause in found.causes) <= 8
    rows = found.rows()
    assert math.fsum(row["lost_s"] for row in rows) == pytest.approx(
        found.time_s - found.ideal_s, abs=1e-5
    )


def test_pushed_blocks_are_explained_too():
    program = package.Program.from_points([[0, 0], [40, 0], [40, 40]], 3000, tolerance=0)
    corner = cause_of(why(program), "corner")
    assert (corner["count"], corner["places"][0]["line_worst"]) == (1, 3)


def test_the_trochoidal_path_loses_its_time_at_its_vertices():
    if not (CORPUS / "tp_trochoidal.ngc").exists():
        pytest.skip("the corpus is not here")
    found = why(CORPUS / "tp_trochoidal.ngc", Machine.load("mill3", set=EXACT), "jerk")
    worst = found.causes[0]
    assert worst["words"] == "corners of 3.5°, acceleration"
    assert worst["lost_s"] / (found.time_s - found.ideal_s) > 0.9
    assert worst["count"] > 10_000
    total = found.ideal_s + math.fsum(cause["lost_s"] for cause in found.causes)
    assert total == pytest.approx(found.time_s, abs=1e-9)


def test_every_limit_has_its_words():
    names = set(measure.limit_names(Machine.load("mill3")).values())
    assert all(summary.limit_words(name) for name in names)
    told = {"accel", "starved", "corner"} | {name for name in names if ":" in name}
    assert names - told == set(planning_why.WORDS), "what a low point may be held by"


def test_a_plan_explains_itself_and_one_by_grades_does_not():
    program = load(circle(turns=1), Machine.load("mill3", set=EXACT))
    assert package.plan(program).why().causes == why(program).causes
    with pytest.raises(package.ArgumentError, match="only an exact plan is explained"):
        package.plan(program, plan="grades").why()


# The command


def test_the_table_has_units_and_the_worst_first(tmp_path):
    file, table = tmp_path / "part.ngc", tmp_path / "why.csv"
    file.write_text(circle(turns=2))
    options = ["why", file, "--set", "path.tolerance_mm=0", "-q"]
    result = pycnc(*options, "--what-if", "-o", table)
    head, sums, names, first, *_ = result.out.splitlines()
    assert head.startswith(f"{file} on mill3, slope ")
    assert re.fullmatch("  ideal time [0-9.]+ s · lost [0-9.]+ s", sums)
    assert names.split() == ["lost", "share", "to", "places", "lines", "worst", "at", "line"]
    assert " s  " in first and "corners of 3.6°, acceleration" in first and "(" in first
    assert "what if" in result.out and "within 0.01 mm" in result.out
    told = json.loads(pycnc(*options, "--json").out)
    assert told["what_if"] == []
    assert told["causes"][0]["cause"] == "corner"
    total = told["ideal_s"] + math.fsum(cause["lost_s"] for cause in told["causes"])
    assert total == pytest.approx(told["time_s"], abs=1e-9)
    with table.open(newline="") as lines:
        rows = list(csv.DictReader(lines))
    assert float(rows[0]["lost_s"]) == pytest.approx(told["causes"][0]["lost_s"])


PART = b"G21 G90 G61\nT1 M6\nG1 X10 F6000\nY10\nX50\nM2\n"


def test_what_if_buys_what_the_same_change_by_set_does(tmp_path):
    file = tmp_path / "part.ngc"
    file.write_bytes(PART)
    changes = ["path.slope=linear", "control.kind=klipper", "times.tool_change_s=9"]
    asked = [word for change in changes for word in ("--what-if", change)]
    told = json.loads(pycnc("why", file, "--json", *asked).out)
    assert sorted(cure["cure"] for cure in told["what_if"]) == sorted(changes)
    for cure in told["what_if"]:
        own = json.loads(pycnc("why", file, "--json", "--set", cure["cure"]).out)
        assert (cure["time_s"], cure["total_s"]) == (own["time_s"], own["total_s"])
        assert cure["gain_s"] == pytest.approx(told["total_s"] - own["total_s"], abs=1e-12)
    *_, worst = pycnc("why", file, *asked).out.splitlines()
    assert worst.split() == ["9.870", "s", "-1.000", "s", "times.tool_change_s=9"]


def test_what_if_may_stand_before_the_file_and_beside_its_cures(tmp_path):
    file = tmp_path / "part.ngc"
    file.write_bytes(PART)
    bare = [cure["cure"] for cure in json.loads(
        pycnc("why", "--what-if", file, "--json").out)["what_if"]]  # fmt: skip
    both = [cure["cure"] for cure in json.loads(pycnc(
        "why", "--what-if", "path.slope=linear", "--what-if", file, "--json").out)["what_if"]]
    assert len(bare) > 8 and sorted(both) == sorted([*bare, "path.slope=linear"])
    assert why(PART, what_if=["path.slope=linear"]).cures[0]["gain_s"] > 0.1


@pytest.mark.parametrize(
    ("change", "code", "words"),
    [
        ("axis.x.a=2000", 2, "--what-if axis.x.a=2000: error[machine]: axis.x.a: unknown key"),
        ("control.kind=cnc", 2, "--what-if control.kind=cnc: error[machine]: control.kind: must"),
        ("=3", 2, "--what-if =3: error[machine]"),
        ("axis.x.max_mm=5", 1, "--what-if axis.x.max_mm=5: <stdin>:3:4: error[travel]"),
        ("description=a", 0, "--what-if description=a: warning[no-effect]: only lists"),
    ],
)
def test_a_change_that_cannot_be_tried_is_told_with_its_place(change, code, words):
    result = pycnc("why", "-", "--what-if", change, stdin=PART)
    assert (result.code, words in result.err) == (code, True)


def test_a_data_frame_has_a_row_a_place():
    frame = why(circle(turns=2), Machine.load("mill3", set=EXACT)).to_pandas()
    assert list(frame.columns)[:3] == ["cause", "words", "lost_s"]
    assert frame["cause"][0] == "corner"


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (["missing.ngc"], 2, "error[file]"),
        (["-", "-o", "table.xlsx"], 2, "error[format]"),
        (["-", "-o", "/nowhere/table.csv"], 2, "cannot write it"),
    ],
)
def test_bad_calls_have_one_clear_error(arguments, code, words):
    result = pycnc("why", *arguments, stdin=b"G21 G90\nG1 X10 F600\nM2\n")
    assert (result.code, words in result.err) == (code, True)
    assert pycnc("why", "-", stdin=b"G21 G90\nG1 Q1 F600\nM2\n").code == 1


# What the ideal time goes to

SLOW = "G21 G90 G17\nG1 F1200 X60\nY40\nX0\n{}\nG1 F1200 Y5\nX50\nM2\n"


@pytest.mark.parametrize("slope", ["jerk", "linear", "optimal"])
def test_a_slow_feed_of_a_few_lines_is_named(slope, tmp_path):
    file = tmp_path / "part.ngc"
    file.write_text(SLOW.format("Z-0.8 F80\nG2 X2 Y40 I1"))
    told = pycnc("why", file, "--json", "--slope", slope)
    (feed,) = json.loads(told.out)["slow_feeds"]
    length = 0.8 + math.pi
    assert feed["length_mm"] == pytest.approx(length, rel=1e-9)
    assert (feed["feed_mm_min"], feed["time_s"]) == pytest.approx((80, length / 80 * 60))
    assert feed["over_s"] == pytest.approx(length * 60 * (1 / 80 - 1 / 1200), rel=1e-9)
    assert (feed["moves"], feed["line_first"], feed["line_last"]) == (2, 5, 6)
    for verb in ("why", "look", "run"):
        words = "2.956 s of the ideal time at a feed of 80 mm/min: 3.94 mm in 2 moves on lines 5-6"
        assert f"\n  {words}\n" in pycnc(verb, file, "--slope", slope).out


@pytest.mark.parametrize(
    "text",
    [
        SLOW.format("Z-0.8"),  # one feed
        SLOW.format("Z-0.8 F700"),  # not far below the rest
        SLOW.format("Z-0.1 F80"),  # takes no notable time
        SLOW.format("X20 F200\nX0"),  # no few lines: a good part of the path
        SLOW.format("G95 S3000 M3\nZ-0.8 F0.4\nG94"),  # 1200 mm/min
        SLOW.format("G93 Z-0.8 F1500\nG94"),  # 1200 mm/min
    ],
)
def test_feeds_that_are_no_surprise_are_not_named(text):
    found = why(text)
    assert found.slow_feeds == []


@pytest.mark.parametrize(
    ("line", "feed", "lines"),
    [
        ("G95 S1000 M3\nZ-0.8 F0.02\nG94", 20, (6, 6)),
        ("G93 Z-0.8 F25\nG94", 20, (5, 5)),
        ("G20\nG1 Z-0.0315 F0.8\nG21", 20.32, (6, 6)),
    ],
)
def test_a_slow_feed_is_told_in_mm_min_whatever_its_mode(line, feed, lines):
    (told,) = why(SLOW.format(line)).slow_feeds
    assert told["feed_mm_min"] == pytest.approx(feed, rel=1e-4)
    assert (told["line_first"], told["line_last"]) == lines


@pytest.mark.sample(4)
@pytest.mark.parametrize("family", FAMILIES)
def test_the_feeds_of_all_blocks_add_up_to_the_ideal_of_cuts(family):
    make, count = FAMILIES[family]
    text = make(np.random.default_rng(11), count // 2)
    found = why(text, Machine.load("mill3", set=EXACT))
    kept, streamed = (feeds.sums_of(each) for each in (
        load(text), Program(text.encode(), Machine.load("mill3"), keep=False)))  # fmt: skip
    assert 60 * kept.time.sum() == pytest.approx(found.as_dict()["ideal"]["cut_s"], rel=1e-6)
    assert (kept.time == streamed.time).all() and (kept.last == streamed.last).all()
