# SPDX-License-Identifier: MIT
"""Fanuc's change of sides without G40: the contour ends at a right angle to its last move, and
begins anew at one to the next, across. Corners are worked out apart from the kernel."""

import cmath
import math
import random

import numpy as np
import pytest
from test_comp_start import near
from test_toolcomp import FREE, corners, error_of, found, load

from pycnc.machine import Machine

R = 2.0
HEAD = "G21 G90 G17 G94 F900 S900 M3\n"


def machine(*more):
    """Return a mill of Fanuc's language whose D1 is 2 mm, D2 is 1 mm."""
    return Machine.load("mill3", set=(
        *FREE, "dialect.base=fanuc", "dialect.d_offset=radius", "tool.1.radius_mm=2",
        "tool.2.radius_mm=1", *more))  # fmt: skip


def beside(way, side, radius=R):
    """Return the step from a point of a line to its parallel."""
    return side * radius * 1j * way / abs(way)


def path_of(points, sides):
    """Return the places of the tool along lines; at a corner away from it, both ends of the arc."""
    ways = np.diff(points)
    places = [points[0] + beside(ways[0], sides[0])]
    for k in range(1, len(ways)):
        at, before, behind = points[k], ways[k - 1], ways[k]
        turn = cmath.phase(behind / before)
        if sides[k] == sides[k - 1] and sides[k] * turn > 0:
            half = cmath.exp(0.5j * turn)
            places.append(at + beside(before * half, sides[k]) / half.real)
        else:
            places += [at + beside(before, sides[k - 1]), at + beside(behind, sides[k])]
    return [*places, points[-1] + beside(ways[-1], sides[-1])]


def drawn(rng):
    """Return (points, sides) of a contour: of one side two or three lines at most."""
    points, sides, angle, at = [0j], [], rng.uniform(-math.pi, math.pi), 0j
    side = rng.choice((1, -1))
    for _ in range(rng.randint(2, 4)):
        for k in range(rng.randint(1, 3)):
            turn = rng.uniform(0.1, 1.7) * rng.choice((1, -1))
            angle += turn if k else rng.choice((turn, math.pi, 0.0))
            at += complex(round(rng.uniform(12, 18) * math.cos(angle), 3),
                          round(rng.uniform(12, 18) * math.sin(angle), 3))  # fmt: skip
            points.append(at)
            sides.append(side)
        side = -side
    return points, sides


def text_of(points, sides):
    code, lines = 0, []
    for k, at in enumerate(points[1:]):
        new = 41 if sides[k] > 0 else 42
        lines.append(("" if new == code else f"G{new} D1 ") + f"X{at.real:.3f} Y{at.imag:.3f}")
        code = new
        if k == 0:
            lines[0] = f"G{new} D1 G0 X0. Y0.\nG1 X{at.real:.3f} Y{at.imag:.3f}"
    return f"{HEAD}G0 X-40. Y-40.\n" + "\n".join(lines) + "\nG40 G0 X300. Y300.\nM30\n"


@pytest.mark.sample(12)
@pytest.mark.parametrize("seed", range(2000))
def test_the_path_changes_sides_where_the_program_does(seed, draw_seed):
    points, sides = drawn(random.Random(seed + draw_seed))
    program = load(text_of(points, sides), machine())
    expected = path_of(np.array(points), sides)
    kept = [each for k, each in enumerate(expected) if not k or abs(each - expected[k - 1]) > 2e-6]
    assert near_all(corners(program)[1:-1], kept), text_of(points, sides)


def near_all(places, expected):
    return len(places) == len(expected) and np.abs(np.subtract(places, expected)).max() < 1e-4


# Behind G41 and a line along X to 20: what follows, and the next places.
CHANGES = {
    "back": ("G42 X0. Y0.", [2j]),
    "left": ("G42 Y20.", [22, 22 + 20j]),
    "right": ("G42 Y-20.", [18, 18 - 20j]),
    "straight on": ("G42 X40.", [20 - 2j, 40 - 2j]),
    "an arc": ("G42 G2 X40. Y0. R10.", [22, 38]),
    "outputs between": ("M8\nG42\nM9\nZ1.\nX40.", [20 - 2j, 40 - 2j]),
    "the same side": ("G41 X40.", [40 + 2j]),
    "another tool": ("G42 D2 X40.", [20 - 1j, 40 - 1j]),
    "of no radius": ("G42 D0 X40.", [40]),
    "twice": ("G42\nG41\nX40.", [40 + 2j]),
}


@pytest.mark.parametrize("start", ["A", "B", "rs274"])
@pytest.mark.parametrize("change", CHANGES)
def test_a_change_of_sides_leads_across(change, start):
    text, expected = CHANGES[change]
    program = load(f"{HEAD}G0 X-20. Y0.\nG41 D1 G1 X0.\nX20.\n{text}\nG40 G0 X80. Y80.\nM30\n",
                   machine(f"dialect.comp_start={start}"))  # fmt: skip
    places = corners(program)
    at = next(k for k, place in enumerate(places) if abs(place - (20 + 2j)) < 1e-5
              or abs(place - (40 + 2j)) < 1e-5)  # fmt: skip
    at += abs(places[at] - (20 + 2j)) < 1e-5
    assert near(places[at : at + len(expected)], expected)


def test_nothing_crosses_where_nothing_follows():
    program = load(f"{HEAD}G0 X-20. Y0.\nG41 D1 G1 X0.\nX20.\nG42\nM30\n", machine())
    assert near(corners(program)[-1:], [20 + 2j])


def test_the_way_across_is_told_with_its_depth():
    program = load(f"{HEAD}G0 X-20. Y0.\nG41 D1 G1 X0.\nX20.\nG42 Y20.\nG40 G0 X80.\nM30\n",
                   machine())  # fmt: skip
    assert [each.line for each in found(program, "comp-way")][1:] == [5]


@pytest.mark.parametrize(("text", "error"), [
    ("G41 D1 G1 X9.\nX20.\nG41 D2 X30.\nM30\n", ("comp-on", 5)),
    ("G41 D1 G1 X9.\nX20.\nG93 G42 X30. F2.\nM30\n", ("comp-on", 5)),
])  # fmt: skip
def test_what_is_no_change_of_sides_is_refused(text, error):
    caught = error_of(f"{HEAD}G0 X-20. Y0.\n{text}", machine())
    assert (caught.id, caught.line) == error


def test_rs274ngc_has_no_change_of_sides():
    more = "dialect.base=linuxcnc"
    caught = error_of(f"{HEAD}G0 X-20. Y0.\nG41 D1 G1 X9.\nG42 X20.\nM2\n", machine(more))
    assert (caught.id, caught.line) == ("comp-on", 4)


def test_a_d_of_fanucs_mills_holds_until_another_one():
    text = f"{HEAD}G0 X-20. Y0.\nG41 D2 G1 X0.\nX20.\nG40 Y9.\nT1 M6\nG41 X0. Y0.\nX-20.\n"
    program = load(f"{text}G40 Y9.\nM30\n", machine())
    assert -20 - 1j in corners(program)
