# SPDX-License-Identifier: MIT
"""Room 1: G70 … G73 of lathes, held against the contour by geometry."""

import contour_programs
import numpy as np
import pytest

from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

FREE = [f"axis.{axis}.{end}_mm=free" for axis in "xz" for end in ("min", "max")]
GRID = 0.01  # [mm] places where the work is looked at
NEAR = 1e-3  # [mm] the points stand for arcs, also for upright ones


def lathe(*more):
    """Return a lathe without limits whose X is a radius."""
    given = [*FREE, "work.g54.z_mm=0", "dialect.diameter=false", "dialect.system=A", *more]
    return Machine.load("cak6150n", set=given)


def decode(text, machine):
    """Return the blocks of a text without errors."""
    blocks, diagnostics = stages.decode(text.encode(), machine)
    errors = diagnostics[diagnostics["code"] < 0]
    assert [(status_id(int(each["code"])), each["line"]) for each in errors] == []
    return blocks


def first_error(text, machine):
    _, diagnostics = stages.decode(text.encode(), machine)
    errors = diagnostics[diagnostics["code"] < 0]
    return (status_id(int(errors[0]["code"])), int(errors[0]["line"])) if len(errors) else None


def moves(blocks, contour, first_line):
    """Yield kind and points (a, d) of the moves from a line on, from where the tool stands."""
    at = None
    for block in blocks[blocks["kind"] <= lib.NCK_BLOCK_ARC]:
        x, z = block["target_nm"][0] / 1e6, block["target_nm"][2] / 1e6
        if at is not None and block["line"] >= first_line:
            way = np.linspace(0, 1, 2000)[:, None]
            if block["kind"] == lib.NCK_BLOCK_ARC:
                cz, cx = block["centre_mm"]
                angle = np.arctan2(at[0] - cx, at[1] - cz) + way * block["sweep_rad"]
                radius = np.hypot(at[0] - cx, at[1] - cz)
                path = np.hstack([cx + radius * np.sin(angle), cz + radius * np.cos(angle)])
            else:
                path = np.array(at) + way * np.subtract((x, z), at)
            a, d = contour.from_lathe(path[:, 0], path[:, 1])
            yield int(block["kind"]), a, d
        at = x, z


def cut_away(blocks, contour, height, grid, first_line, stock):
    """Move the tool: it never passes the height; return the most that a rapid and a cut took."""
    most = {lib.NCK_BLOCK_RAPID: 0.0, lib.NCK_BLOCK_LINE: 0.0}
    for kind, a, d in moves(blocks, contour, first_line):
        order = np.argsort(a)
        low, high = np.searchsorted(grid, (a.min() - 1e-9, a.max() + 1e-9))
        over = slice(low, high)
        tool = np.interp(grid[over], a[order], d[order])
        assert (tool >= height[over] - NEAR).all(), (kind, (height[over] - tool).max())
        rapid = lib.NCK_BLOCK_RAPID if kind == lib.NCK_BLOCK_RAPID else lib.NCK_BLOCK_LINE
        most[rapid] = max(most[rapid], (stock[over] - tool).max(initial=0.0))
        stock[over] = np.minimum(stock[over], tool)
    return most


def roughing(contour, depth, spare_d, spare_a):
    """Return the text of a roughing cycle on a contour, and the line where it stands."""
    code = "G72" if contour.facing else "G71"
    x, z = contour.start
    along, deep = -contour.signs[0] * spare_a, contour.signs[1] * spare_d
    u, w = (along, deep) if contour.facing else (deep, along)
    lines = list(contour.lines)
    lines[0], lines[-1] = f"N10 {lines[0]}", f"N20 {lines[-1]}"
    letter = "W" if contour.facing else "U"
    head = ["G18 G21 G98 F300", f"G0 X{x:.6f} Z{z:.6f}", f"{code} {letter}{depth:.3f} R0.4",
            f"{code} P10 Q20 U{u:.3f} W{w:.3f}"]
    return "\n".join([*head, *lines, "G0 X200 Z200", "M30"]) + "\n", 4


@pytest.mark.parametrize("pockets", [False, True])
@pytest.mark.parametrize("first", range(0, 60, 20))
def test_roughing_leaves_the_allowance_and_takes_no_more_than_asked(first, pockets):
    machine = lathe()
    for seed in range(first, first + 20):
        contour = contour_programs.contour(seed, pockets)
        depth, spare_d, spare_a = 0.7 + seed % 7 * 0.4, seed % 3 * 0.2, (seed % 2) * 0.15
        text, line = roughing(contour, depth, spare_d, 0.0 if pockets else spare_a)
        blocks = decode(text, machine)
        blocks = blocks[blocks["line"] < len(text.splitlines()) - 1]
        points = contour.points + [-(0.0 if pockets else spare_a), spare_d]
        grid = np.arange(0.00317, points[-1, 0], GRID)
        height = np.interp(grid, points[:, 0], points[:, 1])
        stock = np.zeros(len(grid))
        most = cut_away(blocks, contour, height, grid, line, stock)
        assert most[lib.NCK_BLOCK_RAPID] < 1e-5, f"seed {seed}: a rapid cuts"
        assert most[lib.NCK_BLOCK_LINE] < depth + 1e-5, f"seed {seed}"
        missed = np.abs(stock - np.minimum(height, 0)) > NEAR
        assert missed.sum() <= 1, f"seed {seed}: not cut down"  # 1: where two moves meet


SUB = """o7 sub
  G0 X4 Z2
  G1 Z-3
  X8 Z-9 A0.5
  Z-14
  X6 Z-16
  Z-20
  X9 Z-24
  U3
  X16
o7 endsub
"""
SUB_POINTS = np.array(
    [[0, 4], [5, 4], [11, 8], [16, 8], [18, 6], [22, 6], [26, 9], [26, 16]], float
)


def of_sub(cycle):
    """Return the text of a cycle on the contour of SUB, which begins at X18 Z2."""
    return f"G18 G21 F200\n{SUB}G0 X18 Z2\n{cycle}\nM2\n"


class Straight:
    """SUB on the lathe: a is against Z, d is X."""

    @staticmethod
    def from_lathe(x, z):
        return 2 - z, x


def dense(points, step=0.002):
    """Return points of a polygon."""
    parts = []
    for begin, end in zip(points, points[1:], strict=False):
        share = np.linspace(0, 1, max(2, int(np.hypot(*(end - begin)) / step)))[:, None]
        parts.append(begin + share * (end - begin))
    return np.concatenate(parts)


@pytest.mark.parametrize("distance", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("code", ["G71", "G71.1", "G71.2"])
def test_a_distance_is_kept_everywhere(code, distance):
    text = of_sub(f"{code} Q7 D{distance} I1 R0.3")
    blocks = decode(text, lathe("dialect.base=linuxcnc"))
    grid = np.arange(0.0031731, 25.9, GRID)
    height = contour_programs.taken_height(dense(SUB_POINTS), max(distance, GRID), grid)
    height -= 0.03 + (0.02 if distance == 0 else 0)  # the fillet, and slopes within the grid
    stock = np.full(len(grid), 18.0)
    most = cut_away(blocks, Straight, height, grid, 14, stock)
    if code != "G71.2":  # which leaves the first cuts to another cycle
        assert most[lib.NCK_BLOCK_RAPID] < 1e-5
        assert most[lib.NCK_BLOCK_LINE] < 1 + 0.03
    open_side = grid < 15  # behind it lies the pocket
    floor = np.where(open_side | (code != "G71.1"), height, 8 + distance)
    inside = grid < 25.5 - distance
    assert np.abs(stock - floor)[inside].max() < (0.06 if code != "G71.1" else 1.5)


def corners(blocks, line):
    """Return kind, X and Z of the moves of a line, without those at rapid."""
    chosen = blocks[(blocks["line"] == line) & (blocks["kind"] <= lib.NCK_BLOCK_ARC)]
    return [(int(each["kind"]), each["target_nm"][0] / 1e6, each["target_nm"][2] / 1e6)
            for each in chosen if each["kind"] != lib.NCK_BLOCK_RAPID]  # fmt: skip


def test_g70_follows_a_subprogram_in_passes():
    blocks = decode(of_sub("G70 Q7 D0.5 E0 P2"), lathe("dialect.base=linuxcnc"))
    cuts = corners(blocks, 14)
    last = cuts[-9:]
    assert last[0][1:] == pytest.approx((4, -3))
    assert [each[0] for each in last].count(lib.NCK_BLOCK_ARC) == 1
    assert last[-1][1:] == pytest.approx((16, -24))
    assert any(x == pytest.approx(4.25) for _, x, _ in cuts[:-9])  # the first pass


FINISH = """G18 G21 G98 F100
G0 X50 Z5
G71 U2 R0.5
G71 P10 Q20 U0.4 W0.1
N10 G0 X10
G1 Z-5 F30
G2 X14 Z-9 R4
G3 X20 Z-15 I0 K-6
N20 G1 X50
S300
G0 X52 Z6
G70 P10 Q20
G0 X90
M30
"""


def test_g70_does_the_lines_of_the_contour_and_returns():
    machine = lathe()
    plain = decode("G18 G21 G98\nG0 X10 Z6\nG1 Z-5 F30\nG2 X14 Z-9 R4\nG3 X20 Z-15 I0 K-6\n"
                   "G1 X50\nG0 X52 Z6\nG0 X90\nM30\n", machine)  # fmt: skip
    blocks = decode(FINISH, machine)
    first = int(np.flatnonzero(blocks["line"] == 11)[0]) + 1
    finish = blocks[first:]
    assert len(finish) == len(plain)
    for name in ("kind", "target_nm", "centre_mm", "sweep_rad", "feed"):
        assert (finish[name] == plain[name]).all(), name
    assert finish["line"].tolist() == [5, 6, 7, 8, 9, 12, 13, 14]


def test_g73_copies_the_contour_from_further_away():
    text = ("G18 G21 G98 F100\nG0 X50 Z5\nG73 U3 W1 R3\nG73 P10 Q20 U0.4 W0.1\n"
            "N10 G0 X10 Z0\nG1 Z-5\nN20 X20 Z-9\nM30\n")  # fmt: skip
    blocks = decode(text, lathe())
    moved = blocks[(blocks["line"] == 4)]["target_nm"][:, [0, 2]] / 1e6
    copies = moved[:-1].reshape(3, 4, 2)
    contour = np.array([[50, 5], [10, 0], [10, -5], [20, -9]])
    for copy, left in zip(copies, (1, 0.5, 0), strict=True):
        assert copy == pytest.approx(contour + [0.4 + 3 * left, 0.1 + left])
    assert moved[-1].tolist() == [50, 5]


def on_lathe(cycle, contour="N10 G0 X10\nG1 Z-5\nN20 X50"):
    return f"G18 G21 G98 F100\nG0 X50 Z5\nG71 U2 R1\n{cycle}\n{contour}\nM30\n"


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (on_lathe("G71 P10 Q20 U-1"), ("contour", 4)),
        (on_lathe("G71 P10 Q20 W-1"), ("contour", 4)),
        (on_lathe("G71 P11 Q20"), ("contour", 4)),
        (on_lathe("G71 P10 Q30"), ("contour", 8)),
        (on_lathe("G71 P10"), ("word-missing", 4)),
        (on_lathe("G71 P10 Q20 D2"), ("contour", 4)),
        (on_lathe("G72 P10 Q20 D1."), ("contour", 4)),
        (on_lathe("G71 P10 Q20 R1"), ("word-unused", 4)),
        (on_lathe("G71 P10 Q20", "N10 G0 X10\nG1 Z-5\nG1 X8 Z-6\nN20 X50"), ("contour", 7)),
        (on_lathe("G71 P10 Q20", "N10 G0 X10\nG1 Z-5\nG1 X20 Z-4\nN20 X50"), ("contour", 7)),
        (on_lathe("G71 P10 Q20", "N10 G0 X10\nG28 X10\nN20 X50"), ("contour", 6)),
        (on_lathe("G71 P10 Q20", "N10 G2 X10 R90\nN20 Z-5"), ("contour", 5)),
        (on_lathe("G71 P10 Q20", "N10 G0 X10 Z5\nG1 Z-5\nX8 Z-6\nN20 X50"), None),
        (on_lathe("G71 P10 Q20 W0.1", "N10 G0 X10 Z5\nG1 Z-5\nX8 Z-6\nN20 X50"), ("contour", 4)),
        (on_lathe("G71 P10 Q20", "N10 G0 X10\nG1 Z-5\nN20 X90\n"), None),
        (on_lathe("G70 P10 Q20 U1"), ("word-unused", 4)),
        (on_lathe("G70 P50 Q20"), ("label-missing", 4)),
        (on_lathe("G73 P10 Q20"), ("word-missing", 4)),
    ],
)
def test_what_is_left_open_is_refused(text, found):
    assert first_error(text, lathe()) == found


def test_more_elements_than_the_contour_holds_are_refused():
    many = "\n".join(f"Z-{k}" for k in range(1, 1002))
    text = on_lathe("G71 P10 Q20", f"N10 G0 X10\nG1 Z0\n{many}\nN20 X50")
    assert first_error(text, lathe()) == ("contour-full", 4)
