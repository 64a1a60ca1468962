# SPDX-License-Identifier: MIT
"""The rooms of the kernel one by one: arrays in, arrays out."""

import numpy as np

from pycnc import errors, kernel
from pycnc._bind import check, ffi, lib, pointer
from pycnc.records import dtype

BACKENDS = ("auto", "c")


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
    blocks = [np.empty(0, dtype("nck_block_t"))]
    diagnostics = [np.empty(0, dtype("nck_diagnostic_t"))]
    for some_blocks, some_diagnostics, _ in kernel.decode(text, machine):
        blocks.append(some_blocks.copy())
        diagnostics.append(some_diagnostics.copy())
    return np.concatenate(blocks), np.concatenate(diagnostics)


def envelope(w_cap, h, *, w_start=0.0, w_end=0.0, backend="auto", out=None):
    """Room 4: the largest profile of squared speeds that caps and accelerations allow.

    The exact two-pass look-ahead: backward w_i = min(w_cap_i, w_{i+1} + h_i), then forward
    w_{i+1} = min(w_{i+1}, w_i + h_i).

    Parameters
    ----------
    w_cap : array_like
        (n,) cap of v² at every node [mm²/s²], not negative.
    h : array_like
        (n − 1,) 2·a·length of every piece [mm²/s²], not negative.
    w_start, w_end : float
        v² at the ends, at most [mm²/s²].
    backend : {"auto", "c"}
        Where it is computed.
    out : numpy.ndarray, optional
        (n,) float64 to fill.

    Returns
    -------
    numpy.ndarray
        (n,) v² at every node [mm²/s²].

    Raises
    ------
    ArgumentError
        If a number is NaN, infinite or negative, or the lengths do not fit.

    Examples
    --------
    >>> envelope([9.0, 100.0, 9.0], [16.0, 4.0], w_start=9.0, w_end=9.0)
    array([ 9., 13.,  9.])
    """
    if backend not in BACKENDS:
        raise errors.ArgumentError(
            f"backend {backend!r} is not available; available: {', '.join(BACKENDS)}", id="backend"
        )
    w_cap = np.ascontiguousarray(w_cap, np.float64)
    h = np.ascontiguousarray(h, np.float64)
    if w_cap.ndim != 1 or h.ndim != 1 or len(w_cap) != len(h) + 1:
        raise errors.ArgumentError(f"{w_cap.shape} nodes and {h.shape} pieces do not fit")
    w = np.empty_like(w_cap) if out is None else out
    if w.shape != w_cap.shape or w.dtype != np.float64 or not w.flags.c_contiguous:
        raise errors.ArgumentError(f"out must be float64, contiguous, of shape {w_cap.shape}")
    bad = ffi.new("size_t *")
    status = lib.nck_host_envelope(
        pointer("double", w_cap), pointer("double", h), len(w_cap), w_start, w_end,
        pointer("double", w), bad,
    )  # fmt: skip
    if status == lib.NCK_E_ARGUMENT:
        raise errors.ArgumentError(
            f"index {bad[0]}: a number is NaN, infinite or negative", id="argument", status=status
        )
    check(status)
    return w
