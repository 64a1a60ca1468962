# SPDX-License-Identifier: MIT
"""Without the extras: what pip installs for no extra is enough, and what is absent is named."""

import json
import subprocess
import sys
from importlib import metadata

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

PROGRAM = b"G21 G90 G17 G54\nG1 X10 F600\nM2\n"
BLOCK = """
import sys
class Absent:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {absent} or name in {rooms}:
            raise ModuleNotFoundError(f"No module named {{name!r}}", name=name)
sys.meta_path.insert(0, Absent())
"""


def installed():
    """Return the distributions that pip installs with pycnc-nck and no extra."""
    found, left = set(), ["pycnc-nck"]
    while left:
        name = canonicalize_name(left.pop())
        if name in found:
            continue
        found.add(name)
        wanted = map(Requirement, metadata.requires(name) or ())
        left += [
            each.name for each in wanted
            if each.marker is None or each.marker.evaluate({"extra": ""})
        ]  # fmt: skip
    return found


@pytest.fixture(scope="module")
def bare():
    """Return a function that runs Python code, with arguments, where no extra is installed."""
    there = installed()
    absent = {
        module
        for module, names in metadata.packages_distributions().items()
        if not there & {canonicalize_name(name) for name in names}
    }
    assert {"matplotlib", "pyarrow", "pyopencl"} <= absent

    def run(code, *arguments, rooms=(), **options):
        block = BLOCK.format(absent=absent, rooms=rooms)
        command = [sys.executable, "-c", block + code, *map(str, arguments)]
        return subprocess.run(command, capture_output=True, timeout=120, **options)

    return run


COMMAND = "from pycnc.cli import main; main()"


@pytest.mark.thorough
def test_the_command_line_needs_no_extra(bare):
    assert bare(COMMAND, "--help").returncode == 0
    for verb in ("check", "lab canon", "time", "run"):
        done = bare(COMMAND, *verb.split(), "--json", "-", input=PROGRAM)
        assert (done.returncode, done.stderr) == (0, b""), verb
    assert b"What holds it back" in bare(COMMAND, "run", "-", input=PROGRAM).stdout


def test_programs_are_loaded_planned_and_run_without_an_extra(bare):
    code = f"""
import json, pycnc
program = pycnc.load({PROGRAM!r})
print(json.dumps([pycnc.plan(program).time_s, pycnc.run(program).summary["time_s"]]))
"""
    done = bare(code)
    planned, run = json.loads(done.stdout)
    assert planned == run > 1


@pytest.mark.sample(quick=2)
@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (["plot", "-", "-o", "x.png"], 2, 'pip install "pycnc-nck[plot]"'),
        (["run", "-", "--plot", "x.png"], 2, 'pip install "pycnc-nck[plot]"'),
        (["run", "-", "-o", "x.parquet"], 2, 'pip install "pycnc-nck[trace]"'),
        (["lab", "bench", "cao", "-o", "figures"], 2, 'pip install "pycnc-nck[plot]"'),
        (["lab", "bench", "bounds"], 2, 'pip install "pycnc-nck[bounds]"'),
        (["lab", "time", "-", "--plan", "grades", "--backend", "opencl"], 4, "pycnc-nck[opencl]"),
    ],
)
def test_what_is_absent_is_named_in_one_sentence(bare, arguments, code, words, tmp_path):
    done = bare(COMMAND, *arguments, input=PROGRAM, cwd=tmp_path)
    lines = done.stderr.decode().splitlines()
    assert (done.returncode, done.stdout, len(lines)) == (code, b"", 1)
    assert words in lines[0]
    assert list(tmp_path.iterdir()) == []


def test_benches_are_of_the_tree(bare):
    done = bare(COMMAND, "lab", "bench", "tick", rooms=["pycnc.bench"])
    said = (b"pycnc: error[absent]: pycnc.bench is in the source tree alone: "
            b"run this in a checkout of pycnc\n")  # fmt: skip
    assert (done.returncode, done.stdout, done.stderr) == (2, b"", said)


def test_a_picture_without_matplotlib_is_an_error_of_the_family(bare):
    code = f"""
import pycnc
try:
    pycnc.run({PROGRAM!r}).plot()
except pycnc.AbsentError as cause:
    print(cause)
"""
    assert b'pip install "pycnc-nck[plot]"' in bare(code).stdout
