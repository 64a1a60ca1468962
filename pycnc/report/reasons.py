# SPDX-License-Identifier: MIT
"""What ``pycnc why`` tells a person: causes with their worst places, and what cures gain."""

from pycnc.report import times
from pycnc.report.plot import duration

_CAUSES_SHOWN = 12
_SHORT = 6  # causes that a run tells
_PLACES_SHOWN = 3
_PLACE_SHARE = 0.1  # of a cause's loss: what another place must have to be shown
_TEXT = 40  # characters of a source line
GAIN_S = 5e-4  # what is less is no gain


def short(found):
    """Yield the first lines of the same table, which a run has among others.

    Parameters
    ----------
    found : Why
    """
    ideal, lost = (duration(each) for each in (found.ideal_s, found.time_s - found.ideal_s))
    yield f"What holds it back: ideal time {ideal} · lost {lost}"
    yield from _slow_feeds(found)
    yield from _table_of(found, _SHORT, 1)


def _table_of(found, most, places=_PLACES_SHOWN):
    rows = [row for cause in found.causes[:most] for row in _rows(cause, places)]
    if rows:
        heads = ("lost", "share", "to", "places", "lines", "worst at line")
        yield from _table(heads, rows, ">><><<")
    rest = found.causes[most:]
    if rest:
        lost_s = sum(cause["lost_s"] for cause in rest)
        yield f"  {duration(lost_s)} to {len(rest)} more causes (all: pycnc why --json)"


def lines(found):
    """Yield the lines about a program.

    Parameters
    ----------
    found : Why
    """
    yield times.head(found.program, found.plan.totals["total_s"])
    yield from of_total(found)


def of_total(found):
    """Yield the lines behind the whole time of a program."""
    yield f"  {_sums(found)}"
    yield from _slow_feeds(found)
    yield from _table_of(found, _CAUSES_SHOWN)
    if found.cures:
        yield from _cures(found.cures)


def _sums(found):
    """Return what the whole time is the sum of."""
    parts = [("ideal time", duration(found.ideal_s)),
             *times.told(found.plan.totals, times.EXTRAS),
             ("lost", duration(found.time_s - found.ideal_s))]  # fmt: skip
    return " · ".join(f"{word} {time}" for word, time in parts)


def _slow_feeds(found):
    """Yield what of the ideal time is at feeds far below the rest: nothing is lost there."""
    for feed in found.slow_feeds:
        many = "1 move" if feed["moves"] == 1 else f"{feed['moves']:,} moves"
        yield (
            f"  {duration(feed['time_s'])} of the ideal time at a feed of "
            f"{feed['feed_mm_min']:.4g} mm/min: {feed['length_mm']:.3g} mm in {many} on "
            f"{_lines(feed)}"
        )


def _lines(place):
    """Return the lines of a place in words."""
    first, last = place["line_first"], place["line_last"]
    return f"line {first}" if first == last else f"lines {first}-{last}"


def _rows(cause, most):
    """Yield a row of a cause with its worst place, and rows of others that matter."""
    if cause["count"] == 0:
        return
    places = cause["places"]
    worst = _place(places[0]) if places else ["", ""]
    yield [duration(cause["lost_s"]), f"{cause['share']:.1%}", cause["words"],
           f"{cause['count']:,}", *worst]  # fmt: skip
    for place in places[1:most]:
        if place["lost_s"] > _PLACE_SHARE * cause["lost_s"]:
            words = f"  of it {duration(place['lost_s'])}"
            yield ["", "", words, f"{place['count']:,}", *_place(place)]


def _place(place):
    first, last = place["line_first"], place["line_last"]
    axis = f" ({place['axis'].upper()})" if place["axis"] else ""
    text = place["text"]
    text = text if len(text) <= _TEXT else f"{text[: _TEXT - 1]}…"
    span = f"{first}" if first == last else f"{first}-{last}"
    return [span, f"{place['line_worst']}{axis}{': ' if text else ''}{text}"]


def _cures(cures):
    yield ""
    told = [cure for cure in cures if abs(cure["gain_s"]) >= GAIN_S]
    rows = [[duration(cure["total_s"]), _signed(cure["gain_s"]), cure["cure"]] for cure in told]
    yield from _table(("time", "gain", "what if"), rows, ">><")
    if len(told) < len(cures):
        idle = ", ".join(cure["cure"] for cure in cures if cure not in told)
        yield f"  no gain: {idle}"


def _signed(seconds):
    return duration(seconds) if seconds > 0 else f"-{duration(-seconds)}"


def _table(heads, rows, sides):
    """Yield the lines of a table; sides: > or < for each column."""
    widths = [max(map(len, column)) for column in zip(heads, *rows, strict=True)]
    for cells in (heads, *rows):
        fields = (f"{cell:{side}{width}}" for cell, side, width in
                  zip(cells, sides, widths, strict=True))  # fmt: skip
        yield f"  {'  '.join(fields)}".rstrip()
