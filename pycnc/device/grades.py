# SPDX-License-Identifier: MIT
"""Planning by grades on an OpenCL device: bubble, scan, and all stages of the papers at once."""

import dataclasses

import numpy as np

from pycnc import device, errors
from pycnc.device import launch

# Grades are below, as in bubble.cl and scan.cl.
NO_LIMIT = 0x3FFFFFFF
# Points of one work-item of the fused sweeps, as in bubble.cl.
FUSED_POINTS = 1024
# Work-items of a group where one of them does one item.
GROUP = 64


def _check_grades(grades):
    if grades.dtype != np.int32 or grades.ndim != 1 or not grades.flags.c_contiguous:
        raise errors.ArgumentError("grades must be int32, contiguous, of one dimension")
    bits = grades.view(np.uint32)  # a negative grade is a large number there
    if bits.max(initial=0) >= NO_LIMIT:
        bad = np.argmax(bits >= NO_LIMIT)
        raise errors.ArgumentError(f"index {bad}: a grade is below 0 or above {NO_LIMIT - 1}")


def _sweep_until_settled(session, name, points, buffers, grid):
    """Launch until nothing changes; return the buffer with the grades and the launches."""
    changed = session.buffer(np.zeros(1, np.int32), written=True)
    flag = np.ones(1, np.int32)
    (before, n), launches = points, 0
    after, spare = buffers
    while True:
        session.cl.enqueue_fill_buffer(session.queue, changed, np.int32(0), 0, 4)
        arguments = (points[0], before, np.int64(n), after, changed)
        session.launch(("bubble", name, "float"), arguments, *grid)
        session.cl.enqueue_copy(session.queue, flag, changed)
        launches += 1
        if not flag[0]:
            return after, launches
        before, after, spare = after, spare, after


def bubble(grades, method="scan", name=None, out=None):
    """Let grades sink until neighbours differ by one at most (Cao et al. 2014, section 7).

    Parameters
    ----------
    grades : numpy.ndarray
        (n,) int32, preplanned grade of every point, 0 to ``NO_LIMIT - 1``.
    method : {"scan", "sweep", "fused"}
        One exact scan; one launch for every sweep, as the paper has it; or 16 sweeps in a launch.
    name : str or Device, optional
        As for `device.choose`.
    out : numpy.ndarray, optional
        (n,) int32 to fill.

    Returns
    -------
    settled : numpy.ndarray
        (n,) int32; the same for every method.
    launches : int
        Kernels launched, the last of which, but for the scan, changed nothing.

    Raises
    ------
    DeviceError, ArgumentError

    Examples
    --------
    >>> settled, _ = bubble(np.array([1, 5, 2, 5, 3, 1], np.int32))
    >>> settled
    array([1, 2, 2, 3, 2, 1], dtype=int32)
    """
    _check_grades(grades)
    session = device.in_use(name)
    n = len(grades)
    settled = device.empty(n, np.int32) if out is None else out
    if settled.shape != grades.shape or settled.dtype != np.int32:
        raise errors.ArgumentError(f"out must be int32 of shape {grades.shape}")
    if n == 0:
        return settled, 0
    if method not in ("scan", "sweep", "fused"):
        raise errors.ArgumentError(f"method {method!r} is none of scan, sweep, fused")
    try:
        with session.lock:
            return settled, _settle(session, method, grades, settled)
    except session.cl.Error as cause:
        raise session.lost(cause) from cause


def _settle(session, method, grades, settled):
    """Fill settled; return the launches."""
    n = len(grades)
    p = session.buffer(grades)
    first = session.buffer(settled, written=True)
    if method == "scan":
        _launch_scan(session, p, n, first)
        session.read(first, settled)
        return 1
    second = session.room(n, np.int32)
    grid = (n, GROUP) if method == "sweep" else (-(-n // FUSED_POINTS), 1)
    last, launches = _sweep_until_settled(
        session, f"bubble_{method}", (p, n), (first, second), grid
    )
    session.cl.enqueue_copy(session.queue, settled, last)
    return launches


def _launch_scan(session, p, n, settled):
    arguments = (p, np.int64(n), settled)
    session.launch(("scan", "scan", "float"), arguments, launch.parts(session.device, n))


@dataclasses.dataclass(frozen=True)
class GradeArrays:
    """A plan by grades as the device left it; arrays as in ``nck_host_grades_t``."""

    v: np.ndarray
    n_step: np.ndarray
    unit_limit: np.ndarray
    a: np.ndarray
    v_transfer: np.ndarray
    angle: np.ndarray
    preplanned: np.ndarray
    grade: np.ndarray


def plan_grades(segs, units, stretches, name=None):
    """Run the papers' four parallel stages on a device, with no trip to the host between them.

    Speed inside the units, transfer speeds, grades, bubble, and the accelerations that follow.

    Parameters
    ----------
    segs, units, stretches : numpy.ndarray
        Of dtypes ``nck_seg_t``, ``nck_unit_t``, ``nck_host_stretch_t``, as the division into units
        left them; at least one unit.
    name : str or Device, optional
        As for `device.choose`.

    Returns
    -------
    GradeArrays
        The bits of ``nck_host_grade_plan``.

    Raises
    ------
    DeviceError
    """
    session = device.in_use(name)
    counts = (stretches["unit_end"] - stretches["unit_begin"]).astype(np.int64)
    numbers = np.arange(len(stretches), dtype=np.uint32)
    try:
        with session.lock:
            return _plan_grades(
                session, segs, units, np.ascontiguousarray(stretches["rule"]),
                np.repeat(numbers, counts), np.repeat(numbers, counts + 1),
            )  # fmt: skip
    except session.cl.Error as cause:
        raise session.lost(cause) from cause


def _plan_grades(session, segs, units, rules, unit_stretch, point_stretch):
    n, points = np.uint64(len(unit_stretch)), np.uint64(len(point_stretch))
    plan = GradeArrays(
        *(np.empty(n, dtype) for dtype in (np.float64, np.uint32, np.uint8, np.float64)),
        *(np.empty(points, dtype) for dtype in (np.float64, np.float64, np.int32, np.int32)),
    )
    inputs = (segs, units, rules, unit_stretch, point_stretch)
    segs, units, rules, unit_stretch, point_stretch = map(session.buffer, inputs)
    fields = [getattr(plan, field.name) for field in dataclasses.fields(plan)]
    outputs = [session.buffer(each, written=True) for each in fields]
    v, n_step, limit, a, v_transfer, angle, preplanned, grade = outputs

    def stage(program, kernel, items, *arguments):
        session.launch((program, kernel, "double"), arguments, int(items), GROUP)

    stage("unit", "unit_speed", n, segs, units, rules, unit_stretch, n, v, n_step, limit)
    stage("transfer", "transfer", points, segs, units, v, rules, point_stretch, points,
          v_transfer, angle)  # fmt: skip
    stage("grade", "grade", points, rules, point_stretch, v_transfer, points, preplanned)
    _launch_scan(session, preplanned, int(points), grade)
    stage("grade", "acceleration", n, rules, units, unit_stretch, grade, n, a)
    for buffer, array in zip(outputs, fields, strict=True):
        session.read(buffer, array)
    return plan


def layout(name=None):
    """Return how a device lays out the records: offsets of all fields, then the size.

    Parameters
    ----------
    name : str or Device, optional
        As for `device.choose`.

    Returns
    -------
    dict of str to list of int
        Of ``nck_seg_t``, ``nck_unit_t`` and ``nck_grade_rule_t``, as the kernel layout tells them.
    """
    session = device.in_use(name)
    names = ("nck_seg_t", "nck_unit_t", "nck_grade_rule_t")
    unset = np.uint64(2**64 - 1)
    arrays = [np.full(64, unset) for _ in names]
    try:
        buffers = [session.buffer(each, written=True) for each in arrays]
        session.launch(("layout", "layout", "double"), buffers, 1)
        for buffer, array in zip(buffers, arrays, strict=True):
            session.read(buffer, array)
    except session.cl.Error as cause:
        raise session.lost(cause) from cause
    told = (array[array != unset].tolist() for array in arrays)
    return dict(zip(names, told, strict=True))
