# SPDX-License-Identifier: MIT
"""The cases that tests, benches and examples draw from: programs of our own, random families with
fixed seeds, and the corpus with what becomes of every file.

A case prints as its name; `case.text` is the program.
"""

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pycnc.bench import corpus

ROOT = Path(__file__).resolve().parents[1]
PROGRAMS = ROOT / "tests" / "programs"
CORPUS = corpus.FOLDER
SHARED_PROGRAMS = ROOT.parent / "shared" / "programs"
HEAD = "G17 G21 G90 G94 G61\n"  # mm, absolute, exact path: nothing is assumed


@dataclass(frozen=True)
class Case:
    """A program and the machine that it is for; `set` changes the machine."""

    name: str
    text: str
    machine: str = "mill3"
    set: tuple = ()

    def __str__(self):
        return self.name


# Programs


def polyline(points, feed=3000):
    """Return G1 moves along points of (x, y) or (x, y, z), six decimals."""
    lines = [f"F{feed}"]
    for point in points:
        words = " ".join(f"{axis}{value:.6f}" for axis, value in zip("XYZ", point, strict=False))
        lines.append(f"G1 {words}")
    return HEAD + "\n".join(lines) + "\nM2\n"


def star(points=5, outer=20.0, inner=6.0, chord=0.05):
    """A star, every edge of which is cut into chords of equal length."""
    corners = []
    for k in range(2 * points + 1):
        radius, angle = (outer, inner)[k % 2], math.pi * k / points
        corners.append((radius * math.cos(angle), radius * math.sin(angle)))
    path = []
    for (x0, y0), (x1, y1) in zip(corners, corners[1:], strict=False):
        count = max(1, round(math.hypot(x1 - x0, y1 - y0) / chord))
        path += [(x0 + (x1 - x0) * k / count, y0 + (y1 - y0) * k / count) for k in range(count)]
    return polyline([*path, corners[-1]])


def spiral(chord=0.01, turns=3.0, pitch=2.0):
    """A spiral outward from a radius of 1 mm in chords of equal length."""
    path, angle = [], 0.0
    while angle < 2 * math.pi * turns:
        radius = 1.0 + pitch * angle / (2 * math.pi)
        path.append((radius * math.cos(angle), radius * math.sin(angle)))
        angle += chord / radius
    return polyline(path)


def zigzag(step=0.05, height=0.0125, count=400):
    """Teeth that are shorter than what one period covers."""
    return polyline([(k * step, height * (k % 2)) for k in range(count)], feed=2400)


def reversals(count=60):
    """To and fro on one line, ever shorter."""
    return polyline([(20.0 / (k + 1) * (-1) ** k, 0.0) for k in range(count)], feed=6000)


def micrometres(count=3000):
    """One straight line in moves of 1 µm."""
    return polyline([(k * 1e-3, k * 1e-3) for k in range(1, count + 1)], feed=6000)


def empty_moves():
    """Moves without length between, before and after moves with length."""
    points = [(0, 0), (0, 0), (5, 0), (5, 0), (5, 0), (5.000001, 0), (5.000001, 0), (9, 4), (9, 4)]
    return polyline([(x, y, 0) for x, y in points])


def tiny_circles(count=20):
    """Full circles with radii of 2 and 50 µm, moves of 10 µm between them."""
    return HEAD + "F6000\n" + "G2 I0.002 J0\nG1 X0.01\nG3 J-0.05\nG1 X0\n" * count + "M2\n"


def busy(count):
    """Return a program of short moves, each at a speed of its own."""
    moves = (
        f"G1 X{50 * math.cos(k * 1e-3):.4f} Y{50 * math.sin(k * 1e-3):.4f} "
        f"Z{2 * math.sin(k * 5e-3):.4f} F{3000 + k * 7919 % 3000}\n"
        for k in range(count)
    )
    return f"G21 G90 G64 P0.01 F6000\n{''.join(moves)}M2\n"


PROGRAM_CASES = (
    Case("square", (PROGRAMS / "square.ngc").read_text()),
    Case("star", star()),
    Case("circle_of_two_arcs", HEAD + "F2400\nG2 X10 Y0 I5 J0\nG2 X0 Y0 I-5 J0\nM2\n"),
    Case("full_circle", HEAD + "F6000\nG3 X0 Y0 I10 J0\nG2 X0 Y0 I0 J-0.5\nM2\n"),
    Case("helix", HEAD + "F2400\nG2 X0 Y0 Z-6 I8 J0 P3\nG1 Z0\nM2\n"),
    Case("tiny_circles", tiny_circles()),
    Case("planes", HEAD + "F1200\nG18 G2 X4 Z4 R4\nG19 G3 Y4 Z0 R4\nG17 G3 X0 Y0 R-4\nM2\n"),
    Case("spiral", spiral()),
    Case("zigzag", zigzag()),
    Case("reversals", reversals()),
    Case("micrometres", micrometres()),
    Case("empty_moves", empty_moves()),
    Case("waits", (PROGRAMS / "waits.ngc").read_text(), set=("dialect.optional_stop=true",)),
    Case("lathe_part", (PROGRAMS / "lathe_part.ngc").read_text(), machine="cak6150n"),
    Case("rotary", (PROGRAMS / "rotary.ngc").read_text(), machine="mill5_xyzac"),
    Case("outputs_alone", "M3 S100\nM8\nM5\nM2\n"),
    Case("wait_at_the_end", HEAD + "G1 X1 F600\nM0\nM2\n"),
)


# Random families


def random_lines(rng, count):
    """Lines of 1 µm to 20 mm, lengths even in their logarithm, in any direction."""
    lengths = 10 ** rng.uniform(-3, 1.3, count)
    way = rng.normal(size=(count, 3))
    way *= lengths[:, None] / np.linalg.norm(way, axis=1)[:, None]
    points = np.cumsum(way, axis=0)
    return polyline(50 * np.sin(points / 50), feed=6000)


def random_smooth(rng, count):
    """A path that bends little from chord to chord, and now and then sharply."""
    bend = rng.normal(scale=0.05, size=count) + (rng.random(count) < 0.02) * rng.normal(size=count)
    heading, chord = np.cumsum(bend), 10 ** rng.uniform(-2.5, -0.5)
    points = np.cumsum(chord * np.stack([np.cos(heading), np.sin(heading)], axis=1), axis=0)
    return polyline(100 * np.sin(points / 100), feed=9000)


def random_arcs(rng, count):
    """Arcs and helices of all sizes and angles in the three planes, lines between."""
    words = {17: "XYIJZ", 18: "ZXKIY", 19: "YZJKX"}
    lines = [HEAD + "F4000 G91"]
    for _ in range(count):
        plane = int(rng.integers(17, 20))
        u, v, i, j, along = words[plane]
        radius, angle = 10 ** rng.uniform(-2, 1), rng.uniform(0, 2 * math.pi)
        sweep = rng.uniform(0.01, 2 * math.pi - 0.01)
        turn = rng.choice((2, 3))
        end = angle + sweep * (1 if turn == 3 else -1)
        du = radius * (math.cos(end) - math.cos(angle))
        dv = radius * (math.sin(end) - math.sin(angle))
        centre = f"{i}{-radius * math.cos(angle):.6f} {j}{-radius * math.sin(angle):.6f}"
        rise = f" {along}{rng.normal() * radius:.6f}" if rng.random() < 0.3 else ""
        lines.append(f"G{plane} G{turn} {u}{du:.6f} {v}{dv:.6f} {centre}{rise}")
        if rng.random() < 0.3:
            lines.append("G90 G0 X0 Y0 Z0\nG91")
    return "\n".join([*lines, "M2", ""])


def random_stops(rng, count):
    """Lines, rapids, dwells, waits, outputs and exact stops in any order."""
    lines = [HEAD + "F3000"]
    for _ in range(count):
        x, y = rng.uniform(-20, 20, 2)
        lines.append(
            rng.choice([
                f"G1 X{x:.4f} Y{y:.4f}", f"G1 X{x:.4f}", f"G0 X{x:.4f} Y{y:.4f}",
                f"G9 G1 Y{y:.4f}", f"G4 P{abs(x) / 2000:.6f}", "M0", f"S{abs(x) * 100:.0f}", "M8",
                "G61.1", "G64", "G61", f"F{abs(x) * 300 + 60:.0f}",
            ])
        )  # fmt: skip
    return "\n".join([*lines, "M2", ""])


FAMILIES = {
    "lines": (random_lines, 400),
    "smooth": (random_smooth, 2500),
    "arcs": (random_arcs, 120),
    "stops": (random_stops, 200),
}
SEEDS = range(3)
RANDOM_CASES = tuple(
    Case(f"random_{name}_{seed}", family(np.random.default_rng([seed, len(name)]), count))
    for name, (family, count) in FAMILIES.items()
    for seed in SEEDS
)

CASES = PROGRAM_CASES + RANDOM_CASES


# What others share


@dataclass(frozen=True)
class CorpusFile:
    """A file that others share, the machine it is for, and how it ends there.

    `ends` is None if it runs, else (id, line) of its first error.
    """

    file: str
    machine: str = "mill3"
    set: tuple = ()
    ends: tuple | None = None
    folder: Path = CORPUS
    threads: bool = False  # passes are in step with the spindle, and on no path

    def __str__(self):
        return self.file + ("" if not self.set else " with " + ", ".join(self.set))

    @property
    def path(self):
        return self.folder / self.file


_HAAS = (
    "m.88.action=output", "m.89.action=output", "axis.x.min_mm=free", "axis.y.min_mm=free",
    "axis.z.min_mm=free",
)  # fmt: skip
_MMOUNT = (
    "axis.y.min_mm=free", "tool.4.radius_mm=3.175", "tool.5.radius_mm=6.35",
    "tool.15.radius_mm=6.985",
)  # fmt: skip

CORPUS_FILES = (
    *(CorpusFile(*each) for each in corpus.RUNNING),
    CorpusFile("arcs_rword.gcode", set=("spindle.rpm_max=12000",), ends=("number-range", 14)),
    CorpusFile("ax5_boat_xyzac_g93.ngc", machine="mill5_xyzac", ends=("m-unknown", 2)),
    CorpusFile("bad_longmill_invalid.nc", ends=("word-unknown", 124)),
    CorpusFile("lathe_fanuc0t_css.nc", machine="cak6150n", ends=("unsupported", 6)),
    CorpusFile("lathe_g71_g70_pawn.ngc", machine="cak6150n", ends=("other-base", 4)),
    CorpusFile("lathe_g76_thread_part.ngc", machine="cak6150n", ends=("unsupported", 11)),
    CorpusFile(
        "lathe_g76_thread_part.ngc",
        machine="cak6150n",
        set=("dialect.base=linuxcnc", "dialect.diameter=false"),  # and with T9: test_threads.py
        ends=("tool-unknown", 108),
    ),
    CorpusFile("mill_fanuc_g81_g91.nc", ends=("modal-group", 26)),
    CorpusFile("mill_fusion_grbl_helix.nc", ends=("feed-missing", 14)),
    CorpusFile("mill_haas_threadmill.nc", ends=("other-base", 7)),
    CorpusFile(
        "mill_haas_threadmill.nc", set=("dialect.base=fanuc", *_HAAS), ends=("tool-unknown", 28)
    ),
    CorpusFile("mill_sub_cycles_mmount.ngc", ends=("travel", 85)),
    CorpusFile("mill_sub_cycles_mmount.ngc", set=("axis.y.min_mm=free",), ends=("comp-radius", 89)),
    CorpusFile("mill_sub_cycles_mmount.ngc", set=_MMOUNT, threads=True),
    CorpusFile("unsupported_sinumerik840d.nc", ends=("dialect", 1)),
)
# Programs of our own: a tool that the machine has not, a bigger travel, what nobody builds here.
PROGRAM_FILES = (
    CorpusFile(
        "lathe_fanuc_two_line_cycles.nc", "cak6150n", ends=("tool-unknown", 30),
        folder=SHARED_PROGRAMS,
    ),
    CorpusFile(
        "lathe_fanuc_two_line_cycles.nc", "cak6150n", set=("tool.5.radius_mm=0.2",),
        folder=SHARED_PROGRAMS, threads=True,
    ),
    CorpusFile("lathe_g96_g76.ngc", "cak6150n", ends=("unsupported", 3), folder=SHARED_PROGRAMS),
    CorpusFile(
        "lathe_g96_g76.ngc", "cak6150n", set=("dialect.base=linuxcnc",), folder=SHARED_PROGRAMS,
        threads=True,
    ),
    CorpusFile(
        "lathe_haas_one_line_g71.nc", "cak6150n", folder=SHARED_PROGRAMS, threads=True
    ),
    CorpusFile(
        "mill5_fanuc_g43_4_tcp.nc", "mill5_xyzac",
        set=("dialect.base=fanuc", "tool.5.length_mm=60"), ends=("unsupported", 9),
        folder=SHARED_PROGRAMS,
    ),
)  # fmt: skip

CORPUS_FILES += PROGRAM_FILES
RUNNING_FILES = tuple(file for file in CORPUS_FILES if file.ends is None and not file.threads)
# They take 1 to 5 s of a test, where others take a tenth: a quick run has others.
DEAR_FILES = {
    "ax4_rotation_51k.nc", "laser_tball_engrave.gcode", "mill_fanuc_g81_g91.nc",
    "mill_fusion_grbl_helix.nc", "mill_nist_circle_diamond_square.ngc",
    "print_cura_bp_case_56k.gcode", "surf_la_peinture_180k.gc", "surf_webgcode_46k.ngc",
}  # fmt: skip
THREAD_FILES = tuple(file for file in CORPUS_FILES if file.ends is None and file.threads)
