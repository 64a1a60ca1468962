# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench cores`: a big program is read and planned, on one core and on several.

Both take turns in one run, and the medians count. The text is in memory; Python's start is not in
the time. `cpu_s` is the processor's time of all threads: where nobody else wants the cores, `s` is
about its half on two of them. Wrong would make it: other work on the cores, which leaves the plan
one of them.
"""

import functools
import statistics
import time

from pycnc import kernel
from pycnc.bench.kernel import plain_machine, relief
from pycnc.planning import measure, pipeline
from pycnc.planning.plan import Plan
from pycnc.program import Program

ROUNDS = 7  # of every variant, in turn
CASES = {"linear": 1_000_000, "jerk": 300_000}  # slope → lines of a relief


def bench_cores_rows():
    """Return rows {case, lines, variant, s, cpu_s, ratio_to_one_core, equal}.

    equal: time, sums and causes are those of one core, to the bit.
    """
    return [row for slope, lines in CASES.items() for row in _rows(slope, lines)]


def _rows(slope, lines):
    text, machine = relief(lines), plain_machine(slope)
    variants = {"one core": functools.partial(_on_one_core, text, machine)}
    if pipeline.cores() > 1:
        variants[f"{pipeline.cores()} cores"] = functools.partial(_side_by_side, text, machine)
    found = {name: [] for name in variants}
    for _ in range(ROUNDS):
        for name, run in variants.items():
            begun, cpu = time.perf_counter(), time.process_time()
            told = run()
            found[name].append((time.perf_counter() - begun, time.process_time() - cpu, told))
    wall, cpu = ({name: statistics.median(one[k] for one in each) for name, each in found.items()}
                 for k in (0, 1))  # fmt: skip
    first = found["one core"][0][2]
    return [
        {
            "case": f"relief, {slope}",
            "lines": lines,
            "variant": name,
            "s": wall[name],
            "cpu_s": cpu[name],
            "ratio_to_one_core": wall["one core"] / wall[name],
            "equal": all(told == first for _, _, told in found[name]),
        }
        for name in variants
    ]


def _on_one_core(text, machine):
    program = Program(text, machine, keep=False).check()
    planner = kernel.Planner(program.text, program.machine, ())
    for _ in planner.pieces():
        pass
    return measure.plan_times(planner.totals, machine), planner.why["causes"].tobytes()


def _side_by_side(text, machine):
    with pipeline.beside() as beside:
        program = Program(text, machine, keep=False, beside=beside)
        plan = Plan(program, keep=False, beside=beside)
    return plan.totals, plan.lost["causes"].tobytes()
