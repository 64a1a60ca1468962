# SPDX-License-Identifier: MIT
"""The firmware on the host and on two Cortex-M under QEMU: the same setpoints everywhere, what is
told before a run, and the command line."""

import json
import math
import re
from dataclasses import replace
from pathlib import Path

import cases
import firmware_runs
import judged
import numpy as np
import pytest
from command_line import pycnc
from firmware_runs import ERROR, EVERYWHERE, POINTS, PROGRAM, mill

from pycnc import controller, errors
from pycnc.bench import families
from pycnc.machine import Machine
from pycnc.kernel.records import enum
from pycnc.planning.plan import Plan
from pycnc.program import Program

ROOT = Path(__file__).resolve().parents[2]
IDLE, WAIT = (enum("nck_tick_state_t")[name] for name in ("IDLE", "WAIT"))


@pytest.fixture(scope="session")
def controllers(tool):
    """Return the function that opens a controller by its name."""
    return lambda name: firmware_runs.opened(name, tool)


# The same setpoints everywhere

GOLDEN = [
    case for case in cases.CASES
    if case.name in (
        "square", "full_circle", "helix", "planes", "zigzag", "empty_moves", "waits", "rotary",
        "reversals", "outputs_alone", "random_arcs_0",
    )
]  # fmt: skip


def all_agree(outcomes):
    assert {each.state for each in outcomes} == {"done"}
    assert len({(each.hash, each.ticks, each.joints_nm) for each in outcomes}) == 1
    assert {each.overruns + each.starved_ticks for each in outcomes} == {0}


@pytest.mark.sample(4)
@pytest.mark.parametrize("case", GOLDEN, ids=str)
def test_setpoints_are_the_same_on_every_controller(controllers, case):
    machine = Machine.load(case.machine, set=[*case.set, "path.slope=linear"])
    all_agree([controllers(name).run(case.text, machine) for name in controller.CONTROLLERS])


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("case", GOLDEN, ids=str)
def test_jerk_limited_setpoints_are_the_same_on_host_and_m7(controllers, case):
    machine = Machine.load(case.machine, set=[*case.set, "path.slope=jerk"])
    all_agree([controllers(name).run(case.text, machine) for name in EVERYWHERE])


def test_jerk_limited_setpoints_are_the_same_on_an_m4f_that_is_fast_enough(controllers):
    (case,) = (each for each in GOLDEN if each.name == "planes")
    machine = Machine.load(case.machine, set=["path.slope=jerk"])
    outcomes = [
        controllers(name).run(case.text, machine, instruction_ns=1) for name in ("host", "m4f")
    ]
    all_agree(outcomes)


# The wrapper's capacities are larger. Under the linear slope that changes nothing for programs that
# fit into the firmware's window.
@pytest.mark.sample(quick=3)
@pytest.mark.parametrize("name", ["full_circle", "helix", "waits", "lathe_part", "rotary"])
def test_the_firmware_gives_what_the_python_wrapper_gives(controllers, name):
    (case,) = (each for each in cases.CASES if each.name == name)
    case = replace(case, set=(*case.set, "path.slope=linear"))
    rows = judged.rows_of(judged.load(case))
    machine = Machine.load(case.machine, set=case.set)
    outcome = controllers("host").run(case.text, machine, trace=True)
    joints = outcome.rows["joint_nm"][: len(rows)]
    assert np.array_equal(joints, rows["axes"]["joint_nm"][:, : joints.shape[1]])
    assert (outcome.rows["joint_nm"][len(rows) :] == joints[-1]).all()


def test_the_hash_is_that_of_the_setpoints(controllers):
    outcome = controllers("m7").run(cases.polyline(POINTS[:3]), mill(), trace=True)
    hashed = 14695981039346656037
    for row in outcome.rows[outcome.rows["tick_state"] != IDLE]:
        for byte in row["joint_nm"].tobytes():
            hashed = (hashed ^ byte) * 1099511628211 % 2**64
    assert outcome.hash == f"{hashed:016x}"


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("name", EVERYWHERE)
def test_every_wait_is_resumed_after_its_ticks(controllers, name):
    text = "G21 G90\nM0\nM0\nG1 F600 X1\nM0\nM2\n"
    outcome = controllers(name).run(text, mill(), trace=True, wait_ticks=30)
    assert outcome.state == "done" and outcome.joints_nm[0] == 1_000_000
    assert (outcome.rows["tick_state"] == WAIT).sum() == 90
    left_alone = controllers(name).run(text, mill(), wait_ticks=0)
    assert left_alone.state == "wait" and left_alone.joints_nm[0] == 0


def surface(rows=25, columns=400):
    """A milled surface: rows of short moves, to and fro."""
    points = []
    for row in range(rows):
        y = 0.5 * row
        xs = [0.12 * k for k in range(columns)][:: 1 if row % 2 == 0 else -1]
        points += [(x, y, 2 * math.sin(x / 7) * math.cos(y / 5)) for x in xs]
    return cases.polyline(points, feed=6000)


@pytest.mark.thorough
def test_ten_thousand_blocks_run_in_time_on_a_cortex_m7(controllers):
    text = surface()
    host, m7 = (controllers(name).run(text, mill("jerk")) for name in EVERYWHERE)
    assert text.count("G1 ") == 10_000
    assert host.state == m7.state == "done"
    assert m7.hash == host.hash and m7.joints_nm == host.joints_nm
    assert (m7.overruns, m7.underruns, host.overruns, host.underruns) == (0, 0, 0, 0)
    assert m7.wall_s < 60
    assert sum(m7.load.values()) < 1
    assert min(m7.stack_left.values()) > 0


def test_a_run_is_repeated_to_the_bit(controllers):
    commands = [(300, "hold"), (700, "resume"), (900, "override", 40, 100)]
    for name in EVERYWHERE:
        twice = [
            controllers(name).run(PROGRAM, mill(), commands, trace=True, prep_steps=9)
            for _ in range(2)
        ]
        assert np.array_equal(twice[0].rows, twice[1].rows)
        assert twice[0].facts == twice[1].facts


# What goes wrong before a run


@pytest.mark.parametrize("missing", ["arm-none-eabi-gcc", "qemu-system-arm"])
def test_a_missing_tool_is_named_with_its_remedy(monkeypatch, tmp_path, missing):
    file = tmp_path / "part.nc"
    file.write_text(PROGRAM)
    which = controller.shutil.which

    def look(name):
        return None if name == missing else which(name)

    monkeypatch.setattr(controller.shutil, "which", look)
    controller._build.cache_clear()
    result = pycnc("lab", "controller", file, "--on", "m7")
    assert result.code == 4
    assert re.search(rf"error\[controller\]: {missing} is not installed.*apt-get", result.err)


def test_what_the_controller_does_not_take_is_a_usage_error(controllers, tmp_path):
    file = tmp_path / "part.nc"
    file.write_text(PROGRAM)
    wrong = (["--at", "100 fly"], ["--at", "hold"], ["--at", "9 override 500 1"])
    for words in wrong:
        result = pycnc("lab", "controller", file, "--on", "host", *words)
        assert result.code == 2 and "pycnc: error[" in result.err
    assert pycnc("lab", "controller", file, "-o", "t.npz").code == 2
    assert pycnc("run", file, "--at", "100 hold").code == 2
    assert pycnc("lab", "controller", file, "--on", "m9").code == 2
    with pytest.raises(errors.ArgumentError):
        controllers("host").run(PROGRAM, prep_step=3)


def test_a_controller_takes_every_number_of_a_machine(root):
    known = (root / "firmware_sim" / "app" / "setting.c").read_text(encoding="utf-8")
    names = {name for name, *_ in controller._items("", mill().record)}
    missing = {name for name in names if f"({name}," not in known and f'"{name}"' not in known}
    pairs = {tuple(name.split(".", 1)) for name in missing if "." in name}
    assert [pair for pair in sorted(pairs) if f"RECORDS({', '.join(pair)}," not in known] == []
    assert sorted(name for name in missing if "." not in name) == []


@pytest.mark.thorough
def test_a_controller_that_does_not_end_is_given_up(controllers):
    silent = [(0, "feeder_pause", 4_000_000_000)]
    for name in EVERYWHERE:
        with pytest.raises(controller.FirmwareError, match="did not end"):
            controllers(name).run(PROGRAM, commands=silent, timeout_s=1)


@pytest.mark.sample(3)
@pytest.mark.parametrize("name", sorted(families.FAMILIES))
def test_the_firmware_smooths_as_the_module_does(controllers, name):
    """Its window is shorter: what that costs of the time is 5 % at most."""
    points = families.FAMILIES[name](np.random.default_rng([5, 1]))
    lines = [f"G1 X{x:.4f} Y{y:.4f} Z{z:.4f}" for x, y, z in points[:200] - points[0]]
    text = "\n".join(["G21 G90 G64 P0.02 F6000", *lines, "M2\n"])
    host, m7 = (controllers(each).run(text, "mill3") for each in ("host", "m7"))
    all_agree([host, m7])
    planned = Plan(Program(text.encode(), Machine.load("mill3")), keep=False).time_s
    assert 0.98 * planned < host.ticks * 0.001 < 1.05 * planned + 0.02


# The command line, and the page


def test_run_on_a_controller_tells_state_load_and_hash(controllers, tmp_path):
    file = tmp_path / "part.nc"
    file.write_text(PROGRAM)
    words = ["lab", "controller", file, "--on", "host", "--at", "400 hold", "--at", "900 resume"]
    facts = json.loads(pycnc(*words, "--json").out)
    assert facts["state"] == "done" and facts["controller"] == "host" and facts["overruns"] == 0
    assert [state for _, state in facts["events"]][-2:] == ["run", "done"]
    shown = pycnc(*words)
    assert shown.code == 0 and facts["hash"] in shown.out
    file.write_text(ERROR)
    wrong = pycnc("lab", "controller", file, "--on", "host")
    assert wrong.code == 1 and "error[unsupported]" in wrong.err


def test_the_page_about_the_controller_runs(controllers):
    page = (ROOT / "docs" / "controller.md").read_text(encoding="utf-8")
    controllers("m7")
    for code in re.findall(r"```python\n(.*?)```", page, re.S):
        exec(code, {})
