# SPDX-License-Identifier: MIT
"""Slow programmed feeds: the ideal time has them, so no cause of lost time names them.

    blocks as they are decoded ─▶ time, path, lines of each feed ─▶ those that are worth a look

Feeds that are alike in three digits are one, so memory does not grow with the program.
"""

import numpy as np

from pycnc.kernel.bind import lib
from pycnc.program.geometry import Moves

# A feed is told where it is not what the program is about, and costs what one would notice: at most
# this share of the path that is cut is cut at it,
FEW = 0.1
# and at the mean feed of the rest the program would be shorter by this share at least.
NOTABLE = 0.05
_LEAST, _DECADES, _DIGITS = -4, 12, 900  # 1e-4 mm/min and more, by three digits


def _kinds(feeds):
    """Return the number of each feed's kind: its decade, and its first three digits."""
    decade = np.floor(np.log10(feeds))
    digits = np.rint(feeds / 10 ** (decade - 2)) - 100
    kinds = (decade - _LEAST) * _DIGITS + digits
    return np.clip(kinds, 0, _DECADES * _DIGITS - 1).astype(np.intp)


def _of_blocks(blocks, lengths):
    """Return (which blocks cut at a feed of their own, their feeds in mm/min)."""
    is_cut = np.isin(blocks["kind"], (lib.NCK_BLOCK_LINE, lib.NCK_BLOCK_ARC))
    by_turns = blocks["feed_mode"] == lib.NCK_FEED_PER_REV
    feeds = blocks["feed"] * np.where(by_turns, blocks["spindle_rpm"], 1)
    feeds *= np.where(blocks["feed_mode"] == lib.NCK_FEED_INVERSE, lengths, 1)
    # Under G96 the feed changes with the radius.
    found = is_cut & (lengths > 0) & (feeds > 0) & ~(by_turns & (blocks["surface"] > 0))
    return found, feeds[found]


class _Sums:
    """Time [min], path [mm], moves and lines of every kind of feed."""

    def __init__(self):
        count = _DECADES * _DIGITS
        self.time, self.length, self.moves = np.zeros(count), np.zeros(count), np.zeros(count)
        self.first = np.full(count, np.iinfo(np.int64).max)
        self.last = np.zeros(count, np.int64)

    def add(self, blocks, lengths):
        found, feeds = _of_blocks(blocks, lengths)
        if not feeds.size:
            return
        kinds, lengths = _kinds(feeds), lengths[found]
        lines = blocks["line"][found].astype(np.int64)
        count = len(self.time)
        self.time += np.bincount(kinds, lengths / feeds, count)
        self.length += np.bincount(kinds, lengths, count)
        self.moves += np.bincount(kinds, minlength=count)
        np.minimum.at(self.first, kinds, lines)
        np.maximum.at(self.last, kinds, lines)


def sums_of(program):
    """Return the sums of all cuts of a program, by the kinds of their feeds."""
    sums, begin = _Sums(), None
    for blocks in program.pieces():
        moves = Moves(blocks, program.machine, begin)
        sums.add(blocks, moves.lengths(slice(3)))
        begin = moves.end[-1] if len(blocks) else begin
    return sums


def slow(program, time_s):
    """Return the slow feeds of a program, the dearest first.

    Parameters
    ----------
    program : Program
    time_s : float
        Of its plan [s].

    Returns
    -------
    list of dict
        ``feed_mm_min``; ``time_s`` at it; ``over_s``, what of that is over the time at the mean
        feed of the rest; ``length_mm``, ``moves``, ``line_first``, ``line_last``.
    """
    sums = sums_of(program)
    seconds, length = 60 * sums.time, sums.length
    rest_s, rest_mm = seconds.sum() - seconds, length.sum() - length
    over_s = seconds - length * rest_s / np.maximum(rest_mm, 1e-9)
    told = (length <= FEW * length.sum()) & (over_s >= NOTABLE * time_s) & (seconds > 0)
    return [
        {"feed_mm_min": float(f"{length[k] / sums.time[k]:.9g}"), "time_s": float(seconds[k]),
         "over_s": float(over_s[k]), "length_mm": float(length[k]), "moves": int(sums.moves[k]),
         "line_first": int(sums.first[k]), "line_last": int(sums.last[k])}
        for k in sorted(np.flatnonzero(told), key=lambda k: -over_s[k])
    ]  # fmt: skip
