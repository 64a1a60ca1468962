# SPDX-License-Identifier: MIT
"""Folders that one process of a test run works in at a time: `make test` has one for each core."""

import contextlib
import fcntl

import limits


@contextlib.contextmanager
def locked(folder):
    """Wait until no other process of the tests works in a folder; it is made if it is not there.

    Neither the wait nor what is built there counts as time of the test that needs it first.
    """
    folder.mkdir(parents=True, exist_ok=True)
    with limits.untimed(), (folder / "tests.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield
