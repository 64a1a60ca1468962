# SPDX-License-Identifier: MIT
"""Room 1: what a plain line costs in instructions, and that macros have not made it dearer."""

import re
import subprocess

import pytest

COMPILER = "12.2.0"  # what the numbers below were counted with, -O2 on x86-64
INSTRUCTIONS = {"line": 1262, "modal": 922, "arc": 3228}  # a line
BEFORE_MACROS = {"line": 1917, "modal": 1416, "arc": 3185}
WITHIN, MOST = 0.05, 1.02


@pytest.fixture(scope="module")
def plain_lines(root, tool, tmp_path_factory):
    """Return the program that decodes plain lines, compiled alike everywhere."""
    compiler = tool("gcc")
    version = subprocess.run([compiler, "-dumpfullversion"], capture_output=True, text=True)
    if version.stdout.strip() != COMPILER:
        pytest.skip(f"instructions were counted with gcc {COMPILER}")
    binary = tmp_path_factory.mktemp("cost") / "plain_lines"
    sources = [root / "tests/c/plain_lines.c", *(root / "csrc/nck/base").glob("*.c")]
    sources += (root / "csrc/nck/prep/1_decode").glob("*.c")
    options = ["-std=c99", "-O2", "-ffp-contract=off", f"-I{root / 'csrc'}", "-o", binary]
    subprocess.run([compiler, *options, *sources, "-lm"], check=True)
    return binary


def instructions(valgrind, binary, kind, count):
    command = [valgrind, "--tool=callgrind", "--toggle-collect=decode_all"]
    command += ["--callgrind-out-file=/dev/null", binary, kind, str(count)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return int(re.search(r"Collected : (\d+)", done.stderr)[1])


@pytest.mark.parametrize("kind", INSTRUCTIONS)
def test_a_plain_line_costs_what_the_table_says(kind, plain_lines, tool):
    valgrind = tool("valgrind")
    few, many = (instructions(valgrind, plain_lines, kind, count) for count in (1000, 3000))
    cost = (many - few) / 2000
    assert cost == pytest.approx(INSTRUCTIONS[kind], rel=WITHIN)
    assert cost <= MOST * BEFORE_MACROS[kind]
