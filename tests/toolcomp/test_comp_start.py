# SPDX-License-Identifier: MIT
"""How radius compensation begins and ends: RS274NGC's way, and types A and B of Fanuc.

The tool's radius is 2 and it is left of the contour, unless said. Places are worked out by hand.
"""

import math
import re

import numpy as np
import pytest
from test_toolcomp import FREE, HEAD, corners, error_of, found, load, pieces_of

from pycnc.kernel.bind import ffi, lib
from pycnc.machine import Machine

S = math.sqrt(2)
ACUTE = (4 - 2j) / math.sqrt(5)  # beside a corner in 0 that turns by 117 degrees
TO = "G0 X-10 Y0\nG41.1 D4\nG1 X0 Y0\n"
FROM = "G0 X-20 Y0\nG41.1 D4\nG1 X0 Y0\nX20\nG40 G1 "
ARC_FROM = "G0 X10 Y-20\nG41.1 D4\nG1 Y0\nG2 X20 Y10 R10\nG40 G1 "


def machine(start, *more):
    """Return a mill that begins so."""
    return Machine.load("mill3", set=(*FREE, f"dialect.comp_start={start}", *more))


def near(found, expected):
    """Tell whether two lists of places are one, to a few nanometres."""
    return len(found) == len(expected) and np.abs(np.subtract(found, expected)).max() < 5e-6


# What follows the first move, which goes along X to 0: its next place by type A, by type B.
TO_A_CORNER = {
    "outside, right": ("Y-20", [2], [2j, 2]),
    "outside, obtuse": ("X20 Y-20", [S + S * 1j], [2j, S + S * 1j]),
    "outside, acute": ("X-10 Y-20", [ACUTE], [2j, ACUTE]),
    "outside, back": ("X-1.5", [-2j], [2j, -2j]),
    "straight on": ("X20", [2j], [2j]),
    "inside, right": ("Y20", [-2], [-2]),
    "inside, obtuse": ("X20 Y20", [-S + S * 1j], [-S + S * 1j]),
    "inside, acute": ("X-20 Y20", [-S - S * 1j], [-S - S * 1j]),
    "an arc outside": ("G3 X10 Y-10 R10", [2], [2j, 2]),
    "an arc inside": ("G2 X10 Y10 R10", [-2], [-2]),
    "an arc inside, obtuse": ("G2 X20 Y0 R14.142136", [-S + S * 1j], [-S + S * 1j]),
}


@pytest.mark.parametrize("corner", TO_A_CORNER)
def test_the_first_move_ends_beside_the_contour_as_its_type_says(corner):
    text, by_a, by_b = TO_A_CORNER[corner]
    for start, expected in (("A", by_a), ("B", by_b)):
        program = load(f"{HEAD}{TO}{text}\nM2\n", machine(start))
        assert near(corners(program)[1 : len(expected) + 1], expected)
        arcs = [each for each in pieces_of(program)[1:] if each.sweep]
        if len(expected) > 1:  # about the corner
            assert abs(arcs[0].centre) < 1e-5


# The contour ends in 20, along X; behind G40 the tool goes to a place: by way of these.
FROM_A_CORNER = {
    "outside, right": (FROM, "X20 Y-20", [20 + 2j], [20 + 2j, 22]),
    "outside, acute": (FROM, "X10 Y-20", [20 + 2j], [20 + 2j, 20 + ACUTE]),
    "outside, obtuse": (FROM, "X40 Y-20", [20 + 2j], [20 + 2j, 20 + S + S * 1j]),
    "straight on": (FROM, "X40", [20 + 2j], [20 + 2j]),
    "inside": (FROM, "X20 Y20", [20 + 2j], [20 + 2j]),
    "inside, acute": (FROM, "X0 Y20", [20 + 2j], [20 + 2j]),
    "an arc, outside": (ARC_FROM, "X20 Y-20", [20 + 12j], [20 + 12j, 22 + 10j]),
    "an arc, inside": (ARC_FROM, "X20 Y20", [20 + 12j], [20 + 12j]),
}


@pytest.mark.parametrize("corner", FROM_A_CORNER)
def test_the_move_behind_g40_begins_beside_the_contour_as_its_type_says(corner):
    contour, text, by_a, by_b = FROM_A_CORNER[corner]
    for start, way in (("rs274", by_a), ("A", by_a), ("B", by_b)):
        program = load(f"{HEAD}{contour}{text}\nM2\n", machine(start))
        to = complex(*(float(text.split(letter)[1].split()[0]) if letter in text else default
                       for letter, default in (("X", 20.0), ("Y", 0.0))))
        assert near(corners(program)[-len(way) - 1 :], [*way, to])


TEXTS = [
    *(TO + text for text, *_ in TO_A_CORNER.values()),
    *(contour + text for contour, text, *_ in FROM_A_CORNER.values()),
]


def mirrored(text):
    """Return a program on the other side of the X axis."""
    other = {"G41.1": "G42.1", "G2": "G3", "G3": "G2"}
    text = re.sub(r"Y(-?\d+)", lambda word: f"Y{-int(word[1])}", text)
    return re.sub(r"G(41\.1|2|3)\b", lambda word: other[word[0]], text)


@pytest.mark.parametrize("start", ["A", "B"])
def test_right_of_the_contour_is_the_mirror_of_left(start):
    for text in TEXTS:
        left = corners(load(f"{HEAD}{text}\nM2\n", machine(start)))
        right = corners(load(f"{HEAD}{mirrored(text)}\nM2\n", machine(start)))
        assert near(right, np.conj(left))


@pytest.mark.parametrize("start", ["A", "B"])
def test_every_plane_begins_and_ends_like_g17(start):
    for text in TEXTS:
        flat = load(f"{HEAD}{text}\nM2\n", machine(start)).blocks["target_nm"]
        for plane, letters, order in ((18, "ZX", (2, 0)), (19, "YZ", (1, 2))):
            head = HEAD.replace("G17", f"G{plane}")
            turned = load(head + text.translate(str.maketrans("XY", letters)) + "\nM2\n",
                          machine(start)).blocks["target_nm"]
            assert (turned[:, order] == flat[:, (0, 1)]).all()


@pytest.mark.sample(quick=6)
@pytest.mark.parametrize("orientation", range(10))
@pytest.mark.parametrize("start", ["A", "B"])
def test_a_nose_is_led_by_its_point(start, orientation):
    points = [0, 1 - 1j, -1 - 1j, -1 + 1j, 1 + 1j, 1, -1j, -1, 1j, 0]  # of R 1, along Z and X
    table = str.maketrans("XY", "ZX")
    for text in TEXTS:
        text = HEAD.replace("G17", "G18 G8") + text.translate(table) + "\nM2\n"
        nose = text.replace("D4", f"D4 L{orientation}")
        plain, led = (
            load(each, machine(start)).blocks["target_nm"][:, (2, 0)] @ [1e-6, 1e-6j]
            for each in (text, nose)
        )
        # The centre is where it is without a nose, but for the first place and behind G40.
        behind = -2 if "G40" in text else None
        assert near(led[1:behind], plain[1:behind] + 2 * points[orientation])
        assert near(led[:1], plain[:1])
        assert behind is None or near(led[behind:], plain[behind:])


# What is told of a way: line 5 to the contour in 0, line 7 from it in 20, so deep by A, by B.
OVER_AN_END = {
    "straight on": (f"{TO}X20", 5, 2 - 20 / math.sqrt(104), 2 - 20 / math.sqrt(104)),
    "outside, right": (f"{TO}Y-20", 5, 2, 2 - 20 / math.sqrt(104)),
    "inside": (f"{TO}Y20", 5, 0, 0),
    "from above": (f"{TO}X20".replace("Y0\nX", "Y0\nZ-1\nX"), 5, 0, 0),
    "into its depth": (f"{TO}X20".replace("X0 Y0", "X0 Y0 Z-5"), 5, 0, 0),
    "straight from it": (f"{FROM}X40", 7, 2 - 40 / math.sqrt(404), 2 - 40 / math.sqrt(404)),
    "from it, right": (f"{FROM}X20 Y-20", 7, 2, 2 - 40 / math.sqrt(404)),
    "up from it": (f"{FROM}Z1\nX20 Y-20", 8, 0, 0),
}


@pytest.mark.parametrize("corner", OVER_AN_END)
def test_what_a_way_cuts_where_the_contour_begins_or_ends_is_a_warning(corner):
    text, line, *depths = OVER_AN_END[corner]
    for start, deep in zip("AB", depths, strict=True):
        program = load(f"{HEAD}{text}\nM2\n", machine(start))
        told = [each for each in found(program, "comp-way") if each.line == line]
        assert len(told) == (deep > 0)
        assert all(each.severity == "warning" and f"{deep:.3f} mm" in str(each) for each in told)


IN_THE_CONTOUR = {
    "it begins over the wall": (f"{TO}X-20", 5, "2.000 mm", "line 6"),
    "through the wall to it": (f"{TO}X20".replace("X-10 Y0", "X20 Y-10"), 5, "2.000 mm", "line 6"),
    "past another wall": (f"{TO}Y20\nX-8.5\nY1.5", 5, "0.500 mm", "line 8"),
    "from it through a wall": (
        FROM.replace("X20", "Y20\nX20") + "X-20 Y-20", 8, "2.000 mm", "line 6"
    ),
}


@pytest.mark.parametrize("place", IN_THE_CONTOUR)
def test_a_way_in_any_other_part_of_the_contour_is_an_error(place):
    text, line, deep, wall = IN_THE_CONTOUR[place]
    error = error_of(f"{HEAD}{text}\nM2\n", machine("A"))
    assert (error.id, error.line) == ("comp-gouge", line)
    assert deep in str(error) and wall in str(error)


def test_other_axes_keep_their_place_and_words():
    text = ("G0 X-10 Y0\nG41.1 D4\nG1 X0 Y0 Z-1\nY-20 F300\nG40 Z5\nM8\nX-20 Z7 F200\nM2\n")
    rows = [
        (int(b["line"]), *(round(float(v) / 1e6, 4) for v in b["target_nm"][:3]), float(b["feed"]))
        for b in load(HEAD + text, machine("B")).blocks
        if b["kind"] <= lib.NCK_BLOCK_ARC
    ]
    assert rows == [
        (3, -10, 0, 0, 0), (5, 0, 2, -1, 1000), (6, 2, 0, -1, 300), (6, 2, -20, -1, 300),
        (7, 2, -20, 5, 300), (9, 0, -22, 5, 200), (9, -20, -20, 7, 200),
    ]  # fmt: skip


def test_the_first_move_may_be_short_but_is_straight():
    short = "G0 X-1 Y0\nG41.1 D4\nG1 X0 Y0\nY20\nM2\n"
    assert error_of(HEAD + short, machine("rs274")).id == "comp-entry"
    assert near(corners(load(HEAD + short, machine("A"))), [-1, -2, -2 + 20j])
    bent = "G0 X-10 Y-10\nG41.1 D4\nG3 X0 Y0 R10\nG1 Y20\nM2\n"
    assert not load(HEAD + bent, machine("rs274")).diagnostics.errors
    for start in ("A", "B"):
        error = error_of(HEAD + bent, machine(start))
        assert (error.id, error.line) == ("comp-entry", 5)
        assert "an arc" in str(error)


def test_a_first_move_that_is_given_before_the_contour_is_known_ends_beside_itself():
    waits = "M8\n" * (len(ffi.new("nck_toolcomp_t *").ring.at) + 1)
    away = load(f"{HEAD}{TO}{waits}Y-20\nM2\n", machine("A"))
    assert near(corners(away), [-10, 2j, 2, 2 - 20j])
    error = error_of(f"{HEAD}{TO}{waits}Y20\nM2\n", machine("A"))
    assert (error.id, error.line) == ("comp-gouge", 5)


def test_compensation_begins_anew_where_it_ended():
    text = FROM + "X40 Y-20\nG41.1 D4\nG1 X60\nY-40\nG40 G1 X80\nM2\n"
    assert near(
        corners(load(HEAD + text, machine("A")))[-4:],
        [40 - 20j, 62 - 20j, 62 - 40j, 80 - 40j],
    )


@pytest.mark.parametrize("line", range(3, 9))
def test_a_program_that_begins_in_the_middle_ends_as_the_whole_one(line):
    text = f"{HEAD}{TO}Y-20\nX-20\nG40 G1 Y10\nM2\n"
    enters = machine("B", f"dialect.from_line={line}", "approach.height_mm=50")
    whole, part = (load(text, each).blocks for each in (machine("B"), enters))
    moves = whole[(whole["kind"] <= lib.NCK_BLOCK_ARC) & (whole["line"] >= line)]
    rest = part[part["kind"] <= lib.NCK_BLOCK_ARC][-len(moves) :]
    for name in ("kind", "line", "target_nm", "centre_mm", "sweep_rad"):
        assert (rest[name] == moves[name]).all()


TABLE = "G21 G17 G90 G94 F1000\nT1 M6\nG0 X-10 Y0\nG41 D1\nG1 X0 Y0\nY20\nG40 G1 X10\nM30\n"


@pytest.mark.parametrize(
    ("settings", "first"),
    [
        ((), -2 + 2j), (("dialect.base=fanuc",), -2), (("dialect.base=linuxcnc",), -2 + 2j),
        (("dialect.base=fanuc", "dialect.comp_start=rs274"), -2 + 2j),
        (("dialect.base=fanuc", "dialect.comp_start=B"), -2),
        (("dialect.comp_start=A",), -2),
    ],
)  # fmt: skip
def test_the_dialect_says_how_where_the_machine_file_does_not(settings, first):
    mill = Machine.load("mill3", set=(*FREE, "tool.1.radius_mm=2", *settings))
    assert near(corners(load(TABLE, mill))[1:2], [first])
