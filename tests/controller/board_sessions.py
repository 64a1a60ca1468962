# SPDX-License-Identifier: MIT
"""A served machine on an emulated board: bytes over its UART, time as the other one says."""

import contextlib
import socket
import struct
import subprocess
import tempfile
from pathlib import Path

import serving_runs
import targets

from pycnc.kernel.bind import ffi, lib
from pycnc.kernel.session import Session

PIECE = 255  # bytes that go at once
STATE = struct.Struct("<3qQQdII")
WAIT_S = 120
INPUTS = {"door": lib.HAL_IN_DOOR, "emergency": lib.HAL_IN_EMERGENCY}


def _command(core, words):
    folder = targets.build(core)
    if core == "host":
        return [str(folder / "serving"), *words]
    arguments = ",".join(f"arg={word}" for word in ("serving", *words))
    command = ["qemu-system-arm", "-M", targets.BOARDS[core], "-display", "none"]
    command += ["-monitor", "none", "-serial", "unix:line", "-serial", "unix:clock"]
    command += ["-semihosting-config", f"enable=on,target=native,{arguments}"]
    return [*command, "-kernel", str(folder / "serving.elf")]


class BoardSession:
    """What a Session is, on a board; close it.

    Parameters
    ----------
    core : {"host", "m4f", "m7"}
        Of the capacities "default" all three.
    machine : Machine
        With the switches of its file's [inputs].
    """

    def __init__(self, core, machine):
        self._open = contextlib.ExitStack()
        folder = Path(self._open.enter_context(tempfile.TemporaryDirectory()))
        words = ["machine"]
        (folder / "machine").write_bytes(targets.machine_image(machine, "default"))
        if machine.switches is not None:
            words += ["inputs", "wires"]
            self._write_switches(folder, machine)
        doors = [self._listen(folder / name) for name in ("line", "clock")]
        command = _command(core, words)
        process = self._open.enter_context(subprocess.Popen(command, cwd=folder))
        self._open.callback(process.kill)
        self._line, self._clock = (self._accept(door) for door in doors)
        if machine.switches is not None:
            for name, is_pushed in machine.switches[2].items():
                self.push(name, is_pushed)

    def _write_switches(self, folder, machine):
        host = Session(machine)._host
        (folder / "inputs").write_bytes(ffi.buffer(ffi.addressof(host.inputs, "set"))[:])
        size = ffi.offsetof("host_switches_t", "seed")
        (folder / "wires").write_bytes(ffi.buffer(ffi.addressof(host, "switches"))[:size])

    def _listen(self, path):
        door = self._open.enter_context(socket.socket(socket.AF_UNIX))
        door.bind(str(path))
        door.listen(1)
        door.settimeout(WAIT_S)
        return door

    def _accept(self, door):
        line = self._open.enter_context(door.accept()[0])
        line.settimeout(WAIT_S)
        return line

    def close(self):
        """Switch the board off."""
        self._open.close()

    def _get(self, line, n):
        data = b""
        while len(data) < n:
            piece = line.recv(n - len(data))
            if not piece:
                raise serving_runs.Broken("the board is gone")
            data += piece
        return data

    def receive(self, data):
        """Hand over bytes; return how many found room."""
        piece = data[:PIECE]
        self._clock.sendall(b"r" + bytes([len(piece)]))
        self._line.sendall(piece)
        return self._get(self._clock, 1)[0]

    def run(self, ticks):
        """Let so many periods pass."""
        self._clock.sendall(b"t" + struct.pack("<I", ticks))
        self._get(self._clock, 1)

    def take(self):
        """Return the bytes that were said since the last time."""
        self._clock.sendall(b"w")
        n = struct.unpack("<I", self._get(self._clock, 4))[0]
        return self._get(self._line, n)

    def join(self):
        """Somebody is connected."""
        self._clock.sendall(b"+")

    def part(self):
        """The connection is gone."""
        self._clock.sendall(b"-")

    def push(self, name, is_pushed):
        """Open or close the ``door``, push or pull out the ``emergency`` stop."""
        self._clock.sendall(b"p" + bytes([INPUTS[name], is_pushed]))

    def _state(self):
        self._clock.sendall(b"s")
        return STATE.unpack(self._get(self._clock, STATE.size))

    @property
    def joints_nm(self):
        """Return where the joints are [nm, nanodegrees]."""
        return self._state()[:3]

    @property
    def moving(self):
        """Return in how many periods the setpoint changed."""
        return self._state()[3]

    @property
    def hash(self):
        """Return the hash of all setpoints that changed."""
        return self._state()[4]

    @property
    def speed_most(self):
        """Return the highest speed of an axis so far, as a share of its limit."""
        return self._state()[5]

    @property
    def broken(self):
        """Return 0, or which rooms of the kernel have a broken invariant."""
        return self._state()[6]

    @property
    def waiting(self):
        """Return how many bytes wait since the ring has no room for them."""
        return self._state()[7]


@contextlib.contextmanager
def board(core, machine):
    """Give a session on a board, and switch it off."""
    session = BoardSession(core, machine)
    try:
        yield session
    finally:
        session.close()
