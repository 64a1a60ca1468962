# SPDX-License-Identifier: MIT
"""Programs whose begin nobody knows: what they need, by a count of its own, and every line."""

import random
from typing import NamedTuple

import pytest
from command_line import pycnc
from test_zero import ROUTER

from pycnc.kernel.bind import lib
from pycnc.machine import Machine
from pycnc.program import load

ROOM = 200  # mm, of each axis
WORDS = {"G0": "rapid", "G1": "cut", "G2": "cut"}


class Told(NamedTuple):
    """A program, and by axis what it needs."""

    text: str
    needs: list  # (low, high), its zero with it where it is counted
    is_free: list  # whether it may begin anywhere
    cut_mm: float  # length of its straight cuts


def _machine():
    ends = [-ROOM, 0, -ROOM // 2, ROOM // 2, 0, ROOM]
    return Machine.from_text(ROUTER.format(*ends), name="router")


class Writer:
    """Moves of one axis or more, absolute or by a distance, near or far from the zero."""

    def __init__(self, seed):
        self.pen = random.Random(seed)
        self.at, self.hangs = [0.0] * 3, [True] * 3  # whether a place hangs on the begin
        self.known = [[] for _ in "xyz"]  # places that do not
        self.first, self.off = [None] * 3, [False] * 3  # off: a place beside the begin that does
        self.rows, self.cut_mm = ["G17 G21 G90 G94 F900"], 0.0
        self.base = [self.pen.choice([0, 0, 0, 150, -170, 400, -900]) for _ in "xyz"]
        self.spread = self.pen.choice([5, 40, 90, 130])

    def move(self):
        """Write a move."""
        code = self.pen.choice(["G0", "G0", "G1", "G1"])
        axes = self.pen.sample(range(3), self.pen.randrange(1, 4))
        by_distance = self.pen.random() < 0.15
        words, before = [], list(self.at)
        for k in axes:
            value = self.pen.randrange(1, self.spread) * self.pen.choice([-1, 1]) + 0.25
            to = self.at[k] + value if by_distance else self.base[k] + value
            if to == self.at[k]:
                to += 1
            self.first[k] = self.first[k] or WORDS[code]
            words.append(f"{'XYZ'[k]}{to - self.at[k] if by_distance else to:.3f}")
            self.at[k] = to
            self.hangs[k] &= by_distance
        for k in range(3):
            if self.hangs[k]:
                self.off[k] |= self.at[k] != 0
            self.known[k].append((self.at[k], self.hangs[k]))
        if code == "G1":
            steps = ((a - b) ** 2 for a, b in zip(self.at, before, strict=True))
            self.cut_mm += sum(steps) ** 0.5
        self.rows.append(f"{'G91' if by_distance else 'G90'} {code} {' '.join(words)}")

    def told(self):
        """Return what was written, and what it needs."""
        needs, is_free = [], []
        for k in range(3):
            every = [place for place, _ in self.known[k]]
            low, high = min(every), max(every)
            own = [place for place, hangs in self.known[k] if not hangs]
            wide = max(high, 0) - min(low, 0) > ROOM
            free = bool(wide and own and self.first[k] == "rapid" and not self.off[k])
            if free:
                low, high = min(own), max(own)
            elif self.first[k] == "cut" or (wide and high - low <= ROOM):
                low, high = min(low, 0), max(high, 0)
            needs.append((low, high))
            is_free.append(free)
        return Told("\n".join([*self.rows, "M2", ""]), needs, is_free, self.cut_mm)


def written(seed):
    """Return a random program, as `Told`."""
    writer = Writer(seed)
    for _ in range(writer.pen.randrange(1, 9)):
        writer.move()
    return writer.told()


def _cut_mm(program):
    lines = program.blocks["kind"] == lib.NCK_BLOCK_LINE
    steps = program.moves.end[lines] - program.moves.start[lines]
    return float(((steps**2).sum(axis=1) ** 0.5).sum())


@pytest.mark.sample(150)
@pytest.mark.parametrize("number", range(2000))
def test_nothing_is_shortened_and_all_that_is_needed_is_counted(number, draw_seed):
    told = written(draw_seed + number)
    program = load(told.text, _machine())
    sizes = [high - low for low, high in told.needs]
    fits = max(sizes) <= ROOM
    found = [each for each in program.diagnostics if each.severity == "error"]
    assert program.diagnostics.errors == (not fits), found
    (said,) = [each for each in program.diagnostics if each.id in ("travel", "work-zero")]
    assert f"needs {' × '.join(f'{round(size, 2):g}' for size in sizes)} mm" in said.message
    assert _cut_mm(program) == pytest.approx(told.cut_mm, abs=1e-3)
    if not fits:
        assert said.line and said.help
        return
    assert (" begins neither" in said.message) == any(told.is_free)
    for k, (low, high) in enumerate(program.bounds.values()):
        assert program.machine.settings.axis.present()["xyz"[k]].min_mm <= low
        assert high <= program.machine.settings.axis.present()["xyz"[k]].max_mm


VERBS = ("time", "why", "run", "report", "plot", "compare", "sweep", "check")


def _called(verb, file, machine, line, folder):
    """Return the result of a verb that begins at a line."""
    begin = ("--set", f"dialect.from_line={line}")
    options = {
        "report": ("-o", folder / "x.html", *begin), "plot": ("-o", folder / "x.png", *begin),
        "compare": (file, *begin), "sweep": begin, "why": begin,
    }.get(verb, ("--from-line", line))  # fmt: skip
    return pycnc(verb, file, *options, "-m", machine)


@pytest.mark.sample(24, quick=4)
@pytest.mark.parametrize("zero", ["unknown", "told"])
@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize("number", range(6))
def test_a_program_begins_at_every_line_or_says_why_not(number, verb, zero, draw_seed, tmp_path):
    text = written(draw_seed + number).text.replace("G91", "G90")
    file, machine = tmp_path / "part.nc", tmp_path / "router.toml"
    file.write_text(text)
    machine.write_text(_machine().text.replace("unknown", zero))
    for line in range(1, len(text.splitlines()) + 3):
        told = _called(verb, file, machine, line, tmp_path)
        said = told.out + told.err
        assert "Traceback" not in said and "error[internal]" not in said, (line, said)
        if "error[empty]" in said:  # a picture of a program that stays where it is
            assert verb in ("report", "plot") and told.code == 2, (line, said)
            continue
        assert told.code in (0, 1), (line, said)
        assert (told.code == 1) == ("error[" in said), (line, said)
        if zero == "unknown":
            assert said.count("error[") <= 1 + (verb == "sweep"), (line, said)
