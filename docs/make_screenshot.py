# SPDX-License-Identifier: MIT
"""Make docs/figures/report.png: the page of the example in Chromium.

python docs/make_screenshot.py
"""

import io
import shutil
import sys
import tempfile
from pathlib import Path

from PIL import Image
from playwright.sync_api import sync_playwright

from pycnc import load
from pycnc.report import page

ROOT = Path(__file__).resolve().parents[1]
PICTURE = ROOT / "docs" / "figures" / "report.png"
EXAMPLE = ROOT / "pycnc" / "examples" / "first_part.ngc"


def main():
    """Write the picture."""
    sys.path.insert(0, str(ROOT / "tests" / "report"))
    from browser import SOFTWARE_GL, opened, start

    with tempfile.TemporaryDirectory() as folder, sync_playwright() as started:
        file = Path(folder) / "page.html"
        page.write(load(EXAMPLE), file)
        browser = start(started.chromium, shutil.which("chromium"), *SOFTWARE_GL)
        with browser, opened(browser, file) as visit:
            visit.page.click("[data-name=Iso]")
            visit.ask("report.ask.line(315)")
            visit.ask("report.curves.show(report.state.moment.i - 400, report.state.moment.i)")
            visit.settle()
            shot = visit.page.screenshot()
    Image.open(io.BytesIO(shot)).convert("RGB").save(PICTURE, optimize=True)


if __name__ == "__main__":
    main()
