# SPDX-License-Identifier: MIT
"""What in a machine file does not go together: keys that are good alone and wrong beside others."""

from pycnc.machine.control import contradictions as of_control
from pycnc.machine.inputs import contradictions as of_inputs
from pycnc.machine.own import code_problems
from pycnc.machine.schema import TOLERANCE_LEAST_MM, approach_axis, position_key, unit_of
from pycnc.names import AXES, WORK_SYSTEMS


def of(machine):
    """Yield (path to key, message) for numbers that are good alone and wrong together."""
    axes = machine.axis.present()
    for letter, axis in axes.items():
        yield from _axis_contradictions(letter, axis)
    for name, position in _positions(machine):
        yield from _position_contradictions(
            name, position, axes, travel=not name.startswith("work.")
        )
    if 0 < machine.path.tolerance_mm < TOLERANCE_LEAST_MM:
        yield "path.tolerance_mm", f"must be 0 (exact path) or {TOLERANCE_LEAST_MM} at least"
    if machine.path.lookahead_blocks == 1:
        yield "path.lookahead_blocks", "must be 0 (all) or 2 at least"
    if machine.kinematics.type == "lathe_xz" and set(axes) != {"x", "z"}:
        yield (
            "kinematics.type",
            f"lathe_xz needs the axes X and Z alone (the file has {', '.join(axes).upper()})",
        )
    yield from of_control(machine.control, axes)
    yield from of_inputs(machine.inputs, axes)
    yield from _approach_contradictions(machine.approach, machine.kinematics, axes)
    yield from code_problems(machine)
    for number in machine.tool:
        if not (
            number.isdecimal()
            and number.isascii()
            and 0 < int(number) < 10**8
            and number == str(int(number))
        ):
            yield f"tool.{number}", "a tool's name is its number, 1 to 99999999, as in [tool.1]"


def _axis_contradictions(letter, axis):
    unit = unit_of(letter)
    v_max, rapid = getattr(axis, f"v_max_{unit}_s"), getattr(axis, f"rapid_{unit}_s")
    low, high = getattr(axis, f"min_{unit}"), getattr(axis, f"max_{unit}")
    if rapid is not None and rapid > v_max:
        yield (
            f"axis.{letter}.rapid_{unit}_s",
            f"must not be above v_max_{unit}_s = {v_max} (is {rapid})",
        )
    if low is not None and high is not None and low >= high:
        yield f"axis.{letter}.min_{unit}", f"must be below max_{unit} = {high} (is {low})"


def _approach_contradictions(approach, kinematics, axes):
    letter, height = approach_axis(approach, kinematics), approach.height_mm
    if letter not in axes:
        for key in ("axis", "height_mm"):
            if getattr(approach, key) is not None:
                yield f"approach.{key}", f"the machine has no {letter.upper()} axis"
        return
    low, high = axes[letter].min_mm, axes[letter].max_mm
    if height is not None and ((low is not None and height < low)
                               or (high is not None and height > high)):  # fmt: skip
        yield (
            "approach.height_mm",
            f"must be within the travel of {letter.upper()} {_bound(low)} … {_bound(high)} "
            f"(is {height})",
        )


def _positions(machine):
    yield "start", machine.start
    yield "home.g28", machine.home.g28
    yield "home.g30", machine.home.g30
    for name in ("g30_p3", "g30_p4"):
        if (place := getattr(machine.home, name)) is not None:
            yield f"home.{name}", place
    for name in WORK_SYSTEMS:
        yield f"work.{name}", getattr(machine.work, name)
    for number, position in machine.work.p.items():
        yield f"work.p.{number}", position


def _position_contradictions(name, position, axes, travel):
    for letter in AXES:
        value, key = position.along(letter), f"{name}.{position_key(letter)}"
        if letter not in axes:
            if value != 0:
                yield key, f"the machine has no {letter.upper()} axis"
            continue
        if travel:
            yield from _travel_contradictions(key, value, axes[letter], unit_of(letter))


def _travel_contradictions(key, value, axis, unit):
    low, high = (getattr(axis, f"{end}_{unit}") for end in ("min", "max"))
    if low is not None and high is not None and low >= high:
        return  # told as the axis' own
    if (low is not None and value < low) or (high is not None and value > high):
        yield key, f"must be within the travel {_bound(low)} … {_bound(high)} (is {value})"


def _bound(value):
    return "free" if value is None else value
