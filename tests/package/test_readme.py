# SPDX-License-Identifier: MIT
"""The examples of README.md run as they stand there; what pages point to is there."""

import importlib.util
import pathlib
import re
import subprocess
import sys

import pytest

from pycnc import bench

ROOT = pathlib.Path(__file__).resolve().parents[2]


def example(language):
    (code,) = re.findall(rf"```{language}\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)
    return code


def test_the_python_example_tells_time_and_peak(tmp_path):
    run = subprocess.run(
        [sys.executable, "-c", example("python")],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
    )
    time_s, peak = map(float, run.stdout.split())
    # 40 + 10π + 30 mm at 50 mm/s take 2.03 s, and ramps and a slower arc a little more.
    assert 2.03 < time_s < 3.0
    assert 0.5 < peak <= 1.0 + 1e-6


@pytest.mark.seldom(4, "README.md", "csrc/nck/nck.h")
def test_the_c_example_compiles_alone_and_ends_on_its_end_point(tmp_path):
    source = tmp_path / "example.c"
    source.write_text(example("c"))
    command = ["cc", "-std=c99", "-Wall", "-Wextra", "-Werror", f"-I{ROOT / 'csrc'}"]
    kernel = sorted(map(str, (ROOT / "csrc" / "nck").rglob("*.c")))
    subprocess.run([*command, source, *kernel, "-lm", "-o", tmp_path / "example"], check=True)
    run = subprocess.run([tmp_path / "example"], capture_output=True, text=True, check=True)
    rows = [tuple(map(int, row.split())) for row in run.stdout.splitlines()]
    assert rows[-1] == (60_000_000, 20_000_000)
    assert max(abs(b[0] - a[0]) for a, b in zip(rows, rows[1:])) <= 50_001


def test_the_readme_fits_on_two_screens():
    assert len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()) <= 110


@pytest.mark.parametrize("name", ["README.md", "docs/why.md"])
def test_the_output_in_a_page_is_what_the_command_prints(name):
    spec = importlib.util.spec_from_file_location("make_pages", ROOT / "docs" / "make_pages.py")
    pages = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(pages)
    _, shown, _ = pages.split_output((ROOT / name).read_text(encoding="utf-8"))
    clock = r"simulated in .*"  # how busy this computer is
    now = re.sub(clock, "", pages.example_output(name))
    assert re.sub(clock, "", shown) == now, "run docs/make_pages.py"


# All pages

PAGES = sorted(
    ROOT / name
    for name in subprocess.run(
        ["git", "ls-files", "*.md"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.splitlines()
)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_what_a_page_links_to_is_there(page):
    targets = re.findall(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))
    assert [target for target in targets if not (page.parent / target).exists()] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_the_benches_that_a_page_names_exist(page):
    named = re.findall(r"pycnc lab bench ((?:[a-z]+(?: \| )?)+)", page.read_text(encoding="utf-8"))
    subjects = {subject for names in named for subject in names.split(" | ")}
    assert subjects <= set(bench.SUBJECTS)


def test_every_page_of_docs_is_found_from_the_readme():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    pages = [page.name for page in PAGES if page.parent == ROOT / "docs"]
    assert pages
    assert [name for name in pages if f"(docs/{name})" not in text] == []
