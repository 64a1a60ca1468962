# SPDX-License-Identifier: MIT
"""A huge program in parts: it is cut at rests, and each part is a plan of its own.

    text ─▶ decoded once ─▶ cuts at dwells and waits ─▶ parts, planned by anybody ─▶ sums

Where it is cut depends on the program alone, so the bits are the same however many plan the parts.
The path rests there, and what is in force there goes with the part: its plan is the one that the
whole program has there, to the tick. Which limit holds the ramps beside a cut, a part does not
know; so parts give times.
"""

import numpy as np

from pycnc import kernel
from pycnc.planning import control
from pycnc.kernel.records import dtype

PART_BLOCKS = 20_000  # blocks of a part at least


def of(program):
    """Return an iterator over the parts of a program, for `totals_of`; None if it is not huge, or
    has threads: at what angle the spindle is where a part begins, only what is before it tells.
    """
    if control.is_foreign(program.machine):
        return None
    if isinstance(program.text, kernel.Blocks) or program.has_threads:
        return None
    if program.block_count < 2 * PART_BLOCKS:
        return None
    return kernel.cuts(program.text, program.machine, PART_BLOCKS)


def totals_of(part, text, machine):
    """Return the sums of a part, a record of ``nck_host_totals_t``."""
    planner = kernel.Planner(text, machine, (), part=part)
    for _ in planner.pieces():
        pass
    return planner.totals


def add(totals, machine):
    """Return the sums of all parts of a program, in their order."""
    sums = np.zeros((), dtype("nck_host_totals_t"))
    for part in totals:
        for name in sums.dtype.names:
            sums[name] += part[name]
    sums["time_s"] = float(sums["ticks"]) * machine.period_s
    return sums[()]
