# SPDX-License-Identifier: MIT
"""How results show themselves in Python: reprs, notebooks, pandas."""

import html.parser
import json
import subprocess
import sys

import numpy as np
import pytest

import pycnc
from pycnc import errors

TEXT = "G21 G90 G17 G61\nG1 X10 Y0.5 F600\nG3 X20 Y10.5 I0 J10\nG4 P0.05\nM30\n"
EVIL = "<script>alert(1)</script>.nc"


class Tags(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.tags = set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.add(tag)


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    file = tmp_path_factory.mktemp("shown") / EVIL.replace("/", "|")
    file.write_text(TEXT)
    program = pycnc.load(file)
    wrong = pycnc.load(b"G21 G90\nG1 Q5 F100 (</td><script>)\nM2\n")
    return {
        "program": program, "plan": pycnc.plan(program), "trace": pycnc.run(program),
        "why": pycnc.why(program), "diagnostics": wrong.diagnostics,
    }  # fmt: skip


@pytest.mark.parametrize("name", ["program", "plan", "trace", "why", "diagnostics"])
def test_a_result_shows_itself_and_marks_in_it_stay_inert(results, name):
    shown = results[name]._repr_html_()
    assert Tags(shown).tags <= {"table", "tr", "th", "td"}
    assert repr(results[name]).startswith(f"<{type(results[name]).__name__}")
    assert len(repr(results[name])) < 300


def test_the_plan_tells_its_time_in_seconds(results):
    assert f"{results['plan'].time_s:.3f}" in results["plan"]._repr_html_()


def test_frames_have_names_for_codes(results):
    nodes, cells, segs = (results["plan"].to_pandas(n) for n in ("nodes", "cells", "segs"))
    assert len(nodes) == len(results["plan"].nodes)
    assert {"feed", "exact_stop"} <= set(nodes["limit"])
    assert set(segs["kind"]) == {"line", "arc", "dwell"}
    assert segs["end_x_mm"].iloc[-1] == pytest.approx(20)
    assert cells["duration"].sum() == pytest.approx(results["plan"].time_s, abs=0.02)
    ticks = results["trace"].to_pandas()
    trace = results["trace"]
    assert list(ticks.columns) == [*trace.columns, *trace.derived()]
    assert {"line", "arc", "dwell"} <= set(ticks["kind"])
    names = results["trace"].limit_names()
    assert [names[code] for code in results["trace"]["limit"]] == list(ticks["limit"])
    found = results["diagnostics"].to_pandas()
    assert list(found["severity"]).count("error") == results["diagnostics"].errors


def test_a_frame_does_not_copy_codes_into_words(results):
    ticks = results["trace"].to_pandas()
    assert ticks["limit"].cat.codes.dtype == np.int8


def test_records_that_are_not_there_are_named(results):
    with pytest.raises(errors.ArgumentError, match="there are: segs, nodes, cells"):
        results["plan"].to_pandas("cubes")


@pytest.mark.parametrize("name", ["plan", "trace", "why", "diagnostics"])
def test_polars_and_arrow_tell_what_pandas_tells(results, name):
    wanted = results[name].to_pandas()
    polars, arrow = results[name].to_polars(), results[name].to_arrow()
    assert list(polars.columns) == list(arrow.column_names) == list(wanted.columns)
    for column in wanted.columns:
        told = wanted[column].astype(object).where(wanted[column].notna(), None).tolist()
        assert polars[column].to_list() == told == arrow[column].to_pylist(), column
    if name in ("plan", "trace"):
        assert "Enum" in str(polars["limit"].dtype)
        assert "dictionary" in str(arrow["limit"].type)


def test_what_a_node_packs_is_told_as_columns_of_their_own(results):
    plan = results["plan"]
    nodes = plan.to_pandas("nodes")
    rests = nodes["length"] == 0
    assert nodes["dwell_s"].sum() == pytest.approx(plan.totals["dwell_s"], rel=1e-12)
    assert (nodes["dwell_s"][~rests] == 0).all()
    assert (nodes["a_rest"][~rests] > 0).all() and (nodes["a_rest"][rests] == 0).all()
    lines = ~rests & (nodes["kind"] == "line")
    assert (nodes["j_rest"][lines] >= nodes["j"][lines] * (1 - 1e-5)).all()
    assert (nodes["q_rest"][lines] > 1e29).all()  # no bend


def test_axes_have_speed_acceleration_and_jerk(results):
    trace, peaks = results["trace"], results["trace"].summary["peaks"]
    limits = {kind: trace.program.machine.limits(f"{kind}_max") for kind in "vaj"}
    for k, letter in enumerate("xyz"):
        for kind, column in zip("vaj", ("vel_{}_mm_s", "acc_{}_mm_s2", "jerk_{}_mm_s3"),
                                strict=True):  # fmt: skip
            most = np.abs(trace[column.format(letter)]).max()
            assert most / limits[kind][k] == pytest.approx(peaks[letter][kind], rel=1e-9)
    assert len(trace["jerk_x_mm_s3"]) == len(trace)
    with pytest.raises(KeyError):
        trace["jerk_w_mm_s3"]


# Files


@pytest.mark.parametrize("ending", ["npz", "csv", "parquet"])
def test_a_trace_comes_back_from_its_file(results, ending, tmp_path):
    trace, file = results["trace"], tmp_path / f"trace.{ending}"
    getattr(trace, f"to_{ending}")(file)
    rows = pycnc.Trace.load(file)
    assert len(rows) == len(trace) > 100
    assert repr(rows).startswith("<Rows of file ")
    assert Tags(rows._repr_html_()).tags <= {"table", "tr", "th", "td"}
    assert list(rows.columns) == list(trace.columns)
    for name in (*trace.columns, *trace.derived()):
        if name in ("kind", "limit"):
            words = [[each.names()[name][code] for code in each[name]] for each in (rows, trace)]
            assert words[0] == words[1]
        else:
            assert np.array_equal(rows[name], trace[name]), name
    told = {key: str(value) for key, value in trace.metadata().items()}
    assert {key: str(value) for key, value in rows.metadata().items()} == told
    again = tmp_path / f"again.{ending}"
    getattr(rows, f"to_{ending}")(again)
    assert np.array_equal(pycnc.Trace.load(again)["pos_x_mm"], trace["pos_x_mm"])
    assert list(rows.to_pandas().columns) == list(trace.to_pandas().columns)


def bad_files(trace, folder):
    """Yield (file, words) of what is no trace."""
    for name, words in (("a.npz", "is no NumPy archive"), ("b.csv", "is no trace of pycnc"),
                        ("c.parquet", "is no Parquet file"), ("d.txt", "endings: .npz")):
        (folder / name).write_text("t,x\n1,2\n")
        yield folder / name, words
    (folder / "empty.csv").write_text("")
    yield folder / "empty.csv", "is no trace of pycnc"
    np.savez(folder / "other.npz", t_s=np.arange(3.0))
    yield folder / "other.npz", "is no trace of pycnc"
    trace.to_csv(folder / "whole.csv")
    whole = (folder / "whole.csv").read_text()
    (folder / "half.csv").write_text(whole[: len(whole) // 2].rsplit(",", 2)[0])
    yield folder / "half.csv", "the file is not whole"
    (folder / "wrong.csv").write_text(whole.replace("0.001,", "soon,", 1))
    yield folder / "wrong.csv", "column t_s"
    trace.to_npz(folder / "whole.npz")
    (folder / "half.npz").write_bytes((folder / "whole.npz").read_bytes()[:-300])
    yield folder / "half.npz", "is no NumPy archive"


def test_what_is_no_trace_is_told_with_its_file(results, tmp_path):
    for file, words in bad_files(results["trace"], tmp_path):
        with pytest.raises(errors.ArgumentError, match=words) as caught:
            pycnc.Trace.load(file)
        assert file.name in str(caught.value)
    with pytest.raises(OSError, match="absent"):
        pycnc.Trace.load(tmp_path / "absent.npz")


def test_a_trace_of_another_version_keeps_its_own_names(results, tmp_path):
    file = tmp_path / "old.npz"
    results["trace"].to_npz(file)
    with np.load(file) as archive:
        arrays = {name: archive[name] for name in archive.files}
    facts = json.loads(str(arrays.pop("metadata"))) | {"version": "0.0.1"}
    facts["names"]["limit"]["0"] = "the feed of old"
    np.savez(file, metadata=np.array(json.dumps(facts)), strange=arrays["t_s"], **arrays)
    rows = pycnc.Trace.load(file)
    assert rows.metadata()["version"] == "0.0.1"
    assert rows.limit_names()[0] == "the feed of old"
    assert "strange" in rows.to_pandas()


def test_a_profile_shows_itself():
    profile = pycnc.stages.slope([4.0, 2.0], 10.0, 20.0, None, [0.0, 5.0, 0.0])
    assert repr(profile).startswith("<Profile of 2 segments: ")
    assert Tags(profile._repr_html_()).tags <= {"table", "tr", "th", "td"}


def test_without_polars_its_extra_is_named():
    code = (
        "import sys; sys.modules['polars'] = None\nimport pycnc\n"
        "try: pycnc.plan('G21 G90 G1 X1 F100\\nM2\\n').to_polars()\n"
        "except pycnc.AbsentError as error: print(error)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert "pycnc-nck[polars]" in done.stdout, done.stderr


def test_without_pandas_its_extra_is_named():
    code = (
        "import sys; sys.modules['pandas'] = None\nimport pycnc\n"
        "try: pycnc.plan('G21 G90 G1 X1 F100\\nM2\\n').to_pandas()\n"
        "except pycnc.AbsentError as error: print(error)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert "pycnc-nck[table]" in done.stdout, done.stderr
