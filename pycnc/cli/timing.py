# SPDX-License-Identifier: MIT
"""The verbs that tell times: ``time`` and ``why``."""

import contextlib
import functools
import io
import json
import sys

from pycnc import errors
from pycnc.cli.door import LAB, OptionalValue, app, lab, machine_of, tell_idle, verb
from pycnc.cli.options import (
    CURES,
    Backend,
    By,
    DialectName,
    File,
    Files,
    FromLine,
    Jobs,
    Json,
    Left,
    MachineName,
    Override,
    Page,
    PlanName,
    Programs,
    Quiet,
    Set,
    SlopeName,
    Table,
    Tools,
    WhatIf,
    Zero,
)
from pycnc.cli.words import (
    GOOD,
    Refused,
    explain,
    facts_of_failure,
    give_up,
    look_at,
    next_to,
    progress,
    tell,
    writing,
)
from pycnc.names import DEFAULT

_PARTS_SHOWN = 20
_WITHOUT_PARTS = ("file", "machine", "version", "schema_version", "period_s", "time_s", "total_s",
                  "ticks", "slope", "control", "diagnostics")  # fmt: skip


@verb(app, "time part.ngc other.ngc --by section", without=LAB)
@verb(lab, "lab time part.ngc --plan sshape")
def time(
    *, files: Files, by: By = None, machine: MachineName = DEFAULT, dialect: DialectName = None,
    slope: SlopeName = None, set: Set = None, tools: Tools = None, from_line: FromLine = None,
    programs: Programs = None, zero: Zero = None, override: Override = 100, left: Left = None,
    plan: PlanName = "exact", backend: Backend = "auto", jobs: Jobs = 1, json_: Json = False,
    quiet: Quiet = False,
):  # fmt: skip
    """Tell the machining time of programs, from the plan.

    With tool changes and spindle starts, as the machine file has them in [times].
    """
    from pycnc.planning.plan import check_backend

    check_backend(backend, plan)
    mill = machine_of(
        machine, set, tools, dialect, slope=slope, plan=plan, from_line=from_line,
        programs=programs, zero=zero, quiet=quiet,
    )  # fmt: skip
    how = {"plan": plan, "backend": backend, "by": by and by.value, "as_json": json_,
           "override": override, "left": left, "quiet": quiet}  # fmt: skip
    _refuse_beside(mill, how, len(files))
    told, code = [], GOOD
    for facts, this, out, err in _each(functools.partial(_timed, mill, **how), files, jobs):
        sys.stderr.write(err)
        sys.stdout.write(out)
        told.append(facts)
        code = max(code, this)
    if json_:
        print(json.dumps(told[0] if len(files) == 1 else told))
    elif len(files) > 1:
        print(_total_line([facts for facts in told if "time_s" in facts], len(files)))
    return code


def _refuse_beside(machine, how, count):
    """Refuse what an override, or the time left at a line, does not go with."""
    from pycnc.planning.control import is_foreign

    whole = how["override"] == 100 or is_foreign(machine)
    if not whole and (count > 1 or how["by"] or how["left"] or how["plan"] != "exact"):
        raise Refused("--override: error[override]: this kernel's is run: of one program, without "
                      "--by, --left and --plan")  # fmt: skip
    if how["left"] and (how["by"] not in (None, "line") or how["plan"] != "exact"):
        raise Refused("--left: error[left]: it is told by lines: without another --by, or --plan")


def _each(work, files, jobs):
    """Yield (facts, exit code, what goes to stdout, to stderr) of the files, in their order."""
    if jobs == 1 or len(files) == 1 or "-" in files:
        for file in files:
            yield *work(file), "", ""
        return
    from pycnc.planning import workers

    units, done, due = enumerate(files), {}, 0
    jobs = min(jobs, len(files))
    for (place, file), result in workers.each(lambda: next(units, None), _aside, (work,), jobs):
        if isinstance(result, workers.Lost):
            raise errors.InternalError(f"{file}: {result}")
        done[place] = result
        while due in done:
            yield done.pop(due)
            due += 1


def _aside(unit, work):
    """Do a file's work in a process of its own: what it says is handed back."""
    _, file = unit
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        facts, code = work(file)
    return facts, code, out.getvalue(), err.getvalue()


def _facts(planned, override, left_s):
    """Return what --json tells of a plan."""
    facts = planned.as_dict()
    if override != 100:
        facts["override"] = override
    if left_s is not None:
        facts["left_s"] = left_s
    return facts


def _timed(machine, file, *, plan, backend, by, as_json, override, left, quiet):
    """Plan a program and tell its time. Returns (what --json tells of it, exit code)."""
    from pycnc.planning import pipeline
    from pycnc.planning.control import is_foreign
    from pycnc.planning.plan import Plan
    from pycnc.planning.shares import left as left_at

    if override != 100 and not is_foreign(machine):
        return _run_at(machine, file, override, as_json, quiet)
    shown, by = by, "line" if left else by
    with pipeline.beside(plan == "exact" and not by, machine) as beside:
        program, facts, code = look_at(file, machine, quiet, as_json, keep=False, beside=beside)
        if program is None:
            return facts, code
        how = {"plan": plan, "backend": backend, "by": by, "beside": beside,
               "override": override / 100}  # fmt: skip
        try:
            with progress(f"planning {program.file}", quiet) as bar:
                planned = Plan(program, keep=False, progress=bar, **how)
            rest_s = left_at(program, planned.parts, left) if left else None
        except Exception as cause:
            return facts_of_failure(facts, cause) if as_json else {}, explain(cause)
    if as_json:
        return _facts(planned, override, rest_s), GOOD
    tell(program, quiet, sys.stderr)
    at_line = [f"  left at line {left}: {_duration(rest_s)}"] if left else []
    parts = _part_lines(planned, shown) if shown else ()
    print("\n".join([_time_line(planned, override), *at_line, *parts]))
    return planned.totals, GOOD


def _run_at(machine, file, override, as_json, quiet):
    """Run a program under an override, as the kernel's clock has it, and tell its time."""
    from pycnc.report import times
    from pycnc.report.trace import Trace

    program, facts, code = look_at(file, machine, quiet, as_json, keep=False)
    if program is None:
        return facts, code
    with progress(f"running {program.file}", quiet) as bar:
        done = Trace(program, keep=False, commands=((0, "override", override, 100),), progress=bar)
    told = {name: done.summary[name] for name in _WITHOUT_PARTS} | {"override": override}
    if not as_json:
        tell(program, quiet, sys.stderr)
        print(times.head(program, told["total_s"], f", override {override} %"))
    return told, GOOD


@verb(app, "why part.ngc --what-if", cls=OptionalValue)
def why(
    *, file: File, what_if: WhatIf = None, output: Table = None, machine: MachineName = DEFAULT,
    dialect: DialectName = None, slope: SlopeName = None, set: Set = None, tools: Tools = None,
    programs: Programs = None, zero: Zero = None, json_: Json = False, quiet: Quiet = False,
):  # fmt: skip
    """Tell what costs time, on which lines, and what would help.

    Lost is what the plan takes longer than the programmed feed, the speed of rapids and dwells
    would. Speeding up and braking count to the corner, arc or stop that they serve. Places of one
    kind are one row.
    """
    from pycnc.planning import pipeline
    from pycnc.planning.plan import Plan
    from pycnc.report import reasons

    if output is not None and not output.lower().endswith(".csv"):
        raise Refused(f"{output}: error[format]: a table is written as .csv")
    mill = machine_of(
        machine, set, tools, dialect, slope=slope, programs=programs, zero=zero, quiet=quiet
    )
    changes = [change for change in what_if or () if change != CURES]
    tell_idle(mill, changes, quiet)
    with pipeline.beside(True, mill) as beside:
        program, facts, code = look_at(file, mill, quiet, json_, keep=False, beside=beside)
        if program is None:
            return give_up(facts, code, json_)
        with progress(f"planning {program.file}", quiet) as bar:
            found = Plan(program, keep=False, progress=bar, beside=beside).why()
    if what_if:
        with progress(f"planning {program.file} with each cure", quiet) as bar:
            found.what_if(bar, changes, cures=CURES in what_if)
    if output is not None:
        with writing(output):
            found.to_csv(output)
    if json_:
        print(json.dumps(found.as_dict()))
        return GOOD
    tell(program, quiet, sys.stderr)
    print("\n".join(reasons.lines(found)))
    return GOOD


@verb(app, "report part.ngc", cls=OptionalValue)
def report(
    *, file: File, output: Page = None, what_if: WhatIf = None, machine: MachineName = DEFAULT,
    dialect: DialectName = None, slope: SlopeName = None, set: Set = None, tools: Tools = None,
    programs: Programs = None, zero: Zero = None, json_: Json = False, quiet: Quiet = False,
):  # fmt: skip
    """Write one page for a browser: path, curves, program, lost time.

    The page needs no network, and nothing beside it.
    """
    output = _page_of(file, output)
    mill = machine_of(
        machine, set, tools, dialect, slope=slope, programs=programs, zero=zero, quiet=quiet
    )
    tell_idle(mill, [change for change in what_if or () if change != CURES], quiet)

    def lines(_found):
        return [output]

    return _write_page(file, mill, output, lines, quiet=quiet, json_=json_, what_if=what_if)


@verb(app, "look part.ngc")
def look(
    *, file: File, output: Page = None, machine: MachineName = DEFAULT,
    dialect: DialectName = None, slope: SlopeName = None, set: Set = None, tools: Tools = None,
    programs: Programs = None, zero: Zero = None, json_: Json = False, quiet: Quiet = False,
):  # fmt: skip
    """Check a program, tell its time and why, and write its page.

    The same as the program alone: pycnc part.ngc.
    """
    from pycnc.report import reasons

    output = _page_of(file, output)
    mill = machine_of(
        machine, set, tools, dialect, slope=slope, programs=programs, zero=zero, quiet=quiet
    )

    def lines(found):
        return [_time_line(found.plan, 100), *reasons.of_total(found), output]

    return _write_page(file, mill, output, lines, quiet=quiet, json_=json_)


def _write_page(file, mill, output, lines, *, quiet, json_, what_if=False):
    """Write the page of a program, and print what `lines` says of what was found."""
    from pycnc.report import page

    program, facts, code = look_at(file, mill, quiet, json_, keep=False)
    if program is None:
        return give_up(facts, code, json_)
    with progress(f"planning {program.file}", quiet) as bar, writing(output):
        found = page.write(program, output, bar, what_if)
    if json_:
        print(json.dumps({**found.as_dict(), "report": output}))
        return GOOD
    tell(program, quiet, sys.stderr)
    print("\n".join(lines(found)))
    return GOOD


def _page_of(file, output):
    """Return where the page of a program goes: next to it, if no other place is told."""
    output = next_to(file, ".html") if output is None else output
    if not output.lower().endswith((".html", ".htm")):
        raise Refused(f"{output}: error[format]: a report is written as .html")
    return output


def _time_line(plan, override):
    from pycnc.planning.plan import BY
    from pycnc.report import times

    by = f", planned {BY[plan.kind]}" if BY[plan.kind] else ""
    by += f", override {override} %" if override != 100 else ""
    return f"{times.head(plan.program, plan.totals['total_s'], by)} ({_split(plan.totals)})"


def _total_line(told, count):
    """Return the sums over several files."""
    from pycnc.report import times

    names = ("total_s", *(f"{name}_s" for name in (*times.KINDS, *times.MOTIONS)))
    sums = {name: sum(facts[name] for facts in told) for name in names}
    without = f" ({count - len(told)} without a time)" if len(told) < count else ""
    return f"total of {len(told)} files{without}: {_duration(sums['total_s'])} ({_split(sums)})"


def _split(facts):
    """Return what a time is made of, in the words of ``run``; zeros are left out."""
    from pycnc.report import times

    groups = (times.told(facts, names) for names in (times.KINDS, times.MOTIONS))
    return "; ".join(", ".join(map(" ".join, group)) for group in groups if group)


def _part_cells(part, columns, total_s):
    times = (part[f"{name}_s"] for name in columns)
    return [_duration(part["time_s"]), f"{part['time_s'] / max(total_s, 1e-9):.1%}",
            *(_duration(time_s) if time_s > 0 else "" for time_s in times),
            f"{part['line']:,}"]  # fmt: skip


def _aligned(rows):
    """Return rows of cells as lines, each column as wide as its widest cell."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return ["  ".join(cell.rjust(width) for cell, width in zip(row, widths, strict=True))
            for row in rows]  # fmt: skip


def _part_lines(plan, by):
    """Yield the table of the parts of a program's time."""
    from pycnc.report import times

    parts, total_s = plan.parts, plan.totals["total_s"]
    shown, rest = parts[:_PARTS_SHOWN], parts[_PARTS_SHOWN:]
    if not shown:
        return
    columns = [name for name in times.KINDS if any(part[f"{name}_s"] > 0 for part in shown)]
    heads = ["time", "share", *(times.KINDS[name] for name in columns), "line"]
    rows = [heads, *(_part_cells(part, columns, total_s) for part in shown)]
    names = [by, *(part["name"] for part in shown)]
    for cells, name in zip(_aligned(rows), names, strict=True):
        yield f"  {cells}  {_short(name)}".rstrip()
    if rest:
        time_s = _duration(sum(part["time_s"] for part in rest))
        width = max(len(row[0]) for row in rows)
        yield f"  {time_s.rjust(width)}  in {len(rest):,} more (all: --json)"


def _short(name, width=60):
    return name if len(name) <= width else f"{name[: width - 1]}…"


def _duration(seconds):
    from pycnc.report.plot import duration

    return duration(seconds)
