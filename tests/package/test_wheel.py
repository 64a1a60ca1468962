# SPDX-License-Identifier: MIT
"""The wheel, as strangers install it: in an empty environment of each Python, no compiler near."""

import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest
from locks import locked

ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
PYTHONS = ("3.11", "3.12", "3.13")
EXAMPLE = ROOT / "pycnc" / "examples" / "first_part.ngc"
PATIENCE_S = 600

pytestmark = pytest.mark.seldom(4, "cmake", "pyproject.toml", "page", "tests/package")


def call(*command, **options):
    """Return how a command ended, with what it said."""
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False,
                          timeout=PATIENCE_S, **options)  # fmt: skip


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """Return the wheel of the tree, its module compiled with little optimization."""
    folder = ROOT / "build" / "wheel"
    made = tmp_path_factory.mktemp("wheel")
    with locked(folder):
        done = call(sys.executable, "-m", "pip", "wheel", "-q", "--no-build-isolation", "--no-deps",
                    "-C", f"build-dir={folder}", "-C", "cmake.define.NCK_QUICK=ON", "-w", made,
                    ROOT)  # fmt: skip
    assert done.returncode == 0, done.stderr
    (file,) = made.glob("*.whl")
    return file


@pytest.fixture(scope="module")
def inside(wheel):
    """Return name → text of what the wheel says of itself."""
    with zipfile.ZipFile(wheel) as packed:
        told = [name for name in packed.namelist() if ".dist-info/" in name]
        texts = {name.split(".dist-info/")[1]: packed.read(name).decode() for name in told}
        return texts | {"names": packed.namelist()}


def python_of(version):
    """Return a Python of a version that is on this computer; None if there is none."""
    found = [shutil.which(f"python{version}")]
    found += (Path.home() / ".pyenv" / "versions").glob(f"{version}.*/bin/python{version}")
    for each in filter(None, found):
        done = call(each, "-c", "import ensurepip, sys; print(*sys.version_info[:2], sep='.')")
        if done.returncode == 0 and done.stdout.strip() == version:
            return each
    return None


@pytest.mark.parametrize("version", PYTHONS)
def test_an_empty_environment_makes_a_page_without_a_compiler(wheel, tmp_path, version):
    python = python_of(version) or pytest.skip(f"NOT TRIED: there is no Python {version} here")
    assert call(python, "-m", "venv", tmp_path / "venv").returncode == 0
    programs = tmp_path / "venv" / "bin"
    bare = {"PATH": str(programs), "HOME": str(tmp_path), "CC": "/no/compiler"}
    bare |= {name: value for name, value in os.environ.items() if name.startswith("PIP_")}
    bare |= {"PIP_CONFIG_FILE": config} if (config := pip_config()) else {}
    done = call(programs / "pip", "install", "-q", "--only-binary", ":all:", wheel, env=bare)
    if "No matching distribution" in done.stderr or "onnection" in done.stderr:
        pytest.skip(f"NOT TRIED: no package index gives what pycnc needs: {done.stderr[-300:]}")
    assert done.returncode == 0, done.stderr
    shutil.copy(EXAMPLE, tmp_path / "part.ngc")
    done = call(programs / "pycnc", "report", "part.ngc", cwd=tmp_path, env=bare)
    assert done.returncode == 0, done.stderr
    page = (tmp_path / "part.html").read_text(encoding="utf-8")
    assert page.startswith("<!doctype html>") and '"file": "part.ngc"' in page
    done = call(programs / "pycnc", "lab", "bench", "tick", cwd=tmp_path, env=bare)
    assert (done.returncode, done.stdout) == (2, "")
    assert "pycnc.bench is in the source tree alone" in done.stderr


def pip_config():
    """Return the file by which this computer's pip finds its packages; None: it needs none."""
    listed = call(sys.executable, "-m", "pip", "config", "debug").stdout
    found = re.findall(r"^\s+(/\S+), exists: True", listed, re.M)
    return found[-1] if found else None


def test_one_wheel_serves_every_python_from_the_first_on(wheel):
    least = PROJECT["project"]["requires-python"].removeprefix(">=").replace(".", "")
    assert f"-cp{least}-abi3-" in wheel.name
    assert PROJECT["tool"]["cibuildwheel"]["build"] == f"cp{least}-*"


def test_what_it_is_made_of_is_told(inside):
    told = json.loads(inside["sboms/pycnc.cdx.json"])
    assert (told["bomFormat"], told["specVersion"]) == ("CycloneDX", "1.5")
    parts = {part["name"]: part for part in told["components"]}
    page = json.loads((ROOT / "page/package.json").read_text(encoding="utf-8"))["devDependencies"]
    head = (ROOT / "pycnc/report/page.js").read_text(encoding="utf-8")[:4000]
    bundled = {name for name in page if f"{name} {page[name]}" in head}
    assert bundled == {"three", "uplot"}
    assert {name: parts[name]["version"] for name in bundled} == {n: page[n] for n in bundled}
    needed = {re.match(r"[\w-]+", each)[0]: each for each in PROJECT["project"]["dependencies"]}
    assert set(parts) == bundled | set(needed)
    for name, words in needed.items():
        assert parts[name]["description"].endswith(words.removeprefix(name))
    whole = told["metadata"]["component"]
    version = re.search(r"^Version: (.*)$", inside["METADATA"], re.M)[1]
    assert (whole["name"], whole["version"]) == (PROJECT["project"]["name"], version)
    assert whole["licenses"] == [{"expression": PROJECT["project"]["license"]}]
    refs = {part["bom-ref"] for part in told["components"]}
    assert set(told["dependencies"][0]["dependsOn"]) == refs


def test_it_has_its_licences_and_no_more_than_it_needs(inside):
    for name in PROJECT["project"]["license-files"]:
        assert inside[f"licenses/{name}"] == (ROOT / name).read_text(encoding="utf-8")
    rooms = {name.split("/")[0] for name in inside["names"]}
    assert {room for room in rooms if not room.endswith(".dist-info")} == {"pycnc"}
    unasked = re.compile(r"__pycache__|/tests/|^pycnc/(?:bench|papers)/")
    assert [name for name in inside["names"] if unasked.search(name)] == []
    for name in ("report/page.js", "report/page.html", "report/page.css", "report/palette.json"):
        assert f"pycnc/{name}" in inside["names"]
