# SPDX-License-Identifier: MIT
"""Random programs with expressions, parameters, O words and subprograms, as RS274NGC has them."""

import random

MOST = 55  # bytes of an expression
UNARY = ("ABS", "COS", "SIN")
WHOLE = ("FIX", "FUP", "ROUND")  # of what is not whole but for its last digit
BINARY = ("+", "-", "*")
LOGIC = ("AND", "OR", "XOR")
COMPARE = ("EQ", "NE", "LT", "LE", "GT", "GE")


class Writer:
    """Writes one program; every value stays small, every loop ends.

    No value hangs on the last digit of another: no branch of an angle, root or remainder is near.
    #1 … #5 are read and written anywhere; loops count in #<n…>, which nothing else moves.
    """

    def __init__(self, seed):
        self.source = random.Random(seed)
        self.lines = ["G21 G17 G90 G94 G91.1 F600", "G0 X0 Y0 Z0", "#<wide>=3 #<_all>=4"]
        self.lines += [f"#{k}={k}.5" for k in range(1, 6)]
        self.label, self.subs = 100, []
        self.early = self.source.random() < 0.5  # break, continue: else do (see program)

    def operand(self):
        kind = self.source.randint(0, 7)
        if kind <= 2:
            return f"{self.source.uniform(-9, 9):.{self.source.randint(0, 4)}f}"
        if kind <= 4:
            return f"#{self.source.randint(1, 5)}"
        place = f"[ROUND[{self.source.choice(['#<_x>', '#5420', '#5421'])} * 50 + 0.123] / 50]"
        return self.source.choice(["#<wide>", "#<_all>", "#[1+2]", "-#2", place])

    def value(self, depth=0):
        """Return an expression in brackets, within ± 31, short enough for rs274's 255 bytes."""
        text = self._value(depth)
        while len(text) > MOST:
            text = self._value(depth)
        return text

    def _value(self, depth):
        kind = self.source.randint(0, 9) if depth < 4 else 0
        if kind <= 2:
            inside = self.operand()
        elif kind <= 5:
            inside = f"{self.value(depth + 1)} {self.operator()} {self.value(depth + 1)}"
        elif kind == 6 and depth < 2:
            inside = f"{self.source.choice(UNARY)}{self.value(depth + 1)}"
        elif kind == 6:
            inside = f"{self.source.choice(WHOLE)}[{self.source.uniform(-9, 9):.3f} * 1.7]"
        elif kind == 7:
            inside = f"ATAN[{self.operand()}]/[2 + ABS[{self.operand()}]]"
        elif kind == 8:
            inside = f"SQRT[1 + ABS{self.value(depth + 1)}] * 2 ** {self.source.randint(-2, 2)}"
        else:
            inside = f"EXP[SIN{self.value(depth + 1)}] + LN[2 + ABS{self.value(depth + 1)}]"
        return f"[[{inside} + 0.0123] MOD 61 - 30]" if depth % 2 == 0 else f"[{inside}]"

    def operator(self):
        return self.source.choice(BINARY)

    def condition(self):
        left, right = self.value(2), self.value(2)
        first = f"[{left} {self.source.choice(COMPARE)} {right}]"
        if self.source.random() < 0.5:
            return first
        return f"[{first} {self.source.choice(LOGIC)} [{self.operand()} GT 0]]"

    def spell(self, line):
        """Return the line in another spelling: case, blanks, a number, a remark."""
        kind = self.source.randint(0, 5)
        if kind == 0:
            line = line.lower()
        if kind == 1:
            line = line.replace(" ", "  ").replace("[", "[ ").replace("=", " = ")
        if kind == 2 and line[0] in "GX#":
            line = f"N{self.source.randint(1, 9999)} {line}"
        if kind == 3:
            line += " (a remark #1 [)" if self.source.random() < 0.5 else " ; a remark"
        return line

    def add(self, line):
        self.lines.append(self.spell(line))

    def statement(self, depth):
        kind = self.source.randint(0, 11)
        if kind <= 3:
            axes = self.source.sample("XYZ", self.source.randint(1, 3))
            words = " ".join(f"{axis}{self.value()}" for axis in axes)
            self.add(f"G{self.source.randint(0, 1)} {words}")
        elif kind <= 5:
            self.add(f"#{self.source.randint(1, 5)}={self.value()}")
        elif kind == 6:
            self.add(f"#1=#{self.source.randint(1, 5)} #2=#1 #<wide>={self.value()}")
        elif kind == 7:
            self.add(f"G2 X[#<_x>+4] Y#<_y> I{self.source.choice(['2', '[1+1]', 'SQRT[4]'])}")
        elif depth < 3:
            self.compound(depth, kind)

    def block(self, depth, most=4):
        for _ in range(self.source.randint(1, most)):
            self.statement(depth + 1)

    def compound(self, depth, kind):
        self.label += 1
        name, count = f"O{self.label}", self.source.randint(0, 3)
        if kind == 8:
            self.choice(depth, name)
        elif kind == 9:
            self.add(f"{name} REPEAT [{count}]")
            self.block(depth)
            self.add(f"{name} ENDREPEAT")
        elif kind == 10:
            self.loop(depth, name, count)
        elif self.subs:
            self.call()

    def choice(self, depth, name):
        self.add(f"{name} IF {self.condition()}")
        self.block(depth)
        if self.source.random() < 0.5:
            self.add(f"{name} ELSEIF {self.condition()}")
            self.block(depth)
        if self.source.random() < 0.5:
            self.add(f"{name} ELSE")
            self.block(depth)
        self.add(f"{name} ENDIF")

    def loop(self, depth, name, count):
        counter = f"#<n{self.label}>"
        self.add(f"{counter}=0")
        early = self.source.choice(["", "BREAK", "CONTINUE"]) if self.early else ""
        head = f"WHILE [{counter} LT {count}]"
        do = not self.early and self.source.random() < 0.4
        self.add(f"{name} {'DO' if do else head}")
        self.add(f"{counter}=[{counter}+1]")
        self.block(depth)
        if early:
            self.label += 1
            inner = f"O{self.label}"
            self.add(f"{inner} IF [{counter} EQ 2]")
            self.add(f"{name} {early}")
            self.add(f"{inner} ENDIF")
            self.block(depth, 2)
        self.add(f"{name} {head if do else 'ENDWHILE'}")

    def sub(self):
        self.label += 1
        name = self.source.choice([f"O{self.label}", f"O<cut {self.label}>"])
        self.add(f"{name} SUB")
        self.add("#<wide>=2")
        self.block(2)
        if self.source.random() < 0.3:
            self.label += 1
            self.add(f"O{self.label} IF {self.condition()}")
            self.add(f"{name} RETURN [#1]")
            self.add(f"O{self.label} ENDIF")
            self.block(2)
        self.add(f"{name} ENDSUB" + self.source.choice(["", " [#2+1]"]))
        self.subs.append(name)

    def call(self):
        count = self.source.randint(0, 3)
        values = " ".join(self.value() for _ in range(count))
        self.add(f"{self.source.choice(self.subs)} CALL {values}")
        self.add("G1 Z[#<_value> MOD 50]")

    def program(self):
        for _ in range(self.source.randint(0, 3)):
            self.sub()
        for _ in range(25):
            self.statement(0)
        return "\n".join([*self.lines, "M2", ""]).encode()


def program(seed):
    """Return a random program.

    Programs with break or continue have no do: in rs274 a break changes what a do behind it does.
    """
    return Writer(seed).program()
