# SPDX-License-Identifier: MIT
"""What a machine file may say: every key with its unit, range, default and meaning.

This is the one description of the format. ``docs/machine.md`` is generated from it.
"""

from decimal import Decimal

from pycnc.kernel.records import quantity_range
from pycnc.machine.table import FLAG, TEXT, Choice, Key, Number, Numbered, Table, Whole

LINEAR_AXES = ("x", "y", "z", "u", "v", "w")
ROTARY_AXES = ("a", "b", "c")
AXES = ("x", "y", "z", "a", "b", "c", "u", "v", "w")  # the kernel's order
WORK_SYSTEMS = ("g54", "g55", "g56", "g57", "g58", "g59", "g59_1", "g59_2", "g59_3")
TRAVEL_LIMIT = 1_000_000  # mm or degrees: a position beyond a kilometre is a mistake


def _within(quantity, units=1):
    """Return the kind of a number with the kernel's range; units: the file's in one of its."""
    low, high = ((end * units).normalize() for end in quantity_range(quantity))
    return Number(low, high)


PERIOD = _within("period", 1000)
SPEED = _within("speed")
SPEED_PER_MINUTE = _within("speed", 60)
ACCELERATION = _within("acceleration")
JERK = _within("jerk")
ERROR = _within("error")
SIZE = _within("size")
FEED = _within("feed")
ROTATION = _within("rotation")
LEADS = Number(0, 10)
UNIT = Number(0, 1)
SECONDS = Number(0, 3600)
COORDINATE = Number(-TRAVEL_LIMIT, TRAVEL_LIMIT)
TRAVEL = Number(-TRAVEL_LIMIT, TRAVEL_LIMIT, free=True)
SLOPES = ("linear", "jerk", "sshape")


class Kernel(Table):
    """How often setpoints are made."""

    period_ms = Key(
        PERIOD, Decimal(1),
        description="Interpolation period: one setpoint per axis every so many milliseconds.",
    )


class Path(Table):
    """Limits along the path and tolerances."""

    feed_max_mm_min = Key(
        SPEED_PER_MINUTE, None,
        description="Highest feed along the path. Default: all that the axes give.",
    )
    a_max_mm_s2 = Key(
        ACCELERATION, None,
        description="Highest acceleration along the path. Default: all that the axes give.",
    )
    j_max_mm_s3 = Key(
        JERK, None, description="Highest jerk along the path. Default: all that the axes give."
    )
    chord_error_mm = Key(
        ERROR,
        Decimal("0.001"), description="How far the chord between two setpoints may leave an arc."
    )
    tolerance_mm = Key(
        SIZE, Decimal("0.01"),
        description="What G64 without P means, and a program without G61 and G64; 0 is exact path.",
    )
    arc_radius_mm = Key(
        ERROR, Decimal("0.005"), description="How far the end point of an arc may miss its circle."
    )
    lookahead_blocks = Key(
        Whole(0), 0,
        description="Blocks that the look-ahead may see, the one in work among them, 2 at least "
        "(`sshape`: 1, which stops at every block); 0: all that the kernel holds.",
    )
    slope = Key(
        Choice(*SLOPES), "jerk",
        description="Velocity profile. `linear`: acceleration-limited. `jerk`: jerk-limited, "
        "acceleration is carried across junctions. `sshape`: jerk-limited, acceleration is zero "
        "at every junction.",
    )


class LinearAxis(Table):
    """One linear axis."""

    v_max_mm_s = Key(SPEED, description="Highest speed.")
    rapid_mm_s = Key(
        SPEED, None, description="Speed of G0, v_max at most. Default: v_max."
    )
    a_max_mm_s2 = Key(ACCELERATION, description="Highest acceleration.")
    j_max_mm_s3 = Key(
        JERK, description="Highest jerk (the linear slope reports it and does not limit it)."
    )
    min_mm = Key(
        TRAVEL, None,
        description='Lower end of travel (machine coordinates; lathe: radius). Default: `"free"`.',
    )
    max_mm = Key(
        TRAVEL, None,
        description='Upper end of travel (machine coordinates; lathe: radius). Default: `"free"`.',
    )


class RotaryAxis(Table):
    """One rotary axis."""

    v_max_deg_s = Key(SPEED, description="Highest speed.")
    rapid_deg_s = Key(
        SPEED, None, description="Speed of G0, v_max at most. Default: v_max."
    )
    a_max_deg_s2 = Key(ACCELERATION, description="Highest acceleration.")
    j_max_deg_s3 = Key(
        JERK, description="Highest jerk (the linear slope reports it and does not limit it)."
    )
    min_deg = Key(
        TRAVEL, None, description='Lower end of travel, machine coordinates. Default: `"free"`.'
    )
    max_deg = Key(
        TRAVEL, None, description='Upper end of travel, machine coordinates. Default: `"free"`.'
    )


class Axis(Table):
    """The axes that the machine has; a word of any other axis is an error in the program."""

    x = Key(LinearAxis, None, description="The X axis.")
    y = Key(LinearAxis, None, description="The Y axis.")
    z = Key(LinearAxis, None, description="The Z axis.")
    a = Key(RotaryAxis, None, description="The A axis, about X.")
    b = Key(RotaryAxis, None, description="The B axis, about Y.")
    c = Key(RotaryAxis, None, description="The C axis, about Z.")
    u = Key(LinearAxis, None, description="The U axis, along X.")
    v = Key(LinearAxis, None, description="The V axis, along Y.")
    w = Key(LinearAxis, None, description="The W axis, along Z.")

    def wrong(self):
        """Return what is wrong with the axes as a whole."""
        return "" if self.present() else "a machine needs one axis at least"

    def present(self):
        """Return the axes that are there, letter → table, in the kernel's order."""
        return {
            letter: getattr(self, letter) for letter in AXES if getattr(self, letter) is not None
        }


class Kinematics(Table):
    """How axes become joints."""

    type = Key(
        Choice("identity", "lathe_xz"),
        "identity", description="`identity`: a joint for each axis. `lathe_xz`: X (radius) and Z."
    )


class Spindle(Table):
    """The main spindle."""

    rpm_max = Key(ROTATION, Decimal(0), description="Highest speed; 0: not checked.")
    a_max_rpm_s = Key(
        ROTATION, Decimal(0),
        description="How fast the speed can change, in rpm a second: under G96 no move is faster "
        "than the spindle can follow; 0: at once.",
    )


class Times(Table):
    """What takes time that no axis makes; it is added to the machining time where it is told."""

    tool_change_s = Key(
        SECONDS,
        Decimal(0), description="A change of tool: M6, or T where a lathe's turret turns at once."
    )
    spindle_start_s = Key(
        SECONDS,
        Decimal(0), description="Until the spindle has its speed: M3 or M4 from rest, a reversal."
    )


class Dialect(Table):
    """How program text is read."""

    base = Key(
        Choice("linuxcnc", "fanuc", "grbl", "marlin", "auto"), "linuxcnc",
        description="The family of dialects that the text belongs to; `auto`: as the text looks, "
        "which a note tells.",
    )
    system = Key(
        Choice("A", "B", "C"), None,
        description="Fanuc's G-code system of a lathe: what G90, G92, G94 and G98 mean. Not said: "
        "A, and a note where it matters.",
    )
    feed = Key(
        Choice("per_minute", "per_rev"), None,
        description="What F means at start (G94 or G95, in system A G98 or G99). Not said: per "
        "minute, and on a lathe that speaks Fanuc's language a note.",
    )
    scale_unit = Key(
        UNIT, Decimal(0),
        description="What 1 means where a factor of Fanuc's G51 has no point: 1 (Haas), 0.001 or "
        "0.00001; 0: such a factor is an error.",
    )
    d_offset = Key(
        Choice("radius", "diameter"), None,
        description="What Fanuc's G10 L12 and L13 say of an offset for D. Not said: they are "
        "refused, since controls differ.",
    )
    probe = Key(
        Choice("refused", "misses", "touches"), "misses",
        description="What probes (G38.2 to G38.5) meet in the simulation: nothing, or something "
        "where they end. No probe is asked on the way: a machine that moves says `refused`.",
    )
    thread_pull_leads = Key(
        LEADS, Decimal(1),
        description="Leads over which a tool pulls out at a thread's end, in Fanuc's G92 and its "
        "G76 of one line; 0: it stops there.",
    )
    diameter = Key(FLAG, False, description="At start, X words are diameters (G7).")
    units = Key(Choice("mm", "inch"), "mm", description="Units at start (G21 or G20).")
    plane = Key(Choice(17, 18, 19), 17, description="Plane at start (G17, G18, G19).")
    arc_centre = Key(
        Choice("incremental", "absolute"),
        "incremental", description="How I J K are meant at start (G91.1 or G90.1)."
    )
    block_skip = Key(FLAG, False, description="Lines that begin with / are skipped.")
    optional_stop = Key(FLAG, False, description="M1 stops.")
    from_line = Key(
        Whole(0, 4_294_967_295), 0,
        description="Line where programs begin, in the state they have there; 0: with the first.",
    )
    feed_default_mm_min = Key(
        FEED, Decimal(0),
        description="Feed in force before the first F; 0: none, a cut without F is an error.",
    )


class Position(Table):
    """A position: every axis that is not named is 0."""

    x_mm = Key(COORDINATE, Decimal(0), description="X (lathe: radius).")
    y_mm = Key(COORDINATE, Decimal(0), description="Y.")
    z_mm = Key(COORDINATE, Decimal(0), description="Z.")
    a_deg = Key(COORDINATE, Decimal(0), description="A.")
    b_deg = Key(COORDINATE, Decimal(0), description="B.")
    c_deg = Key(COORDINATE, Decimal(0), description="C.")
    u_mm = Key(COORDINATE, Decimal(0), description="U.")
    v_mm = Key(COORDINATE, Decimal(0), description="V.")
    w_mm = Key(COORDINATE, Decimal(0), description="W.")

    def along(self, letter):
        """Return the coordinate of an axis [mm, deg]."""
        return getattr(self, position_key(letter))


class Start(Position):
    """Where the machine stands when a program starts, machine coordinates."""

    work_system = Key(Choice(*WORK_SYSTEMS), "g54", description="Work offset in force at start.")


class Home(Table):
    """Reference points, machine coordinates."""

    g28 = Key(Position, Position(), description="Where G28 goes.")
    g30 = Key(Position, Position(), description="Where G30 goes.")
    g30_p3 = Key(Position, None, description="Where G30 P3 goes; without it: nowhere.")
    g30_p4 = Key(Position, None, description="Where G30 P4 goes; without it: nowhere.")


class Work(Table):
    """Work offsets: the machine coordinates of each system's zero point."""

    g54 = Key(Position, Position(), description="Zero point of G54.")
    g55 = Key(Position, Position(), description="Zero point of G55.")
    g56 = Key(Position, Position(), description="Zero point of G56.")
    g57 = Key(Position, Position(), description="Zero point of G57.")
    g58 = Key(Position, Position(), description="Zero point of G58.")
    g59 = Key(Position, Position(), description="Zero point of G59.")
    g59_1 = Key(Position, Position(), description="Zero point of G59.1.")
    g59_2 = Key(Position, Position(), description="Zero point of G59.2.")
    g59_3 = Key(Position, Position(), description="Zero point of G59.3.")


class Tool(Table):
    """One tool: T names it, and H names its length."""

    length_mm = Key(COORDINATE, Decimal(0), description="Length, along Z.")
    x_mm = Key(COORDINATE, Decimal(0), description="Offset along X (lathe: radius).")
    y_mm = Key(COORDINATE, Decimal(0), description="Offset along Y.")
    radius_mm = Key(SIZE, Decimal(0), description="Cutter or nose radius.")
    radius_wear_mm = Key(
        COORDINATE, Decimal(0), description="Added to the radius: what the tool has lost, negative."
    )
    orientation = Key(
        Whole(0, 9), 0, description="Lathe: where the tip points, 0 to 9."
    )


class OwnM(Table):
    """An M code of the machine's own."""

    action = Key(
        Choice("output", "wait"),
        description="`output`: the code is handed over and the path goes on. `wait`: the path "
        "rests, the code is handed over, and the program waits to be resumed."
    )


class MachineFile(Table):
    """A whole machine file."""

    description = Key(TEXT, "", description="One line for people: shown in lists.")
    kernel = Key(Kernel, Kernel(), description="How often setpoints are made.")
    path = Key(Path, Path(), description="Limits along the path and tolerances.")
    axis = Key(Axis, description="The axes.")
    kinematics = Key(Kinematics, Kinematics(), description="How axes become joints.")
    spindle = Key(Spindle, Spindle(), description="The main spindle.")
    times = Key(Times, Times(), description="What takes time that no axis makes.")
    dialect = Key(Dialect, Dialect(), description="How program text is read.")
    start = Key(Start, Start(), description="Where the machine stands when a program starts.")
    home = Key(Home, Home(), description="Reference points.")
    work = Key(Work, Work(), description="Work offsets.")
    tool = Key(Numbered(Tool), {}, description="The tool table, one table for each number.")
    m = Key(
        Numbered(OwnM),
        {}, description="M codes of the machine's own, one table for each: `[m.428]`."
    )


def unit_of(letter):
    """Return the unit of an axis as keys write it."""
    return "deg" if letter in ROTARY_AXES else "mm"


def position_key(letter):
    """Return the key of an axis in a position, such as ``x_mm``."""
    return f"{letter}_{unit_of(letter)}"


def contradictions(machine):
    """Yield (path to key, message) for numbers that are good alone and wrong together."""
    axes = machine.axis.present()
    for letter, axis in axes.items():
        yield from _axis_contradictions(letter, axis)
    for name, position in _positions(machine):
        yield from _position_contradictions(
            name, position, axes, travel=not name.startswith("work.")
        )
    if machine.path.lookahead_blocks == 1 and machine.path.slope != "sshape":
        yield "path.lookahead_blocks", "must be 0 (all) or 2 at least"
    if machine.kinematics.type == "lathe_xz" and set(axes) != {"x", "z"}:
        yield (
            "kinematics.type",
            f"lathe_xz needs the axes X and Z alone (the file has {', '.join(axes).upper()})",
        )
    for number in machine.m:
        if not (number.isdecimal() and number.isascii() and number == str(int(number))):
            yield f"m.{number}", "an M code's name is its number, as in [m.428]"
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


def _positions(machine):
    yield "start", machine.start
    yield "home.g28", machine.home.g28
    yield "home.g30", machine.home.g30
    for name in ("g30_p3", "g30_p4"):
        if (place := getattr(machine.home, name)) is not None:
            yield f"home.{name}", place
    for name in WORK_SYSTEMS:
        yield f"work.{name}", getattr(machine.work, name)


def _position_contradictions(name, position, axes, travel):
    for letter in AXES:
        value, key = position.along(letter), f"{name}.{position_key(letter)}"
        if letter not in axes:
            if value != 0:
                yield key, f"the machine has no {letter.upper()} axis"
            continue
        if not travel:
            continue
        low, high = (getattr(axes[letter], f"{end}_{unit_of(letter)}") for end in ("min", "max"))
        if (low is not None and value < low) or (high is not None and value > high):
            yield key, f"must be within the travel {_bound(low)} … {_bound(high)} (is {value})"


def _bound(value):
    return "free" if value is None else value
