# SPDX-License-Identifier: MIT
"""The lines of a text, without an object for each of them: programs are long."""

import bisect
import itertools

_PIECE = 1 << 20  # bytes that are looked at at a time


class Lines:
    """The lines of a text, ended by LF, CR LF or CR as the kernel counts them.

    Parameters
    ----------
    text : bytes

    Examples
    --------
    >>> lines = Lines(b"G21\\r\\nG1 X5\\n")
    >>> lines[2], lines[3], len(lines)
    (b'G1 X5', b'', 2)
    """

    def __init__(self, text):
        self._text, self._begins, self._firsts = text, [0], [1]  # of pieces: place, first line

    def __getitem__(self, number):
        """Return a line, counted from 1, without its end; nothing where there is none."""
        while self._firsts[-1] <= number and self._begins[-1] < len(self._text):
            self._read_on()
        piece = bisect.bisect(self._firsts, number) - 1
        if not 0 <= piece < len(self._begins) - 1:
            return b""
        some = self._text[self._begins[piece] : self._begins[piece + 1]].splitlines()
        return some[number - self._firsts[piece]]

    def __len__(self):
        self._read_all()
        return self._firsts[-1] - 1

    def __iter__(self):
        self._read_all()
        for begin, end in itertools.pairwise(self._begins):
            yield from self._text[begin:end].splitlines()

    def _read_all(self):
        while self._begins[-1] < len(self._text):
            self._read_on()

    def _read_on(self):
        """Take in the next piece of the text, up to a line end."""
        text, begin = self._text, self._begins[-1]
        end = text.find(b"\n", begin + _PIECE) + 1 or len(text)
        ends = sum(text.count(mark, begin, end) for mark in (b"\n", b"\r"))
        ends -= text.count(b"\r\n", begin, end)
        is_open = text[end - 1 : end] not in (b"\n", b"\r")  # the text's last line has no end
        self._begins.append(end)
        self._firsts.append(self._firsts[-1] + ends + is_open)
