# SPDX-License-Identifier: MIT
"""What is installed is what was locked, and what is shipped has its licences with it."""

import re
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LOCKS = ("requirements.lock", "requirements-test.lock")


@pytest.mark.parametrize("name", LOCKS)
def test_every_locked_package_has_its_version_and_its_hashes(name):
    text = (ROOT / name).read_text(encoding="utf-8").replace("\\\n", " ")
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    assert len(lines) > 20
    pinned = re.compile(r"[\w.-]+==[\w.]+( +--hash=sha256:[0-9a-f]{64})+")
    assert [line for line in lines if not pinned.fullmatch(line)] == []


def test_all_that_is_shipped_is_under_a_licence_whose_text_is_shipped():
    told = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    files = [ROOT / name for name in told["license-files"]]
    texts = {path.stem: path.read_text(encoding="utf-8") for path in files}
    assert "Permission is hereby granted, free of charge" in texts["LICENSE"]
    assert "GNU GENERAL PUBLIC LICENSE" in texts["GPL-2.0-or-later"]
    shipped = [*(ROOT / "pycnc").rglob("*.*"), *(ROOT / "adapters").rglob("*.*"),
               *(ROOT / "opencl").rglob("*.*"), *(ROOT / "csrc").rglob("*.*")]  # fmt: skip
    wanted = set()
    for path in shipped:
        if path.suffix in (".py", ".pyi", ".c", ".h", ".cl", ".html"):
            text = path.read_text(encoding="utf-8")
            wanted.update(re.findall(r"SPDX-License-Identifier: ([\w.-]+)", text[:300]))
    assert wanted == set(told["license"].split(" AND ")) == {"MIT", "GPL-2.0-or-later"}
