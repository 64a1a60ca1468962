# SPDX-License-Identifier: MIT
"""Contours for radius compensation: random families, and geometry that judges the tool's path.

Points are complex numbers, a contour is a list of elements: lines and arcs in G17.
"""

import math
from dataclasses import dataclass

import numpy as np

HEAD = "G21 G90 G17 G94 G61\n"


@dataclass(frozen=True)
class Element:
    """A line, or an arc of less than half a turn about `centre` by `sweep`."""

    start: complex
    end: complex
    centre: complex = 0j
    sweep: float = 0.0

    @classmethod
    def bulged(cls, start, end, bulge):
        """Return an arc whose height over half its chord is `bulge`, + to the left of the chord."""
        sweep = -4 * math.atan(bulge)
        height = abs(end - start) / 2 / math.tan(sweep / 2)
        centre = (start + end) / 2 + 1j * (end - start) / abs(end - start) * height
        return cls(start, end, centre, sweep)

    def points(self, q):
        """Return the points at shares q of the way."""
        if self.sweep == 0.0:
            return self.start + (self.end - self.start) * q
        return self.centre + (self.start - self.centre) * np.exp(1j * self.sweep * q)

    def left(self, q):
        """Return the normals to the left at shares q of the way."""
        if self.sweep == 0.0:
            return np.full(len(q), 1j * (self.end - self.start) / abs(self.end - self.start))
        arm = (self.points(q) - self.centre) / abs(self.start - self.centre)
        return -arm if self.sweep > 0 else arm

    def distance(self, points):
        """Return how far points are from it."""
        if self.sweep == 0.0:
            way = self.end - self.start
            foot = np.clip(((points - self.start) * np.conj(way)).real / abs(way) ** 2, 0, 1)
            return np.abs(points - self.start - foot * way)
        arm = (points - self.centre) / (self.start - self.centre)
        angle = np.mod(np.angle(arm) * np.sign(self.sweep), 2 * math.pi)
        radius = abs(self.start - self.centre)
        ends = np.minimum(np.abs(points - self.start), np.abs(points - self.end))
        on = angle <= abs(self.sweep)
        return np.where(on, np.abs(np.abs(points - self.centre) - radius), ends)


def to_the_nearest(elements, points):
    """Return how far points are from the nearest of the elements."""
    least = np.full(len(points), np.inf)
    for element in elements:
        np.minimum(least, element.distance(points), out=least)
    return least


def program(elements, radius, side, entry, leave):
    """Return a program along a contour: G41.1 or G42.1 behind a rapid to the entry's start."""
    code = "G41.1" if side > 0 else "G42.1"
    lines = [f"{HEAD}F1000\nG0 X{entry.real:.6f} Y{entry.imag:.6f}\n{code} D{2 * radius:.6f}"]
    lines.append(f"G1 X{elements[0].start.real:.6f} Y{elements[0].start.imag:.6f}")
    for each in elements:
        end = f"X{each.end.real:.6f} Y{each.end.imag:.6f}"
        if each.sweep == 0.0:
            lines.append(f"G1 {end}")
        else:
            centre = each.centre - each.start
            code = "G3" if each.sweep > 0 else "G2"
            lines.append(f"{code} {end} I{centre.real:.6f} J{centre.imag:.6f}")
    return "\n".join([*lines, f"G40 G1 X{leave.real:.6f} Y{leave.imag:.6f}", "M2", ""])


def rounded(value):
    """Return a complex number with the decimals that a program gives it."""
    return complex(round(value.real, 6), round(value.imag, 6))


def chain(points, along, rng, tool, arcs):
    """Return elements through points; a share of them arcs that the tool (radius, side) fits into.

    along: directions; no arc turns back against that of the point where it begins, and where it is
    0 there is none.
    """
    radius, side = tool
    points = [rounded(point) for point in points]
    elements = []
    for start, end, ahead in zip(points, points[1:], along, strict=False):
        way = (end - start) / (ahead or 1)
        arc = Element.bulged(start, end, rng.uniform(0.02, 0.3) * rng.choice([-1, 1]))
        turns_back = abs(np.angle(way)) + abs(arc.sweep) / 2 > 1.45
        small = abs(arc.start - arc.centre) < 1.05 * radius + 0.01
        fits = side * arc.sweep < 0 or not small
        if ahead and rng.random() < arcs and abs(way) > 0.01 and fits and not turns_back:
            elements.append(arc)
        else:
            elements.append(Element(start, end))
    return elements


def terrain(rng, count, form, radius):
    """A contour that goes along X and up and down; the tool is above it, on the left.

    form: step, height and the share of arcs.
    """
    step, height, arcs = form
    x = np.cumsum(step * 10 ** rng.uniform(-1, 0.5, count))
    y = height * (rng.normal(size=count) * 0.5 + np.sin(x / (8 * step)))
    ends = (x < x[0] + 8 * radius) | (x > x[-1] - 8 * radius)
    y[ends] = 0.0
    return chain(x + 1j * y, ~ends, rng, (radius, 1), arcs)


def flower(rng, count, form, radius, side):
    """A closed contour about zero, anticlockwise: the tool is inside (left) or outside (right).

    form: size, depth and the share of arcs.
    """
    size, depth, arcs = form
    flat = min(1.0, 8 * radius / size)
    angle = 2 * math.pi * np.sort(rng.uniform(0.02, 0.98, count - 5))
    edges = np.array([0, flat / 3, flat / 2])
    angle = np.sort(np.concatenate([edges, angle, 2 * math.pi - edges]))
    waves = sum(rng.normal() * np.cos(k * angle + rng.uniform(0, 6)) / k for k in range(2, 9))
    noise = rng.normal(size=count + 1) * 0.1
    reach = size * (1 + depth * (waves / 3 + noise))
    reach = np.maximum(reach, 0.2 * size)
    away = np.minimum(angle, 2 * math.pi - angle)
    near = away < flat
    reach[near] = size / np.cos(away[near])
    around = np.exp(1j * angle)
    near[:-1] |= near[1:]
    return chain(reach * around, 1j * around * ~near, rng, (radius, side), arcs)


def hills(rng, count, radius, side):
    """A contour of elements that are long beside the tool, and turn by 0.06 to 1.3 between them."""
    elements, at = [], 0j
    while len(elements) < count:
        way = rng.uniform(5, 12) * radius * np.exp(1j * rng.uniform(-1.2, 1.2))
        end = rounded(at + way)
        each = Element(at, end)
        if rng.random() < 0.4:
            each = Element.bulged(at, end, rng.uniform(0.02, 0.3) * rng.choice([-1, 1]))
            if side * each.sweep > 0 and abs(each.start - each.centre) < 2 * radius:
                continue
        if elements:
            before, behind = elements[-1].left(np.ones(1))[0], each.left(np.zeros(1))[0]
            if not 0.06 < abs(np.angle(behind / before)) < 1.3:
                continue
        elements.append(each)
        at = end
    return elements
