# SPDX-License-Identifier: MIT
"""Other controls' planners: by hand, against an oracle by seed, sums, settings, and bad input."""

import json
import math
import random

import control_oracle as oracle
import pytest

from pycnc import errors
from pycnc.machine import Machine, MachineFileError
from pycnc.planning import control
from pycnc.planning.plan import Plan, plan, why
from pycnc.program import load

KINDS = ("klipper", "grbl", "grblhal", "fluidnc", "marlin", "linuxcnc")
PRINTERS = ("klipper", "marlin")
_AXES = "".join(
    f"[axis.{letter}]\nv_max_mm_s = {v}\na_max_mm_s2 = {a}\nj_max_mm_s3 = 100000\n"
    for letter, v, a in (("x", 100, 1000), ("y", 80, 500), ("z", 20, 200), ("u", 80, 800))
)
_DIALECTS = {"klipper": "marlin", "marlin": "marlin", "linuxcnc": "linuxcnc"}


def machine_of(kind, **settings):
    """Return a machine of a control, three axes and an extruder."""
    base = _DIALECTS.get(kind, "grbl")
    feed = "\nfeed_default_mm_min = 1500" if base == "marlin" else ""
    own = "".join(f"{key} = {value}\n" for key, value in settings.items())
    return Machine.from_text(
        f'[control]\nkind = "{kind}"\n{own}{_AXES}[dialect]\nbase = "{base}"{feed}\n'
    )


def any_program(kind, seed, count=150):
    """Return a program of all kinds of lines that a control knows."""
    rng = random.Random(f"{kind}{seed}")
    prints = kind in PRINTERS
    lines = ["G21", "G90", "G1 F600", *(["M82"] if prints else ["M3 S100"])]
    if kind == "linuxcnc":
        lines.append(rng.choice(("G61", "G64", "G64 P0.01", "G64 P0.2 Q0.05", "G61.1")))
    for _ in range(count):
        x, y, z = (round(rng.uniform(-20, 20), rng.choice((0, 3))) for _ in "xyz")
        lines.append(rng.choice((
            f"G1 X{x} Y{y}", f"G1 Z{z}", f"G0 X{x} Y{y} Z{z}", f"G1 X{x} F{rng.randint(1, 9000)}",
            "G91\nG2 X0 Y0 I2 J0\nG90", "G91\nG3 X2 Y0 I1 J0 Z0.5\nG90", "G4 P0.1", "G1",
            f"G1 E{x}" if prints else f"G1 X{x} S{rng.randint(0, 99)}",
            f"G1 X{x} E{y}" if prints else "M8", "G91\nG1 X0.001\nG90", "G91\nG1 X-0.001\nG90",
            f"G91\nG1 X0.4 Y{rng.uniform(-0.2, 0.2):.3f}\nG1 X0.4\nG90",
        )))  # fmt: skip
    return load(("\n".join(lines) + "\n").encode(), machine_of(kind))


def time_of(text, machine):
    return plan(load(text.encode(), machine)).time_s


def klipper(**settings):
    return machine_of("klipper", **{"max_velocity": 100, "max_accel": 1000, **settings})


def test_a_line_alone_is_a_trapezoid():
    ramp, feed, length = 1000.0, 50.0, 40.0
    by_hand = 2 * feed / ramp + (length - feed**2 / ramp) / feed
    text = "G21\nG90\nG1 X40 F3000\n"
    assert time_of(text, klipper()) == pytest.approx(by_hand, rel=1e-12)
    assert time_of(text, machine_of("grbl")) == pytest.approx(by_hand, rel=1e-12)


def test_a_right_angle_is_passed_at_the_square_corner_velocity():
    v, a, corner = 100.0, 1000.0, 8.0
    leg = oracle.trapezoid(40.0, a, 0.0, corner, v)
    text = "G21\nG90\nG1 X40 F6000\nG1 Y40\n"
    found = time_of(text, klipper(square_corner_velocity=8, minimum_cruise_ratio=0))
    assert found == pytest.approx(2 * leg, rel=1e-9)


def test_a_minimum_cruise_ratio_keeps_a_short_line_slow():
    # From rest to rest: as fast as half the acceleration would get, up and down at all of it.
    top = math.sqrt(1000.0 * 0.5 * 4.0)
    by_hand = 2 * top / 1000.0 + (4.0 - top**2 / 1000.0) / top
    assert time_of("G21\nG90\nG1 X4 F6000\n", klipper()) == pytest.approx(by_hand, rel=1e-9)


def test_filament_alone_is_as_fast_as_nozzle_and_filament_say():
    ratio = 4 * 0.4**2 / (math.pi * 0.875**2)
    by_hand = oracle.trapezoid(30.0, 1000 * ratio, 0.0, 0.0, 100 * ratio)
    found = time_of("G21\nG90\nM83\nG1 E30 F6000\n", klipper(minimum_cruise_ratio=0))
    assert found == pytest.approx(by_hand, rel=1e-9)


def test_grbl_takes_a_corner_by_its_junction_deviation():
    cap = 500.0 * math.sqrt(2) * 0.01 * math.sqrt(0.5) / (1 - math.sqrt(0.5))
    v = math.sqrt(cap)
    by_hand = oracle.trapezoid(40, 1000, 0, v, 100) + oracle.trapezoid(40, 500, v, 0, 80)
    found = time_of("G21\nG90\nG1 X40 F60000\nG1 Y40\n", machine_of("grbl"))
    assert found == pytest.approx(by_hand, rel=1e-9)


def test_grbl_rests_where_s_changes_and_a_laser_does_not():
    text = "G21\nG90\nM3 S10\nG1 X20 F6000\nG1 X40 S20\nG1 X60 S30\n"
    one = oracle.trapezoid(60, 1000, 0, 0, 100)
    three = 3 * oracle.trapezoid(20, 1000, 0, 0, 100)
    assert time_of(text, machine_of("grbl", laser_mode="true")) == pytest.approx(one, rel=1e-9)
    assert time_of(text, machine_of("grbl")) == pytest.approx(three, rel=1e-9)


def test_a_ring_ends_at_rest():
    # Lines of 1 mm in a row: of 3 blocks 2 are seen, so no line ends faster than the next can stop.
    text = "G21\nG90\nF60000\n" + "".join(f"G1 X{k}\n" for k in range(1, 41))
    v = math.sqrt(2 * 1000 * 1.0)
    by_hand = oracle.trapezoid(1, 1000, 0, v, 100) + oracle.trapezoid(1, 1000, v, 0, 100)
    by_hand += 38 * oracle.trapezoid(1, 1000, v, v, 100)
    found = plan(load(text.encode(), machine_of("grbl", planner_blocks=3)))
    assert found.time_s == pytest.approx(by_hand, rel=1e-9)
    assert time_of(text, machine_of("grbl", planner_blocks=100)) < 0.7 * found.time_s
    assert "looks only 2 lines ahead" in json.dumps(found.why().as_dict())


def test_marlin_s_classic_jerk_begins_and_turns_at_its_own_speeds():
    machine = machine_of("marlin", acceleration=500) .text.replace(
        "[axis.x]", "[control.jerk]\nx = 10\ny = 6\nz = 1\ne = 5\n[axis.x]", 1
    )
    # At 90° X stops from up to 10, Y starts with up to 6: the safe speeds are slower than both.
    leg = oracle.trapezoid(40, 500, 10, 6, 80) + oracle.trapezoid(40, 500, 6, 0.05, 80)
    found = time_of("G21\nG90\nG1 X40 F4800\nG1 Y40\n", Machine.from_text(machine))
    assert found == pytest.approx(leg, rel=2e-3)


def _walk(rng, count, scale):
    x = y = 0.0
    points = [(0.0, 0.0)]
    heading = 0.0
    while len(points) < count:
        heading += rng.choice((0.0, rng.gauss(0, 0.3), rng.uniform(-3.1, 3.1)))
        length = scale * rng.uniform(0.2, 2)
        x, y = round(x + length * math.cos(heading), 3), round(y + length * math.sin(heading), 3)
        if (x, y) != points[-1]:
            points.append((x, y))
    return points


def _text(points, feed):
    moves = "".join(f"G1 X{x:.3f} Y{y:.3f}\n" for x, y in points[1:])
    return f"G21\nG90\nG1 F{feed * 60}\n{moves}"


@pytest.mark.parametrize("seed", range(12))
def test_klipper_is_the_oracle_s(seed):
    rng = random.Random(seed)
    points, feed = _walk(rng, 300, 10 ** rng.uniform(-1, 1)), rng.choice((20, 60, 150))
    corner = rng.choice((0, 1, 5, 20))
    found = time_of(
        _text(points, feed), klipper(square_corner_velocity=corner, minimum_cruise_ratio=0)
    )
    limits = [(1000, corner)] * (len(points) - 1)
    assert found == pytest.approx(oracle.klipper(points, feed, 100, limits), rel=1e-9)


@pytest.mark.sample(12)
@pytest.mark.parametrize("seed", range(1000))
def test_a_line_of_klipper_keeps_the_limits_that_held_as_it_came(seed, draw_seed):
    rng = random.Random(seed + draw_seed)
    points, feed = _walk(rng, 200, 10 ** rng.uniform(-1, 1)), rng.choice((20, 60, 150))
    head, *moves = _text(points, feed).rsplit("\n", len(points))
    a, corner, limits = 1000, 5, []
    for k in range(len(points) - 1):
        if rng.random() < 0.2:
            a, corner = rng.choice((300, 1500, 9000)), rng.choice((1, 5, 12))
            words = rng.choice((f"SET_VELOCITY_LIMIT ACCEL={a}", f"M204 S{a}",
                                f"M204 P{a} T{a + 9}"))  # fmt: skip
            more = f"SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY={corner}"
            moves[k] = f"{words}\n{more}\n{moves[k]}"
        limits.append((a, corner))
    machine = klipper(square_corner_velocity=5, minimum_cruise_ratio=0)
    found = time_of("\n".join([head, *moves]), machine)
    assert found == pytest.approx(oracle.klipper(points, feed, 100, limits), rel=1e-9)


@pytest.mark.parametrize("seed", range(12))
def test_accel_to_decel_is_a_ratio_of_the_acceleration_in_force(seed):
    rng = random.Random(seed)
    head, *moves = _text(_walk(rng, 60, 1.0), 150).rsplit("\n", 60)
    accel, old = rng.randrange(300, 4000), rng.randrange(300, 4000)
    share = rng.choice((0.2, 1, 1.5))
    slow = f"ACCEL_TO_DECEL={accel * share:.9g}"
    words = rng.choice((f"SET_VELOCITY_LIMIT ACCEL={old}\nSET_VELOCITY_LIMIT {slow} ACCEL={accel}",
                        f"M204 S{accel}\nSET_VELOCITY_LIMIT {slow}",
                        f"SET_VELOCITY_LIMIT {slow} ACCEL={accel} MINIMUM_CRUISE_RATIO=0.3"))
    ratio = 0.3 if "RATIO" in words else 1 - min(1, share)
    plain = f"SET_VELOCITY_LIMIT ACCEL={accel} MINIMUM_CRUISE_RATIO={ratio:.9g}"
    times = [time_of("\n".join([head, line, *moves]), klipper()) for line in (words, plain)]
    assert times[0] == pytest.approx(times[1], rel=1e-9)


@pytest.mark.parametrize("seed", range(12))
def test_grbl_is_the_oracle_s(seed):
    rng = random.Random(100 + seed)
    points, feed = _walk(rng, 300, 10 ** rng.uniform(-1, 1)), rng.choice((20, 60, 150))
    deviation, steps = rng.choice((0, 0.002, 0.02)), rng.choice((80, 160))  # no half steps
    machine = Machine.load(
        machine_of("grbl", junction_deviation=deviation, planner_blocks=1000),
        set={f"control.steps_per_mm.{letter}": steps for letter in "xyz"},
    )
    limits = (100, 80), (1000, 500), deviation, steps
    found = time_of(_text(points, feed), machine)
    assert found == pytest.approx(oracle.grbl(points, feed, *limits), rel=1e-9)


@pytest.mark.parametrize("ratio", [0, 0.5, 0.9])
def test_what_klipper_has_in_its_queue_does_not_matter(monkeypatch, ratio):
    rng = random.Random(ratio)
    scales = (0.01, 0.1, 1.0)
    texts = [_text(_walk(rng, 3000, scale), 150) for scale in scales]
    text = "G4 P0\n".join(texts)
    whole = plan(load(text.encode(), klipper(minimum_cruise_ratio=ratio)))
    monkeypatch.setattr(control, "_LINES", 1024)
    pieces = plan(load(text.encode(), klipper(minimum_cruise_ratio=ratio)))
    assert pieces.time_s == pytest.approx(whole.time_s, rel=1e-9)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(4))
def test_programs_of_all_kinds_of_lines_have_a_time(kind, seed):
    found = plan(any_program(kind, seed, 200))
    assert 0 < found.time_s < math.inf
    told = found.why()
    lost = math.fsum(cause["lost_s"] for cause in told.causes)
    assert told.ideal_s + lost == pytest.approx(found.time_s, rel=1e-9)
    assert all(cause["lost_s"] > -1e-6 * found.time_s for cause in told.causes), told.causes


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_lost_and_what_is_not_add_up(kind):
    rng = random.Random(kind)
    text = _text(_walk(rng, 400, 1.0), 60) + "G4 P0\nG0 X0 Y0\n"
    found = plan(load(text.encode(), machine_of(kind)))
    told = found.why()
    lost = math.fsum(cause["lost_s"] for cause in told.causes)
    assert told.ideal_s + lost == pytest.approx(found.time_s, rel=1e-9)
    totals = found.totals
    assert math.fsum(totals["limit_time_s"].values()) == pytest.approx(found.time_s, rel=1e-9)
    for names in (("cut_s", "rapid_s", "dwell_s"),
                  ("accelerate_s", "cruise_s", "decelerate_s", "dwell_s")):  # fmt: skip
        assert math.fsum(totals[name] for name in names) == pytest.approx(found.time_s, rel=1e-9)
    by_line = Plan(found.program, keep=False, by="line").parts
    assert math.fsum(part["time_s"] for part in by_line) == pytest.approx(found.time_s, rel=1e-9)


@pytest.mark.parametrize("kind", ["klipper", "grbl", "marlin", "linuxcnc"])
def test_faster_limits_never_take_longer(kind):
    text = _text(_walk(random.Random(7), 300, 3.0), 60)
    machine = machine_of(kind)
    keys = [("axis.x.a_max_mm_s2", 4000), ("axis.y.a_max_mm_s2", 4000)]
    if kind == "klipper":
        keys = [("control.max_accel", 4000), ("control.square_corner_velocity", 10)]
    faster = Machine.load(machine, set=dict(keys))
    assert time_of(text, faster) < time_of(text, machine)


def test_a_limit_in_the_program_holds_from_there():
    moves = "G1 X40 F6000\nG1 X0\n"
    for kind, word in (("klipper", "SET_VELOCITY_LIMIT ACCEL=250"), ("klipper", "M204 S250"),
                       ("marlin", "M204 T250"), ("marlin", "M201 X250")):  # fmt: skip
        machine = klipper() if kind == "klipper" else machine_of("marlin", acceleration=1000)
        fast, slow = (time_of(f"G21\nG90\n{first}{moves}", machine) for first in ("", f"{word}\n"))
        both = time_of(f"G21\nG90\n{moves}G4 P0\n{word}\n{moves}", machine)
        assert slow > 1.2 * fast
        program = load(f"G21\nG90\n{word}\n{moves}".encode(), machine)
        assert "limits-stay" not in {each.id for each in program.diagnostics}
        assert both == pytest.approx(fast + slow, rel=1e-9), word


@pytest.mark.parametrize("kind", ["klipper", "marlin"])
@pytest.mark.parametrize("seed", range(6))
def test_m220_is_a_share_of_every_feed_behind_it(kind, seed):
    rng = random.Random(seed)
    said, scaled, share = ["G21 G90"], ["G21 G90"], 100
    for k in range(40):
        if rng.random() < 0.3:
            share = rng.choice((25, 50, 100, 200))
            said.append(f"M220 S{share}")
            scaled.append("M106 S9")
        feed, move = rng.choice((600, 2400)), rng.choice(("G0", "G1"))
        place = f"X{rng.uniform(0, 90):.2f} Y{rng.uniform(0, 90):.2f}"
        said.append(f"{move} {place} F{feed}")
        scaled.append(f"{move} {place} F{feed * share / 100:g}")
    machine = machine_of(kind)
    found, expected = (time_of("\n".join(lines), machine) for lines in (said, scaled))
    assert found == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("kind", ["klipper", "marlin"])
@pytest.mark.parametrize("seed", range(6))
def test_m221_is_a_share_of_all_filament_behind_it(kind, seed):
    rng = random.Random(seed)
    said, scaled, share, e, out = ["G21 G90", "M82"], ["G21 G90", "M82"], 1.0, 0.0, 0.0
    for k in range(60):
        if rng.random() < 0.2:
            share = rng.choice((0.25, 0.5, 1, 2))
            said.append(f"M221 S{share * 100:g}")
            scaled.append("M106 S9")
        if rng.random() < 0.1:
            for lines in (said, scaled):
                lines.append("G92 E0")
            e = out = 0.0
        step = rng.choice((0.4, -0.8, 1.6, 0))
        e, out = e + step, out + step * share
        place = rng.choice((f"X{rng.uniform(0, 30):.2f} Y{rng.uniform(0, 30):.2f} ", ""))
        said.append(f"G1 {place}E{e:.3f} F2400")
        scaled.append(f"G1 {place}E{out:.3f} F2400")
    machine = machine_of(kind)
    found, expected = (time_of("\n".join(lines), machine) for lines in (said, scaled))
    assert found == pytest.approx(expected, rel=1e-9)


def test_macros_are_told_once_and_skipped():
    text = "START_PRINT BED=60\nG21\nG90\n" + "EXCLUDE_OBJECT_START NAME=a\nG1 X10 F600\n" * 3
    program = load(text.encode(), klipper())
    found = {each.id: (each.severity, each.line, each.message) for each in program.diagnostics}
    assert found["macro-own"][:2] == ("warning", 1)
    assert found["macro-still"][:2] == ("note", 4) and "3 lines" in found["macro-still"][2]
    named = klipper(still_macros='["start_print"]')
    severities = {each.severity for each in load(text.encode(), named).diagnostics}
    assert severities == {"note"}
    assert program.text != text.encode() and len(program.text) == len(text)


BAMBU = {  # a line of its own → whether it moves nothing; None: it is not a line of its own
    "M1002 gcode_claim_action : 4": True, "M620 S0A": False, "M621 S0A   ; AMS": False,
    "M73.2   R1.0": True, "M221 X0 Y0 Z0": True, "G29.1 Z0": True, "G380 S2 Z-25 F300": False,
    "M960 S5 P1": True, "M970.3 Q1 A7 B30": False, "M622 J1": True, "M623": True, "T255": True,
    "M400 U1": False, "G28 Z P0 T300; low": False, "M982.2 S1": True, "M221 S100": None,
    "M400": None, "G28 X": None, "M73 P5 R2": None, "G39": False, "M9833": False,
}  # fmt: skip


@pytest.mark.parametrize("seed", range(12))
def test_codes_of_bambus_are_told_once_and_skipped(seed):
    rng = random.Random(seed)
    head = ["M1002 set_gcode_claim_speed_level : 5", "G21 G90", "M83", "G1 X1 Y1 F3000"]
    said, plain, told = list(head), list(head), {"M1002": True}
    for _ in range(40):
        line = rng.choice(list(BAMBU))
        said.append("  " * rng.randrange(2) + line)
        plain.append(line if BAMBU[line] is None else "")
        if BAMBU[line] is not None:
            told[line.split()[0]] = BAMBU[line]
        move = f"G1 X{rng.uniform(0, 90):.2f} Y{rng.uniform(0, 90):.2f} E.1"
        said, plain = [*said, move], [*plain, move]
    found = load("\n".join(said), machine_of("marlin"))
    expected = load("\n".join(plain), machine_of("marlin"))
    assert found.diagnostics.errors == expected.diagnostics.errors == 0
    assert plan(found).time_s == plan(expected).time_s
    counts = found.diagnostics.counts
    assert counts["macro-own"] == list(told.values()).count(False)
    assert counts["macro-still"] == list(told.values()).count(True)


def test_m400_with_a_time_waits_so_long_on_bambus():
    head, move = "M1002 judge_flag x\nG21 G90\nG1 X9 F900\n", "G1 X3\n"
    times = [time_of(f"{head}{words}\n{move}", machine_of("marlin"))
             for words in ("M400", "M400 S5", "M400 P250")]  # fmt: skip
    assert times[1] - times[0] == pytest.approx(5) and times[2] - times[0] == pytest.approx(0.25)


@pytest.mark.parametrize("name", ["_CLEAN_NOZZLE", "STATUSES", "SET_PINS_UP", "PRIME"])
def test_a_macro_whose_name_says_nothing_may_move(name):
    program = load(f"G21 G90\n{name}\nG1 X9 F900\n", klipper())
    assert program.diagnostics.counts["macro-own"] == 1


def test_what_if_tells_this_kernel_and_the_control_s_own_settings():
    text = _text(_walk(random.Random(3), 60, 2.0), 60)
    for kind in ("klipper", "grbl", "marlin"):
        found = why(load(text.encode(), machine_of(kind)), what_if=True)
        names = [cure["cure"] for cure in found.cures]
        assert "this kernel (control.kind = nck)" in names and len(names) > 2
        nck = Machine.load(machine_of(kind), set={"control.kind": "nck"})
        own = next(cure for cure in found.cures if "nck" in cure["cure"])
        assert own["time_s"] == plan(load(text.encode(), nck)).time_s


@pytest.mark.parametrize("kind, key, value, words", [
    ("klipper", "control.junction_deviation", 0.01, "is a setting of grbl"),
    ("grbl", "control.square_corner_velocity", 5, "is a setting of klipper"),
    ("klipper", "control.kind", "kliper", "must be"),
    ("klipper", "control.minimum_cruise_ratio", 1.5, "must be 0.999 at most"),
    ("klipper", "control.square_corner_velocity", -1, "must be 0 at least"),
    ("klipper", "control.max_accel", "fast", "must be a number"),
    ("grbl", "control.planner_blocks", 2, "must be 3 at least"),
    ("grbl", "control.steps_per_mm.a", 100, "no axis A"),
    ("marlin", "control.jerk.x", 0, "must be 0.001 at least"),
    ("klipper", "control.scv", 5, "scv"),
])  # fmt: skip
def test_a_wrong_setting_is_told_with_its_place(kind, key, value, words):
    with pytest.raises(MachineFileError) as caught:
        Machine.load(machine_of(kind), set={key: value})
    assert key in str(caught.value) and words in str(caught.value)


def test_both_rules_for_corners_are_one_too_many():
    machine = machine_of("marlin", junction_deviation=0.01)
    with pytest.raises(MachineFileError, match="other rule for corners"):
        Machine.load(machine, set={"control.jerk.x": 10})


def test_an_error_of_the_program_is_no_time():
    with pytest.raises(errors.ProgramError):
        time_of("G21\nG90\nG1 X10 F600\nG1 Q\n", machine_of("grbl"))
