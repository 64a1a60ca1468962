# SPDX-License-Identifier: MIT
"""Many plans: a grid over settings and programs, side by side in processes or on a cluster.

    grid ─▶ tasks (program, changes) ─▶ workers ─▶ rows, in the order of the tasks
                                     └▶ parts of huge programs ─▶ workers ─▶ sums ┘

A row depends on its task alone, and where a program is cut on that program, so however many workers
there are, the bits are the same.
"""

import csv
import itertools
import math
from collections import deque
from decimal import Decimal, InvalidOperation
from typing import NamedTuple

from pycnc import errors
from pycnc.files import read
from pycnc.machine import Machine
from pycnc.planning import measure, parts, workers
from pycnc.planning.plan import Plan
from pycnc.program import Program, shown

GRID_MOST = 10_000  # plans of a sweep
_RATIO = 10  # from such a range on, values go up by equal ratios
_DIGITS = 6  # of a value between two ends
_TIMES = ("total_s", "time_s", "cut_s", "rapid_s", "dwell_s")


class Task(NamedTuple):
    """One plan: a program by its name, and KEY → VALUE of what is changed in the machine."""

    file: str
    changes: tuple


def values_of(text):
    """Return the values that a part of a grid asks for.

    Parameters
    ----------
    text : str
        ``1e4..1e6/9``: nine values from the first to the last, in equal steps, or from a tenfold
        range on by equal ratios; ``a,b,c``: these; anything else is one value.

    Raises
    ------
    ArgumentError
        If a range has no two ends and a count of 2 at least.

    Examples
    --------
    >>> values_of("1..5/3"), values_of("1e4..1e6/3"), values_of("jerk,linear")
    (['1', '3', '5'], ['10000', '100000', '1000000'], ['jerk', 'linear'])
    """
    if ".." not in text:
        return [value.strip() for value in text.split(",")]
    ends, _, count = text.partition("/")
    try:
        low, high = (Decimal(end) for end in ends.split(".."))
        steps = int(count) - 1
        good = steps >= 1 and low.is_finite() and high.is_finite()
    except (InvalidOperation, ValueError):
        good = False
    if not good:
        raise errors.ArgumentError(
            f"no range {text!r}; a range is FIRST..LAST/COUNT, COUNT 2 or more: 1e4..1e6/9",
            id="grid",
        )
    if steps >= GRID_MOST:
        raise errors.ArgumentError(f"{text!r} has more than {GRID_MOST:,} values", id="grid")
    by_ratio = min(low, high) > 0 and max(low, high) >= _RATIO * min(low, high)
    between = (_between(low, high, k / steps, by_ratio) for k in range(1, steps))
    return [_plain(low), *between, _plain(high)]


def _between(low, high, share, by_ratio):
    if by_ratio:
        value = math.exp(math.log(low) + share * (math.log(high) - math.log(low)))
    else:
        value = float(low) + share * float(high - low)
    return _plain(Decimal(f"{value:.{_DIGITS}g}"))


def _plain(number):
    text = f"{number:f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def grid(settings):
    """Return key → values of a grid.

    Parameters
    ----------
    settings : iterable of str
        ``KEY=VALUES``, as `values_of` takes them.
    """
    found = {}
    for setting in settings:
        key, is_one, text = setting.partition("=")
        if not is_one:
            raise errors.ArgumentError(f"{setting!r} is no KEY=VALUES", id="grid")
        found[key] = values_of(text)
    return found


def tasks_of(files, axes):
    """Return the tasks of a grid, the last setting changing first.

    Raises
    ------
    ArgumentError
        If there are more than `GRID_MOST`: they are counted, not made.
    """
    count = len(files) * math.prod(map(len, axes.values()))
    if count > GRID_MOST:
        sizes = " x ".join(str(len(values)) for values in axes.values())
        programs = "1 program" if len(files) == 1 else f"{len(files)} programs"
        raise errors.ArgumentError(
            f"the grid has {count:,} plans ({programs} x {sizes}); at most "
            f"{GRID_MOST:,}: ask for fewer values", id="grid",
        )  # fmt: skip
    points = [tuple(zip(axes, point, strict=True)) for point in itertools.product(*axes.values())]
    return [Task(file, point) for file in files for point in points]


def _changed(machine, changes):
    return Machine.load(machine, set=[f"{key}={value}" for key, value in changes])


class Unit(NamedTuple):
    """What a worker does at once: look at a task, or plan a part of its program."""

    number: int  # of the task
    task: Task
    place: int = 0  # of the part in the program
    part: tuple | None = None


def evaluate(unit, machine, texts):
    """Return the row of a task: times in s, or what is wrong.

    Of a huge program its parts, a list; of a part its sums.
    """
    task = unit.task
    try:
        changed = _changed(machine, task.changes)
        if unit.part is not None:
            return parts.totals_of(unit.part, texts[task.file], changed)
        program = Program(texts[task.file], changed, file=task.file, keep=False).check()
        found = list(parts.of(program) or ())
        if len(found) > 1:
            return found
        return _row(task, Plan(program, keep=False).totals)
    except errors.NckError as cause:
        return _row(task, error=str(cause).splitlines()[0])


def _row(task, totals=None, error=None):
    times = {name: totals[name] for name in _TIMES} if totals else dict.fromkeys(_TIMES)
    return {"file": task.file, **dict(task.changes)} | times | {"error": error}


class _Board:
    """Which units are to be done, and what is known of huge programs."""

    def __init__(self, tasks, machine):
        self._machine = machine
        self._units = deque(Unit(number, task) for number, task in enumerate(tasks))
        self._sums = {}  # number of a task → results of its parts, None: not there yet

    def take(self):
        """Return the next unit, None if there is none."""
        return self._units.popleft() if self._units else None

    def put(self, unit, result):
        """Take a result. Returns the row of its task if that is complete, else None."""
        task = unit.task
        if isinstance(result, workers.Lost):
            result = _row(task, error=str(result))
        if isinstance(result, list):
            self._sums[unit.number] = [None] * len(result)
            made = [Unit(unit.number, task, place, part) for place, part in enumerate(result)]
            self._units.extendleft(reversed(made))
            return None
        if unit.part is None:
            return result
        sums = self._sums[unit.number]
        sums[unit.place] = result
        if any(one is None for one in sums):
            return None
        del self._sums[unit.number]
        wrong = [one for one in sums if isinstance(one, dict)]
        return wrong[0] if wrong else _row(task, self._totals(task, sums))

    def _totals(self, task, sums):
        changed = _changed(self._machine, task.changes)
        return measure.plan_times(parts.add(sums, changed), changed)


class Sweep(shown.Tables):
    """The rows of a grid.

    Attributes
    ----------
    machine : Machine
    axes : dict
        Setting → values.
    rows : list of dict
        ``file``, the settings, times in s as ``pycnc time --json`` has them, and ``error``: None,
        or what is wrong with that plan, whose times are None then.
    """

    def __init__(self, texts, axes, machine, jobs=1, cluster=None, progress=None):
        self.machine, self.axes = machine, axes
        tasks = tasks_of(list(texts), axes)
        for key, values in axes.items():
            for value in values:
                _changed(machine, [(key, value)])
        board, done = _Board(tasks, machine), 0
        self.rows = [None] * len(tasks)
        found = workers.each(board.take, evaluate, (machine, texts), jobs, cluster)
        for unit, result in found:
            row = board.put(unit, result)
            if row is None:
                continue
            self.rows[unit.number] = row
            done += 1
            if progress:
                progress(done, len(tasks))

    @property
    def columns(self):
        """Names of what a row has."""
        return ["file", *self.axes, *_TIMES, "error"]

    def _table(self, kind):
        columns = {name: [row[name] for row in self.rows] for name in self.columns}
        return shown.frame(columns, kind=kind)

    def write_csv(self, file):
        """Write the rows as CSV into an open text file, a line of names first."""
        table = csv.DictWriter(file, self.columns)
        table.writeheader()
        table.writerows(self.rows)

    def _repr_html_(self):
        return shown.rows_table(self.columns, [[row[name] for name in self.columns]
                                               for row in self.rows])  # fmt: skip

    def __repr__(self):
        return f"<Sweep on {self.machine.name}: {len(self.rows):,} plans over {len(self.axes)}>"


def sweep(files, settings, machine="mill3", *, jobs=1, cluster=None):
    """Plan programs on a grid of settings.

    Parameters
    ----------
    files : iterable of path
    settings : dict or iterable of str
        Key → values, or ``KEY=VALUES`` as on the command line (`values_of`).
    machine : str, path or Machine
    jobs : int
        Processes side by side.
    cluster : str, optional
        Address of a scheduler of dask.distributed instead (needs distributed). It is trusted:
        whoever can reach it can run code on its workers and here, for work travels by pickle.

    Returns
    -------
    Sweep

    Raises
    ------
    ArgumentError
        If the grid is no grid, or too large.
    MachineFileError
        If the machine has no such setting, or not with such a value.
    OSError
        If a file cannot be read.

    Examples
    --------
    >>> found = sweep(["part.ngc"], {"path.slope": ["jerk", "linear"]})
    >>> [row["time_s"] for row in found.rows][0] > 0
    True
    """
    texts = {}
    for file in files:
        texts[str(file)] = read(file)
    if isinstance(settings, dict):
        axes = {key: [str(value) for value in values] for key, values in settings.items()}
    else:
        axes = grid(settings)
    return Sweep(texts, axes, Machine.load(machine), jobs, cluster)
