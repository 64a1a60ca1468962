# SPDX-License-Identifier: MIT
"""Runs of programs in the LinuxCNC that is installed here: simulated axes, no screen, no rights.

Every servo cycle advances the planner by one millisecond whatever the wall clock does, so that the
setpoints of a run are the same on every computer. LinuxCNC refuses to run as root: then it runs as
nobody.
"""

import contextlib
import fcntl
import json
import os
import shutil
import signal
import subprocess
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np

from pycnc import errors
from pycnc.linuxcnc import MODULE, MODULES

CYCLE_S = 1e-3
NOBODY = "65534"
LOCK = "pycnc-linuxcnc-live.lock"  # LinuxCNC runs once on a computer; others wait
START_S = 60.0  # that starting and ending LinuxCNC may take

INI = """[EMC]
VERSION = 1.1
MACHINE = live
[DISPLAY]
DISPLAY = ./display.py
[TASK]
TASK = milltask
CYCLE_TIME = 0.001
[RS274NGC]
PARAMETER_FILE = live.var
[EMCMOT]
EMCMOT = motmod
COMM_TIMEOUT = 4.0
BASE_PERIOD = 0
SERVO_PERIOD = 1000000
[EMCIO]
EMCIO = io
CYCLE_TIME = 0.100
TOOL_TABLE = tool.tbl
[HAL]
HALFILE = live.hal
[TRAJ]
NO_FORCE_HOMING = 1
COORDINATES = {coordinates}
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
DEFAULT_LINEAR_VELOCITY = {v_path}
MAX_LINEAR_VELOCITY = {v_path}
MAX_LINEAR_ACCELERATION = {a_path}
DEFAULT_LINEAR_ACCELERATION = {a_path}
ARC_BLEND_ENABLE = 1
ARC_BLEND_FALLBACK_ENABLE = 0
ARC_BLEND_OPTIMIZATION_DEPTH = 50
ARC_BLEND_GAP_CYCLES = 4
ARC_BLEND_RAMP_FREQ = 100
{planner}
[KINS]
KINEMATICS = {kinematics}
JOINTS = {joints}
[SPINDLE_0]
MAX_FORWARD_VELOCITY = 4000
"""

AXIS = """[{section}]
TYPE = {kind}
MIN_LIMIT = -10000
MAX_LIMIT = 10000
MAX_VELOCITY = {v}
MAX_ACCELERATION = {a}
MAX_JERK = {j}
HOME = {home}
HOME_OFFSET = {home}
FERROR = 50
MIN_FERROR = 50
HOME_SEARCH_VEL = 0
HOME_LATCH_VEL = 0
HOME_SEQUENCE = 0
"""

HAL = """loadrt [KINS]KINEMATICS
loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS
loadrt scale names={scales}
loadrt sim_spindle names=spindle
loadrt limit2 names=inertia
loadrt sampler depth=16000 cfg={columns}
addf motion-command-handler servo-thread
addf motion-controller servo-thread
addf inertia servo-thread
addf spindle servo-thread
setp inertia.maxv 1200
setp spindle.scale 0.0166666667
net spindle-asked spindle.0.speed-out => inertia.in
net spindle-speed inertia.out => spindle.velocity-cmd rps.in
addf rps servo-thread
setp rps.gain 0.0166666667
net spindle-turns spindle.position-fb => spindle.0.revs
net spindle-index spindle.0.index-enable <=> spindle.index-enable
net spindle-rps rps.out => spindle.0.speed-in
setp spindle.0.at-speed 1
net estop iocontrol.0.user-enable-out iocontrol.0.emc-enable-in
net tool-prepare iocontrol.0.tool-prepare iocontrol.0.tool-prepared
net tool-change iocontrol.0.tool-change iocontrol.0.tool-changed
net line motion.program-line => sampler.0.pin.0
net speed motion.current-vel => sampler.0.pin.1
net out motion.digital-out-00 => sampler.0.pin.2
net hold motion.feed-hold => sampler.0.pin.3
net time motion-controller.time => sampler.0.pin.4
net spindle-turns => sampler.0.pin.5
net coordinated motion.coord-mode => sampler.0.pin.6
net mark sampler.0.pin.7
net analog motion.analog-out-00 => sampler.0.pin.8
"""
COLUMNS = "sfbbsfbbf"  # of the sampler, before the joints
COORDINATED = 6  # one of them

JOINT = """net position{n} {place} => micrometres{n}.in
net motor{n} joint.{n}.motor-pos-cmd => joint.{n}.motor-pos-fb
setp micrometres{n}.gain 1000
addf micrometres{n} servo-thread
net micrometres{n} micrometres{n}.out => sampler.0.pin.{pin}
"""

TOOLS = "T1 P1 D0.125 Z0.5\nT2 P2 D0.0625 Z0.1\nT3 P3 D0.2 Z0.3\nT4 P4 D1.0 Z1\nT99999 P99999\n"


class Limits(NamedTuple):
    """Of every axis [mm/s, mm/s², mm/s³]."""

    v: float = 100.0
    a: float = 1000.0
    j: float = 10_000.0


class Kinematics(NamedTuple):
    """What makes joints of axes, as many."""

    module: str  # and its parameters
    homes: tuple = ()  # where the joints begin; without any at zero
    angular: str = ""  # joints that turn, by number
    hal: str = ""  # more lines

    @property
    def place(self):
        """Return the pin that has the place of an axis."""
        return "axis.{x}.pos-cmd" if self.module else "joint.{n}.pos-cmd"


TRIVIAL = Kinematics("")


class Log(NamedTuple):
    """A run, cycle by cycle: from the first cycle in which an axis moves to the last one."""

    line: np.ndarray  # of the program
    speed: np.ndarray  # as LinuxCNC tells it [mm/s]
    output: np.ndarray  # 1: M62 P0 or M64 P0
    hold: np.ndarray  # 1: the operator holds the feed
    time: np.ndarray  # that the motion controller took [ns]
    turns: np.ndarray  # of the spindle
    coordinated: np.ndarray  # 1: the planner leads, 0: a jog
    mark: np.ndarray  # 1: from when the operator has asked for rest
    analog: np.ndarray  # M67 E0, M68 E0
    places: np.ndarray  # of the axes, a row a cycle [mm, deg]
    text: str  # what LinuxCNC has said

    @property
    def time_s(self):
        """Return how long the program moved."""
        return (len(self.line) - 1) * CYCLE_S

    def peaks(self, limits):
        """Return the largest speed, acceleration and jerk of any axis, over their limits."""
        found, shares = self.places, []
        for limit in limits:
            found = np.diff(found, axis=0) / CYCLE_S
            shares.append(float(np.abs(found).max()) / limit)
        return shares

    def rest_s(self):
        """Return how long the axes moved after the operator held, or marked; None if nobody did."""
        begins = np.flatnonzero(np.diff(np.maximum(self.hold, self.mark)) > 0)
        if not len(begins):
            return None
        moves = np.abs(np.diff(self.places[begins[0] + 1 :], axis=0)).max(axis=1) > 1e-7
        return float(np.argmin(np.append(moves, False))) * CYCLE_S  # the log ends at rest


def absent(planner=""):
    """Return why there is no live run with a planner here; an empty text if there is."""
    for tool in ("linuxcnc", "halcmd", "halsampler"):
        if not shutil.which(tool):
            return f"{tool} is not installed: apt-get install linuxcnc-uspace"
    if os.geteuid() == 0 and not shutil.which("setpriv"):
        return "as root a live run needs setpriv"
    if planner.split()[:1] == [Path(MODULE).stem] and not (MODULES / MODULE).is_file():
        return f"{MODULE} is not in {MODULES}: pycnc linuxcnc build, then pycnc linuxcnc install"
    return ""


def _sections(axes, limits, kinematics):
    """Return the sections of axes and joints."""
    words = {"v": limits.v, "a": limits.a, "j": limits.j}
    homes = kinematics.homes or (0,) * len(axes)
    told = []
    for n, (x, home) in enumerate(zip(axes, homes, strict=True)):
        turns = {f"AXIS_{x}": x in "ABC",
                 f"JOINT_{n}": str(n) in kinematics.angular if kinematics.module else x in "ABC"}
        told += [AXIS.format(section=section, kind="ANGULAR" if angular else "LINEAR",
                             home=home if section[0] == "J" else 0, **words)
                 for section, angular in turns.items()]  # fmt: skip
    return "".join(told)


def _write(folder, planner, axes, limits, kinematics):
    """Write a configuration."""
    letters = axes.upper()
    ini = INI.format(
        coordinates=" ".join(letters), joints=len(letters),
        kinematics=kinematics.module or f"trivkins coordinates={letters.lower()}",
        v_path=2 * limits.v, a_path=2 * limits.a,
        planner=f"TPMOD = {planner}" if planner else "",
    )  # fmt: skip
    scales = ",".join(["rps", *(f"micrometres{n}" for n in range(len(letters)))])
    hal = HAL.format(scales=scales, columns=COLUMNS + len(letters) * "f") + kinematics.hal
    hal += "".join(JOINT.format(n=n, pin=len(COLUMNS) + n,
                                place=kinematics.place.format(n=n, x=letters[n].lower()))
                   for n in range(len(letters)))  # fmt: skip
    hal += "addf sampler.0 servo-thread\n"
    texts = {"live.ini": ini + _sections(letters, limits, kinematics), "live.hal": hal,
             "live.var": "", "tool.tbl": TOOLS}  # fmt: skip
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    display = folder / "display.py"
    display.write_text(
        "#!/usr/bin/python3\n" + Path(__file__).with_name("display.py").read_text("utf-8"),
        encoding="utf-8",
    )
    display.chmod(0o755)


def _read(path, axes, text):
    rows = []
    for line in path.read_text(encoding="ascii").splitlines():
        words = line.split()
        if len(words) == 1 + len(COLUMNS) + len(axes):
            rows.append(words[1:])
    if not rows:
        raise errors.StateError(f"LinuxCNC has not run:\n{text[-2000:]}", id="live")
    table = np.array(rows, dtype=float)
    table = table[np.argmax(table[:, COORDINATED] > 0) :]  # homing is not the program's
    places = table[:, len(COLUMNS) :] / 1000
    moves = np.flatnonzero(np.abs(np.diff(places, axis=0)).max(axis=1) > 1e-9)
    first, last = (moves[0], moves[-1] + 2) if len(moves) else (0, 1)
    columns = table[first:last, : len(COLUMNS)].T
    return Log(*columns, places[first:last], text)


def _call(call, folder, environment, limit_s):
    """Run LinuxCNC in a session of its own, all of which ends with it; return what it said."""
    said = folder / "said.txt"
    with said.open("wb") as file:
        process = subprocess.Popen(
            call, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=file,
            stderr=subprocess.STDOUT, start_new_session=True,
        )  # fmt: skip
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(limit_s)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
    return said.read_text(encoding="utf-8", errors="replace")


def run(folder, program, *, planner="", axes="XYZ", limits=None, script=(), limit_s=300.0,
        kinematics=TRIVIAL):  # fmt: skip
    """Run a program in LinuxCNC.

    Parameters
    ----------
    folder : path
        An empty one, for the configuration and the log.
    program : str
        NC text.
    planner : str
        What [TRAJ] TPMOD is to say, as ``nck_tp``; nothing is LinuxCNC's own.
    axes : str
        Letters.
    limits : Limits
        Of every axis.
    script : sequence of (float, str, ...)
        What the operator does: how long he waits [s], a word of display.py, what it takes.
    limit_s : float
        Wall clock that the program may take.
    kinematics : Kinematics
        Else each joint is an axis.

    Returns
    -------
    Log

    Raises
    ------
    AbsentError
        If LinuxCNC, or the planner's module, is not installed.
    StateError
        If LinuxCNC does not start, or the program does not end.
    """
    if reason := absent(planner):
        raise errors.AbsentError(reason, id="linuxcnc-absent")
    folder = Path(folder).resolve()
    _write(folder, planner, axes, limits or Limits(), kinematics)
    (folder / "program.ngc").write_text(program, encoding="utf-8")
    asked = {"program": str(folder / "program.ngc"), "log": str(folder / "log.txt"),
             "script": list(script), "limit_s": limit_s}  # fmt: skip
    call = ["linuxcnc", "-r", "live.ini"]
    environment = {"PATH": "/usr/bin:/bin", "HOME": str(folder), "USER": "nobody",
                   "LIVE": json.dumps(asked)}  # fmt: skip
    if os.geteuid() == 0:
        call = ["setpriv", f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups", *call]
        for path in [folder, *folder.iterdir()]:
            os.chown(path, int(NOBODY), int(NOBODY))
    with (Path(tempfile.gettempdir()) / LOCK).open("a") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        text = _call(call, folder, environment, limit_s + START_S)
    log = folder / "log.txt"
    if "\nend\n" not in text or not log.is_file():
        raise errors.StateError(f"LinuxCNC has not run to the end:\n{text[-2000:]}", id="live")
    return _read(log, axes, text)
