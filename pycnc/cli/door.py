# SPDX-License-Identifier: MIT
"""The door of the command line: where verbs register, and what all of them need."""

import contextlib
import functools
import inspect
import os
import signal
import sys

import typer
from typer.core import TyperCommand, TyperGroup

from pycnc import names
from pycnc.cli.options import CURES
from pycnc.cli.words import GOOD, drop_stdout, explain, fail

# In the order of help.
VERBS = (
    "look", "check", "time", "why", "report", "run", "serve", "plot", "compare", "sweep",
)  # fmt: skip


class Verbs(TyperGroup):
    """The verbs. A program in the place of one asks for what most people want of it."""

    def resolve_command(self, ctx, args):
        """Find the verb of a command line."""
        word = args[0]
        is_program = "." in word or os.sep in word or os.path.isfile(word)
        named = word in self.commands or not is_program
        return super().resolve_command(ctx, args if named else ["look", *args])


class OptionalValue(TyperCommand):
    """A verb whose ``--what-if`` may have a KEY=VALUE behind it, or nothing."""

    def parse_args(self, ctx, args):
        """Give a bare ``--what-if`` its empty value."""
        following = [*args[1:], ""]
        return super().parse_args(ctx, [
            f"{word}={CURES}" if word == "--what-if" and not _is_change(behind) else word
            for word, behind in zip(args, following, strict=True)
        ])  # fmt: skip


def _is_change(word):
    """Tell whether a word behind an option that needs none is its KEY=VALUE, and no file."""
    return "=" in word and not word.startswith("-") and not os.path.isfile(word)


app = typer.Typer(
    name="pycnc",
    cls=Verbs,
    help="An NC kernel: from NC text to axis setpoints, tick by tick.",
    epilog="Begin with: pycnc part.ngc. Every verb's --help ends with an example.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)
machines = typer.Typer(no_args_is_help=True, help="Machine files.")
app.add_typer(machines, name="machine")
linuxcnc = typer.Typer(no_args_is_help=True, help="The kernel as LinuxCNC's trajectory planner.")
app.add_typer(linuxcnc, name="linuxcnc")
lab = typer.Typer(
    no_args_is_help=True,
    help="Other planners, the firmware, measurements: not for every day.",
)
app.add_typer(lab, name="lab")
LAB = ("plan", "backend", "prep_steps")  # options that a verb has in the lab alone


def _tell_version(asked):
    if asked:
        print(f"pycnc {names.version()}")
        raise typer.Exit


@app.callback()
def _options(
    version: bool = typer.Option(
        False, "--version", callback=_tell_version, is_eager=True, help="Tell the version."
    ),
):
    pass


@contextlib.contextmanager
def _hearing():
    """A verb hears an interrupt from the keyboard, where else the system would end the process."""
    if signal.getsignal(signal.SIGINT) is not signal.SIG_DFL:
        yield
        return
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.SIG_DFL)


def verb(group, example, cls=None, without=()):
    """Register a function as a verb: whatever goes wrong in it becomes words and an exit code.

    Its name is the verb's. The example ends the verb's help. cls: of a command that reads its
    words in a way of its own. without: options that it does not have in this group.
    """

    def register(function):
        @functools.wraps(function)
        def guarded(*arguments, **options):
            try:
                with _hearing():
                    code = function(*arguments, **options)
                    sys.stdout.flush()
            except BrokenPipeError:  # the reader has seen enough: pycnc lab canon … | head
                drop_stdout()
                code = GOOD
            except (Exception, KeyboardInterrupt) as cause:
                code = explain(cause)
            raise typer.Exit(code or GOOD)

        whole = inspect.signature(function)
        kept = [each for name, each in whole.parameters.items() if name not in without]
        guarded.__signature__ = whole.replace(parameters=kept)
        name = function.__name__.rstrip("_")
        group.command(name=name, cls=cls, epilog=f"Example: pycnc {example}")(guarded)
        return function

    return register


def machine_of(
    name, set, tools, dialect, *, slope=None, plan="exact", from_line=None, programs=None,
    zero=None, quiet=False
):
    """Return the machine that the options describe, after telling the changes without effect."""
    from pycnc.machine import Machine, effect

    changes = [*(set or ()), *([f"path.slope={slope.value}"] if slope else ())]
    changes += [f"dialect.from_line={from_line}"] if from_line else []
    changes += [f"dialect.programs={programs}"] if programs else []
    machine = Machine.load(name, set=changes, tools=tools, dialect=dialect and dialect.value)
    if not quiet:
        for words in machine.not_imported:
            fail(f"{machine.file}: note[not-imported]: {words}")
    if zero is not None:
        from pycnc.program import zero as zeros

        machine = Machine.load(machine, set=zeros.changes(zero, machine))
    if not quiet:
        for change, reason in effect.idle_changes(machine, plan):
            fail(f"--set {change}: warning[no-effect]: {reason}")
    return machine


def tell_idle(machine, changes, quiet):
    """Check changes that ``--what-if`` asks for, and tell those without effect."""
    from pycnc.machine import effect
    from pycnc.planning.why import changed_machines

    for change, changed in changed_machines(machine, changes):
        reason = effect.idle(changed, change.partition("=")[0].strip())
        if reason and not quiet:
            fail(f"--what-if {change}: warning[no-effect]: {reason}")


def close_list():
    """Put the verbs in the order of help, once all of them are registered."""
    app.registered_commands.sort(key=lambda each: VERBS.index(each.name))
