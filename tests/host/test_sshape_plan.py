# SPDX-License-Identifier: MIT
"""The classical S-shape over whole programs: N blocks of look-ahead, every promise kept at every
tick, acceleration zero at junctions, and what that costs (Cao et al. 2014, section 8)."""

import json
import re

import cases
import judged
import numpy as np
import pytest
from command_line import pycnc as command

import pycnc
from pycnc import kernel, stages
from pycnc.bench import optimum, programs
from pycnc.machine import Machine
from pycnc.papers import paths as papers
from pycnc.planning import sshape
from pycnc.planning.plan import for_plan
from pycnc.program import Program

LOOKAHEADS = range(11)
NAMES = (
    "square", "star", "full_circle", "helix", "tiny_circles", "zigzag", "reversals", "micrometres",
    "waits", "lathe_part", "rotary", "random_lines_0", "random_smooth_0", "random_arcs_1",
    "random_stops_0",
)  # fmt: skip
CASES = {case.name: case for case in cases.CASES if case.name in NAMES}
REFERENCE = cases.ROOT.parent / "shared" / "reference" / "paths" / "B1_butterfly.npz"


def planned(program, lookahead=None):
    """Return a program as the S-shape needs it, and its plan."""
    program = for_plan(program.check(), "sshape")
    motion, _ = sshape.of_text(
        program.text, program.machine, lookahead=lookahead, threads=program.has_threads
    )
    return program, motion


def run(program, lookahead=None):
    """Run a program by the S-shape under the checker's eyes."""
    program, motion = planned(program, lookahead)
    judged.run_whole(program, motion)


# Cao et al., section 8


@pytest.fixture(scope="module")
def lathe8():
    """Return the experiment's program."""
    machine = Machine.load("cao2014", set={"path.j_max_mm_s3": papers.lathe8().j_max})
    return Program(papers.lathe8_program().encode(), machine)


@pytest.fixture(scope="module")
def kernel_ms(lathe8):
    """Return the times of the experiment within the kernel's budget at junctions."""
    return [round(1000 * planned(lathe8, n)[1].totals["time_s"]) for n in LOOKAHEADS]


def test_two_look_ahead_segments_save_time_and_no_more_do(kernel_ms):
    assert kernel_ms[0] > kernel_ms[1] > kernel_ms[2]
    assert set(kernel_ms[2:]) == {kernel_ms[2]}


def test_it_takes_as_long_as_the_paper_s_path_but_for_the_budget_at_junctions(kernel_ms):
    """The reversal is passed at 2.7 mm/min and not at 0.75, the tick's filter takes 3 ms at each
    rest, and with N = 0 the zones beside the reversal cost 0.1 s."""
    path = papers.lathe8()
    whole = [path.segment_ms(path.profile("sshape", n)).sum() for n in LOOKAHEADS]
    assert kernel_ms[1:] == pytest.approx(whole[1:], abs=10)
    assert kernel_ms[0] == pytest.approx(whole[0], rel=0.015)


def test_the_table_has_these_times(kernel_ms):
    page = (cases.ROOT / "docs" / "papers.md").read_text(encoding="utf-8")
    row = re.search(r"^\| S-shape, `--plan sshape` \|.*$", page, re.MULTILINE).group()
    told = [int(cell.replace(" ", "")) for cell in row.split("|")[3:-1]]
    assert told == pytest.approx(kernel_ms[:4], abs=1)


@pytest.mark.parametrize("lookahead", [0, 1, 2, 10])
def test_the_experiment_keeps_every_promise(lathe8, lookahead):
    run(lathe8, lookahead)


def lines_of(rng):
    """Return collinear moves of random lengths and feeds: no junction between them costs speed."""
    steps = np.floor(1e3 * np.exp(rng.uniform(np.log(0.05), np.log(8), 60))) / 1e3
    feeds = np.floor(np.exp(rng.uniform(np.log(300), np.log(6000), 60)))
    moves = [f"G1 X{x:.3f} F{f:.0f}" for x, f in zip(steps.cumsum(), feeds, strict=True)]
    return steps, feeds / 60, "\n".join(["G21 G90 G61", *moves, "M2", ""])


@pytest.mark.parametrize("lookahead", range(12))
def test_n_blocks_of_look_ahead_are_those_of_segments(lookahead):
    """Rests cost whole periods and the filter's. Caps are lower by what is left to a filter."""
    steps, caps, text = lines_of(np.random.default_rng(lookahead))
    mill = Machine.load("mill3")
    limits = mill.record["axis"][0]
    nodes = np.r_[0, np.minimum(caps[:-1], caps[1:]), 0]
    whole = stages.slope(
        steps, caps, limits["a_max"], limits["j_max"], nodes, kind="sshape", lookahead=lookahead
    )
    _, motion = planned(Program(text.encode(), mill), lookahead)
    rests = np.count_nonzero(motion.cells()["stop"])
    more = motion.totals["time_s"] - whole.time_s
    assert -1e-3 <= more <= 4 * rests * mill.period_s + 1e-3 * whole.time_s


def test_the_look_ahead_is_the_machine_s_unless_it_is_told():
    program = for_plan(judged.load(CASES["random_lines_0"]), "sshape")
    three = Machine.load(program.machine, set={"path.lookahead_blocks": 3})
    asked = sshape.of_text(program.text, program.machine, lookahead=2)[0]
    given = sshape.of_text(program.text, three)[0]
    everything = sshape.of_text(program.text, program.machine)[0]
    assert given.cells().tobytes() == asked.cells().tobytes()
    assert everything.totals["time_s"] < asked.totals["time_s"]
    with pytest.raises(pycnc.errors.ArgumentError, match="lookahead is -1"):
        sshape.of_text(program.text, program.machine, lookahead=-1)


def test_one_block_of_look_ahead_stops_at_each():
    _, motion = planned(judged.load(CASES["random_lines_0"]), 0)
    blocks = len(np.unique(motion.segs["block"][motion.segs["length"] > 0]))
    assert np.count_nonzero(motion.cells()["stop"]) >= blocks


# Every promise


@pytest.mark.sample(quick=8)
@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("lookahead", [None, 0, 2])
def test_a_run_keeps_limits_path_and_stops(name, lookahead):
    run(judged.load(CASES[name]), lookahead)


@pytest.mark.sample(quick=6)
@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("tolerance", ["G64 P0.01", "G64 P0.1"])
def test_a_run_within_a_tolerance_keeps_limits_path_and_stops(name, tolerance):
    case = CASES[name]
    text = case.text.replace("G61\n", f"{tolerance}\n", 1)
    run(judged.load(cases.Case(name, text, case.machine, case.set)))


@pytest.mark.parametrize("name", ["star", "random_lines_0", "helix"])
def test_acceleration_is_zero_at_junctions_and_jerk_within_its_limit(name):
    program, motion = planned(judged.load(CASES[name]))
    cells = motion.cells()
    begins = np.append(True, cells["last"][:-1] == 1)
    end = cells["a"] + cells["j"] * cells["duration"]
    assert not cells["a"][begins].any()
    assert np.abs(end[cells["last"] == 1]).max() <= 1e-6 * np.abs(cells["a"]).max()
    assert np.abs(cells["j"]).max() <= program.machine.record["path"]["j_max"] * (1 + 1e-6)


def test_few_prep_steps_give_the_same_bytes():
    _, motion = planned(judged.load(CASES["helix"]))
    runs = []
    for prep_steps in (1, kernel.PREP_STEPS):
        simulation = sshape.Simulation(motion, prep_steps)
        rows = np.concatenate([rows.copy() for rows, _ in simulation.pieces()])
        runs.append(rows["pose"].tobytes())
        assert simulation.starved_ticks == 0
    assert runs[0] == runs[1]


@pytest.mark.parametrize("name", ["random_stops_0", "lathe_part"])
def test_outputs_come_in_the_same_order_as_by_the_kernel(name):
    program, motion = planned(judged.load(CASES[name]))
    told = []
    for simulation in (kernel.Simulation(program.text, program.machine), sshape.Simulation(motion)):
        rows = np.concatenate([rows.copy() for rows, _ in simulation.pieces()])
        changes = np.flatnonzero(np.diff(rows["spindle_rpm"], prepend=0.0))
        told.append((rows["spindle_rpm"][changes].tolist(), rows["pose"]["line"][changes].tolist()))
    assert told[0] == told[1]


def test_a_program_without_moves_takes_no_time():
    assert pycnc.plan("G21\nM2\n", plan="sshape").time_s == 0


# What it costs


def test_a_stop_of_acceleration_at_every_junction_costs_half_the_time_of_short_blocks():
    given = np.load(REFERENCE) if REFERENCE.exists() else None
    if given is None:
        pytest.skip("no reference paths here")
    problem = {name: given[key] for name, key in optimum.KEYS.items()}
    s_shape, jerk = (stages.slope(**problem, kind=kind).time_s for kind in ("sshape", "jerk"))
    assert 1.6 < s_shape / jerk < 1.7


@pytest.mark.thorough
def test_it_is_slower_on_short_blocks_than_the_kernel_s_carried_acceleration():
    plan = pycnc.plan(programs.butterfly("G61", 0.001), programs.machine("jerk"), plan="sshape")
    assert plan.time_s > 1.05 * plan.exact_time_s


def test_a_ramp_counts_as_speeding_up_or_braking_from_its_first_jerk_on():
    program, motion = planned(judged.load(CASES["helix"]))
    totals, cells = motion.totals, motion.cells()
    steady = (cells["a"] == 0) & (cells["j"] == 0) & (cells["length"] > 0)
    rests = 4 * np.count_nonzero(cells["stop"]) * program.machine.period_s
    assert totals["cruise_s"] == pytest.approx(cells["duration"][steady].sum(), abs=rests)
    assert totals["accelerate_s"] == pytest.approx(totals["decelerate_s"], rel=0.1)
    assert totals["limit_s"].sum() == pytest.approx(totals["time_s"])


# How it is asked for


@pytest.fixture
def part(tmp_path):
    """Return a file with a part that has corners."""
    file = tmp_path / "part.ngc"
    file.write_text("G21 G90 G1 X20 F3000\nY20\nM2\n", encoding="utf-8")
    return str(file)


@pytest.mark.parametrize(
    "words",
    [
        ["time", "--slope", "sshape"],
        ["time", "--set", "path.slope=sshape"],
        ["lab", "controller", "--set", "path.slope=sshape"],
    ],
)
def test_as_a_slope_it_is_refused_and_the_way_is_told(part, words):
    refused = command(*words, part)
    assert refused.code == 2 and "is a kind of planning" in refused.err
    assert "--plan sshape" in refused.err


def test_as_a_slope_of_a_call_it_is_refused_too(part):
    with pytest.raises(pycnc.errors.ArgumentError, match="plan='sshape'"):
        pycnc.plan(part, slope="sshape")


def test_an_operator_is_refused_and_the_way_is_told(part):
    with pytest.raises(pycnc.errors.ArgumentError, match='takes no commands.*plan="exact"'):
        pycnc.run(part, plan="sshape", commands=[(10, "hold")])


def test_what_only_an_exact_plan_tells_is_refused(part):
    with pytest.raises(pycnc.errors.ArgumentError, match="only an exact plan"):
        pycnc.plan(part, plan="sshape").why()
    assert "by the S-shape is not told by parts" in command(
        "lab", "time", part, "--plan", "sshape", "--by", "tool"
    ).err


def test_a_run_and_its_time_say_so_and_agree(part):
    how = ("--plan", "sshape", "--json")
    ran, timed = (command("lab", verb, part, *how) for verb in ("run", "time"))
    assert ran.code == timed.code == 0
    facts, told = json.loads(ran.out), json.loads(timed.out)
    assert facts["plan"] == told["plan"] == "sshape" and told["slope"] == "jerk"
    assert facts["time_s"] == told["time_s"]
    assert "planned by the S-shape" in command("lab", "time", part, "--plan", "sshape").out
