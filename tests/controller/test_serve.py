# SPDX-License-Identifier: MIT
"""A machine that speaks grbl's protocol: sessions in text, random ones, and the ways to it."""

import os
import socket
import subprocess
import sys
import time
from pathlib import Path

import hostile_runs
import pytest
import serving_runs

from pycnc.controller import serving

SESSIONS = sorted((Path(__file__).parent / "sessions").glob("*.txt"))


@pytest.mark.parametrize("path", SESSIONS, ids=lambda path: path.stem)
def test_a_session_goes_as_it_is_written(path):
    serving_runs.play(path.read_text(encoding="utf-8"))


@pytest.mark.sample(6, quick=2)
@pytest.mark.parametrize("seed", range(1, 201))
def test_every_line_of_a_stream_is_answered_once_and_the_end_is_that_of_a_run(seed):
    serving_runs.streams(seed)


@pytest.mark.sample(3, quick=1)
@pytest.mark.parametrize("seed", range(1, 51))
def test_a_jog_that_is_cancelled_rests_where_its_report_says(seed):
    serving_runs.jogs(seed)


@pytest.mark.sample(4, quick=1)
@pytest.mark.parametrize("seed", range(1, 101))
def test_a_hold_brakes_within_15_ms(seed):
    serving_runs.brakes(seed)


@pytest.mark.sample(4, quick=1)
@pytest.mark.parametrize("seed", range(1, 101))
def test_the_modes_at_the_tool_are_what_its_line_has_left(seed):
    serving_runs.modes(seed)


@pytest.mark.sample(4, quick=1)
@pytest.mark.parametrize("seed", range(1, 101))
def test_a_reset_brakes_at_any_moment_and_keeps_the_place(seed):
    serving_runs.resets(seed)


@pytest.mark.sample(4, quick=1)
@pytest.mark.parametrize("seed", range(1, 101))
def test_an_axis_outside_of_its_travel_may_come_nearer_and_goes_no_further(seed):
    serving_runs.returns(seed)


@pytest.mark.sample(10, quick=3)
@pytest.mark.parametrize("seed", range(1, 501))
def test_noise_breaks_nothing(seed):
    serving_runs.bytes_at_random(seed)


@pytest.mark.sample(10, quick=2)
@pytest.mark.parametrize("seed", range(1, 501))
def test_a_storm_leaves_a_machine_that_does_what_it_is_told(seed):
    hostile_runs.storms(seed)


@pytest.mark.sample(30, quick=5)
@pytest.mark.parametrize("seed", range(1, 1001))
def test_nothing_moves_behind_an_open_door_or_in_a_hold(seed):
    hostile_runs.doors(seed)


def test_a_session_that_is_not_as_written_is_told():
    with pytest.raises(serving_runs.Broken, match="line 2"):
        serving_runs.play("< Grbl…\n< ok\n")
    with pytest.raises(serving_runs.Broken, match="besides"):
        serving_runs.play("> $G\n< Grbl…\n")


def read_until(client, words, seconds=20.0):
    """Return what a socket gives until the words are there."""
    end, data = time.monotonic() + seconds, b""
    client.settimeout(0.5)
    while words not in data and time.monotonic() < end:
        try:
            data += client.recv(4096)
        except TimeoutError:
            continue
    assert words in data, data
    return data


@pytest.fixture
def served():
    """Return a process that serves at a port, and the port."""
    command = [sys.executable, "-m", "pycnc", "serve", "--tcp", "0", "--slope", "jerk"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        line = process.stderr.readline()
        yield int(line.split(";")[0].rsplit(":", 1)[1])
        process.terminate()


def test_a_pulled_cable_holds_the_machine_for_the_next_connection(served):
    with socket.create_connection(("127.0.0.1", served)) as client:
        read_until(client, b"Grbl 1.1f")
        client.sendall(b"G21G91G1X50F600\n")
        read_until(client, b"ok")
        time.sleep(0.5)
    time.sleep(0.5)
    with socket.create_connection(("127.0.0.1", served)) as client:
        client.sendall(b"?")
        assert b"<Hold:0|" in read_until(client, b">")
        client.sendall(b"\x18")
        read_until(client, b"Grbl 1.1f")
        client.sendall(b"?")
        assert b"<Idle|" in read_until(client, b">")


def test_who_comes_back_at_once_is_let_in_and_a_second_one_is_not(served):
    for _ in range(30):
        with socket.create_connection(("127.0.0.1", served)) as client:
            client.sendall(b"?")
            read_until(client, b">")
    with socket.create_connection(("127.0.0.1", served)) as client:
        read_until(client, b"Grbl 1.1f")
        with socket.create_connection(("127.0.0.1", served)) as second:
            second.settimeout(20)
            assert second.recv(1) == b""
        client.sendall(b"?")
        read_until(client, b">")


def test_who_pours_a_file_into_the_port_is_heard_behind_it(served):
    with socket.create_connection(("127.0.0.1", served)) as client:
        read_until(client, b"Grbl 1.1f")
        client.sendall(b"G21G91G1X1F60\n" * 100_000 + b"?!")
        assert b"<Run|" in read_until(client, b">")
        time.sleep(0.5)
        client.sendall(b"?")
        assert b"<Hold:0|" in read_until(client, b">")
        client.sendall(b"\x18")
        read_until(client, b"Grbl 1.1f")


def test_a_pseudo_terminal_is_a_serial_port(tmp_path):
    link = tmp_path / "port"
    line = serving.Pty(str(link))
    server = serving.Server(serving_runs.mill(), line)
    port = os.open(link, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    server.serve(0.2)
    assert b"Grbl 1.1f" in os.read(port, 4096)
    os.write(port, b"G21G91G1X50F600\n")
    server.serve(0.4)
    assert os.read(port, 4096) == b"ok\r\n"
    os.close(port)
    server.serve(0.5)
    moving = server.session.moving
    assert 0 < moving
    server.serve(0.2)
    assert server.session.moving == moving
    line.close()
    assert not link.exists()


def test_time_that_was_missed_is_not_made_up_for():
    line = serving.Tcp(0)
    server = serving.Server(serving_runs.mill(), line)
    server.serve(0.05)
    ticks = server.session.ticks
    time.sleep(0.5)
    server.step()
    assert server.session.ticks - ticks <= serving.LATE_S / 0.001 + 1
    assert server.late_s > 0.4
    line.close()
