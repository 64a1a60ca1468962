# SPDX-License-Identifier: MIT
"""The firmware as a controller: on the host in virtual time, or on a Cortex-M under QEMU.

The firmware of ``firmware_sim/app`` is built in ``build/firmware`` when a controller is opened and
runs as a process of its own, with a job, a program, a report and a trace as its files.
"""

import functools
import shutil
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from pycnc import errors
from pycnc.errors import FirmwareError
from pycnc.program.diagnostics import Diagnostics, Wording
from pycnc.program.lines import Lines
from pycnc.machine import DEFAULT, Machine
from pycnc.kernel.records import dtype, enum

ROOT = Path(__file__).resolve().parents[2]
CORES = {"m4f": "mps2-an386", "m7": "mps2-an500"}
CONTROLLERS = ("host", *CORES)
TIMEOUT_S = 300.0
WANTED = frozenset({"done", "hold", "wait", "aborted", "estop"})  # ends that somebody asked for
INSTRUCTION_NS = {"m4f": 8, "m7": 4}  # of QEMU's virtual time: 125 and 250 million in a second
_COMPILER, _EMULATOR = "arm-none-eabi-gcc", "qemu-system-arm"
_PACKAGES = {
    _COMPILER: "gcc-arm-none-eabi libnewlib-arm-none-eabi",
    _EMULATOR: "qemu-system-arm",
    "cmake": "cmake",
}
# What the work takes where time is virtual, in units of the controller's clock of 25 MHz: about
# what an M7 takes for it with the jerk-limited slope.
_NOMINAL = {"prep_units": 280, "tick_units": 270, "feeder_units": 280}
_COUNTS = ("ticks", "overruns", "underruns", "starved_ticks", "given_away", "refused")
_LISTS = ("task", "diagnostic", "event")
_BOARD, _APP = enum("board_exit_t"), enum("app_exit_t")
_CAUSES = {  # exit status of the firmware → what has happened
    _BOARD.UNEXPECTED: "an exception that nobody takes", _BOARD.NMI: "NMI",
    _BOARD.HARD_FAULT: "hard fault", _BOARD.MEM_FAULT: "memory fault",
    _BOARD.BUS_FAULT: "bus fault", _BOARD.USAGE_FAULT: "usage fault",
    _BOARD.OVERRUN: "tick overrun", _BOARD.WATCHDOG: "watchdog",
    _APP.SYSTEM: "its tasks could not be made", _APP.STREAMS: "a file could not be opened",
    _APP.KERNEL: "its operating system refused a call",
    _APP.BITS: "its arithmetic gives other bits than the kernel was tested with",
}  # fmt: skip


class Outcome:
    """What a run of the firmware gave.

    Attributes
    ----------
    state : str
        The state it ended in: "done", "hold", "aborted", "program_error", "soft_limit", "estop",
        "fault_overrun", "fault_stack", "fault_starved", "fault_task", "fault_machine", or another
        one if ``max_ticks`` ended it.
    events : list of (int, str)
        Changes of state, and the tick each came after.
    hash : str
        FNV-1a of 64 bits over the setpoints of all ticks with something to do.
    joints_nm : tuple of int
        Where the axes stand at the end [nm, nanodegrees].
    ticks, overruns, underruns, starved_ticks, given_away : int
        Ticks with something to do; ticks longer than their period; ticks that preparation was late
        for, at a stop or on the stop tail, and those on the tail; periods without a setpoint after
        an overrun.
    refused : int
        Commands that the machine cannot follow: a travel of a joint that it does not have.
    load : dict
        Share of the processor's time: "tick", and every task by its name.
    tick_most : float
        The longest tick, as a share of its period.
    stack_left : dict
        Bytes of stack that each task never touched.
    diagnostics : Diagnostics
    rows : numpy.ndarray or None
        One item a tick: tick, line, queue, state, tick_state, limit, drives, joint_nm.
    facts : dict
        Every number of the report.
    wall_s : float
    """

    def __init__(self, report, diagnostics, rows, period_s, wall_s):
        self.facts, self.wall_s = report, wall_s
        self.diagnostics, self.rows = diagnostics, rows
        names = report["names"].split()
        self.state, self.hash = report["state"], report["hash"]
        self.joints_nm = tuple(map(int, report["joints"].split()))
        self.events = [(int(tick), names[int(code)]) for tick, code in report["event"]]
        for name in _COUNTS:
            setattr(self, name, int(report[name]))
        self._measure(report, period_s)
        self.state_names = dict(enumerate(names))

    def _measure(self, report, period_s):
        clock = max(int(report["clock_units"]), 1)
        self.load = {"tick": int(report["tick_units"]) / clock}
        self.load |= {words[0]: int(words[3]) / clock for words in report["task"]}
        self.stack_left = {words[0]: int(words[5]) for words in report["task"]}
        self.tick_most = int(report["tick_most_units"]) / (period_s * int(report["clock_hz"]))

    def as_dict(self):
        """Return what a script needs to know, ready for JSON."""
        names = ("state", "hash", *_COUNTS, "load",
                 "tick_most", "stack_left", "joints_nm", "events", "wall_s")  # fmt: skip
        facts = {name: getattr(self, name) for name in names}
        return facts | {"diagnostics": self.diagnostics.as_list()}

    def lines(self):
        """Return a summary for a person, a line each."""
        load = ", ".join(f"{name} {share:.1%}" for name, share in self.load.items())
        return [
            f"  {self.state} after {self.ticks:,} ticks; setpoints {self.hash}",
            f"  load: {load}; longest tick {self.tick_most:.1%} of its period",
            f"  {self.overruns:,} overruns, {self.underruns:,} underruns; {self.wall_s:.1f} s",
        ]

    def __repr__(self):
        return f"<Outcome {self.state} after {self.ticks} ticks, setpoints {self.hash}>"


class Controller:
    """A controller that is built and ready; made by `open`."""

    def __init__(self, name, image):
        self.name, self._image = name, image

    def run(self, program, machine=DEFAULT, commands=(), *, file="<text>", trace=False,
            timeout_s=TIMEOUT_S, instruction_ns=None, **conditions):  # fmt: skip
        """Run a program and return what happened.

        Parameters
        ----------
        program : str or bytes
            NC text.
        machine : str, path or Machine
        commands : iterable of tuple
            (tick, name, numbers…), in any order: what the operator does behind the setpoint of
            that tick. Names: "hold", "resume", "override" (feed and rapid in percent),
            "single_block" (1 or 0), "abort", "estop", "travel" (joint, lowest and highest
            nanometre), and what a test does: "feeder_pause" (ticks), "tick_work" (units of the
            clock, ticks), "stack_work" (priority of a task), "task_work" and "masked_work"
            (priority, units), "trap" (priority).
        file : str
            Name of the program in diagnostics.
        trace : bool
            Keep a row a tick.
        timeout_s : float
            Wall time.
        instruction_ns : int, optional
            What an instruction of a Cortex-M takes, a power of two; 8 on an M4F and 4 on an M7
            unless said otherwise. Of no meaning on the host.
        **conditions
            prep_steps (of a tick at most; 0: no limit), wait_ticks (until the operator resumes
            after M0, M1, M6; 0: never), starve_ticks (at rest without text until that is a fault;
            0: never), max_ticks; prep_units, tick_units and feeder_units: what the work takes on
            the host.

        Returns
        -------
        Outcome

        Raises
        ------
        FirmwareError

        Examples
        --------
        >>> outcome = open("host").run("G1 F600 X5", commands=[(100, "hold"), (200, "resume")])
        >>> outcome.state, outcome.joints_nm[0]
        ('done', 5000000)
        """
        mill = Machine.load(machine)
        job = [*_settings(mill), *_conditions(conditions, trace), *_commands(commands)]
        text = program.encode() if isinstance(program, str) else program
        with tempfile.TemporaryDirectory(prefix="pycnc-") as folder:
            place = Path(folder)
            (place / "job").write_text("\n".join(job) + "\n", encoding="ascii")
            (place / "program").write_bytes(text)
            begin = time.perf_counter()
            self._execute(place, timeout_s, instruction_ns)
            wall_s = time.perf_counter() - begin
            report = _read_report(place / "report")
            rows = _read_rows(place / "trace", report) if trace else None
        found = Diagnostics()
        Wording(file, Lines(text), mill).add(found, _findings(report))
        return Outcome(report, found, rows, mill.period_s, wall_s)

    def _execute(self, place, timeout_s, instruction_ns):
        command = [self._image]
        if self.name in CORES:
            shift = (instruction_ns or INSTRUCTION_NS[self.name]).bit_length() - 1
            command = [
                _EMULATOR, "-M", CORES[self.name], "-display", "none", "-monitor", "none",
                "-serial", "none", "-semihosting-config", "enable=on,target=native",
                "-icount", f"shift={shift},align=off,sleep=off",
                "-kernel", self._image,
            ]  # fmt: skip
        try:
            done = subprocess.run(command, cwd=place, capture_output=True, timeout=timeout_s)
        except subprocess.TimeoutExpired:
            raise FirmwareError(
                f"the {self.name} controller did not end within {timeout_s:g} s: allow more time, "
                "or give max_ticks", id="controller-timeout",
            ) from None  # fmt: skip
        self._judge(done, place)

    def _judge(self, done, place):
        if done.returncode == 0:
            return
        report = place / "report"
        words = report.read_text(encoding="ascii") if report.exists() else ""
        if words.startswith("job_error"):
            number = int(words.split()[1])
            line = (place / "job").read_text(encoding="ascii").splitlines()[number - 1]
            raise errors.ArgumentError(f"the controller does not take {line!r}", id="job")
        cause = _CAUSES.get(done.returncode, f"exit status {done.returncode}")
        said = done.stderr.decode(errors="replace").strip()
        raise FirmwareError(
            f"the {self.name} controller stopped: {cause}{': ' if said else ''}{said}",
            id="controller-fault",
        )


def open(controller="host"):
    """Open a controller; its firmware is built first where that has not been done yet.

    Parameters
    ----------
    controller : {"host", "m4f", "m7"}
        The native program in virtual time, or a Cortex-M under QEMU.

    Returns
    -------
    Controller

    Raises
    ------
    FirmwareError
        The sources, a compiler or the emulator is missing, or the build fails.
    """
    if controller not in CONTROLLERS:
        raise errors.ArgumentError(f"no controller {controller!r}; there are: "
                                   f"{', '.join(CONTROLLERS)}", id="controller")  # fmt: skip
    return Controller(controller, _build(controller))


def _tool(name):
    """Return the path of a program: beside Python, or on the search path."""
    beside = Path(sys.executable).with_name(name)
    path = str(beside) if beside.exists() else shutil.which(name)
    if path is None:
        raise FirmwareError(f"{name} is not installed: on Debian, apt-get install "
                            f"{_PACKAGES[name]}", id="controller-absent")  # fmt: skip
    return path


@functools.cache
def _build(controller):
    """Build the firmware of a controller and return its image."""
    import fcntl  # not everywhere where the rest of pycnc runs

    if not (ROOT / "firmware_sim" / "app").is_dir():
        raise FirmwareError("controllers are built from the sources of pycnc: work in a checkout, "
                            "with an editable install", id="controller-absent")  # fmt: skip
    folder = ROOT / "build" / "firmware" / controller
    configure = [_tool("cmake"), "-S", ROOT, "-B", folder, "-DNCK_FIRMWARE=ON",
                 "-DNCK_CAPACITIES=FULL"]  # fmt: skip
    if controller in CORES:
        toolchain = ROOT / "firmware_sim" / "board" / "arm-none-eabi.cmake"
        configure += ["--toolchain", toolchain, f"-DNCK_CORE={controller}"]
        _tool(_COMPILER), _tool(_EMULATOR)
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        make = [_tool("cmake"), "--build", folder, "--target", "firmware", "--parallel", "2"]
        for command in (configure, make):  # a folder of before has other capacities
            done = subprocess.run(command, capture_output=True, text=True)
            if done.returncode != 0:
                raise FirmwareError(f"the firmware of {controller} does not build:\n{done.stdout}"
                                    f"{done.stderr}", id="controller-build")  # fmt: skip
    suffix = ".elf" if controller in CORES else ""
    return folder / "firmware_sim" / "app" / f"firmware{suffix}"


def _number(value):
    """Return a number as the firmware reads it: exactly."""
    return float(value).hex() if isinstance(value, np.floating) else str(int(value))


def _items(prefix, value):
    """Yield (name, index…, number) of a record, of lists of records and of lists."""
    if isinstance(value, np.void):
        for name in value.dtype.names:
            if name != "reserved":
                yield from _items(f"{prefix}.{name}" if prefix else name, value[name])
    elif isinstance(value, np.ndarray):
        for k, item in enumerate(value):
            for name, *index, number in _items(prefix, item):
                yield name, k, *index, number
    else:
        yield prefix, value


def _settings(machine):
    """Return the machine as lines of a job; what is zero need not be said."""
    record = machine.record
    lines, tools = [], int(record["tool_count"])
    for name, *index, number in _items("", record):
        row, column = [*index, 0, 0][:2]
        of_axis = name.startswith("axis.")
        absent = (of_axis and not record["axis"][row]["present"]) or (
            name.startswith("tool.") and row >= tools
        )
        if number != 0 and not absent:
            lines.append(f"set {name} {row} {column} {_number(number)}")
    return lines


def _conditions(conditions, trace):
    """Return the conditions of a run as lines of a job; the firmware knows which there are."""
    values = _NOMINAL | conditions | {"trace": int(trace)}
    return [f"{name} {int(value)}" for name, value in values.items()]


def read_commands(texts):
    """Return commands for `Controller.run` from texts such as ``"400 override 50 100"``.

    Raises
    ------
    ArgumentError
    """
    commands = []
    for text in texts:
        words = text.split()
        try:
            tick, name, *numbers = words
            commands.append((int(tick), name, *map(int, numbers)))
        except ValueError:
            raise errors.ArgumentError(f"{text!r} is no command: a tick, a name and its numbers, "
                                       "such as \"250 hold\"", id="job") from None  # fmt: skip
    return commands


def _commands(commands):
    ordered = sorted(commands, key=lambda command: command[0])
    return [
        f"at {int(tick)} {name} {' '.join(str(int(number)) for number in numbers)}".strip()
        for tick, name, *numbers in ordered
    ]


def _read_report(path):
    """Return word → rest of its line; tasks, diagnostics and events are lists of words."""
    report = {name: [] for name in _LISTS}
    for line in path.read_text(encoding="ascii").splitlines():
        name, _, rest = line.partition(" ")
        if name in _LISTS:
            report[name].append(rest.split())
        else:
            report[name] = rest
    return report


def _findings(report):
    """Return the diagnostics of a report as records of the kernel."""
    rows = np.zeros(len(report["diagnostic"]), dtype("nck_diagnostic_t"))
    for row, (code, line, column, letter, *reals) in zip(rows, report["diagnostic"], strict=True):
        row["code"], row["line"], row["column"] = int(code), int(line), int(column)
        row["letter"] = int(letter)
        row["value"], row["limit"] = (struct.unpack(">d", bytes.fromhex(b))[0] for b in reals)
    return rows


def _read_rows(path, report):
    joints = len(report["joints"].split())
    return np.fromfile(path, np.dtype([*dtype("app_row_t").descr, ("joint_nm", "<i8", (joints,))]))
