# SPDX-License-Identifier: MIT
"""An override that comes down by little at a time, at any feed, is heard each time."""

import numpy as np
import pytest

import pycnc

LIMITS = (("v_max_mm_s", 100), ("rapid_mm_s", 100), ("a_max_mm_s2", 1000), ("j_max_mm_s3", 1e4))
SET = {f"axis.{axis}.{name}": value for axis in "xyz" for name, value in LIMITS}
FREE = {f"axis.{axis}.{end}_mm": "free" for axis in "xyz" for end in ("min", "max")}
BEGINS, EVERY, STEPS = 800, 150, 10  # ticks of 1 ms; ten steps of 1 %
HEARD = 140  # ticks behind one
NEAR = 1e-3  # of the speed; what is not heard is a step off, 10 times that


@pytest.mark.parametrize("feed", np.geomspace(10, 600, 12).round(2))
def test_each_step_of_a_falling_override_is_heard(feed):
    machine = pycnc.Machine.load("mill3", set={**SET, **FREE, "path.slope": "jerk"})
    program = pycnc.load(f"G21 G90 G94 G61\nG1 F{feed} X{feed / 15:.4f}\nM2\n", machine=machine)
    falls = [(BEGINS + EVERY * k, "override", 100 - k, 100) for k in range(1, STEPS + 1)]
    speed = np.diff(pycnc.run(program, commands=falls)["s_mm"]) * 60e3
    shares = [speed[at + HEARD] / feed for at, *_ in falls]
    assert shares == pytest.approx([percent / 100 for _, _, percent, _ in falls], rel=NEAR)
