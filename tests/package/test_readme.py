# SPDX-License-Identifier: MIT
"""The examples of README.md run as they stand there; what pages point to is there."""

import importlib.util
import pathlib
import re
import subprocess
import sys

import pytest
import sampling

from pycnc import bench

ROOT = pathlib.Path(__file__).resolve().parents[2]


def make_pages():
    """Return docs/make_pages.py as a module."""
    spec = importlib.util.spec_from_file_location("make_pages", ROOT / "docs" / "make_pages.py")
    pages = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(pages)
    return pages


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


@pytest.fixture(scope="module")
def in_c(tmp_path_factory):
    """Return a function that runs the C example with other text: (rows, what it tells)."""
    folder = tmp_path_factory.mktemp("in_c")
    script = [sys.executable, ROOT / "cmake" / "amalgamate.py", "--out", folder / "nck"]
    subprocess.run(script, check=True)
    command = ["cc", "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", f"-I{folder}"]
    subprocess.run([*command, "-c", folder / "nck" / "nck.c", "-o", folder / "nck.o"], check=True)

    def run(text=None):
        code = example("c")
        if text is not None:
            literal = "\n".join(f'"{line}\\n"' for line in text.splitlines())
            code, found = re.subn(r'(?<=text\[\] = )".*"', lambda _: literal, code)
            assert found == 1
        (folder / "example.c").write_text(code)
        program = [folder / "example.c", folder / "nck.o", "-lm", "-o", folder / "example"]
        subprocess.run([*command, *program], check=True)
        done = subprocess.run(
            [folder / "example"], capture_output=True, text=True, check=True, timeout=120
        )
        rows = [tuple(map(int, row.split())) for row in done.stdout.splitlines()]
        return rows, done.stderr.splitlines()

    return run


@pytest.mark.seldom(4, "README.md", "csrc/nck/nck.h")
def test_the_c_example_compiles_alone_and_ends_on_its_end_point(in_c):
    rows, told = in_c()
    assert rows[-1] == (60_000_000, 20_000_000)
    assert max(abs(b[0] - a[0]) for a, b in zip(rows, rows[1:])) <= 50_001
    assert told == []


@pytest.mark.seldom(4, "README.md", "csrc/nck/nck.h")
def test_the_c_example_runs_programs_of_any_length_to_their_end(in_c, request):
    rng = sampling.generator(request.config, "the C example")
    for lines in (0, 1, rng.randrange(300, 3000), rng.randrange(3000, 9000)):
        way = [f"G1 X{rng.uniform(0, 9):.3f} Y{rng.uniform(0, 9):.3f}" for _ in range(lines)]
        for k in range(0, lines, 500):
            way[k] = rng.choice(["M0", "G4 P0.1", "S100 M3", "M6 T1"])
        rows, told = in_c("\n".join(["G21 G90 G61 F3000", *way, "G1 X7 Y5", "M2"]))
        assert rows[-1] == (7_000_000, 5_000_000)
        assert told == []


@pytest.mark.seldom(4, "README.md", "csrc/nck/nck.h")
def test_the_c_example_tells_an_error_and_runs_what_stands_before_it(in_c, request):
    rng = sampling.generator(request.config, "an error in the C example")
    good = rng.randrange(1, 3000)
    way = [f"G1 X{k % 7} Y{k % 5}" for k in range(good)]
    rows, told = in_c("\n".join(["G21 G90 G61 F3000", *way, "G1 X9 Q1", *way, "M2"]))
    assert told == [f"line {good + 2}: word-unused"]
    assert rows[-1] == ((good - 1) % 7 * 1_000_000, (good - 1) % 5 * 1_000_000)


def test_the_readme_fits_on_two_screens():
    assert len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()) <= 110


@pytest.mark.parametrize("name", ["README.md", "docs/why.md"])
def test_the_output_in_a_page_is_what_the_command_prints(name):
    pages = make_pages()
    _, shown, _ = pages.split_output((ROOT / name).read_text(encoding="utf-8"))
    now = pages.renewed(shown, pages.example_output(name), timing=False)
    assert shown == now, "run docs/make_pages.py"


def test_the_running_time_in_the_readme_is_renewed_if_it_is_asked_for():
    pages = make_pages()
    shown, now = "1 s\nsimulated in 1.28 s (75 times)\n", "2 s\nsimulated in 3 s (32 times)\n"
    assert pages.renewed(shown, now, timing=True) == now
    assert pages.renewed(shown, now, timing=False) == "2 s\nsimulated in 1.28 s (75 times)\n"


def test_make_pages_heeds_help_and_writes_nothing():
    before = (ROOT / "README.md").stat().st_mtime_ns
    script = [sys.executable, ROOT / "docs" / "make_pages.py"]
    told = subprocess.run([*script, "--help"], capture_output=True, text=True, check=True).stdout
    assert "--timing" in told
    assert subprocess.run([*script, "--nonsense"], capture_output=True).returncode == 2
    assert (ROOT / "README.md").stat().st_mtime_ns == before


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
