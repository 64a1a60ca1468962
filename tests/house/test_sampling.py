# SPDX-License-Identifier: MIT
"""What the suite has seldom it has after the commits that it is about, and after some others."""

import re
from types import SimpleNamespace

import pytest
import sampling

ITEM = "tests/base/test_link.py::test_no_race"


def is_due(seed, *places):
    """Tell whether the suite has a test with the mark seldom(4, *places)."""
    config = SimpleNamespace(option=SimpleNamespace(draw_seed=seed))
    mark = pytest.mark.seldom(4, *places).mark
    item = SimpleNamespace(nodeid=ITEM, get_closest_marker={"seldom": mark}.get)
    return sampling.is_due(config, item)


@pytest.mark.parametrize("place", ["csrc/nck/base", "csrc/nck/base/link.c", "csrc"])
def test_a_commit_below_the_places_of_a_test_is_followed_by_it(monkeypatch, place):
    monkeypatch.setattr(sampling, "changed_files", lambda: {"README.md", "csrc/nck/base/link.c"})
    assert all(is_due(seed, "docs", place) for seed in range(20))


@pytest.mark.parametrize("place", ["csrc/nck/bas", "link.c", "pycnc"])
def test_of_other_commits_one_in_four_is(monkeypatch, place):
    monkeypatch.setattr(sampling, "changed_files", lambda: {"csrc/nck/base/link.c"})
    due = [is_due(seed, place) for seed in range(400)]
    assert 70 < sum(due) < 130  # three sigma about 100
    assert due == [is_due(seed, place) for seed in range(400)]


def test_every_place_that_a_mark_names_is_there(root):
    texts = [path.read_text(encoding="utf-8") for path in (root / "tests").glob("*/test_*.py")]
    marks = [each for text in texts for each in re.findall(r"^@.*\.seldom\((.*)\)$", text, re.M)]
    places = {place for mark in marks for place in re.findall(r'"([^"]+)"', mark)}
    assert marks and all(re.fullmatch(r'\d(, "[^"]+")+', mark) for mark in marks)
    assert [place for place in sorted(places) if not (root / place).exists()] == []
