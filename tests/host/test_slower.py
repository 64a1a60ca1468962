# SPDX-License-Identifier: MIT
"""The benches of steps that are slower, of the corpus and of what each part buys, on small
programs."""

import numpy as np
import pytest

from pycnc.bench import corpus, families, gains, monotony, programs


def test_a_step_that_is_slower_is_a_row_and_all_are_counted():
    times = {0.5: 2.0, 1.0: 1.0, 2.0: 1.004, 4.0: 1.1}

    class Case(monotony.Tried):
        def _time_of(self, a, **others):
            return times[a]

    walks = (("a", tuple(times), {"P": (0.0, 0.01)}),)
    *slower, total = monotony.bench_monotony_rows([Case("made up", b"", None)], walks)
    assert [(row["from"], row["to"], row["at"]) for row in slower] == [
        ("2.0", "4.0", "P 0.0"), ("2.0", "4.0", "P 0.01"),
    ]  # fmt: skip
    assert slower[0]["slower"] == pytest.approx(1.1 / 1.004 - 1)
    assert total["program"] == "6 steps, 2 slower"


def test_every_program_of_the_bench_has_a_time():
    cases = monotony.cases()
    assert all(case.time_of(monotony.BASE) > 0 for case in cases)
    if len(cases) == len(monotony.OWN):
        pytest.skip("the corpus is not there")


def test_the_values_of_a_step_reach_the_plan():
    case = monotony.Tried("line", b"G21 G90\nG1 X10 F6000\nM2\n", programs.machine())
    base = case.time_of(monotony.BASE)
    assert case.time_of(monotony.BASE | {"j": 0.125}) == pytest.approx(2 * base, rel=0.04)
    assert case.time_of(monotony.BASE | {"override": 50}) > base
    assert case.time_of(monotony.BASE | {"slope": "linear"}) < base
    machine = monotony.changed(
        programs.machine(), a=2, j=3, v=0.5, P=0.1, window=16, slope="jerk"
    )
    assert machine.limits("a_max").tolist() == [2000] * 3
    assert machine.limits("j_max").tolist() == [30_000] * 3
    assert machine.limits("v_max").tolist() == [50] * 3
    assert machine.settings.path.lookahead_blocks == 16


def test_the_corpus_is_told_file_by_file_and_in_sum(tmp_path):
    (tmp_path / "line.ngc").write_bytes(b"G21 G90\nG1 X10 F6000\nM2\n")
    (tmp_path / "turn.ngc").write_bytes(b"G21 G90\nG1 X10 F6000\nY10\nM2\n")
    files = [(name, "mill3", ()) for name in ("line.ngc", "turn.ngc", "none.ngc")]
    line, turn, absent, total = corpus.bench_corpus_rows(tmp_path, files=files)
    assert 1 < line["ratio"] < turn["jerk_s"] / line["linear_s"]
    assert absent["jerk_s"] is None
    assert total["ratio"] == pytest.approx(
        (line["jerk_s"] + turn["jerk_s"]) / (line["linear_s"] + turn["linear_s"])
    )


def test_gains_tell_every_step_of_a_program():
    row, = gains.bench_gains_rows([("zigzag", lambda: programs.zigzag("", 8, 2.0))])
    assert list(row) == ["program", *gains.STEPS]
    assert row["keinert_s"] < row["p_0_1_s"] < row["p_0_01_s"] < row["jerk_s"] <= row["sshape_s"]


@pytest.mark.thorough
def test_families_compare_the_slopes_by_seed():
    few = {name: families.FAMILIES[name] for name in ("engraving", "zigzag")}
    engraving, zigzag = families.bench_families_rows(few, ["stiff"], seeds=2)
    assert engraving["of_0_01"] < 0.9
    assert zigzag["worst"] < 1.03
    assert {"of_0_002", "of_0_01", "of_0_05", "planned"} < set(zigzag)


@pytest.mark.parametrize("family", families.FAMILIES)
def test_a_family_draws_other_programs_by_other_seeds(family):
    points, feed = families.draw(family, 3)
    assert (points == families.draw(family, 3)[0]).all()
    assert points.shape != families.draw(family, 4)[0].shape or feed != families.draw(family, 4)[1]
    assert (np.linalg.norm(np.diff(points, axis=0), axis=1) > 0).all()
    assert 900 < feed <= 6000
