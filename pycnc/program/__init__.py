# SPDX-License-Identifier: MIT
"""A program: NC text, decoded whole for one machine."""

import hashlib

from pycnc import errors, files, kernel
from pycnc.program import folder, guess, kind, limits, moves, remarks, zero
from pycnc.program.diagnostics import Diagnostic, Diagnostics, Wording
from pycnc.program.geometry import Moves
from pycnc.program.lines import Lines
from pycnc.program.shown import facts_table
from pycnc.machine import DEFAULT, Machine
from pycnc.machine.rows import DIALECTS
from pycnc.machine.schema import AXES, unit_of
from pycnc.kernel.bind import lib
from pycnc.kernel.records import copied, join

_PIECE = 16384  # blocks that are looked at at a time


def _line_of_end(blocks, before):
    """Return the line that ends a program, which may be among the next blocks."""
    ends = blocks["line"][blocks["kind"] == lib.NCK_BLOCK_END]
    return int(ends[0]) if len(ends) and not before else before


class Program:
    """NC text, or geometry without text, and what it means on a machine.

    Attributes
    ----------
    file : str
        Where the text came from.
    text : bytes
        Of a program without text: the bytes of its moves (`kernel.Blocks`).
    lines : Lines
        Of the text; none of a program without text.
    machine : Machine
    blocks : numpy.ndarray
        Of dtype ``nck_block_t``; None if the program was only checked.
    diagnostics : Diagnostics
        Everything that was found, errors and notes.
    block_count : int
    tolerance_most_mm : float
        The largest tolerance in force anywhere.
    has_threads : bool
        Whether there are passes of threads, or taps.

    `beside` is a `planning.pipeline.Pipeline`, which plans what has been read so far meanwhile.
    """

    def __init__(self, text, machine, *, file="<text>", keep=True, progress=None, beside=None):
        self.text = text if isinstance(text, bytes) else bytes(text)
        self.lines = Lines(b"" if isinstance(self.text, kernel.Blocks) else self.text)
        self.file, self.diagnostics, self.block_count = file, Diagnostics(), 0
        self.machine = machine = self._choose_dialect(machine)
        if machine.settings.dialect.programs and not isinstance(self.text, kernel.Blocks):
            self._join_programs()
        self._veil(machine)
        if not isinstance(self.text, kernel.Blocks):
            self.machine = machine = zero.further(self.text, machine)
        if machine.settings.work.zero == "unknown":
            self.machine = self._lay_travel(machine)
        self.tolerance_most_mm, self.has_threads, self._end = 0.0, False, 0
        kept = self._decode(keep, progress, beside)
        self.blocks = join("nck_block_t", kept) if keep else None
        self._moves = None
        if not isinstance(self.text, kernel.Blocks):
            self._tell_kind()
            self._tell_remarks()

    def _decode(self, keep, progress, beside):
        """Go through the text once; return arrays of its blocks, if they are kept."""
        machine, kept = self.machine, []
        wording = Wording(self.file, self.lines, machine, self._places())
        another = beside.another if beside else None
        for blocks, findings, used in kernel.decode(self.text, machine, another):
            wording.add(self.diagnostics, limits.heard(findings, machine))
            self.block_count += len(blocks)
            most = blocks["tolerance_mm"].max(initial=0.0)
            self.tolerance_most_mm = max(self.tolerance_most_mm, float(most))
            self.has_threads = self.has_threads or kernel.has_threads(blocks)
            if keep:
                kept.append(copied(blocks))
            if beside:
                beside.take(machine, blocks, used)
            if progress:
                progress(used, len(self.text))
            self._end = _line_of_end(blocks, self._end)
        return kept

    def _places(self):
        """Return where the lines of programs of other files begin."""
        plain = isinstance(self.text, kernel.Blocks) or not self.machine.settings.dialect.programs
        return [] if plain else folder.places(self.text)

    def _tell_kind(self):
        """Say in one line what the text is for, in place of what all its strange words are."""
        seen = kind.kind_of(self.text, self.machine)
        if not seen or (seen.cures and not seen.cures & set(self.diagnostics.counts)):
            return
        found = seen.source.decode("utf-8", "replace")[:40]
        self.diagnostics.lead(
            Diagnostic(
                self.file, seen.line, 0, "looks-like", "note", f"looks like {seen.name}: {found}",
                f"pycnc time {self.file} {seen.options}", self.lines[seen.line],
            ),
            seen.cures,
        )  # fmt: skip

    def _tell_remarks(self):
        """Tell what the program says to its operator."""
        for line, column, words in remarks.found(self.text, self.machine, self._end):
            source = self.lines[line]
            self.diagnostics.add(
                Diagnostic(self.file, line, column, "remark", "note", words, "", source)
            )

    def _join_programs(self):
        """Put the programs of the machine's folder that the text calls behind it."""
        dialect = self.machine.settings.dialect
        try:
            self.text = folder.joined(self.text, dialect.programs, dialect.base)
        except (folder.FolderError, OSError) as cause:
            self.diagnostics.add(
                Diagnostic(self.file, 0, 0, "programs", "error", str(cause),
                           "--programs takes a folder of files such as O9000.nc or name.ngc")
            )  # fmt: skip
        self.lines = Lines(self.text)

    def _veil(self, machine):
        """Hide what the machine's control would do beside motion; tell of each kind once."""
        self.text, findings = limits.veil(self.text, machine)
        for line, name, macro, count in findings:
            message, remedy = limits.words_of(name, macro, count)
            severity = "note" if name == "macro-still" else "warning"
            source = self.lines[line]
            self.diagnostics.add(
                Diagnostic(self.file, line, 0, name, severity, message, remedy, source)
            )

    def _lay_travel(self, machine):
        """Return the machine with its travel where the program needs it; tell once if it fits."""
        placed = zero.place(self.text, machine)
        if placed.message:
            self.diagnostics.add(
                Diagnostic(self.file, placed.line, 0, placed.identity, placed.severity,
                           placed.message, placed.remedy, self.lines[placed.line])
            )  # fmt: skip
        return placed.machine

    def _choose_dialect(self, machine):
        """Return the machine; if it leaves the dialect to the text, with that of the text."""
        if machine.settings.dialect.base != "auto":
            return machine
        dialect, line, reason = guess.dialect_of(self.text)
        source = self.lines[line]
        self.diagnostics.add(
            Diagnostic(
                self.file, line, 0, "dialect-auto", "note", f"read as {dialect}: {reason}",
                f"if that is wrong: --dialect {' or '.join(sorted(DIALECTS - {dialect}))}", source,
            )
        )  # fmt: skip
        return Machine.load(machine, dialect=dialect)

    @classmethod
    def from_points(cls, points, feed, machine=DEFAULT, *, tolerance=None):
        """Make a program of straight moves from point to point.

        Parameters
        ----------
        points : array_like
            (n, k) coordinates on the machine's first k axes, in the order X Y Z A B C U V W, from
            the program's zero [mm, deg]. The first point is gone to as a rapid.
        feed : float or array_like
            One for all moves, or (n,): `feed[i]` is that of the move to point i [mm/min].
        machine : str, path or Machine
        tolerance : float, optional
            How far the path may leave the points' polygon [mm]; 0: the exact path; without it the
            machine's own (``path.tolerance_mm``).

        Returns
        -------
        Program
            The move to point i is line i + 1 in traces, plans and diagnostics.

        Examples
        --------
        >>> program = Program.from_points([[0, 0], [10, 0], [10, 5]], feed=600, tolerance=0.01)
        >>> program.length_mm
        15.0
        """
        machine = Machine.load(machine)
        rows = moves.of_points(points, feed, machine.axes, tolerance)
        return cls(kernel.Blocks(rows.tobytes()), machine, file="<points>")

    @classmethod
    def from_moves(cls, sequence, machine=DEFAULT):
        """Make a program of moves of all kinds.

        Parameters
        ----------
        sequence : iterable of dict, or numpy.ndarray
            Each with a ``kind`` and the keys below; or rows of dtype ``nck_block_in_t``.
        machine : str, path or Machine

        Returns
        -------
        Program
            A move's line in traces, plans and diagnostics is its ``id``, else its place, from 1.

        Notes
        -----
        "rapid" and "line" take x y z a b c u v w, the target [mm, deg]; an axis without one stays.
        "arc" also takes ``centre``, two coordinates along the plane's axes [mm]; ``turns``, how
        often the target is passed, + anticlockwise, − clockwise; ``plane``, 17 (XY), 18 or 19.
        "dwell" takes ``seconds``, "m" ``code``, "s" ``rpm``, "t" ``number``; "set" sets what
        follows. Every kind takes ``feed`` with ``feed_mode`` ("per_minute", "inverse", "per_rev"),
        ``path`` ("exact", "stop") or ``tolerance`` [mm], which stay in force, and ``id``. A number
        outside of its range is an ``ArgumentError`` with the move's place.

        Examples
        --------
        >>> program = Program.from_moves([
        ...     {"kind": "rapid", "x": 0, "y": 0},
        ...     {"kind": "line", "x": 10, "feed": 600, "tolerance": 0.01},
        ...     {"kind": "arc", "x": 10, "y": 8, "centre": (10, 4), "turns": 1},
        ... ])
        >>> len(program.blocks)
        4
        """
        rows = moves.rows_of(sequence)
        return cls(kernel.Blocks(rows.tobytes()), Machine.load(machine), file="<moves>")

    @property
    def end_line(self):
        """The last line that is executed: the one with M2 or M30, else the text's last one."""
        return self._end or len(self.lines) or self.block_count

    @property
    def sha256(self):
        """Hash of the text."""
        return hashlib.sha256(getattr(self.text, "original", self.text)).hexdigest()

    def pieces(self, another=None):
        """Yield the blocks in pieces, again from the text if they were not kept.

        A piece stands until the next one is asked for. another: as `kernel.decode` takes it, for
        blocks that were not kept.
        """
        if self.blocks is not None:
            for begin in range(0, len(self.blocks), _PIECE):
                yield self.blocks[begin : begin + _PIECE]
            return
        for blocks, _, _ in kernel.decode(self.text, self.machine, another):
            yield blocks

    @property
    def moves(self):
        """Where the moves run, as `geometry.Moves`."""
        if self._moves is None:
            self._moves = Moves(self.blocks, self.machine)
        return self._moves

    @property
    def bounds(self):
        """Axis letter → (smallest, largest) machine coordinate of all moves [mm, deg]."""
        low, high = self.moves.bounds()
        order = {letter: AXES.index(letter) for letter in self.machine.axes}
        return {letter: (float(low[k]), float(high[k])) for letter, k in order.items()}

    @property
    def length_mm(self):
        """Length of all moves [mm]; a degree counts as a millimetre."""
        return self.moves.length()

    def check(self):
        """Return the program if it has no error.

        Raises
        ------
        ProgramError
            At the first error, with its line and column.
        """
        for finding in self.diagnostics:
            if finding.severity == "error":
                raise errors.ProgramError(
                    finding.text(), id=finding.id, line=finding.line, column=finding.col
                )
        return self

    def _facts(self):
        yield "file", self.file
        yield "machine", self.machine.name
        yield "blocks", f"{self.block_count:,}"
        yield "errors", str(self.diagnostics.errors)
        if self.blocks is not None:
            yield "length", f"{self.length_mm:.1f} mm"
            for letter, (low, high) in self.bounds.items():
                yield letter.upper(), f"{low:.3f} … {high:.3f} {unit_of(letter)}"

    def __repr__(self):
        return "<Program " + ", ".join(f"{name} {value}" for name, value in self._facts()) + ">"

    def _repr_html_(self):
        return facts_table(self._facts())


def read_text(path_or_text):
    """Return (name, bytes) of a program: a path, or the text itself.

    bytes, and a str with a line end in it, are text; any other str is a path.
    """
    if isinstance(path_or_text, bytes | bytearray | memoryview):
        return "<text>", bytes(path_or_text)
    if isinstance(path_or_text, str) and "\n" in path_or_text:
        return "<text>", path_or_text.encode()
    return str(path_or_text), files.read(path_or_text)


def load(path_or_text, machine=DEFAULT, dialect=None):
    """Load a program and decode it whole.

    Parameters
    ----------
    path_or_text : path, str or bytes
        A file; or the text: bytes, or a str with a line end in it.
    machine : str, path or Machine
        Name of a shipped machine, a machine file, or a machine.
    dialect : {"linuxcnc", "fanuc", "grbl", "marlin", "auto"}, optional
        Replaces the machine's; "auto": as the text looks, which a note tells.

    Returns
    -------
    Program
        Errors of the text are in its `diagnostics`; `Program.check` raises them.

    Raises
    ------
    OSError
        If the file cannot be read.
    MachineFileError

    Examples
    --------
    >>> program = load("G21 G90 G1 X10 F600\\nM2\\n", machine="mill3")
    >>> program.length_mm
    10.0
    """
    file, text = read_text(path_or_text)
    return Program(text, Machine.load(machine, dialect=dialect), file=file)
