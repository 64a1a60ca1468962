# SPDX-License-Identifier: MIT
"""Inputs that a fuzzer draws from a seed, under the sanitizers: no fault, no hang."""

import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FUZZ_TARGETS = sorted(path.stem for path in (ROOT / "tests" / "house" / "fuzz").glob("*.c"))
FUZZ_RUNS = {"decode": 100_000, "kernel": 5_000}
FUZZ_FLAGS = {"kernel": ["-len_control=0", "-max_len=600"]}  # long inputs at once


@pytest.mark.parametrize("name", FUZZ_TARGETS)
def test_fuzzing_finds_no_fault(clang_build, tmp_path, name):
    # The same inputs in every run: one seed, the corpus in one order, no folder that is read again.
    corpus = sorted(str(path) for path in (ROOT / "tests" / "house" / "fuzz" / name).iterdir())
    command = [clang_build[0] / f"fuzz_{name}", f"-runs={FUZZ_RUNS[name]}", "-seed=1"]
    command += [f"-seed_inputs={','.join(corpus)}"]
    command += ["-timeout=20", f"-artifact_prefix={tmp_path}/", "-verbosity=0"]
    command += FUZZ_FLAGS.get(name, [])
    done = subprocess.run(command, capture_output=True, text=True, timeout=1200)
    assert done.returncode == 0, done.stderr
