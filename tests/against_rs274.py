# SPDX-License-Identifier: MIT
"""Random programs against LinuxCNC's rs274, as many as one wants.

    .venv/bin/python tests/against_rs274.py 10000 [first seed]

A share of every family: modes and arcs, canned cycles, expressions and calls, shifted zeros, kept
states, homes and dynamic lengths. Prints a table, and every program that differs; exit code 3 if
one does. The suite runs the first of each; docs/words.md has a whole run.
"""

import multiprocessing
import sys
import tempfile
from pathlib import Path

import cycle_programs
import macro_programs
import rs274_oracle
import test_1_cycles
import test_1_decode
import test_1_macros
import test_1_offsets
import test_1_ports

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


# name → program of a seed, machine, how far rounding adds up [mm], whether it drills
FAMILIES = {
    "modes": (test_1_decode.modal_program, _six_axes, 0.0, False),
    "cycles": (cycle_programs.program, _mill, test_1_cycles.PECKS, True),
    "macros": (macro_programs.program, _mill, test_1_macros.READ_BACK, False),
    "zeros": (test_1_offsets.program, _mill, 0.0, False),
    "states": (lambda seed: test_1_ports.program(seed).encode(), _mill, 0.0, False),
}


def compare(name, seed, folder):
    """Return (moves that are equal, what differs) of one program."""
    write, machine, rounding, drills = FAMILIES[name]
    text = write(seed)
    blocks, diagnostics = stages.decode(text, machine())
    errors = [status_id(int(each["code"])) for each in diagnostics if each["code"] < 0]
    (folder / "program.ngc").write_bytes(text)
    theirs, complaint = rs274_oracle.run(folder / "program.ngc", folder, TOOLS)
    if errors or "error" in complaint.lower() or (complaint and name != "macros"):
        return 0, f"ours: {errors}, theirs: {complaint}"
    for move in theirs:
        move.tolerance += rounding
    theirs = rs274_oracle.drill_upright(theirs) if drills else theirs
    ours = rs274_oracle.from_blocks(blocks, lib.NCK_COUNTS_PER_DEG)
    equal, words = rs274_oracle.difference(ours, theirs)
    return equal, words or ("" if equal > 0.5 * len(theirs) else f"{equal} of {len(theirs)}")


def _one(task):
    with tempfile.TemporaryDirectory() as folder:
        return (*task, *compare(*task, Path(folder)))


def main(count, first):
    """Compare `count` programs; print the table; return how many differ."""
    names = list(FAMILIES)
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
    seeds = [int(word) for word in sys.argv[1:3]]
    sys.exit(3 if main(*seeds, *[1000][len(seeds) - 1 :]) else 0)
