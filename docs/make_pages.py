# SPDX-License-Identifier: MIT
"""Write the pages that tell what code tells, and the output in README.md and docs/why.md."""

import argparse
import json
import os
import re
import subprocess
import sys
import typing
from decimal import Decimal
from pathlib import Path

from pycnc.machine import control, inputs, schema
from pycnc.program import diagnostics

ROOT = Path(__file__).resolve().parents[1]

# id → (wording of RS274NGC interpreters, grbl's error number or alarm)
ELSEWHERE = {
    "character": ("Bad character used", "error:1"),
    "number": ("Bad number format", "error:2"),
    "number-range": ("(by word) out of range", "error:4, error:38"),
    "line-length": ("Command too long", "error:11"),
    "comment": ("Unclosed comment found", ""),
    "comment:(": ("Nested comment found", ""),
    "word-unknown": ("Bad character used", "error:1"),
    "word-twice": ("Multiple words on one line", "error:25"),
    "word-unused": ("(by word) with no code that uses it", "error:36"),
    "word-missing": ("(by word) missing", "error:28"),
    "g-unknown": ("Unknown g code used", "error:20"),
    "m-unknown": ("Unknown m code used", "error:20"),
    "other-base": ("Unknown g code used", "error:20"),
    "modal-group": ("Two g codes used from same modal group", "error:21, error:24"),
    "unsupported": ("", "error:20"),
    "feed-missing": ("Cannot do g1 with zero feed rate", "error:22"),
    "arc-radius": ("Radius to end of arc differs from radius to start", "error:33"),
    "arc-mode": ("Radius to end of arc differs from radius to start", "error:33"),
    "arc-mode:A": ("Radius to end of arc differs from radius to start", "error:33"),
    "arc-centre": ("(by word) missing while center of arc needed", "error:35"),
    "arc-chord": ("Arc radius too small to reach end point", "error:34"),
    "axis-unknown": ("", "error:20"),
    "travel": ("Move would exceed limit", "alarm:2, error:15"),
    "tool-unknown": ("Requested tool not found in the tool table", "error:38"),
    "word-shared": ("G4 not allowed with G2 or G3 because they both use P", ""),
    "incremental": ("Cannot use g53 incremental", ""),
    "comp-on": ("Cannot (do that) with cutter radius compensation on", ""),
    "comp-plane": ("G41 with lathe tool, but plane is not G18", ""),
    "comp-entry": ("Length of … entry move is not greater than the tool radius", ""),
    "comp-exit": ("The move just after exiting cutter compensation mode must be straight", ""),
    "comp-radius": ("Tool radius not less than arc radius with comp", ""),
    "comp-gouge": ("Straight feed in concave corner cannot be reached without gouging", ""),
    "no-motion": ("Cannot use axis values without a g code that uses them", "error:31"),
}
FORMAT = re.compile(r":\.?\d?[gf]\}")  # {value:.3f} is for the formatter, not for the reader
TABLES = (
    ("", schema.MachineFile),
    ("[kernel]", schema.Kernel),
    ("[path]", schema.Path),
    ("[axis.x], y, z, u, v, w", schema.LinearAxis),
    ("[axis.a], b, c", schema.RotaryAxis),
    ("[kinematics]", schema.Kinematics),
    ("[control]", control.Control),
    ("[control.steps_per_mm], [control.jerk]", control.ByAxis),
    ("[spindle]", schema.Spindle),
    ("[times]", schema.Times),
    ("[dialect]", schema.Dialect),
    ("[approach]", schema.Approach),
    ("[inputs]", inputs.Inputs),
    ("[inputs.x], y, z, a, b, c, u, v, w", inputs.AxisSwitch),
    ("[start]", schema.Start),
    ("[work]", schema.Work),
    ("[home.g28], [home.g30], [home.g30_p3], [home.g30_p4], [work.g54] …", schema.Position),
    ("[tool.N]", schema.Tool),
    ("[m.N]", schema.OwnM),
    ("[g.N]", schema.OwnG),
)
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
MACHINE_HEAD = """\
# Machine files

A machine file is TOML and says every number that a program meets but does not contain. The unit
stands in every key. An unknown key, a wrong unit, a number out of range or NaN is an error; all
errors are told at once: `pycnc machine validate FILE`. `pycnc machine show NAME --effective` tells
every value in force and where it comes from. `--set axis.x.max_mm=500` changes one for one call,
`--tools FILE` adds the tools of a LinuxCNC tool table (mm; D is a diameter).

`pycnc machine new NAME` writes one to begin with, each key with its meaning. `pycnc machine import
FILE` makes one of LinuxCNC's INI, grbl's `$$`, Klipper's cfg, FluidNC's yaml, Marlin's `M503` or
RepRapFirmware's config.g: units are converted, each value has the line that it comes from as its
comment, and every line that nothing is made of is told. It says whose planner it is, [control],
with that control's settings. Files that it includes are read. `--units` says the unit where an INI
does not.

Positions are machine coordinates. A key without a default must be there, if its table is.
This page is written by `docs/make_pages.py` from `pycnc/machine/schema.py`; a test compares.
"""
DIAGNOSTICS_HEAD = """\
# Diagnostics

    part.nc:1043:12: error[arc-radius]: arc ends 0.214 mm off its circle (…)
      G2 X10 Y5 I3 J4
                ^
      help: check I J K and G90.1/G91.1, write more decimals, or set path.arc_radius_mm

File, line and column (from 1, in bytes), severity, id, message; the source line with a caret; help.
All errors of a program are told in one go, at most {shown} of one id and then their count. The ids
are stable: the kernel's status codes, `--json` and this page have the same. Errors end a program
before anything moves (exit code 1); warnings and notes do not. A file that cannot be read is
`error[file]`, a machine file that is wrong `error[machine]` (both exit code 2), a limit that a run
broke `error[limit]` (exit code 1).

In the messages a word in braces is the program's own letter, number or machine. An id with a letter
or a code behind it, such as `unsupported:G90`, has words of its own; `--json` tells the id alone.
The last two columns name what RS274NGC interpreters (LinuxCNC's `rs274`) and grbl say in the same
case.
This page is written by `docs/make_pages.py` from `pycnc/program/diagnostics.py`; a test compares.
"""


def machine_page():
    """Return the page about machine files."""
    lines = [MACHINE_HEAD]
    for title, table in TABLES:
        lines += [f"## {title or 'Top of the file'}", "", "| key | takes | default | meaning |"]
        lines += ["|---|---|---|---|"]
        for name, field in table.model_fields.items():
            lines.append(f"| `{name}` | {takes(field)} | {default(field)} | {field.description} |")
        lines.append("")
    return "\n".join(lines)


def members(kind):
    """Return what a type is made of; None, for a key that may be absent, is no part."""
    return [each for each in typing.get_args(kind) if each is not type(None)]


def choices(kind):
    """Return the choices of a type, () where it has none."""
    for each in (kind, *members(kind)[:1]):
        if typing.get_origin(each) is typing.Literal:
            return typing.get_args(each)
    return ()


def bare(kind, bounds):
    """Return a type without its annotations, and the bounds that stood in them."""
    while parts := members(kind):
        for part in parts:
            bounds = [*bounds, *getattr(part, "__metadata__", ())]
            kind = typing.get_args(part)[0] if hasattr(part, "__metadata__") else part
    return kind, bounds


def takes(field):
    """Return what a key takes, in words."""
    kind, bounds = field.annotation, list(field.metadata)
    if chosen := choices(kind):
        return ", ".join(f"`{choice}`" for choice in chosen)
    kind, bounds = bare(kind, bounds)
    if isinstance(kind, type) and issubclass(kind, schema.Table):
        return "table"
    words = {bool: "true, false", str: "text", dict: "tables", int: "whole number", tuple: "texts"}
    number = words.get(typing.get_origin(kind) or kind, "number")
    return " ".join([number, *limits(bounds)])


def bound_in_words(bound):
    """Return the end of a range; one of many zeros as a power of ten."""
    sign, digits, exponent = Decimal(bound).normalize().as_tuple()
    if len(digits) > 1 or -3 <= exponent < 6:
        return f"{Decimal(bound).normalize():f}"
    factor = "" if digits == (1,) else f"{digits[0]}·"
    return f"{'−' * sign}{factor}10{str(exponent).translate(RAISED)}"


def limits(bounds):
    """Yield the range of a number, in words."""
    signs = {"gt": ">", "ge": "≥", "le": "≤"}
    for bound in bounds:
        for part in [bound, *getattr(bound, "metadata", ())]:
            for name, sign in signs.items():
                if hasattr(part, name):
                    yield f"{sign} {bound_in_words(getattr(part, name))}"


def default(field):
    """Return a default as the file would write it; nothing if the key must be there."""
    value = field.default
    if field.is_required() or isinstance(value, schema.Table | dict) or value is None:
        return "required" if field.is_required() else ""
    if isinstance(value, Decimal):
        return f"{value}"
    text = str(value).lower() if isinstance(value, bool) else str(value)
    return f"`{text}`" if text else "empty"


def diagnostics_page():
    """Return the page about diagnostics."""
    lines = [DIAGNOSTICS_HEAD.format(shown=diagnostics.SHOWN_PER_ID)]
    lines += ["| id | severity | message | help | RS274NGC | grbl |", "|---|---|---|---|---|---|"]
    for name in diagnostics.ids():
        wording, number = ELSEWHERE.get(name, ("", ""))
        severity = diagnostics.severity_of(name)
        for key in [key for key in diagnostics.WORDING if key.split(":")[0] == name]:
            message, remedy = (FORMAT.sub("}", text) for text in diagnostics.WORDING[key])
            lines.append(f"| `{key}` | {severity} | {message} | {remedy} | {wording} | {number} |")
    return "\n".join(lines) + "\n"


BEGIN, END = "<!-- output -->\n", "<!-- /output -->"
EXAMPLES = {
    "README.md": ("run", "pycnc/examples/first_part.ngc"),
    "docs/why.md": ("why", "pycnc/examples/first_part.ngc", "--what-if", "path.slope=jerk",
                    "--what-if", "axis.z.j_max_mm_s3=8e4"),
}


def example_output(name):
    """Run the example of a page, and return the command and its output as Markdown."""
    command = [sys.executable, "-c", "from pycnc.cli import main; main()", *EXAMPLES[name]]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    lines = [f"$ pycnc {' '.join(EXAMPLES[name])}", *map(str.rstrip, done.stdout.splitlines())]
    return "\n".join(["```", *lines, "```", ""])


def split_output(text):
    """Return a page's text before, in and after the output of its example."""
    begin = text.index(BEGIN) + len(BEGIN)
    end = text.index(END, begin)
    return text[:begin], text[begin:end], text[end:]


CLOCK = re.compile(r"simulated in .*")  # how busy this computer is


def renewed(shown, now, timing):
    """Return the output now; without `timing` with the running time of the one that is shown."""
    was = CLOCK.search(shown)
    return now if timing or not was else CLOCK.sub(lambda _: was[0], now)


def write_output(name, timing=False):
    """Renew the output in a page."""
    page = ROOT / name
    before, shown, after = split_output(page.read_text(encoding="utf-8"))
    text = before + renewed(shown, example_output(name), timing) + after
    page.write_text(text, encoding="utf-8")


JSON_HEAD = """\
# JSON

With `--json` a verb tells its results as JSON on stdout, in one line; `check` tells a list of
findings, `lab canon` an object a line. Keys that stand here stay; more may come. A program that is
not planned, because it has errors or cannot be read, is told by the first four keys of `time`
alone.
`docs/schema.json` has all of it as JSON schema.

This page is written by `docs/make_pages.py` from `docs/json_models.py`; tests hold what the verbs
tell against it.
"""
COMMANDS_HEAD = """\
# The command line

`pycnc VERB …`. Results go to stdout, everything else to stderr. A file `-` is stdin. `NO_COLOR` is
honoured. Where a setting has a default, `pycnc machine show --effective` tells it.

| exit code | means |
|---|---|
| 0 | good |
| 1 | the program has errors, or a limit was broken |
| 2 | the command, a file or the machine file is wrong |
| 3 | a comparison is outside of its tolerance |
| 4 | an internal error, or a backend that fails |
| 130 | interrupted: no half file is left |

This page is written by `docs/make_pages.py` from the verbs' own help; a test compares.
"""
TRACE_HEAD = """\
# The columns of a trace

`pycnc run part.ngc -o trace.npz` (or `.csv`, `.parquet`) writes a row a tick;
`pycnc.run(program).columns` has the same, and `pycnc.Trace.load(file)` reads it back. A rotary axis
has degrees in place of millimetres. This page is written by `docs/make_pages.py` from
`pycnc/report/trace_file.py`; a test compares. The columns on a machine with X, Y and A:
"""
_COLUMNS = {
    "t_s": "end of the tick, from the start of the program",
    "line": "source line of the place, however many a piece has; 0 before the first",
    "block": "running number of the block",
    "kind": "what it does: `idle`, `rapid`, `line`, `arc`, `dwell`, `wait`, `spline`, `thread`",
    "s_mm": "path so far",
    "pos": "place of the axis in machine coordinates, as planned",
    "joint": "setpoint of the drive: whole nanometres, or nanodegrees",
    "vel_mm_s": "speed along the path, as the program means it",
    "feed_cmd_mm_min": "programmed feed; 0: a rapid",
    "override": "feed override, or that of rapids in a rapid; 1 is 100 %",
    "limit": "what holds the path: a name of `limit_time_s`; a ramp is `accel` or `jerk`",
    "queue_cells": "pieces of the plan that wait for the tick",
    "spindle_rpm": "commanded speed",
}


def json_page():
    """Return the page about JSON."""
    models = _models()
    lines = [JSON_HEAD]
    for verb, model in models.MODELS.items():
        lines += [f"## {verb}", "", *_table(model)]
    lines += ["## What is in them", ""]
    for model in models.SHARED:
        lines += [f"### {model.__name__}", "", *_table(model)]
    return "\n".join(lines)


def _models():
    sys.path.insert(0, str(ROOT / "docs"))
    import json_models

    return json_models


def _table(model):
    """Return the lines about a model: what is its own, behind what it adds to."""
    base = model.__bases__[0]
    known = getattr(base, "model_fields", {})
    yield model.__doc__.strip()
    if known:
        yield f"It has all keys of {base.__name__}, and:"
    yield from ("", "| key | has | meaning |", "|---|---|---|")
    for name, field in model.model_fields.items():
        if name not in known:
            yield f"| `{name}` | {_has(field.annotation)} | {field.description} |"
    yield ""


def _has(kind):
    if typing.get_origin(kind) is typing.Literal:
        return ", ".join(f"`{choice}`" for choice in typing.get_args(kind))
    inner = [each for each in typing.get_args(kind) if each is not type(None)]
    if typing.get_origin(kind) is list:
        return f"list of {_has(inner[0])}"
    if typing.get_origin(kind) is dict:
        return f"name → {_has(inner[1])}"
    if len(inner) != len(typing.get_args(kind)):
        return " or ".join([*map(_has, inner), "null"])
    if inner:
        return " or ".join(map(_has, inner))
    words = {str: "text", int: "whole number", float: "number"}
    return words.get(kind) or kind.__name__


def schema_text():
    """Return the JSON schema of all verbs."""
    from pydantic.json_schema import models_json_schema

    models = [(model, "serialization") for model in _models().MODELS.values()]
    _, whole = models_json_schema(models, title="what pycnc tells with --json")
    return json.dumps(whole, indent=1, ensure_ascii=False) + "\n"


def commands_page():
    """Return the page about the command line: the help of every verb."""
    from pycnc.cli import app

    groups = [(app, "")]
    groups += [(each.typer_instance, f"{each.name} ") for each in app.registered_groups]
    names = [before + command.name for group, before in groups
             for command in group.registered_commands]  # fmt: skip
    lines = [COMMANDS_HEAD]
    for name, text in zip(names, _helps(names), strict=True):
        lines += [f"## {name}", "", "```text", text, "```", ""]
    return "\n".join(lines)


def _helps(names):
    """Return what ``--help`` of each verb prints, in lines that fit a page."""
    code = """import sys
from pycnc.cli import main
for name in sys.argv[1:]:
    sys.argv = ["pycnc", *name.split(), "--help"]
    try:
        main()
    except SystemExit:
        print(end="\\0")
"""
    done = subprocess.run(
        [sys.executable, "-c", code, *names], capture_output=True, text=True, check=True,
        env={**os.environ, "COLUMNS": "96", "TERMINAL_WIDTH": "96", "NO_COLOR": "1"},
    )  # fmt: skip
    texts = done.stdout.split("\0")[:-1]
    return ["\n".join(line.rstrip() for line in text.strip().splitlines()) for text in texts]


def trace_page():
    """Return the page about the columns of a trace."""
    from pycnc.machine import Machine
    from pycnc.report.trace_file import Columns

    axis = "v_max_deg_s = 60\na_max_deg_s2 = 500\nj_max_deg_s3 = 5000\n"
    text = Machine.load("cao2014").text + f"\n[axis.a]\n{axis}"
    columns = Columns(Machine.from_text(text))
    lines = [TRACE_HEAD, "| column | unit | meaning |", "|---|---|---|"]
    for name, unit in columns.units.items():
        lines.append(f"| `{name}` | {unit} | {_COLUMNS.get(name) or _of_axis(name)} |")
    lines += ["", "These are not in files; they are made when they are asked for (`trace[…]`,",
              "`derived`, and in every table):", "", "| column | unit | meaning |", "|---|---|---|"]
    for before, words, power in (("vel", "speed", ""), ("acc", "acceleration", "2"),
                                 ("jerk", "jerk", "3")):
        for key, unit in (("x_mm", "mm"), ("a_deg", "deg")):
            behind = f"_s{power}"
            lines.append(f"| `{before}_{key}{behind}` | {unit}/s{_RAISED.get(power, '')} | {words} "
                         f"of the axis: difference of neighbouring ticks |")
    lines += [
        "", "A table (`to_pandas`, `to_polars`, `to_arrow`) has names in place of the codes of",
        "`kind` and `limit`; arrays have codes, and `limit_names()` tells what they mean. The file",
        "also has version, machine and its hash, program and its hash, dialect and period.", "",
    ]
    return "\n".join(lines)


_RAISED = {"2": "²", "3": "³"}


def _of_axis(name):
    return _COLUMNS[name.split("_")[0]]


PAGES = {
    "machine.md": machine_page, "diagnostics.md": diagnostics_page, "json.md": json_page,
    "commands.md": commands_page, "trace.md": trace_page, "schema.json": schema_text,
}  # fmt: skip


def main():
    """Renew all pages."""
    parser = argparse.ArgumentParser(description=__doc__)
    what = "also how long the README's example takes on this computer"
    parser.add_argument("--timing", action="store_true", help=what)
    asked = parser.parse_args()
    for name, page in PAGES.items():
        (ROOT / "docs" / name).write_text(page(), encoding="utf-8")
    for name in EXAMPLES:
        write_output(name, asked.timing)


if __name__ == "__main__":
    main()
