# SPDX-License-Identifier: MIT
"""The rooms of the kernel one by one: arrays in, arrays out."""

import numpy as np

from pycnc import errors, kernel
from pycnc._bind import check, ffi, lib, pointer
from pycnc.parallel import Keinert, envelope, keinert
from pycnc.records import dtype, join

__all__ = ["Keinert", "Profile", "decode", "envelope", "keinert", "slope"]


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
        blocks.append(some_blocks.copy())
        diagnostics.append(some_diagnostics.copy())
    return join("nck_block_t", blocks), join("nck_diagnostic_t", diagnostics)


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
        s, v, a = np.empty((3, rows))
        lib.nck_host_slope_sample(
            pointer("nck_cell_t", self.cells), len(self.cells), period_s, rows,
            pointer("double", s), pointer("double", v), pointer("double", a),
        )  # fmt: skip
        return s, v, a


def _slope(arrays, kind, lookahead, ramp_s):
    n = len(arrays["length"])
    path = ffi.new("nck_host_path_t *", {k: pointer("double", x) for k, x in arrays.items()})
    path.n, path.kind, path.ramp_s = n, RAMPS[kind], ramp_s
    path.lookahead = n if lookahead is None else min(int(lookahead), n)
    v_out, cells = np.empty(n + 1), np.empty(lib.NCK_HOST_SLOPE_CELLS * n, dtype("nck_cell_t"))
    count, bad = ffi.new("size_t *"), ffi.new("size_t *")
    status = lib.nck_host_slope(
        path, pointer("double", v_out), pointer("nck_cell_t", cells), count, bad
    )
    if status == lib.NCK_E_ARGUMENT:
        message = f"index {bad[0]}: a number is NaN, infinite or outside of its range"
        raise errors.ArgumentError(message, id="argument", status=status)
    check(status)
    return Profile(v_out, cells[: count[0]].copy())


def slope(length_mm, v_cap, a_max, j_max, v_node, *, kind="linear", lookahead=None, ramp_s=1.0):
    """Room 5 as Cao et al. 2014 have it: a profile with N look-ahead segments.

    Planning looks `lookahead` segments beyond the one in work and assumes rest at the end of them.
    The kernel itself plans with :func:`envelope`; this is for comparison with the paper.

    Parameters
    ----------
    length_mm : array_like
        (n,) lengths of the segments [mm], positive.
    v_cap : array_like
        Cap inside of every segment [mm/s], one number or (n,), positive.
    a_max, j_max : array_like
        Tangential acceleration [mm/s²] and jerk [mm/s³], one number or (n,), positive. j_max is
        for "sshape" only and may be None otherwise.
    v_node : array_like
        (n + 1,) cap at every junction, start and end included [mm/s], not negative.
    kind : {"linear", "sshape", "whole", "fixed"}
        How speed changes: constant acceleration; S-shaped within a_max and j_max; one symmetric S
        over every whole segment, within a_max; every ramp lasts ramp_s (look-ahead 0 only).
    lookahead : int, optional
        Segments seen beyond the one in work; None: all. 0: a stop at the end of every segment.
    ramp_s : float
        Duration of every ramp of the kind "fixed" [s], positive.

    Returns
    -------
    Profile

    Raises
    ------
    ArgumentError
        If a number is outside of its range (the first such index is told) or shapes do not fit.

    Examples
    --------
    >>> slope([4.0, 4.0], 10.0, 2.0, None, [0.0, 10.0, 0.0]).v_node
    array([0., 4., 0.])
    """
    lengths, nodes = (np.ascontiguousarray(x, np.float64) for x in (length_mm, v_node))
    if kind not in RAMPS:
        raise errors.ArgumentError(f"kind {kind!r} is not one of {', '.join(RAMPS)}", id="kind")
    if lengths.ndim != 1 or lengths.size == 0 or nodes.shape != (lengths.size + 1,):
        raise errors.ArgumentError(f"{lengths.shape} segments and {nodes.shape} nodes do not fit")
    if lookahead is not None and lookahead < 0:
        raise errors.ArgumentError(f"lookahead is {lookahead}, must not be negative")
    arrays = {"length": lengths, "v_node": nodes}
    for name, numbers in (("v_cap", v_cap), ("a_max", a_max), ("j_max", j_max)):
        given = np.broadcast_to(np.nan if numbers is None else numbers, lengths.shape)
        arrays[name] = np.ascontiguousarray(given, np.float64)
    return _slope(arrays, kind, lookahead, ramp_s)
