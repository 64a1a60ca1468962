# SPDX-License-Identifier: MIT
"""The C tests, tests/<room>/test_*.c, as items of pytest: one for each build that has them.

A test runs in the release build by gcc, in the default and in the small capacities (`small`), a few
also in a build that leaves rooms out, `linear` or `jerk` as drawn. A quick run has the small
capacities of two rooms alone, the suite beside them those of the rooms that the commit changes, and
of half of the others. Under the sanitizers of clang the suite runs the tests of some rooms
in one set of capacities, as drawn; the campaign runs them all.
"""

import re
import subprocess
from pathlib import Path

import pytest
import sampling
from builds import build_c

ROOT = Path(__file__).resolve().parents[1]
LIMIT_S = 600  # of the campaign, too, whose tests limits.py does not watch
# Builds that leave out rooms and planners, and the tests that they are built with.
LEAN = {"test_decode_motion", "test_interpolate", "test_left_out", "test_link"}
LEAN_PROGRAMS = ("tests_lean_linear", "tests_lean_jerk")
SANITIZED = "clang-19"
SUFFIXES = ("", "_small")  # of names, for the sets of capacities
FUZZED = ("decode", "kernel", "serve")
LIBRARIES = ("firmware_sim/app/libapp.a", "libsim.a", "libnck_host.a", "firmware_sim/libos.a",
             "firmware_sim/app/libhal_switches.a", "libnck.a")  # fmt: skip
SMALL_ALWAYS = ("base", "kernel")  # whose rings wrap and fill where they are short


def programs():
    """Return {path of a C test: the stem of the program that holds it}."""
    found = {}
    for path in sorted(Path(__file__).parent.glob("*/test_*.c")):
        alone = re.search(r'^#include "nck/.*\.c"', path.read_text(encoding="utf-8"), re.M)
        found[path] = path.stem if alone else f"tests_{path.parent.name}"
    return found


def drawn_suffixes(config):
    """Return the ends of the names of the capacities that a run has under the sanitizers.

    The suite has one set of two, for each takes as long to compile as all tests take to run.
    """
    if config.option.draw == "suite":
        return (sampling.generator(config, "capacities").choice(SUFFIXES),)
    return SUFFIXES if config.option.draw == "whole" else ()


def small_rooms(config):
    """Return the rooms whose tests a run has in the small capacities."""
    rooms = sorted({path.parent.name for path in programs()} - set(SMALL_ALWAYS))
    if config.option.draw != "suite":
        return {*SMALL_ALWAYS, *(rooms if config.option.draw == "whole" else ())}
    some = sampling.generator(config, "small rooms").sample(rooms, len(rooms) // 2)
    changed = {room for room in rooms for file in sampling.changed_files()
               if re.search(rf"(^|[/_]){room}/.*\.[ch]$", file)}  # fmt: skip
    return {*SMALL_ALWAYS, *changed, *some}


def small_programs(config):
    """Return the programs of those rooms."""
    rooms = small_rooms(config)
    return {f"{stem}_small" for path, stem in programs().items() if path.parent.name in rooms}


def drawn_programs(config):
    """Return the names of the programs that a run has under the sanitizers, and of lean builds.

    The suite has those of half of the rooms, and one build that leaves rooms out.
    """
    names, lean = sorted(set(programs().values())), LEAN_PROGRAMS
    if config.option.draw != "whole":
        names = sampling.generator(config, "sanitizers").sample(names, len(names) // 2)
        lean = [sampling.generator(config, "lean").choice(LEAN_PROGRAMS)]
    return [name + suffix for name in names for suffix in drawn_suffixes(config)], lean


def sanitized_targets(config):
    """Return what a run builds under the sanitizers."""
    if config.option.draw == "whole":
        return ("all", *LEAN_PROGRAMS)
    fuzzers = [f"fuzz_{name}{each}" for name in FUZZED for each in drawn_suffixes(config)]
    return (*drawn_programs(config)[0], *fuzzers)


def release_targets(config):
    """Return what a run builds by gcc of all that it may."""
    lean = drawn_programs(config)[1]
    if config.option.draw == "whole":
        return ("all", *lean)
    others = ("nck", "nck_host", "nck_small", "firmware", "blocks_of")
    return (*others, *sorted(set(programs().values())), *sorted(small_programs(config)), *lean)


def not_drawn(config, items):
    """Return the items that a run leaves out: under the sanitizers, in small capacities, lean."""
    drawn, small = drawn_programs(config), small_programs(config)
    tests = [each for each in items if isinstance(each, CTest)]
    return [each for each in tests if not each.is_drawn(*drawn, small)]


def link_anew(program, objects, target, *command):
    """Link a program of the release build, objects before its own libraries; return the target.

    So one file of the kernel is compiled otherwise, and nothing else. Objects of sources that are
    gone lie in the folder until it is made anew; they do not count.
    """
    folder, complaints = build_c("gcc", program)
    if complaints:
        raise CTestError(complaints[-4000:])
    place = folder / "CMakeFiles" / f"{program}.dir"
    own = [each for each in place.rglob("*.o")
           if (ROOT / each.relative_to(place)).with_suffix("").exists()]  # fmt: skip
    libraries = [folder / name for name in LIBRARIES]
    command = [*command, *objects, *own, *libraries, "-lm", "-l:libgomp.so.1", "-lpthread"]
    done = subprocess.run([*command, "-o", target], capture_output=True, text=True)
    if done.returncode != 0:
        raise CTestError(done.stderr)
    return target


class CTestError(Exception):
    """What a C test, or the compiler, said."""


class CTest(pytest.Item):
    """A C test in one build."""

    def __init__(self, *, build, program, **others):
        super().__init__(**others)
        self.build, self.program = build, program
        self.is_sanitized = build == SANITIZED

    def targets(self):
        """Return what a run builds for this test: all, or what a change in work needs."""
        if self.is_sanitized:
            return sanitized_targets(self.config)
        quick = self.config.option.draw == "quick"
        return (self.program,) if quick else release_targets(self.config)

    def is_drawn(self, sanitized, lean, small):
        """Tell whether a run has this test, by the names of the programs that it draws."""
        if self.is_sanitized:
            return self.program in sanitized
        if self.program in LEAN_PROGRAMS:
            return self.program in lean
        return self.name != "small" or self.program in small

    def runtest(self):
        folder, complaints = build_c(self.build, *self.targets())
        executable = folder / self.program
        if complaints and (not executable.exists() or self.program in complaints):
            raise CTestError(f"{self.program} was not built\n{complaints[-4000:]}")
        command = [executable] + ([self.path.stem] if self.program.startswith("tests_") else [])
        done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT_S)
        if done.returncode != 0:
            raise CTestError(f"exit status {done.returncode}\n{done.stdout}{done.stderr}")

    def repr_failure(self, excinfo, style=None):
        if isinstance(excinfo.value, CTestError):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self):
        return self.path, 0, self.name


class CTestFile(pytest.File):
    """A file of C tests."""

    def collect(self):
        stem = programs()[self.path]
        rows = [("release", "gcc", stem), ("small", "gcc", f"{stem}_small")]
        if self.path.stem in LEAN:
            rows += [(name.rpartition("_")[2], "gcc", name) for name in LEAN_PROGRAMS]
        rows += [("sanitized", SANITIZED, stem), ("sanitized_small", SANITIZED, f"{stem}_small")]
        for name, build, program in rows:
            yield CTest.from_parent(self, name=name, build=build, program=program)


def collect_file(file_path, parent):
    """Return the collector of a C test; None for any other file."""
    if file_path.suffix == ".c" and file_path.stem.startswith("test_"):
        return CTestFile.from_parent(parent, path=file_path)
    return None
