# SPDX-License-Identifier: MIT
"""Work side by side: in this process, in processes of this computer, or on a cluster.

    take() ─▶ a unit of work ─▶ work(unit, *shared) in a worker ─▶ (unit, result), as they come

What is done with a result may make new units: `take` is asked again behind each of them. A unit
whose worker dies is given to another one, `TRIES` times in all; then its result is a `Lost`.
"""

import contextlib
import multiprocessing
import signal
from collections import Counter
from multiprocessing import resource_tracker
from multiprocessing.connection import wait
from typing import NamedTuple

from pycnc import errors
from pycnc.extras import need

TRIES = 3


class Lost(NamedTuple):
    """What became of a unit whose workers died."""

    how: str

    def __str__(self):
        return f"{TRIES} workers died at it, the last one {self.how}"


def each(take, work, shared, jobs=1, cluster=None):
    """Yield (unit, result) of all units, in the order in which they are done.

    Parameters
    ----------
    take : callable
        Returns the next unit, None if there is none now.
    work : callable
        A function of a module: ``work(unit, *shared)``.
    shared : tuple
        What every worker is given once.
    jobs : int
        Processes; with 1 all is done in this one.
    cluster : str, optional
        Address of a scheduler of dask.distributed instead.

    Raises
    ------
    ArgumentError
        If there is no such cluster.
    """
    if cluster is not None:
        yield from _on_cluster(take, work, shared, cluster)
    elif jobs > 1:
        yield from _in_processes(take, work, shared, jobs)
    else:
        while (unit := take()) is not None:
            yield unit, work(unit, *shared)


@contextlib.contextmanager
def _deaf():
    """Processes that are started here hear no interrupt: it is for who has asked, who ends them."""
    resource_tracker.ensure_running()  # its start, in here, would unblock the signal
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _serve(pipe, work, shared):
    while (unit := pipe.recv()) is not None:
        pipe.send(work(unit, *shared))


class _Worker:
    def __init__(self, work, shared):
        context = multiprocessing.get_context("spawn")
        self.pipe, there = context.Pipe()
        self.process = context.Process(target=_serve, args=(there, work, shared), daemon=True)
        with _deaf():
            self.process.start()
        there.close()
        self.unit = None  # in work

    def give(self, unit):
        self.unit = unit
        self.pipe.send(unit)

    def result(self):
        """Return (unit, result) of a worker that is done; of one who died the result is a Lost."""
        unit, self.unit = self.unit, None
        try:
            return unit, self.pipe.recv()
        except (EOFError, ConnectionResetError):
            self.process.join()
            self.pipe.close()
            return unit, Lost(f"with exit code {self.process.exitcode}")

    def end(self):
        self.process.terminate()
        self.process.join()
        self.pipe.close()


def _hand_out(workers, take, hire, jobs):
    """Give every idle worker a unit while there is one; hire up to as many as `jobs`."""
    idle = [worker for worker in workers if worker.unit is None]
    while (idle or len(workers) < jobs) and (unit := take()) is not None:
        if not idle:
            idle = [hire()]
            workers += idle
        idle.pop().give(unit)


def _in_processes(take, work, shared, jobs):
    again, tries = [], Counter()  # units of dead workers; how often each was tried, by its id
    workers = []
    try:
        while True:
            _hand_out(workers, lambda: again.pop() if again else take(),
                      lambda: _Worker(work, shared), jobs)  # fmt: skip
            busy = {worker.pipe: worker for worker in workers if worker.unit is not None}
            if not busy:
                return
            for pipe in wait(list(busy)):
                unit, result = busy[pipe].result()
                if isinstance(result, Lost):
                    workers.remove(busy[pipe])
                    tries[id(unit)] += 1
                    if tries[id(unit)] < TRIES:
                        again.append(unit)
                        continue
                yield unit, result
    finally:
        for worker in workers:
            worker.end()


def _on_cluster(take, work, shared, address):
    distributed = need("distributed")
    try:
        client = distributed.Client(address, timeout=10)
    except (OSError, ValueError) as cause:
        raise errors.ArgumentError(f"no cluster at {address!r}: {cause}", id="cluster") from None
    with client:
        there = [client.scatter(each, broadcast=True) for each in shared]
        units, done = {}, distributed.as_completed()

        def submit():
            while (unit := take()) is not None:
                future = client.submit(work, unit, *there, retries=TRIES - 1, pure=False)
                units[future] = unit
                done.add(future)

        submit()
        for future in done:
            unit = units.pop(future)
            try:
                yield unit, future.result()
            except distributed.KilledWorker as cause:
                yield unit, Lost(f"was {cause.last_worker}")
            submit()
