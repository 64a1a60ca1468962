# SPDX-License-Identifier: MIT
"""A page for a browser on this computer that shows a served machine moving, with its buttons."""

import html
import json
import secrets
import threading
from collections import deque
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib import resources
from urllib.parse import parse_qs, urlsplit

from pycnc import errors

TRAIL_MOST = 20_000  # points that are kept; then every second of them goes
_WORD_MOST = 32  # bytes of a request
WORDS = {
    "hold": b"!", "resume": b"~", "reset": b"\x18", "feed": b"\x90", "feed+10": b"\x91",
    "feed-10": b"\x92", "feed+1": b"\x93", "feed-1": b"\x94", "rapid": b"\x95",
    "rapid50": b"\x96", "rapid25": b"\x97", "spindle": b"\x99", "spindle+10": b"\x9a",
    "spindle-10": b"\x9b",
}  # fmt: skip
SWITCHES = ("door", "emergency")


class Page:
    """The page's own server, at this computer's address alone.

    Parameters
    ----------
    session : Session
    name : str
        Of the machine.
    port : int
        0 takes one that is free.

    Attributes
    ----------
    address : str
        Where a browser finds it.
    """

    def __init__(self, session, name, port):
        self._session, self._name, self.key = session, name, secrets.token_hex(16)
        self.asked, self._pushed = deque(), dict.fromkeys(SWITCHES, False)
        self._trail, self._era, self._told = [], 0, {}
        try:
            self._server = _Server(("127.0.0.1", port), self)
        except (OSError, OverflowError) as cause:
            raise errors.ArgumentError(f"cannot listen at 127.0.0.1:{port}: {cause}; another "
                                       "--page may be free", id="serve-port") from None  # fmt: skip
        self.hosts = [f"{host}:{self._server.server_port}" for host in ("127.0.0.1", "localhost")]
        self.address = f"http://{self.hosts[0]}/"
        self.look()
        threading.Thread(target=self._server.serve_forever, daemon=True).start()

    def look(self):
        """Do what the page asks for, and keep what it will be told."""
        while self.asked:
            self._obey(self.asked.popleft())
        told = self._session.shown()
        if not self._trail or self._trail[-1] != told["at"]:
            self._trail.append(told["at"])
        if len(self._trail) > TRAIL_MOST:
            self._trail, self._era = self._trail[::2], self._era + 1
        self._told = told

    def _obey(self, word):
        if word in SWITCHES:
            self._pushed[word] = not self._pushed[word]
            self._session.push(word, self._pushed[word])
        else:
            self._session.receive(WORDS[word])

    def state(self, first, era):
        """Return what is told of now, and the path from a point on, as JSON."""
        trail, now = self._trail, self._era
        first = first if era == now and 0 <= first <= len(trail) else 0
        points = trail[first:]
        told = self._told | {"era": now, "trail": points, "next": first + len(points)}
        return json.dumps(told).encode()

    def text(self):
        """Return the page."""
        page = (resources.files("pycnc.controller") / "page.html").read_text(encoding="utf-8")
        page = page.replace("{{NONCE}}", self.key)
        return page.replace("{{NAME}}", html.escape(self._name)).encode()

    def close(self):
        """Close the port."""
        self._server.shutdown()
        self._server.server_close()


class _Server(ThreadingHTTPServer):
    daemon_threads = True

    def __init__(self, address, page):
        self.page = page
        super().__init__(address, _Answers)


class _Answers(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def do_GET(self):  # noqa: N802
        """Answer for the page and for its state."""
        page, asked = self.server.page, urlsplit(self.path)
        if not self._is_local():
            self._give(403, b"")
        elif asked.path == "/":
            self._give(200, page.text(), "text/html; charset=utf-8")
        elif asked.path == "/state":
            words = parse_qs(asked.query)
            numbers = [words.get(name, [""])[0] for name in ("from", "era")]
            first, era = (int(word) if word.isdecimal() else 0 for word in numbers)
            self._give(200, page.state(first, era), "application/json")
        else:
            self._give(404, b"")

    def do_POST(self):  # noqa: N802
        """Take what a button asks for, of the page alone."""
        page, size = self.server.page, self.headers.get("Content-Length", "")
        if not self._is_local() or self.headers.get("X-Key") != page.key:
            self.close_connection = True
            self._give(403, b"")
            return
        least = size.isdecimal() and int(size) <= _WORD_MOST
        word = self.rfile.read(int(size)).decode("ascii", "replace") if least else ""
        self.close_connection = not least
        known = self.path == "/do" and (word in WORDS or word in SWITCHES)
        if known:
            page.asked.append(word)
        self._give(204 if known else 400, b"")

    def _is_local(self):
        """Tell whether the browser asked this computer, and no name that leads to it."""
        return self.headers.get("Host") in self.server.page.hosts

    def _give(self, status, body, kind="text/plain"):
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.send_header("Cache-Control", "no-store")
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *words):
        """Say nothing."""
