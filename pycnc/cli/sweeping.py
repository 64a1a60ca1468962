# SPDX-License-Identifier: MIT
"""The verb that plans a grid: ``sweep``."""

import contextlib
import io
import json
from typing import Annotated

import typer

from pycnc.cli.door import app, machine_of, verb
from pycnc.cli.options import (
    DialectName,
    Files,
    Jobs,
    Json,
    MachineName,
    Programs,
    Quiet,
    SlopeName,
    Table,
    Tools,
    Zero,
)
from pycnc.cli.words import GOOD, WRONG, Refused, fail, progress, read, writing
from pycnc.names import DEFAULT

_ROWS_SHOWN = 40
_Grid = Annotated[
    list[str],
    typer.Option(
        "--set", metavar="KEY=VALUES",
        help="Values of a setting: a,b,c or FIRST..LAST/COUNT. Several: every combination.",
    ),
]
_Cluster = Annotated[
    str | None,
    typer.Option("--cluster", metavar="ADDRESS",
                 help="Plan on a cluster of dask.distributed: tcp://host:8786. Whoever can reach "
                      "it can run code there and here (pickle): only one that you trust."),
]  # fmt: skip


@verb(app, "sweep part.ngc --set path.j_max_mm_s3=1e4..1e6/9")
def sweep(
    *, files: Files, set: _Grid, output: Table = None, machine: MachineName = DEFAULT,
    dialect: DialectName = None, slope: SlopeName = None, tools: Tools = None,
    programs: Programs = None, zero: Zero = None, jobs: Jobs = 1,
    cluster: _Cluster = None, json_: Json = False, quiet: Quiet = False,
):  # fmt: skip
    """Tell how long programs take with each setting of a grid.

    From a tenfold range on, values go up by equal ratios, else in equal steps.
    """
    from pycnc.planning import sweep as planning

    if output is not None and not output.lower().endswith(".csv"):
        raise Refused(f"{output}: error[format]: a table is written as .csv")
    axes = planning.grid(set)
    planning.tasks_of(files, axes)  # counted before anything is read
    mill = machine_of(
        machine, None, tools, dialect, slope=slope, programs=programs, zero=zero, quiet=quiet
    )
    if not quiet:
        from pycnc.machine import effect

        for key, reason in effect.idle_keys(mill, axes):
            fail(f"--set {key}=…: warning[no-effect]: {reason}")
    texts = dict(read(file) for file in files)
    with _table(output) as table:
        with progress(f"planning {len(planning.tasks_of(files, axes)):,} times", quiet) as bar:
            found = planning.Sweep(texts, axes, mill, jobs, cluster, bar)
        table(found)
    if json_:
        facts = {"machine": mill.name, "settings": axes, "rows": found.rows}
        print(json.dumps(facts))
    else:
        print("\n".join(_lines(found)))
    wrong = [row for row in found.rows if row["error"]]
    for row in wrong[:5]:
        fail(f"{_point(row, axes)}: {row['error']}")
    if len(wrong) > 5:
        fail(f"… and {len(wrong) - 5} more")
    return WRONG if wrong else GOOD


@contextlib.contextmanager
def _table(output):
    """Give a function that writes a sweep; whether it can is known before hours of planning."""
    from pycnc.files import Part

    if output is None:
        yield lambda found: None
        return

    with writing(output):
        part = Part(output)

    def write(found):
        text = io.StringIO(newline="")
        found.write_csv(text)
        with writing(output):
            part.write(text.getvalue())
            part.close()

    try:
        yield write
    except BaseException:
        part.discard()
        raise


def _point(row, axes):
    return " ".join([row["file"], *(f"{key}={row[key]}" for key in axes)])


def _against(row, best):
    """Return the time of a plan, and how much more that is than the fastest of its program."""
    from pycnc.report.plot import duration

    if row["error"]:
        return "no time", ""
    time_s, fastest = row["total_s"], best[row["file"]]
    more = time_s / fastest - 1 if fastest > 0 else 0.0
    return duration(time_s), f"+{more:.1%}" if time_s > fastest else "fastest"


def _lines(found):
    """Yield the table: the total time of each plan, over the fastest of its program."""
    best = {}
    for row in found.rows:
        if not row["error"]:
            name = row["file"]
            best[name] = min(best.get(name, row["total_s"]), row["total_s"])
    keys = [*found.axes, *(["file"] if len(best) > 1 else [])]
    rows = [["time", "more", *keys]]
    rows += [[*_against(row, best), *(row[key] for key in keys)]
             for row in found.rows[:_ROWS_SHOWN]]  # fmt: skip
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        yield "  ".join(cell.rjust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
    if len(found.rows) > _ROWS_SHOWN:
        yield f"… and {len(found.rows) - _ROWS_SHOWN:,} more (all: --json, or -o table.csv)"
