# SPDX-License-Identifier: MIT
"""Benches of the two papers' experiments: rows, and the figures of docs/papers.md on request.

What they mean is in docs/papers.md. Machining times and speeds are the same on every computer.
Wrong would make the times of computation: other work on the cores, threads before all; each is the
least of several runs.
"""

from pycnc import papers, papers_grades, papers_parallel

_KEINERT_OVERLAP = (5, 50)  # the paper's case study


def cao(folder=None):
    """Return total time and end speeds over N look-ahead segments (figure 16, table 2).

    Parameters
    ----------
    folder : path, optional
        Where to write the figures 9 to 12 and 14 to 16, and the lathe's profile.
    """
    path = papers.lathe8()
    rows = papers.lookahead_rows(path)
    if folder is not None:
        from pycnc import papers_plot

        papers_plot.velocity(path, folder)
        papers_plot.fixed_ramp(path, folder)
        papers_plot.acceleration(path, folder)
        papers_plot.total_time(rows, folder)
        papers_plot.worked_example(papers_grades.sweeps(papers_grades.WORKED_EXAMPLE), folder)
        papers_plot.grade_charts(papers_grades.charts(), folder)
        papers_plot.lathe(papers_grades.lathe_runs(), folder)
    for row in rows:
        row["end_speed_mm_min"] = " ".join(f"{v:g}" for v in row["end_speed_mm_min"])
    return rows


def segments():
    """Return time and cost of planning over N on a path of many short blocks."""
    return papers.reach_rows()


def grades():
    """Return what planning by grades costs in machining time against the exact envelope."""
    return papers_grades.cost_rows()


def keinert(folder=None):
    """Return time of serial and parallel look-ahead over the number of blocks (figure 5).

    Parameters
    ----------
    folder : path, optional
        Where to write the figures 5 to 8.
    """
    rows = papers_parallel.efficiency_rows()
    if folder is not None:
        from pycnc import papers_plot_parallel

        seen = papers_parallel.profiles()
        tasks = seen["found"].tasks
        papers_plot_parallel.efficiency(rows, folder)
        papers_plot_parallel.profiles(
            seen["s"], seen["serial"], seen["parallel"], seen["short"], folder
        )
        papers_plot_parallel.overlap(tasks["overlap_behind"][:-1], *_KEINERT_OVERLAP, folder)
        papers_plot_parallel.gantt(
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
    rows = papers_parallel.scaling_rows()
    if folder is not None:
        from pycnc import papers_plot_parallel

        papers_plot_parallel.scaling(rows, folder)
    return rows

