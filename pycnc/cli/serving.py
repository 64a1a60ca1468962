# SPDX-License-Identifier: MIT
"""The verb ``serve``: a machine for programs that speak grbl's protocol."""

import contextlib
import signal
import sys
from pathlib import Path
from typing import Annotated

import typer

from pycnc.cli.door import app, machine_of, verb
from pycnc.cli.options import Dialect, DialectName, MachineName, Quiet, Set, SlopeName, Tools
from pycnc.cli.words import GOOD, USAGE, Refused, fail
from pycnc.names import DEFAULT

_PORT = 8023


@verb(app, "serve --tcp 8023 --time-scale 10")
def serve(
    *, machine: MachineName = DEFAULT,
    pty: Annotated[str | None, typer.Option(
        metavar="LINK", help="A pseudo-terminal; LINK will lead to it.")] = None,
    tcp: Annotated[int | None, typer.Option(
        metavar="PORT", min=0, max=65535, help=f"A TCP port; {_PORT} without --pty.")] = None,
    listen: Annotated[str, typer.Option(
        metavar="ADDRESS", help="Of the interface; others than this computer's are everybody's."
    )] = "127.0.0.1",
    time_scale: Annotated[float, typer.Option(
        min=0.01, max=1000.0, help="Seconds of the machine in one of the clock.")] = 1.0,
    save: Annotated[bool, typer.Option(
        "--save", help="Keep changed settings and offsets in the machine file.")] = False,
    page: Annotated[int | None, typer.Option(
        metavar="PORT", min=0, max=65535, help="A page that shows it, for a browser here.")] = None,
    record: Annotated[Path | None, typer.Option(
        metavar="FILE", help="Write what comes and goes, as text.")] = None,
    dialect: DialectName = None, slope: SlopeName = None, set: Set = None, tools: Tools = None,
    quiet: Quiet = False,
):  # fmt: skip
    """Be a machine that speaks grbl 1.1, for senders to try.

    What it understands stands in docs/serve.md.
    """
    from pycnc.controller import serving

    if pty is not None and tcp is not None:
        fail("--pty and --tcp: one of them")
        return USAGE
    mill = machine_of(machine, set, tools, dialect or Dialect.grbl, slope=slope, quiet=quiet)
    line = serving.Tcp(_PORT if tcp is None else tcp, listen) if pty is None else serving.Pty(pty)
    with contextlib.ExitStack() as files, contextlib.closing(line):
        file = None if record is None else files.enter_context(_opened(record))
        server = serving.Server(mill, line, time_scale, saves=save, page=page, record=file)
        if not quiet:
            print(f"{mill.name} at {line.name}; Ctrl-C ends it", file=sys.stderr, flush=True)
            if server.page:
                print(f"page: {server.page.address}", file=sys.stderr, flush=True)
        _serve(server, quiet)
    return GOOD


def _opened(path):
    try:
        return path.open("w", encoding="utf-8")
    except OSError as cause:
        raise Refused(f"{path}: error[file]: {cause.strerror}; name another --record") from None


def _serve(server, quiet):
    """Serve until Ctrl-C or a signal, telling what is kept."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        while True:
            server.step()
            _tell(server.keeper, quiet)
    except KeyboardInterrupt:
        server.end()
        _tell(server.keeper, quiet)


def _tell(keeper, quiet):
    for note in keeper.notes if not quiet else ():
        print(note, file=sys.stderr, flush=True)
    keeper.notes.clear()
