# SPDX-License-Identifier: MIT
"""Runs nasty programs from a seed and tells what they find, each as the smallest program that
still finds it; exit 1 if there is any.

    python tests/kernel/nasty.py --slope jerk --count 2000 --seed 1

A worker process judges; one that does not answer in time is a finding too.
"""

import argparse
import multiprocessing
import re
import sys
import time
from dataclasses import replace
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))

import nasty_judge
import nasty_seeds

ANSWER_S = 20.0  # a case that takes longer hangs
TRIALS = 200  # to make a finding smaller
SHRINK_S = 60.0


class Worker:
    """Judges cases in a process of its own."""

    def __init__(self):
        self._context = multiprocessing.get_context("fork")
        self._process = None

    def _begin(self):
        self._pipe, theirs = self._context.Pipe()
        self._process = self._context.Process(target=_serve, args=(theirs,), daemon=True)
        self._process.start()
        theirs.close()

    def find(self, case, answer_s=ANSWER_S):
        """Return the findings of a case."""
        if self._process is None:
            self._begin()
        self._pipe.send(case)
        try:
            if self._pipe.poll(answer_s):
                return self._pipe.recv()
            found = [f"hangs: no answer in {answer_s:g} s"]
        except (EOFError, ConnectionResetError):
            self._process.join()
            found = [f"dies: exit code {self._process.exitcode}"]
        self.close()
        return found

    def close(self):
        """End the process."""
        if self._process is not None:
            self._process.kill()
            self._process.join()
            self._process = None


def _serve(pipe):
    while True:
        try:
            case = pipe.recv()
        except EOFError:
            return
        pipe.send(nasty_judge.find(case))


def kind_of(finding):
    """Return what a finding is about, without its numbers."""
    words = re.sub(r"^(.*error\[(.*)\]): .*", r"error \2", finding.split("\n")[0])
    words = re.sub(r"^(line \d+|tick \d+, line [\d?]+): ", "", words)
    return re.sub(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?", "#", re.sub(r"\[[^]]*\]", "#", words))


def shrink(case, kind, worker):
    """Return the smallest case found that has a finding of this kind."""
    left, until = TRIALS, time.monotonic() + SHRINK_S
    patience = 2.0 if kind.startswith("hangs") else ANSWER_S

    def is_kept(smaller):
        nonlocal left
        left -= 1
        if left < 0 or time.monotonic() > until:
            return False
        return kind in map(kind_of, worker.find(smaller, patience))

    for simpler in ({"prep_steps": 256}, {"commands": ()}, {"relative": False}):
        if is_kept(replace(case, **simpler)):
            case = replace(case, **simpler)
    for name in ("items", "commands", "items"):
        case = _with_fewer(case, name, is_kept)
    return case


def _with_fewer(case, name, is_kept):
    """Leave out halves, quarters, … single ones of a list, as long as the finding stays."""
    size = max(1, len(getattr(case, name)) // 2)
    while True:
        at = 0
        while at < len(getattr(case, name)):
            items = getattr(case, name)
            smaller = replace(case, **{name: items[:at] + items[at + size :]})
            if is_kept(smaller):
                case = smaller
            else:
                at += size
        if size == 1:
            return case
        size //= 2


def findings(slope, seed, numbers, worker, family="all"):
    """Yield (number, case, finding) of everything that is found."""
    for number in numbers:
        case = nasty_seeds.case(slope, seed, number, family)
        for finding in worker.find(case):
            yield number, case, finding


def told(case, finding):
    """Return a case and its finding as text."""
    text, _ = case.written()
    commands = ", ".join(map(str, case.commands)) or "none"
    return (f"{finding}\n--- machine\n{case.machine}--- program\n{text}"
            f"--- commands: {commands}; prep steps: {case.prep_steps}\n")  # fmt: skip


def main(arguments=None):
    """Run the command line; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--slope", choices=(*nasty_seeds.SLOPES, "optimal"), default="jerk")
    parser.add_argument("--family", choices=nasty_seeds.FAMILIES, default="all")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    options = parser.parse_args(arguments)
    worker, kinds = Worker(), {}
    numbers = range(options.first, options.first + options.count)
    drawn = options.slope, options.seed, numbers, worker, options.family
    for number, case, finding in findings(*drawn):
        kind = kind_of(finding)
        kinds[kind] = kinds.get(kind, 0) + 1
        print(f"=== {options.slope} {options.seed} {number}: {finding}", flush=True)
        if kinds[kind] <= 2:
            smallest = shrink(case, kind, worker)
            found = [one for one in worker.find(smallest) if kind_of(one) == kind]
            print(told(smallest, (found or [finding])[0]), flush=True)
    worker.close()
    print(f"{options.count} programs, {sum(kinds.values())} findings")
    for kind, count in sorted(kinds.items(), key=lambda item: -item[1]):
        print(f"{count:6} {kind}")
    return 1 if kinds else 0


if __name__ == "__main__":
    sys.exit(main())
