# SPDX-License-Identifier: MIT
"""Room 3: one curve within P, whatever the chords that a program is made of, in both numbers."""

import curve_door
import numpy as np
import pytest

P = 0.01
pytestmark = pytest.mark.sample(quick=1, of="library")


@pytest.fixture(scope="module", params=("double", "float"))
def library(request, tool, tmp_path_factory):
    """Return the curve, compiled to solve in one of the numbers."""
    return curve_door.build(tool("gcc"), tmp_path_factory.mktemp("curve"), request.param)


def wave(chord, noise=0.0):
    """Return chords of a sine of 3 mm, a given length along X, with noise on all points."""
    x = np.arange(0.0, 30.0, chord)
    points = np.stack([x, 3.0 * np.sin(x / 3.0)], axis=1)
    return points + np.random.default_rng(1).uniform(-noise, noise, points.shape)


@pytest.mark.parametrize("noise", (0.0, 0.002))
def test_short_chords_take_as_long_as_fewer_ones(library, noise):
    knots = []
    for chord in (0.1, 0.02, 0.005):
        *_, run = curve_door.smooth(library, wave(chord, noise if chord > 0.01 else 0.0), P)
        assert run.told[4] == 0 and run.told[5] <= 1.0
        knots.append(run.pieces)
    assert max(knots) <= (1.04 if noise else 1.03) * min(knots)  # what noise costs is by chance


def test_a_wider_tolerance_takes_no_longer(library):
    corners = np.array([[k, k % 2] for k in range(8)], float)
    knots = [curve_door.smooth(library, corners, p)[2].pieces for p in (0.002, 0.01, 0.05)]
    assert knots == sorted(knots, reverse=True)


def test_the_curve_is_proven_within_the_tolerance(library):
    random = np.random.default_rng(5)
    for _ in range(6):
        points = np.cumsum(random.normal(size=(40, 3)) * 10 ** random.uniform(-2, 0), axis=0)
        *_, run = curve_door.smooth(library, points, 10 ** random.uniform(-2.7, -1.5))
        assert run.told[4] == 0 and run.told[5] <= 1.0


@pytest.mark.thorough
def test_no_curve_misses_a_tolerance_whatever_the_limits_are(library):
    random = np.random.default_rng(6)
    rests = 0
    for _ in range(24):
        a, j = 10 ** random.uniform([1.3, 2], [4.3, 6])
        asked = {"a": a, "j": j, "v": 250.0, "feed": 10 ** random.uniform(0, 2.4)}
        asked["tau"] = min(0.004, 0.4 * (0.01 / j) ** (1 / 3))
        points = np.cumsum(random.normal(size=(30, 3)) * 10 ** random.uniform(-3, -0.5), axis=0)
        *_, run = curve_door.smooth(library, points, 10 ** random.uniform(-4.8, -3.8), **asked)
        assert run.told[4] == 0 and run.told[5] <= 1.0
        rests += run.told[6]
    assert rests > 0
