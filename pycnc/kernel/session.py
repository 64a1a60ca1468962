# SPDX-License-Identifier: MIT
"""A machine that speaks grbl's protocol, in virtual time: bytes in, bytes out."""

from pycnc.kernel import kept
from pycnc.kernel.bind import check, ffi, lib, new_room

STEPS = 64  # of preparation between two ticks, at most
WAITING_MOST = 1 << 24  # bytes in front of a real-time one that is heard at once


class Session:
    """A machine with the protocol around it. Time passes when `run` lets it.

    Parameters
    ----------
    machine : Machine
        With the switches of its file's [inputs].
    steps : int
        Steps of preparation between two ticks, 1 at least.

    Raises
    ------
    MachineError
        The kernel refuses the machine.

    Examples
    --------
    >>> from pycnc.machine import Machine
    >>> session = Session(Machine.load("mill3", dialect="grbl"))
    >>> session.take()
    b"\\r\\nGrbl 1.1f ['$' for help]\\r\\n"
    >>> session.receive(b"G1 X2 F600\\n")
    11
    >>> session.run(400)
    >>> session.take(), session.joints_nm[0]
    (b'ok\\r\\n', 2000000)
    """

    def __init__(self, machine, steps=STEPS):
        self._machine, self._steps = machine, steps
        self._nck, self._host = new_room("nck_t *"), ffi.new("host_serve_t *")
        self._out = ffi.new("char[]", lib.HOST_OUT)
        self._in = new_room("char[]", WAITING_MOST)
        check(lib.host_serve_init(self._host, self._nck, machine.pointer))
        lib.host_serve_lend(self._host, self._in, WAITING_MOST)
        if machine.switches is not None:
            inputs, wires, pushed = machine.switches
            self.connect(inputs, **wires)
            for name, is_pushed in pushed.items():
                self.push(name, is_pushed)

    def connect(self, inputs=None, **switches):
        """Give the machine switches: what of them is set, and where the real axes are.

        Parameters
        ----------
        inputs : dict
            Members of ``inputs_set_t``.
        switches
            Members of ``host_switches_t``; lists of nanometres begin with X.
        """
        for name, value in (inputs or {}).items():
            setattr(self._host.inputs.set, name, value)
        for name, value in switches.items():
            self.wire(name, value)
        lib.host_serve_connect(self._host)

    def wire(self, name, value):
        """Change a member of the simulated switches."""
        if isinstance(value, list | tuple):
            getattr(self._host.switches, name)[0 : len(value)] = value
        else:
            setattr(self._host.switches, name, value)

    def push(self, name, is_pushed):
        """Open or close the ``door``, push the ``emergency`` stop; set ``port0`` … ``port7``."""
        pins = {"door": lib.HAL_IN_DOOR, "emergency": lib.HAL_IN_EMERGENCY}
        pins |= {f"port{k}": lib.HAL_IN_PORT + k for k in range(8)}
        bit = 1 << pins[name]
        pushed = self._host.switches.pushed & ~bit
        self._host.switches.pushed = pushed | bit if is_pushed else pushed

    @property
    def real_nm(self):
        """Return where the real axes are [nm, nanodegrees], which the kernel may not know."""
        return tuple(self._host.switches.real_nm[0:9])

    def receive(self, data):
        """Hand over bytes as they arrive; return how many found room."""
        return lib.host_serve_receive(self._host, data, len(data))

    def run(self, ticks):
        """Let so many periods pass."""
        lib.host_serve_run(self._host, ticks, self._steps)

    def take(self):
        """Return the bytes that were said since the last time."""
        n = lib.host_serve_take(self._host, self._out, lib.HOST_OUT)
        return bytes(ffi.buffer(self._out, n))

    def join(self):
        """Somebody is connected: the banner, or a session that is held."""
        lib.serve_join(ffi.addressof(self._host.serve))

    def part(self):
        """The connection is gone: the machine comes to rest and is held."""
        lib.host_serve_part(self._host)

    def settings(self):
        """Return path to key of a machine file → value, of all that can be changed."""
        has_inputs = self._machine.switches is not None
        return kept.settings(self._nck, self._host.inputs.set, has_inputs)

    def record(self):
        """Return where the machine stands, and what else a power failure must not lose."""
        return kept.record(self._nck, self._host)

    def restore(self, record):
        """Go on from a record, before anything else; return what it was, in words.

        Raises
        ------
        KeyError, TypeError, ValueError, ArgumentError
            It is none.
        """
        words = kept.restore(self._nck, self._host, record)
        self.run(2)
        return words

    def shown(self):
        """Return what a person wants to see of the machine: numbers and texts."""
        return kept.shown(self._nck, self._host) | {"switches": self._machine.switches is not None}

    def end(self):
        """Nothing comes any more."""

    @property
    def rests(self):
        """Tell whether nothing is under way, so that settings are what they will stay."""
        return bool(lib.nck_is_idle(self._nck)) and self._host.serve.phase == lib.SERVE_READS

    @property
    def waiting(self):
        """Return how many bytes wait since the ring has no room for them."""
        return self._host.in_head - self._host.in_tail

    @property
    def joints_nm(self):
        """Return where the joints are [nm, nanodegrees]."""
        return tuple(self._host.axes.joint_nm[0 : lib.nck_joint_count(self._nck)])

    @property
    def ticks(self):
        """Return how many periods have passed."""
        return self._host.ticks

    @property
    def moving(self):
        """Return in how many of them the setpoint changed."""
        return self._host.moving

    @property
    def speed_most(self):
        """Return the highest speed of an axis so far, as a share of its limit."""
        return self._host.v_most

    @property
    def broken(self):
        """Return 0, or which rooms of the kernel have a broken invariant."""
        return lib.nck_invariants(self._nck)
