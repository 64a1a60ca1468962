# SPDX-License-Identifier: MIT
"""Inputs that a fuzzer draws from a seed, under the sanitizers: no fault, no hang."""

import subprocess
from pathlib import Path

import pytest

FUZZ = Path(__file__).resolve().parent / "fuzz"
FUZZ_TARGETS = sorted(path.stem for path in FUZZ.glob("*.c"))
RUNS = {  # inputs of the suite, and of the campaign
    "decode": {"suite": 10_000, "whole": 100_000},
    "kernel": {"suite": 500, "whole": 5_000},
}
FUZZ_FLAGS = {"kernel": ["-len_control=0", "-max_len=600"]}  # long inputs at once


@pytest.mark.thorough
@pytest.mark.parametrize("name", FUZZ_TARGETS)
def test_fuzzing_finds_no_fault(clang_build, draw, draw_seed, pytestconfig, tmp_path, name):
    # The same inputs from the same seed: the corpus in one order, no folder that is read again.
    runs = RUNS[name][draw] * pytestconfig.option.fuzz_factor
    corpus = sorted(str(path) for path in (FUZZ / name).iterdir())
    command = [clang_build[0] / f"fuzz_{name}", f"-runs={runs}", f"-seed={draw_seed or 1}"]
    command += [f"-seed_inputs={','.join(corpus)}"]
    command += ["-timeout=20", f"-artifact_prefix={tmp_path}/", "-verbosity=0"]
    command += FUZZ_FLAGS.get(name, [])
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
