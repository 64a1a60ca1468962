# SPDX-License-Identifier: MIT
"""Pictures of a run: a path in space fills its place, and nothing of it is cut off."""

import numpy as np
import pytest

from pycnc import Trace, load
from pycnc.report import plot

backend_agg = pytest.importorskip("matplotlib.backends.backend_agg")

FILLED = 0.94  # of its place, in one direction at least
INK = 0.9  # a pixel that is darker is drawn at


def path_in(box, seed):
    """Return a program that goes to the corners of a box and to places in it, with a long rapid."""
    random = np.random.default_rng(seed)
    places = np.vstack([np.zeros(3), box, random.uniform(0, 1, (6, 3)) * box])
    cuts = "\n".join("G1 X{:.3f} Y{:.3f} Z{:.3f}".format(*place) for place in places)
    return f"G21 G90 G64 P0.01 F3000\nG0 Z100\n{cuts}\nG0 Z100\nM2\n"


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("box", [(80, 40, 40), (30, 90, 12), (20, 20, 60), (90, 30, 20)])
def test_a_path_in_space_fills_its_place(box, seed):
    figure = plot.draw(Trace(load(path_in(box, seed))))
    path, bar, speed = figure.axes[:3]
    canvas = backend_agg.FigureCanvasAgg(figure)
    canvas.draw()
    to_parts = figure.transFigure.inverted().transform_bbox
    free = to_parts(bar.get_tightbbox()).x0, 1 - speed.get_position().y1
    image = np.asarray(canvas.buffer_rgba())[..., :3].min(axis=2) / 255
    high, wide = image.shape
    rows = slice(int(0.4 * figure.dpi), int(free[1] * high))
    ink = image[rows, : int(free[0] * wide)] < INK
    across, down = np.flatnonzero(ink.any(axis=0)), np.flatnonzero(ink.any(axis=1))
    shares = np.ptp(across) / ink.shape[1], np.ptp(down) / ink.shape[0]
    assert FILLED < max(shares) <= 1
    assert path.name == "3d"
