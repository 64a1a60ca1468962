# SPDX-License-Identifier: MIT
"""A disk that is full: what cannot be written whole leaves nothing, and is told in one line."""

import os
import resource
import subprocess
import sys

import pytest
from cases import star

MOST = 200  # bytes that a file may have: the system refuses the next one, as a full disk does
# Python 3.11 takes what it could write of a compiled module for all of it, and that stays.
NOTHING_COMPILED = {"PYTHONDONTWRITEBYTECODE": "1"}


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    ("verb", "words", "name"),
    [
        ("report", (), "page.html"),
        ("why", (), "why.csv"),
        ("run", (), "run.csv"),
        ("run", (), "run.npz"),
        ("run", (), "run.parquet"),
        ("plot", (), "picture.png"),
        ("plot", (), "picture.svg"),
        ("sweep", ("--set", "path.slope=jerk,linear"), "sweep.csv"),
        ("machine new", (), "my.toml"),
    ],
)
def test_what_a_full_disk_cannot_take_leaves_no_half_file(verb, words, name, tmp_path):
    (tmp_path / "part.ngc").write_text(star(chord=1.0))
    place = tmp_path / "out"
    place.mkdir()
    done = subprocess.run(
        [sys.executable, "-m", "pycnc", *verb.split(), tmp_path / "part.ngc", "-o", place / name,
         *words],
        capture_output=True, text=True, check=False, env=os.environ | NOTHING_COMPILED,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (MOST, MOST)),
    )  # fmt: skip
    assert done.returncode == 2, done.stderr
    assert done.stderr.count("error[file]: cannot write it: File too large") == 1
    assert "Traceback" not in done.stderr
    assert list(place.iterdir()) == []
