# SPDX-License-Identifier: MIT
"""The page of ``pycnc report`` in a browser: it draws, finds the line, and tells the numbers."""

import contextlib
import functools
import io
import json
import math

import pytest
from browser import NO_GL, SOFTWARE_GL, opened, start
from PIL import Image
from cases import busy
from test_report import BAR, HOSTILE, PART, TURNTABLE

from pycnc import load, run, why
from pycnc.machine import Machine
from pycnc.report import page as report_page
from pycnc.report import trail
from pycnc.report.plot import duration

BACKGROUND = (16, 22, 31)
PIXELS = 3  # what a click may miss
# Counts the lines that are drawn before the first picture is there.
COUNT = """(() => {
    const pen = CanvasRenderingContext2D.prototype;
    const [line, mark] = [pen.lineTo, performance.mark];
    let count = 0;
    pen.lineTo = function (...at) { count++; line.apply(this, at); };
    performance.mark = function (name) {
        if (name === "drawn") window.first = { count, ready: document.body.dataset.ready };
        return mark.call(performance, name);
    };
})()"""
FIRST = 40_000  # lines of the first picture, at most
DRAWN = """([k]) => report.curves.plots[k].plot.data.slice(1, 3).flat()
    .reduce((a, b) => Math.max(a, Math.abs(b)), 0)"""
MOMENT = "report.timeOf(report.state.moment)"


@pytest.fixture(scope="module")
def browse(tool):
    """Return the function that opens a file in Chromium, of which there is one for all flags."""
    driver = pytest.importorskip(
        "playwright.sync_api", reason="playwright is not installed: NO PAGE WAS TESTED"
    )
    path = tool("chromium")
    with driver.sync_playwright() as started, contextlib.ExitStack() as browsers:

        @functools.cache
        def browser(*flags):
            return browsers.enter_context(start(started.chromium, path, *flags))

        yield lambda file, *flags, **words: opened(browser(*flags), file, **words)


def write(folder, text, **changes):
    file = folder / "page.html"
    report_page.write(load(text, Machine.load("mill3", set=changes)), file)
    return file


@pytest.fixture(scope="module")
def visit(browse, tmp_path_factory):
    """Return an open page of PART."""
    with browse(write(tmp_path_factory.mktemp("page"), PART), *SOFTWARE_GL) as visit:
        yield visit
        assert visit.complaints == []


def colours(visit):
    """Return how many pixels of the path's picture have which colour."""
    shot = visit.page.locator("#view").screenshot()
    with Image.open(io.BytesIO(shot)).convert("RGB") as image:
        return {colour: n for n, colour in image.getcolors(image.width * image.height)}


def middle(visit, line):
    """Return where the middle of a line's longest stretch is on the page, and its number."""
    return visit.ask(
        """(line) => {
            const { model, scene } = report;
            let best = -1;
            for (let i = 1; i < model.n; i++) {
                if (model.line[i] !== line) continue;
                const way = (k) => Math.hypot(model.x[k] - model.x[k - 1],
                    model.y[k] - model.y[k - 1], model.z[k] - model.z[k - 1]);
                if (best < 0 || way(i) > way(best)) best = i;
            }
            const [a, b] = [scene.screenOf(best - 1), scene.screenOf(best)];
            const box = document.getElementById("over").getBoundingClientRect();
            return [box.left + (a[0] + b[0]) / 2, box.top + (a[1] + b[1]) / 2, best];
        }""",
        line,
    )


def now(visit):
    """Return the line that is marked in the program, and the moment [s]."""
    return int(visit.text(".row.here b")), visit.ask(MOMENT)


# It draws


@pytest.mark.parametrize(
    ("flags", "fragment", "kind"),
    [(SOFTWARE_GL, "", "webgl"), (NO_GL, "", "canvas"), (SOFTWARE_GL, "#canvas", "canvas")],
)
def test_the_path_is_drawn_with_webgl_and_without(flags, fragment, kind, browse, tmp_path):
    with browse(write(tmp_path, PART), *flags, fragment=fragment) as visit:
        assert visit.ask("document.body.dataset.ready") == kind
        seen = colours(visit)
        drawn = sum(n for colour, n in seen.items() if colour != BACKGROUND)
        assert seen[BACKGROUND] > 100_000
        assert drawn > 5000
        feed = sum(n for (r, g, b), n in seen.items() if b > r + 60 and b > g + 20)
        assert feed > 500  # the programmed feed is reached: blue
        told = [words for words in visit.complaints if kind == "webgl" or "WebGL" not in words]
        assert told == []


def test_modes_views_and_rapids_change_the_picture(visit):
    pieces = visit.ask("report.scene.pieces.count")
    pictures = set()
    for name in ("speed", "acceleration", "limit", "tool", "slowness", "Iso", "Top"):
        visit.page.click(f"[data-name={name}]")
        visit.settle()
        pictures.add(tuple(sorted(colours(visit).items())))
    assert len(pictures) >= 6
    visit.page.uncheck("#rapids")
    visit.settle()
    assert visit.ask("report.scene.pieces.count") < pieces
    visit.page.check("#rapids")
    visit.settle()


def test_the_curves_are_drawn_and_go_to_the_program_s_end(visit):
    assert visit.page.locator("#curves .u-wrap").count() == 3
    highest = visit.ask("""report.curves.plots.map(({ plot }) =>
        plot.data.slice(1, 4).flat().reduce((a, b) => Math.max(a, b), 0))""")
    facts = visit.ask("report.facts")
    fastest = visit.ask("report.model.v.reduce((a, b) => Math.max(a, b), 0)")
    assert highest[0] == pytest.approx(60 * fastest, rel=1e-6)
    tracks = {track["name"]: track for track in facts["felt"]["tracks"]}
    run_peaks = run(load(PART, Machine.load("mill3"))).summary["peaks"]
    axes = {letter: run_peaks[letter] for letter in tracks if letter != "path"}
    for kind, k in (("a", 1), ("j", 2)):
        most = visit.ask(DRAWN, [k])
        share = max(peak[kind] for peak in axes.values())
        assert most == pytest.approx(100 * share, rel=0.01)
        for letter, peak in axes.items():
            visit.page.click(f"#tracks [data-name={letter}]")
            assert visit.ask(DRAWN, [k]) == pytest.approx(
                peak[kind] * tracks[letter][kind], rel=0.01)  # fmt: skip
        visit.page.click("#tracks [data-name=axes]")
    ends = visit.ask("report.curves.plots.map(({ plot }) => plot.data[0].at(-1))")
    assert ends == pytest.approx([facts["time_s"]] * 3, abs=1e-6)


def test_a_slow_feed_stands_before_what_is_lost(browse, tmp_path):
    slow = "G1 F80 Z-1\nF1200 X60\nY40\nG4 P0.5\nX0\nM2\n"
    with browse(write(tmp_path, "G21 G90\n" + slow), *SOFTWARE_GL) as visit:
        assert "0.750 s of it at a feed of 80 mm/min ·" in visit.text("#verdict")
        assert visit.text("#causes .place >> nth=0").split("\n") == [
            "a feed of 80 mm/min · line 2", "0.750 s", "G1 F80 Z-1",
        ]  # fmt: skip
        visit.page.click("#causes .place >> nth=0")
        assert now(visit)[0] == 2
        visit.ask("() => { report.ask.cause = (cause) => { window.chosen = cause?.words; }; }")
        for k in range(visit.page.locator("#causes details").count()):
            visit.page.click(f"#causes summary >> nth={k}")
            visit.settle()
            words = visit.text(f"#causes summary .words >> nth={k}")
            assert visit.ask("chosen") == words


# Where the numbers of the marks are written, by number.
NUMBERS = """(() => {
    const pen = CanvasRenderingContext2D.prototype;
    const own = pen.fillText;
    window.numbers = {};
    pen.fillText = function (text, x, y) {
        if (this.canvas.id === "over" && /^[0-9]$/.test(text)) window.numbers[text] = [x, y];
        own.call(this, text, x, y);
    };
})()"""
FAR = "\n" * 25  # lines between two places of one cause
ROUND = [f"{corner}\nG4 P0.1{FAR}" for corner in ("X{0}", "Y60", "X0", "Y0")]
CORNERS = "G21 G90 G61\nG1 F3000 X0 Y0\n" + "".join(2 * ROUND) + "M2\n"


@pytest.mark.parametrize("broad", [60, 150])  # mm: at the top; below the legend, too
def test_every_mark_stands_in_the_picture_beside_the_legend(broad, browse, tmp_path):
    file = write(tmp_path, CORNERS.format(broad))
    with browse(file, *SOFTWARE_GL, before=NUMBERS) as visit:
        visit.page.click("[data-name=Top]")
        visit.settle()
        numbers = visit.ask("Object.values(numbers)")
        wide, high, top, right = visit.ask("""[report.scene].map(() => {
            const [view, legend] = ["view", "legend"].map((id) => document.getElementById(id));
            return [view.clientWidth, view.clientHeight, legend.offsetTop,
                legend.offsetLeft + legend.offsetWidth];
        })[0]""")
    assert len(numbers) == 7
    for x, y in numbers:
        assert 10 <= x <= wide - 10 and 10 <= y <= high - 10
        assert x > right or y < top
        assert sum(abs(x - u) < 20 and abs(y - v) < 20 for u, v in numbers) == 1


def test_a_rest_has_no_programmed_feed_and_no_slant_leads_across_it(browse, tmp_path):
    wave = "\n".join(f"X{0.05 * k:.2f} Y{3 * math.sin(0.3 * k):.3f}" for k in range(1500))
    text = f"G21 G90 G64 P0.01\nG1 F1200\n{wave}\nG4 P3\nX0 F600\nG4 P2\nF1500\n{wave}\nM2\n"
    with browse(write(tmp_path, text), *SOFTWARE_GL) as visit:
        times, *_, feeds = visit.ask("report.curves.plots[0].plot.data")
        rests = visit.ask("""[...report.model.t.keys()].filter((i) => report.model.rests(i))
            .map((i) => [report.model.t[i - 1], report.model.t[i]])""")
        pixel = visit.ask("""(({ bbox, scales: { x } }) =>
            (x.max - x.min) * devicePixelRatio / bbox.width)(report.curves.plots[0].plot)""")
        many = visit.ask("report.model.n")
    assert many > 2 * len(times) / 3, "it is drawn in pixels"
    assert [end - begin > 1.9 for begin, end in rests].count(True) == 2
    for begin, end in rests:
        inside = [feed for t, feed in zip(times, feeds, strict=True) if begin < t < end]
        assert set(inside) <= {None}
    told = list(zip(times, feeds, strict=True))
    for (t, feed), (later, next_feed) in zip(told, told[1:], strict=False):
        if None not in (feed, next_feed) and feed != next_feed:
            assert later - t < 1.01 * pixel


# It finds


@pytest.mark.parametrize("line", [4, 5, 6, 13, 14])
def test_a_click_on_the_path_marks_its_line_and_its_moment(visit, line):
    visit.page.click("[data-name=Iso]")
    visit.page.click("#whole")
    visit.settle()
    x, y, stretch = middle(visit, line)
    visit.page.mouse.move(x, y)
    visit.page.wait_for_selector("#tip:not([hidden])")
    assert visit.text("#tip code").startswith(f"{line} ")
    visit.page.mouse.click(x, y)
    visit.settle()
    marked, moment = now(visit)
    ends = [f"report.scene.screenOf({k})" for k in (stretch - 1, stretch)]
    found = visit.ask(f"[...{ends[0]}, ...{ends[1]}, "
                      "...report.scene.screenOf(report.state.moment.i)]")  # fmt: skip
    middle_of = (found[0] + found[2]) / 2, (found[1] + found[3]) / 2
    length = math.dist(found[:2], found[2:4])
    assert marked == line
    assert math.dist(middle_of, found[4:]) <= length / 2 + PIXELS  # stretches may be less than one
    place = visit.page.locator(".curve .now").first.bounding_box()["x"]
    curve = visit.page.locator(".curve .u-over").first.bounding_box()
    share = (place + 1 - curve["x"]) / curve["width"]
    assert share == pytest.approx(moment / visit.ask("report.facts.time_s"), abs=3e-3)


def test_a_click_on_a_curve_marks_the_line_and_the_place(visit):
    visit.page.click("#whole")
    curve = visit.page.locator(".curve .u-over").first.bounding_box()
    for share in (0.2, 0.8):
        visit.page.mouse.click(curve["x"] + share * curve["width"], curve["y"] + 40)
        visit.settle()
        marked, moment = now(visit)
        assert moment == pytest.approx(share * visit.ask("report.facts.time_s"), rel=0.02)
        assert marked == visit.ask("report.model.line[report.state.moment.i]")


def test_a_click_on_a_line_marks_the_moment_when_it_begins(visit):
    for line in (14, 5, 1):  # a line without a path stands for the next one
        visit.page.evaluate("document.getElementById('listing').scrollTop = 0")
        visit.settle()
        visit.page.click(f".row[data-line='{line}'] code")
        visit.settle()
        marked, moment = now(visit)
        own = visit.ask(f"report.model.line.findIndex((n, i) => i > 0 && n >= {line})")
        assert marked == visit.ask(f"report.model.line[{own}]")
        assert moment == visit.ask(f"report.model.t[{own - 1}]")


def test_a_place_of_the_table_is_shown_everywhere(visit):
    for group in range(2):
        visit.page.locator(".cause summary").nth(group).click()
        cause = visit.ask(f"report.facts.causes[{group}]")
        visit.page.locator(".cause").nth(group).locator(".place").first.click()
        visit.settle()
        marked, _ = now(visit)
        assert marked == cause["places"][0]["line_worst"]
        x, y = visit.ask("report.scene.screenOf(report.state.moment.i)")
        view = visit.page.locator("#view").bounding_box()
        assert (x, y) == pytest.approx((view["width"] / 2, view["height"] / 2), abs=2)
        shown = visit.ask("report.curves.plots[0].plot.scales.x")
        assert shown["max"] - shown["min"] < 0.7 * visit.ask("report.facts.time_s")
    visit.page.locator(".cause[open] summary").click()


def test_it_plays_and_scrubs(visit):
    visit.page.evaluate("""() => { const s = document.getElementById("scrub");
        s.value = 2500; s.dispatchEvent(new Event("input")); }""")
    total = visit.ask("report.facts.time_s")
    assert visit.ask(MOMENT) == pytest.approx(total / 4, rel=1e-3)
    visit.page.select_option("#rate", "1")
    visit.page.click("#play")
    while visit.ask(MOMENT) < total / 4 + 0.05:
        visit.settle()
    visit.page.click("#play")
    stands = visit.ask(MOMENT)
    visit.settle()
    assert visit.ask(MOMENT) == stands


def test_over_the_path_the_moment_stays(visit):
    visit.page.click("#whole")
    visit.page.click(".row[data-line='5'] code")
    before = now(visit)
    visit.page.click("#across [data-name=path]")
    visit.settle()
    end = visit.ask("report.curves.plots[0].plot.scales.x.max")
    assert end == pytest.approx(visit.ask("report.facts.length_mm"))
    assert now(visit) == before
    visit.page.click("#across [data-name=time]")


# It tells the truth


def test_the_numbers_are_those_of_why(visit):
    told = json.loads(json.dumps(why(PART).as_dict()))
    facts = visit.ask("report.facts")
    assert {name: facts[name] for name in told} == told
    assert visit.text("#total") == duration(told["total_s"])
    assert f"ideal time {duration(told['ideal_s'])}" in visit.text("#verdict")
    assert duration(told["time_s"] - told["ideal_s"]) in visit.text("#verdict")
    shown = [cause for cause in told["causes"] if cause["lost_s"] >= 5e-4]
    words = visit.page.locator(".cause .words").all_inner_texts()
    lost = visit.page.locator(".cause summary .lost").all_inner_texts()
    assert words == [cause["words"] for cause in shown][:10]
    assert lost == [duration(cause["lost_s"]) for cause in shown][:10]


def test_time_and_limits_of_the_points_are_those_of_the_plan(visit):
    times = visit.ask("""() => { const { model, facts } = report; const sums = {};
        for (let i = 1; i < model.n; i++) {
            const { name } = facts.limits[model.limit[i]];
            sums[name] = (sums[name] ?? 0) + model.t[i] - model.t[i - 1];
        }
        return sums; }""")
    for name, time_s in visit.ask("report.facts.limit_time_s").items():
        assert times.get(name, 0) == pytest.approx(time_s, abs=1e-3)


def test_every_level_of_detail_has_every_low_point(visit):
    missing = visit.ask("""() => report.scene.levels.made().map(({ points }) => {
        const has = new Set(points);
        return [points.length, [...report.model.feet.at].filter((i) => !has.has(i)).length];
    })""")
    sizes, lost = zip(*missing, strict=True)
    assert set(lost) == {0}
    assert sizes[-1] < sizes[0]


def test_what_cures_gain_is_told_and_turned_paths_tell_their_angles(browse, tmp_path):
    program = load(BAR, Machine.load("mill5_xyzac", set=TURNTABLE))
    found = report_page.write(program, tmp_path / "page.html", what_if=True)
    with browse(tmp_path / "page.html", *SOFTWARE_GL) as visit:
        shown = visit.page.locator(".cure").all_inner_texts()
        told = [cure for cure in found.cures if abs(cure["gain_s"]) >= 5e-4]
        assert len(shown) == len(told)
        for text, cure in zip(shown, told, strict=True):
            verb = "gains" if cure["gain_s"] > 0 else "loses"
            assert text.split("\n")[:2] == [
                cure["cure"], f"{verb} {duration(abs(cure['gain_s']))}"
            ]  # fmt: skip
        assert visit.text("#size").endswith("on the part")
        x, y, _ = middle(visit, 4)
        visit.page.mouse.move(x, y)
        visit.settle()
        assert " A " in visit.text("#tip")
        assert visit.complaints == []


def test_a_page_without_cures_says_nothing_of_them(visit):
    assert visit.page.locator(".cure, h3").count() == 0


def test_marks_in_comments_and_names_do_nothing(browse, tmp_path):
    program = load(f"G21 G90 G17\n({HOSTILE})\nG1 X10 F600 ({HOSTILE})\nM2\n")
    program.file = f"{HOSTILE}.nc"
    file = tmp_path / "page.html"
    report_page.write(program, file)
    with browse(file, *SOFTWARE_GL) as visit:
        visit.page.on("dialog", lambda dialog: visit.complaints.append(dialog.message))
        assert visit.ask("document.scripts.length") == 3
        assert HOSTILE in visit.text(".row[data-line='2'] code")
        assert visit.text("#name") == "script><!--<style>{{DATA}}.nc"
        assert visit.complaints == []


# It is large enough, and tells what it leaves out


@pytest.mark.thorough
def test_a_page_that_leaves_out_lines_and_points_tells_so_and_finds_them(
    browse, tmp_path, monkeypatch
):
    for name, most in (("PATH_MOST", 10_000), ("TEXT_MOST", 4_000), ("_POINTS", 1 << 9)):
        monkeypatch.setattr(trail, name, most)
    with browse(write(tmp_path, busy(4000), **{"path.slope": "jerk"}), *SOFTWARE_GL) as visit:
        facts = visit.ask("report.facts")
        shown = sum(count for _, count in facts["spans"])
        told = visit.text("#machine")
        assert f"{shown:,} of 4,002 lines" in told
        assert f"{facts['points']:,} of {facts['all']['points']:,} points" in told
        assert f"{facts['feet']:,} of {facts['all']['feet']:,} low points" in told
        first, count = facts["spans"][0]
        assert visit.text(".row[data-line='2'] code").startswith("G1 X50.0000")
        line = first + count + 5  # left out
        visit.ask(f"report.ask.line({line})")
        visit.settle()
        assert now(visit)[0] == line
        assert visit.text(".row.here code") == "(not in this page)"
        i = visit.ask("report.state.moment.i")
        before, own = visit.ask(f"[report.model.line[{i - 1}], report.model.line[{i}]]")
        assert before < line <= own
        assert f"{before + 1:,}–{own:,}" in visit.text("#here") or own == before + 1
        visit.page.locator(".row.here").click()
        visit.page.keyboard.press("ArrowDown")
        visit.settle()
        assert now(visit)[0] == line + 1
        visit.page.locator(".cause summary").first.click()
        visit.page.locator(".cause .place").first.click()
        visit.settle()
        assert now(visit)[0] == facts["causes"][0]["places"][0]["line_worst"]
        assert visit.complaints == []


@pytest.mark.thorough
def test_a_page_that_has_all_says_nothing_of_what_is_left_out(visit):
    assert "shown" not in visit.text("#machine")
    assert visit.page.locator(".row .absent").count() == 0



@pytest.mark.seldom(4, "page", "pycnc/report", "tests/report")
def test_a_million_points_load_and_are_found(browse, tmp_path):
    lines, count = ["G21 G90 G17 G61", "G1 F4000"], 48_000
    for k in range(count):
        row, column = divmod(k, 1000)
        x = 0.1 * (column if row % 2 == 0 else 999 - column)
        lines.append(f"X{x:.3f}Y{0.2 * row:.3f}Z{(k * 7 % 5) * 0.03:.3f}")
    file = write(tmp_path, "\n".join([*lines, "M2", ""]), **{"axis.x.max_mm": 500})
    with browse(file, *SOFTWARE_GL, before=COUNT) as visit:
        first = visit.ask("window.first")
        assert FIRST / 2 < first["count"] < FIRST
        assert first["ready"] is None
        assert visit.ask("report.model.n") >= 1e6
        assert sum(n for colour, n in colours(visit).items() if colour != BACKGROUND) > 20_000
        visit.ask("report.ask.line(24002)")
        visit.settle()
        assert now(visit)[0] == 24002
        i = visit.ask("report.state.moment.i")
        visit.ask(f"report.scene.show({i - 3}, {i + 3}, {i})")
        visit.settle()
        lost = visit.ask("""() => report.scene.levels.made().map(({ points }) => {
            let k = 0; let missing = 0;
            for (const i of report.model.feet.at) {
                while (points[k] < i) k++;
                if (points[k] !== i) missing++;
            }
            return missing;
        })""")
        assert set(lost) == {0}
        assert visit.complaints == []
