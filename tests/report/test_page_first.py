# SPDX-License-Identifier: MIT
"""The first picture of a page: it has the path before WebGL is asked for, and without it."""

import io

import pytest
from browser import NO_GL, SOFTWARE_GL, WITHOUT_GL
from PIL import Image
from test_page import browse, write  # noqa: F401
from test_report import PART

# What the picture has when a page first asks for WebGL: pixels of the path, and whether its
# place on the page is that of the marks. "lost" gives a context that draws nothing.
WATCH = """(() => {
    const plain = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        if (!kind.startsWith("webgl")) return plain.call(this, kind, ...rest);
        if (!window.first) {
            const paint = document.querySelector("canvas.paint");
            const { width, height } = paint;
            const { data } = plain.call(paint, "2d").getImageData(0, 0, width, height);
            let seen = 0;
            for (let k = 0; k < data.length; k += 4) {
                if (data[k + 2] > data[k] + 60 && data[k + 2] > data[k + 1] + 20) seen++;
            }
            const view = document.getElementById("view").getBoundingClientRect();
            window.first = { seen, sizes: [width, height, view.width, view.height] };
        }
        const context = plain.call(this, kind, ...rest);
        if (context && LOST) context.getExtension("WEBGL_lose_context").loseContext();
        return context;
    };
})()"""
LEAST = 500  # pixels of the path


@pytest.mark.parametrize(
    ("flags", "lost", "kind"),
    [
        ((), "false", "webgl"),  # --disable-gpu alone: WebGL by software, slow to begin
        (SOFTWARE_GL, "false", "webgl"),
        (SOFTWARE_GL, "true", "canvas"),
        (NO_GL, "false", "canvas"),
        (("--disable-software-rasterizer",), "false", "canvas"),
    ],
)
def test_the_path_is_drawn_before_webgl_is_asked_for(
    browse, tmp_path, flags, lost, kind  # noqa: F811
):
    file = write(tmp_path, PART)
    with browse(file, *flags, before=WATCH.replace("LOST", lost)) as visit:
        first = visit.ask("window.first")
        assert first["seen"] > LEAST
        wide, high, *view = first["sizes"]
        assert [wide, high] == pytest.approx(view, abs=0.5), "laid out as it stays"
        assert visit.ask("document.body.dataset.ready") == kind
        assert visit.page.locator("canvas.paint").count() == 1
        shot = visit.page.locator("#view").screenshot()
        with Image.open(io.BytesIO(shot)).convert("RGB") as image:
            seen = sum(n for n, (r, g, b) in image.getcolors(image.width * image.height)
                       if b > r + 60 and b > g + 20)  # fmt: skip
        assert seen > LEAST
        assert [words for words in visit.complaints if WITHOUT_GL not in words] == []
