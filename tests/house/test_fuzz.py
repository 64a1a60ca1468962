# SPDX-License-Identifier: MIT
"""Inputs that a fuzzer draws from a seed, under the sanitizers: no fault, no hang."""

import subprocess
from pathlib import Path

import c_tests
import pytest

FUZZ = Path(__file__).resolve().parent / "fuzz"
RUNS = {  # inputs of the suite, and of the campaign, in each set of capacities
    "decode": {"suite": 10_000, "whole": 100_000},
    "kernel": {"suite": 250, "whole": 5_000},
    "serve": {"suite": 100, "whole": 2_000},
}
FUZZ_FLAGS = dict.fromkeys(("kernel", "serve"), ["-len_control=0", "-max_len=600"])  # long at once


@pytest.mark.thorough
@pytest.mark.parametrize("name", c_tests.FUZZED)
def test_fuzzing_finds_no_fault(clang_build, draw, draw_seed, pytestconfig, tmp_path, name):
    # The same inputs from the same seed: the corpus in one order, no folder that is read again.
    runs = RUNS[name][draw] * pytestconfig.option.fuzz_factor
    corpus = sorted(str(path) for path in (FUZZ / name).iterdir())
    options = [f"-runs={runs}", f"-seed={draw_seed or 1}", f"-seed_inputs={','.join(corpus)}"]
    options += ["-timeout=20", f"-artifact_prefix={tmp_path}/", "-verbosity=0"]
    options += FUZZ_FLAGS.get(name, [])
    for suffix in c_tests.drawn_suffixes(pytestconfig):
        command = [clang_build[0] / f"fuzz_{name}{suffix}", *options]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
