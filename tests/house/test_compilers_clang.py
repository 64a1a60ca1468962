# SPDX-License-Identifier: MIT
"""The build by clang under its sanitizers has no warning; the suite builds what it draws of it."""

import pytest

pytestmark = pytest.mark.thorough


def test_clang_has_no_warning(clang_build):
    _, complaints = clang_build
    assert not complaints, complaints
