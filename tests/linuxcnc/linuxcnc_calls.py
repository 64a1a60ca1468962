# SPDX-License-Identifier: MIT
"""Calls that a host makes of the planner module, at random by seed, and what they have to bring.

    .venv/bin/python tests/linuxcnc/linuxcnc_calls.py [FAMILY … ] [--count N] [--seed FIRST]

Families: `calls` (an operator at rest, beside LinuxCNC's own planner), `stops` (one on the move),
`feeds` (G95, G96 while the spindle changes its speed), `threads` (lines with leads of their own
that come when they come), `late` (short ones that come when the tool is nearly there, or is) and
`reverses` (a program that is run to and fro by adaptive feed).
"""

import argparse
import random
import sys
import tempfile
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))

import numpy as np
from linuxcnc_held import ROUNDING, held, words_of
from linuxcnc_reverses import reverses_failures
from linuxcnc_stand_in import CYCLE_S, EVER, OWN, StandIn

NEAR = 0.02  # LinuxCNC's own planner goes on into the next move before it hears a pause [mm]
OFF = 5e-3  # of a feed a revolution
STEADY = 0.8  # for so long, before it is judged, tool and spindle have changed little [s], …
FASTEST = {"css": 0.25, "": 0.1}  # … the spindle by no more than this share a second
LATE_S = 0.05  # and for so long its change may not be heard [s]
ASKED_LATE_S = 0.1  # nor what G96 asks for, of a spindle that has not got it [s]
HAS = 0.98  # of what it asks for
REST = f"rest {EVER}"
BY_HAND = "enables 9"  # no adaptive feed, which has a direction of its own
SETTLES = f"settled {EVER}"


# ---- calls: each at rest, so that both planners are at the same place behind it


class Calls:
    """A host whose calls are drawn; each lets the machine settle, and asks where it is.

    What differs on purpose is not among them: test_linuxcnc_differences.py has it. Where a probe
    stops is not compared, for that hangs on jerk, nor where a hold on the move does.
    """

    MOVES = ("line", "lines", "rapid", "same", "arc", "tap", "thread", "revolution")
    OTHERS = ("spindle", "at speed", "output", "resume", "forward", "abort", "scale", "hold",
              "vlimit", "enables", "term", "limits", "nothing")  # fmt: skip
    AT_RESTS = ("pause", "paused line", "step", "probe", "to and fro")
    TERMS = (("term 0 0", "term 1 0"), ("term 1 0", "term 2 0", "term 2 0.05"))

    def __init__(self, seed):
        self.draw = random.Random(seed)
        self.place = [0.0, 0.0, 0.0]
        self.script = ["term 1 0", "spindle 10 0"]
        self.holds, self.outputs = set(), False
        self.turns = self.at_speed = True
        self.waits = False  # a move that the spindle leads waits for it
        self.moved = 0  # lines of the script up to the last move
        self.blends = self.draw.random() < 0.4

    def all(self):
        """Return the script, behind whose last call nothing is held and all is done."""
        for _ in range(self.draw.randrange(6, 24)):
            led = not self.holds and not self.outputs
            others = self.OTHERS + (() if self.blends else self.AT_RESTS)
            self.call(self.draw.choice(self.MOVES[: None if led else -3] + others))
            self.script.append(self.draw.choice(["run 1", "run 3", SETTLES]))
            self.script += [SETTLES, "tell"]
        ends = ["feed 1", "rapids 1", "adaptive 1", "feedhold 0", "vlimit 1000", "enables 7",
                "spindle 10 0", "atspeed 1", "resume"]  # fmt: skip
        return [*self.script, *ends, SETTLES, "tell"]

    def call(self, word):
        """Make one call, or those that belong together."""
        draw, script = self.draw, self.script
        if word in self.MOVES:
            self.move(word)
        elif word == "spindle":
            rps = draw.choice([0, 5, 10, 10])
            script.append(f"spindle {rps} 0")
            self.lead(turns=rps > 0, at_speed=self.at_speed)
        elif word == "at speed":
            script.append(draw.choice(["atspeed 1"] if self.holds or self.outputs else
                                      ["wait", "atspeed 0", "atspeed 1"]))  # fmt: skip
            self.lead(turns=self.turns, at_speed={"atspeed 0": False, "atspeed 1": True}.get(
                script[-1], self.at_speed))  # fmt: skip
        elif word == "output" and not self.holds:
            kind = draw.choice(["dout", "aout"])
            script.append(f"{kind} {draw.randrange(4)} {draw.randrange(2)}")
            self.outputs = True
        elif word == "paused line":
            self.hold("pause", held=True)
            self.move("line")
        elif word in ("probe", "to and fro") and not (self.holds or self.waits or self.outputs):
            (self.probe if word == "probe" else self.to_and_fro)()
        elif word in ("pause", "resume"):
            self.hold(word, held=word == "pause", name="pause")
        elif word == "abort":
            self.abort()
        elif word == "scale":
            name, share = draw.choice(["feed", "rapids", "adaptive"]), draw.choice([0, 0.5, 1, 1])
            self.hold(f"{name} {share}", held=share == 0, name=name)
        elif word == "hold":
            on = draw.randrange(2)
            self.hold(f"feedhold {on}", held=on == 1, name=word)
        elif word == "vlimit":
            most = draw.choice([0, 30, 1000])
            self.hold(f"vlimit {most}", held=most == 0, name=word)
        elif word == "enables":
            script.append(f"enables {draw.choice([0, 1, 5, 7])}")
        elif word == "term":
            script.append(draw.choice(self.TERMS[self.blends]))
        elif word == "limits":
            most = f"{draw.choice([30, 100])} {draw.choice([300, 1000])}"
            script.append(f"axis {draw.randrange(3)} {most}")
        elif word in ("step", "forward"):
            script.append(word)

    def probe(self):
        """Move until something is touched, and on from where that was."""
        self.move("lines")
        self.script += [f"run {self.draw.randrange(1, 300)}", "abort", SETTLES]
        self.place[0] += 0.5  # the last move may have been done
        self.script.append(f"line 50 {words_of(*self.place)}")

    def to_and_fro(self):
        """Some moves, back over them from somewhere, and forward again."""
        self.script += [BY_HAND, "pause"]
        self.move("lines")
        self.script += [SETTLES, "resume", f"run {self.draw.randrange(1, 60)}", "pause", SETTLES,
                        "reverse", "resume", SETTLES, "tell", "pause", "forward", "resume", SETTLES,
                        "enables 13"]  # fmt: skip

    def lead(self, *, turns, at_speed):
        """Let the spindle turn, or say that it has its speed."""
        self.turns, self.at_speed = turns, at_speed
        self.waits &= not (turns and at_speed)

    def hold(self, call, *, held, name="pause"):
        """Hold, or end a hold."""
        if held and (self.waits or "wait" in self.script[self.moved:]):
            return
        self.script.append(call)
        (self.holds.add if held else self.holds.discard)(name)

    def abort(self):
        """Abort, as LinuxCNC does it; from another place at times."""
        self.script += ["abort", SETTLES, "tell", SETTLES, "clear", self.TERMS[0][1]]
        self.holds.discard("pause")
        self.outputs = self.waits = False
        if self.draw.random() < 0.3:
            self.place = [self.draw.uniform(-9, 9) for _ in self.place]
            self.script.append(f"setpos {words_of(*self.place)}")

    def move(self, word):
        """Ask for one move, or a few."""
        draw = self.draw
        if word in ("line", "lines", "rapid"):
            for _ in range(draw.randrange(2, 5) if word == "lines" else 1):
                for k in draw.sample(range(3), draw.randrange(1, 4)):
                    self.place[k] += draw.choice([-7, -3, -1, 0.5, 2, 6])
                kind = "rapid 100" if word == "rapid" else f"line {draw.choice([20, 50, 100])}"
                self.script.append(f"{kind} {words_of(*self.place)}")
        elif word == "same" and not self.outputs:
            self.script.append(f"line 50 {words_of(*self.place)}")
        elif word == "arc":
            self.arc()
        elif word == "tap":
            hole = [*self.place[:2], self.place[2] - draw.choice([1, 3])]
            self.led(0.5, 0, f"tap 50 {words_of(*hole)} 0 0 0 0 0 0 1")
        elif word != "same":
            self.place[2] -= draw.choice([1, 3])
            lead = draw.choice([0.25, 0.5])
            self.led(lead, int(word == "revolution"), f"line 50 {words_of(*self.place)}")
        self.outputs &= word == "same"
        self.moved = len(self.script)

    def led(self, lead, mode, move):
        """Ask for a move that the spindle leads."""
        self.script += [f"sync {lead} {mode}", move, "sync 0 0"]
        self.waits |= not (self.turns and self.at_speed)

    def arc(self):
        """Ask for half of a circle in any plane, a helix at times, or more than a turn."""
        draw, axis = self.draw, self.draw.randrange(3)
        u, radius = (axis + 1) % 3, self.draw.choice([0.5, 2, 4])
        centre = list(self.place)
        centre[u] += radius
        self.place[u] += 2 * radius
        self.place[axis] += draw.choice([0, 0, 2, -1])
        normal = [float(k == axis) for k in range(3)]
        end, others = words_of(*self.place), "0 0 0 0 0 0"
        around = f"{words_of(*centre)} {words_of(*normal)} {draw.choice([0, 0, -1, 1])}"
        self.script.append(f"arc 50 {end} {others} {around}")


def tells(run):
    """Return where it is behind every call, and whether something is left to do."""
    told = ((np.array(each[:3], float), dict(zip(each[3::2], each[4::2], strict=True)))
            for each in run.told("tell"))  # fmt: skip
    return [(place, flags["done"], flags["depth"] != "0", flags["full"]) for place, flags in told]


def order(run):
    """Return what was handed over in which order: answers, moves on the way, outputs."""
    ids = run.column("id")[run.column("speed") > 0]
    way = [int(ids[n]) for n in np.flatnonzero(np.diff(ids, prepend=-1)) if ids[n]]
    outputs = sorted({(word, *each[:2]) for word in ("dout", "aout") for each in run.told(word)})
    return run.told("move"), way, outputs


def calls_failures(stand_in, seed):
    """Return what differs from LinuxCNC's own planner, in words."""
    calls = Calls(seed)
    script = calls.all()
    runs = [stand_in.run(script, module=module) for module in (OWN, None)]
    pairs = enumerate(zip(*map(tells, runs), strict=True))
    wrong = [f"call {n}: {ours} in place of {own}" for n, (own, ours) in pairs
             if np.abs(ours[0] - own[0]).max() > NEAR or ours[1:] != own[1:]]  # fmt: skip
    own, ours = map(order, runs)
    # blends take moves over; a move that waits behind a step has begun, and is aborted; where a
    # hold on the move ends hangs on jerk
    ways = not calls.blends and "abort" not in script and "reverse" not in script
    told = zip(ours, own, (True, ways, True), strict=True)
    wrong += [f"{a} in place of {b}" for a, b, judged in told if judged and a != b]
    free = not any(line.startswith(("setpos", "sync")) for line in script)  # jumps; is led
    exact = "jerk"  # at junctions of an exact path a step of acceleration is allowed
    return wrong + [each for each in held(runs[1]) if free and exact not in each]


# ---- stops: an operator, and limits, while it moves

REST_OR_STILL = "still 20000"
FORWARD = ["pause", REST_OR_STILL, "forward", "resume"]  # who moves does not turn


def stops(seed):
    """Return a script, and where it ends."""
    draw = random.Random(seed)
    script = [draw.choice(["term 2 0.01", "term 1 0", "term 2 0.2"]), BY_HAND]
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
                                        *FORWARD],
            ["reverse", wait, *FORWARD], [*["reverse", "run 1"] * 20, *FORWARD],
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
    return [*script, "feed 1", "vlimit 1000", *FORWARD, REST, "line 50 1 2 3", REST]


def stops_failures(stand_in, seed):
    """Return what is wrong after an operator on the move, in words."""
    script = stops(seed)
    run = stand_in.run(script)
    wrong = [each for each in held(run) if script[0] != "term 1 0" or "jerk" not in each]
    if ["-1"] in run.told("rest"):
        wrong.append("it stands for ever")
    if np.abs(run.places[-1] - [1, 2, 3]).max() > 1e-6:
        wrong.append(f"it ends at {run.places[-1]}")
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


def behind(run, script, v, rps):
    """Return by which share a second what G96 asks for changes where the spindle falls behind."""
    words = (line.split() for line in script)
    asked = {word: float(rest[0]) for word, *rest in words if word in ("spindle", "css")}
    if "css" not in asked:
        return np.zeros(len(v))
    x = np.maximum(np.abs(run.places[1:, 0]), 1e-9)
    told = np.minimum(asked["css"] / 60 / x, asked["spindle"])
    return np.where(rps < HAS * told, v / x, 0.0)


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
    off -= behind(run, script, v, rps)[at] * ASKED_LATE_S
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
            "threads": threads_failures, "late": late_failures,
            "reverses": reverses_failures}  # fmt: skip


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
