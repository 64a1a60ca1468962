# SPDX-License-Identifier: MIT
"""What a served machine keeps: changes in its file, and a record for when the power fails."""

import json
import time
from pathlib import Path

from pycnc import errors, files
from pycnc.machine import Machine, edit, shipped

EVERY_S = 0.5  # of the wall clock, between two looks at what has changed
_VERSION = 1


class Keeper:
    """Looks after a session's settings: tells what was changed, or keeps it.

    Parameters
    ----------
    session : Session
    machine : Machine
    saves : bool
        Changes go into the machine's file, and what a power failure must not lose beside it.

    Attributes
    ----------
    notes : list of str
        What is to be told, in the order in which it came; who tells it takes it away.

    Raises
    ------
    ArgumentError
        ``saves``, and the machine has no file of its own.
    """

    def __init__(self, session, machine, saves):
        self.notes, self._session, self._machine = [], session, machine
        self._path, self._record = Path(machine.file), None
        self._before, self._next, self._saves = session.settings(), 0.0, saves
        if not saves:
            return
        if machine.name in shipped() or not self._path.is_file():
            raise errors.ArgumentError(
                f"--save: {machine.name} is no file of your own; pycnc machine show "
                f"{machine.name} > my.toml makes one, -m my.toml takes it", id="serve-save",
            )  # fmt: skip
        self._place = self._path.with_suffix(".power.json")
        self._remember()

    def look(self, now=None):
        """Keep what has changed, if it is time."""
        now = time.monotonic() if now is None else now
        if self._saves and now >= self._next:
            self._next = now + EVERY_S
            self.keep()

    def keep(self):
        """Keep what has changed."""
        if self._session.rests:
            self._write_changes()
        record = {"version": _VERSION, "machine": self._machine.name, **self._session.record()}
        if record != self._record:
            self._write(self._place, json.dumps(record, indent=1) + "\n")
            self._record = record

    def end(self):
        """The machine is switched off: keep what has changed, or tell that it is forgotten."""
        if self._saves:
            self.keep()
            return
        changed = self._changes()
        for key, value in changed.items():
            self.notes.append(f"forgotten: {key} = {edit.shown(value)}; --save keeps it")

    def _changes(self):
        now = self._session.settings()
        return {
            key: value for key, value in now.items()
            if value != self._before.get(key) and not self._follows(key, now)
        }  # fmt: skip

    def _follows(self, key, settings):
        """Tell whether a rapid speed is the highest speed, as it is where a file has none."""
        most = settings.get(key.replace(".rapid_", ".v_max_"))
        return ".rapid_" in key and key not in self._machine.sources and settings[key] == most

    def _write_changes(self):
        changed = self._changes()
        if not changed:
            return
        self._before = self._session.settings()
        try:
            text = edit.put(files.read(self._path, files.SETTINGS_MOST).decode("utf-8"), changed)
            Machine.from_text(text, name=self._machine.name)
        except (OSError, ValueError, errors.MachineError) as cause:
            self.notes.append(f"{self._path}: not saved: {cause}")
            return
        self._write(self._path, text)
        for key, value in changed.items():
            self.notes.append(f"{self._path}: {key} = {edit.shown(value)}")

    def _write(self, path, text):
        try:
            with files.Part(path) as part:
                part.write(text)
        except OSError as cause:
            self.notes.append(f"{path}: not written: {cause.strerror}")

    def _remember(self):
        """Go on from the record, if there is one."""
        try:
            record = _parsed(files.read(self._place, files.SETTINGS_MOST))
            if (record.get("version"), record.get("machine")) != (_VERSION, self._machine.name):
                raise ValueError("is another machine's")
            words = self._session.restore(record)
        except FileNotFoundError:
            return
        except (OSError, ValueError, errors.NckError) as cause:
            self.notes.append(f"{self._place}: not taken: {cause}; it is written anew")
            return
        self.notes.append(f"{self._place}: {words}")


def _parsed(data):
    """Return the table of a record, or raise ValueError."""
    try:
        record = json.loads(data)
    except RecursionError:
        record = None
    if not isinstance(record, dict):
        raise ValueError("is no table of JSON")
    return record
