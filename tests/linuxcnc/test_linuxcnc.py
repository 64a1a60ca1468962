# SPDX-License-Identifier: MIT
"""The kernel as LinuxCNC's trajectory planner, in a stand-in for its motion controller."""

import math
import random

import numpy as np
import pytest
from linuxcnc_stand_in import BY_TICK, CYCLE_S, EVER, OWN, ROOT, Machine, StandIn

ROUNDING = 1e-6  # of a limit, on doubles
WITHIN = "term 2 0.01"
EXACT, STOPS = "term 1 0", "term 0 0"
ZIGZAG = [f"line 100 {5 * n} {10 * (n % 2)} 0" for n in range(1, 13)]
SCRIPTS = 200
CHORDS = 1500  # of a waved ring of 0.055 mm, as many as pass in 0.8 s at 100 mm/s
SLOWER = 2e-3  # than its feed a move is under `optimal`, at most


def ring(count=CHORDS):
    """Return the script of a ring of chords, one a servo cycle."""
    t = np.arange(count + 1) * 1e-3
    r = 50 + 3 * np.sin(9 * t)
    x, y, z = r * np.cos(t) - 50, r * np.sin(t), 2 * np.sin(5 * t)
    moves = [f"line 100 {a:.4f} {b:.4f} {c:.4f}\nrun 1" for a, b, c in zip(x, y, z, strict=True)]
    return [WITHIN, *moves[1:]]


@pytest.fixture(scope="module")
def stand_in(tmp_path_factory):
    return StandIn(tmp_path_factory.mktemp("linuxcnc"))


def assert_within_limits(run, rows=slice(None)):
    assert max(run.peaks(rows)) <= 1 + ROUNDING


# Moves


def test_lines_are_executed_to_their_ends_within_all_limits(stand_in):
    run = stand_in.run([WITHIN, *ZIGZAG, f"rest {EVER}", "tell"])
    assert_within_limits(run)
    assert run.places[-1] == pytest.approx([60, 0, 0], abs=1e-6)
    assert run.told("tell")[0][5:7] == ["done", "1"]


@pytest.mark.parametrize("normal", [(0, 0, 1), (0, 1, 0), (1, 0, 0), (0, 0, -1), (1, 1, 1)])
@pytest.mark.parametrize("turn", [0, 1, -1, -2])
def test_an_arc_about_any_axis_stays_on_its_circle(stand_in, normal, turn):
    n = np.array(normal) / np.linalg.norm(normal)
    u = np.cross(n, [0.3, 0.5, 0.7])
    u /= np.linalg.norm(u)
    v = np.cross(n, u)
    radius, rise = 8.0, 3.0
    start, centre = np.zeros(3), -radius * u
    end = centre + radius * (math.cos(2.0) * u + math.sin(2.0) * v) + rise * n
    numbers = [*end, 0, 0, 0, 0, 0, 0, *centre, *n]
    run = stand_in.run([WITHIN, f"arc 50 {' '.join(map(repr, map(float, numbers)))} {turn}",
                        f"rest {EVER}"])  # fmt: skip
    assert_within_limits(run)
    away = run.places - centre
    flat = away - np.outer(away @ n, n)
    assert np.abs(np.linalg.norm(flat, axis=1) - radius).max() < 0.0105
    angle = np.unwrap(np.arctan2(flat @ v, flat @ u))
    wanted = 2.0 + 2 * math.pi * turn if turn >= 0 else 2.0 + 2 * math.pi * (turn)
    assert angle[-1] - angle[0] == pytest.approx(wanted, abs=1e-6)
    assert run.places[-1] == pytest.approx(end, abs=1e-6)
    assert start == pytest.approx(run.places[0], abs=0.01)


def test_a_spiral_ends_at_its_end(stand_in):
    run = stand_in.run([WITHIN, "arc 50 -15 0 0 0 0 0 0 0 0 -5 0 0 0 0 1 0", f"rest {EVER}"])
    radius = np.linalg.norm(run.places[:, :2] - [-5, 0], axis=1)
    assert run.places[-1] == pytest.approx([-15, 0, 0], abs=1e-6)
    assert (np.diff(radius) > -1e-4).all() and radius[-1] == pytest.approx(10, abs=1e-6)


@pytest.mark.parametrize("term", [EXACT, STOPS])
def test_the_exact_path_is_met(stand_in, term):
    run = stand_in.run([term, *ZIGZAG, f"rest {EVER}"])
    x, y, _ = run.places.T
    assert np.abs(y - 10 * (1 - np.abs(x / 5 % 2 - 1))).max() < 1e-5
    assert max(run.peaks()[:2]) <= 1 + ROUNDING


def test_all_nine_axes_move(stand_in):
    nine = Machine(axes="XYZABCUVW")
    run = stand_in.run([WITHIN, "line 50 1 2 3 4 5 6 7 8 9", "line 50 9 8 7 6 5 4 3 2 1",
                        f"rest {EVER}"], nine)  # fmt: skip
    assert_within_limits(run)
    assert run.places[-1] == pytest.approx([9, 8, 7, 6, 5, 4, 3, 2, 1], abs=1e-6)


def test_a_machine_in_inches_does_the_same_as_one_in_millimetres(stand_in):
    inch = Machine(v=100 / 25.4, a=1000 / 25.4, j=10_000 / 25.4, units="inch")
    scaled = [f"line {100 / 25.4!r} {5 * n / 25.4!r} {10 * (n % 2) / 25.4!r} 0"
              for n in range(1, 13)]  # fmt: skip
    runs = [stand_in.run([WITHIN, *ZIGZAG, f"rest {EVER}"]),
            stand_in.run([f"term 2 {0.01 / 25.4!r}", *scaled, f"rest {EVER}"], inch)]  # fmt: skip
    assert len(runs[0].places) == len(runs[1].places)
    assert np.abs(runs[0].places - 25.4 * runs[1].places).max() < 1e-5


def test_a_rotary_axis_alone_has_its_speed_in_degrees(stand_in):
    run = stand_in.run(["vlimit 5", "line 40 0 0 0 90", f"rest {EVER}"], Machine(axes="XYZA"))
    assert run.column("speed").max() == pytest.approx(40, rel=SLOWER)


# What the host hears


def test_moves_are_told_in_their_order(stand_in):
    run = stand_in.run([WITHIN, *ZIGZAG, f"rest {EVER}", "tell"])
    ids = run.column("id").astype(int)
    assert list(dict.fromkeys(ids)) == [*range(1, 13), 0]
    assert (np.diff(run.column("depth")) <= 0).all()


def test_speed_is_the_tools(stand_in):
    run = stand_in.run(["line 20 30 40 0 90", f"rest {EVER}"], Machine(axes="XYZA"))
    way = np.linalg.norm(np.diff(run.places[:, :3], axis=0), axis=1) / CYCLE_S
    assert np.abs(run.column("speed")[1:] - way).max() < 1e-9
    assert run.column("speed").max() == pytest.approx(20, rel=SLOWER)


def test_the_distance_to_go_comes_down_to_nothing(stand_in):
    run = stand_in.run([EXACT, "arc 50 10 0 0 0 0 0 0 0 0 5 0 0 0 0 -1 -1", f"rest {EVER}"])
    to_go = run.column("to_go")
    assert to_go.max() == pytest.approx(5 * math.pi, rel=0.01)
    assert (np.diff(to_go[np.argmax(to_go):]) <= 1e-9).all() and to_go[-1] == 0


def test_outputs_change_in_step_with_the_motion(stand_in):
    run = stand_in.run([EXACT, "line 50 10 0 0", "dout 3 1", "aout 1 0.5", "line 50 20 0 0",
                        "dout 3 0", f"rest {EVER}", "line 50 30 0 0", f"rest {EVER}",
                        "dout 2 1"])  # fmt: skip
    digital = run.told("dout")
    assert [each[:2] for each in digital] == [["3", "1"], ["3", "0"]]
    assert [float(each[4]) for each in digital] == pytest.approx([10, 20], abs=0.06)
    assert [each[:2] for each in run.told("aout")] == [["1", "0.5"]]


def test_a_move_waits_for_the_spindle(stand_in):
    run = stand_in.run(["atspeed 0", "line 50 10 0 0", "wait", "line 50 20 0 0", "run 2000",
                        "tell", "pause", "resume", "run 50", "tell", "atspeed 1", f"rest {EVER}",
                        "tell"])  # fmt: skip
    assert [float(each[0]) for each in run.told("tell")] == pytest.approx([10, 10, 20], abs=1e-6)
    assert run.told("tell")[0][4] == "2"


def test_a_locking_indexer_is_free_while_it_turns(stand_in):
    run = stand_in.run(["line 50 10 0 0 0", "indexer 3", "line 50 10 0 0 30", "line 50 20 0 0 30",
                        f"rest {EVER}"], Machine(axes="XYZA"))  # fmt: skip
    (unlock, lock) = [int(each[3]) for each in run.told("unlock")]
    turns = np.flatnonzero(np.diff(run.places[:, 3])) + 1  # cycles; the lock answers at once
    moves = np.flatnonzero(np.diff(run.places[:, 0])) + 1
    assert unlock <= turns[0] and turns[-1] <= lock
    assert not ((moves > unlock) & (moves < lock)).any()
    assert [each[1] for each in run.told("unlock")] == ["1", "0"]


# The operator


def test_a_pause_rests_and_goes_on(stand_in):
    run = stand_in.run([WITHIN, *ZIGZAG, "run 500", "pause", "still 3000", "run 300", "tell",
                        "resume", f"rest {EVER}"])  # fmt: skip
    assert int(run.told("still")[0][0]) > 0
    assert_within_limits(run)
    assert run.places[-1] == pytest.approx([60, 0, 0], abs=1e-6)


def test_an_abort_rests_and_goes_on_from_there(stand_in):
    run = stand_in.run([WITHIN, *ZIGZAG, "run 500", "abort", "rest 3000", "tell", "line 50 0 0 0",
                        f"rest {EVER}", "tell"])  # fmt: skip
    assert_within_limits(run)
    assert run.told("tell")[0][5:9] == ["done", "1", "depth", "0"]
    assert run.places[-1] == pytest.approx([0, 0, 0], abs=1e-6)


def test_a_step_rests_at_the_end_of_its_move(stand_in):
    steps = ["step", "run 1500", "tell"]
    run = stand_in.run([EXACT, *ZIGZAG, "run 300", "pause", "still 3000", *3 * steps, "resume",
                        f"rest {EVER}"])  # fmt: skip
    rests = [float(each[0]) for each in run.told("tell")]
    first = rests[0] / 5
    assert rests == pytest.approx([5 * (round(first) + n) for n in range(3)], abs=1e-6)
    assert run.places[-1] == pytest.approx([60, 0, 0], abs=1e-6)


@pytest.mark.parametrize("share", [0.5, 0.333, 1.2])
def test_overrides_count_in_per_mille(stand_in, share):
    run = stand_in.run([f"feed {share}", "line 40 100 0 0", f"rest {EVER}"])
    assert run.column("speed").max() == pytest.approx(40 * share, rel=SLOWER)


def test_rapids_have_an_override_of_their_own(stand_in):
    run = stand_in.run(["feed 0.1", "rapids 0.25", "rapid 100 100 0 0", f"rest {EVER}"])
    assert run.column("speed").max() == pytest.approx(25, rel=SLOWER)


def test_the_operators_largest_speed_holds(stand_in):
    stand_in = stand_in.exact()
    run = stand_in.run(["line 100 100 0 0", "run 600", "vlimit 33.3", "run 700", "tell",
                        f"rest {EVER}"])  # fmt: skip
    assert float(run.told("tell")[0][12]) == pytest.approx(33.3, abs=0.01)
    assert_within_limits(run)


def test_adaptive_feed_and_feed_hold_scale_as_they_do_in_linuxcnc(stand_in):
    run = stand_in.run(["adaptive 0.4", "line 50 100 0 0", "run 600", "tell", "feedhold 1",
                        "still 1000", "feedhold 0", f"rest {EVER}"])  # fmt: skip
    assert float(run.told("tell")[0][12]) == pytest.approx(20, abs=0.05)
    assert int(run.told("still")[0][0]) > 0
    assert run.places[-1] == pytest.approx([100, 0, 0], abs=1e-6)


@pytest.mark.parametrize("cycles", [0, 300])
def test_limits_change_between_moves_at_rest_and_on_the_way(stand_in, cycles):
    stand_in = stand_in.exact()
    run = stand_in.run(["line 100 50 0 0", f"run {cycles}", "axis 0 20 200", "line 100 100 0 0",
                        f"rest {EVER}"])  # fmt: skip
    assert_within_limits(run)
    there = np.argmax(run.places[:, 0] > 50.01)
    assert run.column("speed")[there:].max() == pytest.approx(20, abs=1e-3)


def test_the_acceleration_along_the_path_has_its_own_limit(stand_in):
    run = stand_in.run(["amax 250", "line 100 100 0 0", f"rest {EVER}"])
    assert run.peaks()[1] == pytest.approx(0.25, abs=0.01)


def test_after_a_jog_it_goes_on_from_there(stand_in):
    run = stand_in.run(["line 50 10 0 0", f"rest {EVER}", "setpos 7.1234567891 3 0",
                        "line 50 10 5 0", f"rest {EVER}"])  # fmt: skip
    jog = np.argmax(run.places[:, 1] > 0)
    assert run.places[jog] == pytest.approx([7.1234567891, 3, 0], abs=1e-4)
    assert run.places[-1] == pytest.approx([10, 5, 0], abs=1e-6)
    assert_within_limits(run, slice(jog + 2, None))


def test_a_clear_on_the_move_stays_at_once_and_goes_on_later(stand_in):
    stand_in = stand_in.exact()
    run = stand_in.run([WITHIN, *ZIGZAG, "run 500", "clear", "line 50 0 0 0", "run 1", "tell",
                        f"rest {EVER}", "tell"])  # fmt: skip
    assert_within_limits(run, slice(501, None))
    assert run.places[-1] == pytest.approx([0, 0, 0], abs=1e-6)


# In step with the spindle

LEAD, PASS = 2.0, ["spindle 10", "run 100", "sync 2 0", "line 100 0 0 -20", "line 100 1 0 -21",
                   "sync 0 0", "rapid 100 0 0 0", f"rest {EVER}"]  # fmt: skip


def phase_error(run, first, last, lead=LEAD):
    """Return by how much the tool is off its thread between two places of Z [mm]."""
    z, turns = run.places[:, 2], run.column("turns")
    begin = np.argmax(z < first)
    cuts = slice(begin, begin + np.argmax(z[begin:] < last))
    return np.ptp(z[cuts] + lead * turns[cuts])


def test_a_thread_follows_the_spindles_angle(stand_in):
    run = stand_in.run(PASS)
    assert_within_limits(run)
    assert phase_error(run, -3, -18) < 1e-6
    assert run.places[-1] == pytest.approx([0, 0, 0], abs=1e-6)


def angles_at(run, place):
    """Return the spindle's angles where Z passes a place downward [revolutions]."""
    z, turns = run.places[:, 2], run.column("turns")
    crossings = np.flatnonzero((z[:-1] > place) & (z[1:] <= place))
    share = (z[crossings] - place) / (z[crossings] - z[crossings + 1])
    return turns[crossings] + share * (turns[crossings + 1] - turns[crossings])


def test_passes_of_one_thread_cut_one_groove(stand_in):
    again = [line for line in PASS if line not in ("spindle 10", "run 100")]
    run = stand_in.run([*PASS, "run 37", *again, "spindle 7", "run 77", *again])
    assert angles_at(run, -9) % 1 == pytest.approx(np.full(3, 0.5), abs=1e-6)


@pytest.mark.parametrize("rps", [5, 10])
def test_linuxcncs_own_groove_lies_behind_by_its_way_to_speed(stand_in, rps):
    if not OWN.is_file():
        pytest.skip("linuxcnc-uspace is not installed")
    script = [f"spindle {rps}", *PASS[1:]]
    own, ours = (angles_at(stand_in.run(script, module=each), -9)[0] for each in (OWN, None))
    v = LEAD * rps
    assert LEAD * ((own - ours) % 1) == pytest.approx(v**2 / 2 / 1000, abs=0.001)


def test_a_spindle_that_slows_down_takes_the_tool_along(stand_in):
    slows = ["spindle 10 5", "run 2100", *PASS[2:7], "run 800", "spindle 8", f"rest {EVER}"]
    run = stand_in.run(slows)
    assert_within_limits(run)
    assert phase_error(run, -3, -18) < 0.02  # while it changes by half a turn a second, each 0.1 s


def test_a_rigid_tap_goes_in_and_out_with_the_spindle(stand_in):
    run = stand_in.run(["spindle 10 20", "run 900", "sync 1 0", "tap 100 0 0 -15 0 0 0 0 0 0 1.5",
                        "sync 0 0", "rapid 100 10 0 0", f"rest {EVER}"])  # fmt: skip
    assert_within_limits(run)
    z, turns = run.places[:, 2], run.column("turns")
    cuts = np.flatnonzero(z < -2)
    assert np.ptp(z[cuts] + turns[cuts]) < 0.025  # the spindle brakes at 20 turns/s²
    assert z.min() < -15
    assert run.places[-1] == pytest.approx([10, 0, 0], abs=1e-6)
    assert np.abs(z[run.places[:, 0] > 0.01]).max() < 1e-6


@pytest.mark.parametrize("rps_s", [1e9, 2000, 200])
@pytest.mark.parametrize(("rps", "lead"), [(10, 1), (25, 2)])
def test_a_spindle_that_turns_back_at_once_leads_no_axis_over_its_limits(
    stand_in, rps, lead, rps_s
):
    run = stand_in.run([f"spindle {rps} {rps_s}", "run 900", f"sync {lead} 0",
                        "tap 100 0 0 -60 0 0 0 0 0 0 1", "sync 0 0", f"rest {EVER}"])  # fmt: skip
    assert_within_limits(run)
    z, turns = run.places[:, 2], run.column("turns")
    first, back = (np.flatnonzero(z < -10)[k] for k in (0, -1))
    off = z[[first, back]] + lead * turns[[first, back]]
    assert np.ptp(off) < 1e-3  # in step again on its way out
    assert run.places[-1] == pytest.approx([0, 0, 0], abs=1e-6)


def test_an_abort_in_a_thread_rests_and_goes_on_from_there(stand_in):
    run = stand_in.run([*PASS[:4], "run 900", "abort", "rest 2000", "tell", "line 50 0 0 0",
                        f"rest {EVER}"])  # fmt: skip
    assert_within_limits(run)
    assert -20 < float(run.told("tell")[0][2]) < -2
    assert run.places[-1] == pytest.approx([0, 0, 0], abs=1e-6)


def test_a_clear_in_a_thread_stays_at_once(stand_in):
    run = stand_in.run([*PASS[:4], "run 900", "clear", "sync 0 0", "line 50 0 0 0", "run 5",
                        f"rest {EVER}"])  # fmt: skip
    assert_within_limits(run, slice(1001, None))
    assert run.places[-1] == pytest.approx([0, 0, 0], abs=1e-6)


def test_a_feed_a_revolution_follows_the_spindles_speed(stand_in):
    # LinuxCNC hands over the feed a revolution as the move's speed, 2 here
    run = stand_in.run(["spindle 10", "run 10", "sync 2 1", "line 2 100 0 0", "run 1500", "tell",
                        "spindle 5", "run 1500", "tell", f"rest {EVER}"])  # fmt: skip
    assert [float(each[12]) for each in run.told("tell")] == pytest.approx([20, 10], abs=0.05)
    assert_within_limits(run)


# What the INI file lacks, and what is no move

MOVES = ["line 50 1 0 0", "run 20"]


@pytest.mark.parametrize(("line", "found"), [
    ("MAX_JERK = 10000.0\n", "MAX_JERK is missing"), ("MAX_VELOCITY = 100.0\n", "MAX_VELOCITY"),
    ("COORDINATES = X Y Z\n", "COORDINATES"), ("LINEAR_UNITS = mm\n", ""),
])  # fmt: skip
def test_what_is_missing_in_the_ini_is_told_and_nothing_moves(stand_in, line, found):
    machine = Machine()
    done = stand_in.start(MOVES, machine, ini=machine.ini.replace(line, ""))
    assert done.returncode == 0 and found in done.stderr
    assert ("move 1 -1" in done.stdout) == (found != "")


def test_what_is_wrong_is_told_again_where_a_move_is_asked_for(stand_in):
    machine = Machine()
    ini = machine.ini.replace("MAX_JERK = 10000.0", "")
    done = stand_in.start(["run 3", "setpos 4 5 6", *MOVES, "pause", "resume", "abort", "run 3",
                           "clear", "run 3", "tell"], machine, ini=ini)  # fmt: skip
    at_load, at_move = done.stderr.splitlines()
    assert at_load == at_move and "axis X: MAX_JERK is missing" in at_move
    words = done.stdout.splitlines()[-1].split()  # where the host has put it
    assert [float(each) for each in words[1:4]] == [4, 5, 6]
    assert words[6:8] == ["done", "1"]


@pytest.mark.parametrize(("line", "wrong", "found"), [
    ("[KINS]", "NCK_PLANNER = fast\n[KINS]", "write jerk, optimal or linear"),
    ("[KINS]", "NCK_BUDGET = much\n[KINS]", "NCK_BUDGET"),
    ("[KINS]", "NCK_TOLERANCE = -1\n[KINS]", "NCK_TOLERANCE"),
    ("LINEAR_UNITS = mm", "LINEAR_UNITS = yard", "write mm or inch"),
    ("MAX_JERK = 10000.0", "MAX_JERK = -1", "MAX_JERK is no number above zero"),
    ("MAX_ACCELERATION = 1000.0", "MAX_ACCELERATION = 0", "MAX_ACCELERATION"),
])  # fmt: skip
def test_what_is_wrong_in_the_ini_is_told_in_one_line_and_nothing_moves(
    stand_in, line, wrong, found
):
    done = stand_in.start(MOVES, Machine(), ini=Machine().ini.replace(line, wrong))
    assert "move 1 -1" in done.stdout
    message, again = done.stderr.splitlines()
    assert found in message and again == message


def test_kinematics_of_any_kind_are_served_by_their_axes(stand_in):
    machine = Machine()
    ini = machine.ini.replace("trivkins coordinates=xyz", "genserkins")
    assert stand_in.start([], machine, ini=ini).returncode == 0


@pytest.mark.parametrize("move", ["line 50 nan 0 0", "line 50 2e6 0 0", "line 0 1 0 0",
                                  "line -1 1 0 0", "arc 50 1 0 0 0 0 0 0 0 0 0 0 0 0 0 1 0",
                                  "line nan 1 0 0"])  # fmt: skip
def test_a_move_that_is_none_is_refused_and_the_next_one_runs(stand_in, move):
    run = stand_in.run([move, "line 50 1 0 0", f"rest {EVER}"])
    assert len(run.told("move")) == 1
    assert run.places[-1] == pytest.approx([1, 0, 0], abs=1e-6)


# Everything at once


def random_script(seed):
    """Return a script of random moves and a random operator, and where it ends."""
    draw = random.Random(seed)
    script = [draw.choice([WITHIN, "term 2 0.1", "term 2 0"])]
    place = [0.0, 0.0, 0.0]
    for _ in range(draw.randrange(6, 25)):
        for _ in range(draw.randrange(1, 12)):
            size = draw.choice([0.05, 1, 10, 30])
            place = [min(max(x + draw.uniform(-size, size), -100), 100) for x in place]
            word = draw.choice(["line", "line", "line", "rapid"])
            script.append(f"{word} {draw.choice([20, 50, 100])} {place[0]} {place[1]} {place[2]}")
            if draw.random() < 0.1:
                script.append(f"dout {draw.randrange(4)} {draw.randrange(2)}")
        script.append(f"run {draw.randrange(1, 400)}")
        script += draw.choice([
            ["pause", f"run {draw.randrange(1, 600)}", "resume"],
            ["pause", "still 20000", "step", f"run {draw.randrange(1, 900)}", "pause", "resume"],
            ["abort", "rest 20000"], ["abort", "run 3", "rest 20000"],
            [f"feed {draw.choice([0, 0.01, 0.3, 0.999, 1.5, 2])}", f"run {draw.randrange(1, 500)}",
             "feed 1"],
            [f"rapids {draw.choice([0, 0.1, 0.5])}", f"run {draw.randrange(1, 500)}", "rapids 1"],
            [f"vlimit {draw.choice([3, 20, 60, 1000])}"], ["feedhold 1", "run 300", "feedhold 0"],
            [f"adaptive {draw.choice([0.2, 0.5, 1])}"], [f"rest {EVER}"],
            ["atspeed 0", "wait", f"line 50 0 0 {draw.uniform(1, 9)}", "run 700", "atspeed 1"],
        ])  # fmt: skip
    return [*script, "feed 1", "rapids 1", "adaptive 1", "vlimit 1000", f"rest {EVER}",
            "line 50 1 2 3", f"rest {EVER}", "tell"]  # fmt: skip


@pytest.mark.sample(60)
@pytest.mark.parametrize("seed", range(SCRIPTS))
def test_a_random_operator_breaks_no_limit_and_loses_no_place(stand_in, seed):
    run = stand_in.run(random_script(seed))
    assert max(run.peaks()[:2]) <= 1 + ROUNDING
    assert run.peaks()[2] <= BY_TICK
    assert ["-1"] not in run.told("rest") + run.told("still")
    assert run.places[-1] == pytest.approx([1, 2, 3], abs=1e-6)


# What a cycle costs


def test_chords_that_come_one_a_cycle_begin_soon_and_end_soon(stand_in):
    run = stand_in.run([*ring(), f"rest {EVER}"])
    assert_within_limits(run)
    moves = np.abs(np.diff(run.places, axis=0)).max(axis=1) > 0
    assert np.argmax(moves) < 800  # what a first window needs has come one by one
    assert len(moves) < CHORDS + 1300


def test_plans_of_a_zigzag_are_made_in_time(stand_in):
    edges = [f"line 100 {5 * (n + n % 2)} {5 * (n - n % 2)} 0\nrun 1" for n in range(1, 101)]
    run = stand_in.run([WITHIN, *edges, f"rest {EVER}"])
    assert_within_limits(run)
    assert len(run.places) < 32_700  # it rests at every corner


def told(row):
    """Return what the page says of our planner in a row: instructions."""
    page = (ROOT / "docs/linuxcnc.md").read_text(encoding="utf-8")
    line = next(line for line in page.splitlines() if line.startswith(f"| {row} |"))
    return int(line.split("|")[3].replace(" ", ""))


@pytest.mark.seldom(4, "adapters", "csrc/nck/tick", "docs/linuxcnc.md", "tests/linuxcnc")
def test_a_cycle_takes_as_many_instructions_as_the_page_says(stand_in):
    if not OWN.is_file():
        pytest.skip("linuxcnc-uspace is not installed")
    script = [*ring(), f"rest {EVER}"]
    ours, own = stand_in.count(script), stand_in.count(script, OWN)
    found = {"mean": ours.mean(), "most": ours.max()}
    stopped = [*ring(CHORDS // 2), "abort", "rest 20000", "run 1"]
    found["an abort has come to rest"] = stand_in.count(stopped)[-2:].max()
    print(f"own: mean {own.mean():.0f}, most {own.max()}; ours: {found}")
    for row, value in found.items():
        assert value == pytest.approx(told(row), rel=0.05), row
