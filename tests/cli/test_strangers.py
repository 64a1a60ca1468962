# SPDX-License-Identifier: MIT
"""Strangers at the command line see no traceback, no error without a place, no time gone wrong."""

import pytest
import strangers


@pytest.mark.sample(40, quick=4)
@pytest.mark.parametrize("number", range(400))
def test_a_stranger_finds_nothing(number, draw_seed):
    found, calls = strangers.faults(draw_seed + number)
    assert not found, "\n".join(found)
    assert calls
