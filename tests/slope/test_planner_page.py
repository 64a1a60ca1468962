# SPDX-License-Identifier: MIT
"""docs/planner.md: its numbers are those of the source, its examples come out, and its equations
are what a run does. Sections and names are those of the page."""

import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import rules

from pycnc.bench import programs
from pycnc.planning.plan import Plan
from pycnc.program import Program
from pycnc.report.trace import Trace

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "planner.md").read_text(encoding="utf-8")
EXAMPLES = PAGE[PAGE.index("## 16.") : PAGE.index("## 17.")]
NUMBERS = PAGE[PAGE.index("## 17.") :]
P, V, A, J, T = 0.01, 100.0, 1e3, 1e4, 1e-3  # mm, s: the machine of the examples
TAU = 0.4 * np.cbrt(0.01 / J)
FEED = 6000
LINE = [[0, 0, 0], [5, 0, 0]]
CORNER = [[0, 0, 0], [10, 0, 0], [10, 10, 0]]
ALONG = np.arange(0, 60, 0.05)
WAVES = np.column_stack([ALONG, 2 * np.sin(0.4 * ALONG), np.sin(0.26 * ALONG)])
PATHS = {"line": LINE, "corner": CORNER, "waves": WAVES.round(5)}
FINE = 50  # parts of a period, and of an interval, that means are made of


def planned(points):
    """Return a plan and its program: Bernstein points of the intervals of the clock, and b_k."""
    points = np.array(points, float)
    program = Program.from_points(points, FEED, programs.machine("optimal"), tolerance=P)
    plan = Plan(program)
    segs, cells = plan.segs, plan.cells
    inner = segs["shape"]["inner"]
    points = np.stack([segs["start"], inner[:, 0], inner[:, 1], segs["end"]], axis=1)[:, :, :3]
    place = cells["s"] / segs["length"][np.searchsorted(segs["seq"], cells["seg"])]
    pace = [cells["v"][place == share] * TAU / segs["length"] for share in (0.0, 0.5)]
    node, middle = pace[0] ** 2, pace[1] ** 2
    b = np.empty(len(segs) + 1)
    b[1:-1] = 2 * node[1:] - (middle[:-1] + middle[1:]) / 2
    b[0], b[-1] = 2 * middle[0] - b[1], 2 * middle[-1] - b[-2]
    time_s = float(cells["duration"].sum())
    return SimpleNamespace(program=program, points=points, b=b, time_s=time_s)


def derivatives(points, w):
    """Return x, x′, x″, x‴ over u of cubics at the share w of their intervals."""
    b0, b1, b2, b3 = np.moveaxis(points, 1, 0)
    w = np.asarray(w)[:, None]
    m = 1 - w
    place = m**3 * b0 + 3 * m * m * w * b1 + 3 * m * w * w * b2 + w**3 * b3
    first = 3 * (m * m * (b1 - b0) + 2 * m * w * (b2 - b1) + w * w * (b3 - b2)) / TAU
    second = 6 * (m * (b2 - 2 * b1 + b0) + w * (b3 - 2 * b2 + b1)) / TAU**2
    return place, first, second, 6 * (b3 - 3 * b2 + 3 * b1 - b0) / TAU**3


def chain(first, second, third, b):
    """Return v, a, j by section 2; b: b, b′, b″."""
    here, slope, bend = (each[:, None] for each in b)
    root = np.sqrt(here)
    return (first * root, second * here + first * slope / 2,
            root * (third * here + 1.5 * second * slope + first * bend / 2))  # fmt: skip


def motion(plan):
    """Return t, places, and v, a, j by section 2, many times an interval."""
    u = (np.arange(FINE * len(plan.points)) + 0.5) / FINE
    cell = u.astype(int)
    node = (u + 0.5).astype(int)
    x = u - node
    even = np.concatenate([plan.b[1:2], plan.b, plan.b[-2:-1]])
    before, here, behind = even[node], even[node + 1], even[node + 2]
    bend, slope = before - 2 * here + behind, (behind - before) / 2
    level = here + bend / 8 + slope * x + bend * x * x / 2
    b = level, (slope + bend * x) / TAU, bend / TAU**2
    place, *over_clock = derivatives(plan.points[cell], u - cell)
    lasts = TAU / FINE / np.sqrt(level)
    return np.cumsum(lasts) - lasts / 2, place, chain(*over_clock, b)


def shares(plan):
    """Return the most that rows of acceleration and of jerk take, by section 4."""
    even = np.concatenate([plan.b[1:2], plan.b, plan.b[-2:-1]])
    bend = even[:-2] - 2 * even[1:-1] + even[2:]
    node = plan.b + bend / 8, (even[2:] - even[:-2]) / 2
    middle = (plan.b[1:] + plan.b[:-1]) / 2, np.diff(plan.b)
    before, behind = [part[:-1] for part in node], [part[1:] for part in node]
    rows = [(0, before, bend[:-1]), (0.5, middle, bend[:-1]),
            (0.5, middle, bend[1:]), (1, behind, bend[1:])]  # fmt: skip
    found = []
    for w, (level, slope), alpha in rows:
        _, first, second, third = derivatives(plan.points, np.full(len(plan.points), w))
        p1, p2, delta = first / (2 * TAU * A), second / A, TAU * third / A
        alpha, beta, gamma = alpha[:, None], slope[:, None], level[:, None]
        jerk = p1 * alpha + 1.5 * p2 * beta + delta * gamma
        found.append((p1 * beta + p2 * gamma, np.sqrt(gamma) * A / (J * TAU) * jerk))
    return np.abs(np.array(found)).max(axis=(0, 2, 3))


def mean(values, widths):
    """Return running means of columns, one by one, each so many samples wide."""
    kernel = np.ones(1)
    for width in widths:
        kernel = np.convolve(kernel, np.ones(width) / width)
    return np.column_stack([np.convolve(column, kernel, "same") for column in values.T])


def difference(found, order, t, values):
    """Return the most by which differences of the ticks' places differ from values over t."""
    of_ticks = np.diff(found, order, axis=0) / T**order
    even = np.arange(0, t[-1], T / FINE)
    over_t = np.column_stack([np.interp(even, t, column) for column in values.T])
    meant = mean(over_t, [FINE] * order)
    rows = np.arange(2, len(of_ticks) - 4)
    at = np.round((rows + order / 2) * FINE).astype(int)
    return np.abs(of_ticks[rows] - meant[at]).max()


def ticks(program):
    """Return where the tick has the tool, from the moment before the first one on."""
    trace = Trace(program)
    places = np.column_stack([trace[f"pos_{axis}_mm"] for axis in "xyz"])
    return np.concatenate([np.zeros((1, 3)), places])


@pytest.fixture(scope="module", params=PATHS)
def plan(request):
    """Return the plan of a path."""
    return planned(PATHS[request.param])


# Names and numbers


def test_the_numbers_are_those_of_the_source():
    rows = rules.ROW.findall(NUMBERS)
    told = {(name, room): float(value) for value, name, room in rows}
    found = {
        (name, room): float(value)
        for room, file in rules.TUNING.items()
        for name, value in rules.NUMBER.findall(file.read_text(encoding="utf-8"))
    }
    assert found == told


def test_the_tests_that_it_names_are_there():
    names = set(re.findall(r"`([a-z]+(?:_[a-z0-9]+){2,})`", PAGE))
    files = [file for end in ("py", "c", "h") for file in (ROOT / "tests").rglob(f"*.{end}")]
    text = "\n".join(file.read_text(encoding="utf-8") for file in files)
    defined = set(re.findall(r"^(?:def (?:test_)?|static void )(\w+)\(", text, re.M))
    assert len(names) > 12
    assert sorted(name for name in names if name.removeprefix("test_") not in defined) == []


def test_the_knots_are_as_long_as_it_says():
    assert f"`mill3` {1e3 * 0.4 * np.cbrt(0.01 / 5e4):.1f} ms" in PAGE.replace("\n", " ")
    text = PAGE.replace("\n", " ")
    assert f"below {1e3 * J * (TAU / 1.6) ** 3:.2f} µm at J = 10 000 mm/s³" in text


# Sections 2 and 4


def test_the_chain_rule_is_what_the_ticks_do(plan):
    t, _, (v, a, j) = motion(plan)
    found = ticks(plan.program)
    assert difference(found, 1, t, v) <= 1e-3 * V
    assert difference(found, 2, t, a) <= 1e-5 * A
    assert difference(found, 3, t, j) <= 1e-2 * J


def test_the_time_is_the_integral_over_the_clock(plan):
    t = motion(plan)[0]
    assert t[-1] == pytest.approx(plan.time_s, abs=TAU / FINE)
    assert 0.85 < np.median(plan.b) < 1.15


def test_a_plan_keeps_its_limits_and_uses_them(plan):
    acceleration, jerk = shares(plan)
    assert acceleration <= 0.996 * 1.003
    assert 0.98 <= jerk <= 0.996 * 1.003
    v, a, j = (np.abs(each).max() for each in motion(plan)[2])
    assert v <= 0.999 * 1.003 * V
    assert a <= 0.996 * 1.003 * A
    assert j <= 0.996 * 1.003 * J


# Section 7


def test_the_guess_sees_a_corner_as_the_page_says():
    h = P * np.arange(4.01, 20, 0.01)
    place = np.linspace(-3, 3, 601)[:, None] * h  # of the corner, from the place looked at
    x = lambda s: np.minimum(s - place, 0)  # noqa: E731
    second = np.abs(x(h) - 2 * x(0) + x(-h)) - 4 * P
    third = np.abs(x(3 * h) - 3 * x(h) + 3 * x(-h) - x(-3 * h)) - 8 * P
    by_a = 0.8 * np.sqrt((A * h**2 / np.maximum(second, 1e-9)).min())
    by_j = 0.8 * np.cbrt((J * (2 * h) ** 3 / np.maximum(third, 1e-9)).min())
    assert f"v ≤ 0.8·√(16 A P) = {by_a:.1f} mm/s" in EXAMPLES
    assert f"v ≤ 0.8·∛(432 J P²) = {by_j:.2f} mm/s, {6 * P:.2f} mm beside it" in EXAMPLES


# Section 16


def says(*numbers):
    """Assert that these stand in the examples, each by itself."""
    told = {x: re.search(rf"(?<![\d.]){re.escape(x)}(?!\d)", EXAMPLES) for x in numbers}
    assert [x for x, found in told.items() if not found] == []


def test_the_line_takes_what_the_page_says():
    quarter = np.cbrt(5 / (2 * J))
    says(f"{quarter:.4f}", f"{4 * quarter:.4f}", f"{J * quarter:.0f}", f"{J * quarter**2:.1f}")
    plan = planned(LINE)
    v, a, j = (np.abs(each).max() for each in motion(plan)[2])
    says(f"{plan.time_s:.4f}", f"{plan.time_s / (4 * quarter):.3f}")
    says(f"{len(plan.points)} intervals")
    says(f"{j / J:.3f} J", f"{a:.0f} mm/s²", f"{v:.1f} mm/s")
    says(f"{len(ticks(plan.program)) - 1} periods")


def test_the_corner_takes_what_the_page_says():
    whole, left = 8 * np.cbrt(10 / (2 * J)), np.sqrt(2) * P
    half = np.cbrt(6 * left / J)
    says(f"{whole:.4f}", f"{left:.4f}", f"{half:.4f}", f"{2 * half:.4f}", f"{whole - 2 * half:.4f}")
    says(f"{J / 2 * half**2:.2f}", f"{np.sqrt(2) * J / 2 * half**2:.2f}")
    plan = planned(CORNER)
    t, place, (v, *_) = motion(plan)
    speed = np.linalg.norm(v, axis=1)[np.abs(t - plan.time_s / 2) < 0.1]
    says(f"{plan.time_s:.4f}", f"{speed.min():.2f}")
    outside = 1e3 * (place[:, 0].max() - 10), -1e3 * place[:, 1].min()
    says(f"{outside[0]:.1f} µm")
    assert outside[1] == pytest.approx(outside[0], rel=0.03)
    says(f"{1e3 * np.linalg.norm(place - CORNER[1], axis=1).min():.1f} µm")
    says(re.search(r"\| two edges of 10 mm \|[^|]+\| ([\d.]+) \|", PAGE)[1])


def distances(points, ends):
    """Return how far points are from a chain of lines."""
    found = []
    for start, end in zip(ends, ends[1:], strict=False):
        along = end - start
        share = np.clip((points - start) @ along / max(along @ along, 1e-12), 0, 1)
        found.append(np.linalg.norm(points - start - share[:, None] * along, axis=1))
    return np.min(found, axis=0)


def test_the_example_keeps_its_tolerance_both_ways():
    place = motion(planned(CORNER))[1]
    ends = np.array(CORNER, float)
    program = np.concatenate([a + np.linspace(0, 1, 201)[:, None] * (b - a)
                              for a, b in zip(ends, ends[1:], strict=False)])  # fmt: skip
    assert distances(place, ends).max() <= P
    assert 0.9 * P < distances(program, place).max() <= P
