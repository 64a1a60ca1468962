# SPDX-License-Identifier: MIT
"""More of something is never slower: programs of a few moves, on which it once was."""

from itertools import pairwise

import numpy as np
import pytest

import pycnc
from pycnc.bench import programs
from pycnc.program import Program

HEAD = "G17 G21 G90 G94 "


def planned_s(moves, mode, feed=6000, **limits):
    text = f"{HEAD}{mode}\nF{feed}\n{moves}M2\n"
    return pycnc.plan(Program(text.encode(), programs.machine("jerk", **limits))).time_s


def lines(lengths, turns_deg, begin_deg=7.0):
    """Return moves along lines of these lengths [mm], each turned from the one before."""
    angles = np.radians(begin_deg + np.cumsum([0, *turns_deg][: len(lengths)]))
    places = np.cumsum(np.column_stack([np.cos(angles), np.sin(angles)]).T * lengths, axis=1).T
    return "".join(f"G1 X{x:.4f} Y{y:.4f}\n" for x, y in places)


def rounded_rectangle(r, side):
    """Return moves around a rectangle whose corners are quarters of a circle."""
    far = side + r
    return (
        f"G1 X{side}\nG3 X{far} Y{r} I0 J{r}\nG1 Y{far}\nG3 X{side} Y{far + r} I-{r} J0\n"
        f"G1 X0\nG3 X-{r} Y{far} I0 J-{r}\nG1 Y{r}\nG3 X0 Y0 I{r} J0\n"
    )


def assert_never_slower(times, share):
    """Assert that no time is longer than the one before it by more than this share."""
    assert all(more <= (1 + share) * less for less, more in pairwise(times)), times


@pytest.mark.parametrize(("turn", "side"), [(3, 3.0), (3, 1.0), (5, 10.0), (5, 1.0)])
def test_two_lines_of_one_length_bend_at_speed(turn, side):
    moves = lines([side, side], [turn])
    times = [planned_s(moves, f"G64 P{p}") for p in (0.01, 0.03, 0.05, 0.1)]
    assert_never_slower(times, 0.03)


@pytest.mark.parametrize(("r", "side"), [(1, 5), (1, 20), (3, 5), (10, 5), (10, 20)])
def test_more_tolerance_is_no_slower_around_round_corners(r, side):
    times = [planned_s(rounded_rectangle(r, side), f"G64 P{p}") for p in (0.003, 0.01, 0.03, 0.1)]
    assert_never_slower(times, 0.01)


@pytest.mark.parametrize("corners", [3, 5, 6, 8])
def test_more_tolerance_is_no_slower_around_a_polygon(corners):
    moves = lines([20.0] * corners, [360 / corners] * corners)
    times = [planned_s(moves, f"G64 P{p}") for p in (0.001, 0.003, 0.01, 0.03, 0.1)]
    assert_never_slower(times, 0.005)


@pytest.mark.parametrize("mode", ["G61", "G64 P0.01"])
@pytest.mark.parametrize(("turn", "side"), [(2, 1.0), (8, 0.2), (20, 3.0), (60, 1.0), (90, 10.0)])
def test_an_acceleration_that_no_speed_has_room_for_changes_nothing(mode, turn, side):
    moves = lines([side] * 12, [turn, -turn] * 6)
    times = [planned_s(moves, mode, a=a) for a in (2000, 4000, 16_000)]
    assert_never_slower(times, 0.002)


@pytest.mark.parametrize("feed", [300, 600])
def test_a_bend_is_no_wider_than_the_feed_asks_for(feed):
    moves = lines([30.0, 30.0, 30.0], [10, -20])
    text = f"{HEAD}G64 P1\nF{feed}\n{moves}M2\n".encode()
    error_mm = pycnc.run(Program(text, programs.machine())).summary["path_error_mm"]
    v = feed / 60
    widest = max(4 * v**2 / 1000, 2 * np.sqrt(v**3 / 10_000))
    assert error_mm < widest


@pytest.mark.parametrize("tolerance", [0.01, 0.03, 0.1])
def test_a_bend_that_costs_nothing_is_no_stop(tolerance):
    moves = lines([10.0] * 12, [1, -1] * 6)
    assert planned_s(moves, f"G64 P{tolerance}", feed=600) <= 12.0 + 0.1
