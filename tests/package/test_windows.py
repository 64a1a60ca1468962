# SPDX-License-Identifier: MIT
"""libnck for Windows, by mingw-w64 from here: it builds, and its C tests pass under wine.

What runs on the os of firmware_sim is not linked: its port for hosts needs ucontext. The Python
module is not built: that needs a Python for Windows. Nothing is tried on Windows itself.
"""

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from builds import CMAKE, NINJA
from locks import locked

ROOT = Path(__file__).resolve().parents[2]
COMPILER = "x86_64-w64-mingw32-gcc"
ROOMS = ("base", "decode", "toolcomp", "smooth", "lookahead", "slope", "tick", "kernel", "host")
# The reference of its sine is the C library's, which is 1.3e-15 off there, and wants 4.5e-16.
ASTRAY = {"test_trig"}
ATTEMPTS = 3  # wine's server may end between two programs
PATIENCE_S = 600

pytestmark = pytest.mark.seldom(4, "CMakeLists.txt", "cmake", "csrc/nck/base", "tests/package")


def wine():
    """Return wine's program; Debian's package has it beside the path."""
    found = shutil.which("wine64", path=f"{os.environ['PATH']}:/usr/lib/wine:/usr/bin")
    return found or pytest.skip("wine64 is not here: NO PROGRAM FOR WINDOWS WAS RUN")


def libraries():
    """Return the folders of the compiler's libraries, as wine takes them."""
    found = []
    for name in ("libgomp-1.dll", "libwinpthread-1.dll"):
        told = subprocess.run([COMPILER, f"-print-file-name={name}"], capture_output=True,
                              text=True, check=True)  # fmt: skip
        found.append(f"Z:{Path(told.stdout.strip()).resolve().parent}")
    return ";".join(found)


@pytest.fixture(scope="module")
def folder():
    """Return the folder of the build: the library, and the C tests of rooms that need no os."""
    if not shutil.which(COMPILER):
        pytest.skip(f"{COMPILER} is not here: NOTHING WAS BUILT FOR WINDOWS")
    made = ROOT / "build" / "mingw"
    targets = [f"tests_{room}{suffix}" for room in ROOMS for suffix in ("", "_small")]
    # Its headers' macros are not warning-free: -Werror is off.
    configure = [CMAKE, "-S", ROOT, "-B", made, "-G", "Ninja", "-DNCK_TESTS=ON", "-DNCK_STRICT=OFF",
                 "-DCMAKE_SYSTEM_NAME=Windows", f"-DCMAKE_C_COMPILER={COMPILER}",
                 f"-DCMAKE_MAKE_PROGRAM={NINJA}", "-DCMAKE_EXE_LINKER_FLAGS=-static"]  # fmt: skip
    with locked(made):
        for command in (configure, [NINJA, "-C", made, "nck", *targets]):
            done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
            assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
    return made


def test_the_library_builds(folder):
    assert (folder / "libnck.a").stat().st_size > 100_000


@pytest.mark.thorough
@pytest.mark.parametrize("room", ROOMS)
def test_the_c_tests_of_a_room_pass_under_wine(folder, room):
    space = os.environ | {"WINEPREFIX": str(folder / "wine"), "WINEDEBUG": "-all",
                          "WINEPATH": libraries()}  # fmt: skip

    def run(*words):
        for _ in range(ATTEMPTS):
            done = subprocess.run([wine(), *words], capture_output=True, text=True, env=space,
                                  timeout=PATIENCE_S)  # fmt: skip
            if "wine client error" not in done.stderr:
                break
        return done

    program = folder / f"tests_{room}.exe"
    tests = run(program).stdout.split()
    assert len(tests) > 2
    broken = {}
    for test in tests:
        done = run(program, test)
        if done.returncode != 0:
            broken[test] = done.stdout[-300:]
    assert set(broken) <= ASTRAY, broken
