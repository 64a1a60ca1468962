# SPDX-License-Identifier: MIT
"""The columns of a page: the points and low points of a plan, and the program's text.

    points as they come ─┬─▶ columns of all of them ─── too large? ─┬─ no ──▶ the page's
                         └─▶ some number of them ───────────────────┴─ yes ─▶ thinned till they fit
"""

import numpy as np

from pycnc.kernel import Blocks
from pycnc.machine.schema import ROTARY_AXES
from pycnc.report import thinned
from pycnc.report.packed import Columns, Waiting
from pycnc.report.turning import Turning, turns

PLACE_MM = 1e-3  # positions are told in steps of so much
TIME_S = 1e-6  # and times
PATH_MOST, TEXT_MOST = 3_400_000, 1_200_000  # packed bytes of a page: with what is felt 7 MB
_POINTS = 1 << 18  # that stay of a path which is larger, and a quarter less till it fits
_RAPID, _RESTS = 32, 64  # bits beside the limit in the column "code"


class Path:
    """The columns of points and low points, packed as they come."""

    def __init__(self, turning):
        self.columns, self._v, self._feed = Columns(), Waiting(), Waiting()
        self._turning = turning

    @property
    def packed(self):
        """How many bytes the columns have up to now."""
        return self.columns.packed + self._v.packed + self._feed.packed

    def add(self, points, feet):
        """Take the next rows of dtypes ``nck_host_point_t`` and ``nck_host_foot_t``."""
        columns, low = self.columns, feet["low"]
        self._add_places(points)
        columns.steps("t", np.rint(points["t"] / TIME_S), TIME_S)
        self._v.add(points["v"])
        self._feed.add(points["feed"])
        columns.steps("line", points["line"])
        columns.steps("tool", points["tool"])
        columns.numbers("code", points["limit"] + _RAPID * points["rapid"]
                        + _RESTS * points["rests"])  # fmt: skip
        columns.steps("foot_first", feet["first"])
        columns.steps("foot_at", feet["at"])
        columns.steps("foot_line", low["line"])
        for name in ("limit", "ends", "axis"):
            columns.numbers(f"foot_{name}", low[name].astype(np.uint8))
        columns.numbers("foot_angle", np.degrees(low["angle"]).astype(np.float32))
        columns.numbers("foot_lost", low["lost_s"].astype(np.float32))

    def _add_places(self, points):
        """Add the places on the part; of a program that turns, those of the axes too."""
        columns, steps = self.columns, np.rint(points["xyz"] / PLACE_MM)
        if self._turning and self._turning.axes:
            for k, letter in enumerate("xyz"):
                columns.steps(f"axis_{letter}", steps[:, k], PLACE_MM)
            angles = points["abc"].astype(np.float32)
            for k in self._turning.axes:
                columns.steps(f"axis_{ROTARY_AXES[k]}", np.rint(angles[:, k] / PLACE_MM), PLACE_MM)
            places = self._turning.on_part(steps * PLACE_MM, angles, points["line"])
            steps = np.rint(places / PLACE_MM)
        for k, letter in enumerate("xyz"):
            columns.steps(letter, steps[:, k], PLACE_MM)

    def finish(self):
        """Add what waited for its largest number: called once."""
        most = max(self._v.most, self._feed.most, 1e-9)
        for name, waiting in (("v", self._v), ("feed", self._feed)):
            for piece in waiting.pieces():
                self.columns.levels(name, piece, most)
        self.columns.close()


class Trail:
    """The points and low points of a plan become columns as they come.

    Attributes
    ----------
    turned : list of str
        The rotary axes that turn.
    """

    def __init__(self, program):
        self._turning = Turning(program) if turns(program.machine) else None
        self.turned = [ROTARY_AXES[k] for k in self._turning.axes] if self._turning else []
        self._come = {"points": 0, "feet": 0}
        self._whole, self._some = Path(self._turning), thinned.Points(_POINTS, bool(self.turned))

    def add(self, points, feet):
        """Take the next rows of dtypes ``nck_host_point_t`` and ``nck_host_foot_t``."""
        self._come["points"] += len(points)
        self._come["feet"] += len(feet)
        self._some.add(points, feet)
        if self._whole:
            self._whole.add(points, feet)
            if self._whole.packed > PATH_MOST:
                self._whole = None

    def columns(self, text, worst):
        """Return all columns, with the program's text, and what is to be known of them.

        Called once. worst: lines whose text stays, the most important one first.
        """
        path, facts = self._whole, dict(self._come)
        if not path or _finished(path) > PATH_MOST:
            path, facts = self._thinned()
        told = _add_text(path.columns, b"" if isinstance(text, Blocks) else text, worst)
        return path.columns, facts | told

    def _thinned(self):
        """Return a path of as many points as have room, and what is told of it."""
        most = _POINTS
        while True:
            self._some.thin(most)
            path, feet = Path(self._turning), self._some.placed()
            path.add(self._some.rows, feet)
            if _finished(path) <= PATH_MOST:
                break
            most = most * 3 // 4
        shown = {"points": len(self._some.rows), "feet": len(feet)}
        return path, shown if shown == self._come else shown | {"all": self._come}


def _finished(path):
    path.finish()
    return path.columns.packed


def _add_text(columns, text, worst):
    """Add the text to the columns, and return what is told of it if lines are left out."""
    size, packed = columns.bytes("text", text, TEXT_MOST)
    if packed <= TEXT_MOST:
        return {}
    while True:
        size = size * TEXT_MOST // packed
        columns.drop("text")
        spans, kept, count = thinned.lines(text, worst, size)
        _, packed = columns.bytes("text", kept, TEXT_MOST)
        if packed <= TEXT_MOST:
            return {"spans": spans, "lines": count}
