# SPDX-License-Identifier: MIT
"""Room 1: words of shops. Random programs that say them against the same programs without."""

import random

import numpy as np
import pytest

import pycnc
from pycnc import stages
from pycnc.kernel.bind import diagnostic_id, lib, status_id
from pycnc.machine import Machine

FREE = [f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
FANUC = [*FREE, "dialect.base=fanuc", "tool.1.radius_mm=2", "tool.1.length_mm=0"]
HEAD = "G21 G90 G94 G17 G54\nS900 M3\nG0 X0. Y0. Z9.\n"
SEEDS = range(40)


def mill(*changes):
    return Machine.load("mill3", set=[*FANUC, *changes])


def decode(text, machine):
    """Return (blocks, ids and lines of the errors, ids of the notes)."""
    blocks, findings = stages.decode(text.encode(), machine)
    errors, notes = findings[findings["code"] < 0], findings[findings["code"] > 0]
    return (blocks, [(status_id(int(each["code"])), int(each["line"])) for each in errors],
            [diagnostic_id(int(each["code"])) for each in notes])  # fmt: skip


def told(text, machine):
    """Return what a program without a mistake does, but for the numbers of its lines."""
    blocks, errors, _ = decode(text, machine)
    assert errors == [], text
    return blocks[["kind", "target_nm", "feed", "tolerance_mm", "path_mode", "dwell_s"]]


def same(one, other, machine, second=None):
    np.testing.assert_array_equal(told(one, machine), told(other, second or machine), one)


def move(rng):
    code = rng.choice(("G0", "G1 F300."))
    return f"{code} X{rng.uniform(-50, 50):.3f} Y{rng.uniform(-50, 50):.3f}"


# ---- modes

MODES = ("G05 P10000", "G05 P0", "G05.1 Q1", "G5.1 Q1 R5", "G05.1 Q0", "G08 P1", "G08 P0", "G61.1",
         "G62", "G63", "G64", "G187", "G187 P2", "G13.1", "G23", "G40.1 G50.2",
         "G10.9")  # fmt: skip


@pytest.mark.parametrize("seed", SEEDS)
def test_a_mode_that_nobody_explains_changes_nothing(seed):
    rng = random.Random(seed)
    lines = [move(rng) for _ in range(8)]
    with_modes = [line for each in lines for line in (*rng.choices(MODES, k=2), each)]
    ends = (HEAD, "M30\n")
    same("\n".join(with_modes).join(ends), "\n".join(["", *lines, ""]).join(ends), mill())


def test_a_mode_is_noted_once_unless_it_ends_or_is_explained():
    text = f"{HEAD}G05.1 Q1\nG1 X1. F100.\nG05.1 Q1\nX2.\nM30\n"
    assert decode(text, mill())[2].count("mode-stays") == 1
    assert "mode-stays" not in decode(text, mill("g.5_1.action=ignore"))[2]
    assert "mode-stays" not in decode(f"{HEAD}G5.1 Q0\nG8 P0\nG5 P0\nG187\nM30\n", mill())[2]


@pytest.mark.parametrize("seed", SEEDS)
def test_an_explained_mode_is_the_tolerance_that_g64_says(seed):
    rng = random.Random(seed)
    sizes = {f"{code}": rng.choice((0, 0.005, 0.02, 0.3)) for code in ("5_1_q1", "187_p2", "62")}
    said = {"5_1_q1": "G5.1 Q1", "187_p2": "G187 P2", "62": "G62", "e": "G187 P1 E.125",
            "end": "G5.1 Q0"}  # fmt: skip
    changes = [f"g.{key}.{name}={value}" for key, size in sizes.items()
               for name, value in (("action", "tolerance"), ("tolerance_mm", size))]  # fmt: skip
    fanuc, linuxcnc = [], []
    for _ in range(6):
        key, line = rng.choice(list(said)), move(rng)
        size = {**sizes, "e": 0.125, "end": 0.01}[key]
        fanuc += [said[key], line]
        linuxcnc += [f"G64 P{size} Q{size}", line]
    machine = mill(*changes)
    same(HEAD + "\n".join(fanuc) + "\nM30\n", HEAD + "\n".join(linuxcnc) + "\nM30\n", machine,
         Machine.load("mill3", set=FREE))  # fmt: skip


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("G05", "word-missing"), ("G5.1 R1", "word-missing"), ("G8", "word-missing"),
        ("G5.1 Q1 X0.", "word-unused"), ("G187 P1 E-.1", "number-range"),
        ("G187 Q1", "word-unused"),
        ("G8 G4 P5", "word-shared"), ("G68.2 X0.", "unsupported"), ("G43.4 H1", "unsupported"),
        ("G12.1", "unsupported"), ("G7.1 C5.", "unsupported"), ("G10.9 X0.", "word-unused"),
    ],
)  # fmt: skip
def test_a_mode_that_says_too_little_or_is_not_built_is_refused(line, found):
    assert decode(f"{HEAD}{line}\nM30\n", mill())[1] == [(found, 4)]


def test_haas_looks_so_many_lines_ahead_with_a_note():
    assert decode(f"{HEAD}G103 P1\nG1 X1. F90.\nG103\nM30\n", mill())[2].count("mode-stays") == 1


def test_a_machine_without_tools_takes_no_radius_with_a_note():
    text = f"{HEAD}G41 D7 G1 X9. F90.\nY9.\nG40 X20.\nM30\n"
    bare = pycnc.load(text, Machine.load("haas_vf2"))
    notes = [each for each in bare.diagnostics if each.id == "assumed-length"]
    assert bare.diagnostics.errors == 0 and "radius of tool 7" in notes[0].message
    one = pycnc.load(text, Machine.load("haas_vf2", set={"tool.1.radius_mm": 2}))
    assert [each.id for each in one.diagnostics if each.severity == "error"] == ["tool-unknown"]


def test_a_code_of_the_machine_file_alone_is_done_as_it_says():
    machine = mill("g.203.action=ignore", "g.332_p2.action=tolerance", "g.332_p2.tolerance_mm=0.2")
    text = f"{HEAD}G203 P1\nG332 P2 K9.\nG1 X1. F100.\nM30\n"
    assert told(text, machine)["tolerance_mm"][-2] == 0.2
    assert decode(f"{HEAD}G203 P1 G1 X5.\nM30\n", machine)[1] == [("modal-group", 4)]
    assert decode(f"{HEAD}G203 P1\nM30\n", mill())[1] == [("g-unknown", 4)]


@pytest.mark.parametrize(
    ("change", "key"),
    [
        ("g.x.action=ignore", "g.x"), ("g.5_1_r3.action=ignore", "g.5_1_r3"),
        ("g.62.tolerance_mm=0.1", "g.62.action"), ("work.p.0.x_mm=1", "work.p.0"),
        ("work.p.301.x_mm=1", "work.p.301"), ("dialect.skip_switches=20", "skip_switches"),
    ],
)  # fmt: skip
def test_a_wrong_name_in_the_machine_file_is_told(change, key):
    with pytest.raises(pycnc.MachineFileError) as told:
        mill(change)
    assert key in str(told.value)


# ---- work systems

FURTHER = ("G54.1 P{0}", "G54 P{0}", "G154 P{0}", "G{1}")


@pytest.mark.parametrize("seed", SEEDS)
def test_further_work_systems_are_work_systems(seed):
    rng = random.Random(seed)
    places = {n: [rng.randint(-90, 90) for _ in range(3)] for n in (1, 2, 5)}
    systems = dict(zip(places, ("g55", "g56", "g57"), strict=True))
    key = {name: f"work.{name}" for name in systems.values()}
    changes = [f"{stem}.{axis}_mm={at}" for n, place in places.items()
               for stem in (f"work.p.{n}", key[systems[n]])
               for axis, at in zip("xyz", place, strict=True)]  # fmt: skip
    further, common = [], []
    for _ in range(8):
        n, kind = rng.choice(list(places)), rng.random()
        if kind < 0.3:
            words = f"X{rng.randint(-9, 9)}. Z{rng.randint(-9, 9)}."
            mode = rng.choice(("G90", "G91"))
            further += [f"{mode} G10 L20 P{n} {words}", "G90"]
            common += [f"{mode} G10 L2 P{int(systems[n][1:]) - 53} {words}", "G90"]
        elif kind < 0.6:
            further.append(rng.choice(FURTHER).format(n, 109 + n))
            common.append(systems[n])
        elif kind < 0.7:
            further.append("G54")
            common.append("G54")
        line = move(rng)
        further.append(line)
        common.append(line)
    machine = mill(*changes)
    same(HEAD + "\n".join(further) + "\nM30\n", HEAD + "\n".join(common) + "\nM30\n", machine)


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("G54.1", "word-missing"), ("G54.1 P0", "number-range"), ("G54.1 P301", "number-range"),
        ("G154 P100", "number-range"), ("G10 L20 P0 X1.", "number-range"),
        ("G10 L20 P1 X1. R5.", "word-unused"), ("G112", "unsupported"), ("G130", "g-unknown"),
        ("G54.1 G4 P5", "word-shared"),
    ],
)  # fmt: skip
def test_a_work_system_that_is_none_is_refused(line, found):
    assert decode(f"{HEAD}{line}\nM30\n", mill())[1] == [(found, 4)]


def test_offsets_of_a_program_stay_for_the_next_one():
    nck = pycnc.Machine.load("mill3", set=FANUC)
    text = f"{HEAD}G10 L20 P7 X5.\nG54.1 P7\nG0 X0.\nM30\n"
    assert told(text, nck)["target_nm"][-2][0] == 5_000_000


# ---- cycles, compensation, skips

@pytest.mark.parametrize("seed", SEEDS)
def test_behind_g80_the_motion_before_the_cycle_goes_on(seed):
    rng = random.Random(seed)
    before = rng.choice(("G0", "G1"))
    cycle = rng.choice(("G81 Z-5. R2.", "G82 Z-5. R2. P50", "G83 Z-5. R2. Q1.5", "G85 Z-5. R2."))
    words = f"X{rng.randint(-9, 9)}. Y{rng.randint(-9, 9)}."
    begin = f"{HEAD}{before} X1. F200.\nG99 {cycle}\nX3.\n"
    plain, said = rng.choice(((f"G80 {words}", f"G80\n{before} {words}"),
                              (f"G80\n{words}", f"G80\n{before} {words}")))  # fmt: skip
    same(f"{begin}{plain}\nM30\n", f"{begin}{said}\nM30\n", mill())


def test_a_peck_rests_at_the_bottom_for_p():
    text = "G99 {} Z-5. R2. Q2. F100. {}\nX5.\nG80\nM30\n"
    for code in ("G83", "G73"):
        plain, rests = (told(HEAD + text.format(code, p), mill()) for p in ("", "P250"))
        dwells = rests[rests["kind"] == lib.NCK_BLOCK_DWELL]
        np.testing.assert_array_equal(rests[rests["kind"] != lib.NCK_BLOCK_DWELL], plain)
        assert dwells["dwell_s"].tolist() == [0.25, 0.25]
        assert set(dwells["target_nm"][:, 2]) == {-5_000_000}


def test_a_peck_without_a_point_needs_the_machine_to_say_its_unit():
    text = f"{HEAD}G99 G83 Z-5. R2. Q2000 F100.\nG80\nM30\n"
    assert decode(text, mill())[1] == [("scale-unit", 4)]
    same(text, text.replace("Q2000", "Q2."), mill("dialect.integers=increments"))


def test_h_names_the_radius_where_no_d_does():
    text = "{} {} G1 X10. F200.\nX30.\nY30.\nG40 Y50.\nM30\n"
    for side in ("G41", "G42"):
        same(HEAD + text.format(side, "H1"), HEAD + text.format(side, "D1"), mill())
    both = f"{HEAD}G43 H1 G41 D1 G1 X10. F200.\nG40 X50.\nM30\n"
    assert decode(both, mill())[1] == []


@pytest.mark.parametrize("seed", SEEDS)
def test_what_stands_behind_a_slash_is_skipped_by_its_switch(seed):
    rng = random.Random(seed)
    on = set(rng.sample(range(1, 10), rng.randint(0, 3)))
    with_slashes, plain = [], []
    for _ in range(10):
        number, in_middle = rng.randint(0, 9), rng.random() < 0.5
        skips, digit = (number or 1) in on, str(number or "")
        x, y = f"X{rng.randint(-50, 50)}.", f"Y{rng.randint(-50, 50)}."
        with_slashes.append(f"G0 {x} /{digit} {y}" if in_middle else f"/{digit} G0 {x}")
        plain.append(f"G0 {x if in_middle or not skips else ''} "
                     f"{y if in_middle and not skips else ''}")  # fmt: skip
    machine = mill(f"dialect.skip_switches={''.join(map(str, on))}")
    ends = (HEAD, "M30\n")
    same("\n".join(["", *with_slashes, ""]).join(ends), "\n".join(["", *plain, ""]).join(ends),
         machine)  # fmt: skip


def test_block_skip_is_for_every_number_and_for_the_rest_of_a_line():
    text = f"{HEAD}/5 G0 X7.\nG0 X1. /Y2.\nM30\n"
    same(text, f"{HEAD}G0 X1.\nM30\n", mill("dialect.block_skip=true"))
    assert decode(f"{HEAD}G0 X1. /Y2.\n", Machine.load("mill3"))[1] == [("character", 4)]


def test_clocks_and_switches_of_the_operator_change_no_path():
    text = "#3001=0\nG0 X1. #3003=1\n#3004=7\nX2.\nM30\n"
    same(HEAD + text, f"{HEAD}G0 X1.\nX2.\nM30\n", mill())


def waiting(rng):
    """Return two texts: one that waits by #3001 and asks for the day, and what is left of it."""
    texts, day = [[], []], rng.randrange(1, 29)
    for n in range(rng.randrange(1, 6)):
        begin, wait, x = rng.randrange(2000), rng.randrange(300), rng.randrange(90)
        loop = rng.choice([f"N{n + 1} IF[#3001LT{begin + wait}]GOTO{n + 1}",
                           f"WHILE[#3001LT{begin + wait}]DO1\nEND1"])
        texts[0] += [f"#3001={begin}", loop, f"X[{x}.+#3001-{begin + wait}] Y[#3011-20301200]"]
        texts[1] += [f"X{x + 1}. Y{day}."]
    return [HEAD + "\n".join([*lines, "M30", ""]) for lines in texts], day


@pytest.mark.parametrize("seed", SEEDS)
def test_a_wait_by_a_clock_ends_and_the_day_is_the_machine_s(seed):
    (text, other), day = waiting(random.Random(seed))
    machine = mill(f"dialect.clock=2030-12-{day:02} 06:05:04")
    same(text, other, machine)
    assert decode(text, machine)[2] == ["timer-read"]
    assert decode(text, mill())[2] == ["timer-read", "assumed-clock"]
    assert decode(f"{HEAD}X#3012\n", machine)[0]["target_nm"][-2][0] == 60504 * 10**6


# ---- holes on a circle

def ringed(rng):
    """Return two texts: holes by G70 and G71, and the same one by one."""
    x, y = (round(rng.uniform(-30, 30), 3) for _ in range(2))
    cycle = rng.choice(["G81 Z-5. R2. F90.", "G83 Z-5. R2. Q1.5 F90.", "G82 Z-4. R1. P200 F80.",
                        "G76 Z-4. R1. Q.2 F80.", "G84 Z-6. R3. F900."])  # fmt: skip
    level, at = rng.choice([98, 99]), f"G0 X{x} Y{y}"
    lines, plain = [f"{at} Z12.", f"G{level} {cycle} L0"], [f"{at} Z12.", f"G{level} {cycle} L0"]
    for _ in range(rng.randrange(1, 4)):
        radius, first = round(rng.uniform(1, 30), 3), rng.choice([0, 15, -90, 90, 33.3])
        count, whole = rng.randrange(1, 9), rng.random() < 0.5
        step = 360 / count if whole else rng.choice([30, -45, 7.5, 90])
        centre = ""
        if rng.random() < 0.5:
            x, y = (round(rng.uniform(-30, 30), 3) for _ in range(2))
            centre = f" X{x} Y{y}"
        else:
            centre = f" X{x} Y{y}" if len(lines) > 2 else ""
        words = f"I{radius} J{float(first)} L{count}" + ("" if whole else f" K{float(step)}")
        lines.append(f"G{70 if whole else 71}{centre} {words}")
        for k in range(count):
            angle = np.radians(first + k * step)
            plain.append(f"X{x + radius * np.cos(angle):.9f} Y{y + radius * np.sin(angle):.9f}")
    ends = ["G80", "G0 X1. Y1.", "M30", ""]
    return "\n".join([HEAD, *lines, *ends]), "\n".join([HEAD, *plain, *ends])


@pytest.mark.sample(40)
@pytest.mark.parametrize("number", range(400))
def test_holes_on_a_circle_are_those_that_are_said_one_by_one(number, draw_seed):
    ring, plain = ringed(random.Random(draw_seed + number))
    one, other = told(ring, mill()), told(plain, mill())
    assert one["kind"].tolist() == other["kind"].tolist(), ring
    away = one["target_nm"].astype(np.int64) - other["target_nm"].astype(np.int64)
    assert np.abs(away).max() <= 1, ring


@pytest.mark.parametrize(("lines", "found"), [
    ("G70 I5. L4", "no-motion"), ("G81 Z-5. R2. F90. L0\nG70 I5.", "word-missing"),
    ("G81 Z-5. R2. F90. L0\nG71 I5. L4", "word-missing"),
    ("G81 Z-5. R2. F90. L0\nG70 I5. K9. L4", "word-unused"),
    ("G81 Z-5. R2. F90. L0\nG70 I-5. L4", "number-range"),
    ("G81 Z-5. R2. F90. L0\nG70 I5. L4.5", "number-range"),
    ("G81 Z-5. R2. F90. L0\nG70 I5. L1001", "number-range"),
    ("G81 Z-5. R2. F90. L0\nG72 I5. J30. L4", "unsupported"),
    ("G81 Z-5. R2. F90. L0\nG68 X0. Y0. R9.\nG70 I5. L4", "layout-on"),
    ("G80\nG70 I5. L4", "no-motion"), ("G1 X2. F90.\nG71 I5. K9. L4", "no-motion"),
])  # fmt: skip
def test_a_circle_of_holes_that_is_none_has_one_error(lines, found):
    text = f"{HEAD}{lines}\n"
    assert decode(f"{text}M30\n", mill())[1] == [(found, text.count("\n"))]


def test_a_circle_behind_a_cycle_that_is_refused_has_no_error_of_its_own():
    text = f"{HEAD}G81 X1. Z-5. F90.\nG70 I5. L4\nG80\nM30\n"
    assert decode(text, mill())[1] == [("word-missing", 4)]


# ---- boring

def bored(rng):
    """Return two texts: holes by G76 and G87, and the same by plain words."""
    lines, plain, at, shift = ["G0 Z20."], ["G0 Z20."], 20.0, ""
    for k in range(6):
        x, y, low, high = (round(rng.uniform(-40, 40), 3) for _ in range(4))
        low, high = sorted((low - 50, high - 50))
        code, level = rng.choice((76, 87)), rng.choice((98, 99))
        if k == 0 or rng.random() < 0.7:
            shift, aside = rng.choice((("Q0.5", (0.5, 0)), ("I-0.25 J0.75", (-0.25, 0.75))))
        r, depth = (high, low) if code == 76 else (low, high)
        back = r if (code, level) == (76, 99) else 20.0
        words = shift if k == 0 or rng.random() < 0.5 else ""
        if shift and not words and plain[-1] != shift:
            words = shift
        lines.append(f"G{level} G{code} X{x} Y{y} Z{depth} R{r} {words} P250 F90.")
        over, off = f"G0 X{x} Y{y}", f"G0 X{x + aside[0]:.3f} Y{y + aside[1]:.3f}"
        stop, cut = ["M5", "M19", off], [f"G1 Z{depth} F90.", "G4 P250"]
        if code == 76:
            rise = [f"G0 Z{r}"] if at < r else []
            plain += [*rise, over, f"G0 Z{r}", *cut, *stop, f"G0 Z{back}", over, "M3"]
        else:
            plain += [over, *stop, f"G0 Z{r}", over, "M3", *cut, *stop, "G0 Z20.", over, "M3"]
        at = back
    return lines, plain


@pytest.mark.parametrize("seed", SEEDS)
def test_boring_is_what_its_parts_are(seed):
    lines, plain = bored(random.Random(seed))
    machine, found = mill("m.19.action=output"), []
    for each in (lines, plain):
        blocks, errors, _ = decode(f"{HEAD}{chr(10).join(each)}\nG80\nM30\n", machine)
        assert errors == []
        steps = [tuple(block["target_nm"][:3]) for block in blocks]
        moved = [k == 0 or steps[k] != steps[k - 1] for k in range(len(steps))]
        found.append([
            (int(b["kind"]), steps[k], float(b["dwell_s"]), float(b["output"]["value"]),
             float(b["feed"]) if b["kind"] == 1 else 0.0)
            for k, b in enumerate(blocks) if b["kind"] > 1 or moved[k]
        ])  # fmt: skip
    assert found[0] == found[1]


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("G76 X1. Z-5. R1.", "word-missing"), ("G76 X1. Z5. R1. Q1.", "number-range"),
        ("G87 X1. Z-5. R1. Q1.", "number-range"), ("G76 X1. Z-5. R1. Q5", "scale-unit"),
        ("G76 X1. Z-5. R1. Q-1.", "number-range"), ("G18 G76 X1. Y-5. R1. I1.", "word-unused"),
        ("M5\nG76 X1. Z-5. R1. Q1.", "word-missing"), ("G76 X9. Z-5. R1. Q2.", "travel"),
    ],
)
def test_boring_that_cannot_be_done_moves_nothing(line, found):
    machine = mill("axis.x.max_mm=10")
    blocks, errors, _ = decode(f"{HEAD}F50.\n{line}\nM30\n", machine)
    assert [each[0] for each in errors] == [found]
    assert (blocks["kind"] <= 1).sum() == 1


# ---- probes

@pytest.mark.parametrize("seed", SEEDS)
def test_g31_is_a_probe_that_need_not_meet_anything(seed):
    rng = random.Random(seed)
    x, z = rng.uniform(-9, 9), rng.uniform(-9, 9)
    words = f"X{x:.3f} Z{z:.3f} F100."
    fanuc = f"G55 G31 {words}\nG1 X#5061 Y#5062 Z[#5063+1.]\nG0 Z9.\n"
    linuxcnc = f"G55 G38.3 {words}\nG1 X{x:.3f} Y#5062 Z[{z:.3f}+1.]\nG0 Z9.\n"
    zero = ["work.g55.x_mm=3", "work.g55.y_mm=-4"]
    same(HEAD + fanuc + "M30\n", HEAD + linuxcnc + "M30\n", mill(*zero),
         Machine.load("mill3", set=[*FREE, *zero]))  # fmt: skip
    after = f"{HEAD}G1 F50. X1.\nG31 Z0.\nX2.\nM30\n"
    same(after, after.replace("X2.", "G1 X2."), mill())


def test_g31_is_refused_where_probes_are():
    text = f"{HEAD}G31 Z0. F100.\nM30\n"
    assert decode(text, mill("dialect.probe=refused"))[1] == [("unsupported", 4)]


# ---- lathes

def lathe(*changes):
    free = [each for each in FREE if ".y." not in each]
    return Machine.load("cak6150n", set=[*free, "dialect.system=A", *changes])


def test_c_of_a_lathe_without_that_axis_cuts_a_corner_off():
    text = "G21\nG97 S500 M3\nG0 X20. Z0\nG1 Z-10. {} F.2\nX40.\nG0 X60.\nM30\n"
    same(text.format("C2."), text.format(",C2."), lathe())
    assert decode("G21\nG0 X20. C2.\nM30\n", lathe())[1] == [("word-unused", 2)]


def test_a_lathe_of_fanucs_begins_with_feed_per_revolution():
    text = "G21\nG97 S500 M3\nG1 X20. F.2\nM30\n"
    found, said = (stages.decode(text.encode(), lathe(*change))[0]["feed_mode"][-2]
                   for change in ((), ("dialect.feed=per_minute",)))  # fmt: skip
    assert (found, said) == (lib.NCK_FEED_PER_REV, lib.NCK_FEED_PER_MINUTE)
    assert "assumed-feed-mode" in decode(text, lathe())[2]


# ---- grbl's dialects

@pytest.mark.parametrize("code", ["M62 P1", "M63 P1", "M64 P0", "M65 P3", "M66 P1 L3 Q2",
                                  "M67 E1 Q20", "M68 E0 Q.5"])  # fmt: skip
def test_grbl_hands_ports_over_as_linuxcnc_does(code):
    text = f"G21 G90 G94\n{code}\nG0 X1\nM2\n"
    grbl, linuxcnc = (stages.decode(text.encode(), Machine.load(
        "mill3", set=[f"dialect.base={base}"]))[0] for base in ("grbl", "linuxcnc"))  # fmt: skip
    assert len(grbl) == 3
    np.testing.assert_array_equal(grbl[["kind", "output", "target_nm"]],
                                  linuxcnc[["kind", "output", "target_nm"]])  # fmt: skip


# ---- grbl's spindle


@pytest.mark.parametrize("seed", SEEDS)
def test_a_speed_above_the_spindles_is_clipped_in_grbl_and_wrong_elsewhere(seed):
    rng = random.Random(seed)
    most = rng.randrange(500, 3000)
    words = [rng.choice([rng.randrange(most), most, most + rng.randrange(1, 9000)])
             for _ in range(6)]  # fmt: skip
    text = "G21 G90 G94 G17\nM3 S{}\nG1 X1 F99\nS{}\nX2 S{}\nS{} M4\nX3\nS{}\nG0 X4 S{}\nM2\n"
    grbl = Machine.load("mill3", set=[*FREE, "dialect.base=grbl", f"spindle.rpm_max={most}"])
    clipped = [min(word, most) for word in words]
    blocks, errors, notes = decode(text.format(*words), grbl)
    assert errors == []
    assert notes.count("speed-clipped") == (max(words) > most)
    outputs = blocks["output"]["value"], decode(text.format(*clipped), grbl)[0]["output"]["value"]
    np.testing.assert_array_equal(*outputs)
    mill3 = Machine.load("mill3", set=[*FREE, f"spindle.rpm_max={most}"])
    lines = [found for found, _ in decode(text.format(*words), mill3)[1]]
    assert lines == ["number-range"] * sum(word > most for word in words)
    assert decode("G21\nM3 S-1\nM2\n", grbl)[1] == [("number-range", 2)]
    assert decode("G21\nM3 S1e15\nM2\n", grbl)[1] != []


@pytest.mark.parametrize("seed", SEEDS)
def test_steps_home_are_steps_of_a_mill_without_such_axes(seed):
    rng = random.Random(seed)
    letters, code = rng.sample("XYZ", rng.randrange(1, 4)), rng.choice(["G28", "G30"])
    steps = {letter: round(rng.choice([0, rng.uniform(-5, 5)]), 3) for letter in letters}
    plain = " ".join(f"{letter}{step}" for letter, step in steps.items())
    others = " ".join(f"{'UVW'['XYZ'.index(letter)]}{step}" for letter, step in steps.items())
    before, after = f"{HEAD}G1 X5. Y-7. F100.\n", "\nX1. Y1.\nM30\n"
    machine = mill("home.g30.z_mm=0")
    same(f"{before}{code} {others}{after}", f"{before}G91 {code} {plain}\nG90{after}", machine)
    same(f"{before}G91\n{code} {others}{after}", f"{before}G91 {code} {plain}{after}", machine)
    assert decode(f"{before}U1.\n", machine)[1] == [("axis-unknown", 5)]
