# SPDX-License-Identifier: MIT
"""Machine files from the configurations of LinuxCNC, grbl and grblHAL, Klipper and FluidNC.

Units are converted; each value has the line that it comes from as its comment; what a machine file
has no equal for is told.
"""

import re
from decimal import Decimal, InvalidOperation
from typing import NamedTuple

from pycnc import errors
from pycnc.machine import foreign
from pycnc.machine.draft import Draft
from pycnc.machine.schema import AXES, ROTARY_AXES

_MM = {  # LINEAR_UNITS of LinuxCNC → millimetres
    **dict.fromkeys(("mm", "metric"), Decimal(1)), "cm": Decimal(10), "um": Decimal("1e-3"),
    **dict.fromkeys(("inch", "in", "imperial"), Decimal("25.4")),
}  # fmt: skip
_ELSEWHERE = re.compile(r"^\s*(#INCLUDE\s+\S+|\[include\s+.+\])", re.M)
_MOTION = re.compile(  # what has to do with motion, and no equal here
    r"junction_deviation|square_corner|backlash|instant_corner|accel_to_decel|minimum_cruise|ferror"
    r"|stepgen_maxvel|stepgen_maxaccel|max_joint|input_shap|pressure_advance|shaper_freq", re.I,
)  # fmt: skip


class Setting(NamedTuple):
    """A setting of a foreign file."""

    value: str
    line: int
    text: str  # the line


class Source:
    """The settings of a foreign file, and the draft that is made of them."""

    def __init__(self, file, settings, kind):
        self.file, self.settings, self.used = file, settings, set()
        self.draft = Draft(f"imported from {file} ({kind})")

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
                comment = f"line {setting.line}: {setting.text}"
                try:
                    number = Decimal(setting.value)
                except InvalidOperation:
                    number = Decimal("NaN")
                if number.is_finite():
                    return number, comment
                self.draft.problems.append(
                    (f"line {setting.line}", f"{setting.value!r} is no number: {setting.text}")
                )
                return None, ""
        return None, ""

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

    def tell_left(self):
        """Say what has to do with motion and has not been used, and count the rest."""
        rest = 0
        for key, setting in self.settings.items():
            if key in self.used or not key[-1]:  # used, or the head of a section
                continue
            if _MOTION.search(key[-1]):
                self.draft.left.append(f"line {setting.line}: {setting.text}")
            else:
                rest += 1
        if rest:
            self.draft.left.append(f"{rest} more that are not about the motion of axes")


def read(text, file):
    """Return the draft of a machine file from a foreign configuration.

    Parameters
    ----------
    text : str
    file : str
        Its name, for comments and messages.

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
    source = Source(file, parse(text), kind)
    letters = fill(source)
    for found in _ELSEWHERE.finditer(text):
        number = text.count("\n", 0, found.start(1)) + 1
        source.draft.left.append(f"line {number}: {found[1]} (what stands there is not read)")
    if not letters:
        source.draft.problems.append(("", "no axis found"))
    source.draft.complete(letters)
    source.tell_left()
    return source.draft


# ---- the forms of files: (section, key) → Setting, keys in lower case


def _sections(text):
    """Read [section] and key = value or key: value."""
    found, section = {}, ""
    for number, line in enumerate(text.splitlines(), 1):
        bare = re.split(r"(?:^|\s)[#;]", line, maxsplit=1)[0].strip()
        head = re.fullmatch(r"\[(.+)\]", bare)
        pair = re.match(r"([^=:\s][^=:]*?)\s*[=:]\s*(.*)", bare)
        if head:
            section = head[1].strip().lower()
            found.setdefault((section, ""), Setting("", number, bare))
        elif pair and not line[:1].isspace():
            key = (section, pair[1].lower())
            found.setdefault(key, Setting(pair[2], number, " ".join(bare.split())))
    return found


def _dollars(text):
    """Read $110=500.000."""
    found = {}
    for number, line in enumerate(text.splitlines(), 1):
        pair = re.match(r"\s*\$(\d+)\s*=\s*([^\s(]+)", line)
        if pair:
            found[("$", int(pair[1]))] = Setting(pair[2], number, " ".join(line.split()))
    return {(section, str(key)): setting for (section, key), setting in found.items()}


def _indented(text):
    """Read the maps of YAML: the section of a key is the keys that it stands under."""
    found, above = {}, []
    for number, line in enumerate(text.splitlines(), 1):
        bare = re.split(r"(?:^|\s)#", line, maxsplit=1)[0].rstrip()
        pair = re.match(r"(\s*)([\w.\-]+)\s*:\s*(.*)", bare)
        if not pair:
            continue
        depth = len(pair[1].expandtabs())
        above = [each for each in above if each[0] < depth]
        section = ".".join(name for _, name in above)
        if pair[3]:
            value = pair[3].strip("\"'")
            found[(section, pair[2].lower())] = Setting(value, number, " ".join(bare.split()))
        else:
            above.append((depth, pair[2].lower()))
    return found


# ---- what they mean


def _fill_linuxcnc(source):
    units = (source.word(("traj", "linear_units")) or "mm").lower()
    if units not in _MM:
        known = ", ".join(_MM)
        source.draft.problems.append(("LINEAR_UNITS", f"{units!r} is none of {known}"))
    unit = _MM.get(units, Decimal(1))
    letters = re.sub("[^a-z]", "", (source.word(("traj", "coordinates")) or "xyz").lower())
    letters = [letter for letter in AXES if letter in letters]
    kinematics = source.word(("kins", "kinematics")) or "trivkins"
    if not kinematics.startswith("trivkins"):
        source.draft.left.append(f"kinematics {kinematics}: the axes are taken as joints")
    for joint, letter in enumerate(letters):
        rotary = letter in ROTARY_AXES
        scale = Decimal(1) if rotary else unit
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
    if unit == _MM["inch"]:
        source.draft.put("dialect.units", "inch", "LINEAR_UNITS")
    if source.word(("display", "lathe")) == "1" and letters == ["x", "z"]:
        source.draft.put("kinematics.type", "lathe_xz", "LATHE = 1")
        source.draft.put("dialect.plane", 18, "LATHE = 1")
    if source.word(("emcio", "tool_table")):
        source.draft.left.append("the tool table: give it by --tools")
    return letters


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
    source.path("path.chord_error_mm", [("$", "12")])
    source.path("spindle.rpm_max", [("$", "30")])
    deviation, comment = source.number(("$", "11"))
    if deviation is not None:
        source.draft.left.append(f"{comment} (junction deviation; see path.tolerance_mm)")
    source.draft.put("dialect.base", "grbl")
    return letters


def _fill_klipper(source):
    kinematics = source.word(("printer", "kinematics")) or "cartesian"
    if kinematics not in ("cartesian", "corexy", "corexz", "hybrid_corexy", "hybrid_corexz"):
        source.draft.problems.append(("printer.kinematics", f"{kinematics} has no equal here"))
    sections = {section for section, _ in source.settings}
    letters = [letter for letter in "xyz" if f"stepper_{letter}" in sections]
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
    source.draft.put("dialect.base", "marlin")
    source.draft.put("dialect.feed_default_mm_min", 1800, "until the first F; not in the source")
    return letters


def _fill_fluidnc(source):
    sections = {section for section, _ in source.settings}
    letters = [letter for letter in AXES if f"axes.{letter}" in sections]
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
    source.path("path.chord_error_mm", [("", "arc_tolerance_mm")])
    source.draft.put("dialect.base", "grbl")
    return letters


_READERS = {
    "LinuxCNC (INI)": (_sections, _fill_linuxcnc),
    "grbl or grblHAL ($$)": (_dollars, _fill_grbl),
    "Klipper (printer.cfg)": (_sections, _fill_klipper),
    "FluidNC (YAML)": (_indented, _fill_fluidnc),
}
