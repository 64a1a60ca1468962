# SPDX-License-Identifier: MIT
"""A session with a served machine as text: what came, what went, and how many periods passed.

``> G1 X5`` is a line that came, ``= 18 3f`` bytes in hexadecimal, ``< ok`` a line that went,
``. 2 2 3`` periods that passed, each number at once, ``+`` somebody who has connected, ``-`` one
who is gone, ``* door 1`` a door that was opened. In virtual time the same comes of it again.
"""

from pycnc.kernel.session import Session

_WIDTH = 90


class Recorded(Session):
    """A session that writes what it hears and says.

    Parameters
    ----------
    machine : Machine
    file : object
        A text file that is open for writing.
    """

    def __init__(self, machine, file):
        self._file, self._periods, self._part = file, ".", b""
        super().__init__(machine)
        file.write(f"# pycnc serve: {machine.name}\n")

    def receive(self, data):
        """Hand over bytes as they arrive; return how many found room."""
        used = super().receive(data)
        taken = data[:used]
        text = taken[:-1].decode("latin-1")
        if taken.endswith(b"\n") and text.isascii() and text.isprintable():
            self._put(f"> {text}")
        elif taken:
            self._put(f"= {taken.hex(' ')}")
        return used

    def run(self, ticks):
        """Let so many periods pass."""
        super().run(ticks)
        if len(self._periods) > _WIDTH:
            self._end_periods()
        self._periods += f" {ticks}"

    def take(self):
        """Return the bytes that were said since the last time."""
        data = super().take()
        *lines, self._part = (self._part + data).split(b"\r\n")
        for line in filter(None, lines):
            self._put(f"< {line.decode('ascii')}")
        return data

    def join(self):
        """Somebody is connected."""
        self._put("+")
        super().join()

    def part(self):
        """The connection is gone."""
        self._put("-")
        super().part()

    def push(self, name, is_pushed):
        """Open or close the ``door``, push or pull out the ``emergency`` stop."""
        self._put(f"* {name} {int(is_pushed)}")
        super().push(name, is_pushed)

    def end(self):
        """Write what is left."""
        self._end_periods()
        self._file.flush()

    def _put(self, line):
        self._end_periods()
        self._file.write(line + "\n")
        self._file.flush()

    def _end_periods(self):
        if self._periods != ".":
            self._file.write(self._periods + "\n")
        self._periods = "."
