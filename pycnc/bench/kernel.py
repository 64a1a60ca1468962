# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench decode | tick | time`, and of the window in `pycnc lab bench lookahead`.

The programs are made here, always the same: a relief of micro-segments as a milled picture has
them, arcs, and what else the tick finds hard. rs274, LinuxCNC's stand-alone interpreter, is the
peer, if it is installed: there variants take turns and the medians count. Wrong would make it:
other work on the cores, a clock that changes between variants, and for the tick's longest times
whatever else interrupts a process.
"""

import functools
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from pycnc import kernel
from pycnc.bench import timing
from pycnc.machine import DEFAULT, Machine

ROUNDS = 5  # of every variant, in turn; the medians count
LINES = 180_000  # of the relief: as many as the corpus' largest surface
ARCS = 50_000
LOOPS = 30_000
TICKS = 1_000_000  # at most, for each program
HEAD = "G17 G21 G90 G91.1 G94 G61\nG0 X0 Y0 Z5\nF6000\n"


def relief(lines=LINES):
    """Return a program of short lines in three axes: rows over a smooth surface, four decimals."""
    k = np.arange(lines)
    row, column = divmod(k, 600)
    x = np.where(row % 2, 599 - column, column) * 0.12
    y = row * 0.12
    z = np.sin(x / 3) * np.cos(y / 5) - 2
    words = zip(x.tolist(), y.tolist(), z.tolist(), strict=True)
    moves = "\n".join(f"G1 X{a:.4f} Y{b:.4f} Z{c:.4f}" for a, b, c in words)
    return f"{HEAD}{moves}\nM2\n".encode()


def arcs(count=ARCS):
    """Return a program of quarter arcs that join smoothly, up and down in turn."""
    wave = (
        "G3 X1.0125 Y1.0125 I0.0000 J1.0125", "G2 X1.0125 Y1.0125 I1.0125 J0.0000",
        "G2 X1.0125 Y-1.0125 I0.0000 J-1.0125", "G3 X1.0125 Y-1.0125 I1.0125 J0.0000",
    )  # fmt: skip
    moves = _joined(wave[k % 4] for k in range(count))
    return f"{HEAD}G91\n{moves}\nM2\n".encode()


def _joined(moves):
    return "\n".join(moves)


def circles(count=200):
    """Return a program of full circles and helices."""
    return f"{HEAD}{_joined(['G2 I5 J0 Z1', 'G3 I-3 J0 Z0'] * count)}\nM2\n".encode()


def micrometres(count=200_000):
    """Return a program of moves of 1 µm: a tick crosses tens of them."""
    return f"{HEAD}{_joined(f'G1 X{k * 1e-3:.3f}' for k in range(count))}\nM2\n".encode()


def loop():
    """Return a program that goes along a helix by WHILE, sine and cosine."""
    body = "G1 X[50*COS[#1]] Y[50*SIN[#1]] Z[#1/1000]\n#1=[#1+1]"
    return f"{HEAD}#1=0\nO1 WHILE [#1 LT {LOOPS}]\n{body}\nO1 ENDWHILE\nM2\n".encode()


def plain_machine(slope="linear"):
    """Return the mill without travel limits, with an exact path: what the pages tell of."""
    plain = [f"path.slope={slope}", "path.tolerance_mm=0"]
    free = [f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
    return Machine.load(DEFAULT, set=[*plain, *free])


# rs274


def _rs274(file):
    """Return the wall time of rs274 over a file, its listing thrown away [s]."""
    begun = time.perf_counter()
    subprocess.run(["rs274", "-g", file], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.perf_counter() - begun


def _rs274_cpu(file):
    """Return what rs274 has of the processor over a file [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    _rs274(file)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def _has_rs274():
    return shutil.which("rs274") is not None


def _medians(variants):
    """Return name → median time of functions that return seconds, called in turn."""
    times = {name: [] for name in variants}
    for _ in range(ROUNDS):
        for name, run in variants.items():
            times[name].append(run())
    return {name: statistics.median(each) for name, each in times.items()}


def _decode(text, machine):
    begun = time.process_time()
    for _ in kernel.decode(text, machine):
        pass
    return time.process_time() - begun


def bench_decode_rows():
    """Return rows {case, lines, variant, ns_per_line, lines_per_s, ratio_to_rs274}.

    Times are of the processor; lines of a loop count as often as they are read. rs274 starts a
    process and prints what it finds, to nowhere; the time of its start, measured with an empty
    program, is taken off.
    """
    rows, machine = [], plain_machine()
    programs = ("lines", relief(), 1), ("arcs", arcs(), 1), ("loop", loop(), LOOPS)
    with tempfile.TemporaryDirectory() as folder:
        for case, text, times in programs:
            rows += _decode_rows(case, (text, times), machine, Path(folder))
    return rows


def _decode_rows(case, program, machine, folder):
    (text, times), empty = program, folder / "empty.ngc"
    lines = text.count(b"\n") if times == 1 else 4 * times  # WHILE, G1, #1=, ENDWHILE
    file = folder / f"{case}.ngc"
    file.write_bytes(text)
    empty.write_bytes(b"M2\n")
    variants = {"pycnc": functools.partial(_decode, text, machine)}
    if _has_rs274():
        variants |= {name: functools.partial(_rs274_cpu, each)
                     for name, each in (("rs274", file), ("start", empty))}
    seconds = _medians(variants)
    if _has_rs274():
        seconds["rs274"] -= seconds.pop("start")
    return [
        {
            "case": case,
            "lines": lines,
            "variant": name,
            "ns_per_line": each / lines * 1e9,
            "lines_per_s": lines / each,
            "ratio_to_rs274": seconds["rs274"] / each if "rs274" in seconds else None,
        }
        for name, each in seconds.items()
    ]


# Room 4 and the whole of prep


def bench_window_rows():
    """Return rows {n, variant, ns_per_point} of the windowed look-ahead, least times per block.

    The window of a firmware holds hundreds of blocks and stays in the processor's cache; the
    host's holds ten thousand.
    """
    rows, machine = [], plain_machine()
    for case, text in (("relief", relief()), ("arcs", arcs())):
        segs = timing.segs_of(text, machine)
        for blocks in (100, 0):
            changed = Machine.load(machine, set={"path.lookahead_blocks": blocks})
            ns = min(timing.window(segs, changed)[0] for _ in range(2 * ROUNDS))
            name = f"window of {blocks} blocks" if blocks else "window, all of it"
            rows.append(_window_row(len(segs), f"{name}, {case}", ns))
        ns = min(_plan(text, machine) for _ in range(2 * ROUNDS)) * 1e9
        rows.append(_window_row(len(segs), f"prep, text to cells, {case}", ns))
    return rows


def _window_row(n, variant, ns):
    return {"n": n, "variant": variant, "ns_per_point": ns / n}


def _plan(text, machine):
    begun = time.perf_counter()
    for _ in kernel.Planner(text, machine).pieces():
        pass
    return time.perf_counter() - begun


# The tick


def bench_tick_rows():
    """Return rows {case, ticks, ns_mean, ns_median, ns_99_99, ns_max} of one tick each.

    The largest of a million contains what else the computer did; 99.99 % of the ticks were not
    longer than ns_99_99.
    """
    programs = {"relief": relief(), "arcs": arcs(), "circles": circles(), "1 µm": micrometres()}
    machine = plain_machine()
    rows = []
    for case, text in programs.items():
        ns = timing.ticks(text, machine, TICKS)
        rows.append(
            {
                "case": case,
                "ticks": len(ns),
                "ns_mean": float(ns.mean()),
                "ns_median": float(np.median(ns)),
                "ns_99_99": float(np.quantile(ns, 0.9999)),
                "ns_max": int(ns.max()),
            }
        )
    return rows


# The command


def bench_time_rows():
    """Return rows {case, lines, variant, s, ratio_to_rs274}: `pycnc time` as a user types it.

    A process each: Python's start and imports are in the time, and so is rs274's printing of what
    it only interprets; it plans nothing.
    """
    text = relief()
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "relief.ngc"
        file.write_bytes(text)
        variants = {"pycnc time": functools.partial(_pycnc_time, file)}
        if _has_rs274():
            variants["rs274"] = functools.partial(_rs274, file)
        seconds = _medians(variants)
    return [
        {
            "case": "relief",
            "lines": text.count(b"\n"),
            "variant": name,
            "s": each,
            "ratio_to_rs274": seconds["rs274"] / each if "rs274" in seconds else None,
        }
        for name, each in seconds.items()
    ]


def _pycnc_time(file):
    free = [f"--set=axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
    call = [sys.executable, "-c", "from pycnc.cli import main; main()", "time", "-q", file, *free]
    begun = time.perf_counter()
    subprocess.run(call, stdout=subprocess.DEVNULL, check=True)
    return time.perf_counter() - begun
