# SPDX-License-Identifier: MIT
"""Is a program that begins at a line in the middle the tail of the whole one? Judged by its blocks
and, to the last tick, by where the axes are; and by the way in. Nothing here asks the kernel how it
enters.

    python tests/decode/entering.py                # the cases and the corpus, 200 lines of each
    python tests/decode/entering.py --family mill --seeds 0 +100  # or of all families

Prints what is wrong, and how many lines were entered; exit 1 if anything is.
"""

import argparse
import functools
import re
import sys
from dataclasses import dataclass
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))

import cases
import entering_families
import numpy as np

from pycnc.kernel import Simulation
from pycnc.kernel.bind import lib
from pycnc.kernel.records import counts_per_unit
from pycnc.machine import Machine
from pycnc.machine.schema import AXES
from pycnc.program import Program

NEAR_MM = 2e-3  # of two runs beside their tolerances: chords of arcs
SAME_S_MM = 1e-7  # path coordinates so near are one
SPUN_MM = 0.05  # of two passes: they meet the spindle at other moments of their periods
PERIOD_MS = 5  # nobody waits for ticks either; a corner passed within one is a² T² / 2 wide
PLACE_NM = 0  # where a program ends it ends to the bit
LONG = 200  # lines of a long program that are entered
MOVES = (lib.NCK_BLOCK_RAPID, lib.NCK_BLOCK_LINE, lib.NCK_BLOCK_ARC)
SPUN = (lib.NCK_SEG_THREAD, lib.NCK_SEG_TAP)  # in step with the spindle: on no path coordinate
SLOW = {"ax4_rotation_51k.nc", "print_cura_bp_case_56k.gcode"}  # some minutes of ticks each
TOO_FAR = "corner"  # drawn edges may turn in too far for a ,R or ,C: then nobody enters
FEED = 6000  # of the way in [mm/min]: no test waits for it


@dataclass
class Run:
    """A program, decoded and run."""

    program: Program
    rows: np.ndarray

    @classmethod
    def of(cls, text, machine):
        program = Program(text, machine)
        if program.diagnostics.errors:
            return cls(program, None)
        simulation = Simulation(text, machine, commands=[(0, "override", 200, 100)])
        pieces = [rows.copy() for rows, _ in simulation.pieces() if len(rows)]
        return cls(program, np.concatenate(pieces) if pieces else None)

    @property
    def errors(self):
        return [each for each in self.program.diagnostics if each.severity == "error"]

    @property
    def blocks(self):
        return self.program.blocks


def machine_of(case, *more):
    """Return the machine of a case, with a height for the way in where its travel is free."""
    machine = Machine.load(case.machine, set=case.set)
    axis = machine.settings.axis.present().get(letter_of(machine))
    height = ["approach.height_mm=500"] if axis is not None and axis.max_mm is None else []
    quick = f"approach.feed_mm_min={FEED}", f"kernel.period_ms={PERIOD_MS}"
    return Machine.load(case.machine, set=[*quick, *height, *case.set, *more])


def letter_of(machine):
    """Return the axis that leaves the work first, by what docs/machine.md says of it."""
    settings = machine.settings
    lathe = settings.kinematics.type == "lathe_xz"
    return settings.approach.axis or ("x" if lathe else "z")


@functools.cache
def whole_of(case):
    """Return the run of a whole case."""
    return Run.of(bytes_of(case), machine_of(case))


def bytes_of(case):
    """Return the text of a case or of a file of the corpus."""
    return case.path.read_bytes() if hasattr(case, "path") else case.text.encode()


def without_comments(text):
    """Return a program without what stands in brackets or behind a semicolon, line by line."""
    return re.sub(rb"\([^)\n]*\)?|;[^\n]*", b" ", text)


def findings(case, line):
    """Return what is wrong with a case that begins at a line: a list of texts."""
    whole = whole_of(case)
    if whole.errors and whole.errors[0].id == TOO_FAR:
        return []
    if whole.errors:
        return [f"the whole program: {whole.errors[0].id}"]
    return Entered(case, line, whole).findings()


class Entered:
    """A case that is entered at a line, beside the run of the whole one."""

    def __init__(self, case, line, whole):
        self.line, self.whole = line, whole
        self.machine = machine_of(case, f"dialect.from_line={line}")
        self.run = Run.of(bytes_of(case), self.machine)
        self.lines = without_comments(self.run.program.text).upper().split(b"\n")
        self.counts = counts_per_unit(self.machine.record["axis"]["rotary"])
        self.prints = self.machine.settings.dialect.base == "marlin"
        self.counted = slice(0, 6 if self.prints else 9)  # of the axes: U is an extruder

    def findings(self):
        if self.run.errors:
            return self._refused(self.run.errors[0])
        self.count = self._common()
        self.first = len(self.whole.blocks) - self.count
        self.entry = self.run.blocks[: len(self.run.blocks) - self.count]
        return [*self._begin(), *self._way(), *self._end(), *self._path()]

    def _refused(self, error):
        """A line of a loop or subprogram, or behind the program's end, may be refused that no pass
        comes to, and with words."""
        reached = (self.whole.blocks["line"] == self.line).any()
        apart = self._is_inside() or self._is_behind()
        if error.id == "label-missing" and not reached and apart:
            return [] if error.help else ["refused without a remedy"]
        return [f"refused: {error.id} ({error.message})"]

    def _is_inside(self):
        """Something begins before the line that ends behind it, by the words of its lines."""
        begins = any(re.search(rb"SUB|WHILE|REPEAT|DO|^[O:] *\d+ *$", each.strip())
                     for each in self.lines[: self.line])  # fmt: skip
        rest = self.lines[self.line - 1 :]
        return begins and any(re.search(rb"END|WHILE|M99", each) for each in rest)

    def _is_behind(self):
        """The line stands behind an M2 or M30: only a call leads there; or behind all words."""
        before, rest = self.lines[: self.line - 1], self.lines[self.line - 1 :]
        ends = any(re.match(rb"[^(;]*M(0?2|30)(?!\d)", each) for each in before)
        return ends or not any(each.strip() for each in rest)

    def _bare(self, blocks):
        """Return blocks that can be compared: an extruder's places count from its last one."""
        bare = blocks.copy()
        if self.prints and len(bare):
            bare["target_nm"][:, AXES.index("u")] -= bare["target_nm"][-1, AXES.index("u")]
        return bare

    def _common(self):
        """Return how many blocks both have in common at their ends."""
        ours, theirs = self._bare(self.run.blocks), self._bare(self.whole.blocks)
        most = min(len(ours), len(theirs))
        differ = np.flatnonzero(ours[len(ours) - most :] != theirs[len(theirs) - most :])
        return most - (differ[-1] + 1 if len(differ) else 0)

    def _begin(self):
        """The tail begins with the first block of the line, or behind where it would stand."""
        lines = self.whole.blocks["line"]
        before, behind = lines[: self.first], lines[self.first :]
        if (before == self.line).any() and not self._is_contour():
            yield f"of the line {int((before == self.line).sum())} blocks are not executed"
        if (np.diff(lines.astype(np.int64)) >= 0).all():
            if (before >= self.line).any() and not self._is_of_sub():
                yield f"begins behind line {int(before.max())}"
            early = (behind < self.line).any() and not self._turns_back()
            if early and not self._is_whole(behind[0]):
                yield f"begins already at line {int(behind.min())}"

    def _turns_back(self):
        """The end of a loop or a subprogram at the line or behind it leads to earlier ones."""
        rest = self.lines[self.line - 1 :]
        return any(re.search(rb"\bEND[\dWRS]|GOTO|\bWHILE|M99", each) for each in rest)

    def _is_of_sub(self):
        """A line between O… sub and its endsub is come to behind the line that calls."""
        before = b"\n".join(self.lines[: self.line - 1])
        return len(re.findall(rb"O *(<[^>]*>|\d+) *SUB", before)) > before.count(b"ENDSUB")

    def _is_contour(self):
        """Lines of a contour move once more when it is finished."""
        return any(code in each for code in (b"G70", b"G71", b"G72") for each in self.lines)

    def _is_whole(self, line):
        """What several lines say together begins with the first of them."""
        words = b" ".join(self.lines[line - 1 : self.line])
        return any(code in words for code in (b"G5.", b"G6.2", b"G7", b",R", b",C", b"R", b"C"))

    def _way(self):
        """Away from the work first, across, and in at the feed: nothing else moves."""
        moves = self.entry[np.isin(self.entry["kind"], MOVES)]
        if (self.entry["line"] < self.line).any():
            yield "something of before the line is executed"
        if not len(moves):
            return
        letter = letter_of(self.machine)
        axis, places = AXES.index(letter), self._places(moves)
        away, across, inward = np.diff(places, axis=0)
        height = self.machine.settings.approach.height_mm
        if height is None and letter in self.machine.settings.axis.present():
            height = self.machine.settings.axis.present()[letter].max_mm
        high = max(places[0, axis], places[-1, axis], int((height or -1e6) * 1_000_000))
        others = np.arange(len(AXES)) != axis
        before = self._places(self.whole.blocks[: self.first])[-1]
        if (places[-1] != before)[self.counted].any():
            yield "the way in ends beside where the tail begins"
        if len(moves) != 3 or [int(kind) for kind in moves["kind"]] != [0, 0, 1]:
            yield f"the way in has moves {moves['kind'].tolist()}"
        if away[others].any() or across[axis] or inward[others].any():
            yield f"the way in is not away, across, in: {places.tolist()}"
        if letter in self.machine.settings.axis.present() and places[1, axis] != high:
            yield f"crosses at {places[1, axis]}, not at {high}"
        if inward[axis] > 0 or away[axis] < 0:
            yield "goes away where it should go in"
        if abs(float(moves["feed"][-1]) - FEED) > 1e-9 * FEED or moves["feed_mode"][-1] != 0:
            yield f"goes in at {moves['feed'][-1]}"

    def _places(self, blocks):
        """Return where the axes are from the start on, move by move [nm, ndeg]."""
        moves = blocks[np.isin(blocks["kind"], (*MOVES, lib.NCK_BLOCK_THREAD))]
        places = moves["target_nm"].astype(np.int64)
        places[:, :3] += moves["tool_nm"]
        return np.vstack([self.machine.record["start_nm"], places])

    def _end(self):
        """The last setpoints are those of the whole program."""
        ends = [run.rows["axes"]["joint_nm"][-1] if run.rows is not None else None
                for run in (self.run, self.whole)]  # fmt: skip
        if any(end is None for end in ends):
            return
        off = np.abs(ends[0] - ends[1])[: len(self.machine.axes) - self.prints]
        if off.max(initial=0) > PLACE_NM:
            yield f"ends {off.max() / 1e6} mm off"

    def _path(self):
        """On the way to the end the axes are where they are in the whole run."""
        if self.run.rows is None or self.whole.rows is None:
            return
        theirs, ours = self._poses(self.whole, self.first), self._poses(self.run, len(self.entry))
        near = 2.2 * float(self.run.blocks["tolerance_mm"].max(initial=0.0)) + NEAR_MM
        near += float(self.machine.record["axis"]["a_max"].max()) * self.machine.period_s**2 / 2
        if not len(ours) and len(theirs) > 1:
            yield "the tail is not executed"
            return
        yield from self._stand(ours[:1]["axis"], near)
        on_path = ~np.isin(ours["kind"], SPUN)
        yield from self._compare(theirs[~np.isin(theirs["kind"], SPUN)], ours[on_path], near)
        yield from self._compare_spun(theirs, ours)

    def _poses(self, run, first):
        """Return the poses from a block on, the path coordinate counted from the program's end."""
        poses = run.rows["pose"].copy()
        poses["s"] -= poses["s"][-1]
        return poses[poses["block"] >= first]

    def _stand(self, first, near):
        """The tail begins where the way in has ended."""
        off = np.abs(first - self._places(self.entry)[-1] / self.counts)[:, self.counted]
        if off.max(initial=0.0) > near + self._one_period():
            yield f"the tail begins {off.max():.4f} mm beside where it should"

    def _compare(self, theirs, ours, near):
        if not len(theirs) or not len(ours):
            return
        inside = (ours["s"] >= theirs["s"][0]) & (ours["s"] <= theirs["s"][-1])
        steps = np.diff(theirs["s"]) > 0
        theirs = theirs[np.r_[True, steps] | np.r_[steps, True]]  # of a rest both ends
        passes = theirs["s"][:-1][np.diff(theirs["s"]) == 0]  # there a thread may have been cut
        for s in passes:
            inside &= np.abs(ours["s"] - s) > SAME_S_MM
        off = 0.0
        for axis in range(9)[self.counted]:
            wanted = np.interp(ours["s"], theirs["s"], theirs["axis"][:, axis])
            off = np.maximum(off, np.abs(wanted - ours["axis"][:, axis]))
        off = np.where(inside, off, 0.0)
        if off.max(initial=0.0) > near:
            at = int(off.argmax())
            yield f"at line {int(ours['line'][at])} {off[at]:.4f} mm off the whole program's path"

    def _one_period(self):
        """Return how far the axes go in one period at most: poses stand so far apart."""
        axes = self.machine.record["axis"]
        return float(np.sqrt((axes["v_max"][axes["present"] == 1] ** 2).sum())
                     * self.machine.period_s)  # fmt: skip

    def _compare_spun(self, theirs, ours):
        """Threads and taps reach as far."""
        for block in np.unique(theirs["block"][np.isin(theirs["kind"], SPUN)]):
            want = theirs["axis"][theirs["block"] == block]
            have = ours["axis"][ours["block"] == block - self.first + len(self.entry)]
            if not len(have):
                yield f"the pass of block {block} is missing"
                continue
            reach = np.concatenate([want.min(0) - have.min(0), want.max(0) - have.max(0)])
            off = np.abs(reach).max()
            if off > SPUN_MM:
                yield f"the pass of block {block} is {off:.4f} mm off"


def lines_of(case, most=None, seed=0):
    """Return the lines of a case, or so many of them by a seed."""
    count = bytes_of(case).count(b"\n")
    every = np.arange(1, count + 1)
    if most is None or count <= most:
        return every.tolist()
    return sorted(np.random.default_rng(seed).choice(every, most, replace=False).tolist())


def files():
    """Return the files of the corpus that are here and run."""
    return [file for file in cases.RUNNING_FILES + cases.THREAD_FILES if file.path.exists()]


def search(names, seed, long):
    """Enter cases; print findings. Return (lines, findings)."""
    lines = found = 0
    for case in names:
        whole_of.cache_clear()
        for line in lines_of(case, long, seed):
            lines += 1
            for words in findings(case, line):
                found += 1
                print(f"{case}:{line}: {words}", flush=True)
    return lines, found


def main():
    ask = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    ask.add_argument("--family", choices=["all", *sorted(entering_families.FAMILIES)])
    ask.add_argument("--seeds", nargs=2, default=("0", "+20"), help="the first, and how many more")
    ask.add_argument("--only", default="", help="cases whose name contains it")
    ask.add_argument("--lines", type=int, default=LONG, help="of a long program, by the first seed")
    asked = ask.parse_args()
    first, count = map(int, asked.seeds)
    if asked.family:
        families = entering_families.FAMILIES if asked.family == "all" else [asked.family]
        chosen = [entering_families.case(family, first + more)
                  for family in families for more in range(count)]  # fmt: skip
    else:
        chosen = [case for case in (*cases.CASES, *files()) if asked.only in str(case)]
    lines, found = search(chosen, first, asked.lines)
    print(f"{lines} lines of {len(chosen)} programs entered, {found} findings")
    return found > 0


if __name__ == "__main__":
    sys.exit(main())
