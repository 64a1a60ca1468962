# SPDX-License-Identifier: MIT
"""Make the pictures of the page in docs/figures, in Chromium: report*.png.

python docs/make_screenshot.py [NAME …]      all of them without a name
"""

import io
import math
import shutil
import sys
import tempfile
from pathlib import Path

from PIL import Image
from playwright.sync_api import sync_playwright

from pycnc import load
from pycnc.machine import Machine
from pycnc.report import page

ROOT = Path(__file__).resolve().parents[1]
FIGURES = ROOT / "docs" / "figures"
EXAMPLES = ROOT / "pycnc" / "examples"
DESK, PHONE = {"width": 1500, "height": 940}, {"width": 390, "height": 844}
STRIP = {"width": 880, "height": 900}
COLOURS = 200  # of a picture: they are small files
MOST = 150_000  # bytes
LINES = 1_000_000
MOMENTS = (0.05, 0.35, 0.6, 1.0)  # of the strip, in shares of the time
GAP = 6  # between its pictures [px]
GO = """(share) => { const slider = document.getElementById("scrub");
    slider.value = 10000 * share; slider.dispatchEvent(new Event("input")); }"""


def example():
    """Return the program of the pictures."""
    return load(EXAMPLES / "first_part.ngc")


def pin():
    """Return a turned program."""
    return load(EXAMPLES / "turned_pin.ngc", Machine.load("cak6150n"))


def surface(lines=LINES):
    """Return a surface of so many lines."""
    text, columns = ["G21 G90 G17 G64 P0.01", "G1 F3000"], 2000
    for k in range(lines):
        row, column = divmod(k, columns)
        x, y = 0.04 * (column if row % 2 == 0 else columns - 1 - column), 0.16 * row
        z = math.sin(0.2 * x) * math.cos(0.15 * y) + 0.3 * math.sin(x + 0.7 * y) - 2
        text.append(f"X{x:.3f}Y{y:.3f}Z{z:.3f}")
    made = load("\n".join([*text, "M2", ""]))
    made.file = "surface.ngc"
    return made


def worst(visit):
    """Show a corner of the example from the side."""
    visit.page.click("[data-name=Iso]")
    visit.ask("report.ask.line(315)")
    visit.ask("report.curves.show(report.state.moment.i - 400, report.state.moment.i)")


def part(visit):
    """Show the part, half done."""
    visit.page.click("#shows [data-name=part]")
    visit.ask(GO, 0.62)


def nothing(visit):
    """Show the page as it opens."""


# Name: (program, size, scheme, what is done before the picture, all of its height).
SHOTS = {
    "report": (example, DESK, "light", worst, False),
    "report_dark": (example, DESK, "dark", part, False),
    "report_lathe": (pin, DESK, "light", part, False),
    "report_million": (surface, DESK, "light", nothing, False),
    "report_phone": (example, PHONE, "light", nothing, True),
}


def save(image, name, folder=FIGURES):
    """Write a picture in few colours; it must be small."""
    file = folder / f"{name}.png"
    image.convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE).save(file, optimize=True)
    if file.stat().st_size > MOST:
        raise SystemExit(f"{file}: {file.stat().st_size} bytes: more than {MOST}")


def image_of(shot):
    """Return a screenshot as a picture."""
    return Image.open(io.BytesIO(shot)).convert("RGB")


def strip(visit):
    """Return the part at some moments, side by side."""
    visit.page.click("#shows [data-name=part]")
    shots = []
    for share in MOMENTS:
        visit.ask(GO, share)
        visit.settle()
        shots.append(image_of(visit.page.locator("#view").screenshot()))
    wide = sum(shot.width + GAP for shot in shots) - GAP
    made = Image.new("RGB", (wide, shots[0].height), "white")
    for k, shot in enumerate(shots):
        made.paste(shot, (k * (shot.width + GAP), 0))
    return made


def make(names, folder=FIGURES):
    """Write the pictures of some names."""
    sys.path[:0] = [str(ROOT / "tests")]
    from browser import SOFTWARE_GL, opened, start

    with tempfile.TemporaryDirectory() as space, sync_playwright() as started:
        file = Path(space) / "page.html"
        with start(started.chromium, shutil.which("chromium"), *SOFTWARE_GL) as browser:
            for name in names:
                if name == "report_strip":
                    page.write(example(), file)
                    with opened(browser, file, size=STRIP) as visit:
                        save(strip(visit), name, folder)
                    continue
                program, size, scheme, prepare, is_whole = SHOTS[name]
                page.write(program(), file)
                with opened(browser, file, size=size, scheme=scheme) as visit:
                    prepare(visit)
                    visit.settle()
                    save(image_of(visit.page.screenshot(full_page=is_whole)), name, folder)


if __name__ == "__main__":
    make(sys.argv[1:] or [*SHOTS, "report_strip"])
