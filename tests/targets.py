# SPDX-License-Identifier: MIT
"""Programs of tests/qemu: built for the host and for the emulated boards, and run there."""

import re
import subprocess
import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from builds import CMAKE, NINJA, keep_what_is_compiled
from locks import locked

from pycnc.kernel.bind import lib
from pycnc.kernel.records import dtype

ROOT = Path(__file__).resolve().parents[1]
BOARDS = {"m4f": "mps2-an386", "m7": "mps2-an500", "m55": "mps3-an547"}
SPANS = ("prep", "tick")
LIMIT_S = 60  # an interrupt that takes longer than its period never lets go


@dataclass(frozen=True)
class Result:
    """What a run of tests/qemu/setpoints.c tells.

    `instructions` is {span: (runs, sum, most)}, counted by the emulator only.
    """

    hash: int
    ticks: int
    starved: int
    prep_steps: int
    error: int
    kernel_bytes: int
    stack_bytes: int
    instructions: dict | None = None


class TargetError(Exception):
    """A program did not build, or did not run to its end; `status` is its exit status."""

    def __init__(self, message, status=None):
        super().__init__(message)
        self.status = status


def _run(command, **options):
    words = [str(word) for word in command]
    try:
        done = subprocess.run(words, capture_output=True, text=True, **options)
    except subprocess.TimeoutExpired as cause:
        raise TargetError(f"{command[0]}: no end within {cause.timeout} s") from None
    if done.returncode != 0:
        said = f"{command[0]}: status {done.returncode}\n{done.stdout}{done.stderr}"
        raise TargetError(said, done.returncode)
    return done.stdout


@cache
def build(core, *targets):
    """Build programs for the host or a board: "host", "m4f", "m7", "m55"; return the folder.

    Without targets those that run; "nck_called" tells who calls whom, for house/size/stack.py.
    """
    folder = ROOT / "build" / f"qemu-{core}"
    keep_what_is_compiled()
    configure = [CMAKE, "-S", ROOT / "tests" / "qemu", "-B", folder, "-G", "Ninja"]
    configure += [f"-DCMAKE_MAKE_PROGRAM={NINJA}"]
    if core != "host":
        toolchain = ROOT / "firmware_sim" / "board" / "arm-none-eabi.cmake"
        configure += ["--toolchain", toolchain, f"-DNCK_CORE={core}"]
    with locked(folder):
        if not (folder / "build.ninja").exists():
            _run(configure)
        _run([NINJA, "-C", folder, *targets])
    return folder


@cache
def capacities(name):
    """Return {macro: value} of a set of cmake/capacities.cmake: "small", "optimal" or "host"."""
    text = (ROOT / "cmake" / "capacities.cmake").read_text(encoding="utf-8")
    words = re.search(rf"NCK_CAPACITY_{name.upper()}\s+([^)]*)\)", text)[1].split()
    return {macro: int(value) for macro, value in (word.split("=") for word in words)}


def machine_image(machine, set_name):
    """Return a machine as it stands in the memory of a build with other capacities.

    Parameters
    ----------
    machine : Machine
    set_name : {"default", "small", "optimal", "host"}
    """
    given = {"default": {"NCK_TOOL_MAX": 32}, "host": {}}.get(set_name) or capacities(set_name)
    axes, tools = given.get("NCK_AXIS_MAX", lib.NCK_AXIS_MAX), given.get("NCK_TOOL_MAX")
    lengths = {lib.NCK_AXIS_MAX: axes, lib.NCK_TOOL_MAX: tools or lib.NCK_TOOL_MAX}
    lengths[lib.NCK_OWN_M_MAX] = given.get("NCK_OWN_M_MAX", lib.NCK_OWN_M_MAX)
    homes = 4 if given.get("NCK_CYCLES", 1) and given.get("NCK_LANGUAGE", 4) else 2  # NCK_HOMES
    whole = dtype("nck_machine_t")
    if given.get("NCK_VARIABLES", 1) == 0:  # has no clock
        kept = [(name, whole[name]) for name in whole.names if name != "clock"]
        whole = np.dtype(kept, align=True)
    image = np.zeros(1, _smaller(whole, lengths, homes))
    _copy(machine.record, image[0])
    return image.tobytes()


def _smaller(record, lengths, homes):
    """Return a record with fewer homes, whose arrays of axes and tools are shorter: their last
    dimension."""
    if record.subdtype:
        base, shape = record.subdtype
        last = shape[-1] if base.subdtype else lengths.get(shape[-1], shape[-1])
        return np.dtype((_smaller(base, lengths, homes), (*shape[:-1], last)))
    if not record.names:
        return record
    fields = [(name, _smaller(record[name], lengths, homes)) for name in record.names]
    for k, (name, field) in enumerate(fields):
        if name == "home_nm":
            base, shape = field.subdtype
            fields[k] = (name, np.dtype((base, (homes, *shape[1:]))))
    return np.dtype(fields, align=True)


def _copy(source, target):
    for name in target.dtype.names:
        if target[name].dtype.names and not target[name].shape:
            _copy(source[name], target[name])
            continue
        whole = source[name][tuple(slice(n) for n in target[name].shape)]
        if target[name].dtype.names:
            for k in range(len(whole)):
                _copy(whole[k], target[name][k])
        else:
            target[name] = whole


@cache
def addresses(image):
    """Return {symbol: address} of an image."""
    rows = _run(["arm-none-eabi-nm", image]).splitlines()
    return {name: int(value, 16) for value, _, name in (row.split() for row in rows)}


def emulate(core, image, *arguments, counts=None, folder=None, shift=3):
    """Run an image under the emulator until it exits; exit status 0 is good.

    With `counts`, a file, instructions are counted between the marks and written there. An
    instruction takes 2^shift ns of virtual time.
    """
    arguments = ",".join(f"arg={word}" for word in (image.stem, *arguments))
    command = ["qemu-system-arm", "-M", BOARDS[core], "-display", "none", "-monitor", "none"]
    command += ["-serial", "none", "-semihosting-config", f"enable=on,target=native,{arguments}"]
    command += ["-icount", f"shift={shift},align=off,sleep=off", "-kernel", image]
    if counts:
        found = addresses(image)
        spans = [
            f"span={name}:{found[f'mark_{name}_begin']}:{found[f'mark_{name}_end']}"
            for name in SPANS
        ]
        plugin = build("host") / "count.so"
        command += ["-plugin", ",".join([str(plugin), f"out={counts}", *spans])]
    return _run(command, timeout=LIMIT_S, cwd=folder)


def run_setpoints(core, set_name, case, machine, folder, *, count=False, hold=0):
    """Run a program on a target; return a Result.

    Parameters
    ----------
    core : {"host", "m4f", "m7", "m55"}
    set_name : {"default", "small", "optimal", "host"}
        Capacities.
    case : Case
    machine : Machine
    folder : Path
        Empty, for the files of this run; `rows` will be the setpoints.
    count : bool
        Count instructions (not on the host).
    hold : int
        Ask for a hold at this tick; 0: none.
    """
    (folder / "machine").write_bytes(machine_image(machine, set_name))
    (folder / "program").write_text(case.text)
    words = ("machine", "program", "summary", "rows", str(hold))
    if core == "host":
        _run([build(core) / f"setpoints_{set_name}", *words], cwd=folder, timeout=LIMIT_S)
    else:
        counts = folder / "counts" if count else None
        image = build(core) / f"setpoints_{set_name}.elf"
        emulate(core, image, *words, counts=counts, folder=folder)
    numbers = np.fromfile(folder / "summary", "u8")
    instructions = None
    if count:
        lines = (folder / "counts").read_text().split("\n")[:-1]
        rows = (line.split() for line in lines)
        instructions = {name: tuple(map(int, values)) for name, *values in rows}
    return Result(*map(int, numbers), instructions)
