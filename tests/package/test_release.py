# SPDX-License-Identifier: MIT
"""What a release says of itself: one version, one licence, whoever reads it."""

import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CITATION = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(nck VERSION ([0-9.]+)", text)[1]


def test_one_version_is_told_by_all():
    assert re.search(r"^version: (.*)$", CITATION, re.M)[1] == version()
    changes = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    assert re.search(r"^## ([0-9.]+)", changes, re.M)[1] == version()


def test_a_version_is_told_in_sixty_lines():
    changes = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    versions = re.split(r"^## ", changes, flags=re.M)[1:]
    assert [each.split()[0] for each in versions if each.rstrip().count("\n") >= 60] == []


def test_the_licences_are_those_of_the_sources():
    cited = re.findall(r"^  - ([\w.-]+)$", CITATION.split("license:")[1].split("keywords")[0], re.M)
    assert " AND ".join(cited) == PROJECT["license"]
    used = set()
    for folder in ("csrc", "pycnc", "firmware_sim", "adapters", "opencl"):
        for file in (ROOT / folder).rglob("*.[chp]*"):
            head = file.read_bytes()[:300].decode(errors="replace")
            used |= set(re.findall(r"SPDX-License-Identifier: ([\w.-]+)", head))
    assert used == set(cited)
    for name in PROJECT["license-files"]:
        assert (ROOT / name).is_file()


def test_every_python_that_is_promised_is_within_the_bound():
    named = [each.rpartition(" ")[2] for each in PROJECT["classifiers"] if "Python :: 3." in each]
    least = PROJECT["requires-python"].removeprefix(">=")
    assert named
    assert named[0] == least
    assert PROJECT["authors"][0]["name"] in CITATION


def test_what_no_machine_here_can_try_is_told():
    page = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    told = page.split("## A release")[1].split("\n## ")[0]
    wheels = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"][
        "cibuildwheel"]  # fmt: skip
    for platform, words in (("linux", "Linux aarch64"), ("macos", "macOS"), ("windows", "Windows")):
        assert wheels[platform]["archs"]
        assert f"| {words} |" in told
    assert f"`{PROJECT['name']}`" in told
    assert ("urls" in PROJECT) == ("url:" in CITATION), "addresses come together"
    for name in re.findall(r"`(test_\w+\.py)`", told):
        assert (ROOT / "tests" / "package" / name).is_file()
