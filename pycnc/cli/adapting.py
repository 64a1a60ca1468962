# SPDX-License-Identifier: MIT
"""The verbs of LinuxCNC's planner: ``linuxcnc build | install | package | ini | jerk``."""

import json as json_text
import os
from typing import Annotated

import typer

from pycnc.cli.door import linuxcnc, verb
from pycnc.cli.options import Files, Json, Quiet
from pycnc.cli.words import GOOD, WRONG, Refused, progress, read, writing

Folder = Annotated[str, typer.Argument(metavar="FOLDER", help="Where to.")]


@verb(linuxcnc, "linuxcnc build")
def build(
    *, folder: Folder = "nck_tp",
    short_servo: Annotated[bool, typer.Option(
        "--short-servo", help="For a servo period of less than 1 ms.")] = False,
):  # fmt: skip
    """Compile the planner module for the LinuxCNC of this computer."""
    from pycnc import linuxcnc as adapter

    print(adapter.build(folder, short_servo=short_servo))
    return GOOD


@verb(linuxcnc, "linuxcnc install")
def install(
    *, folder: Annotated[str, typer.Argument(metavar="FOLDER", help="Where it was built.")] =
    "nck_tp",
):  # fmt: skip
    """Copy the module to where LinuxCNC looks for it; that takes root's rights."""
    from pathlib import Path

    from pycnc import linuxcnc as adapter

    print(adapter.install(Path(folder) / adapter.MODULE))
    return GOOD


@verb(linuxcnc, "linuxcnc package")
def package(
    *, folder: Annotated[str, typer.Argument(metavar="FOLDER", help="Where it was built.")] =
    "nck_tp",
):  # fmt: skip
    """Make a Debian package of the module."""
    from pycnc.linuxcnc import package as debian

    print(debian.pack(folder))
    return GOOD


@verb(linuxcnc, "linuxcnc ini machine.ini")
def ini(
    *, file: Annotated[str, typer.Argument(metavar="FILE", help="An INI file of LinuxCNC.")],
    json: Json = False,
):  # fmt: skip
    """Read a machine's INI file and say what to add to it."""
    from pycnc.linuxcnc import configuration

    name, text = read(file, "give an INI file of LinuxCNC")
    text, absent = configuration.expand(
        text.decode("utf-8", errors="replace"), os.path.dirname(file)
    )
    found = configuration.look_at(text)
    found["notes"] = absent + found["notes"]
    if json:
        print(json_text.dumps({"file": name, **found}))
        return WRONG if found["errors"] else GOOD
    for kind in ("errors", "notes"):
        for text in found[kind]:
            print(f"{name}: {kind.removesuffix('s')}: {text}")
    if found["add"]:
        print(f"Add to {name}:\n")
        for section, lines in found["add"].items():
            print(f"[{section}]", *lines, "", sep="\n")
    elif not found["errors"]:
        print(f"{name}: nothing to add")
    return WRONG if found["errors"] else GOOD


@verb(linuxcnc, "linuxcnc jerk machine.ini part.ngc -o jerk.png")
def jerk(
    *, file: Annotated[str, typer.Argument(metavar="INI", help="An INI file of LinuxCNC.")],
    files: Files,
    output: Annotated[str | None, typer.Option(
        "--output", "-o", metavar="PICTURE", help="Draw it: .png, .svg or .pdf.")] = None,
    quiet: Quiet = False,
):  # fmt: skip
    """Say which jerk to begin with: what programs take with each, and what it buys.

    A ramp of acceleration of so many seconds leaves no vibration of a frequency whose period it
    is, and little of those above. The row none is MAX_JERK = 0 for all axes, with the planner
    linear: it goes round corners slower, and dense programs take longer than with much jerk.
    """
    from pycnc.linuxcnc import advice, configuration

    if output is not None and not output.lower().endswith((".png", ".svg", ".pdf")):
        raise Refused(f"{output}: error[format]: a picture is .png, .svg or .pdf")
    name, data = read(file, "give an INI file of LinuxCNC")
    folder = os.path.dirname(file)
    text, _ = configuration.expand(data.decode("utf-8", errors="replace"), folder)
    machine = advice.machine_of(text, os.path.basename(name), folder)
    found = configuration.settings(text)
    texts = dict(read(each) for each in files)
    with progress(f"planning with {len(advice.RAMPS_S) + 1} jerks", quiet) as bar:
        rows = advice.rows_of(machine, texts, advice.unit_mm(found), bar)
    chosen = advice.choose(rows)
    print("\n".join(_jerks(rows, chosen)))
    add, first = advice.lines_for(chosen, found)
    print(f"\nA ramp half as long saves less than {advice.WORTH:.0%}. Begin with, in {name}:\n")
    print("[TRAJ]", *add, sep="\n")
    for place in first:
        print(f"{name}: note: {place} counts first: take it out")
    if output is not None:
        with writing(output):
            print(advice.draw(rows, chosen, machine.name, output))
    return GOOD


def _jerks(rows, chosen):
    """Yield the table: jerk, its ramp, the time, what is quiet."""
    from pycnc.report.plot import duration

    least = min(row.time_s for row in rows)
    cells = [["jerk", "ramp", "time", "more", "no vibration above", ""]]
    for row in rows:
        more = f"+{row.time_s / least - 1:.1%}" if row.time_s > least > 0 else ""
        limited = [f"{row.jerk:g}", f"{row.ramp_s:g} s"] if row.ramp_s else ["none", ""]
        quiet = f"{row.quiet_hz:g} Hz" if row.ramp_s else ""
        cells.append([*limited, duration(row.time_s), more, quiet, "<" if row is chosen else ""])
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    for row in cells:
        yield "  ".join(cell.rjust(n) for cell, n in zip(row, widths, strict=True)).rstrip()
