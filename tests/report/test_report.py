# SPDX-License-Identifier: MIT
"""``pycnc report``: one inert page with the path, its curves and what holds it back."""

import base64
import gzip
import hashlib
import json
import math
import re

import numpy as np
import pytest
from cases import CORPUS, ROOT, busy, star
from command_line import pycnc

from pycnc import ArgumentError, load, run, why
from pycnc.machine import Machine
from pycnc.planning import measure
from pycnc.report import packed, page, trail

PART = """G21 G90 G17 G64 P0.01
T1 M6
S2000 M3
G1 X20 Y0 F3000
Y20 F900
G2 X0 Y20 I-10 J0 Z-2
(a pause)
G4 P0.2
T2 M6
G1 X0.3
X0.2 Y20.1
X0.1 Y20.3
G0 X200 Y100 Z50
G1 X0 Y0 Z0 F6000
M2
"""
HOSTILE = "</script><script>alert`1`</script><!--<style>{{DATA}}"


class Unpacked:
    """What stands in a page, read by other code than the page's own."""

    def __init__(self, html):
        self.html = html
        (facts,) = re.findall(r'id="facts">(.*?)</script>', html, re.S)
        (data,) = re.findall(r'id="data">(.*?)</script>', html, re.S)
        self.facts = json.loads(facts)
        self.bytes = gzip.decompress(base64.b64decode(data))

    def raw(self, name):
        place = self.facts["columns"][name]
        return self.bytes[place["at"] : place["at"] + place["size"]]

    def column(self, name):
        kind, raw = self.facts["columns"][name]["kind"], self.raw(name)
        if kind not in ("steps", "levels"):
            return np.frombuffer(raw, kind)
        low, high = np.frombuffer(raw, np.uint8).reshape(2, -1).astype(np.int64)
        words = low + 256 * high
        quantum = self.facts["columns"][name]["quantum"]
        if kind == "levels":
            return np.cumsum(words) % 65536 * quantum
        steps = np.where(words > 32767, words - 65536, words)
        steps[steps == -32768] = np.frombuffer(self.raw(f"{name}+"), "f8")
        return np.cumsum(steps) * quantum


def page_of(text, **changes):
    html, _ = page.make(load(text, Machine.load("mill3", set=changes)))
    return Unpacked(html)


@pytest.fixture(scope="module")
def part():
    return page_of(PART)


@pytest.mark.parametrize("slope", ["jerk", "linear"])
def test_points_add_up_to_what_why_and_time_tell(slope):
    made = page_of(PART, **{"path.slope": slope})
    facts, t, code = made.facts, made.column("t"), made.column("code")
    assert t[-1] == pytest.approx(facts["time_s"], abs=1e-6)
    first = made.column("foot_first")
    owner = np.searchsorted(first, np.arange(len(t)), "right") - 1
    limit = code & 31
    limit = np.where(np.isin(limit, facts["ramps"]), made.column("foot_limit")[owner], limit)
    times = np.bincount(limit, np.diff(t, prepend=0), minlength=32)
    for number, told in facts["limits"].items():
        expected = facts["limit_time_s"][told["name"]]
        assert times[int(number)] == pytest.approx(expected, abs=2e-6 * len(t))
    ramps = made.column("foot_lost").sum()
    assert ramps <= sum(cause["lost_s"] for cause in facts["causes"]) + 1e-5
    lost = {cause["cause"]: cause["lost_s"] for cause in facts["causes"]}
    for number, told in facts["limits"].items():
        own = (made.column("foot_limit") == int(number)) & (made.column("foot_ends") == 0)
        if told["name"] in ("dwell", "wait"):  # of others pieces may have caps
            total = made.column("foot_lost")[own].sum()
            assert total == pytest.approx(lost.get(told["name"], 0), abs=1e-5)


def test_the_page_tells_what_why_tells(part):
    told = why(PART).as_dict()
    assert {name: part.facts[name] for name in told} == json.loads(json.dumps(told))


@pytest.mark.parametrize("slope", ["jerk", "linear"])
def test_points_are_where_the_ticks_are_at_that_time(slope):
    text = PART.replace("G64 P0.01", "G61").replace("G4 P0.2\n", "").replace("T2 M6\n", "")
    made, trace = page_of(text, **{"path.slope": slope}), run(text, slope=slope)
    late = 1.5e-3 if slope == "jerk" else 0.0  # the middle of the filter
    fastest = made.column("v").max()
    for letter in "xyz":
        here = places(made, letter, trace["t_s"] - late)
        assert np.abs(here - trace[f"pos_{letter}_mm"]).max() < fastest * 2.6e-3
        assert made.column(letter)[-1] == pytest.approx(trace[f"pos_{letter}_mm"][-1], abs=6e-4)


def places(made, letter, times):
    """Return where the path is at some times: the speed between two points is straight."""
    t, v, x = (made.column(name) for name in ("t", "v", letter))
    k = np.clip(np.searchsorted(t, times), 1, len(t) - 1)
    share = np.clip((times - t[k - 1]) / np.maximum(t[k] - t[k - 1], 1e-9), 0, 1)
    way = 2 * v[k - 1] * share + (v[k] - v[k - 1]) * share**2
    way = way / np.maximum(v[k - 1] + v[k], 1e-9)
    return x[k - 1] + way * (x[k] - x[k - 1])


BAR = """G21 G90 G94 G17 G61
G0 X0 Y0 Z30 A0
G1 Z20 F1200
X60 A1080 F4000
G0 Z30
M2
"""
TURNTABLE = ["axis.a.min_deg=free", "axis.a.max_deg=free"]


def turned_page(text, *changes):
    html, _ = page.make(load(text, Machine.load("mill5_xyzac", set=[*TURNTABLE, *changes])))
    return Unpacked(html)


def test_a_fourth_axis_is_drawn_as_the_part_sees_it():
    made = turned_page(BAR)
    y, z, line = (made.column(name) for name in ("y", "z", "line"))
    helix = line == 4
    assert made.facts["turned"] == ["a"]
    assert np.hypot(y, z)[helix] == pytest.approx(20, abs=2e-3)
    angle = np.unwrap(np.arctan2(z[helix], y[helix]))
    assert abs(angle[-1] - angle[0]) == pytest.approx(6 * np.pi, abs=0.1)
    assert np.abs(np.diff(angle)).max() < np.radians(5.01)  # no chord cuts the bar
    assert made.column("axis_z")[helix] == pytest.approx(20, abs=1e-3)
    assert made.column("axis_a")[helix].max() == pytest.approx(1080, abs=1e-3)


def test_places_on_the_part_go_by_offsets_and_by_the_order_of_the_axes():
    text = BAR.replace("X60 A1080", "X10 Y5 A30 C90").replace("G0 X0", "G43 H1\nG0 X0")
    made = turned_page(text, "tool.1.length_mm=7", "work.g54.x_mm=3", "work.g54.a_deg=10")
    k = int(np.flatnonzero(made.column("line") == 5)[-1])
    place = {name: made.column(f"axis_{name}")[k] for name in "xyzac"}
    assert place == pytest.approx({"x": 13, "y": 5, "z": 27, "a": 40, "c": 90}, abs=2e-3)
    x, y, z = 10, 5, 20  # from the program's zero
    cos, sin = np.cos(np.radians(30)), np.sin(np.radians(30))
    y, z = cos * y - sin * z, sin * y + cos * z
    x, y = -y, x  # then C turns by 90
    found = [made.column(name)[k] for name in "xyz"]
    assert found == pytest.approx([x + 3, y, z], abs=3e-3)


def test_what_does_not_turn_is_drawn_where_the_axes_are(part):
    assert part.facts["turned"] == [] and "axis_x" not in part.facts["columns"]
    still = turned_page(BAR.replace("A1080", ""))
    assert still.facts["turned"] == [] and "axis_x" not in still.facts["columns"]


def test_the_page_has_the_gains_of_cures_if_they_are_asked_for(tmp_path):
    (tmp_path / "part.ngc").write_text(PART)
    out = tmp_path / "part.html"
    asked = pycnc("report", tmp_path / "part.ngc", "-o", out, "--what-if", "--json")
    facts = Unpacked(out.read_text()).facts
    assert asked.code == 0
    assert facts["what_if"] == json.loads(asked.out)["what_if"] == why(PART, what_if=True).cures
    assert len(facts["what_if"]) > 8


def test_the_page_has_what_one_setting_gains(tmp_path):
    (tmp_path / "part.ngc").write_text(PART)
    change, other = "axis.x.a_max_mm_s2=2500", "control.kind=grbl"
    facts = []
    for words in ([change, "--what-if", other], [change, "--what-if"]):
        out = tmp_path / "part.html"
        assert pycnc("report", tmp_path / "part.ngc", "-o", out, "--what-if", *words).code == 0
        facts.append(Unpacked(out.read_text()).facts["what_if"])
    assert facts[0] == why(PART, what_if=[change, other]).cures
    assert len(facts[1]) > 8 and change in [each["cure"] for each in facts[1]]
    bad = pycnc("report", tmp_path / "part.ngc", "--what-if", "axis.x.a=1")
    assert bad.code == 2 and "axis.x.a: unknown key" in bad.err


def test_every_low_point_stands_in_the_page():
    text = star(chord=0.5)
    made = page_of(text, **{"path.tolerance_mm": 0})
    corners = made.column("foot_limit") == 2
    assert corners.sum() >= 9
    assert np.all(made.column("foot_at") < made.facts["points"])
    speed = made.column("v")[made.column("foot_at")[corners].astype(int)]
    assert speed.max() < made.column("feed").max()
    counts = {cause["cause"]: cause["count"] for cause in made.facts["causes"]}
    lost = made.column("foot_lost")
    assert (lost[corners] > 1e-6).sum() == sum(
        cause["count"] for cause in made.facts["causes"] if cause["cause"] == "corner"
    ), counts


def test_tools_lines_and_text_are_those_of_the_program(part):
    assert part.raw("text").decode() == PART
    assert sorted(set(part.column("tool"))) == [1, 2]
    lines = set(part.column("line").astype(int))
    assert {4, 5, 6, 8, 13, 14} <= lines <= set(range(1, 17))
    rapid = part.column("line")[(part.column("code") & 32) > 0]
    assert set(rapid) == {13}


def test_a_step_that_16_bits_do_not_hold_is_kept():
    columns = packed.Columns()
    values = np.array([0, 32767, 65535, 65535 - 32768, 10**9, -5, 7])
    columns.steps("s", values)
    kept = Unpacked.__new__(Unpacked)
    columns.levels("l", np.array([0.0, 3.0, 1.0, 3.0]), 3.0)
    kept.facts, kept.bytes = {"columns": columns.told()}, gzip.decompress(b"".join(columns.gzip()))
    assert kept.column("s").tolist() == values.tolist()
    assert len(kept.raw("s+")) == 8 * 4
    assert kept.column("l") == pytest.approx([0, 3, 1, 3], abs=3 / 65535)


# One file, and inert


def test_the_policy_lets_nothing_in_but_the_page_itself(part):
    (policy,) = re.findall(r'Security-Policy" content="([^"]*)"', part.html)
    rules = dict(rule.strip().split(" ", 1) for rule in policy.split(";"))
    assert rules["default-src"] == "'none'"
    assert set(rules) == {"default-src", "script-src", "style-src", "base-uri", "form-action"}
    for tag, rule in (("script", "script-src"), ("style", "style-src")):
        (text,) = re.findall(rf"<{tag}>(.*?)</{tag}>", part.html, re.S)
        digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
        assert rules[rule] == f"'sha256-{digest}'"
    assert not re.search(r'(?:src|href)\s*=\s*["\']?\s*(?:https?:)?//', part.html, re.I)


def test_marks_in_comments_and_names_stay_inert():
    program = load(f"G21 G90 G17\n({HOSTILE})\nG1 X10 F600 ({HOSTILE})\nM2\n")
    program.file = f"{HOSTILE}.nc"
    html, _ = page.make(program)
    plain, _ = page.make(load("G21 G90 G17\nG1 X10 F600\nM2\n"))
    for tag in ("<script", "</script", "<style", "<!--"):
        assert html.count(tag) == plain.count(tag), tag
    assert Unpacked(html).facts["file"] == f"{HOSTILE}.nc"
    assert HOSTILE.encode() in Unpacked(html).raw("text")


def test_the_bundle_is_that_of_its_sources_and_has_its_licences():
    told = dict(reversed(line.split("  ")) for line in
                (ROOT / "pycnc/report/page.sha256").read_text().splitlines())  # fmt: skip
    sha256 = lambda data: hashlib.sha256(data).hexdigest()  # noqa: E731
    for name in ("page.js", "page.css"):
        assert sha256((ROOT / "pycnc/report" / name).read_bytes()) == told[name], name
    names = ["../pycnc/report/palette.json", "bundle.mjs", "package-lock.json", "package.json"]
    names += sorted(f"src/{path.name}" for path in (ROOT / "page/src").iterdir())
    lines = "".join(f"{name} {sha256((ROOT / 'page' / name).read_bytes())}\n" for name in names)
    assert sha256(lines.encode()) == told["sources"], "npm --prefix page run bundle"
    head = (ROOT / "pycnc/report/page.js").read_text(encoding="utf-8")[:4000]
    for package, words in (("three", "three.js authors"), ("uplot", "Leon Sorokin")):
        version = json.loads((ROOT / "page/package.json").read_text())["devDependencies"][package]
        assert f"{package} {version}" in head
        assert words in head
    lock = json.loads((ROOT / "page/package-lock.json").read_text())["packages"]
    assert all("integrity" in each for name, each in lock.items() if name)


# Bad input


def test_what_does_not_move_has_no_page(tmp_path):
    with pytest.raises(ArgumentError, match="nothing moves"):
        page.make(load("G21 G90\nM2\n"))
    result = pycnc("report", "-", "-o", tmp_path / "x.html", stdin=b"G21 G90\nM2\n")
    assert (result.code, list(tmp_path.iterdir())) == (2, [])
    assert "error[empty]" in result.err


@pytest.mark.parametrize(
    ("file", "words"),
    [("x.pdf", "error[format]"), ("no/such/folder/x.html", "error[file]"), (".html", "")],
)
def test_where_it_cannot_go_is_told_and_leaves_nothing(file, words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = pycnc("report", "-", "-o", file, stdin=PART.encode())
    assert result.code == (2 if words else 0)
    assert words in result.err
    assert [path.name for path in tmp_path.iterdir()] == ([] if words else [file])


def test_a_program_with_errors_has_no_page(tmp_path):
    result = pycnc("report", "-", "-o", tmp_path / "x.html", stdin=b"G1 X10 F100 Q\n")
    assert (result.code, list(tmp_path.iterdir())) == (1, [])


def test_an_interrupt_leaves_no_half_page(tmp_path, monkeypatch):
    def stop(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr(page, "Plan", stop)
    result = pycnc("report", "-", "-o", tmp_path / "x.html", stdin=PART.encode())
    assert (result.code, list(tmp_path.iterdir())) == (130, [])


def test_the_json_is_that_of_why_and_where_the_page_is(tmp_path):
    file = tmp_path / "x.html"
    told = json.loads(pycnc("report", "-", "-o", file, "--json", stdin=PART.encode()).out)
    assert told.pop("report") == str(file)
    assert told == json.loads(pycnc("why", "-", "--json", stdin=PART.encode()).out)
    assert Unpacked(file.read_text()).facts["causes"] == told["causes"]


def test_a_program_of_blocks_has_a_page_without_text():
    from pycnc import Program

    points = np.array([[0, 0, 0], [10, 0, 0], [10, 10, 0]], float)
    made = Unpacked(page.make(Program.from_points(points, 1200))[0])
    assert made.raw("text") == b""
    assert made.column("x").max() == pytest.approx(10, abs=0.01)  # within the machine's tolerance


JERK = {"path.slope": "jerk"}  # has more low points, and is planned in a tenth of the time


def thinned(text, monkeypatch, path=10_000, lines=4_000, points=1 << 10, **changes):
    """Return a page that holds less than its program has."""
    monkeypatch.setattr(trail, "PATH_MOST", path)
    monkeypatch.setattr(trail, "TEXT_MOST", lines)
    monkeypatch.setattr(trail, "_POINTS", points)
    return page_of(text, **changes)


def test_a_thinned_path_is_where_the_whole_one_is_at_every_moment(monkeypatch):
    text = star(chord=0.02)
    whole, less = page_of(text), thinned(text, monkeypatch, path=4_000, points=1 << 11)
    n, feet = less.facts["points"], less.facts["feet"]
    assert n == len(less.column("t")) < whole.facts["points"] / 2
    assert less.facts["all"] == {"points": whole.facts["points"], "feet": whole.facts["feet"]}
    assert feet == whole.facts["feet"]
    t = whole.column("t")
    for letter in "xyz":
        place = np.interp(t, less.column("t"), less.column(letter))
        assert np.abs(place - whole.column(letter)).max() < 0.05
    for name in ("t", "v", "x"):
        at = [made.column(name)[made.column("foot_at").astype(int)] for made in (whole, less)]
        assert at[1] == pytest.approx(at[0], abs=1e-3)
    names = ("foot_line", "foot_lost", "foot_limit", "foot_angle")
    assert all(np.array_equal(whole.column(name), less.column(name)) for name in names)
    first = less.column("foot_first").astype(int)
    assert np.all(np.diff(first) >= 0) and np.all(less.column("foot_at") < n)
    assert less.facts["causes"] == whole.facts["causes"]


def test_of_too_many_low_points_the_dearest_stay(monkeypatch):
    text = busy(4000)
    whole = page_of(text, **JERK)
    less = thinned(text, monkeypatch, path=10_000, points=1 << 9, **JERK)
    kept, every = less.column("foot_lost"), np.sort(whole.column("foot_lost"))[::-1]
    assert len(kept) == less.facts["feet"] < whole.facts["feet"] == less.facts["all"]["feet"]
    assert kept.sum() >= 0.5 * every[: len(kept)].sum()
    assert every[0] == kept.max()


def test_of_too_long_a_text_the_worst_places_and_the_begin_stay(monkeypatch):
    text = busy(4000)
    less = thinned(text, monkeypatch)
    lines, told = text.split("\n"), []
    for first, count in less.facts["spans"]:
        told += lines[first - 1 : first - 1 + count]
    assert less.raw("text").decode() == "".join(f"{line}\n" for line in told)
    assert less.facts["lines"] == 4002 and less.facts["spans"][0][0] == 1
    places = [each for cause in less.facts["causes"] for each in cause["places"]]
    worst = max(places, key=lambda place: place["lost_s"])["line_worst"]
    assert any(first <= worst < first + count for first, count in less.facts["spans"])


@pytest.mark.seldom(4, "pycnc/report", "tests/report")
def test_a_page_of_whatever_length_stays_below_8_mb():
    html, found = page.make(load(busy(700_000), Machine.load("mill3", set=JERK)))
    assert len(html.encode()) <= 8e6
    made = Unpacked(html)
    assert made.facts["all"]["points"] > made.facts["points"] > 2e5
    assert made.column("t")[-1] == pytest.approx(found.time_s, abs=1e-6)
    assert made.facts["lines"] == 700_002 > sum(count for _, count in made.facts["spans"])


@pytest.mark.thorough
def test_a_large_surface_fits_in_5_mb():
    file = CORPUS / "surf_la_peinture_180k.gc"
    if not file.exists():
        pytest.skip(f"{file} is not here")
    html, found = page.make(load(file))
    assert len(html.encode()) <= 5e6
    made = Unpacked(html)
    assert made.column("t")[-1] == pytest.approx(found.time_s, abs=1e-6)
    assert set(measure.limit_names(found.program.machine)) == set(map(int, made.facts["limits"]))
