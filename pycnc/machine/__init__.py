# SPDX-License-Identifier: MIT
"""The machine: read from a machine file, checked whole, and the same as the kernel has it."""

import difflib
import hashlib
import json
import re
import tomllib
from decimal import Decimal
from importlib import resources
from pathlib import Path

import numpy as np
import pydantic

from pycnc import files
from pycnc.machine import control as controls
from pycnc.machine import contradictions, foreign, schema, source, tool_table
from pycnc.kernel.bind import ffi, lib, pointer
from pycnc.machine.inputs import switches_of
from pycnc.machine.problems import MachineFileError
from pycnc.machine.rows import base_number, rows_of
from pycnc.machine.schema import AXES, MachineFile, position_key, unit_of
from pycnc.names import DEFAULT  # noqa: F401


def shipped():
    """Return the names of the machines that come with pycnc, sorted."""
    folder = resources.files("pycnc") / "machines"
    return sorted(
        item.name.removesuffix(".toml") for item in folder.iterdir() if item.name.endswith(".toml")
    )


class Machine:
    """A checked machine.

    Attributes
    ----------
    name : str
        Name of a shipped machine, or the file's stem.
    file : str
        Where it came from.
    text : str
        The machine file, as it is.
    settings : MachineFile
        Every setting, defaults included (mm, s, degrees as the keys say, exact decimals).
    sources : dict
        Path to key → "file", "--set", "--dialect" or the tool table's name. What is not in it is
        a default.
    changes : tuple of (str, value, str)
        What was changed behind the file: path to key, value, source.
    not_imported : tuple of str
        Of another control's configuration: what has to do with motion, and no equal here.

    Examples
    --------
    >>> machine = Machine.load("mill3", set={"axis.x.max_mm": 500})
    >>> machine.axes
    'xyz'
    """

    def __init__(self, data, *, name="machine", file="<machine>", text="", changes=()):
        self.name, self.file, self.text = name, str(file), text
        self.changes, self.not_imported = tuple(changes), ()
        self.sources = dict.fromkeys(_leaves(data), "file")
        self.sources |= {key: source for key, _, source in changes}
        self.settings, problems = _validate(data)
        if problems:
            own = _validate(_parse(text, file))[1] if changes else ()
            raise MachineFileError(self.file, problems, changes, own)
        self._rows = rows_of(self.settings)
        if lib.nck_machine_check(self.pointer) != lib.NCK_OK:
            problem = ("", "a number is outside of what the kernel can hold")
            raise MachineFileError(self.file, [problem], changes)

    @classmethod
    def load(cls, name, *, set=(), dialect=None, tools=None):
        """Load a machine.

        Parameters
        ----------
        name : str, path or Machine
            Name of a shipped machine, a TOML file, or another control's configuration, which is
            imported.
        set : dict or iterable of str
            Changes: ``{"axis.x.max_mm": 500}`` or ``["axis.x.max_mm=500"]``.
        dialect : str, optional
            Replaces ``dialect.base``.
        tools : path, optional
            A LinuxCNC tool table, added to the file's tools.

        Raises
        ------
        MachineFileError
            With every problem of the file.
        """
        if isinstance(name, cls):
            if not (set or dialect or tools):
                return name
            stem, file, text, told = name.name, name.file, name.text, name.not_imported
        else:
            stem, file, text, told = _read(name)
        data = _parse(text, file)
        noses = _noses_of(data)
        said = [*(_changes_of(name) if isinstance(name, cls) else ()), *_changes(set, dialect)]
        _apply_changes(data, said)
        base = _base_of(data)
        if isinstance(name, cls):
            said = _turned(said, name.settings.dialect.base, base)
        changes = [*said, *(_turned(_tools_of(tools), "linuxcnc", base) if tools else ())]
        _apply_changes(data, [*_turned(noses, _base_of(_parse(text, file)), base), *changes])
        machine = cls(data, name=stem, file=file, text=text, changes=changes)
        machine.not_imported = told
        return machine

    @classmethod
    def from_text(cls, text, name="machine"):
        """Make a machine from the text of a machine file."""
        return cls(_parse(text, f"<{name}>"), name=name, file=f"<{name}>", text=text)

    @property
    def axes(self):
        """Letters of the axes, lower case, in the kernel's order."""
        return "".join(self.settings.axis.present())

    @property
    def period_s(self):
        """Interpolation period [s]."""
        return float(self._rows[0]["period_s"])

    @property
    def record(self):
        """The kernel's machine, a copy: one item of dtype ``nck_machine_t``."""
        return self._rows.copy()[0]

    @property
    def pointer(self):
        """``nck_machine_t *`` for calls into the kernel; it lives as long as the machine."""
        return pointer("nck_machine_t", self._rows)

    @property
    def switches(self):
        """Members of ``inputs_set_t`` and ``host_switches_t``, and what is pushed; None: none."""
        return switches_of(self.settings)

    @property
    def sha256(self):
        """Hash of all settings: equal machines have equal ones, however their files are written."""
        settings = self.settings.model_dump(exclude={"description"})
        text = json.dumps(settings, sort_keys=True, default=lambda number: f"{number.normalize()}")
        return hashlib.sha256(text.encode()).hexdigest()

    def limits(self, kind):
        """Return every axis' limit.

        Parameters
        ----------
        kind : {"v_max", "a_max", "j_max"}

        Returns
        -------
        numpy.ndarray
            One float64 an axis, in the order of `axes` [mm/s, mm/s², mm/s³ or degrees].
        """
        axis = self._rows[0]["axis"]
        return np.array([axis[kind][AXES.index(letter)] for letter in self.axes])

    @property
    def limits_path(self):
        """Whether the path has limits of its own, before those of its axes (5_slope/terms.c)."""
        path = self._rows[0]["path"]
        kinds = ("a_max", "j_max")
        return any(path[kind] < (1 - 1e-9) * np.linalg.norm(self.limits(kind)) for kind in kinds)

    def effective(self):
        """Yield (path to key, value, source) for every setting, in the order of the description.

        Positions along axes that the machine does not have, and other controls' settings, are left
        out.
        """
        kind = self.settings.control.kind
        absent = {position_key(letter) for letter in AXES if letter not in self.axes}
        for key, value in _walk(self.settings):
            folder, _, leaf = key.rpartition(".")
            if controls.is_idle(kind, key):
                continue
            if leaf not in absent or folder.startswith("tool."):
                yield key, value, self.sources.get(key, "default")

    def __repr__(self):
        return f"<Machine {self.name}: {self.axes.upper()}, {self.period_s * 1e3:g} ms>"


def _read(name):
    """Return (name, file, text, what an import left) of a shipped machine or of a file."""
    if str(name) in shipped():
        file = resources.files("pycnc") / "machines" / f"{name}.toml"
        return str(name), str(file), file.read_text(encoding="utf-8"), ()
    path = Path(name)
    try:
        data = files.read(path, files.SETTINGS_MOST)
        text = source.decode(data)
        if foreign.kind_of(text) and not _is_machine_file(text):
            return path.stem, str(name), *_as_it_is(text, path)
        return path.stem, str(name), data.decode("utf-8"), ()
    except UnicodeDecodeError:
        raise MachineFileError(str(name), [("", "is no text in UTF-8")]) from None
    except (OSError, ValueError) as cause:
        names = ", ".join(shipped())
        reason = getattr(cause, "strerror", None) or str(cause)
        raise MachineFileError(str(name), [("", f"{reason}; shipped machines: {names}")]) from None


def imported(text, file, folder=None, units=None, deviation=None):
    """Return (draft, text) of the machine file that another control's configuration comes to.

    Parameters
    ----------
    file : str
        Its path; the rest as of `importer.read`.

    Raises
    ------
    MachineFileError
        If it comes to none, with the lines that are to blame.
    """
    from pycnc.machine import importer

    name = Path(file).name
    draft = importer.read(text, name, folder, units, deviation)
    if draft.problems:
        raise MachineFileError(file, draft.problems)
    made = draft.text([f"Imported from {name}. Check every line: a file cannot tell all of it."])
    try:
        Machine.from_text(made, name=file)
    except MachineFileError as cause:
        raise MachineFileError(file, draft.sourced(cause.problems)) from None
    return draft, made


def _as_it_is(text, path):
    """Return (text of the machine file, what is told) of a configuration in its place."""
    try:
        draft, made = imported(text, str(path), path.parent)
    except MachineFileError as cause:
        command = f"pycnc machine import {path} -o my.toml takes them; then -m my.toml"
        options = [("", f"options such as --units: {command}")] if "--" in str(cause) else []
        raise MachineFileError(str(path), [*cause.problems, *options]) from None
    return made, tuple(draft.left)


_TOML_ERRORS = (tomllib.TOMLDecodeError, ArithmeticError, RecursionError)


def _is_machine_file(text):
    try:
        data = tomllib.loads(text, parse_float=Decimal)
    except _TOML_ERRORS:
        return False
    return not MachineFile.model_fields.keys().isdisjoint(data)


def _parse(text, file):
    try:
        return tomllib.loads(text, parse_float=Decimal)
    except _TOML_ERRORS as cause:
        raise MachineFileError(file, [("", f"is not valid TOML: {cause}")]) from None


def _leaves(data, prefix=""):
    """Yield the path to every value."""
    for key, value in data.items():
        if isinstance(value, dict):
            yield from _leaves(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}"


def _changes(changes, dialect):
    """Yield (path to key, value, source)."""
    pairs = changes.items() if isinstance(changes, dict) else (_split(change) for change in changes)
    for key, value in pairs:
        yield key, value, "--set"
    if dialect is not None:
        yield "dialect.base", dialect, "--dialect"


def _split(change):
    key, equals, value = change.partition("=")
    if not equals or not key.strip():
        raise MachineFileError("--set", [(change, "must look like axis.x.max_mm=500")])
    try:
        value = tomllib.loads(f"value = {value}", parse_float=Decimal)["value"]
    except (tomllib.TOMLDecodeError, ArithmeticError, RecursionError):
        value = value.strip()  # a bare word: slope=linear
    return key.strip(), value


def _apply_changes(data, changes):
    for key, value, source in changes:
        table, (*folders, leaf) = data, key.split(".")
        for folder in folders:
            table = table.setdefault(folder, {})
            if not isinstance(table, dict):
                raise MachineFileError(source, [(key, f"{folder} is a value, not a table")])
        table[leaf] = value


def _changes_of(machine):
    """Yield the changes that had been made to a machine after its file was read."""
    for key, value, source in machine.effective():
        if source not in ("file", "default"):
            yield key, "free" if value is None else value, source


def _base_of(data):
    """Return ``dialect.base`` of a machine file that nobody has checked."""
    dialect = data.get("dialect")
    base = dialect.get("base") if isinstance(dialect, dict) else None
    return base or MachineFile.model_fields["dialect"].default.base


def _noses_of(data):
    """Return where the tips of a file's tools point, as changes."""
    tools = data.get("tool")
    tools = tools.items() if isinstance(tools, dict) else ()
    return [
        (f"tool.{number}.orientation", tool["orientation"], "file")
        for number, tool in tools
        if isinstance(tool, dict) and isinstance(tool.get("orientation"), int)
    ]


def _turned(changes, before, after):
    """Return changes, the noses of files and tool tables as the base in force numbers them."""
    if (before == "fanuc") == (after == "fanuc"):
        return list(changes)
    return [
        (key, tool_table.TURNED.get(value, value), source)
        if key.endswith(".orientation") and source not in ("--set", "--dialect")
        else (key, value, source)
        for key, value, source in changes
    ]


def _tools_of(file):
    """Yield the tools of a table as changes."""
    try:
        text = files.read(file, files.SETTINGS_MOST).decode("utf-8", errors="replace")
    except (OSError, ValueError) as cause:
        raise MachineFileError(
            str(file), [("", getattr(cause, "strerror", None) or str(cause))]
        ) from None
    tools, problems = tool_table.read(text)
    if problems:
        raise MachineFileError(str(file), problems)
    for number, tool in tools.items():
        for key, value in tool.items():
            yield f"tool.{number}.{key}", value, str(file)


def _validate(data):
    """Return (settings, problems) of a machine file."""
    try:
        settings = MachineFile.model_validate(data)
    except pydantic.ValidationError as cause:
        return None, [_problem(error, data) for error in cause.errors()]
    _leave_tools_to_grblhal(settings)
    problems = list(contradictions.of(settings))
    window, tools = lib.NCK_WINDOW, lib.NCK_TOOL_MAX
    if settings.path.lookahead_blocks > window:
        problems.append(
            (
                "path.lookahead_blocks",
                f"must be {window} at most (is {settings.path.lookahead_blocks})",
            )
        )
    problems += [
        (f"m.{number}", f"{lib.NCK_M_MAX} at most, and no code that the kernel executes itself")
        for number in settings.m
        if number.isdecimal() and not _is_free(int(number), settings)
    ]
    if len(settings.m) > lib.NCK_OWN_M_MAX:
        problems.append(("m", f"{lib.NCK_OWN_M_MAX} codes at most (the table has more)"))
    if len(settings.tool) > tools:
        problems.append(("tool", f"{tools} tools at most (the table has {len(settings.tool)})"))
    return settings, problems


def _leave_tools_to_grblhal(settings):
    """Forget that an operator changes tools, as grbl's files say: grblHAL does it itself."""
    own = settings.m.get("6")
    if settings.control.kind == "grblhal" and own is not None and own.action == "wait":
        del settings.m["6"]


_FREE = (lib.NCK_E_M_UNKNOWN, lib.NCK_E_UNSUPPORTED, lib.NCK_E_OTHER_BASE)


def _is_free(code, settings):
    """Tell whether an M code is within range and none that the kernel executes in a language."""
    machine, decode = ffi.new("nck_machine_t *"), ffi.new("nck_decode_t *")
    lib.nck_machine_default(machine)
    machine.dialect.base = base_number(settings)
    lib.nck_decode_init(decode, machine)
    line = f"M{code}\n".encode()
    lib.nck_decode_push(decode, line, len(line), ffi.new("size_t *"))
    status = lib.nck_decode_pull(decode, ffi.new("nck_block_t *"))
    return code <= lib.NCK_M_MAX and status in _FREE


def _plain(number):
    """Return a number without an exponent."""
    return f"{Decimal(number):f}"


def _problem(error, data):
    """Return (path to key, wording) of one finding of pydantic."""
    path = [str(step) for step in error["loc"]]
    context, given = error.get("ctx", {}), error["input"]
    wording = {
        "missing": lambda: "is missing",
        "extra_forbidden": lambda: _unknown(path),
        "greater_than_equal": lambda: f"must be {_plain(context['ge'])} at least (is {given})",
        "less_than_equal": lambda: f"must be {_plain(context['le'])} at most (is {given})",
        "finite_number": lambda: f"must be a finite number (is {given})",
        "literal_error": lambda: f"must be {context['expected']} (is {given!r}){_moved(given)}",
        "bool_type": lambda: f"must be true or false (is {given!r})",
        "int_type": lambda: f"must be a whole number (is {given})",
        "value_error": lambda: (
            f"{context['error']}{'' if isinstance(given, dict) else f' (is {given!r})'}"
        ),
        "model_type": lambda: "must be a table",
        "dict_type": lambda: "must be a table",
    }
    words = wording.get(
        error["type"], lambda: error["msg"].removeprefix("Input ").replace("should", "must")
    )
    return ".".join(path), words()


def _moved(given):
    """Say where a value that was one has gone."""
    sshape = ": the S-shape is a kind of planning, pycnc lab time --plan sshape"
    return sshape if given == "sshape" else ""


def _unknown(path):
    """Say which keys a table has, the nearest first if one is near."""
    table = MachineFile
    for step in path[:-1]:
        table = _table_of(table, step)
    allowed = {_bare(key): key for key in table.model_fields}
    near = difflib.get_close_matches(_bare(path[-1]), allowed, n=1, cutoff=0.7)
    if near:
        return f"unknown key; did you mean {allowed[near[0]]}?"
    return f"unknown key; allowed: {', '.join(allowed.values())}"


def _bare(key):
    """Return a key without its unit and its underscores: amax is a_max_mm_s2."""
    return re.sub(r"_(mm|deg|ms)(_.*)?$", "", key).replace("_", "").lower()


def _table_of(table, step):
    """Return the class of a table inside a table, or inside a table of numbered tables."""
    if step not in table.model_fields:  # a number
        return table
    kind = table.model_fields[step].annotation
    options = getattr(kind, "__args__", (kind,))
    tables = (
        option
        for option in options
        if isinstance(option, type) and issubclass(option, schema.Table)
    )
    return next(tables, table)


def _walk(table, prefix=""):
    """Yield (path to key, value) of every setting."""
    items = (
        table.items()
        if isinstance(table, dict)
        else ((name, getattr(table, name)) for name in type(table).model_fields)
    )
    for name, value in items:
        if isinstance(value, schema.Table | dict):
            yield from _walk(value, f"{prefix}{name}.")
        elif prefix not in ("axis.", "inputs.") or name not in AXES:
            yield f"{prefix}{name}", value
