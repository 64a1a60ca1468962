# SPDX-License-Identifier: MIT
"""Jerk as LinuxCNC tells it: of 2.9 the INI file alone, from 2.10 on every move."""

import random

import numpy as np
import pytest
from linuxcnc_stand_in import CYCLE_S, EVER, Machine, StandIn

WITHIN, REST = "term 2 0.01", f"rest {EVER}"
NONE = Machine().ini.replace("MAX_JERK = 10000.0", "MAX_JERK = 0")
ROUNDING = 1e-6
SCRIPTS = 40
ALL_TELL = [f"jerk {axis} 10000" for axis in range(3)]


@pytest.fixture(scope="module", params=[False, True], ids=["2.9", "2.10"])
def either(request, tmp_path_factory):
    return StandIn(tmp_path_factory.mktemp("either"), tells_jerk=request.param)


@pytest.fixture(scope="module")
def stand_in(tmp_path_factory):
    return StandIn(tmp_path_factory.mktemp("linuxcnc"), tells_jerk=True)


def peak(run, axis, rows=slice(None)):
    """Return the largest jerk of an axis."""
    return np.abs(np.diff(run.places[rows, axis], n=3)).max() / CYCLE_S**3


def zigzag(draw, count=30):
    """Return lines of random directions."""
    ends = [[draw.uniform(-40, 40) for _ in range(3)] for _ in range(count)]
    return [f"line 100 {x} {y} {z}" for x, y, z in ends]


@pytest.mark.parametrize("seed", range(4))
def test_both_move_alike_as_long_as_moves_tell_what_the_ini_file_says(
    stand_in, tmp_path, seed
):
    script = [WITHIN, *zigzag(random.Random(seed)), REST]
    old = StandIn(tmp_path).run(script)
    new = stand_in.run([*ALL_TELL, *script])
    assert np.array_equal(old.places, new.places)


@pytest.mark.parametrize("jerk", [2000, 10_000, 40_000])
def test_the_jerk_that_moves_tell_is_the_axis(stand_in, jerk):
    run = stand_in.run([*ALL_TELL, "line 100 30 0 0", REST, f"jerk 0 {jerk}", "line 100 0 0 0",
                        "line 100 0 30 0", REST])  # fmt: skip
    first = np.argmax(run.column("done")[1:]) + 1  # the first move ends there
    assert peak(run, 0, slice(None, first)) == pytest.approx(10_000, rel=0.05)
    assert peak(run, 0, slice(first + 2, None)) == pytest.approx(jerk, rel=0.05)
    assert peak(run, 1) == pytest.approx(10_000, rel=0.05)


def test_a_move_that_tells_none_has_what_was_told_before(stand_in):
    run = stand_in.run(["line 100 30 0 0", REST])
    assert peak(run, 0) == pytest.approx(10_000, rel=0.05)


@pytest.mark.sample(10)
@pytest.mark.parametrize("seed", range(SCRIPTS))
def test_no_axis_has_more_than_the_most_that_was_told_of_it(stand_in, seed):
    draw = random.Random(seed)
    most = [10_000.0] * 3
    script = [WITHIN, *ALL_TELL]
    for _ in range(6):
        axis, jerk = draw.randrange(3), draw.choice([3000, 8000, 20_000, 50_000])
        most[axis] = max(most[axis], jerk)
        script += [*zigzag(draw, draw.randrange(1, 8)), f"run {draw.randrange(900)}",
                   f"jerk {axis} {jerk}"]  # fmt: skip
    run = stand_in.run([*script, *zigzag(draw, 3), REST])
    assert [peak(run, axis) <= most[axis] * (1 + ROUNDING) for axis in range(3)] == [True] * 3
    assert ["-1"] not in run.told("rest")


def test_a_thread_has_the_jerk_that_its_lines_tell(stand_in):
    thread = ["spindle 10", "run 100", "sync 2 0", "line 100 0 0 -20", "sync 0 0", REST]
    peaks = [peak(stand_in.run([*ALL_TELL, f"jerk 2 {jerk}", *thread]), 2)
             for jerk in (3000, 10_000)]  # fmt: skip
    assert peaks[0] <= 3000 < peaks[1] <= 10_000


def test_the_host_hears_of_acceleration_jerk_and_direction(stand_in):
    stand_in = stand_in.exact()
    run = stand_in.run([*ALL_TELL, WITHIN, "line 100 30 40 0", REST])
    jerk, a = run.column("j_told"), run.column("a_told")
    assert np.diff(run.column("speed")) / CYCLE_S == pytest.approx(a[1:], abs=1e-6)
    assert np.diff(a) / CYCLE_S == pytest.approx(jerk[1:], abs=1e-3)
    moves = run.column("speed") > 0
    assert run.column("x_along")[moves] == pytest.approx(0.6, abs=1e-3)
    assert run.column("y_along")[moves] == pytest.approx(0.8, abs=1e-3)
    assert not run.column("x_along")[~moves].any()


def start(either, script, ini):
    """Run a script with an INI text; return what the module said."""
    done = either.start(script, Machine(), ini=ini)
    assert done.returncode == 0, done.stderr
    return done.stderr


def test_no_jerk_for_all_axes_is_the_planner_without_it(either):
    assert "planner linear" in start(either, ["line 100 30 0 0", REST], NONE)


def test_no_jerk_of_one_axis_is_what_a_cycle_can(either):
    ini = NONE.replace("MAX_JERK = 0", "MAX_JERK = 10000", 1)  # X
    said = start(either, [WITHIN, *zigzag(random.Random(1), 8), REST], ini)
    assert "X jerk 10000" in said and "Y jerk 0 units/s^3: none" in said
    rows = np.fromfile(either.folder / "trace").reshape(-1, either.columns)
    jerks = np.abs(np.diff(rows[:, :3], n=3, axis=0)).max(axis=0) / CYCLE_S**3
    assert jerks[0] <= 10_000 * (1 + ROUNDING) < jerks[1] <= 2 * 1000 / CYCLE_S * (1 + ROUNDING)


def test_a_line_that_ends_in_a_backslash_goes_on_in_the_next_one(either):
    ini = Machine().ini.replace("COORDINATES = X Y Z", "COORDINATES = X \\\nY \\\nZ")
    said = start(either, ["line 100 0 0 5", REST], ini)
    assert all(f"{axis} jerk 10000" in said for axis in "XYZ")
