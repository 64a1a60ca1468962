# SPDX-License-Identifier: MIT
"""The release build by gcc: no warning, and the C unit tests."""

import pytest
from c_tests import PROGRAMS, run_c_test


def test_gcc_has_no_warning(gcc_build):
    _, complaints = gcc_build
    assert not complaints, complaints


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_c_test_passes_in_the_release_build(gcc_build, name):
    run_c_test(gcc_build[0], name)
