# SPDX-License-Identifier: MIT
"""The rooms of the kernel one by one: arrays in, arrays out."""

import numpy as np

from pycnc import errors, kernel
from pycnc.kernel.bind import check, ffi, lib, pointer
from pycnc.planning.parallel import Keinert, envelope, keinert
from pycnc.kernel.records import copied, dtype, join, room

__all__ = ["JerkPlanner", "Keinert", "Profile", "decode", "envelope", "keinert", "slope"]


def decode(text, machine):
    """Room 1: NC text to blocks.

    Parameters
    ----------
    text : bytes
    machine : Machine

    Returns
    -------
    blocks : numpy.ndarray
        Of dtype ``nck_block_t``: targets in nm or ndeg, machine coordinates of the tool tip.
    diagnostics : numpy.ndarray
        Of dtype ``nck_diagnostic_t``: every error and note.
    """
    blocks, diagnostics = [], []
    for some_blocks, some_diagnostics, _ in kernel.decode(text, machine):
        blocks.append(copied(some_blocks))
        diagnostics.append(copied(some_diagnostics))
    return join("nck_block_t", blocks), join("nck_diagnostic_t", diagnostics)


# Periods that a cell of a jerk-limited profile lasts about, and for how many more it is tried where
# so short a step is lost in rounding on a long path.
STEPS = (0.125, 0.25, 0.5, 1, 2, 4)
LADDER_ROUNDS = 2  # times that long cells are divided
RAMPS = {
    "linear": lib.NCK_HOST_RAMP_LINEAR,
    "sshape": lib.NCK_HOST_RAMP_SSHAPE,
    "whole": lib.NCK_HOST_RAMP_WHOLE,
    "fixed": lib.NCK_HOST_RAMP_FIXED,
}


class Profile:
    """Speed over time along a path, from :func:`slope`.

    Attributes
    ----------
    v_node : numpy.ndarray
        (n + 1,) speeds at the junctions [mm/s].
    cells : numpy.ndarray
        Of dtype ``nck_cell_t``: stretches of constant jerk; ``seg`` is the segment's index.
    segment_s : numpy.ndarray
        (n,) time of every segment [s].
    time_s : float
        Time of all [s].
    """

    def __init__(self, v_node, cells):
        self.v_node, self.cells = v_node, cells
        segments = len(v_node) - 1
        self.segment_s = np.bincount(cells["seg"], cells["duration"], minlength=segments)
        self.time_s = float(self.segment_s.sum())

    def __repr__(self):
        fastest = max(self.cells["v"].max(initial=0.0), self.v_node.max(initial=0.0))
        return (
            f"<Profile of {len(self.segment_s):,} segments: {self.time_s:.3f} s, up to "
            f"{fastest:.6g} mm/s, {len(self.cells):,} cells>"
        )

    def _repr_html_(self):
        from pycnc.program import shown

        facts = {
            "time [s]": f"{self.time_s:.6g}", "segments": f"{len(self.segment_s):,}",
            "cells": f"{len(self.cells):,}",
            "slowest segment": f"{int(self.segment_s.argmax())} "
            f"({self.segment_s.max():.6g} s)" if len(self.segment_s) else "",
        }  # fmt: skip
        return shown.facts_table(facts.items())

    def sample(self, period_s):
        """Return (s, v, a) at t = 0, period_s, 2 period_s … and once at or behind the end.

        Parameters
        ----------
        period_s : float
            Between two samples [s], positive.

        Returns
        -------
        tuple of numpy.ndarray
            Path coordinate [mm], speed [mm/s] and acceleration [mm/s²]. At a step of acceleration
            the later value.
        """
        if not (np.isfinite(period_s) and period_s > 0):
            raise errors.ArgumentError(f"period_s is {period_s}, must be positive", id="argument")
        rows = int(np.ceil(self.time_s / period_s)) + 1
        s, v, a = room("the samples", 3 * rows, "double", "give a longer period_s").reshape(3, rows)
        places = [pointer("double", each) for each in (s, v, a)]
        samples = ffi.new("nck_host_samples_t *", [period_s, rows, *places])
        lib.nck_host_slope_sample(pointer("nck_cell_t", self.cells), len(self.cells), samples)
        return s, v, a


def _raise_argument(status, bad):
    if status == lib.NCK_E_ARGUMENT:
        message = f"index {bad}: a number is NaN, infinite or outside of its range"
        raise errors.ArgumentError(message, id="argument", status=status)
    check(status)


def _path(arrays):
    path = ffi.new("nck_host_path_t *", {k: pointer("double", x) for k, x in arrays.items()})
    path.n = len(arrays["length"])
    return path


def _slope(arrays, kind, lookahead, ramp_s):
    path, n = _path(arrays), len(arrays["length"])
    path.kind, path.ramp_s = RAMPS[kind], ramp_s
    path.lookahead = n if lookahead is None else min(int(lookahead), n)
    v_out, cells = np.empty(n + 1), np.empty(lib.NCK_HOST_SLOPE_CELLS * n, dtype("nck_cell_t"))
    count, bad = ffi.new("size_t *"), ffi.new("size_t *")
    status = lib.nck_host_slope(
        path, pointer("double", v_out), pointer("nck_cell_t", cells), count, bad
    )
    _raise_argument(status, bad[0])
    return Profile(v_out, cells[: count[0]].copy())


class JerkPlanner:
    """A path and the arrays that its jerk-limited profile needs: planned once or many times.

    Parameters
    ----------
    arrays : dict
        length, v_cap, a_max, j_max, v_node as :func:`slope` takes them, float64.
    period_s, step_s, j_scale : float, float or None, float
        As there.

    Attributes
    ----------
    arguments : tuple
        What ``nck_host_jerk`` takes: path, settings and area.
    """

    def __init__(self, arrays, period_s, step_s, j_scale):
        self._path, self._how = _path(arrays), ffi.new("nck_host_jerk_t *")
        self._steps = [step_s] if step_s is not None else [share * period_s for share in STEPS]
        self._how.period_s, self._how.step_s, self._how.j_scale = period_s, self._steps[0], j_scale
        self._how.rounds = LADDER_ROUNDS
        self._v_out = np.empty(len(arrays["v_node"]))
        self._make_room(4 * len(arrays["length"]) + 2048)

    def _make_room(self, nodes):
        remedy = "give a longer period_s or step_s, or plan the path in parts, between its stops"
        self._work = room("the profile", lib.nck_host_jerk_bytes(nodes), "uint8_t", remedy)
        self._cells = room("the profile", nodes, "nck_cell_t", remedy)
        area = ffi.new("nck_host_jerk_area_t *", {"nodes": nodes})
        area.work = ffi.from_buffer(self._work)
        area.v_node = pointer("double", self._v_out)
        area.cells = pointer("nck_cell_t", self._cells)
        self.arguments = (self._path, self._how, area)

    def profile(self):
        """Plan; return the Profile."""
        for self._how.step_s in self._steps:
            status, count, bad = self._plan()
            if status not in (lib.NCK_E_STATE, lib.NCK_FULL):
                break
        if status == lib.NCK_FULL:
            raise errors.ArgumentError(
                f"the profile has more than {lib.NCK_HOST_JERK_NODES:,} nodes: give a longer "
                "period_s or step_s, or plan the path in parts, between its stops",
                id="memory",
            )
        if status == lib.NCK_E_STATE:
            raise errors.ArgumentError(
                f"segment {bad} would never be passed at a period of {self._how.period_s:g} s: "
                "a step is lost in rounding on so long a path; give a longer step_s, or plan the "
                "path in parts",
                id="period", status=status,
            )  # fmt: skip
        _raise_argument(status, bad)
        return Profile(self._v_out.copy(), self._cells[:count].copy())

    def _plan(self):
        """Return what ``nck_host_jerk`` returns, the cells and the index of a bad segment."""
        count, bad = ffi.new("size_t *"), ffi.new("size_t *")
        status = lib.nck_host_jerk(*self.arguments, count, bad)
        while status == lib.NCK_FULL and count[0] <= lib.NCK_HOST_JERK_NODES:
            more = count[0] + count[0] // 4  # the next round divides some
            self._make_room(max(count[0], min(more, lib.NCK_HOST_JERK_NODES)))
            status = lib.nck_host_jerk(*self.arguments, count, bad)
        return status, count[0], bad[0]


def slope(length_mm, v_cap, a_max, j_max, v_node, *, kind="linear", lookahead=None, ramp_s=1.0,
          period_s=1e-3, step_s=None, j_scale=0.0):  # fmt: skip
    """Room 5 over a whole path: the kernel's jerk-limited profile, or one of Cao et al. 2014.

    The first has no filter, so each segment keeps its limits. The others plan `lookahead` segments
    beyond the one in work and assume rest at their end; they are for comparison with the paper.

    Parameters
    ----------
    length_mm : array_like
        (n,) lengths of the segments [mm], positive.
    v_cap : array_like
        Cap inside of every segment [mm/s], one number or (n,), positive.
    a_max, j_max : array_like
        Tangential acceleration [mm/s²] and jerk [mm/s³], one number or (n,), positive. j_max is
        for "jerk" and "sshape" only and may be None otherwise.
    v_node : array_like
        (n + 1,) cap at every junction, start and end included [mm/s], not negative.
    kind : {"linear", "jerk", "sshape", "whole", "fixed"}
        How speed changes: constant acceleration; within a_max and j_max, acceleration carried
        across junctions, from rest to rest; S-shaped within a_max and j_max; one symmetric S
        over every whole segment, within a_max; every ramp lasts ramp_s (look-ahead 0 only).
    lookahead : int, optional
        Segments seen beyond the one in work; None: all. 0: a stop at the end of every segment.
    ramp_s : float
        Duration of every ramp of the kind "fixed" [s], positive.
    period_s : float
        Kind "jerk": at samples of that period [s] j_max holds.
    step_s : float, optional
        Kind "jerk": how long a cell lasts about [s], at most four periods. None: an eighth of one,
        or as often twice that as so long a path asks for.
    j_scale : float
        Kind "jerk": share of j_max to plan with, 0 … 1. 0: as much as holds at every sample.

    Returns
    -------
    Profile

    Raises
    ------
    ArgumentError
        If a number is outside of its range (the first such index is told) or shapes do not fit. Id
        "memory": there would be too many cells; "period": a segment would never be passed.

    Examples
    --------
    >>> slope([4.0, 4.0], 10.0, 2.0, None, [0.0, 10.0, 0.0]).v_node
    array([0., 4., 0.])
    """
    arrays = checked_path(length_mm, v_cap, a_max, j_max, v_node)
    if kind == "jerk":
        if lookahead is not None:
            raise errors.ArgumentError('kind "jerk" sees the whole path', id="lookahead")
        return JerkPlanner(arrays, period_s, step_s, j_scale).profile()
    if kind not in RAMPS:
        kinds = ", ".join([*RAMPS, "jerk"])
        raise errors.ArgumentError(f"kind {kind!r} is not one of {kinds}", id="kind")
    if lookahead is not None and lookahead < 0:
        raise errors.ArgumentError(f"lookahead is {lookahead}, must not be negative")
    return _slope(arrays, kind, lookahead, ramp_s)


def checked_path(length_mm, v_cap, a_max, j_max, v_node):
    """Return the arrays of a path as C reads them, name → float64."""
    lengths, nodes = (np.ascontiguousarray(x, np.float64) for x in (length_mm, v_node))
    if lengths.ndim != 1 or lengths.size == 0 or nodes.shape != (lengths.size + 1,):
        raise errors.ArgumentError(f"{lengths.shape} segments and {nodes.shape} nodes do not fit")
    arrays = {"length": lengths, "v_node": nodes}
    for name, numbers in (("v_cap", v_cap), ("a_max", a_max), ("j_max", j_max)):
        given = np.broadcast_to(np.nan if numbers is None else numbers, lengths.shape)
        arrays[name] = np.ascontiguousarray(given, np.float64)
    return arrays
