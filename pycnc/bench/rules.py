# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench rules`: what each number of the planner buys.

The kernel is compiled without one number of docs/planner.md, section 17, after the other, and plans
programs of all kinds, for half an hour. time: how many times as long they take, in the mean; worst:
the one that loses most; work: how many times as many instructions, by the prices of the steps;
family: the kind that pays most, and how much of its time. `tests/slope/rules.py` says what is
planned, and takes single numbers. These are the same on every computer.
"""

import json
import subprocess
import sys
from pathlib import Path

from pycnc import errors

SCRIPT = Path(__file__).resolve().parents[2] / "tests" / "slope" / "rules.py"


def bench_rules_rows():
    """Return rows {number, without, time, worst, work, family, of_it}.

    Raises
    ------
    InternalError
        If the kernel as it is does not build or plan.
    """
    done = subprocess.run([sys.executable, SCRIPT, "--json"], stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        raise errors.InternalError("the kernel as it is does not plan", id="bench")
    return [json.loads(line) for line in done.stdout.splitlines()]
