# SPDX-License-Identifier: MIT
"""One page about a program: its path, its curves, and what holds it back. No network.

    points and low points of the plan ─▶ columns of small differences ─▶ gzip ─▶ base64 ─▶ page

The page is one file: template, style sheet, bundle of scripts (``page/`` of the project builds it)
and data. Its security policy allows that style and that script by their hashes, and nothing else.
"""

import base64
import gzip
import hashlib
import html
import json
from importlib import resources

import numpy as np

from pycnc import errors
from pycnc.files import Part
from pycnc.kernel import Blocks
from pycnc.kernel.bind import lib
from pycnc.kernel.records import enum, join
from pycnc.machine.schema import ROTARY_AXES
from pycnc.planning import measure
from pycnc.planning.plan import Plan
from pycnc.report.summary import limit_words
from pycnc.report.turning import Turning, turns

PLACE_MM = 1e-3  # positions are told in steps of so much
TIME_S = 1e-6  # and times
_LEVELS = 65535  # of a speed
_ESCAPE = -32768  # stands for a difference that 16 bits do not hold
_GZIP = 6
_RAPID, _RESTS = 32, 64  # bits beside the limit in the column "code"
_PARTS = ("page.html", "page.css", "page.js")


class Trail:
    """The points of a plan as they come, in as little memory as the page needs.

    `turned`: with the angles of rotary axes.
    """

    def __init__(self, turned=False):
        self._points, self._feet, self._turned = [], [], turned

    def add(self, points, feet):
        """Take the next rows of dtypes ``nck_host_point_t`` and ``nck_host_foot_t``."""
        self._points.append({
            "t": points["t"].copy(),
            "xyz": np.rint(points["xyz"] / PLACE_MM).astype(np.int32),
            "v": points["v"].astype(np.float32),
            "feed": points["feed"].astype(np.float32),
            "line": points["line"].copy(),
            "tool": points["tool"].astype(np.uint16),
            "code": points["limit"] + _RAPID * points["rapid"] + _RESTS * points["rests"],
            **({"abc": points["abc"].astype(np.float32)} if self._turned else {}),
        })  # fmt: skip
        self._feet.append(feet.copy())

    def points(self):
        """Return column → array of all points; they are handed over."""
        names = list(self._points[0])
        return {
            name: np.concatenate([piece.pop(name) for piece in self._points]) for name in names
        }

    def feet(self):
        """Return all low points."""
        return join("nck_host_foot_t", self._feet)


class Columns:
    """Columns of numbers as bytes, and where each of them lies."""

    def __init__(self):
        self.told, self._bytes, self._size = {}, [], 0

    def _add(self, name, kind, array, **facts):
        data = array.tobytes()
        self.told[name] = {"kind": kind, "at": self._size, "size": len(data), **facts}
        self._bytes.append(data)
        self._size += len(data)

    def bytes(self, name, data):
        """Add bytes as they are."""
        self._add(name, "u1", np.frombuffer(data, np.uint8))

    def numbers(self, name, array):
        """Add numbers of 1, 2 or 4 bytes as they are."""
        self._add(name, array.dtype.str[1:], array.astype(array.dtype.newbyteorder("<")))

    def levels(self, name, array, most):
        """Add numbers from 0 to `most` in 65,536 levels: differences modulo 65,536."""
        levels = np.rint(array * (_LEVELS / most)).astype(np.int64)
        change = np.diff(levels, prepend=0).astype(np.uint16)
        self._add(name, "levels", _planes(change), quantum=most / _LEVELS)

    def steps(self, name, array, quantum=1.0):
        """Add whole numbers: differences of 16 bits, those that need more beside them."""
        change = np.diff(array.astype(np.int64), prepend=0)
        large = np.abs(change) > -_ESCAPE - 1
        small = np.where(large, _ESCAPE, change).astype(np.int16)
        self._add(name, "steps", _planes(small.view(np.uint16)), quantum=quantum)
        self._add(f"{name}+", "f8", change[large].astype("<f8"))

    def data(self):
        """Return the bytes of all columns."""
        return b"".join(self._bytes)


def _planes(array):
    """Return 16 bit numbers as their low bytes, then their high ones: these compress better."""
    return np.stack([array & 255, array >> 8]).astype(np.uint8)


def _pack(trail, program):
    """Return the columns of the page, its points and its low points, and which axes turn."""
    points, feet, columns = trail.points(), trail.feet(), Columns()
    turned = [k for k in range(3) if "abc" in points and np.ptp(points["abc"][:, k]) > 0]
    places = _turned(columns, points, turned, program) if turned else points["xyz"]
    for k, letter in enumerate("xyz"):
        columns.steps(letter, places[:, k], PLACE_MM)
    columns.steps("t", np.rint(points["t"] / TIME_S).astype(np.int64), TIME_S)
    most = float(max(points["v"].max(), points["feed"].max(), 1e-9))
    columns.levels("v", points["v"], most)
    columns.levels("feed", points["feed"], most)
    columns.steps("line", points["line"])
    columns.steps("tool", points["tool"])
    columns.numbers("code", points["code"])
    low = feet["low"]
    columns.steps("foot_first", feet["first"])
    columns.steps("foot_at", feet["at"])
    columns.steps("foot_line", low["line"])
    columns.numbers("foot_limit", low["limit"].astype(np.uint8))
    columns.numbers("foot_ends", low["ends"].astype(np.uint8))
    columns.numbers("foot_axis", low["axis"].astype(np.uint8))
    columns.numbers("foot_angle", np.degrees(low["angle"]).astype(np.float32))
    columns.numbers("foot_lost", low["lost_s"].astype(np.float32))
    columns.bytes("text", b"" if isinstance(program.text, Blocks) else bytes(program.text))
    return columns, len(points["t"]), len(feet), [ROTARY_AXES[k] for k in turned]


def _turned(columns, points, turned, program):
    """Add the places of the axes, and return those on the part, in steps."""
    for k, letter in enumerate("xyz"):
        columns.steps(f"axis_{letter}", points["xyz"][:, k], PLACE_MM)
    for k in turned:
        steps = np.rint(points["abc"][:, k] / PLACE_MM)
        columns.steps(f"axis_{ROTARY_AXES[k]}", steps, PLACE_MM)
    places = Turning(program).on_part(points["xyz"] * PLACE_MM, points["abc"], points["line"])
    return np.rint(places / PLACE_MM).astype(np.int64)


def _facts(found, points, feet, turned):
    """Return what the page knows beside its columns: what ``pycnc why --json`` tells, and names."""
    plan, machine = found.plan, found.program.machine
    names, path = measure.limit_names(machine), machine.record["path"]
    slope = machine.settings.path.slope
    limits = enum("nck_limit_t")
    return {
        **found.as_dict(),
        "length_mm": plan.totals["length_mm"],
        "blocks": plan.totals["blocks"],
        "axes": machine.axes,
        "turned": turned,
        "lathe": machine.settings.kinematics.type == "lathe_xz",
        "a_max": float(path["a_max"]),
        "j_max": float(path["j_max"]) if slope != "linear" else None,
        "filter_s": lib.NCK_FILTER_TAPS * machine.period_s if slope == "jerk" else 0.0,
        "points": points,
        "feet": feet,
        "limits": {code: {"name": name, "words": limit_words(name)}
                   for code, name in names.items()},
        "ramps": [int(limits.ACCEL), int(limits.JERK)],
    }  # fmt: skip


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


def make(program, progress=None, what_if=False):
    """Return the page of a program as HTML text, and what it tells, a `Why`.

    Parameters
    ----------
    program : Program
    progress : callable, optional
        Called with (bytes of the program that are planned, all of them).
    what_if : bool
        Plan it again with each cure; the page tells what they gain.

    Raises
    ------
    ProgramError
        If the program has an error.
    ArgumentError
        If nothing moves in it.
    """
    trail = Trail(turns(program.machine))
    found = Plan(program, keep=False, trail=trail.add, progress=progress).why()
    if not found.time_s > 0:
        raise errors.ArgumentError(f"{program.file}: nothing moves: there is no path", id="empty")
    if what_if:
        found.what_if()
    columns, points, feet, turned = _pack(trail, program)
    data = base64.b64encode(gzip.compress(columns.data(), _GZIP, mtime=0)).decode()
    parts = _assets()
    facts = _facts(found, points, feet, turned) | {"columns": columns.told}
    fields = {
        "TITLE": html.escape(f"{program.file}: why it takes its time"),
        "POLICY": (
            f"default-src 'none'; script-src 'sha256-{_script_hash(parts['page.js'])}'; "
            f"style-src 'sha256-{_script_hash(parts['page.css'])}'; base-uri 'none'; "
            "form-action 'none'"
        ),
        "STYLE": parts["page.css"],
        "FACTS": inert(facts),
        "DATA": data,
        "SCRIPT": parts["page.js"],
    }
    head, *rest = parts["page.html"].split("{{")
    pieces = [head]
    for piece in rest:
        name, _, behind = piece.partition("}}")
        pieces += [fields[name], behind]
    return "".join(pieces), found


def write(program, path, progress=None, what_if=False):
    """Write the page of a program into a file, which appears once it is complete.

    Returns what it tells, a `Why`. The parameters and errors are those of `make`; OSError if the
    file cannot be written.
    """
    with Part(path) as part:  # first: whether it can be written is known before it is made
        text, found = make(program, progress, what_if)
        part.file.write(text.encode("utf-8", errors="replace"))
    return found
