# SPDX-License-Identifier: MIT
"""What the configurations of printers mean: Klipper, Marlin, RepRapFirmware."""

import re
from decimal import Decimal

from pycnc.machine.schema import AXES

_NUMBER = re.compile(r"-?(\d+\.?\d*|\.\d+)")
_PI = Decimal("3.14159265358979")


def klipper(source):
    """Fill in a printer.cfg; return the letters of its axes."""
    if "printer" not in source.form.heads.values():
        source.draft.problems.append(
            ("", "no [printer]: it is a part of a configuration; give the printer.cfg that has it")
        )
        return []
    name = (source.word(("printer", "kinematics")) or "cartesian").lower()
    if name not in _TRAVELS:
        known = ", ".join(_TRAVELS)
        source.draft.problems.append(
            ("printer.kinematics", f"{name} moves no axes that are known here; known: {known}")
        )
        return []
    travel, told = _TRAVELS[name]
    if told:
        source.draft.left.append(f"kinematics {name}: {told}; planned is the tool's path in X Y Z")
    letters = list("xyz") if travel else source.letters_of("stepper_", "xyz")
    for letter in letters:
        own = [("printer", f"max_{letter}_velocity"), ("printer", "max_velocity")]
        source.axis(letter, "v_max", own)
        source.axis(letter, "a_max", [("printer", f"max_{letter}_accel"), ("printer", "max_accel")])
        if not travel:
            _straight(source, letter, f"stepper_{letter}")
    _safe_home(source)
    if travel:
        source.axes.update(each for each in source.form.heads.values() if _is_rail(each))
        travel(source)
    source.path("path.feed_max_mm_min", [("printer", "max_velocity")], Decimal(60))
    source.path("path.a_max_mm_s2", [("printer", "max_accel")])
    _own_klipper(source)
    source.draft.put("dialect.base", "marlin")
    source.draft.put("dialect.feed_default_mm_min", 1500, "until the first F, as Klipper has it")
    if "extruder" in source.form.heads.values():
        source.axes.add("extruder")
        _extruder(source)
        letters = [*letters, _filament(source)]
    return letters


def _safe_home(source):
    """Where X and Y stand while Z is homed, and then stay."""
    words = source.word(("safe_z_home", "home_xy_position"))
    said = re.fullmatch(r"([-\d.]+)\s*,\s*([-\d.]+)", words or "")
    for letter, text in zip("xy", said.groups() if said else (), strict=False):
        if _NUMBER.fullmatch(text):
            source.draft.homes(letter, Decimal(text), "[safe_z_home]")


def _filament(source):
    """The extruder's axis, which has no ends; return its letter."""
    for end in ("min", "max"):
        source.draft.put(f"axis.u.{end}_mm", "free")
    return "u"


def _is_rail(section):
    return section.startswith(("stepper_", "carriage "))


def _straight(source, letter, section):
    source.axis(letter, "min", [(section, "position_min")])
    source.axis(letter, "max", [(section, "position_max")])
    if source.draft.limit(letter, "min") is None:
        source.draft.axis(letter, "min", Decimal(0), "position_min is 0 unless it is told")
    place, comment = source.number((section, "position_endstop"))
    if place is not None:
        source.draft.homes(letter, place, comment)


def _round(source, *keys):
    """X and Y reach so far from the middle."""
    reach, comment = source.number(*keys)
    if reach is not None:
        for letter in "xy":
            source.draft.axis(letter, "min", -reach, comment)
            source.draft.axis(letter, "max", reach, comment)


def _height(source):
    """Z of a delta: from minimum_z_position to where all carriages meet their switches."""
    source.axis("z", "min", [("printer", "minimum_z_position")], default=Decimal(0))
    ends = [source.number((f"stepper_{tower}", "position_endstop")) for tower in "abc"]
    least = min((end for end in ends if end[0] is not None), default=None)
    if least:
        source.draft.axis("z", "max", *least)
        source.draft.homes("z", *least)


def _delta(source):
    _round(source, ("printer", "print_radius"), ("printer", "delta_radius"))
    _height(source)


def _deltesian(source):
    width, comment = source.number(("printer", "print_width"))
    if width is not None:
        source.draft.axis("x", "min", -width / 2, comment)
        source.draft.axis("x", "max", width / 2, comment)
    _straight(source, "y", "stepper_y")
    source.axis("z", "min", [("printer", "minimum_z_position")], default=Decimal(0))


def _polar(source):
    _round(source, ("stepper_arm", "position_max"))
    _straight(source, "z", "stepper_z")


def _carriages(source):
    for letter in "xyz":
        _straight(source, letter, f"carriage {letter}")


def _free(source):
    source.draft.left.append("travel: anchors do not say it; taken as free")


_SHARED = "motors share axes"
_LIMITED = "its limits of X and Y (max_x_accel …) are left out of Klipper's times"
_EDGE = "Klipper is slower near the edge, which is left out"
_TRAVELS = {  # kinematics → (its travel, or one of each stepper; what is told)
    "cartesian": (None, ""),
    **dict.fromkeys(("corexy", "corexz", "hybrid_corexy", "hybrid_corexz"), (None, _SHARED)),
    "limited_cartesian": (None, _LIMITED),
    **dict.fromkeys(("limited_corexy", "limited_corexz"), (None, f"{_SHARED}; {_LIMITED}")),
    "generic_cartesian": (_carriages, "carriages as they are named"),
    "delta": (_delta, f"three towers; {_EDGE}"),
    "rotary_delta": (_height, f"three arms; {_EDGE}"),
    "deltesian": (_deltesian, f"two towers; {_EDGE}"),
    "polar": (_polar, "a bed that turns"),
    "winch": (_free, "cables"),
}  # fmt: skip


_KLIPPER = {  # Klipper's own defaults, where it has any
    "max_velocity": None, "max_accel": None, "max_z_velocity": None, "max_z_accel": None,
    "square_corner_velocity": Decimal(5), "minimum_cruise_ratio": Decimal("0.5"),
}  # fmt: skip
_EXTRUDER = {
    "instantaneous_corner_velocity": Decimal(1), "max_extrude_only_velocity": None,
    "max_extrude_only_accel": None, "nozzle_diameter": None, "filament_diameter": None,
}  # fmt: skip


def _own_klipper(source):
    source.draft.put("control.kind", "klipper")
    for key, default in _KLIPPER.items():
        source.own(key, [("printer", key)], default)
    _decelerating(source)
    for key, default in _EXTRUDER.items():
        source.own(key, [("extruder", key)], default)
    arcs = "gcode_arcs" in source.form.heads.values()
    if arcs:
        source.axes.add("gcode_arcs")
        source.own("resolution", [("gcode_arcs", "resolution")], Decimal(1))
    else:
        source.draft.left.append("no [gcode_arcs]: Klipper knows no G2 and G3; their time is told")


def _decelerating(source):
    """The older form of the minimum cruise ratio, as Klipper takes it: told, but not beside it."""
    accel = source.draft.values.get("control.max_accel")
    if ("printer", "minimum_cruise_ratio") in source.settings or not accel:
        return
    slow, comment = source.number(("printer", "max_accel_to_decel"))
    if slow is not None and slow > 0 and accel[0] > 0:
        ratio = round(1 - min(Decimal(1), slow / accel[0]), 6)
        source.draft.put("control.minimum_cruise_ratio", ratio, f"1 - its share: {comment}")


def _extruder(source):
    """The axis of the filament: as fast alone as Klipper lets it be."""
    values = source.draft.values

    def of(key, default):
        return Decimal(values.get(f"control.{key}", (default, ""))[0])

    radius = of("filament_diameter", "1.75") / 2
    ratio = 4 * of("nozzle_diameter", "0.4") ** 2 / (_PI * radius**2)
    for quantity, own, key in (
        ("v_max", "max_extrude_only_velocity", "max_velocity"),
        ("a_max", "max_extrude_only_accel", "max_accel"),
    ):
        if f"control.{own}" in values:
            source.draft.axis("u", quantity, of(own, 1), own)
        elif f"control.{key}" in values:
            words = "the extruder, E: by nozzle and filament, as Klipper has it"
            source.draft.axis("u", quantity, round(of(key, 1) * ratio, 3), words)


def _axis_of_marlin(source, own):
    """Fill in what M503 prints of an axis, by its letter there."""
    letter = "u" if own == "e" else own
    source.axis(letter, "v_max", [("m203", own)])
    source.axis(letter, "a_max", [("m201", own)])
    source.own(f"steps_per_mm.{own}", [("m92", own)])
    if ("m205", "j") not in source.settings:  # Marlin 1.0 has one number for X and Y
        source.own(f"jerk.{own}", [("m205", own), *([("m205", "x")] if own == "y" else [])])


def marlin(source):
    """Fill in what M503 prints; return the letters of its axes."""
    has = source.settings
    letters = [letter for letter in AXES if ("m203", letter) in has]
    if ("", "g20") in has:
        source.draft.problems.append(("M503", "in inches: send G21 before M503"))
    source.draft.put("control.kind", "marlin")
    extrudes = ("m203", "e") in has
    for own in [*letters, *(["e"] if extrudes else [])]:
        _axis_of_marlin(source, own)
    is_old = ("m204", "s") in has and ("m204", "p") not in has  # S, and T of retractions
    travel, retract = ("s", "t") if is_old else ("t", "r")
    for key, word in (("acceleration", "p"), ("travel_acceleration", travel),
                      ("retract_acceleration", retract)):  # fmt: skip
        source.own(key, [("m204", word), ("m204", "s")])
    source.own("min_segment_time_us", [("m205", "b")])
    _deviation_of_marlin(source)
    if extrudes:
        letters = [*letters, _filament(source)]
    source.draft.left.append("travel: M503 does not have it; taken as free")
    _kinematics_of_marlin(source)
    source.draft.put("dialect.base", "marlin")
    source.draft.put("dialect.feed_default_mm_min", 1500, "until the first F, as Marlin has it")
    return letters


def _kinematics_of_marlin(source):
    """M665 is there where motors are no axes: of a delta with L, else of a SCARA or a polar one."""
    said = [key for key in source.settings if key[0] == "m665"]
    if said:
        name = "a delta of three towers" if ("m665", "l") in said else "a SCARA, or a polar one"
        source.draft.left.append(
            f"kinematics: {name} (M665); planned is the tool's path in X Y Z, not its segments"
        )


def _deviation_of_marlin(source):
    deviation, comment = source.number(("m205", "j"))
    if deviation is None:
        return
    is_whole = deviation.as_tuple().exponent < -2 or deviation == 0
    if not is_whole and source.deviation is None:
        source.draft.problems.append(
            (comment, "M503 prints two decimals of J: add --junction-deviation with what "
             "Configuration.h has, JUNCTION_DEVIATION_MM, such as 0.013")
        )  # fmt: skip
    told = (source.deviation, "--junction-deviation") if source.deviation else (deviation, comment)
    source.draft.put("control.junction_deviation", *told)


def reprap(source):
    """Fill in a config.g; return the letters of its axes."""
    letters = [letter for letter in "xyzabcvw" if ("m203", letter) in source.settings]
    if ("", "g20") in source.settings:
        source.draft.problems.append(("config.g", "in inches (G20): write it in mm"))
    source.draft.put("control.kind", "marlin", "its rules are the nearest: M566 is classic jerk")
    source.draft.put("control.reprap", True, "it is RepRapFirmware's language")
    source.draft.left.append(
        "RepRapFirmware has rules of its own: lines, corners by M566 and a ring of 40 are taken as "
        "Marlin's; input shaping and pressure advance are left out"
    )
    extrudes = ("m203", "e") in source.settings
    if ("m203", "u") in source.settings:
        source.draft.left.append("axis U: a second carriage, left out")
    for own in [*letters, *(["e"] if extrudes else [])]:
        letter = "u" if own == "e" else own
        source.axis(letter, "v_max", [("m203", own)], 1 / Decimal(60))
        source.axis(letter, "a_max", [("m201", own)])
        source.own(f"steps_per_mm.{own}", [("m92", own)])
        if ("m566", own) in source.settings:
            source.own(f"jerk.{own}", [("m566", own)], scale=1 / Decimal(60))
        else:
            source.draft.left.append(f"M566 {own.upper()}: not in the source; versions differ")
    for key, word in (("acceleration", "p"), ("travel_acceleration", "t")):
        source.own(key, [("m204", word)])
    source.own("planner_blocks", [], Decimal(40))
    _travel_of_reprap(source, letters)
    source.draft.put("dialect.base", "marlin")
    source.draft.put("dialect.feed_default_mm_min", 3000, "until the first F: 50 mm/s")
    if extrudes:
        letters = [*letters, _filament(source)]
    return letters


_REPRAP_KINEMATICS = {  # of M669 K
    0: "", 1: "CoreXY", 2: "CoreXZ", 3: "a linear delta", 4: "a SCARA of two arms", 5: "CoreXYU",
    6: "cables (Hangprinter)", 7: "polar", 8: "CoreXYUV", 9: "a SCARA of five bars",
    10: "a rotary delta", 11: "Markforged",
}  # fmt: skip


def _travel_of_reprap(source, letters):
    number, _ = source.number(("m669", "k"), ("m667", "s"))
    is_delta = ("m665", "r") in source.settings or ("m665", "l") in source.settings
    number = 3 if number is None and is_delta else int(number or 0)
    if name := _REPRAP_KINEMATICS.get(number, f"M669 K{number}"):
        source.draft.left.append(f"kinematics: {name}; planned is the tool's path in X Y Z")
    if number == 3:
        _round(source, ("m665", "b"), ("m665", "r"))
        source.axis("z", "min", [("m208.1", "z")], default=Decimal(0))
        source.axis("z", "max", [("m665", "h")])
        height, comment = source.number(("m665", "h"))
        if height is not None:
            source.draft.homes("z", height, comment)
    for letter in letters if number != 3 else ():
        source.axis(letter, "min", [("m208.1", letter)], default=Decimal(0))
        source.axis(letter, "max", [("m208.0", letter)], default=Decimal(200))
        _switch_of_reprap(source, letter)


def _switch_of_reprap(source, letter):
    """M574: the switch is at the lower end (1), or the upper one (2)."""
    which, comment = source.number(("m574", letter))
    if which in (1, 2):
        source.draft.homes(letter, source.draft.limit(letter, "min" if which == 1 else "max"),
                           comment)  # fmt: skip
