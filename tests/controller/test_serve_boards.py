# SPDX-License-Identifier: MIT
"""Sessions in text over the UART of the emulated boards: the answers of the host, and its bits."""

from pathlib import Path

import pytest
import serving_runs
from board_sessions import board
from test_serve_inputs import INPUTS, machine

SESSIONS = sorted((Path(__file__).parent / "sessions").glob("*.txt"))
SWITCHES = """# It is homed, probes, is stopped by a limit and by a door.
< Grbl 1.1f ['$' for help]
< [MSG:'$H'|'$X' to unlock]
> G1 X1 F100
< error:9
> $H
. 20000
< ok
> G21 G90 G0 Z-38
< ok
> G38.2 Z-60 F60
< [PRB:48.000,-148.000,-40.…:1]
< ok
= 3f
< <Idle|MPos:48.000,-148.000,-40.…
> G1 Z10 F3000
< ok
. 200
* door 1
. 300
= 3f
< <Door:0|…|Pn:…D…
* door 0
. 20
= 7e
. 3000
> G0 Z49.9
< ok
. 1500
"""


@pytest.fixture(autouse=True)
def needs(tool):
    """Need the compiler and the emulator."""
    for name in ("arm-none-eabi-gcc", "qemu-system-arm"):
        tool(name)


def played(core, text, mill):
    """Return what a session has come to on a target: its end, and all setpoints in one number."""
    with board(core, mill) as session:
        serving_runs.play(text, mill, session)
        return session.joints_nm, session.moving, session.hash


def check(core, text, mill):
    """Hold a session on a board against the same program on the host, and Python's module."""
    serving_runs.play(text, mill)
    assert played(core, text, mill) == played("host", text, mill)


@pytest.mark.sample(3, quick=1)
@pytest.mark.parametrize("core", ["m4f", "m7"])
@pytest.mark.parametrize("path", SESSIONS, ids=lambda path: path.stem)
def test_a_session_goes_as_it_is_written_on_a_board(path, core):
    check(core, path.read_text(encoding="utf-8"), serving_runs.mill())


@pytest.mark.sample(1, quick=0)
@pytest.mark.parametrize("core", ["m4f", "m7"])
def test_a_machine_with_switches_is_homed_and_probes_on_a_board(core):
    check(core, SWITCHES, machine(INPUTS))


@pytest.mark.thorough
@pytest.mark.sample(1)
@pytest.mark.parametrize("seed", range(1, 9))
@pytest.mark.parametrize("core", ["m4f", "m7"])
def test_a_stream_is_answered_on_a_board_and_ends_where_a_run_does(core, seed):
    with board(core, serving_runs.mill()) as session:
        serving_runs.streams(seed, session)
