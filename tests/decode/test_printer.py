# SPDX-License-Identifier: MIT
"""Room 1: words of printers: E, heaters and fans."""

import random

import pytest

import pycnc
from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine
from pycnc.planning import plan as planned
from pycnc.planning.plan import Plan

HEAD = "M82\nG21 G90 F600\nG92 E0\n"


@pytest.fixture(scope="module")
def machine():
    return Machine.load("printer")


def decode(text, machine):
    blocks, diagnostics = stages.decode(text.encode(), machine)
    errors = diagnostics[diagnostics["code"] < 0]
    return blocks, [(status_id(int(each["code"])), int(each["line"])) for each in errors]


@pytest.mark.parametrize(
    ("lines", "ends"),
    [
        ("G1 X5 E1\nG1 X6 E1.5", [1, 1.5]),
        ("M83\nG1 X5 E1\nG1 X6 E1.5", [1, 2.5]),
        ("M83\nG1 E1\nM82\nG1 E1.5", [1, 1.5]),
        ("G91\nG1 X5 E1\nG1 X1 E1.5", [1, 2.5]),
        ("G91\nM82\nG1 X5 E1\nG1 X1 E1.5", [1, 1.5]),
        ("G91\nM82\nG1 X5 E1\nG92 E0\nG1 X1 E0.5", [1, 1.5]),
        ("M83\nG90\nG1 E1\nG1 E1.5", [1, 1.5]),
        ("G20\nM83\nG1 E1\nG1 E.5", [25.4, 38.1]),
    ],
)
def test_e_counts_as_m82_and_m83_say(lines, ends, machine):
    blocks, errors = decode(f"{HEAD}{lines}\n", machine)
    moves = blocks[blocks["kind"] == lib.NCK_BLOCK_LINE]["target_nm"]
    assert errors == []
    assert (moves[:, 6] / 1e6).tolist() == ends


def test_heaters_wait_or_do_not_and_say_how_hot(machine):
    text = f"{HEAD}M104 S200\nM140 S60\nM106\nM107\nM109 T0 R210\nM190 S60\nM400\nM84\n"
    blocks, errors = decode(text, machine)
    kinds = {lib.NCK_BLOCK_OUTPUT: "output", lib.NCK_BLOCK_WAIT: "wait"}
    said = [
        (kinds[block["kind"]], block["output"]["number"], block["output"]["value"])
        for block in blocks if block["output"]["kind"] == lib.NCK_OUTPUT_SETTING
    ]  # fmt: skip
    assert errors == []
    assert said == [
        ("output", 104, 200), ("output", 140, 60), ("output", 106, 255), ("wait", 109, 210),
        ("wait", 190, 60),
    ]  # fmt: skip
    codes = blocks["output"]["value"][blocks["output"]["kind"] == lib.NCK_OUTPUT_M]
    assert {107, 84, 2} <= set(codes.tolist())


def test_a_text_is_no_word_and_limits_are_told(machine):
    program = pycnc.load(f"{HEAD}M117 Printing 50% [layer] X\nM204 P500 T900\nG1 X1\n", machine)
    assert [each.id for each in program.diagnostics if each.severity == "error"] == []
    assert "limits-stay" in [each.id for each in program.diagnostics]


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("M104", ("word-missing", 4)), ("M109 S-1", ("number-range", 4)),
        ("M104 S200 G1 X1", ("modal-group", 4)), ("G1 E1 U1", ("word-twice", 4)),
        ("M567", ("m-unknown", 4)),
    ],
)  # fmt: skip
def test_mistakes_are_told(line, found, machine):
    assert decode(f"{HEAD}{line}\n", machine)[1] == [found]


def test_a_machine_without_an_extruder_and_another_dialect_have_no_e():
    assert decode(f"{HEAD}G1 E1\n", Machine.load("mill3", set=["dialect.base=marlin"]))[1] == [
        ("axis-unknown", 3), ("axis-unknown", 4)
    ]  # fmt: skip
    linuxcnc = Machine.load("mill3")
    assert decode("G21 G90 F600\nG1 X1 E1\nM2\n", linuxcnc)[1] == [("word-unknown", 2)]
    assert decode("M104 S200\nM2\n", linuxcnc)[1] == [("other-base", 1)]


def test_f_is_the_speed_of_the_nozzle_and_e_alone_has_it_too(machine):
    program = pycnc.load(f"{HEAD}G1 X100 E500 F3000\nG1 E490\nG1 X0 E700\n", machine)
    peaks = pycnc.run(program).summary["peaks"]
    assert 100 / 2.1 <= 300 * peaks["x"]["v"] <= 50 + 1e-6  # held down by E, at corners less
    assert all(peaks[axis]["v"] <= 1 + 1e-9 for axis in ("x", "u"))


@pytest.mark.sample(20)
@pytest.mark.parametrize("number", range(200))
def test_a_feed_of_nothing_is_not_heard_but_ends_a_print_of_klipper(number, draw_seed):
    pen = random.Random(draw_seed + number)
    rows, plain = ["G21", "G90"], ["G21", "G90"]
    wrong = []
    for _ in range(pen.randrange(1, 12)):
        move = f"G{pen.randrange(2)} X{pen.randrange(1, 90)} Y{pen.randrange(1, 90)}"
        feed = pen.choice(["", f" F{pen.randrange(300, 9000)}", " F0", " F-20", " F0.0"])
        is_none = feed.startswith((" F0", " F-"))
        rows.append(move + feed)
        plain.append(move if is_none else move + feed)
        wrong += [len(rows)] * is_none
    text, without = "\n".join([*rows, ""]), "\n".join([*plain, ""])
    for machine in ("printer", "printer_marlin"):
        found = pycnc.load(text, machine)
        assert found.diagnostics.errors == 0
        assert found.diagnostics.counts["feed-kept"] == bool(wrong)
        assert found.blocks["feed"].tolist() == pycnc.load(without, machine).blocks["feed"].tolist()
    errors = [each for each in pycnc.load(text, "printer_klipper").diagnostics
              if each.severity == "error"]  # fmt: skip
    assert [each.line for each in errors] == wrong[:1]


@pytest.mark.sample(20)
@pytest.mark.parametrize("number", range(200))
def test_a_place_beyond_a_travel_that_holds_is_its_end_but_ends_a_klipper_print(number, draw_seed):
    pen = random.Random(draw_seed + number)
    ends, at = {"X": 220, "Y": 220, "Z": 250}, dict.fromkeys("XYZ", 0)
    rows, beyond, outside, held = ["G21", "G90", "G1 X0 Y0 Z0 F9000"], [], [], True
    within = list(rows)
    for _ in range(pen.randrange(1, 12)):
        if pen.random() < 0.2:
            said = pen.choice(["", " S0", " S1"])
            held = said != " S0" if said else held
            rows.append(f"M211{said}")
            within.append("M211 S0")
        steps, words, kept = pen.random() < 0.3, "", ""
        for axis in sorted(pen.sample("XYZ", pen.randrange(1, 4))):
            to = pen.choice([-1, 1]) * pen.randrange(1, 9) if pen.random() < 0.2 else 60
            place = at[axis] + to if steps else pen.choice([to + ends[axis], -to, ends[axis] - 60])
            said = place - at[axis] if steps else place
            at[axis] = min(max(place, 0), ends[axis]) if held else place
            outside += [len(rows) + 1] * (not 0 <= place <= ends[axis])
            words, kept = f"{words} {axis}{said}", f"{kept} {axis}{at[axis]}"
            if place != at[axis] and len(rows) + 1 not in beyond:
                beyond.append(len(rows) + 1)
        code = f"G{pen.randrange(2)}"
        rows.append(f"{'G91' if steps else 'G90'} {code}{words}")
        within.append(f"G90 {code}{kept}")
    text, without = "\n".join([*rows, ""]), "\n".join([*within, ""])
    for machine in ("printer", "printer_marlin"):
        found = pycnc.load(text, machine)
        assert found.diagnostics.errors == 0
        assert found.diagnostics.counts["travel-end"] == bool(beyond)
        other = pycnc.load(without, machine).blocks["target_nm"]
        assert found.blocks["target_nm"].tolist() == other.tolist(), text
    errors = [each for each in pycnc.load(text, "printer_klipper").diagnostics
              if each.severity == "error"]  # fmt: skip
    assert [(each.id, each.line) for each in errors] == [("travel", n) for n in outside[:1]]


@pytest.mark.parametrize("words", ["M203 X0", "M201 Y0 X0", "M203 E0", "M204 S0", "M220 S0"])
def test_a_limit_of_nothing_changes_nothing(words):
    text = "G21\nG90\n{}\nG1 X30 Y20 E1 F3000\nG1 X0\n"
    both = (pycnc.load(text.format(each), "printer_marlin") for each in ("M107", words))
    plain, told = (Plan(program, keep=False).why() for program in both)
    assert told.time_s == plain.time_s > 0
    assert [row["lost_s"] for row in told.causes] == [row["lost_s"] for row in plain.causes]


def test_a_dwell_of_a_printer_without_a_time_is_a_rest():
    program = pycnc.load(f"{HEAD}G1 X5\nG4 ; wait\nG1 X9\n", "printer_marlin")
    (rest,) = program.blocks[program.blocks["kind"] == lib.NCK_BLOCK_DWELL]
    assert program.diagnostics.errors == 0 and rest["dwell_s"] == 0


@pytest.mark.sample(20)
@pytest.mark.parametrize("number", range(200))
def test_reprap_says_speeds_of_limits_in_a_minute(number, draw_seed):
    pen = random.Random(draw_seed + number)
    rows, same = ["G21", "G90", "G1 X0 Y0 F9000"], ["G21", "G90", "G1 X0 Y0 F9000"]
    for _ in range(pen.randrange(1, 12)):
        said = {axis: pen.randrange(1, 99) for axis in pen.sample("XYZ", pen.randrange(1, 4))}
        code, per_s, per_min = pen.choice([(203, 203, 60), (566, 205, 60), (201, 201, 1)])
        rows.append(" ".join([f"M{code}", *(f"{axis}{to * per_min}" for axis, to in said.items())]))
        same.append(" ".join([f"M{per_s}", *(f"{axis}{to}" for axis, to in said.items())]))
        move = f"G1 X{pen.randrange(90)} Y{pen.randrange(90)}"
        rows, same = [*rows, move], [*same, move]
    jerk = {f"control.jerk.{axis}": 8 for axis in "xyz"}
    machine = Machine.load("printer_marlin", set=jerk)
    of_reprap = Machine.load("printer_marlin", set={**jerk, "control.reprap": True})
    times = [planned.plan(pycnc.load("\n".join([*lines, ""]), own)).time_s
             for lines, own in ((rows, of_reprap), (same, machine))]  # fmt: skip
    assert times[0] == pytest.approx(times[1], rel=1e-9)


def counted(pen, firmware):
    """Return (text with E as a firmware counts it, the same with all E in steps)."""
    rows, plain = ["G21", "M82", "G90"], ["G21", "M83"]
    steps, relative, at = False, False, 0.0
    for _ in range(pen.randrange(4, 25)):
        said = pen.choice(["G90", "G91", "M82", "M83", "", "", ""])
        rows += [said] * bool(said)
        relative = said == "G91" if said[:1] == "G" else relative
        if said[:1] == "M" or (said and firmware == "marlin"):
            steps = said in ("M83", "G91")
        in_steps = steps or (relative and firmware == "klipper")
        by = round(pen.uniform(0, 5), 3)
        rows.append(f"G1 E{by if in_steps else round(at + by, 3)} F900")
        plain.append(f"G1 E{by} F900")
        at = round(at + by, 3)
    return "\n".join([*rows, ""]), "\n".join([*plain, ""])


@pytest.mark.sample(30)
@pytest.mark.parametrize("firmware", ["marlin", "klipper", "reprap"])
@pytest.mark.parametrize("number", range(300))
def test_e_counts_as_the_firmware_of_the_printer_has_it(firmware, number, draw_seed):
    text, plain = counted(random.Random(draw_seed + number), firmware)
    name = "printer_klipper" if firmware == "klipper" else "printer_marlin"
    own = Machine.load(name, set={"control.reprap": True} if firmware == "reprap" else {})
    ends = [decode(each, machine)[0]["target_nm"][:, 6].tolist()
            for each, machine in ((text, own), (plain, Machine.load("printer")))]  # fmt: skip
    assert ends[0] == ends[1], text
    dwells = decode("G21\nG4 S2\nG4 P500\n", own)[0]["dwell_s"].tolist()
    assert dwells[:2] == [0.0 if firmware == "klipper" else 2.0, 0.5]


@pytest.mark.parametrize("seed", range(20))
def test_what_only_the_printer_knows_is_refused_by_its_name(seed):
    pen = random.Random(seed)
    line, column, words = pen.choice((
        ("if move.axes[0].homed", 1, "if is of RepRapFirmware's meta commands"),
        ('echo "x"', 2, "echo is of RepRapFirmware's"), ("var a = 1", 2, "var is of RepRap"),
        ("G1 X{var.a}", 4, "{ is of RepRapFirmware's"), ("G1 H2 X5 F600", 4, "H2 has a move end"),
        ("G5 I0 J3 P0 Q-3 X60 Y60 E16", 1, "E does not move along a spline"),
    ))  # fmt: skip
    plain = [f"G1 X{pen.randrange(90)} F900" for _ in range(pen.randrange(1, 9))]
    text = "G21\nG90\n" + "\n".join(plain) + f"\n{line}\nG1 X1\n"
    machine = Machine.load("printer_marlin", set={"control.reprap": True})
    (found,) = [each for each in pycnc.load(text, machine).diagnostics if each.severity == "error"]
    assert (found.line, found.col) == (3 + len(plain), column)
    assert found.message.startswith(words) and found.help


@pytest.mark.sample(20)
@pytest.mark.parametrize("number", range(200))
def test_a_stop_with_a_time_goes_on_by_itself(number, draw_seed):
    pen = random.Random(draw_seed + number)
    lines, waits = ["G28", "G21", "G90"], 0.0
    for _ in range(pen.randrange(1, 9)):
        seconds, thousandths = pen.randrange(1, 30), pen.randrange(1, 5000)
        words, wait = pen.choice(((f"S{seconds}", seconds), (f"P{thousandths}", thousandths / 1000),
                                  (f"P{thousandths} S{seconds}", seconds), ("", 0),
                                  (f"S{seconds} P{thousandths}", seconds)))  # fmt: skip
        text = pen.choice(("", " Please wait", " S", "; S9"))
        lines += [f"M{pen.randrange(2)} {words}{text}", f"G1 X{pen.randrange(90)} F3000"]
        waits += wait
    plan = planned.plan(pycnc.load("\n".join([*lines, ""]), "printer_marlin"))
    assert plan.totals["dwell_s"] == pytest.approx(waits)


@pytest.mark.parametrize("first", range(0, 400, 50))
@pytest.mark.sample(2)
def test_each_way_of_the_firmware_s_own_is_told_once(machine, first):
    ways = ["G10", "G11", "G12 P1 S1", "G26", "G27 P2", "G29 A", "G34", "G80", "G80 X9 Y9 W4 H4"]
    for seed in range(first, first + 50):
        rng = random.Random(seed)
        lines = [rng.choice([*ways, f"G1 X{rng.randint(1, 9)} F600"]) for _ in range(20)]
        said = [line.split()[0] for line in lines]
        found = stages.decode(("G21 G90\nM82\n" + "\n".join(lines) + "\n").encode(), machine)[1]
        told = [(f"G{each['value']:g}", int(each["line"])) for each in found
                if each["letter"] in (b"G", ord("G"))]  # fmt: skip
        wanted = [(code, said.index(code) + 3) for code in dict.fromkeys(said) if code != "G1"]
        assert told == wanted, f"seed {seed}"
