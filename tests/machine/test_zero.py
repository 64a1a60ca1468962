# SPDX-License-Identifier: MIT
"""Work whose zero nobody knows: what a program needs, and whether the machine has it."""

import random
from decimal import Decimal

import pytest
from command_line import pycnc

from pycnc.errors import ArgumentError
from pycnc.machine import Machine
from pycnc.program import Program, load, zero

ROUTER = """\
[axis.x]
v_max_mm_s = 100
a_max_mm_s2 = 500
j_max_mm_s3 = 5000
min_mm = {0}
max_mm = {1}
[axis.y]
v_max_mm_s = 100
a_max_mm_s2 = 500
j_max_mm_s3 = 5000
min_mm = {2}
max_mm = {3}
[axis.z]
v_max_mm_s = 100
a_max_mm_s2 = 500
j_max_mm_s3 = 5000
min_mm = {4}
max_mm = {5}
[work]
zero = "unknown"
[work.p.7]
x_mm = 3
"""
HALF = 200


def _router(pen):
    ends = []
    for _ in "xyz":
        low = pen.randrange(-2 * HALF, HALF)
        ends += [low, low + pen.randrange(2 * HALF, 4 * HALF)]
    text = ROUTER.format(*ends)
    inside = "".join(f"{letter}_mm = {ends[2 * k] + 1}\n" for k, letter in enumerate("xyz"))
    text += "".join(f"[{table}]\n{inside}" for table in ("home.g28", "home.g30", "start"))
    return Machine.from_text(text, name="router"), ends


def _program(pen, offset):
    """Return (text, what it needs of X, Y and Z) of moves with words of the machine between."""
    rows, places = ["G17 G21 G90 G94"], []
    at = [0, 0, 0]
    systems = pen.sample(["G54", "G55", "G59.3", "G92.1"], 2)
    for _ in range(pen.randrange(3, 20)):
        kind = pen.randrange(6)
        if kind == 0 and at[0] <= 60:  # half a circle beyond its ends
            radius = pen.randrange(1, 20)
            rows.append(f"G2 X{at[0] + 2 * radius} Y{at[1]} I{radius} J0 F900")
            places += [tuple(at), (at[0] + radius, at[1] + radius, at[2])]
            at[0] += 2 * radius
        elif kind == 1 and places:
            rows.append(pen.choice(["G53 G0 X{0} Y{1} Z{2}", "G28", "G28 X5"]).format(*offset))
            rows.append("G90")
            at = [pen.randrange(-50, 50) for _ in range(3)]
            rows.append(f"{systems[0]}\nG0 X{at[0]} Y{at[1]} Z{at[2]}")
            if rows[-3].startswith("G28 X"):
                places.append((5, *places[-1][1:]))
        else:
            begin, code = tuple(at), pen.randrange(2)
            at = [pen.randrange(-60, 60) + pen.choice([0, 0.5]) for _ in range(3)]
            if code and not places:  # who cuts first does so from the zero
                places.append(begin)
            rows.append(f"G{code} X{at[0]} Y{at[1]} Z{at[2]} F800")
        places.append(tuple(at))
        if pen.random() < 0.2:
            rows.append(systems[1])
    return "\n".join([*rows, "M2", ""]), places


def _spans(places):
    return [(min(axis), max(axis)) for axis in zip(*places, strict=True)]


@pytest.mark.sample(60)
@pytest.mark.parametrize("number", range(400))
def test_a_program_that_fits_is_laid_so_that_it_does(number, draw_seed):
    pen = random.Random(draw_seed + number)
    machine, ends = _router(pen)
    inside = [ends[0] + 2, ends[2] + 2, ends[4] + 2]
    text, places = _program(pen, inside)
    program = load(text, machine)
    found = [each for each in program.diagnostics if each.id in ("work-zero", "travel")]
    assert [each.id for each in found] == ["work-zero"]
    size = " × ".join(f"{high - low:g}" for low, high in _spans(places))
    assert f"needs {size} mm: fits into" in found[0].message
    assert not program.diagnostics.errors
    for letter, low, high in zip("xyz", ends[::2], ends[1::2], strict=True):
        assert low <= program.bounds[letter][0] and program.bounds[letter][1] <= high


@pytest.mark.sample(30)
@pytest.mark.parametrize("number", range(100))
def test_a_program_that_is_too_large_is_told_so_once(number, draw_seed):
    pen = random.Random(draw_seed + number)
    machine, ends = _router(pen)
    text, places = _program(pen, [ends[0] + 2, ends[2] + 2, ends[4] + 2])
    k = pen.randrange(3)
    letter, room = "XYZ"[k], ends[2 * k + 1] - ends[2 * k]
    text = text.replace("M2\n", f"G0 {letter}{-room}\nG1 {letter}{room} F100\n" * 9 + "M2\n")
    program = load(text, machine)
    wrong = [each for each in program.diagnostics if each.severity == "error"]
    assert [each.id for each in wrong] == ["travel"] and program.diagnostics.errors == 1
    assert f"does not fit, {letter} has {room}" in wrong[0].message


def _rounds(pen):
    """Return a program of circles, quarters and roundings, in inches or not."""
    unit, digits = pen.choice([(25.4, 4), (1, 3)])
    rows = ["G20" if unit != 1 else "G21", "G90 G17 G94 G0 X0 Y0", "G1 F20."]
    for _ in range(pen.randrange(3, 9)):
        far, wide, radius = (
            f"{pen.uniform(*ends) / unit:.{digits}f}" for ends in ((2, 60), (2, 60), (1, 5))
        )
        rows += pen.choice([
            [f"G1 X{far} Y{wide}"],
            [f"G3 I{radius}"],
            [f"G91 G2 X{radius} Y{radius} R{radius}", "G90"],
            ["G0 X0 Y0", f"G1 X{far} ,R{0.5 / unit:.{digits}f}", f"Y{wide}"],
        ])  # fmt: skip
    return "\n".join(rows)


@pytest.mark.sample(40)
@pytest.mark.parametrize("number", range(1000))
def test_a_place_of_the_machine_changes_nothing_of_what_round_work_needs(number, draw_seed):
    text = _rounds(random.Random(draw_seed + number))
    machine, needs = Machine.load("haas_vf2"), []
    for last in ("M30", "G53 G0 Z0. M30"):
        (found,) = [each for each in load(f"{text}\n{last}\n", machine).diagnostics
                    if each.id == "work-zero"]  # fmt: skip
        needs.append(found.message)
    assert needs[0] == needs[1] and "needs 0 × 0" not in needs[0]


def test_the_zero_can_be_told():
    machine, ends = _router(random.Random(5))
    text = "G21 G90\nG1 X10 Y5 Z2 F600\nG55 X10\nM2\n"
    changes = zero.changes(f"{ends[0]},{ends[2]}", machine)
    program = load(text, Machine.load(machine, set=changes))
    assert "work-zero" not in program.diagnostics.counts
    assert program.bounds["x"][1] == ends[0] + 10 and program.bounds["y"][1] == ends[2] + 5
    for words in ("", "1,", "a,2", "nan", "1,2,3,4"):
        with pytest.raises(ArgumentError, match="--zero"):
            zero.changes(words, machine)


def test_a_laid_program_begins_at_its_zero_and_takes_as_long():
    """Where the work lies makes no difference to the time but by what leads to the machine."""
    machine, ends = _router(random.Random(8))
    text = "G21 G90\nG0 X10\nG1 X80 Y5 F6000\nM2\n"
    laid = load(text, machine)
    free = {f"axis.{k}.{end}_mm": "free" for k in "xyz" for end in ("min", "max")}
    told = load(text, Machine.load(machine, set=free | {"work.zero": "told"} | {
        f"start.{k}_mm": 0 for k in "xyz"}))  # fmt: skip
    assert laid.length_mm == pytest.approx(told.length_mm, abs=1e-6)


def test_a_big_program_is_laid_piece_by_piece():
    machine, ends = _router(random.Random(11))
    rows = [f"G1 X{k % 50} Y{k % 31} Z{-(k % 11)}" for k in range(40_000)]
    text = "\n".join(["G17 G21 G90 F900", *rows, "M2", ""]).encode()
    program = Program(text, machine, keep=False)
    (told,) = [each for each in program.diagnostics if each.id == "work-zero"]
    assert "needs 49 × 30 × 10 mm" in told.message


def test_verbs_take_a_zero(tmp_path):
    machine, ends = _router(random.Random(3))
    file = tmp_path / "router.toml"
    file.write_text(machine.text)
    at = ",".join(str(Decimal(low) + 1) for low in ends[::2])
    program = b"G21 G90\nG1 X10 Y5 Z2 F600\nM2\n"
    for verb in ("check", "time", "lab canon", "why", "run"):
        told = pycnc(*verb.split(), "-", "-m", file, f"--zero={at}", stdin=program)
        assert told.code == 0 and "work-zero" not in told.out + told.err, verb
        told = pycnc(*verb.split(), "-", "-m", file, "--zero=1e9,0", stdin=program)
        assert told.code == 2 and "work.g54.x_mm" in told.err


@pytest.mark.parametrize("row", ["G54.1 P3", "G54 P 12", "G154P99", "G110", "G129", "g154 p7"])
@pytest.mark.parametrize("zero", [None, "-400,-300,-200"])
def test_a_further_work_system_lies_where_all_others_do(row, zero, tmp_path):
    (tmp_path / "part.nc").write_text(f"G21 G90 G0 G54 X1. Y2. Z3.\n{row} X4. Y5. Z6.\nM30\n")
    more = ["--zero", zero] if zero else []
    told = pycnc("check", tmp_path / "part.nc", "-m", "haas_vf2", *more)
    assert told.code == 0, told.out + told.err
    apart = Machine.load("haas_vf2", set={"work.zero": "told", "work.g55.x_mm": -9})
    text = f"G21 G90 G0 {row} X4. Y5. Z6.\nM30\n".encode()
    assert load(text, apart).machine.settings.work.p == {}
