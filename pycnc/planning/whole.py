# SPDX-License-Identifier: MIT
"""Whole programs that the host plans at once, in place of the kernel's room 5: their path, their
cells and sums, and running them."""

import numpy as np

from pycnc import errors, kernel
from pycnc.kernel.bind import ffi, lib, pointer
from pycnc.kernel.records import copied, dtype, join

_CELL_ROWS = 16384


def records_of(text, machine, names, *, threads=False, progress=None):
    """Plan a whole NC text by the kernel and keep records of it.

    Parameters
    ----------
    text : bytes
        Without errors.
    machine : Machine
    names : sequence of str
        Which records, as `kernel.Planner` takes them.
    threads : bool
        As for `kernel.Planner`.
    progress : callable, optional
        Called with (bytes used, bytes of the text).

    Returns
    -------
    records : list of numpy.ndarray
    totals : numpy.void
        Of dtype ``nck_host_totals_t``.
    """
    planner = kernel.Planner(text, machine, names, threads=threads)
    kept = [[] for _ in names]
    for *pieces, used in planner.pieces():
        for arrays, piece in zip(kept, pieces, strict=True):
            arrays.append(copied(piece))
        if progress:
            progress(used, len(text))
    records = [join(f"nck_{name}_t", rows) for name, rows in zip(names, kept, strict=True)]
    return records, planner.totals


class Motion:
    """A path that the host has planned whole. A planner has its own `slope` and `_walk`.

    Attributes
    ----------
    machine : Machine
    segs, outputs : numpy.ndarray
        Of dtypes ``nck_seg_t`` and ``nck_output_t``, the whole path and what it hands over.
    slope : str
        The machine's slope that its caps are for, and its run.
    nodes : numpy.ndarray
        Of dtype ``nck_node_t``, if it is planned by the kernel's.
    backend : str
        Where it was planned.
    count : int
        What its totals tell as nodes.
    """

    slope = "jerk"
    backend = "c"

    def __init__(self, segs, machine, outputs=None):
        self.machine = machine
        self.segs = join("nck_seg_t", [segs])
        self.outputs = join("nck_output_t", [] if outputs is None else [outputs])
        self.nodes = join("nck_node_t", [])

    @property
    def count(self):
        """How many nodes it has."""
        return len(self.nodes)

    def _walk(self):
        """Return the name of the planner's function that gives cells, and a new place to begin."""
        raise NotImplementedError

    def feed(self):
        """Return a new ``nck_host_feed_t`` at the first cell, and what must live as long."""
        name, walk = self._walk()
        feed = ffi.new("nck_host_feed_t *")
        feed.machine, feed.next, feed.walk = self.machine.pointer, ffi.addressof(lib, name), walk
        feed.segs, feed.seg_count = pointer("nck_seg_t", self.segs), len(self.segs)
        feed.outputs, feed.output_count = pointer("nck_output_t", self.outputs), len(self.outputs)
        return feed, walk

    @property
    def totals(self):
        """Times and counts, a ``nck_host_totals_t``."""
        feed, _walk = self.feed()
        sums = np.zeros(1, dtype("nck_host_totals_t"))
        lib.nck_host_feed_totals(feed, pointer("nck_host_totals_t", sums))
        sums["nodes"] = self.count
        return sums[0]

    def cells(self):
        """Return the cells of the whole path, of dtype ``nck_cell_t``."""
        (feed, _walk), count = self.feed(), ffi.new("size_t *", 1)
        rows = np.empty(_CELL_ROWS, dtype("nck_cell_t"))
        kept = []
        while count[0]:
            lib.nck_host_feed_cells(feed, pointer("nck_cell_t", rows), len(rows), count)
            kept.append(copied(rows[: count[0]]))
        return join("nck_cell_t", kept)


class Simulation(kernel.Simulation):
    """The simulation, fed with a motion.

    Parameters
    ----------
    motion : Motion
        For a machine of its slope: another's filter would make another motion of it.
    prep_steps : int
        Prep steps between two ticks, 1 at least.
    """

    def __init__(self, motion, prep_steps=kernel.PREP_STEPS):
        slope = motion.machine.settings.path.slope
        if slope != motion.slope:
            raise errors.ArgumentError(
                f"such a plan runs with the slope {motion.slope}, not {slope}", id="slope"
            )
        super().__init__(b"", motion.machine, prep_steps)
        self._motion = motion
        self._feed, self._walk = motion.feed()
        self._feed.nck = self._nck
        lib.sim_prepare_by(self._sim, ffi.addressof(lib, "nck_host_feed_prep"), self._feed)
