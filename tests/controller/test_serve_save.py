# SPDX-License-Identifier: MIT
"""What a served machine keeps in its file, and what it knows after a power failure."""

import json
import os
import random
import signal
import subprocess
import sys
from decimal import Decimal

import pytest
from serving_runs import RESUME, Talk
from test_serve_inputs import machine

from pycnc import errors
from pycnc.controller.keeping import Keeper
from pycnc.machine import Machine, edit

WORK = '\n[work.g54] # the vice\nx_mm = 1.5   # its left jaw\ny_mm = "0x"\n'


@pytest.fixture
def path(tmp_path):
    """Return a machine file of somebody's own."""
    path = tmp_path / "own.toml"
    path.write_text(machine().text + WORK.replace('"0x"', "0"), encoding="utf-8")
    return path


def session(path, saves=True):
    """Return a talk with the machine of a file, and who keeps it."""
    mill = Machine.load(path)
    talk = Talk(mill)
    keeper = Keeper(talk.session, mill, saves)
    talk.listen()
    return talk, keeper


def test_changed_settings_and_offsets_come_back_and_comments_stay(path):
    talk, keeper = session(path)
    before = path.read_text(encoding="utf-8")
    talk.ask("$X")
    for line in ("$110=3000", "$121=750.5", "$24=45", "$23=1", "$26=12", "$21=0"):
        assert talk.ask(line)[-1] == "ok"
    talk.ask("G10L2P1X2.25")
    talk.ask("G10L2P3Z-7")
    keeper.keep()
    text = path.read_text(encoding="utf-8")
    assert "x_mm = 2.25   # its left jaw" in text and "[work.g54] # the vice" in text
    assert len(keeper.notes) == 9 and all(" = " in note for note in keeper.notes)
    settings = Machine.load(path).settings
    assert settings.axis.x.v_max_mm_s == 50 and settings.axis.x.rapid_mm_s is None
    assert settings.axis.y.a_max_mm_s2 == Decimal("750.5")
    assert settings.work.g56.z_mm == -7 and settings.inputs.feed_mm_min == 45
    assert [settings.inputs.x.end, settings.inputs.y.end] == ["least", "most"]
    assert settings.inputs.debounce_ms == 12 and settings.inputs.limits is False
    assert [line for line in before.splitlines() if line not in text.splitlines()] == [
        "limits = true", "feed_mm_min = 60", "x_mm = 1.5   # its left jaw"
    ]  # fmt: skip
    again, _ = session(path)
    listed = again.ask("$$")
    for line in ("$110=3000.000", "$121=750.500", "$24=45.000", "$23=1", "$26=12"):
        assert line in listed


def test_without_save_changes_are_forgotten_and_told(path):
    before = path.read_text(encoding="utf-8")
    talk, keeper = session(path, saves=False)
    talk.ask("$110=3000")
    keeper.look(1e9)
    keeper.end()
    assert keeper.notes == ["forgotten: axis.x.v_max_mm_s = 50; --save keeps it"]
    assert path.read_text(encoding="utf-8") == before
    assert [each.name for each in path.parent.iterdir()] == ["own.toml"]


def test_a_shipped_machine_is_not_written():
    mill = Machine.load("mill3")
    with pytest.raises(errors.ArgumentError, match="no file of your own"):
        Keeper(Talk(mill).session, mill, saves=True)


def test_a_file_that_is_written_otherwise_is_left_alone(path):
    text = path.read_text(encoding="utf-8").replace("[work.g54] # the vice", "[work]")
    path.write_text(text.replace("x_mm = 1.5   # its left jaw\ny_mm = 0", "g54 = {x_mm = 1.5}"))
    talk, keeper = session(path)
    talk.ask("$X")
    talk.ask("G10L2P1X3")
    before = path.read_text(encoding="utf-8")
    keeper.keep()
    assert path.read_text(encoding="utf-8") == before
    [note] = keeper.notes
    assert "work.g54.x_mm: write it as a line of its own in [work.g54]" in note


def test_at_rest_the_machine_goes_on_where_it_stood(path):
    talk, keeper = session(path)
    talk.ask("$X")
    talk.ask("G21G90G1X-3Y4F3000")
    talk.settle()
    talk.ask("G92X10")
    talk.ask("G43.1Z2.5")
    keeper.end()
    modes = [said for said in talk.ask("$#") if not said.startswith("[PRB")]
    again, keeper = session(path)
    again.said.clear()
    assert keeper.notes == [f"{path.with_suffix('.power.json')}: the axes stand where they stood"]
    assert again.session.joints_nm[:2] == talk.session.joints_nm[:2]
    assert [said for said in again.ask("$#") if not said.startswith("[PRB")] == modes
    again.ask("$X")
    again.ask("G90G1X11F900")
    again.settle()
    assert again.session.joints_nm[0] == talk.session.joints_nm[0] + 1_000_000


def test_in_motion_the_place_is_a_guess_and_the_machine_is_locked(path):
    path.write_text(path.read_text().replace("limits = true", "homing = false"))
    talk, keeper = session(path)
    talk.ask("N70G1X30F300")
    talk.wait(500)
    keeper.keep()
    record = json.loads(path.with_suffix(".power.json").read_text())
    assert record["moves"] and record["line"] == 70
    again, keeper = session(path)
    said, again.said = again.said, []
    assert "in line 70" in keeper.notes[0]
    assert said[-1] == "[MSG:Power has failed: '$H'|'$X' to unlock]"
    assert again.ask("G1X2F99") == ["error:9"]
    assert again.session.joints_nm[0] == record["position_nm"]["x"] > 0
    assert again.ask("$X")[-1] == "ok" and again.ask("G1X2F900") == ["ok"]


@pytest.mark.parametrize("spoil", [
    lambda text: "{", lambda text: "[]", lambda text: text.replace("own", "other"),
    lambda text: text.replace('"g54"', '"g99"'), lambda text: text.replace("position_nm", "p"),
    lambda text: text.replace('"x": 0', '"x": 99999999999999999'),
    lambda text: text.replace('"x": 0', '"x": "a"'),
    lambda text: text.replace('"tool_in": 0', '"tool_in": -1'),
])  # fmt: skip
def test_a_record_that_is_none_is_told_and_left_out(path, spoil):
    _, keeper = session(path)
    keeper.end()
    place = path.with_suffix(".power.json")
    place.write_text(spoil(place.read_text()))
    talk, keeper = session(path)
    assert "not taken" in keeper.notes[0]
    talk.ask("$X")
    assert talk.ask("G1X2F900") == ["ok"]


ODD = (None, True, -1, 2**31, 2**32, 2**63, -(2**63), 1e300, float("nan"), "", "g54", "x", [],
       [0, 0], [0, 0, "0"], {}, {"x": 0}, {"x": None, "y": 0, "z": 0})  # fmt: skip


def _spoil(text, draw):
    """Return the text of a record with an odd value, a piece less, or odd bytes."""
    kind, record = draw.random(), json.loads(text)
    if kind < 0.5:
        record[draw.choice(list(record))] = draw.choice(ODD)
        return json.dumps(record)
    if kind < 0.6:
        record["position_nm"]["y"] = draw.choice(ODD)
        return json.dumps(record)
    if kind < 0.65:
        return draw.choice("[{") * draw.choice((1, 100_000))
    at = draw.randint(0, len(text))
    piece = draw.choice(("", "\0", "\ufeff", "}", ",", '"', "\x80", "1e9", "\n"))
    return text[:at] + piece + text[at + draw.choice((0, 1, 1, 30)) :]


@pytest.mark.sample(8, quick=2)
@pytest.mark.parametrize("seed", range(1, 301))
def test_whatever_became_of_the_files_is_told_and_the_machine_works(path, seed):
    draw = random.Random(seed)
    _, keeper = session(path)
    keeper.end()
    place = path.with_suffix(".power.json")
    place.write_text(_spoil(place.read_text(), draw), encoding="utf-8")
    talk, keeper = session(path)
    assert [note for note in keeper.notes if "not taken: " not in note] in (
        [], [f"{place}: the axes stand where they stood"],
        [f"{place}: the power has failed in motion, in line 0: the place of the axes is a guess"],
    )  # fmt: skip
    keeper.notes.clear()
    talk.said.clear()
    assert talk.ask("$X")[-1] == "ok" and talk.ask("$110=3000") == ["ok"]
    text = path.read_text(encoding="utf-8")
    at = draw.randint(0, len(text))
    path.write_text(text[:at] + draw.choice(("", "[", "]", '"', "=", "\0", "x", "\n[[a]]\n"))
                    + text[at + draw.choice((0, 1, 50)) :], encoding="utf-8")  # fmt: skip
    keeper.end()
    assert len(keeper.notes) == 1 and ("not saved: " in keeper.notes[0] or " = " in keeper.notes[0])


def test_the_command_keeps_what_it_is_told_to(path):
    command = [sys.executable, "-m", "pycnc", "serve", "--tcp", "0", "-m", str(path)]
    for words, told in (([], "forgotten: "), (["--save"], f"{path}: ")):
        with subprocess.Popen([*command, *words], stderr=subprocess.PIPE, text=True) as process:
            line = process.stderr.readline()
            port = int(line.split(";")[0].rsplit(":", 1)[1])
            _change(port)
            os.kill(process.pid, signal.SIGINT)
            err = process.communicate(timeout=30)[1]
        assert process.returncode == 0 and told in err and "axis.x.v_max_mm_s = 50" in err
    assert Machine.load(path).settings.axis.x.v_max_mm_s == 50


def _change(port):
    import socket

    from test_serve import read_until

    with socket.create_connection(("127.0.0.1", port)) as client:
        read_until(client, b"Grbl 1.1f")
        client.sendall(RESUME + b"$110=3000\n")
        read_until(client, b"ok")


@pytest.mark.parametrize(("text", "key", "value", "after"), [
    ("[a]\nb = 1 # c\n", "a.b", Decimal("2.50"), "[a]\nb = 2.5 # c\n"),
    ("[a]\n  b= \"free\"\n[c]\n", "a.b", Decimal(2), "[a]\n  b= 2\n[c]\n"),
    ("[a]\nb = 1\n\n# of c\n[c]\nd = 1", "a.e", True, "[a]\nb = 1\ne = true\n\n# of c\n[c]\nd = 1"),
    ("x = 1\n", "a.b", "most", 'x = 1\n\n[a]\nb = "most"\n'),
    ("[ a . b ] # t\n", "a.b.c", Decimal("-0.001"), "[ a . b ] # t\nc = -0.001\n"),
])  # fmt: skip
def test_a_value_is_put_where_it_stands(text, key, value, after):
    assert edit.put(text, {key: value}) == after


@pytest.mark.parametrize(
    "text", ["a = {b = 1}\n", "a.b = 1\n", "[a]\nb = [\n1]\n", "[[a]]\nb = 1\n"]
)
def test_what_cannot_be_put_is_refused(text):
    with pytest.raises(ValueError, match="a.b: write it"):
        edit.put(text, {"a.b": Decimal(2)})
