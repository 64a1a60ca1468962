# SPDX-License-Identifier: MIT
"""Calls for a plan whose rooms work side by side: blocks become batches of path, batches a plan."""

import numpy as np

from pycnc.kernel import Planner
from pycnc.kernel.bind import check, ffi, lib, pointer
from pycnc.kernel.records import dtype

# Of a batch: type and number of its rows, under the names of C.
_ROWS = {
    "seg": ("nck_host_batch_seg_t", 4096), "whole": ("nck_seg_t", 4096),
    "node": ("nck_node_t", 8192), "output": ("nck_output_t", 1024), "mark": ("nck_mark_t", 4096),
    "order": ("uint8_t", 32768),
}  # fmt: skip


class Batch:
    """A stretch of path between two threads: segs, nodes and outputs in their order."""

    def __init__(self):
        self.record, self._rows = ffi.new("nck_host_batch_t *"), []
        for name, (kind, count) in _ROWS.items():
            rows = np.empty(count, dtype(kind))
            setattr(self.record, f"{name}s", pointer(kind, rows))
            setattr(self.record, f"{name}_max", count)
            self._rows.append(rows)


class Early:
    """Rooms 3 and 4 by themselves.

    Parameters
    ----------
    machine : Machine
    another : callable
        Returns the batch that is filled next.
    """

    def __init__(self, machine, another):
        self._early, self._another = ffi.new("nck_host_early_t *"), another
        check(lib.nck_host_early_init(self._early, machine.pointer))
        self._batch, self._anew, self._is_done = None, 1, False

    def batches(self, blocks):
        """Yield the batches that blocks fill.

        Parameters
        ----------
        blocks : numpy.ndarray
            Of dtype ``nck_block_t``, the next of the program; none: it ends, and so does the path.

        Raises
        ------
        NckError
            If these rooms cannot go on by themselves.
        """
        lib.nck_host_early_give(self._early, pointer("nck_block_t", blocks), len(blocks))
        while not self._is_done:
            if self._anew:
                self._batch = self._another()
            status = check(lib.nck_host_early_run(self._early, self._batch.record, self._anew))
            self._anew = int(status == lib.NCK_OK)
            self._is_done = status == lib.NCK_DONE
            if status == lib.NCK_EMPTY:
                return
            yield self._batch


class Late(Planner):
    """Room 5 and the sums of a plan, from batches of path.

    Parameters
    ----------
    machine : Machine
    """

    def __init__(self, machine):
        super().__init__(b"", machine, ())

    def take(self, batch):
        """Plan on with a batch, which is of no more use then.

        Raises
        ------
        NckError
            If the plan cannot be made this way, or the program has an error behind room 2.
        """
        lib.nck_host_plan_take(self._plan, batch.record)
        status = lib.NCK_OK
        while status == lib.NCK_OK:
            status = check(lib.nck_host_plan_run(self._plan))
