# SPDX-License-Identifier: MIT
"""Lathe programs as they are, in the LinuxCNC that is installed: grooves and feeds a revolution.

    .venv/bin/python tests/linuxcnc/lathe_live.py [PROGRAM.ngc … ]     its own ones without any

A groove is cut without a rest, its lead is the program's within 0.5 %, and no axis passes a limit.
"""

import re
import sys
import tempfile
from pathlib import Path
from unittest import mock

import numpy as np

from pycnc.linuxcnc import live

SHIPPED = [Path("/usr/share/linuxcnc/ncfiles/g76.ngc")]
TOOLS = "".join(f"T{n} P{n}\n" for n in range(1, 10))  # cutters of no size
LONG_S = 900.0  # that a program may take: it runs as long as on a machine
OFF = 5e-3  # of a lead
EVEN = 0.02  # of it: where the tool follows the spindle, and does not run in or out
LEAST = 1.0  # revolutions: what follows for less is a corner between two speeds
FINE_MM = 1e-6  # the log counts nanometres
LIMITED = 1e-3  # so limits hold by this share

# As LinuxCNC's manual has them (chapters G33, G33.1, G76, G95): name → text.
MANUAL = {
    "G33": "G20 G90 G18\nG0 X1 Z0.1\nS100 M3\nG33 Z-2 K0.125\nG0 X1.25\nZ0.1\nM2\n",
    "G33.1": "G20 G90 G17\nG0 X1.000 Y1.000 Z0.100\nS100 M3\nG33.1 Z-0.750 K0.05\nM2\n",
    "G76": ("G20 G90 G18\nS400 M3\nG0 Z-0.5 X0.2\n"
            "G76 P0.05 Z-1 I-.075 J0.008 K0.045 Q29.5 L2 E0.045\nM2\n"),
    "G95": "G20 G90 G18\nG0 X1 Z0\nS600 M3\nG4 P1\nG95 F0.01\nG1 Z-0.5\nM2\n",
}  # fmt: skip


def lead_of(text):
    """Return the lead of a program's only groove, or its feed a revolution [mm]."""
    words = re.search(r"g76 *p([\d.]+)|g33[^\n]*k([\d.]+)|g95 *f([\d.]+)", text, re.I)
    inch = re.search(r"g20(?!\d)", text, re.I)
    return float(words[1] or words[2] or words[3]) * (25.4 if inch else 1.0)


def grooves(log, lead):
    """Return (first, last cycle) of all that follows the spindle by a lead along Z."""
    way, turn = np.abs(np.diff(log.places[:, -1])), np.abs(np.diff(log.turns))
    follows = (turn > 0) & (np.abs(way - lead * turn) < EVEN * lead * turn + FINE_MM)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], follows.astype(int), [0]])))
    pairs = zip(edges[::2], edges[1::2], strict=True)
    return [(a, b) for a, b in pairs if abs(log.turns[b] - log.turns[a]) > LEAST]


def failures(log, lead):
    """Return what is wrong with a run, in words."""
    wrong = [f"{peak:.3f} of a limit" for peak in log.peaks(live.Limits()) if peak > 1 + LIMITED]
    found = grooves(log, lead)
    if not found:
        wrong.append("no groove")
    for a, b in found:
        cut = abs(log.places[b, -1] - log.places[a, -1]) / abs(log.turns[b] - log.turns[a])
        if abs(cut / lead - 1) > OFF:
            wrong.append(f"{cut:.4f} mm a revolution in place of {lead:.4f}")
    # a groove that goes on the same way from where one has ended had a rest in it
    for (first, end), (begin, last) in zip(found, found[1:], strict=False):
        gone = np.abs(np.diff(log.places[end : begin + 1], axis=0)).sum(axis=0)
        ways = [log.places[b, -1] - log.places[a, -1] for a, b in ((first, end), (begin, last))]
        if gone[0] < FINE_MM and gone[-1] < lead and ways[0] * ways[1] > 0:
            wrong.append(f"a rest in the groove, cycle {end}")
    return wrong


def try_text(folder, text, planner="nck_tp"):
    """Run a program; return what is wrong with it, and how many grooves it has."""
    lead = lead_of(text)
    with mock.patch.object(live, "TOOLS", TOOLS):
        log = live.run(folder, text, planner=planner, limit_s=LONG_S)
    return failures(log, lead), len(grooves(log, lead))


def main():
    """Run programs; 1 if one of them is wrong."""
    named = [Path(each) for each in sys.argv[1:]]
    todo = dict.fromkeys(path.read_text(encoding="latin-1") for path in named or SHIPPED)
    texts = [*([] if named else MANUAL.values()), *todo]
    bad = 0
    for text in texts:
        name = text.strip().splitlines()[0]
        with tempfile.TemporaryDirectory() as folder:
            Path(folder).chmod(0o755)
            wrong, count = try_text(folder, text)
        bad += bool(wrong)
        print(name, f"{count} grooves", *wrong, sep="; ", flush=True)
    return int(bad > 0)


if __name__ == "__main__":
    sys.exit(main())
