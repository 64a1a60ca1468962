# SPDX-License-Identifier: MIT
"""What each number of the planner buys: the kernel is compiled without it and plans the families.

    .venv/bin/python tests/slope/rules.py                 all numbers of docs/planner.md, section 17
    .venv/bin/python tests/slope/rules.py SHARE NCK_WAY   these alone
    .venv/bin/python tests/slope/rules.py GROWS=0.08      with that value in its place
    .venv/bin/python tests/slope/rules.py --seeds 6       of more programs

A number is taken out by the values of WITHOUT, at which its rule does nothing or as much as a
neighbour's; by half of it and twice of it where there are none. A row tells: time, the mean over
all programs of how many times as long they take; the family that pays most, and how much; work,
how many times as many instructions all steps of prep may take by their own prices. Programs: the
kinds of pycnc/bench/families.py on two machines within three tolerances, `mixed` of clocked.py
with arcs and words, `any` of test_lowered_feeds.py and `machines` of test_any_machine.py. What
stands for limits, overrides and rests is held by tests, not seen here.
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
sys.path.append(str(ROOT / "tests"))

import builds  # noqa: E402

FOLDER = ROOT / "build" / "rules"
COPIED = ("CMakeLists.txt", "cmake", "csrc", "firmware_sim", "opencl", "adapters/linuxcnc")
PAGE = ROOT / "docs" / "planner.md"
ROW = re.compile(r"^\| [^|]+ \| ([-\d.e]+) \| (\w+) \| (\S+\.[ch]) \|", re.M)
WITHOUT = {
    "NCK_WAY": "0.95", "NCK_ROOM": "1", "NCK_FURTHER": "32", "NCK_START": "1", "NCK_GAP": "0.1",
    "KNOT_STOPS": "0", "KNOT_PARTS": "1", "KNOT_RAISE": "1e9", "KNOT_SHARE_MOST": "1e9",
    "GROWS": "1e9", "SWINGS": "1e9", "TURNS": "1e9", "NCK_TIMING_ASK": "1", "REACH_KNOTS": "0",
    "BLUR_KNOTS": "0", "KEEP_ASK": "0.7", "FOLLOWS": "0", "SHARE": "1", "STAY": "0", "FIRM": "0",
    "EVEN": "0", "RELAXED": "1", "FIRST_GAP": "1", "ROUNDS": "3", "BETTER": "0", "SMALL": "1e-9",
    "ENOUGH": "1", "WHOLE": "0", "MU_BROKEN": "0", "PAID": "1", "NCK_OPTIMAL_CELL_SHARE": "1e9",
}  # fmt: skip
LIMIT_S = 600.0  # of a build's programs: without a number some may never end
WORK = """
extern uint64_t rules_work;
__attribute__((visibility("default"))) uint64_t rules_work;
"""


def pattern_of(name):
    """Return the expression for a number of the source: what stands before it, and itself."""
    begin = rf"(?:#define {name} |\b{name} = )(?:\(\(nck_num\)|NCK_NUM_OF\()?"
    return re.compile(rf"({begin})([-\d.e]+)")


def write(file, content):
    """Write a file, if it is another one: what is as it was is not compiled again."""
    if not file.exists() or file.read_bytes() != content:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)


def counted(text):
    """Return the text of csrc/host/plan.c with the prices of prep's steps added up."""
    step = "    plan->status = nck_prep(plan->nck);\n"
    assert text.count(step) == 1
    line = text.index("\n", text.rindex("\n#include") + 1)
    text = text[:line] + WORK + text[line:]
    return text.replace(step, "    rules_work += nck_price(plan->nck);\n" + step)


def copy_tree(tree):
    """Copy what the module is made of."""
    for name in COPIED:
        source = ROOT / name
        for file in [source] if source.is_file() else sorted(source.rglob("*")):
            if not file.is_file():
                continue
            content = file.read_bytes()
            if file.name == "plan.c" and file.parent.name == "host":
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


def drawn(seeds):
    """Yield (family, program)."""
    import clocked
    import test_any_machine
    import test_lowered_feeds

    from pycnc.bench import families, programs
    from pycnc.program import Program

    for name, limits in families.MACHINES.items():
        machine = programs.machine("optimal", *limits)
        for family in families.FAMILIES:
            for seed in range(seeds):
                points, feed = families.draw(family, seed)
                for p in families.TOLERANCES:
                    program = Program.from_points(points, feed, machine, tolerance=p)
                    yield f"{family} {name}", program
        for seed in range(10 * seeds):
            yield f"mixed {name}", Program(clocked.text_of(seed).encode(), machine)
    for seed in range(20 * seeds):
        rng = np.random.default_rng([77, seed])
        machine = test_lowered_feeds._machine(rng)
        yield "any", Program(test_lowered_feeds._text(rng), machine)
    for seed in range(30 * seeds):
        a, j, feed, points = test_any_machine.draw(seed)
        machine = programs.machine("optimal", a, j)
        yield "machines", Program.from_points(points, feed, machine, tolerance=test_any_machine.P)


def measure(module, seeds):
    """Print what a module takes: [family, seconds, work] a program."""
    spec = importlib.util.spec_from_file_location("pycnc._nck", module)
    sys.modules["pycnc._nck"] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(sys.modules["pycnc._nck"])
    work = ctypes.c_uint64.in_dll(ctypes.CDLL(module), "rules_work")
    from pycnc.planning.plan import Plan

    rows = []
    for family, program in drawn(seeds):
        before = work.value
        rows.append([family, Plan(program, keep=False).time_s, work.value - before])
    json.dump(rows, sys.stdout)


def measured(module, seeds):
    """Return families, seconds and work of a module, each an array over programs."""
    command = [sys.executable, __file__, "--measure", str(module), "--seeds", str(seeds)]
    out = subprocess.run(command, capture_output=True, check=True, timeout=LIMIT_S).stdout
    families, time_s, work = zip(*json.loads(out), strict=True)
    return np.array(families), np.array(time_s), np.array(work, float)


def told(base, found):
    """Return the words of a row."""
    ratio, work = found[1] / base[1], found[2].sum() / base[2].sum()
    of = {name: ratio[base[0] == name].mean() for name in dict.fromkeys(base[0])}
    most = max(of, key=of.get)
    return (f"time {ratio.mean():.4f}  worst {ratio.max():.3f}  work {work:.3f}"
            f"  {most} {of[most]:.4f}")  # fmt: skip


def variants(words):
    """Yield (name, file, value in its place) of words, NAME or NAME=VALUE; of all without any."""
    rows = {name: (file, now) for now, name, file in ROW.findall(PAGE.read_text(encoding="utf-8"))}
    for word in words or rows:
        name, _, value = word.partition("=")
        file, now = rows[name]
        other = WITHOUT.get(name) or f"{float(now) / 2:g} {float(now) * 2:g}"
        for each in (value or other).split():
            yield name, file, each


def row_of(tree, base, variant, seeds):
    """Return the row of a variant; the tree is as it was behind it."""
    name, file, value = variant
    path = tree / "csrc" / "nck" / file
    text = path.read_text(encoding="utf-8")
    changed, count = pattern_of(name).subn(rf"\g<1>{value}", text, count=1)
    assert count == 1, name
    path.write_text(changed, encoding="utf-8")
    try:
        return told(base, measured(build(tree), seeds))
    except subprocess.SubprocessError as error:
        return f"does not plan: {type(error).__name__}"
    finally:
        path.write_text(text, encoding="utf-8")


def main():
    """Print the rows."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--measure", metavar="MODULE", help="of a module, for itself")
    given = parser.parse_args()
    if given.measure:
        measure(given.measure, given.seeds)
        return 0
    tree = FOLDER / "tree"
    copy_tree(tree)
    base = measured(build(tree), given.seeds)
    print(f"{len(base[0])} programs, {base[1].sum():.0f} s", flush=True)
    for variant in variants(given.names):
        row = row_of(tree, base, variant, given.seeds)
        print(f"{variant[0]:25}{variant[2]:>6}  {row}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
