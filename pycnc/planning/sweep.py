# SPDX-License-Identifier: MIT
"""Many plans: a grid over settings and programs, side by side in processes or on a cluster.

    grid ─▶ tasks (program, changes) ─▶ workers ─▶ rows, in the order of the tasks

A row depends on its task alone, so however many workers there are, the bits are the same.
"""

import csv
import itertools
import math
import multiprocessing
import signal
from collections import deque
from decimal import Decimal, InvalidOperation
from multiprocessing.connection import wait
from typing import NamedTuple

from pycnc import errors
from pycnc.extras import need
from pycnc.machine import Machine
from pycnc.planning.plan import Plan
from pycnc.program import Program, shown

GRID_MOST = 10_000  # plans of a sweep
TRIES = 3  # of a task whose workers die
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
        raise errors.ArgumentError(
            f"the grid has {count:,} plans ({len(files)} programs x {sizes}); at most "
            f"{GRID_MOST:,}: ask for fewer values", id="grid",
        )  # fmt: skip
    points = [tuple(zip(axes, point, strict=True)) for point in itertools.product(*axes.values())]
    return [Task(file, point) for file in files for point in points]


def _changed(machine, changes):
    return Machine.load(machine, set=[f"{key}={value}" for key, value in changes])


def evaluate(task, machine, texts):
    """Return the row of a task: times in s, or what is wrong."""
    row = {"file": task.file, **dict(task.changes)}
    try:
        changed = _changed(machine, task.changes)
        plan = Plan(Program(texts[task.file], changed, file=task.file, keep=False), keep=False)
    except errors.NckError as cause:
        return row | dict.fromkeys(_TIMES) | {"error": str(cause).splitlines()[0]}
    return row | {name: plan.totals[name] for name in _TIMES} | {"error": None}


def _lost(task, tries, how):
    row = {"file": task.file, **dict(task.changes)} | dict.fromkeys(_TIMES)
    return row | {"error": f"{tries} workers died at it, the last one {how}"}


# Workers on this computer


def _serve(pipe, machine, texts):
    """Be a worker: an interrupt is for who has asked, who then ends this."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    while (task := pipe.recv()) is not None:
        pipe.send(evaluate(task, machine, texts))


class _Worker:
    def __init__(self, machine, texts):
        context = multiprocessing.get_context("spawn")
        self.pipe, there = context.Pipe()
        self.process = context.Process(target=_serve, args=(there, machine, texts), daemon=True)
        self.process.start()
        there.close()
        self.number = None  # of the task in work

    def give(self, number, task):
        self.number = number
        self.pipe.send(task)

    def end(self):
        self.process.terminate()
        self.process.join()
        self.pipe.close()


def _in_processes(tasks, machine, texts, jobs):
    """Yield (number, row) as they come; a task whose worker dies is given to another."""
    left, tries = deque(range(len(tasks))), [0] * len(tasks)
    workers = [_Worker(machine, texts) for _ in range(min(jobs, len(tasks)))]
    try:
        for worker in workers:
            worker.give(left[0], tasks[left.popleft()])
        while busy := [worker for worker in workers if worker.number is not None]:
            ready = wait([worker.pipe for worker in busy])
            for worker in [worker for worker in busy if worker.pipe in ready]:
                number, worker.number = worker.number, None
                try:
                    yield number, worker.pipe.recv()
                except (EOFError, ConnectionResetError):
                    worker.process.join()
                    tries[number] += 1
                    if tries[number] < TRIES:
                        left.appendleft(number)
                    else:
                        how = f"with exit code {worker.process.exitcode}"
                        yield number, _lost(tasks[number], TRIES, how)
                    worker.pipe.close()
                    workers[workers.index(worker)] = worker = _Worker(machine, texts)
                if left:
                    worker.give(left[0], tasks[left.popleft()])
    finally:
        for worker in workers:
            worker.end()


# Workers of a cluster


def _on_cluster(tasks, machine, texts, address):
    """Yield (number, row) as they come from a cluster of dask.distributed."""
    distributed = need("distributed")
    try:
        client = distributed.Client(address, timeout=10)
    except (OSError, ValueError) as cause:
        raise errors.ArgumentError(f"no cluster at {address!r}: {cause}", id="cluster") from None
    with client:
        shared = client.scatter(texts, broadcast=True)
        numbers = {}
        for number, task in enumerate(tasks):
            future = client.submit(evaluate, task, machine, shared, retries=TRIES - 1, pure=False)
            numbers[future] = number
        for future in distributed.as_completed(numbers):
            try:
                yield numbers[future], future.result()
            except distributed.KilledWorker as cause:
                how = f"was {cause.last_worker}"
                yield numbers[future], _lost(tasks[numbers[future]], TRIES, how)


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
        if cluster is not None:
            found = _on_cluster(tasks, machine, texts, cluster)
        elif jobs == 1:
            found = ((k, evaluate(task, machine, texts)) for k, task in enumerate(tasks))
        else:
            found = _in_processes(tasks, machine, texts, jobs)
        self.rows = [None] * len(tasks)
        for done, (number, row) in enumerate(found, 1):
            self.rows[number] = row
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
        Address of a scheduler of dask.distributed instead (needs distributed).

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
        with open(file, "rb") as data:
            texts[str(file)] = data.read()
    if isinstance(settings, dict):
        axes = {key: [str(value) for value in values] for key, values in settings.items()}
    else:
        axes = grid(settings)
    return Sweep(texts, axes, Machine.load(machine), jobs, cluster)
