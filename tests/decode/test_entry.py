# SPDX-License-Identifier: MIT
"""Rooms 1 and 2: a program that begins in the middle goes on as the whole one would."""

import cases
import entering
import entering_families
import numpy as np
import pytest
from sampling import cheap_first

import pycnc
from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

EVERYTHING = """G21 G17 G90 G94 F500
T2 M6 G43
S900 M4
M8
G0 X10 Y10 Z50
G55 G91.1
G1 Z-1 F300
G2 X20 Y20 I5 J5
G91 G1 X5 M7
#<n> = 3
o1 while [#<n> gt 0]
  X1 S[900 + #<n>]
  #<n> = [#<n> - 1]
o1 endwhile
G90 G98 G81 X40 Z-5 R2
X50
G80 M9
G64 P0.1
G20 G1 X2
G21 T3
M5
G0 Z40
M2
"""


TURNED = """G21 G18 G99
G50 S2000
T0202
G96 S120 M3
G0 X60 Z2 M8
G1 Z-10 F0.2
G50 X0 Z5
U4 W-2
G90 X50 Z-20
X46
G97 S600
G92 X44 Z-15 F1.5
X43
G74 R0.5
G74 Z-20. X40. P1000 Q4000 F0.1
G98 F200
G0 X70 Z9
G28 U0 W0
M30
"""
LATHE = ("dialect.base=fanuc", "dialect.system=A", "tool.2.x_mm=3", "tool.2.length_mm=-7")


def whole(machine, text):
    blocks, diagnostics = stages.decode(text, machine)
    assert not (diagnostics["code"] < 0).any()
    return blocks


def entered(name, text, line, settings=()):
    """Return the blocks of a text from a line on, and the first error."""
    machine = Machine.load(name, set=[*settings, f"dialect.from_line={line}"])
    blocks, diagnostics = stages.decode(text, machine)
    errors = diagnostics[diagnostics["code"] < 0]
    return blocks, [status_id(int(each["code"])) for each in errors]


def parted(line):
    """Return the blocks of the whole program before a line and from it on, and those entered."""
    text = EVERYTHING.encode()
    full = whole(Machine.load("mill3"), text)
    first = int(np.argmax(full["line"] >= line))
    blocks, errors = entered("mill3", text, line)
    assert errors == []
    return full[:first], full[first:], blocks


@pytest.mark.parametrize("line", range(1, EVERYTHING.count("\n") + 1))
def test_from_every_line_on_the_blocks_are_those_of_the_whole_program(line):
    before, rest, blocks = parted(line)
    assert (blocks[-len(rest) :] == rest).all()
    entry = blocks[: -len(rest)]
    moves = before[before["kind"] <= lib.NCK_BLOCK_ARC]
    if len(moves):  # the tool comes to where it would be
        assert (entry[-1]["target_nm"] == moves[-1]["target_nm"]).all()


@pytest.mark.parametrize("line", range(2, TURNED.count("\n") + 1))
def test_a_lathe_enters_with_its_zero_tool_and_modes(line):
    text = TURNED.encode()
    full = whole(Machine.load("cak6150n", set=LATHE), text)
    first = int(np.argmax(full["line"] >= line))
    blocks, errors = entered("cak6150n", text, line, LATHE)
    assert errors == []
    assert (blocks[-len(full[first:]) :] == full[first:]).all()
    assert in_force(blocks[: len(blocks) - len(full[first:])]) == in_force(full[:first])


def in_force(blocks):
    """Return the last speed (G96, G97), spindle and coolant words, and the tool, of outputs."""
    state = {}
    for block in blocks[(blocks["kind"] == lib.NCK_BLOCK_OUTPUT)
                        | (blocks["kind"] == lib.NCK_BLOCK_WAIT)]:  # fmt: skip
        kind, value = int(block["output"]["kind"]), float(block["output"]["value"])
        if kind == lib.NCK_OUTPUT_M and value == 9:
            state.pop(7, None), state.pop(8, None)
        group = {3: 5, 4: 5}.get(value, value) if kind == lib.NCK_OUTPUT_M else -1 - kind
        if not (kind == lib.NCK_OUTPUT_M and value in (6, 9)):
            speeds = (lib.NCK_OUTPUT_SPINDLE_SPEED, lib.NCK_OUTPUT_SURFACE_SPEED)
            state["speed" if kind in speeds else group] = (kind, value) if kind in speeds else value
    if state.get(5) == 5:
        del state[5]
    return state


@pytest.mark.parametrize("line", range(5, EVERYTHING.count("\n") + 1))
def test_tool_spindle_and_coolant_are_those_of_the_line(line):
    before, rest, blocks = parted(line)
    assert in_force(blocks[: len(blocks) - len(rest)]) == in_force(before)


def test_what_a_line_cannot_be_is_told():
    mill = lambda text, line: entered("mill3", text.encode(), line)[1]  # noqa: E731
    assert mill("G21 G90 G0 X1\nX2\nM2\n", 4) == ["label-missing"]


def way(name, text, line, *settings):
    """Return the moves of the way in: (kind, places of X Y Z) [mm]."""
    blocks, errors = entered(name, text.encode(), line, settings)
    assert errors == []
    moves = blocks[np.isin(blocks["kind"], entering.MOVES) & (blocks["line"] == line)][:3]
    places = (moves["target_nm"][:, :3] + moves["tool_nm"]) / 1e6
    return [(int(kind), *place) for kind, place in zip(moves["kind"], places.tolist(), strict=True)]


BEHIND_A_CHANGE = "G21 G90 G17\nT2 M6\nG0 X10 Y20 Z5\nG1 Z-1 F300\nG1 X40\nG1 Y0\nM2\n"
RAPID, LINE = lib.NCK_BLOCK_RAPID, lib.NCK_BLOCK_LINE


def test_the_tool_leaves_first_crosses_above_and_goes_in_at_a_feed():
    ways = {"": 200.0, "approach.height_mm=80": 80.0}
    for setting, high in ways.items():
        told = way("mill3", BEHIND_A_CHANGE, 5, *[setting] * bool(setting))
        assert told == [(RAPID, 0, 0, high), (RAPID, 10, 20, high), (LINE, 10, 20, -1)]
    blocks, _ = entered("mill3", BEHIND_A_CHANGE.encode(), 5, ["approach.feed_mm_min=250"])
    inward = blocks[(blocks["kind"] == LINE) & (blocks["line"] == 5)][0]
    assert (inward["feed_mode"], inward["path_mode"]) == (0, 1)
    assert inward["feed"] == pytest.approx(250, rel=1e-12)


def test_the_tool_never_goes_towards_the_work_before_it_goes_in():
    above = BEHIND_A_CHANGE.replace("Z5", "Z150").replace("Z-1", "Z120")
    told = way("mill3", above, 5, "approach.height_mm=80")
    assert told == [(RAPID, 0, 0, 120), (RAPID, 10, 20, 120), (LINE, 10, 20, 120)]
    stands = ["start.z_mm=190", "approach.height_mm=80"]
    assert [z for *_, z in way("mill3", BEHIND_A_CHANGE, 5, *stands)] == [190, 190, -1]


def test_tool_spindle_and_coolant_come_where_they_are_safe():
    text = BEHIND_A_CHANGE.replace("M6", "M6\nS900 M3 M8").encode()
    blocks, errors = entered("mill3", text, 6)
    told = [
        "move" if block["kind"] in entering.MOVES
        else (int(block["output"]["kind"]), float(block["output"]["value"]))
        for block in blocks[blocks["line"] == 6]
    ]  # fmt: skip
    tool, m, speed = lib.NCK_OUTPUT_TOOL, lib.NCK_OUTPUT_M, lib.NCK_OUTPUT_SPINDLE_SPEED
    assert errors == [] and told == [
        "move", (tool, 2), (m, 5), (m, 6), "move", (speed, 900), (m, 3), (m, 8), "move", "move"
    ]  # fmt: skip


BORE = "G21 G18 G99\nT0202\nG97 S600 M3\nG0 X30 Z2\nG1 Z-20 F0.2\nX34\nM30\n"


def test_a_lathe_leaves_along_x_or_for_a_bore_along_z():
    outside = way("cak6150n", BORE, 6, *LATHE)
    assert [(kind, x, z) for kind, x, _, z in outside] == [
        (RAPID, 250, 600), (RAPID, 250, 273), (LINE, 18, 273)
    ]  # fmt: skip
    inside = way("cak6150n", BORE, 6, *LATHE, "approach.axis=z", "approach.height_mm=700")
    assert [(kind, x, z) for kind, x, _, z in inside] == [
        (RAPID, 200, 700), (RAPID, 18, 700), (LINE, 18, 273)
    ]  # fmt: skip


def test_rotary_axes_turn_while_the_tool_is_away():
    text = "G21 G90\nG0 X10 A30 C90\nG1 Z-5 F100\nX20\nM2\n"
    blocks, errors = entered("mill5_xyzac", text.encode(), 4)
    away, across, inward = blocks[np.isin(blocks["kind"], entering.MOVES)][:3]["target_nm"]
    assert errors == []
    assert away.tolist() == [0, 0, 250_000_000, *[0] * 6]
    assert across[[3, 5]].tolist() == [30_000_000_000, 90_000_000_000]
    assert (inward - across).tolist() == [0, 0, -255_000_000, *[0] * 6]


def test_no_way_is_gone_where_the_tool_stands_already():
    text = b"G21 G90 F100\nM8\nG1 X10\nM2\n"
    blocks, errors = entered("mill3", text, 3, ["axis.z.max_mm=free"])
    assert errors == [] and blocks["kind"].tolist() == [lib.NCK_BLOCK_OUTPUT, LINE, 6]


def test_an_unknown_height_is_refused_with_words():
    machine = Machine.load("mill3", set=["axis.z.max_mm=free", "dialect.from_line=5"])
    error = pycnc.load(BEHIND_A_CHANGE, machine).diagnostics.shown[-1]
    assert (error.id, error.line, error.col, error.severity) == ("approach", 5, 1, "error")
    assert "Z" in error.message and "approach.height_mm" in error.help
    flat = "[axis.x]\nv_max_mm_s=9\na_max_mm_s2=9\nj_max_mm_s3=9\n[dialect]\nfrom_line=3\n"
    plotter = pycnc.load("G21 G90 F100\nG1 X5\nX9\nM2\n", Machine.from_text(flat))
    assert plotter.diagnostics.errors == 0  # it has no axis that could clear anything


@pytest.mark.parametrize(
    ("setting", "key"),
    [("approach.height_mm=201", "approach.height_mm"), ("approach.axis=u", "approach.axis"),
     ("approach.axis=a", "approach.axis"), ("approach.feed_mm_min=0", "approach.feed_mm_min")],
)  # fmt: skip
def test_an_approach_that_cannot_be_is_an_error_of_the_machine(setting, key):
    with pytest.raises(pycnc.errors.MachineError) as told:
        Machine.load("mill3", set=[setting])
    assert key in str(told.value)


def test_a_line_in_radius_compensation_is_entered_beside_the_contour():
    text = "G21 G90 T1 M6\nG0 X1\nG41 D1 G1 X20 F100\nX30\nX40\nG40 Y50\nM2\n"
    told = way("mill3", text, 5, "tool.1.radius_mm=3")
    assert told[1:] == [(RAPID, 30, 3, 200), (LINE, 30, 3, 0)]


def test_a_line_of_a_subprogram_is_entered_when_it_is_called():
    sub = "o1 sub\nG1 X#1\nG1 Y#1\no1 endsub\n"
    before = f"G21 G90 F100\n{sub}G1 Z-1\no1 call [7]\no1 call [9]\nM2\n"
    assert way("mill3", before, 4)[-1] == (LINE, 7, 0, -1)
    unused = before.replace("o1 call [7]", "").replace("o1 call [9]", "")
    assert entered("mill3", unused.encode(), 4)[1] == ["label-missing"]


def test_a_corner_before_the_line_belongs_to_it():
    text = "G21 G90 F100\nG1 X20 ,R5\nY20\nX0\nM30\n"
    blocks, errors = entered("mill3", text.encode(), 3, ["dialect.base=fanuc"])
    assert errors == [] and blocks["kind"].tolist() == [RAPID, RAPID, LINE, 2, LINE, LINE, 6]
    assert blocks["target_nm"][2][:2].tolist() == [15_000_000, 0]


def test_what_a_printer_has_put_out_is_not_put_out_again():
    text = "G21 G90\nG28\nG1 X50 Y50 Z0.2 E900 F1200\nX60 E901\n"
    blocks, errors = entered("printer", text.encode(), 4)
    assert errors == []
    assert blocks[np.isin(blocks["kind"], entering.MOVES)]["target_nm"][:, 6].tolist() == [
        0, 0, 0, 1_000_000
    ]  # fmt: skip


def test_the_rest_runs_within_all_limits_and_ends_where_the_whole_program_does():
    case = cases.CASES[0]
    lines = case.text.count("\n")
    machine = Machine.load(case.machine, set=[f"dialect.from_line={lines // 2}"])
    begun = pycnc.load(case.text, machine)
    assert begun.diagnostics.errors == 0
    everything = pycnc.load(case.text, case.machine)
    assert (begun.blocks[-1] == everything.blocks[-1]).all() if begun.block_count else False
    trace = pycnc.run(begun)
    assert all(peak["v"] <= 1 + 1e-9 for axis, peak in trace.summary["peaks"].items()
               if axis != "path")  # fmt: skip


@pytest.mark.sample(8)
@pytest.mark.parametrize("case", cases.CASES, ids=str)
def test_the_run_of_a_case_from_a_line_on_is_the_tail_of_the_whole_run(case, draw_seed):
    for line in entering.lines_of(case, 6, draw_seed):
        assert entering.findings(case, line) == [], f"line {line}"


@pytest.mark.sample(8)
@pytest.mark.parametrize("number", range(3))
@pytest.mark.parametrize("name", sorted(entering_families.FAMILIES))
def test_the_run_of_a_random_program_from_a_line_on_is_that_tail(name, number, draw_seed):
    case = entering_families.case(name, (draw_seed + number) % 1_000_000)
    for line in entering.lines_of(case, 6, draw_seed):
        assert entering.findings(case, line) == [], f"{case}, line {line}"


@pytest.mark.sample(3)
@pytest.mark.parametrize("file", cheap_first(
    [file for file in cases.RUNNING_FILES + cases.THREAD_FILES if file.file not in entering.SLOW],
    cases.DEAR_FILES), ids=str)  # fmt: skip
def test_the_run_of_a_file_of_the_corpus_from_a_line_on_is_that_tail(file, draw_seed):
    if not file.path.exists():
        pytest.skip(f"{file.path} is not here: the corpus lies beside the repository")
    for line in entering.lines_of(file, 2, draw_seed):
        assert entering.findings(file, line) == [], f"line {line}"
