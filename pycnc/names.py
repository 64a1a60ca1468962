# SPDX-License-Identifier: MIT
"""What is known before a room is opened: the version, and the machine to begin with."""

DEFAULT = "mill3"  # the machine where none is named


def version():
    """Return the version of pycnc."""
    from importlib import metadata

    try:
        return metadata.version("pycnc-nck")
    except metadata.PackageNotFoundError:
        return "0 (not installed)"
