# SPDX-License-Identifier: MIT
"""Calls into the kernel in bulk: decode a text, plan it, run it in the simulation.

Each is a generator that works through the text in bounded pieces, so that a caller can show
progress, stop, or keep nothing. Arrays that it yields are its own and are filled again by the next
piece: copy what is to stay.
"""

from importlib import metadata

import numpy as np

from pycnc import errors
from pycnc.kernel.bind import check, ffi, lib, pointer
from pycnc.kernel.records import dtype, enum

_BLOCK_ROWS = 16384
_DIAGNOSTIC_ROWS = 4096
_PLAN_ROWS = 4 * lib.NCK_WINDOW  # the least that nck_host_plan_run takes
_TICK_ROWS = 16384
_COMMANDS = {  # name → (kind, how many numbers it needs, the most that each may be)
    "hold": (lib.SIM_HOLD, 0, ()),
    "resume": (lib.SIM_RESUME, 0, ()),
    "override": (lib.SIM_OVERRIDE, 1, (200, 100)),
    "single_block": (lib.SIM_SINGLE_BLOCK, 1, (1,)),
    "abort": (lib.SIM_ABORT, 0, ()),
}
PREP_STEPS = 256  # prep steps between two ticks: more than any program of 1 µm moves needs


def version():
    """Return the version of pycnc."""
    try:
        return metadata.version("pycnc-nck")
    except metadata.PackageNotFoundError:
        return "0 (not installed)"


class Blocks(bytes):
    """A program without text: the bytes of rows of dtype ``nck_block_in_t``."""

    def splitlines(self, keepends=False):
        """Return no line: there is no text."""
        return []


def decode(text, machine):
    """Decode a whole text, or `Blocks`.

    Parameters
    ----------
    text : bytes
    machine : Machine

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
    blocks = np.empty(_BLOCK_ROWS, dtype("nck_block_t"))
    diagnostics = np.empty(_DIAGNOSTIC_ROWS, dtype("nck_diagnostic_t"))
    data = ffi.from_buffer("char[]", text)
    decoding.text, decoding.text_size = data, len(text)
    decoding.is_blocks = isinstance(text, Blocks)
    decoding.blocks, decoding.block_max = pointer("nck_block_t", blocks), len(blocks)
    decoding.diagnostics = pointer("nck_diagnostic_t", diagnostics)
    decoding.diagnostic_max = len(diagnostics)
    status = lib.NCK_OK
    while status == lib.NCK_OK:
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


class Planner:
    """Plans a whole text without executing it.

    Parameters
    ----------
    text : bytes
    machine : Machine
    records : sequence of str
        Which records `pieces` yields: of seg, node, cell, output.

    Attributes
    ----------
    totals : numpy.void
        Of dtype ``nck_host_totals_t``: sums so far, complete when `pieces` has ended.
    """

    def __init__(self, text, machine, records=("seg", "node", "cell")):
        self._text, self._machine = text, machine
        self._nck, self._plan = ffi.new("nck_t *"), ffi.new("nck_host_plan_t *")
        self._data = ffi.from_buffer("char[]", text)
        check(lib.nck_host_plan_init(self._plan, self._nck, machine.pointer, self._data, len(text)))
        if isinstance(text, Blocks):
            lib.nck_host_plan_blocks(self._plan)
        self._arrays = {
            name: np.empty(_PLAN_ROWS, dtype(f"nck_{name}_t")) for name in records
        }
        for name, array in self._arrays.items():
            setattr(self._plan, f"{name}s", pointer(f"nck_{name}_t", array))
            setattr(self._plan, f"{name}_max", len(array))

    def pieces(self):
        """Yield (segs, nodes, cells, bytes used) or what was asked for, until the plan is done.

        Raises
        ------
        ProgramError
            At the first error of the program; everything before it has been planned.
        """
        status = lib.NCK_OK
        while status == lib.NCK_OK:
            status = lib.nck_host_plan_run(self._plan)
            check(status)
            pieces = (
                array[: getattr(self._plan, f"{name}_count")]
                for name, array in self._arrays.items()
            )
            yield *pieces, self._plan.text_used

    @property
    def totals(self):
        """What the plan adds up to, as a record of ``nck_host_totals_t``."""
        data = ffi.buffer(ffi.addressof(self._plan, "totals"))
        return np.frombuffer(bytes(data), dtype("nck_host_totals_t"))[0]


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
    """

    def __init__(self, text, machine, prep_steps=PREP_STEPS, commands=()):
        self._text, self._machine = text, machine
        self._nck, self._sim = ffi.new("nck_t *"), ffi.new("sim_t *")
        self._data = ffi.from_buffer("char[]", text)
        check(
            lib.sim_init(self._sim, self._nck, machine.pointer, self._data, len(text), prep_steps)
        )
        if isinstance(text, Blocks):
            lib.sim_feed_blocks(self._sim)
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
            status = lib.sim_run(self._sim, pointer("sim_row_t", rows), len(rows), count)
            yield rows[: count[0]], self._sim.text_used
            if self.end == "stalled":
                raise errors.InternalError(self._stall(), id="internal", status=status)
            check(status)

    def _stall(self):
        sim, pose, axes = self._sim, ffi.new("nck_pose_t *"), ffi.new("nck_axes_t *")
        queue = ffi.new("nck_queue_t *")
        lib.nck_position(self._nck, pose, axes)
        lib.nck_queue(self._nck, queue)
        return (
            f"the run stands still after tick {sim.ticks:,} ({sim.ticks * self._machine.period_s:g}"
            f" s), at line {pose.line}: neither preparation nor the tick goes on "
            f"({sim.text_used:,} of {len(self._text):,} bytes read, prep status "
            f"{sim.prep_status}, {queue.segs} segs unfinished)"
        )

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
