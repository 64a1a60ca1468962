# SPDX-License-Identifier: MIT
"""What is known before a room is opened: versions, the machine to begin with, names of axes."""

DEFAULT = "mill3"  # the machine where none is named
LINEAR_AXES = ("x", "y", "z", "u", "v", "w")
ROTARY_AXES = ("a", "b", "c")
AXES = ("x", "y", "z", "a", "b", "c", "u", "v", "w")  # the kernel's order
WORK_SYSTEMS = ("g54", "g55", "g56", "g57", "g58", "g59", "g59_1", "g59_2", "g59_3")
SCHEMA = 1  # of --json: another number where a key that stood there means something else


def version():
    """Return the version of pycnc."""
    from importlib import metadata

    try:
        return metadata.version("pycnc-nck")
    except metadata.PackageNotFoundError:
        return "0 (not installed)"
