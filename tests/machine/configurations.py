# SPDX-License-Identifier: MIT
"""Random configurations of other controls, and what stands in them.

    .venv/bin/python tests/machine/configurations.py COUNT SEED

reads COUNT of each kind and says which were not read as they were written.
"""

import random
import sys
import tempfile
import tomllib
from decimal import Decimal
from pathlib import Path
from typing import NamedTuple

from pycnc.machine import importer, source

INCH = Decimal("25.4")
ROTARY = "abc"
JUNK = ("HALFILE", "note_x", "serial", "pid_Kp", "gcode", "FERROR", "backlash", "µ_step")
KINDS = ("linuxcnc", "klipper", "grbl")


class Case(NamedTuple):
    """A configuration: bytes of its files, the first of them the one that is read."""

    files: dict
    expected: dict  # path of a key in the machine file → value
    kind: str
    units: str | None


class Writer:
    """Lines as people write them."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.indents = self.random.choice([[""], ["", "  "], ["    "], ["\t", " ", ""]])
        self.files, self.number = {}, 0

    def number_text(self, low, high):
        """Return (text, value) of a number."""
        value = round(self.random.uniform(low, high), self.random.randrange(4))
        text = f"{value:g}" if self.random.random() < 0.8 else f"{value:e}"
        return text, Decimal(text)

    def blank(self):
        """Return a blank or a comment, or nothing."""
        return self.random.choice([[], [], [], [""], ["   "], ["# a comment [TRAJ] x = 1"],
                                   ["; one more", ""]])  # fmt: skip

    def pair(self, key, value, joins, comments, indents=None):
        """Return a line of a key and its value."""
        blanks = self.random.choice(["", " ", "   "])
        behind = self.random.choice([" " + self.random.choice(comments) + " why", "", "", "  "])
        indent = self.random.choice(indents or self.indents)
        return f"{indent}{key}{blanks}{self.random.choice(joins)}{blanks or ' '}{value}{behind}"

    def junk(self, joins):
        """Return a key that means nothing for motion."""
        self.number += 1
        key = f"{self.random.choice(JUNK)}_{self.number}"
        return self.pair(key, self.random.choice(["one two", "1.5", "°C", "a=b:c", ""]), joins, "#")

    def apart(self, lines, directive, names):
        """Put lines into a file of their own, if it so falls; return what stands for them."""
        if self.random.random() < 0.7:
            return lines
        name = f"{self.random.choice(names)}{len(self.files)}"
        self.files[name] = lines
        return [directive.format(name)]

    def encoded(self, first, lines):
        """Return the files as bytes: in any of the ways that editors write them."""
        end = self.random.choice(["\n", "\n", "\r\n", "\r"])
        code = self.random.choice(["utf-8", "utf-8", "utf-8-sig", "utf-16", "latin-1"])
        files = {first: lines} | self.files
        return {name: end.join([*rows, ""]).encode(code) for name, rows in files.items()}


def linuxcnc(seed):
    """Return an INI."""
    pen = Writer(seed)
    axes = pen.random.choice(["xyz", "xz", "xyza", "xyyz", "xyzabc", "yxz"])
    unit = pen.random.choice(["mm", "inch", "INCH", "metric", None])
    given = pen.random.choice(["mm", "inch"]) if unit is None else None
    scale = INCH if (unit or given).lower() == "inch" else Decimal(1)
    said = " ".join(axes.upper())
    if pen.random.random() < 0.3:
        said = " \\\n      ".join(said.split(" ", 1))
    trajectory = ["[TRAJ]", *pen.pair("COORDINATES", said, "=", "#;").split("\n")]
    if unit:
        trajectory.append(pen.pair("LINEAR_UNITS", unit, "=", "#;"))
    trajectory += [pen.junk("=") for _ in range(pen.random.randrange(3))]
    kinematics = ["[KINS]", pen.pair("KINEMATICS", f"trivkins coordinates={axes}", "=", ["#"])]
    lines = ["[EMC]", pen.junk("=")]
    lines += pen.apart(trajectory, "#INCLUDE {}", ["traj.inc", "sub.ini"])
    lines += pen.apart(kinematics, "  #INCLUDE {}", ["kins.inc"])
    expected = {}
    for letter in dict.fromkeys(axes):
        own = pen.random.choice([f"AXIS_{letter.upper()}", f"JOINT_{axes.index(letter)}"])
        rows, values = _axis_of_ini(pen, own)
        factor = Decimal(1) if letter in ROTARY else scale
        unit_of = "deg" if letter in ROTARY else "mm"
        expected |= {f"axis.{letter}.{key.format(unit_of)}": value * factor
                     for key, value in values.items()}  # fmt: skip
        lines += pen.apart(rows, "#INCLUDE {}", ["axis.inc"]) + pen.blank()
    return Case(pen.encoded("machine.ini", lines), expected, "linuxcnc", given)


def _axis_of_ini(pen, section):
    rows, values = [f"[{section}]", *pen.blank()], {}
    wanted = [("MAX_VELOCITY", "v_max_{}_s", 1, 200), ("MAX_ACCELERATION", "a_max_{}_s2", 20, 900),
              ("MIN_LIMIT", "min_{}", -90, 0), ("MAX_LIMIT", "max_{}", 1, 90)]  # fmt: skip
    pen.random.shuffle(wanted)
    for name, key, low, high in wanted:
        text, values[key] = pen.number_text(low, high)
        rows += [pen.pair(name, text, "=", "#;"), *pen.blank()]
        if pen.random.random() < 0.15:  # of two the first counts
            rows.append(pen.pair(name, pen.number_text(low, high)[0], "=", "#;"))
    rows.insert(pen.random.randrange(1, len(rows) + 1), pen.junk("="))
    return rows, values


def klipper(seed):
    """Return a printer.cfg."""
    pen = Writer(seed)
    flat = pen.random.choice([[""], [""], ["  "]])  # in one section all alike: else it goes on
    lines, expected = pen.blank(), {}
    speed, expected_v = pen.number_text(50, 500)
    accel, expected_a = pen.number_text(500, 9000)
    rows = ["[printer]", pen.pair("kinematics", "corexy", ":=", "#;", flat),
            pen.pair("max_velocity", speed, ":=", "#;", flat), *pen.blank(),
            pen.pair("max_accel", accel, ":=", "#;", flat),
            pen.pair("square_corner_velocity", "5", ":=", "#;", flat)]  # fmt: skip
    if pen.random.random() < 0.3:  # of two the last counts
        rows.insert(2, pen.pair("max_accel", "1", ":=", "#;", flat))
    lines += pen.apart(rows, "[include {}]", ["base.cfg", "more.cfg"])
    for letter in pen.random.choice(["xyz", "xzy"]):
        most, value = pen.number_text(10, 400)
        rows = [f"[stepper_{letter}]", pen.pair("position_max", most, ":=", "#;", flat),
                *pen.blank(), pen.pair("step_pin", "PF0", ":=", "#;", flat)]  # fmt: skip
        lines += pen.apart(rows, "[include {}]", ["stepper.cfg"])
        expected |= {f"axis.{letter}.v_max_mm_s": expected_v, f"axis.{letter}.max_mm": value,
                     f"axis.{letter}.a_max_mm_s2": expected_a}  # fmt: skip
    lines += ["[gcode_macro START]", "gcode:", "    G28 X Y", "", "    max_accel: 7",
              "    {% if a %}", "      M104 S{b}", "    {% endif %}"]  # fmt: skip
    lines += ["#*# <---- SAVE_CONFIG ---->", "#*# [stepper_x]", "#*# position_endstop = 7.5"]
    return Case(pen.encoded("printer.cfg", lines), expected, "klipper", None)


def grbl(seed):
    """Return what $$ prints."""
    pen = Writer(seed)
    lines, expected = ["Grbl 1.1h ['$' for help]", *pen.blank()], {}
    for k, letter in enumerate(pen.random.choice(["xyz", "xyzab"])):
        unit = "deg" if letter in ROTARY else "mm"
        for number, key, low, high, scale in ((110, f"v_max_{unit}_s", 100, 9000, 60),
                                              (120, f"a_max_{unit}_s2", 20, 900, 1),
                                              (130, f"min_{unit}", 10, 900, -1)):  # fmt: skip
            text, value = pen.number_text(low, high)
            expected[f"axis.{letter}.{key}"] = value / scale
            indent = pen.random.choice(pen.indents)
            if pen.random.random() < 0.1:  # of two the last counts
                lines.append(f"{indent}${number + k}=1")
            words = pen.random.choice(["", " (rate, mm/min)", "  "])
            lines += [f"{indent}${number + k} ={text}{words}", *pen.blank()]
    lines += ["$10=1", "$32 = 0 (laser)", "[G54:0.000,0.000,0.000]", "ok"]
    return Case(pen.encoded("grbl.txt", lines), expected, "grbl", None)


def _told(data, path):
    for part in path.split("."):
        data = data[part]
    return Decimal(str(data))


def _is_silent(kind, row):
    """Return whether a line is a comment, or of a word that is used but not quoted."""
    bare = row.strip()
    if kind == "grbl":
        return False
    if bare.lower().startswith(("coordinates", "linear_units", "kinematics")) or bare[:1] == ";":
        return True
    return bare.startswith("#") and not bare.startswith(("#INCLUDE", "#*#"))


def faults(case, folder):
    """Read a configuration; return what is not as it was written."""
    for name, data in case.files.items():
        (Path(folder) / name).write_bytes(data)
    first = next(iter(case.files))
    text = source.decode((Path(folder) / first).read_bytes())
    draft = importer.read(text, first, folder, case.units)
    if draft.problems:
        return [str(draft.problems)]
    made = draft.text()
    data, found = tomllib.loads(made), []
    for path, value in case.expected.items():
        if abs(_told(data, path) - value) > Decimal("1e-6"):
            found.append(f"{path} is {_told(data, path)}, not {value}")
    wanted = {path.split(".")[1] for path in case.expected}
    if set(data["axis"]) != wanted:
        found.append(f"axes {set(data['axis'])}, not {wanted}")
    for content in case.files.values():
        found += _lost(case.kind, source.decode(content), made)
    return found


def _lost(kind, text, made):
    """Yield the lines that stand nowhere in what was made of them."""
    for row in text.replace("\\\n", "").split("\n"):
        bare = " ".join(row.split())
        is_told = bare in made or bare.startswith(("[", "#INCLUDE", "#*# <", "#*# ["))
        if bare and not is_told and not _is_silent(kind, row):
            yield f"lost: {row!r}"


def main():
    """Search so many of each kind."""
    count, seed = int(sys.argv[1]), int(sys.argv[2])
    wrong = 0
    for kind in KINDS:
        for k in range(count):
            with tempfile.TemporaryDirectory() as folder:
                found = faults(globals()[kind](seed + k), folder)
            wrong += bool(found)
            if found:
                print(f"{kind} {seed + k}:", *found, sep="\n  ")
    print(f"{count} configurations of each of {', '.join(KINDS)}: {wrong} not read as written")
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main())
