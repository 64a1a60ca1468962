# SPDX-License-Identifier: MIT
"""How much of the tests a run has: all of a promise's cases are searched by the campaign, of the
many that are alike the suite draws some, by a seed from the commit.

`--draw quick` is for a change in work, `--draw suite` (the default) is `make test`, `--draw whole`
is the campaign. Three marks say what a run leaves out:

    @pytest.mark.sample(12)      of the cases of this test twelve are drawn, a quarter of them in a
                                 quick run; `quick=1` says another number; `of="kernel"` draws
                                 kernels, the same ones for all tests of the file with this mark;
                                 `sample(quick=1)` thins out the quick run alone
    @pytest.mark.thorough        a quick run leaves it out
    @pytest.mark.campaign        only the campaign has it

What is not drawn is not collected; the run says how many cases that were and how to repeat the
draw: `--draw-seed N`, without which the seed is the commit's.

What hypothesis thinks of is thinned out likewise: of `@examples(60)` the suite has a half, a quick
run a quarter.
"""

import hashlib
import random
import subprocess
import sys
from collections import defaultdict
from functools import cache
from pathlib import Path

import hypothesis
import pytest

ROOT = Path(__file__).resolve().parents[1]
LEVELS = ("quick", "suite", "whole")
MARKS = (
    "sample(count=all, quick=None, of=None): how many of a test's cases, or of the values of a "
    "parameter, the suite and a quick run draw",
    "thorough: left out of a quick run",
    "campaign: only in the campaign",
    "seldom(one_in, *places): in the suite after one commit of so many, and after those that "
    "change a file below the places",
)

_level = "suite"  # of this run, from pytest_configure on


def seed_of_commit():
    """Return a number from the commit that is checked out; 0 outside of a repository."""
    command = ["git", "-C", str(ROOT), "rev-parse", "HEAD"]
    done = subprocess.run(command, capture_output=True, text=True)
    return int(done.stdout[:8], 16) if done.returncode == 0 else 0


@cache
def changed_files():
    """Return the files that the last commit changes, and what is not committed; relative paths.

    No files outside of a repository, nor where the commit before is not known.
    """
    found = set()
    asked = ["diff", "--name-only", "HEAD~1"], ["ls-files", "--others", "--exclude-standard"]
    for words in asked:
        done = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True)
        if done.returncode != 0:
            return frozenset()
        found.update(done.stdout.splitlines())
    return frozenset(found)


def pytest_addoption(parser):
    """Add the options of the draw."""
    parser.addoption("--draw", choices=LEVELS, default="suite", help="how much is run")
    parser.addoption("--draw-seed", type=int, help="another draw than the commit's")
    parser.addoption("--fuzz-factor", type=int, default=1, help="times as many fuzzed inputs")


def pytest_configure(config):
    """Name the marks; fix the level, and the seed for the workers too."""
    global _level
    _level = config.option.draw
    for mark in MARKS:
        config.addinivalue_line("markers", mark)
    given = getattr(config, "workerinput", {}).get("draw_seed", config.option.draw_seed)
    config.option.draw_seed = seed_of_commit() if given is None else given


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node):
    """Give a worker the seed of the run."""
    node.workerinput["draw_seed"] = node.config.option.draw_seed


def pytest_report_header(config):
    """Say which draw it is."""
    return f"draw: {config.option.draw}, seed {config.option.draw_seed}"


def generator(config, name):
    """Return the random numbers of one name, the same for every run of a draw."""
    digest = hashlib.sha256(f"{config.option.draw_seed} {name}".encode()).digest()
    return random.Random(digest)


def cheap_first(names, dear):
    """Return the values of a parameter; a quick run has none that begins with a dear name."""
    mark = pytest.mark.thorough
    return [pytest.param(n, marks=mark) if str(n).split(" ")[0] in dear else n for n in names]


def examples(count):
    """Return the settings of a test for which hypothesis thinks of so many examples."""
    shares = {"quick": 4, "suite": 2, "whole": 1}
    return hypothesis.settings(max_examples=max(1, count // shares[_level]))


def _quarter(count):
    return max(1, count // 4)


def _most(mark, level):
    """Return how many cases a mark lets a level draw."""
    count = mark.args[0] if mark.args else sys.maxsize
    return mark.kwargs.get("quick", _quarter(count)) if level == "quick" else count


def is_due(config, item):
    """Tell whether the suite has a test that it has seldom, or a test that is not so marked."""
    mark = item.get_closest_marker("seldom")
    if mark is None:
        return True
    one_in, *places = mark.args
    below = tuple(f"{place}/" for place in places)
    if any(file in places or file.startswith(below) for file in changed_files()):
        return True
    return generator(config, item.nodeid.partition("[")[0]).randrange(one_in) == 0


def leave_out(config, items, others=()):
    """Take away the items that this run does not draw, and the others that the caller names."""
    level = config.option.draw
    left_out, groups = set(others), defaultdict(lambda: defaultdict(list))
    for item in items if level != "whole" else ():
        marks = {mark.name for mark in item.iter_markers()}
        too_long = level == "quick" and marks & {"thorough", "seldom"}
        if "campaign" in marks or too_long or not is_due(config, item):
            left_out.add(item)
        elif item.get_closest_marker("sample"):
            of = item.get_closest_marker("sample").kwargs.get("of")
            name = item.nodeid.partition("::" if of else "[")[0]
            value = item.callspec.indices[of] if of else item.nodeid
            groups[name, of][value].append(item)
    for (name, _), values in groups.items():
        mark = next(iter(values.values()))[0].get_closest_marker("sample")
        most = min(len(values), _most(mark, level))
        for value in generator(config, name).sample(list(values), len(values) - most):
            left_out.update(values[value])
    if left_out:
        config.hook.pytest_deselected(items=[item for item in items if item in left_out])
        items[:] = [item for item in items if item not in left_out]


@pytest.fixture(scope="session")
def draw(request):
    """Return the level of the run: "quick", "suite" or "whole"."""
    return request.config.option.draw


@pytest.fixture(scope="session")
def draw_seed(request):
    """Return the seed of the run, for what draws its own cases."""
    return request.config.option.draw_seed
