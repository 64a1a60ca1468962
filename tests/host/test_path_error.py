# SPDX-License-Identifier: MIT
"""How far a path is from its program: what C finds while the program streams by is what brute force
finds on dense points of all of it."""

import numpy as np
import pytest

from pycnc import kernel
from pycnc.kernel.records import dtype
from pycnc.machine import Machine
from pycnc.program import Program
from pycnc.report import path_error
from pycnc.report.path_error import PathError

HEAD = "G17 G21 G90 G94 "
DENSE = 801  # points of a move, of a seg
DENSER = 12001  # of a helix
TICKS = 300  # of a run
SPLINE, ARC = 2, 1
SHARE, NEAR_MM = 1e-5, 1e-4  # by how much the dense points may be off


def zigzag_of_all(seed):
    """Lines and arcs, never near to themselves again: each goes 3 mm up."""
    rng = np.random.default_rng(seed)
    yield "G64 P0.05 F2000"
    for k in range(1, 25):
        x, z = rng.uniform(-20, 20), rng.uniform(-3, 0)
        if k % 4 == 1:
            yield f"G{rng.integers(2, 4)} X{x:.3f} Y{3 * k} R{rng.uniform(60, 90):.3f}"
        elif k % 7 == 3:
            yield f"G{rng.integers(2, 4)} X{x:.3f} Y{3 * k} Z{z:.3f} R{rng.uniform(60, 90):.3f}"
        else:
            yield f"G1 X{x:.3f} Y{3 * k} Z{z:.3f}"


HELICES = [  # a pitch below the tolerance, and one above it
    "G64 P0.2 F3000", "G1 X8 Y3", "G3 I-4 J2 Z0.0007 P2", "G1 X30 Z-1", "G2 I5 Z-3 P3", "G1 Y9",
]  # fmt: skip
PROGRAMS = {f"zigzag {seed}": list(zigzag_of_all(seed)) for seed in range(4)} | {"helices": HELICES}


def program_of(lines, slope="jerk", **how):
    text = f"{HEAD}\n" + "\n".join(lines) + "\nM2\n"
    return Program(text.encode(), Machine.load("mill3", set=[f"path.slope={slope}"]), **how)


def segs_of(program):
    planner = kernel.Planner(program.text, program.machine, records=("seg",))
    return np.concatenate([segs.copy() for segs, _ in planner.pieces()])


def rows_of(program):
    controller = kernel.Simulation(program.text, program.machine)
    rows = np.concatenate([rows.copy() for rows, _ in controller.pieces()])
    rows = rows[rows["pose"]["line"] > 0]
    return rows[:: max(1, len(rows) // TICKS)]


def chords_distance(points, chain):
    """Return how far points are from the chords between neighbours of a chain: (n,)."""
    begin, way = chain[:-1], np.diff(chain, axis=0)
    square = np.maximum(np.einsum("mx,mx->m", way, way), 1e-300)
    found = []
    for point in points:
        q = np.clip(np.einsum("mx,mx->m", point - begin, way) / square, 0, 1)
        found.append(np.linalg.norm(begin + q[:, None] * way - point, axis=1).min())
    return np.array(found)


def chain_of_program(program, dense=DENSE):
    q, moves = np.linspace(0, 1, dense), program.moves
    blocks = np.flatnonzero(np.linalg.norm(moves.end - moves.start, axis=1) + moves.is_arc > 0)
    return np.concatenate([moves.point(np.full(dense, k), q) for k in blocks])


def points_of_seg(seg):
    f = np.linspace(0, 1, DENSE)[:, None]
    start, end = seg["start"], seg["end"]
    if seg["kind"] == SPLINE:
        inner = seg["shape"]["inner"]
        points = [start, inner[0], inner[1], end]
        while len(points) > 1:
            points = [a + (b - a) * f for a, b in zip(points, points[1:], strict=False)]
        return points[0]
    points = start + (end - start) * f
    if seg["kind"] == ARC:
        arc = np.frombuffer(seg["shape"].tobytes(), dtype("nck_seg_arc_t"), 1)[0]
        u, v, centre = arc["axis_u"], arc["axis_v"], arc["centre_u"] + 1j * arc["centre_v"]
        turned = (start[u] + 1j * start[v] - centre) * np.exp(1j * arc["sweep"] * f[:, 0]) + centre
        points[:, u], points[:, v] = turned.real, turned.imag
    return points


def errors_of(program, segs, rows):
    """Return the errors of both ways, each alone."""
    run, path = PathError(program), PathError(program)
    run.add(rows)
    for piece in np.array_split(segs, 7):
        path.add_segs(piece)
    path.finish_segs()
    return run, path


@pytest.mark.sample(6)
@pytest.mark.parametrize("slope", ["linear", "jerk"])
@pytest.mark.parametrize("name", PROGRAMS)
def test_both_ways_are_as_far_as_brute_force_finds(name, slope):
    program = program_of(PROGRAMS[name], slope)
    segs, rows = segs_of(program), rows_of(program)
    run, path = errors_of(program, segs, rows)
    chain = chain_of_program(program, DENSER if name == "helices" else DENSE)
    most = chords_distance(rows["pose"]["axis"], chain).max()
    assert run.largest_mm == pytest.approx(most, rel=SHARE, abs=NEAR_MM)
    made = np.concatenate([points_of_seg(seg) for seg in segs if seg["length"] > 0])
    corners = program.moves.end[program.blocks["kind"] <= 2]
    missed = chords_distance(corners, made).max()
    assert path.largest_mm >= missed * (1 - SHARE) - NEAR_MM
    assert path.largest_mm <= program.tolerance_most_mm
    assert path.missed == pytest.approx(path.largest_mm / program.tolerance_most_mm)


def one_row(s, *place):
    row = np.zeros(1, dtype("sim_row_t"))
    row["pose"]["line"], row["pose"]["s"] = 1, s
    row["pose"]["axis"][0, : len(place)] = place
    return row


def distance_at(program, s, *place):
    error = PathError(program)
    error.add(one_row(s, *place))
    return error.largest_mm


def test_a_setpoint_is_measured_from_the_nearest_of_the_moves_around():
    program = program_of(["F600", "G1 X10", "G3 X20 Y10 J10", "G1 Y20"])
    assert distance_at(program, 5, 5, 0.25) == pytest.approx(0.25, abs=1e-12)
    around = abs(np.hypot(0.5, -10) - 10)
    assert distance_at(program, 5, 10.5, 0) == pytest.approx(around, abs=1e-12), "on the next one"
    assert distance_at(program, 12, 19, 5) == pytest.approx(np.hypot(9, 5) - 10, abs=1e-12)
    assert distance_at(program, 12, 20.5, 15) == pytest.approx(0.5, abs=1e-12), "on the next one"
    assert distance_at(program, 99, 20, 21) == pytest.approx(1, abs=1e-12), "behind the end"


@pytest.mark.parametrize("rise", [0.0007, -0.05, 4])
@pytest.mark.parametrize("turns", [1, 3])
def test_beside_a_helix_the_nearest_turn_counts(rise, turns):
    """The one that is level is not the nearest where the pitch is less than the error."""
    program = program_of(["G1 X5 F600", f"G3 X5 Y0 I-5 Z{rise} P{turns}"])
    chain = chain_of_program(program, DENSER)
    rng, length = np.random.default_rng(2), turns * 10 * np.pi
    for q in rng.uniform(0.01, 0.99, 30):
        angle = 2 * np.pi * turns * q
        place = np.array([5 * np.cos(angle), 5 * np.sin(angle), rise * q, *[0] * 6])
        place[:3] += rng.uniform(-0.1, 0.1, 3)
        found = distance_at(program, 5 + np.hypot(length, rise) * q, *place)
        assert found == pytest.approx(chords_distance([place], chain)[0], abs=1e-5)


@pytest.mark.parametrize("name", ["zigzag 0", "helices"])
def test_rings_that_hold_what_is_near_are_enough(name, monkeypatch):
    program = program_of(PROGRAMS[name])
    segs, rows = segs_of(program), rows_of(program)
    whole = errors_of(program, segs, rows)
    monkeypatch.setattr(path_error, "_MOVES", 16)
    monkeypatch.setattr(path_error, "_MARKS", 40)
    monkeypatch.setattr(path_error, "_SEGS", 48)
    monkeypatch.setattr("pycnc.program._PIECE", 5)
    short = errors_of(program, segs, rows)
    assert [each.largest_mm for each in short] == [each.largest_mm for each in whole]
    assert [each.missed for each in short] == [each.missed for each in whole]


@pytest.mark.parametrize("tolerance", [0.05, 5])
def test_rings_that_are_too_short_measure_what_they_hold(tolerance, monkeypatch):
    """Short moves within a large tolerance: more of them than rows. All of them are measured, and
    what is nearer outside of the ring does not count."""
    moves = [f"X{k * 0.02:.2f} Y{0.03 * (k % 7):.2f}" for k in range(2000)]
    program = program_of([f"G64 P{tolerance}", "G1 F2000", *moves])
    segs, rows = segs_of(program), rows_of(program)
    whole = errors_of(program, segs, rows)
    monkeypatch.setattr(path_error, "_MOVES", 4)
    monkeypatch.setattr(path_error, "_MARKS", 8)
    monkeypatch.setattr(path_error, "_SEGS", 16)
    short = errors_of(program, segs, rows)
    for own, longer in zip(short, whole, strict=True):
        assert longer.largest_mm * (1 - 1e-12) <= own.largest_mm <= 1.5 * max(tolerance, 0.2)


def test_a_program_without_moves_is_no_error():
    program = program_of(["G4 P0.1"])
    run, path = errors_of(program, segs_of(program), rows_of(program))
    assert run.largest_mm == path.largest_mm == path.missed == 0
