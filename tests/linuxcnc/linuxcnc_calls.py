# SPDX-License-Identifier: MIT
"""Calls that a host makes of the planner module, at random by seed, and what they have to bring.

    .venv/bin/python tests/linuxcnc/linuxcnc_calls.py [FAMILY … ] [--count N] [--seed FIRST]

Families: `calls` (an operator at rest, beside LinuxCNC's own planner), `stops` (one on the move),
`feeds` (G95, G96 while the spindle changes its speed), `threads` (lines with leads of their own
that come when they come) and `late` (short ones that come when the tool is nearly there, or is).
"""

import argparse
import random
import sys
import tempfile
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))

import numpy as np
from linuxcnc_stand_in import BY_TICK, CYCLE_S, EVER, OWN, StandIn

ROUNDING = 1e-6  # of a limit, on doubles
NEAR = 0.02  # LinuxCNC's own planner goes on into the next move before it hears a pause [mm]
OFF = 5e-3  # of a feed a revolution
STEADY = 0.8  # for so long, before it is judged, tool and spindle have changed little [s], …
FASTEST = {"css": 0.25, "": 0.1}  # … the spindle by no more than this share a second
LATE_S = 0.05  # and for so long its change may not be heard [s]
REST = f"rest {EVER}"
SETTLES = "run 2500"  # every move of `calls` is done by then


def held(run, rows=slice(None)):
    """Return what is wrong with the limits of the axes, in words."""
    most = {"speed": 1 + ROUNDING, "acceleration": 1 + ROUNDING, "jerk": BY_TICK}
    told = zip(most, run.peaks(rows), strict=True)
    return [f"{name} {peak:.4f} of its limit" for name, peak in told if peak > most[name]]


# ---- calls: each at rest, so that both planners are at the same place behind it


def calls(seed):
    """Return a script whose places behind every call are those of LinuxCNC's own planner."""
    draw, x = random.Random(seed), 0
    script, waits, backward = ["term 1 0"], False, False
    for _ in range(draw.randrange(6, 20)):
        word = draw.choice(["line", "line", "lines", "pause", "resume", "step", "abort", "nothing",
                            "reverse", "paused line"])  # fmt: skip
        if word in ("line", "lines"):
            for _ in range(1 if word == "line" else draw.randrange(2, 5)):
                x += draw.choice([4, 7, 10])
                script.append(f"line 50 {x} 0 0")
        elif word == "paused line":
            x += 5
            script += ["pause", f"line 50 {x} 0 0"]
        elif word == "reverse" and waits and not backward:
            continue  # LinuxCNC's own goes back: test_reverse tells what ours does
        elif word not in ("nothing", "reverse"):
            script.append(word)
        if word == "abort":
            script += [SETTLES, "clear"]
        script += [draw.choice(["run 1", "run 3", SETTLES]) if draw.random() < 0.2 else SETTLES,
                   "tell"]  # fmt: skip
    return [*script, "resume", "run 30000", "tell"]


def tells(run):
    """Return place and what is left to do behind every call."""
    return [(float(each[0]), each[5] + each[6]) for each in run.told("tell")]


def calls_failures(stand_in, seed):
    """Return what differs from LinuxCNC's own planner, in words."""
    script = settled(calls(seed))
    ours, own = (tells(stand_in.run(script, module=module)) for module in (None, OWN))
    pairs = enumerate(zip(ours, own, strict=True))
    wrong = [f"call {n}: {a} in place of {b}" for n, (a, b) in pairs
             if abs(a[0] - b[0]) > NEAR or a[1] != b[1]]  # fmt: skip
    return wrong + held(stand_in.run(script))


def settled(script):
    """Return the script with time to settle wherever something is told."""
    return [line for each in script for line in ([SETTLES, each] if each == "tell" else [each])]


# ---- stops: an operator, and limits, while it moves


def stops(seed):
    """Return a script, and where it ends."""
    draw = random.Random(seed)
    script = [draw.choice(["term 2 0.01", "term 1 0", "term 2 0.2"])]
    place = [0.0, 0.0, 0.0]
    for _ in range(draw.randrange(4, 14)):
        for _ in range(draw.randrange(0, 8)):
            size = draw.choice([0.05, 1, 10, 30])
            place = [min(max(x + draw.uniform(-size, size), -100), 100) for x in place]
            word = draw.choice(["line", "line", "rapid"])
            script.append(f"{word} {draw.choice([20, 50, 100])} {place[0]} {place[1]} {place[2]}")
            script += draw.choice([[], [], [f"run {draw.randrange(1, 30)}"]])
        wait = f"run {draw.choice([0, 1, 2, 5, 40, 300, 2000])}"
        script += [wait, *draw.choice([
            ["pause", wait, "resume"], ["pause", "still 20000", "reverse", wait, "resume", wait,
                                        "forward", "resume"],
            ["reverse", wait, "forward"], [*["reverse", "run 1"] * 20, "forward"],
            ["pause", wait, "step", wait, "step", wait, "resume"], ["step", wait, "resume"],
            ["pause", wait, "abort"], ["abort"], ["abort", "run 3", "pause", wait, "resume"],
            ["pause", wait, "feed 0", wait, "feed 1", "resume"], ["feedhold 1", wait, "feedhold 0"],
            [f"axis {draw.randrange(3)} {draw.choice([30, 60])} {draw.choice([300, 1000])}"],
            [f"soft 0 {place[0] - 60} {place[0] + 60}", wait, "soft 0 0 0"],
            [f"vlimit {draw.choice([3, 60, 1000])}"], ["wait"], [REST], ["pause", REST_OR_STILL,
                                                                         "resume"],
        ])]  # fmt: skip
        if "abort" in script[-4:] or any(line.startswith("soft") for line in script[-3:]):
            script += ["run 30", REST, "resume"]
    script += ["axis 0 100 1000", "axis 1 100 1000", "axis 2 100 1000"]
    return [*script, "feed 1", "vlimit 1000", "forward", "resume", REST, "line 50 1 2 3", REST]


REST_OR_STILL = "still 20000"


def stops_failures(stand_in, seed):
    """Return what is wrong after an operator on the move, in words."""
    script = stops(seed)
    run = stand_in.run(script)
    wrong = [each for each in held(run) if script[0] != "term 1 0" or "jerk" not in each]
    if ["-1"] in run.told("rest"):
        wrong.append("it stands for ever")
    if np.abs(run.places[-1] - [1, 2, 3]).max() > 1e-6:
        wrong.append(f"it ends at {run.places[-1]}")
    if run.log.count("reverse") > sum(line in ("reverse", "forward") for line in script):
        wrong.append("a message repeats")
    return wrong


# ---- feeds: G95 and G96


def feeds(seed):
    """Return a script, and its feed a revolution."""
    draw = random.Random(seed)
    lead = draw.choice([0.05, 0.1, 0.2, 0.5, 1])
    rps_s, facing = draw.choice([5, 20, 100]), draw.random() < 0.3
    top = min(60.0, 60.0 / lead)
    script = [draw.choice(["term 1 0", "term 2 0.01"]), f"sync {lead} 1"]
    x, way = 0.0, -1 if facing else 1
    if facing:
        x, rps = draw.uniform(2, 60), draw.uniform(0.2, 1) * top
        begin = rps * draw.uniform(0.1, 0.8)
        script += [f"setpos {x} 0 0", f"spindle {rps} {rps_s}", f"css {60 * begin * x} 0"]
    for _ in range(draw.randrange(1, 5)):
        if not facing:
            rps = draw.uniform(0.05, 1) * top
            script += [f"spindle {rps} {rps_s}", f"run {draw.choice([0, 1, 500])}"]
        for _ in range(draw.randrange(1, 4)):
            x += way * min(lead * rps * draw.uniform(0.2, 3), 0.3 * x if facing else np.inf)
            script += draw.choice([[], [], ["wait"]])
            script.append(f"line {lead} {x} 0 0")
            script += draw.choice([[], [], [f"run {draw.randrange(60)}"]])
        if draw.random() < 0.3 and not facing:
            script += [f"run {draw.randrange(900)}", f"spindle {rps * draw.uniform(0.6, 1.4)} 0"]
        script += [REST] if not facing else []
    return [*script, REST], lead


def feeds_failures(stand_in, seed):
    """Return what is wrong with feeds a revolution, in words: away from rests, at an even speed."""
    script, lead = feeds(seed)
    run = stand_in.run(script)
    v = np.abs(np.diff(run.places[:, 0])) / CYCLE_S
    rps = np.abs(np.diff(run.column("turns"))) / CYCLE_S
    wrong, n = held(run), int(STEADY / CYCLE_S)
    if len(v) <= n:
        return wrong
    # judged towards the end of a time in which tool and spindle change little
    late, windows = int(LATE_S / CYCLE_S), np.lib.stride_tricks.sliding_window_view
    slope = np.abs(rps[late:] - rps[:-late]) / np.maximum(rps[:-late], 1e-9) / LATE_S
    rate = windows(slope, n - late).max(axis=1)
    moves = windows(v, n).min(axis=1) > 0.8 * lead * windows(rps, n).min(axis=1)
    fastest = FASTEST["css" if any("css" in line for line in script) else ""]
    judged = np.flatnonzero((rate < fastest) & moves)
    at = judged + n - n // 8
    off = np.abs(v[at] / (lead * rps[at]) - 1) - rate[judged] * LATE_S
    if len(off) and off.max() > OFF:
        wrong.append(f"feed a revolution off by {100 * off.max():.2f} %")
    return wrong


# ---- threads


def threads(seed):
    """Return a script; the thread's nodes, their angles and its speed."""
    draw = random.Random(seed)
    rps, lead = draw.uniform(2, 20), draw.choice([0.5, 1, 1.5, 2])
    leads = [lead] if draw.random() < 0.4 else [lead, lead * draw.choice([0.5, 0.8, 1.25, 2])]
    nodes, turns = [np.zeros(3)], [0.0]
    script, known_s = [f"spindle {rps}", "run 100", f"sync {lead} 0"], 0.0
    count = draw.choice([1, 2, 3, 5, 20, 90])
    taper = draw.choice([0, 0, 0.05, 0.3])
    now, long = 0.0, draw.choice([0.4, 2, 6])
    for n in range(count):
        lead = draw.choice(leads)
        way = lead * draw.uniform(0.5, 1) * (long if n else 6)
        across = taper * draw.choice([1, 1, -0.5])
        end = nodes[-1] + way / np.hypot(1, taper) * np.array([across, 0, -1])
        script += [f"sync {lead} 0", "line 0 {} {} {}".format(*end)]
        turns.append(turns[-1] + np.linalg.norm(end - nodes[-1]) / lead)
        nodes.append(end)
        known_s = turns[-1] / rps
        late = draw.choice([0, 0, 1, 15, 40, 300])
        if now + late * CYCLE_S < known_s - LATEST_S:
            script.append(f"run {late}")
            now += late * CYCLE_S
    return [*script, "sync 0 0", REST], np.array(nodes), np.array(turns), rps


LATEST_S = 0.8  # a line has come so long before the tool is there, kinks of all sizes included


def threads_failures(stand_in, seed):
    """Return what is wrong with a thread, in words."""
    script, nodes, turns, rps = threads(seed)
    run = stand_in.run(script)
    wrong = held(run)
    if np.abs(run.places[-1] - nodes[-1]).max() > 1e-6:
        wrong.append(f"it ends at {run.places[-1]}")
    moves = np.abs(np.diff(run.places, axis=0)).max(axis=1) > 1e-9
    cut = slice(np.argmax(moves), len(moves) - np.argmax(moves[::-1]))
    z = run.places[1:][cut, 2]
    angle = run.column("turns")[1:][cut]
    seconds = len(z) * CYCLE_S - (turns[-1] / rps)
    if seconds > 2 * LATEST_S:
        wrong.append(f"it rests for {seconds:.2f} s")
    u = np.interp(-z, -nodes[:, 2], turns)
    margin = np.abs(u[:, None] - turns[None, :]).min(axis=1) > 0.45 * rps
    off = (angle - u)[margin]
    if len(off) and np.abs(off - np.round(off)).max() > 1e-5:
        wrong.append(f"off its helix by {np.abs(off - np.round(off)).max():.6f} turns")
    if len(off) and np.ptp(np.round(off)) > 0:
        wrong.append("it goes on a turn later")
    return wrong


# ---- lines of a thread that come late


def late(seed):
    """Return a script of lines shorter than a ramp, and where it ends."""
    draw = random.Random(seed)
    rps, lead = draw.uniform(4, 20), draw.choice([0.5, 1, 2])
    leads = [lead * draw.choice([0.5, 0.8, 1, 1.25, 2]) for _ in range(4)]
    z, long = -3 * lead, draw.choice([0.1, 0.2, 0.4, 0.7, 1])
    script = [f"spindle {rps}", "run 100", f"sync {lead} 0", f"line 0 0 0 {z}",
              f"run {draw.randrange(int(3000 / rps) + 100)}"]  # fmt: skip
    for _ in range(draw.randrange(5, 40)):
        lead, turns = draw.choice(leads), long * draw.uniform(0.6, 1)
        z -= turns * lead
        wait = f"run {draw.randrange(int(1400 * turns / rps) + 1)}"
        script += [f"sync {lead} 0", f"line 0 0 0 {z}", wait]
    return [*script, "sync 0 0", REST], z


def late_failures(stand_in, seed):
    """Return what is wrong with lines that are caught up with, in words."""
    script, z = late(seed)
    run = stand_in.run(script)
    ends = [] if abs(run.places[-1, 2] - z) < 1e-6 else [f"it ends at {run.places[-1]}"]
    return held(run) + ends


FAMILIES = {"calls": calls_failures, "stops": stops_failures, "feeds": feeds_failures,
            "threads": threads_failures, "late": late_failures}  # fmt: skip


def main():
    """Run the families that are asked for; 1 if one of them found something."""
    parser = argparse.ArgumentParser()
    parser.add_argument("family", nargs="*", default=list(FAMILIES))
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    found = 0
    with tempfile.TemporaryDirectory() as folder:
        stand_in = StandIn(folder)
        for family in asked.family:
            for seed in range(asked.seed, asked.seed + asked.count):
                if wrong := FAMILIES[family](stand_in, seed):
                    found += 1
                    print(family, seed, *wrong, sep="; ", flush=True)
            print(f"{family}: {asked.count} run, {found} wrong so far", flush=True)
    return int(found > 0)


if __name__ == "__main__":
    sys.exit(main())
