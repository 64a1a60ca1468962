# SPDX-License-Identifier: MIT
"""What each number of the planner buys: the kernel is compiled without it and plans the families.

    pycnc lab bench rules                                 all numbers of docs/planner.md, section 17
    .venv/bin/python tests/slope/rules.py NCK_GAP NCK_WAY these alone
    .venv/bin/python tests/slope/rules.py NCK_WAY=0.9     with that value in its place
    .venv/bin/python tests/slope/rules.py --seeds 6       of more programs

A number is taken out by the values of WITHOUT, at which its rule does nothing or as much as a
neighbour's; by half of it and twice of it where there are none. A row tells: time, the mean over
all programs of how many times as long they take; the family that pays most, and how much; work, how
many times as many instructions all steps of prep may take by their own prices. Programs: the kinds
of pycnc/bench/families.py on two machines within three tolerances, `mixed` of clocked.py with arcs
and words, `loops` of test_loops.py, `any` of test_lowered_feeds.py, `machines` of
test_any_machine.py and `lathe`, facing at a surface speed: of it the row has by how many times a
tick is slower than its feed at most; `coming`, a served session whose chords come one a period: its
ticks in motion. What stands for limits, overrides and rests is held by tests, not seen here.
"""

import argparse
import ctypes
import importlib.util
import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "tests"), str(ROOT / "tests" / "smooth")]

import builds  # noqa: E402

FOLDER = ROOT / "build" / "rules"
CALLS = ("csrc/host/plan.c", "firmware_sim/serve/serve.c")  # of nck_prep
COPIED = ("CMakeLists.txt", "cmake", "csrc", "firmware_sim", "opencl", "adapters/linuxcnc")
PAGE = ROOT / "docs" / "planner.md"
TUNING = {file.parent.name: file for file in (ROOT / "csrc/nck").rglob("tuning.h")}
ROW = re.compile(r"^\| [^|]+ \| ([-\d.e]+) \| (NCK_\w+) \| (\w+) \|", re.M)
NUMBER = re.compile(r"^#define (\w+) (?:NCK_NUM_OF\()?([-\d.e]+)", re.M)
WITHOUT = {
    "NCK_WAY": "0.95", "NCK_ROOM": "1", "NCK_FURTHER": "32", "NCK_START": "1", "NCK_GAP": "0.1",
    "NCK_KNOT_STOPS": "0", "NCK_KNOT_PARTS": "1", "NCK_KNOT_RAISE": "1e9",
    "NCK_KNOT_SHARE_MOST": "1e9", "NCK_TIMING_GROWS": "1e9", "NCK_TIMING_SWINGS": "1e9",
    "NCK_TIMING_TURNS": "1e9", "NCK_TIMING_ASK": "1", "NCK_TIMING_REACH": "0",
    "NCK_TIMING_BLUR": "0", "NCK_TIMING_KEEP_ASK": "0.7", "NCK_REFERENCE_FOLLOWS": "0",
    "NCK_STREAM_SHARE": "1", "NCK_STREAM_STAY": "0", "NCK_STREAM_FIRM": "0",
    "NCK_STREAM_OPEN": "0", "NCK_TIMING_LEAVE": "0.7", "NCK_STREAM_NEXT": "1",
    "NCK_TRACK_JOINED": "1", "NCK_OPTIMAL_COMMIT_OFF": "0", "NCK_STREAM_EVEN": "0",
    "NCK_STREAM_RELAXED": "1", "NCK_STREAM_FIRST_GAP": "1",
    "NCK_STREAM_ROUNDS": "3", "NCK_FAIR_BETTER": "0", "NCK_FAIR_SMALL": "1e-9", "NCK_AIM": "1",
    "NCK_MOTION_WHOLE": "0", "NCK_MOTION_BROKEN": "0", "NCK_MOTION_PAID": "1",
    "NCK_OPTIMAL_CELL_SHARE": "1e9",
}  # fmt: skip
FEED = 0.2  # mm a revolution, of a lathe
RAMP = 100  # ticks of a lathe's cut at either end: it comes from a rest, and to one
SILENCE = 200  # ticks behind which nothing more moves
LIMIT_S = 600.0  # of a build's programs: without a number some may never end
WORK = """
extern uint64_t rules_work;
__attribute__((visibility("default"), weak)) uint64_t rules_work;
"""


def write(file, content):
    """Write a file, if it is another one: what is as it was is not compiled again."""
    if not file.exists() or file.read_bytes() != content:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)


def counted(text):
    """Return the text of a file of `CALLS` with the prices of prep's steps added up."""
    (call,) = re.findall(r"^.*\bnck_prep\((\w+->nck)\);\n", text, re.M)
    line = text.index("\n", text.rindex("\n#include") + 1)
    text = text[:line] + WORK + text[line:]
    price = f"    rules_work += nck_price({call});\n"
    return re.sub(r"^(?=.*\bnck_prep\()", price, text, flags=re.M)


def copy_tree(tree):
    """Copy what the module is made of."""
    for name in COPIED:
        source = ROOT / name
        for file in [source] if source.is_file() else sorted(source.rglob("*")):
            if not file.is_file():
                continue
            content = file.read_bytes()
            if file.relative_to(ROOT).as_posix() in CALLS:
                content = counted(content.decode()).encode()
            write(tree / file.relative_to(ROOT), content)


def build(tree):
    """Compile the module of a tree, little optimized; return it."""
    folder = tree.parent / "out"
    builds.keep_what_is_compiled()
    if not (folder / "build.ninja").exists():
        options = ["-G", "Ninja", "-DSKBUILD=1", "-DNCK_QUICK=ON", "-DNCK_STRICT=OFF",
                   f"-DCMAKE_MAKE_PROGRAM={builds.NINJA}",
                   f"-DPython_EXECUTABLE={sys.executable}"]  # fmt: skip
        subprocess.run([builds.CMAKE, "-S", tree, "-B", folder, *options],
                       check=True, stdout=subprocess.DEVNULL)  # fmt: skip
    subprocess.run([builds.NINJA, "-C", folder, "--quiet", "_nck"],
                   check=True, stdout=subprocess.DEVNULL)  # fmt: skip
    return folder / "_nck.abi3.so"


def facing(seed):
    """Return a lathe's program, whose feed follows its surface speed."""
    from pycnc.machine import Machine
    from pycnc.program import Program

    rng = np.random.default_rng([96, seed])
    most = rng.uniform(30, 60)  # half of it is left: the spindle follows without being waited for
    x = np.round(np.linspace(most, most / 2, rng.integers(2, 5)), 3)
    head = f"G21 G18 G99\nG50 S{rng.integers(1000, 3000)}\nG96 S{rng.integers(50, 300)} M3\n"
    cuts = "".join(f"G1 X{each} F{FEED}\n" for each in x[1:])
    machine = Machine.load("cak6150n", set=("dialect.system=A", "path.slope=optimal"))
    return Program(f"{head}G0 X{x[0]} Z0\n{cuts}M30\n".encode(), machine)


def slowness(program):
    """Return by how many times a tick of a lathe's cut is slower than its feed, at most."""
    import judged

    pose = judged.rows_of(program)["pose"]
    within = np.flatnonzero(pose["line"] > 4)[RAMP:-RAMP]
    asked = pose["spindle_rpm"][within] * FEED / 60
    return float((asked / pose["v"][within]).max())


def coming(seed):
    """Return the ticks of a session whose chords come one a period, at a feed that outruns them."""
    from pycnc.kernel.session import Session
    from pycnc.machine import Machine

    rng = np.random.default_rng([97, seed])
    n, chord = int(rng.integers(500, 1500)), 10 ** rng.uniform(-1.6, -0.7)
    way = np.cumsum(rng.uniform(0.02, 0.2) * np.sin(np.arange(n) * rng.uniform(1e-3, 0.05)))
    points = chord * np.cumsum([np.cos(way), np.sin(way)], axis=1).T
    machine = Machine.load("mill3", dialect="grbl", set=("path.tolerance_mm=0.01",))
    session = Session(machine)
    session.run(10)
    session.receive(b"G21 G1 F6000\n")
    for x, y in points:
        session.receive(f"G1 X{x:.4f} Y{y:.4f}\n".encode())
        session.run(1)
    moved = -1
    while session.moving != moved or moved == 0:  # it waits for more before it sets off
        moved = session.moving
        session.run(SILENCE)
    said = session.take()
    assert b"error" not in said, said
    return moved


def drawn(seeds):
    """Yield (family, what its time is, of what)."""
    import clocked
    import test_any_machine
    import test_loops
    import test_lowered_feeds

    from pycnc.bench import families, programs
    from pycnc.machine import Machine
    from pycnc.program import Program

    for name, limits in families.MACHINES.items():
        machine = programs.machine("optimal", *limits)
        for family in families.FAMILIES:
            for seed in range(seeds):
                points, feed = families.draw(family, seed)
                for p in families.TOLERANCES:
                    program = Program.from_points(points, feed, machine, tolerance=p)
                    yield f"{family} {name}", planned, program
        for seed in range(10 * seeds):
            yield f"mixed {name}", planned, Program(clocked.text_of(seed).encode(), machine)
    for seed in range(20 * seeds):
        rng = np.random.default_rng([77, seed])
        machine = test_lowered_feeds._machine(rng)
        yield "any", planned, Program(test_lowered_feeds._text(rng), machine)
    for seed in range(30 * seeds):
        a, j, feed, points = test_any_machine.draw(seed)
        machine = programs.machine("optimal", a, j)
        program = Program.from_points(points, feed, machine, tolerance=test_any_machine.P)
        yield "machines", planned, program
    mill = Machine.load("mill3")
    for seed in range(20 * seeds):
        yield "loops", planned, Program(test_loops.program(seed, loops=True).encode(), mill)
    for seed in range(4 * seeds):
        yield "lathe", slowness, facing(seed)
    for seed in range(4 * seeds):
        yield "coming", coming, seed


def planned(program):
    """Return the time of a program [s]."""
    from pycnc.planning.plan import Plan

    return Plan(program, keep=False).time_s


def measure(module, seeds):
    """Print what a module takes: [family, seconds or how slow it is, work] a program."""
    spec = importlib.util.spec_from_file_location("pycnc._nck", module)
    sys.modules["pycnc._nck"] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(sys.modules["pycnc._nck"])
    work = ctypes.c_uint64.in_dll(ctypes.CDLL(module), "rules_work")
    rows = []
    for family, taken, of in drawn(seeds):
        before = work.value
        rows.append([family, taken(of), work.value - before])
    json.dump(rows, sys.stdout)


def measured(module, seeds):
    """Return families, seconds and work of a module, each an array over programs."""
    command = [sys.executable, __file__, "--measure", str(module), "--seeds", str(seeds)]
    out = subprocess.run(command, capture_output=True, check=True, timeout=LIMIT_S).stdout
    families, time_s, work = zip(*json.loads(out), strict=True)
    return np.array(families), np.array(time_s), np.array(work, float)


def compared(base, found):
    """Return the numbers of a row."""
    ratio, work = found[1] / base[1], found[2].sum() / base[2].sum()
    of = {name: ratio[base[0] == name].mean() for name in dict.fromkeys(base[0])}
    most = max(of, key=of.get)
    return {"time": ratio.mean(), "worst": ratio.max(), "work": work,
            "family": most, "of_it": of[most]}  # fmt: skip


def said(row):
    """Return the words of a row."""
    begin = f"{row['number']:25}{row['without']:>6}  "
    if row["time"] is None:
        return begin + "does not plan"
    return begin + ("time {time:.4f}  worst {worst:.3f}  work {work:.3f}  {family} {of_it:.4f}"
                    ).format(**row)  # fmt: skip


def variants(words):
    """Yield (name, file, value in its place) of words, NAME or NAME=VALUE; of all without any."""
    page = PAGE.read_text(encoding="utf-8")
    rows = {name: (TUNING[room], now) for now, name, room in ROW.findall(page)}
    for word in words or rows:
        name, _, value = word.partition("=")
        file, now = rows[name]
        other = WITHOUT.get(name) or f"{float(now) / 2:g} {float(now) * 2:g}"
        for each in (value or other).split():
            yield name, file, each


def row_of(tree, base, variant, seeds):
    """Return the row of a variant; the tree is as it was behind it."""
    name, file, value = variant
    path = tree / file.relative_to(ROOT)
    text = path.read_text(encoding="utf-8")
    (number,) = (each for each in NUMBER.finditer(text) if each[1] == name)
    changed = text[: number.start(2)] + value + text[number.end(2) :]
    path.write_text(changed, encoding="utf-8")
    row = {"number": name, "without": value}
    try:
        return row | compared(base, measured(build(tree), seeds))
    except subprocess.SubprocessError:
        return row | dict.fromkeys(("time", "worst", "work", "family", "of_it"))
    finally:
        path.write_text(text, encoding="utf-8")


def main():
    """Print the rows."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--json", action="store_true", help="a row a line")
    parser.add_argument("--measure", metavar="MODULE", help="of a module, for itself")
    given = parser.parse_args()
    if given.measure:
        measure(given.measure, given.seeds)
        return 0
    tree = FOLDER / "tree"
    copy_tree(tree)
    base = measured(build(tree), given.seeds)
    for variant in variants(given.names):
        row = row_of(tree, base, variant, given.seeds)
        print(json.dumps(row) if given.json else said(row), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
