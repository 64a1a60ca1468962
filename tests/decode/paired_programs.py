# SPDX-License-Identifier: MIT
"""Random programs in Fanuc's language, each with the same in RS274NGC: what rs274 can read.

A writer gives (text in Fanuc's language, text in RS274NGC).
"""

import math
import random

import test_layouts


def steps(begin, end, size):
    """Return places from begin to end, both included."""
    way = 1 if end > begin else -1
    return [*range(begin, end, way * size), end]


class Turning:
    """Lathe, system A: U and W, turning, facing and thread cycles, G32, shifts of the zero."""

    def __init__(self, seed):
        self.source = random.Random(seed)
        self.ours = ["G21 G18 G98 G97 S500 M3 F200", "G0 X40. Z10."]
        self.theirs = ["G21 G18 G90 G94 G7 F200", "S500 M3", "G0 X40 Z10"]
        self.at = {"X": 40000, "Z": 10000}  # [0.001 mm] X as diameter

    def word(self, letter, to):
        """Return the word of a place, or of the step to it."""
        if self.source.random() < 0.4:
            step, letter = to - self.at[letter], {"X": "U", "Z": "W"}[letter]
            return f"{letter}{step / 1000:.3f}"
        return f"{letter}{to / 1000:.3f}"

    def plain(self, code, **to):
        words = " ".join(f"{letter}{value / 1000:.4f}" for letter, value in to.items())
        self.theirs.append(f"{code} {words}")

    def pick(self, low, high, even=1):
        return even * self.source.randint(low // even, high // even)

    def both(self, ours, theirs=""):
        self.ours.append(ours)
        self.theirs.append(theirs or ours)

    def move(self):
        to = {"X": self.pick(4000, 60000, 2), "Z": self.pick(-40000, 20000)}
        to = {letter: to[letter] for letter in self.source.sample("XZ", self.source.randint(1, 2))}
        code = f"G{self.source.randint(0, 1)}"
        self.ours.append(" ".join([code, *[self.word(*each) for each in to.items()]]))
        self.plain(code, **to)
        self.at.update(to)

    def arc(self):
        x, z = self.pick(1000, 9000), self.pick(1000, 9000)  # steps, X as radius
        radius = math.hypot(x, z) * self.source.uniform(0.55, 2)
        to = {"X": self.at["X"] + 2 * x, "Z": self.at["Z"] - z}
        words = " ".join(self.word(*each) for each in to.items())
        code = f"G{self.source.choice('23')}"
        self.ours.append(f"{code} {words} R{radius / 1000:.3f}")
        self.theirs.append(
            f"{code} X{to['X'] / 1000:.3f} Z{to['Z'] / 1000:.3f} R{radius / 1000:.3f}"
        )
        self.at = to

    def rectangle(self):
        """G90, G94 or G92, in some lines; each ends where it begins."""
        code = self.source.choice(["G90", "G94", "G92"])
        begin = {"X": 50000, "Z": self.pick(2000, 9000)}
        self.ours.append(f"G0 X50. Z{begin['Z'] / 1000:.3f}")
        self.plain("G0", **begin)
        self.at = begin
        z, taper, lead = self.pick(-40000, -30000), 0, self.source.choice([1.0, 1.5])
        for k in range(self.source.randint(1, 4)):
            x = self.pick(10000, 30000, 2)
            words = [self.word("X", x)]
            if k == 0 or self.source.random() < 0.3:
                z = self.pick(-40000, -30000)
                words.append(self.word("Z", z))
            if self.source.random() < 0.3:
                taper = self.pick(-3000, 0)
                words.append(f"R{taper / 1000:.3f}")
            words += [code] if k == 0 else []
            words += [f"F{lead}"] if k == 0 and code == "G92" else []
            self.source.shuffle(words)
            self.ours.append(" ".join(words))
            self.corners(code, x, z, (taper, lead))
        if code == "G92":
            self.both("F200")

    def corners(self, code, x, z, form):
        taper, lead = form
        begin = self.at
        if code == "G94":
            self.plain("G0", Z=z + taper)
            self.plain("G1", X=x, Z=z)
            self.plain("G1", Z=begin["Z"])
            self.plain("G0", X=begin["X"])
            return
        self.plain("G0", X=x + 2 * taper)
        way = math.hypot(taper, z - begin["Z"]) / abs(z - begin["Z"])
        cut = f"G33 K{lead * way:.6f}" if code == "G92" else "G1"
        self.plain(cut, X=x, Z=z)
        self.plain("G0" if code == "G92" else "G1", X=begin["X"])
        self.plain("G0", Z=begin["Z"])

    def peck(self):
        """G74 or G75, whose every move is said in the other language."""
        code, along, across = self.source.choice([("G74", "Z", "X"), ("G75", "X", "Z")])
        back = self.pick(0, 900)
        to = {"X": self.pick(10000, 30000, 2), "Z": self.pick(-40000, -30000)}
        begin = {"X": 50000, "Z": self.pick(2000, 9000)}
        self.ours += [f"G0 X50. Z{begin['Z'] / 1000:.3f}", f"{code} R{back / 1000:.3f}"]
        self.plain("G0", **begin)
        self.at = begin
        step = {"X": self.pick(2000, 9000), "Z": self.pick(3000, 9000)}  # X as radius
        words = [self.word(letter, to[letter]) for letter in self.source.sample("XZ", 2)]
        for letter, plain, other in (("X", "P", "I"), ("Z", "Q", "K")):
            kind, size = self.source.randint(0, 2), step[letter]
            words.append((f"{plain}{size}", f"{plain}{size / 1000:.3f}",
                          f"{other}{size / 1000:.3f}")[kind])  # fmt: skip
        self.ours.append(" ".join([code, *words]))
        double = {"X": 2, "Z": 1}  # diameters
        for row in steps(begin[across], to[across], double[across] * step[across]):
            self.plain("G0", **{across: row})
            for cut in steps(begin[along], to[along], double[along] * step[along])[1:]:
                self.plain("G1", **{along: cut})
                away = 1 if begin[along] > cut else -1
                if cut != to[along]:
                    self.plain("G0", **{along: cut + away * double[along] * back})
            self.plain("G0", **{along: begin[along]})
        self.plain("G0", **{across: begin[across]})

    def thread(self):
        """G32 along Z, or along a cone."""
        to = {"Z": self.at["Z"] - self.pick(30000, 60000)}
        cone = self.pick(-2000, 2000, 2) if self.source.random() < 0.4 else 0
        if cone:
            to["X"] = self.at["X"] + cone
        lead = self.source.choice([0.75, 1.0, 1.5])
        length = (to["Z"] - self.at["Z"]) / 1000
        along = math.hypot(length, cone / 2000) / abs(length)
        words = " ".join(self.word(*each) for each in to.items())
        self.ours.append(f"G32 {words} F{lead}")
        self.plain(f"G33 K{lead * along:.6f}", **to)
        self.at.update(to)
        self.both("F200")

    def mode(self):
        kind = self.source.randint(0, 3)
        if kind == 0:
            feed = self.source.randint(20, 400)
            self.both(f"G98 F{feed}", f"G94 F{feed}")
        elif kind == 1:
            self.both("G99 F.2", "G95 F.2")
        elif kind == 2:
            to = {"X": self.pick(10000, 60000, 2), "Z": self.pick(-20000, 20000)}
            words = f"X{to['X'] / 1000:.3f} Z{to['Z'] / 1000:.3f}"
            self.both(f"G50 {words}", f"G92 {words}")
            self.at = to
        else:
            self.both(self.source.choice(["M8", "M9", "G4 X.5", "G4 U1."]), "G4 P1")

    def program(self):
        for _ in range(40):
            steps = (self.move, self.move, self.move, self.arc, self.rectangle, self.thread,
                     self.peck, self.mode)  # fmt: skip
            self.source.choice(steps)()
        return tuple("\n".join([*lines, "M30", ""]).encode() for lines in (self.ours, self.theirs))


def turning(seed):
    """Return a random program of a lathe that speaks Fanuc's language, system A."""
    return Turning(seed).program()


class Macro:
    """Parameters, IF GOTO THEN, WHILE DO END, G65 with both kinds of arguments, M98."""

    def __init__(self, seed):
        self.source = random.Random(seed)
        self.ours, self.theirs = ["G21 G17 G90 G94 F600", "G0 X0. Y0. Z0."], []
        self.theirs += self.ours
        self.label, self.programs = 100, []
        for k in range(101, 106):
            self.both(f"#{k}={k - 100}.5")

    def both(self, ours, theirs=None):
        self.ours.append(ours)
        self.theirs.append(ours if theirs is None else theirs)

    def operand(self, local):
        if local and self.source.random() < 0.4:
            return f"#{self.source.randint(1, local)}"
        kind = self.source.randint(0, 2)
        return f"{self.source.uniform(-9, 9):.3f}" if kind else f"#{self.source.randint(101, 105)}"

    def value(self, local=0):
        """Return a value in brackets; no error of an operand grows in it, not in a loop either."""
        a, b = self.operand(local), self.operand(local)
        form = self.source.randint(0, 5)
        inside = (
            f"{a}*0.7{self.source.choice('+-')}{b}*0.3", f"{a}/[ABS[{b}]+9.]", f"SIN[{a}]*{b}",
            f"SQRT[ABS[{a}]+1.]-{b}", f"[{a}+{b}]*COS[{b}]*0.5", f"ATAN[{a}]/[ABS[{b}]+60.]",
        )[form]  # fmt: skip
        return f"[[{inside}+0.0123] MOD 61. - 30.]"

    def condition(self, local):
        """Return it in both languages."""
        one, other = self._compared(local), self._compared(local)
        if self.source.random() < 0.7:
            return one
        joint = self.source.choice(["AND", "OR", "XOR"])
        return tuple(f"[{a} {joint} {b}]" for a, b in zip(one, other, strict=True))

    def _compared(self, local):
        """EQ and NE are exact in Fanuc's language; to rs274 what differs by 1e-4 is equal."""
        code = self.source.choice(["EQ", "NE", "LT", "LE", "GT", "GE"])
        one, other = self.value(local), self.value(local)
        ours = f"[{one} {code} {other}]"
        exact = {"EQ": "LE", "NE": "GT"}.get(code)
        return ours, f"[ABS[{one}-{other}] {exact} 0]" if exact else ours

    def statement(self, depth, local, do=1):
        kind = self.source.randint(0, 8)
        if kind <= 2:
            axes = self.source.sample("XYZ", self.source.randint(1, 3))
            words = " ".join(axis + self.value(local) for axis in axes)
            self.both(f"G{self.source.randint(0, 1)} {words}")
        elif kind <= 4:
            self.both(f"#{self.source.randint(101, 105)}={self.value(local)}")
        elif depth < 3 and kind == 5:
            self.choice(depth, local, do)
        elif depth < 3 and kind == 6 and do <= 3:
            self.loop(depth, local, do)
        elif kind == 7:
            self.then(local)
        elif self.programs and depth < 3:
            self.call(local)

    def block(self, depth, local, do):
        for _ in range(self.source.randint(1, 3)):
            self.statement(depth + 1, local, do)

    def names(self, count):
        self.label += count
        return range(self.label - count, self.label)

    def choice(self, depth, local, do):
        yes, behind, name = self.names(3)
        condition = self.condition(local)
        self.both(f"IF{condition[0]}GOTO{yes}", f"O{name} if {condition[1]}")
        mark = len(self.ours), len(self.theirs)
        self.block(depth, local, do)  # the other way: it stands first in Fanuc's language
        other = self.theirs[mark[1] :]
        del self.theirs[mark[1] :]
        self.ours += [f"GOTO{behind}", f"N{yes}"]
        self.block(depth, local, do)
        self.theirs += [f"O{name} else", *other, f"O{name} endif"]
        self.ours.append(f"N{behind}")

    def then(self, local):
        (name,) = self.names(1)
        condition, set_it = self.condition(local), f"#{self.source.randint(101, 105)}="
        set_it += self.value(local)
        self.ours.append(f"IF{condition[0]}THEN{set_it}")
        self.theirs += [f"O{name} if {condition[1]}", set_it, f"O{name} endif"]

    def loop(self, depth, local, do):
        (name,) = self.names(1)
        count, most = f"#{name + 400}", self.source.randint(0, 3)
        self.both(f"{count}=0")
        self.both(f"WHILE[{count} LT {most}.]DO{do}", f"O{name} while [{count} LT {most}]")
        self.both(f"{count}={count}+1.", f"{count}=[{count}+1]")
        self.block(depth, local, do + 1)
        self.both(f"END{do}", f"O{name} endwhile")

    def argument(self, count, times, local):
        """Return a value: short, since rs274 reads 255 bytes a line; said once for all times."""
        if times > 1:
            return f"[{self.source.uniform(-9, 9):.3f}]"
        return f"[{self.operand(local)}]" if count > 3 else self.value(local)

    def call(self, local):
        number, arguments = self.source.choice(self.programs)
        times = self.source.randint(1, 2)
        if not arguments:
            self.ours.append(f"M98 P{number} L{times}")
            self.theirs += [f"O{number} call"] * times
            return
        values = [self.argument(arguments, times, local) for _ in range(arguments)]
        letters = "ABC" + "IJK" * 10
        words = " ".join(letter + value for letter, value in zip(letters, values, strict=False))
        self.ours.append(f"G65 P{number} L{times} {words}")
        self.theirs += [f"O{number} call {' '.join(values)}"] * times

    def program(self):
        main = self.ours, self.theirs
        subs, theirs = [], []
        for k in range(self.source.randint(1, 3)):
            number, arguments = 9001 + k, self.source.choice([0, 3, 6, 9, 12, 30])
            self.ours, self.theirs = [f"O{number}"], [f"O{number} sub"]
            # M98 has the loops of its caller beside its own.
            self.block(2, arguments, 1)
            self.block(1, arguments, 3)
            self.both("M99", f"O{number} endsub")
            subs, theirs = subs + self.ours, theirs + self.theirs
            self.programs.append((number, arguments))
        self.ours, self.theirs = main
        for _ in range(20):
            self.statement(0, 0)
        ours = [*self.ours, "M30", *subs, ""]
        return "\n".join(ours).encode(), "\n".join([*theirs, *self.theirs, "M2", ""]).encode()


def macros(seed):
    """Return a random program with Fanuc's macros."""
    return Macro(seed).program()


HEAD = "G21 G94 F600 G10 L2 P2 X7 Y-3 Z11 G55"
ZERO = (7.0, -3.0, 11.0)


def layouts(seed):
    """Return a random program whose coordinates are laid out, and the same without."""
    source = random.Random(seed)
    plane = source.choice([17, 18, 19])
    layout, lines = test_layouts.Layout(source, plane), test_layouts.moves(source, plane)
    lines += _polar(source, plane)
    head = [HEAD.replace(" G10", "\nG10").replace(" G55", "\nG55"), f"G{plane}"]
    ours = [*head, *layout.begin, *[our for our, _ in _pairs(lines)], *layout.end]
    theirs = [*head, f"(lay {seed})", *[their for _, their in _pairs(lines)], "(plain)"]
    behind = ["G90 G0 X1 Y2 Z3", "M30", ""]
    return "\n".join(ours + behind).encode(), "\n".join(theirs + behind).encode()


def _pairs(lines):
    return [line if isinstance(line, tuple) else (line, line) for line in lines]


def _polar(source, plane):
    """Return pairs: places by radius and angle, and the same by coordinates."""
    u, v = test_layouts.WORDS[plane][:2]
    told = [("G90 G16", "G90")]
    for _ in range(source.randint(0, 6)):
        radius, angle = round(source.uniform(1, 40), 3), round(source.uniform(-400, 400), 3)
        x, y = radius * math.cos(math.radians(angle)), radius * math.sin(math.radians(angle))
        told.append((f"G1 {u}{radius:.3f} {v}{angle:.3f}", f"G1 {u}{x:.7f} {v}{y:.7f}"))
    return [*told, ("G15", "G90")]


def told_layouts(moves):
    """Return moves of rs274, mapped as the layout of their remark does it."""
    laid = None
    for move in moves:
        if not move.remark.startswith("lay"):
            continue
        if laid is None:
            source = random.Random(int(move.remark.split()[1]))
            plane = source.choice([17, 18, 19])
            laid = test_layouts.Layout(source, plane)
        if move.kind == "arc":
            u, v = move.plane
            centre = list(move.end[:3])
            centre[u], centre[v] = move.centre
            at = _laid(laid, centre)
            move.centre = at[u], at[v]
            move.turns *= -1 if test_layouts.mirrors(laid, u, v) else 1
        move.end = [*_laid(laid, move.end[:3]), *move.end[3:]]
        move.tolerance *= 4.0  # scaled by 3 at most
    return moves


def _laid(layout, place):
    inner = [a - b for a, b in zip(place, ZERO, strict=True)]
    return [float(a + b) for a, b in zip(layout.place(inner), ZERO, strict=True)]


