# SPDX-License-Identifier: MIT
"""Files that are there whole or not at all."""

import errno
import os
from pathlib import Path


class Part:
    """A file that appears under its name once it is complete."""

    def __init__(self, path):
        self._path, self.part = Path(path), Path(f"{path}.part")
        if self._path.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
        self.file = open(self.part, "wb")  # noqa: SIM115

    def close(self):
        """Give the file its name."""
        self.file.close()
        os.replace(self.part, self._path)

    def discard(self):
        """Leave nothing behind."""
        self.file.close()
        self.part.unlink(missing_ok=True)
