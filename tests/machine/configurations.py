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
STAMPS = ("", "", "", "19:22:01.123 -> ", "[7:02:59] ", ">>> ")  # of terminals
JUNK = ("HALFILE", "note_x", "serial", "pid_Kp", "gcode", "FERROR", "backlash", "µ_step")
KINDS = ("linuxcnc", "klipper", "grbl", "fluidnc", "marlin", "reprap")


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
    hal, flags, mask = pen.random.random() < 0.4, pen.random.randrange(16), pen.random.randrange(32)
    lines += ["$398=100"] * hal + [f"$22={flags}", f"$23={mask}"]
    for k, letter in enumerate(pen.random.choice(["xyz", "xyzab"])):
        unit = "deg" if letter in ROTARY else "mm"
        above = hal and flags & 8 and mask >> k & 1
        end = (f"max_{unit}", 1) if above else (f"min_{unit}", -1)
        for number, key, low, high, scale in ((110, f"v_max_{unit}_s", 100, 9000, 60),
                                              (120, f"a_max_{unit}_s2", 20, 900, 1),
                                              (130, end[0], 10, 900, end[1])):  # fmt: skip
            text, value = pen.number_text(low, high)
            expected[f"axis.{letter}.{key}"] = value / scale
            indent = pen.random.choice(pen.indents)
            if pen.random.random() < 0.1:  # of two the last counts
                lines.append(f"{indent}${number + k}=1")
            words = pen.random.choice(["", " (rate, mm/min)", "  "])
            lines += [f"{indent}${number + k} ={text}{words}", *pen.blank()]
    lines += ["$10=1", "$32 = 0 (laser)", "[G54:0.000,0.000,0.000]", "ok"]
    stamp = pen.random.choice(STAMPS)
    lines = [stamp + line if line.strip() else line for line in lines]
    return Case(pen.encoded("grbl.txt", lines), expected, "grbl", None)


def fluidnc(seed):
    """Return a config.yaml."""
    pen = Writer(seed)
    step, junk = pen.random.choice(["  ", "    "]), pen.random.choice
    lines, expected = [f"name: {junk(['mill', 'a router'])}", *pen.blank(), "axes:"], {}
    for letter in pen.random.choice(["xyz", "xz", "xyza"]):
        unit = "deg" if letter in ROTARY else "mm"
        rows = []
        wanted = [("max_rate_mm_per_min", f"v_max_{unit}_s", 60, 9000, 60, 1000),
                  ("acceleration_mm_per_sec2", f"a_max_{unit}_s2", 10, 900, 1, 25)]  # fmt: skip
        for name, key, low, high, scale, default in wanted:
            text, value = pen.number_text(low, high)
            if pen.random.random() < 0.2:  # left out: the control's own default
                value = Decimal(default)
            else:
                rows.append(f"{step * 2}{name}: {text}{junk(['', '  # why'])}")
            expected[f"axis.{letter}.{key}"] = value / scale
        travel, at = pen.random.randrange(50, 900), pen.random.randrange(-20, 20)
        up = pen.random.random() < 0.5
        rows += [f"{step * 2}max_travel_mm: {travel}", *pen.blank(), f"{step * 2}limit_pin: gpio.3"]
        pen.random.shuffle(rows)
        rows += [f"{step * 2}homing:", f"{step * 3}positive_direction: {str(up).lower()}",
                 f"{step * 3}mpos_mm: {at}"]  # fmt: skip
        expected[f"axis.{letter}.max_{unit}"] = Decimal(at if up else at + travel)
        lines += [f"{step}{letter}:", *rows]
    lines += ["kinematics:", f"{step}Cartesian:", "probe:", f"{step}pin: gpio.2"]
    return Case(pen.encoded("config.yaml", lines), expected, "fluidnc", None)


def _words(pen, code, letters, ends, *, name, scale=1):
    """Return (a line of M words, axis key → value) of some letters; ends: least, largest."""
    said, expected = [], {}
    for letter in letters:
        _, value = pen.number_text(*ends)
        said.append(f"{letter.upper()}{value:f}")
        own = "u" if letter == "e" else letter
        expected[f"axis.{own}.{name}"] = value / scale
    return f"{code} {' '.join(said)}", expected


def marlin(seed):
    """Return what M503 prints."""
    pen = Writer(seed)
    letters = pen.random.choice(["xyze", "xyz", "xye"])
    speed, v_of = _words(pen, "M203", letters, (5, 500), name="v_max_mm_s")
    accel, a_of = _words(pen, "M201", letters, (50, 5000), name="a_max_mm_s2")
    steps, _ = _words(pen, "M92", letters, (80, 400), name="steps")
    deviation = Decimal(pen.random.randrange(1, 300)) / 10_000 + Decimal("0.00001")
    own = ["M204 P500.00 R800 T1500", f"M205 B20000.00 S0.00 T0.00 J{deviation}"]
    corner = {"control.junction_deviation": deviation, "control.retract_acceleration": Decimal(800),
              "control.travel_acceleration": Decimal(1500)}  # fmt: skip
    if pen.random.random() < 0.3:  # Marlin 1.0
        own = ["M204 S500.00 T700.00", "M205 S0.00 T0.00 B20000 X12.50 Z0.40 E5.00"]
        corner = {"control.jerk.x": Decimal("12.5"), "control.jerk.y": Decimal("12.5"),
                  "control.retract_acceleration": Decimal(700),
                  "control.travel_acceleration": Decimal(500)}  # fmt: skip
    echo = pen.random.choice(["", "echo:", "echo:  ", "Recv: echo:  "])  # the last: OctoPrint's log
    lines = ["Steps per unit:", steps, speed, "; Acceleration", accel, *own, "M851 X0 Y0 Z-1",
             "M420 S0"]  # fmt: skip
    expected = v_of | a_of | corner | {"control.acceleration": Decimal(500)}
    if pen.random.random() < 0.3:  # Prusa's
        mode, other = "Maximum feedrates - {0} (mm/s):", "Maximum acceleration - {0} (mm/s2):"
        lines[2:5] = [mode.format("normal"), speed, mode.format("stealth"), "M203 X3 Y3 Z1 E2",
                      other.format("normal"), accel, other.format("stealth"), "M201 X9 Y9 Z2 E8",
                      "Acceleration: P=print, R=retract, T=travel"]  # fmt: skip
    stamp = pen.random.choice(STAMPS)
    lines = [f"{stamp}{echo}{line}" for line in lines] + ["ok"]
    return Case(pen.encoded("m503.txt", lines), expected, "marlin", None)


def reprap(seed):
    """Return a config.g."""
    pen = Writer(seed)
    letters = pen.random.choice(["xyze", "xyz", "xyzae"])
    speed, v_of = _words(pen, "M203", letters, (60, 9000), name="v_max_mm_s", scale=60)
    accel, a_of = _words(pen, "M201", letters, (50, 5000), name="a_max_mm_s2")
    steps, _ = _words(pen, "M92", letters, (80, 400), name="steps")
    expected = {path.replace("axis.a.v_max_mm_s", "axis.a.v_max_deg_s").replace(
        "axis.a.a_max_mm_s2", "axis.a.a_max_deg_s2"): value
        for path, value in (v_of | a_of).items()}  # fmt: skip
    jumps = []
    for letter in letters:
        text, value = pen.number_text(20, 900)
        jumps.append(f"{letter.upper()}{value:f}" + pen.random.choice(["", f":{value:f}"]))
        expected[f"control.jerk.{letter}"] = value / 60
    low, high = pen.random.randrange(-20, 20), pen.random.randrange(100, 400)
    both = pen.random.random() < 0.5
    ends = [f"M208 X{low}:{high}"] if both else [f"M208 X{low} S1", f"M208 X{high} S0"]
    expected |= {"axis.x.min_mm": Decimal(low), "axis.x.max_mm": Decimal(high)}
    expected |= {"axis.y.min_mm": Decimal(0), "axis.y.max_mm": Decimal(200)}
    own = [steps, f"M566 {' '.join(jumps)}", speed, accel]
    if pen.random.random() < 0.3:  # several in a line
        own = [own[0], f"{own[1]} {own[2].lower()}", own[3]]
    lines = ["; a printer", 'M550 P"M203 X1 G20"', "M584 X0 Y1:4 Z5 E3",
             pen.random.choice(["M669 K0", "M669 K1"]), *own, *ends, "M906 X800 I30",
             "M572 D0 S0.05", 'if exists(global.a) && {move.axes[0].max} > 3', "  M906 X500",
             'M98 P"more.g"', "T0"]  # fmt: skip
    return Case(pen.encoded("config.g", lines), expected, "reprap", None)


def _told(data, path):
    for part in path.split("."):
        data = data[part]
    return Decimal(str(data))


def _is_silent(kind, row):
    """Return whether a line is a comment, or of a word that is used but not quoted."""
    bare = row.strip()
    if kind == "grbl":
        return False
    if kind in ("marlin", "reprap"):
        bare = bare.removeprefix(next(filter(bare.startswith, STAMPS[3:]), ""))
        said = bare.removeprefix("Recv:").lstrip().removeprefix("echo:").lstrip()
        return said[:1] == ";" or bare.startswith("M669")
    if kind == "fluidnc":  # of a map the head is not quoted, and a true that is used is not
        return bare.startswith(("#", ";", "positive_direction", "mpos_mm")) or bare.endswith(":")
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
    wanted = {path.split(".")[1] for path in case.expected if path.startswith("axis.")}
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
