# SPDX-License-Identifier: MIT
"""MC/DC of the tick path: every condition is seen to decide the outcome on its own.

Modified condition/decision coverage as clang counts it, over the C tests of the tick. A condition
that stands alone counts as covered if it was true and false.
"""

import json
import os
import subprocess
from concurrent.futures import ThreadPoolExecutor

import c_tests
import pytest

pytestmark = pytest.mark.thorough

TESTS = (
    "pass", "link", "link_races", "marks", "interpolate", "transform", "filter", "path", "tick",
    "kernel", "begin", "flush", "survive", "travel", "single_block", "thread", "spindle",
    "sync", "sync_tap", "stop", "await",
)  # fmt: skip
# What runs in the tick, below csrc/nck: a file, and its functions if not all of them do.
TICK_PATH = {
    "tick/6_interpolate/interpolate.c": None,
    "tick/6_interpolate/sync.c": None,
    "tick/6_interpolate/follow.c": None,
    "tick/6_interpolate/tap.c": None,
    "base/thread.c": None,
    "tick/7_transform/transform.c": None,
    "base/link.c": None,
    "base/marks.c": {"nck_marks_line"},
    "base/path_math.h": {"nck_path_point", "nck_path_cubic"},
    "base/trig.c": {"nck_sincos"},
    "base/trig_math.h": {"nck_trig_sincos", "nck_sin_core", "nck_cos_core"},
    "nck.c": {"nck_tick", "is_held", "hand_over_outputs", "nck_resume", "nck_hold", "nck_abort",
              "nck_is_idle", "nck_is_moving", "nck_take"},
}  # fmt: skip
GOAL = 0.94
# The tests, and what is not of the tick's path, are those of the release build: clang compiles what
# is counted, which comes first among what is linked.
COUNTED = sorted({name for name in TICK_PATH if name.endswith(".c")} | {"base/path.c"})
# Asserts are left out: none of them is ever to be false.
PROFILED = "-fprofile-instr-generate"
FLAGS = ("-std=c99 -O2 -DNDEBUG -ffp-contract=off -fno-math-errno"
         f" {PROFILED} -fcoverage-mapping -fcoverage-mcdc").split()  # fmt: skip


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def programs(root, tool, tmp_path_factory):
    """Return {test: its program} of the tests, in which the tick's path is counted."""
    clang, folder = tool("clang-19"), tmp_path_factory.mktemp("counted")
    includes = [f"-I{root / name}" for name in ("csrc", "tests/c")]

    def compiled(source):
        binary = folder / f"{source.stem}.o"
        run([clang, *FLAGS, *includes, "-c", source, "-o", binary])
        return binary

    files = {path: name for path, name in c_tests.programs().items() if path.stem[5:] in TESTS}
    assert len(files) == len(TESTS)
    with ThreadPoolExecutor(2) as pool:
        counted = list(pool.map(compiled, [root / "csrc" / "nck" / name for name in COUNTED]))
    for path, program in files.items():
        if program == path.stem:  # it brings the source that it is about
            run([clang, PROFILED, compiled(path), folder / "marks.o", "-o", folder / program])
        elif not (folder / program).exists():
            c_tests.link_anew(program, counted, folder / program, clang, PROFILED)
    return {path.stem: folder / program for path, program in files.items()}


@pytest.fixture(scope="module")
def counted(root, tool, programs, tmp_path_factory):
    """Return what llvm-cov exports of the tick path after a run of the tests."""
    profiles = tmp_path_factory.mktemp("profiles")
    for test, program in programs.items():
        places = {**os.environ, "LLVM_PROFILE_FILE": str(profiles / f"{test}.profraw")}
        run([program, test], env=places, timeout=300)
    merged = profiles / "all.profdata"
    run([tool("llvm-profdata-19"), "merge", "-sparse", *profiles.glob("*.profraw"), "-o", merged])
    first, *others = sorted(set(programs.values()))
    command = [tool("llvm-cov-19"), "export", first, *(f"-object={other}" for other in others)]
    sources = [root / "csrc" / "nck" / name for name in TICK_PATH]
    return json.loads(run([*command, f"-instr-profile={merged}", *sources]))["data"][0]


def lines_of(counted, file, names):
    """Return the lines of a file's functions, all of them if names is None."""
    found, lines = set(), set()
    for function in counted["functions"]:
        name = function["name"].rpartition(":")[2]
        if name.endswith("_invariants"):  # asked by tests alone
            continue
        if function["filenames"][0].endswith(f"csrc/nck/{file}") and (not names or name in names):
            found.add(name)
            lines.update(range(function["regions"][0][0], function["regions"][0][2] + 1))
    assert found and (not names or found == names), f"{file}: {names} are not what was counted"
    return lines


def decisions_of(counts):
    """Return {place: [which condition, in order of the text, was seen to decide]}."""
    found = {}
    for record in counts["mcdc_records"]:
        place, shown = tuple(record[:4]), record[6]
        before = found.get(place, [False] * len(shown))
        found[place] = [one or other for one, other in zip(before, shown, strict=True)]
    return found


def branches_of(counts):
    """Return {place: (how often true, how often false)}."""
    found = {}
    for branch in counts["branches"]:
        place = tuple(branch[:4])
        before = found.get(place, (0, 0))
        found[place] = (before[0] + branch[4], before[1] + branch[5])
    return found


def is_within(inner, outer):
    return outer[:2] <= inner[:2] and inner[2:] <= outer[2:]


def conditions_of(counts):
    """Yield (line, column, whether it is covered) of every condition of a file."""
    decisions, branches = decisions_of(counts), branches_of(counts)
    alone = dict(branches)
    for place, shown in decisions.items():
        parts = sorted(branch for branch in branches if is_within(branch, place))
        assert len(parts) == len(shown), f"a decision within another one: {place}"
        for part, covered in zip(parts, shown, strict=True):
            del alone[part]
            yield part[0], part[1], covered
    for place, (true, false) in alone.items():
        yield place[0], place[1], true > 0 and false > 0


def test_conditions_of_the_tick_path_decide_on_their_own(counted):
    files = {file["filename"]: file for file in counted["files"]}
    total, missed = 0, []
    for name, functions in TICK_PATH.items():
        lines = lines_of(counted, name, functions)
        counts = next(file for path, file in files.items() if path.endswith(f"csrc/nck/{name}"))
        found = [each for each in conditions_of(counts) if each[0] in lines]
        total += len(found)
        missed += [f"{name}:{line}:{column}" for line, column, covered in found if not covered]
    said = f"{total - len(missed)} of {total} conditions; not shown to decide: {missed}"
    assert total > 100 and len(missed) <= (1.0 - GOAL) * total, said
