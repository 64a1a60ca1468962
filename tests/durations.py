# SPDX-License-Identifier: MIT
"""What the tests cost: processor and wall time of every test and fixture, in build/durations.

    make test DURATIONS=1                        the suite, and the table below it
    .venv/bin/python tests/durations.py          the table of the last run
    .venv/bin/python tests/durations.py --write  renew the table in CONTRIBUTING.md

A fixture is counted apart from the test that is the first to need it: it compiles, or makes what
several tests look at. Processor time is that of the process and of all that it started and waited
for.
"""

import argparse
import json
import os
import time
from collections import defaultdict
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "durations"
PAGE = ROOT / "CONTRIBUTING.md"
BEGIN, END = "<!-- durations -->\n", "<!-- /durations -->\n"
LEAST_S = 10.0  # of processor time: files and fixtures below it share a row


def _used():
    """Return the processor time of this process and of its ended children [s]."""
    now = os.times()
    return now.user + now.system + now.children_user + now.children_system


class Durations:
    """A plugin that writes a line for each test and each fixture.

    What is measured within something else counts there no more: a fixture is no part of its test.
    """

    def __init__(self, worker):
        FOLDER.mkdir(parents=True, exist_ok=True)
        self._file = (FOLDER / f"{worker}.jsonl").open("w", encoding="utf-8")
        self._inner = [[0.0, 0.0]]

    def _measure(self, kind, file, name):
        began, used = time.perf_counter(), _used()
        self._inner.append([0.0, 0.0])
        yield
        wall, cpu = time.perf_counter() - began, _used() - used
        inner_wall, inner_cpu = self._inner.pop()
        self._inner[-1][0] += wall
        self._inner[-1][1] += cpu
        row = {"kind": kind, "file": file, "name": name,
               "wall_s": wall - inner_wall, "cpu_s": cpu - inner_cpu}  # fmt: skip
        self._file.write(json.dumps(row) + "\n")
        self._file.flush()

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item):
        """Measure a test, setup and end with it."""
        yield from self._measure("test", item.nodeid.partition("::")[0], item.name)

    @pytest.hookimpl(hookwrapper=True)
    def pytest_fixture_setup(self, fixturedef, request):
        """Measure what a fixture makes."""
        file = request.node.nodeid.partition("::")[0]
        yield from self._measure("fixture", file, fixturedef.argname)


def pytest_configure(config):
    """Measure in every process that runs tests, if it is asked for."""
    if not os.environ.get("DURATIONS"):
        return
    worker = os.environ.get("PYTEST_XDIST_WORKER")
    if worker is None:
        for path in FOLDER.glob("*.jsonl"):
            path.unlink()
    if worker or not config.getoption("numprocesses", None):
        config.pluginmanager.register(Durations(worker or "main"))


def rows():
    """Return {(room, what): (tests, cpu [s], wall [s])}, the dearest first."""
    found = defaultdict(lambda: [0, 0.0, 0.0])
    for path in sorted(FOLDER.glob("*.jsonl")):
        for line in path.read_text(encoding="utf-8").splitlines():
            row = json.loads(line)
            file = Path(row["file"])
            what = f"`{file.name}`" if row["kind"] == "test" else f"fixture `{row['name']}`"
            room = file.parent.name if row["file"] else "shared"
            if file.suffix == ".c":
                sanitized = row["name"].startswith("sanitized")
                what = "C tests" + (" under the sanitizers" if sanitized else "")
            each = found[room, what]
            each[0] += row["kind"] == "test"
            each[1] += row["cpu_s"]
            each[2] += row["wall_s"]
    return dict(sorted(found.items(), key=lambda item: -item[1][1]))


def table():
    """Return what the last run cost as a Markdown table."""
    lines = ["| room | what | tests | CPU s | wall s |", "|---|---|---:|---:|---:|"]
    others, total = [0, 0.0, 0.0], [0, 0.0, 0.0]
    for (room, what), numbers in rows().items():
        total = [a + b for a, b in zip(total, numbers, strict=True)]
        if numbers[1] < LEAST_S:
            others = [a + b for a, b in zip(others, numbers, strict=True)]
        else:
            lines.append("| {} | {} | {} | {:.0f} | {:.0f} |".format(room, what, *numbers))
    for title, numbers in ((f"each below {LEAST_S:.0f} s", others), ("**all**", total)):
        lines.append("| | {} | {} | {:.0f} | {:.0f} |".format(title, *numbers))
    return "\n".join(lines) + "\n"


def main():
    """Print the table, or renew it."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--write", action="store_true", help="renew the table in CONTRIBUTING.md")
    if not parser.parse_args().write:
        print(table(), end="")
        return
    page = PAGE.read_text(encoding="utf-8")
    before, rest = page.split(BEGIN)
    PAGE.write_text(before + BEGIN + table() + END + rest.split(END)[1], encoding="utf-8")


if __name__ == "__main__":
    main()
