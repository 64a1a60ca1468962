# SPDX-License-Identifier: MIT
"""The part being cut: heights under a mill, radii on a lathe, as the moment has them."""

import numpy as np
import pytest
from browser import NO_GL, SOFTWARE_GL
from test_page import browse, colours, write  # noqa: F401

from pycnc import load
from pycnc.machine import Machine
from pycnc.report import page

RADIUS = 5.0
SLOT = "G21 G90 G17 G61 F1200\nT1 M6\nG0 Z5\nG0 X0 Y0\nG1 Z-2\nX40\nG0 Z5\nG0 X20 Y20\nG1 Z-4\nM2\n"
TURNED = (
    "G18 G21 G90 G94 G61 F200\nS800 M3\nG0 X24 Z2\nG0 X20\n"
    "G1 Z-30\nG0 X24 Z2\nG0 X10\nG1 Z-10\nX24\nM2\n"
)


def opened_part(browse, folder, *flags):  # noqa: F811
    file = write(folder, SLOT, **{"tool.1.radius_mm": RADIUS})
    return browse(file, *flags)


def go(visit, share):
    """Go to a share of the time; return the part's numbers then."""
    visit.ask("""(share) => { const slider = document.getElementById("scrub");
        slider.value = 10000 * share; slider.dispatchEvent(new Event("input"));
        report.scene.draw(); }""", share)
    return visit.ask("""() => { const { stock } = report.part.state;
        return { ...stock, heights: [...stock.heights ?? []], radii: [...stock.radii ?? []] }; }""")


def heights(stock):
    """Return the heights of cells, and X and Y of their middles."""
    at = [stock["low"][d] + (np.arange(stock[name]) + 0.5) * stock["size"]
          for d, name in enumerate(("across", "up"))]  # fmt: skip
    return np.reshape(stock["heights"], (stock["up"], stock["across"])), *np.meshgrid(*at)


def slot_and_hole(x, y):
    """Return the heights that the program leaves, and how far each place is from an edge."""
    slot = np.hypot(x - np.clip(x, 0, 40), y) - RADIUS
    hole = np.hypot(x - 20, y - 20) - RADIUS
    left = np.where(hole < 0, -4.0, np.where(slot < 0, -2.0, 0.0))
    return left, np.minimum(np.abs(slot), np.abs(hole))


@pytest.mark.parametrize("flags", [SOFTWARE_GL, NO_GL])
def test_a_mill_cuts_what_its_cutter_passes_over(browse, tmp_path, flags):  # noqa: F811
    with opened_part(browse, tmp_path, *flags) as visit:
        visit.page.click("#shows [data-name=part]")
        before = colours(visit)
        made, x, y = heights(go(visit, 1))
        wanted, edge = slot_and_hole(x, y)
        inner = edge > 0.75 * visit.ask("report.part.state.stock.size")
        assert np.abs(made - wanted)[inner].max() < 1e-3
        assert np.count_nonzero(inner) > 0.9 * inner.size
        after = colours(visit)
        blue = [sum(n for (r, g, b), n in seen.items() if b > r + 15 and r > 80)
                for seen in (before, after)]  # fmt: skip
        assert blue[1] > blue[0] + 2000, "what is cut is seen"
        early, *_ = heights(go(visit, 0.02))
        assert early.min() == 0, "back at the begin nothing is cut"
        again, *_ = heights(go(visit, 1))
        assert np.array_equal(again, made)


def test_it_plays(browse, tmp_path):  # noqa: F811
    with opened_part(browse, tmp_path, *SOFTWARE_GL) as visit:
        visit.page.click("#shows [data-name=part]")
        go(visit, 0)
        left = "report.part.state.stock.heights.reduce((a, b) => a + b, 0)"
        visit.page.click("#play")
        seen = set()
        while len(seen) < 5:
            seen.add(visit.ask(left))
            visit.settle()
        visit.page.click("#play")
        assert visit.complaints == []


def test_a_cutter_that_no_table_tells_is_asked_for(browse, tmp_path):  # noqa: F811
    with browse(write(tmp_path, SLOT.replace("T1 M6\n", "")), *SOFTWARE_GL) as visit:
        assert not visit.page.locator("#cutter").is_visible()
        visit.page.click("#shows [data-name=part]")
        wide = []
        for diameter in ("3", "8"):
            visit.page.fill("#cutter", diameter)
            visit.page.press("#cutter", "Enter")
            made, _, y = heights(go(visit, 1))
            middle = made.shape[1] // 3
            wide.append(np.ptp(y[:, middle][made[:, middle] == -2]))
        assert wide == pytest.approx([3, 8], abs=0.7)


def test_a_lathe_s_part_has_the_radii_that_its_tool_left(browse, tmp_path):  # noqa: F811
    file = tmp_path / "page.html"
    program = load(TURNED, Machine.load("cak6150n"))
    page.write(program, file)
    with browse(file, *SOFTWARE_GL) as visit:
        visit.page.click("#shows [data-name=part]")
        stock = go(visit, 1)
        zero = program.machine.record["work_nm"][0][2] * 1e-6
        z = stock["low"] - zero + (np.arange(len(stock["radii"])) + 0.5) * stock["size"]
        radii = np.array(stock["radii"])
        for where, radius in ((z < -10.2, 10), ((z > -9.8) & (z < 1.8), 5)):
            assert where.any()
            assert radii[where] == pytest.approx(radius, abs=1e-3)
        view = visit.page.locator("#view").bounding_box()
        middle = visit.ask("(z) => report.scene.project(0, 0, z)", zero - 14)
        assert middle[1] == pytest.approx(view["height"] / 2, abs=2), "both sides of the axis"
        assert visit.complaints == []


@pytest.mark.parametrize(("name", "line"), [("printer_klipper", "M83\n"), ("mill3", "")])
def test_where_nothing_is_cut_off_the_path_alone_is_shown(
    browse, tmp_path, name, line  # noqa: F811
):
    file = tmp_path / "page.html"
    page.write(load(f"G21 G90\n{line}G1 F3000 X40\nG1 Y40\n", Machine.load(name)), file)
    with browse(file, *SOFTWARE_GL) as visit:
        assert not visit.page.locator("#shows").is_visible()
        assert visit.complaints == []
