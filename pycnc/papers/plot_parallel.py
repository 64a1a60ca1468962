# SPDX-License-Identifier: MIT
"""The figures of docs/papers.md about planning in parallel: Keinert's and the scaling study."""

import numpy as np

from pycnc.papers.plot import PAPER, save, sheet

_SERIAL, _PARALLEL, _SHORT = "#20242c", "#1f6feb", "#d1495b"
_THREADS = ("#1f6feb", "#d1884b", "#2f9e5b", "#8a5cd6")
_BACKENDS = {
    "c": "#20242c", "simd": "#2f9e5b", "threads": "#1f6feb",
    "opencl pthread": "#d1495b", "opencl basic": "#d1884b", "opencl gpu": "#8a5cd6",
}  # fmt: skip


def efficiency(rows, folder):
    """Draw time of serial and parallel look-ahead over the number of blocks (figure 5)."""
    figure, axes = sheet(1, 2, (10, 4))
    blocks, serial = [row["blocks"] for row in rows], np.array([row["serial_us"] for row in rows])
    for key, colour, label in (
        ("serial_us", _SERIAL, "serial"),
        ("one_thread_us", _SHORT, "Keinert's tasks, 1 thread"),
        ("parallel_us", _PARALLEL, f"Keinert's tasks, {rows[0]['threads']} threads"),
        ("chunks_us", "#2f9e5b", f"chunks in lanes, {rows[0]['threads']} threads"),
    ):
        times = np.array([row[key] for row in rows])
        axes[0, 0].loglog(blocks, times, "o-", color=colour, ms=4, label=label)
        axes[0, 1].semilogx(blocks, serial / times, "o-", color=colour, ms=4)
    axes[0, 0].set_ylabel("look-ahead of all blocks [µs]")
    axes[0, 0].legend(frameon=False, fontsize=9)
    axes[0, 1].axhline(1, color=PAPER, lw=1, ls="--")
    axes[0, 1].set_ylabel("serial time / time")
    axes[0, 1].set_ylim(0)
    for each in axes.flat:
        each.set_xlabel("blocks")
    return save(figure, folder, "keinert_5_efficiency")


def profiles(s, serial, parallel, short, folder):
    """Draw the feed profiles of serial and parallel look-ahead (figure 6), where they drop most.

    Parameters
    ----------
    s : numpy.ndarray
        (n,) path coordinate [mm].
    serial, parallel, short : numpy.ndarray
        (n,) speeds [mm/s]; short: with a largest overlap that does not suffice.
    """
    figure, axes = sheet(2, 1, (10, 5.6), sharex=True, sharey=True)
    middle = int(np.argmax(serial - short))
    shown = slice(max(0, middle - 250), middle + 250)
    pairs = (("enough overlap", parallel, _PARALLEL), ("too little overlap", short, _SHORT))
    for each, (title, given, colour) in zip(axes.flat, pairs, strict=True):
        apart = int(np.count_nonzero(serial != given))
        each.plot(s[shown], serial[shown] * 60, color=PAPER, lw=4, alpha=0.4, label="serial")
        each.plot(s[shown], given[shown] * 60, color=colour, lw=1.2, label="parallel")
        each.set_title(f"{title}: {apart:,} of {len(s):,} points differ", fontsize=10)
        each.set_ylabel("feed [mm/min]")
        each.legend(frameon=False, fontsize=9, loc="lower right")
        each.set_ylim(0)
    axes[-1, 0].set_xlabel("path [mm], around the deepest drop")
    return save(figure, folder, "keinert_6_profiles")


def overlap(used, least, most, folder):
    """Draw the overlap that every task used (figure 7).

    Parameters
    ----------
    used : numpy.ndarray
        (tasks,) blocks of overlap.
    least, most : int
        Its configured bounds.
    """
    figure, axes = sheet(1, 1, (10, 3.2))
    axes[0, 0].plot(used, ".", color=_PARALLEL, ms=4)
    axes[0, 0].set_xlim(-0.02 * len(used), 1.12 * len(used))
    for bound, name in ((least, "minimum"), (most, "maximum")):
        axes[0, 0].axhline(bound, color=PAPER, lw=1, ls="--")
        words = f"{name} {bound}"
        axes[0, 0].text(1.02 * len(used), bound, words, va="bottom", fontsize=9, color=PAPER)
    axes[0, 0].set_ylim(0, most * 1.15)
    axes[0, 0].set_xlabel("task")
    axes[0, 0].set_ylabel("overlap [blocks]")
    return save(figure, folder, "keinert_7_overlap")


def gantt(thread, begin_us, end_us, folder):
    """Draw which thread ran which task when: all, and the last ones (figure 8).

    Parameters
    ----------
    thread : numpy.ndarray
        (tasks,) number of the thread.
    begin_us, end_us : numpy.ndarray
        (tasks,) time stamps on entry and exit [µs].
    """
    figure, axes = sheet(1, 2, (11, 3.2), sharey=True)
    last = slice(max(0, len(thread) - 16), None)
    for each, some, title, edge in (
        (axes[0, 0], slice(None), f"all {len(thread)} tasks", 0),
        (axes[0, 1], last, "the last tasks", 0.6),
    ):
        colours = [_THREADS[k % 4] for k in thread[some]]
        each.barh(
            thread[some], (end_us - begin_us)[some], left=begin_us[some], height=0.6,
            color=colours, edgecolor="white", linewidth=edge,
        )  # fmt: skip
        each.set_title(title, fontsize=10)
        each.set_xlabel("time [µs]")
    axes[0, 0].set_yticks(np.unique(thread))
    axes[0, 0].set_ylabel("thread")
    return save(figure, folder, "keinert_8_threads")


def scaling(rows, folder):
    """Draw time per point over the number of points: every backend, and the memory's bound."""
    figure, axes = sheet(1, 2, (12, 5), sharey=True)
    for each, real in zip(axes.flat, ("float", "double"), strict=True):
        chosen = [row for row in rows if row["real"] == real]
        for name in dict.fromkeys(row["backend"] for row in chosen):
            line = [row for row in chosen if row["backend"] == name]
            points, ns = [row["n"] for row in line], [row["ns_per_point"] for row in line]
            road, _, copies = name.partition(", ")
            colour = _BACKENDS.get(road, PAPER)
            each.loglog(
                points, ns, "o:" if copies else "o-", color=colour, ms=4, lw=1.4,
                alpha=0.6 if copies else 1, label=name,
            )  # fmt: skip
        each.set_title(real, fontsize=10)
        each.set_xlabel("points")
    axes[0, 0].set_ylabel("time per point [ns]")
    axes[0, 0].legend(frameon=False, fontsize=8)
    return save(figure, folder, "scaling")
