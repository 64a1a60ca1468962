# SPDX-License-Identifier: MIT
"""Settings as the kernel has them: exact decimals become its units and numbers."""

from decimal import ROUND_HALF_EVEN

import numpy as np

from pycnc.kernel.bind import lib
from pycnc.kernel.records import counts_per_unit, dtype, quantity_range
from pycnc.machine.own import g_code
from pycnc.machine.schema import (
    AXES,
    ROTARY_AXES,
    WORK_SYSTEMS,
    Position,
    approach_axis,
    unit_of,
)

_FREE = (np.iinfo(np.int64).min, np.iinfo(np.int64).max)
_KINEMATICS = {"identity": lib.NCK_KINEMATICS_IDENTITY, "lathe_xz": lib.NCK_KINEMATICS_LATHE_XZ}
_SLOPES = {
    "optimal": lib.NCK_SLOPE_OPTIMAL,
    "linear": lib.NCK_SLOPE_LINEAR,
    "jerk": lib.NCK_SLOPE_JERK,
}
_DIALECTS = {
    "linuxcnc": lib.NCK_DIALECT_LINUXCNC,
    "fanuc": lib.NCK_DIALECT_FANUC,
    "grbl": lib.NCK_DIALECT_GRBL,
    "marlin": lib.NCK_DIALECT_MARLIN,
    "grblhal": lib.NCK_DIALECT_GRBLHAL,
}
_SYSTEMS = {
    None: lib.NCK_SYSTEM_OPEN,
    "A": lib.NCK_SYSTEM_A,
    "B": lib.NCK_SYSTEM_B,
    "C": lib.NCK_SYSTEM_C,
}
_D_OFFSETS = {
    None: lib.NCK_D_OPEN,
    "radius": lib.NCK_D_RADIUS,
    "diameter": lib.NCK_D_DIAMETER,
}
_INTEGERS = {
    None: lib.NCK_INTEGERS_OPEN,
    "units": lib.NCK_INTEGERS_UNITS,
    "increments": lib.NCK_INTEGERS_INCREMENTS,
}
_COMP_STARTS = {
    None: lib.NCK_COMP_START_OPEN,
    "rs274": lib.NCK_COMP_START_RS274,
    "A": lib.NCK_COMP_START_A,
    "B": lib.NCK_COMP_START_B,
}
_PROBES = {
    "refused": lib.NCK_PROBE_REFUSED,
    "misses": lib.NCK_PROBE_MISSES,
    "touches": lib.NCK_PROBE_TOUCHES,
}
_FEEDS = {
    None: lib.NCK_FEED_START_OPEN,
    "per_minute": lib.NCK_FEED_START_MINUTE,
    "per_rev": lib.NCK_FEED_START_REV,
}
_ACTIONS = {
    "note": lib.NCK_G_NOTE,
    "ignore": lib.NCK_G_IGNORE,
    "tolerance": lib.NCK_G_TOLERANCE,
}
DIALECTS = frozenset(_DIALECTS)


def _counts(value, letter):
    """Return exact nanometres (or nanodegrees) of an axis, rounded half to even."""
    counts = int(counts_per_unit(letter in ROTARY_AXES))
    return int((value * counts).to_integral_value(rounding=ROUND_HALF_EVEN))


def rows_of(settings):
    """Return the kernel's machine as an array of one record."""
    rows = np.zeros(1, dtype("nck_machine_t"))
    record = rows[0]
    record["period_s"] = float(settings.kernel.period_ms / 1000)
    for letter, axis in settings.axis.present().items():
        _fill_axis(record["axis"][AXES.index(letter)], letter, axis)
    _fill_path(record, settings.path)
    record["kinematics"] = _KINEMATICS[settings.kinematics.type]
    record["spindle"]["rpm_max"] = float(settings.spindle.rpm_max)
    record["spindle"]["a_max_rpm_s"] = float(settings.spindle.a_max_rpm_s)
    record["spindle_waits"] = settings.spindle.waits
    record["firmware"] = _firmware(settings.control)
    _fill_dialect(record["dialect"], settings)
    _fill_approach(record["approach"], settings)
    _fill_positions(record, settings)
    _fill_tools(record, settings.tool)
    _fill_own_m(record, settings.m)
    _fill_own_g(record, settings.g)
    _fill_further(record, settings.work.p)
    _fill_clock(record["clock"], settings.dialect.clock)
    return rows


def _fill_axis(row, letter, axis):
    unit = unit_of(letter)
    v_max, rapid = getattr(axis, f"v_max_{unit}_s"), getattr(axis, f"rapid_{unit}_s")
    row["present"], row["rotary"] = 1, letter in ROTARY_AXES
    row["v_max"], row["rapid"] = float(v_max), float(v_max if rapid is None else rapid)
    row["a_max"] = float(getattr(axis, f"a_max_{unit}_s2"))
    row["j_max"] = float(getattr(axis, f"j_max_{unit}_s3"))
    for field, free in zip(("min", "max"), _FREE, strict=True):
        value = getattr(axis, f"{field}_{unit}")
        row[f"{field}_nm"] = free if value is None else _counts(value, letter)


def _together(axes, kind, quantity):
    """Return what all axes give along the path together, within the range of path limits."""
    most = float(quantity_range(quantity)[1])
    return min(most, float(np.sqrt(np.sum(axes[kind] ** 2))))


def _fill_path(record, path):
    axes = record["axis"][record["axis"]["present"] == 1]
    kinds = {"v_max": "speed", "a_max": "acceleration", "j_max": "jerk"}
    together = {kind: _together(axes, kind, quantity) for kind, quantity in kinds.items()}
    row = record["path"]
    row["feed_max"] = (
        together["v_max"] if path.feed_max_mm_min is None else float(path.feed_max_mm_min / 60)
    )
    row["a_max"] = together["a_max"] if path.a_max_mm_s2 is None else float(path.a_max_mm_s2)
    row["j_max"] = together["j_max"] if path.j_max_mm_s3 is None else float(path.j_max_mm_s3)
    row["chord_error"] = float(path.chord_error_mm)
    row["tolerance"] = float(path.tolerance_mm)
    row["arc_radius"] = float(path.arc_radius_mm)
    record["lookahead_blocks"] = path.lookahead_blocks
    record["slope"] = _SLOPES[path.slope]


def base_number(settings):
    """Return the kernel's number of ``dialect.base``; "auto": LinuxCNC's, until a text tells.

    grblHAL has words that grbl has not.
    """
    base, kind = settings.dialect.base, settings.control.kind
    name = kind if (base, kind) == ("grbl", "grblhal") else base
    return _DIALECTS.get(name, lib.NCK_DIALECT_LINUXCNC)


def _firmware(control):
    """Return whose firmware a printer has."""
    if control.kind == "klipper":
        return lib.NCK_FIRMWARE_KLIPPER
    return lib.NCK_FIRMWARE_REPRAP if control.reprap else lib.NCK_FIRMWARE_MARLIN


def _fill_dialect(row, settings):
    dialect = settings.dialect
    row["base"] = base_number(settings)
    row["system"] = _SYSTEMS[dialect.system]
    row["feed"] = _FEEDS[dialect.feed]
    row["d_offset"] = _D_OFFSETS[dialect.d_offset]
    row["integers"] = _INTEGERS[dialect.integers]
    row["comp_start"] = _COMP_STARTS[dialect.comp_start]
    row["probe"] = _PROBES[dialect.probe]
    row["scale_unit"] = float(dialect.scale_unit)
    row["thread_pull"] = float(dialect.thread_pull_leads)
    row["diameter"], row["inch"] = dialect.diameter, dialect.units == "inch"
    row["plane"], row["arc_absolute"] = dialect.plane, dialect.arc_centre == "absolute"
    row["block_skip"], row["optional_stop"] = dialect.block_skip, dialect.optional_stop
    row["skip_switches"] = sum(1 << int(digit) for digit in set(dialect.skip_switches))
    row["from_line"] = dialect.from_line
    row["feed_default"] = float(dialect.feed_default_mm_min)


def _fill_approach(row, settings):
    approach, letter = settings.approach, approach_axis(settings.approach, settings.kinematics)
    height = approach.height_mm
    row["height_nm"] = _FREE[1] if height is None else _counts(height, letter)
    row["feed"] = float(approach.feed_mm_min / 60)
    row["axis"] = 0 if approach.axis is None else 1 + AXES.index(approach.axis)


def _fill_positions(record, settings):
    more = settings.home.g30_p3, settings.home.g30_p4
    homes = (settings.home.g28, settings.home.g30, *[each or Position() for each in more])
    record["home_more"] = sum(1 << k for k, home in enumerate(more) if home is not None)
    for index, letter in enumerate(AXES):
        record["start_nm"][index] = _counts(settings.start.along(letter), letter)
        for row, home in enumerate(homes):
            record["home_nm"][row][index] = _counts(home.along(letter), letter)
        for row, name in enumerate(WORK_SYSTEMS):
            place = getattr(settings.work, name).along(letter)
            record["work_nm"][row][index] = _counts(place, letter)
    record["work_system"] = WORK_SYSTEMS.index(settings.start.work_system)


def _fill_tools(record, tools):
    record["tool_count"] = len(tools)
    for row, (number, tool) in zip(record["tool"], tools.items(), strict=False):
        row["number"], row["orientation"] = int(number), tool.orientation
        offset = {"x": tool.x_mm, "y": tool.y_mm, "z": tool.length_mm}
        row["offset_nm"] = [_counts(value, letter) for letter, value in offset.items()]
        row["radius_mm"] = float(tool.radius_mm)
        row["wear_mm"] = float(tool.radius_wear_mm)


def _fill_own_m(record, codes):
    record["own_m_count"] = len(codes)
    for row, (number, code) in zip(record["own_m"], codes.items(), strict=False):
        row["code"], row["waits"] = int(number), code.action == "wait"
        row["stays"] = code.stays


def _fill_own_g(record, codes):
    record["own_g_count"] = len(codes)
    for row, (name, own) in zip(record["own_g"], codes.items(), strict=False):
        row["code"], letter, row["value"] = g_code(name) or (0, "", 0)
        row["letter"] = ord(letter) if letter else 0
        row["action"] = _ACTIONS[own.action]
        row["tolerance"] = float(own.tolerance_mm)


def _fill_clock(row, clock):
    if clock:
        date, time = clock.split()
        row["date"], row["time"] = int(date.replace("-", "")), int(time.replace(":", ""))


def _fill_further(record, places):
    record["work_more_count"] = len(places)
    for row, (number, place) in zip(record["work_more"], places.items(), strict=False):
        row["number"] = int(number)
        row["zero_nm"] = [_counts(place.along(letter), letter) for letter in AXES]
