# SPDX-License-Identifier: MIT
"""The options and arguments that verbs of the command line share."""

from enum import StrEnum
from typing import Annotated

import typer


CURES = ""  # what --what-if without a value stands for


class Dialect(StrEnum):
    """What ``--dialect`` takes."""

    linuxcnc = "linuxcnc"
    fanuc = "fanuc"
    grbl = "grbl"
    marlin = "marlin"
    auto = "auto"


class Slope(StrEnum):
    """What ``--slope`` takes."""

    jerk = "jerk"
    optimal = "optimal"
    linear = "linear"


def slope_of(word):
    """Return the slope of a name."""
    if word in [*Slope]:
        return Slope(word)
    sshape = "; the S-shape is a kind of planning: pycnc lab time --plan sshape"
    moved = sshape if word == "sshape" else ""
    names = ", ".join(repr(each.value) for each in Slope)
    raise typer.BadParameter(f"{word!r} is not one of {names}{moved}.")


class PlanKind(StrEnum):
    """What ``--plan`` takes."""

    exact = "exact"
    grades = "grades"
    sshape = "sshape"


class BackendName(StrEnum):
    """What ``--backend`` takes."""

    auto = "auto"
    c = "c"
    opencl = "opencl"


class Controller(StrEnum):
    """What ``--on`` takes."""

    host = "host"
    m4f = "m4f"
    m7 = "m7"


class Part(StrEnum):
    """What ``--by`` takes."""

    tool = "tool"
    section = "section"
    line = "line"


class Units(StrEnum):
    """What ``--units`` takes."""

    mm = "mm"
    inch = "inch"


def settings_of():
    """Return what may be typed behind ``--set``, for a shell that completes it."""
    from pycnc.machine import Machine
    from pycnc.names import DEFAULT

    return [f"{key}=" for key, _, _ in Machine.load(DEFAULT).effective()]


def machine_names():
    """Return the shipped machines, for a shell that completes them."""
    from pycnc.machine import shipped

    return shipped()


FromLine = Annotated[
    int | None,
    typer.Option(
        "--from-line", min=1, metavar="N",
        help="Begin at line N, with tool, spindle, coolant and modes as they are there, by the way "
        "in that the machine file says: [approach].",
    ),
]
File = Annotated[str, typer.Argument(metavar="FILE", help="NC program; - is stdin.")]
Files = Annotated[list[str], typer.Argument(metavar="FILE…", help="NC programs; - is stdin.")]
MachineName = Annotated[
    str,
    typer.Option(
        "--machine", "-m",
        help="Name of a shipped machine, a machine file, or a control's own configuration.",
        autocompletion=machine_names,
    ),
]
Set = Annotated[
    list[str] | None,
    typer.Option(
        "--set", metavar="KEY=VALUE", autocompletion=settings_of,
        help="Change a setting: axis.x.max_mm=500.",
    ),
]
Tools = Annotated[
    str | None, typer.Option("--tools", metavar="FILE", help="Tool table (LinuxCNC tool.tbl).")
]
DialectName = Annotated[
    Dialect | None,
    typer.Option("--dialect", help="Read the text as this dialect; auto: as it looks."),
]
Programs = Annotated[
    str | None,
    typer.Option(
        "--programs", metavar="DIR",
        help="Folder of subprograms that the text calls: the same as --set dialect.programs=…",
    ),
]
Override = Annotated[
    int, typer.Option("--override", min=1, max=200, metavar="PERCENT", help="Of the feed."),
]
Left = Annotated[
    int | None,
    typer.Option("--left", min=1, metavar="N", help="Tell what is left at line N, too."),
]
Zero = Annotated[
    str | None,
    typer.Option(
        "--zero", metavar="X,Y,Z",
        help="Where the program's zero lies, machine coordinates, in the order of the axes.",
    ),
]
Json = Annotated[bool, typer.Option("--json", help="Results as JSON.")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Errors and results only.")]
Verbose = Annotated[bool, typer.Option("--verbose", "-v", help="Tell the program's notes, too.")]
SlopeName = Annotated[
    Slope | None,
    typer.Option(
        "--slope", parser=slope_of, metavar=f"<{'|'.join(Slope)}>", autocompletion=lambda: [*Slope],
        help="Velocity profile: the same as --set path.slope=…",
    ),
]
Backend = Annotated[
    BackendName,
    typer.Option("--backend", help="Where planning runs; exact plans run in C."),
]
PlanName = Annotated[
    PlanKind,
    typer.Option("--plan", help="How speed is planned: by the slope, by grades, by the S-shape."),
]

By = Annotated[
    Part | None,
    typer.Option(
        "--by", help="Where the time goes: a section begins at a comment on a line of its own."
    ),
]
WhatIf = Annotated[
    list[str] | None,
    typer.Option(
        "--what-if", metavar="[KEY=VALUE]", autocompletion=settings_of,
        help="Plan it again with each cure: twice the limits of the axes, a tolerance, no stops; "
        "or with a setting as --set takes it: control.kind=nck.",
    ),
]
Table = Annotated[
    str | None,
    typer.Option("--output", "-o", metavar="TABLE", help="Write all rows as a table: .csv."),
]
Page = Annotated[
    str | None,
    typer.Option(
        "--output", "-o", metavar="PAGE", help="Where to: .html; else next to the program."
    ),
]
Jobs = Annotated[
    int, typer.Option("--jobs", min=1, max=256, help="Programs that are planned side by side.")
]
Output = Annotated[
    str | None,
    typer.Option(
        "--output", "-o", metavar="TRACE", help="Write a row per tick: .npz, .csv or .parquet."
    ),
]
Picture = Annotated[
    str | None,
    typer.Option("--plot", metavar="PICTURE", help="Draw the run: .png, .svg or .pdf."),
]
PrepSteps = Annotated[
    int | None,
    typer.Option(
        min=1, max=2**32 - 1, help="Prep steps between two ticks; few of them starve the tick."
    ),
]
ControllerName = Annotated[
    Controller, typer.Option("--on", help="Which controller: this computer, or one under QEMU.")
]
Commands = Annotated[
    list[str] | None,
    typer.Option(
        "--at", metavar='"TICK COMMAND …"',
        help='What the operator does there: "250 hold", "400 override 50 100".',
    ),
]  # fmt: skip
Subject = Annotated[
    str | None, typer.Argument(metavar="NAME", help="Which one; without a name: a list.")
]
Figures = Annotated[
    str | None,
    typer.Option("--output", "-o", metavar="FOLDER", help="Write the figures of a subject there."),
]
Paths = Annotated[
    str | None, typer.Option(metavar="FOLDER", help="Problems for optimum, files for corpus.")
]
