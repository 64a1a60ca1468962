# SPDX-License-Identifier: MIT
"""Machine files from the configurations of LinuxCNC, grbl and grblHAL, Klipper, FluidNC and Marlin.

Units are converted; each value has the line that it comes from as its comment; what a machine file
has no equal for is told.
"""

import re
from decimal import Decimal

from pycnc import errors
from pycnc.machine import foreign
from pycnc.machine import source as forms
from pycnc.machine.draft import Draft
from pycnc.machine.schema import AXES, ROTARY_AXES

_MM = {  # LINEAR_UNITS of LinuxCNC → millimetres
    **dict.fromkeys(("mm", "metric"), Decimal(1)), "cm": Decimal(10), "um": Decimal("1e-3"),
    **dict.fromkeys(("inch", "in", "imperial"), Decimal("25.4")),
}  # fmt: skip
_DEGREES = {  # ANGULAR_UNITS of LinuxCNC → degrees
    **dict.fromkeys(("deg", "degree"), Decimal(1)), "grad": Decimal("0.9"), "gon": Decimal("0.9"),
    **dict.fromkeys(("rad", "radian"), Decimal("57.29577951308232087679815")),
}  # fmt: skip
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d{1,3})?", re.ASCII)
_MOTION = re.compile(  # what has to do with motion, and no equal here
    r"backlash|accel_to_decel|ferror|stepgen_maxvel|stepgen_maxaccel|max_joint|input_shap"
    r"|pressure_advance|shaper_freq", re.I,
)  # fmt: skip


class Source:
    """The settings of a foreign file, and the draft that is made of them."""

    def __init__(self, file, form, kind, units):
        self.form, self.settings, self.units, self.used = form, form.settings, units, set()
        self.axes = set()  # sections that say by themselves that there is an axis
        self.draft = Draft(f"imported from {file} ({kind})")
        self.draft.problems += form.problems

    def word(self, *keys):
        """Return the text of the first of some keys that is there; None if none is."""
        for key in keys:
            if key in self.settings:
                self.used.add(key)
                return self.settings[key].value
        return None

    def number(self, *keys):
        """Return (number, comment) of the first of some keys that is there; (None, "")."""
        for key in keys:
            if key in self.settings:
                self.used.add(key)
                setting = self.settings[key]
                if _NUMBER.fullmatch(setting.value):
                    return Decimal(setting.value), setting.told
                place, _, text = setting.told.partition(": ")
                self.draft.problems.append((place, f"{setting.value!r} is no number: {text}"))
                return None, ""
        return None, ""

    def unit(self, key, name, known):
        """Return what a unit that the file names is worth; None if it names none.

        A number says how many of them are a millimetre, or a degree.
        """
        word = self.word(key)
        if word is None or word.lower() in known:
            return word and known[word.lower()]
        if _NUMBER.fullmatch(word) and Decimal(word) > 0:
            return round(1 / Decimal(word), 6)
        self.draft.problems.append((name, f"{word!r} is none of {', '.join(known)}, nor a number"))
        return Decimal(1)

    def letters_of(self, begin, letters):
        """Return the letters of the axes that have a section of their own."""
        found = [letter for letter in letters if begin + letter in self.form.heads.values()]
        self.axes.update(begin + letter for letter in found)
        return found

    def axis(self, letter, quantity, keys, scale=Decimal(1)):
        """Set a limit of an axis from the first of some keys."""
        value, comment = self.number(*keys)
        if value is not None:
            self.draft.axis(letter, quantity, value * scale, comment)

    def path(self, key, keys, scale=Decimal(1)):
        """Set a value that is no axis' from the first of some keys."""
        value, comment = self.number(*keys)
        if value is not None and value > 0:
            self.draft.put(key, value * scale, comment)

    def own(self, key, keys, default=None, scale=Decimal(1)):
        """Set a setting of the control from the first of some keys, else its own default."""
        value, comment = self.number(*keys)
        if value is None and default is None:
            return
        told = comment or "not in the source: the control's own default"
        self.draft.put(f"control.{key}", default if value is None else value * scale, told)

    def tell_left(self):
        """List every line that nothing was made of: what has to do with motion, and the rest."""
        used = {id(row) for key in self.used for row in self.settings[key].rows}
        sections = {section for section, _ in self.used} | self.axes
        for row in self.form.rows:
            section = self.form.heads.get(id(row))
            is_used = id(row) in used or (section and _leads_to(section, sections))
            if is_used or not row.text:
                continue
            note = self.form.notes.get(id(row))
            moves = note or _MOTION.search(row.text)
            told = f"{row.place}: {row.text}" + (f" ({note})" if note else "")
            (self.draft.left if moves else self.draft.rest).append(told)


def _leads_to(section, used):
    """Tell whether a section, or one below it, has a value that is used."""
    return any(each == section or each.startswith(f"{section}.") for each in used)


def read(text, file, folder=None, units=None):
    """Return the draft of a machine file from a foreign configuration.

    Parameters
    ----------
    text : str
    file : str
        Its name, for comments and messages.
    folder : path, optional
        Where it lies: what it includes is read from there; without one it is told.
    units : str, optional
        "mm" or "inch": what lengths are in where the file does not say.

    Raises
    ------
    ArgumentError
        If it is none that is known.
    """
    kind = foreign.kind_of(text)
    if kind is None:
        known = ", ".join(_READERS)
        raise errors.ArgumentError(
            f"{file}: is no configuration that can be imported: {known}", id="import"
        )
    parse, fill = _READERS[kind]
    source = Source(file, parse(text, folder), kind, units)
    letters = fill(source)
    if not letters:
        source.draft.problems.append(("", "no axis found"))
    if kind not in _PRINTERS:  # of a printer it is the bed's
        source.draft.put("work.zero", "unknown", "whoever clamps the work sets it: --zero says it")
    source.draft.complete(letters)
    source.tell_left()
    return source.draft


# ---- what they mean


def _length_unit(source):
    """Return the millimetres of a LinuxCNC machine's unit: as it says, else as the caller does."""
    told = source.unit(("traj", "linear_units"), "LINEAR_UNITS", _MM)
    given = source.units and _MM[source.units]
    if told is None and given is None:
        source.draft.problems.append(
            ("LINEAR_UNITS", "the file does not say them: add --units mm or --units inch")
        )
    if told and given and told != given:
        source.draft.problems.append(("--units", f"{source.units}: the file says otherwise"))
    return told or given or Decimal(1)


def _joints(source):
    """Return {axis: its first joint} of a LinuxCNC machine, in the order of the axes."""
    kinematics = source.word(("kins", "kinematics")) or "trivkins"
    if not kinematics.startswith("trivkins"):
        source.draft.left.append(f"kinematics {kinematics}: the axes are taken as joints")
    told = source.word(("traj", "coordinates"))
    if told is None:
        source.draft.left.append("COORDINATES: not in the source; taken as X Y Z")
    of_joints = re.search(r"\bcoordinates=(\w+)", kinematics.lower())
    named = re.sub("[^a-z]", "", (told or "xyz").lower())
    order = of_joints[1] if of_joints else named
    return {letter: order.find(letter) for letter in AXES if letter in named}


def _fill_linuxcnc(source):
    unit = _length_unit(source)
    degrees = source.unit(("traj", "angular_units"), "ANGULAR_UNITS", _DEGREES) or Decimal(1)
    joints = _joints(source)
    letters = list(joints)
    for letter, joint in joints.items():
        rotary = letter in ROTARY_AXES
        scale = degrees if rotary else unit
        own = (f"axis_{letter}", f"axis_{joint}", f"joint_{joint}")
        most = "max_angular" if rotary else "max_linear"
        for quantity, name in (("v_max", "velocity"), ("a_max", "acceleration"),
                               ("j_max", "jerk")):  # fmt: skip
            keys = [*((section, f"max_{name}") for section in own), ("traj", f"{most}_{name}"),
                    ("traj", f"max_{name}")]  # fmt: skip
            source.axis(letter, quantity, keys, scale)
        source.axis(letter, "min", [(section, "min_limit") for section in own], scale)
        source.axis(letter, "max", [(section, "max_limit") for section in own], scale)
    source.path("path.feed_max_mm_min", [("traj", "max_linear_velocity")], 60 * unit)
    source.path("kernel.period_ms", [("emcmot", "servo_period")], Decimal("1e-6"))
    source.path("spindle.rpm_max", [("spindle_0", "max_forward_velocity")])
    source.draft.put("control.kind", "linuxcnc")
    _startup(source, unit)
    if unit == _MM["inch"]:
        source.draft.put("dialect.units", "inch", "LINEAR_UNITS")
    if source.word(("display", "lathe")) == "1" and letters == ["x", "z"]:
        source.draft.put("kinematics.type", "lathe_xz", "LATHE = 1")
        source.draft.put("dialect.plane", 18, "LATHE = 1")
    if source.word(("emcio", "tool_table")):
        source.draft.left.append("the tool table: give it by --tools")
    return letters


def _startup(source, unit):
    """What is in force before a program says G61 or G64; without both LinuxCNC has a bare G64."""
    code = source.word(("rs274ngc", "rs274ngc_startup_code"))
    words = re.sub(r"\s+", "", code or "").upper()
    within = re.search(r"G64P([\d.]+)", words)
    if within and _NUMBER.fullmatch(within[1]):
        source.draft.put("path.tolerance_mm", Decimal(within[1]) * unit, f"start-up code {code}")
    elif re.search(r"G61(?!\d)", words):
        source.draft.put("path.tolerance_mm", 0, f"start-up code {code}")
    else:
        words = f"start-up code {code}" if code else "no start-up code: G64 without P"
        source.draft.put("control.g64_without_p", "length", words)
        return
    source.draft.put("control.g64_without_p", "tolerance", f"start-up code {code}")


def _fill_grbl(source):
    has = source.settings
    letters = [letter for k, letter in enumerate("xyzabc") if ("$", f"{110 + k}") in has]
    for letter in letters:
        k = "xyzabc".index(letter)
        source.axis(letter, "v_max", [("$", f"{110 + k}")], 1 / Decimal(60))
        source.axis(letter, "a_max", [("$", f"{120 + k}")])
        travel, comment = source.number(("$", f"{130 + k}"))
        if travel:
            source.draft.axis(letter, "min", -travel, comment)
            source.draft.axis(letter, "max", Decimal(0), "homed at the upper end, as grbl does")
        source.own(f"steps_per_mm.{letter}", [("$", f"{100 + k}")])
    source.path("path.chord_error_mm", [("$", "12")])
    source.path("spindle.rpm_max", [("$", "30")])
    is_hal = ("$", "398") in has or ("i", "firmware") in has
    words = "its settings say so" if is_hal else 'grblHAL writes the same: then say "grblhal"'
    source.draft.put("control.kind", "grblhal" if is_hal else "grbl", words)
    source.own("junction_deviation", [("$", "11")], Decimal("0.01"))
    source.own("arc_tolerance", [("$", "12")], Decimal("0.002"))
    laser, comment = source.number(("$", "32"))
    source.draft.put("control.laser_mode", laser == 1, comment or "not in the source: off")
    blocks, comment = source.number(("$", "398"), ("i", "blocks"))
    if blocks is not None:
        source.draft.put("control.planner_blocks", blocks + (("$", "398") not in has), comment)
    source.draft.put("dialect.base", "grbl")
    return letters


def _fill_klipper(source):
    kinematics = source.word(("printer", "kinematics")) or "cartesian"
    if kinematics not in ("cartesian", "corexy", "corexz", "hybrid_corexy", "hybrid_corexz"):
        source.draft.problems.append(("printer.kinematics", f"{kinematics} has no equal here"))
    letters = source.letters_of("stepper_", "xyz")
    for letter in letters:
        own = [("printer", f"max_{letter}_velocity"), ("printer", "max_velocity")]
        source.axis(letter, "v_max", own)
        source.axis(letter, "a_max", [("printer", f"max_{letter}_accel"), ("printer", "max_accel")])
        source.axis(letter, "min", [(f"stepper_{letter}", "position_min")])
        source.axis(letter, "max", [(f"stepper_{letter}", "position_max")])
        if source.draft.limit(letter, "min") is None:
            source.draft.axis(letter, "min", Decimal(0), "position_min is 0 unless it is told")
    source.path("path.feed_max_mm_min", [("printer", "max_velocity")], Decimal(60))
    source.path("path.a_max_mm_s2", [("printer", "max_accel")])
    _own_klipper(source)
    source.draft.put("dialect.base", "marlin")
    source.draft.put("dialect.feed_default_mm_min", 1500, "until the first F, as Klipper has it")
    if "extruder" in source.form.heads.values():
        source.axes.add("extruder")
        _extruder(source)
        letters = [*letters, "u"]
    return letters


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
    for key, default in _EXTRUDER.items():
        source.own(key, [("extruder", key)], default)
    arcs = "gcode_arcs" in source.form.heads.values()
    if arcs:
        source.axes.add("gcode_arcs")
        source.own("resolution", [("gcode_arcs", "resolution")], Decimal(1))
    else:
        source.draft.left.append("no [gcode_arcs]: Klipper knows no G2 and G3; their time is told")


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
    for end in ("min", "max"):
        source.draft.put(f"axis.u.{end}_mm", "free")


_PI = Decimal("3.14159265358979")


def _fill_fluidnc(source):
    letters = source.letters_of("axes.", AXES)
    for letter in letters:
        own = f"axes.{letter}"
        source.axis(letter, "v_max", [(own, "max_rate_mm_per_min")], 1 / Decimal(60))
        source.axis(letter, "a_max", [(own, "acceleration_mm_per_sec2")])
        travel, comment = source.number((own, "max_travel_mm"))
        at, _ = source.number((f"{own}.homing", "mpos_mm"))
        up = (source.word((f"{own}.homing", "positive_direction")) or "true").lower() == "true"
        if travel:
            at = at or Decimal(0)
            ends = (at - travel, at) if up else (at, at + travel)
            for end, place in zip(("min", "max"), ends, strict=True):
                source.draft.axis(letter, end, place, comment)
        source.own(f"steps_per_mm.{letter}", [(own, "steps_per_mm")])
    source.path("path.chord_error_mm", [("", "arc_tolerance_mm")])
    source.draft.put("control.kind", "fluidnc")
    source.own("junction_deviation", [("", "junction_deviation_mm")], Decimal("0.01"))
    source.own("arc_tolerance", [("", "arc_tolerance_mm")], Decimal("0.002"))
    source.own("planner_blocks", [("", "planner_blocks")])
    source.draft.put("dialect.base", "grbl")
    return letters


def _fill_marlin(source):
    has = source.settings
    letters = [letter for letter in AXES if ("m203", letter) in has]
    if ("", "g20") in has:
        source.draft.problems.append(("M503", "in inches: send G21 before M503"))
    source.draft.put("control.kind", "marlin")
    extrudes = ("m203", "e") in has
    for own in [*letters, *(["e"] if extrudes else [])]:
        letter = "u" if own == "e" else own
        source.axis(letter, "v_max", [("m203", own)])
        source.axis(letter, "a_max", [("m201", own)])
        source.own(f"steps_per_mm.{own}", [("m92", own)])
        if ("m205", "j") not in has:
            source.own(f"jerk.{own}", [("m205", own)])
    for key, word in (("acceleration", "p"), ("travel_acceleration", "t"),
                      ("retract_acceleration", "r")):  # fmt: skip
        source.own(key, [("m204", word), ("m204", "s")])
    source.own("min_segment_time_us", [("m205", "b")])
    _deviation_of_marlin(source)
    if extrudes:
        letters = [*letters, "u"]
        for end in ("min", "max"):
            source.draft.put(f"axis.u.{end}_mm", "free")
    source.draft.left.append("travel: M503 does not have it; taken as free")
    source.draft.put("dialect.base", "marlin")
    source.draft.put("dialect.feed_default_mm_min", 1500, "until the first F, as Marlin has it")
    return letters


def _deviation_of_marlin(source):
    deviation, comment = source.number(("m205", "j"))
    if deviation is None:
        return
    source.draft.put("control.junction_deviation", deviation, comment)
    if deviation.as_tuple().exponent >= -2:
        source.draft.left.append(
            f"{comment}: M503 prints two decimals, so J0.01 may be 0.005 to 0.015; "
            "Configuration.h has it whole: JUNCTION_DEVIATION_MM"
        )


_PRINTERS = ("Klipper (printer.cfg)", "Marlin (M503)", "RepRapFirmware (config.g)")
_READERS = {
    "LinuxCNC (INI)": (forms.linuxcnc, _fill_linuxcnc),
    "grbl or grblHAL ($$)": (forms.grbl, _fill_grbl),
    "Klipper (printer.cfg)": (forms.klipper, _fill_klipper),
    "FluidNC (YAML)": (forms.fluidnc, _fill_fluidnc),
    "Marlin (M503)": (forms.marlin, _fill_marlin),
}
