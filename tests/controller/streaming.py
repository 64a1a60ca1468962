# SPDX-License-Identifier: MIT
"""A program of the corpus, streamed by counted bytes with holds, overrides and ``?`` at 10 Hz.

    python tests/controller/streaming.py FILE [SLOPE [SEED]]

Every line is answered once, by ok; the end is that of a run. What it tells: seconds of the machine
and of the clock, and how often it was asked.
"""

import random
import sys
import time

from serving_runs import HOLD, OVERRIDES, RESUME, RING, Broken, Talk, end_of, mill, operate

from pycnc.bench import corpus

STEP, ASK = 10, 100  # ticks between two looks, and between two ?
SELDOM = ((0.0005, HOLD), (0.005, RESUME), (0.008, OVERRIDES))
FREE = {f"axis.{axis}.{end}_mm": 2000 * sign
        for axis in "xyz" for end, sign in (("min", -1), ("max", 1))}  # fmt: skip


def stream(lines, talk, draw):
    """Send all lines; return how often a report was asked for, and came."""
    lengths, sent, taken, passed, asked, told = [], 0, 0, 0, 0, 0
    while taken < len(lines):
        while sent < len(lines) and sum(lengths) + len(lines[sent]) + 1 <= RING:
            talk.send(lines[sent].encode() + b"\n")
            lengths.append(len(lines[sent]) + 1)
            sent += 1
        operate(talk, draw, SELDOM)
        if passed % ASK == 0:
            talk.send(b"?")
            asked += 1
        talk.wait(STEP)
        passed += STEP
        answers = [said for said in talk.said if not said.startswith("<")]
        if any(answer != "ok" for answer in answers):
            raise Broken(f"line {taken + 1} or soon behind it: {answers}")
        told += len(talk.said) - len(answers)
        taken += len(answers)
        del lengths[: len(answers)]
        talk.said.clear()
    return asked, told


def main(name, slope="jerk", seed=1):
    """Stream a file; tell what it took."""
    text = (corpus.FOLDER / name).read_text(encoding="latin-1")
    lines = [line for line in text.splitlines() if line.strip("% \t")]
    machine = mill(**FREE, **{"path.slope": slope})
    talk, begun = Talk(machine), time.monotonic()
    talk.said.clear()
    asked, told = stream(lines, talk, random.Random(int(seed)))
    talk.send(b"\x90\x95")
    talk.settle(4_000_000)
    took, machine_s = time.monotonic() - begun, talk.session.ticks * machine.period_s
    talk.check()
    if talk.session.joints_nm != end_of(lines, machine):
        raise Broken(f"the end is at {talk.session.joints_nm}")
    print(f"{name}, {slope}: {len(lines)} lines, {machine_s:.0f} s of the machine in {took:.1f} s, "
          f"{machine_s / took:.0f} times real time; {told} of {asked} reports, the end is exact")


if __name__ == "__main__":
    main(*sys.argv[1:])
