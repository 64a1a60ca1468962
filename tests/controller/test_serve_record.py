# SPDX-License-Identifier: MIT
"""What `pycnc serve --record` writes is a session that can be played again."""

import contextlib
import io
import random
import socket
import subprocess
import sys

import pytest
import serving_runs
from test_serve import read_until
from test_serve_inputs import INPUTS, machine

from pycnc.controller.recording import Recorded
from pycnc.controller.serving import Server
from pycnc.machine import Machine


class Sender:
    """A line whose other end sends at random, in place of a port."""

    def __init__(self, draw):
        self._draw, self.is_there = draw, False

    def wait(self, _):
        """Return 1 where somebody has come."""
        comes = not self.is_there and self._draw.random() < 0.2
        self.is_there = self.is_there or comes
        return comes

    def read(self, most):
        """Return a few words, nothing, or None where the sender is gone."""
        if not self.is_there or self._draw.random() < 0.5:
            return b""
        if self._draw.random() < 0.02:
            self.is_there = False
            return None
        return serving_runs.noise(self._draw, self._draw.randint(1, 6))[:most]

    def write(self, data):
        """Take some of it."""
        return self._draw.randint(0, len(data))


@pytest.mark.sample(4, quick=2)
@pytest.mark.parametrize("seed", range(1, 101))
def test_a_record_of_anything_is_played_to_the_same_end(seed, monkeypatch):
    draw, file, mill = random.Random(seed), io.StringIO(), machine(INPUTS)
    server = Server(mill, Sender(draw), record=file)
    monkeypatch.setattr(server, "_due", lambda: draw.choice((0, 1, 2, 2, 3, 20, 100)))
    for _ in range(300):
        server.step()
        if draw.random() < 0.01:
            server.session.push("door", draw.random() < 0.5)
    server.session.run(200)
    server.session.take()
    server.end()
    talk = serving_runs.play(file.getvalue(), mill)
    assert talk.session.joints_nm == server.session.joints_nm or talk.session.moving


def test_the_command_writes_it(tmp_path):
    path = tmp_path / "session.txt"
    command = [sys.executable, "-m", "pycnc", "serve", "--tcp", "0", "--slope", "jerk",
               "--record", str(path)]  # fmt: skip
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        port = int(process.stderr.readline().split(";")[0].rsplit(":", 1)[1])
        with contextlib.ExitStack() as stack:
            stack.callback(process.terminate)
            client = stack.enter_context(socket.create_connection(("127.0.0.1", port)))
            read_until(client, b"Grbl 1.1f")
            client.sendall(b"$G\nN5 G21G91G1X1F600\n")
            read_until(client, b"ok")
            client.sendall(b"?")
            read_until(client, b">")
        process.wait(timeout=30)
    text = path.read_text(encoding="utf-8")
    for line in ("+\n", "< ok\n", "< Grbl 1.1f", ". "):
        assert line in text
    serving_runs.play(text, Machine.load("mill3", dialect="grbl", set={"path.slope": "jerk"}))


def test_a_file_that_cannot_be_written_is_told(tmp_path):
    command = [sys.executable, "-m", "pycnc", "serve", "--record", str(tmp_path / "no" / "x")]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 2 and "error[file]" in done.stderr
    assert "Traceback" not in done.stderr


def test_lines_and_bytes_are_told_apart():
    file = io.StringIO()
    session = Recorded(machine(""), file)
    for data in (b"G1 X1\n", b"?", b"G1\nX2\n", b"\xc2\x84\n"):
        session.receive(data)
    session.end()
    assert file.getvalue().splitlines()[1:] == [
        "> G1 X1", "= 3f", "= 47 31 0a 58 32 0a", "= c2 84 0a"
    ]  # fmt: skip
