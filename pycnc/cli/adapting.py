# SPDX-License-Identifier: MIT
"""The verbs of LinuxCNC's planner: ``linuxcnc build``, ``install``, ``package``, ``ini``."""

import json as json_text
import os
from typing import Annotated

import typer

from pycnc.cli.door import linuxcnc, verb
from pycnc.cli.options import Json
from pycnc.cli.words import GOOD, WRONG, read

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
