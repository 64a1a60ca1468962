# SPDX-License-Identifier: MIT
"""The release build by gcc has no warning. The C tests that it runs stand in their rooms."""

import c_tests
from builds import build_c

# A quick run sees what is shipped; the C tests tell of their own warnings.
SHIPPED = ("nck", "nck_host", "nck_small", "app")


def test_gcc_has_no_warning(draw, pytestconfig):
    targets = SHIPPED if draw == "quick" else c_tests.release_targets(pytestconfig)
    _, complaints = build_c("gcc", *targets)
    assert not complaints, complaints
