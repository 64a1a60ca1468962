# SPDX-License-Identifier: MIT
"""A verb's memory grows by its program's text, and by little more: programs have millions of
lines."""

import functools
import subprocess
import sys
from pathlib import Path

import pytest
from cases import busy

from pycnc.bench.kernel import relief

LINES = (240_000, 420_000)  # a run plans beside: both go on when they hold the most
OF_A_PAGE = (700_000, 1_000_000)  # both have more points than a page holds
MANY, MOST = 2_000_000, 300 << 20  # lines; bytes of their plan, all cores at work
NOISE = 5 << 20  # bytes: what two runs differ by, and what is filled by the longer one only
# Bytes that a line costs besides its text.
# A run counts the ticks of each line; a report knows where each line ends.
OF_A_LINE = {"check": 0, "time": 0, "why": 0, "run": 20, "report": 40}
REPEATS = {"check": 1, "time": 1, "why": 1, "run": 4, "report": 1}
PEAK = """
import atexit, re, runpy, sys
def tell():
    with open("/proc/self/status") as status:
        print(re.search(r"VmHWM:\\s*(\\d+) kB", status.read())[1], file=sys.stderr)
atexit.register(tell)
runpy.run_module("pycnc", run_name="__main__")
"""

pytestmark = pytest.mark.skipif(
    not Path("/proc/self/status").exists(), reason="no /proc that tells a process's peak"
)


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    """Return the function that gives the path of a program of so many short moves, each at a speed
    of its own; the last line is worth a note."""
    folder = tmp_path_factory.mktemp("long")

    @functools.cache
    def program(count):
        path = folder / f"{count}.ngc"
        path.write_text(f"{busy(count)}G1 X0\n")
        return path

    return program


def peak(verb, path, *options):
    """Return the largest memory of a verb [bytes]."""
    command = [sys.executable, "-c", PEAK, verb, str(path), *options]
    command += ["-o", str(path.with_suffix(".html"))] if verb == "report" else []
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return int(done.stderr.split()[-1]) << 10


@pytest.mark.seldom(4, "pycnc/planning", "pycnc/program", "tests/host")
def test_two_million_lines_are_planned_in_300_mb(tmp_path):
    path = tmp_path / "long.ngc"
    path.write_bytes(relief(MANY))
    machine = [f"--set=axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
    assert peak("time", path, *machine) <= MOST


@pytest.mark.seldom(4, "pycnc/planning", "pycnc/program", "pycnc/report", "tests/host")
@pytest.mark.sample(2)
@pytest.mark.parametrize("verb", OF_A_LINE)
def test_memory_grows_by_the_text_and_little_more(verb, program):
    lines = OF_A_PAGE if verb == "report" else LINES
    paths = [program(count) for count in lines]
    # A peak depends on what a run's two threads hold at once: what grows does so in every repeat.
    repeats = [[peak(verb, path) for path in paths] for _ in range(REPEATS[verb])]
    less, more = max(first for first, _ in repeats), min(second for _, second in repeats)
    text = paths[1].stat().st_size - paths[0].stat().st_size
    allowed = text + OF_A_LINE[verb] * (lines[1] - lines[0]) + NOISE
    assert more - less <= allowed, f"{(more - less) / 2**20:.1f} MB for {text / 2**20:.1f} of text"
