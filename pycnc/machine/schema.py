# SPDX-License-Identifier: MIT
"""What a machine file may say: every key with its unit, range, default and meaning.

This is the one description of the format. ``docs/machine.md`` is generated from it.
"""

from decimal import Decimal
from typing import Annotated, Literal, get_args

from pydantic import Field, model_validator

from pycnc.machine.control import Control
from pycnc.machine.inputs import Inputs
from pycnc.machine.own import OwnG, OwnM
from pycnc.machine.quantity import (
    Acceleration,
    Clock,
    Coordinate,
    Error,
    Feed,
    Jerk,
    Leads,
    Period,
    Rotation,
    Seconds,
    Size,
    Speed,
    SpeedPerMinute,
    Switches,
    Table,
    Travel,
    Unit,
)
from pycnc.names import AXES, LINEAR_AXES, ROTARY_AXES, WORK_SYSTEMS

TOLERANCE_LEAST_MM = Decimal("0.0001")  # the kernel smooths within nothing smaller


Slope = Literal["linear", "jerk", "optimal"]
SLOPES = get_args(Slope)


class Kernel(Table):
    """How often setpoints are made."""

    period_ms: Period = Field(
        Decimal(1),
        description="Interpolation period: one setpoint per axis every so many milliseconds.",
    )


class Path(Table):
    """Limits along the path and tolerances."""

    feed_max_mm_min: SpeedPerMinute | None = Field(
        None,
        description="Highest feed along the path. Default: all that the axes give.",
    )
    a_max_mm_s2: Acceleration | None = Field(
        None,
        description="Highest acceleration along the path. Default: all that the axes give.",
    )
    j_max_mm_s3: Jerk | None = Field(
        None, description="Highest jerk along the path. Default: all that the axes give."
    )
    chord_error_mm: Error = Field(
        Decimal("0.001"), description="How far the chord between two setpoints may leave an arc."
    )
    tolerance_mm: Size = Field(
        Decimal("0.01"),
        description="What G64 without P means, and a program without G61 and G64: 0, which is "
        "exact path, or 0.0001 at least.",
    )
    arc_radius_mm: Error = Field(
        Decimal("0.005"), description="How far the end point of an arc may miss its circle."
    )
    lookahead_blocks: int = Field(
        0,
        ge=0,
        description="Blocks that the look-ahead may see, the one in work among them, 2 at least; "
        "within a tolerance two pieces of the spline at least; 0: all that the kernel holds.",
    )
    slope: Slope = Field(
        "optimal",
        description="Velocity profile. `linear`: acceleration-limited, `jerk`: jerk-limited, both "
        "on the exact path, whatever the tolerance. `optimal`: the same as `jerk`, within a "
        "tolerance the fastest motion along the smoothest curve; where a build has it.",
    )


class LinearAxis(Table):
    """One linear axis."""

    v_max_mm_s: Speed = Field(description="Highest speed.")
    rapid_mm_s: Speed | None = Field(
        None, description="Speed of G0, v_max at most. Default: v_max."
    )
    a_max_mm_s2: Acceleration = Field(description="Highest acceleration.")
    j_max_mm_s3: Jerk = Field(
        description="Highest jerk (the linear slope reports it and does not limit it)."
    )
    min_mm: Travel = Field(
        None,
        description='Lower end of travel (machine coordinates; lathe: radius). Default: `"free"`.',
    )
    max_mm: Travel = Field(
        None,
        description='Upper end of travel (machine coordinates; lathe: radius). Default: `"free"`.',
    )


class RotaryAxis(Table):
    """One rotary axis."""

    v_max_deg_s: Speed = Field(description="Highest speed.")
    rapid_deg_s: Speed | None = Field(
        None, description="Speed of G0, v_max at most. Default: v_max."
    )
    a_max_deg_s2: Acceleration = Field(description="Highest acceleration.")
    j_max_deg_s3: Jerk = Field(
        description="Highest jerk (the linear slope reports it and does not limit it)."
    )
    min_deg: Travel = Field(
        None, description='Lower end of travel, machine coordinates. Default: `"free"`.'
    )
    max_deg: Travel = Field(
        None, description='Upper end of travel, machine coordinates. Default: `"free"`.'
    )


class Axis(Table):
    """The axes that the machine has; a word of any other axis is an error in the program."""

    x: LinearAxis | None = Field(None, description="The X axis.")
    y: LinearAxis | None = Field(None, description="The Y axis.")
    z: LinearAxis | None = Field(None, description="The Z axis.")
    a: RotaryAxis | None = Field(None, description="The A axis, about X.")
    b: RotaryAxis | None = Field(None, description="The B axis, about Y.")
    c: RotaryAxis | None = Field(None, description="The C axis, about Z.")
    u: LinearAxis | None = Field(None, description="The U axis, along X.")
    v: LinearAxis | None = Field(None, description="The V axis, along Y.")
    w: LinearAxis | None = Field(None, description="The W axis, along Z.")

    @model_validator(mode="after")
    def _some(self):
        if not self.present():
            raise ValueError("a machine needs one axis at least")
        return self

    def present(self):
        """Return the axes that are there, letter → table, in the kernel's order."""
        return {
            letter: getattr(self, letter) for letter in AXES if getattr(self, letter) is not None
        }


class Kinematics(Table):
    """How axes become joints."""

    type: Literal["identity", "lathe_xz"] = Field(
        "identity", description="`identity`: a joint for each axis. `lathe_xz`: X (radius) and Z."
    )


class Spindle(Table):
    """The main spindle."""

    rpm_max: Rotation = Field(Decimal(0), description="Highest speed; 0: not checked.")
    a_max_rpm_s: Rotation = Field(
        Decimal(0),
        description="How fast the speed can change, in rpm a second: under G96 no move is faster "
        "than the spindle can follow; 0: at once.",
    )
    waits: bool = Field(False, description="M3, M4 and another S rest until the speed is there.")


class Times(Table):
    """What takes time that no axis makes; it is added to the machining time where it is told."""

    tool_change_s: Seconds = Field(
        Decimal(0), description="A change of tool: M6, or T where a lathe's turret turns at once."
    )
    spindle_start_s: Seconds = Field(
        Decimal(0), description="Until the spindle has its speed: M3 or M4 from rest, a reversal."
    )


class Dialect(Table):
    """How program text is read."""

    base: Literal["linuxcnc", "fanuc", "grbl", "marlin", "auto"] = Field(
        "linuxcnc",
        description="The family of dialects that the text belongs to; `auto`: as the text looks, "
        "which a note tells. `grbl` is grblHAL's where that is the control's kind.",
    )
    system: Literal["A", "B", "C"] | None = Field(
        None,
        description="Fanuc's G-code system of a lathe: what G90, G92, G94 and G98 mean. Not said: "
        "A, and a note where it matters.",
    )
    feed: Literal["per_minute", "per_rev"] | None = Field(
        None,
        description="What F means at start (G94 or G95, in system A G98 or G99). Not said: per "
        "minute; on a lathe that speaks Fanuc's language per revolution, and a note.",
    )
    scale_unit: Unit = Field(
        Decimal(0), description="What 1 means in a factor of Fanuc's G51 without a point: 1 "
        "(Haas), 0.001 or 0.00001; 0: such a factor is an error.",
    )
    d_offset: Literal["radius", "diameter"] | None = Field(
        None, description="What Fanuc's G10 L12 and L13 say of an offset for D. Not said: they "
        "are refused, since controls differ.",
    )
    comp_start: Literal["rs274", "A", "B"] | None = Field(
        None, description="How G41 begins, G40 ends (words.md); not said: A of Fanuc, else rs274."
    )
    integers: Literal["units", "increments"] | None = Field(
        None,
        description="What Fanuc's lengths, angles and dwells (X, U) without a point count: X100 is "
        "100 mm, or 100 least increments (0.001 mm, 0.0001 inch, 0.001 degrees, 0.001 s). Not "
        "said: units, and a note.",
    )
    probe: Literal["refused", "misses", "touches"] = Field(
        "misses",
        description="What probes (G38.2 to G38.5) meet in the simulation: nothing, or something "
        "where they end. A session asks the machine's own probe; `refused` refuses there, too.",
    )
    thread_pull_leads: Leads = Field(
        Decimal(1),
        description="Leads over which a tool pulls out at a thread's end, in Fanuc's G92 and its "
        "G76 of one line; 0: it stops there.",
    )
    diameter: bool = Field(False, description="At start, X words are diameters (G7).")
    units: Literal["mm", "inch"] = Field("mm", description="Units at start (G21 or G20).")
    plane: Literal[17, 18, 19] = Field(17, description="Plane at start (G17, G18, G19).")
    arc_centre: Literal["incremental", "absolute"] = Field(
        "incremental", description="I J K at start (G91.1 or G90.1)."
    )
    block_skip: bool = Field(False, description="Lines that begin with / are skipped.")
    skip_switches: Switches = Field(
        "",
        description="Digits 1 to 9: the same for these numbers alone, as `25` for /2 and /5. A / "
        "without a number is /1; in the middle of a line, where Fanuc has it, it skips the rest.",
    )
    programs: str = Field(
        "",
        description="Folder of the programs that a text calls and does not hold, such as O9000.nc, "
        "9000.nc or name.ngc, seen from where pycnc runs.",
    )
    optional_stop: bool = Field(False, description="M1 stops.")
    clock: Clock = Field(
        None, description="Day and time of #3011, #3012; not said: 2000-01-01 00:00:00, and a note"
    )
    from_line: int = Field(
        0, ge=0, le=4_294_967_295,
        description="Line where programs begin, in the state they have there; 0: with the first.",
    )
    feed_default_mm_min: Feed = Field(
        Decimal(0), description="Feed before the first F; 0: none, a cut without F is an error."
    )


class Approach(Table):
    """The way to where a program begins in the middle (`--from-line`): one axis leaves the work
    first, the others go across as rapids, and that axis goes in last, at a feed."""

    axis: Literal[LINEAR_AXES] | None = Field(
        None,
        description="The axis that leaves first and goes in last, its positive end away from the "
        "work. Default: Z, of a lathe X (`z` for a bore).",
    )
    height_mm: Travel = Field(
        None,
        description="Where that axis clears everything, machine coordinates (lathe: radius); it "
        "never goes towards the work for it. Default: the end of its travel; where that is free, "
        "too, the way is an error.",
    )
    feed_mm_min: SpeedPerMinute = Field(
        Decimal(100),
        description="How fast it goes in: by default who sees it go wrong has a second for 2 mm.",
    )


class Position(Table):
    """A position: every axis that is not named is 0."""

    x_mm: Coordinate = Field(Decimal(0), description="X (lathe: radius).")
    y_mm: Coordinate = Field(Decimal(0), description="Y.")
    z_mm: Coordinate = Field(Decimal(0), description="Z.")
    a_deg: Coordinate = Field(Decimal(0), description="A.")
    b_deg: Coordinate = Field(Decimal(0), description="B.")
    c_deg: Coordinate = Field(Decimal(0), description="C.")
    u_mm: Coordinate = Field(Decimal(0), description="U.")
    v_mm: Coordinate = Field(Decimal(0), description="V.")
    w_mm: Coordinate = Field(Decimal(0), description="W.")

    def along(self, letter):
        """Return the coordinate of an axis [mm, deg]."""
        return getattr(self, position_key(letter))


class Start(Position):
    """Where the machine stands when a program starts, machine coordinates."""

    work_system: Literal[WORK_SYSTEMS] = Field("g54", description="Work offset in force at start.")


class Home(Table):
    """Reference points, machine coordinates."""

    g28: Position = Field(Position(), description="Where G28 goes.")
    g30: Position = Field(Position(), description="Where G30 goes.")
    g30_p3: Position | None = Field(None, description="Where G30 P3 goes; without it: nowhere.")
    g30_p4: Position | None = Field(None, description="Where G30 P4 goes; without it: nowhere.")


class Work(Table):
    """Work offsets: the machine coordinates of each system's zero point."""

    zero: Literal["told", "unknown"] = Field(
        "told",
        description="`unknown`: nobody says where the work lies. A program then begins at its "
        "zero, which is laid so that all of it is within the travel; one line tells what it needs.",
    )
    g54: Position = Field(Position(), description="Zero point of G54.")
    g55: Position = Field(Position(), description="Zero point of G55.")
    g56: Position = Field(Position(), description="Zero point of G56.")
    g57: Position = Field(Position(), description="Zero point of G57.")
    g58: Position = Field(Position(), description="Zero point of G58.")
    g59: Position = Field(Position(), description="Zero point of G59.")
    g59_1: Position = Field(Position(), description="Zero point of G59.1.")
    g59_2: Position = Field(Position(), description="Zero point of G59.2.")
    g59_3: Position = Field(Position(), description="Zero point of G59.3.")
    p: dict[str, Position] = Field(
        {},
        description="Zero points of Fanuc's further systems, a table for each: `[work.p.7]` is "
        "that of G54.1 P7 (G54 P7; Haas: G154 P7, G116).",
    )


class Tool(Table):
    """One tool: T names it, and H names its length."""

    length_mm: Coordinate = Field(Decimal(0), description="Length, along Z.")
    x_mm: Coordinate = Field(Decimal(0), description="Offset along X (lathe: radius).")
    y_mm: Coordinate = Field(Decimal(0), description="Offset along Y.")
    radius_mm: Size = Field(Decimal(0), description="Cutter or nose radius.")
    radius_wear_mm: Coordinate = Field(
        Decimal(0), description="Added to the radius: what the tool has lost, negative."
    )
    orientation: Annotated[int, Field(ge=0, le=9)] = Field(
        0,
        description="Lathe: where the tip points, 0 to 9, as the language of the file's "
        "`dialect.base` numbers it: X−, Z− is 3 for Fanuc (and Haas), 2 for LinuxCNC.",
    )


class MachineFile(Table):
    """A whole machine file."""

    description: str = Field("", description="One line for people: shown in lists.")
    kernel: Kernel = Field(Kernel(), description="How often setpoints are made.")
    path: Path = Field(Path(), description="Limits along the path and tolerances.")
    axis: Axis = Field(description="The axes.")
    kinematics: Kinematics = Field(Kinematics(), description="How axes become joints.")
    control: Control = Field(
        Control(), description="Whose planner the time is told of (controls.md)."
    )
    spindle: Spindle = Field(Spindle(), description="The main spindle.")
    times: Times = Field(Times(), description="What takes time that no axis makes.")
    dialect: Dialect = Field(Dialect(), description="How program text is read.")
    approach: Approach = Field(
        Approach(), description="The way to where a program begins in the middle (`--from-line`)."
    )
    inputs: Inputs | None = Field(None, description="Switches of the machine that is served.")
    start: Start = Field(Start(), description="Where the machine stands when a program starts.")
    home: Home = Field(Home(), description="Reference points.")
    work: Work = Field(Work(), description="Work offsets.")
    tool: dict[str, Tool] = Field({}, description="The tool table, one table for each number.")
    m: dict[str, OwnM] = Field(
        {}, description="M codes of the machine's own, one table for each: `[m.428]`."
    )
    g: dict[str, OwnG] = Field(
        {},
        description="G codes that choose a mode of the control's, or that the language does not "
        "have: `[g.187]`, `[g.5_1_q1]` for G5.1 Q1.",
    )


def unit_of(letter):
    """Return the unit of an axis as keys write it."""
    return "deg" if letter in ROTARY_AXES else "mm"


def position_key(letter):
    """Return the key of an axis in a position, such as ``x_mm``."""
    return f"{letter}_{unit_of(letter)}"


def approach_axis(approach, kinematics):
    """Return the letter of the axis that leaves the work first."""
    return approach.axis or ("x" if kinematics.type == "lathe_xz" else "z")
