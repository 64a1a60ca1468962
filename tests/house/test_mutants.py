# SPDX-License-Identifier: MIT
"""mutate.py changes what it says, and its reviewed changes are changes of today's code."""

import mutate
import near
import pytest
import sampling

SOURCE = """
// if (a < b) in a comment is none
static int clamp(int a, const int *b) {
    const nck_seg_t *const seg = at(a);
    if (a < *b && a != 0) return 7;
    for (int k = 0; k < 3; k++) a += k * 2;
    self->s = a - 1.5;
    work(seg);
    return a;
}
static int is_good(int a) {
    return 1;
}
static unsigned count(void) {
    return 1;
}
enum { NONE = 5 };
"""
CHANGES = {
    ("a < *b && a != 0", "!(a < *b && a != 0)"), ("<", "<="), ("<", ">="), ("&&", "||"),
    ("!=", "=="), ("0", "1"), ("return 7", ""), ("7", "8"), ("7", "6"), ("3", "4"), ("3", "2"),
    ("+=", "-="), ("+=", "="), ("*", "/"), ("2", "3"), ("2", "1"), ("a += k * 2", ""),
    ("-", "+"), ("1.5", "(1.5 + 1.0)"), ("1.5", "(1.5 - 1.0)"), ("self->s = a - 1.5", ""),
    ("work(seg)", ""), ("1", "0"), ("1", "2"),
}  # fmt: skip


def test_changes_are_small_and_inside_of_functions(tmp_path, monkeypatch):
    (tmp_path / "csrc" / "nck").mkdir(parents=True)
    (tmp_path / "csrc" / "nck" / "clamp.c").write_text(SOURCE)
    monkeypatch.setattr(mutate, "ROOT", tmp_path)
    found = list(mutate.mutants_of("clamp.c"))
    assert {(mutant.was, mutant.now) for mutant in found} == CHANGES
    assert all(mutant.was in mutant.source for mutant in found)
    # a truth becomes none, a number its neighbours
    assert [mutant.now for mutant in found if mutant.was == "1"] == ["0", "2", "0"]


def test_a_sample_is_the_same_whatever_is_added_behind():
    mutants = list(mutate.mutants_of("base/link.c"))
    some = mutants[: len(mutants) // 2]
    drawn = [mutant for mutant in mutate.draw(mutants, 1) if mutant in set(some)]
    assert drawn == mutate.draw(some, 1)
    assert drawn != mutate.draw(some, 2)


def test_reviewed_mutants_are_changes_of_the_code():
    known = mutate.reviewed()
    files = sorted({file for file, *_ in known})
    assert known <= {mutate.name_of(mutant) for file in files for mutant in mutate.mutants_of(file)}


# How many of the drawn mutants the quick tests of their own room may leave, in the default
# capacities: those of the slope kill 25 of 44, and chance has its part: of these fewer than 3 of
# 12 once in 200 draws. Tests that see nothing are found so; the campaign asks for 95 of 100 by all
# tests (mutate.GOAL).
DRAWN, LEFT_MOST = 12, 9
# Room 1 is held against rs274, in Python; 3 and 4 by times and setpoints, whose tests stand in the
# rooms behind them.
FOLDERS = ("base/", "2_toolcomp/", "5_slope/", "tick/")


@pytest.mark.thorough
def test_tests_of_a_room_kill_mutants_of_it(pytestconfig, draw_seed):
    some = sampling.generator(pytestconfig, "mutants").choice(FOLDERS)
    survivors, killed = near.run(mutate.sample(draw_seed, [some]), DRAWN)
    assert killed + len(survivors) == DRAWN
    assert len(survivors) <= LEFT_MOST, "\n".join(map(str, survivors))
