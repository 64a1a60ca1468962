# SPDX-License-Identifier: MIT
"""The C code under two compilers, a static analyser and the sanitizers, and its unit tests."""

import re
import subprocess
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
C_TESTS = sorted(path.stem for path in (ROOT / "tests" / "c").glob("test_*.c"))
FUZZ_TARGETS = sorted(path.stem for path in (ROOT / "tests" / "fuzz").glob("*.c"))
FUZZ_RUNS = {"decode": 200_000, "kernel": 5_000}
FUZZ_FLAGS = {"kernel": ["-len_control=0", "-max_len=600"]}  # long inputs at once
CAPACITIES = ("", "_small")
# Builds that leave out rooms and planners, and the tests that they are built with.
LEAN = [
    f"{name}_{lean}"
    for lean in ("linear", "jerk")
    for name in ("test_decode_motion", "test_interpolate", "test_left_out", "test_link")
]


def run_c_test(folder, name):
    """Run a C test program; fail with its own words."""
    executable = folder / name
    if not executable.exists():
        pytest.fail(f"{name} was not built", pytrace=False)
    done = subprocess.run([executable], capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        pytest.fail(f"{done.stdout}{done.stderr}", pytrace=False)


def test_gcc_has_no_warning(gcc_build):
    _, complaints = gcc_build
    assert not complaints, complaints


def test_clang_has_no_warning(clang_build):
    _, complaints = clang_build
    assert not complaints, complaints


@pytest.mark.parametrize("capacities", CAPACITIES)
@pytest.mark.parametrize("name", C_TESTS)
def test_c_tests_pass_under_the_sanitizers(clang_build, name, capacities):
    run_c_test(clang_build[0], f"{name}{capacities}")


@pytest.mark.parametrize("capacities", CAPACITIES)
@pytest.mark.parametrize("name", C_TESTS)
def test_c_tests_pass_in_the_release_build(gcc_build, name, capacities):
    run_c_test(gcc_build[0], f"{name}{capacities}")


@pytest.mark.parametrize("name", LEAN)
def test_what_lean_builds_have_left_runs_under_the_sanitizers(clang_build, name):
    run_c_test(clang_build[0], name)


@pytest.mark.parametrize("name", LEAN)
def test_what_lean_builds_have_left_runs_in_the_release_build(gcc_build, name):
    run_c_test(gcc_build[0], name)


@pytest.mark.parametrize("name", FUZZ_TARGETS)
def test_fuzzing_finds_no_fault(clang_build, tmp_path, name):
    # The same inputs in every run: one seed, the corpus in one order, no folder that is read again.
    corpus = sorted(str(path) for path in (ROOT / "tests" / "fuzz" / name).iterdir())
    command = [clang_build[0] / f"fuzz_{name}", f"-runs={FUZZ_RUNS[name]}", "-seed=1"]
    command += [f"-seed_inputs={','.join(corpus)}"]
    command += ["-timeout=20", f"-artifact_prefix={tmp_path}/", "-verbosity=0"]
    command += FUZZ_FLAGS.get(name, [])
    done = subprocess.run(command, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr


def test_cppcheck_has_no_finding(root, tool):
    command = [tool("cppcheck"), "--std=c99", "--enable=warning,style,performance,portability"]
    command += ["--inline-suppr", "--error-exitcode=1", "--quiet", "-j2", "--force"]
    command += [f"--suppressions-list={root / 'tests' / 'cppcheck.txt'}"]
    command += [f"-I{root / 'csrc'}", f"-I{root / 'firmware_sim'}"]
    command += [root / "csrc", root / "firmware_sim"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr

def misra_findings(cppcheck):
    """Yield (rule, place, source line) of every finding of cppcheck's MISRA checks in libnck."""
    command = [cppcheck, "--std=c99", "--addon=misra", "--enable=style", "--quiet", "-j2"]
    command += ["--template={id}\t{file}\t{line}", f"-I{ROOT / 'csrc'}", ROOT / "csrc" / "nck"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    rows = re.findall(r"^misra-c2012-(\S+)\t(\S+)\t(\d+)$", done.stderr, re.M)
    for rule, file, number in sorted(set(rows)):
        source = Path(file).read_text(encoding="utf-8").split("\n")[int(number) - 1]
        yield rule, f"{Path(file).relative_to(ROOT)}:{number}", source.strip()


def test_misra_checks_hold_but_for_the_reviewed_deviations(tool):
    text = (ROOT / "tests" / "misra.toml").read_text(encoding="utf-8")
    unused = tomllib.loads(text)["deviation"]
    deviations = list(unused)
    broken = []
    for rule, place, source in misra_findings(tool("cppcheck")):
        fits = [
            each
            for each in deviations
            if each["rule"] == rule and re.search(each.get("line", ""), source)
        ]
        unused = [each for each in unused if each not in fits]
        if not fits:
            broken.append(f"{rule} {place}: {source}")
    assert not broken, "\n".join(broken)
    assert not unused, "deviations that nothing needs any longer"
