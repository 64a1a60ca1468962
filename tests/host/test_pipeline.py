# SPDX-License-Identifier: MIT
"""A plan whose rooms work side by side on several cores has the bits of the one on one core."""

import json
import os
import signal
import subprocess
import sys

import cases
import judged
import numpy as np
import pytest
from command_line import pycnc
from sampling import cheap_first

from pycnc import kernel
from pycnc.bench import kernel as programs
from pycnc.errors import NckError
from pycnc.kernel import batches
from pycnc.planning import pipeline
from pycnc.planning.plan import Plan
from pycnc.program import Program

SLOPES = ("linear", "jerk")
FILES = {str(file): file for file in (*cases.RUNNING_FILES, *cases.THREAD_FILES)}
CASES = {str(case): case for case in cases.CASES}
FREE = [f"--set=axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]


def bits_of(planner):
    """Return all that a planner tells, as bytes."""
    why = planner.why
    return planner.totals.tobytes(), *(np.asarray(why[name]).tobytes() for name in sorted(why))


def on_one_core(program):
    """Return the bits of the kernel's own plan, or what it refuses."""
    planner = kernel.Planner(program.text, program.machine, ())
    try:
        for _ in planner.pieces():
            pass
    except NckError as cause:
        return cause.id
    return bits_of(planner)


def side_by_side(program, rows=100):
    """Return the bits of a plan whose rooms get so many blocks at a time; None: there is none."""
    with pipeline.Pipeline() as beside:
        for blocks in program.pieces():
            for begin in range(0, len(blocks), rows):
                beside.take(program.machine, blocks[begin : begin + rows].copy())
        planner = beside.end()
    return planner and bits_of(planner)


def same_bits(program, rows):
    """Compare both; a program of one block, or with threads, has no rooms side by side."""
    found = side_by_side(program, max(1, min(rows, program.block_count // 3)))
    is_parted = program.block_count > 1 and not program.has_threads
    assert found == (on_one_core(program) if is_parted else None)


@pytest.fixture
def two_cores(monkeypatch):
    """Let a plan have two cores, wherever the test runs."""
    monkeypatch.setattr(pipeline, "cores", lambda: 2)


@pytest.mark.sample(10)
@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("name", cheap_first(FILES, cases.DEAR_FILES))
def test_real_programs_have_the_same_bits(name, slope):
    if not FILES[name].path.exists():
        pytest.skip(f"{FILES[name].path} is not here: the corpus lies beside the repository")
    program = judged.load(FILES[name], [f"path.slope={slope}"]).check()
    same_bits(program, 1000)


@pytest.mark.sample(50)
@pytest.mark.parametrize("slope", [*SLOPES, "optimal"])
@pytest.mark.parametrize("name", CASES)
def test_cases_have_the_same_bits(name, slope):
    program = judged.load(CASES[name], [f"path.slope={slope}"]).check()
    same_bits(program, 100)


@pytest.mark.thorough
@pytest.mark.sample(3)
@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("text", [programs.relief(50_000), programs.arcs(40_000), programs.loop()],
                         ids=["relief", "arcs", "loop"])  # fmt: skip
def test_big_programs_are_planned_so_by_themselves(text, slope, two_cores):
    machine = programs.plain_machine(slope)
    with pipeline.beside() as beside:
        program = Program(text, machine, keep=False, beside=beside)
        read = Plan(program, keep=False, beside=beside)
    again, kept = Plan(program, keep=False), Plan(Program(text, machine), keep=False)
    whole = Plan(program)
    assert len(whole.cells) > 50_000 and len(read.cells) == 0
    for plan in (read, again, kept):
        assert plan.totals == whole.totals
        assert repr(plan.lost) == repr(whole.lost)


def test_points_without_text_have_the_same_bits(two_cores):
    points = np.column_stack([np.arange(40_000) * 0.01, np.sin(np.arange(40_000) * 0.01)])
    program = Program.from_points(points, 3000, programs.plain_machine("jerk"))
    assert Plan(program, keep=False).totals == Plan(program).totals


def test_rings_full_of_outputs_are_left_to_one_core(two_cores):
    text = b"G21 G90 G17 G94 G61 F600\nG1 X1\n" + b"M8\nM9\n" * 20_000 + b"G1 X2\nM2\n"
    program = Program(text, programs.plain_machine())
    assert side_by_side(program) is None
    assert Plan(program, keep=False).totals == Plan(program).totals


def test_what_goes_wrong_on_another_core_is_told(two_cores, monkeypatch):
    def refuse(self, batch):
        raise MemoryError("no more")

    monkeypatch.setattr(batches.Late, "take", refuse)
    program = Program(programs.relief(50_000), programs.plain_machine())
    with pytest.raises(MemoryError):
        Plan(program, keep=False)


def test_breaking_off_ends_the_threads(two_cores):
    program = Program(programs.relief(80_000), programs.plain_machine())
    with pytest.raises(KeyboardInterrupt), pipeline.Pipeline() as beside:
        for blocks in program.pieces():
            beside.take(program.machine, blocks)
        threads = list(beside._threads)
        raise KeyboardInterrupt
    assert len(threads) == 2 and not any(thread.is_alive() for thread in threads)


def test_in_a_process_beside_others_a_plan_has_one_core():
    code = "import multiprocessing as m\nfrom pycnc.planning.pipeline import cores\n"
    code += "if __name__ == '__main__':\n with m.get_context('spawn').Pool(1) as pool:\n"
    code += "  print(cores() > 0, pool.apply(cores))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stdout.split() == ["True", "1"], done.stderr


# The command line


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("verb", ["time", "why"])
def test_a_verb_says_the_same_on_any_number_of_cores(verb, tmp_path, monkeypatch):
    file = tmp_path / "big.ngc"
    file.write_bytes(programs.relief(50_000) + b"G1 X0\n")
    said = []
    for count in (1, 2):
        monkeypatch.setattr(pipeline, "cores", lambda count=count: count)
        for how in (["--json"], [], ["-q"]):
            said.append(pycnc(verb, *how, file, *FREE))
    facts = [json.loads(said[k].out) for k in (0, 3)]
    for each in facts:
        each.pop("plan_s", None)
    assert facts[0] == facts[1]
    assert said[1:3] == said[4:6]
    assert [each.code for each in said] == [0] * 6 and "after-end" in said[4].err


def test_an_error_behind_a_big_part_is_told_as_on_one_core(tmp_path, monkeypatch):
    file = tmp_path / "wrong.ngc"
    file.write_bytes(programs.relief(50_000).replace(b"M2\n", b"G1 X5 Q7\nM2\n"))
    said = []
    for count in (1, 2):
        monkeypatch.setattr(pipeline, "cores", lambda count=count: count)
        said += [pycnc("time", *how, file, *FREE) for how in (["--json"], [])]
    assert said[:2] == said[2:]
    assert said[0].code == 1


@pytest.mark.thorough
@pytest.mark.skipif(pipeline.cores() == 1, reason="one core: nothing works side by side")
def test_an_interrupt_exits_130_at_once(tmp_path):
    file = tmp_path / "big.ngc"
    file.write_bytes(programs.relief(1_500_000))
    process = subprocess.Popen(
        [sys.executable, "-m", "pycnc", "time", str(file), *FREE],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )  # fmt: skip
    while len(os.listdir(f"/proc/{process.pid}/task")) < 3:  # its threads are there
        assert process.poll() is None
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=10)
    assert (process.returncode, out) == (130, b"")
    assert b"Traceback" not in err
