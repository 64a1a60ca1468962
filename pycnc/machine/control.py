# SPDX-License-Identifier: MIT
"""Whose planner the machine has: the control's own settings, by its own names."""

from decimal import Decimal
from typing import Annotated, Literal, get_args

from pydantic import BeforeValidator, Field, model_validator

from pycnc.machine.quantity import Acceleration, Error, Number, Speed, Table, number

Kind = Literal["nck", "nck_tp", "klipper", "grbl", "grblhal", "fluidnc", "marlin", "linuxcnc"]
KINDS = get_args(Kind)
NCKS = ("nck", "nck_tp")
GRBLS = ("grbl", "grblhal", "fluidnc")
PRINTERS = ("klipper", "marlin")

Ratio = Annotated[Number, Field(ge=0, le=Decimal("0.999")), BeforeValidator(number)]
Deviation = Annotated[Number, Field(ge=0, le=10), BeforeValidator(number)]
Corner = Annotated[Number, Field(ge=0, le=10_000), BeforeValidator(number)]
Diameter = Annotated[Number, Field(ge=Decimal("0.01"), le=100), BeforeValidator(number)]
Steps = Annotated[Number, Field(ge=Decimal("0.001"), le=1_000_000), BeforeValidator(number)]
Blocks = Annotated[int, Field(ge=3, le=1000)]


class ByAxis(Table):
    """One number for each axis; E is the extruder, the axis U of a machine file."""

    x: Steps | None = Field(None, description="X.")
    y: Steps | None = Field(None, description="Y.")
    z: Steps | None = Field(None, description="Z.")
    a: Steps | None = Field(None, description="A.")
    b: Steps | None = Field(None, description="B.")
    c: Steps | None = Field(None, description="C.")
    e: Steps | None = Field(None, description="E, the extruder.")

    def present(self):
        """Return what is said: letter of a machine file's axis → number."""
        said = {letter: getattr(self, letter) for letter in type(self).model_fields}
        return {"u" if at == "e" else at: value for at, value in said.items() if value is not None}


class Control(Table):
    """Whose planner the time is told of, with that control's own settings and defaults.

    A kind alone stands for a table of it: ``control = "grbl"``.
    """

    @model_validator(mode="before")
    @classmethod
    def _of_kind(cls, said):
        return {"kind": said} if isinstance(said, str) else said

    kind: Kind = Field(
        "nck",
        description="`nck`: this kernel; `nck_tp`: with the capacities of its module for LinuxCNC, "
        "which look less far ahead. Any other: times are told by that control's own rules "
        "(controls.md), with the axes' v_max and a_max, without jerk.",
    )
    max_velocity: Speed | None = Field(
        None, description="Klipper: highest speed along the path. Default: `feed_max_mm_min`."
    )
    max_accel: Acceleration | None = Field(
        None, description="Klipper: acceleration along the path. Default: `path.a_max_mm_s2`."
    )
    max_z_velocity: Speed | None = Field(
        None, description="Klipper: highest speed of Z. Default: `max_velocity`."
    )
    max_z_accel: Acceleration | None = Field(
        None, description="Klipper: acceleration of Z. Default: `max_accel`."
    )
    square_corner_velocity: Corner = Field(
        Decimal(5), description="Klipper: speed [mm/s] at which a right angle is passed."
    )
    minimum_cruise_ratio: Ratio = Field(
        Decimal("0.5"), description="Klipper: share of a short move that is not ramp."
    )
    instantaneous_corner_velocity: Corner = Field(
        Decimal(1), description="Klipper: step of the extruder's speed [mm/s]."
    )
    max_extrude_only_velocity: Speed | None = Field(
        None, description="Klipper: filament alone, speed. Default: by nozzle and filament."
    )
    max_extrude_only_accel: Acceleration | None = Field(
        None, description="Klipper: filament alone, acceleration. Default: the same."
    )
    nozzle_diameter: Diameter = Field(Decimal("0.4"), description="Klipper [mm].")
    filament_diameter: Diameter = Field(Decimal("1.75"), description="Klipper [mm].")
    resolution: Diameter = Field(
        Decimal(1), description="Klipper: chords of arcs, as in [gcode_arcs] [mm]."
    )
    junction_deviation: Deviation | None = Field(
        None,
        description="grbl's $11, Marlin's M205 J [mm]: 0 stops at every corner. Default: 0.01, of "
        "Marlin 0.013.",
    )
    arc_tolerance: Error = Field(
        Decimal("0.002"), description="grbl's $12: how far chords leave an arc [mm]."
    )
    planner_blocks: Blocks | None = Field(
        None,
        description="grbl, Marlin: lines that the ring has, one of them never filled; grblHAL's "
        "$398. Default: 16, of grblHAL 100.",
    )
    laser_mode: bool = Field(False, description="grbl's $32: an S on a move is no rest.")
    acceleration: Acceleration | None = Field(
        None, description="Marlin's M204 P, moves that extrude. Default: all that the axes give."
    )
    travel_acceleration: Acceleration | None = Field(
        None, description="Marlin's M204 T, moves that do not. Default: `acceleration`."
    )
    retract_acceleration: Acceleration | None = Field(
        None, description="Marlin's M204 R, filament alone. Default: `acceleration`."
    )
    min_segment_time_us: Annotated[int, Field(ge=0, le=1_000_000)] = Field(
        20_000, description="Marlin's M205 B: shorter lines are slower while the ring fills."
    )
    reprap: bool = Field(
        False,
        description="A program is read as RepRapFirmware does: M203 and M566, which is the jerk, "
        "in mm/min; G90 and G91 say nothing of E.",
    )
    mm_per_arc_segment: Diameter = Field(Decimal(1), description="Marlin: chords of arcs [mm].")
    g64_without_p: Literal["length", "tolerance"] = Field(
        "length",
        description="LinuxCNC: what G64 without P, and a program without G61 and G64, means: a "
        "quarter of the shorter line, as LinuxCNC has it, or `path.tolerance_mm`.",
    )
    still_macros: tuple[str, ...] = Field(
        (),
        description="Macros of a printer's own that move nothing, such as Klipper's START_PRINT.",
        strict=False,
    )
    steps_per_mm: ByAxis = Field(
        ByAxis(), description="grbl's $100…, Marlin's M92: positions are whole steps."
    )
    jerk: ByAxis = Field(
        ByAxis(),
        description="Marlin's M205 X Y Z E, classic jerk: step of speed at a corner [mm/s].",
    )


# Whose setting it is; what is not here is everybody's.
OWNERS = {
    **dict.fromkeys(
        ("max_velocity", "max_accel", "max_z_velocity", "max_z_accel", "square_corner_velocity",
         "minimum_cruise_ratio", "instantaneous_corner_velocity", "max_extrude_only_velocity",
         "max_extrude_only_accel", "nozzle_diameter", "filament_diameter", "resolution"),
        ("klipper",),
    ),
    "still_macros": ("klipper", "marlin"),
    **dict.fromkeys(("arc_tolerance", "laser_mode"), GRBLS),
    **dict.fromkeys(("junction_deviation", "planner_blocks", "steps_per_mm"), (*GRBLS, "marlin")),
    "g64_without_p": ("linuxcnc",),
    **dict.fromkeys(
        ("acceleration", "travel_acceleration", "retract_acceleration", "jerk",
         "min_segment_time_us", "mm_per_arc_segment", "reprap"), ("marlin",),
    ),
}  # fmt: skip


def is_idle(kind, key):
    """Tell whether a path to a key is another control's setting."""
    table, _, rest = key.partition(".")
    own = rest.partition(".")[0]
    return table == "control" and own != "kind" and kind not in OWNERS[own]


def contradictions(control, axes):
    """Yield (path to key, message) for settings of another control, and of axes that are not there.

    A file that only changes the kind (`--set control.kind=nck`) may leave the others where they
    are: those of a control that is not in force wait.
    """
    if control.kind in NCKS:
        return
    for key in sorted(control.model_fields_set - {"kind"}):
        if control.kind not in OWNERS[key]:
            owners = " and ".join(OWNERS[key])
            yield f"control.{key}", f"is a setting of {owners}; control.kind is {control.kind!r}"
    for table in ("steps_per_mm", "jerk"):
        for letter in getattr(control, table).present():
            if letter not in axes:
                own = "e" if letter == "u" else letter
                yield f"control.{table}.{own}", f"the machine has no axis {own.upper()}"
    if control.jerk.present() and control.junction_deviation is not None:
        yield "control.jerk", "is Marlin's other rule for corners: leave junction_deviation out"
