# SPDX-License-Identifier: MIT
"""The release build by gcc has no warning. The C tests that it runs stand in their rooms."""


def test_gcc_has_no_warning(gcc_build):
    _, complaints = gcc_build
    assert not complaints, complaints
