# SPDX-License-Identifier: MIT
"""What LinuxCNC asks of the planner beside moves: caps of each move, outputs, a servo period."""

import math
import random

import numpy as np
import pytest
from linuxcnc_stand_in import BY_TICK, CYCLE_S, EVER, OWN, ROOT, Machine, StandIn

WITHIN, EXACT = "term 2 0.01", "term 1 0"
LINE, BEND = "line 80 100 0 0", "line 80 40 30 0"
ARC = "arc 80 -20 0 0 0 0 0 0 0 0 -10 0 0 0 0 1 0"  # half of a circle, radius 10
FREE = 1e9  # a cap that is none
REST = f"rest {EVER}"
CORNER = 2.0  # a corner rounded within 0.01 mm begins and ends nearer than this [mm]
SCRIPTS = 60


@pytest.fixture(scope="module")
def stand_in(tmp_path_factory):
    return StandIn(tmp_path_factory.mktemp("linuxcnc"))


def caps(v=FREE, a=FREE):
    """Return the word that tells caps of the moves that come."""
    return f"caps {v} {a}"


def speeds(run):
    """Return the tool's speed, a row a cycle from the second one on."""
    return np.linalg.norm(np.diff(run.places, axis=0), axis=1) / CYCLE_S


def accelerations(run):
    """Return the magnitude of the tool's acceleration."""
    found = np.diff(run.places, axis=0) / CYCLE_S
    return np.linalg.norm(np.diff(found, axis=0), axis=1) / CYCLE_S


def rests(run):
    """Return how often the tool comes to rest before its end."""
    moves = speeds(run) > 0.1  # a rest may lie between two cycles
    return int((moves[:-1] & ~moves[1:])[: np.flatnonzero(moves)[-1]].sum())


# Cycles

# LinuxCNC drills on the exact path whatever the program says, and tells G64 with each move.
HOLES = [f"{word} {n} 0 {z}" for n in range(1, 4)
         for word, z in (("rapid 100", 2), ("line 50", -5), ("rapid 100", 2))]  # fmt: skip


@pytest.mark.parametrize("blends", [0, 1])
def test_a_cycle_under_g64_keeps_the_jerk_in_its_corners(stand_in, blends):
    run = stand_in.run([EXACT, f"blends {blends}", *HOLES, WITHIN, LINE, REST])
    assert (run.peaks()[2] <= 1 + 1e-6) == bool(blends)
    assert np.abs(run.places[:, 2].min() + 5) < 1e-6


# Speed


@pytest.mark.parametrize("move", [LINE, BEND, ARC])
@pytest.mark.parametrize("share", [0.5, 1, 1.5, 2])
def test_no_override_makes_a_move_faster_than_its_cap(stand_in, move, share):
    run = stand_in.run([f"feed {share}", caps(60), move, REST])
    assert speeds(run).max() == pytest.approx(min(80 * share, 60), abs=0.06)  # 1 ‰ of it


M49 = "enables 12"  # FS_ENABLED is 2


@pytest.mark.parametrize("name,word", [("rapids", "rapid"), ("feed", "line")])
def test_a_move_of_m49_begins_where_an_override_of_none_keeps_others(stand_in, name, word):
    other = {"rapid": "line", "line": "rapid"}[word]
    script = [EXACT, f"{other} 50 10 0 0", M49, f"{word} 50 20 0 0", f"{name} 0", "settled 9000"]
    for module in (None, OWN):
        assert stand_in.run(script, module=module).places[-1, 0] == pytest.approx(20, abs=1e-6)


@pytest.mark.parametrize("share", [0.5, 1])
def test_a_rapid_is_no_faster_than_its_cap_and_the_next_one_is(stand_in, share):
    stand_in = stand_in.exact()
    run = stand_in.run([f"rapids {share}", caps(40), "rapid 40 50 0 0", caps(),
                        "rapid 100 150 0 0", REST])  # fmt: skip
    first = run.places[1:, 0] < 50
    assert speeds(run)[first].max() == pytest.approx(40 * share, abs=0.001)
    assert speeds(run).max() == pytest.approx(100 * share, abs=0.001)


@pytest.mark.parametrize(("before", "after"), [(1, 2), (2, 1), (0.75, 1.5), (2, 0.75)])
def test_the_override_changes_while_capped_moves_are_planned(stand_in, before, after):
    stand_in = stand_in.exact()
    lines = [f"line 80 {10 * n} 0 0" for n in range(1, 21)]
    run = stand_in.run([WITHIN, f"feed {before}", caps(60), *lines, "run 600", f"feed {after}",
                        REST])  # fmt: skip
    assert speeds(run).max() < 60.001
    assert speeds(run)[1000:2000] == pytest.approx(60, abs=0.01)


@pytest.mark.parametrize(("before", "after"), [(1.25, 1.25), (1, 1.25), (0.2, 1.25)])
def test_lines_beside_a_capped_one_have_an_override_that_has_come_since_when_it_is_passed(
    stand_in, before, after
):
    stand_in = stand_in.exact()
    run = stand_in.run([WITHIN, f"feed {before}", caps(), "line 80 100 0 0", caps(60),
                        "line 60 200 0 0", caps(), "line 80 300 0 0", "run 300", f"feed {after}",
                        REST])  # fmt: skip
    x, v = run.places[1:, 0], speeds(run)
    assert v[(x > 100.1) & (x < 199.9)].max() < 60.01
    assert v[np.argmax(x > 60)] == pytest.approx(80 * max(before, 1), abs=0.01)
    assert v[np.argmax(x > 270)] == pytest.approx(100, abs=0.01)


def test_a_feed_a_revolution_keeps_to_the_cap(stand_in):
    stand_in = stand_in.exact()
    run = stand_in.run(["spindle 10", "run 10", "sync 5 1", caps(60), "line 5 100 0 0", "run 800",
                        "spindle 20", REST])  # fmt: skip
    assert speeds(run)[700] == pytest.approx(50, abs=0.2)
    assert speeds(run).max() == pytest.approx(60, abs=0.01)


# Acceleration


@pytest.mark.parametrize("move", [LINE, BEND, "rapid 100 100 50 0", "line 80 20 20 -20"])
def test_a_straight_move_has_the_acceleration_that_is_asked(stand_in, move):
    stand_in = stand_in.exact()
    run = stand_in.run([caps(a=300), move, REST])
    assert accelerations(run).max() == pytest.approx(300, abs=0.01)


def test_on_an_arc_each_axis_has_no_more_than_is_asked(stand_in):
    run = stand_in.run([caps(v=40, a=300), ARC, REST])
    assert run.peaks()[1] <= 0.3 + 1e-6
    assert accelerations(run).max() < 2**0.5 * 300


def test_moves_of_one_share_of_the_axes_acceleration_rest_only_around_them(stand_in):
    ends = [(20, 0), (40, 1), (60, 1), (80, 3), (100, 4)]  # bends that need no rest
    script = [WITHIN]
    for n, (x, y) in enumerate(ends):
        along = np.hypot(20, y - ends[n - 1][1]) / 20 if n else 1
        script += [caps(a=along * 500 if 0 < n < 4 else FREE), f"line 80 {x} {y} 0"]
    run = stand_in.run([*script, REST])
    inside = slice(*(np.argmax(run.column("id") == n) for n in (2, 5)))
    assert np.abs(np.diff(run.places[inside], 2, axis=0)).max() / CYCLE_S**2 <= 500 + 1e-3
    assert rests(run) == 2
    assert rests(stand_in.run([line for line in script if "caps" not in line] + [REST])) == 0


def test_one_acceleration_in_all_directions_costs_few_rests(stand_in):
    bow = [f"line 80 {50 * math.sin(t)} {50 * math.cos(t)} 0" for t in np.linspace(0.1, 1.5, 40)]
    run = stand_in.run(["setpos 0 50 0", WITHIN, caps(a=500), *bow, REST])
    assert rests(run) < 3
    assert run.peaks(slice(2, None))[1] <= 0.5 + 1e-6


def test_what_the_axes_leave_to_a_move_is_no_cap(stand_in):
    stand_in = stand_in.exact()
    edges = [f"line 80 {5 * n} {10 * (n % 2)} {n}" for n in range(1, 13)]
    script = [WITHIN, "feed 1.2", *edges, "rapid 100 0 0 0", ARC, REST]
    told, free = stand_in.run(script), stand_in.run([caps(), *script])
    assert np.array_equal(told.places, free.places)
    assert rests(stand_in.run([WITHIN, *edges, REST])) == 0


def test_limits_that_are_lowered_on_the_way_cost_one_rest(stand_in):
    stand_in = stand_in.exact()
    lines = [f"line 80 {50 + 5 * n} 0 0" for n in range(1, 11)]
    run = stand_in.run([WITHIN, "line 100 50 0 0", "run 100", "axis 0 50 500", *lines, REST])
    assert rests(run) == 1
    lower = run.places[1:, 0] > 50.01
    assert speeds(run)[lower].max() == pytest.approx(50, abs=1e-3)
    assert accelerations(run)[lower[1:]].max() <= 500.001


def test_limits_that_an_abort_has_dropped_are_told_again(stand_in):
    run = stand_in.run(["line 100 50 0 0", "run 300", caps(a=200), "line 80 90 0 0", "abort",
                        "rest 5000", "line 80 0 0 0", REST])  # fmt: skip
    back = np.argmax(run.places[:, 0])
    assert accelerations(run)[back + 1:].max() <= 200.001


# Everything at once

# Caps are shares of the axes' limits along the programmed line. Where corners are moved to their
# outside a line turns by P over its length, and its tool may be as much faster; seen: 3e-4.
TURNED = 5e-4


def random_script(seed):
    """Return a script of random moves with random caps, and the speed that each may have."""
    draw = random.Random(seed)
    script, most, place = [draw.choice([WITHIN, EXACT])], [], [0.0, 0.0, 0.0]
    for _ in range(draw.randrange(4, 10)):
        for _ in range(draw.randrange(1, 15)):
            size = draw.choice([0.05, 1, 10, 30, 60])
            place = [min(max(x + draw.uniform(-size, size), -100), 100) for x in place]
            word, v = draw.choice(["line", "line", "rapid"]), draw.choice([FREE, FREE, 15, 40, 60])
            vel = min(draw.choice([20, 50, 90]), v)
            script += [caps(v, draw.choice([FREE, FREE, FREE, 400])),
                       f"{word} {vel} {place[0]} {place[1]} {place[2]}"]  # fmt: skip
            most.append(vel if word == "rapid" else v)
            script += draw.choice([[], [], ["run 1"]])
        script += [f"run {draw.randrange(1, 400)}", *draw.choice([
            ["feed 0.5"], ["feed 1"], ["feed 1.3"], ["feed 2"], ["pause", "run 300", "resume"],
            ["feed 0", "run 200", "feed 1.7"], [REST], ["abort", "rest 20000"],
        ])]  # fmt: skip
    return [*script, "feed 1", REST], np.array([FREE, *most])


@pytest.mark.sample(quick=15)
@pytest.mark.parametrize("seed", range(SCRIPTS))
def test_a_random_operator_makes_no_move_faster_than_its_cap(stand_in, seed):
    script, most = random_script(seed)
    run = stand_in.run(script)
    move, to_go = run.column("id").astype(int), run.column("to_go")
    length = np.zeros(len(most))
    np.maximum.at(length, move, to_go)
    inside = (move[1:] == move[:-1]) & (move[1:] > 0)
    if script[0] != EXACT:
        inside &= (np.minimum(to_go, length[move] - to_go) > CORNER)[1:]
    more = 1e-5 if script[0] == EXACT else TURNED
    assert (speeds(run) / most[move[1:]])[inside].max(initial=0) <= 1 + more
    assert max(run.peaks()[:2]) <= 1 + 1e-6
    assert script[0] == EXACT or run.peaks()[2] <= BY_TICK


@pytest.mark.parametrize("script", [
    [caps(60), LINE], ["feed 2", caps(60), LINE], ["feed 2", caps(60), ARC],
    [caps(40), "rapid 40 100 0 0"], ["feed 2", LINE], ["vlimit 30", "rapid 100 100 0 0"],
])  # fmt: skip
def test_no_cap_lets_it_be_faster_than_linuxcncs_own_planner(stand_in, script):
    stand_in = stand_in.exact()
    if not OWN.is_file():
        pytest.skip("linuxcnc-uspace is not installed")
    ours, own = (speeds(stand_in.run([*script, REST], module=each)).max() for each in (None, OWN))
    assert ours == pytest.approx(own, abs=0.01)


# Outputs


@pytest.mark.parametrize(("term", "within"), [(EXACT, 0.06), (WITHIN, 0.07)])
def test_an_output_is_switched_off_alone_where_its_move_begins(stand_in, term, within):
    stand_in = stand_in.exact()
    run = stand_in.run([term, "line 50 10 0 0", "dout 3 0", "line 50 20 0 0", REST])
    ((index, value, _, _, x),) = run.told("dout")
    assert (index, value) == ("3", "0")
    assert float(x) == pytest.approx(10, abs=within)


def test_an_output_to_be_switched_off_waits_for_a_move_and_is_dropped_by_an_abort(stand_in):
    run = stand_in.run(["line 50 10 0 0", REST, "dout 3 0", "run 100", "abort", "line 50 20 0 0",
                        REST])  # fmt: skip
    assert run.told("dout") == []


# What a stop takes


def overtravels():
    """Return what the page tells, [(feed, jerk, mm)]."""
    page = (ROOT / "docs/linuxcnc.md").read_text(encoding="utf-8")
    begin = page.index("| feed [mm/min] | own |")
    lines = page[begin : page.index("\n\n", begin)].splitlines()[2:]
    rows = [[float(word) for word in line.strip(" |").split("|")] for line in lines]
    return [(feed, jerk, mm) for feed, _, slow, quick in rows
            for jerk, mm in ((10_000, slow), (50_000, quick))]  # fmt: skip


@pytest.mark.sample(30)
@pytest.mark.parametrize("cycles", range(1000, 1500, 11))  # any moment on the way
@pytest.mark.parametrize(("feed", "jerk", "told"), overtravels())
def test_a_stop_overtravels_by_what_the_page_says(stand_in, feed, jerk, told, cycles):
    script = [f"line {feed / 60} 300 0 0", f"run {cycles}", "abort", "rest 20000"]
    x = stand_in.run(script, Machine(j=jerk)).places[:, 0]
    assert 0.9 * told < x[-1] - x[cycles - 1] <= told + 0.0005


# The servo period


@pytest.mark.parametrize("period", ["0", "-1000000", "1000", "9999", "100000001", "1e12", "often"])
def test_a_servo_period_out_of_range_is_told_in_one_line_and_nothing_moves(stand_in, period):
    machine = Machine()
    ini = machine.ini.replace("[KINS]", f"[EMCMOT]\nSERVO_PERIOD = {period}\n[KINS]")
    done = stand_in.start([LINE, "run 20"], machine, ini=ini)
    assert "move 1 -1" in done.stdout
    message, again = done.stderr.splitlines()
    assert message == again
    assert "[EMCMOT] SERVO_PERIOD: write 10000 to 100000000 nanoseconds" in message


@pytest.mark.parametrize("period", ["10000", "1000000", "100000000"])
def test_a_servo_period_within_the_range_loads(stand_in, period):
    machine = Machine()
    ini = machine.ini.replace("[KINS]", f"[EMCMOT]\nSERVO_PERIOD = {period}\n[KINS]")
    assert stand_in.start([], machine, ini=ini).returncode == 0


@pytest.mark.parametrize("period", [1e-6, 0.2, float("inf")])
def test_a_servo_period_that_the_ini_does_not_tell_lets_no_move_in(stand_in, period):
    run = stand_in.run([f"period {period}", "line 50 10 0 0", "run 100", "setpos 1 2 3", "tell",
                        "period 0.001", "line 50 10 0 0", REST])  # fmt: skip
    assert run.told("period") == [["-1"], ["0"]]
    assert run.told("move") == [["1", "-1"]]
    assert run.log.count("servo period is outside of 0.01 to 100 ms") == 1
    assert np.isfinite(run.places).all() and (run.places[:100] == 0).all()
    assert run.places[-1] == pytest.approx([10, 0, 0], abs=1e-6)


def test_no_servo_period_changes_nothing(stand_in):
    run = stand_in.run(["period 0", "line 50 10 0 0", REST])
    assert run.told("period") == [["-1"]] and "period" not in run.log
    assert run.places[-1] == pytest.approx([10, 0, 0], abs=1e-6)
