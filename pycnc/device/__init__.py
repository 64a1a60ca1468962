# SPDX-License-Identifier: MIT
"""OpenCL devices, and the kernels of ``opencl/`` on arrays. The only file that knows pyopencl.

Nothing here is needed to plan: the same bits come from C. A device pays where whole programs are
planned again and again.
"""

import dataclasses
import functools
import hashlib
import importlib.metadata
import os
import shutil
import stat
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

import numpy as np

import pycnc
from pycnc import errors
from pycnc.device.launch import REALS, EnvelopeLaunch

# A page.
ALIGNMENT = 4096

# Every program and its number type.
PROGRAMS = (
    ("unit", "double"), ("transfer", "double"), ("grade", "double"), ("bubble", "float"),
    ("scan", "float"), ("envelope", "float"), ("envelope", "double"), ("envelope_gpu", "float"),
    ("envelope_gpu", "double"), ("layout", "double"),
)  # fmt: skip

_PROBE_SECONDS = 300


def _is_ours(folder):
    """Tell whether nobody but this user can have put anything into a folder."""
    found = folder.lstat()
    if not stat.S_ISDIR(found.st_mode) or not os.access(folder, os.W_OK):
        return False
    if not hasattr(os, "getuid"):  # rights are told otherwise there
        return True
    return found.st_uid == os.getuid() and not found.st_mode & (stat.S_IWGRP | stat.S_IWOTH)


def cache_folder():
    """Return the folder for compiled kernels, made if it is not there yet.

    What lies there is run: a folder that is another user's, that others can write or that is a link
    is not taken, be it in the home or in the temporary folder that all share.
    """
    home = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    user = os.getuid() if hasattr(os, "getuid") else os.environ.get("USERNAME", "user")
    for base in (Path(home) / "pycnc", Path(tempfile.gettempdir()) / f"pycnc-{user}"):
        try:
            base.mkdir(mode=0o700, parents=True, exist_ok=True)
            if _is_ours(base):
                return base
        except OSError:
            continue
    raise errors.DeviceError(
        f"no folder for compiled kernels: what is in {home} and in {tempfile.gettempdir()} cannot "
        "be written, or not by this user alone; set XDG_CACHE_HOME to a folder of your own",
        id="device-build",
    )


@functools.cache
def _opencl():
    """Import pyopencl, after the environment that PoCL reads once."""
    os.environ.setdefault("POCL_DEVICES", "basic pthread")
    os.environ.setdefault("POCL_CACHE_DIR", str(_made(cache_folder() / "pocl")))
    os.environ.setdefault("PYOPENCL_NO_CACHE", "1")  # PoCL has its own
    try:
        import pyopencl
    except ImportError as cause:
        raise errors.DeviceError(
            "OpenCL is not installed; pip install 'pycnc-nck[opencl]'", id="device-absent"
        ) from cause
    return pyopencl


def _made(folder):
    folder.mkdir(parents=True, exist_ok=True)
    return folder


@dataclasses.dataclass(frozen=True)
class Device:
    """One OpenCL device.

    Attributes
    ----------
    kind : str
        "pthread" (PoCL on all cores), "basic" (PoCL in the calling thread), "gpu", "oclgrind" (a
        checker, slow), or "cpu" (any other).
    name, platform, version : str
        As the device and its platform call themselves; the version tells two PoCLs apart.
    units : int
        Compute units.
    shares_memory : bool
        Arrays of the host are used where they stand, without copies.
    """

    kind: str
    name: str
    platform: str
    version: str
    units: int
    shares_memory: bool

    def __str__(self):
        return f"{self.kind}: {self.name} ({self.version})"


def _kind(device):
    platform = device.platform.name.lower()
    if "oclgrind" in platform:
        return "oclgrind"
    if device.type & _opencl().device_type.GPU:
        return "gpu"
    first = device.name.split("-")[0]
    return first if first in ("basic", "pthread") else "cpu"


@functools.cache
def _found():
    """Return all devices with their OpenCL objects, in order of preference."""
    cl = _opencl()
    try:
        platforms = cl.get_platforms()
    except cl.Error as cause:
        raise errors.DeviceError(
            f"no OpenCL platform: {cause}; pip install 'pyopencl[pocl]'", id="device-absent"
        ) from cause
    found = []
    for platform in platforms:
        try:
            some = platform.get_devices()
        except cl.Error:  # a platform without devices says so by an error
            some = []
        for each in some:
            ours = Device(
                kind=_kind(each),
                name=each.name.strip(),
                platform=platform.name.strip(),
                version=platform.version.strip(),
                units=each.max_compute_units,
                shares_memory=bool(each.host_unified_memory),
            )
            found.append((ours, each))
    order = ("pthread", "cpu", "gpu", "basic", "oclgrind")
    newest = sorted(found, key=lambda pair: pair[0].version, reverse=True)
    return sorted(newest, key=lambda pair: order.index(pair[0].kind))


def devices():
    """Return the devices that OpenCL offers here, the preferred one first; else DeviceError.

    Examples
    --------
    >>> [device.kind for device in devices() if device.kind in ("pthread", "basic")]
    ['pthread', 'basic']
    """
    return tuple(ours for ours, _ in _found())


def _fitting(wanted, everyone):
    """Return the devices of a kind, or with these words in their name; "": all but checkers."""
    if not wanted:
        return [each for each in everyone if each.kind != "oclgrind"]
    of_kind = [each for each in everyone if each.kind == wanted]
    return of_kind or [each for each in everyone if wanted.lower() in str(each).lower()]


def choose(name=None):
    """Return one device; a DeviceError lists those that are there.

    Parameters
    ----------
    name : str or Device, optional
        A kind ("pthread", "basic", "gpu", "oclgrind", "cpu"), or a part of ``str(device)``, such as
        a version; by default the environment's PYCNC_DEVICE, or the preferred device.
    """
    if isinstance(name, Device):
        return name
    wanted = name or os.environ.get("PYCNC_DEVICE", "")
    everyone = devices()
    fits = _fitting(wanted, everyone)
    if not fits:
        there = "; ".join(map(str, everyone)) or "none"
        raise errors.DeviceError(
            f"no OpenCL device {wanted!r}; there: {there}. pip install 'pyopencl[pocl]' brings one",
            id="device-absent",
        )
    return fits[0]


def _folder(name):
    """Return a folder of sources that is installed beside the modules."""
    for base in pycnc.__path__:
        if (Path(base) / name).is_dir():
            return Path(base) / name
    raise errors.DeviceError(
        f"the folder {name} of the kernels is not installed; install pycnc-nck again",
        id="device-build",
    )


def _stamp(device):
    """Return a file that exists once the device has proved itself with these very sources."""
    sources = sorted([*_folder("opencl").rglob("*.*"), *_folder("csrc").rglob("*.h")])
    content = [path.read_bytes() for path in sources]
    facts = (str(device), shutil.which("ld"), importlib.metadata.version("pyopencl"))
    digest = hashlib.sha256(b"\0".join([*content, repr(facts).encode()])).hexdigest()
    return cache_folder() / f"proved-{digest[:32]}"


def _last_word(words):
    """Return what a process said of its end: its last line that tells an error."""
    lines = words.splitlines() or ["its process ended without a word"]
    return next((line for line in reversed(lines) if "error" in line.lower()), lines[-1])


def probe(name=None):
    """Prove a device in a process of its own, once: a broken OpenCL may abort its process.

    Parameters
    ----------
    name : str or Device, optional
        As for `choose`.

    Returns
    -------
    Device

    Raises
    ------
    DeviceError
        If the process fails; the message carries its last words.
    """
    device = choose(name)
    stamp = _stamp(device)
    if stamp.exists():
        return device
    code = "import sys; from pycnc import device; device.prove(sys.argv[1])"
    command = [sys.executable, "-c", code, str(device)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=_PROBE_SECONDS)
        words, good = done.stderr.strip(), done.returncode == 0
    except subprocess.TimeoutExpired:
        words, good = f"no answer within {_PROBE_SECONDS} s", False
    if not good:
        remedy = "" if shutil.which("ld") else "; PoCL needs ld: install binutils"
        if "unknown target CPU" in words:
            remedy = "; its LLVM is older than this processor: install a newer PoCL"
        raise errors.DeviceError(
            f"{device} does not work: {_last_word(words)}{remedy}", id="device-build"
        )
    stamp.touch()
    return device


def prove(name):
    """Build every kernel for a device and run the envelope on it; raise if that goes wrong."""
    used = session(choose(name))
    for source, real in PROGRAMS:
        used.program(source, real)
    vv_cap, h, out = np.full(9000, 4.0), np.ones(8999), np.empty(9000)
    EnvelopeLaunch(used, vv_cap, h, out).run(0.0, 0.0)
    if out[4] != 4.0 or out[-2] != 1.0 or out.max() != 4.0:
        raise errors.DeviceError(f"{name} computes wrong numbers", id="device-build")


class Session:
    """A device in use: its queue and its programs, built once.

    ``shares_memory`` is the device's; set it to False to see what copies cost.
    """

    def __init__(self, device):
        cl = _opencl()
        self.cl = cl
        self.device, self.shares_memory = device, device.shares_memory
        try:
            (opencl_device,) = [theirs for ours, theirs in _found() if ours == device]
            self.context = cl.Context([opencl_device])
            self.queue = cl.CommandQueue(self.context)
        except cl.Error as cause:
            raise self.lost(cause) from cause
        self.programs, self.kernels = {}, {}
        self.lock = threading.RLock()  # whoever uses the session holds it: PoCL waits in vain else

    def lost(self, cause):
        """Return the exception for a device that failed at work, and forget the session."""
        _sessions.pop(self.device, None)
        return errors.DeviceError(
            f"{self.device} failed: {cause}; the C backend needs no device", id="device-lost"
        )

    def program(self, name, real):
        """Return the program of ``opencl/<name>.cl`` for float or double."""
        if (name, real) not in self.programs:
            folder = _folder("opencl")
            options = ["-cl-std=CL1.2"]
            for include in (_folder("csrc"), folder / real, folder):
                options += ["-I", str(include)]
            source = (folder / f"{name}.cl").read_text(encoding="utf-8")
            try:
                built = self.cl.Program(self.context, source).build(options)
            except self.cl.Error as cause:
                raise errors.DeviceError(
                    f"{self.device} does not build {name}.cl: {cause}", id="device-build"
                ) from cause
            self.programs[name, real] = built
        return self.programs[name, real]

    def launch(self, names, arguments, items, local=1):
        """Enqueue a kernel for so many work-items, rounded up to whole groups.

        names: program, kernel and number type. The caller keeps the buffers among the arguments
        alive. A kernel is made once, since that takes longer than a short launch.
        """
        program, name, real = names
        kernel = self.kernels.get(names)
        if kernel is None:
            kernel = self.cl.Kernel(self.program(program, real), name)
            memory = (self.cl.Buffer, self.cl.LocalMemory)
            kernel.set_scalar_arg_dtypes(
                [None if isinstance(each, memory) else type(each) for each in arguments]
            )
            self.kernels[names] = kernel
        kernel.set_args(*arguments)
        size = -(-items // local) * local
        self.cl.enqueue_nd_range_kernel(self.queue, kernel, (size,), (local,))

    def buffer(self, array, written=False):
        """Return a buffer with the array's content: the array itself where memory is shared."""
        flags = self.cl.mem_flags
        access = flags.READ_WRITE if written else flags.READ_ONLY
        place = flags.USE_HOST_PTR if self.shares_memory else flags.COPY_HOST_PTR
        return self.cl.Buffer(self.context, access | place, hostbuf=array)

    def room(self, n, dtype):
        """Return a buffer for n items that lives on the device."""
        size = max(n, 1) * np.dtype(dtype).itemsize
        return self.cl.Buffer(self.context, self.cl.mem_flags.READ_WRITE, size)

    def read(self, buffer, array):
        """Wait, and make the array hold what the buffer holds."""
        if self.shares_memory and buffer.flags & self.cl.mem_flags.USE_HOST_PTR:
            mapped, _ = self.cl.enqueue_map_buffer(
                self.queue, buffer, self.cl.map_flags.READ, 0, array.shape, array.dtype
            )
            mapped.base.release(self.queue)
        else:
            self.cl.enqueue_copy(self.queue, array, buffer)
        return array


_sessions = {}


def session(device):
    """Return the session of a device that has proved itself."""
    if device not in _sessions:
        _sessions[device] = Session(device)
    return _sessions[device]


def in_use(name=None):
    """Return the session of a device, chosen as by `choose` and proved."""
    device = choose(name)
    return _sessions.get(device) or session(probe(device))


def empty(n, dtype=np.float64):
    """Return an uninitialised array that begins at a page: devices use it at full speed.

    Parameters
    ----------
    n : int
        Items.
    dtype : numpy dtype

    Examples
    --------
    >>> empty(3).ctypes.data % ALIGNMENT
    0
    """
    size = n * np.dtype(dtype).itemsize
    room = np.empty(size + ALIGNMENT, np.uint8)
    begin = -room.ctypes.data % ALIGNMENT
    return room[begin : begin + size].view(dtype)


def _check_arrays(vv_cap, h, out):
    n = len(vv_cap)
    good = vv_cap.dtype == h.dtype == out.dtype and out.dtype in REALS
    shapes = (vv_cap.shape, h.shape, out.shape) == ((n,), (max(n - 1, 0),), (n,))
    flat = all(each.flags.c_contiguous for each in (vv_cap, h, out))
    if not (good and shapes and flat and n > 0):
        raise errors.ArgumentError(
            "vv_cap (n), h (n − 1) and out (n) must be contiguous, of one type, float32 or "
            "float64, with n ≥ 1",
            id="argument",
        )


def envelope(vv_cap, h, vv_start, vv_end, out, *, device=None, kernel=None):
    """Compute the exact two-pass envelope on a device: the bits of C, or an error.

    Parameters
    ----------
    vv_cap : numpy.ndarray
        (n,) cap of v² at every node [mm²/s²], float32 or float64, contiguous.
    h : numpy.ndarray
        (n − 1,) 2·a·length of every piece [mm²/s²].
    vv_start, vv_end : float
        v² at the ends, at most [mm²/s²].
    out : numpy.ndarray
        (n,) to fill; it may be vv_cap.
    device : str or Device, optional
        As for `choose`.
    kernel : {"parts", "tiles"}, optional
        As for `EnvelopeLaunch`.

    Returns
    -------
    Device
        Where it ran.

    Raises
    ------
    DeviceError
        If there is no such device, it fails, or the result is not certain; out is not to be used
        then.
    ArgumentError
        If the arrays do not fit.

    Examples
    --------
    >>> vv = empty(3)
    >>> _ = envelope(np.array([9.0, 100.0, 9.0]), np.array([16.0, 4.0]), 9.0, 9.0, vv)
    >>> vv
    array([ 9., 13.,  9.])
    """
    _check_arrays(vv_cap, h, out)
    used = in_use(device)
    caps = vv_cap.copy() if np.may_share_memory(vv_cap, out) else vv_cap
    with used.lock:
        EnvelopeLaunch(used, caps, h, out, kernel=kernel).run(vv_start, vv_end)
    return used.device
