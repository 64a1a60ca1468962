# SPDX-License-Identifier: MIT
"""From where to where a program goes, from its zero: also where nobody knows where it begins.

A program begins at its zero. What it needs has that place in it along an axis that cuts first;
a rapid comes from anywhere.
"""

from decimal import Decimal
from typing import NamedTuple

import numpy as np

from pycnc import kernel
from pycnc.kernel.bind import lib
from pycnc.kernel.records import copied, join
from pycnc.machine.schema import AXES
from pycnc.program.geometry import Moves, is_move

_SAME = 1e-6  # mm: the kernel counts nanometres


class _Piece(NamedTuple):
    """Blocks of a program, the last machine's; the places of all, from the zero of each."""

    rows: np.ndarray
    moves: Moves
    owners: np.ndarray  # the block of each place
    places: list
    has_errors: bool  # on the first machine; or the moves of another are others


class Reach:
    """The places of a program along every axis, from its zero [mm, deg].

    Attributes
    ----------
    low, high : numpy.ndarray
        Of the places that move with the work; low is above high where there are none.
    cuts : numpy.ndarray
        Whether the first motion along an axis is no rapid: it begins where the program does.
    has_errors : bool
        Whether not all of its places are known: the text is wrong somewhere, or its moves are
        others where the zero is another.
    """

    def __init__(self):
        self.has_errors = False
        self.low, self.high = np.full(len(AXES), np.inf), np.full(len(AXES), -np.inf)
        self.cuts, self._moved = np.zeros(len(AXES), bool), np.zeros(len(AXES), bool)

    def take(self, points, is_work):
        """Take the places of a piece."""
        low = np.where(is_work, points, np.inf).min(axis=0, initial=np.inf)
        high = np.where(is_work, points, -np.inf).max(axis=0, initial=-np.inf)
        self.low, self.high = np.minimum(self.low, low), np.maximum(self.high, high)

    def begin(self, rows, moves):
        """See which axes a piece moves first, and whether it cuts then."""
        if self._moved.all() or not len(rows):
            return
        moved = (np.abs(moves.end - moves.start) > _SAME) & is_move(rows)[:, None]
        new = moved.any(axis=0) & ~self._moved
        kinds = rows["kind"][moved.argmax(axis=0)]
        self.cuts |= new & (kinds != lib.NCK_BLOCK_RAPID)
        self._moved |= new

    def need(self, letter, with_zero):
        """Return from where to where a program goes along an axis; nowhere: (0, 0)."""
        k = AXES.index(letter)
        if self.low[k] > self.high[k]:
            return Decimal(0), Decimal(0)
        down, up = (round(Decimal(float(end[k])), 6) for end in (self.low, self.high))
        return (min(down, Decimal(0)), max(up, Decimal(0))) if with_zero else (down, up)


class Free(Reach):
    """The places of a program that do not hang on where it begins.

    Attributes
    ----------
    hangs : numpy.ndarray
        Whether places along an axis do, but for the one where it begins.
    first : dict
        Index of an axis → (the first place that does not, whether it is the work's).
    """

    def __init__(self, off):
        super().__init__()
        self.hangs, self.first, self._off = np.zeros(len(AXES), bool), {}, off

    def sort(self, points, shifted, is_work):
        """Take the places of a piece, and those of the same that begins `off` beside its zero."""
        own = np.abs(points - shifted) < _SAME
        begun = (np.abs(points) < _SAME) & (np.abs(shifted - self._off) < _SAME)
        self.hangs |= (~own & ~begun).any(axis=0)
        for k in np.flatnonzero(own.any(axis=0)):
            row = own[:, k].argmax()
            self.first.setdefault(int(k), (float(points[row, k]), bool(is_work[row, k])))
        self.take(points, is_work & own)


def reach_of(text, machines, zeros):
    """Return the `Reach` of a program whose zero is tried at one place or two."""
    found = Reach()
    for piece in _corners(text, machines, zeros):
        found.has_errors |= piece.has_errors
        found.begin(piece.rows, piece.moves)
        found.take(piece.places[0], _is_work(piece.places))
    return found


def free_reach_of(text, machines, zeros, off):
    """Return the `Free` reach of a program; of the machines the last begins `off` beside."""
    found = Free(off)
    for piece in _corners(text, machines, zeros):
        found.hangs |= piece.has_errors
        found.begin(piece.rows, piece.moves)
        found.sort(piece.places[0], piece.places[-1], _is_work(piece.places[:-1]))
    return found


def line_beyond(text, machine, zero, letter, room, begin):
    """Return the first line by which a program is wider than its room along an axis; 0: none.

    begin: the places that it is at before; none, or one.
    """
    k, low, high = AXES.index(letter), min(begin, default=np.inf), max(begin, default=-np.inf)
    for piece in _corners(text, [machine], [zero]):
        order = np.argsort(piece.owners, kind="stable")
        at = piece.places[0][order, k]
        lows = np.minimum.accumulate(np.concatenate([[low], at]))
        highs = np.maximum.accumulate(np.concatenate([[high], at]))
        beyond = np.flatnonzero(highs - lows > room + _SAME)
        if beyond.size:
            return int(piece.rows["line"][piece.owners[order][max(beyond[0] - 1, 0)]])
        low, high = lows[-1], highs[-1]
    return 0


def _is_work(places):
    same = np.ones(places[0].shape, bool)
    for points in places[1:]:
        same &= np.abs(points - places[0]) < _SAME
    return same


def _corners(text, machines, zeros):
    """Yield the pieces of a program that is decoded for several machines, as `_Piece`."""
    before = [None] * len(machines)
    for pieces in zip(*(kernel.decode(text, each) for each in machines), strict=False):
        places, wrong = [], []
        for k, (blocks, findings, _) in enumerate(pieces):
            begun = before[k] is not None
            rows = copied(blocks)
            if begun:
                rows = join("nck_block_t", [before[k], rows])
            moves = Moves(rows, machines[k])
            points, owners = moves.corners()
            new = owners >= int(begun)
            places.append(points[new] - zeros[k])
            wrong.append(bool((findings["code"] < 0).any()))
            before[k] = _last_move(rows)
        if len({len(points) for points in places}) > 1:  # where they part nothing is known
            yield _Piece(rows[:0], moves, owners[:0], [points[:0] for points in places], True)
            return
        yield _Piece(rows, moves, owners[new], places, wrong[0])


def _last_move(rows):
    """Return the last block that moves, where the next piece begins; None: none yet."""
    moves = np.flatnonzero(is_move(rows))
    return rows[moves[-1] : moves[-1] + 1] if moves.size else None
