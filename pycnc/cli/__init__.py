# SPDX-License-Identifier: MIT
"""The command line: ``pycnc VERB``. Results on stdout, everything else on stderr."""

import json
import os
import sys
from typing import Annotated

import typer

# They register their verbs.
from pycnc.cli import adapting, comparing, configuring, serving, sweeping, timing  # noqa: F401
from pycnc.cli.door import LAB, app, close_list, lab, machine_of, machines, verb
from pycnc.cli.options import (
    Backend,
    Commands,
    ControllerName,
    DialectName,
    Figures,
    File,
    Files,
    FromLine,
    Json,
    MachineName,
    Output,
    Paths,
    Picture,
    PlanName,
    PrepSteps,
    Programs,
    Quiet,
    Set,
    SlopeName,
    Subject,
    Tools,
    Units,
    Verbose,
    Zero,
)
from pycnc.cli.words import (
    GOOD,
    USAGE,
    WRONG,
    Refused,
    colour,
    decoded,
    draw,
    explain,
    fail,
    give_up,
    look_at,
    next_to,
    progress,
    read,
    tell,
    writing,
)
from pycnc.extras import need, of_tree
from pycnc.names import DEFAULT, SCHEMA

PEAK_TOLERANCE = 1e-6  # of a limit, on the double setpoints


@verb(app, "check part.ngc --machine mill3")
def check(
    *, files: Files, machine: MachineName = DEFAULT, dialect: DialectName = None, set: Set = None,
    tools: Tools = None, from_line: FromLine = None, programs: Programs = None,
    zero: Zero = None, json_: Json = False, quiet: Quiet = False, verbose: Verbose = False,
):  # fmt: skip
    """Tell all errors and warnings of programs, without planning."""
    mill = machine_of(
        machine, set, tools, dialect, from_line=from_line, programs=programs, zero=zero,
        quiet=quiet,
    )  # fmt: skip
    found, code = [], GOOD
    for file in files:
        try:
            program = decoded(file, mill, quiet, keep=False)
        except Refused as cause:
            code = max(code, explain(cause))
            found.append(cause.finding.as_dict())
            continue
        code = max(code, WRONG if program.diagnostics.errors else GOOD)
        if json_:
            found += program.diagnostics.as_list()
            continue
        tell(program, quiet, sys.stdout, verbose)
        if not program.diagnostics.errors and not quiet:
            print(f"{program.file}: no errors in {program.block_count:,} blocks")
    if json_:
        print(json.dumps(found))
    return code


@verb(lab, "lab canon part.ngc --units inch")
def canon(
    *, file: File, machine: MachineName = DEFAULT, dialect: DialectName = None, set: Set = None,
    tools: Tools = None, units: Annotated[Units, typer.Option(help="Units of the listing.")] = "mm",
    zero: Zero = None, json_: Json = False, quiet: Quiet = False,
):  # fmt: skip
    """List the decoded motions, one a line.

    Places are those of the tool tip, in machine coordinates.
    """
    from pycnc.report import listing

    mill = machine_of(machine, set, tools, dialect, zero=zero, quiet=quiet)
    program = decoded(file, mill, quiet)
    make = listing.json_lines if json_ else listing.lines
    sys.stdout.writelines(f"{line}\n" for line in make(program, Units(units).value))
    tell(program, quiet, sys.stderr)
    return WRONG if program.diagnostics.errors else GOOD


@verb(app, "run part.ngc --plot part.png -o trace.csv", without=LAB)
@verb(lab, "lab run part.ngc --plan grades")
def run(
    *, file: File, machine: MachineName = DEFAULT, dialect: DialectName = None,
    slope: SlopeName = None, set: Set = None, tools: Tools = None, from_line: FromLine = None,
    programs: Programs = None, output: Output = None, picture: Picture = None,
    zero: Zero = None, prep_steps: PrepSteps = None, plan: PlanName = "exact",
    backend: Backend = "auto", json_: Json = False, quiet: Quiet = False, verbose: Verbose = False,
):  # fmt: skip
    """Run a program in the simulation, tick by tick."""
    from pycnc import kernel
    from pycnc.report import trace

    if picture is not None:
        need("matplotlib.figure")
    mill = machine_of(
        machine, set, tools, dialect, slope=slope, plan=plan, from_line=from_line,
        programs=programs, zero=zero, quiet=quiet,
    )  # fmt: skip
    program, facts, code = look_at(file, mill, quiet, json_, keep=False)
    if program is None:
        return give_up(facts, code, json_)
    if verbose:
        tell(program, quiet, sys.stderr, verbose)
    with progress(f"running {program.file}", quiet) as bar, writing(output):
        done = trace.Trace(
            program, prep_steps=prep_steps or kernel.PREP_STEPS, keep=picture is not None,
            output=output, plan=plan, backend=backend, progress=bar,
        )  # fmt: skip
    if picture is not None:
        picture = draw(done, picture)
    if json_:
        print(json.dumps(done.summary))
    elif not quiet:
        _print_summary(done, output, picture)
    return _judge(done)


def _print_summary(done, output, picture):
    from rich.console import Console

    from pycnc.report import summary

    written = [("Trace", output), ("Picture", picture)]
    width = None if sys.stdout.isatty() else 100
    shown = summary.render(done, [(what, path) for what, path in written if path])
    Console(highlight=False, width=width).print(shown, crop=False)


def _judge(done):
    """Return the exit code of a run: WRONG if a limit was broken that its plan promises."""
    promised = ("v",) if done.plan.kind == "grades" else ("v", "a")
    promised = promised if any("j" in peak for peak in done.summary["peaks"].values()) else ()
    broken = [
        f"{name} {kind}: {ratio:.7f} of its limit"
        for name, peak in done.summary["peaks"].items()
        for kind, ratio in peak.items()
        if kind in promised and ratio > 1 + PEAK_TOLERANCE
    ]
    for words in broken:
        fail(f"{done.program.file}: error[limit]: {words}")
    return WRONG if broken else GOOD


@verb(lab, 'lab controller part.ngc --at "250 hold" --at "900 resume"')
def controller(
    *, file: File, on: ControllerName = "host", at: Commands = None,
    machine: MachineName = DEFAULT, dialect: DialectName = None, slope: SlopeName = None,
    set: Set = None, tools: Tools = None, prep_steps: PrepSteps = None,
    json_: Json = False, quiet: Quiet = False,
):  # fmt: skip
    """Run a program on the firmware, with its tasks and interrupts."""
    from pycnc import controller, kernel

    mill = machine_of(machine, set, tools, dialect, slope=slope, quiet=quiet)
    name, text = read(file)
    done = controller.open(on).run(
        text, mill, controller.read_commands(at or ()), file=name, prep_steps=prep_steps or 0
    )
    if json_:
        facts = {"file": name, "machine": mill.name, "version": kernel.version(),
                 "schema_version": SCHEMA, "controller": on, "slope": mill.settings.path.slope,
                 "period_s": mill.period_s}  # fmt: skip
        print(json.dumps(facts | done.as_dict()))
        return GOOD if done.state in controller.WANTED else WRONG
    if not quiet:
        print("\n".join([f"{name} on {on}, slope {mill.settings.path.slope}:", *done.lines()]))
    for found in done.diagnostics:
        if found.severity == "error":
            fail(found.text(colour(sys.stderr)))
    return GOOD if done.state in controller.WANTED else WRONG


@verb(app, "plot part.ngc")
def plot(
    *, file: File,
    output: Annotated[str | None, typer.Option(
        "--output", "-o", metavar="PICTURE",
        help="Where to: .png, .svg or .pdf; else a .png next to the program.")] = None,
    machine: MachineName = DEFAULT, dialect: DialectName = None, slope: SlopeName = None,
    set: Set = None, tools: Tools = None, programs: Programs = None, zero: Zero = None,
    json_: Json = False, quiet: Quiet = False,
):  # fmt: skip
    """Draw the path, coloured by speed, and its speed over time.

    The speed is the one that is really reached. Acceleration is drawn, too.
    """
    from pycnc.report import trace

    output = next_to(file, ".png") if output is None else output
    need("matplotlib.figure")
    mill = machine_of(
        machine, set, tools, dialect, slope=slope, programs=programs, zero=zero, quiet=quiet
    )
    program, facts, code = look_at(file, mill, quiet, json_)
    if program is None:
        return give_up(facts, code, json_)
    with progress(f"running {program.file}", quiet) as bar:
        done = trace.Trace(program, progress=bar)
    picture = draw(done, output)
    if not json_:
        tell(program, quiet, sys.stderr)
    print(json.dumps({**done.summary, "picture": picture}) if json_ else picture)
    return _judge(done)


@verb(lab, "lab bench lookahead")
def bench(
    *, name: Subject = None, output: Figures = None, paths: Paths = None,
    live: Annotated[bool, typer.Option(
        "--live", help="Subject linuxcnc: in the LinuxCNC that is installed here.")] = False,
    json_: Json = False,
):  # fmt: skip
    """Print one table of a benchmark, in a checkout.

    Some subjects draw figures, too.
    """
    bench = of_tree("pycnc.bench")
    if name is None:
        print("\n".join(bench.SUBJECTS))
        return GOOD
    if output is not None:
        need("matplotlib.figure")
    with writing(output):
        bench.run(f"{name} --live" if live else name, json=json_, folder=output, paths=paths)
    return GOOD


@verb(machines, "machine list")
def list_(*, json_: Json = False):
    """List the machines that come with pycnc."""
    from pycnc.machine import Machine, shipped

    loaded = [Machine.load(name) for name in shipped()]
    if json_:
        rows = [
            {"name": each.name, "axes": each.axes, "description": each.settings.description}
            for each in loaded
        ]
        print(json.dumps(rows))
        return
    for each in loaded:
        print(f"{each.name:16}{each.axes.upper():7}{each.settings.description}")


@verb(machines, "machine show mill3 --effective")
def show(
    *, name: Annotated[str, typer.Argument(metavar="NAME|FILE", help="Which machine.")] = DEFAULT,
    effective: Annotated[bool, typer.Option(
        "--effective", help="Every setting in force, and where its value comes from.")] = False,
    set: Set = None, tools: Tools = None, dialect: DialectName = None, json_: Json = False,
    quiet: Quiet = False,
):  # fmt: skip
    """Print a machine file."""
    from pycnc.report import listing

    machine = machine_of(name, set, tools, dialect, quiet=quiet)
    changed = effective or set or tools or dialect
    if json_:
        print(json.dumps(listing.settings_dict(machine)))
    elif changed:
        print("\n".join(listing.settings_toml(machine, defaults=effective)))
    else:
        print(machine.text, end="")


@verb(machines, "machine validate mill3 cak6150n")
def validate(
    *, names: Annotated[list[str], typer.Argument(metavar="NAME|FILE…", help="Which machines.")],
    set: Set = None, tools: Tools = None, dialect: DialectName = None, json_: Json = False,
    quiet: Quiet = False,
):  # fmt: skip
    """Check machine files: all errors at once."""
    from pycnc.machine import MachineFileError

    problems = []
    for name in names:
        try:
            machine = machine_of(name, set, tools, dialect, quiet=quiet)
        except MachineFileError as cause:
            problems += [
                {"file": place, "key": key, "message": words}
                for place, (key, words) in zip(cause.places, cause.problems, strict=True)
            ]
            if not json_:
                print(cause)
            continue
        if not (json_ or quiet):
            print(f"{machine.file}: good ({machine.name}, axes {machine.axes.upper()})")
    if json_:
        print(json.dumps(problems))
    return USAGE if problems else GOOD


close_list()


def main():
    """Enter from the console script."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:  # the caller has closed it: pycnc time … >&-
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115
        getattr(sys, name).reconfigure(errors="replace")
    app()
