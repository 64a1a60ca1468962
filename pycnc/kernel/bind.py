# SPDX-License-Identifier: MIT
"""The lowest floor: the compiled module, and the one place where a status becomes an exception.

No other file imports ``pycnc._nck``, or ``pycnc._nck_tp``: the same with the capacities of the
planner module for LinuxCNC, for plans and runs.
"""

import os

from pycnc import errors

# OpenMP reads this once, when the module is loaded. Threads that spin while they wait hold up the
# others for whole time slices as soon as the computer has something else to do.
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

from pycnc._nck import ffi, lib  # noqa: E402

new_room = ffi.new_allocator(should_clear_after_alloc=False)  # who has the memory begins it

_CAUSES = {
    lib.NCK_E_ARGUMENT: errors.ArgumentError,
    lib.NCK_E_MACHINE: errors.MachineError,
    lib.NCK_E_STATE: errors.StateError,
    lib.NCK_E_INTERNAL: errors.InternalError,
}


def status_id(status):
    """Return the stable id of a status code, such as ``"arc-radius"``."""
    return ffi.string(lib.nck_status_id(status)).decode()


def diagnostic_id(code):
    """Return the stable id of a diagnostic's code, of an error or a note (``"assumed-units"``)."""
    return ffi.string(lib.nck_diagnostic_id(code)).decode()


def check(status, diagnostic=None):
    """Return a status that is good or "not now"; raise what a negative one means.

    Parameters
    ----------
    status : int
        What a function of the kernel returned.
    diagnostic : optional
        An ``nck_diagnostic_t``, or anything with its ``line`` and ``column``: where the program
        is wrong.

    Raises
    ------
    NckError
        ProgramError, MachineError, ArgumentError, StateError or InternalError.
    """
    if status >= 0:
        return status
    cause = _CAUSES.get(status, errors.ProgramError)
    name = status_id(status)
    if diagnostic is None:
        raise cause(name, id=name, status=status)
    line, column = int(diagnostic.line), int(diagnostic.column)
    raise cause(f"{line}:{column}: {name}", id=name, status=status, line=line, column=column)


def build_of(kind):
    """Return the build that plans and runs for a control, a ``sim_build_t``.

    Parameters
    ----------
    kind : str
        ``"nck_tp"``: with the capacities of the planner module for LinuxCNC.
    """
    build = ffi.new("sim_build_t *")
    if kind == "nck_tp":
        from pycnc import _nck_tp  # where it is asked for: few need it

        _nck_tp.lib.sim_build_tell(build)
    else:
        lib.sim_build_tell(build)
    return build


def room_for(type_name, size):
    """Return memory for a record of so many bytes, and a pointer to it, which lives as long.

    type_name: of the pointer, such as ``"nck_t *"``.
    """
    room = new_room("double[]", -(-size // ffi.sizeof("double")))
    return room, ffi.cast(type_name, room)


def pointer(type_name, array):
    """Return a C pointer into a C-contiguous array, which must outlive its use; None gives NULL.

    Parameters
    ----------
    type_name : str
        C type of one item, such as ``"nck_cell_t"`` or ``"double"``.
    array : numpy.ndarray, bytes or None
        Its items must have the size of the type.
    """
    if array is None:
        return ffi.NULL
    size, item = ffi.sizeof(type_name), memoryview(array).itemsize
    if item != size:
        raise errors.ArgumentError(f"items of {item} bytes where {type_name} has {size}")
    return ffi.from_buffer(f"{type_name}[]", array)
