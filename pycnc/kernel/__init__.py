# SPDX-License-Identifier: MIT
"""Calls into the kernel in bulk: decode a text, plan it, run it in the simulation.

Each is a generator that works through the text in bounded pieces, so that a caller can show
progress, stop, or keep nothing. Arrays that it yields are its own and are filled again by the next
piece: copy what is to stay.
"""

import itertools

import numpy as np

from pycnc import errors
from pycnc.kernel.bind import build_of, check, ffi, lib, pointer, room_for
from pycnc.kernel.records import dtype, enum
from pycnc.names import version  # noqa: F401

BLOCK_ROWS = 16384  # that are decoded at a time
_DIAGNOSTIC_ROWS = 4096
_PLAN_ROWS = 4 * lib.NCK_WINDOW  # the least that nck_host_plan_run takes
_TRAIL_ROWS = 16 * lib.NCK_HOST_TRAIL_ROOM
_TRAIL = {"host_point": ("points", "point"), "host_foot": ("feet", "foot")}
_TICK_ROWS = 16384
_OF_SPINDLE = (lib.NCK_BLOCK_THREAD, lib.NCK_BLOCK_TAP)
_COMMANDS = {  # name → (kind, how many numbers it needs, the most that each may be)
    "hold": (lib.SIM_HOLD, 0, ()),
    "resume": (lib.SIM_RESUME, 0, ()),
    "override": (lib.SIM_OVERRIDE, 1, (200, 100)),
    "single_block": (lib.SIM_SINGLE_BLOCK, 1, (1,)),
    "abort": (lib.SIM_ABORT, 0, ()),
}
# Prep steps between two ticks: more than any program of 1 µm moves needs, and enough that the first
# plan behind a wait, which begins with the resume, is made before the next tick.
PREP_STEPS = 4096


class Blocks(bytes):
    """A program without text: the bytes of rows of dtype ``nck_block_in_t``."""


def rows_of_blocks():
    """Return an array for the blocks that are decoded at a time."""
    return np.empty(BLOCK_ROWS, dtype("nck_block_t"))


def decode(text, machine, another=None):
    """Decode a whole text, or `Blocks`.

    Parameters
    ----------
    text : bytes
    machine : Machine
    another : callable, optional
        Returns the array that the next blocks are for, of dtype ``nck_block_t``; without it they
        are all for the same one.

    Yields
    ------
    blocks : numpy.ndarray
        Of dtype ``nck_block_t``.
    diagnostics : numpy.ndarray
        Of dtype ``nck_diagnostic_t``.
    used : int
        Bytes of the text that are read so far.
    """
    state, decoding = ffi.new("nck_decode_t *"), ffi.new("nck_host_decoding_t *")
    toolcomp = ffi.new("nck_toolcomp_t *")
    lib.nck_decode_init(state, machine.pointer)
    lib.nck_toolcomp_init(toolcomp, machine.pointer)
    if another is None:
        another = itertools.repeat(rows_of_blocks()).__next__
    diagnostics = np.empty(_DIAGNOSTIC_ROWS, dtype("nck_diagnostic_t"))
    data = ffi.from_buffer("char[]", text)
    decoding.text, decoding.text_size = data, len(text)
    decoding.is_blocks = isinstance(text, Blocks)
    decoding.diagnostics = pointer("nck_diagnostic_t", diagnostics)
    decoding.diagnostic_max = len(diagnostics)
    status = lib.NCK_OK
    while status == lib.NCK_OK:
        blocks = another()
        decoding.blocks, decoding.block_max = pointer("nck_block_t", blocks), len(blocks)
        status = lib.nck_host_decode(state, toolcomp, decoding)
        if status == lib.NCK_E_ARGUMENT:
            raise _bad_block(text, decoding.text_used)
        check(status)
        yield (
            blocks[: decoding.block_count], diagnostics[: decoding.diagnostic_count],
            decoding.text_used,
        )  # fmt: skip


def _bad_block(data, used):
    """Return the error that names the block behind so many bytes: it is outside of its range."""
    rows = np.frombuffer(data, dtype("nck_block_in_t"))
    k = used // rows.itemsize
    return errors.ArgumentError(
        f"move {k} (counted from 0) has a member outside of its range: {rows[k]}; see "
        "docs/firmware.md, section 9",
        id="argument",
    )


def has_threads(blocks):
    """Return whether passes of threads or taps are among blocks of dtype ``nck_block_t``."""
    return bool(np.isin(blocks["kind"], _OF_SPINDLE).any())


def cuts(text, machine, least):
    """Yield (cut, blocks) of each part that a text is cut into at its rests.

    Parameters
    ----------
    text : bytes
    machine : Machine
    least : int
        Blocks of a part, the last one's left out: it is cut at the next dwell or wait behind them.

    Yields
    ------
    cut : bytes
        Where the part begins, and what is in force there, for `Planner`.
    blocks : int
        How many the part has; of the last one 0.
    """
    cut, data = ffi.new("nck_host_cut_t *"), ffi.from_buffer("char[]", text)
    check(lib.nck_host_cut_init(cut, machine.pointer, data, len(text)))
    blocks = -1
    while blocks:
        begun, here = int(cut.blocks), bytes(ffi.buffer(cut))
        found = lib.nck_host_cut_next(cut, least) == lib.NCK_OK
        blocks = int(cut.blocks) - begun if found else 0
        yield here, blocks


class Planner:
    """Plans a whole text without executing it.

    Parameters
    ----------
    text : bytes
    machine : Machine
    records : sequence of str
        Which records `pieces` yields: of seg, node, cell, output; of the trail host_point and
        host_foot, both together.
    part : tuple, optional
        One of those that `cuts` gives, to plan it alone.
    shares : int or numpy.ndarray, optional
        Parts of the time that are asked for: so many tools at most; or for every source line the
        number of its row (uint32).
    threads : bool
        Whether the program has threads or taps, whose waits for the spindle's angle are to be
        planned. Each is half a turn without it, and in a part.

    Attributes
    ----------
    totals : numpy.void
        Of dtype ``nck_host_totals_t``: sums so far, complete when `pieces` has ended.
    shares : numpy.ndarray
        Of dtype ``nck_host_share_t``: the rows that were asked for, as above.
    why : dict
        "causes": of dtype ``nck_host_cause_t``, those that lose time; "cut_s", "rapid_s",
        "dwell_s": the time without them. Complete when `pieces` has ended.
    """

    def __init__(self, text, machine, records=("seg", "node", "cell"), shares=None,
                 part=None, threads=False):  # fmt: skip
        self._text, self._machine = text, machine
        self._build = build_of(machine.settings.control.kind)
        self._rooms, self._nck = room_for("nck_t *", self._build.kernel_size)
        self._room, self._plan = room_for("nck_host_plan_t *", self._build.plan_size)
        self._data = ffi.from_buffer("char[]", text)
        init = self._build.plan_init
        check(init(self._plan, self._nck, machine.pointer, self._data, len(text)))
        if isinstance(text, Blocks):
            self._build.plan_blocks(self._plan)
        if part is not None:
            cut = ffi.from_buffer("nck_host_cut_t *", part[0])
            check(self._build.plan_part(self._plan, cut, part[1]))
        elif threads:
            self._build.plan_threads(self._plan)
        self._shares = ask_shares(self._plan.why.shares, shares)
        self._arrays = {
            name: np.empty(_TRAIL_ROWS if name in _TRAIL else _PLAN_ROWS, dtype(f"nck_{name}_t"))
            for name in records
        }
        for name, array in self._arrays.items():
            owner, rows, short = self._rows_of(name)
            setattr(owner, rows, pointer(f"nck_{name}_t", array))
            setattr(owner, f"{short}_max", len(array))

    def _rows_of(self, name):
        """Return who has the rows of a record, under which name, and the name of their counts."""
        if name in _TRAIL:
            return self._plan.why.trail, *_TRAIL[name]
        return self._plan, f"{name}s", name

    def pieces(self):
        """Yield (segs, nodes, cells, bytes used) or what was asked for, until the plan is done.

        Raises
        ------
        ProgramError
            At the first error of the program; everything before it has been planned.
        """
        status = lib.NCK_OK
        while status == lib.NCK_OK:
            status = self._build.plan_run(self._plan)
            check(status)
            owners = {name: self._rows_of(name) for name in self._arrays}
            pieces = (
                self._arrays[name][: getattr(owner, f"{short}_count")]
                for name, (owner, _, short) in owners.items()
            )
            yield *pieces, self._plan.text_used

    @property
    def totals(self):
        """What the plan adds up to, as a record of ``nck_host_totals_t``."""
        return record_of(self._plan.totals, "nck_host_totals_t")

    @property
    def shares(self):
        """The parts of the time, as they were asked for."""
        return shares_of(self._plan.why.shares, self._shares[0])

    @property
    def why(self):
        """What the time goes to."""
        return causes_of(self._plan.why)


def ask_shares(shares, asked):
    """Ask a ``nck_host_shares_t`` for parts of the time; return what must live as long: rows first.

    asked: as `Planner` takes it.
    """
    by_line = isinstance(asked, np.ndarray)
    count = 0 if asked is None else int(asked.max()) + 1 if by_line else asked
    rows = np.zeros(count, dtype("nck_host_share_t"))
    if count:
        shares.rows, shares.max = pointer("nck_host_share_t", rows), count
    if not by_line:
        return (rows,)
    row_of_line = np.ascontiguousarray(asked, np.uint32)
    shares.row_of_line = pointer("uint32_t", row_of_line)
    shares.line_max = len(asked) - 1
    return rows, row_of_line


def shares_of(shares, rows):
    """Return the rows of a ``nck_host_shares_t`` that have something."""
    return rows if shares.row_of_line != ffi.NULL else rows[: shares.count]


def record_of(struct, name):
    """Return a copy of a struct in C as a record of a dtype."""
    return np.frombuffer(bytes(ffi.buffer(ffi.addressof(struct))), dtype(name))[0]


def causes_of(why):
    """Return what time is lost to, and the ideal: of a record with causes and these sums."""
    causes = np.frombuffer(bytes(ffi.buffer(why.causes)), dtype("nck_host_cause_t"))
    ideal = {name: _sum(getattr(why, name)) for name in ("cut_s", "rapid_s", "dwell_s")}
    return {"causes": causes[causes["lost_s"]["sum"] != 0], **ideal}


def _sum(number):
    """Return what a ``nck_host_sum_t`` adds up to."""
    return number.sum + number.rest


def _command_rows(commands):
    """Return what the operator does as C reads it, in the order of ticks."""
    commands = sorted(commands, key=lambda command: command[0])
    rows = np.zeros(len(commands), dtype("sim_command_t"))
    for row, (tick, name, *numbers) in zip(rows, commands, strict=True):
        kind, needed, most = _command(tick, name, numbers)
        if name == "override":
            numbers = [*numbers, *most[len(numbers) :]]  # rapids are at 100 % unless told
        row["tick"], row["kind"], row["value"][: len(numbers)] = tick, kind, numbers
    return rows


def _command(tick, name, numbers):
    """Return an item of _COMMANDS; refuse what it does not allow."""
    if name not in _COMMANDS:
        names = ", ".join(_COMMANDS)
        raise errors.ArgumentError(f"no command {name!r}; there are: {names}", id="command")
    kind, needed, most = _COMMANDS[name]
    good = tick >= 0 and needed <= len(numbers) <= len(most)
    if not good or any(not 0 <= n <= limit for n, limit in zip(numbers, most, strict=False)):
        ranges = " and ".join(f"0 … {limit}" for limit in most) or "no number"
        told = " ".join(map(str, (tick, name, *numbers)))
        raise errors.ArgumentError(
            f"command {told!r}: takes a tick from 0 on, and {ranges}", id="command"
        )
    return kind, needed, most


class Simulation:
    """The simulation: prep steps and ticks interleaved in virtual time.

    Parameters
    ----------
    text : bytes
    machine : Machine
    prep_steps : int
        Prep steps between two ticks, 1 at least. Few of them starve the tick.
    commands : iterable of tuple
        What the operator does, as `pycnc.run` takes it.
    spindle : tuple of float, optional
        A measured spindle: by how much it is late [s], by which share its speed swells and falls,
        over so many revolutions. Without it the spindle turns as commanded.
    """

    def __init__(self, text, machine, prep_steps=PREP_STEPS, commands=(), spindle=None):
        self._text, self._machine = text, machine
        self._build = build_of(machine.settings.control.kind)
        self._rooms, self._nck = room_for("nck_t *", self._build.kernel_size)
        self._sim = ffi.new("sim_t *")
        self._data = ffi.from_buffer("char[]", text)
        init = self._build.sim_init
        check(init(self._sim, self._nck, machine.pointer, self._data, len(text), prep_steps))
        if isinstance(text, Blocks):
            self._build.sim_feed_blocks(self._sim)
        if spindle is not None:
            own = self._sim.spindle
            own.late_s, own.ripple, own.ripple_turns = spindle
            own.on = 1
        self._commands = _command_rows(commands)
        lib.sim_operate(
            self._sim, pointer("sim_command_t", self._commands), len(self._commands)
        )

    def pieces(self):
        """Yield (rows, bytes used): one row of dtype ``sim_row_t`` a tick.

        Raises
        ------
        ProgramError
            After everything before the error has been executed.
        InternalError
            If neither preparation nor the tick goes on, with the numbers of where it stands.
        """
        rows, count = np.empty(_TICK_ROWS, dtype("sim_row_t")), ffi.new("size_t *")
        status = lib.NCK_OK
        while status == lib.NCK_OK:
            status = self._build.sim_run(self._sim, pointer("sim_row_t", rows), len(rows), count)
            yield rows[: count[0]], self._sim.text_used
            if self.end == "stalled":
                raise errors.InternalError(self._stall(), id="internal", status=status)
            check(status)

    def _stall(self):
        sim, pose, axes = self._sim, ffi.new("nck_pose_t *"), ffi.new("nck_axes_t *")
        queue = ffi.new("nck_queue_t *")
        self._build.position(self._nck, pose, axes)
        self._build.queue(self._nck, queue)
        return (
            f"the run stands still after tick {sim.ticks:,} ({sim.ticks * self._machine.period_s:g}"
            f" s), at line {pose.line}: neither preparation nor the tick goes on "
            f"({sim.text_used:,} of {len(self._text):,} bytes read, prep status "
            f"{sim.prep_status}, {queue.segs} segs unfinished)"
        )

    @property
    def thread_lost(self):
        """Whether a thread was stopped before its end."""
        return bool(self._build.is_thread_lost(self._nck))

    @property
    def end(self):
        """How the run has ended: "done", "hold", "single_block", "override" (of 0), "aborted" or
        "stalled"; "not" while it goes on.
        """
        return enum("sim_end_t")(self._sim.end).name.lower()

    @property
    def starved_ticks(self):
        """Ticks so far in which the path was waited for."""
        return self._sim.starved_ticks
