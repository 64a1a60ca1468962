# SPDX-License-Identifier: MIT
"""What a line costs in instructions, from its text to cells, and what the tick takes.

Counted by callgrind over a build of this tree by gcc -O2 with the capacities of the module; the
programs are those of `pycnc lab bench decode | tick`, shorter. `start` is commit 240a973 under the
same count, where its parts can be told apart. Other compilers count otherwise; clocks do not
matter. The longest steps of two microcontrollers are those of docs/size.md, which
tests/house/size/table.py measures.
"""

import re
import shutil
import subprocess
import tempfile
from collections import Counter
from pathlib import Path

from pycnc import errors
from pycnc.bench import kernel

ROOT = Path(__file__).resolve().parents[2]
LINES, ARCS, MOVES = 20_000, 1000, 20_000  # many lines: the first plan is made from rest, twice
DOORS = ("nck_push", "nck_prep", "nck_take")  # whose instructions are a line's
SOURCES = {
    "text_to_cells": ("csrc/nck/**/*.c", "tests/c/text_to_cells.c"),
    "plain_lines": ("csrc/nck/base/*.c", "csrc/nck/prep/1_decode/**/*.c", "tests/c/plain_lines.c"),
}


def _tool(name):
    path = shutil.which(name)
    if path is None:
        raise errors.AbsentError(f"counting instructions needs {name}", id="absent")
    return path


def capacities():
    """Return the module's capacities as options of a compiler."""
    text = (ROOT / "cmake" / "capacities.cmake").read_text(encoding="utf-8")
    told = re.search(r"set\(NCK_CAPACITY_HOST\s+(.*?)\)", text, re.S)[1]
    return [f"-D{each}" for each in told.split()]


def build(name, folder, level="-O2"):
    """Compile a program of `SOURCES` into a folder, at a level, once; return its path.

    What lies there already is taken as it is.
    """
    if not (ROOT / "tests" / "c").is_dir():
        raise errors.AbsentError("counting instructions needs the source tree", id="absent")
    binary = Path(folder) / f"{name}{level}"
    if binary.exists():
        return binary
    sources = [path for pattern in SOURCES[name] for path in sorted(ROOT.glob(pattern))]
    compile_c(sources, binary, level, capacities())
    return binary


def compile_c(sources, binary, level, definitions):
    """Compile sources, and libraries among them, as instructions are counted."""
    options = ["-std=c99", level, "-g1", "-ffp-contract=off", "-fno-math-errno", *definitions]
    command = [_tool("gcc"), *options, f"-I{ROOT / 'csrc'}", "-o", binary, *sources, "-lm"]
    subprocess.run(command, check=True)


class Count:
    """Instructions of one run, file by file.

    Attributes
    ----------
    total : int
        All that were collected.
    own : dict
        File → instructions of its functions, without those that they call.
    calls : dict
        Function → how often it was called.
    said : str
        What the program printed.
    """

    def __init__(self, text, said):
        self.said, self.own, self.calls = said, Counter(), Counter()
        file, called, is_own = None, None, True
        for line in text.splitlines():
            kind, _, told = line.partition("=")
            if kind == "fl":
                file = told
            elif kind == "cfn":
                called = told
            elif kind == "calls":
                self.calls[called] += int(told.split()[0])
                is_own = False  # what the next line has is the callee's
            elif line[:1].isdigit():
                self.own[file] += int(line.split()[1]) if is_own else 0
                is_own = True
        self.total = self.own.total()

    def room(self, part):
        """Return the instructions of functions whose file has this in its path."""
        return sum(cost for file, cost in self.own.items() if part in file)


def count(binary, arguments, doors=DOORS):
    """Run a program under callgrind and return the `Count` of functions and what they call."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        command = [_tool("valgrind"), "--tool=callgrind", f"--callgrind-out-file={out}"]
        command += ["--compress-strings=no", "--compress-pos=no"]
        command += [f"--toggle-collect={door}" for door in doors]
        done = subprocess.run([*command, binary, *arguments], capture_output=True, text=True)
        if done.returncode != 0:
            raise errors.InternalError(f"{Path(binary).name}: {done.stderr}", id="bench")
        return Count(out.read_text(encoding="utf-8"), done.stdout)


# What is counted: program, slope, and how the tick's side takes it.
RUNS = {
    "relief, linear": ("relief", "linear"),
    "relief, jerk, G61": ("relief", "jerk"),
    "relief, optimal, P0.01": ("smoothed", "optimal"),
    "arcs, jerk": ("arcs", "jerk"),
    "relief, linear, tick": ("relief", "linear", "tick"),
    "1 µm, linear, tick": ("micrometres", "linear", "tick"),
}
# Row → (at the start of issue 12, target); None: none was counted, or there is none.
GOALS = {
    "relief, linear, a line": (8391, 2500),
    "room 4 of it": (4710, 1000),
    "decode, a G1 line": (1945, 700),
    "relief, jerk, G61, a line": (36_742, 7000),
    "relief, optimal, P0.01, a line": (45_121, 12_000),
    "an arc of 35 ms, jerk": (419_974, 40_000),
    "nodes planned for a final cell": (2.95, 1.3),
    "profile, a node and plan": (1097, 450),
    "tick of 1 µm moves, over the relief's": (42.0, 8.0),
}


def _programs():
    relief = kernel.relief(LINES)
    return {
        "relief": relief,
        "smoothed": relief.replace(b"G61", b"G64 P0.01", 1),
        "arcs": kernel.arcs(ARCS),
        "micrometres": kernel.micrometres(MOVES),
    }


def count_runs(folder):
    """Return {name of `RUNS`: `Count`}; what is built and written goes to a folder."""
    binary, found = build("text_to_cells", folder), {}
    for name, text in _programs().items():
        (Path(folder) / name).write_bytes(text)
    for slope in ("linear", "jerk", "optimal"):
        (Path(folder) / slope).write_bytes(kernel.plain_machine(slope).record.tobytes())
    for name, (program, slope, *ticks) in RUNS.items():
        arguments = [Path(folder) / slope, Path(folder) / program, *ticks]
        found[name] = count(binary, arguments, ("nck_tick",) if ticks else DOORS)
    return found


def count_line(folder, kind="line"):
    """Return the instructions of decoding a plain line: a "line" of G1, a "modal" one, an "arc"."""
    binary = build("plain_lines", folder)
    few, many = (count(binary, [kind, str(n)], ("decode_all",)).total for n in (1000, 3000))
    return (many - few) / 2000


def count_planned(folder):
    """Return the nodes that the relief's jerk-limited plans have; where `count_runs` has written.

    Every node is drawn once a plan. The build leaves the call where it is.
    """
    program, slope = RUNS["relief, jerk, G61"]
    arguments = [Path(folder) / slope, Path(folder) / program]
    return count(build("text_to_cells", folder, "-O0"), arguments).calls["draw_motion"]


def figures(folder):
    """Return {row of `GOALS`: what is counted now}."""
    runs = count_runs(folder)
    linear, jerk = runs["relief, linear"], runs["relief, jerk, G61"]
    tick, short = runs["relief, linear, tick"], runs["1 µm, linear, tick"]
    planned = count_planned(folder)
    return dict(zip(GOALS, (
        linear.total / LINES,
        linear.room("/4_lookahead/") / LINES,
        count_line(folder),
        jerk.total / LINES,
        runs["relief, optimal, P0.01"].total / LINES,
        runs["arcs, jerk"].total / ARCS,
        planned / int(jerk.said),
        jerk.room("/5_slope/profile") / planned,
        short.total / short.calls["nck_tick"] * tick.calls["nck_tick"] / tick.total,
    ), strict=True))  # fmt: skip


def bench_cost_rows():
    """Return rows {case, start, now, target}."""
    with tempfile.TemporaryDirectory() as folder:
        now = figures(folder)
    return [
        {"case": name, "start": start, "now": now[name], "target": target}
        for name, (start, target) in GOALS.items()
    ]
