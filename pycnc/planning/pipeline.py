# SPDX-License-Identifier: MIT
"""A big program is planned by its rooms side by side, while it is read.

    caller: rooms 1, 2 ══blocks══▶ thread: rooms 3, 4 ══batches of path══▶ thread: room 5, sums

Each room does what it does in one kernel, in the same order, so the bits are those of the plan on
one core. A few arrays and batches go round, so memory does not grow with the program. Where a room
cannot go on by itself, or finds something wrong, there is no plan: the caller makes it on one core,
and tells what that tells.
"""

import contextlib
import os
import queue
import sys
import threading
import time

import numpy as np

from pycnc import errors, kernel
from pycnc.kernel.batches import Batch, Early, Late
from pycnc.kernel.records import dtype

_ARRAYS, _BATCHES = 3, 4


def cores():
    """Return how many cores a plan may use: in one of several processes that work side by side, 1.

    Without that it is what the system lets this process have.
    """
    processes = sys.modules.get("multiprocessing.process")
    if processes and processes.parent_process() is not None:
        return 1
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def is_worth(program):
    """Return whether a program that is decoded is planned sooner by several cores."""
    is_big = program.block_count > kernel.BLOCK_ROWS
    return is_big and not program.has_threads and _has_rooms(program.machine) and cores() > 1


def _has_rooms(machine):
    """Return whether the rooms of a machine's planner can work side by side: the package's can."""
    return machine.settings.control.kind == "nck"


@contextlib.contextmanager
def beside(wanted=True, machine=None):
    """Give a Pipeline, whose threads end with the context; None on one core, if not wanted, and
    for a machine with another planner than the package's."""
    if not wanted or cores() == 1 or (machine is not None and not _has_rooms(machine)):
        yield None
        return
    with Pipeline() as line:
        yield line


class Pipeline:
    """A plan under way on several cores; of use as a context, which ends its threads.

    Nothing begins before a second piece of the program comes: what is smaller is planned sooner on
    one core.

    Attributes
    ----------
    begun : float
        When it began, by `time.perf_counter` [s].
    is_left : bool
        The program goes round and may never end: it is read first, and planned if it does.
    """

    def __init__(self):
        self.begun, self.is_left, self._used = time.perf_counter(), False, 0
        self._first, self._threads, self._early, self._late = None, [], None, None
        self._is_broken, self._cause = threading.Event(), None
        self._arrays, self._free_arrays = 0, queue.SimpleQueue()
        self._blocks, self._batches = queue.SimpleQueue(), queue.SimpleQueue()
        self._free_batches = queue.SimpleQueue()

    def another(self):
        """Return an array for the next blocks, as `kernel.decode` asks for it."""
        if self._arrays == _ARRAYS:
            return self._free_arrays.get()
        self._arrays += 1
        return kernel.rows_of_blocks()

    def take(self, machine, blocks, used=None):
        """Take the next blocks of a program for a machine: of `another` array, or what stays.

        used: bytes of the text that are read so far; from where they become no more on, the program
        is not planned while it is read. Threads are planned on one core: how long one waits for the
        spindle's angle hangs on every period before it.
        """
        if used is not None:
            self._leave(used)
        if kernel.has_threads(blocks):
            self._is_broken.set()
        if self._first is None:
            self._first = blocks
            return
        if not self._threads:
            self._begin(machine)
            self._blocks.put(self._first)
        self._blocks.put(blocks)

    def _leave(self, used):
        """What has gone round over as many blocks as an array holds may do so for ever."""
        if used <= self._used and self._threads:
            self.is_left = True
            self._is_broken.set()
        self._used = max(self._used, used)

    def end(self):
        """Return the planner of the program, which has ended; None: plan it on one core."""
        if not self._threads:
            return None
        self._join()
        if self._cause is not None:
            raise self._cause
        return None if self._is_broken.is_set() else self._late

    def _begin(self, machine):
        for _ in range(_BATCHES):
            self._free_batches.put(Batch())
        for work in (self._serve_late, self._serve_early):
            thread = threading.Thread(target=work, args=(machine,), daemon=True)
            thread.start()
            self._threads.append(thread)

    def _another_batch(self):
        batch = self._free_batches.get()
        if batch is None:
            raise errors.StateError("broken off")
        return batch

    def _serve_early(self, machine):
        self._try(self._make_early, machine)
        while (blocks := self._blocks.get()) is not None:
            self._try(self._fill, blocks)
            self._free_arrays.put(blocks if blocks.base is None else blocks.base)
        self._try(self._fill, np.empty(0, dtype("nck_block_t")))
        self._batches.put(None)

    def _make_early(self, machine):
        self._early = Early(machine, self._another_batch)

    def _fill(self, blocks):
        for batch in self._early.batches(blocks):
            self._batches.put(batch)

    def _make_late(self, machine):
        self._late = Late(machine)

    def _serve_late(self, machine):
        self._try(self._make_late, machine)
        while (batch := self._batches.get()) is not None:
            self._try(self._take, batch)
            self._free_batches.put(batch)

    def _take(self, batch):
        self._late.take(batch)

    def _try(self, work, *what):
        """Do something, unless the plan is broken off; what goes wrong breaks it off."""
        if self._is_broken.is_set():
            return
        try:
            work(*what)
        except errors.NckError:
            self._is_broken.set()
        except BaseException as cause:
            self._cause = cause
            self._is_broken.set()

    def _join(self):
        self._blocks.put(None)
        for thread in self._threads:
            thread.join()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._is_broken.set()
        self._batches.put(None)
        self._free_batches.put(None)
        self._join()
