# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench families`: kinds of programs by seed, slopes `jerk` and `optimal`.

A family is a kind of path as shops cut it; a seed draws its sizes, chords and feed. Machines: soft
(a 500 mm/s², j 5 000 mm/s³ an axis) and stiff (a 5 000, j 100 000), v 100 mm/s, T = 1 ms. of_0_002,
of_0_01, of_0_05: the time under `optimal` over that under `jerk` within so many mm, the median of
the seeds; worst: the largest of all of them. These are the same on every computer. planned: how
many times faster than real time the slowest part, `optimal`, is planned, on this one.

`pycnc lab bench tubes` holds the first 60 mm and 4 s of two programs of each against the best
anywhere within P (`pycnc lab bench bounds`, whose machine and columns they have).
"""

import time

import numpy as np

from pycnc.bench import bounds, programs
from pycnc.planning.plan import Plan
from pycnc.program import Program

TOLERANCES = (0.002, 0.01, 0.05)  # mm
MACHINES = {"soft": (500, 5_000), "stiff": (5_000, 100_000)}  # a [mm/s²], j [mm/s³]
SEEDS = 6
LEAST_MM = 1e-4  # between two points of a program
TUBE_MM, TUBE_S, TUBE_POINTS = 60.0, 4.0, 500  # of a program that a bound is looked for
TUBE_P = 0.01  # mm


def _curve(rng, x, y, z=None):
    """Return points along a curve x(t), y(t), z(t), t = 0 … 1, in chords of a drawn error."""
    t = np.linspace(0, 1, 20_001)
    fine = np.column_stack([x(t), y(t), np.zeros_like(t) if z is None else z(t)])
    way = np.append(0, np.cumsum(np.linalg.norm(np.diff(fine, axis=0), axis=1)))
    chord = 10 ** rng.uniform(-1.2, 0.3)
    at = np.linspace(0, way[-1], max(4, int(way[-1] / chord)))
    return np.column_stack([np.interp(at, way, of) for of in fine.T])


def adaptive(rng):
    """Clearing with a steady load: loops that grow and drift."""
    turns, r, drift = rng.integers(3, 8), rng.uniform(1, 8), rng.uniform(0.5, 4)
    return _curve(rng, lambda t: drift * turns * t + r * np.cos(2 * np.pi * turns * t) * (1 + t),
                  lambda t: r * np.sin(2 * np.pi * turns * t) * (1 + t))  # fmt: skip


def trochoid(rng):
    """A slot in circles."""
    turns, r, step = rng.integers(4, 10), rng.uniform(0.5, 5), rng.uniform(0.2, 1.5)
    return _curve(rng, lambda t: step * turns * t + r * np.cos(2 * np.pi * turns * t),
                  lambda t: r * np.sin(2 * np.pi * turns * t))  # fmt: skip


def spiral(rng):
    """A pocket from its middle."""
    turns, r = rng.uniform(2, 6), rng.uniform(4, 25)
    return _curve(rng, lambda t: r * t * np.cos(2 * np.pi * turns * t),
                  lambda t: r * t * np.sin(2 * np.pi * turns * t))  # fmt: skip


def scallop(rng):
    """Finishing passes over a waved surface, to and fro."""
    passes, width = int(rng.integers(2, 5)), rng.uniform(10, 40)
    high, waves, step = rng.uniform(0.2, 4), rng.uniform(1, 5), rng.uniform(0.1, 1)
    found = []
    for k in range(passes):
        one = _curve(rng, lambda t: width * t, lambda t: 0 * t + step * k,  # noqa: B023
                     lambda t: high * np.sin(2 * np.pi * waves * t + 0.3 * k))  # noqa: B023
        found.append(one[:: -1 if k % 2 else 1])
    return np.concatenate(found)


def noise(rng):
    """A line that a scanner has followed."""
    n, step = int(rng.integers(60, 300)), 10 ** rng.uniform(-1.3, -0.3)
    return np.column_stack([step * np.arange(n), rng.normal(0, rng.uniform(0.001, 0.02), n),
                            np.zeros(n)])  # fmt: skip


def engraving(rng):
    """Letters: short strokes, and curves in chords."""
    found, place = [np.zeros(3)], np.zeros(3)
    for _ in range(int(rng.integers(15, 40))):
        way, turn = rng.uniform(0, 2 * np.pi), rng.normal(0, 0.4)
        size = 10 ** rng.uniform(-0.7, 0.5)
        for k in range(int(rng.integers(1, 9))):
            place = place + size / 3 * np.array([np.cos(way + k * turn), np.sin(way + k * turn), 0])
            found.append(place)
    return np.array(found)


def pocket(rng):
    """Right angles, from the outside in."""
    wide, high, step = *rng.uniform(8, 40, 2), rng.uniform(0.5, 3)
    found, x, y, u, v = [(0, 0, 0)], 0.0, 0.0, wide, high
    while min(u, v) > step and len(found) < 40:
        for dx, dy in ((u, 0), (0, v), (-u, 0), (0, step - v)):
            x, y = x + dx, y + dy
            found.append((x, y, 0))
        x += step
        found.append((x, y, 0))
        u, v = u - 2 * step, v - 2 * step
    return np.array(found, float)


def zigzag(rng):
    """A raster: long passes, short steps."""
    n, wide, step = int(rng.integers(4, 16)), rng.uniform(2, 30), 10 ** rng.uniform(-1, 0.7)
    x = np.repeat(np.arange(n) % 2, 2) * wide
    y = np.repeat(np.arange(n + 1) * step, 2)[1 : 2 * n + 1]
    return np.column_stack([x, y, np.zeros(2 * n)])


def polygon(rng):
    """Lines of any length at any angle."""
    n, scale = int(rng.integers(6, 40)), 10 ** rng.uniform(-0.5, 1.2)
    return np.cumsum(rng.normal(0, 1, (n, 3)) * [scale, scale, 0], axis=0)


def arcs(rng):
    """Lines and round corners, in fine chords."""
    found, place, way = [np.zeros(3)], np.zeros(3), 0.0
    for _ in range(int(rng.integers(4, 14))):
        r, sweep = 10 ** rng.uniform(-0.3, 1.2), rng.uniform(0.4, 3) * rng.choice([-1, 1])
        n = max(2, int(abs(sweep) * np.sqrt(r / 0.008)))
        for _ in range(n):
            way += sweep / n
            place = place + r * abs(sweep) / n * np.array([np.cos(way), np.sin(way), 0])
            found.append(place)
        place = place + rng.uniform(0.5, 15) * np.array([np.cos(way), np.sin(way), 0])
        found.append(place)
    return np.array(found)


def form(rng):
    """A free curve in space."""
    a = rng.normal(0, 1, (3, 2, 4)) / np.arange(1, 5)
    size, turns = 10 ** rng.uniform(0.3, 1.4), 2 * np.pi * np.arange(1, 5)

    def of(axis):
        return lambda t: size * (np.cos(np.outer(t, turns)) @ a[axis, 0]
                                 + np.sin(np.outer(t, turns)) @ a[axis, 1])  # fmt: skip

    return _curve(rng, of(0), of(1), of(2))


FAMILIES = {each.__name__: each for each in (
    adaptive, trochoid, spiral, scallop, noise, engraving, pocket, zigzag, polygon, arcs, form)
}  # fmt: skip


def draw(family, seed):
    """Return the points of a seed's program [mm] and its feed [mm/min].

    Examples
    --------
    >>> points, feed = draw("zigzag", 1)
    >>> points.shape[1], feed <= 6000
    (3, True)
    """
    rng = np.random.default_rng([33, seed, list(FAMILIES).index(family)])
    points = np.round(FAMILIES[family](rng), 5)
    points = points - points[0]
    apart = np.linalg.norm(np.diff(points, axis=0), axis=1)
    points = points[np.append(True, apart > LEAST_MM)]
    return points, float(np.round(6000 * 10 ** rng.uniform(-0.8, 0)))


def bench_families_rows(families=FAMILIES, machines=MACHINES, seeds=SEEDS):
    """Return rows {family, machine, programs, of_0_002, of_0_01, of_0_05, worst, planned}."""
    return [_row(family, name, seeds) for name in machines for family in families]


def _row(family, name, seeds):
    drawn = [draw(family, seed) for seed in range(seeds)]
    jerk, optimal = (programs.machine(slope, *MACHINES[name]) for slope in ("jerk", "optimal"))
    row = {"family": family, "machine": name, "programs": seeds}
    ratios, time_s, cost_s = [], 0.0, 0.0
    for tolerance in TOLERANCES:
        for points, feed in drawn:
            jerk_s = _time_s(points, feed, tolerance, jerk)
            began = time.process_time()
            optimal_s = _time_s(points, feed, tolerance, optimal)
            cost_s += time.process_time() - began
            time_s += optimal_s
            ratios.append(optimal_s / jerk_s)
        row["of_" + f"{tolerance}".replace(".", "_")] = float(np.median(ratios[-seeds:]))
    return row | {"worst": max(ratios), "planned": time_s / cost_s}


def _time_s(points, feed, tolerance, machine):
    return Plan(Program.from_points(points, feed, machine, tolerance=tolerance), keep=False).time_s


def bench_tubes_rows(families=FAMILIES, seeds=2):
    """Return the rows of `bounds.bench_bounds_rows` for beginnings of programs of families.

    Raises
    ------
    AbsentError
        If CasADi is not installed.
    """
    drawn = [(family, seed) for seed in range(seeds) for family in families]
    return bounds.bench_bounds_rows([
        (f"{family} {seed}", lambda each=(family, seed): _beginning(draw(*each)[0]), TUBE_P)
        for family, seed in drawn
    ])  # fmt: skip


def _beginning(points):
    """Return the first points of a program, few enough to find the best for."""
    gone = np.append(0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    points = points[: max(4, int(np.searchsorted(gone, TUBE_MM)))]
    time_s = _time_s(points, bounds.FEED, TUBE_P, programs.machine("optimal"))
    share = min(TUBE_S / time_s, TUBE_POINTS / len(points), 1)
    return points[: max(4, int(len(points) * share))]
