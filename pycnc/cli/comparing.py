# SPDX-License-Identifier: MIT
"""The verb ``compare``: two programs, machines, settings, traces, or a measured log."""

import json
from pathlib import Path
from typing import Annotated

import typer

from pycnc.cli.door import app, machine_of, verb
from pycnc.cli.options import (
    DialectName,
    Json,
    MachineName,
    Programs,
    Quiet,
    Set,
    SlopeName,
    Tools,
    Zero,
)
from pycnc.cli.words import GOOD, OUTSIDE, WRONG, fail, look_at, progress
from pycnc.names import DEFAULT

_LOGS = (".npz", ".csv", ".parquet")
_OPERAND = "NC program (it is run), trace (.npz, .csv, .parquet) or log (.csv)."
Columns = Annotated[
    str | None,
    typer.Option(
        "--map", metavar="t=…,x=…",
        help="Columns of a measured log: t=Time,x=PosX; with units t=Time:ms,x=PosX:inch.",
    ),
]  # fmt: skip


@verb(app, "compare part.ngc part.ngc --set-b path.tolerance_mm=0.1")
def compare(
    *, a: Annotated[str, typer.Argument(metavar="A", help=_OPERAND)],
    b: Annotated[str, typer.Argument(metavar="B", help=_OPERAND)],
    map_: Columns = None, machine: MachineName = DEFAULT,
    machine_b: Annotated[str | None, typer.Option(help="Another machine for B.")] = None,
    set: Set = None,
    set_b: Annotated[list[str] | None, typer.Option(
        metavar="KEY=VALUE", help="Change a setting of B's machine, besides --set.")] = None,
    slope: SlopeName = None, dialect: DialectName = None, tools: Tools = None,
    programs: Programs = None, zero: Zero = None,
    tolerance: Annotated[float | None, typer.Option(
        min=0, metavar="MM", help="Exit 3 if B leaves A's path by more.")] = None,
    tolerance_s: Annotated[float | None, typer.Option(
        min=0, metavar="S", help="Exit 3 if the times differ by more.")] = None,
    json_: Json = False, quiet: Quiet = False,
):  # fmt: skip
    """Tell by how much two runs differ, in time, path and by line.

    Exit code 3 says that they differ by more than a tolerance.
    """
    from pycnc.report import compare as comparing

    columns = comparing.columns_of(map_) if map_ else None
    how = {"slope": slope, "programs": programs, "zero": zero, "quiet": quiet}
    first = machine_of(machine, set, tools, dialect, **how)
    changes = [*(set or ()), *(set_b or ())]
    second = machine_of(machine_b or machine, changes, tools, dialect, **how)
    sides = []
    for file, mill, name in ((a, first, "A"), (b, second, "B")):
        side, code = _side(file, mill, columns, quiet, name)
        if side is None:
            return code
        sides.append(side)
    found = comparing.Comparison(*sides)
    if json_:
        print(json.dumps(found.as_dict()))
    elif not quiet:
        print("\n".join(comparing.lines_of(found)))
    return _judge(found, tolerance, tolerance_s)


def _side(file, machine, columns, quiet, name):
    """Return (side, exit code) of a file; the side is None if the program has errors."""
    from pycnc.planning.control import title
    from pycnc.report import compare as comparing
    from pycnc.report.trace import Trace

    if Path(file).suffix.lower() in _LOGS:
        own = file.lower().endswith(".csv") and columns is not None and not _is_trace(file)
        return comparing.read(file, columns if own else None), GOOD
    program, _, code = look_at(file, machine, quiet, False)
    if program is None:
        return None, max(code, WRONG)
    with progress(f"running {program.file}", quiet) as bar:
        trace = Trace(program, progress=bar)
    name = f"{program.file} on {machine.name}, {title(machine)}"
    is_laid = machine.settings.work.zero == "unknown"
    return comparing.of_trace(trace, name, is_laid), GOOD


def _is_trace(file):
    """Tell whether a CSV is a trace of ours: its metadata stand before the names."""
    with open(file, "rb") as data:
        return data.read(11) == b"# version: "


def _judge(found, tolerance, tolerance_s):
    """Return the exit code, after telling what is outside of its tolerance."""
    code = GOOD
    for words, value, most, unit in (
        ("path", found.distance_mm, tolerance, "mm"),
        ("time", abs(found.time_s), tolerance_s, "s"),
    ):
        if most is not None and value > most:
            fail(f"pycnc: error[tolerance]: {words}: {value:.6g} {unit}, more than {most:g} {unit}")
            code = OUTSIDE
    return code
