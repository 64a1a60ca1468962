# SPDX-License-Identifier: MIT
"""Pictures of a run: the path coloured by the speed really reached, speed and acceleration."""

import errno
import json
import math
import os
from importlib import resources
from pathlib import Path

import numpy as np

from pycnc.extras import need
from pycnc.files import Part
from pycnc.planning.measure import KINDS

_POINTS = 200_000  # points of the path that are drawn at most
_BINS = 1600  # columns of the curves over time: about one a pixel
_FLAT = 0.12  # a path whose third extent is smaller than this part of the largest is drawn flat
_TURN, _TILT = math.radians(-60), math.radians(32)  # from where a path in space is seen
_ON_SCREEN = np.array([  # of a box with X, Y, Z: width and height, seen from there
    [-math.sin(_TURN), math.cos(_TURN), 0],
    [math.sin(_TILT) * math.cos(_TURN), -math.sin(_TILT) * math.sin(_TURN), math.cos(_TILT)],
])  # fmt: skip
_TITLE, _GAP = 0.4, 0.1  # height of its line, and below the path [inch]
_INK, _GRID = "#20242c", "#e4e7ec"
_SPEED, _FEED, _ACCELERATION = "#1f6feb", "#9aa4b2", "#d1495b"


def duration(seconds):
    """Return a time for people.

    Examples
    --------
    >>> duration(83.42)
    '1 min 23.4 s'
    """
    if seconds < 60:
        return f"{seconds:.3f} s" if seconds < 10 else f"{seconds:.2f} s"
    tenths = round(seconds * 10)
    if tenths < 36000:
        return f"{tenths // 600} min {tenths % 600 / 10:.1f} s"
    minutes = round(seconds / 60)
    return f"{minutes // 60} h {minutes % 60:02d} min"


def draw(trace):
    """Draw a run.

    Parameters
    ----------
    trace : Trace
        With its rows.

    Returns
    -------
    matplotlib.figure.Figure
        Path above, speed and acceleration over time below; of a run without a tick its name alone.
    """
    if not len(trace):
        return _draw_nothing(trace)
    shape = _projection(trace)
    height = _path_height(trace, shape)
    figure = need("matplotlib.figure").Figure(
        figsize=(11, height + 4.6), dpi=110, layout="constrained", facecolor="white"
    )
    grid = figure.add_gridspec(3, 1, height_ratios=(height, 2, 2))
    three = len(shape) == 3
    path_axes = figure.add_subplot(grid[0], projection="3d" if three else None)
    bar = _draw_path(figure, path_axes, trace, shape)
    speed_axes = figure.add_subplot(grid[1])
    _draw_speed(speed_axes, trace)
    _draw_acceleration(figure.add_subplot(grid[2], sharex=speed_axes), trace)
    speed_axes.tick_params(labelbottom=False)
    figure.suptitle(_title(trace), fontsize=13, color=_INK)
    if three:
        _fill(figure, path_axes, bar.ax, speed_axes)
    return figure


def _draw_nothing(trace):
    figure = need("matplotlib.figure").Figure(figsize=(11, 3.2), dpi=110, facecolor="white")
    axes = figure.add_subplot()
    axes.set_axis_off()
    axes.text(0.5, 0.5, "nothing moves", ha="center", color=_INK)
    figure.suptitle(_title(trace), fontsize=13, color=_INK)
    return figure


def write(trace, path):
    """Draw a run into a file.

    Parameters
    ----------
    trace : Trace
        With its rows.
    path : path
        Its ending chooses the format: png, svg, pdf. Without one it gets ``.png``.

    Returns
    -------
    str
        The file that was written.
    """
    name = os.fspath(path)
    if os.path.isdir(name or os.curdir):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), name)
    name = name if Path(name).suffix else f"{name}.png"
    figure = draw(trace)
    with Part(name) as part:
        figure.savefig(part.file, format=Path(name).suffix[1:])
    return name


def _title(trace):
    name, machine = Path(trace.program.file).name, trace.program.machine.name
    return f"{name}   ·   {machine}   ·   {duration(trace.summary['total_s'])}"


def _positions(trace):
    """Return axis letter → positions of the linear axes [mm]."""
    letters = [letter for letter in trace.program.machine.axes if letter in "xyz"]
    return {letter: trace[f"pos_{letter}_mm"] for letter in letters}


def _projection(trace):
    """Return the axes to draw: two of a flat path, horizontal first, or all three."""
    positions = _positions(trace)
    if trace.program.machine.settings.kinematics.type == "lathe_xz":
        return ("z", "x")
    cutting = _cutting(trace)
    extent = {a: float(np.ptp(p[cutting])) if len(p) else 0.0 for a, p in positions.items()}
    ranked = sorted(positions, key=lambda letter: -extent[letter])
    if len(ranked) == 3 and extent[ranked[2]] > _FLAT * extent[ranked[0]] > 0:
        return ("x", "y", "z")
    return tuple(sorted(ranked[:2])) if len(ranked) > 1 else (ranked[0], ranked[0])


def palette():
    """Return the colours that pictures and pages share: slow is red and fast blue in both."""
    text = resources.files("pycnc.report").joinpath("palette.json").read_text(encoding="utf-8")
    return json.loads(text)


def _colours():
    from matplotlib.colors import LinearSegmentedColormap

    return LinearSegmentedColormap.from_list("speed", palette()["speed"])


def _path_height(trace, shape):
    """Return the height of the path's picture [inch]: what a flat path needs at full width."""
    extents = [np.ptp(_positions(trace)[letter][_cutting(trace)]) for letter in shape]
    across, up = _ON_SCREEN @ extents if len(shape) == 3 else extents
    return float(np.clip(8.6 * up / across, 3.2, 7.5)) if across > 0 else 7.5


def _cutting(trace):
    """Return which rows cut; all rows if none does."""
    cuts = [KINDS.index(kind) for kind in ("line", "arc", "spline", "thread", "tap")]
    cutting = np.isin(trace["kind"], cuts)
    return cutting if cutting.any() else np.ones(len(trace), bool)


def _draw_path(figure, axes, trace, shape):
    from matplotlib.collections import LineCollection
    from matplotlib.colors import Normalize

    stride = max(1, math.ceil(len(trace) / _POINTS))
    positions = _positions(trace)
    points = np.stack([positions[letter][::stride] for letter in shape], axis=1)
    speed = trace["vel_mm_s"][::stride][1:] * 60
    rapid = trace["kind"][::stride][1:] == KINDS.index("rapid")
    pieces = np.stack([points[:-1], points[1:]], axis=1)
    moved = np.any(pieces[:, 0] != pieces[:, 1], axis=1)
    cutting = moved & ~rapid
    top = float(speed[cutting].max()) if cutting.any() else 1.0
    collection = LineCollection
    if len(shape) == 3:
        from mpl_toolkits.mplot3d.art3d import Line3DCollection as collection
    grey = palette()["limits"]["rapid"]
    axes.add_collection(collection(pieces[moved & rapid], colors=grey, linewidths=0.6))
    coloured = collection(
        pieces[cutting], cmap=_colours(), norm=Normalize(0, top), linewidths=1.6, capstyle="round"
    )
    coloured.set_array(speed[cutting])
    axes.add_collection(coloured)
    drawn = pieces[cutting].reshape(-1, len(shape)) if cutting.any() else points
    _frame(axes, drawn, shape)
    bar = figure.colorbar(
        coloured, ax=axes, shrink=0.85, pad=0.02 + 0.06 * (len(shape) == 3), aspect=32
    )
    bar.set_label("speed reached [mm/min]; rapids in grey", color=_INK)
    bar.outline.set_visible(False)
    return bar


def _frame(axes, points, shape):
    """Set limits around points with a margin, the same scale on all axes, and labels."""
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.05 * max(float((high - low).max()), 1e-3)
    setters = (axes.set_xlim, axes.set_ylim) + ((axes.set_zlim,) if len(shape) == 3 else ())
    for k, setter in enumerate(setters):
        setter(low[k] - margin, high[k] + margin)
    axes.set_xlabel(f"{shape[0].upper()} [mm]")
    axes.set_ylabel(f"{shape[1].upper()} [mm]")
    if len(shape) == 3:
        axes.set_zlabel(f"{shape[2].upper()} [mm]")
        axes.set_box_aspect(_box(axes))
        axes.view_init(elev=math.degrees(_TILT), azim=math.degrees(_TURN))
        return
    axes.set_aspect("equal")
    _plain(axes)


def _box(axes):
    """Return the extents of a box in space: all axes have one scale."""
    return [float(np.ptp(limits)) for limits in (axes.get_xlim(), axes.get_ylim(), axes.get_zlim())]


def _fill(figure, axes, bar, below):
    """Let a path in space fill its place: the box and its labels, which do not grow with it."""
    from matplotlib.transforms import Bbox, TransformedBbox

    axes.set_in_layout(False)
    figure.draw_without_rendering()
    figure.set_layout_engine("none")
    drawn = figure.transFigure.inverted().transform_bbox(bar.get_tightbbox())
    bottom = below.get_position().y1 + _GAP / figure.get_figheight()
    place = Bbox([[0, bottom], [1 - drawn.width, 1 - _TITLE / figure.get_figheight()]])
    was = bar.get_position()
    up = (place.ymin + place.ymax - was.ymin - was.ymax) / 2
    bar.set_position(was.translated(1 - drawn.x1, up))
    box, zoom = _box(axes), 1.0
    for _ in range(3):
        drawn = _drawn(figure, axes)
        zoom *= min(place.width / drawn.width, place.height / drawn.height)
        axes.set_box_aspect(box, zoom=zoom)
        figure.draw_without_rendering()
    drawn, now = _drawn(figure, axes), axes.get_position()
    shift = (place.min + place.max - drawn.min - drawn.max) / 2
    axes.set_position([*(now.min + shift), now.width, now.height])
    for collection in axes.collections:  # a rapid goes on beyond the box
        collection.set_clip_box(TransformedBbox(place, figure.transFigure))


def _drawn(figure, axes):
    """Return where the box in space and its labels are, in parts of the figure."""
    from matplotlib.transforms import Bbox
    from mpl_toolkits.mplot3d import proj3d

    limits = (axes.get_xlim(), axes.get_ylim(), axes.get_zlim())
    corners = np.stack(np.meshgrid(*limits)).reshape(3, -1)
    across, up, _ = proj3d.proj_transform(*corners, axes.get_proj())
    box = Bbox.null()
    box.update_from_data_xy(axes.transData.transform(np.column_stack([across, up])))
    labels = [axis.get_tightbbox() for axis in (axes.xaxis, axes.yaxis, axes.zaxis)]
    return figure.transFigure.inverted().transform_bbox(Bbox.union([box, *labels]))


def _draw_speed(axes, trace):
    t, low, high = _bins(trace, trace["vel_mm_s"] * 60)
    _, _, feed = _bins(trace, trace["feed_cmd_mm_min"])
    if np.isfinite(feed).any() and feed.max() > 0:
        axes.plot(t, np.where(feed > 0, feed, np.nan), color=_FEED, lw=1, label="programmed")
    axes.fill_between(t, low, high, color=_SPEED, alpha=0.35, lw=0)
    axes.plot(t, high, color=_SPEED, lw=1, label="reached")
    axes.set_ylabel("speed [mm/min]")
    _frame_speed(axes, trace)
    axes.legend(loc="upper right", ncols=2, fontsize=8, edgecolor="none", framealpha=0.9)
    _plain(axes)


def _frame_speed(axes, trace):
    """Leave the room to the cuts: of much faster rapids only the number is told."""
    speed, rapid = trace["vel_mm_s"] * 60, trace["kind"] == KINDS.index("rapid")
    cut, top = float(speed[~rapid].max(initial=0)), float(speed.max(initial=0))
    if 0 < 2 * cut < top:
        words = f"rapids reach {top:,.0f} mm/min"
        box = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}
        axes.text(0.01, 0.9, words, transform=axes.transAxes, fontsize=8, color=_INK, bbox=box)
        top = cut
    axes.set_ylim(0, 1.25 * max(top, 1e-9))


def _draw_acceleration(axes, trace):
    period = trace.program.machine.period_s
    acceleration = np.diff(trace["vel_mm_s"], prepend=trace["vel_mm_s"][:1]) / period
    t, low, high = _bins(trace, acceleration)
    axes.fill_between(t, low, high, color=_ACCELERATION, alpha=0.45, lw=0)
    axes.plot(t, high, color=_ACCELERATION, lw=0.8)
    axes.plot(t, low, color=_ACCELERATION, lw=0.8)
    axes.set_ylabel("acceleration along\nthe path [mm/s²]")
    axes.set_xlabel("time [s]")
    axes.set_xlim(0, max(float(t[-1]), period))
    _plain(axes)


def _bins(trace, values):
    """Return (time, smallest, largest) of values in as many bins as the picture can show."""
    width = max(1, math.ceil(len(values) / _BINS))
    starts = np.arange(0, len(values), width)
    time = trace["t_s"][starts]
    return time, np.minimum.reduceat(values, starts), np.maximum.reduceat(values, starts)


def _plain(axes):
    axes.grid(color=_GRID, lw=0.8)
    axes.set_axisbelow(True)
    for spine in axes.spines.values():
        spine.set_color(_GRID)
    axes.tick_params(colors=_INK, labelsize=9, length=0)
