# SPDX-License-Identifier: MIT
"""The rules of other controls once more, whole programs at once and without a ring: an oracle."""

import math


def _unit(way):
    length = math.dist(way, [0.0] * len(way))
    return [each / length for each in way], length


def _least(limits, unit):
    return min(limit / abs(share) for limit, share in zip(limits, unit, strict=True) if share)


def _deviation_cap(u, w, a, deviation):
    cosine = -sum(x * y for x, y in zip(u, w, strict=True))
    s = math.sqrt(max(0.0, (1 - cosine) / 2))
    return a * deviation * s / (1 - s) if s < 1 else math.inf


def trapezoid(length, a, v0, v1, most):
    """Return the time of a line from v0 to v1, never faster than most."""
    top = min(most, math.sqrt((v0 * v0 + v1 * v1) / 2 + a * length))
    ramps = (2 * top * top - v0 * v0 - v1 * v1) / (2 * a)
    return (2 * top - v0 - v1) / a + max(0.0, length - ramps) / top


def _passes(lines, caps):
    """Speeds squared at all junctions: as fast as the caps and both passes let them be."""
    vv = [0.0, *caps, 0.0]
    for k in range(len(lines) - 1, -1, -1):
        vv[k] = min(vv[k], vv[k + 1] + 2 * lines[k]["a"] * lines[k]["length"])
    for k, line in enumerate(lines):
        vv[k + 1] = min(vv[k + 1], vv[k] + 2 * line["a"] * line["length"])
    return vv


def _time(lines, vv):
    return sum(
        trapezoid(line["length"], line["a"], math.sqrt(vv[k]), math.sqrt(vv[k + 1]), line["v"])
        for k, line in enumerate(lines)
    )


def grbl(points, feed, v_max, a_max, deviation, steps):
    """Return grbl's time along points with a ring that holds them all."""
    rounded = [
        [math.copysign(math.floor(abs(x) * steps + 0.5), x) / steps for x in point]
        for point in points
    ]
    lines = []
    for here, there in zip(rounded, rounded[1:], strict=False):
        if here != there:
            unit, length = _unit([y - x for x, y in zip(here, there, strict=True)])
            lines.append({"unit": unit, "length": length, "a": _least(a_max, unit),
                          "v": min(feed, _least(v_max, unit))})  # fmt: skip
    caps = []
    for one, two in zip(lines, lines[1:], strict=False):
        u, w = one["unit"], two["unit"]
        cosine = -sum(x * y for x, y in zip(u, w, strict=True))
        most = min(one["v"], two["v"]) ** 2
        if cosine > 0.999999:
            caps.append(0.0)
        elif cosine < -0.999999:
            caps.append(most)
        else:
            across, _ = _unit([y - x for x, y in zip(u, w, strict=True)])
            caps.append(min(most, _deviation_cap(u, w, _least(a_max, across), deviation)))
    return _time(lines, _passes(lines, caps))


def klipper(points, feed, v, limits):
    """Return Klipper's time along points with a minimum cruise ratio of 0, in X and Y.

    limits: (acceleration, square corner velocity) that hold as each line comes.
    """
    lines, caps = [], []
    for (here, there), (a, square_corner) in zip(zip(points, points[1:]), limits, strict=True):
        unit, length = _unit([y - x for x, y in zip(here, there, strict=True)])
        lines.append({"unit": unit, "length": length, "a": a, "v": min(feed, v),
                      "bend": square_corner**2 * (math.sqrt(2) - 1)})  # fmt: skip
    for one, two in zip(lines, lines[1:], strict=False):
        u, w = one["unit"], two["unit"]
        cosine = -sum(x * y for x, y in zip(u, w, strict=True))
        s, k = (math.sqrt(max(0.0, (1 + sign * cosine) / 2)) for sign in (-1, 1))
        cap = min(one["v"], two["v"]) ** 2
        if s < 1 and k > 0:
            cap = min(cap, _deviation_cap(u, w, 1.0, min(one["bend"], two["bend"])))
            cap = min(cap, *(line["a"] * line["length"] * s / (2 * k) for line in (one, two)))
        caps.append(cap)
    return _time(lines, _passes(lines, caps))
