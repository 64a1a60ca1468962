# SPDX-License-Identifier: MIT
"""Room 1: G83 … G89 of Fanuc's lathes against what its manual says, written apart."""

import random

import pytest
from pytest import approx

from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

BACK = 0.254  # [mm] a peck's
KINDS = {lib.NCK_BLOCK_RAPID: "rapid", lib.NCK_BLOCK_LINE: "line", lib.NCK_BLOCK_DWELL: "rest",
         lib.NCK_BLOCK_TAP: "tap"}  # fmt: skip


def lathe(system):
    free = [f"axis.{axis}.{end}_mm=free" for axis in "xz" for end in ("min", "max")]
    zero = ["work.g54.z_mm=0", "start.z_mm=0", "start.x_mm=0", "home.g28.z_mm=0"]
    return Machine.load("lathe_fanuc", set=[*free, *zero, f"dialect.system={system}"])


class Drilling:
    """One program: holes along Z or X, as system A, B or C says them; `deeds` is what is to come.

    A deed is (kind, X as a radius, Z, feed, dwell); [0]: X, [1]: Z.
    """

    def __init__(self, seed):
        self.pen = random.Random(seed)
        self.system = self.pen.choice("ABC")
        self.steps = self.system != "A" and self.pen.random() < 0.3
        self.to_r = self.system != "A" and self.pen.random() < 0.5
        self.side = self.pen.random() < 0.4
        self.at, self.deeds = [60.0, 40.0], []
        self.feed = "G95" if self.system != "A" else "G99"
        self.inches = "G71" if self.system == "C" else "G21"
        self.lines = [f"{self.inches} {self.feed} S500 M3", "G0 X120. Z40."]
        if self.system != "A":
            self.lines += ["G99" if self.to_r else "G98"]

    def go(self, kind, axis, place, feed=0.0):
        if kind == "rapid" and self.at[axis] == approx(place, abs=1e-9):
            return
        self.at[axis] = place
        self.deeds.append((kind, *self.at, feed, 0.0))

    def word(self, axis, place):
        """Return the word of a place of an axis, as a step under G91."""
        place = place - self.at[axis] if self.steps else place
        return f"{'XZ'[axis]}{place * (2 if axis == 0 else 1):.4f}"

    def cycle(self):
        """A code with its words, then lines that name another hole only."""
        pen, drill = self.pen, 0 if self.side else 1
        kind = pen.choice(["drill", "peck", "bore", "tap"])
        code = {"drill": 83, "peck": 83, "bore": 85, "tap": 84}[kind] + 4 * self.side
        initial = self.at[drill]
        clear = round(pen.uniform(1, 9), 3) if pen.random() < 0.7 else 0.0
        deep = round(pen.uniform(5, 30), 3)
        peck = round(pen.uniform(1, 12), 3) if kind == "peck" else 1e9
        rest = pen.choice([0, 0.2, 0.35])
        feed = round(pen.uniform(0.05, 1.5), 3)
        level, bottom = initial - clear, initial - clear - deep
        if self.steps:
            self.lines.append("G91")
        words = [f"G{code}"]
        if self.steps:
            words += [f"R{-clear:.4f}", f"{'XZ'[drill]}{-deep * (2 if drill == 0 else 1):.4f}"]
        else:
            words += [f"R{(-clear if self.system == 'A' else level):.4f}"] if clear else []
            words += [self.word(drill, bottom)]
        words += [f"Q{peck:.4f}"] if kind == "peck" else []
        words += [f"P{round(1000 * rest)}"] if rest and kind != "tap" else []
        words += [f"F{feed:.4f}"]
        for k in range(pen.randint(1, 3)):
            place = round(pen.uniform(5, 50), 3)
            hole = self.word(1 - drill, place)
            self.lines.append(" ".join([*words, hole] if k == 0 else [hole]))
            self.go("rapid", 1 - drill, place)
            self.hole(kind, drill, (initial, level, bottom), (peck, rest, feed))
        self.lines += ["G90 G80" if self.steps else "G80"]

    def hole(self, kind, drill, levels, rest_of_it):
        initial, level, bottom = levels
        peck, rest, feed = rest_of_it
        # A hole behind another one that ended on R begins there.
        self.go("rapid", drill, level)
        cut = level
        while kind != "tap" and cut > bottom:
            cut = max(bottom, round(cut - peck, 6))
            self.go("line", drill, cut, feed)
            if cut > bottom:
                self.go("rapid", drill, min(level, cut + BACK))
        if kind == "tap":
            self.deeds.append(("tap", *self.at, 0.0, 0.0))
        elif rest:
            self.deeds.append(("rest", *self.at, 0.0, rest))
        if kind == "bore":
            self.go("line", drill, level, 2 * feed)
        self.go("rapid", drill, level if self.to_r else initial)

    def text(self):
        for _ in range(self.pen.randint(1, 4)):
            self.cycle()
            self.at = [60.0, 40.0]
            self.lines.append("G0 X120. Z40.")
            self.deeds.append(("rapid", *self.at, 0.0, 0.0))
        return "\n".join([*self.lines, "M30", ""])


def deeds(blocks):
    for block in blocks:
        if kind := KINDS.get(block["kind"]):
            feed = float(block["feed"]) if kind == "line" else 0.0
            x, _, z = (block["target_nm"][:3] / 1e6).tolist()
            yield kind, x, z, feed, float(block["dwell_s"]) if kind == "rest" else 0.0


@pytest.mark.parametrize("first", range(0, 400, 50))
@pytest.mark.sample(2)
def test_lathes_drill_as_the_manual_says(first):
    for seed in range(first, first + 50):
        drilling = Drilling(seed)
        text = drilling.text()
        blocks, found = stages.decode(text.encode(), lathe(drilling.system))
        errors = [(status_id(int(each["code"])), int(each["line"])) for each in found
                  if each["code"] < 0]  # fmt: skip
        assert errors == [], f"seed {seed}\n{text}"
        ours = list(deeds(blocks))[1:]
        assert [each[0] for each in ours] == [each[0] for each in drilling.deeds], f"seed {seed}"
        for mine, theirs in zip(ours, drilling.deeds, strict=True):
            assert mine[1:] == approx(theirs[1:], abs=2e-4), f"seed {seed}\n{text}"


@pytest.mark.parametrize(
    ("line", "name"),
    [
        ("G83 Z-9. R2. F.1", "number-range"),  # a place: Haas' lathes
        ("G83 W-9. R-2. F.1", "incremental"), ("G87 U-9. R-2. F.1", "incremental"),
        ("G83 R-2. F.1", "word-missing"), ("G83 Z9. R-2. F.1", "number-range"),
        ("G83 Z-9. R-2. Q0. F.1", "number-range"), ("G83 Z-9. R-2. Q5000 F.1", "scale-unit"),
        ("G81 Z-9. R-2. F.1", "unsupported"), ("G82 Z-9. R-2. F.1", "unsupported"),
        ("G86 Z-9. R-2. F.1", "unsupported"), ("G85 Z-9. Q1. F.1", "word-unused"),
    ],
)  # fmt: skip
def test_what_a_lathe_cannot_drill_is_refused_and_moves_nothing(line, name):
    text = f"G21 G99 S500 M3\nG0 X20. Z5.\n{line}\nM30\n"
    blocks, found = stages.decode(text.encode(), lathe("A"))
    assert [status_id(int(each["code"])) for each in found if each["code"] < 0] == [name]
    assert blocks[blocks["line"] == 3]["kind"].tolist() == []
