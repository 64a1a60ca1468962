# SPDX-License-Identifier: MIT
"""Files that are there whole or not at all."""

import contextlib
import errno
import os
from pathlib import Path


class Part:
    """A file that appears under its name once it is complete.

    As a context it is closed at the end, or discarded if that is an error.
    """

    def __init__(self, path):
        self._path, self.part = Path(path), Path(f"{path}.part")
        if self._path.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
        self.file = open(self.part, "wb")  # noqa: SIM115

    def write(self, text):
        """Write text as UTF-8; bytes of a program that are none come back as they were."""
        self.file.write(text.encode("utf-8", errors="surrogateescape"))

    def close(self):
        """Give the file its name; if its last bytes cannot be written, leave nothing behind."""
        try:
            self.file.close()
            os.replace(self.part, self._path)
        except BaseException:
            self.discard()
            raise

    def discard(self):
        """Leave nothing behind."""
        with contextlib.suppress(OSError):  # the disk is full, and it does not matter
            self.file.close()
        self.part.unlink(missing_ok=True)

    def __enter__(self):
        return self

    def __exit__(self, kind, cause, trace):
        if kind is None:
            self.close()
        else:
            self.discard()
