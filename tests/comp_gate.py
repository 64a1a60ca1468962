# SPDX-License-Identifier: MIT
"""Contours under radius compensation, searched by seed: is every element cut, or told?

Circles and helices between tangents, laps, pockets, bosses, open spirals, level and on a ramp, and
chains of tangent elements, on both sides, in all planes, with 0 to 3 decimals. A program is good if
no part of the path is nearer to the contour than R − 1 µm, if the path touches every element
wherever a disc of R fits, and if heights are reached where they are programmed; and, where rs274
takes it, if the path is its own. In G17 the tool stands upright: it passes above what lies lower. A
program that is refused has an element that the path beside it does not fit, or a way to the contour
or from it that is in the contour further than R from where it begins or ends. All of it under each
way to begin and to end (dialect.comp_start), and by types A and B the tool comes to the contour and
goes from it as their equations say, at corners of every kind. How deep it is there is told.

    python tests/comp_gate.py --count 300 --seed 1
"""

import argparse
import math
import re
import sys
import tempfile
from collections import Counter
from pathlib import Path

import contours
import numpy as np
import rs274_oracle
from comp_families import FAMILIES, STARTS, case_of, text_of

from pycnc.kernel.bind import lib
from pycnc.machine import Machine
from pycnc.program import Program

NEAR = 1e-3  # [mm] so much nearer than R is too near
SHORT = 1e-4  # [mm] shorter arcs about a corner are none
FREE = tuple(f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max"))
OPEN = Machine.load("mill3", set=(*FREE, "path.arc_radius_mm=0.05"))
MACHINES = {start: Machine.load(OPEN, set=[f"dialect.comp_start={start}"]) for start in STARTS}
AXES = {17: (0, 1, 2), 18: (2, 0, 1), 19: (1, 2, 0)}


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


def levels(rows, case, lines):
    """Return the elements of lines that have a length, and the heights of their ends: where the
    tool does not stand upright on the plane, all are of one."""
    found, at = [], 0.0
    for line, each, height in rows:
        if line in lines and length(each) > 1e-9:
            found.append((each, at, height) if case.plane == 17 else (each, 0.0, 0.0))
        at = height
    return found


def places(elements, step):
    """Return points of elements with heights, and how high each is."""
    points, heights = [], []
    for each, begin, end in elements:
        q = np.linspace(0, 1, 3 + int(length(each) / step))
        points.append(each.points(q))
        heights.append(begin + (end - begin) * q)
    return np.concatenate(points), np.concatenate(heights)


def depth_in(walls, path, radius, level=1e-9):
    """Return how deep the tool is in walls at each place of a path; level: as much as a wall may be
    lower than it and is in its way."""
    depths = []
    for point, tip in zip(*path):
        high = walls[1] >= tip - level
        depths.append(radius - np.abs(walls[0][high] - point).min(initial=np.inf))
    return np.array(depths)


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


def comes_to(case, start, enter, contour):
    """Return where the first move may end: one place but for RS274NGC's inside of a corner, where
    an element cuts it short."""
    first = contour[0]
    to, ahead, into = first.start, enter.end - enter.start, heading(first, 0.0)
    turns_away = -case.side * np.angle(np.conj(ahead) * into) >= 0
    if start == "A" or (start == "B" and not turns_away):
        return [beside(case, to, into)]
    if turns_away:
        return [beside(case, to, ahead)]
    line = beside(case, enter.points(np.linspace(0, 1, 4000)), ahead)
    near = [np.abs(each.distance(line) - case.radius) < abs(ahead) / 1000 for each in contour]
    return line[np.any(near, axis=0)]


def leaves_from(case, start, at, last, leave):
    """Return the ways from where the path ends: by type B there may be an arc about the corner."""
    rounds = round_about(case, last.end, heading(last, 1.0), leave - last.end)
    if start != "B" or not rounds:
        return [contours.Element(at, leave)]
    turn = float(np.angle((rounds[1] - last.end) / (rounds[0] - last.end)))
    return [contours.Element(*rounds, last.end, turn), contours.Element(rounds[1], leave)]


def in_the_way(case, start, plain, rows, line):
    """Tell whether a way is in the contour further than R from where that begins or ends.

    plain: rows without compensation; rows: with it; line: of the way.
    """
    lines = range(6, plain[-1][0])
    walls = levels(plain, case, lines)
    contour = [each for each, *_ in walls]
    tip = next(height for own, _, height in plain if own == line)
    if line == 5:
        place, way = contour[0].start, next(each for own, each, _ in plain if own == 5)
        ends = comes_to(case, start, way, contour)
        moves = [contours.Element(way.start, end) for end in ends]
    else:
        place, leave = contour[-1].end, plain[-1][1].end
        moves = leaves_from(case, start, rows[-1][1].end, contour[-1], leave)
    points, heights = places(walls, case.radius / 100)
    away = np.abs(points - place) > 0.999 * case.radius
    tip = tip if case.plane == 17 else 0.0
    path = places([(each, tip, tip) for each in moves if length(each) > 1e-9], case.radius / 50)
    deep = depth_in((points[away], heights[away]), path, case.radius, 2 * NEAR)
    return deep.max(initial=0.0) > NEAR / 2


def own_lines(case, walls, line):
    """Return the lines of the contour against which a way is held in any case: one that comes back
    to itself begins anew there."""
    lines = sorted(walls)
    laps = sorted({part for part in case.parts if part >= 0})
    if laps:
        lap, lead = (laps[0], lines[0]) if line == 5 else (laps[-1], lines[-1])
        return [each for each, part in zip(lines, case.parts) if part == lap or each == lead]
    if case.must or case.ramps or not meets_itself([each for each, *_ in sum(walls.values(), [])]):
        return lines
    return lines[:1] if line == 5 else lines[-1:]


def depth_of(case, walls, way):
    """Return how deep a way is in walls, and how exact that is."""
    path = places(way, case.radius / 4000)
    deep = case.radius - nearest([each for each, *_ in walls], path[0]).min()
    if deep < NEAR or len({height for _, *ends in (*walls, *way) for height in ends}) == 1:
        return deep, 2 * NEAR
    step = case.radius / 100
    return depth_in(places(walls, step), places(way, step), case.radius).max(), step + 2 * NEAR


def untold(case, plain, rows, told):
    """Return words for a way that is in the contour, and not as deep as is told.

    told: the depth by the line of the way.
    """
    last = plain[-1][0]
    walls = {line: levels(plain, case, [line]) for line in range(6, last)}
    walls = {line: each for line, each in walls.items() if each}
    for line in (5, last):
        way, depth = levels(rows, case, [line]), told.get(line, 0.0)
        if not way:
            continue
        own = [row for each in own_lines(case, walls, line) for row in walls[each]]
        (least, close), (most, _) = (
            depth_of(case, each, way) for each in (own, sum(walls.values(), []))
        )
        if max(least, depth) > NEAR and not least - close < depth < most + close:
            return f"line {line} is {least:.4f} mm in the contour, told: {depth} mm"
    return ""


def fault_of(case, start="rs274"):
    """Return (what became of a case, words for what is wrong); start: how it begins and ends."""
    machine = MACHINES[start]
    plain = Program(text_of(case, False).encode(), machine, file="plain")
    if any(each.severity == "error" for each in plain.diagnostics):
        return "no program", ""
    plain = shapes_of(plain, case.plane)
    contour = [each for line, each, _ in plain if line >= 6][:-1]
    lines = [line for line, _, _ in plain if line >= 6][:-1]
    heights = {line: height for line, _, height in plain}
    program = Program(text_of(case).encode(), machine, file="part")
    errors = [each for each in program.diagnostics if each.severity == "error"]
    warned = any(each.id == "comp-left" for each in program.diagnostics)
    parts = case.parts or [0] * len(contour)
    parts = [parts[line - 6] for line in lines]
    whole = shapes_of(program, case.plane)
    if errors and "on its way" in errors[0].message:
        good = in_the_way(case, start, plain, whole, errors[0].line)
        return "in the way", "" if good else "a way that is refused is in no contour"
    if errors:
        return "refused", refusal(case, start, plain, errors[0])
    told = {each.line: float(re.search(r"[\d.]+ mm", each.message)[0][:-3])
            for each in program.diagnostics if each.id == "comp-way"}  # fmt: skip
    words = untold(case, plain, whole, told)
    if words:
        return "cut", words
    rows = [row for row in whole if row[0] >= 6]
    last = {line: height for line, _, height in rows}
    if any(abs(last.get(line, 1e9) - heights[line]) > 1e-6 for line in lines if not warned):
        return "cut", "an element, or its height, is missing"
    path = [each for _, each, _ in rows][:-1]
    if case.ramps:
        return "warned" if warned else "cut", fault_of_ramp(case, plain, whole)
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
        moves = [each for line, each, _ in plain if line >= 5]
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


def along(case, walls, shares):
    """Return where the tool is beside elements with heights, and how high, element by element."""
    for each, begin, end in walls:
        beside = each.points(shares) + case.side * case.radius * each.left(shares)
        yield beside, begin + (end - begin) * shares


def fault_of_ramp(case, plain, rows):
    """Return words for what is wrong with a path that is beside each element or above it."""
    lines = range(6, plain[-1][0])
    walls = levels(plain, case, lines)
    points = places(walls, case.radius / 60)
    path = places(levels(rows, case, lines), case.radius / 10)
    deep = depth_in(points, path, case.radius).max()
    if deep > NEAR:
        return f"{deep:.4f} mm too near"
    begin, end = walls[0][0].start, walls[-1][0].end
    owners = [line for line, each, _ in plain if line in lines and length(each) > 1e-9]
    for line, (beside, tips) in zip(owners, along(case, walls, np.linspace(0.1, 0.9, 7))):
        ends = np.minimum(np.abs(beside - begin), np.abs(beside - end)) > 2.5 * case.radius
        fits = (depth_in(points, (beside, tips), case.radius) < 1e-6) & ends
        own = [each for other, each, _ in rows if other == line]
        away = nearest(own, beside[fits]).max(initial=0.0)
        if away > NEAR:
            return f"{away:.4f} mm away from where it could touch line {line}"
    return ""


def passes_by(case, enter, walls):
    """Tell whether RS274NGC's first move does not meet what is beside the first element: inside a
    corner with a small arc it leads past that."""
    shares = np.linspace(0, 1, 4000)
    ends = beside(case, enter.points(np.array([0.0, 1.0])), enter.end - enter.start)
    places, _ = next(along(case, walls, shares))
    return contours.Element(*ends).distance(places).min() > length(walls[0][0]) / 2000


def refusal(case, start, plain, error):
    """Return words for an error without a reason."""
    if case.must:
        return f"refused: {error.text().splitlines()[0]}"
    if error.id == "comp-radius" or error.id == "comp-entry":
        return ""
    walls = levels(plain, case, range(6, plain[-1][0]))
    enter = next(each for line, each, _ in plain if line == 5)
    if error.line == 5 and start == "rs274" and passes_by(case, enter, walls):
        return ""
    points = places(walls, case.radius / 60)
    for each in along(case, walls, np.linspace(0, 1, 100)):
        if depth_in(points, each, case.radius, 2 * NEAR).max() > NEAR:
            return ""
    return f"refused without a reason: {error.text().splitlines()[0]}"


def turned(elements, centre, close):
    """Return by how much arcs turn about a centre [rad]."""
    return sum(abs(each.sweep) for each in elements if abs(each.centre - centre) < close)


def loses_turn(case, elements):
    """Tell whether a path lacks one of the turns that are programmed: most of one about its centre.

    rs274 does, where a turn ends in a corner that it passes over, and begins behind its end then.
    """
    plain = Program(text_of(case, False).encode(), MACHINES["rs274"], file="plain")
    programmed = [each for _, each, _ in shapes_of(plain, case.plane)]
    close = 1.5 * 10.0**-case.decimals
    for each in programmed:
        missing = turned(programmed, each.centre, close) - turned(elements, each.centre, close)
        if abs(each.sweep) > math.pi and missing > math.pi:
            return True
    return False


def differs_from_rs274(case, folder):
    """Return words for what is not as in rs274; none if that refuses the program, or loses a turn.

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
    if loses_turn(case, theirs) and not loses_turn(case, ours):
        return ""
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
