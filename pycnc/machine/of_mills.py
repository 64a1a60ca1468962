# SPDX-License-Identifier: MIT
"""What the configurations of mills and routers mean: LinuxCNC, grbl and grblHAL, FluidNC."""

import re
from decimal import Decimal

from pycnc.machine.draft import OWN_DEFAULT
from pycnc.machine.schema import AXES, ROTARY_AXES

_MM = {  # LINEAR_UNITS of LinuxCNC → millimetres
    **dict.fromkeys(("mm", "metric"), Decimal(1)), "cm": Decimal(10), "um": Decimal("1e-3"),
    **dict.fromkeys(("inch", "in", "imperial"), Decimal("25.4")),
}  # fmt: skip
_DEGREES = {  # ANGULAR_UNITS of LinuxCNC → degrees
    **dict.fromkeys(("deg", "degree"), Decimal(1)), "grad": Decimal("0.9"), "gon": Decimal("0.9"),
    **dict.fromkeys(("rad", "radian"), Decimal("57.29577951308232087679815")),
}  # fmt: skip
# LinuxCNC's [RS274NGC] CENTER_ARC_RADIUS_TOLERANCE: the least, and the most, its default.
_ARCS = {
    "mm": (Decimal("0.001"), Decimal("0.02828427")),
    "inch": (Decimal("0.00004"), Decimal("0.002828427")),
}


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


_KINEMATICS = (  # by how its name begins
    ("lineardelta", "a delta of three towers"), ("rotarydelta", "a delta of three arms"),
    ("corexy", "CoreXY: two belts for X and Y"), ("scara", "a SCARA of two arms"),
    ("scorbot", "an arm"), ("puma", "an arm"), ("genser", "an arm"), ("genhex", "a hexapod"),
    ("pentakins", "a pentapod"), ("tripod", "a tripod"), ("rotatekins", "X and Y turned"),
    ("millturn", "a mill that turns"), ("5axis", "a mill with a head that turns"),
    ("max", "a mill with a head that turns"), ("xyz", "a mill with a table or a head that turns"),
    ("gantry", "a gantry"), ("gentriv", "joints as they are named"),
)  # fmt: skip


def _kinematics(source):
    """Return (the kinematics of a LinuxCNC machine with what is said of them, their name)."""
    words = source.word(("kins", "kinematics")) or ""
    return words, words.split()[0].lower() if words.split() else "trivkins"


def _joints(source):
    """Return {axis: its first joint} of a LinuxCNC machine, in the order of the axes."""
    kinematics, name = _kinematics(source)
    if name != "trivkins":
        what = next((words for begin, words in _KINEMATICS if name.startswith(begin)), "joints")
        source.draft.left.append(
            f"kinematics {name}: {what}; planned is the tool's path in X Y Z, within the limits of "
            "[AXIS_L]; what a joint alone forbids is not known"
        )
    told = source.word(("traj", "coordinates"))
    if told is None:
        source.draft.left.append("COORDINATES: not in the source; taken as X Y Z")
    of_joints = re.search(r"\bcoordinates=(\w+)", kinematics.lower())
    named = re.sub("[^a-z]", "", (told or "xyz").lower())
    order = of_joints[1] if of_joints else named
    return {letter: order.find(letter) for letter in AXES if letter in named}


def _axis_of_linuxcnc(source, letter, joint, scale):
    own = (f"axis_{letter}", f"axis_{joint}", f"joint_{joint}")
    most = "max_angular" if letter in ROTARY_AXES else "max_linear"
    for quantity, name in (("v_max", "velocity"), ("a_max", "acceleration"), ("j_max", "jerk")):
        keys = [*((section, f"max_{name}") for section in own), ("traj", f"{most}_{name}"),
                ("traj", f"max_{name}")]  # fmt: skip
        default = None if quantity == "j_max" else Decimal(1)  # a unit a second
        source.axis(letter, quantity, keys, scale, default)
    _for_offsets(source, letter)
    # An axis' and its joint's both forbid; where joints are no axes the axis' alone.
    ends = own if _kinematics(source)[1] == "trivkins" else own[:2]
    for end, pick in (("min", max), ("max", min)):
        keys = [(section, f"{end}_limit") for section in ends]
        source.tightest(letter, end, pick, keys, scale)


def linuxcnc(source):
    """Fill in an INI; return the letters of its axes."""
    unit = _length_unit(source)
    degrees = source.unit(("traj", "angular_units"), "ANGULAR_UNITS", _DEGREES) or Decimal(1)
    joints = _joints(source)
    letters = list(joints)
    for letter, joint in joints.items():
        _axis_of_linuxcnc(source, letter, joint, degrees if letter in ROTARY_AXES else unit)
    source.path("path.feed_max_mm_min", [("traj", "max_linear_velocity")], 60 * unit)
    source.path("kernel.period_ms", [("emcmot", "servo_period")], Decimal("1e-6"))
    source.path("spindle.rpm_max", [("spindle_0", "max_forward_velocity")])
    if unit == _MM["inch"]:
        source.draft.put("dialect.units", "inch", "LINEAR_UNITS")
    if source.word(("display", "lathe")) == "1" and letters == ["x", "z"]:
        source.draft.put("kinematics.type", "lathe_xz", "LATHE = 1")
        source.draft.put("dialect.plane", 18, "LATHE = 1")
    _startup(source, unit)
    _planner(source, unit)
    _without_jerk(source, letters)
    _arcs(source, unit)
    if source.word(("rs274ngc", "subroutine_path")):
        source.draft.left.append("subprograms in files: give their folder by --programs")
    if source.word(("emcio", "tool_table")):
        source.draft.left.append("the tool table: give it by --tools")
    return letters


def _planner(source, unit):
    """Which trajectory planner it loads: its own, or nck_tp with one of its slopes."""
    words = (source.word(("traj", "tpmod")) or "").lower().split()
    if words[:1] != ["nck_tp"]:
        source.draft.put("control.kind", "linuxcnc")
        return
    given = dict(word.split("=", 1) for word in words if "=" in word)
    slope = given.get("planner", source.word(("traj", "nck_planner")) or "optimal").lower()
    source.draft.put("control.kind", "nck_tp", "TPMOD = nck_tp")
    source.draft.put("path.slope", slope, "planner of nck_tp")
    within, comment = source.number(("traj", "nck_tolerance"))
    if "path.tolerance_mm" not in source.draft.values:
        tolerance = within * unit if within else Decimal("0.05")
        source.draft.put("path.tolerance_mm", tolerance, comment or "G64 without P of nck_tp")


def _without_jerk(source, letters):
    """MAX_JERK = 0 is none, of which an axis turns its acceleration round within a cycle; of all
    axes, nck_tp has the planner linear."""
    free = [letter for letter in letters if source.draft.limit(letter, "j_max") == 0]
    period_ns, _ = source.number(("emcmot", "servo_period"))
    for letter in free:
        turn = 2 * source.draft.limit(letter, "a_max") * 10**9 / (period_ns or 10**6)
        source.draft.axis(letter, "j_max", turn, "MAX_JERK = 0: none")
    if free == list(letters) and source.draft.values.get("control.kind", ("",))[0] == "nck_tp":
        source.draft.put("path.slope", "linear", "no axis has a MAX_JERK")


def _for_offsets(source, letter):
    """Leave what LinuxCNC keeps of an axis for external offsets out of what a program has."""
    share, comment = source.number((f"axis_{letter}", "offset_av_ratio"))
    for quantity in ("v_max", "a_max") if share and 0 < share < 1 else ():
        value = source.draft.limit(letter, quantity)
        source.draft.axis(letter, quantity, value * (1 - share), f"without {comment}")


_STARTS = {  # codes of a start-up code → what a machine file says for it
    "G20": ("units", "inch"), "G21": ("units", "mm"), "G7": ("diameter", True),
    "G8": ("diameter", False), "G17": ("plane", 17), "G18": ("plane", 18), "G19": ("plane", 19),
    "G90.1": ("arc_centre", "absolute"), "G91.1": ("arc_centre", "incremental"),
}  # fmt: skip
_STARTS_NOWHERE = re.compile(r"G(9[1235]|61\.1|10|96)")  # what it has no key for
_START_WORD = re.compile(r"([A-Z])(\d+\.?\d*|\.\d+)")
_SYSTEMS = re.compile(r"G5[5-9](\.[123])?")


def _startup(source, unit):
    """What is in force before a program says anything else."""
    code = source.word(("rs274ngc", "rs274ngc_startup_code"))
    bare = re.sub(r"\([^)]*\)|;.*|\s", "", code or "").upper()
    words = [(letter, Decimal(number)) for letter, number in _START_WORD.findall(bare)]
    codes = [f"{letter}{number.normalize():f}" for letter, number in words]
    told = f"start-up code {code}"
    for name, (key, value) in _STARTS.items():
        if name in codes:
            source.draft.put(f"dialect.{key}", value, told)
    source.draft.problems += [
        ("RS274NGC_STARTUP_CODE", f"{name}: a machine file cannot say it; let the programs do")
        for name in _unsaid(bare, codes)
    ]
    for name in filter(_SYSTEMS.fullmatch, codes):
        source.draft.left.append(f"{told}: {name}; programs begin in G54, whose zero nobody knows")
    scale = _MM["inch"] if "G20" in codes else _MM["mm"] if "G21" in codes else unit
    if feed := dict(words).get("F"):
        source.draft.put("dialect.feed_default_mm_min", feed * scale, told)
    _path_mode(source, codes, dict(words).get("P"), scale, told if code else "")


def _unsaid(bare, codes):
    """Return what no machine file can say: a call, an expression, a sign, some codes."""
    odd = [bare] if _START_WORD.sub("", bare) else []
    return [*odd, *filter(_STARTS_NOWHERE.fullmatch, codes)]


def _path_mode(source, codes, within, scale, told):
    """G61 or G64 of the start-up code; without both LinuxCNC has a bare G64."""
    if "G64" in codes and within is not None:
        source.draft.put("path.tolerance_mm", within * scale, told)
    elif "G61" in codes:
        source.draft.put("path.tolerance_mm", 0, told)
    else:
        words = told or "no start-up code: G64 without P"
        source.draft.put("control.g64_without_p", "length", words)
        return
    source.draft.put("control.g64_without_p", "tolerance", told)


def _arcs(source, unit):
    """How far arcs may miss their circle; the others' tolerance is for programs in the other unit.
    """
    named = "inch" if unit == _MM["inch"] else "mm"
    least, most = _ARCS[named]
    told, comment = source.number(("rs274ngc", f"center_arc_radius_tolerance_{named}"))
    if told is None:
        told, comment = most, OWN_DEFAULT
    elif not least <= told <= most:
        told, comment = most, f"{comment} is beyond {least} to {most}, so {OWN_DEFAULT}"
    source.draft.put("path.arc_radius_mm", told * _MM[named], comment)


def _without_travel(source, letter):
    source.draft.left.append(f"travel of {letter.upper()}: none in the source; taken as free")


def _is_hal(source):
    return ("$", "398") in source.settings or ("i", "firmware") in source.settings


def _home_of_grbl(source, k):
    """Return (whether an axis' travel is above 0, why).

    It is below 0, wherever the axis homes; but of grblHAL above, where it homes at the lower end
    ($23) and where it has homed becomes its zero ($22, bit 3).
    """
    (flags, one), (mask, other) = (
        source.number(("$", number)) if _is_hal(source) else (None, "") for number in ("22", "23")
    )
    if flags is None or mask is None:
        return False, "homed at the upper end, as grbl does"
    is_above = bool(int(flags) & 8) and bool(int(mask) >> k & 1)
    return is_above, f"{one}; {other}"


def _travel_of_grbl(source, letter, k):
    """Fill in the travel of an axis, the k-th."""
    travel, comment = source.number(("$", f"{130 + k}"))
    if travel and travel < 0:
        words = "a travel has no sign: it is below grbl's home"
        source.draft.problems.append((comment, words))
    elif travel:
        is_above, home = _home_of_grbl(source, k)
        ends = ("min", "max") if is_above else ("max", "min")
        source.draft.axis(letter, ends[0], Decimal(0), home)
        source.draft.axis(letter, ends[1], travel if is_above else -travel, comment)
    else:
        _without_travel(source, letter)


def grbl(source):
    """Fill in what $$ and $I print; return the letters of its axes."""
    has = source.settings
    letters = [letter for k, letter in enumerate("xyzabc") if ("$", f"{110 + k}") in has]
    for letter in letters:
        k = "xyzabc".index(letter)
        source.axis(letter, "v_max", [("$", f"{110 + k}")], 1 / Decimal(60))
        source.axis(letter, "a_max", [("$", f"{120 + k}")])
        _travel_of_grbl(source, letter, k)
        source.own(f"steps_per_mm.{letter}", [("$", f"{100 + k}")])
    source.path("path.chord_error_mm", [("$", "12")])
    source.path("spindle.rpm_max", [("$", "30")])
    source.draft.left.append("home and G28: where they are, the settings do not say; taken as 0")
    is_hal = _is_hal(source)
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


def _travel_of_fluidnc(source, letter, own):
    travel, comment = source.number((own, "max_travel_mm"))
    if travel is None:
        travel, comment = Decimal(1000), OWN_DEFAULT
    if not travel:
        _without_travel(source, letter)
        return
    at = source.number((f"{own}.homing", "mpos_mm"))[0] or Decimal(0)
    up = (source.word((f"{own}.homing", "positive_direction")) or "true").lower() == "true"
    ends = (at - travel, at) if up else (at, at + travel)
    for end, place in zip(("min", "max"), ends, strict=True):
        source.draft.axis(letter, end, place, comment)


_SPINDLES = ("laser", "pwm", "onoff", "relay", "10v", "dac", "besc", "hbridge", "huanyang",
             "yl620", "h2a", "h100", "nowforever", "siemens_v20", "modbusvfd",
             "plasmaspindle")  # fmt: skip


def _laser_of_fluidnc(source):
    """Whether tool 0, which it begins with, is a laser: then an S on a move is no rest."""
    heads = [name for name in _SPINDLES if name in source.form.heads.values()]
    if "laser" not in heads:
        return
    numbers = {name: source.number((name, "tool_num"))[0] or 0 for name in heads}
    source.axes.add("laser")
    is_first = numbers["laser"] == min(numbers.values())
    words = "laser:" if is_first else "laser: its tool_num is not the first"
    source.draft.put("control.laser_mode", is_first, words)


def fluidnc(source):
    """Fill in a config.yaml; return the letters of its axes."""
    letters = source.letters_of("axes.", AXES)
    for letter in letters:
        own = f"axes.{letter}"
        source.axis(letter, "v_max", [(own, "max_rate_mm_per_min")], 1 / Decimal(60),
                    Decimal(1000))  # fmt: skip
        source.axis(letter, "a_max", [(own, "acceleration_mm_per_sec2")], default=Decimal(25))
        _travel_of_fluidnc(source, letter, own)
        source.own(f"steps_per_mm.{letter}", [(own, "steps_per_mm")], Decimal(80))
    named = [each for each in source.form.heads.values() if each.startswith("kinematics.")]
    for name in (each.removeprefix("kinematics.") for each in named):
        if name != "cartesian":
            source.draft.left.append(f"kinematics {name}: planned is the tool's path in X Y Z")
    source.path("path.chord_error_mm", [("", "arc_tolerance_mm")])
    source.draft.put("control.kind", "fluidnc")
    _laser_of_fluidnc(source)
    source.own("junction_deviation", [("", "junction_deviation_mm")], Decimal("0.01"))
    source.own("arc_tolerance", [("", "arc_tolerance_mm")], Decimal("0.002"))
    source.own("planner_blocks", [("", "planner_blocks")], Decimal(16))
    source.draft.put("dialect.base", "grbl")
    return letters
