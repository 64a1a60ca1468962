# SPDX-License-Identifier: MIT
"""Plans with the capacities of the planner module for LinuxCNC, by records of this build."""

import re

import pytest

import pycnc
from pycnc.bench import programs
from pycnc.kernel.bind import build_of, lib
from pycnc.machine import Machine
from pycnc.planning.plan import Plan
from pycnc.program import Program

COUNT = 3000  # chords: more than the module's window, and than this build's knots


@pytest.fixture(scope="module")
def module():
    return Machine.load(programs.machine(), set=["control.kind=nck_tp"])


def planned(text, machine, **how):
    return Plan(Program(text, machine), **how)


def test_records_of_one_build_serve_the_other():
    own, other = build_of("nck"), build_of("nck_tp")
    for name in ("machine_size", "cut_size", "told_size", "sim_size"):
        assert getattr(own, name) == getattr(other, name) > 0
    assert other.plan_size < own.plan_size
    assert other.kernel_size < own.kernel_size


def test_its_capacities_are_the_makefiles(root):
    text = (root / "adapters/linuxcnc/Makefile").read_text(encoding="utf-8")
    told = dict(re.findall(r"-D(NCK_WINDOW|NCK_CELL_MAX|NCK_CLOCKED)=(\d+)", text))
    assert len(told) == 3
    assert all(int(size) < getattr(lib, name) for name, size in told.items())


def test_a_plan_of_it_is_whole(module):
    text = programs.micro("G64 P0.01", COUNT)
    kept, alone = planned(text, module), planned(text, module, keep=False)
    assert kept.time_s == alone.time_s == pytest.approx(planned(text, programs.machine()).time_s,
                                                        rel=0.02)
    assert kept.as_dict()["control"] == "nck_tp"
    assert len(kept.segs) == kept.totals["segments"]
    assert sum(kept.totals["limit_time_s"].values()) == pytest.approx(kept.time_s)


def test_it_plans_and_runs_with_less_ahead(module):
    text = programs.zigzag("G64 P0.01", 60, 10.0)
    time_s = planned(text, module, keep=False).time_s
    assert time_s != planned(text, programs.machine(), keep=False).time_s
    assert pycnc.run(text, machine=module).summary["time_s"] == pytest.approx(time_s, abs=1e-9)


def test_its_parts_and_reasons_are_told(module):
    text = programs.micro("G61", 200)
    whole = planned(text, module, by="line", keep=False)
    assert sum(part["time_s"] for part in whole.parts) == pytest.approx(whole.time_s)
    assert whole.why().causes
