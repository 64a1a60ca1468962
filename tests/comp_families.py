# SPDX-License-Identifier: MIT
"""Programs under radius compensation, drawn by seed: families of contours for comp_gate.py."""

import math
from dataclasses import dataclass, field

import numpy as np

STARTS = ("rs274", "A", "B")
LETTERS = {17: "XYIJZ", 18: "ZXKIY", 19: "YZJKX"}


@dataclass
class Case:
    """A program along elements: (end, centre or None, sense, height or None) each.

    walls: of each element the ones that its path keeps off from; leads: those that lead in and out.
    """

    start: complex
    entry: complex
    elements: list
    radius: float
    side: int
    leave: complex
    decimals: int = 3
    plane: int = 17
    parts: list = field(default_factory=list)  # of each element; −1: it leads in or out
    must: bool = True  # it fits: refused is wrong
    starts: tuple = STARTS  # the ways to begin that it is meant for
    ramps: bool = False  # no part of it meets another one, and they lie on heights of their own


def number(value, decimals):
    """Return a coordinate as it is written."""
    return f"{round(value, decimals) + 0.0:.{decimals}f}"


def text_of(case, compensated=True):
    """Return the program; its entry is line 5, its elements follow."""
    x, y, i, j, z = LETTERS[case.plane]
    digits = case.decimals

    def place(point):
        return f"{x}{number(point.real, digits)} {y}{number(point.imag, digits)}"

    code = "G41.1" if case.side > 0 else "G42.1"
    lines = [f"G21 G90 G91.1 G{case.plane} G94 G61", "F1000", f"G0 {place(case.start)} {z}0"]
    lines.append(f"{code} D{2 * case.radius:.6f}" if compensated else "G4 P0")
    lines.append(f"G1 {place(case.entry)}")
    at = case.entry
    for end, centre, sense, height in case.elements:
        up = "" if height is None else f" {z}{number(height, digits)}"
        if centre is None:
            lines.append(f"G1 {place(end)}{up}")
        else:
            at = complex(round(at.real, digits), round(at.imag, digits))
            way = centre - at
            arm = f"{i}{number(way.real, digits)} {j}{number(way.imag, digits)}"
            lines.append(f"G{3 if sense > 0 else 2} {place(end)}{up} {arm}")
        at = end
    lines.append(("G40 " if compensated else "") + f"G1 {place(case.leave)}")
    return "\n".join([*lines, "M2", ""])


def turned(case, rng):
    """Turn and shift a case, so that nothing in it is along an axis."""
    turn = np.exp(1j * rng.uniform(0, 2 * math.pi))
    shift = complex(*rng.uniform(-20, 20, 2))

    def move(point):
        return None if point is None else point * turn + shift

    case.start, case.entry, case.leave = map(move, (case.start, case.entry, case.leave))
    case.elements = [(move(e), move(c), sense, z) for e, c, sense, z in case.elements]
    return case


def before(rng, place, ahead, radius, free=lambda start: True):
    """Return where a first move comes from: from behind, a little from one side, if one of 20
    places is free there."""
    for _ in range(20):
        way = ahead * np.exp(1j * rng.uniform(-0.5, 0.5)) * radius * rng.uniform(1.5, 4)
        if free(place - way):
            break
    return place - way


def circle(rng, turns=0):
    """A bore or a boss between two tangent arcs, as a circle or a helix of some turns."""
    radius = float(rng.choice([0.5, 1, 3, 6.35]))
    inside = bool(rng.random() < 0.6)
    size = radius * rng.uniform(1.6, 8) if inside else radius * rng.uniform(0.2, 6)
    lead = rng.uniform(1.25 * radius, 0.95 * size) if inside and 0.95 * size > 1.25 * radius else 0
    if not inside:
        lead = radius * rng.uniform(1.3, 4)
    anticlockwise = int(rng.choice([-1, 1]))
    side = anticlockwise if inside else -anticlockwise
    out = 1 if inside else -1  # from the circle's centre to the leads' one: inwards or outwards
    touch, centre = size + 0j, 0j
    hub = touch - out * lead
    # Both leads are quarters; seen from its hub each turns as the tool does.
    sense = anticlockwise * out
    begin = hub + lead * np.exp(1j * (0 if inside else math.pi)) * np.exp(-1j * sense * math.pi / 2)
    end = hub + lead * np.exp(1j * (0 if inside else math.pi)) * np.exp(1j * sense * math.pi / 2)
    step = float(rng.uniform(0.2, 2))
    circles = [(touch, centre, anticlockwise, -step * k if turns else None)
               for k in range(1, max(turns, 1) + 1)]
    if lead == 0:
        return None
    start = before(rng, begin, 1j * sense * (begin - hub) / lead, radius,
                   lambda start: out * (size - abs(start)) > radius)
    elements = [(touch, hub, sense, None), *circles, (end, hub, sense, None)]
    parts = [-1, *range(len(circles)), -1]
    case = Case(start, begin, elements, radius, side, start, parts=parts)
    return case


def helix(rng):
    """A circle with 1 to 5 turns down."""
    return circle(rng, int(rng.integers(1, 6)))


def corners_of(rng, radius, inside):
    """Return the corners of a convex polygon, anticlockwise, its edges longer than the tool."""
    count = int(rng.integers(4, 8))
    angles = np.sort((np.arange(count) + rng.uniform(-0.3, 0.3, count)) * 2 * math.pi / count)
    size = radius * rng.uniform(7, 15) if inside else radius * rng.uniform(3, 12)
    return size * rng.uniform(0.9, 1.1, count) * np.exp(1j * angles)


def around(corners, direction):
    """Return the elements of a polygon from the middle of its first edge, and that place."""
    if direction < 0:
        corners = corners[::-1]
    begin = (corners[-1] + corners[0]) / 2
    return [(corner, None, 0, None) for corner in corners] + [(begin, None, 0, None)], begin


def form(rng, inside):
    """A pocket or a boss with quarters that lead in and out."""
    radius = float(rng.choice([0.5, 1, 3, 6.35]))
    corners, direction = corners_of(rng, radius, inside), int(rng.choice([-1, 1]))
    elements, begin = around(corners, direction)
    side = direction if inside else -direction
    ahead = (elements[0][0] - begin) / abs(elements[0][0] - begin)
    free = 1j * side * ahead
    lead = radius * rng.uniform(1.3, 2)
    hub = begin + lead * free
    first, last = hub - lead * ahead, hub + lead * ahead
    elements = [(begin, hub, side, None), *elements, (last, hub, side, None)]
    start = before(rng, first, 1j * side * (first - hub) / lead, radius)
    parts = [-1, *[0] * (len(elements) - 2), -1]
    return Case(start, first, elements, radius, side, start, parts=parts)


def pocket(rng):
    """A pocket."""
    return form(rng, True)


def boss(rng):
    """A boss."""
    return form(rng, False)


def laps(rng):
    """A polygon run through again and again, each lap beside the one before or on it."""
    radius, inside = float(rng.choice([0.5, 1, 3])), bool(rng.random() < 0.5)
    corners, direction = corners_of(rng, radius, True), int(rng.choice([-1, 1]))
    step = float(rng.choice([0, 0.01, 0.1, -0.1, -0.02])) * int(rng.integers(1, 3))
    side = direction if inside else -direction
    elements, parts = [], []
    for lap in range(int(rng.integers(2, 5))):
        each, begin = around(corners * (1 + step * lap), direction)
        if lap == 0:
            ahead = (each[0][0] - begin) / abs(each[0][0] - begin)
            entry = begin
        else:
            elements.append((begin, None, 0, None))
            parts.append(-1)
        elements += each
        parts += [lap] * len(each)
    free = 1j * side * ahead
    start, leave = entry + radius * (2 * free - 1.2 * ahead), entry + 4 * radius * free
    # A way to the next lap that is longer than R, and at an inside corner, may not fit.
    fits = abs(step) * np.abs(corners).max() < 0.9 * radius
    return Case(start, entry, elements, radius, side, leave, parts=parts, must=bool(fits))


def chain(rng):
    """Elements one tangent to the next, arcs of up to 6.2 rad and lines; they may meet."""
    radius, side = float(rng.choice([0.5, 1, 3])), int(rng.choice([-1, 1]))
    at, ahead, elements = 0j, 1 + 0j, []
    most = float(rng.choice([1.5, 3, 6.2]))
    for _ in range(int(rng.integers(3, 10))):
        if rng.random() < 0.3:
            at = at + ahead * radius * rng.uniform(0.5, 8)
            elements.append((at, None, 0, None))
            continue
        sense = int(rng.choice([-1, 1]))
        size = radius * (rng.uniform(1.1, 6) if sense == side else rng.uniform(0.3, 6))
        turn = np.exp(1j * sense * rng.uniform(0.2, most))
        hub = at + 1j * sense * size * ahead
        at, ahead = hub + (at - hub) * turn, ahead * turn
        elements.append((at, hub, sense, None))
    start = -5 * radius + 0j
    return Case(start, 0j, elements, radius, side, at + 5 * radius * ahead, must=False)


def ways(rng):
    """A line or an arc, with ways to it and from it out of all directions, as short as they may be:
    too short for RS274NGC's."""
    radius, side = float(rng.choice([0.5, 1, 3])), int(rng.choice([-1, 1]))
    first, last = np.exp(1j * rng.uniform(-3.1, 3.1, 2)) * radius * rng.uniform(0.3, 6, 2)
    end, hub, sense = complex(radius * rng.uniform(0.5, 9)), None, 0
    if rng.random() < 0.5:
        sense = int(rng.choice([-1, 1]))
        size = radius * (rng.uniform(1.1, 6) if sense == side else rng.uniform(0.3, 6))
        hub = 1j * sense * size
        end = hub - hub * np.exp(1j * sense * rng.uniform(0.3, 3))
        if abs(end) < 2 * radius:  # an arc about one end would be in the way of the other
            return None
    elements = [(end, hub, sense, None)]
    return Case(-first, 0j, elements, radius, side, end + last, starts=("A", "B"))


def winding(rng):
    """An open spiral of half circles, inwards or outwards: what is beside one lap faces the back of
    the next, or is clear of it by as little, and the paths beside them do not cross."""
    radius, sense = float(rng.choice([0.5, 1, 3])), int(rng.choice([-1, 1]))
    halves = int(rng.integers(3, 7))
    steps = np.where(rng.random(halves) < 0.3, rng.uniform(0.6, 1.1, halves), 1.3)
    sizes = radius * (rng.uniform(0.3, 1.7) + np.cumsum(steps))
    if rng.random() < 0.5:
        sizes = sizes[::-1]
    at, ahead, elements = 0j, 1 + 0j, []
    for size in sizes:
        hub = at + 1j * sense * size * ahead
        at, ahead = 2 * hub - at, -ahead
        elements.append((at, hub, sense, None))
    side = int(rng.choice([-1, 1]))
    start, leave = from_the_free_side(radius * (0.9 + 1.2j), side, at, ahead)
    return Case(start, 0j, elements, radius, side, leave, must=False)


def from_the_free_side(free, side, at, ahead):
    """Return where a first move comes from, beside X in 0, and a last one goes to from a place."""
    leave = free if side > 0 else np.conj(free)
    return -np.conj(leave), at + leave * ahead


def ramp(rng):
    """An open spiral of half circles on a ramp: laps may be nearer than the tool is wide. It fits
    where the tool is over no lap that is as high as itself."""
    radius, sense = float(rng.choice([0.5, 1, 3])), int(rng.choice([-1, 1]))
    halves = int(rng.integers(3, 8))
    sizes = radius * (rng.uniform(2.2, 3) + np.cumsum(rng.uniform(0.1, 1.3, halves)))
    inwards, down, inside = (bool(each) for each in rng.random(3) < 0.5)
    falls = radius * np.where(rng.random(halves) < 0.1, 0.0, rng.uniform(0.1, 1, halves))
    heights = np.cumsum(falls) * (-1 if down else 1)
    at, ahead, elements = 0j, 1 + 0j, []
    for size, height in zip(sizes[::-1] if inwards else sizes, heights):
        hub = at + 1j * sense * size * ahead
        at, ahead = 2 * hub - at, -ahead
        elements.append((at, hub, sense, float(height)))
    side = sense if inside else -sense
    start, leave = from_the_free_side(radius * (0.8 + 1.5j), side, at, ahead)
    fits = inside == (inwards == down) and falls.all()
    return Case(start, 0j, elements, radius, side, leave, must=bool(fits), ramps=True)


FORMS = (circle, helix, pocket, boss, laps, chain, ways, winding, ramp)
FAMILIES = {each.__name__: each for each in FORMS}


def case_of(family, seed):
    """Return a case; decimals and plane follow from the seed, too."""
    rng = np.random.default_rng([seed, sorted(FAMILIES).index(family)])
    case = None
    while case is None:
        case = FAMILIES[family](rng)
    case = turned(case, rng)
    case.decimals = int(rng.choice([0, 1, 2, 3, 3] if family == "chain" else [2, 3]))
    case.plane = int(rng.choice([17, 17, 17, 18, 19] if case.ramps else [17, 18, 19]))
    case.must = case.must and (case.plane == 17 or not case.ramps)
    return case
