# SPDX-License-Identifier: MIT
"""Files that are there whole or not at all, and reading that comes to an end."""

import contextlib
import errno
import io
import os
import secrets
import stat
from pathlib import Path

PROGRAM_MOST = 1 << 30  # bytes: 30 million lines of NC text, read into memory whole
SETTINGS_MOST = 1 << 24  # of a machine file or a tool table: a thousand of those that there are
_PIECE = 1 << 20
_TRIES = 100  # names that may be taken already


class Part:
    """A file that appears under its name once it is complete.

    It is made beside its place under a name that nobody else has. A link stays one: what it leads
    to is written; a file that is there keeps its mode. What is no file, such as a pipe or what lies
    in /dev, is written as it is. As a context it is closed at the end, or discarded if that is an
    error.
    """

    def __init__(self, path):
        self.part, self._place = None, Path(os.path.realpath(path))
        there = _status(path)
        if there and stat.S_ISDIR(there.st_mode):
            raise _error(errno.EISDIR, path)
        in_dev = Path(os.path.abspath(path)).parts[:2] == ("/", "dev")
        if there and (in_dev or not stat.S_ISREG(there.st_mode)):
            self.file = open(path, "wb")  # noqa: SIM115
            return
        if there and not os.access(path, os.W_OK):
            raise _error(errno.EACCES, path)
        self.file = self._begin(path)
        if there:
            with contextlib.suppress(OSError):  # not every file system has modes
                os.chmod(self.part, stat.S_IMODE(there.st_mode))

    def _begin(self, path):
        """Open a file of a name that nobody has, in the folder of the one that it becomes."""
        for _ in range(_TRIES):
            self.part = self._place.parent / f".pycnc-{secrets.token_hex(8)}.part"
            try:
                return open(self.part, "xb")
            except FileExistsError:
                continue
            except OSError as cause:
                raise _error(cause.errno, path) from None
        raise _error(errno.EEXIST, path)

    def write(self, text):
        """Write text as UTF-8; bytes of a program that are none come back as they were."""
        self.file.write(text.encode("utf-8", errors="surrogateescape"))

    def close(self):
        """Give the file its name; if its last bytes cannot be written, leave nothing behind."""
        try:
            self.file.close()
            if self.part:
                os.replace(self.part, self._place)
        except BaseException:
            self.discard()
            raise

    def discard(self):
        """Leave nothing behind."""
        with contextlib.suppress(OSError):  # the disk is full, and it does not matter
            self.file.close()
        if self.part:
            self.part.unlink(missing_ok=True)

    def __enter__(self):
        return self

    def __exit__(self, kind, cause, trace):
        if kind is None:
            self.close()
        else:
            self.discard()


def _status(path):
    try:
        return os.stat(path)
    except FileNotFoundError:
        return None


def _error(number, path):
    return OSError(number, os.strerror(number), str(path))


def _too_long(name, most):
    return OSError(errno.EFBIG, f"it has more than {most:,} bytes", str(name))


def read(path, most=PROGRAM_MOST):
    """Return the bytes of a file, or of what is none: a pipe, a device.

    Raises
    ------
    OSError
        If it cannot be read, or has more bytes than `most`.
    """
    with open(path, "rb") as file:
        if os.fstat(file.fileno()).st_size > most:
            raise _too_long(path, most)
        return read_open(file, path, most)


def read_open(file, name, most=PROGRAM_MOST):
    """Return the bytes of an open file up to its end, as `read` does.

    Behind the piece with the first NUL byte nothing is read: there no text goes on.
    """
    text = io.BytesIO()  # grows in place and gives its bytes without a copy: pieces to join are two
    while piece := file.read(_PIECE):
        text.write(piece)
        if text.tell() > most:
            raise _too_long(name, most)
        if b"\0" in piece:
            break
    return text.getvalue()
