# SPDX-License-Identifier: MIT
"""Families of programs that are entered in the middle, by seed: those that are held against rs274,
and what rs274 has not: corners, contours of Fanuc's lathes, splines, printers, laps about a part,
and a mill's program with a bit of everything."""

import random

import against_rs274
import cases
import contour_programs
import test_contours
import test_corners

from pycnc.machine import Machine

TOOLS = [f"tool.{n}.{key}={n * by}" for n in (1, 2, 3)
         for key, by in (("length_mm", 11.5), ("radius_mm", 1.25))]  # fmt: skip


class Mill:
    """Writes one program: tools, zeros, cycles, arcs, radius compensation, calls, loops, modes."""

    def __init__(self, seed):
        self.source = random.Random(seed)
        self.lines = ["G21 G17 G90 G94 F900 G40 G49", "#1=0", "G0 Z30"]
        self.subs = 0

    def number(self, low=-60.0, high=60.0):
        return f"{self.source.uniform(low, high):.3f}"

    def place(self, letters="XY"):
        return " ".join(f"{each}{self.number()}" for each in letters)

    def change(self):
        tool = self.source.randint(1, 3)
        self.lines += [f"T{tool} M6", self.source.choice([f"G43 H{tool}", "G49", "G43"])]
        self.lines.append(f"S{self.source.randint(200, 3000)} M{self.source.randint(3, 5)}")
        self.lines.append(self.source.choice(["M7", "M8", "M9", "", "(a remark)", "M0", "G4 P0.1"]))

    def zero(self):
        self.lines.append(self.source.choice([
            f"G{self.source.randint(54, 59)}",
            f"G10 L2 P{self.source.randint(1, 6)} {self.place()}",
            f"G10 L20 P{self.source.randint(1, 6)} {self.place('XYZ')}", f"G92 {self.place('XYZ')}",
            "G92.1", f"G52 {self.place()}", "G52 X0 Y0", "G92.2", "G92.3",
        ]))  # fmt: skip

    def drill(self):
        code = self.source.choice(["G81", "G82 P0.01", "G83 Q3", "G73 Q2", "G85"])
        self.lines += ["G90 G0 Z40", f"{self.source.choice(['G98', 'G99'])} {code} "
                       f"{self.place()} Z{self.number(-15, -5)} R{self.number(1, 5)}"]  # fmt: skip
        self.lines += [self.place() for _ in range(self.source.randint(0, 3))]
        self.lines += [f"G91 X{self.number(1, 5)} Y1 L2", "G90"] * self.source.randint(0, 1)
        self.lines.append("G80")

    def arcs(self):
        radius = self.source.uniform(1, 20)
        self.lines += [
            f"G1 {self.place()} Z{self.number(-5, 5)}",
            f"G91 G{self.source.randint(2, 3)} X{radius:.3f} Y{radius:.3f} R{radius:.3f} Z-1",
            f"G{self.source.randint(2, 3)} I{radius:.3f} J0 Z0.5", "G90",
        ]  # fmt: skip

    def beside(self):
        """Three sides of a rectangle; the tool leaves without crossing the way that it came."""
        x, y = self.source.uniform(-50, 50), self.source.uniform(-50, 50)
        a, b = self.source.uniform(15, 40), self.source.uniform(15, 40)
        code, turns = self.source.choice([("G41", 3), ("G42", 2)])
        self.lines += ["G90 G17", f"G0 X{x - 20:.3f} Y{y - 20:.3f}", f"G1 Z{self.number(-9, -1)}",
                       f"{code} D{self.source.randint(1, 3)} G1 X{x:.3f} Y{y - 8:.3f}"]  # fmt: skip
        corner = [f"X{x:.3f} Y{y:.3f}", f"X{x:.3f} Y{y + b:.3f}", f"X{x + a:.3f} Y{y + b:.3f}",
                  f"X{x + a:.3f} Y{y:.3f}"]  # fmt: skip
        round_ = f"G{turns} X{x + a:.3f} Y{y + b:.3f} R{a:.3f}"
        middle = [corner[1], self.source.choice([corner[2], round_]), f"G1 {corner[3]}"]
        self.lines += [corner[0], *middle, self.source.choice(["M8", "", "S500", "G4 P0.05"])]
        self.lines += [f"G1 X{x + a:.3f} Y{y - 8:.3f}", f"G40 X{x + a:.3f} Y{y - 40:.3f}"]
        self.lines.append("G0 Z9")

    def call(self):
        self.subs += 1
        name, times = f"o{100 + self.subs}", self.source.randint(1, 3)
        body = [f"G1 {self.place()}", f"G91 G1 X{self.number(-3, 3)} Z-0.1", "G90"]
        self.lines += [f"{name} sub", *body, f"{name} endsub"]
        self.lines += [f"{name} call"] * times

    def loop(self):
        self.subs += 1
        name = f"o{100 + self.subs}"
        self.lines += [f"#1={self.source.randint(0, 3)}", f"{name} while [#1 gt 0]",
                       f"  G1 X[#1*7] {self.place('Y')}", f"  o9{self.subs} if [#1 eq 2]",
                       f"    G0 Z[#1+{self.source.randint(1, 9)}]", f"  o9{self.subs} endif",
                       "  #1=[#1-1]", f"{name} endwhile"]  # fmt: skip

    def mode(self):
        self.lines += self.source.choice([
            ["G20", f"G1 X{self.number(-2, 2)} F40", "G21 F800"], ["G61"], ["G64 P0.05"],
            ["G61.1"], ["G64"], ["G93", f"G1 {self.place()} F30", "G94 F700"], ["G95", "S500 M3",
            f"G1 {self.place()} F0.5", "G94 F700"], ["G28 Z60", "G90 G0 Z10"], ["G53 G0 Z100"],
            ["G91.1"], ["M70", f"G91 F{self.source.randint(100, 900)}", "M72"],
        ])  # fmt: skip

    def move(self):
        place = self.place(self.source.choice(["XY", "XYZ", "Z", "Y"]))
        self.lines.append(f"G{self.source.randint(0, 1)} {place}")

    def program(self):
        steps = (self.move, self.move, self.move, self.change, self.zero, self.drill, self.arcs,
                 self.beside, self.call, self.loop, self.mode)  # fmt: skip
        for _ in range(self.source.randint(6, 14)):
            self.source.choice(steps)()
        self.lines += [f"G90 G1 {self.place('XYZ')}", "G92.1", "M5 M9", "G0 Z50", "M2", ""]
        return "\n".join(self.lines)


class Printer:
    """Writes one program: layers, E by places and by steps, retracts, G92 E."""

    def __init__(self, seed):
        self.source = random.Random(seed)
        self.steps, self.e = False, 0.0
        self.lines = ["M140 S60", "M104 S200", "G21", "G90", "G28", "G1 Z5 F3000", "G92 E0"]

    def extrude(self, way):
        self.e += way
        return f"E{way if self.steps else self.e:.5f}"

    def program(self):
        for layer in range(1, self.source.randint(2, 5)):
            self.lines += [f"G0 Z{0.2 * layer:.2f}", "G92 E0"] if layer % 2 else ["M106 S128"]
            self.e = 0.0 if layer % 2 else self.e
            if self.source.random() < 0.5:
                self.steps = not self.steps
                self.lines += ["M83" if self.steps else "M82"]
            for _ in range(self.source.randint(3, 9)):
                x, y = (self.source.uniform(20, 180) for _ in range(2))
                way = self.extrude(self.source.uniform(0.1, 2))
                self.lines.append(f"G1 X{x:.3f} Y{y:.3f} {way}")
            self.lines += [f"G1 {self.extrude(-1.5)} F2400", "G0 X10 Y10"]
            self.lines.append(f"G1 {self.extrude(1.5)} F900")
        return "\n".join([*self.lines, "M104 S0", ""])


def _free(*more):
    return Machine.load("mill3", set=[*against_rs274.FREE, *against_rs274.HOMES, *more])


def _rough(seed):
    contour = contour_programs.contour(seed, pockets=bool(seed % 2))
    text, _ = test_contours.roughing(contour, 0.7 + seed % 7 * 0.4, seed % 3 * 0.2, 0.0)
    return text.replace("G0 X200 Z200\n", "G70 P10 Q20\nG0 X200 Z200\n")


def _corners(seed):
    return test_corners.contour(random.Random(seed), "RC"[seed % 2])[0]


OWN = {
    "mill": (lambda seed: Mill(seed).program(), lambda: _free(*TOOLS)),
    "printer": (lambda seed: Printer(seed).program(), lambda: Machine.load("printer")),
    "rough": (_rough, test_contours.lathe),
    "corners": (_corners, lambda: _free("dialect.base=fanuc")),
}
FAMILIES = {*OWN, *against_rs274.FAMILIES}


def case(name, seed):
    """Return a program of a family as a case."""
    if name in OWN:
        write, machine = OWN[name]
        text = write(seed)
    else:
        family = against_rs274.FAMILIES[name]
        written, machine = family.write(seed), family.machine
        text = (written[0] if isinstance(written, tuple) else written).decode()
    return cases.Case(f"{name}_{seed}", text, machine())
