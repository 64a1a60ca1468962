# SPDX-License-Identifier: MIT
"""The build by clang: no warning, and the C unit tests under its sanitizers."""

import pytest
from c_tests import C_TESTS, CAPACITIES, LEAN, run_c_test


def test_clang_has_no_warning(clang_build):
    _, complaints = clang_build
    assert not complaints, complaints


@pytest.mark.parametrize("capacities", CAPACITIES)
@pytest.mark.parametrize("name", C_TESTS)
def test_c_tests_pass_under_the_sanitizers(clang_build, name, capacities):
    run_c_test(clang_build[0], f"{name}{capacities}")


@pytest.mark.parametrize("name", LEAN)
def test_what_lean_builds_have_left_runs_under_the_sanitizers(clang_build, name):
    run_c_test(clang_build[0], name)
