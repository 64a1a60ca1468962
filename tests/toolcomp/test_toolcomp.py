# SPDX-License-Identifier: MIT
"""Room 2, toolcomp: the tool's centre beside the contour, judged by geometry and by rs274."""

import math
from pathlib import Path

import comp_gate
import contours
import numpy as np
import pytest
import rs274_oracle

from pycnc import stages
from pycnc.errors import ProgramError
from pycnc.kernel.bind import ffi, lib
from pycnc.machine import Machine
from pycnc.program import Program

CORPUS = Path(__file__).resolve().parents[3] / "shared" / "corpus"
FREE = tuple(f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max"))
MILL = Machine.load("mill3", set=FREE)
ROUNDING = 1e-3  # [mm] of the numbers in a program, and of setpoints
HEAD = contours.HEAD + "F1000\n"


def load(text, machine=MILL):
    """Return a checked program."""
    return Program(text.encode(), machine, file="part.ngc").check()


def error_of(text, machine=MILL):
    """Return the error that a program ends with."""
    with pytest.raises(ProgramError) as caught:
        load(text, machine)
    return caught.value


def found(program, name):
    """Return the findings of one id."""
    return [each for each in program.diagnostics if each.id == name]


def pieces_of(program):
    """Return the moves in the plane as elements, from the first one on."""
    pieces, at = [], 0j
    for block in program.blocks[program.blocks["kind"] <= lib.NCK_BLOCK_ARC]:
        end = complex(*block["target_nm"][:2]) / 1e6
        if block["kind"] == lib.NCK_BLOCK_ARC:
            centre = complex(*block["centre_mm"])
            pieces.append(contours.Element(at, end, centre, float(block["sweep_rad"])))
        elif end != at:
            pieces.append(contours.Element(at, end))
        at = end
    return pieces


def corners(program):
    """Return where the moves end, in the plane."""
    return [complex(np.round(piece.end, 6)) for piece in pieces_of(program)]


# What the contour demands


def test_elements_that_reverse_are_dropped_and_the_rest_is_told():
    program = load(
        HEAD + "G0 X-10 Y24\nG41.1 D6\nG1 X-10 Y14\nX-10 Y2\nX-9.4 Y0.6\nX-8 Y0\nX10\n"
        "G40 G1 Y20\nM2\n"
    )
    assert corners(program) == [-10 + 24j, -7 + 14j, -7 + 3j, 10 + 3j, 10 + 20j]
    (left,) = found(program, "comp-left")
    assert (left.line, left.severity) == (7, "warning")
    assert "line 8" in left.message
    assert f"{abs(-9.4 + 0.6j - (-7 + 3j)) - 3:.3f} mm" in left.message


SLOT = (
    "G0 X-10 Y-10\nG41.1 D{diameter}\nG1 X0 Y0\nX10\nY-10\n{behind}X14 Y-10\nY0\nX30\n"
    "G40 G1 Y20\nM2\n"
)


def test_a_slot_that_opens_out_behind_its_neck_is_an_error_with_both_lines():
    text = HEAD + SLOT.format(diameter=6, behind="X5\nY-30\nX19\nY-10\n")
    error = error_of(text)
    assert (error.id, error.line) == ("comp-gouge", 7)
    assert "2.000 mm into the contour of line 13" in str(error)
    assert not load(text.replace("D6", "D3.9")).diagnostics.errors


def test_a_slot_that_the_tool_does_not_enter_is_an_error():
    error = error_of(HEAD + SLOT.format(diameter=6, behind=""))
    # The path of line 7 goes down at X13, 1 mm beside the slot's other side.
    assert (error.id, error.line) == ("comp-gouge", 7)
    assert "2.000 mm into the contour of line 9" in str(error)


def test_many_short_elements_of_a_slot_are_no_inside_corner():
    down = "".join(f"Y-{0.5 * k}\n" for k in range(1, 20))
    up = "".join(f"Y-{9.5 - 0.5 * k}\n" for k in range(19))
    text = HEAD + f"G0 X-10 Y-10\nG41.1 D6\nG1 X0 Y0\nX10\n{down}X14\n{up}X30\nG40 G1 Y20\nM2\n"
    assert error_of(text).id == "comp-gouge"


def test_a_pocket_that_ends_in_its_inside_corner_is_an_error():
    text = "G0 X0 Y0\nG41.1 D6\nG1 X0 Y-20\nX20\nY20\nX-20\nY-20\nX0\nG40 G1 X0 Y0\nM2\n"
    assert not load(HEAD + text).diagnostics.errors
    corner = "G0 X0 Y0\nG41.1 D6\nG1 X20 Y-20\nY20\nX-20\nY-20\nX20\nG40 G1 X0 Y0\nM2\n"
    error = error_of(HEAD + corner)
    assert (error.id, error.line) == ("comp-gouge", 9)
    assert "3.000 mm into the contour of line 6" in str(error)


@pytest.mark.sample(18)
@pytest.mark.parametrize("seed", range(1, 7))
@pytest.mark.parametrize("family", comp_gate.FAMILIES)
def test_every_element_is_cut_or_told(family, seed, tool, tmp_path):
    tool("rs274")
    for each in range(10 * seed, 10 * seed + 10):
        case = comp_gate.case_of(family, each)
        for start in case.starts:
            assert comp_gate.fault_of(case, start)[1] == ""
    case = comp_gate.case_of(family, 10 * seed)
    if case.plane != 19 and "rs274" in case.starts:  # rs274 has no G19
        assert comp_gate.differs_from_rs274(case, tmp_path) == ""


def threadmill(radius):
    """Return the sweep of the helix of a real thread mill's program, and its end."""
    text = (CORPUS / "mill_haas_threadmill.nc").read_text().splitlines()
    moves = "\n".join(line.split(" ", 1)[1] for line in text[29:34])
    head = "G21 G17 G90 G91.1 G94\nT4 M6\nG0 X0 Y0 Z-12\n"
    machine = Machine.load("mill3", set=(*FREE, f"tool.4.radius_mm={radius}"))
    blocks = load(head + moves + "\nM2\n", machine).blocks
    helix = blocks[blocks["line"] == 7]
    return float(helix["sweep_rad"].sum()), int(helix["target_nm"][-1][2])


@pytest.mark.parametrize("radius", np.linspace(0.2, 1.9, 18).round(3))
def test_the_helix_of_a_thread_mill_is_whole(radius):
    if not (CORPUS / "mill_haas_threadmill.nc").exists():
        pytest.skip("no corpus")
    sweep, height = threadmill(radius)
    assert sweep == pytest.approx(2 * math.pi, abs=1e-3)
    assert height == -10_313_000


FAMILIES = {"terrain": 1, "inside": 1, "outside": -1}


def random_contour(family, seed):
    """Return (elements, radius, side, where the tool comes from, where it leaves to)."""
    rng, side = np.random.default_rng([seed, 7]), FAMILIES[family]
    radius, arcs = float(rng.choice([0.5, 1, 3, 6])), float(rng.choice([0, 0.3]))
    if family == "terrain":
        step, height = rng.choice([0.05, 0.1, 0.2]), rng.choice([0.02, 0.1, 0.3])
        form = radius * float(step), radius * float(height), arcs
        elements = contours.terrain(rng, 520, form, radius)
        return elements, radius, side, elements[0].start - 40 + 60j, elements[-1].end + 40 + 60j
    form = radius * float(rng.choice([8, 15])), float(rng.choice([0.02, 0.05, 0.1])), arcs
    elements = contours.flower(rng, 520, form, radius, side)
    away = elements[0].start * (0.3 if side > 0 else 2)
    return elements, radius, side, away, away


def no_room(elements, radius, side):
    """Tell whether more than R of the contour in a row, or at once, is out of the tool's reach."""
    q, row, most = np.linspace(0.02, 0.98, 15), 0.0, 0.0
    beside = np.array([each.points(q) + side * radius * each.left(q) for each in elements])
    far = contours.to_the_nearest(elements, beside.ravel()).reshape(beside.shape)
    for each, reached in zip(elements, (far >= radius - 1e-6).any(axis=1), strict=True):
        row = 0.0 if reached else row + abs(each.end - each.start)
        most = max(most, row)
    return most > radius


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("family", FAMILIES)
def test_the_tool_keeps_off_the_contour_and_touches_it_where_it_can(family, seed):
    elements, radius, side, entry, leave = random_contour(family, seed)
    text = contours.program(elements, radius, side, entry, leave)
    program = Program(text.encode(), MILL, file="part.ngc")
    if program.diagnostics.errors:
        assert no_room(elements, radius, side)
        return
    path = pieces_of(program)[2:-1]

    places = np.concatenate([piece.points(np.linspace(0, 1, 9)) for piece in path])
    assert contours.to_the_nearest(elements, places).min() >= radius - ROUNDING

    q = np.linspace(0.05, 0.95, 5)
    beside = [each.points(q) + side * radius * each.left(q) for each in elements]
    beside = np.concatenate(beside)
    ends = np.abs(beside - elements[0].start), np.abs(beside - elements[-1].end)
    beside = beside[np.minimum(*ends) > 5 * radius]  # where it leads in and out is cut short
    touches = contours.to_the_nearest(elements, beside) >= radius - 1e-6
    assert contours.to_the_nearest(path, beside[touches]).max(initial=0.0) <= ROUNDING


CLOSED = {
    "arcs lead in and out": (
        "G0 X10 Y20\nG42.1 D6\nG1 X10 Y10\nG2 X0 Y0 R10\nG1 X-30\nY-40\nX30\nY0\nX0\n"
        "G2 X-10 Y10 R10\nG40 G1 X-10 Y20\n"
    ),
    "lines cross at a corner": (
        "G0 X-20 Y-30\nG41.1 D6\nG1 X0 Y-10\nY50\nX80\nY0\nX-10\nG40 G1 X-30 Y-30\n"
    ),
    "three laps": (
        "G0 X0 Y0\nG41.1 D6\nG1 X20 Y0\n" + "Y20\nX-20\nY-20\nX20\nY0\n" * 3 + "G40 G1 X0 Y0\n"
    ),
    "a bore and its arcs": (
        "G0 X0 Y0\nG41.1 D6\nG1 X10 Y-10\nG3 X20 Y0 R10\nI-20 J0\nG3 X10 Y10 R10\nG40 G1 X0 Y0\n"
    ),
}


@pytest.mark.parametrize("name", CLOSED)
def test_a_contour_that_meets_itself_is_run_through_whole(name):
    text = HEAD + CLOSED[name]
    program = load(text + "M2\n")
    assert not found(program, "comp-left")
    lines = set(range(5, text.count("\n") + 1))
    assert set(program.blocks["line"].tolist()) >= lines


# What the program says


def test_outputs_feeds_and_other_axes_keep_their_place():
    program = load(
        HEAD + "G0 X0 Y-10\nG41.1 D4\nG1 X0 Y0\nY20\nM8\nX20 F300\nZ5\nG4 P1\nY0 Z9\n"
        "G40 G1 Z10\nX0 Y0\nM2\n"
    )
    rows = [
        (int(b["kind"]), *(round(float(v) / 1e6, 4) for v in b["target_nm"][:3]), float(b["feed"]))
        for b in program.blocks
    ]
    rapid, line, arc, dwell, _, output, end = range(7)
    assert rows == [
        (rapid, 0, -10, 0, 0), (line, -2, 0, 0, 1000), (line, -2, 20, 0, 1000),
        (output, -2, 20, 0, 0), (arc, 0, 22, 0, 300), (line, 20, 22, 0, 300),
        (line, 20, 22, 5, 300), (dwell, 20, 22, 5, 0), (arc, 22, 20, 5, 300), (line, 22, 0, 9, 300),
        (line, 22, 0, 10, 300), (line, 0, 0, 10, 300), (end, 0, 0, 10, 0),
    ]  # fmt: skip


def test_an_arc_about_a_corner_takes_its_share_of_inverse_time():
    program = load(
        contours.HEAD + "G0 X0 Y-10\nG41.1 D4\nG93 G1 X0 Y0 F6\nY20 F6\nX20 F6\nG40 G1 X40 F6\nM2\n"
    )
    arc = program.blocks[program.blocks["kind"] == lib.NCK_BLOCK_ARC][0]
    assert arc["feed"] == pytest.approx(6 * 20 / (math.pi * 2 / 2))


ENTRY = "G0 X0 Y-10\nG41.1 D4\nG1 X0 Y0\n"
ERRORS = {
    "comp-entry": (5, "G0 X0 Y-1\nG41.1 D4\nG1 X0 Y0\nY20\nM2\n"),
    "comp-radius": (7, ENTRY + "Y20\nG3 X-1 Y21 I-1 J0\nM2\n"),
    "comp-exit": (8, ENTRY + "Y20\nX20\nG40 G2 X30 R10\nM2\n"),
    "comp-on": (7, ENTRY + "Y20\nG81 X1 Y1 Z-1 R1\nM2\n"),
}


@pytest.mark.parametrize("name", ERRORS)
def test_what_cannot_be_done_is_one_error(name):
    line, text = ERRORS[name]
    error = error_of(HEAD + text)
    assert (error.id, error.line) == (name, line)


@pytest.mark.parametrize("more", [-4, -1, 0, 6])
def test_what_is_given_is_not_cut_short_any_more(more):
    room = len(ffi.new("nck_toolcomp_t *").ring.at) - 2  # two contours wait, too
    text = ENTRY + "Y20\nY40\n" + "M8\n" * (room + more) + "X-20\nG40 G1 X-20 Y20\nM2\n"
    if more < 0:
        assert corners(load(HEAD + text))[-3:] == [-2 + 38j, -20 + 38j, -20 + 20j]
        return
    error = error_of(HEAD + text)
    assert (error.id, error.line) == ("comp-gouge", 7)
    assert "2.000 mm into the contour" in str(error)


def test_the_tool_is_held_against_the_travel_not_the_contour_alone():
    text = HEAD + "G0 X0 Y-10\nG41.1 D4\nG1 X0 Y0\nY20\nX20\nM2\n"
    tight = Machine.load("mill3", set=(*FREE, "axis.x.min_mm=-1", "home.g30.x_mm=0"))
    error = error_of(text, tight)
    assert (error.id, error.line) == ("travel", 5)
    wide = Machine.load("mill3", set=(*FREE, "axis.x.min_mm=-2", "home.g30.x_mm=0"))
    assert not load(text, wide).diagnostics.errors


def test_the_tools_radius_and_wear_come_from_the_table():
    tools = ("tool.3.radius_mm=2.1", "tool.3.radius_wear_mm=-0.1")
    machine = Machine.load("mill3", set=(*FREE, *tools))
    by_table = HEAD + "T3 M6\nG0 X0 Y-10\nG42{d}\nG1 X0 Y0\nY20\nX20\nG40 G1 X40\nM2\n"
    by_diameter = load(by_table.replace("G42{d}", "G42.1 D4"), machine)
    for d in ("", " D3"):
        assert corners(load(by_table.format(d=d), machine)) == corners(by_diameter)
    zero = corners(load(by_table.format(d=" D0"), machine))
    assert zero == [-10j, 0j, 20j, 20 + 20j, 40 + 20j]


def test_every_plane_is_like_g17():
    text = ENTRY + "X0 Y20\nX20 Y30\nG2 X40 Y10 I0 J-20\nG1 X60 Y10\nG40 G1 X60 Y0\nM2\n"
    flat = load(HEAD + text).blocks
    for plane, letters, order in ((18, "ZXKI", (2, 0)), (19, "YZJK", (1, 2))):
        table = str.maketrans("XYIJ", letters)
        turned = load(HEAD.replace("G17", f"G{plane}") + text.translate(table)).blocks
        assert (turned["kind"] == flat["kind"]).all()
        assert (turned["target_nm"][:, order] == flat["target_nm"][:, (0, 1)]).all()
        assert (turned["centre_mm"] == flat["centre_mm"]).all()


# Against rs274


def compare(text, folder, machine=MILL, tools=None):
    """Return (moves of rs274, equal ones, words for the first that differs, its complaint)."""
    file = folder / "part.ngc"
    file.write_bytes(text)
    theirs, complaint = rs274_oracle.run(file, folder, tools or {})
    blocks, _ = stages.decode(text, machine)
    ours = rs274_oracle.from_blocks(blocks, lib.NCK_COUNTS_PER_DEG)
    return theirs, *rs274_oracle.difference(ours, theirs), complaint


@pytest.mark.parametrize("seed", range(12))
def test_contours_equal_rs274(seed, tool, tmp_path):
    tool("rs274")
    rng = np.random.default_rng([seed, 3])
    radius, side = float(rng.choice([1, 3, 6])), int(rng.choice([-1, 1]))
    elements = contours.hills(rng, 40, radius, side)
    ahead = -1j * elements[0].left(np.zeros(1))[0]
    entry = elements[0].start - 10 * radius * ahead * np.exp(0.5j * rng.choice([-1, 1]))
    leave = elements[-1].end + 10 * radius * np.exp(1j * rng.uniform(-1, 1))
    text = contours.program(elements, radius, side, entry, leave)
    theirs, equal, words, complaint = compare(text.encode(), tmp_path)
    assert complaint == ""
    assert words == ""
    assert equal == len(theirs) > 40


@pytest.mark.parametrize("orientation", range(10))
@pytest.mark.parametrize("code", ["G41.1", "G42.1"])
def test_a_nose_equals_rs274(code, orientation, tool, tmp_path):
    tool("rs274")
    head = f"G21 G90 G18 G8 G61 F100\nG0 X30 Z20\n{code} D1.6 L{orientation}\n"
    text = head + "G1 X10 Z5\nZ-10\nX20 Z-12\nG3 X30 Z-22 R10\nG2 X40 Z-32 R10\nG1 X50\n"
    text += "G40 G1 X60 Z-20\nM2\n"
    theirs, equal, words, complaint = compare(text.encode(), tmp_path)
    assert complaint == ""
    assert words == ""
    assert equal == len(theirs) >= 8


def test_an_entry_along_an_arc_equals_rs274(tool, tmp_path):
    tool("rs274")
    text = HEAD + "G0 X0 Y-10\nG41.1 D4\nG3 X5 Y0 R10\nG1 Y20\nX20\nG40 G1 X40\nM2\n"
    theirs, equal, words, _ = compare(text.encode(), tmp_path)
    assert (equal, words) == (len(theirs), "")


def test_a_real_program_equals_rs274(tool, tmp_path):
    tool("rs274")
    if not (file := CORPUS / "mill_cutcomp_semicolon.ngc").exists():
        pytest.skip(f"no corpus file {file}")
    # Behind G40 in line 52 a move along Z alone leaves the tool where it is; rs274 takes it back to
    # the contour on its way.
    text = b"\n".join(file.read_bytes().splitlines()[:58]) + b"\nM2\n%\n"
    machine = Machine.load("mill3", set=(*FREE, "tool.1.radius_mm=4", "tool.3.radius_mm=3"))
    tools = {n: (0.0, radius) for n, radius in ((1, 4.0), (3, 3.0))}
    theirs, equal, words, _ = compare(text, tmp_path, machine, tools)
    assert words == ""
    assert equal == len(theirs) >= 8


def test_a_move_that_leaves_the_plane_alone_leaves_the_tool_off_the_contour():
    program = load(HEAD + ENTRY + "Y20\nX20\nG40 G0 Z10\nX30\nM2\n")
    assert corners(program)[-2:] == [20 + 22j, 30 + 20j]
