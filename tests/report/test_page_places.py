# SPDX-License-Identifier: MIT
"""The page of ``pycnc report`` where people read it: on a phone, in the dark, on paper."""

import pytest
from browser import SOFTWARE_GL
from test_page import browse, write  # noqa: F401
from test_report import PART

PHONE = {"width": 390, "height": 844}
CONTRAST = 4.5  # of text and its ground, as WCAG 2.1 AA asks
BEYOND = """() => [...document.querySelectorAll("button, select, input, h1, h2, summary, p")]
    .filter((one) => one.checkVisibility())
    .filter((one) => { const box = one.getBoundingClientRect();
        return box.left < -1 || box.right > innerWidth + 1; })
    .map((one) => `${one.tagName} ${one.id} ${one.textContent.slice(0, 20)}`)"""
# Of every element with text of its own: what it says, and how its colour stands out.
CONTRASTS = """() => {
    const number = (words) => (words.match(/[\\d.]+/g) ?? [0, 0, 0, 0]).map(Number);
    const light = (words) => number(words).slice(0, 3).map((part) => part / 255)
        .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4))
        .reduce((sum, part, k) => sum + part * [0.2126, 0.7152, 0.0722][k], 0);
    const ground = (one) => {
        for (let at = one; at; at = at.parentElement) {
            const words = getComputedStyle(at).backgroundColor;
            const parts = number(words);
            if (parts.length < 4 || parts[3] > 0.9) return words;
        }
        return "rgb(255,255,255)";
    };
    return [...document.querySelectorAll("header *, .bar *, h2, .cause *, .row *")]
        .filter((one) => one.checkVisibility() && [...one.childNodes].some(
            (node) => node.nodeType === 3 && node.data.trim()))
        .map((one) => {
            const lights = [light(getComputedStyle(one).color), light(ground(one))].sort();
            return [one.textContent.slice(0, 30),
                (Math.max(...lights) + 0.05) / (Math.min(...lights) + 0.05)];
        });
}"""


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    return write(tmp_path_factory.mktemp("places"), PART)


def test_a_phone_crops_nothing(browse, file):  # noqa: F811
    with browse(file, *SOFTWARE_GL, size=PHONE) as visit:
        assert visit.ask("document.scrollingElement.scrollWidth") <= PHONE["width"]
        assert visit.ask(BEYOND) == []
        assert visit.complaints == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_text_stands_out_in_light_and_dark(browse, file, scheme):  # noqa: F811
    with browse(file, *SOFTWARE_GL, scheme=scheme) as visit:
        found = visit.ask(CONTRASTS)
        assert len(found) > 30
        assert [each for each in found if each[1] < CONTRAST] == []
        ground = visit.ask("getComputedStyle(document.body).backgroundColor")
        assert (ground == "rgb(11, 16, 23)") == (scheme == "dark")


def test_paper_has_the_causes_and_no_knobs(browse, file):  # noqa: F811
    with browse(file, *SOFTWARE_GL) as visit:
        visit.page.emulate_media(media="print")
        assert visit.page.locator("#causes").is_visible()
        assert visit.page.locator("#view").is_visible()
        assert not visit.page.locator("#play").is_visible()
        assert visit.ask("""() => { const one = document.getElementById("causes");
            return one.scrollHeight - one.clientHeight; }""") <= 1
