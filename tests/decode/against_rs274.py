# SPDX-License-Identifier: MIT
"""Random programs against LinuxCNC's rs274, as many as one wants.

    .venv/bin/python tests/decode/against_rs274.py 10000 [first seed [family …]]

A share of every family: modes and arcs, canned cycles, expressions and calls, shifted zeros, kept
states, taps, radius compensation, lathes; and in Fanuc's language, each beside the same in
RS274NGC: layouts, turning cycles, macros. Prints a table, and every program that differs; exit
code 3 if one does. The suite runs the first of each; docs/words.md has a whole run.
"""

import multiprocessing
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))

import comp_programs
import cycle_programs
import lathe_programs
import macro_programs
import paired_programs
import rs274_oracle
import test_cycles
import test_decode
import test_macros
import test_offsets
import test_ports

from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

TOOLS = {1: 0.0, 2: 50.8}
FREE = [f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
HOMES = [f"home.{code}.{axis}_mm=0" for code in ("g28", "g30") for axis in "xyz"]
TABLE = [f"tool.{number}.length_mm={length}" for number, length in TOOLS.items()]


def _six_axes():
    lines = ["[path]", "arc_radius_mm = 0.005", '[kinematics]\ntype = "identity"']
    for axis, unit in zip("xyzabc", ["mm"] * 3 + ["deg"] * 3, strict=True):
        lines += [f"[axis.{axis}]", f"v_max_{unit}_s = 100", f"a_max_{unit}_s2 = 1000"]
        lines.append(f"j_max_{unit}_s3 = 10000")
    for number, length in TOOLS.items():
        lines += [f"[tool.{number}]", f"length_mm = {length}"]
    return Machine.from_text("\n".join(lines))


def _mill():
    return Machine.load("mill3", set=[*FREE, *HOMES, *TABLE])


def _tapping_mill():
    return Machine.load("mill3", set=[*FREE, *HOMES, *TABLE, "axis.z.a_max_mm_s2=5000"])


def _compensating_mill():
    radii = [f"tool.{number}.radius_mm={radius}" for number, radius in comp_programs.RADII.items()]
    return Machine.load("mill3", set=[*FREE, *HOMES, *radii])


def _lathe(*change):
    free = [each for each in FREE if ".y." not in each]
    zeros = [each for each in HOMES if ".y_" not in each]
    return Machine.load("cak6150n", set=[*free, *zeros, "work.g54.z_mm=0", *change])


def _fanuc():
    return Machine.load("mill3", set=[*FREE, *HOMES, "dialect.base=fanuc"])


@dataclass(frozen=True)
class Family:
    """Programs of a kind: how they are written, and what they are read by."""

    write: Callable  # of a seed: a text, or ours and the same in RS274NGC
    machine: Callable = _mill
    rounding: float = 0.0  # how far it adds up [mm]
    told: Callable = lambda moves: moves  # rs274's moves, where ours are on purpose otherwise
    tools: dict = field(default_factory=lambda: TOOLS)
    warns: bool = False  # rs274 may say something and go on


FAMILIES = {
    "modes": Family(test_decode.modal_program, _six_axes),
    "cycles": Family(cycle_programs.program, _mill, test_cycles.PECKS,
                     rs274_oracle.drill_upright),
    "macros": Family(macro_programs.program, _mill, test_macros.READ_BACK, warns=True),
    "zeros": Family(test_offsets.program),
    "tools": Family(test_offsets.tool_program, rounding=1e-5),
    "states": Family(lambda seed: test_ports.program(seed).encode()),
    "taps": Family(lathe_programs.taps, _tapping_mill, 0.0, lathe_programs.told_taps),
    "contours": Family(comp_programs.program, _compensating_mill, 1e-5,
                       tools={n: (0.0, radius) for n, radius in comp_programs.RADII.items()}),
    "lathe": Family(lathe_programs.lathe,
                    lambda: _lathe("dialect.base=linuxcnc", "dialect.diameter=false"), 1e-5,
                    lathe_programs.told_lathe),
    "turning": Family(paired_programs.turning,
                      lambda: _lathe("dialect.system=A", "dialect.thread_pull_leads=0"), 1e-3),
    "fanuc": Family(paired_programs.macros, _fanuc, test_macros.READ_BACK, warns=True),
    "layouts": Family(paired_programs.layouts, _fanuc, 1e-4, paired_programs.told_layouts),
}  # fmt: skip


def compare(name, seed, folder):
    """Return (moves that are equal, what differs) of one program."""
    family = FAMILIES[name]
    text = family.write(seed)
    text, other = text if isinstance(text, tuple) else (text, text)
    blocks, diagnostics = stages.decode(text, family.machine())
    errors = [
        (status_id(int(each["code"])), int(each["line"]))
        for each in diagnostics if each["code"] < 0
    ]  # fmt: skip
    (folder / "program.ngc").write_bytes(other)
    theirs, complaint = rs274_oracle.run(folder / "program.ngc", folder, family.tools)
    if errors or "error" in complaint.lower() or (complaint and not family.warns):
        return 0, f"ours: {errors}, theirs: {complaint}"
    for move in theirs:
        move.tolerance += family.rounding
    theirs = family.told(theirs)
    ours = rs274_oracle.from_blocks(blocks, lib.NCK_COUNTS_PER_DEG)
    equal, words = rs274_oracle.difference(ours, theirs)
    return equal, words or ("" if equal >= 0.5 * len(theirs) else f"{equal} of {len(theirs)}")


def _one(task):
    with tempfile.TemporaryDirectory() as folder:
        return (*task, *compare(*task, Path(folder)))


def main(count, first=1000, names=()):
    """Compare `count` programs; print the table; return how many differ."""
    names = names or list(FAMILIES)
    tasks = [(names[k % len(names)], first + k // len(names)) for k in range(count)]
    sums = {name: [0, 0, 0] for name in names}
    with multiprocessing.Pool() as pool:
        for name, seed, equal, words in pool.imap_unordered(_one, tasks, chunksize=8):
            sums[name] = [a + b for a, b in zip(sums[name], (1, equal, words != ""), strict=True)]
            if words:
                print(f"{name} {seed}: {words}")
    print(f"{'family':8} {'programs':>9} {'moves':>9} {'differ':>7}")
    for name, (programs, moves, differ) in sums.items():
        print(f"{name:8} {programs:9} {moves:9} {differ:7}")
    return sum(differ for _, _, differ in sums.values())


if __name__ == "__main__":
    numbers = [int(word) for word in sys.argv[1:3]]
    sys.exit(3 if main(*numbers, *[sys.argv[3:]][: len(sys.argv) > 3]) else 0)
