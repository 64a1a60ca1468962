# SPDX-License-Identifier: MIT
"""The envelope's kernels for GPUs, on PoCL: tiles of any size, their edges, and who takes them."""

import dataclasses
import doctest

import numpy as np
import pytest
from envelopes import HOME_DEVICES, REALS, by_c, on_device, random_path

from pycnc import device
from pycnc.device import launch
from pycnc.errors import ArgumentError, DeviceError

TILES = {  # nodes of a tile of envelope_gpu.cl on PoCL
    real: np.prod(launch.tile_sizes(1 << 20, 4096, np.dtype(real).itemsize))
    for real in REALS
}


@pytest.mark.parametrize("home", HOME_DEVICES)
@pytest.mark.parametrize("real", REALS)
@pytest.mark.parametrize("edge", [-1, 0, 1])
@pytest.mark.parametrize("beside", [0, 1024, 1025])  # an overlap behind the tile, and its last node
@pytest.mark.parametrize("count", [1, 2, 5])
def test_edges_of_tiles_do_not_show(home, count, beside, edge, real):
    n = count * TILES[real] + beside + edge
    vv_cap, h = random_path(n, 7, 0.01, real, h=(10.0, 300.0))
    got = on_device(home, vv_cap, h, 30.0, 5.0, kernel="tiles")
    assert got.tobytes() == by_c(vv_cap, h, 30.0, 5.0).tobytes()


@pytest.mark.parametrize("local_bytes, group_most", [(32768, 256), (49152, 128), (32768, 64)])
@pytest.mark.parametrize("real", REALS)
def test_tiles_are_cut_to_the_local_memory(monkeypatch, local_bytes, group_most, real):
    item = np.dtype(real).itemsize
    group, run = launch.tile_sizes(local_bytes, group_most, item)
    assert group <= group_most and run % 2 == 1
    assert 2 * item * (group * run + launch.OVERLAP_ROOM) < local_bytes
    monkeypatch.setattr(launch, "tile_sizes", lambda *_: (group, run))
    vv_cap, h = random_path(9001, 4, 0.01, real)
    assert on_device("basic", vv_cap, h, kernel="tiles").tobytes() == by_c(vv_cap, h).tobytes()


def test_the_example_of_the_sizes_runs():
    found = doctest.testmod(launch)
    assert (found.failed, found.attempted) == (0, 1)


@pytest.mark.parametrize("limits", [(16384, 256, 8), (49152, 32, 4)])
def test_a_device_that_does_not_hold_a_tile_is_refused(limits):
    with pytest.raises(DeviceError, match="do not hold a tile") as caught:
        launch.tile_sizes(*limits)
    assert caught.value.id == "device-build"


def test_a_gpu_takes_tiles_and_others_take_parts():
    gpu = dataclasses.replace(device.choose("basic"), kind="gpu")
    for used, kernel in ((gpu, "tiles"), (device.choose("basic"), "parts")):
        session = device.Session(device.choose("basic"))
        session.device = used
        vv_cap, h = random_path(5000, 1, 0.01, np.float32)
        launch = device.EnvelopeLaunch(session, vv_cap, h, np.empty_like(vv_cap))
        assert launch.kernel == kernel
        launch.run(0.0, 0.0)
        built = {"tiles": {"envelope_gpu"}, "parts": {"envelope"}}[kernel]
        assert {program for program, _ in session.programs} == built
        assert launch.out.tobytes() == by_c(vv_cap, h).tobytes()


def test_a_kernel_that_is_none_is_refused():
    with pytest.raises(ArgumentError, match="none of parts, tiles"):
        on_device("basic", np.ones(3), np.ones(2), kernel="gpu")


@pytest.mark.parametrize("real", REALS)
@pytest.mark.parametrize("which", [0, 1])
@pytest.mark.parametrize("place", [0, 1, 1500, 8998])
def test_a_negative_zero_is_no_number_of_a_tile(real, which, place):
    arrays = random_path(9000, 1, 0.01, real)
    arrays[which][place] = -0.0
    with pytest.raises(DeviceError, match="negative zero"):
        on_device("basic", *arrays, kernel="tiles")
