# SPDX-License-Identifier: MIT
"""Envelopes of random paths, by serial C and by an OpenCL device: what the tests compare."""

import numpy as np

from pycnc import device
from pycnc.kernel.bind import check, ffi, lib, pointer

HOME_DEVICES = ("pthread", "basic")
REALS = (np.float32, np.float64)


def by_c(w_cap, h, w_start=0.0, w_end=0.0):
    """Return the envelope as serial C computes it, in the arrays' number type."""
    real = {np.dtype(np.float32): "float", np.dtype(np.float64): "double"}[w_cap.dtype]
    choice = ffi.new("nck_host_choice_t *", {"backend": lib.NCK_HOST_SERIAL})
    report, w = ffi.new("nck_host_envelope_report_t *"), np.empty_like(w_cap)
    path = [pointer(real, w_cap), pointer(real, h), len(w_cap), w_start, w_end]
    problem = ffi.new(f"nck_host_problem_{real}_t *", path)
    check(getattr(lib, f"nck_host_envelope_{real}")(choice, problem, pointer(real, w), report))
    return w


def on_device(name, w_cap, h, w_start=0.0, w_end=0.0, *, count=None, kernel=None):
    """Return the envelope as a device computes it, cut into so many parts, or into tiles."""
    w = device.empty(len(w_cap), w_cap.dtype)
    w.fill(-1.0)
    device.EnvelopeLaunch(device.in_use(name), w_cap, h, w, count, kernel).run(w_start, w_end)
    return w


def random_path(n, seed, rare, real, h=(100.0, 3000.0)):
    """Return caps and pieces; rare: the share of low caps."""
    rng = np.random.default_rng(seed)
    w_cap = np.where(rng.random(n) < rare, rng.uniform(0, 10, n), rng.uniform(1e3, 1e4, n))
    return w_cap.astype(real), rng.uniform(*h, max(n - 1, 0)).astype(real)
