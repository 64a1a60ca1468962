# SPDX-License-Identifier: MIT
"""The page for people: find, filters, keys, units, the phone, dark and light, paper."""

import io

import pytest
from browser import NO_GL, SOFTWARE_GL
from PIL import Image
from test_page import browse, colours, now, write  # noqa: F401
from test_report import PART

PHONE = {"width": 390, "height": 844}
LAYERS = "G21 G90 G17 G61 F1200\n" + "".join(
    f"T{1 + k // 2} M6\nG0 Z5\nG0 X0 Y0\nG1 Z{-k}\nX30\nY20\nX0\nY0\n" for k in range(1, 5)
) + "G0 Z5\nM2\n"  # fmt: skip
# What is cut off on a phone: beyond the page, or text that its box does not hold.
CROPPED = """() => {
    const found = [];
    for (const each of document.body.querySelectorAll("*")) {
        if (each.closest("[hidden], #listing, script") || !each.offsetParent) continue;
        const box = each.getBoundingClientRect();
        if (box.right > innerWidth + 0.5 || box.left < -0.5) {
            found.push(`${each.tagName}#${each.id} ${box.left} ${box.right}`);
        }
        const own = [...each.childNodes].some((one) => one.nodeType === 3 && one.data.trim());
        if (own && each.scrollWidth > each.clientWidth + 1
            && getComputedStyle(each).display !== "inline") {
            found.push(`${each.tagName}.${each.className} ${each.textContent}`);
        }
    }
    return found;
}"""


@pytest.fixture(scope="module")
def visit(browse, tmp_path_factory):  # noqa: F811
    """Return an open page of LAYERS."""
    file = write(tmp_path_factory.mktemp("people"), LAYERS)
    with browse(file, *SOFTWARE_GL) as visit:
        yield visit
        assert visit.complaints == []


def ground(visit):
    """Return the colour of the page beside its parts."""
    with Image.open(io.BytesIO(visit.page.screenshot())).convert("RGB") as image:
        return image.getpixel((3, image.height - 3))


# Find


def test_a_text_is_found_on_and_back(visit):
    lines = [k for k, line in enumerate(LAYERS.splitlines(), 1) if "x30" in line.lower()]
    visit.ask("report.ask.line(2)")
    visit.page.keyboard.press("/")
    visit.page.keyboard.type("x30")
    for k in (0, 1, 2, 3, 0):
        visit.page.keyboard.press("Enter")
        visit.settle()
        assert now(visit)[0] == lines[k]
        assert visit.text("#found") == f"{k + 1} of 4"
    visit.page.click("#find-back")
    assert now(visit)[0] == lines[3]
    visit.page.fill("#find", "no such words")
    visit.page.click("#find-on")
    assert visit.text("#found") == "not found"


def test_a_number_is_a_line(visit):
    visit.page.fill("#find", "15")
    visit.page.press("#find", "Enter")
    visit.settle()
    assert now(visit)[0] == visit.ask("report.model.line.find((n, i) => i > 0 && n >= 15)")


# Filters


def drawn(visit, column):
    return visit.ask(f"""() => {{ const {{ pieces }} = report.scene; const found = new Set();
        for (let k = 0; k < pieces.count; k++) found.add(report.model.{column}[pieces.to[k]]);
        return [...found].sort((a, b) => a - b); }}""")


def slide(visit, name, value):
    visit.page.evaluate("""([name, value]) => { const range = document.getElementById(name);
        range.value = value; range.dispatchEvent(new Event("input")); }""", [name, value])
    visit.settle()


def test_layers_and_a_range_of_them_are_shown_alone(visit):
    assert "4 layers" in visit.text("#filtered")
    whole = drawn(visit, "z")
    slide(visit, "low", 1)
    slide(visit, "high", 2)
    shown = drawn(visit, "z")  # a way down between them is shown, too
    assert (min(shown), max(shown)) == (-3, -2)
    assert visit.text("#filtered") == "layers 2–3 of 4"
    slide(visit, "high", 1)
    assert drawn(visit, "z") == [-3]
    assert visit.text("#filtered") == "layer 2 of 4, Z -3.000"
    slide(visit, "low", 0)
    slide(visit, "high", 3)
    assert drawn(visit, "z") == whole


def test_one_tool_is_shown_alone(visit):
    tools = drawn(visit, "tool")
    visit.page.select_option("#tool-only", "2")
    visit.settle()
    assert drawn(visit, "tool") == [2]
    visit.page.select_option("#tool-only", "")
    visit.settle()
    assert drawn(visit, "tool") == tools


# Keys


def test_keys_turn_move_and_zoom_the_path_and_go_from_point_to_point(visit):
    visit.page.focus("#over")
    visit.page.keyboard.press("Home")
    pictures = [visit.ask("report.scene.screenOf(20)")]
    for key in ("ArrowLeft", "ArrowUp", "Shift+ArrowLeft", "Shift+ArrowDown", "+", "-"):
        visit.page.keyboard.press(key)
        visit.settle()
        pictures.append(visit.ask("report.scene.screenOf(20)"))
    assert len({tuple(each) for each in pictures[:6]}) == 6
    assert pictures[6] == pytest.approx(pictures[4], abs=0.5)
    visit.page.keyboard.press("Home")
    visit.settle()
    assert visit.ask("report.scene.screenOf(20)") == pytest.approx(pictures[0], abs=0.5)
    visit.ask("report.ask.now({i: 5, f: 1})")
    visit.page.keyboard.press(".")
    assert visit.ask("report.state.moment") == {"i": 6, "f": 1}
    visit.page.keyboard.press(",")
    assert visit.ask("report.state.moment") == {"i": 5, "f": 1}


def test_keys_move_the_moment_and_zoom_the_curves(visit):
    visit.page.focus("#curves")
    end = visit.ask("report.facts.time_s")
    moment = "report.timeOf(report.state.moment)"
    visit.page.keyboard.press("End")
    assert visit.ask(moment) == pytest.approx(end)
    visit.page.keyboard.press("Home")
    assert visit.ask(moment) == 0
    visit.page.keyboard.press("ArrowRight")
    assert visit.ask(moment) == pytest.approx(0.01 * end)
    visit.page.keyboard.press("Shift+ArrowRight")
    assert visit.ask(moment) == pytest.approx(0.11 * end)
    visit.page.keyboard.press("ArrowUp")
    shown = "(({ min, max }) => max - min)(report.curves.plots[0].plot.scales.x)"
    assert visit.ask(shown) < 0.95 * end
    visit.page.keyboard.press("0")
    assert visit.ask(shown) == pytest.approx(end)


# Numbers


def test_speeds_are_told_in_the_unit_that_is_asked_for(visit):
    visit.ask("report.ask.line(6)")
    minutes = visit.text("#here"), visit.ask("report.curves.plots[0].plot.scales.y.max")
    visit.page.click("[data-name='mm/s']")
    visit.settle()
    seconds = visit.text("#here"), visit.ask("report.curves.plots[0].plot.scales.y.max")
    assert "of 1,200" in minutes[0] and "mm/min" in minutes[0]
    assert "of 20.0" in seconds[0] and "mm/s" in seconds[0]
    assert seconds[1] == pytest.approx(minutes[1] / 60)
    assert visit.page.locator(".curve .unit").first.inner_text() == "speed mm/s"
    visit.page.click("[data-name=speed]")
    assert "mm/s" in visit.text("#legend")
    visit.page.click("[data-name='mm/min']")
    assert "mm/min" in visit.text("#legend")
    visit.page.click("[data-name=slowness]")


def second(visit, k):
    """Return the numbers at the right of a curve."""
    return visit.ask("""(k) => { const { plot } = report.curves.plots[k];
        const { splits, values } = plot.axes[2]; return values(plot, splits(plot)); }""", k)


def test_the_acceleration_axis_has_a_second_number(visit):
    tracks = {each["name"]: each for each in visit.ask("report.facts.felt.tracks")}
    assert second(visit, 1)[0] == ""
    assert second(visit, 1)[-1].split("\n")[0] == "XY 2.5K"
    assert tracks["x"]["a"] == 2500
    assert visit.page.locator(".unit.right").first.inner_text() == "mm/s²"
    visit.page.click("#tracks [data-name=x]")
    assert second(visit, 1) == ["-100 %", "-50 %", "0 %", "50 %", "100 %"]
    assert visit.page.locator(".unit.right").first.inner_text() == "% of limit"
    assert visit.page.locator(".curve .unit").nth(1).inner_text() == "accel. mm/s²"
    visit.page.click("#tracks [data-name=axes]")


# Screens and paper


@pytest.mark.parametrize("text", [PART, LAYERS], ids=["part", "layers"])
def test_nothing_is_cropped_on_a_phone(browse, tmp_path, text):  # noqa: F811
    with browse(write(tmp_path, text), *SOFTWARE_GL, size=PHONE) as visit:
        assert visit.ask("document.documentElement.scrollWidth") == PHONE["width"]
        assert visit.ask(CROPPED) == []
        for summary in visit.page.locator(".cause summary").all():
            summary.click()
            assert visit.ask(CROPPED) == []


def test_dark_and_light_are_the_system_s_and_follow_it(browse, tmp_path):  # noqa: F811
    with browse(write(tmp_path, PART), *SOFTWARE_GL) as visit:
        assert min(ground(visit)) > 200
        visit.page.emulate_media(color_scheme="dark")
        visit.settle()
        assert max(ground(visit)) < 60
        ink = visit.ask("report.curves.plots[0].plot.axes[0].stroke()")
        visit.page.emulate_media(color_scheme="light")
        assert ink != visit.ask("report.curves.plots[0].plot.axes[0].stroke()")


def test_paper_is_white_and_holds_path_curves_and_causes(browse, tmp_path):  # noqa: F811
    with browse(write(tmp_path, PART), *SOFTWARE_GL, scheme="dark", size=(
            {"width": 760, "height": 1000})) as visit:  # fmt: skip
        visit.page.emulate_media(media="print")
        visit.settle()
        seen = colours(visit)
        assert max(seen, key=seen.get) == (255, 255, 255)
        assert sum(n for (r, g, b), n in seen.items() if b > r + 60 and b > g + 20) > 500
        assert visit.ask("document.documentElement.scrollWidth") <= 760
        for name in ("#curves", "#causes", "#verdict", "#total"):
            assert visit.page.locator(name).is_visible()
        assert not visit.page.locator("#play").is_visible()
        assert visit.page.pdf()[:5] == b"%PDF-"
        visit.page.emulate_media(media="screen")
        visit.settle()
        seen = colours(visit)
        assert max(seen, key=seen.get) == (16, 22, 31)


@pytest.mark.parametrize("power", range(-4, 4))
def test_numbers_of_an_axis_are_told_apart(browse, tmp_path, power):  # noqa: F811
    far = 10.0**power
    text = f"G21 G90 G1 X{far:.6f} F{min(6000, 30 * far):.6f}\nX0\nM2\n"
    free = {"axis.x.max_mm": "free", "axis.x.min_mm": "free"}
    with browse(write(tmp_path, text, **free), *NO_GL) as visit:
        for unit in ("mm/min", "mm/s"):
            for across in ("time", "path"):
                visit.page.click(f"#units [data-name='{unit}']")
                visit.page.click(f"#across [data-name={across}]")
                visit.settle()
                shown = visit.ask("""report.curves.plots.map(({ plot }) => plot.axes.slice(0, 2)
                    .map((axis) => axis._values ?? []))""")
                for numbers in (each for axes in shown for each in axes):
                    told = [number for number in numbers if number]
                    assert len(set(told)) == len(told), (unit, across, told)
