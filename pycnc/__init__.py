# SPDX-License-Identifier: MIT
"""pycnc: an NC kernel, from NC text to axis setpoints.

    program = pycnc.load("part.ngc", machine="mill3")
    plan = pycnc.plan(program)
    trace = pycnc.run(program)
    trace.plot("part.png")

The front door opens rooms on use: `pycnc.stages` and the records need NumPy and cffi alone, machine
files pydantic. Pictures need matplotlib, Parquet files pyarrow, OpenCL pyopencl: extras, each with
one sentence that names it where it is absent.
"""

import importlib

from pycnc.errors import (
    AbsentError,
    ArgumentError,
    InternalError,
    MachineError,
    NckError,
    ProgramError,
    StateError,
)

_ROOMS = {
    "Machine": "machine",
    "MachineFileError": "machine",
    "Program": "program",
    "load": "program",
    "Plan": "planning.plan",
    "plan": "planning.plan",
    "Why": "planning.why",
    "why": "planning.plan",
    "Rows": "report.rows",
    "Sweep": "planning.sweep",
    "sweep": "planning.sweep",
    "Trace": "report.trace",
    "run": "report.trace",
}

__all__ = [
    "AbsentError",
    "ArgumentError",
    "InternalError",
    "MachineError",
    "NckError",
    "ProgramError",
    "StateError",
    "__version__",
    "stages",
    *_ROOMS,
]


def __getattr__(name):
    """Open a room when its name is first used."""
    if name == "__version__":
        return importlib.import_module("pycnc.names").version()
    if name == "stages":
        return importlib.import_module("pycnc.stages")
    if name in _ROOMS:
        value = getattr(importlib.import_module(f"pycnc.{_ROOMS[name]}"), name)
        globals()[name] = value
        return value
    raise AttributeError(f"module 'pycnc' has no attribute {name!r}")


def __dir__():
    return sorted(__all__)
