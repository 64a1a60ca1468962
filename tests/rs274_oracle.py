# SPDX-License-Identifier: MIT
"""LinuxCNC's rs274 as an oracle: its canonical motions, and where they differ from decoded blocks.

rs274 prints positions with four decimals, in the units of the program, without work offset and G92.
"""

import cmath
import math
import os
import re
import subprocess
from dataclasses import dataclass, replace

import contours
import numpy as np

from pycnc.kernel.bind import lib

ROUNDING = 0.51e-4  # half of the last of four decimals, in the units of the program
PLANES = {"XY": (0, 1, 2), "XZ": (2, 0, 1), "YZ": (1, 2, 0)}
BLOCK_PLANES = {17: (0, 1), 18: (2, 0), 19: (1, 2)}
CALL = re.compile(r"^\s*\d+ N\S+\s+(\w+)\((.*)\)$")
SYNCHRONOUS = ("START_SPEED_FEED_SYNC", "STOP_SPEED_FEED_SYNCH")
THREADS = (lib.NCK_BLOCK_THREAD, lib.NCK_BLOCK_TAP)
AXES = 6  # X Y Z A B C: what rs274 prints


def _near(a, b, tolerance):
    return all(abs(x - y) <= tolerance for x, y in zip(a, b))


@dataclass
class Move:
    """One motion: end and centre in machine coordinates [mm, deg]."""

    kind: str  # rapid, line, arc
    end: list
    plane: tuple = ()
    centre: tuple = ()
    turns: int = 0  # + anticlockwise; 1: up to a whole turn
    feed: float = 0.0  # in force, as printed: per minute
    unit: float = 1.0  # mm in the unit of the feed
    tolerance: float = 0.0  # how far its numbers may be off by their rounding [mm]
    line: int = 0
    only_rotary: bool = False  # nothing but rotary axes moves: the feed is in deg/min
    drill: int = 2  # axis that stands on the plane in force
    cycle: int = 0  # how many remarks that say (cycle) stand before it; 0 behind one of (plain)
    remark: str = ""  # the last one before it
    lead: float = 0.0  # of a thread: along the path, a revolution [mm]
    rpm: float = 0.0  # of the spindle, as last said


class Listing:
    """The canonical commands of rs274, read one by one into `moves`."""

    def __init__(self, text):
        self.unit, self.plane, self.feed = 1.0, PLANES["XY"], (0.0, 1.0)
        self.offsets = {name: ([0.0] * AXES, 0.0) for name in ("G5X", "G92")}
        self.turn = 1 + 0j  # of the work system in X and Y
        self.at = [0.0] * AXES
        self.moves, self.cycles, self.cycle, self.tolerance = [], 0, 0, 0.0
        self.remark, self.lead, self.rpm = "", 0.0, 0.0
        for line in text.splitlines():
            if match := CALL.match(line):
                self._read(match[1], match[2])

    def _scale(self):
        return [self.unit] * 3 + [1.0] * 3

    def _offset(self):
        return [sum(pair) for pair in zip(*(values for values, _ in self.offsets.values()))]

    def _tolerance(self):
        return ROUNDING * self.unit + sum(error for _, error in self.offsets.values())

    def _read(self, name, arguments):
        if name == "COMMENT":
            self.cycles += arguments == '"cycle"'
            self.cycle = {'"cycle"': self.cycles, '"plain"': 0}.get(arguments, self.cycle)
            own = arguments.startswith('"interpreter:')
            self.remark = self.remark if own else arguments.strip('"')
        elif name == "USE_LENGTH_UNITS":
            self.unit = 25.4 if "INCH" in arguments else 1.0
        elif name == "SELECT_PLANE":
            self.plane = PLANES[arguments[-2:]]
        elif name == "SET_FEED_RATE":
            self.feed = float(arguments), self.unit
        elif name in ("SET_G5X_OFFSET", "SET_G92_OFFSET"):
            numbers = [float(word) for word in arguments.split(",")][-AXES:]
            error = ROUNDING * self.unit if any(numbers) else 0.0
            values = [a * b for a, b in zip(numbers, self._scale())]
            self.offsets[name[4:7]] = values, error
        elif name == "SET_XY_ROTATION":
            self.turn = cmath.exp(1j * math.radians(float(arguments)))
        elif name == "SET_SPINDLE_SPEED":
            self.rpm = float(arguments.split(",")[1])
        elif name in SYNCHRONOUS:
            self.lead = float(arguments.split(",")[0] or 0.0) * self.unit
        elif name == "RIGID_TAP":
            self._tap([float(word) for word in arguments.split(",")])
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED"):
            self._move(name, [float(word) for word in arguments.split(",")])

    def _tap(self, numbers):
        """In, and out again to where it stands, which has the rounding of the move to there."""
        back = [a - b for a, b in zip(self.at, self._offset())]
        back = [number / unit for number, unit in zip(back, self._scale())]
        self._move("STRAIGHT_FEED", numbers + back[3:])
        self._move("STRAIGHT_FEED", back)
        self.tolerance = self.moves[-1].tolerance = self.moves[-2].tolerance

    def _place(self, numbers):
        """Return the machine position that the numbers of six axes name."""
        (zero, _), (shift, _) = self.offsets["G5X"], self.offsets["G92"]
        at = [n * scale + more for n, scale, more in zip(numbers, self._scale(), shift)]
        turned = complex(at[0], at[1]) * self.turn
        return [a + b for a, b in zip((turned.real, turned.imag, *at[2:]), zero)]

    def _move(self, name, numbers):
        if name == "ARC_FEED":
            u, v, w = self.plane
            end, centre = [0.0] * AXES, [0.0] * AXES
            for axis, number in zip((u, v, w, 3, 4, 5), (*numbers[:2], *numbers[5:9])):
                end[axis] = number
            centre[u], centre[v] = numbers[2:4]
            end, centre = self._place(end), self._place(centre)
            move = Move("arc", end, (u, v), (centre[u], centre[v]), int(numbers[4]))
        else:
            end = self._place(numbers[:AXES])
            move = Move("rapid" if name == "STRAIGHT_TRAVERSE" else "line", end)
        # The first move behind a change of units begins where the others' rounding has left it.
        (move.feed, move.unit), before = self.feed, self.tolerance
        self.tolerance = self._tolerance()
        move.tolerance = max(before, self.tolerance)
        move.drill, move.cycle, move.remark = self.plane[2], self.cycle, self.remark
        move.lead, move.rpm = self.lead, self.rpm
        self.moves.append(move)
        self.at = end


def run(program, folder, tools):
    """Return (moves, complaint) of rs274 on a file; tools: number → length, or (length, radius)."""
    table = ""
    for n, size in tools.items():
        length, radius = size if isinstance(size, tuple) else (size, 0.0)
        table += f"T{n} P{n} Z{length / 25.4:.10g} D{2 * radius / 25.4:.10g}\n"
    (folder / "tool.tbl").write_text(table)
    (folder / "params.var").write_text("")
    output = folder / "canon.txt"
    command = ["timeout", "60", "rs274", "-g", "-t", folder / "tool.tbl"]
    command += ["-v", folder / "params.var", "-n", "2", program, output]
    home = {**os.environ, "HOME": str(folder)}  # where it shares its tools with every other one
    done = subprocess.run(
        command, stdin=subprocess.DEVNULL, capture_output=True, text=True, env=home
    )
    complaint = "" if done.returncode == 0 else done.stderr.strip()
    return Listing(output.read_text(errors="replace")).moves, complaint


def drill_upright(moves):
    """Return moves with those of canned cycles as LinuxCNC's manual and RS274NGC order them.

    Below R the drill rises to R first, and the way to a hole is parallel to the plane. rs274 goes
    there and up to the height of G98 in one, and comes down to R before it goes where R is above
    that height.
    """
    told, at, k, line = [], [0.0] * AXES, 0, 0
    while k < len(moves):
        move, following = moves[k], moves[min(k + 1, len(moves) - 1)]
        axis, begins, line = move.drill, move.cycle != line, move.cycle
        aside, rise = _aside(at, move), move.end[axis] - at[axis]
        steps = [move]
        if move.cycle and move.kind == "rapid" and rise > 2 * move.tolerance and aside:
            down = following.kind == "rapid" and not _aside(move.end, following)
            height = min(move.end[axis], following.end[axis] if down else math.inf)
            steps = [_at_height(move, at, height), _at_height(move, move.end, height)]
            k += height < move.end[axis]
        elif move.cycle and begins and rise < 0 and not aside:
            over = following.kind == "rapid" and following.end[axis] == move.end[axis]
            if over and following.cycle == line:
                steps = [_at_height(following, following.end, at[axis]), following]
                k += 1
        if steps != [move]:  # heights of the move before have its rounding
            before = told[-1].tolerance if told else 0.0
            steps = [replace(each, tolerance=max(each.tolerance, before)) for each in steps]
        told += steps
        at = told[-1].end
        k += 1
    return told


def _aside(at, move):
    return any(
        abs(move.end[j] - at[j]) > 2 * move.tolerance for j in range(AXES) if j != move.drill
    )


def _at_height(move, place, height):
    end = list(place)
    end[move.drill] = height
    return replace(move, end=end)


def _threads(block, at, end):
    """Return a pass as a line and the way out, a tap as the ways in and out."""
    tap = block["kind"] == lib.NCK_BLOCK_TAP
    word = block["tap" if tap else "thread"]
    inner = [a + b for a, b in zip(at, word["way"])] + end[3:] if tap else list(end)
    inner[0] -= 0.0 if tap else float(word["leave"])
    lead = float(word["lead"])  # of a thread along an axis, maybe
    along = math.dist(inner[:3], at[:3])
    lead *= 1.0 if tap else along / float(word["length"])
    into = Move("line", inner, line=int(block["line"]), feed=-1.0, lead=lead)
    if not tap and not word["leave"]:
        return [into]
    return [into, replace(into, kind="line" if tap else "rapid", end=end, lead=tap * into.lead)]


def from_blocks(blocks, counts_per_degree):
    """Return the moves of decoded blocks from a start at zero; an arc in two parts is one."""
    counts = [1e6] * 3 + [float(counts_per_degree)] * 3
    moves, sweep, at = [], 0.0, [0, 0, 0]
    for block in blocks[(blocks["kind"] <= 2) | np.isin(blocks["kind"], THREADS)]:
        if block["kind"] > 2:
            end = [float(a) / b for a, b in zip(block["target_nm"][:AXES], counts)]
            moves += _threads(block, moves[-1].end, end)
            at = (block["target_nm"][:3] + block["tool_nm"]).tolist()
            continue
        end = [float(a) / b for a, b in zip(block["target_nm"][:AXES], counts)]
        move = Move(("rapid", "line", "arc")[block["kind"]], end, line=int(block["line"]))
        move.feed = float(block["feed"]) if block["feed_mode"] == 0 else -1.0
        before, at = at, (block["target_nm"][:3] + block["tool_nm"]).tolist()
        turned = not moves or move.end[3:] != moves[-1].end[3:]
        move.only_rotary = move.kind != "arc" and at == before and turned
        if move.kind == "arc":
            move.centre = tuple(block["centre_mm"])
            last = moves[-1] if moves else move
            same = last.line == move.line and _near(last.centre, move.centre, 0.1)
            whole = abs(sweep) > 1e-6 and abs(math.remainder(sweep, 2 * math.pi)) < 1e-6
            # A loop's next one is elsewhere, or follows a whole turn.
            joins = moves and last.kind == "arc" and same and not whole
            sweep = float(block["sweep_rad"]) + (sweep if joins else 0.0)
            turns = math.ceil(abs(sweep) / (2 * math.pi) - 1e-6)
            move.turns = int(math.copysign(max(turns, 1), sweep))
            move.plane = BLOCK_PLANES[int(block["plane"])]
            if joins:
                moves.pop()
        moves.append(move)
    return moves


def _arc_differs(ours, theirs, start):
    """What differs between two arcs with the same ends.

    Our centre is moved onto the chord's bisector: by what theirs is beside it, and by the rounding
    of their numbers, which a short chord magnifies.
    """
    if ours.turns != theirs.turns or ours.plane != theirs.plane:
        return f"turns {ours.turns} in {ours.plane}, not {theirs.turns} in {theirs.plane}"
    u, v = theirs.plane
    chord = [theirs.end[u] - start[u], theirs.end[v] - start[v]]
    length = math.hypot(*chord)
    middle = [(theirs.end[u] + start[u]) / 2, (theirs.end[v] + start[v]) / 2]
    radius = math.hypot(theirs.centre[0] - start[u], theirs.centre[1] - start[v])
    allowed = 3 * theirs.tolerance
    if length > theirs.tolerance:
        from_middle = [theirs.centre[k] - middle[k] for k in range(2)]
        aside = abs(from_middle[0] * chord[0] + from_middle[1] * chord[1]) / length
        allowed = allowed * (1 + 2 * radius / length) + aside
    if not _near(ours.centre, theirs.centre, allowed):
        return f"centre {ours.centre}, not {theirs.centre} within {allowed:.2g}"
    return ""


def difference(ours, theirs):
    """Return (moves that are equal, words for the first that is not).

    Straight moves that are shorter than their numbers' rounding may be missing on either side.
    """
    at, i, j, equal = [0.0] * AXES, 0, 0, 0
    while i < len(ours) and j < len(theirs):
        a, b = ours[i], theirs[j]
        if a.kind == b.kind and _near(a.end, b.end, b.tolerance):
            if a.kind == "arc" and (words := _arc_differs(a, b, at)):
                return equal, f"line {a.line}: {words}"
            feed = b.feed * (1.0 if a.only_rotary else b.unit)
            cut = a.kind != "rapid" and a.feed >= 0.0
            if cut and abs(a.feed - feed) > 2 * b.tolerance + 1e-9 * feed:
                return equal, f"line {a.line}: feed {a.feed}, not {feed}"
            if abs(a.lead - b.lead) > 2e-4 * max(1.0, b.unit):
                return equal, f"line {a.line}: lead {a.lead}, not {b.lead}"
            at, i, j, equal = b.end, i + 1, j + 1, equal + 1
        elif a.kind != "arc" and _near(a.end, at, 2 * b.tolerance):
            i += 1
        elif b.kind != "arc" and _near(b.end, at, 2 * b.tolerance):
            j += 1
        else:
            return equal, f"line {a.line}: {a} is not {b}"
    return equal, ""


def elements_of(moves, axes):
    """Return the elements of rs274's moves in the plane of two axes, and how far each turns."""
    u, v, _ = axes
    elements, at = [], 0j
    for move in moves:
        end = complex(move.end[u], move.end[v])
        if move.kind == "arc":
            centre = complex(*move.centre)
            turn = math.copysign(1, move.turns)
            sweep = turn * (np.angle((end - centre) / (at - centre)) * turn % (2 * math.pi))
            whole = abs(at - end) < 0.02 * abs(at - centre)  # its own ends of a circle lie apart
            sweep = turn * 2 * math.pi if whole else sweep
            elements.append(contours.Element(at, end, centre, sweep))
        elif abs(end - at) > 1e-4:
            elements.append(contours.Element(at, end))
        at = end
    return elements
