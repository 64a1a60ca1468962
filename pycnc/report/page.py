# SPDX-License-Identifier: MIT
"""One page about a program: its path, its curves, and what holds it back. No network.

    points and low points of the plan ─▶ packed columns, as they come ─▶ base64 ─▶ page

The page is one file: template, style sheet, bundle of scripts (``page/`` of the project builds it)
and data. Its security policy allows that style and that script by their hashes, and nothing else.
"""

import base64
import hashlib
import html
import json
import re
from importlib import resources

from pycnc import errors
from pycnc.files import Part
from pycnc.kernel.records import enum
from pycnc.planning import control, measure
from pycnc.planning.plan import Plan
from pycnc.report import felt
from pycnc.report.summary import limit_words
from pycnc.report.trail import Trail

_PARTS = ("page.html", "page.css", "page.js")


def _facts(found, trail, told):
    """Return what the page knows beside its columns: what ``pycnc why --json`` tells, and names."""
    plan, machine = found.plan, found.program.machine
    names, path = measure.limit_names(machine), machine.record["path"]
    slope, foreign = machine.settings.path.slope, control.is_foreign(machine)
    limits = enum("nck_limit_t")
    return {
        **found.as_dict(),
        "length_mm": plan.totals["length_mm"],
        "blocks": plan.totals["blocks"],
        "axes": machine.axes,
        "turned": trail.turned,
        "stock": _stock(found.program),
        "lathe": machine.settings.kinematics.type == "lathe_xz",
        "j_max": float(path["j_max"]) if slope != "linear" and not foreign else None,
        "points": told["points"],
        "feet": told["feet"],
        "limits": {code: {"name": name, "words": _words(name, machine)}
                   for code, name in names.items()},
        "ramps": [int(limits.ACCEL), int(limits.JERK)],
        **{name: told[name] for name in ("all", "spans", "lines") if name in told},
    }  # fmt: skip


def _stock(program):
    """Return what the page needs to show the part being cut; None where nothing is cut off."""
    machine, record = program.machine, program.machine.record
    if machine.settings.kinematics.type == "lathe_xz":
        return {"kind": "lathe", "tools": {}}
    if not set("xyz") <= set(machine.axes) <= set("xyzabc"):  # an extruder is an axis
        return None
    is_long = re.search(rb"G\s*0*43", program.text, re.I) if program.text else None
    tools = {number: {"diameter": 2 * float(tool.radius_mm),
                      **({"length": float(tool.length_mm)} if is_long else {})}
             for number, tool in machine.settings.tool.items() if tool.radius_mm > 0}  # fmt: skip
    return {"kind": "mill", "tools": tools, "work_z": float(record["work_nm"][0][2]) * 1e-6}


def _words(name, machine):
    """Return a limit in words; a ring that another control looks ahead in is its own."""
    theirs = control.is_foreign(machine) and name not in ("corner", "exact_stop")
    return (control.words(name, machine, "") if theirs else "") or limit_words(name)


def _worst(found):
    """Return the lines of the places that lose most, these first."""
    places = [place for cause in found.causes for place in cause["places"]]
    places.sort(key=lambda place: -place["lost_s"])
    return [place["line_worst"] for place in places]


def _script_hash(text):
    return base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def _assets():
    """Return name → text of the parts that every page has."""
    folder = resources.files("pycnc.report")
    return {name: folder.joinpath(name).read_text(encoding="utf-8") for name in _PARTS}


def inert(value):
    """Return JSON that ends no script and begins no comment, whatever stands in its texts.

    Examples
    --------
    >>> inert("</script>")
    '"\\\\u003c/script>"'
    """
    return json.dumps(value).replace("<", "\\u003c")


def _base64(pieces):
    """Yield bytes that come in pieces as text."""
    left = b""
    for piece in pieces:
        left += piece
        whole = len(left) // 3 * 3
        yield base64.b64encode(left[:whole]).decode()
        left = left[whole:]
    yield base64.b64encode(left).decode()


def _page(program, progress, what_if):
    """Return the page of a program as pieces of text, and what it tells."""
    trail, axes = Trail(program), felt.Felt(program)

    def plan():
        return Plan(program, keep=False, trail=trail.add, progress=progress).why()

    found = axes.beside(plan)
    if not found.time_s > 0:
        raise errors.ArgumentError(f"{program.file}: nothing moves: there is no path", id="empty")
    if what_if:
        asked = [""] if what_if is True else what_if
        found.what_if(changes=[each for each in asked if each], cures="" in asked)
    columns, told = trail.columns(program.text, _worst(found))
    facts, parts = _facts(found, trail, told), _assets()
    facts["felt"] = axes.add_to(columns)
    facts["columns"] = columns.told()
    fields = {
        "TITLE": [html.escape(f"{program.file}: why it takes its time")],
        "POLICY": [
            f"default-src 'none'; script-src 'sha256-{_script_hash(parts['page.js'])}'; "
            f"style-src 'sha256-{_script_hash(parts['page.css'])}'; base-uri 'none'; "
            "form-action 'none'"
        ],
        "STYLE": [parts["page.css"]],
        "FACTS": [inert(facts)],
        "DATA": _base64(columns.gzip()),
        "SCRIPT": [parts["page.js"]],
    }
    return _filled(parts["page.html"], fields), found


def _filled(template, fields):
    """Yield a template, and the pieces of a field in place of its name in double braces."""
    head, *rest = template.split("{{")
    yield head
    for piece in rest:
        name, _, behind = piece.partition("}}")
        yield from fields[name]
        yield behind


def make(program, progress=None, what_if=False):
    """Return the page of a program as HTML text, and what it tells, a `Why`.

    Parameters
    ----------
    program : Program
    progress : callable, optional
        Called with (bytes of the program that are planned, all of them).
    what_if : bool or list of str
        Plan it again with each cure, or with these settings; the page tells what they gain. An
        empty one of a list stands for the cures.

    Raises
    ------
    ProgramError
        If the program has an error.
    ArgumentError
        If nothing moves in it.
    """
    pieces, found = _page(program, progress, what_if)
    return "".join(pieces), found


def write(program, path, progress=None, what_if=False):
    """Write the page of a program into a file, which appears once it is complete.

    Returns what it tells, a `Why`. The parameters and errors are those of `make`; OSError if the
    file cannot be written.
    """
    with Part(path) as part:  # first: whether it can be written is known before it is made
        pieces, found = _page(program, progress, what_if)
        for piece in pieces:
            part.file.write(piece.encode("utf-8", errors="replace"))
    return found
