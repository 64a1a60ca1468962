# SPDX-License-Identifier: MIT
"""A program that begins in the middle puts out again what stays: a printer's heaters, fan, shares
of speed and flow, and ports. What that is, the program's own words say."""

import random

import numpy as np
import pytest
from entering import MOVES

from pycnc import stages
from pycnc.kernel.bind import lib
from pycnc.machine import Machine

HEATERS = {104: 109, 140: 190, 141: 191}  # and the code that waits
OUT = (lib.NCK_BLOCK_OUTPUT, lib.NCK_BLOCK_WAIT)


def printed(pen):
    """Return (row, name, value, whether it waits) of a printer's setting."""
    code = pen.choice([*HEATERS, *HEATERS.values(), 106, 107, 220, 221])
    if code == 107:
        return "M107", 106, 0.0, False
    if code == 106 and pen.random() < 0.3:
        return "M106", 106, 255.0, False
    value = float(pen.randrange(1, 300))
    sets = {waits: sets for sets, waits in HEATERS.items()}
    letter = "R" if code in sets and pen.random() < 0.5 else "S"
    return f"M{code} {letter}{value:g}", sets.get(code, code), value, code in sets


def ported(pen):
    """Return the same of a port: digital ones by their number, analogue ones by its negative."""
    port = pen.choice([0, 1, 31, 32, 63, pen.randrange(64)])
    code = pen.choice([62, 63, 64, 65, 67, 68])
    if code < 66:
        return f"M{code} P{port}", ("digital", port), float(code in (62, 64)), False
    value = round(pen.uniform(-9, 9), 2)
    return f"M{code} E{port % 16} Q{value}", ("analogue", port % 16), value, False


def written(seed):
    """Return (machine, text, line of a move, name → (value, whether it was waited for))."""
    pen = random.Random(seed)
    name, said = pen.choice([("printer", printed), ("mill3", ported)])
    rows, state = ["G21 G90", "G1 X1 Y1 F900"], {}
    for k in range(pen.randrange(40)):
        row, place, value, waits = said(pen)
        state[place] = value, waits or state.get(place, (0, False))[1]
        rows += [row] + [f"G1 X{k % 7 + 2}"] * (pen.random() < 0.3)
    line = len(rows) + 1
    rows += ["G1 X9", "M107" if name == "printer" else "M64 P5", "G1 X3"]
    return name, "\n".join([*rows, ""]), line, state


def put_out(blocks):
    """Return name → (value, whether it waits) of what blocks put out, the last of each."""
    state = {}
    for block in blocks[np.isin(blocks["kind"], OUT)]:
        put, waits = block["output"], block["kind"] == lib.NCK_BLOCK_WAIT
        number, value = int(put["number"]), float(put["value"])
        assert put["kind"] in KINDS, put
        state[KINDS[put["kind"]](number)] = value, bool(waits)
    return state


KINDS = {
    lib.NCK_OUTPUT_SETTING: lambda n: {w: s for s, w in HEATERS.items()}.get(n, n),
    lib.NCK_OUTPUT_DIGITAL: lambda n: ("digital", n),
    lib.NCK_OUTPUT_ANALOGUE: lambda n: ("analogue", n),
}


@pytest.mark.sample(100)
@pytest.mark.parametrize("number", range(5000))
def test_what_a_program_has_put_out_is_put_out_again(number, draw_seed):
    name, text, line, state = written(draw_seed + number)
    machine = Machine.load(name, set=[f"dialect.from_line={line}"])
    blocks, diagnostics = stages.decode(text.encode(), machine)
    assert not (diagnostics["code"] < 0).any()
    ways = np.flatnonzero(np.isin(blocks["kind"], MOVES))
    assert put_out(blocks[: ways[2]]) == state
    ends = [int(block["line"]) for block in blocks[ways[2] + 1 :]]
    assert ends[:3] == [line, line + 1, line + 2]


@pytest.mark.parametrize(("line", "is_told"), [(2, False), (4, True)])
def test_a_code_of_the_machines_own_is_not_done_again_and_that_is_told(line, is_told):
    text = "G0 X1 Y1 Z1\nG0 X2\nM21 X3\nG0 X4\nM22 X5\n"
    changes = {"m.21.action": "output", "m.22.action": "wait", "dialect.from_line": line}
    _, diagnostics = stages.decode(text.encode(), Machine.load("mill3", set=changes))
    told = diagnostics[diagnostics["code"] == lib.NCK_NOTE_OWN_LEFT]
    assert told[["line", "value"]].tolist() == [(3, 21.0)] * is_told


@pytest.mark.sample(60)
@pytest.mark.parametrize("number", range(2000))
def test_codes_whose_effect_stays_are_done_again_the_latest_last(number, draw_seed):
    pen = random.Random(draw_seed + number)
    codes = pen.sample(range(100, 190), pen.randrange(1, 17))
    actions = {code: pen.choice(["output", "wait"]) for code in codes}
    stays = {code for code in codes if pen.random() < 0.7}
    said = [pen.choice(codes) for _ in range(pen.randrange(1, 30))]
    line = 2 + len(said)
    text = "\n".join(["G0 X1 Y1 Z1", *(f"M{code} X{k % 7}" for k, code in enumerate(said)), "X9\n"])
    changes = {f"m.{code}.action": action for code, action in actions.items()}
    changes |= {f"m.{code}.stays": True for code in stays} | {"dialect.from_line": line}
    blocks, told = stages.decode(text.encode(), Machine.load("mill3", set=changes))
    again = list(reversed(list(dict.fromkeys(code for code in reversed(said) if code in stays))))
    put = blocks[np.isin(blocks["kind"], OUT) & (blocks["output"]["kind"] == lib.NCK_OUTPUT_M)]
    kinds = {"output": OUT[0], "wait": OUT[1]}
    assert put["output"]["value"].tolist() == again
    assert put["kind"].tolist() == [kinds[actions[code]] for code in again]
    assert (told["code"] == lib.NCK_NOTE_OWN_LEFT).any() == (not set(said) <= stays)
