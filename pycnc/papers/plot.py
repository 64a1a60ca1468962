# SPDX-License-Identifier: MIT
"""The figures of docs/papers.md, each from the arrays of pycnc.papers."""

import io
from pathlib import Path

import numpy as np

from pycnc.extras import need
from pycnc.planning.measure import KINDS
from pycnc.papers import paths

_INK, _GRID = "#20242c", "#e4e7ec"
_COLOURS = {"linear": "#d1495b", "sshape": "#1f6feb", "whole": "#2f9e5b", "fixed": "#8a5cd6"}
_LABELS = {
    "linear": "linear, a = 25 mm/s²",
    "sshape": "S-shape, a = 25 mm/s², j = 75 mm/s³",
    "whole": "S over whole segments (gives the printed totals)",
    "fixed": "ramps of fixed duration 2 t0 = 2 s",
}
PAPER = "#6b7280"  # what the paper prints


def sheet(rows=1, columns=1, size=(9, 4), **options):
    """Return (figure, axes) in the style of all figures."""
    figure = need("matplotlib.figure").Figure(
        figsize=size, dpi=100, layout="constrained", facecolor="white"
    )
    axes = figure.subplots(rows, columns, squeeze=False, **options)
    for each in axes.flat:
        each.grid(color=_GRID, lw=0.8)
        each.set_axisbelow(True)
        each.tick_params(colors=_INK, labelsize=9, length=0)
        for spine in each.spines.values():
            spine.set_color(_GRID)
    return figure, axes


def save(figure, folder, name):
    """Write a figure as a PNG of few colours, which is small; return its path."""
    from PIL import Image

    path, drawn = Path(folder) / f"{name}.png", io.BytesIO()
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(drawn, format="png")
    Image.open(drawn).convert("RGB").quantize(48).save(path, optimize=True)
    return path


def velocity(path, folder):
    """Draw speed over time for N = 0, 1, 2, 6 look-ahead segments (Cao's figure 14)."""
    figure, axes = sheet(2, 2, (10, 6), sharey=True)
    for each, n in zip(axes.flat, paths.LOOKAHEADS, strict=True):
        for kind in ("whole", "sshape", "linear"):
            t, v, _ = _sampled(path, kind, n)
            each.plot(t, v * 60, color=_COLOURS[kind], lw=1.4, label=_LABELS[kind])
        each.set_title(f"N = {n}", fontsize=10, color=_INK)
        each.set_ylim(0, 560)
        each.set_xlim(0, 10.2)
    for each in axes[-1]:
        each.set_xlabel("time [s]")
    for each in axes[:, 0]:
        each.set_ylabel("speed [mm/min]")
    handles, labels = axes[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=3, frameon=False, fontsize=9)
    return save(figure, folder, "cao_14_velocity")


def fixed_ramp(path, folder):
    """Draw speed over time for N = 0 with ramps of fixed duration, another model."""
    figure, axes = sheet(1, 1, (10, 2.6))
    t, v, _ = _sampled(path, "fixed", 0)
    axes[0, 0].plot(t, v * 60, color=_COLOURS["fixed"], lw=1.4)
    title = f"N = 0, {_LABELS['fixed']}: {t[-1]:.1f} s (printed: 31.636 s)"
    axes[0, 0].set_title(title, fontsize=10, color=_INK)
    axes[0, 0].set_xlabel("time [s]")
    axes[0, 0].set_ylabel("speed [mm/min]")
    return save(figure, folder, "cao_14_fixed_ramp")


def acceleration(path, folder):
    """Draw acceleration over time, S-shape and linear, for N = 1 (Cao's figure 15)."""
    figure, axes = sheet(2, 1, (10, 5), sharex=True, sharey=True)
    for each, kind in zip(axes.flat, ("sshape", "linear"), strict=True):
        t, _, a = _sampled(path, kind, 1)
        style = {"drawstyle": "steps-post"} if kind == "linear" else {}
        each.plot(t, a, color=_COLOURS[kind], lw=1.4, **style)
        each.set_title(f"N = 1, {_LABELS[kind]}", fontsize=10, color=_INK)
        each.set_ylabel("acceleration [mm/s²]")
    axes[-1, 0].set_xlabel("time [s]")
    return save(figure, folder, "cao_15_acceleration")


def total_time(rows, folder):
    """Draw total time over the number of look-ahead segments (Cao's figure 16)."""
    figure, axes = sheet(1, 1, (9, 4.6))
    each = axes[0, 0]
    ns = sorted(paths.PRINTED_MS)
    printed = [paths.PRINTED_MS[n] for n in ns]
    each.plot(ns, printed, "x", color=PAPER, ms=11, mew=2, zorder=5, label="printed in the paper")
    for kind, label in _LABELS.items():
        chosen = [row for row in rows if row["kind"] == kind]
        marker = {"fixed": "D"}.get(kind, "o")
        each.plot(
            [row["lookahead"] for row in chosen], [row["total_ms"] for row in chosen],
            f"{marker}-", color=_COLOURS[kind], lw=1.2, ms=5, label=label,
        )  # fmt: skip
    each.annotate("32 000", (0, 32000), (0.25, 31000), fontsize=9, color=_COLOURS["fixed"])
    each.set_yscale("log")
    each.set_ylim(4500, 36000)
    each.set_yticks([5000, 7208, 10000, 20000, 31636])
    each.set_yticklabels(["5 000", "7 208", "10 000", "20 000", "31 636"])
    each.minorticks_off()
    each.set_xlabel("look-ahead segments N")
    each.set_ylabel("total time [ms]")
    each.legend(frameon=False, fontsize=9)
    return save(figure, folder, "cao_16_total_time")


def worked_example(sweeps, folder):
    """Draw the grades of the paper's six points before, during and after the bubble (10 to 12).

    Parameters
    ----------
    sweeps : list of numpy.ndarray
        Grades before the first sweep and after every sweep that changed one.
    """
    shown = [*sweeps, sweeps[-1]]
    titles = ["preplanned", *(f"after sweep {k}" for k in range(1, len(shown)))]
    titles[-1] += ": no change, the end"
    figure, axes = sheet(1, len(shown), (3.3 * len(shown), 3), sharey=True)
    for k, each in enumerate(axes.flat):
        points = np.arange(1, len(shown[k]) + 1)
        moved = shown[k] != shown[max(0, k - 1)]
        each.bar(points, shown[0], color=_GRID, width=0.6)
        each.bar(points, shown[k], color=np.where(moved, "#d1495b", "#1f6feb"), width=0.6)
        for x, y in zip(points, shown[k], strict=True):
            each.text(x, y + 0.1, str(y), ha="center", fontsize=9, color=_INK)
        each.set_title(titles[k], fontsize=10, color=_INK)
        each.set_xticks(points, [f"p{k}" for k in points])
    axes[0, 0].set_ylabel("velocity grade")
    axes[0, 0].set_ylim(0, 6)
    return save(figure, folder, "cao_10_12_worked_example")


def grade_charts(charts, folder):
    """Draw the grades of paths before, during and after the bubble (9 to 12 for real paths).

    Parameters
    ----------
    charts : list of (str, numpy.ndarray, list of numpy.ndarray)
        Title, path coordinate of every point [mm], grades before the first sweep and after each.
    """
    figure, axes = sheet(len(charts), 1, (10, 3.2 * len(charts)))
    for each, (title, s, sweeps) in zip(axes.flat, charts, strict=True):
        last = len(sweeps) - 1
        for k in sorted({0, last // 3, 2 * last // 3, last}):
            share = k / last
            colour = (0.82 - 0.7 * share, 0.55 - 0.1 * share, 0.3 + 0.6 * share) if k else "#9aa4b2"
            label = "preplanned" if k == 0 else f"after sweep {k}" + ", the end" * (k == last)
            each.plot(s, sweeps[k], color=colour, lw=1.8 if k == last else 1.1, label=label)
        each.set_title(title, fontsize=10)
        each.set_ylabel("velocity grade")
        each.legend(frameon=False, fontsize=8, loc="lower center", ncols=4)
        each.set_ylim(-0.22 * sweeps[0].max())
        each.set_yticks([tick for tick in each.get_yticks() if 0 <= tick <= sweeps[0].max()])
    axes[-1, 0].set_xlabel("path [mm]")
    return save(figure, folder, "cao_9_12_grades")


def lathe(runs, folder):
    """Draw speed over time of a lathe program, planned exactly and by grades, and a corner of it.

    Parameters
    ----------
    runs : dict
        Kind of planning → Trace.
    """
    figure, axes = sheet(2, 1, (11, 6.4))
    begin, end = _corner(runs["exact"], runs["grades"])
    for kind, colour, width in (("exact", "#9aa4b2", 3), ("grades", "#1f6feb", 1)):
        trace = runs[kind]
        t, s, v = trace["t_s"], trace["s_mm"], trace["vel_mm_s"] * 60
        label = f"{kind}: {trace.summary['time_s']:.3f} s"
        axes[0, 0].plot(t, v, color=colour, lw=width, label=label)
        near = (s >= begin) & (s <= end)
        axes[1, 0].plot(s[near], v[near], ".-", color=colour, lw=width, ms=5, label=kind)
    axes[0, 0].set_yscale("symlog", linthresh=10)
    axes[0, 0].set_ylim(0, 200000)
    axes[0, 0].set_xlim(0, float(t[-1]))
    axes[0, 0].set_title("turned_pin.ngc on cak6150n", fontsize=10)
    axes[0, 0].set_xlabel("time [s]")
    axes[1, 0].set_title("the cut's corner at which the two differ most, a dot a tick", fontsize=10)
    axes[1, 0].set_xlabel("path [mm]")
    axes[1, 0].set_ylim(0)
    for each in axes.flat:
        each.set_ylabel("speed [mm/min]")
        each.legend(frameon=False, fontsize=9, loc="upper right", ncols=2)
    return save(figure, folder, "cao_cak6150n")


def _corner(exact, by_grades, around_mm=0.06):
    """Return the stretch of path [mm] around the place in a cut where two runs differ most."""
    cut = np.isin(exact["kind"], (KINDS.index("line"), KINDS.index("arc")))
    s, v = exact["s_mm"], exact["vel_mm_s"]
    apart = np.abs(v - np.interp(s, by_grades["s_mm"], by_grades["vel_mm_s"]))
    middle = float(s[np.argmax(np.where(cut, apart, 0))])
    return middle - around_mm, middle + around_mm


def _sampled(path, kind, lookahead):
    """Return (t, v, a) of a profile, every period."""
    profile = path.profile(kind, lookahead)
    _, v, a = profile.sample(path.period_s)
    return np.arange(len(v)) * path.period_s, v, a
