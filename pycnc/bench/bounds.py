# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench bounds`: how near our motion is to the fastest that there can be.

Machine of the comparison (v 100 mm/s, a 1000 mm/s², j 10 000 mm/s³ an axis, T = 1 ms), every move
at F6000, from rest to rest. ours_s: the tick's motion under the slope `optimal`; ours_peak: the
largest share of v, a and j that it takes of any axis; ours_miss: how far it is from the program at
most, over P. tube_s: the best anywhere within P of the program, both ways, the tool's speed held to
F. IPOPT finds it from our motion on: an optimum, but a local one. It is checked on samples 1 ms
apart and slowed down until it keeps every limit, so such a motion exists. step: by how much half
the step makes it faster, what is left of it is the error of the pieces. tube_miss: how far the
tube's motion is from the program at most, both ways, over P. These numbers are the same on every
computer but for the last digits.
"""

import numpy as np

from pycnc.bench import bounds_tube, butterfly, corpus, programs
from pycnc.bench.bounds_solve import Limits, Seen, stretched
from pycnc.planning.plan import Plan
from pycnc.program import Program
from pycnc.report.trace import Trace

FEED = 6000  # of every move [mm/min]
STEP_S = 0.008  # of the tube's pieces, half of it along our path; then half of each
SEARCH_S = 2e-4  # between the places of a motion that are compared with the program


def _xy(text):
    """Return the places of a program of straight moves in X, Y and Z."""
    place, found = {axis: 0.0 for axis in "XYZ"}, []
    for line in text.decode(errors="replace").splitlines():
        words = [word for word in line.split() if word[0] in "XYZ"]
        place |= {word[0]: float(word[1:]) for word in words}
        if words and found[-1:] != [tuple(place.values())]:
            found.append(tuple(place.values()))
    return np.array(found)


def _corpus(name, first, moves):
    """Return the points of moves of a file of the corpus, None if it is not there."""
    file = corpus.FOLDER / name
    return _xy(file.read_bytes())[first : first + moves + 1] if file.exists() else None


def _butterfly(chord_mm, share=0.28):
    """Return the butterfly's first chords."""
    u = butterfly.cuts(chord_mm)
    return np.round(butterfly.point(u[u <= share]), 6)


def _spiral(count=60, chord=5.0, radius=100.0, pitch=4.0):
    """Return the points of chords along a spiral."""
    found, angle = [], 0.0
    for _ in range(count + 1):
        r = radius + pitch * angle / (2 * np.pi)
        found.append((r * np.cos(angle), r * np.sin(angle)))
        angle += chord / r
    return np.array(found)


def _arcs(radius, line=20.0):
    """Return points on, and the moves of, three lines that two half circles join."""
    angle = np.linspace(0, np.pi, int(np.pi * np.sqrt(radius / 0.004)) + 1)
    across, up = radius * np.sin(angle), radius * (1 - np.cos(angle))
    right = np.column_stack([line + across, up])
    left = np.column_stack([-across, 2 * radius + up])
    ends = (0, 0), (line, 4 * radius)
    moves = (
        f"G1 X{line}\nG3 Y{2 * radius} I0 J{radius}\nG1 X0\n"
        f"G2 Y{4 * radius} I0 J{radius}\nG1 X{line}\n"
    )
    return np.concatenate([ends[:1], right, left, ends[1:]]), moves


def _stairs(count, step):
    return _xy(programs.zigzag("", count, step))


# Name, points, tolerance [mm].
CASES = (
    ("two edges of 10 mm", lambda: _stairs(2, 10.0), 0.01),
    ("zigzag 12 × 1 mm", lambda: _stairs(12, 1.0), 0.01),
    ("zigzag 12 × 1 mm", lambda: _stairs(12, 1.0), 0.1),
    ("zigzag 6 × 10 mm", lambda: _stairs(6, 10.0), 0.01),
    ("butterfly 28 %, chords of 1 µm", lambda: _butterfly(0.001), 0.01),
    ("butterfly 28 %, chords of 5 µm", lambda: _butterfly(0.005), 0.01),
    ("butterfly 28 %, chords of 10 µm", lambda: _butterfly(0.01), 0.01),
    ("micro-segments, 1400", lambda: _xy(programs.micro("", 1400)), 0.01),
    ("spiral, 60 chords of 5 mm", _spiral, 0.01),
    ("lines and arcs of 2 mm", lambda: _arcs(2.0), 0.01),
    ("lines and arcs of 20 mm", lambda: _arcs(20.0), 0.01),
    ("relief, 160 moves", lambda: _corpus("surf_la_peinture_180k.gc", 0, 160), 0.01),
    ("pocketing, 130 moves", lambda: _corpus("surf_webgcode_46k.ngc", 2, 130), 0.01),
)


def bench_bounds_rows(cases=CASES, step_s=STEP_S):
    """Return rows {program, P, moves, ours_s, ours_peak, ours_miss, tube_s, ours_over_tube, step,
    tube_miss, note}.

    Raises
    ------
    AbsentError
        If CasADi is not installed.
    """
    return [_row(name, make(), tolerance, step_s) for name, make, tolerance in cases]


def _row(name, made, tolerance, step_s):
    row = {"program": name, "P": tolerance}
    if made is None:
        return row | {"note": "skipped: its file is not in ../shared/corpus"}
    points, moves = made if isinstance(made, tuple) else (made, None)
    points = points - points[0]
    points = points[:, points.any(axis=0)]
    limits = _limits(points.shape[1])
    plan, seen, facts = ours(points, tolerance, moves)
    ours_s = float(seen.t[-1])
    found = [bounds_tube.fastest(points, tolerance, limits, seen, step_s / k) for k in (1, 2)]
    tube_s, tube_miss = stretched(found[1], limits), miss(found[1], points) / tolerance
    row |= {"moves": len(points) - 1, "ours_s": ours_s, "ours_peak": _peak(facts),
            "ours_miss": facts["path_error_mm"] / tolerance}  # fmt: skip
    step = 1 - found[1].time_s / found[0].time_s
    row |= {"tube_s": tube_s}
    return row | {
        "ours_over_tube": ours_s / tube_s,
        "step": step,
        "tube_miss": tube_miss,
        "note": _note(found, ours_s, tube_s),
    }


def _note(motions, ours_s, tube_s):
    """Return what is wrong with a row, None if nothing is."""
    unsolved = {motion.status for motion in motions if not motion.is_solved}
    found = [f"not converged: {', '.join(sorted(unsolved))}"] if unsolved else []
    if tube_s > ours_s:
        found.append("the bound is above ours: not the optimum")
    return "; ".join(found) or None


def _limits(axes):
    machine = programs.machine()
    v, a, j = (machine.limits(f"{kind}_max")[:axes] for kind in "vaj")
    return Limits(v, a, j, FEED / 60)


def ours(points, tolerance, moves=None):
    """Return our plan of a polygon that begins where the machine is, and our motion.

    Parameters
    ----------
    points : numpy.ndarray
        (K + 1, D) [mm], the first is zero.
    tolerance : float
        P [mm].
    moves : str, optional
        What is run in place of the polygon: the moves that its points lie on.

    Returns
    -------
    plan : pycnc.planning.plan.Plan
    seen : Seen
    facts : dict
        What ``pycnc run --json`` tells of the motion.
    """
    axes = points.shape[1]
    program = _program(points, tolerance, moves, programs.machine())
    plan, trace = Plan(program), Trace(program)
    places = np.column_stack([trace[f"pos_{axis}_mm"] for axis in "xyz"[:axes]])
    places = np.concatenate([np.zeros((1, axes)), places])
    s = np.append(0.0, trace["s_mm"])
    t = np.arange(len(s)) * programs.machine().period_s
    seen = Seen(t, s, places, _corners_s(points, plan.segs, s, t))
    return plan, seen, trace.summary


def _program(points, tolerance, moves, machine):
    if not moves:
        return Program.from_points(points, FEED, machine, tolerance=tolerance)
    text = programs.head(f"G64 P{tolerance}") + f"F{FEED}\n{moves}M2\n"
    return Program(text.encode(), machine)


def _peak(facts):
    """Return the largest share that an axis takes of a limit."""
    axes = {name: peaks for name, peaks in facts["peaks"].items() if name != "path"}
    return max(peaks[kind] for peaks in axes.values() for kind in "vaj")


def _corners_s(points, segs, s, t):
    """Return when the path stands for each of the program's points."""
    programmed = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    ends = np.append(0.0, segs["s_begin"] + segs["length"])
    told = np.append(0.0, segs["s_begin"] + segs["length"])
    there = np.interp(programmed * told[-1] / programmed[-1], told, ends)
    found = np.interp(there, s + 1e-12 * np.arange(len(s)), t)
    found[[0, -1]] = t[[0, -1]]
    return found


def miss(motion, points):
    """Return how far a motion is from a polygon at most, and its corners from the motion [mm].

    Each place is compared with all moves, each corner with all places: nothing is taken from how
    the motion was found.
    """
    t = np.linspace(0, motion.time_s, int(np.ceil(motion.time_s / SEARCH_S)) + 1)
    places = motion.places(t)
    off = _off_polyline(places, points)
    return float(max(off.max(), _off_polyline(points, places).max()))


def _off_polyline(places, line):
    """Return the distance of each place from the nearest of a polyline's moves [mm]."""
    start, way = line[:-1], np.diff(line, axis=0)
    square = np.maximum((way**2).sum(axis=1), 1e-300)
    found = np.empty(len(places))
    for k, place in enumerate(places):
        apart = place - start
        along = np.clip((apart * way).sum(axis=1) / square, 0, 1)
        found[k] = (((apart - along[:, None] * way) ** 2).sum(axis=1)).min()
    return np.sqrt(found)
