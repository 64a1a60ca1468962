# SPDX-License-Identifier: MIT
"""What the axes feel: acceleration and jerk of every tick, the least and largest of each bin.

    ticks of the simulation ─▶ differences ─▶ least and largest of 1, 2, 4 … ticks ─▶ columns

They are those of the setpoints, as ``run`` measures them: nothing here asks the planner.
"""

import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from pycnc.planning import control, measure, stretches

BINS = 1 << 16  # of a page at most; of a longer run a bin holds twice, four times … as many ticks
PACKED_MOST = 700_000  # bytes of all columns; above it bins are joined, too
_STEP = 1e-3  # of the limit: so exactly a value is told


class Bins:
    """The least and the largest of rows of numbers, of bins of equally many rows.

    Parameters
    ----------
    width : int
        Numbers of a row.
    most : int
        Bins at most, an even number.

    Attributes
    ----------
    size : int
        Rows of a bin, a power of two.

    Examples
    --------
    >>> bins = Bins(1, 2)
    >>> bins.add(np.array([[3.0], [-1.0], [2.0]]))
    >>> bins.size, bins.ends()[0][:, 0].tolist(), bins.ends()[1][:, 0].tolist()
    (2, [-1.0, 2.0], [3.0, 2.0])
    """

    def __init__(self, width, most):
        self._most, self.size, self._count = most, 1, 0
        self._least = np.full((most, width), np.inf)
        self._largest = np.full((most, width), -np.inf)

    def add(self, rows):
        """Take the next rows."""
        done = 0
        while done < len(rows):
            if self._count == self._most * self.size:
                self.join()
            some = rows[done : done + self._most * self.size - self._count]
            bins = (self._count + np.arange(len(some))) // self.size
            at, first = np.unique(bins, return_index=True)
            least, largest = (how.reduceat(some, first) for how in (np.minimum, np.maximum))
            self._least[at] = np.minimum(self._least[at], least)
            self._largest[at] = np.maximum(self._largest[at], largest)
            done, self._count = done + len(some), self._count + len(some)

    def join(self):
        """Make one bin of two."""
        half = self._most // 2
        self._least[:half] = np.minimum(self._least[0::2], self._least[1::2])
        self._largest[:half] = np.maximum(self._largest[0::2], self._largest[1::2])
        self._least[half:], self._largest[half:] = np.inf, -np.inf
        self.size *= 2

    def ends(self):
        """Return the least and the largest numbers, a row for each bin."""
        used = -(-self._count // self.size)
        return self._least[:used], self._largest[:used]


class Felt:
    """Acceleration and jerk of the axes and of the path, of a run that is made beside the plan.

    Parameters
    ----------
    program : Program
        Of another control's accelerations, and no jerk.
    """

    def __init__(self, program):
        self._program, machine = program, program.machine
        self._derivatives, self._period = measure.Derivatives(machine), machine.period_s
        path = machine.record["path"]
        self.tracks = [*machine.axes, "path"]
        limits = [np.append(machine.limits(f"{kind}_max"), path[f"{kind}_max"]) for kind in "aj"]
        self._kinds = "aj"
        if control.is_foreign(machine):
            self._kinds, limits = "a", [stretches.limits_of(machine)[1]]
        self._limits = np.concatenate(limits).astype(float)
        self._bins = Bins(len(self._limits), BINS)
        self._stop = threading.Event()

    def beside(self, work):
        """Run the program on a second thread while `work` is done; return what that returns."""
        with ThreadPoolExecutor(1) as other:
            run = other.submit(self._run)
            try:
                done = work()
            except BaseException:
                self._stop.set()
                raise
            run.result()
        return done

    def _run(self):
        program = self._program
        for rows, _ in stretches.simulation(program).pieces():
            _, *rates = self._derivatives.of(rows)
            self._bins.add(np.hstack(rates))
            if self._stop.is_set():
                return

    def add_to(self, columns):
        """Add the columns to those of a page; return what the page has to know of them.

        ``felt_x_a`` and ``felt_x_j`` are the least of each bin, in thousandths of X's limit,
        ``felt_x_a_span`` tells by how much the largest is more.
        """
        names = [f"felt_{track}_{kind}" for kind in self._kinds for track in self.tracks]
        while True:
            before = columns.packed
            least, largest = (np.rint(end / (_STEP * self._limits)) for end in self._bins.ends())
            for k, name in enumerate(names):
                columns.steps(name, least[:, k], _STEP)
                columns.steps(f"{name}_span", largest[:, k] - least[:, k], _STEP)
            columns.close()
            if columns.packed - before <= PACKED_MOST or self._bins.size >= BINS:
                break
            for name in names:
                columns.drop(name)
                columns.drop(f"{name}_span")
            self._bins.join()
        return self._facts(len(least))

    def _facts(self, count):
        half = len(self.tracks)
        least, largest = self._bins.ends()
        moves = np.any(np.maximum(np.abs(least), np.abs(largest)) > 0, axis=0)
        return {
            "bin_s": self._bins.size * self._period,
            "bins": count,
            "kinds": list(self._kinds),
            "tracks": [
                {"name": track, **{kind: self._limits[k + half * order]
                                   for order, kind in enumerate(self._kinds)}}
                for k, track in enumerate(self.tracks)
                if moves[k] and np.isfinite(self._limits[k])
            ],
        }
