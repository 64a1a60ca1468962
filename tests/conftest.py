# SPDX-License-Identifier: MIT
"""Where things are, the C builds that several tests share, and the closing line that counts."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import hypothesis
import pytest
from locks import locked

ROOT = Path(__file__).resolve().parents[1]

# Random cases come from a fixed seed: the same run finds the same faults.
hypothesis.settings.register_profile("house", derandomize=True, deadline=None, database=None)
hypothesis.settings.load_profile("house")


def find_tool(name):
    """Return the path of a program; without it the test is skipped, under CI it fails."""
    path = shutil.which(name)
    if path is None:
        absent = pytest.fail if os.environ.get("CI") else pytest.skip
        absent(f"{name} is not installed (make test installs it on Debian)")
    return path


def build_c(compiler, *options, name=None, targets=("all",)):
    """Build C targets in build/<name or compiler>; return (folder, words of a failure or "")."""
    cmake = Path(sys.executable).with_name("cmake")
    folder = ROOT / "build" / (name or compiler)
    configure = [cmake, "-S", ROOT, "-B", folder, "-G", "Ninja", "-DNCK_TESTS=ON"]
    configure += [f"-DCMAKE_MAKE_PROGRAM={cmake.with_name('ninja')}"]
    configure += [f"-DCMAKE_C_COMPILER={find_tool(compiler)}", *options]
    keep_going = [cmake, "--build", folder, "--target", *targets, "--", "-k", "0"]
    with locked(folder):
        for command in (configure, keep_going):
            done = subprocess.run(command, capture_output=True, text=True)
            if done.returncode != 0:
                return folder, done.stdout + done.stderr
    return folder, ""


@pytest.fixture(scope="session")
def root():
    """Return the repository's folder."""
    return ROOT


@pytest.fixture(scope="session")
def tool():
    """Return the function that finds a program or skips."""
    return find_tool


@pytest.fixture(scope="session")
def gcc_build():
    """Return the folder of the release build with gcc, and what it complained about."""
    return build_c("gcc")


@pytest.fixture(scope="session")
def clang_build():
    """Return the folder of the build with clang under the sanitizers, and its complaints."""
    return build_c("clang-19", "-DNCK_SANITIZE=ON")


@pytest.fixture(scope="session")
def coverage_build():
    """Return the function that builds C tests to be counted, MC/DC among it; see build_c.

    Asserts are left out: none of them is ever to be false.
    """

    def build(*targets):
        flags = "-fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc -DNDEBUG"
        return build_c("clang-19", f"-DCMAKE_C_FLAGS={flags}", name="coverage", targets=targets)

    return build


TOO_OLD = "its LLVM is older than this processor"


def _is_too_old():
    """Return whether PoCL builds nothing here, since it does not know this computer's processor."""
    from pycnc import device, errors

    try:
        device.probe("basic")
    except errors.DeviceError as cause:
        return TOO_OLD in str(cause)
    return False


def pytest_collection_modifyitems(items):
    """Skip, loudly, all that needs PoCL where PoCL is older than the processor."""
    of_device = [item for item in items if item.path.stem.startswith("test_4_opencl")]
    if of_device and _is_too_old():
        reason = "OpenCL was NOT tested: the LLVM of PoCL is older than this processor"
        for item in of_device:
            item.add_marker(pytest.mark.skip(reason=reason))


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    """The same for the few tests elsewhere that ask a device."""
    outcome = yield
    report = outcome.get_result()
    if report.failed and TOO_OLD in str(call.excinfo.value):
        report.outcome = "skipped"
        report.longrepr = (str(item.path), item.location[1], f"OpenCL was NOT tested: {TOO_OLD}")


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config):
    """Print the plain closing line, below pytest's own."""
    reporter = config.pluginmanager.get_plugin("terminalreporter")
    if reporter is None or config.option.collectonly:
        return
    counts = {key: len(reports) for key, reports in reporter.stats.items()}
    failed = counts.get("failed", 0) + counts.get("error", 0)
    print(f"{counts.get('passed', 0)} passed, {failed} failed, {counts.get('skipped', 0)} skipped")
