# SPDX-License-Identifier: MIT
"""A session at a port or a pseudo-terminal, in the time of the wall clock."""

import contextlib
import errno
import os
import select
import socket
import time
from pathlib import Path

from pycnc import errors
from pycnc.controller.keeping import Keeper
from pycnc.controller.page import Page
from pycnc.controller.recording import Recorded
from pycnc.kernel.session import Session

PASS_S = 0.002  # between two looks at the clock
LATE_S = 0.02  # of the wall clock, that is made up for; what is later stretches the machine's time
BACKLOG = 1 << 16  # bytes that are read at once


class Tcp:
    """One client at a time at a TCP port.

    Parameters
    ----------
    port : int
        0 takes one that is free.
    address : str
        Of the interface; this computer alone unless said otherwise.
    """

    def __init__(self, port, address="127.0.0.1"):
        try:
            self._door = socket.create_server((address, port))
        except (OSError, OverflowError) as cause:
            words = str(getattr(cause, "strerror", cause)).partition(" (")[0]
            taken = getattr(cause, "errno", 0) in (0, errno.EADDRINUSE, errno.EACCES)
            remedy = ("another --tcp may be free" if taken
                      else "--listen takes an address of this computer")  # fmt: skip
            raise errors.ArgumentError(f"cannot listen at {address}:{port}: {words}; {remedy}",
                                       id="serve-port") from None  # fmt: skip
        self._door.setblocking(False)
        self._client = None
        host, number = self._door.getsockname()[:2]
        self.name = f"{host}:{number}"

    def wait(self, seconds):
        """Sleep until bytes come, at most so long; return 1 when somebody new is there."""
        watched = [self._door] if self._client is None else [self._door, self._client]
        ready, _, _ = select.select(watched, [], [], seconds)
        if self._door not in ready or self._client in ready:
            return False  # who has something to say may be at its end, and makes way
        client, _ = self._door.accept()
        if self._client is not None:
            client.close()
            return False
        client.setblocking(False)
        client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._client = client
        return True

    def read(self, most):
        """Return bytes that came, b"" if there are none; None when the client is gone."""
        if self._client is None or most <= 0:
            return b""
        try:
            data = self._client.recv(most)
        except BlockingIOError:
            return b""
        except OSError:
            data = b""
        if data:
            return data
        self._client.close()
        self._client = None
        return None

    def write(self, data):
        """Send as many bytes as go at once; return how many, all where nobody is there."""
        if self._client is None:
            return len(data)
        try:
            return self._client.send(data)
        except BlockingIOError:
            return 0
        except OSError:
            return len(data)

    def close(self):
        """Close the port."""
        for each in (self._client, self._door):
            if each is not None:
                each.close()


class Pty:
    """A pseudo-terminal, which looks like a serial port.

    Parameters
    ----------
    link : str
        Path of a symbolic link to it; it must not be there yet, but as such a link.
    """

    def __init__(self, link):
        import tty  # not everywhere where the rest of pycnc runs

        self._link, self._is_open = Path(link), False
        if os.path.lexists(link) and not self._link.is_symlink():
            raise errors.ArgumentError(f"{link} is there and no link: name another --pty",
                                       id="serve-link")  # fmt: skip
        self._master, slave = os.openpty()
        tty.setraw(slave)
        name = os.ttyname(slave)
        os.close(slave)
        os.set_blocking(self._master, False)
        try:
            self._link.unlink(missing_ok=True)
            self._link.symlink_to(name)
        except OSError as cause:
            os.close(self._master)
            raise errors.ArgumentError(f"cannot make {link}: {cause.strerror}: name another --pty",
                                       id="serve-link") from None  # fmt: skip
        self.name = f"{link} ({name})"

    def wait(self, seconds):
        """Sleep until bytes come, at most so long; return 1 when somebody new is there."""
        poll = select.poll()
        poll.register(self._master, select.POLLIN)
        events = poll.poll(seconds * 1000.0)
        closed = any(event & select.POLLHUP for _, event in events)
        if closed and not self._is_open:
            time.sleep(seconds)
        comes = not closed and not self._is_open
        self._is_open = self._is_open or not closed
        return comes

    def read(self, most):
        """Return bytes that came, b"" if there are none; None when the port was closed."""
        if not self._is_open or most <= 0:
            return b""
        try:
            return os.read(self._master, most)
        except BlockingIOError:
            return b""
        except OSError:
            self._is_open = False
            return None

    def write(self, data):
        """Send as many bytes as go at once; return how many, all where nobody is there."""
        if not self._is_open:
            return len(data)
        try:
            return os.write(self._master, data)
        except BlockingIOError:
            return 0
        except OSError:
            return len(data)

    def close(self):
        """Take the link away."""
        with contextlib.suppress(FileNotFoundError):
            self._link.unlink()
        os.close(self._master)


class Server:
    """A session, who talks to it, and a clock.

    Parameters
    ----------
    machine : Machine
    line : Tcp or Pty
    scale : float
        Seconds of the machine in one of the wall clock.
    saves : bool
        What is changed is kept in the machine's file.
    page : int, optional
        Port of a page that shows the machine.
    record : object, optional
        A text file that is open for writing, for what comes and goes.
    """

    def __init__(self, machine, line, scale=1.0, *, saves=False, page=None, record=None):
        self.session = Session(machine) if record is None else Recorded(machine, record)
        self._line, self._scale = line, scale
        self.keeper = Keeper(self.session, machine, saves)
        self.page = None if page is None else Page(self.session, machine.name, page)
        self._period_s = machine.period_s
        self._waiting, self._said = b"", b""
        self._time, self._owed = time.monotonic(), 0.0
        self.late_s = 0.0  # of the wall clock, that were not made up for

    def serve(self, seconds=None):
        """Serve for so long, or for ever."""
        end = None if seconds is None else time.monotonic() + seconds
        while end is None or time.monotonic() < end:
            self.step()

    def step(self):
        """Wait for bytes, or for a while; let the time that has passed pass in the machine."""
        if self._line.wait(PASS_S):
            self.session.join()
        self._hear()
        self.session.run(self._due())
        self._speak()
        self.keeper.look()
        if self.page:
            self.page.look()

    def end(self):
        """The machine is switched off."""
        self.keeper.end()
        self.session.end()
        if self.page:
            self.page.close()

    def _hear(self):
        data = self._line.read(BACKLOG - len(self._waiting))
        if data is None:
            self.session.part()
            self._waiting = self._said = b""
            return
        self._waiting += data
        used = self.session.receive(self._waiting)
        self._waiting = self._waiting[used:]

    def _due(self):
        now = time.monotonic()
        passed, self._time = now - self._time, now
        self.late_s += max(passed - LATE_S, 0.0)
        self._owed += min(passed, LATE_S) * self._scale / self._period_s
        ticks = int(self._owed)
        self._owed -= ticks
        return ticks

    def _speak(self):
        self._said += self.session.take()
        self._said = self._said[self._line.write(self._said) :] if self._said else b""
