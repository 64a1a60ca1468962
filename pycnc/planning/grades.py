# SPDX-License-Identifier: MIT
"""Planning by velocity grades (Cao et al. 2014): its stages, whole programs, and running them.

Arrays in, arrays out; the theory and the costs are in ``docs/grades.md``.
"""

import numpy as np

from pycnc import errors
from pycnc.device import grades as device_grades
from pycnc.kernel.bind import check, ffi, lib, pointer
from pycnc.kernel.records import dtype, join, room
from pycnc.planning.whole import Motion, Simulation, records_of

__all__ = [
    "STEPS", "Grades", "Simulation", "bubble", "bubble_printed", "link_angles", "of_text", "rule",
    "table",
]  # fmt: skip

STEPS = lib.NCK_HOST_GRADE_STEPS  # n: steps of a planning unit at command velocity
_INT32_MAX = 2**31 - 1


def rule(machine, v_command, *, a=None, v_min=0.0, steps=STEPS):
    """Make the numbers of a table of grades.

    Parameters
    ----------
    machine : Machine
        Period, chord error, and the acceleration limits of the axes.
    v_command : float
        Command velocity, the highest grade [mm/s].
    a : float, optional
        Acceleration along the path [mm/s²]; without it the machine's.
    v_min : float
        Speed of grade 0 [mm/s].
    steps : int
        n: interpolation steps of a planning unit at command velocity.

    Returns
    -------
    numpy.ndarray
        (1,) of dtype ``nck_grade_rule_t``.

    Raises
    ------
    ArgumentError
        If a number is NaN, infinite, or outside of its range.
    """
    made = np.zeros(1, dtype("nck_grade_rule_t"))
    a = float(machine.record["path"]["a_max"]) if a is None else a
    status = lib.nck_host_grade_rule(
        machine.pointer, v_command, v_min, a, _steps(steps), pointer("nck_grade_rule_t", made)
    )
    if status == lib.NCK_E_ARGUMENT:
        given = {"v_command": v_command, "v_min": v_min, "a": a, "steps": steps}
        raise errors.ArgumentError(f"no table of grades can be made of {given}", id="argument")
    check(status)
    return made


def _steps(steps):
    if not 1 <= steps <= _INT32_MAX:
        raise errors.ArgumentError(f"steps must be 1 or more, not {steps}", id="argument")
    return int(steps)


def table(made):
    """Return the speeds of all grades of a rule, lowest first [mm/s] (eqs. 8 and 11)."""
    v_max, v_min = float(made["v_max"][0]), float(made["v_min"][0])
    step = 2 * made["a"][0] * made["length"][0]
    grades = np.arange(made["count"][0])
    speeds = np.sqrt(np.minimum(v_min**2 + step * grades, v_max**2))
    speeds[-1] = v_max
    return speeds


def bubble(preplanned, *, method="scan"):
    """Find the largest grades that differ by one at most from point to point.

    Parameters
    ----------
    preplanned : array_like
        (n,) grades that the points may have at most, not negative.
    method : {"scan", "sweeps"}
        The min-plus scan, or the race-free sweeps until one changes nothing. The same grades.

    Returns
    -------
    grades : numpy.ndarray
        (n,) int32.
    sweeps : int
        Sweeps that were made, the last of which changed nothing; 0 for the scan.

    Raises
    ------
    ArgumentError
        At the first grade that is negative or too large, or if they are no whole numbers.

    Examples
    --------
    >>> bubble([1, 5, 2, 5, 3, 1], method="sweeps")
    (array([1, 2, 2, 3, 2, 1], dtype=int32), 2)
    """
    wide = np.atleast_1d(preplanned)
    p = _whole_numbers(wide)
    g, bad, sweeps = np.empty_like(p), ffi.new("size_t *"), ffi.new("size_t *")
    if method == "scan":
        status = lib.nck_host_bubble_scan(
            pointer("int32_t", p), len(p), pointer("int32_t", g), bad
        )
    elif method == "sweeps":
        status = lib.nck_host_bubble_sweeps(
            pointer("int32_t", p), len(p), pointer("int32_t", g),
            pointer("int32_t", np.empty_like(p)), sweeps, bad,
        )  # fmt: skip
    else:
        raise errors.ArgumentError(f"method {method!r}; there are: scan, sweeps", id="argument")
    if status == lib.NCK_E_ARGUMENT:
        raise errors.ArgumentError(
            f"index {bad[0]}: grade {wide[bad[0]]} is negative or too large", id="argument"
        )
    check(status)
    return g, int(sweeps[0])


def _whole_numbers(array):
    """Return grades as int32; what is too large or negative stays so."""
    if array.dtype == np.int32:
        return np.ascontiguousarray(array)
    if len(array) and array.dtype.kind not in "iu":
        raise errors.ArgumentError(f"grades are whole numbers, not {array.dtype}", id="argument")
    return np.clip(array, -1 if array.dtype.kind == "i" else 0, _INT32_MAX).astype(np.int32)


def bubble_printed(preplanned, orders, most=1000):
    """Demonstrate the defect of the bubble as it is printed: not for planning.

    Parameters
    ----------
    preplanned : array_like
        (n,) grades.
    orders : callable
        ``orders(k)`` gives the order in which the writes of the n − 1 pairs arrive in step k.
    most : int
        Steps after which it counts as never ending.

    Yields
    ------
    numpy.ndarray
        (n,) grades after each step; the last two are equal if it stopped. They may be wrong.
    """
    g = np.array(preplanned, np.int32)
    for k in range(most):
        order, after = np.ascontiguousarray(orders(k), np.uint32), np.empty_like(g)
        if sorted(order.tolist()) != list(range(len(g) - 1)):
            raise errors.ArgumentError("an order names every pair once", id="argument")
        changed = lib.nck_host_bubble_printed(
            pointer("int32_t", g), len(g), pointer("uint32_t", order), pointer("int32_t", after)
        )
        yield after
        if not changed:
            return
        g = after


def link_angles(segs):
    """Return the linking vector angle between each seg and the next one (eqs. 1 to 5).

    Parameters
    ----------
    segs : numpy.ndarray
        (n,) of dtype ``nck_seg_t``, moves all.

    Returns
    -------
    numpy.ndarray
        (n − 1,) angles, 0 … π [rad].
    """
    segs = join("nck_seg_t", [segs])
    at, junctions = pointer("nck_seg_t", segs), range(max(0, len(segs) - 1))
    return np.array([lib.nck_host_link_angle(at + k, at + k + 1) for k in junctions])


class Grades(Motion):
    """A path planned by grades.

    Parameters
    ----------
    segs : numpy.ndarray
        Of dtype ``nck_seg_t``, the whole path.
    machine : Machine
    outputs : numpy.ndarray, optional
        Of dtype ``nck_output_t``: what the path hands over on its way.
    steps : int
        n of eq. 10.
    backend : {"auto", "c", "opencl"}
        Where the four parallel stages run. The bits are the same; ``auto`` is C, which measured
        no slower than a device of the same cores (docs/grades.md).

    Attributes
    ----------
    backend : str
        Where they ran.
    stretches : numpy.ndarray
        Of dtype ``nck_host_stretch_t``: from rest to rest, with the rule of each.
    units : numpy.ndarray
        Of dtype ``nck_unit_t``.
    v, n_step, unit_limit, a : numpy.ndarray
        Of every unit: speed inside [mm/s], steps, what bound it (``nck_limit_t``), acceleration
        between its ends [mm/s²].
    v_transfer, angle, preplanned, grade : numpy.ndarray
        Of every point, one more a stretch than it has units: cap [mm/s], linking vector angle
        [rad], grade before and after the bubble.
    v_command : numpy.ndarray
        Of every seg [mm/s].

    Raises
    ------
    ArgumentError
        At the first seg with a number that is NaN, infinite, negative or missing; or if the plan
        does not fit into memory. Nothing is planned by half.
    DeviceError
        If OpenCL was asked for and is not here, or fails.
    """

    slope = "linear"  # the others' filter would blur the plan

    def __init__(self, segs, machine, outputs=None, *, steps=STEPS, backend="auto"):
        super().__init__(segs, machine, outputs)
        self._plan = ffi.new("nck_host_grades_t *")
        self._plan.machine, self._plan.steps = machine.pointer, _steps(steps)
        self._give("segs", "nck_seg_t", self.segs)
        self._plan.seg_count = len(self.segs)
        self._make("v_command", "double", len(self.segs))
        self._make("limit", "uint8_t", len(self.segs))
        self._check(lib.nck_host_grade_command(self._plan))
        self._fill("stretch", "stretches", lib.nck_host_grade_stretches)
        self._fill("unit", "units", lib.nck_host_grade_divide)
        units, points = len(self.units), len(self.units) + len(self.stretches)
        for name, kind in _OF_UNITS.items():
            self._make(name, kind, units)
        for name, kind in _OF_POINTS.items():
            self._make(name, kind, points)
        self.backend = "opencl" if backend == "opencl" and units else "c"
        if self.backend == "opencl":
            done = device_grades.plan_grades(self.segs, self.units, self.stretches)
            for name in (*_OF_UNITS, *_OF_POINTS):
                getattr(self, name)[:] = getattr(done, name)
        else:
            self._check(lib.nck_host_grade_plan(self._plan))

    def _give(self, name, kind, array):
        setattr(self._plan, name, pointer(kind, array))

    def _make(self, name, kind, count):
        """Make an array of a stage."""
        remedy = "give more steps to a planning unit, or plan the program in parts"
        setattr(self, name, room(name, count, kind, remedy))
        self._give(name, kind, getattr(self, name))

    def _fill(self, noun, name, stage):
        """Count with a stage, make room, and let it fill that."""
        status = stage(self._plan)
        if status == lib.NCK_FULL:
            kind = {"stretches": "nck_host_stretch_t", "units": "nck_unit_t"}[name]
            self._make(name, kind, getattr(self._plan, f"{noun}_count"))
            setattr(self._plan, f"{noun}_max", len(getattr(self, name)))
            status = stage(self._plan)
        elif status == lib.NCK_OK:
            setattr(self, name, np.zeros(0, dtype("nck_unit_t")))
        self._check(status)

    def _check(self, status):
        if status != lib.NCK_E_ARGUMENT:
            return check(status)
        bad = self._plan.bad
        if bad >= len(self.segs):
            raise errors.ArgumentError("the path has 2³¹ planning units or more", id="memory")
        line = int(self.segs["line"][bad])
        raise errors.ArgumentError(
            f"seg {bad} (line {line}): a number is NaN, infinite, negative or missing",
            id="argument", status=status, line=line,
        )  # fmt: skip

    @property
    def count(self):
        """How many units it has."""
        return len(self.units)

    def _walk(self):
        cursor = ffi.new("nck_host_grade_cursor_t *")
        cursor.grades = self._plan
        return "nck_host_grade_next", cursor

    def holds(self):
        """Return whether every invariant of the plan holds."""
        return bool(lib.nck_host_grade_invariants(self._plan))

    def __repr__(self):
        return f"<Grades: {len(self.units):,} units in {len(self.stretches):,} stretches>"


_OF_UNITS = {"v": "double", "n_step": "uint32_t", "unit_limit": "uint8_t", "a": "double"}
_OF_POINTS = {
    "v_transfer": "double", "angle": "double", "preplanned": "int32_t", "grade": "int32_t",
}  # fmt: skip


def of_text(text, machine, *, steps=STEPS, backend="auto", threads=False, progress=None):
    """Plan a whole NC text by grades.

    Parameters
    ----------
    text : bytes
        Without errors.
    machine : Machine
    steps : int
        n of eq. 10.
    backend : {"auto", "c", "opencl"}
        As for `Grades`.
    threads : bool
        As for `kernel.Planner`: of the exact plan alone.
    progress : callable, optional
        Called with (bytes used, bytes of the text).

    Returns
    -------
    grades : Grades
    exact : numpy.void
        Of dtype ``nck_host_totals_t``: the same program planned by the exact envelope.
    """
    (segs, outputs), exact = records_of(
        text, machine, ("seg", "output"), threads=threads, progress=progress
    )
    return Grades(segs, machine, outputs, steps=steps, backend=backend), exact
