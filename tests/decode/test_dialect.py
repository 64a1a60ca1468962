# SPDX-License-Identifier: MIT
"""The dialect that a text is read as where the machine leaves it open."""

import pytest
from cases import CORPUS, CORPUS_FILES

import pycnc
from pycnc.machine.rows import DIALECTS
from pycnc.program import guess

SIGNS = [
    (b";FLAVOR:Marlin\nG1 X1\n", "marlin", 1),
    (b"G21\nM104 S200\n", "marlin", 2),
    (b"G0 X1\nG1 X2 E0.5\n", "marlin", 2),
    (b"o<cut> sub\no<cut> endsub\n", "linuxcnc", 1),
    (b"%\nO100 CALL [1]\n", "linuxcnc", 2),
    (b"G0 X#<wide>\n", "linuxcnc", 1),
    (b"G64 P0.01\n", "linuxcnc", 1),
    (b"%\nO0100 (PART)\nG0 X1\n", "fanuc", 2),
    (b"%\n:0100\nG0 X1\n", "fanuc", 2),
    (b"G0 X1\nN5 IF [#1 EQ 2] GOTO 9\n", "fanuc", 2),
    (b"G0 X1\n/M98 P100\n", "fanuc", 2),
    (b"G61.1\nG05.1 Q1\nG1 X1.\n", "fanuc", 2),
    (b"G0 X1.\nN4 G54.1 P3\n", "fanuc", 2),
    (b"G187 P1 E.02\n", "fanuc", 1),
    (b"G61.1\nG5 X1 Y1 I1 J1 P1 Q1\n", "linuxcnc", 0),
    (b"(for Grbl)\nG0 X1\n", "grbl", 1),
    (b"G0 X1\n(O0100)\nG1 X2 F9\n", "linuxcnc", 0),
    (b"", "linuxcnc", 0),
]
FANUC = ("fanuc", "haas")


@pytest.mark.parametrize(("text", "dialect", "line"), SIGNS)
def test_a_sign_of_a_dialect_decides(text, dialect, line):
    found = guess.dialect_of(text)
    assert found[:2] == (dialect, line)
    assert dialect in DIALECTS


@pytest.mark.parametrize("file", CORPUS_FILES, ids=str)
def test_the_corpus_is_read_as_what_it_is(file):
    if not file.path.exists():
        pytest.skip(f"no corpus file in {CORPUS}")
    dialect, _, _ = guess.dialect_of(file.path.read_bytes())
    shop = any(name in file.file for name in FANUC) and "m98_vars" not in file.file
    printer = file.file.startswith("print_")
    assert dialect == ("fanuc" if shop else "marlin" if printer else "linuxcnc")


def test_a_program_says_what_was_chosen_and_reads_it_so():
    text = "%\nO0100\nG21 G90 G0 X1\nG4 P1500\nM30\n%\n"
    program = pycnc.load(text, dialect="auto")
    note = program.diagnostics.as_list()[0]
    assert (note["id"], note["severity"], note["line"]) == ("dialect-auto", "note", 2)
    assert "fanuc" in note["message"] and "linuxcnc" in note["help"]
    assert program.machine.settings.dialect.base == "fanuc"
    assert program.blocks["dwell_s"].max() == 1.5
    assert pycnc.load(text).machine.settings.dialect.base == "linuxcnc"


REMEDIES = (
    ("cak6150n", "A", "G82 Z-20 R5 F1.5", "unsupported", "with P it rests"),
    ("cak6150n", "A", "G83 W-20. F1.5", "incremental", "its depth by Z, or X"),
    ("cak6150n", "B", "F99 G75 X-9. P5000 R1.", "unsupported", "a line of its own"),
    ("cak6150n", "A", "G83 Z-20. R5. F.1", "number-range", "a step from where the drill stands"),
    ("mill3", "A", "G88 X1 Z-20 R5 F99", "unsupported", "use G86"),
    ("mill3", "A", "G30 P3 Z0", "unsupported", "home.g30_p3.z_mm"),
    ("mill3", "A", "G10 L12 P1 R3.", "unsupported", "dialect.d_offset"),
    ("mill3", "A", "G10 L3 P1 R3.", "unsupported", "tool.N.length_mm"),
    ("mill3", "A", "G10 L2 P1 R30.", "unsupported", "G68"),
    ("mill3", "A", "#2001=3.", "unsupported", "G10"),
    ("mill3", "A", "G0 X1. #5221=3.", "word-shared", "a line of its own"),
    ("mill3", "A", "G65 P9 J1. I2.", "unsupported", "in this order"),
)


@pytest.mark.parametrize(("machine", "system", "line", "name", "remedy"), REMEDIES)
def test_what_is_refused_says_what_to_do(machine, system, line, name, remedy):
    change = ["dialect.base=fanuc", f"dialect.system={system}"]
    program = pycnc.load(f"G21\n{line}\nM30\n", pycnc.Machine.load(machine, set=change))
    (found,) = [each for each in program.diagnostics if each.severity == "error"]
    assert (found.id, found.line) == (name, 2)
    assert remedy in found.help


@pytest.mark.parametrize(("code", "remedy"), [("G88", "use G86"), ("G87", "bore from above")])
def test_a_lathe_of_rs274ngc_has_the_remedies_of_its_language(code, remedy):
    machine = pycnc.Machine.load("cak6150n", set=["dialect.base=linuxcnc"])
    program = pycnc.load(f"G21 G18\n{code} X1 Z1 Y-20 R5 F99\nM2\n", machine)
    (found,) = [each for each in program.diagnostics if each.severity == "error"]
    assert remedy in found.help


def test_further_reference_points_are_the_machines():
    change = ["dialect.base=fanuc", "home.g30_p3.z_mm=-5", "home.g30_p4.x_mm=7"]
    machine = pycnc.Machine.load("mill3", set=change)
    blocks = pycnc.load("G21 G90 G0 X1 Y1 Z0\nG30 P3 Z0\nG30 P4 X2\nM2\n", machine).blocks
    assert blocks["target_nm"][[2, 4], :3].tolist() == [
        [1_000_000, 1_000_000, -5_000_000], [7_000_000, 1_000_000, -5_000_000]
    ]  # fmt: skip


# Lengths without a point

def targets(text, **settings):
    said = {f"dialect.{key}": each for key, each in settings.items()}
    changes = {"dialect.base": "fanuc", **said}
    machine = pycnc.Machine.load("mill3", set=changes)
    program = pycnc.Program(text.encode(), machine)
    places = program.blocks["target_nm"][program.blocks["kind"] <= 1, :3] / 1e6
    return places.tolist(), [each.id for each in program.diagnostics]


@pytest.mark.parametrize(
    ("integers", "lines", "found", "notes"),
    [
        ({}, "G0 X100 Z-2.\nG1 Y-50 F100", [[100, 0, -2], [100, -50, -2]], ["assumed-integers"]),
        ({"integers": "units"}, "G0 X100 Z-2.\nG1 Y-50 F100", [[100, 0, -2], [100, -50, -2]], []),
        ({"integers": "increments"}, "G0 X100 Z-2.\nG1 Y-50 F100",
         [[0.1, 0, -2], [0.1, -0.05, -2]], []),
        ({"integers": "increments"}, "G20 G0 X100\nY1.", [[0.254, 0, 0], [0.254, 25.4, 0]], []),
        ({"integers": "increments"}, "#1=100\nG0 X#1\nY[2*3]", [[100, 0, 0], [100, 6, 0]], []),
        ({}, "G0 X0 Y0\nX1.5 Y2.", [[0, 0, 0], [1.5, 2, 0]], []),
    ],
)  # fmt: skip
def test_what_a_length_without_a_point_counts_is_told_and_may_be_said(
    integers, lines, found, notes
):
    start = "G17 G90" if "G20" in lines else "G17 G21 G90"
    places, said = targets(f"{start}\n{lines}\nM30\n", **integers)
    assert places == [pytest.approx(each) for each in found]
    assert said == notes


@pytest.mark.parametrize(
    ("line", "same"),
    [
        ("G68 X0 Y0 R30000\nG1 X1000 Y2000 F99", "G68 X0 Y0 R30.\nG1 X1. Y2. F99"),
        ("G16\nG1 X9000 Y30000 F99", "G16\nG1 X9. Y30. F99"),
        ("G1 F99 X9000,R2000\nY9000", "G1 F99 X9.,R2.\nY9."),
        ("G83 Z-9000 R1000 Q2000 F99", "G83 Z-9. R1. Q2. F99"),
        ("G4 X1500", "G4 X1.5"),
        ("G4 P1500", "G4 X1.5"),
    ],
)
def test_increments_are_what_all_lengths_angles_and_dwells_count(line, same):
    machine = pycnc.Machine.load(
        "mill3", set={"dialect.base": "fanuc", "dialect.integers": "increments"}
    )
    programs = [
        pycnc.load(f"G21 G17 G90\n{text}\nM30\n", machine).blocks for text in (line, same)
    ]
    assert programs[0].tobytes() == programs[1].tobytes()


@pytest.mark.parametrize(
    ("line", "same"),
    [
        ("G92 X18000 Z-20000 R500 F2.", "G92 X18. Z-20. R.5 F2."),
        ("G76 X18000 Z-20000 I500 K1000 D.3 F2. A60", "G76 X18. Z-20. I.5 K1. D.3 F2. A60"),
        ("G76 P010060 Q50 R100\nG76 X18000 Z-20000 R500 P1000 Q300 F2.",
         "G76 P010060 Q50 R.1\nG76 X18. Z-20. R.5 P1000 Q300 F2."),
        ("G75 R500\nG75 X10000 Z-20000 P2000 Q3000 F.1", "G75 R.5\nG75 X10. Z-20. P2000 Q3000 F.1"),
    ],
)  # fmt: skip
def test_increments_are_what_cycles_of_lathes_count(line, same):
    change = ["dialect.base=fanuc", "dialect.system=A", "dialect.integers=increments"]
    machine = pycnc.Machine.load("cak6150n", set=change)
    start = "G21 G99\nM3 S300\nG0 X30. Z9."
    loads = [pycnc.load(f"{start}\n{text}\nM30\n", machine) for text in (line, same)]
    assert [each.id for each in loads[0].diagnostics if each.severity == "error"] == []
    assert loads[0].blocks.tobytes() == loads[1].blocks.tobytes()


def test_centres_count_as_ends_do():
    text = "G17 G21 G90\nG1 Y1000 F100\nG2 X1000 Y0 I0 J-1000\nG1 X-5000\nM30\n"
    arcs = text.replace("1000", "1.").replace("5000", "5.")
    assert targets(text, integers="increments") == targets(arcs)
