# SPDX-License-Identifier: MIT
"""Contours under radius compensation, searched by seed: is every element cut, or told?

Circles and helices between tangents, laps, pockets, bosses, open spirals and chains of tangent
elements, on both sides, in all planes, with 0 to 3 decimals. A program is good if no part of the
path is nearer to the contour than R − 1 µm, if the path touches every element wherever a disc of R
fits, and if heights are reached where they are programmed; and, where rs274 takes it, if the path
is its own. A program that is refused has an element that the path beside it does not fit. All of it
under each way to begin and to end (dialect.comp_start), and by types A and B the tool comes to the
contour and goes from it as their equations say, at corners of every kind.

    python tests/comp_gate.py --count 300 --seed 1
"""

import argparse
import math
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

import contours
import numpy as np
import rs274_oracle

from pycnc.kernel.bind import lib
from pycnc.machine import Machine
from pycnc.program import Program

NEAR = 1e-3  # [mm] so much nearer than R is too near
SHORT = 1e-4  # [mm] shorter arcs about a corner are none
FREE = tuple(f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max"))
STARTS = ("rs274", "A", "B")
OPEN = Machine.load("mill3", set=(*FREE, "path.arc_radius_mm=0.05"))
MACHINES = {start: Machine.load(OPEN, set=[f"dialect.comp_start={start}"]) for start in STARTS}
LETTERS = {17: "XYIJZ", 18: "ZXKIY", 19: "YZJKX"}
AXES = {17: (0, 1, 2), 18: (2, 0, 1), 19: (1, 2, 0)}


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


def shapes_of(program, plane):
    """Return (line, element, height at its end) of each move."""
    u, v, w = AXES[plane]
    rows, at = [], 0j
    for block in program.blocks[program.blocks["kind"] <= lib.NCK_BLOCK_ARC]:
        place = block["target_nm"] / 1e6
        end = complex(place[u], place[v])
        if block["kind"] == lib.NCK_BLOCK_ARC:
            centre = complex(*block["centre_mm"])
            each = contours.Element(at, end, centre, float(block["sweep_rad"]))
        else:
            each = contours.Element(at, end)
        rows.append((int(block["line"]), each, float(place[w])))
        at = end
    return rows


def samples(element, count=40):
    """Return points of an element that has a length."""
    return element.points(np.linspace(0, 1, count))


def length(element):
    """Return the length of an element."""
    if element.sweep:
        return abs(element.sweep) * abs(element.start - element.centre)
    return abs(element.end - element.start)


def nearest(elements, points):
    """Return how far points are from the nearest of elements that have a length."""
    return contours.to_the_nearest([each for each in elements if length(each) > 1e-9], points)


def meets_itself(elements):
    """Tell whether a contour crosses itself, or comes back to a place of it."""
    for k, each in enumerate(elements):
        points = samples(each, 200)
        for m, other in enumerate(elements):
            if abs(m - k) > 1 and nearest([other], points).min() < 0.05 * length(each) + NEAR:
                return True
    return False


def beside(case, point, ahead):
    """Return where the tool is beside a point of the contour that goes in a direction there."""
    return point + 1j * case.side * case.radius * ahead / abs(ahead)


def round_about(case, corner, behind, ahead):
    """Return the places beside both sides of a corner that turns away from the tool, else none."""
    turn = -case.side * np.angle(np.conj(behind) * ahead)
    if turn * case.radius < SHORT:
        return []
    return [beside(case, corner, behind), beside(case, corner, ahead)]


def heading(element, q):
    """Return the direction of an element at a share of it."""
    return -1j * element.left(np.array([q]))[0]


def ways_differ(case, start, plain, path):
    """Return words for a way to the contour, or from it, that is not as the type says.

    plain: elements without compensation, the first move and the last among them; path: rows with
    it, from behind the first move on.
    """
    enter, first, *_ = plain
    *_, last, leave = plain
    to, at = first.start, last.end
    into, out = heading(first, 0.0), heading(last, 1.0)
    ends = [beside(case, to, into)]
    begins = [beside(case, at, out)]
    if start == "B":
        ends = round_about(case, to, enter.end - enter.start, into) or ends
        begins = round_about(case, at, out, leave.end - leave.start) or begins
    inward = max(abs(a - each.start) for a, (_, each, _) in zip(ends, path))
    tail = [each for line, each, _ in path if line == path[-1][0]]
    outward = max(abs(a - each.start) for a, each in zip(begins, tail))
    if len(tail) != len(begins):
        return f"{len(tail)} moves from the contour, not {len(begins)}"
    if max(inward, outward) > NEAR:
        return f"{inward:.4f} mm beside its way to the contour, {outward:.4f} mm from it"
    if len(begins) > 1 and np.ptp(np.abs(samples(tail[0]) - at)) > NEAR:
        return "no arc about the contour's end"
    return ""


def fault_of(case, start="rs274"):
    """Return (what became of a case, words for what is wrong); start: how it begins and ends."""
    machine = MACHINES[start]
    plain = Program(text_of(case, False).encode(), machine, file="plain")
    if any(each.severity == "error" for each in plain.diagnostics):
        return "no program", ""
    contour = [each for line, each, _ in shapes_of(plain, case.plane) if line >= 6][:-1]
    lines = [line for line, _, _ in shapes_of(plain, case.plane) if line >= 6][:-1]
    heights = {line: height for line, _, height in shapes_of(plain, case.plane)}
    program = Program(text_of(case).encode(), machine, file="part")
    errors = [each for each in program.diagnostics if each.severity == "error"]
    warned = any(each.id == "comp-left" for each in program.diagnostics)
    parts = case.parts or [0] * len(contour)
    parts = [parts[line - 6] for line in lines]
    if errors:
        return "refused", refusal(case, contour, parts, errors[0])
    rows = [row for row in shapes_of(program, case.plane) if row[0] >= 6]
    last = {line: height for line, _, height in rows}
    if any(abs(last.get(line, 1e9) - heights[line]) > 1e-6 for line in lines if not warned):
        return "cut", "an element, or its height, is missing"
    path = [each for _, each, _ in rows][:-1]
    simple = case.must or len(set(parts)) > 1 or not meets_itself(contour)
    for part in sorted(set(parts) - {-1}):
        walls = [each for each, other in zip(contour, parts) if other == part]
        own = {line for line, other in zip(lines, parts) if other == part}
        near = [e for line, e, _ in rows[:-1] if line in own and length(e) > 1e-9]
        points = np.concatenate([samples(each) for each in near])
        lap = len(set(parts) - {-1}) > 1  # it begins and ends beside another one
        if lap:
            points = points[np.abs(points - walls[0].start) > 2.5 * case.radius]
        depth = case.radius - nearest(walls, points).min(initial=np.inf)
        if simple and depth > NEAR:
            return "cut", f"{depth:.4f} mm too near"
        words = untouched(case, walls, [*path, rows[-1][1]])
        if words:
            return "cut", words
    words = ""
    if start != "rs274" and not warned:
        moves = [each for line, each, _ in shapes_of(plain, case.plane) if line >= 5]
        words = ways_differ(case, start, [each for each in moves if length(each) > 1e-6], rows)
    return "warned" if warned else "cut", words


def untouched(case, walls, path):
    """Return words for a place that the tool could touch and does not; where it leads in and out
    contours are cut short."""
    for each in filter(length, walls):
        q = np.linspace(0.1, 0.9, 7)
        beside = each.points(q) + case.side * case.radius * each.left(q)
        ends = np.minimum(np.abs(beside - walls[0].start), np.abs(beside - walls[-1].end))
        fits = (nearest(walls, beside) > case.radius - 1e-6) & (ends > 2.5 * case.radius)
        away = nearest(path, beside[fits]).max(initial=0.0)
        if away > NEAR:
            return f"{away:.4f} mm away from where it could touch"
    return ""


def refusal(case, contour, parts, error):
    """Return words for an error without a reason."""
    if case.must:
        return f"refused: {error.text().splitlines()[0]}"
    if error.id == "comp-radius" or error.id == "comp-entry":
        return ""
    q = np.linspace(0, 1, 100)
    for each in contour:
        beside = each.points(q) + case.side * case.radius * each.left(q)
        if nearest(contour, beside).min() < case.radius - NEAR:
            return ""
    return f"refused without a reason: {error.text().splitlines()[0]}"


# ---- families


def turned(case, rng):
    """Turn and shift a case, so that nothing in it is along an axis."""
    turn = np.exp(1j * rng.uniform(0, 2 * math.pi))
    shift = complex(*rng.uniform(-20, 20, 2))

    def move(point):
        return None if point is None else point * turn + shift

    case.start, case.entry, case.leave = map(move, (case.start, case.entry, case.leave))
    case.elements = [(move(e), move(c), sense, z) for e, c, sense, z in case.elements]
    return case


def before(rng, place, ahead, radius):
    """Return where a first move comes from: from behind, a little from one side."""
    return place - ahead * np.exp(1j * rng.uniform(-0.5, 0.5)) * radius * rng.uniform(1.5, 4)


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
    start = before(rng, begin, 1j * sense * (begin - hub) / lead, radius)
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
    start, leave = entry - 3 * radius * ahead + 2 * radius * free, entry + 4 * radius * free
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
    start, leave = -5 * radius + 0j, at + 5 * radius * ahead
    return Case(start, 0j, elements, radius, side, leave, must=False)


FORMS = (circle, helix, pocket, boss, laps, chain, ways, winding)
FAMILIES = {each.__name__: each for each in FORMS}


def case_of(family, seed):
    """Return a case; decimals and plane follow from the seed, too."""
    rng = np.random.default_rng([seed, sorted(FAMILIES).index(family)])
    case = None
    while case is None:
        case = FAMILIES[family](rng)
    case = turned(case, rng)
    case.decimals = int(rng.choice([0, 1, 2, 3, 3] if family == "chain" else [2, 3]))
    case.plane = int(rng.choice([17, 18, 19]))
    return case


def differs_from_rs274(case, folder):
    """Return words for what is not as in rs274; none if that refuses the program.

    It passes over corners of less than 0.05 rad, by up to R·0.025 along either side.
    """
    text = text_of(case).encode()
    file = folder / "part.ngc"
    file.write_bytes(text)
    moves, complaint = rs274_oracle.run(file, folder, {})
    program = Program(text, MACHINES["rs274"], file="part")
    if complaint or any(each.severity == "error" for each in program.diagnostics):
        return ""
    ours = [each for _, each, _ in shapes_of(program, case.plane)]
    theirs = rs274_oracle.elements_of(moves, AXES[case.plane])
    for one, other in ((ours, theirs), (theirs, ours)):
        points = np.concatenate([samples(each, 30) for each in one if length(each) > 1e-9])
        away = nearest(other, points).max()
        if away > 0.02 * case.radius + 1.5 * 10.0**-case.decimals:
            return f"{away:.4f} mm beside the path of rs274"
    ways = [sum(length(each) for each in elements) for elements in (ours, theirs)]
    if abs(ways[0] - ways[1]) > 0.1 * case.radius * (len(case.elements) + 1):
        return f"{ways[0]:.3f} mm long, rs274: {ways[1]:.3f} mm"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=100, help="cases of each family")
    parser.add_argument("--seed", type=int, default=1, help="the first one")
    parser.add_argument("--rs274", action="store_true", help="hold them beside rs274, too")
    parser.add_argument("families", nargs="*", default=list(FAMILIES))
    given = parser.parse_args()
    wrong = 0
    for family in given.families or FAMILIES:
        became = Counter()
        for seed in range(given.seed, given.seed + given.count):
            case = case_of(family, seed)
            for start in case.starts:
                what, words = fault_of(case, start)
                beside_theirs = given.rs274 and start == "rs274" and case.plane != 19
                if beside_theirs and not words and what != "no program":
                    with tempfile.TemporaryDirectory() as folder:
                        words = differs_from_rs274(case, Path(folder))
                became[f"{what} {start}"] += 1
                if words:
                    wrong += 1
                    print(f"{family} {seed} {start}: {words}", flush=True)
        print(family, dict(became), flush=True)
    print(f"{wrong} wrong")
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main())
