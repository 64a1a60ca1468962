# SPDX-License-Identifier: MIT
"""Servo periods of less than a millisecond: what a cycle costs, and that plans come in time."""

import numpy as np
import pytest
from linuxcnc_stand_in import EVER, JERK, Machine, StandIn
from test_linuxcnc import WITHIN, random_script, ring

PERIOD_S = 0.25e-3
MOST = 150_000  # instructions of a cycle
UNBOUND = Machine(traj="NCK_BUDGET = 100000")
SEEDS, LINES = 400, 40  # a script's begin: valgrind takes its time
EDGES = [f"line 100 {5 * (n + n % 2)} {5 * (n - n % 2)} 0\nrun 1" for n in range(1, 9)]
WAVE = [f"line 100 {0.2 * n:.4f} {3 * np.sin(0.03 * n):.4f} 0\nrun 1" for n in range(1, 1001)]
THINNED = ring()[6::6]  # chords of 0.33 mm: what Q joins
PROGRAMS = {"ring": ring(700), "zigzag": [WITHIN, *EDGES], "wave": [WITHIN, *WAVE],
            "thinned": [WITHIN, *THINNED]}  # fmt: skip


@pytest.fixture(scope="module")
def stand_in(tmp_path_factory):
    return StandIn(tmp_path_factory.mktemp("servo"), short_servo=True)


def paced(script):
    """Return the script at the short period; a move is handed over each millisecond."""
    each = f"run {round(1e-3 / PERIOD_S)}"
    return [f"period {PERIOD_S}", *(line.replace("run 1", each) for line in script),
            f"rest {EVER}"]  # fmt: skip


def moving_s(run):
    """Return how long it has moved."""
    moves = np.flatnonzero(np.abs(np.diff(run.places, axis=0)).max(axis=1) > 0)
    return (moves[-1] - moves[0] + 1) * PERIOD_S


@pytest.mark.thorough
@pytest.mark.sample(2)
@pytest.mark.parametrize("name", PROGRAMS)
@pytest.mark.parametrize("machine", [Machine(), JERK], ids=["optimal", "jerk"])
def test_a_cycle_of_a_quarter_millisecond_is_bounded(stand_in, name, machine):
    assert stand_in.count(paced(PROGRAMS[name]), machine=machine).max() <= MOST


@pytest.mark.thorough
@pytest.mark.sample(1)
@pytest.mark.parametrize("seed", range(SEEDS))
def test_the_same_under_a_random_operator(stand_in, seed):
    script = [line.replace(f"{EVER}", "700") for line in random_script(seed)[:LINES]]
    assert stand_in.count([f"period {PERIOD_S}", *script, "run 1000"]).max() <= MOST


@pytest.mark.thorough
def test_a_cycle_behind_an_abort_costs_no_more(stand_in):
    script = [*paced(ring(300))[:-1], "abort", "rest 20000", "line 50 0 0 0", "run 2000"]
    assert stand_in.count(script).max() <= MOST


@pytest.mark.parametrize("name", PROGRAMS)
def test_the_budget_of_a_cycle_costs_no_time(stand_in, name):
    bound, unbound = (moving_s(stand_in.run(paced(PROGRAMS[name]), machine))
                      for machine in (Machine(), UNBOUND))  # fmt: skip
    assert bound <= 1.01 * unbound + 0.45  # till the first window is planned
