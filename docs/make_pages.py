# SPDX-License-Identifier: MIT
"""Write machine.md, diagnostics.md and the output in README.md from the code that they describe.

python docs/make_pages.py
"""

import re
import subprocess
import sys
import typing
from decimal import Decimal
from pathlib import Path

from pycnc.machine import schema
from pycnc.program import diagnostics

ROOT = Path(__file__).resolve().parents[1]

# id → (wording of RS274NGC interpreters, grbl's error number or alarm)
ELSEWHERE = {
    "character": ("Bad character used", "error:1"),
    "number": ("Bad number format", "error:2"),
    "number-range": ("(by word) out of range", "error:4, error:38"),
    "line-length": ("Command too long", "error:11"),
    "comment": ("Unclosed comment found", ""),
    "word-unknown": ("Bad character used", "error:1"),
    "word-twice": ("Multiple words on one line", "error:25"),
    "word-unused": ("(by word) with no code that uses it", "error:36"),
    "word-missing": ("(by word) missing", "error:28"),
    "g-unknown": ("Unknown g code used", "error:20"),
    "m-unknown": ("Unknown m code used", "error:20"),
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
    ("[spindle]", schema.Spindle),
    ("[dialect]", schema.Dialect),
    ("[start]", schema.Start),
    ("[home.g28], [home.g30], [work.g54] … [work.g59_3]", schema.Position),
    ("[tool.N]", schema.Tool),
    ("[m.N]", schema.OwnM),
)
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
MACHINE_HEAD = """\
# Machine files

A machine file is TOML and says every number that a program meets but does not contain. The unit
stands in every key. An unknown key, a wrong unit, a number out of range or NaN is an error; all
errors are told at once: `pycnc machine validate FILE`. `pycnc machine show NAME --effective` tells
every value in force and where it comes from. `--set axis.x.max_mm=500` changes one for one call,
`--tools FILE` adds the tools of a LinuxCNC tool table (mm; D is a diameter).

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


def takes(field):
    """Return what a key takes, in words."""
    kind, bounds = field.annotation, list(field.metadata)
    if typing.get_origin(kind) is typing.Literal:
        return ", ".join(f"`{choice}`" for choice in typing.get_args(kind))
    members = [each for each in typing.get_args(kind) if each is not type(None)]
    while typing.get_origin(kind) is typing.Annotated or members:
        for member in members:
            bounds += getattr(member, "__metadata__", ())
            kind = typing.get_args(member)[0] if hasattr(member, "__metadata__") else member
        members = [m for m in typing.get_args(kind) if m is not type(None)]
    if isinstance(kind, type) and issubclass(kind, schema.Table):
        return "table"
    words = {bool: "true, false", str: "text", dict: "tables", int: "whole number"}
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
EXAMPLE = ("run", "pycnc/examples/first_part.ngc", "--set", "path.slope=jerk")


def example_output():
    """Run the example of the README, and return the command and its output as Markdown."""
    command = [sys.executable, "-c", "from pycnc.cli import main; main()", *EXAMPLE]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    lines = [f"$ pycnc {' '.join(EXAMPLE)}", *map(str.rstrip, done.stdout.splitlines())]
    return "\n".join(["```", *lines, "```", ""])


def split_readme(text):
    """Return README's text before, in and after the output of the example."""
    begin = text.index(BEGIN) + len(BEGIN)
    end = text.index(END, begin)
    return text[:begin], text[begin:end], text[end:]


def write_readme():
    """Renew the output in the README."""
    readme = ROOT / "README.md"
    before, _, after = split_readme(readme.read_text(encoding="utf-8"))
    readme.write_text(before + example_output() + after, encoding="utf-8")


PAGES = {"machine.md": machine_page, "diagnostics.md": diagnostics_page}


def main():
    """Renew all pages."""
    for name, page in PAGES.items():
        (ROOT / "docs" / name).write_text(page(), encoding="utf-8")
    write_readme()


if __name__ == "__main__":
    main()
