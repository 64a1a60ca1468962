# SPDX-License-Identifier: MIT
"""Compiled kernels are run, so that they lie where nobody but their user can put any."""

import os
from pathlib import Path

import pytest

from pycnc import device
from pycnc.errors import DeviceError


@pytest.fixture
def places(tmp_path, monkeypatch):
    """Return the folders in the home and in the shared temporary folder, neither of them made."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "home"))
    monkeypatch.setattr(device.tempfile, "gettempdir", lambda: str(tmp_path))
    return tmp_path / "home" / "pycnc", tmp_path / f"pycnc-{os.getuid()}"


def link(folder):
    folder.with_name("elsewhere").mkdir(parents=True)
    folder.symlink_to(folder.with_name("elsewhere"))


def open_to(mode):
    def make(folder):
        folder.mkdir(parents=True)
        folder.chmod(mode)

    return make


SPOILED = {"link": link, "group": open_to(0o775), "all": open_to(0o1777), "file": Path.touch}


def test_the_cache_is_made_for_its_user_alone(places):
    assert device.cache_folder() == places[0]
    assert places[0].stat().st_mode & 0o777 == 0o700


@pytest.mark.parametrize("how", SPOILED)
def test_a_cache_that_others_can_write_is_not_taken(places, how):
    places[0].parent.mkdir()
    SPOILED[how](places[0])
    assert device.cache_folder() == places[1]
    places[1].rmdir()
    SPOILED[how](places[1]) if how != "link" else places[1].symlink_to(places[0])
    with pytest.raises(DeviceError, match="set XDG_CACHE_HOME to a folder of your own"):
        device.cache_folder()


def test_a_cache_of_another_user_is_not_taken(places, monkeypatch):
    places[0].mkdir(parents=True, mode=0o700)
    monkeypatch.setattr(device.os, "getuid", lambda: os.stat(places[0]).st_uid + 1)
    with pytest.raises(DeviceError):
        device.cache_folder()
