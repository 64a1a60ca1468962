# SPDX-License-Identifier: MIT
"""What the page draws of acceleration and jerk is what the axes feel: the ticks', as run's."""

import numpy as np
import pytest
from cases import CASES, DEAR_FILES, RUNNING_FILES, SEEDS
from test_report import PART, Unpacked, page_of

from pycnc import errors, load, run
from pycnc.machine import Machine
from pycnc.report import felt, page

SLOPES = ("jerk", "linear", "optimal")
DRAWN = 0.5e-3 + 1e-6  # of the limit: half a step of what the page tells
STOPS = (
    "G21 G90 G61.1\nG1 X10 F3000\nY10\nM2\n",
    "G21 G90 G64 P0.5\nG1 X10 F6000\nY10\nX0 Y0\nM2\n",
    "G21 G90 G64\nG0 X10\nG0 Y10\nG1 X0 F4000\nG4 P0.1\nG1 Y0\nM2\n",
)


def peaks_drawn(made):
    """Return track → kind → the largest number that is drawn, of the limit."""
    found = {}
    for track in made.facts["felt"]["tracks"]:
        name, found[track["name"]] = track["name"], {}
        for kind in "aj":
            least = made.column(f"felt_{name}_{kind}")
            largest = least + made.column(f"felt_{name}_{kind}_span")
            assert len(least) == made.facts["felt"]["bins"]
            found[name][kind] = max(-least.min(), largest.max())
    return found


def compare(program):
    """Hold the peaks that are drawn against those that `run` tells, and its rows."""
    done = run(program)
    if not any(told["a"] for told in done.summary["peaks"].values()):
        with pytest.raises(errors.ArgumentError, match="nothing moves"):
            page.make(program)
        return
    html, _ = page.make(program)
    drawn = peaks_drawn(Unpacked(html))
    assert set(drawn) <= {*program.machine.axes, "path"}
    for name, told in done.summary["peaks"].items():
        for kind in "aj":
            got = drawn.get(name, {"a": 0.0, "j": 0.0})[kind]
            assert got == pytest.approx(told[kind], rel=1e-2, abs=DRAWN), (name, kind)
    for k, letter in enumerate(program.machine.axes):
        for kind, column in (("a", "acc"), ("j", "jerk")):
            (name,) = (key for key in done.derived() if key.startswith(f"{column}_{letter}_"))
            rows = np.abs(done[name][3:])  # they do not tell the place before the first
            peak = rows.max(initial=0.0) / program.machine.limits(f"{kind}_max")[k]
            got = drawn.get(letter, {"a": 0.0, "j": 0.0})[kind]
            assert got >= 0.99 * peak - DRAWN, (letter, kind)


@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_the_peaks_that_are_drawn_are_those_of_the_run(case, slope):
    machine = Machine.load(case.machine, set=[*case.set, f"path.slope={slope}"])
    compare(load(case.text, machine))


@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("text", STOPS)
def test_at_stops_too(text, slope):
    compare(load(text, Machine.load("mill3", set={"path.slope": slope})))


@pytest.mark.parametrize("seed", SEEDS)
def test_at_corners_of_any_angle_as_the_axes_feel_it(seed):
    rng = np.random.default_rng([seed, 37])
    for slope in SLOPES:
        turns = np.cumsum(rng.uniform(0.2, 3.0, 6))
        places = np.cumsum(rng.uniform(0.5, 15, (6, 1)) * np.c_[np.cos(turns), np.sin(turns)], 0)
        mode = rng.choice(["G61", "G61.1", "G64", "G64 P0.05"])
        moves = "".join(f"G{rng.integers(2)} X{x:.3f} Y{y:.3f}\n" for x, y in places)
        text = f"G21 G90 {mode} F{rng.integers(500, 6000)}\n{moves}M2\n"
        compare(load(text, Machine.load("mill3", set={"path.slope": slope})))


@pytest.mark.thorough
@pytest.mark.parametrize(
    "file", [each for each in RUNNING_FILES if each.file not in DEAR_FILES], ids=str
)
def test_files_that_others_share_too(file):
    if not file.path.exists():
        pytest.skip(f"{file.path} is not here")
    compare(load(file.path, Machine.load(file.machine, set=file.set)))


@pytest.mark.parametrize("seed", SEEDS)
def test_bins_keep_the_least_and_the_largest_however_often_they_are_joined(seed):
    rng = np.random.default_rng([seed, 1])
    rows = rng.normal(size=(int(rng.integers(1, 3000)), 2))
    bins, done = felt.Bins(2, 1 << int(rng.integers(1, 9))), 0
    while done < len(rows):
        some = int(rng.integers(1, 500))
        bins.add(rows[done : done + some])
        done += some
    least, largest = bins.ends()
    for k in range(len(least)):
        piece = rows[k * bins.size : (k + 1) * bins.size]
        assert np.array_equal(least[k], piece.min(axis=0))
        assert np.array_equal(largest[k], piece.max(axis=0))
    assert (len(least) - 1) * bins.size < len(rows) <= len(least) * bins.size


def test_bins_are_joined_until_they_have_room(monkeypatch):
    whole = page_of(PART)
    monkeypatch.setattr(felt, "PACKED_MOST", 2000)
    less = page_of(PART)
    assert less.facts["felt"]["bin_s"] > whole.facts["felt"]["bin_s"]
    for name, told in peaks_drawn(whole).items():
        assert peaks_drawn(less)[name] == pytest.approx(told, abs=1e-9)
