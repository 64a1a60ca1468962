# SPDX-License-Identifier: MIT
"""What is known before a room is opened: versions, and the machine to begin with."""

DEFAULT = "mill3"  # the machine where none is named
SCHEMA = 1  # of --json: another number where a key that stood there means something else


def version():
    """Return the version of pycnc."""
    from importlib import metadata

    try:
        return metadata.version("pycnc-nck")
    except metadata.PackageNotFoundError:
        return "0 (not installed)"
