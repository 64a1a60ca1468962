# SPDX-License-Identifier: MIT
"""Configurations of other controls: which one a text is."""

import re

_STAMP = r"^[ \t]*(\[?\d\d?:\d\d:\d\d(\.\d+)?\]?[ \t]*)?((->|>+)[ \t]*)?"  # what a terminal adds
_SIGNS = {  # of each a line that its files have and the others' do not
    "grbl or grblHAL ($$)": _STAMP + r"\$1[0-3][0-9][ \t]*=",
    "Klipper (printer.cfg)": r"^[ \t]*\[(stepper_\w+|printer|mcu( \w+)?|include [^]]+"
                             r"|board_pins\b.*|gcode_macro [^]]+|extruder\d*"
                             r"|tmc\d{4} [^]]+|display\w*( \w+)?"
                             r"|carriage \w+|neopixel [^]]+|duplicate_pin_override)\]",
    "LinuxCNC (INI)": r"^[ \t]*(\[(EMC|TRAJ|KINS|AXIS_\w|JOINT_\d+)\]|#INCLUDE\b)",
    "RepRapFirmware (config.g)": r"^[ \t]*M(584|566|667|669)[ \t]+[A-Z]",
    "Marlin (M503)": _STAMP + r"(Recv:[ \t]*)?(echo:)?[ \t]*M(92|201|203)[ \t]+[XYZE][\d.]+[ \t]",
    "FluidNC (YAML)": r"^axes:[ \t]*(#.*)?\r?$",
}  # fmt: skip


def kind_of(text):
    """Return the control that a configuration is of; None if it is none of those that we know.

    Examples
    --------
    >>> kind_of("[stepper_x]\\nstep_pin: PF0\\n")
    'Klipper (printer.cfg)'
    """
    return next((name for name, sign in _SIGNS.items() if re.search(sign, text, re.M)), None)
