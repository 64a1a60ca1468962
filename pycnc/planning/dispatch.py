# SPDX-License-Identifier: MIT
"""Which backend plans in bulk: measured once on this computer, kept, overridable, reported.

``backend="auto"`` stands for the backend that a calibration found to be the quickest at that number
of nodes. The calibration runs at the first use and is kept in the user's cache folder. The
environment variable ``PYCNC_BACKEND`` names what ``auto`` stands for instead. Every result is the
same to the bit, so a choice costs time at worst.
"""

import contextlib
import contextvars
import dataclasses
import json
import math
import os
import platform
import warnings
from pathlib import Path

from pycnc import errors

BACKENDS = ("c", "simd", "threads", "opencl")
# Where the calibration measures [nodes]; between them it goes by the logarithm, beyond the ends
# flat.
SIZES = (64, 256, 1024, 4096, 16384, 65536, 262144, 1048576)

_report = contextvars.ContextVar("pycnc_dispatch_report", default=None)
_tables = {}  # of this process, by file: also where the cache folder cannot be written
_warned = set()


@dataclasses.dataclass(frozen=True)
class Report:
    """Who computed the last result, and why it was that one.

    Attributes
    ----------
    backend : {"c", "simd", "threads", "opencl"}
        Where it ran.
    asked : str
        What the caller asked for.
    why : str
        The reason of the choice, in words.
    real : {"float", "double"}
        Number type.
    nodes : int
    processor : str
        ``"plain"``, ``"avx2"``, or the name of the OpenCL device.
    threads : int
    blocks, blocks_refused : int
        Blocks planned in lanes, and those planned serially because no overlap was certain.
    chunks_refused : int
        How often no overlap beyond a block was certain (it grew, and was planned serially); with
        threads, of a chunk: more than 0, and one thread planned all.
    overlap : int
        Longest overlap of a lane [nodes].
    """

    backend: str
    asked: str
    why: str
    real: str
    nodes: int
    processor: str = "plain"
    threads: int = 1
    blocks: int = 0
    blocks_refused: int = 0
    chunks_refused: int = 0
    overlap: int = 0

    def __str__(self):
        crew = f", {self.threads} threads" if self.threads > 1 else ""
        return f"{self.backend} ({self.real}, {self.processor}{crew}): {self.why}"


def last_report():
    """Return the Report of the last bulk plan in this thread, or None before the first one."""
    return _report.get()


def note(report):
    """Keep the Report of what just ran, for `last_report`."""
    _report.set(report)


def fall_back(cause):
    """Tell once for each kind of cause that ``auto`` goes on in C. Returns the reason in words.

    Parameters
    ----------
    cause : NckError
        What the chosen backend said.
    """
    if cause.id not in _warned:
        _warned.add(cause.id)
        warnings.warn(f"planning goes on in C: {cause}", RuntimeWarning, stacklevel=5)
    return f"fell back: {cause}"


@dataclasses.dataclass(frozen=True)
class Calibration:
    """What every backend costs on this computer.

    Attributes
    ----------
    costs : dict
        ``costs[real][backend]`` is a list of (nodes, ns a node), by growing nodes.
    """

    costs: dict

    def cost(self, real, backend, nodes):
        """Return what one node costs [ns], between the measured sizes by the logarithm."""
        points = self.costs[real][backend]
        if nodes <= points[0][0]:
            return points[0][1] * points[0][0] / max(nodes, 1)  # the start costs most of it
        for (n0, ns0), (n1, ns1) in zip(points, points[1:], strict=False):
            if nodes <= n1:
                share = math.log(nodes / n0) / math.log(n1 / n0)
                return math.exp((1 - share) * math.log(ns0) + share * math.log(ns1))
        return points[-1][1]

    def choose(self, real, nodes):
        """Return the quickest backend for so many nodes, False, and the reason in words."""
        costs = {name: self.cost(real, name, nodes) for name in self.costs[real]}
        best = min(costs, key=costs.get)
        told = ", ".join(f"{name} {ns:.2g}" for name, ns in costs.items())
        return best, False, f"calibrated at {nodes:,} nodes, ns a node: {told}"


@dataclasses.dataclass(frozen=True)
class Choice:
    """A backend, whether the user named it, and the reason in words."""

    backend: str
    is_named: bool
    why: str


def choose(asked, real, nodes, identity, measure):
    """Return the Choice for a bulk plan.

    Parameters
    ----------
    asked : str
        What the caller said: ``"auto"`` or one of `BACKENDS`.
    real : {"float", "double"}
    nodes : int
    identity : str
        What the costs depend on besides the computer: version, threads, instruction set.
    measure : callable
        ``measure(real, backend, nodes)`` returns ns a node, or None where a backend is not here.

    Raises
    ------
    ArgumentError
        If there is no such backend.
    """
    named = asked if asked != "auto" else os.environ.get("PYCNC_BACKEND", "auto")
    if named not in ("auto", *BACKENDS):
        raise errors.ArgumentError(
            f"backend {named!r} is not available; available: auto, {', '.join(BACKENDS)}",
            id="backend",
        )
    if named != "auto":
        who = "the caller" if asked != "auto" else "PYCNC_BACKEND"
        return Choice(named, True, f"named by {who}")
    if nodes < SIZES[0]:
        return Choice("c", False, f"fewer than {SIZES[0]} nodes")
    return Choice(*calibration(identity, measure).choose(real, nodes))


def calibration(identity, measure, *, anew=False):
    """Return the kept Calibration of this computer, measured if there is none yet.

    Parameters
    ----------
    identity, measure
        As for `choose`.
    anew : bool
        Measure even if one is kept.
    """
    who = f"{identity}; {_processor()}; {os.cpu_count()} cores"
    file = _file()
    kept = _tables.get(file) or _read(file)
    if not anew and kept.get("computer") == who:
        _tables[file] = kept
        return Calibration(kept["costs"])
    costs = {real: _measured(real, measure) for real in ("float", "double")}
    _tables[file] = {"computer": who, "costs": costs}
    _write(file, _tables[file])
    return Calibration(costs)


def _measured(real, measure):
    costs = {name: [(n, measure(real, name, n)) for n in SIZES] for name in BACKENDS}
    return {name: points for name, points in costs.items() if all(ns for _, ns in points)}


def _processor():
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    models = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return models[0] if models else platform.processor() or platform.machine()


def _file():
    home = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return Path(home) / "pycnc" / "dispatch.json"


def _read(file):
    """Return what a file holds; a file that is absent or damaged holds nothing."""
    try:
        kept = json.loads(file.read_text(encoding="utf-8"))
        Calibration(kept["costs"]).choose("float", SIZES[-1])
        Calibration(kept["costs"]).choose("double", SIZES[-1])
    except (OSError, ValueError, KeyError, TypeError, AttributeError, IndexError):
        return {}
    return kept


def _write(file, kept):
    """Keep a calibration for the next process; where that is not possible, it measures again."""
    passing = file.with_name(f"{file.name}.{os.getpid()}")
    try:
        file.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        passing.write_text(json.dumps(kept), encoding="utf-8")
        passing.replace(file)  # whole or not at all, for whoever reads it now
    except OSError:
        with contextlib.suppress(OSError):
            passing.unlink()
