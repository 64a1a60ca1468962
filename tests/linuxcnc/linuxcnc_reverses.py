# SPDX-License-Identifier: MIT
"""Programs that are run to and fro by adaptive feed, at random by seed (linuxcnc_calls.py runs it).

The way back is within the tolerance of what is programmed, and within the axes' limits; outputs
are said once.
"""

import random

import numpy as np
from linuxcnc_held import held, words_of
from linuxcnc_stand_in import EVER
from polylines import distance

REST = f"rest {EVER}"


class Reverses:
    """A program whose way is known, run to and fro."""

    def __init__(self, seed):
        self.draw = random.Random(seed)
        self.p = self.draw.choice([0, 0.01, 0.1])
        self.path = [np.zeros(3)]  # the programmed way, as a polyline
        self.outputs = 0

    def all(self):
        """Return the script; behind it all is done, forward."""
        draw = self.draw
        script = [f"term {2 if self.p else 1} {self.p}"]
        if draw.random() < 0.3:
            script.append("caps 30 1000")
        for _ in range(draw.randrange(1, 4)):
            for _ in range(draw.randrange(1, 5)):
                script += self.moves()
            script.append(f"run {draw.choice([30, 300, 1000, 3000])}")
            for _ in range(draw.randrange(2, 7)):
                script += [*self.act(), f"run {draw.choice([30, 200, 600, 2000])}"]
        return [*script, "resume", "adaptive 1", "run 400", "adaptive 1", REST, "tell"]

    def act(self):
        """Return what an operator does."""
        draw = self.draw
        turns = f"adaptive {draw.choice([-1, -0.5, -0.2, 1, 1])}"
        return draw.choice([[turns], [turns], [turns], ["pause", "run 300", turns, "resume"],
                            ["pause", "run 50", "step"], ["feed 0.5"], ["feed 1.2"], ["adaptive 0"],
                            ["axis 0 60 500"], ["resume"]])  # fmt: skip

    def moves(self):
        """Return the script of some moves of one kind."""
        draw, kind = self.draw, self.draw.choice(["line", "line", "chords", "arc", "rapid", "word"])
        if kind == "word":
            self.outputs += 1
            return [draw.choice([f"dout {self.outputs % 8} 1", f"aout {self.outputs % 8} 1"]),
                    "wait", *self.line("line 60", 3)]  # fmt: skip
        if kind == "chords":
            turn = draw.uniform(-0.3, 0.3)
            return [each for n in range(draw.randrange(10, 120)) for each in
                    self.line("line 80", 0.2, [np.cos(turn * n), np.sin(turn * n), 0.1])]
        if kind == "arc":
            return self.arc()
        word = "rapid 100" if kind == "rapid" else f"line {draw.choice([20, 50, 100])}"
        return self.line(word, draw.choice([0.5, 3, 20]))

    def line(self, word, size, way=None):
        """Return a straight move."""
        way = [self.draw.uniform(-1, 1) for _ in range(3)] if way is None else way
        self.path.append(np.round(self.path[-1] + size * np.array(way), 4))
        return [f"{word} {words_of(*self.path[-1])}"]

    def arc(self):
        """Return part of a circle or helix about one of the axes."""
        draw, axis = self.draw, self.draw.randrange(3)
        begin, radius = self.path[-1], draw.choice([1, 5])
        turns, pitch = draw.choice([0.5, 1, 2.5, -0.5, -1.5]), draw.choice([0, 1])
        t = np.linspace(0, 2 * np.pi * turns, 2 + int(700 * abs(turns)))
        along, u, v = (np.roll([0.0, 0, 1], k + axis + 1) for k in range(3))
        centre = begin + radius * u
        way = [centre - radius * (np.cos(x) * u + np.sin(x) * v) + pitch * along * x / t[-1]
               for x in t]  # fmt: skip
        self.path += [*way[1:-1], np.round(way[-1], 4)]
        whole = abs(turns) - 0.5 if turns % 1 else abs(turns) - 1
        turn = int(whole) if turns > 0 else -1 - int(whole)
        centre_axis = f"{words_of(*centre)} {words_of(*along)} {turn}"
        return [f"arc 50 {words_of(*self.path[-1])} 0 0 0 0 0 0 {centre_axis}"]


def reverses_failures(stand_in, seed):
    """Return what is wrong with a program that is run to and fro, in words."""
    program = Reverses(seed)
    script = program.all()
    run = stand_in.run(script)
    wrong = [each for each in held(run) if program.p or "jerk" not in each]
    if ["-1"] in run.told("rest"):
        wrong.append("it stands for ever")
    path = np.array(program.path)
    if np.abs(run.places[-1] - path[-1]).max() > 2e-6:
        wrong.append(f"it ends at {run.places[-1]} in place of {path[-1]}")
    away = distance(run.places[::9], path)
    if away > max(program.p, 2e-3) + 2e-4:
        wrong.append(f"off its way by {away:.4f}")
    said = len(run.told("dout") + run.told("aout"))
    if said != program.outputs:
        wrong.append(f"{said} outputs in place of {program.outputs}")
    return wrong
