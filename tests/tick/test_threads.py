# SPDX-License-Identifier: MIT
"""Threads: in step with the spindle to the nanometre, within limits, and lost only out loud."""

import re
import shutil
import subprocess

import cases
import numpy as np
import pytest

from pycnc import kernel
from pycnc.machine import Machine
from pycnc.program import Program

LINUXCNC = ("dialect.base=linuxcnc",)
FACE = 300.0  # [mm] Z of the program's zero
EXACT, UNEVEN = (0.0, 0.0, 1.0), (0.3, 0.02, 0.7)  # spindles: late [s], ripple, over turns
PASS = "G21 G18 G90 G40\nM3 S{rpm}\nG0 X20 Z5\nG33 Z-60 K1.5\nG0 X30\nZ5\nM2\n"
LEAD, LINE = 1.5, 4


def load(text, *change):
    machine = Machine.load("cak6150n", set=change)
    return Program(text.encode(), machine, file="thread")


def fanuc(lines, *change):
    head = "G21 G18 G99 G97 S800 M3\nG0 X24. Z5.\n"
    return load(f"{head}{lines}\nM30\n", "dialect.system=A", *change)


def run(program, spindle=None, commands=()):
    """Return (rows, simulation) of a program that has no errors."""
    assert not [each for each in program.diagnostics if each.severity == "error"]
    simulation = kernel.Simulation(program.text, program.machine, 4, commands, spindle)
    return np.concatenate([rows.copy() for rows, _ in simulation.pieces()]), simulation


def passes(program):
    """Return the blocks of all passes."""
    return program.blocks[program.blocks["kind"] == 8]


def peaks(rows, period=1e-3):
    """Return the largest speed, acceleration and jerk of X and Z, sampled."""
    at = rows["pose"]["axis"][:, [0, 2]]
    return [np.abs(np.diff(at, n, axis=0)).max() / period**n for n in (1, 2, 3)]


def run_in_mm(v, a=1000 / 1.05**2, j=20_000 / 1.05**3):
    """Return how far a pass runs in, or a little more [mm]: with v/a + a/j to its speed."""
    return 0.5 * v * max(v / a + a / j, 2 * (v / j) ** 0.5) + 1e-9


def beside_helix(rows, line, start):
    """Return how far Z is from the helix of a tool that starts at full speed at angle 0 [mm], and
    which ticks are in the full thread: behind the run-in, before the run-out."""
    pose = rows["pose"]
    of_line = pose["line"] == line
    z = np.where(of_line, pose["axis"][:, 2], np.nan)
    run_in = run_in_mm(pose["feed"][of_line].max())
    full = (z < np.nanmax(z) - run_in) & (z > np.nanmin(z) + run_in)
    leads = (pose["axis"][full, 2] - FACE - start) / LEAD + rows["spindle_turns"][full]
    return (leads - np.round(leads)) * LEAD, full


# In step


@pytest.mark.parametrize("slope", ["linear", "jerk"])
@pytest.mark.parametrize("rpm", [300, 600, 1200])
@pytest.mark.parametrize("spindle, most_mm", [(EXACT, 1e-3), (UNEVEN, 5e-3)])
def test_the_full_thread_is_on_the_helix_of_a_start_at_full_speed(slope, rpm, spindle, most_mm):
    rows, simulation = run(load(PASS.format(rpm=rpm), *LINUXCNC, f"path.slope={slope}"), spindle)
    error, full = beside_helix(rows, LINE, 5.0)
    assert full.sum() * 1e-3 * rpm / 60 * LEAD > 55  # [mm] of 65
    assert np.abs(error).max() <= most_mm
    assert (simulation.end, simulation.thread_lost) == ("done", False)
    assert rows["pose"]["axis"][rows["pose"]["line"] == LINE][-1, 2] == FACE - 60


@pytest.mark.parametrize("rpm", [300, 600, 1200])
def test_a_pass_keeps_the_limits_of_the_axes(rpm):
    rows, _ = run(load(PASS.format(rpm=rpm), *LINUXCNC))
    _, a, j = peaks(rows[rows["pose"]["line"] == LINE])
    assert a <= 1000 and j <= 20_000


@pytest.mark.parametrize("angle", [0, 90_000, 180_000, 270_500])
def test_q_is_the_angle_at_the_start(angle):
    program = fanuc(f"G32 Z-30 F1.5 Q{angle}")
    rows, _ = run(program, EXACT)
    error, _ = beside_helix(rows, 3, 5.0 + LEAD * angle / 360e3)
    assert np.abs(error).max() <= 1e-3


def test_all_passes_of_a_cycle_cut_one_groove():
    program = fanuc("G76 P020060 Q100 R0.05\nG76 X18.05 Z-20. P920 Q300 F1.5")
    rows, _ = run(program, UNEVEN)
    at = rows["pose"]["axis"]
    depth = 12 - at[:, 0] - (12 - 9.945)  # below the crest
    flank = FACE + 5 - np.tan(np.radians(30)) * depth  # along it the passes begin further on
    run_in = run_in_mm(rows["pose"]["feed"][rows["pose"]["kind"] == 5].max())
    full = (rows["pose"]["line"] == 4) & (rows["pose"]["kind"] == 5)
    full &= (at[:, 2] < flank - run_in) & (at[:, 2] > FACE - 20 + 3)  # before it pulls out
    leads = ((at[:, 2] - flank) / LEAD + rows["spindle_turns"])[full]
    assert len(np.unique(rows["pose"]["block"][full])) == len(passes(program)) > 8
    assert np.abs(leads - np.round(leads)).max() * LEAD <= 1e-5


# Out of the thread


@pytest.mark.parametrize("slope", ["linear", "jerk"])
def test_the_tool_pulls_out_within_its_limits_and_stays_in_step_until_then(slope):
    program = fanuc("G92 X18.2 Z-20 F1.5", f"path.slope={slope}")
    rows, _ = run(program, EXACT)
    pose, z = rows["pose"], rows["pose"]["axis"][:, 2] - FACE
    cuts = pose["kind"] == 5
    _, a, j = peaks(rows[cuts])
    assert a <= 1000 and (slope == "linear" or j <= 20_000)
    begins = np.flatnonzero(cuts & (pose["axis"][:, 0] > 9.1 + 1e-9) & (z < 4))[0]
    assert z[begins] == pytest.approx(-20 + LEAD, abs=0.05)  # a lead before the end
    assert rows["pose"]["axis"][cuts][-1, [0, 2]].tolist() == [12.0, FACE - 20]


def test_the_tool_goes_in_over_the_taper_at_the_begin():
    lines = "G76 P1.5 Z-20 I-3 J0.3 K0.92 R2 Q29.5 H1 E4 L3\n"
    text = f"G21 G18 G90 G8\nM3 S800\nG0 X15 Z5\n{lines}M2\n"
    rows, _ = run(load(text, *LINUXCNC, "dialect.diameter=false"), EXACT)
    last = rows[rows["pose"]["block"] == rows["pose"]["block"][rows["pose"]["kind"] == 5][-1]]
    x, z = last["pose"]["axis"][:, 0], last["pose"]["axis"][:, 2] - FACE
    assert x[0] == 12 and x.min() == pytest.approx(11.08, abs=1e-12)
    begin = 5 - 0.92 * np.tan(np.radians(29.5))
    assert begin - z[np.flatnonzero(x < 11.0801)[0]] == pytest.approx(4, abs=0.3)
    _, a, j = peaks(last)
    assert a <= 1000 and j <= 20_000


# What operators do


@pytest.fixture(scope="module")
def plain():
    """Return the rows of a pass that nobody touches, and its ticks."""
    rows, _ = run(load(PASS.format(rpm=1200), *LINUXCNC))
    return rows, np.flatnonzero(rows["pose"]["kind"] == 5)


@pytest.mark.parametrize("command", [("hold",), ("override", 0, 0), ("override", 200, 100)])
@pytest.mark.parametrize("after", [60, 1000, 2200])
def test_hold_and_override_wait_for_the_end_of_the_pass(plain, command, after):
    rows, ticks = plain
    again = ("resume",) if command == ("hold",) else ("override", 100, 100)
    begin = int(ticks[0])
    held, simulation = run(
        load(PASS.format(rpm=1200), *LINUXCNC),
        commands=[(begin + after, *command), (begin + 8000, *again)],
    )
    assert (held["pose"]["axis"][ticks] == rows["pose"]["axis"][ticks]).all()
    assert (simulation.end, simulation.thread_lost) == ("done", False)
    assert (len(held) > 8000) == (command != ("override", 200, 100))


@pytest.mark.parametrize("slope", ["linear", "jerk"])
@pytest.mark.parametrize("after", [*range(30, 130, 7), 1000, 2150, 2190, 2210])
def test_an_abort_stops_at_once_within_the_limits_and_says_that_the_thread_is_lost(slope, after):
    program = load(PASS.format(rpm=1200), *LINUXCNC, f"path.slope={slope}")
    at = int(np.flatnonzero(run(program)[0]["pose"]["kind"] == 5)[0]) + after
    rows, simulation = run(program, commands=[(at, "abort")])
    pose = rows["pose"][at - 1 :]
    v, a, j = peaks(rows[at - 4 :])
    assert v <= 31.5 and a <= 1000 * (1 + 1e-9) and (slope == "linear" or j <= 20_000)
    assert len(pose) < 140  # [ms] the run-in takes 84
    assert (np.diff(pose["axis"][:, 2]) <= 0).all() and pose["axis"][-1, 2] >= FACE - 60
    assert (pose["state"][-1], simulation.end) == (5, "aborted")
    assert simulation.thread_lost == (FACE - 60 < pose["axis"][0, 2] < FACE + 5)


def test_a_hold_before_the_angle_begins_no_pass_until_it_is_over(plain):
    rows, ticks = plain
    begin = int(ticks[0])
    held, simulation = run(
        load(PASS.format(rpm=1200), *LINUXCNC), EXACT,
        [(begin + 2, "hold"), (begin + 3000, "resume")],
    )  # fmt: skip
    waits = held["pose"][begin + 2 : begin + 3000]
    assert (waits["state"] == 5).all() and (waits["v"] == 0).all()
    assert (waits["axis"] == rows["pose"]["axis"][begin]).all()
    assert (simulation.end, simulation.thread_lost) == ("done", False)
    assert np.abs(beside_helix(held, LINE, 5.0)[0]).max() <= 1e-3


def test_a_hold_before_the_angle_that_nobody_ends_ends_the_run(plain):
    begin = int(plain[1][0])
    rows, simulation = run(load(PASS.format(rpm=1200), *LINUXCNC), commands=[(begin + 2, "hold")])
    assert (simulation.end, simulation.thread_lost) == ("hold", False)
    assert (rows["pose"]["axis"][-1] == plain[0]["pose"]["axis"][begin]).all()


def test_an_abort_before_the_angle_loses_nothing():
    program = load(PASS.format(rpm=60), *LINUXCNC)
    begin = int(np.flatnonzero(run(program)[0]["pose"]["kind"] == 5)[0])
    rows, simulation = run(program, commands=[(begin + 3, "abort")])
    assert (simulation.end, simulation.thread_lost) == ("aborted", False)
    assert rows["pose"]["axis"][-1, 2] == FACE + 5


def test_a_spindle_that_is_too_fast_to_follow_loses_the_thread_and_nothing_follows():
    program = load(PASS.format(rpm=600), *LINUXCNC)
    rows, simulation = run(program, (0.0, 0.3, 1000.0), [(20_000, "resume")])
    assert simulation.thread_lost and simulation.end == "aborted"
    at = rows["pose"]["axis"]
    assert (at[-1, [0]] == at[rows["pose"]["kind"] == 5][0, [0]]).all()  # never drawn out
    assert np.abs(np.diff(at[:, 2], 2)).max() <= 1e-3 * (1 + 1e-9)  # [mm] no jump: 1000 mm/s²


def test_a_spindle_that_slows_down_takes_the_tool_along_and_stopping_loses_the_thread():
    program = load(PASS.format(rpm=600), *LINUXCNC)
    machine, text = program.machine, program.text
    simulation = kernel.Simulation(text, machine, 4, [(9000, "abort")], (0.05, 0.9, -200.0))
    rows = np.concatenate([rows.copy() for rows, _ in simulation.pieces()])
    pose = rows["pose"][rows["pose"]["kind"] == 5]
    speed = np.diff(rows["spindle_turns"])[-len(pose) :] / 10e-3  # over 10 turns/s at 600 rpm
    slow = (pose["state"] == 1) & (speed < 0.2) & (pose["v"] > 0)
    assert slow.any() and (speed[slow] > 0.09).all()
    assert pose["v"][slow] == pytest.approx(speed[slow] * pose["feed"][slow], rel=0.01)
    assert simulation.thread_lost
    assert np.abs(np.diff(rows["pose"]["axis"][:, 2], 2)).max() <= 1e-3 * (1 + 1e-9)


# What cannot be cut is told before anything moves


def finding(program):
    (error,) = [each for each in program.diagnostics if each.severity == "error"]
    return error


def test_too_short_a_run_in_is_told_with_what_it_needs():
    error = finding(fanuc("G32 W-0.5 F2"))
    assert error.id == "thread-run-in"
    needs = float(re.search(r"takes ([\d.]+) mm", error.message)[1])
    assert not fanuc(f"G32 W-{needs + 0.001:.3f} F2").blocks["line"][-1] == 3
    assert [each.id for each in fanuc(f"G32 W-{needs + 0.001:.3f} F2").diagnostics] == []
    assert finding(fanuc(f"G32 W-{needs - 0.002:.3f} F2")).id == "thread-run-in"


@pytest.mark.parametrize(
    "lines, name",
    [
        ("G32 Z-20 F20", "thread-speed"),
        ("G96 S100\nG32 Z-20 F1", "thread-speed"),
        ("M5\nG32 Z-20 F1", "thread-speed"),
        ("S0.0001\nG32 Z-20 F1", "thread-speed"),
        ("G32 Z-20", "word-missing"),
        ("G32 Z-20 F0", "number-range"),
        ("G32 Z-20 F1 Q400000", "number-range"),
        ("G92 X20 Z-20", "word-missing"),
        ("G92 X0 Z0", "word-missing"),
        ("G92", "word-missing"),
        ("G92 Z-20 F1", "word-missing"),
        ("G76 X20 Z-20 P1000 Q100 F1", "word-missing"),
        ("G76 P020061 Q100 R0", "number-range"),
        ("G76 P020060 Q100 R0\nG76 X20 Z-20 P1.5 Q100 F1", "number-range"),
        ("G76 X20. Z-20. K1. D300 F1.", "number-range"),
        ("G76 X20. Z-20. K1. D0.00001 F1.", "number-range"),
        ("G32 Z-400 F1", "travel"),
        ("G42 X20 Z-1 F1\nG32 Z-9 F1", "comp-on"),
    ],
)
def test_what_cannot_be_cut_is_one_finding(lines, name):
    assert finding(fanuc(lines)).id == name


@pytest.mark.parametrize(
    "lines",
    [
        "G33 Z-20",
        "G76 P1 Z-20 J.2 K1",
        "G76 P1 Z-20 I-1 J.2 K1 R.5",
        "G76 P1 Z-20 I[-10**200] J.2 K1",
    ],
)
def test_rs274ngcs_forms_need_their_words(lines):
    program = load(f"G21 G18 G90\nM3 S500\nG0 X24 Z5\n{lines}\nM2\n", *LINUXCNC)
    assert finding(program).id in ("word-missing", "number-range")


def test_a_mill_that_speaks_fanucs_language_has_no_threads():
    machine = Machine.load("mill3", set=("dialect.base=fanuc",))
    program = Program(b"G21\nM3 S500\nG33 Z-20 F1\nM30\n", machine, file="t")
    assert finding(program).id == "unsupported"


# Cycles


def depths(program, crest):
    """Return how deep the passes of a cycle are, as X has it [mm]."""
    cut = passes(program)
    x = (cut["target_nm"][:, 0] + cut["tool_nm"][:, 0]) * 1e-6 - cut["thread"]["leave"]
    return crest - x


def test_two_lines_cut_by_roots_down_to_the_least_step_and_the_allowance():
    program = fanuc("G76 P021060 Q100 R0.05\nG76 X16.933 Z-25. P1534 Q400 F2.5")
    got = depths(program, 16.933 / 2 + 1.534)
    want, depth = [], 0.0
    while depth < 1.534 - 0.05:
        depth = min(max(0.4 * np.sqrt(len(want) + 1), depth + 0.1), 1.534 - 0.05)
        want.append(depth)
    assert got == pytest.approx([*want, 1.534, 1.534], abs=2e-6)


def test_one_line_cuts_by_roots_of_d():
    text = "G20 G18 G99\nG97 S900 M3\nG0 X1. Z.2\nG76 X.7387 Z-.75 K.0682 D.012 F.1111 A60\nM30\n"
    program = load(text, "dialect.system=A")
    want = np.minimum(0.012 * np.sqrt(np.arange(1, 34)), 0.0682) * 25.4
    assert depths(program, 25.4 * (0.7387 / 2 + 0.0682)) == pytest.approx(want, abs=2e-6)
    assert passes(program)["thread"]["lead"] == pytest.approx(0.1111 * 25.4)


def test_a_thread_cycle_holds_and_ends_where_it_began():
    program = fanuc("G92 X19.4 Z-20 F1.5\nX18.9\nX18.6 R-0.5\nG0 X40")
    assert depths(program, 12.0) == pytest.approx([12 - 9.7, 12 - 9.45, 12 - 9.3])
    x = program.blocks["target_nm"][program.blocks["kind"] == 0][:, 0] * 1e-6
    assert x == pytest.approx([12, 9.7, 12, 9.45, 12, 8.8, 12, 20])  # a taper begins deeper
    assert (program.blocks["target_nm"][-2, [0, 2]] * 1e-6).tolist() == [20, FACE + 5]


def test_nothing_pulls_out_where_the_machine_says_so():
    block = passes(fanuc("G92 X19.4 Z-20 F1.5", "dialect.thread_pull_leads=0"))
    assert block["thread"]["leave"].tolist() == [0]
    assert block["target_nm"][0, 0] == 9_700_000


@pytest.mark.parametrize("mode, letters", [("G7", "L0"), ("G8", "L0"), ("G8", "L2 E1.5")])
def test_rs274ngcs_cycle_cuts_where_rs274_does(mode, letters, tmp_path):
    if not shutil.which("rs274"):
        pytest.skip("rs274 is not installed")
    text = (
        f"G21 G18 G90 {mode}\nM3 S800\nG0 X15 Z5\n"
        f"G76 P1.5 Z-20 I-3 J0.3 K0.92 R1.8 Q29.5 H2 {letters}\nG0 X40\nM2\n"
    )
    path = tmp_path / "t.ngc"
    path.write_text(text)
    heard = subprocess.run(["rs274", "-g", path], capture_output=True, text=True, check=True).stdout
    cuts = re.findall(r"STRAIGHT_FEED\(([-\d.]+), [-\d.]+, ([-\d.]+)", heard)
    change = (*LINUXCNC, f"dialect.diameter={str(mode == 'G7').lower()}")
    program = load(text, *change)
    assert not [each for each in program.diagnostics if each.severity == "error"]
    cut = passes(program)
    x = cut["target_nm"][:, 0] * 1e-6 - cut["thread"]["leave"]
    theirs = np.array(cuts, float)
    deepest = theirs[:, 0].reshape(len(cut), -1).min(axis=1)
    ends = theirs[:, 1].reshape(len(cut), -1).min(axis=1)
    assert x == pytest.approx(deepest, abs=1e-4)
    assert cut["target_nm"][:, 2] * 1e-6 - FACE == pytest.approx(ends, abs=1e-4)


# Programs of shops

SHARED = cases.CORPUS.parent
PROGRAMS = {
    "corpus/lathe_g76_thread_part.ngc": (
        *LINUXCNC, "dialect.diameter=false", "tool.9.radius_mm=0.2",
    ),
    "programs/lathe_g96_g76.ngc": LINUXCNC,
}  # fmt: skip


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_program_with_threads_runs(name):
    path = SHARED / name
    if not path.exists():
        pytest.skip(f"{path} is not here")
    program = load(path.read_text(), *PROGRAMS[name])
    rows, simulation = run(program, UNEVEN)
    assert (simulation.end, simulation.thread_lost) == ("done", False)
    v, a, _ = peaks(rows)
    assert v <= 250 * (1 + 1e-9) and a <= 1000 * (1 + 1e-6)


@pytest.mark.parametrize(
    "lines", ["G92 X23 Z5 F1", "G76 P020060 Q100 R0.05\nG76 X20 Z5 P920 Q300 F1"]
)
def test_a_pass_of_no_length_is_told(lines):
    assert finding(fanuc(lines)).id in ("thread-run-in", "word-missing", "number-range")
