# SPDX-License-Identifier: MIT
"""Benches: every subject gives rows, which are printed as one table or as JSON."""

import importlib
import inspect
import json as json_text
import os
import platform
import subprocess
import sys
from pathlib import Path

import numpy as np

from pycnc import errors
from pycnc.kernel import version

LIVE = "linuxcnc --live"

# Subject → (module, functions whose rows make the table). A module opens when it is asked for.
SUBJECTS = {
    "decode": [("kernel", "bench_decode_rows")],
    "lookahead": [("parallel", "bench_lookahead_rows"), ("kernel", "bench_window_rows")],
    "tick": [("kernel", "bench_tick_rows")],
    "time": [("kernel", "bench_time_rows")],
    "cores": [("cores", "bench_cores_rows")],
    "cost": [("cost", "bench_cost_rows")],
    "optimum": [("optimum", "bench_optimum_rows")],
    "bounds": [("bounds", "bench_bounds_rows")],
    "corpus": [("corpus", "bench_corpus_rows")],
    "monotony": [("monotony", "bench_monotony_rows")],
    "gains": [("gains", "bench_gains_rows")],
    "families": [("families", "bench_families_rows")],
    "tubes": [("families", "bench_tubes_rows")],
    "rules": [("rules", "bench_rules_rows")],
    "linuxcnc": [("linuxcnc", "bench_linuxcnc_rows")],
    LIVE: [("linuxcnc_live", "bench_live_rows"), ("linuxcnc_wide", "bench_wide_rows")],
    "butterfly": [("linuxcnc", "bench_butterfly_rows")],
    "window": [("linuxcnc", "bench_window_rows")],
    "stops": [("stops", "bench_stops_rows")],
    "controllers": [("stops_controllers", "bench_stops_controllers_rows")],
    "bubble": [("grades", "bench_bubble_rows")],
    "opencl": [("opencl", "bench_opencl_rows")],
    "cao": [("papers", "cao")],
    "segments": [("papers", "segments")],
    "grades": [("papers", "grades")],
    "keinert": [("papers", "keinert")],
    "scaling": [("papers", "scaling")],
}


def run(name, *, json=False, folder=None, paths=None):
    """Run a bench and print its table.

    Parameters
    ----------
    name : str
        One of `SUBJECTS`.
    json : bool
        Print {"bench", "commit", "machine": {"cpu", "cores", "device"}, "rows"} instead.
    folder : path, optional
        Where subjects that draw figures put them.
    paths : path, optional
        Folder with problems, for the subject that takes them.

    Returns
    -------
    list of dict
        The rows, all with the same keys.

    Raises
    ------
    ArgumentError
        If there is no such bench.
    """
    if name not in SUBJECTS:
        raise errors.ArgumentError(
            f"no bench {name!r}; there are: {', '.join(SUBJECTS)}", id="bench"
        )
    rows, notes = [], []
    for place, function in SUBJECTS[name]:
        module = importlib.import_module(f"pycnc.bench.{place}")
        rows += _rows_of(getattr(module, function), folder=folder, paths=paths)
        notes.append(_note(module))
    rows = _same_keys(rows)
    facts = {"bench": name, "commit": commit(), "machine": computer()}
    if json:
        print(json_text.dumps({**facts, "rows": rows}))
        return rows
    print(f"{name}, {facts['commit']}, {', '.join(str(x) for x in computer().values() if x)}")
    print()
    print(table(rows))
    print()
    print("\n\n".join(notes))
    return rows


def _rows_of(function, **options):
    """Call a subject with those options that it takes."""
    taken = inspect.signature(function).parameters
    return function(**{name: value for name, value in options.items() if name in taken})


def _note(module):
    """Return how a module's rows are measured and what would make them wrong."""
    return inspect.getdoc(module).partition("\n\n")[2]


def _same_keys(rows):
    keys = dict.fromkeys(key for row in rows for key in row)
    return [{key: row.get(key) for key in keys} for row in rows]


def commit():
    """Return the commit of the source tree, or the version if this is no source tree."""
    root = Path(__file__).resolve().parents[2]
    call = ["git", "-C", root, "describe", "--always", "--dirty", "--exclude=*"]
    try:
        done = subprocess.run(call, capture_output=True, text=True)
    except OSError:
        return version()
    return done.stdout.strip() or version()


def computer():
    """Return what the numbers were measured on: {"cpu", "cores", "device"}."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    models = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    # Only if a bench has opened one.
    device = sys.modules.get("pycnc.device") if "pyopencl" in sys.modules else None
    return {
        "cpu": models[0] if models else platform.processor() or platform.machine(),
        "cores": os.cpu_count(),
        "device": "; ".join(str(each) for each in device.devices()) if device else None,
    }


def table(rows):
    """Return rows as text in columns: names above, numbers to the right, four digits.

    Examples
    --------
    >>> print(table([{"n": 1000, "ns": 2.71828}, {"n": 20, "ns": None}]))
       n     ns
    1000  2.718
      20      -
    """
    if not rows:
        return "(no rows)"
    names = list(rows[0])
    lines = [names] + [[_cell(row[name]) for name in names] for row in rows]
    widths = [max(len(line[k]) for line in lines) for k in range(len(names))]
    words = [any(isinstance(row[name], str) for row in rows) for name in names]
    aligned = (
        "  ".join(
            text.ljust(width) if is_word else text.rjust(width)
            for text, width, is_word in zip(line, widths, words, strict=True)
        )
        for line in lines
    )
    return "\n".join(line.rstrip() for line in aligned)


def _cell(value):
    if value is None:
        return "-"
    if isinstance(value, bool | np.bool_):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.0f}" if abs(value) >= 1000 else f"{value:.4g}"
    return str(value)
