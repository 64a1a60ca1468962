# SPDX-License-Identifier: MIT
"""The journeys of docs/journeys.md run as they stand there, and write what they promise."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "journeys.md").read_text(encoding="utf-8")
# Journey: (what it writes, what the terminal tells).
WRITES = {
    "A mill": (["part.html", "part.png", "my_mill.toml"], ["what if", "T1"]),
    "A lathe": (["pin.html", "pin.csv"], ["peak", "what if"]),
    "A printer": (["cube.html"], ["klipper", "what if", "a_max_mm_s2"]),
    "A laser": (["field_0.html", "field_5.html", "lines_0.txt"], ["laser"]),
}


def script(name):
    """Return the script of a journey."""
    (section,) = [each for each in PAGE.split("\n## ") if each.startswith(f"{name}:")]
    (block,) = re.findall(r"^```sh\n(.*?)^```", section, re.M | re.S)
    return block


def test_every_journey_is_here():
    assert re.findall(r"^## (A \w+):", PAGE, re.M) == list(WRITES)


@pytest.mark.seldom(4, "docs/journeys.md", "pycnc/cli")
@pytest.mark.parametrize("name", WRITES)
def test_a_journey_runs_as_it_stands(name, tmp_path):
    files, words = WRITES[name]
    programs = Path(sys.executable).parent
    space = os.environ | {"PATH": f"{programs}:{os.environ['PATH']}", "COLUMNS": "100"}
    done = subprocess.run(["sh", "-eu", "-c", script(name)], cwd=tmp_path, env=space, text=True,
                          capture_output=True)  # fmt: skip
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    for file in files:
        assert (tmp_path / file).stat().st_size > 1000, file
    for word in words:
        assert word.lower() in done.stdout.lower() + done.stderr.lower(), word
