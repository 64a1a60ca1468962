# SPDX-License-Identifier: MIT
"""Every code and parameter means what the language in force gives to it, or is refused by name."""

import random

import pytest
import tongues
from tongues import TONGUES, decode, machine_of

import pycnc
from pycnc.kernel.bind import lib

BITS = dict(zip(TONGUES, (
    lib.NCK_TONGUE_LINUXCNC, lib.NCK_TONGUE_FANUC, lib.NCK_TONGUE_TURNING, lib.NCK_TONGUE_GRBL,
    lib.NCK_TONGUE_MARLIN,
), strict=True))  # fmt: skip


@pytest.mark.parametrize("tongue", TONGUES)
@pytest.mark.parametrize(("letter", "table"), [("G", tongues.G), ("M", tongues.M)])
def test_a_code_is_its_languages_or_refused(letter, table, tongue):
    machine, read = machine_of(tongue), table[tongue]
    refused = tongues.refused_of(letter, read, machine)
    assert set(range(10000)) - set(refused) == read
    for tenths in read:
        errors = decode(f"{tongues.spelled(letter, tenths)}\n", machine)[1]
        assert not [each for each in errors if each[0] in tongues.UNKNOWN], tenths / 10
    for tenths, (name, whose) in refused.items():
        others = sum(BITS[other] for other in TONGUES if tenths in table[other])
        if others:
            assert name == "unsupported" or (whose & others) == others, tenths / 10


@pytest.mark.parametrize("letter", "GM")
def test_grblhal_has_grbls_words_and_most_of_linuxcncs(letter):
    machine, table = machine_of("grbl", **{"control.kind": "grblhal"}), vars(tongues)[letter]
    assert tongues.HAL[letter] < table["linuxcnc"]
    read = table["grbl"] | tongues.HAL[letter]
    refused = tongues.refused_of(letter, read, machine)
    assert set(range(10000)) - set(refused) == read


@pytest.mark.parametrize("tongue", ["linuxcnc", "fanuc", "turning"])
def test_a_parameter_of_the_control_is_told_or_refused(tongue):
    groups = {4001, 4002, 4003, 4005, 4006, 4109, 4119, 4120}
    machine = machine_of(tongue)
    if tongue == "linuxcnc":
        told = {*range(1, 5001), *range(5061, 5071), *range(5220, 5401), *range(5420, 5429)}
    else:
        axes, own = len(machine.axes), {4016} if tongue == "turning" else {4010}
        rows = [5001, 5021, 5041, 5061, 5201, *range(5221, 5341, 20)]
        told = {*range(1, 34), *range(100, 1000), *groups, *own, *range(3001, 3005),
                3007, 3008, 3011, 3012, 4014, *range(5401, 5501)}
        told |= {first + k for first in rows for k in range(axes)}
    numbers = range(1, 10000)
    text = "".join(f"#{33 if n != 33 else 32}=#{n}\n" for n in numbers)
    refused = {numbers[line - 1] for _, line, _ in decode(text, machine)[1]}
    assert set(numbers) - refused == told


@pytest.mark.parametrize("base", ["grbl", "marlin"])
@pytest.mark.parametrize("line", ["#1=2", "G0 X#1", "G0 X[1+2]", "O5 sub", "IF [1] GOTO 2"])
def test_languages_without_parameters_refuse_them(base, line):
    assert [each[0] for each in decode(f"G21 G90\n{line}\n", machine_of(base))[1]] == ["other-base"]


@pytest.mark.parametrize("first", range(0, 1000, 250))
@pytest.mark.sample(2)
def test_a_word_of_another_language_is_refused_where_it_stands(first):
    assert tongues.search(250, first)[1] == []


def test_a_refusal_names_line_column_and_whose_the_word_is():
    program = pycnc.load("G21 G90\nG0 X1 G7\nM60\nM30\n", machine_of("grbl"))
    errors = [each for each in program.diagnostics if each.severity == "error"]
    assert [(each.id, each.line, each.col) for each in errors] == [
        ("other-base", 2, 7), ("other-base", 3, 1)
    ]  # fmt: skip
    assert "linuxcnc" in errors[0].message and "--dialect linuxcnc" in errors[0].help
    assert "m.60.action=output" in errors[1].help
    own = machine_of("grbl", **{"m.60.action": "output"})
    assert decode("G21 G90\nM60\nM30\n", own)[1] == []


def places(text, machine):
    blocks, errors = decode(text, machine)
    assert errors == []
    return (blocks[blocks["kind"] <= 1]["target_nm"][:, :3] / 1e6).tolist()


def test_5041_has_the_tools_length_in_it_and_5001_has_not():
    text = "G21 G90\nG43 H1 G0 Z10.\n#101=#5003\n#102=#5043\n#103=#5023\nG49 G0 X#101 Y#102 Z#103\n"
    assert places(text, machine_of("fanuc"))[-1] == [10, 15, 15]


def test_where_the_axes_are_is_open_beside_a_contour():
    text = "G21 G90\nG41 D1 G1 X5. F100.\n#101=#5041\nM30\n"
    assert [each[:2] for each in decode(text, machine_of("fanuc"))[1]] == [("comp-on", 3)]


def test_groups_of_lathes_are_their_own():
    text = "G21 G18\nG97 S100\n#101=#4002\n#102=#4016\n#103=#4005\nG0 X#101 Z#102\n"
    machine = machine_of("turning", **{"dialect.diameter": False, "dialect.feed": "per_minute"})
    at = [axis - zero for axis, zero in zip(places(text, machine)[-1], (0, 0, 300), strict=True)]
    assert at[::2] == [97, 18]


@pytest.mark.parametrize(
    ("text", "ends", "told"),
    [
        ("G0 X1\n(abort, stop here)\nG0 X50\nM2\n", [1], ["abort"]),
        ("G0 X1\nG0 X5 ( Abort,stop)\nM2\n", [1], ["abort"]),
        ("G0 X1\n(abort, a)(b)\nG0 X5\nM2\n", [1, 5], []),
        ("G0 X1\n(abort , a)\nG0 X5 ; (abort, b)\nM2\n", [1, 5], []),
        ("G0 X1\n/ (abort, a)\nM2\n", [1], ["abort"]),
        ("G0 X1\no1 if [1 gt 2]\n(abort, a)\no1 endif\nG0 X5\nM2\n", [1, 5], []),
        ("G0 X1\no1 if [2 gt 1] (abort, a)\nG0 X5\no1 endif\nM2\n", [1, 5], []),
    ],
)
def test_abort_ends_a_program_where_linuxcnc_ends_it(text, ends, told):
    program = pycnc.load(f"G21 G90\n{text}", machine_of("linuxcnc"))
    blocks = program.blocks
    moves = blocks[blocks["kind"] <= 1]["target_nm"][:, 0] / 1e6
    assert (moves.tolist(), [each.id for each in program.diagnostics]) == (ends, told)
    assert blocks[-1]["kind"] == lib.NCK_BLOCK_END
    assert pycnc.load(f"G21 G90 G17 {text}", machine_of("grbl")).diagnostics.counts["abort"] == 0


@pytest.mark.parametrize("line", ["(a (b) G0 X9", "G0 (a (b)) X9", "N5 (a) (b (c)"])
def test_a_comment_in_a_comment_is_refused_by_linuxcnc_alone(line):
    text = f"G21 G90\n{line}\nG0 X1\nM2\n"
    (found,) = decode(text, machine_of("linuxcnc"))[1]
    assert found[:2] == ("comment", 2)
    assert decode("G0 X1 ; (a (b)\nM2\n", machine_of("linuxcnc"))[1] == []


# LinuxCNC's number of a nose → Fanuc's
NOSES = {0: 0, 1: 4, 2: 3, 3: 2, 4: 1, 5: 5, 6: 8, 7: 7, 8: 6, 9: 9}


@pytest.mark.parametrize("number", NOSES)
def test_a_nose_is_numbered_as_its_language_does(number, tmp_path):
    text = "G21 G18 G8\nT1 M6\nG0 X30 Z20\nG42 G1 X20 Z1 F100\nZ-20\nG40 X34\nM30\n"
    there = pycnc.Machine.load("cak6150n", set={
        "dialect.base": "linuxcnc", "dialect.diameter": False, "tool.1.radius_mm": 0.4,
        "tool.1.orientation": number, "dialect.comp_start": "rs274",
        "dialect.feed": "per_minute",
    })  # fmt: skip
    here = pycnc.Machine.load(there, dialect="fanuc", set={"tool.1.orientation": NOSES[number]})
    table = tmp_path / "tool.tbl"
    table.write_text(f"T1 D0.8 Q{number}\n")
    listed = pycnc.Machine.load(here, tools=table)
    paths = [
        decode(text if machine is there else text.replace(" G8", "").replace("T1 M6", "T0101"),
               machine)
        for machine in (there, here, listed)
    ]  # fmt: skip
    noses = []
    for blocks, errors in paths:
        assert errors == []
        noses.append(blocks[blocks["kind"] == lib.NCK_BLOCK_LINE]["target_nm"].tolist())
    assert noses[0] == noses[1] == noses[2]
    turned = pycnc.Machine.load(listed, dialect="linuxcnc")
    assert int(turned.record["tool"][0]["orientation"]) == number


def test_the_tools_of_a_file_keep_their_noses_in_another_language():
    file = pycnc.Machine.load("cak6150n")
    other = pycnc.Machine.load(file, dialect="linuxcnc")
    both = zip(file.record["tool"]["orientation"], other.record["tool"]["orientation"], strict=True)
    assert all(NOSES[int(theirs)] == int(ours) for ours, theirs in both)


def test_m1_of_a_printer_waits_as_m0_does():
    for base, kind in (("marlin", lib.NCK_BLOCK_WAIT), ("linuxcnc", lib.NCK_BLOCK_OUTPUT)):
        assert decode("M1\n", machine_of(base))[0]["kind"][0] == kind


@pytest.mark.parametrize("sign", "$?~!")
@pytest.mark.parametrize("base", ["grbl", "linuxcnc"])
def test_what_a_sender_says_is_named_with_what_to_do(base, sign):
    text = f"G21 G90\nG0 X1\n{sign}H\nG0 X2\nM2\n"
    (found,) = [each for each in pycnc.load(text, "mill3", dialect=base).diagnostics
                if each.severity == "error"]  # fmt: skip
    assert (found.line, found.col, found.id) == (3, 1, "character")
    assert "says to grbl" in found.message and "take the line out" in found.help


@pytest.mark.parametrize("seed", range(20))
def test_a_spindle_of_linuxcnc_is_the_one_that_there_is(seed):
    pen = random.Random(seed)
    lines = ["G21 G90 F900", f"M3 $0 S{pen.randrange(1, 9000)}", "G1 X1", "S500 $0", "M5 $-1"]
    plain = [line.replace(" $0", "").replace(" $-1", "") for line in lines]
    one, other = (pycnc.load("\n".join([*each, "M2", ""]), "mill3") for each in (lines, plain))
    assert one.diagnostics.errors == 0
    assert one.blocks["output"].tolist() == other.blocks["output"].tolist()
    bad = pen.choice(["M3 $1 S9", "M3 $2", "M5 $-2"])
    (found,) = [each for each in pycnc.load(f"G21\n{bad}\nM2\n", "mill3").diagnostics
                if each.severity == "error"]  # fmt: skip
    assert (found.id, found.line, found.col) == ("number-range", 2, 4)
    assert "$0" in found.message and found.help


@pytest.mark.parametrize("name", [
    "_hal[plasmac.cut-feed-rate]", "_ini[TRAJ]MAX", "_hal[a]", "_vmajor", "_ccomp", "_Line",
    "_inverse_time", "_units_per_rev", "_spindle_cw", "_flood", "_abs_x", "_call_level",
])
def test_what_linuxcnc_alone_knows_is_refused_by_its_name(name):
    text = f"G21\nM190 P2\nF#<{name}>\nG0 X1\nM2\n"
    found = pycnc.load(text, "mill3").diagnostics
    assert found.counts["looks-like"] == 0
    (error,) = [each for each in found if each.id == "parameter-unset"]
    assert (error.line, error.help) == (3, "write the number in its place")
