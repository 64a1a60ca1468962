# SPDX-License-Identifier: MIT
"""Benches of the two papers' experiments: rows, and the figures of docs/papers.md on request.

What they mean is in docs/papers.md. Machining times and speeds are the same on every computer.
Wrong would make the times of computation: other work on the cores, threads before all; each is the
least of several runs.
"""

from pycnc.papers import parallel, paths
from pycnc.papers import grades as by_grades

_KEINERT_OVERLAP = (5, 50)  # the paper's case study


def cao(folder=None):
    """Return total time and end speeds over N look-ahead segments (figure 16, table 2).

    Parameters
    ----------
    folder : path, optional
        Where to write the figures 9 to 12 and 14 to 16, and the lathe's profile.
    """
    path = paths.lathe8()
    rows = paths.lookahead_rows(path)
    if folder is not None:
        from pycnc.papers import plot

        plot.velocity(path, folder)
        plot.fixed_ramp(path, folder)
        plot.acceleration(path, folder)
        plot.total_time(rows, folder)
        plot.worked_example(by_grades.sweeps(by_grades.WORKED_EXAMPLE), folder)
        plot.grade_charts(by_grades.charts(), folder)
        plot.lathe(by_grades.lathe_runs(), folder)
    for row in rows:
        row["end_speed_mm_min"] = " ".join(f"{v:g}" for v in row["end_speed_mm_min"])
    return rows


def segments():
    """Return time and cost of planning over N on a path of many short blocks."""
    return paths.reach_rows()


def grades():
    """Return what planning by grades costs in machining time against the exact envelope."""
    return by_grades.cost_rows()


def keinert(folder=None):
    """Return time of serial and parallel look-ahead over the number of blocks (figure 5).

    Parameters
    ----------
    folder : path, optional
        Where to write the figures 5 to 8.
    """
    rows = parallel.efficiency_rows()
    if folder is not None:
        from pycnc.papers import plot_parallel

        seen = parallel.profiles()
        tasks = seen["found"].tasks
        plot_parallel.efficiency(rows, folder)
        plot_parallel.profiles(
            seen["s"], seen["serial"], seen["parallel"], seen["short"], folder
        )
        plot_parallel.overlap(tasks["overlap_behind"][:-1], *_KEINERT_OVERLAP, folder)
        plot_parallel.gantt(
            tasks["thread"], tasks["entry_ns"] / 1e3, tasks["exit_ns"] / 1e3, folder
        )
    return rows


def scaling(folder=None):
    """Return ns per point of every backend over the number of points, beside the triad's.

    Parameters
    ----------
    folder : path, optional
        Where to write the figure.
    """
    rows = parallel.scaling_rows()
    if folder is not None:
        from pycnc.papers import plot_parallel

        plot_parallel.scaling(rows, folder)
    return rows

