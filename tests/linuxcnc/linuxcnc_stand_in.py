# SPDX-License-Identifier: MIT
"""The planner module in a stand-in for LinuxCNC's motion controller: scripts in, setpoints out."""

import copy
import hashlib
import os
import re
import shutil
import subprocess
from functools import cache
from pathlib import Path
from typing import NamedTuple
from unittest import mock

import numpy as np
import pytest
from builds import CMAKE, NINJA, keep_what_is_compiled
from locks import locked

from pycnc import linuxcnc

ROOT = Path(__file__).resolve().parents[2]
CACHED = "/usr/lib/ccache"  # compilers of the same names; the kernel in one file takes 10 s of one
HEADERS = Path("/usr/include/linuxcnc")
OWN = Path("/usr/lib/linuxcnc/modules/tpmod.so")  # LinuxCNC's own planner
FLAGS = ["-D_GNU_SOURCE", "-DRTAPI", "-DSIM", "-Drealtime", "-D__MODULE__", "-rdynamic", "-O2"]
AXES = "XYZABCUVW"
# Jerk where an answer comes late and the tick brakes by itself (docs/stops.md).
BY_TICK = 1.15
JERK_COLUMNS = ("a_told", "j_told", "x_along", "y_along", "z_along")  # from 2.10 on
COLUMNS = (*AXES.lower(), "turns", "speed", "to_go", "id", "depth", "done", "v_asked")
CYCLE_S = 1e-3
EVER = 1_000_000  # cycles: longer than any script takes

INI = """[TRAJ]
COORDINATES = {coordinates}
LINEAR_UNITS = {units}
ANGULAR_UNITS = degree
{traj}
[KINS]
KINEMATICS = trivkins coordinates={joints}
{axes}"""


class Machine(NamedTuple):
    """Limits of every axis, in the machine's units."""

    axes: str = "XYZ"
    v: float = 100.0
    a: float = 1000.0
    j: float = 10_000.0
    units: str = "mm"
    traj: str = ""  # more lines of [TRAJ]

    @property
    def ini(self):
        """Return the text of its INI file."""
        limits = f"MAX_VELOCITY = {self.v}\nMAX_ACCELERATION = {self.a}\nMAX_JERK = {self.j}\n"
        return INI.format(
            coordinates=" ".join(self.axes), units=self.units, traj=self.traj,
            joints=self.axes.lower(), axes="".join(f"[AXIS_{x}]\n{limits}" for x in self.axes),
        )  # fmt: skip

    @property
    def limits(self):
        """Return the script that tells the planner the limits of its axes."""
        return [f"axis {AXES.index(x)} {self.v} {self.a}" for x in self.axes]


JERK = Machine(traj="NCK_PLANNER = jerk")


class Run(NamedTuple):
    """What a script has brought about; the rows have JERK_COLUMNS from 2.10 on."""

    machine: Machine
    answers: list  # lines of words
    log: str
    rows: np.ndarray  # a row a cycle, COLUMNS

    def column(self, name):
        """Return one column."""
        return self.rows[:, (*COLUMNS, *JERK_COLUMNS).index(name)]

    @property
    def places(self):
        """Return the places of the machine's axes, a row a cycle."""
        return self.rows[:, [AXES.index(x) for x in self.machine.axes]]

    def told(self, word):
        """Return the answers that begin with a word, without it."""
        return [answer[1:] for answer in self.answers if answer[0] == word]

    def peaks(self, rows=slice(None)):
        """Return the largest speed, acceleration and jerk of any axis, over its limits."""
        found = np.diff(self.places[rows], axis=0) / CYCLE_S
        shares = []
        for limit in (self.machine.v, self.machine.a, self.machine.j):
            shares.append(float(np.abs(found).max()) / limit)
            found = np.diff(found, axis=0) / CYCLE_S
        return shares


def headers_with_jerk(folder):
    """Write LinuxCNC's headers as they are from 2.10 on, as far as a planner meets them.

    A move tells its jerk behind its acceleration; the status has what the path's motion is.
    """
    text = (HEADERS / "tp.h").read_text(encoding="utf-8")
    told, moves = re.subn(r"(double\s+acc\s*,)(\s*unsigned)", r"\1 double ini_maxjerk,\2", text)
    status = (HEADERS / "motion.h").read_text(encoding="utf-8")
    fields = r"\1 double current_acc, current_jerk; PmCartesian current_dir;"
    more, places = re.subn(r"(double current_vel;)", fields, status)
    assert (moves, places) == (3, 1)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "tp.h").write_text(told, encoding="utf-8")
    (folder / "motion.h").write_text(more, encoding="utf-8")
    return folder


def built_module(headers=None, *, short_servo=False):
    """Return the planner module of this tree, compiled once for all tests that load it."""
    digest = hashlib.sha256(f"{bool(headers)} {short_servo}".encode())
    for pattern in ("csrc/nck/**/*.[ch]", "adapters/linuxcnc/*"):
        for path in sorted(ROOT.glob(pattern)):
            digest.update(path.read_bytes())
    folder = ROOT / "build" / "linuxcnc" / digest.hexdigest()[:16]
    keep_what_is_compiled()
    cached_first = {"PATH": f"{CACHED}:{os.environ['PATH']}"}
    with locked(folder), mock.patch.dict(os.environ, cached_first):
        module = folder / linuxcnc.MODULE
        return module if module.exists() else linuxcnc.build(
            folder, headers, short_servo=short_servo)


@cache
def told_by_the_same_build(*, short_servo=False):
    """Return the program of told.c, compiled with the capacities that the module has."""
    words = (ROOT / "adapters/linuxcnc/Makefile").read_text(encoding="utf-8")
    sizes = re.findall(r"-D(NCK_\w+=\d+)", words)
    sizes = [size for size in sizes if short_servo or not size.startswith("NCK_PROFILE")]
    folder = ROOT / "build" / ("linuxcnc_told_short" if short_servo else "linuxcnc_told")
    keep_what_is_compiled()
    configure = [CMAKE, "-S", ROOT, "-B", folder, "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={NINJA}",
                 f"-DNCK_CAPACITIES={';'.join(sizes)}"]  # fmt: skip
    libraries = ["libnck_host.a", "libnck.a"]
    program = folder / "told"
    link = ["gcc", "-std=gnu99", "-O2", f"-I{ROOT / 'csrc'}", *(f"-D{size}" for size in sizes),
            ROOT / "tests/linuxcnc/told.c", *(folder / each for each in libraries), "-lm",
            "-o", program]  # fmt: skip
    with locked(folder):
        for command in (configure, [NINJA, "-C", folder, *libraries], link):
            subprocess.run(command, check=True, capture_output=True)
    return program


class StandIn:
    """The module and the stand-in, compiled into a folder; it needs LinuxCNC's headers.

    tells_jerk: as LinuxCNC does from 2.10 on; short_servo: as `build --short-servo` makes it.
    """

    def __init__(self, folder, *, tells_jerk=False, short_servo=False):
        self.machine = Machine()
        if not (HEADERS / "tp.h").is_file():
            pytest.skip("linuxcnc-uspace-dev is not installed")
        self.folder = Path(folder)
        headers = headers_with_jerk(self.folder / "headers") if tells_jerk else None
        self.module = built_module(headers, short_servo=short_servo)
        self.columns = len(COLUMNS) + len(JERK_COLUMNS) * tells_jerk
        found = [f"-I{headers}", "-DTP_TAKES_JERK"] if tells_jerk else []
        self.program = self.folder / "stand_in"
        source = ROOT / "tests/linuxcnc/stand_in.c"
        command = ["gcc", *FLAGS, *found, f"-I{HEADERS}", source, "-o", self.program, "-ldl", "-lm"]
        subprocess.run(command, check=True)

    def exact(self):
        """Return the same with the planner `jerk`: the exact path, feeds to the last digit."""
        found = copy.copy(self)
        found.machine = JERK
        return found

    def start(self, script, machine, ini=None, module=None, under=()):
        """Run a script, `under` another program; return the process, whether or not it went well.

        module: another planner than the one that was built.
        """
        path = self.folder / "machine.ini"
        path.write_text(machine.ini if ini is None else ini, encoding="utf-8")
        return subprocess.run(
            [*under, self.program, module or self.module, self.folder / "trace"],
            input="\n".join([*machine.limits, *script]) + "\n",
            env={"INI_FILE_NAME": str(path)}, capture_output=True, text=True, timeout=300,
        )  # fmt: skip

    def run(self, script, machine=None, module=None):
        """Run a script on a machine; return what it has brought about."""
        machine = machine or self.machine
        done = self.start(script, machine, module=module)
        assert done.returncode == 0, done.stderr
        rows = np.fromfile(self.folder / "trace").reshape(-1, self.columns)
        return Run(machine, [line.split() for line in done.stdout.splitlines()], done.stderr, rows)

    def count(self, script, module=None, machine=None):
        """Run a script on a machine; return the instructions of each servo cycle."""
        out = self.folder / "callgrind"
        out.unlink(missing_ok=True)
        under = [shutil.which("valgrind"), "--tool=callgrind", "--combine-dumps=yes",
                 f"--callgrind-out-file={out}", "--toggle-collect=tpRunCycle",
                 "--dump-after=tpRunCycle"]  # fmt: skip
        done = self.start(script, machine or self.machine, module=module, under=under)
        assert done.returncode == 0, done.stderr
        found = re.findall(r"^totals: (\d+)", out.read_text(encoding="utf-8"), re.M)
        return np.array(found[:-1], int)  # the last one is of what comes behind the last cycle
