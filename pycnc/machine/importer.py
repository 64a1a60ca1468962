# SPDX-License-Identifier: MIT
"""Machine files from the configurations of other controls.

Units are converted; each value has the line that it comes from as its comment; what a machine file
has no equal for is told.
"""

import re
from decimal import Decimal
from pathlib import Path

from pycnc import errors
from pycnc.machine.draft import OWN_DEFAULT, Draft
from pycnc.machine.foreign import kind_of
from pycnc.machine.of_mills import fluidnc, grbl, linuxcnc
from pycnc.machine.of_printers import klipper, marlin, reprap
from pycnc.machine.source import FORMS

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d{1,3})?", re.ASCII)
_MOTION = re.compile(  # what has to do with motion, and no equal here
    r"backlash|accel_to_decel|ferror|stepgen_maxvel|stepgen_maxaccel|max_joint|input_shap"
    r"|pressure_advance|shaper_freq|\bM(566|572|593|955|956)\b", re.I,
)  # fmt: skip


class Source:
    """The settings of a foreign file, and the draft that is made of them."""

    def __init__(self, file, form, kind, units=None, deviation=None):
        self.form, self.settings, self.used = form, form.settings, set()
        self.units, self.deviation = units, deviation  # as the caller says them
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
                problem = place, f"{setting.value!r} is no number: {text}"
                if problem not in self.draft.problems:
                    self.draft.problems.append(problem)
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

    def axis(self, letter, quantity, keys, scale=Decimal(1), default=None):
        """Set a limit of an axis from the first of some keys, else the control's own default."""
        value, comment = self.number(*keys)
        if value is not None or default is not None:
            given = default if value is None else value
            self.draft.axis(letter, quantity, given * scale, comment or OWN_DEFAULT)

    def tightest(self, letter, quantity, pick, keys, scale=Decimal(1)):
        """Set an axis' limit from some keys that all count: what pick, min or max, takes."""
        found = [each for each in (self.number(key) for key in keys) if each[0] is not None]
        if found:
            value, comment = pick(found, key=lambda each: each[0])
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
        given = default if value is None else value * scale
        self.draft.put(f"control.{key}", given, comment or OWN_DEFAULT)

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


def read(text, file, folder=None, units=None, deviation=None):
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
    deviation : Decimal, optional
        Marlin's junction deviation [mm], of which M503 shows two decimals.

    Raises
    ------
    ArgumentError
        If it is none that is known.
    """
    kind = kind_of(text)
    if kind is None:
        known = ", ".join(_FILLS)
        raise errors.ArgumentError(
            f"{file}: is no configuration that can be imported: {known}", id="import"
        )
    place = None if folder is None else Path(folder, file)
    source = Source(file, FORMS[kind](text, place), kind, units, deviation)
    if source.draft.problems:  # a part of it is not there
        return source.draft
    letters = _FILLS[kind](source)
    if not letters and not source.draft.problems:
        source.draft.problems.append(("", f"no axis found: {_AXES_IN[kind]} would tell of one"))
    if kind not in _PRINTERS:  # of a printer it is the bed's
        source.draft.put("work.zero", "unknown", "whoever clamps the work sets it: --zero says it")
    source.draft.complete(letters)
    source.tell_left()
    return source.draft


_PRINTERS = ("Klipper (printer.cfg)", "Marlin (M503)", "RepRapFirmware (config.g)")
_AXES_IN = {  # where a whole configuration has them
    "LinuxCNC (INI)": "[AXIS_X] or [JOINT_0]", "grbl or grblHAL ($$)": "$110=…",
    "Klipper (printer.cfg)": "[stepper_x]", "FluidNC (YAML)": "axes: x:",
    "RepRapFirmware (config.g)": "M203 X…", "Marlin (M503)": "M203 X…",
}  # fmt: skip
_FILLS = {
    "LinuxCNC (INI)": linuxcnc, "grbl or grblHAL ($$)": grbl, "Klipper (printer.cfg)": klipper,
    "FluidNC (YAML)": fluidnc, "RepRapFirmware (config.g)": reprap, "Marlin (M503)": marlin,
}  # fmt: skip
