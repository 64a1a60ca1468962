# SPDX-License-Identifier: MIT
"""Room 1: corners that ,R rounds and ,C cuts off, by geometry on random contours."""

import math
import random

import numpy as np
import pytest

from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

FREE = [f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
NEAR = 1e-5  # [mm] roundings to nanometres, seen from the far end of an arc


@pytest.fixture(scope="module")
def mill():
    return Machine.load("mill3", set=[*FREE, "dialect.base=fanuc"])


def decode(text, machine):
    blocks, diagnostics = stages.decode(text.encode(), machine)
    errors = diagnostics[diagnostics["code"] < 0]
    return blocks, [status_id(int(each["code"])) for each in errors]


def way_at(block, place):
    """Return the unit vector along a block's path at a place of it."""
    if block["kind"] == lib.NCK_BLOCK_ARC:
        out = place - block["centre_mm"]
        way = np.array([-out[1], out[0]]) * math.copysign(1, block["sweep_rad"])
    else:
        way = block["target_nm"][:2] / 1e6 - place
    return way / np.linalg.norm(way)


def contour(source, letter):
    """Return the lines of a random walk whose corners have words, and the sizes."""
    lines, sizes = ["G21 G17 G90 G94 G1 X0 Y0 F100"], []
    at, heading = np.zeros(2), 0.0
    for _ in range(40):
        heading += source.choice((-1, 1)) * source.uniform(0.3, 2.4)
        length = source.uniform(20, 40)
        at = at + length * np.array([math.cos(heading), math.sin(heading)])
        size = round(source.uniform(0.1, 1.5), 3)
        bulge = source.choice((0, 0, 1, -1))
        move = "G1" if bulge == 0 else ("G2" if bulge > 0 else "G3")
        word = "" if bulge == 0 else f" R{source.uniform(0.8, 3) * length:.4f}"
        lines.append(f"{move} X{at[0]:.4f} Y{at[1]:.4f}{word} ,{letter}{size}")
        sizes.append(size)
    lines[-1] = lines[-1].split(" ,")[0]
    return "\n".join([*lines, "M30", ""]), sizes[:-1]


@pytest.mark.parametrize("seed", range(60))
def test_a_rounded_contour_has_no_bend_and_ends_where_it_did(seed, mill):
    text, sizes = contour(random.Random(seed), "R")
    plain = "\n".join(line.split(" ,")[0] for line in text.splitlines()) + "\n"
    exact, none = decode(plain, mill)
    blocks, errors = decode(text, mill)
    if errors:  # two edges may meet without a corner, or turn in too far
        assert errors == ["corner"]
        return
    assert none == []
    moves = blocks[blocks["kind"] <= lib.NCK_BLOCK_ARC]
    assert moves[-1]["target_nm"].tolist() == exact[exact["kind"] <= lib.NCK_BLOCK_ARC][-1][
        "target_nm"
    ].tolist()
    assert len(moves) == 1 + 40 + len(sizes)
    for k, size in enumerate(sizes):
        before, piece, behind = moves[1 + 2 * k : 4 + 2 * k]
        start, end = before["target_nm"][:2] / 1e6, piece["target_nm"][:2] / 1e6
        for place in (start, end):
            assert np.linalg.norm(place - piece["centre_mm"]) == pytest.approx(size, abs=NEAR)
        places = moves["target_nm"][2 * k : 4 + 2 * k, :2] / 1e6
        shortest = np.linalg.norm(np.diff(places, axis=0), axis=1).min()
        bend_most = 1e-6 + 3e-6 / shortest  # ends are whole nanometres
        joints = [(way_at(piece, start), before, start), (way_at(piece, end), behind, end)]
        for way, other, place in joints:
            if other["kind"] == lib.NCK_BLOCK_ARC:
                theirs = way_at(other, place)
            elif other is before:
                theirs = place - moves[2 * k]["target_nm"][:2] / 1e6
                theirs = theirs / np.linalg.norm(theirs)
            else:
                theirs = way_at(other, place)
            assert way @ theirs > 0, k
            assert abs(way[0] * theirs[1] - way[1] * theirs[0]) < bend_most, k


def test_most_random_contours_can_be_rounded(mill):
    fits = sum(not decode(contour(random.Random(seed), "R")[0], mill)[1] for seed in range(60))
    assert fits >= 20


@pytest.mark.parametrize("seed", range(40))
def test_a_chamfer_ends_that_far_from_the_corner(seed, mill):
    text, sizes = contour(random.Random(seed), "C")
    plain = "\n".join(line.split(" ,")[0] for line in text.splitlines()) + "\n"
    corners = decode(plain, mill)[0]["target_nm"][1:-2, :2] / 1e6
    blocks, errors = decode(text, mill)
    assert errors == []
    moves = blocks[blocks["kind"] <= lib.NCK_BLOCK_ARC]["target_nm"][:, :2] / 1e6
    for k, size in enumerate(sizes):
        for place in moves[1 + 2 * k : 3 + 2 * k]:
            assert np.linalg.norm(place - corners[k]) == pytest.approx(size, abs=NEAR)


def test_radius_compensation_runs_beside_the_corner():
    tools = Machine.load("mill3", set=[*FREE, "dialect.base=fanuc", "tool.1.radius_mm=2"])
    head = "G21 G17 G90 G94 F100\nT1 M6\nG0 X-20 Y-20\nG41 D1 G1 X0 Y0\n"
    with_word = head + "X30 ,R5\nY30\nX0\nG40 X-20\nM30\n"
    by_hand = head + "X25\nG3 X30 Y5 R5\nG1 Y30\nX0\nG40 X-20\nM30\n"
    ours, theirs = (
        [block for block in decode(text, tools)[0] if block["kind"] <= lib.NCK_BLOCK_ARC]
        for text in (with_word, by_hand)
    )
    assert [b["target_nm"].tolist() for b in ours] == [b["target_nm"].tolist() for b in theirs]


def test_a_roughed_contour_has_its_corners():
    lathe = Machine.load("cak6150n", set=["dialect.base=fanuc"])
    head = "G21 G98 G0 X60 Z2 F100\nG71 U2 R1\nG71 P10 Q20 U0 W0\nN10 G0 X20\n"
    tail = "G70 P10 Q20\nM30\n"
    rounded, errors = decode(head + "G1 Z-20 ,R3\nX40 ,C2\nN20 Z-40\n" + tail, lathe)
    by_hand = "G1 Z-17\nG2 X26 Z-20 R3\nG1 X36\nX40 Z-22\nN20 Z-40\n"
    hand, none = decode(head + by_hand + tail, lathe)
    assert errors == none == []
    assert np.abs(rounded["target_nm"] - hand["target_nm"]).max() <= 2


def test_a_contour_cannot_end_in_a_corner():
    lathe = Machine.load("cak6150n", set=["dialect.base=fanuc"])
    text = "G21 G98 G0 X60 Z2 F100\nG71 U2 R1\nG71 P10 Q20 U0 W0\nN10 G0 X20\nN20 G1 Z-20 ,R3\n"
    assert decode(text + "G0 X70\nM30\n", lathe)[1] == ["corner"]


def test_a_corner_alone_is_the_one_mistake(mill):
    assert decode(",R2", mill)[1] == ["corner"]


@pytest.mark.parametrize("cycle", ["G75 X10 Z-12 P3000 Q2", "G74 X10 Z-12 P3000 Q2000"])
def test_no_cycle_follows_a_corner(cycle):
    lathe = Machine.load("cak6150n", set=["dialect.base=fanuc"])
    text = f"G21 G98 G0 X40 Z5 F100\n{cycle[:3]} R0.5\nG1 Z0 ,R1\n{cycle}\nG0 Z9\nM30\n"
    blocks, errors = decode(text, lathe)
    assert errors == ["corner"]
    assert set(blocks["line"]) <= {1, 5, 6}
