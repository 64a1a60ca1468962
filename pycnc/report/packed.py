# SPDX-License-Identifier: MIT
"""Columns of numbers for a page, made small as they come: nothing is kept but what the page needs.

    pieces of numbers ─▶ small differences ─▶ deflate, one stream for each column ─▶ one gzip

Streams of deflate that end on a whole byte may stand behind one another: the whole is one stream.
"""

import struct
import zlib

import numpy as np

_LEVELS = 65535  # of a speed
_ESCAPE = -32768  # stands for a difference that 16 bits do not hold
_LEVEL, _RAW = 6, -zlib.MAX_WBITS
_HEAD = b"\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\xff"  # gzip: deflate, no name, no time
_END = b"\x03\x00"  # of deflate: a last block, empty
_PIECE = 1 << 20  # bytes that are looked at at a time; of a whole number of doubles


class Stream:
    """Bytes that come piece by piece and are kept compressed.

    Attributes
    ----------
    size, kept : int
        How many have come, and how many are kept for them up to now.
    """

    def __init__(self, level=_LEVEL):
        self._packer, self._pieces = zlib.compressobj(level, wbits=_RAW), []
        self.size = self.kept = 0

    def add(self, data):
        """Take the next bytes."""
        self.size += len(data)
        self._pieces.append(self._packer.compress(data))
        self.kept += len(self._pieces[-1])

    def packed(self):
        """Return pieces of deflate, without a last block: called when all has come."""
        if self._packer:
            self._pieces.append(self._packer.flush(zlib.Z_FULL_FLUSH))
            self.kept += len(self._pieces[-1])
            self._packer = None
        return self._pieces

    @staticmethod
    def unpacked(packed):
        """Yield the bytes of what `packed` gives, in pieces."""
        unpacker = zlib.decompressobj(wbits=_RAW)
        for piece in packed:
            data = unpacker.decompress(piece, _PIECE)
            while data:
                yield data
                data = unpacker.decompress(unpacker.unconsumed_tail, _PIECE)


class Columns:
    """Columns of numbers as bytes, and where each of them lies.

    A column is one call with all of its numbers, or several with pieces of them.
    """

    def __init__(self):
        self._columns, self._last = {}, {}

    @property
    def packed(self):
        """How many bytes are kept up to now."""
        return sum(stream.kept for streams, _ in self._columns.values() for stream in streams)

    def close(self):
        """Pack what still waits, of the columns that are there: all of their numbers have come."""
        for streams, _ in self._columns.values():
            for stream in streams:
                stream.packed()

    def drop(self, name):
        """Forget a column, and what stands beside its steps."""
        for each in (name, f"{name}+"):
            self._columns.pop(each, None)
        self._last.pop(name, None)

    def _streams(self, name, kind, count, **facts):
        """Return the streams of a column, which stand behind one another."""
        if name not in self._columns:
            self._columns[name] = ([Stream() for _ in range(count)], {"kind": kind, **facts})
        return self._columns[name][0]

    def bytes(self, name, data, most):
        """Add bytes as they are, all of them or till more than `most` are kept.

        Returns how many were added, and how many are kept for them.
        """
        (stream,) = self._streams(name, "u1", 1)
        for begin in range(0, len(data), _PIECE):
            stream.add(data[begin : begin + _PIECE])
            if stream.kept > most:
                break
        stream.packed()
        return stream.size, stream.kept

    def numbers(self, name, array):
        """Add numbers of 1, 2 or 4 bytes as they are."""
        (stream,) = self._streams(name, array.dtype.str[1:], 1)
        stream.add(array.astype(array.dtype.newbyteorder("<")).tobytes())

    def levels(self, name, array, most):
        """Add numbers from 0 to `most` in 65,536 levels: differences modulo 65,536."""
        levels = np.rint(array * (_LEVELS / most)).astype(np.int64)
        planes = self._streams(name, "levels", 2, quantum=most / _LEVELS)
        _add_planes(planes, self._change(name, levels).astype(np.uint16))

    def steps(self, name, array, quantum=1.0):
        """Add whole numbers: differences of 16 bits, those that need more beside them."""
        change = self._change(name, array.astype(np.int64))
        large = np.abs(change) > -_ESCAPE - 1
        small = np.where(large, _ESCAPE, change).astype(np.int16)
        _add_planes(self._streams(name, "steps", 2, quantum=quantum), small.view(np.uint16))
        (beside,) = self._streams(f"{name}+", "f8", 1)
        beside.add(change[large].astype("<f8").tobytes())

    def _change(self, name, numbers):
        change = np.diff(numbers, prepend=self._last.get(name, 0))
        if len(numbers):
            self._last[name] = numbers[-1]
        return change

    def told(self):
        """Return name → where a column lies, and what is to be known to read it."""
        places, at = {}, 0
        for name, (streams, facts) in self._columns.items():
            size = sum(stream.size for stream in streams)
            places[name] = {**facts, "at": at, "size": size}
            at += size
        return places

    def gzip(self):
        """Yield the bytes of all columns as one gzip, in pieces: called once."""
        yield _HEAD
        crc, size = 0, 0
        for streams, _ in self._columns.values():
            for stream in streams:
                packed = stream.packed()
                for data in Stream.unpacked(packed):
                    crc = zlib.crc32(data, crc)
                size += stream.size
                yield from packed
        yield _END + struct.pack("<2I", crc, size & 0xFFFFFFFF)


def _add_planes(streams, array):
    """Add 16 bit numbers as low bytes and high ones, apart: these compress better."""
    low, high = streams
    low.add((array & 255).astype(np.uint8).tobytes())
    high.add((array >> 8).astype(np.uint8).tobytes())


class Waiting:
    """Numbers whose largest one is to be known before they become a column."""

    def __init__(self):
        self._stream, self.most = Stream(level=1), 0.0

    @property
    def packed(self):
        """How many bytes are kept up to now."""
        return self._stream.kept

    def add(self, array):
        """Take the next numbers."""
        numbers = array.astype("<f4")
        self.most = max(self.most, float(numbers.max(initial=0.0)))
        self._stream.add(numbers.tobytes())

    def pieces(self):
        """Yield all numbers again, in pieces: called once."""
        left = b""
        for data in Stream.unpacked(self._stream.packed()):
            data = left + data
            whole = len(data) // 4 * 4
            left = data[whole:]
            yield np.frombuffer(data[:whole], "<f4")
