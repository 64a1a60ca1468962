# SPDX-License-Identifier: MIT
"""Random programs with canned cycles, as RS274NGC has them."""

import random

AXES = {17: "XYZ", 18: "ZXY", 19: "YZX"}  # of the plane, and of the drill
CODES = ("G73", "G81", "G82", "G83", "G85", "G86", "G89")
TIMED, PECKED = ("G82", "G86", "G89"), ("G73", "G83")
SYSTEMS = "G54 G55 G56 G57 G58 G59 G59.1 G59.2 G59.3".split()


class Writer:
    """Writes one program; where rs274 goes on purpose another way, it does not go.

    Not written: an R or a depth that holds over a change of units or of the plane, a peck that is
    no longer than the clearance, a depth that is a whole number of pecks but for rounding, and a
    line without a place behind which the drill would rise and go down again where it stands.
    """

    def __init__(self, seed):
        self.source = random.Random(seed)
        self.plane, self.inch, self.steps, self.to_r = 17, False, False, False
        self.code = ""  # of the cycle in force
        self.fresh = True  # R and depth are to be said
        self.high = False  # the drill stands where G98 has left it
        self.lines = ["G21 G17 G90 G94 G98 F600", "S1000 M3", "T2 M6", "G0 Z30", "S900 M3"]

    def number(self, low, high):
        """Return a number in the units in force; low and high are in mm."""
        scale = 25.4 if self.inch else 1.0
        return f"{self.source.uniform(low / scale, high / scale):.{self.source.randint(3, 6)}f}"

    def place(self, most=2):
        u, v, _ = AXES[self.plane]
        letters = self.source.sample([u, v], self.source.randint(1, most))
        return [letter + self.number(-50, 50) for letter in letters]

    def heights(self):
        drill = AXES[self.plane][2]
        below = self.steps and self.source.random() < 0.3
        self.fresh = below  # such an R would be too deep as an absolute one
        return ["R" + self.number(-20 if below else 0, -1 if below else 9),
                drill + self.number(-20, -0.1)]

    def hole(self):
        """A line of a cycle: a code with all that it needs, or a part of it."""
        begins = not self.code or self.source.random() < 0.3
        code = self.source.choice(CODES) if begins else self.code
        full = self.fresh or code != self.code
        words = [code] if begins else []
        if self.source.random() < 0.2:
            words.append(self.retract())
        always = full or begins or not (self.high or self.to_r)
        if always or self.source.random() < 0.8:
            words += self.place()
        if full or self.source.random() < 0.3 or not any(word[0] in "XYZ" for word in words):
            words += self.heights()
        if code in TIMED and (full or self.source.random() < 0.2):
            words.append(f"P{self.source.choice(['0', '0.5', '.25'])}")
        if code in PECKED and (full or self.source.random() < 0.2):
            words.append("Q" + self.number(0.3, 9))
        if self.source.random() < 0.3:
            words.append(f"L{self.source.randint(1, 4)}")
        self.code, self.high = code, not self.to_r
        self.source.shuffle(words)
        self.lines += ["(cycle)", " ".join(words), "(plain)"]

    def retract(self):
        self.to_r = self.source.random() < 0.5
        return "G99" if self.to_r else "G98"

    def leave(self):
        """A straight move, along the plane or along the drill, or G80 before a change."""
        self.code, self.high = "", False
        drill = AXES[self.plane][2] + self.number(-5, 40)
        move = self.source.choice([[drill], self.place()])
        if self.source.random() < 0.3:
            self.length(self.source.choice(["G43 H2", "G49"]))
        self.lines.append(f"G{self.source.randint(0, 1)} {' '.join(move)}")

    def length(self, code):
        self.lines.append(f"G0 {code} Z{self.number(0, 40)}")

    def change(self):
        """Something between two lines of a cycle."""
        self.high = False
        _, _, drill = AXES[self.plane]
        place = " ".join(self.place())
        self.lines.append(self.source.choice([
            f"G92 {drill}{self.number(-5, 30)}", f"G92 {place}", "G92.1", f"G28 {place}",
            f"G28 {drill}{self.number(-5, 30)}", f"G30 {place}", self.source.choice(SYSTEMS),
            f"G10 L2 P{self.source.randint(1, 9)} {place} {drill}{self.number(-5, 5)}",
            "G4 P0.5", "G4 P1 G80", "M4", "M3", "G61", "G64 P0.1", "S500",
        ]))  # fmt: skip
        if "G80" in self.lines[-1]:
            self.code = ""

    def mode(self):
        kind = self.source.randint(0, 4)
        if kind <= 1:
            self.steps = self.source.random() < 0.5
            self.lines.append("G91" if self.steps else "G90")
        elif kind == 2:
            self.plane = self.source.choice([17, 18, 19])
            self.lines += ["G80", f"G{self.plane}"]
            self.code, self.fresh = "", True
        elif kind == 3:
            feed = self.source.randint(5, 500)
            self.length("G49")  # rs274 does not convert it
            self.inch = self.source.random() < 0.5
            self.lines += ["G80", "G20" if self.inch else "G21", f"F{feed}"]
            self.code, self.fresh = "", True
        else:
            self.lines.append(self.retract())

    def spell(self, line):
        kind = self.source.randint(0, 5)
        if line[0] == "(" or kind > 3:
            return line
        if kind == 0:
            return line.lower()
        if kind == 1:
            return line.replace(" ", "")
        if kind == 2:
            return f"N{self.source.randint(1, 9999)} {line}"
        return line + " (a hole R1 L2)"

    def program(self):
        for _ in range(40):
            kind = self.source.randint(0, 9)
            step = self.hole if kind <= 5 else (self.leave, self.change, self.mode)[kind % 3]
            step()
        return "\n".join([self.spell(line) for line in self.lines] + ["M2", ""]).encode()


def program(seed):
    """Return a random program."""
    return Writer(seed).program()
