# SPDX-License-Identifier: MIT
"""Pictures of the page in docs: small, shown, and made again by their script."""

import importlib.util
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FIGURES = ROOT / "docs" / "figures"


@pytest.fixture(scope="module")
def script():
    """Return the module docs/make_screenshot.py."""
    pytest.importorskip("playwright.sync_api", reason="playwright is absent: NO PICTURE WAS MADE")
    place = ROOT / "docs" / "make_screenshot.py"
    spec = importlib.util.spec_from_file_location("make_screenshot", place)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_pictures_are_small_and_shown(script):
    shown = re.findall(r"figures/(report\w*)\.png", (ROOT / "docs/report.md").read_text("utf-8"))
    assert sorted(shown) == sorted([*script.SHOTS, "report_strip"])
    for name in shown:
        assert 10_000 < (FIGURES / f"{name}.png").stat().st_size < script.MOST


@pytest.mark.seldom(4, "docs/make_screenshot.py", "page/src")
def test_the_script_makes_them_again(script, tool, tmp_path):
    from PIL import Image

    tool("chromium")
    names = ["report_dark", "report_strip"]
    script.make(names, tmp_path)
    for name in names:
        sizes = []
        for folder in (FIGURES, tmp_path):
            with Image.open(folder / f"{name}.png") as image:
                sizes.append(image.size)
        assert sizes[0] == sizes[1]
