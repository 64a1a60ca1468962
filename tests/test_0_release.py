# SPDX-License-Identifier: MIT
"""The release build by gcc: no warning, and the C unit tests."""

import pytest
from c_tests import C_TESTS, CAPACITIES, LEAN, run_c_test


def test_gcc_has_no_warning(gcc_build):
    _, complaints = gcc_build
    assert not complaints, complaints


@pytest.mark.parametrize("capacities", CAPACITIES)
@pytest.mark.parametrize("name", C_TESTS)
def test_c_tests_pass_in_the_release_build(gcc_build, name, capacities):
    run_c_test(gcc_build[0], f"{name}{capacities}")


@pytest.mark.parametrize("name", LEAN)
def test_what_lean_builds_have_left_runs_in_the_release_build(gcc_build, name):
    run_c_test(gcc_build[0], name)
