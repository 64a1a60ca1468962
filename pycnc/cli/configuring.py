# SPDX-License-Identifier: MIT
"""The verbs that make machine files: ``machine new`` and ``machine import``."""

import errno
import os
import sys
from decimal import Decimal
from pathlib import Path
from typing import Annotated

import typer

from pycnc import errors
from pycnc.cli.door import machines, verb
from pycnc.cli.options import Dialect, Quiet, Units
from pycnc.cli.words import GOOD, fail, read, writing
from pycnc.files import Part

Output = Annotated[
    str | None,
    typer.Option("--output", "-o", metavar="FILE.toml", help="Where to; without it to stdout."),
]


@verb(machines, "machine new mymill --travel x=-300:300,y=-250:250,z=-200:0 --a-max 1500")
def new(
    *, name: Annotated[str, typer.Argument(metavar="NAME", help="What it is called.")],
    axes: Annotated[str, typer.Option(help="Its axes; xz is a lathe.")] = "xyz",
    travel: Annotated[str | None, typer.Option(
        metavar="x=MIN:MAX,…", help="Ends of travel [mm, deg]; free where none is told.")] = None,
    v_max: Annotated[float, typer.Option(help="Highest speed of each axis [mm/s].")] = 200,
    a_max: Annotated[float, typer.Option(help="Highest acceleration [mm/s²].")] = 2000,
    j_max: Annotated[float, typer.Option(help="Highest jerk [mm/s³].")] = 40000,
    dialect: Annotated[Dialect, typer.Option(help="How its programs are read.")] = "linuxcnc",
    output: Output = None, quiet: Quiet = False,
):  # fmt: skip
    """Write a machine file to begin with, every key with its meaning."""
    from pycnc.machine import AXES, Machine, draft

    letters = [letter for letter in AXES if letter in axes.lower()]
    if not letters or len(letters) != len(axes):
        raise errors.ArgumentError(f"--axes {axes!r}: must be some of {''.join(AXES)}", id="axes")
    limits = {key: Decimal(str(value))
              for key, value in (("v_max", v_max), ("a_max", a_max), ("j_max", j_max))}  # fmt: skip
    for key, value in limits.items():
        if not value.is_finite():
            option = key.replace("_", "-")
            raise errors.ArgumentError(f"--{option} {value}: must be a number", id="limits")
    limits["travel"] = _travel(travel or "", letters)
    plain = _plain(name)
    text = draft.commented(letters, limits, Dialect(dialect).value, plain)
    Machine.from_text(text, name=plain)
    return _write(text, output, quiet)


def _plain(name):
    return "".join(c for c in name if c.isprintable() and c not in '"\\')


def _travel(words, letters):
    """Return letter → (min, max) of x=-300:300,y=0:200."""
    found = {}
    for pair in filter(None, words.split(",")):
        letter, _, span = pair.partition("=")
        try:
            ends = tuple(Decimal(end) for end in span.split(":"))
        except ArithmeticError:
            ends = ()
        if letter not in letters or len(ends) != 2 or not all(end.is_finite() for end in ends):
            raise errors.ArgumentError(
                f"--travel {pair!r}: must look like x=-300:300, of an axis of it", id="travel"
            )
        found[letter] = ends
    return found


@verb(machines, "machine import printer.cfg -o printer.toml")
def import_(
    *, file: Annotated[str, typer.Argument(
        metavar="FILE", help="LinuxCNC INI, grbl $$, FluidNC yaml, Klipper cfg, Marlin M503 or "
        "RepRapFirmware config.g; - is stdin.")],
    units: Annotated[
        Units | None, typer.Option(help="Unit of lengths where a LinuxCNC INI does not say it.")
    ] = None,
    junction_deviation: Annotated[float | None, typer.Option(
        min=0, max=10, metavar="MM", help="Marlin's JUNCTION_DEVIATION_MM, which M503 rounds.")
    ] = None,
    output: Output = None, quiet: Quiet = False,
):  # fmt: skip
    """Make a machine file of another control's configuration.

    Units are converted; each value has the line that it comes from as its comment, and every line
    that nothing is made of stands at the end. Files that it includes are read.
    """
    from pycnc.machine import imported, source

    name, data = read(file, "give a file with the configuration of a control")
    folder = None if file == "-" else Path(file).parent
    deviation = None if junction_deviation is None else Decimal(str(junction_deviation))
    found, text = imported(
        source.decode(data), name, folder, units and units.value, deviation
    )
    if not quiet:
        for words in found.left:
            fail(f"{name}: note[not-imported]: {words}")
        if found.rest:
            fail(f"{name}: note[not-imported]: {len(found.rest)} more lines that are not about the "
                 "motion of axes; they stand at the end of the machine file")
    return _write(text, output, quiet)


def _write(text, output, quiet):
    if output is None:
        sys.stdout.write(text)
        return GOOD
    with writing(output):
        if os.path.lexists(output):  # what somebody has edited is not written over
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), output)
        with Part(output) as part:
            part.write(text)
    if not quiet:
        print(output)
    return GOOD
