# SPDX-License-Identifier: MIT
"""The options and arguments that verbs of the command line share."""

from enum import StrEnum
from typing import Annotated

import typer


class Dialect(StrEnum):
    """What ``--dialect`` takes."""

    linuxcnc = "linuxcnc"
    fanuc = "fanuc"
    grbl = "grbl"
    marlin = "marlin"
    auto = "auto"


class Units(StrEnum):
    """What ``--units`` takes."""

    mm = "mm"
    inch = "inch"


File = Annotated[str, typer.Argument(metavar="FILE", help="NC program; - is stdin.")]
Files = Annotated[list[str], typer.Argument(metavar="FILE…", help="NC programs; - is stdin.")]
MachineName = Annotated[
    str, typer.Option("--machine", "-m", help="Name of a shipped machine, or a machine file.")
]
Set = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="KEY=VALUE", help="Change a setting: axis.x.max_mm=500."),
]
Tools = Annotated[
    str | None, typer.Option("--tools", metavar="FILE", help="Tool table (LinuxCNC tool.tbl).")
]
DialectName = Annotated[
    Dialect | None,
    typer.Option("--dialect", help="Read the text as this dialect; auto: as it looks."),
]
Json = Annotated[bool, typer.Option("--json", help="Results as JSON.")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Errors and results only.")]
Verbose = Annotated[bool, typer.Option("--verbose", "-v", help="Tell more.")]
Backend = Annotated[str, typer.Option("--backend", help="Where planning runs: auto, c, opencl.")]
PlanName = Annotated[str, typer.Option("--plan", help="How speed is planned: exact or grades.")]

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
    str, typer.Option("--on", help="Which controller: host, or m4f or m7 under QEMU.")
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
    str | None, typer.Option(metavar="FOLDER", help="Problems for the subject optimum.")
]
