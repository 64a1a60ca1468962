# SPDX-License-Identifier: MIT
"""Random contours for the roughing cycles of lathes: text, and the same contour as points."""

import dataclasses
import math
import random

import numpy as np

STEP = 0.002  # [mm] between the points of a contour


@dataclasses.dataclass
class Contour:
    """A contour along a, below d = 0, and where a cycle has it on the lathe.

    facing: a is X and d is Z (G72), else a is Z and d is X. signs: of a and d along those axes.
    """

    facing: bool
    signs: tuple[int, int]
    start: tuple[float, float]  # X (radius) and Z
    points: np.ndarray  # a and d
    lines: list[str]  # blocks of the program, the first one leads to the contour

    def to_lathe(self, a, d):
        """Return X and Z of places."""
        along, deep = self.signs[0] * a, self.signs[1] * d
        x, z = (along, deep) if self.facing else (deep, along)
        return self.start[0] + x, self.start[1] + z

    def from_lathe(self, x, z):
        """Return a and d of places."""
        x, z = x - self.start[0], z - self.start[1]
        along, deep = (x, z) if self.facing else (z, x)
        return self.signs[0] * along, self.signs[1] * deep


class Drawer:
    """Draws a contour piece by piece."""

    def __init__(self, seed, pockets):
        self.source = random.Random(seed)
        source = self.source
        self.pockets = pockets
        self.a, self.d = 0.0, -source.uniform(8, 25)
        self.facing = source.random() < 0.4
        self.signs = (source.choice((-1, 1)), source.choice((-1, 1)))
        self.start = (source.uniform(40, 60), source.uniform(-20, 20))
        self.contour = Contour(self.facing, self.signs, self.start, None, [])
        self.points = [np.array([[self.a, self.d]])]
        words = self.words(self.a, self.d)
        first = words if pockets else words[:1] if not self.facing else words[1:]
        self.lines = [f"{source.choice(('G0', 'G1'))} {' '.join(first)}"]

    def words(self, a, d):
        x, z = self.contour.to_lathe(a, d)
        return [f"X{x:.6f}", f"Z{z:.6f}"]

    def line(self, a, d):
        count = max(2, int(math.hypot(a - self.a, d - self.d) / STEP))
        share = np.linspace(0, 1, count)[:, None]
        self.points.append([self.a, self.d] + share * np.array([a - self.a, d - self.d]))
        self.lines.append(f"G1 {' '.join(self.words(a, d))}")
        self.a, self.d = a, d

    def arc(self, radius, begin, end):
        """Draw an arc from the angle begin to end [rad], both seen from the centre."""
        centre = self.a - radius * math.cos(begin), self.d - radius * math.sin(begin)
        count = max(3, int(radius * abs(end - begin) / STEP))
        angle = np.linspace(begin, end, count)
        way = np.stack([np.cos(angle), np.sin(angle)], axis=1)
        self.points.append(np.array(centre) + radius * way)
        a, d = self.points[-1][-1]
        hand = self.signs[0] * self.signs[1] * (-1 if self.facing else 1)
        code = "G3" if (end - begin) * hand > 0 else "G2"
        i, k = np.subtract(self.contour.to_lathe(*centre), self.contour.to_lathe(self.a, self.d))
        self.lines.append(f"{code} {' '.join(self.words(a, d))} I{i:.6f} K{k:.6f}")
        self.a, self.d = a, d

    def rise(self):
        """Draw a piece that does not fall."""
        source, high = self.source, min(6.0, -1.0 - self.d)
        kind = source.choice(("flat", "taper", "step", "bulge", "hollow"))
        if high < 0.2 or kind == "flat":
            self.line(self.a + source.uniform(0.5, 8), self.d)
        elif kind == "taper":
            self.line(self.a + source.uniform(0.5, 8), self.d + source.uniform(0.1, high))
        elif kind == "step":
            self.line(self.a, self.d + source.uniform(0.1, high))
        else:
            ends = [source.uniform(0, 0.7), source.uniform(0.8, math.pi / 2)]
            radius = source.uniform(0.2, high)
            if kind == "bulge":  # from the left of the circle to its top
                self.arc(radius, math.pi - ends[0], math.pi - ends[1])
            else:  # from its bottom to the right
                self.arc(radius, ends[0] - math.pi / 2, ends[1] - math.pi / 2)

    def dip(self):
        """Draw a pocket, or a hump."""
        source = self.source
        low, high = source.uniform(0.3, 5), min(5.0, -1.0 - self.d)
        kind = source.choice(("groove", "valley", "round"))
        if kind == "groove":
            self.line(self.a + source.uniform(0, 4), self.d - low)
            self.line(self.a + source.uniform(0.5, 6), self.d)
            self.line(self.a + source.uniform(0, 4), self.d + source.uniform(0.1, low))
        elif kind == "valley":  # an arc through its lowest place
            self.arc(low, math.pi + source.uniform(0, 1), 2 * math.pi - source.uniform(0, 1))
        elif high > 0.3:  # over its highest one
            self.arc(source.uniform(0.2, high), math.pi - source.uniform(0, 1),
                     source.uniform(0, 1))

    def draw(self):
        for _ in range(self.source.randint(3, 9)):
            if self.pockets and self.source.random() < 0.5:
                self.dip()
            else:
                self.rise()
        self.line(self.a + self.source.uniform(0.5, 3), self.d)
        self.contour.points = np.concatenate(self.points)
        self.contour.lines = self.lines
        return self.contour


def contour(seed, pockets):
    """Return a random contour below its start; with pockets its depth goes up and down."""
    drawn = Drawer(seed, pockets).draw()
    while drawn.points[:, 1].max() > -0.5:
        seed += 100_000
        drawn = Drawer(seed, pockets).draw()
    return drawn


def taken_height(points, spare, grid):
    """Return how high a contour stands over places of a, with a distance to keep [mm]."""
    height = np.full(len(grid), -np.inf)
    first = np.searchsorted(grid, points[:, 0] - spare - 1e-12)
    last = np.searchsorted(grid, points[:, 0] + spare + 1e-12)
    for shift in range(int((last - first).max(initial=0))):
        at = np.minimum(first + shift, len(grid) - 1)
        inside = first + shift < last
        under = spare**2 - (grid[at] - points[:, 0]) ** 2
        stands = points[:, 1] + np.sqrt(np.maximum(under, 0))
        np.maximum.at(height, at[inside], stands[inside])
    return height
