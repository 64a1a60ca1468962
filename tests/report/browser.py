# SPDX-License-Identifier: MIT
"""A page in Debian's Chromium, without a window and without a network."""

import contextlib
import tempfile

FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
)  # fmt: skip
SOFTWARE_GL = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
NO_GL = ("--disable-3d-apis",)
SIZE = {"width": 1500, "height": 940}

# A page is ready within 2 s; one that never is is told soon, on a busy computer too.
READY_MS = 15_000


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
        """Open the file and wait until the page is ready."""
        self.page.goto(self._file.as_uri() + fragment)
        self.page.wait_for_selector("body[data-ready]", timeout=READY_MS)
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


@contextlib.contextmanager
def opened(launcher, chromium, file, *flags, fragment=""):
    """Open a file in a browser with a new profile; flags come on top of FLAGS.

    launcher: ``chromium`` of playwright's synchronous interface.
    """
    with tempfile.TemporaryDirectory() as profile:
        context = launcher.launch_persistent_context(
            profile, executable_path=chromium, args=[*FLAGS, *flags], offline=True,
            headless=True, viewport=SIZE,
        )  # fmt: skip
        try:
            visit = Visit(context.new_page(), file)
            visit.load(fragment)
            yield visit
        finally:
            context.close()
