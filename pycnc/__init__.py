# SPDX-License-Identifier: MIT
"""pycnc: an NC kernel, from NC text to axis setpoints."""

from pycnc.errors import (
    ArgumentError,
    InternalError,
    MachineError,
    NckError,
    ProgramError,
    StateError,
)

__all__ = [
    "ArgumentError",
    "InternalError",
    "MachineError",
    "NckError",
    "ProgramError",
    "StateError",
]
