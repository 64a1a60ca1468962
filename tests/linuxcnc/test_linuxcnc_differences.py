# SPDX-License-Identifier: MIT
"""What the module does otherwise than LinuxCNC's own planner on purpose, call by call, both ways.

All else that a host asks at rest is the same: test_linuxcnc_calls.py searches that by seed.
"""

import numpy as np
import pytest
from linuxcnc_calls import BY_HAND, SETTLES
from linuxcnc_stand_in import OWN, StandIn

TAP = ["sync 0.5 0", "tap 50 0 0 -3 0 0 0 0 0 0 1", "sync 0 0"]
THREADS = ["sync 0.5 0", "line 50 0 0 -3", SETTLES, "line 50 0 0 -6", SETTLES, "sync 0 0"]
TELL = [SETTLES, "tell"]
ARC = "arc 100 0 40 0 0 0 0 0 0 0 0 20 0 0 0 1 0"  # half of a circle, radius 20, X up to 20


@pytest.fixture(scope="module")
def stand_in(tmp_path_factory):
    if not OWN.is_file():
        pytest.skip("linuxcnc-uspace is not installed")
    return StandIn(tmp_path_factory.mktemp("linuxcnc"))


def told(run):
    """Return (place, what is told with it) of every `tell`."""
    for words in run.told("tell"):
        flags = dict(zip(words[3::2], words[4::2], strict=True))
        yield [float(each) for each in words[:3]], {key: float(x) for key, x in flags.items()}


def last(run):
    """Return the last place and flags."""
    return list(told(run))[-1]


def outputs(run):
    """Return the outputs that were made."""
    return [each[0] for each in run.told("dout")]


def z_left(run):
    place, flags = last(run)
    return round(place[2], 2), flags["done"]


def is_at_work(run):
    _, flags = last(run)
    return flags["id"], flags["active"]


# Name: script; what is looked at; LinuxCNC's own planner; ours.
DIFFERENCES = {
    "behind a tap in a hold the tool is at its end, not before it": (
        ["spindle 0 0", *TAP, "vlimit 0", "spindle 10 0", *TELL], lambda run: last(run)[1]["done"],
        0, 1),
    "a pause holds threads that wait for their spindle": (
        ["spindle 10 0", "atspeed 0", *THREADS, "pause", SETTLES, "atspeed 1", *TELL], z_left,
        (-6, 1), (0, 0)),
    "a move that waits for its spindle is the move in work": (
        ["spindle 0 0", *TAP, *TELL], is_at_work, (0, 0), (1, 1)),
    "behind an abort, in a hold, a wait for the spindle waits for the hold's end": (
        ["vlimit 0", "line 50 9 0 0", SETTLES, "abort", SETTLES, "clear", "dout 1 1", "wait",
         "line 50 9 0 0", *TELL], outputs, ["1"], []),
    "an output before a move of no length is made": (
        ["dout 1 1", "line 50 0 0 0", "line 50 9 0 0", *TELL], outputs, [], ["1"]),
    "an arc that leaves the travel is refused": (
        ["travel 0 -1 15", ARC, *TELL], lambda run: len(run.told("move")), 0, 1),
    "a step within a tolerance rests within it of the move's end": (
        [BY_HAND, "term 2 0.5", "pause", "line 50 10 0 0", "line 50 10 10 0", SETTLES, "step",
         *TELL], lambda run: np.linalg.norm(last(run)[0] - np.array([10, 0, 0])) <= 0.5,
        False, True),
    "reverse counts for nothing while nothing is to be done": (
        ["line 50 9 0 0", SETTLES, "reverse"], lambda run: run.told("reverse"), [["0"]], [["-1"]]),
}  # fmt: skip


@pytest.mark.parametrize("name", DIFFERENCES)
def test_a_difference_is_what_it_is_said_to_be(stand_in, name):
    script, look, *expected = DIFFERENCES[name]
    found = [look(stand_in.run(["term 1 0", *script], module=module)) for module in (OWN, None)]
    assert found == expected
    assert expected[0] != expected[1]
