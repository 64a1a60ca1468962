# SPDX-License-Identifier: MIT
"""What the command line reads, and what it says: findings, refusals, progress, exit codes."""

import contextlib
import json
import os
import sys
import traceback
from pathlib import Path

from pycnc import errors, files, names

_USUAL = ("assumed-centre", "assumed-plane")  # what nearly all programs leave to the control
GOOD, WRONG, USAGE, OUTSIDE, INTERNAL, INTERRUPTED = 0, 1, 2, 3, 4, 130


class Refused(Exception):
    """A file that cannot be read or written, with what to say about it.

    Attributes
    ----------
    finding : Diagnostic or None
        The same as ``--json`` tells it.
    """

    def __init__(self, message, finding=None):
        super().__init__(message)
        self.finding = finding


def fail(message):
    """Say on stderr what is wrong."""
    print(message, file=sys.stderr)


def drop_stdout():
    """Let what is still to be written to stdout go nowhere."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


# What an exception is told as, and its exit code: the first row that it is one of.
_TOLD = (
    (errors.BackendError | errors.DeviceError, "pycnc: error[backend]: {cause}", INTERNAL),
    (errors.FirmwareError, "pycnc: error[controller]: {cause}", INTERNAL),
    (errors.MachineError | Refused, "{cause}", USAGE),
    (errors.ProgramError, "{cause}", WRONG),
    (errors.ArgumentError | errors.AbsentError, "pycnc: error[{id}]: {cause}", USAGE),
)


def explain(cause):
    """Return the exit code of an exception after telling it."""
    if isinstance(cause, KeyboardInterrupt):
        return INTERRUPTED
    for kinds, words, code in _TOLD:
        if isinstance(cause, kinds):
            fail(words.format(cause=cause, id=getattr(cause, "id", "") or "argument"))
            return code
    if isinstance(cause, OSError):
        fail(f"{cause.filename or 'pycnc'}: error[file]: {cause.strerror or cause}")
        if cause.filename is None:  # a disk that is full: pycnc lab canon … > file
            drop_stdout()
        return USAGE
    fail(f"pycnc: error[internal]: {type(cause).__name__}: {cause}")
    if os.environ.get("PYCNC_DEBUG"):
        traceback.print_exception(cause)
    else:
        fail("  help: please report this with the program; PYCNC_DEBUG=1 shows where it happened")
    return INTERNAL


def read(file, remedy="give a file with an NC program"):
    """Return (name, bytes) of a file on the command line; remedy: if it cannot be read."""
    try:
        if file == "-" and sys.stdin is not None:
            return "<stdin>", files.read_open(sys.stdin.buffer, "<stdin>")
        return file, files.read(file)
    except (OSError, ValueError) as cause:
        from pycnc.program.diagnostics import Diagnostic

        reason = getattr(cause, "strerror", None) or str(cause)
        words = Diagnostic(file, 0, 0, "file", "error", f"cannot read it: {reason}", remedy)
        raise Refused(words.text(colour(sys.stderr)), words) from None


def colour(stream):
    """Return whether a stream shows colours."""
    return stream.isatty() and "NO_COLOR" not in os.environ and os.environ.get("TERM") != "dumb"


@contextlib.contextmanager
def progress(what, quiet):
    """Give a function that shows how far the work is: a bar on stderr, on a terminal only."""
    if quiet or not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.markup import escape
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(escape(what), total=None)
        yield lambda done, total: bar.update(task, completed=done, total=total)


def decoded(file, machine, quiet, keep=True, beside=None):
    """Return a program on the command line, decoded whole; beside: a pipeline that plans it."""
    from pycnc.program import Program

    name, text = read(file)
    with progress(f"reading {name}", quiet) as bar:
        return Program(text, machine, file=name, keep=keep, progress=bar, beside=beside)


def tell(program, quiet, stream, verbose=False):
    """Write the diagnostics of a program; quiet: errors only; verbose: what all assume, too."""
    found, without = program.diagnostics, () if verbose else _USUAL
    if quiet:
        without = {each.id for each in found if each.severity != "error"}
    if text := found.text(program.file, colour(stream), without):
        print(text, file=stream)


def look_at(file, machine, quiet, as_json, keep=True, beside=None):
    """Return (program, facts, exit code) of a program on the command line.

    The program is None unless it can be planned; what is wrong has been told then, and facts are
    what ``--json`` tells of it: nothing without it. beside: a pipeline that plans it meanwhile.
    """
    try:
        program = decoded(file, machine, quiet, keep, beside)
    except Refused as cause:
        facts = facts_of(file, machine, [cause.finding.as_dict()]) if as_json else {}
        return None, facts, explain(cause)
    found = program.diagnostics
    if found.errors and not as_json:
        tell(program, quiet, sys.stderr)
    facts = facts_of(program.file, machine, found.as_list()) if as_json else {}
    return (None, facts, WRONG) if found.errors else (program, facts, GOOD)


def facts_of(name, machine, findings):
    """Return what ``--json`` tells of a program that is not planned."""
    return {
        "file": name,
        "machine": machine.name,
        "version": names.version(),
        "schema_version": names.SCHEMA,
        "diagnostics": findings,
    }


def facts_of_failure(facts, cause):
    """Add what went wrong while a program was planned to what ``--json`` tells of it."""
    from pycnc.program.diagnostics import Diagnostic

    identity, line = getattr(cause, "id", "") or "internal", getattr(cause, "line", None) or 0
    column = getattr(cause, "column", None) or 0
    failure = Diagnostic(facts["file"], line, column, identity, "error", str(cause))
    return facts | {"diagnostics": [*facts["diagnostics"], failure.as_dict()]}


def give_up(facts, code, as_json):
    """Return the exit code of a verb that its program ends, after telling it as JSON."""
    if as_json:
        print(json.dumps(facts))
    return code


def next_to(file, ending):
    """Return where a result goes that has no other place: next to its program.

    Examples
    --------
    >>> next_to("parts/plate.ngc", ".html")
    'parts/plate.html'
    """
    if file == "-":
        words = f"stdin has no place: tell where to, as -o part{ending}"
        raise Refused(f"--output: error[output]: {words}")
    path = Path(file).with_suffix(ending)
    if path == Path(file):
        raise Refused(f"--output: error[output]: {file} would be written over: tell where to")
    return str(path)


@contextlib.contextmanager
def writing(path):
    """Tell a file that cannot be written."""
    try:
        yield
    except OSError as cause:
        reason = cause.strerror or str(cause)
        raise Refused(f"{path}: error[file]: cannot write it: {reason}") from None


def draw(done, picture):
    """Write a picture of a run; return its path."""
    from pycnc.report import plot

    try:
        with writing(picture):
            return plot.write(done, picture)
    except ValueError as cause:  # matplotlib's word for an ending that it does not know
        raise Refused(f"{picture}: error[format]: {cause}") from None
