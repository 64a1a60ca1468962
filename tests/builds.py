# SPDX-License-Identifier: MIT
"""The C builds that tests share: each is made once, in build/, by whichever test needs it first.

Compilers go through ccache where it is installed, with its cache in build/ccache: what one folder
has compiled, no other compiles again, whoever configures it: where compiler, options, paths and the
files that were read are the same to the word. The preprocessor is not asked: that saves a tenth of
what a small file takes.
"""

import os
import shutil
import subprocess
import sys
import time
from functools import cache
from pathlib import Path

import pytest
from locks import locked

ROOT = Path(__file__).resolve().parents[1]
CMAKE = Path(sys.executable).with_name("cmake")
NINJA = Path(sys.executable).with_name("ninja")
# Name: (compiler, options of the configuration).
BUILDS = {
    "gcc": ("gcc", []),
    "clang-19": ("clang-19", ["-DNCK_SANITIZE=ON"]),
}


def keep_what_is_compiled():
    """From here on every CMake of this process has its compilers' work kept, if ccache is there."""
    if shutil.which("ccache"):
        os.environ |= {"CCACHE_DIR": str(ROOT / "build" / "ccache"), "CCACHE_NOHASHDIR": "1",
                       "CCACHE_DEPEND": "1", "CMAKE_C_COMPILER_LAUNCHER": "ccache"}  # fmt: skip
    if shutil.which("gcc"):
        os.environ.setdefault("CC", "gcc")  # ccache takes cc for another compiler


def wait_for_packages():
    """Wait until what `make test` installs beside the tests is there, or cannot be had."""
    installing = os.environ.get("PACKAGES_COMING")  # a file that goes when they have come
    while installing and Path(installing).exists():
        time.sleep(0.2)
    keep_what_is_compiled()


def find_tool(name):
    """Return the path of a program; without it the test is skipped, under CI it fails."""
    if name not in ("gcc", "cc", "nm"):  # what the module was built with
        wait_for_packages()
    path = shutil.which(name)
    if path is None:
        absent = pytest.fail if os.environ.get("CI") else pytest.skip
        absent(f"{name} is not installed (make test installs it on Debian)")
    return path


@cache
def build_c(name, *targets):
    """Build targets of a build, all without any; return (folder, words of a failure or "")."""
    compiler, options = BUILDS[name]
    folder = ROOT / "build" / name
    keep_what_is_compiled()
    configure = [CMAKE, "-S", ROOT, "-B", folder, "-G", "Ninja", "-DNCK_TESTS=ON"]
    configure += [f"-DCMAKE_MAKE_PROGRAM={NINJA}", f"-DCMAKE_C_COMPILER={find_tool(compiler)}"]
    keep_going = [NINJA, "-C", folder, "-k", "0", *targets]
    commands = [keep_going] if (folder / "build.ninja").exists() else [configure, keep_going]
    commands[0] += options if commands[0] is configure else []
    with locked(folder):
        for command in commands:
            done = subprocess.run(command, capture_output=True, text=True)
            if done.returncode != 0:
                return folder, done.stdout + done.stderr
    return folder, ""
