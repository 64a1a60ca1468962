# SPDX-License-Identifier: MIT
"""A change of a machine that changes nothing is told with its reason, and no other is."""

import pytest

from pycnc.machine import Machine
from pycnc.machine.effect import idle_changes, idle_keys


@pytest.mark.parametrize(
    ("changes", "plan", "told"),
    [
        (["path.slope=jerk"], "exact", {}),
        (["axis.x.max_mm=5", "path.tolerance_mm=0.1"], "exact", {}),
        (["axis.x.j_max_mm_s3=5e4"], "exact", {}),
        (["axis.x.j_max_mm_s3=5e4", "path.slope=linear"], "exact",
         {"axis.x.j_max_mm_s3=5e4": "does not limit it"}),
        (["path.slope=linear", "path.slope=jerk"], "exact",
         {"path.slope=linear": "path.slope=jerk comes behind it"}),
        (["path.slope=linear", "axis.x.j_max_mm_s3=5e4"], "sshape",
         {"path.slope=linear": "the S-shape is planned under"}),
        (["path.slope=optimal"], "exact", {}),
        (["path.slope=optimal", "path.a_max_mm_s2=2000"], "exact", {}),
        (["dialect.system=B"], "exact", {"dialect.system=B": "only dialect.base=fanuc"}),
        (["dialect.base=fanuc", "dialect.system=B"], "exact", {}),
        (["description=mine"], "exact", {"description=mine": "only lists"}),
        (["path.tolerance_mm=0.1", "path.slope=jerk"], "exact",
         {"path.tolerance_mm=0.1": "under the slope jerk the path is exact"}),
        (["path.tolerance_mm=0", "path.slope=linear"], "exact", {}),
        (["path.tolerance_mm=0.1", "path.slope=linear", "control.kind=linuxcnc"], "exact",
         {"path.slope=linear": "linuxcnc plans without it"}),
        (["path.tolerance_mm=0.1"], "grades", {"path.tolerance_mm=0.1": "grades are planned"}),
    ],
)  # fmt: skip
def test_a_change_without_effect_is_told_with_its_reason(changes, plan, told):
    found = dict(idle_changes(Machine.load("mill3", set=changes), plan))
    assert found.keys() == told.keys()
    assert all(told[change] in reason for change, reason in found.items())


@pytest.mark.parametrize(
    ("axes", "told"),
    [
        ({"path.j_max_mm_s3": ["1e5", "2e5"], "path.slope": ["linear"]}, ["path.j_max_mm_s3"]),
        ({"path.j_max_mm_s3": ["1e5", "2e5"], "path.slope": ["linear", "jerk"]}, []),
    ],
)
def test_a_key_of_a_grid_is_told_if_it_has_an_effect_at_no_point(axes, told):
    assert [key for key, _ in idle_keys(Machine.load("mill3"), axes)] == told
