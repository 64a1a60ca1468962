# SPDX-License-Identifier: MIT
"""The C unit tests of tests/c, as programs of a build: their names, and how one is run."""

import subprocess
from pathlib import Path

import pytest

C_TESTS = sorted(path.stem for path in (Path(__file__).parent / "c").glob("test_*.c"))
# Builds that leave out rooms and planners, and the tests that they are built with.
LEAN = [
    f"{name}_{lean}"
    for lean in ("linear", "jerk")
    for name in ("test_decode_motion", "test_interpolate", "test_left_out", "test_link")
]
# In the default and in the small capacities, then those.
PROGRAMS = [f"{name}{capacities}" for name in C_TESTS for capacities in ("", "_small")] + LEAN


def run_c_test(folder, name):
    """Run a C test program; fail with its own words."""
    executable = folder / name
    if not executable.exists():
        pytest.fail(f"{name} was not built", pytrace=False)
    done = subprocess.run([executable], capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        pytest.fail(f"{done.stdout}{done.stderr}", pytrace=False)
