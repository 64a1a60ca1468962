# SPDX-License-Identifier: MIT
"""How long a test may take: one that loops for ever fails, and the run goes on.

Counted is the processor time of the test's process and of all that it has started, so that a busy
computer ends nothing; of the time that passes while they wait, a quarter. What a test has started
is killed first, and mostly the test then fails by itself. Where the test itself loops, in C too,
its process ends with the places where it was; xdist says which test that was, starts another
process and lets it go on behind that test. What is built once for several tests (locks.py) is not
counted.
"""

import faulthandler
import os
import signal
import sys
import threading
import time
from contextlib import contextmanager, nullcontext, suppress
from pathlib import Path

import pytest
from xdist.scheduler.loadfile import LoadFileScheduling

FOLDER = Path(__file__).resolve().parents[1] / "build" / "limits"
# By draw. A quick run's tests take less than 5 s each; the suite's longest is a minute.
LIMIT_S = {"quick": 15.0, "suite": 900.0}
WAITING = 0.25  # of the time that passes counts where nothing is computed
PERIOD_S = 0.5  # between two looks
# Times the limit, and no other thread of Python has got a turn: a loop in C that lets none.
DEAF = 5
GRACE_S = 2.0  # for a test to end when all that it has started is killed
TICKS_PER_S = os.sysconf("SC_CLK_TCK")


def started_by(pid):
    """Return the numbers of all processes that one has started, and those in turn."""
    try:
        threads = os.listdir(f"/proc/{pid}/task")
    except OSError:  # the process has ended meanwhile
        return []
    found = []
    for thread in threads:
        try:
            text = Path(f"/proc/{pid}/task/{thread}/children").read_text()
        except OSError:  # the thread has
            continue
        for child in map(int, text.split()):
            found += [child, *started_by(child)]
    return found


def _used_s(pid):
    """Return the processor time of a process and of those that it has waited for."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return 0.0
    return sum(int(field) for field in fields[11:15]) / TICKS_PER_S


class Watch:
    """A plugin that looks at the running test from a thread of its own."""

    def __init__(self, limit_s, run):
        FOLDER.mkdir(parents=True, exist_ok=True)
        self.limit_s = limit_s
        self._run = run
        self._note = FOLDER / f"{run}-{os.getpid()}"  # the test that this process is at
        self._began = None  # (time, processor time); None: nothing is watched
        self._killed_at = None  # time at which what the test has started was killed
        threading.Thread(target=self._look_on, daemon=True).start()

    @contextmanager
    def untimed(self):
        """Count nothing within, and what comes behind from nothing."""
        is_timed = self._began is not None
        self._end()
        try:
            yield
        finally:
            if is_timed:
                self._begin()

    def _begin(self):
        self._began = self._now()

    def _end(self):
        self._began = None

    @staticmethod
    def _now():
        pids = (os.getpid(), *started_by(os.getpid()))
        return time.monotonic(), sum(_used_s(pid) for pid in pids)

    def _is_over(self, began):
        now = self._now()
        return max(now[1] - began[1], WAITING * (now[0] - began[0])) > self.limit_s

    def _look_on(self):
        while True:
            # Put off as often as this thread gets a turn: no test has to, which would take 0.5 ms.
            faulthandler.dump_traceback_later(DEAF * self.limit_s, exit=True, file=sys.__stderr__)
            time.sleep(PERIOD_S)
            began = self._began
            if began is None or not self._is_over(began) or began is not self._began:
                continue
            for pid in reversed(started_by(os.getpid())):
                with suppress(ProcessLookupError):  # it has ended meanwhile
                    os.kill(pid, signal.SIGKILL)
            if self._killed_at is None:
                self._killed_at = time.monotonic()
            elif time.monotonic() > self._killed_at + GRACE_S:
                os.abort()  # pytest lets faulthandler say where that was

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item):
        """Watch a test, and what is set up for it."""
        self._killed_at = None
        self._note.write_text(item.nodeid, encoding="utf-8")
        self._begin()
        try:
            return (yield)
        finally:
            self._end()
            self._note.unlink(missing_ok=True)

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtest_setup(self, item):
        """Pass by a test that has ended a process of this run: xdist gives it to the next one."""
        for note in FOLDER.glob(f"{self._run}-*"):
            with suppress(FileNotFoundError):  # its process goes on
                if note != self._note and note.read_text(encoding="utf-8") == item.nodeid:
                    pytest.skip("it has ended a process already")

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(self):
        """Let a test fail whose processes were killed, and say why."""
        report = yield
        if self._killed_at is not None:
            report.outcome = "failed"
            said = f"longer than {self.limit_s:.0f} s: what it had started was killed"
            report.longrepr = f"{report.longrepr or ''}\n{said}"
            self._killed_at = None
        return report


class Scheduler(LoadFileScheduling):
    """Whole files to each process, as xdist gives them, and those left of one that has ended.

    xdist gives out all that the process ever had. Who gets a file with nothing left to run has
    nothing to answer, so gets no other one: in the end all would wait.
    """

    def remove_node(self, node):
        """Take back what a process had; return the test at which it ended, if at one."""
        files = self.assigned_work[node]
        for name in [name for name, tests in files.items() if all(tests.values())]:
            del files[name]
        return super().remove_node(node)


_watch = None


def pytest_configure(config):
    """Watch the tests in every process that runs some, but for the campaign's."""
    global _watch
    limit_s = LIMIT_S.get(config.option.draw)
    runs_tests = hasattr(config, "workerinput") or not config.getoption("numprocesses", None)
    if limit_s and runs_tests:
        run = getattr(config, "workerinput", {}).get("testrunuid", f"{os.getpid()}")
        _watch = Watch(limit_s, run)
        config.pluginmanager.register(_watch)


def untimed():
    """Return a context for what is built once, by whichever test needs it first."""
    return _watch.untimed() if _watch else nullcontext()
