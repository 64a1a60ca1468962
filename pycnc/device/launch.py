# SPDX-License-Identifier: MIT
"""The envelope on fixed arrays of a device: in parts for a processor, in tiles for a GPU."""

import numpy as np

from pycnc import errors

# A part of a path that is worth a work-item of its own [nodes].
PART_WORTH = 4096
# Parts for every compute unit: more than one, so that a disturbed unit does not hold up the others.
PARTS_PER_UNIT = 8
# Work-items of a group of a GPU, the preferred number first, and the least run of one [nodes].
TILE_GROUPS, RUN_LEAST = (256, 128, 64), 7
# Local memory of a group at most, and what the kernels have beside their two windows [bytes].
LOCAL_MOST, LOCAL_BESIDE = 48 * 1024, 64
# Numbers of a window beside the tile's, as in envelope_gpu.cl.
OVERLAP_ROOM = 1025
# bits of a state, as in envelope.cl and envelope_gpu.cl
DOUBT_OVERLAP, DOUBT_NUMBER = 1, 2

KERNELS = ("parts", "tiles")
REALS = {np.dtype(np.float32): "float", np.dtype(np.float64): "double"}


def parts(device, n, worth=PART_WORTH):
    """Return how many parts to cut a path of n nodes into."""
    most = 1 if device.kind == "basic" else PARTS_PER_UNIT * device.units
    return max(1, min(most, n // worth))


def tile_sizes(local_bytes, group_most, item_bytes):
    """Return what a group of a GPU takes on: (work-items, nodes of each); an odd number of nodes.

    Parameters
    ----------
    local_bytes : int
        Local memory of the device [bytes].
    group_most : int
        Work-items of a group at most.
    item_bytes : int
        4 for float, 8 for double.

    Raises
    ------
    DeviceError
        If the windows do not fit; what OpenCL 1.2 asks of every device suffices.

    Examples
    --------
    >>> tile_sizes(32768, 1024, 4), tile_sizes(32768, 1024, 8), tile_sizes(49152, 1024, 8)
    ((256, 11), (128, 7), (256, 7))
    """
    room = (min(local_bytes, LOCAL_MOST) - LOCAL_BESIDE) // (2 * item_bytes) - OVERLAP_ROOM
    for group in TILE_GROUPS:
        run = (room // group - 1) | 1
        if group <= group_most and run >= RUN_LEAST:
            return group, run
    raise errors.DeviceError(
        f"{local_bytes} bytes of local memory and groups of {group_most} do not hold a tile",
        id="device-build",
    )


class _Parts:
    """One launch of envelope.cl: a work-item for each part of the path."""

    def __init__(self, session, n, dtype, count):
        self.session, self.real = session, REALS[dtype]
        self.states = parts(session.device, n) if count is None else count

    def enqueue(self, path, n, ends, out):
        """Enqueue the kernel: path, the buffers of caps and pieces; out, those of vv and states."""
        names = ("envelope", "envelope", self.real)
        self.session.launch(names, (*path, n, *ends, *out), self.states)


class _Tiles:
    """Two launches of envelope_gpu.cl: a work-group for each tile of the path."""

    def __init__(self, session, n, dtype):
        self.session, self.real = session, REALS[dtype]
        (device,) = session.context.devices
        limits = device.local_mem_size, device.max_work_group_size
        self.group, run = tile_sizes(*limits, dtype.itemsize)
        self.run = np.int32(run)
        self.states = -(-n // (self.group * run))
        self.between = session.room(n, dtype)
        size = (self.group * run + OVERLAP_ROOM) * dtype.itemsize
        self.windows = session.cl.LocalMemory(size), session.cl.LocalMemory(size)

    def enqueue(self, path, n, ends, out):
        """Enqueue both kernels, as `_Parts.enqueue`; the queue keeps their order."""
        (vv_cap, h), (vv_start, vv_end), (vv, states) = path, ends, out
        backward = (vv_cap, h, n, vv_end, self.run, self.between, states, *self.windows)
        forward = (self.between, h, n, vv_start, self.run, vv, states, *self.windows)
        for name, arguments in (("backward", backward), ("forward", forward)):
            names = ("envelope_gpu", name, self.real)
            self.session.launch(names, arguments, self.states * self.group, self.group)


class EnvelopeLaunch:
    """The envelope on fixed arrays, to be run often; `device.envelope` says what it computes.

    Parameters
    ----------
    session : device.Session
        From `device.in_use`.
    vv_cap, h, out : numpy.ndarray
        As for `device.envelope`; out must not share memory with vv_cap.
    count : int, optional
        Parts to cut the path into; by default what suits the device. Tiles take no notice.
    kernel : {"parts", "tiles"}, optional
        "tiles" is for GPUs and their default, "parts" for all others; either runs anywhere.
    """

    def __init__(self, session, vv_cap, h, out, count=None, kernel=None):
        self.session, self.out = session, out
        self.kernel = kernel or ("tiles" if session.device.kind == "gpu" else "parts")
        if self.kernel not in KERNELS:
            raise errors.ArgumentError(f"kernel {kernel!r} is none of {', '.join(KERNELS)}")
        n = len(vv_cap)
        try:
            if self.kernel == "tiles":
                self.form = _Tiles(session, n, out.dtype)
            else:
                self.form = _Parts(session, n, out.dtype, count)
            self.states = np.empty(self.form.states, np.int32)
            self.vv = session.buffer(out, written=True)
            self.state_buffer = session.room(len(self.states), np.int32)
            # One node has no piece; an OpenCL buffer is never empty.
            self.inputs = [session.buffer(each) for each in (vv_cap, h if n > 1 else vv_cap)]
        except session.cl.Error as cause:
            raise session.lost(cause) from cause

    def run(self, vv_start, vv_end):
        """Compute once and wait; raise DeviceError where the result is not certain."""
        if not (_is_good(vv_start) and _is_good(vv_end)):
            raise _bad_number()
        with self.session.lock:
            self._enqueue(vv_start, vv_end)
            self.fetch()

    def run_kernels(self, vv_start, vv_end):
        """Compute once and wait; the result stays on the device until `fetch`."""
        with self.session.lock:
            self._enqueue(vv_start, vv_end)
            try:
                self.session.queue.finish()
            except self.session.cl.Error as cause:
                raise self.session.lost(cause) from cause

    def fetch(self):
        """Bring the result into `out`; raise DeviceError where it is not certain."""
        with self.session.lock:
            try:
                self.session.read(self.vv, self.out)
                self.session.read(self.state_buffer, self.states)
            except self.session.cl.Error as cause:
                raise self.session.lost(cause) from cause
        doubt = int(np.bitwise_or.reduce(self.states))
        if doubt & DOUBT_NUMBER:
            raise _bad_number()
        if doubt & DOUBT_OVERLAP:
            raise errors.DeviceError(
                "pieces are too short for the overlap of two parts; plan with the C backend",
                id="device-overlap",
            )

    def _enqueue(self, vv_start, vv_end):
        real = self.out.dtype.type
        ends, n = (real(vv_start), real(vv_end)), np.int64(len(self.out))
        try:
            self.form.enqueue(self.inputs, n, ends, (self.vv, self.state_buffer))
        except self.session.cl.Error as cause:
            raise self.session.lost(cause) from cause


def _bad_number():
    return errors.DeviceError(
        "a number is NaN, infinite, negative or a negative zero; the C backend names it",
        id="device-number",
    )


def _is_good(x):
    return 0.0 <= x < np.inf
