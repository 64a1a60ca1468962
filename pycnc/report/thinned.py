# SPDX-License-Identifier: MIT
"""What is left out where a program has more points or lines than a page holds.

Points go whose place can be told best from their neighbours, at their time; low points of the speed
stay, and if there are too many of those, the dearest ones. Of the text the worst places stay, and
the begin.
"""

import numpy as np

from pycnc.kernel.records import dtype

_SLACK = 1.25  # times the points that stay: so many are held before some go
_LOW = 0.75  # of the points that stay: so many low points at most
_FRESH = 1 << 15  # the last points, whose low points may be still to come
_OF_A_LIMIT = 64  # low points of each limit that stay, however little they cost
_KIND_MM, _LIMIT_MM = 1.0, 0.02  # what it counts that a rapid, a rest, a tool or a limit ends there
_ROW = [
    ("t", "f8"), ("xyz", "f8", 3), ("v", "f4"), ("feed", "f4"), ("line", "u4"), ("tool", "u4"),
    ("limit", "u1"), ("rapid", "u1"), ("rests", "u1"),
]  # fmt: skip
_NUMBER, _ANGLES = ("number", "i8"), ("abc", "f4", 3)


class Points:
    """Points and low points of a plan, no more than some number of them.

    Parameters
    ----------
    most : int
    turns : bool
        Whether rotary axes turn.

    Attributes
    ----------
    feet : numpy.ndarray
        Of dtype ``nck_host_foot_t``; they tell points by their numbers among all that have come.
    """

    def __init__(self, most, turns):
        self._most, self._count, self._held = most, 0, 0
        fields = np.dtype([*_ROW, *([_ANGLES] if turns else []), _NUMBER])
        self._names = fields.names[:-1]
        self._rows = np.empty(int(_SLACK * most) + 2 * _FRESH, fields)
        self.feet, self._low = np.empty(0, dtype("nck_host_foot_t")), []

    @property
    def rows(self):
        """Points that are left, with the fields of ``nck_host_point_t`` that are of use."""
        return self._rows[: self._held]

    def add(self, points, feet):
        """Take the next rows of dtypes ``nck_host_point_t`` and ``nck_host_foot_t``."""
        self._low.append(feet.copy())
        for begin in range(0, len(points), _FRESH):
            piece = points[begin : begin + _FRESH]
            if self._held + len(piece) > len(self._rows):
                self.thin(self._most, _FRESH)
            held = self._rows[self._held : self._held + len(piece)]
            for name in self._names:
                held[name] = piece[name]
            held["number"] = np.arange(self._count, self._count + len(piece))
            self._held, self._count = self._held + len(piece), self._count + len(piece)

    def thin(self, most, fresh=0):
        """Leave at most so many points, of the last `fresh` ones all."""
        self.feet, self._low = np.concatenate([self.feet, *self._low]), []
        if len(self.feet) > _LOW * most:
            self.feet = self.feet[_dearest(self.feet["low"], int(_LOW * most))]
        low, at = np.zeros(self._held, bool), self._places(self.feet["at"])
        low[at[at < len(low)]] = True
        kept = _kept(self.rows, low, most, fresh)
        self._rows[: len(kept)] = self.rows[kept]
        self._held = len(kept)

    def _places(self, numbers):
        return np.searchsorted(self.rows["number"], numbers)

    def placed(self):
        """Return the low points with numbers among the points that are left."""
        feet = self.feet.copy()
        for name in ("first", "at"):
            feet[name] = self._places(feet[name])
        return feet


def _dearest(low, most):
    """Return which low points stay, in their order: those that cost most, some of each limit."""
    dear = np.argsort(-low["lost_s"], kind="stable")
    limits, stays = low["limit"][dear], np.zeros(len(low), bool)
    for limit in np.unique(limits):
        stays[dear[limits == limit][:_OF_A_LIMIT]] = True
    others = dear[~stays[dear]]
    stays[others[: max(0, most - np.count_nonzero(stays))]] = True
    return np.flatnonzero(stays)


def _kept(rows, low, most, fresh):
    """Return the numbers of the rows that stay.

    Every other point that is no low one may go, and half of those do whose places are told best.
    """
    index, odd, idle = np.arange(len(rows)), 0, 0
    while len(index) > most and idle < 2:
        middle = np.arange(1 + odd, max(1, len(index) - max(fresh, 1)), 2)
        middle = middle[~low[index[middle]]]
        odd, idle = 1 - odd, 0 if len(middle) else idle + 1
        goes = min(len(index) - most, (len(middle) + 1) // 2)
        if goes:
            apart = _apart(rows, index[middle - 1], index[middle], index[middle + 1])
            index = np.delete(index, middle[np.argpartition(apart, goes - 1)[:goes]])
    return index


def _apart(rows, before, here, behind):
    """Return how far points are from where their neighbours tell them at their time [mm]."""
    t = rows["t"]
    time = t[behind] - t[before]
    share = np.where(time > 0, (t[here] - t[before]) / np.where(time > 0, time, 1.0), 0.0)
    apart = np.zeros(len(here))
    for name in ("xyz", "abc") if "abc" in rows.dtype.names else ("xyz",):
        place = rows[name]
        way = place[behind] - place[before]
        apart += ((place[here] - place[before] - share[:, None] * way) ** 2).sum(axis=1)
    apart = np.sqrt(apart)
    for name in ("rapid", "rests", "tool"):
        apart += _KIND_MM * (rows[name][here] != rows[name][behind])
    return apart + _LIMIT_MM * (rows["limit"][here] != rows["limit"][behind])


def lines(text, worst, most, about=50):
    """Return the lines of a text that stay, as pairs (first line, how many), and their bytes.

    Parameters
    ----------
    text : bytes
    worst : list of int
        Lines that stay with so many `about` them, the first ones if not all have room.
    most : int
        Bytes that stay at most. What the worst places leave of it, the program's begin has.
    """
    ends = _ends(text)
    stays, left = np.zeros(len(ends), bool), most
    for line in worst:
        span = np.arange(max(line - 1 - about, 0), min(line + about, len(ends)))
        span = span[~stays[span]]
        size = int(_sizes(ends, span).sum())
        if size <= left:
            stays[span], left = True, left - size
    begin = int(np.searchsorted(ends, most, "right"))
    others = np.flatnonzero(~stays[:begin])
    stays[others[np.cumsum(_sizes(ends, others)) <= left]] = True
    edges = np.flatnonzero(np.diff(stays.astype(np.int8), prepend=0, append=0)).reshape(-1, 2)
    begins = [int(ends[first - 1]) if first else 0 for first, _ in edges]
    spans = [(int(first) + 1, int(end - first)) for first, end in edges]
    kept = (text[at : ends[end - 1]] for at, (_, end) in zip(begins, edges, strict=True))
    return spans, b"".join(kept), len(ends)


def _ends(text):
    """Return where each line ends, behind its line feed."""
    bytes_of, step = np.frombuffer(text, np.uint8), 1 << 20
    found = [np.flatnonzero(bytes_of[at : at + step] == ord("\n")) + (at + 1)
             for at in range(0, len(text), step)]  # fmt: skip
    if text[-1:] != b"\n":
        found.append(np.array([len(text)]))
    return np.concatenate(found)


def _sizes(ends, lines):
    """Return the bytes of lines, by their numbers from 0."""
    return ends[lines] - np.where(lines > 0, ends[lines - 1], 0)
