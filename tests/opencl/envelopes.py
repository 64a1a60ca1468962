# SPDX-License-Identifier: MIT
"""Envelopes of random paths, by serial C and by an OpenCL device: what the tests compare."""

import numpy as np

from pycnc import device
from pycnc.kernel.bind import check, ffi, lib, pointer

HOME_DEVICES = ("pthread", "basic")
REALS = (np.float32, np.float64)


def by_c(vv_cap, h, vv_start=0.0, vv_end=0.0):
    """Return the envelope as serial C computes it, in the arrays' number type."""
    real = {np.dtype(np.float32): "float", np.dtype(np.float64): "double"}[vv_cap.dtype]
    choice = ffi.new("nck_host_choice_t *", {"backend": lib.NCK_HOST_SERIAL})
    report, vv = ffi.new("nck_host_envelope_report_t *"), np.empty_like(vv_cap)
    path = [pointer(real, vv_cap), pointer(real, h), len(vv_cap), vv_start, vv_end]
    problem = ffi.new(f"nck_host_problem_{real}_t *", path)
    check(getattr(lib, f"nck_host_envelope_{real}")(choice, problem, pointer(real, vv), report))
    return vv


def on_device(name, vv_cap, h, vv_start=0.0, vv_end=0.0, *, count=None, kernel=None):
    """Return the envelope as a device computes it, cut into so many parts, or into tiles."""
    vv = device.empty(len(vv_cap), vv_cap.dtype)
    vv.fill(-1.0)
    device.EnvelopeLaunch(device.in_use(name), vv_cap, h, vv, count, kernel).run(vv_start, vv_end)
    return vv


def random_path(n, seed, rare, real, h=(100.0, 3000.0)):
    """Return caps and pieces; rare: the share of low caps."""
    rng = np.random.default_rng(seed)
    vv_cap = np.where(rng.random(n) < rare, rng.uniform(0, 10, n), rng.uniform(1e3, 1e4, n))
    return vv_cap.astype(real), rng.uniform(*h, max(n - 1, 0)).astype(real)
