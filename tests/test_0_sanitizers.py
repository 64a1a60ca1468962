# SPDX-License-Identifier: MIT
"""The build by clang: no warning, and the C unit tests under its sanitizers."""

import pytest
from c_tests import PROGRAMS, run_c_test


def test_clang_has_no_warning(clang_build):
    _, complaints = clang_build
    assert not complaints, complaints


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_c_test_passes_under_the_sanitizers(clang_build, name):
    run_c_test(clang_build[0], name)
