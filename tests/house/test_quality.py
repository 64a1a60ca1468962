# SPDX-License-Identifier: MIT
"""The C code under a static analyser: no finding, and MISRA C but for reviewed deviations."""

import re
import subprocess
import tomllib
from pathlib import Path

import pytest
import sampling

ROOT = Path(__file__).resolve().parents[2]


SOURCES = sorted((ROOT / "csrc").rglob("*.c")) + sorted((ROOT / "firmware_sim").rglob("*.c"))
SAMPLE, MISRA_SAMPLE = 40, 8  # of them, beside those that the commit changes


def drawn(config, sources, name, count):
    """Return the sources that a run has: those that the commit changes, and some; or all."""
    if config.option.draw == "whole":
        return sources
    changed = {ROOT / each for each in sampling.changed_files()} & set(sources)
    return sorted(changed.union(sampling.generator(config, name).sample(sources, count)))


@pytest.mark.thorough
def test_cppcheck_has_no_finding(root, tool, pytestconfig):
    command = [tool("cppcheck"), "--std=c99", "--enable=warning,style,performance,portability"]
    command += ["--inline-suppr", "--error-exitcode=1", "--quiet", "-j2", "--force"]
    command += [f"--suppressions-list={root / 'tests' / 'house' / 'cppcheck.txt'}"]
    command += [f"-I{root / 'csrc'}", f"-I{root / 'firmware_sim'}"]
    command += drawn(pytestconfig, SOURCES, "cppcheck", SAMPLE)
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def misra_findings(cppcheck, sources, folder):
    """Yield (rule, place, source line) of every finding of cppcheck's MISRA checks in sources.

    What it hands to its MISRA checks goes to a folder, for others read the sources meanwhile.
    """
    command = [cppcheck, "--std=c99", "--addon=misra", "--enable=style", "--quiet", "-j2"]
    command += [f"--cppcheck-build-dir={folder}"]
    command += ["--template={id}\t{file}\t{line}", f"-I{ROOT / 'csrc'}", *sources]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    rows = re.findall(r"^misra-c2012-(\S+)\t(\S+)\t(\d+)$", done.stderr, re.M)
    for rule, file, number in sorted(set(rows)):
        source = Path(file).read_text(encoding="utf-8").split("\n")[int(number) - 1]
        yield rule, f"{Path(file).relative_to(ROOT)}:{number}", source.strip()


@pytest.mark.thorough
def test_misra_checks_hold_but_for_the_reviewed_deviations(tool, draw, pytestconfig, tmp_path):
    kernel = [path for path in SOURCES if ROOT / "csrc" / "nck" in path.parents]
    sources = drawn(pytestconfig, kernel, "misra", MISRA_SAMPLE)
    text = (ROOT / "tests" / "house" / "misra.toml").read_text(encoding="utf-8")
    unused = tomllib.loads(text)["deviation"]
    deviations = list(unused)
    broken = []
    for rule, place, source in misra_findings(tool("cppcheck"), sources, tmp_path):
        fits = [
            each
            for each in deviations
            if each["rule"] == rule and re.search(each.get("line", ""), source)
        ]
        unused = [each for each in unused if each not in fits]
        if not fits:
            broken.append(f"{rule} {place}: {source}")
    assert not broken, "\n".join(broken)
    if draw == "whole":
        assert not unused, "deviations that nothing needs any longer"
