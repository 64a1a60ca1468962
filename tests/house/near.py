# SPDX-License-Identifier: MIT
"""The same mutants in short: do the C tests of a source's own room notice?

What the suite has of tests/house/mutate.py. It is a matter of seconds, for the file of the mutant
is compiled alone; all else is the release build's; and tests that take long are left out: a
survivor would wait for them all.
"""

import subprocess
import tempfile
from pathlib import Path

import builds
import c_tests
import mutate

# What a test may take without any change [s], to be asked: the three of 14 in the slope that take
# longer have nine tenths of the time, and one kill of ten.
LONGEST_S = 0.4
SLOWER_CODE = 4.0  # times as long may code take that is compiled with mutate.FLAGS


class Near:
    """Judges mutants of sources by the tests of their own rooms, in the default capacities."""

    def __init__(self, folder):
        self._folder, self._tests, self._originals = Path(folder), {}, {}

    def _compile(self, text):
        """Return what the compiler makes of a file's text; None if it is no C."""
        source, binary = self._folder / "mutant.c", self._folder / "mutant.o"
        source.write_text(text, encoding="utf-8")
        command = ["gcc", "-std=c99", "-ffp-contract=off", "-fno-math-errno", *mutate.FLAGS]
        command += [f"-I{mutate.ROOT / 'csrc'}", "-c", source, "-o", binary]
        done = subprocess.run(command, capture_output=True)
        return binary.read_bytes() if done.returncode == 0 else None

    def _tests_of(self, room):
        """Return [(limit [s], test)], by what they take without any change."""
        if room not in self._tests:
            found = []
            for path, program in c_tests.programs().items():
                if path.parent.name == room and program != path.stem:
                    test = mutate.Test(room, path.stem, program)
                    took = test.time(600.0, builds.build_c("gcc", program)[0])
                    assert took is not None, f"{program} {path.stem} fails without any change"
                    if took > LONGEST_S:
                        continue
                    found.append((mutate.SLACK_S + mutate.SLOWER * SLOWER_CODE * took, test))
            self._tests[room] = sorted(found, key=lambda row: row[0])
        return self._tests[room]

    def judge(self, mutant):
        """Try one mutant; see mutate.judge."""
        text = (mutate.ROOT / "csrc" / "nck" / mutant.file).read_text(encoding="utf-8")
        if mutant.file not in self._originals:
            self._originals[mutant.file] = self._compile(text)
        now = self._compile(text[: mutant.begin] + mutant.now + text[mutant.end :])
        if now is None or now == self._originals[mutant.file]:
            return "same"
        linked = set()
        for limit_s, test in self._tests_of(mutate.room_of(mutant.file)):
            if self._folder / test.program not in linked:
                binary, program = self._folder / "mutant.o", self._folder / test.program
                linked.add(c_tests.link_anew(test.program, [binary], program, "gcc"))
            if test.time(limit_s, self._folder) is None:
                return f"{test.stem} ({test.program})"
        return "survived"


def run(mutants, count):
    """Judge mutants of sources by the tests of their own rooms; see mutate.tally."""
    with tempfile.TemporaryDirectory() as folder:
        near = Near(folder)
        some = [mutant for mutant in mutants if mutant.file.endswith(".c")]
        return mutate.tally(some, count, near.judge)
