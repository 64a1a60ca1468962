# SPDX-License-Identifier: MIT
"""The exceptions of pycnc: one small family, one class for each kind of cause."""


class NckError(Exception):
    """The kernel refused something.

    Attributes
    ----------
    id : str
        Stable id of the cause, such as ``"arc-radius"``.
    status : int
        The kernel's status code.
    line, column : int or None
        Where in the NC program, 1-based; column 0 means the whole line. None if no program is
        concerned.
    """

    def __init__(self, message, *, id="", status=0, line=None, column=None):
        super().__init__(message)
        self.id = id
        self.status = status
        self.line = line
        self.column = column


class ProgramError(NckError):
    """The NC program has an error."""


class MachineError(NckError):
    """A number of the machine is outside of its range."""


class ArgumentError(NckError, ValueError):
    """An argument is outside of its range."""


class AbsentError(NckError, ImportError):
    """A package that the work needs is not installed; the message says how to get it."""


class StateError(NckError):
    """The call is not possible in the present state."""


class BackendError(ArgumentError):
    """A backend that is not there."""


class FirmwareError(NckError):
    """A controller cannot be built, does not start or does not end; the message has the remedy."""


class InternalError(NckError):
    """An invariant of the kernel is broken: a defect of pycnc."""


class DeviceError(NckError):
    """An OpenCL device is absent, refused a kernel, was lost, or cannot be certain of a result.

    The message names the remedy. ``id`` is one of "device-absent", "device-build", "device-lost",
    "device-overlap" (no overlap of two parts was certain: the C backend plans such
    paths) and "device-number" (a number that C refuses, or a negative zero).
    """
