# SPDX-License-Identifier: MIT
"""A test that ends its process fails, and all others run, whatever is left to do."""

import subprocess
import sys
from pathlib import Path

import pytest

TESTS = Path(__file__).resolve().parents[1]
CONFTEST = f"""import sys
sys.path.append({str(TESTS)!r})
import limits

def pytest_addoption(parser):
    parser.addoption("--draw", default="quick")

def pytest_xdist_make_scheduler(config, log):
    return limits.Scheduler(config, log)

def pytest_configure(config):
    limits.pytest_configure(config)
"""
ENDS = "import os\ndef test_ends_its_process():\n    os.abort()\n"
PASSES = "def test_passes_{}():\n    pass\n"


@pytest.mark.thorough
@pytest.mark.parametrize("behind", (0, 3))
@pytest.mark.parametrize("before", (0, 5))
def test_a_run_outlives_a_process(tmp_path, before, behind):
    passes = "".join(map(PASSES.format, range(3)))
    (tmp_path / "conftest.py").write_text(CONFTEST)
    for number in range(before + behind):
        (tmp_path / f"test_{number:02}{'b' * (number >= before)}.py").write_text(passes)
    (tmp_path / f"test_{before:02}a.py").write_text(ENDS + passes)
    command = [sys.executable, "-m", "pytest", "-n", "2", "--dist", "loadfile"]
    run = subprocess.run(
        [*command, "--no-loadscope-reorder", "-q", "-p", "no:cacheprovider", tmp_path],
        cwd=tmp_path, capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    count = 3 * (before + behind + 1)
    assert f"1 failed, {count} passed, 1 skipped" in run.stdout
