# SPDX-License-Identifier: MIT
"""Times by another control's own planner: its settings as C has them, and whole programs.

The rules and their sources are in ``docs/controls.md``.
"""

import math
from decimal import Decimal

import numpy as np

from pycnc import errors, kernel
from pycnc.kernel.bind import check, ffi, lib, pointer
from pycnc.kernel.records import copied, dtype
from pycnc.machine import Machine
from pycnc.machine.control import GRBLS, NCKS, PRINTERS
from pycnc.machine.schema import AXES, unit_of
from pycnc.program import limits

BLOCKS = {"grbl": 16, "grblhal": 100, "fluidnc": 16, "marlin": 16}  # of a ring, as they ship
_KINDS = {
    "klipper": lib.NCK_HOST_CONTROL_KLIPPER, **dict.fromkeys(GRBLS, lib.NCK_HOST_CONTROL_GRBL),
    "marlin": lib.NCK_HOST_CONTROL_MARLIN, "linuxcnc": lib.NCK_HOST_CONTROL_LINUXCNC,
}  # fmt: skip
_LINES = 16384  # of Klipper that are planned together
_LINES_LEAST = 1024
_SPEED, _FLOW = 220, 221  # M220 S, M221 S: percent of the speed of all moves, of what is extruded
_E = AXES.index("u")
_STRETCHES = 65536  # rows at a time; more, where one block has more of them
FREE = 1e12  # mm/s, mm/s²: no limit
_NOBODY_S_MM = Decimal("0.0101010101")
_DEVIATION = {"marlin": 0.013}


def is_foreign(machine):
    """Tell whether a machine's times are another control's."""
    return machine.settings.control.kind not in NCKS


def refuse(machine, what):
    """Refuse what only this kernel does, for a machine with another control's planner.

    Raises
    ------
    ArgumentError
    """
    kind = machine.settings.control.kind
    raise errors.ArgumentError(
        f"{what} of this kernel alone, and control.kind is {kind}; for this kernel: "
        "--set control.kind=nck",
        id="control",
    )


def title(machine):
    """Return how a plan of a machine is told of: its slope, or whose rules they are."""
    settings = machine.settings
    if is_foreign(machine):
        return f"as {settings.control.kind} plans"
    return f"slope {settings.path.slope}"


def words(name, machine, angles):
    """Return what a cause is called where another control plans; empty: as with this kernel."""
    own = machine.settings.control
    rule = {"klipper": "square_corner_velocity", "linuxcnc": "its tolerance"}.get(own.kind)
    corner = rule or ("jerk" if own.jerk.present() else "junction_deviation")
    ahead = int(rule_of(machine)["ahead"][0])
    return {
        "corner": f"corners of {angles}, {corner}",
        "accel": "minimum_cruise_ratio" if own.kind == "klipper" else "acceleration",
        "lookahead": f"the ring of blocks: looks only {ahead} lines ahead",
        "spindle": "rests where S changes",
        "wait": "rests for spindle, coolant, tool or operator",
        "exact_stop": "stops",
    }.get(name, "")


def cures(machine):
    """Yield (words, changes) of what another control's settings may be instead."""
    own, kind = machine.settings.control, machine.settings.control.kind
    yield "this kernel (control.kind = nck)", {"control.kind": "nck"}
    value = rule_of(machine)[0]["value"]
    if kind == "klipper":
        yield from _cures_of_klipper(value)
        return
    yield "acceleration x 2", accelerations_twice(machine)
    if kind == "linuxcnc":
        return
    if not own.jerk.present():
        deviation = float(value[lib.NCK_CONTROL_DEVIATION]) or 0.01
        yield "junction_deviation x 2", {"control.junction_deviation": 2 * deviation}
    blocks = own.planner_blocks or BLOCKS[kind]
    yield f"a ring of {8 * blocks} blocks", {"control.planner_blocks": min(1000, 8 * blocks)}
    if kind in GRBLS and not own.laser_mode:
        yield "laser_mode: S on a move is no rest", {"control.laser_mode": True}


def _cures_of_klipper(value):
    for key, place in (
        ("max_accel", lib.NCK_CONTROL_A_PATH), ("square_corner_velocity", lib.NCK_CONTROL_CORNER),
        ("max_velocity", lib.NCK_CONTROL_V_PATH),
    ):  # fmt: skip
        if value[place] > 0:
            yield f"{key} x 2", {f"control.{key}": 2 * float(value[place])}
    yield "minimum_cruise_ratio 0", {"control.minimum_cruise_ratio": 0}


def accelerations_twice(machine):
    """Return the changes that double what axes, and lines of each kind, may accelerate."""
    own, twice = machine.settings.control, {}
    for letter, axis in machine.settings.axis.present().items():
        key = f"a_max_{unit_of(letter)}_s2"
        twice[f"axis.{letter}.{key}"] = 2 * getattr(axis, key)
    for key in ("acceleration", "travel_acceleration", "retract_acceleration"):
        if (has := getattr(own, key)) is not None:
            twice[f"control.{key}"] = 2 * has
    return twice


def rule_of(machine):
    """Return a machine's control as C has it, one row of dtype ``nck_host_control_rule_t``."""
    settings = machine.settings
    own, kind = settings.control, settings.control.kind
    rows = np.zeros(1, dtype("nck_host_control_rule_t"))
    rule, value = rows[0], rows[0]["value"]
    rule["kind"], rule["laser"] = _KINDS[kind], own.laser_mode
    rule["classic"] = bool(own.jerk.present())
    value[: lib.NCK_CONTROL_JERK] = FREE
    value[lib.NCK_CONTROL_JERK : lib.NCK_CONTROL_STEPS] = FREE
    value[lib.NCK_CONTROL_V_PATH] = value[lib.NCK_CONTROL_A_PATH] = FREE
    for letter, axis in settings.axis.present().items():
        place, unit = AXES.index(letter), unit_of(letter)
        value[lib.NCK_CONTROL_V + place] = getattr(axis, f"v_max_{unit}_s")
        value[lib.NCK_CONTROL_A + place] = getattr(axis, f"a_max_{unit}_s2")
    for name, begin in (("steps_per_mm", lib.NCK_CONTROL_STEPS), ("jerk", lib.NCK_CONTROL_JERK)):
        for letter, number in getattr(own, name).present().items():
            value[begin + AXES.index(letter)] = number
    {"klipper": _klipper, "marlin": _marlin, "linuxcnc": _linuxcnc}.get(kind, _grbl)(
        rule, value, own, machine
    )
    return rows


def _ring(rule, own):
    """One block of a ring is never filled."""
    rule["ahead"] = (own.planner_blocks or BLOCKS[own.kind]) - 1


def _klipper(rule, value, own, machine):
    path = machine.record["path"]
    velocity = float(own.max_velocity or path["feed_max"])
    accel = float(own.max_accel or path["a_max"])
    # Filament alone: as fast as a line four nozzles square would take it.
    radius = float(own.filament_diameter) / 2
    ratio = 4 * float(own.nozzle_diameter) ** 2 / (math.pi * radius**2)
    z = AXES.index("z")
    value[: lib.NCK_CONTROL_JERK] = FREE  # one for all axes but Z
    value[lib.NCK_CONTROL_V + z] = own.max_z_velocity or velocity
    value[lib.NCK_CONTROL_A + z] = own.max_z_accel or accel
    value[lib.NCK_CONTROL_V_PATH], value[lib.NCK_CONTROL_A_PATH] = velocity, accel
    value[lib.NCK_CONTROL_CORNER] = own.square_corner_velocity
    value[lib.NCK_CONTROL_CRUISE_RATIO] = own.minimum_cruise_ratio
    value[lib.NCK_CONTROL_CORNER_E] = own.instantaneous_corner_velocity
    value[lib.NCK_CONTROL_V_EXTRUDE] = own.max_extrude_only_velocity or velocity * ratio
    value[lib.NCK_CONTROL_A_EXTRUDE] = own.max_extrude_only_accel or accel * ratio
    value[lib.NCK_CONTROL_CHORD] = own.resolution


def _grbl(rule, value, own, machine):
    _ring(rule, own)
    value[lib.NCK_CONTROL_DEVIATION] = _deviation(own)
    value[lib.NCK_CONTROL_CHORD] = own.arc_tolerance


def _deviation(own):
    has = own.junction_deviation
    return _DEVIATION.get(own.kind, 0.01) if has is None else has


def _marlin(rule, value, own, machine):
    _ring(rule, own)
    # The block in work is not planned again: one line less is seen.
    rule["ahead"] -= 1
    accel = own.acceleration or FREE
    value[lib.NCK_CONTROL_A_PATH] = accel
    value[lib.NCK_CONTROL_A_TRAVEL] = own.travel_acceleration or accel
    value[lib.NCK_CONTROL_A_RETRACT] = own.retract_acceleration or accel
    value[lib.NCK_CONTROL_DEVIATION] = _deviation(own)
    value[lib.NCK_CONTROL_CHORD] = own.mm_per_arc_segment
    value[lib.NCK_CONTROL_SEGMENT_S] = own.min_segment_time_us * 1e-6


def _linuxcnc(rule, value, own, machine):
    rule["ahead"] = 50
    path = machine.record["path"]
    value[lib.NCK_CONTROL_V_PATH], value[lib.NCK_CONTROL_A_PATH] = path["feed_max"], path["a_max"]
    value[lib.NCK_CONTROL_PERIOD_S] = machine.period_s
    value[lib.NCK_CONTROL_CHORD] = path["chord_error"]


def _bare(machine):
    """Return the machine with a tolerance that no program says, which then stands for G64 without
    P; None where that is the machine's own."""
    own = machine.settings.control
    if own.kind != "linuxcnc" or own.g64_without_p == "tolerance":
        return None
    return Machine.load(machine, set={"path.tolerance_mm": _NOBODY_S_MM})


class Planner:
    """Plans a whole program as the machine's control does; in the place of `kernel.Planner`.

    Parameters
    ----------
    program : Program
    shares : int or numpy.ndarray, optional
        As `kernel.Planner` takes it.
    override : float
        Of the feed, 1 for 100 %; printers have one for rapids, too.
    traced : bool
        Whether `pieces` yields the path.

    Attributes
    ----------
    totals, why, shares
        As of `kernel.Planner`.
    """

    def __init__(self, program, shares=None, override=1.0, traced=False):
        machine = self._machine = program.machine
        self._override, self._shares = override, {_SPEED: 1.0, _FLOW: 1.0}
        self._e_nm = [int(machine.record["start_nm"][_E])] * 2  # as the program counts, as it is
        self._program, self._rule = program, rule_of(machine)
        self._bare = _bare(machine)
        if self._bare is not None:
            self._rule["value"][0, lib.NCK_CONTROL_BARE] = self._bare.record["path"]["tolerance"]
        self._state = state = ffi.new("nck_host_control_t *")
        most = max(_LINES_LEAST, 2 * int(self._rule["ahead"][0]))
        lines = _LINES if machine.settings.control.kind == "klipper" else most
        self._lines = np.zeros(lines, dtype("nck_host_control_line_t"))
        self._changes = limits.changes(program.text, machine)
        state.lines, state.line_max = pointer("nck_host_control_line_t", self._lines), lines
        state.changes = pointer("nck_host_control_change_t", self._changes)
        state.change_count = len(self._changes)
        status = lib.nck_host_control_init(
            state, pointer("nck_host_control_rule_t", self._rule), machine.pointer
        )
        if status == lib.NCK_E_ARGUMENT:
            raise errors.ArgumentError("a setting of the control is out of range", id="control")
        check(status)
        self._rows = kernel.ask_shares(state.shares, shares)
        self._stretches = np.empty(0, dtype("nck_host_control_stretch_t"))
        self._feet = np.empty(0, dtype("nck_host_foot_t"))
        if traced:
            self._have_rows(_STRETCHES)

    def _have_rows(self, count):
        """Have rows for so many stretches, where they are asked for."""
        if not 0 < count > len(self._stretches):
            return
        trace = self._state.trace
        self._stretches = np.zeros(count, self._stretches.dtype)
        self._feet = np.zeros(count, self._feet.dtype)
        trace.stretches = pointer("nck_host_control_stretch_t", self._stretches)
        trace.feet, trace.stretch_max = pointer("nck_host_foot_t", self._feet), count

    def run(self, progress=None):
        """Plan it."""
        for _ in self.pieces(progress):
            pass

    def pieces(self, progress=None):
        """Plan it, and yield (stretches, low points) as they are final, if it is traced.

        Their dtypes are ``nck_host_control_stretch_t`` and ``nck_host_foot_t``, whose numbers
        count stretches. The arrays are filled again by the next piece.
        """
        state, done, count = self._state, 0, self._program.block_count
        for piece in self._pieces():
            blocks = self._overridden(piece)
            yield from self._taken(blocks)
            done += len(blocks)
            if progress:
                progress(done, count)
        if len(self._stretches):
            self._have_rows(lib.nck_host_control_room(state, ffi.NULL))
        lib.nck_host_control_end(state)
        yield self._told()

    def _taken(self, blocks):
        first, taken = pointer("nck_block_t", blocks), 0
        while taken < len(blocks):
            some = lib.nck_host_control_take(self._state, first + taken, len(blocks) - taken)
            taken += some
            if some == 0:
                self._have_rows(lib.nck_host_control_room(self._state, first + taken))
            elif len(self._stretches):
                yield self._told()

    def _told(self):
        trace = self._state.trace
        return self._stretches[: trace.stretch_count], self._feet[: trace.foot_count]

    def _overridden(self, blocks):
        """Return blocks at the speeds that the override leaves of them, and a printer's M220, with
        as much filament as its M221 has."""
        prints = self._machine.settings.control.kind in PRINTERS
        share = self._override * self._said(blocks, _SPEED) if prints else self._override
        blocks = self._flown(blocks) if prints else blocks
        if np.all(share == 1):
            return blocks
        blocks = copied(blocks)
        scaled = prints | (blocks["kind"] != lib.NCK_BLOCK_RAPID)
        blocks["feed"] *= np.where(scaled, share, 1.0)
        return blocks

    def _flown(self, blocks):
        """Return blocks whose steps of filament are the share that the program says."""
        share = self._said(blocks, _FLOW)
        said_nm, is_nm = self._e_nm
        if (np.all(share == 1) and said_nm == is_nm) or not len(blocks):
            self._e_nm = [int(blocks["target_nm"][-1, _E])] * 2 if len(blocks) else self._e_nm
            return blocks
        blocks = copied(blocks)
        places = blocks["target_nm"][:, _E].astype(np.float64)
        self._e_nm[0] = int(places[-1])
        steps = np.diff(places, prepend=said_nm) * share
        blocks["target_nm"][:, _E] = np.rint(is_nm + np.cumsum(steps))
        self._e_nm[1] = int(blocks["target_nm"][-1, _E])
        return blocks

    def _said(self, blocks, code):
        """Return the share that the program itself says by a code of M, of each block."""
        told = blocks["output"]
        says = (blocks["kind"] == lib.NCK_BLOCK_OUTPUT) & (told["number"] == code)
        says &= (told["kind"] == lib.NCK_OUTPUT_SETTING) & (told["value"] > 0)
        if not says.any():
            return self._shares[code]
        shares = np.full(len(blocks), self._shares[code])
        for place in np.flatnonzero(says):
            shares[place:] = told["value"][place] / 100
        self._shares[code] = shares[-1]
        return shares

    def _pieces(self):
        if self._bare is None:
            return self._program.pieces()
        return (blocks for blocks, *_ in kernel.decode(self._program.text, self._bare))

    @property
    def totals(self):
        """What the plan adds up to, as a record of ``nck_host_totals_t``."""
        return kernel.record_of(self._state.totals, "nck_host_totals_t")

    @property
    def shares(self):
        """The parts of the time, as they were asked for."""
        return kernel.shares_of(self._state.shares, self._rows[0])

    @property
    def why(self):
        """What the time goes to."""
        return kernel.causes_of(self._state)
