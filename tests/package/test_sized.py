# SPDX-License-Identifier: MIT
"""A caller and a library of different capacities or versions do not link, and no build ignores the
capacities that it is given.
"""

import json
import random
import re
import shlex
import subprocess
from pathlib import Path

import pytest
from builds import CMAKE, NINJA

ROOT = Path(__file__).resolve().parents[2]
CSRC = ROOT / "csrc"
LIMITS = (CSRC / "nck" / "base" / "limits.h").read_text(encoding="utf-8")
DEFAULTS = dict(re.findall(r"^#ifndef (NCK_\w+)\n#define \1 (\d+)$", LIMITS, re.M))
POWERS = [2**k for k in range(5, 13)]
# Other values of each that limits.h takes beside the defaults of the rest.
VALUES = {
    "NCK_AXIS_MAX": range(3, 10), "NCK_LINE_MAX": range(80, 5000), "NCK_TOOL_MAX": range(1, 1001),
    "NCK_OWN_M_MAX": range(1, 1001), "NCK_VARIABLES": range(5000), "NCK_CALL_DEPTH": range(1001),
    "NCK_LANGUAGE": range(5), "NCK_CYCLES": range(2),
    "NCK_CONTOUR": [0, *range(8, 1000)], "NCK_COMP_SPAN": [0, 16, *POWERS],
    "NCK_WINDOW": POWERS[4:], "NCK_CORNER_SPAN": [2, 4, 8, 32],
    "NCK_FILTER_TAPS": range(1, 17), "NCK_PROFILE": [0, *POWERS],
    "NCK_CLOCKED": [0, 64, 72, 80, 88, *range(104, 160, 8)], "NCK_CELL_MAX": [16, 32, 64],
}  # fmt: skip
CALLER = """
#include "nck/nck.h"
static nck_machine_t machine;
static double memory[120000];
int main(void) {
    nck_t *const kernel = nck_place(memory, sizeof memory);
    nck_machine_default(&machine);
    return nck_init(kernel, &machine, NULL) == NCK_OK ? 0 : 1;
}
"""
OUTER = """
cmake_minimum_required(VERSION 3.25)
project(outer LANGUAGES C)
set(NCK_CAPACITIES "{capacities}")
{set}
add_subdirectory("{root}" nck EXCLUDE_FROM_ALL)
add_library(sizes STATIC "{root}/tests/package/project/sizes.c")
target_link_libraries(sizes PRIVATE nck::nck)
"""


def call(*command, **options):
    """Run a command; return what it prints, or fail with its words."""
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, **options)
    if done.returncode != 0:
        pytest.fail(f"{command}\n{done.stdout}{done.stderr}", pytrace=False)
    return done.stdout


@pytest.fixture(scope="module")
def library(kernel_build):
    """Return the library in its default capacities."""
    return kernel_build[0] / "libnck.a"


@pytest.fixture
def links(library, tool, tmp_path):
    """Return a function: "" if a caller of so defined capacities links, else the linker's words."""

    def link(*definitions, include=CSRC):
        (tmp_path / "caller.c").write_text(CALLER)
        options = ["-std=c99", *definitions, f"-I{include}"]
        call(tool("gcc"), *options, "-c", tmp_path / "caller.c", "-o", tmp_path / "caller.o")
        command = [tool("gcc"), tmp_path / "caller.o", library, "-lm", "-o", tmp_path / "caller"]
        return subprocess.run(command, capture_output=True, text=True).stderr

    return link


def test_every_capacity_is_tried():
    assert VALUES.keys() == DEFAULTS.keys()


def test_a_caller_of_the_same_capacities_links_and_runs(links, tmp_path):
    assert links() == ""
    assert links(*(f"-D{name}={value}" for name, value in DEFAULTS.items())) == ""
    call(tmp_path / "caller")


@pytest.mark.sample(6, quick=2)
@pytest.mark.parametrize("name", VALUES)
def test_a_caller_of_another_capacity_does_not_link(links, draw_seed, name):
    values = [value for value in VALUES[name] if str(value) != DEFAULTS[name]]
    value = random.Random(f"{draw_seed} {name}").choice(values)
    said = links(f"-D{name}={value}")
    for function in ("nck_machine_default", "nck_init"):
        found = re.search(rf"undefined reference to .({function}_v\w+)'", said)
        assert found, f"{name}={value} links"
        assert re.search(rf"[a-z]{value}(_|$)", found[1])


def test_a_caller_of_another_version_does_not_link(links, tmp_path):
    folder = tmp_path / "include"
    for path in (CSRC / "nck").rglob("*.h"):
        copy = folder / path.relative_to(CSRC)
        copy.parent.mkdir(parents=True, exist_ok=True)
        text = path.read_text(encoding="utf-8")
        copy.write_text(re.sub(r"(NCK_VERSION_MINOR) \d+$", r"\1 77", text, flags=re.M))
    assert "undefined reference to `nck_init_v0_77_axes9" in links(include=folder)


def test_the_headers_have_the_version_of_the_project():
    version = re.search(r"project\(nck VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
    text = (CSRC / "nck" / "base" / "version.h").read_text(encoding="utf-8")
    parts = re.findall(r"^#define NCK_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", text, re.M)
    assert ".".join(parts) == version


# As a subproject


def configured(folder, capacities, setting=""):
    """Configure a project that has libnck as its part; return the finished process."""
    text = OUTER.format(capacities=capacities, root=ROOT, set=setting)
    folder.mkdir(exist_ok=True)
    (folder / "CMakeLists.txt").write_text(text)
    command = [CMAKE, "-S", folder, "-B", folder / "build", "-G", "Ninja"]
    command += [f"-DCMAKE_MAKE_PROGRAM={NINJA}", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"]
    return subprocess.run(command, capture_output=True, text=True)


def kernel_size(folder, name):
    """Return sizeof(nck_t) as a file of the project sees it, compiled as the project would."""
    found = json.loads((folder / "build" / "compile_commands.json").read_text())
    (row,) = (row for row in found if row["file"].endswith(name))
    words = shlex.split(row["command"])
    sizes = str(ROOT / "tests" / "package" / "project" / "sizes.c")
    words[words.index("-o") + 1 :] = [str(folder / "sizes.o"), "-c", sizes]
    call(*words, cwd=row["directory"])
    rows = call("nm", "-S", folder / "sizes.o")
    return int(re.search(r"^\w+ (\w+) \w kernel_size$", rows, re.M)[1], 16)


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("setting", ["", "set(SKBUILD 2)"])
def test_a_subproject_has_the_capacities_that_it_is_given(tmp_path, setting):
    done = configured(tmp_path / "small", "SMALL", setting)
    assert done.returncode == 0, done.stderr
    done = configured(tmp_path / "list", "NCK_AXIS_MAX=3;NCK_TOOL_MAX=8", setting)
    assert done.returncode == 0, done.stderr
    seen = [[kernel_size(tmp_path / name, file) for file in ("sizes.c", "nck/nck.c")]
            for name in ("small", "list")]  # fmt: skip
    assert seen[0][0] == seen[0][1] < seen[1][0] == seen[1][1]


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("wrong", ["SMAL", "NCK_TOOLS=8", "NCK_TOOL_MAX=0x8", "NCK_TOOL_MAX"])
def test_a_subproject_refuses_capacities_that_there_are_not(tmp_path, wrong):
    done = configured(tmp_path / "wrong", wrong)
    assert done.returncode != 0
    assert f"no capacity like {wrong}" in " ".join(done.stderr.split())
