# SPDX-License-Identifier: MIT
"""How far places are from a polyline."""

import numpy as np


def distance(points, path):
    """Return the largest distance of points from a polyline, in the plane or in space."""
    begin, way = path[:-1], np.diff(path, axis=0)
    square = np.maximum((way**2).sum(axis=1), 1e-30)
    far = 0.0
    for point in points:
        share = np.clip(((point - begin) * way).sum(axis=1) / square, 0, 1)
        far = max(far, np.linalg.norm(begin + share[:, None] * way - point, axis=1).min())
    return far
