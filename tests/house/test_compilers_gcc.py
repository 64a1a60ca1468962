# SPDX-License-Identifier: MIT
"""The release build by gcc has no warning. The C tests that it runs stand in their rooms."""

from builds import build_c

# A quick run sees what is shipped; the C tests tell of their own warnings.
SHIPPED = ("nck", "nck_host", "nck_small", "app")


def test_gcc_has_no_warning(draw):
    _, complaints = build_c("gcc", *(SHIPPED if draw == "quick" else ()))
    assert not complaints, complaints
