# SPDX-License-Identifier: MIT
"""The bounds against motions whose time is known in closed form, and their checks against motions
that are wrong on purpose."""

import numpy as np
import pytest

from pycnc.bench import bounds, bounds_tube, corpus
from pycnc.bench.bounds_solve import Limits, Motion, Seen, shares, states, stretched

V, A, J = 100.0, 1000.0, 10_000.0  # of an axis: mm/s, mm/s², mm/s³
EDGE = 10.0
REST_TO_REST_S = (32 * EDGE / J) ** (1 / 3)  # four phases of ± J; v and a stay below their limits

pytest.importorskip("casadi", reason="the extra bounds is not installed")


def limits(axes=2, feed=np.inf):
    one = np.ones(axes)
    return Limits(V * one, A * one, J * one, feed)


def slow_motion(points, time_s=2.0):
    """Return a motion that is known: from rest to rest at every point."""
    moves = np.linalg.norm(np.diff(points, axis=0), axis=1)
    corners_s = np.linspace(0, time_s, len(points))
    t = np.linspace(0, time_s, 1001)
    k = np.minimum(np.searchsorted(corners_s, t, "right") - 1, len(moves) - 1)
    x = (t - corners_s[k]) / (corners_s[1] - corners_s[0])
    x = x**3 * (10 - 15 * x + 6 * x * x)
    places = points[k] + x[:, None] * np.diff(points, axis=0)[k]
    s = np.append(0, np.cumsum(moves))[k] + x * moves[k]
    return Seen(t, s, places, corners_s)


def tube(points, tolerance, feed=np.inf, step_s=0.02):
    points = np.array(points, float)
    return bounds_tube.fastest(
        points, tolerance, limits(points.shape[1], feed), slow_motion(points), step_s
    )


CORNER = [(0, 0), (EDGE, 0), (EDGE, EDGE)]


@pytest.mark.parametrize("tolerance", [1e-3, 0.1])
def test_a_straight_line_takes_its_s_curve_whatever_the_tolerance(tolerance):
    found = tube([(0, 0), (EDGE, 0)], tolerance)
    assert found.is_solved
    assert found.time_s == pytest.approx(REST_TO_REST_S, rel=2e-3)
    assert found.time_s >= REST_TO_REST_S * (1 - 1e-6)


def test_a_long_line_takes_all_seven_phases_and_keeps_the_feed():
    full = tube([(0, 0), (40, 0)], 0.01)
    assert full.time_s == pytest.approx(40 / V + V / A + A / J, rel=2e-3)
    slow = tube([(0, 0), (40, 0)], 0.01, feed=50.0)
    assert slow.time_s == pytest.approx(40 / 50 + 2 * np.sqrt(50 / J), rel=2e-3)  # A not reached
    assert shares(slow, limits(feed=50.0))[0] <= 1 + 1e-3


@pytest.mark.thorough
def test_a_corner_lies_between_a_stop_and_one_move_of_both_axes():
    found = [tube(CORNER, tolerance) for tolerance in (1e-4, 0.01, 0.1, EDGE)]
    times = [motion.time_s for motion in found]
    assert all(motion.is_solved for motion in found)
    assert times == sorted(times, reverse=True)
    assert times[0] == pytest.approx(2 * REST_TO_REST_S, rel=0.02)
    assert times[0] < 2 * REST_TO_REST_S
    assert times[-1] == pytest.approx(REST_TO_REST_S, rel=3e-3)  # both axes at once


def test_a_corner_is_passed_within_the_tolerance_and_uses_it():
    points = np.array(CORNER, float)
    found = tube(CORNER, 0.05)
    assert bounds.miss(found, points) == pytest.approx(0.05, rel=2e-3)
    assert shares(found, limits()) <= (1 + 1e-6, 1 + 1e-6, 1 + 1e-4)


def test_a_finer_step_is_never_slower():
    coarse, fine = (tube(CORNER, 0.01, step_s=step).time_s for step in (0.04, 0.02))
    assert fine < coarse < 1.05 * fine


@pytest.mark.thorough
def test_another_begin_of_the_search_leads_to_the_same_time():
    points = bounds._stairs(6, 1.0)[:, :2]
    points = points - points[0]
    _, seen, _ = bounds.ours(points, 0.01)
    rests = slow_motion(points, 3 * seen.t[-1])
    ours, slow = (
        bounds_tube.fastest(points, 0.01, limits(feed=100.0), begin, step_s)
        for begin, step_s in ((seen, 0.008), (rests, 0.024))
    )
    assert ours.is_solved and slow.is_solved
    assert ours.time_s == pytest.approx(slow.time_s, rel=2e-3)


def test_a_motion_that_passes_a_limit_is_found_and_slowed_down():
    h, j = np.full(4, REST_TO_REST_S / 4), J * np.array([[1.0], [-1.0], [-1.0], [1.0]])
    good = bounds_tube._of_pieces(np.zeros(1), h, j, "Solve_Succeeded")
    assert shares(good, limits(1)) == pytest.approx((0.63, 0.79, 1.0), rel=0.02)
    assert good.places(np.array([good.time_s]))[0, 0] == pytest.approx(EDGE)
    fast = Motion(good.time_s / 2, lambda t: good.places(2 * t), good.status)
    assert shares(fast, limits(1))[2] == pytest.approx(8, rel=1e-3)
    assert stretched(fast, limits(1)) == pytest.approx(good.time_s, rel=1e-3)


def test_a_place_off_the_program_is_found_both_ways():
    points = np.array(CORNER, float)
    aside = Motion(1.0, lambda t: np.column_stack([EDGE * t, 0.2 + 0 * t]), "")
    assert bounds.miss(aside, points) == pytest.approx(EDGE - 0.2)  # the last corner is not met
    assert bounds.miss(aside, points[:2]) == pytest.approx(0.2)


def test_pieces_of_jerk_go_where_their_integral_does():
    q, v, a = states(np.array([1.0, 2.0, 1.0]), np.array([6.0, 0.0, 1.0]))
    assert (q.tolist(), v.tolist(), a.tolist()) == ([0, 1, 19], [0, 3, 15], [0, 6, 6])


@pytest.mark.thorough
def test_a_row_of_bounds_is_in_order():
    bent = np.array([(0, 0), (EDGE, 0), (2 * EDGE, EDGE / 8)])
    cases = [("corner", lambda: bent, 0.01), bounds.CASES[0]]
    row, stops = bounds.bench_bounds_rows(cases, step_s=0.016)
    assert row["note"] is stops["note"] is None
    assert 1 < stops["ours_over_tube"] < 1.1
    assert row["tube_s"] < row["ours_s"]
    assert row["ours_over_tube"] == pytest.approx(row["ours_s"] / row["tube_s"])
    assert 0 < row["step"] < 0.02
    assert row["tube_miss"] < 1.002
    assert 0.9 < row["ours_peak"] <= 1
    assert 0.5 < row["ours_miss"] <= 1


def test_a_row_whose_file_is_absent_says_so(monkeypatch, tmp_path):
    monkeypatch.setattr(corpus, "FOLDER", tmp_path)
    rows = bounds.bench_bounds_rows(bounds.CASES[-2:])
    assert all("skipped" in row["note"] for row in rows)


def test_what_is_not_converged_or_no_bound_is_told():
    lost = Motion(1.0, None, "Maximum_Iterations_Exceeded")
    assert bounds._note([lost], 1.0, 0.9) == "not converged: Maximum_Iterations_Exceeded"
    good = Motion(1.0, None, "Solve_Succeeded")
    assert "above ours" in bounds._note([good], 1.0, 1.1)
