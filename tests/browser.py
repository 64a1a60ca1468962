# SPDX-License-Identifier: MIT
"""A page in Debian's Chromium, without a window and without a network."""

import contextlib
import time

FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
)  # fmt: skip
SOFTWARE_GL = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
NO_GL = ("--disable-3d-apis",)
SIZE = {"width": 1500, "height": 940}

# A page is ready within 2 s, and answers sooner; one that never does is told soon, on a busy
# computer too.
ANSWER_S = 15.0
LOOK_MS = 20  # between two looks whether a page is ready
WITHOUT_GL = "WebGL"  # in what a page may complain of on the way: it draws without


class Visit:
    """A page that is open.

    Attributes
    ----------
    page : playwright.sync_api.Page
    complaints : list of str
        Errors and warnings of the page, and whatever it asked of the network.
    """

    def __init__(self, page, file):
        self.page, self.complaints, self._file = page, [], file
        page.set_default_timeout(1000 * ANSWER_S)
        page.on("console", self._hear)
        page.on("pageerror", lambda error: self.complaints.append(f"error: {error}"))
        page.on("request", self._ask)

    def _hear(self, message):
        is_own = "due to ReadPixels" not in message.text  # what a picture of the page costs
        if is_own and message.type in ("error", "warning"):
            self.complaints.append(f"{message.type}: {message.text}")

    def _ask(self, request):
        if not request.url.startswith(("file:", "blob:", "data:")):
            self.complaints.append(f"asks for {request.url}")

    def load(self, fragment=""):
        """Open the file and wait until the page is ready, or complains of what keeps it from that.
        """
        self.page.goto(self._file.as_uri() + fragment)
        latest = time.monotonic() + ANSWER_S
        while not self.page.locator("body[data-ready]").count():
            broken = [words for words in self.complaints if WITHOUT_GL not in words]
            assert not broken, broken
            assert time.monotonic() < latest, "the page is never ready"
            self.page.wait_for_timeout(LOOK_MS)
        self.settle()

    def settle(self):
        """Wait until all that is asked for is drawn."""
        self.page.evaluate("""() => new Promise((done) => requestAnimationFrame(
            () => requestAnimationFrame(() => requestAnimationFrame(done))))""")

    def ask(self, script, *arguments):
        """Return what a function of the page returns."""
        return self.page.evaluate(script, *arguments)

    def text(self, selector):
        """Return the text of an element."""
        return self.page.inner_text(selector)


def start(launcher, chromium, *flags):
    """Return a browser; flags come on top of FLAGS.

    launcher: ``chromium`` of playwright's synchronous interface.
    """
    return launcher.launch(executable_path=chromium, args=[*FLAGS, *flags], headless=True)


@contextlib.contextmanager
def opened(browser, file, fragment="", scheme="light", size=SIZE, before="", **words):
    """Open a file in a browser, in a profile of its own; before: a script that runs first."""
    with browser.new_context(
        offline=True, viewport=size, color_scheme=scheme, **words
    ) as context:
        context.add_init_script(before)
        visit = Visit(context.new_page(), file)
        visit.load(fragment)
        yield visit
