# SPDX-License-Identifier: MIT
"""How far the path that was run and the program are apart, both ways: a door to C.

From the run to the program (csrc/host/path_error.h): the distance of every setpoint from the
programmed moves. From the program to the run (csrc/host/path_miss.h): the distance of every corner
of the program, and of points on its arcs, from the path that the kernel made, in closed form: ticks
do not come into it, so nothing is lost between them. The second way sees a tip that is cut off,
where the two lines of a spike are nearly one.

Both work through the program in fixed memory. What is further away along the path than their rings
reach does not count: half of `_MOVES` moves, a quarter of `_SEGS` segs.
"""

import numpy as np

from pycnc.kernel.bind import check, ffi, lib, pointer
from pycnc.kernel.records import dtype

_MOVES, _MARKS, _SEGS = 32768, 8192, 16384  # rows of the rings


class PathError:
    """Largest distance of the path run from the program, and of the program from that path.

    Parameters
    ----------
    program : Program
    """

    def __init__(self, program):
        self._error, self._miss = _Way(program, "error"), _Way(program, "miss")
        self._error.ring("move", _MOVES)
        self._miss.ring("mark", _MARKS)
        self._miss.ring("seg", _SEGS)
        lib.nck_host_path_error_init(self._error.state, program.machine.pointer)
        most = program.tolerance_most_mm
        lib.nck_host_path_miss_init(self._miss.state, program.machine.pointer, most)

    @property
    def largest_mm(self):
        """The larger of both ways [mm]."""
        return max(self._error.state.largest, self._miss.state.largest)

    @property
    def missed(self):
        """How far the path misses a point of the program at most, as a share of the tolerance in
        force there; 0 where there is none."""
        return self._miss.state.missed

    def add(self, rows):
        """Measure the next rows of a run (dtype ``sim_row_t``) against the program."""
        self._error.add(lib.nck_host_path_error_add, "nck_pose_t", rows["pose"])

    def add_segs(self, segs):
        """Measure the program against the next segs of its path (dtype ``nck_seg_t``)."""
        self._miss.add(lib.nck_host_path_miss_add, "nck_seg_t", segs)

    def finish_segs(self):
        """There are no more segs: measure what is left of the program."""
        self._miss.end(lib.nck_host_path_miss_end)


class _Way:
    """A measurement in C, which asks for the program's blocks as it goes along."""

    def __init__(self, program, name):
        self.state = ffi.new(f"nck_host_path_{name}_t *")
        self._blocks, self._piece, self._rings = program.pieces(), None, []

    def ring(self, name, rows):
        """Give it memory for rows of a record."""
        record = "nck_seg_t" if name == "seg" else f"nck_host_{name}_t"
        self._rings.append(np.empty(rows, dtype(record)))
        setattr(self.state, f"{name}s", pointer(record, self._rings[-1]))
        setattr(self.state, f"{name}_max", rows)

    def add(self, call, record, rows):
        """Hand over rows of a record."""
        rows, used, done = np.require(rows, requirements="C"), ffi.new("size_t *"), 0
        first = pointer(record, rows)
        while done < len(rows):
            status = call(self.state, first + done, len(rows) - done, used)
            done += used[0]
            self._feeds(status)

    def end(self, call):
        """No rows follow."""
        while self._feeds(call(self.state)):
            pass

    def _feeds(self, status):
        """Return whether it wants the next blocks, and has them then."""
        if check(status) != lib.NCK_EMPTY:
            return False
        self._piece = next(self._blocks, None)
        count = 0 if self._piece is None else len(self._piece)
        blocks = pointer("nck_block_t", self._piece)
        lib.nck_host_course_give(ffi.addressof(self.state, "course"), blocks, count)
        return True
