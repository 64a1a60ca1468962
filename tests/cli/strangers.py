# SPDX-License-Identifier: MIT
"""A stranger at the command line: any machine, any program, any verb, some of them wrong.

    .venv/bin/python tests/cli/strangers.py COUNT SEED

tries COUNT strangers, each with several commands, and says what none of them may see: a traceback,
an error without a place or a remedy, a time that goes the wrong way.
"""

import contextlib
import json
import os
import random
import re
import sys
import tempfile
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parents[1]),
                str(Path(__file__).resolve().parents[1] / "machine")]  # fmt: skip

import configurations  # noqa: E402
import stranger_programs  # noqa: E402
from command_line import pycnc  # noqa: E402

SHIPPED = ("router", "laser", "printer_klipper", "printer_marlin", "printer", "haas_vf2",
           "lathe_fanuc", "mill3", "mill4")  # fmt: skip
FITS = {
    "router": ("router", "laser"), "laser": ("laser",), "printer_klipper": ("print", "klipper"),
    "printer_marlin": ("print",), "printer": ("print",), "haas_vf2": ("haas",),
    "lathe_fanuc": ("lathe",), "mill3": ("linuxcnc",), "mill4": ("linuxcnc",),
    "linuxcnc": ("linuxcnc",), "klipper": ("print", "klipper"), "grbl": ("router", "laser"),
    "fluidnc": ("router", "laser"), "marlin": ("print",), "reprap": ("print",),
}  # fmt: skip
ODD = ("0", "-1", "-0.0", "1e30", "1e-30", "nan", "inf", "", "abc", "1,5", "1e", "--3", "0x10")
SLOWER = 1.005  # a doubled acceleration may cost so much: positions fall in other whole steps
AWAY = 0.01  # s, which a doubled acceleration may cost besides


def damaged(pen, data):
    """Return (bytes, whether it is one number) of a configuration that hands or disks spoilt."""
    kind = pen.randrange(6)
    if kind == 0:  # a number that is none, or an odd one
        found = list(re.finditer(rb"(?<=[=:XYZEPJ ])-?\d+\.?\d*(?=\s)", data))
        for match in pen.sample(found, min(len(found), pen.randrange(1, 3)))[:1]:
            odd = pen.choice(ODD).encode()
            return data[: match.start()] + odd + data[match.end() :], True
    rows = data.split(b"\n")
    at = pen.randrange(len(rows))
    if kind == 1:
        del rows[at]
    elif kind == 2:
        rows.insert(at, pen.choice(rows))
    elif kind == 3:
        rows = rows[:at]
    elif kind == 4:
        rows.insert(at, bytes(pen.randrange(256) for _ in range(pen.randrange(1, 9))))
    return b"\n".join(rows), False


class Stranger:
    """Somebody with a folder, a machine and a program; `faults` is what must not be."""

    def __init__(self, seed, folder):
        self.pen, self.folder, self.faults = random.Random(seed), Path(folder), []
        self.calls = 0
        self.machine, kind = self._machine(seed)
        fits = FITS[kind] if self.pen.random() < 0.85 else stranger_programs.LANGUAGES
        self.language, text = stranger_programs.written(self.pen, fits)
        self.is_whole = self.pen.random() < 0.6
        if not self.is_whole:
            text = stranger_programs.spoilt(self.pen, text)
        self.file = self.folder / self.pen.choice(["part.nc", "a part.gcode", "Ä.ngc"])
        self.file.write_bytes(text)
        self.lines = len(text.splitlines())

    def _machine(self, seed):
        """Return (machine, kind): a shipped one's name, or the file of an import; None: refused."""
        if self.pen.random() < 0.5:
            name = self.pen.choice(SHIPPED)
            return name, name
        kind = self.pen.choice(configurations.KINDS)
        case = getattr(configurations, kind)(seed)
        numbers = others = 0
        for name, data in case.files.items():
            if self.pen.random() < 0.5:
                data, is_number = damaged(self.pen, data)
                numbers, others = numbers + is_number, others + (not is_number)
            (self.folder / name).write_bytes(data)
        made, first = self.folder / "made.toml", self.folder / next(iter(case.files))
        more = ["--units", case.units] if case.units else []
        told = self.call("machine", "import", first, "-o", made, *more)
        count = sum("error[" in line for line in told.err.splitlines())
        self._must(others or count <= numbers, f"{count} errors for {numbers}", told)
        if told.code == 0:
            shown = self.call("machine", "validate", made)
            self._must(shown.code == 0, "an import that is no machine file", shown)
        return (made if told.code == 0 else None), kind

    def _must(self, good, words, told):
        if not good:
            self.faults.append(f"{words}: {told.out[-300:]}{told.err[-600:]}")

    def call(self, *arguments):
        """Call pycnc, and see that it says what it has to say as it should."""
        self.calls += 1
        told = pycnc(*arguments)
        said, shown = told.out + told.err, " ".join(str(each) for each in arguments)
        broken = "Traceback" in said or "error[internal]" in said
        self._must(not broken, f"{shown}: fell over", told)
        self._must(told.code in (0, 1, 2), f"{shown}: exit code {told.code}", told)
        is_told = "error[" in said or "Error: " in said or '"error"' in said
        self._must((told.code != 0) == is_told, f"{shown}: {told.code}, and errors differ", told)
        self._must(len(said) < 40_000 or "--json" in arguments, f"{shown}: endless", told)
        return told

    def located(self):
        """Check the program: each error has a line, and a remedy."""
        told = self.call("check", self.file, "-m", self.machine, "--json")
        for found in json.loads(told.out) if told.code in (0, 1) else ():
            if found["severity"] == "error" and not (found["help"] and found["message"]):
                self.faults.append(f"no remedy: {found}")
            if found["severity"] == "error" and not found["line"] and found["id"] != "no-program":
                self.faults.append(f"no line: {found}")
        return told.code == 0

    def timed(self, *more):
        """Return what ``time --json`` tells; None: it is refused."""
        told = self.call("time", self.file, "-m", self.machine, "--json", *more)
        return json.loads(told.out) if told.code == 0 else None

    def times(self):
        """See that the times of a good program go the way that they have to."""
        whole = self.timed("--by", "line")
        if whole is None:
            self.faults.append(f"checked, and no time: {self.file.read_bytes()[:300]}")
            return
        total_s = whole["total_s"]
        parts_s = sum(part["time_s"] for part in whole["parts"])
        if not 0 <= total_s < 1e9 or abs(parts_s - total_s) > 1e-6 * (1 + total_s):
            self.faults.append(f"lines come to {parts_s}, the whole to {total_s}")
        self._slower(total_s)
        self._quicker(whole, total_s)
        self._cut(whole, total_s)

    def _slower(self, total_s):
        slow = self.timed("--override", 50)
        if slow is None or slow["total_s"] < total_s * (1 - 1e-9) - 2e-3:
            self.faults.append(f"at half the speed {slow and slow['total_s']} s, not {total_s}")

    def _quicker(self, whole, total_s):
        """Twice every acceleration is no slower, by a control's planner.

        LinuxCNC cuts its corners wider where it accelerates less, so that the way is shorter.
        """
        if whole["control"] in ("nck", "linuxcnc"):
            return
        from pycnc.machine import Machine
        from pycnc.planning import control

        machine = Machine.load(str(self.machine))
        changes = control.accelerations_twice(machine)
        more = [word for key, value in changes.items() for word in ("--set", f"{key}={value}")]
        quick = self.timed(*more)
        if quick is None or quick["total_s"] > total_s * SLOWER + AWAY:
            self.faults.append(
                f"{self.machine}: {quick and quick['total_s']} s with twice the acceleration, "
                f"{total_s} without"
            )

    def _cut(self, whole, total_s):
        """What is done before a line and what is left there are the whole."""
        line = self.pen.randrange(1, self.lines + 3)
        told = self.call("time", self.file, "-m", self.machine, "--json", "--left", line)
        if told.code == 0:
            left_s = json.loads(told.out)["left_s"]
            before_s = sum(part["time_s"] for part in whole["parts"] if part["line"] < line)
            if abs(before_s + left_s - total_s) > 1e-6 * (1 + total_s):
                self.faults.append(f"line {line}: {before_s} + {left_s} s are not {total_s}")
        later = self.timed("--from-line", line)
        if told.code == 0 and later and later["total_s"] < left_s * (1 - 5e-3) - 0.02:
            self.faults.append(f"from line {line} {later['total_s']} s, and {left_s} are left")

    def verbs(self):
        """Call some verbs with options, good and odd."""
        pen, machine, file = self.pen, self.machine, self.file
        value = pen.choice([*ODD, "1", "100"])
        key = pen.choice(["axis.x.a_max_mm_s2", "axis.x.v_max_mm_s", "control.max_accel",
                          "control.junction_deviation", "control.planner_blocks",
                          "path.chord_error_mm", "control.kind", "work.zero", "spindle.rpm_max",
                          "axis.q.min_mm",
                          "control.minimum_cruise_ratio", "kernel.period_ms"])  # fmt: skip
        png, html = self.folder / "x.png", self.folder / "x.html"
        choices = [
            ("time", file, "-m", machine, "--set", f"{key}={value}"),
            ("time", file, "-m", machine, f"--left={value}"),
            ("time", file, "-m", machine, f"--override={value}"),
            ("time", file, "-m", machine, f"--zero={value},{value}"),
            ("time", file, "-m", machine, "--by", pen.choice(["tool", "section", "line"])),
            ("why", file, "-m", machine),
            ("why", file, "-m", machine, "--what-if"),
            ("why", file, "-m", machine, "--what-if", f"{key}={value}"),
            ("run", file, "-m", machine),
            ("report", file, "-m", machine, "-o", html),
            ("plot", file, "-m", machine, "-o", png),
            ("compare", file, file, "-m", machine),
            ("compare", file, file, "-m", machine, "--set-b", f"{key}={value}"),
            ("sweep", file, "-m", machine, "--set", "control.kind=nck"),
            ("sweep", file, "-m", machine, "--set", f"{key}={value},2"),
            ("machine", "show", machine, "--effective"),
            ("time", self.folder / "none.nc", "-m", machine),
            ("time", file, "-m", self.folder / "none.toml"),
            ("time", file, "-m", file),
            ("machine", "import", file),
            ("time", file, "-m", machine, "--dialect",
             pen.choice(["linuxcnc", "fanuc", "grbl", "marlin", "auto"])),
        ]
        for words in pen.sample(choices, 3):
            self.call(*words)


def faults(seed):
    """Let a stranger try; return (what must not be, number of calls)."""
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        stranger = Stranger(seed, folder)
        if stranger.machine is not None:
            good = stranger.located()
            if good:
                stranger.times()
            stranger.verbs()
        return [f"{stranger.language} on {stranger.machine}: {each}" for each in stranger.faults], \
            stranger.calls


def main():
    """Let so many try."""
    count, seed = int(sys.argv[1]), int(sys.argv[2])
    wrong = calls = 0
    os.environ["NO_COLOR"] = "1"
    for k in range(count):
        found, called = faults(seed + k)
        calls += called
        wrong += bool(found)
        if found:
            print(f"{seed + k}:", *found, sep="\n  ", flush=True)
    print(f"{count} strangers from {seed}, {calls} calls: {wrong} saw what nobody should")
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main())
