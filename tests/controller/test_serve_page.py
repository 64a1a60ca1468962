# SPDX-License-Identifier: MIT
"""The page of a served machine in Chromium: the tool moves, and the buttons are the operator's."""

import contextlib
import http.client
import io
import json
import socket
import subprocess
import sys

import pytest
from browser import start
from PIL import Image
from test_serve import read_until
from test_serve_inputs import INPUTS, machine

from pycnc import errors
from pycnc.controller import page as live_page
from pycnc.kernel.session import Session

PATIENCE_MS, LOOK_MS = 20_000, 40


@contextlib.contextmanager
def serving(*words):
    """Return the ports of a sender and of a page, with a machine behind them."""
    command = [sys.executable, "-m", "pycnc", "serve", "--tcp", "0", "--page", "0", *words]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        lines = [process.stderr.readline() for _ in range(2)]
        try:
            yield int(lines[0].split(";")[0].rsplit(":", 1)[1]), int(lines[1].split(":")[3][:-2])
        finally:
            process.terminate()


@pytest.fixture
def chromium(tool):
    """Return a browser."""
    driver = pytest.importorskip("playwright.sync_api", reason="NO LIVE PAGE WAS TESTED")
    path = tool("chromium")
    with driver.sync_playwright() as started, start(started.chromium, path) as browser:
        yield browser


def opened(browser, port):
    """Return the page, and what it complains of or asks of others."""
    page, complaints = browser.new_page(), []
    own = f"http://127.0.0.1:{port}/"
    page.set_default_timeout(PATIENCE_MS)
    page.on("console", lambda told: complaints.append(told.text) if told.type == "error" else None)
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.on("request", lambda asked: asked.url.startswith((own, "data:"))
            or complaints.append(asked.url))  # fmt: skip
    page.goto(own)
    page.wait_for_selector("body[data-ready]")
    return page, complaints


def until(page, script):
    """Wait until something of the page is true."""
    for _ in range(PATIENCE_MS // LOOK_MS):
        if page.evaluate(script):
            return
        page.wait_for_timeout(LOOK_MS)
    raise AssertionError(f"never {script}: {page.evaluate('live.told')}")


def inked(page):
    """Return how many colours the picture of the path has."""
    with Image.open(io.BytesIO(page.locator("#path").screenshot())).convert("RGB") as image:
        return len(image.getcolors(image.width * image.height))


def test_the_tool_moves_and_the_buttons_hold_go_on_and_reset(chromium):
    with serving("--slope", "jerk") as (sender, port):
        page, complaints = opened(chromium, port)
        assert page.inner_text("#state") == "Idle"
        with socket.create_connection(("127.0.0.1", sender)) as client:
            read_until(client, b"Grbl 1.1f")
            client.sendall(b"N30 G21G91G1X200Y50F1500\n")
            until(page, "live.told.state === 'Run' && live.told.at[0] > 2")
            assert page.inner_text("#line") == "line 30"
            first = page.evaluate("live.trail.length")
            until(page, f"live.trail.length > {first} + 5")
            page.click("[data-do=hold]")
            until(page, "live.told.state === 'Hold:0'")
            stands = page.evaluate("live.told.at")
            page.wait_for_timeout(300)
            assert page.evaluate("live.told.at") == stands
            assert inked(page) > 3
            page.click("[data-do='feed+10']")
            until(page, "live.told.feed === 110")
            assert page.inner_text("#feed") == "110 %"
            page.click("[data-do=resume]")
            until(page, f"live.told.at[0] > {stands[0]} + 3")
            for view in ("xy", "xz", "yz", "iso"):
                page.click(f"[data-view={view}]")
                assert page.evaluate("live.view") == view
            page.click("[data-do=reset]")
            until(page, "live.told.state === 'Idle'")
            assert 0 < page.evaluate("live.told.at[0]") < 200
            assert page.inner_text("#feed") == "100 %"
            read_until(client, b"Grbl 1.1f")
        assert not page.is_visible("#switches")
        assert complaints == []


def test_a_door_is_opened_by_its_button(chromium, tmp_path):
    path = tmp_path / "own.toml"
    path.write_text(machine(INPUTS.replace("limits", "homing = false\nlimits")).text)
    with serving("-m", str(path)) as (_, port):
        page, complaints = opened(chromium, port)
        page.click("[data-do=door]")
        until(page, "live.told.state === 'Door:0' && live.told.pins === 'door'")
        page.click("[data-do=door]")
        until(page, "live.told.pins === ''")
        page.click("[data-do=resume]")
        until(page, "live.told.state === 'Idle'")
        assert complaints == []


@pytest.fixture
def shown():
    """Return a page without a browser, and its session."""
    session = Session(machine(""))
    page = live_page.Page(session, "<mill>", 0)
    yield page, session
    page.close()


def ask(page, method, path, body=None, **headers):
    """Return status and body of an answer."""
    port = int(page.address.rstrip("/").rsplit(":", 1)[1])
    client = http.client.HTTPConnection("127.0.0.1", port, timeout=20)
    client.request(method, path, body, {name.replace("_", "-"): at for name, at in headers.items()})
    answer = client.getresponse()
    found = answer.status, answer.read()
    client.close()
    return found


def test_nobody_else_may_ask(shown):
    page, session = shown
    assert ask(page, "GET", "/", Host="evil.example")[0] == 403
    assert ask(page, "GET", "/state", Host="evil.example:80")[0] == 403
    assert ask(page, "POST", "/do", "reset")[0] == 403
    assert ask(page, "POST", "/do", "reset", X_Key="0" * 32)[0] == 403
    assert not page.asked
    assert ask(page, "POST", "/do", "reset", X_Key=page.key)[0] == 204
    assert list(page.asked) == ["reset"]
    for path, body in (("/do", "explode"), ("/do", "x" * 5000), ("/else", "hold"), ("/do", "")):
        assert ask(page, "POST", path, body, X_Key=page.key)[0] == 400
    assert ask(page, "GET", "/etc/passwd")[0] == 404
    status, text = ask(page, "GET", "/")
    assert status == 200 and b"<h1>&lt;mill&gt;</h1>" in text and b"{{" not in text
    assert session.take()


def test_a_long_path_is_thinned_and_told_anew(shown, monkeypatch):
    page, session = shown
    monkeypatch.setattr(live_page, "TRAIL_MOST", 50)
    session.receive(b"G91G1X20F1200\n")
    for _ in range(200):
        session.run(10)
        page.look()
    told = json.loads(ask(page, "GET", "/state?from=7&era=0")[1])
    assert told["era"] > 0 and told["trail"][0][0] == 0 and len(told["trail"]) <= 50
    assert told["trail"][-1][0] == pytest.approx(20)
    again = json.loads(ask(page, "GET", f"/state?from={told['next']}&era={told['era']}")[1])
    assert again["trail"] == [] and again["next"] == told["next"]
    assert json.loads(ask(page, "GET", "/state?from=-1&era=x")[1])["trail"] == told["trail"]


def test_a_port_that_is_taken_is_told(shown):
    page, session = shown
    with pytest.raises(errors.ArgumentError, match="another --page"):
        live_page.Page(session, "mill", int(page.address.rstrip("/").rsplit(":", 1)[1]))
