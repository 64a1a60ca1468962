# SPDX-License-Identifier: MIT
"""Where things are, the C builds that several tests share, and the closing line that counts."""

import os
from pathlib import Path

import c_tests
import durations
import hypothesis
import limits
import pytest
import sampling
from builds import build_c, find_tool, wait_for_packages
from sampling import (  # noqa: F401
    draw,
    draw_seed,
    pytest_addoption,
    pytest_configure_node,
    pytest_report_header,
)

ROOT = Path(__file__).resolve().parents[1]


def pytest_configure(config):
    """Fix the draw of this run: of the cases, and of what hypothesis thinks of."""
    sampling.pytest_configure(config)
    durations.pytest_configure(config)
    limits.pytest_configure(config)
    # Random cases come from the run's seed: the same seed finds the same faults.
    hypothesis.settings.register_profile("house", deadline=None, database=None)
    hypothesis.settings.load_profile("house")
    hypothesis.core.global_force_seed = config.option.draw_seed


def pytest_xdist_make_scheduler(config, log):
    """Give out tests so that a run goes on when a process ends."""
    return limits.Scheduler(config, log)


def pytest_collect_file(file_path, parent):
    """Collect C tests beside those in Python."""
    return c_tests.collect_file(file_path, parent)


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
    """Return the folder of the release build with gcc, with what is installed, and complaints."""
    return build_c("gcc", "nck", "nck_host")


@pytest.fixture(scope="session")
def kernel_build():
    """Return the same with no more than the kernel in its default capacities built."""
    return build_c("gcc", "nck")


@pytest.fixture(scope="session")
def clang_build(pytestconfig):
    """Return the folder of the build with clang under the sanitizers, and its complaints."""
    return build_c("clang-19", *c_tests.sanitized_targets(pytestconfig))


# Rooms whose tests reach for packages on their own, and not by the fixture `tool`.
WITH_PACKAGES = {"kernel", "tick", "controller", "linuxcnc", "package", "house"}
FIRST = {"test_house_rules", "test_file_rules", "test_compilers_gcc"}  # … but for these


def pytest_runtest_setup(item):
    """Let what needs packages wait for them; all else begins meanwhile."""
    if item.path.parent.name in WITH_PACKAGES and item.path.stem not in FIRST:
        wait_for_packages()


TOO_OLD = "its LLVM is older than this processor"


def _is_too_old():
    """Return whether PoCL builds nothing here, since it does not know this computer's processor."""
    from pycnc import device, errors

    try:
        device.probe("basic")
    except errors.DeviceError as cause:
        return TOO_OLD in str(cause)
    return False


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config, items):
    """Draw; then skip, loudly, all that needs PoCL where PoCL is older than the processor.

    Oclgrind has a compiler of its own, for a processor that it plays.
    """
    sampling.leave_out(config, items, c_tests.not_drawn(config, items))
    of_device = [item for item in items if item.path.stem.startswith("test_opencl")
                 and "oclgrind" not in item.name]  # fmt: skip
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
    """Print what the tests cost, if it is asked for, and the plain closing line below it all."""
    reporter = config.pluginmanager.get_plugin("terminalreporter")
    if reporter is None or config.option.collectonly:
        return
    if os.environ.get("DURATIONS"):
        print(durations.table())
    counts = {key: len(reports) for key, reports in reporter.stats.items()}
    failed = counts.get("failed", 0) + counts.get("error", 0)
    print(f"{counts.get('passed', 0)} passed, {failed} failed, {counts.get('skipped', 0)} skipped")
