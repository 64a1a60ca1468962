# SPDX-License-Identifier: MIT
"""Change libnck in one small place after another: do the C tests notice?

A seeded sample of changes ("mutants") over base/, the wires and all rooms, each compiled into a
copy of the tree in build/mutate and run against the C tests: those of its own room first, the
quickest first, then all others. A test that fails, crashes or does not end kills the mutant.
Survivors are printed; those of tests/house/mutants*.toml are reviewed: nobody can tell them from
the original, for the reason that stands there. The exit status is 1 below the share of GOAL.

    python tests/house/mutate.py                      the sample, 100 mutants
    python tests/house/mutate.py --count 50 tick/     50 of the files whose path contains tick/
    python tests/house/mutate.py --seed 2             another sample
"""

import argparse
import hashlib
import math
import os
import re
import resource
import shutil
import subprocess
import sys
import tomllib
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "tests" / "decode")]

import against_rs274  # noqa: E402
import builds  # noqa: E402
import c_tests  # noqa: E402
import targets  # noqa: E402

FOLDER = ROOT / "build" / "mutate"
TREE = FOLDER / "tree"
BUILT = FOLDER / "out" / "tree"
COPIED = ("CMakeLists.txt", "cmake", "csrc", "firmware_sim", "tests")
PLACES = ("base", "prep", "tick", "nck.c", "front.c")
NINJA = Path(sys.executable).with_name("ninja")
# The room of tests that a folder of libnck has, where it is not the folder's name.
ROOMS = {"6_interpolate": "tick", "7_transform": "tick", "nck": "kernel"}
LIBRARIES = ("libnck.a", "libnck_small.a", "libnck_host.a", "libnck_host_small.a")
FOREIGN = {"controller"}  # rooms of tests that know no kernel
# What is undefined stops the program, as it does in the C tests under the sanitizers.
FLAGS = ("-O1", "-fsanitize=undefined,float-divide-by-zero,float-cast-overflow,bounds-strict",
         "-fsanitize-undefined-trap-on-error")  # fmt: skip
GOAL = 0.95
# A test that takes so many times as long, and so much longer, counts as one that never ends.
SLOWER, SLACK_S = 5.0, 2.0
LIMIT_S = 20.0  # of a family of programs
# The project as a part of another one: warnings are no errors then.
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(mutants LANGUAGES C)
add_subdirectory(tree)
"""

TOKEN = re.compile(
    r"(?P<blank>\s+|//[^\n]*|/\*.*?\*/|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*)"
    r"|(?P<text>\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*')"
    r"|(?P<number>(?:0[xX][0-9a-fA-F]+|\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+)[uUlLfF]*)"
    r"|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<sign><<=|>>=|\.\.\.|[-+*/%&|^=!<>]=|<<|>>|&&|\|\||\+\+|--|->|.)",
    re.S | re.M,
)
SWAPS = {
    "<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"),
    "==": ("!=",), "!=": ("==",), "&&": ("||",), "||": ("&&",),
    "+": ("-",), "-": ("+",), "*": ("/",), "/": ("*",), "%": ("*",),
    "&": ("|",), "|": ("&",), "<<": (">>",), ">>": ("<<",),
    "+=": ("-=", "="), "-=": ("+=", "="), "*=": ("/=", "="), "/=": ("*=", "="),
}  # fmt: skip
# How a statement begins that must stay: a declaration, a jump whose absence is no C.
KEPT = {"const", "static", "double", "int", "char", "void", "unsigned", "float", "long", "switch"}
KEPT |= {"case", "default", "return", "if", "for", "while", "do", "else", "struct", "enum"}


@dataclass(frozen=True)
class Token:
    """A word of C text."""

    kind: str
    text: str
    begin: int
    end: int


@dataclass(frozen=True)
class Mutant:
    """One change: of `file`, the characters from begin to end become `now`."""

    file: str
    begin: int
    end: int
    now: str
    line: int
    column: int
    source: str  # the line
    was: str

    def __str__(self):
        was, now = (" ".join(text.split()) for text in (self.was, self.now))
        return f"{self.file}:{self.line}: {was} → {now or '(nothing)'}"


def tokens_of(text):
    """Return the tokens of C text but for blanks, comments and directives."""
    found = (Token(match.lastgroup, match[0], *match.span()) for match in TOKEN.finditer(text))
    return [token for token in found if token.kind != "blank"]


def bodies(tokens):
    """Yield (first, behind the last) of the tokens of every function's body."""
    depth = first = 0
    for k, token in enumerate(tokens):
        if token.text == "{":
            depth += 1
            if depth == 1:
                first = k + 1 if tokens[k - 1].text == ")" else 0
        elif token.text == "}":
            depth -= 1
            if depth == 0 and first:
                yield first, k


def match_of(tokens, k):
    """Return the place of the parenthesis that closes the one at k."""
    depth = 0
    while True:
        depth += (tokens[k].text == "(") - (tokens[k].text == ")")
        if depth == 0:
            return k
        k += 1


def is_binary(text, token):
    """Tell whether an operator stands between two blanks, as only binary ones do here."""
    return text[token.begin - 1].isspace() and text[token.end].isspace()


def other_numbers(word):
    """Return a constant plus one and less one."""
    digits = word.rstrip("uUlL")
    if re.fullmatch(r"\d+|0[xX][0-9a-fA-F]+", digits):
        value, suffix = int(digits, 0), word[len(digits) :]
        lower = [f"{value - 1}{suffix}"] if value > 0 else []
        return [f"{value + 1}{suffix}", *lower]
    return [f"({word} + 1.0)", f"({word} - 1.0)"]


def statement_end(tokens, k):
    """Return the place of the semicolon that ends the statement at k; None if it is a block."""
    depth = 0
    while tokens[k].text not in ("{", "}"):
        depth += (tokens[k].text in "([") - (tokens[k].text in ")]")
        if tokens[k].text == ";" and depth == 0:
            return k
        k += 1
    return None


def is_removable(tokens, k, heads):
    """Tell whether a statement begins at k that C can do without."""
    before, word, after = tokens[k - 1].text, tokens[k], tokens[k + 1]
    if before not in (";", "{", "}", "else") and k - 1 not in heads:
        return False
    if word.text == "return":
        return k - 1 in heads  # an early one
    if word.text in KEPT or word.text in ("}", ";", "{"):
        return False
    is_declaration = word.text.endswith("_t") and after.kind == "name" or after.text == ":"
    return not is_declaration and not (word.text.endswith("_t") and after.text == "*")


def is_size(tokens, k):
    """Tell whether a number is the size of an array, which the address sanitizer is to judge."""
    is_index = (tokens[k - 1].text, tokens[k + 1].text) == ("[", "]")
    while is_index and tokens[k - 1].text not in (";", "{", "}", "(", "="):
        k -= 1
    is_type = tokens[k].text in KEPT - {"return", "case"} or tokens[k].text.endswith("_t")
    return is_index and is_type and tokens[k + 1].text != "["


def changes(text):
    """Yield (begin, end, what stands there instead) of every change of C text."""
    tokens = tokens_of(text)
    for first, behind in bodies(tokens):
        heads = set()  # where the parenthesis of an if, for or while closes
        in_for = set()
        for k in range(first, behind):
            if tokens[k].text in ("if", "for", "while"):
                close = match_of(tokens, k + 1)
                heads.add(close)
                if tokens[k].text == "for":
                    in_for.update(range(k + 1, close))
            if tokens[k].text == "if":
                yield tokens[k + 1].end, tokens[k + 1].end, "!("
        head = next((k for k in range(first, 0, -1) if tokens[k - 1].text in (";", "}")), 0)
        is_truth = "int" in {each.text for each in tokens[head : head + 3]}  # what it returns
        for k in range(first, behind):
            if is_truth and (tokens[k - 1].text, tokens[k].text) == ("return", "1"):
                yield tokens[k].begin, tokens[k].end, "0"  # 2 is as true
            else:
                yield from changes_at(text, tokens, k)
            if k in in_for or not is_removable(tokens, k, heads):
                continue
            end = statement_end(tokens, k)
            if end:
                yield tokens[k].begin, tokens[end].begin, ""


def changes_at(text, tokens, k):
    """Yield the changes of one token."""
    token = tokens[k]
    if token.kind == "number":
        for now in () if is_size(tokens, k) else other_numbers(token.text):
            yield token.begin, token.end, now
    elif token.text in SWAPS and is_binary(text, token):
        for now in SWAPS[token.text]:
            yield token.begin, token.end, now


def mutants_of(file):
    """Yield all mutants of a source file."""
    text = (ROOT / "csrc" / "nck" / file).read_text(encoding="utf-8")
    for begin, end, now in changes(text):
        if now == "!(":  # a condition, negated
            end = closing(text, begin)
            now = f"!({text[begin:end]})"
        line = text.count("\n", 0, begin) + 1
        line_begin = text.rfind("\n", 0, begin) + 1
        source = text[line_begin:].split("\n", 1)[0]
        yield Mutant(file, begin, end, now, line, begin - line_begin, source, text[begin:end])


def closing(text, at):
    """Return the place of the parenthesis that closes the one before `at`."""
    depth = 1
    for match in TOKEN.finditer(text, at):
        if match.lastgroup == "sign":
            depth += {"(": 1, ")": -1}.get(match[0], 0)
        if depth == 0:
            return match.start()
    raise ValueError("a parenthesis is not closed")


def draw(mutants, seed):
    """Return mutants in an order at random, which changes elsewhere in the code hardly disturb."""
    seen = Counter()
    keys = {}
    for mutant in mutants:
        words = f"{mutant.file} {mutant.source.strip()} {mutant.column} {mutant.was} {mutant.now}"
        keys[mutant] = hashlib.sha256(f"{seed} {seen[words]} {words}".encode()).digest()
        seen[words] += 1
    return sorted(mutants, key=keys.get)


def sample(seed, only):
    """Return all mutants of the chosen files in an order at random."""
    base = ROOT / "csrc" / "nck"
    given = [base / place for place in PLACES]
    paths = [path for path in given if path.is_file()]
    paths += [path for folder in given for path in folder.rglob("*.[ch]")]
    files = sorted(path.relative_to(base).as_posix() for path in paths)
    chosen = [file for file in files if not only or any(word in file for word in only)]
    return draw([mutant for file in chosen for mutant in mutants_of(file)], seed)


def copy_tree():
    """Bring the copy up to date; what has not changed is left, so that little is built."""
    kept = set()
    for name in COPIED:
        source = ROOT / name
        for path in [source] if source.is_file() else sorted(source.rglob("*")):
            target = TREE / path.relative_to(ROOT)
            kept.add(target)
            if path.is_dir() or path.suffix in (".py", ".pyc"):
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            if not target.exists() or target.read_bytes() != path.read_bytes():
                shutil.copyfile(path, target)
    for path in sorted(TREE.rglob("*"), reverse=True):
        if path.is_file() and path not in kept:
            path.unlink()
    (FOLDER / "CMakeLists.txt").write_text(PROJECT)


def make(*targets):
    """Build targets of the copy. Returns whether they are built."""
    command = [NINJA, "-C", FOLDER / "out", *(f"tree/{target}" for target in targets)]
    return subprocess.run(command, capture_output=True).returncode == 0


def configure():
    """Make the build folder."""
    cmake = NINJA.with_name("cmake")
    builds.keep_what_is_compiled()
    command = [cmake, "-S", FOLDER, "-B", FOLDER / "out", "-G", "Ninja"]
    command += [f"-DCMAKE_MAKE_PROGRAM={NINJA}", "-DCMAKE_C_COMPILER=gcc", "-DNCK_TESTS=ON"]
    command += ["-DCMAKE_BUILD_TYPE=Mutate", f"-DCMAKE_C_FLAGS_MUTATE={' '.join(FLAGS)}"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stdout + done.stderr)


@dataclass(frozen=True)
class Test:
    """A C test in one set of capacities."""

    room: str
    stem: str
    program: str

    def time(self, limit_s, folder=BUILT):
        """Run it. Returns the processor's time [s]; None: it failed or took over the limit."""
        limit = math.ceil(limit_s)
        begin = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        done = subprocess.run(
            [folder / self.program, self.stem],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)),
        )
        took = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - begin
        return took if done.returncode == 0 else None


PROGRAMS = 10  # of each family, those that the suite holds against rs274


class Programs:
    """Random programs that the suite holds against rs274: what rooms 1 and 2 make of them.

    Where that differs from what the original makes, the suite would have told.
    """

    stem, program = "against_rs274", "blocks_of"

    def __init__(self, room):
        self.room, self._expected = room, None
        self._runs = [_written(name, family) for name, family in against_rs274.FAMILIES.items()]

    def time(self, limit_s):
        """Run them. Returns the processor's time [s]; None: other blocks, or over the limit."""
        limit = math.ceil(limit_s)
        begin = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        found = []
        for files in self._runs:
            done = subprocess.run(
                [BUILT / self.program, *files],
                capture_output=True,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)),
            )
            found.append((done.returncode, done.stdout))
        self._expected = self._expected or found
        took = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - begin
        return took if found == self._expected else None


def _written(name, family):
    """Write a family's machine and programs; return their files."""
    folder = FOLDER / "programs" / name
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "machine").write_bytes(targets.machine_image(family.machine(), "default"))
    files = [folder / "machine"]
    for seed in range(1, 1 + PROGRAMS):
        text = family.write(seed)
        files.append(folder / f"{seed}.ngc")
        files[-1].write_bytes(text[0] if isinstance(text, tuple) else text)
    return files


def room_of(file):
    """Return the room whose tests are the nearest to a file of libnck."""
    folder = re.match(r"(?:prep/|tick/)?(?:(\w+)/)?", file)[1] or "nck"  # whatever wing of it
    return ROOMS.get(folder, folder.partition("_")[2] or folder)


def tests_of(rooms):
    """Build and run the tests of rooms on the original; return [(limit [s], test)]."""
    found = [(LIMIT_S, Programs(room)) for room in rooms if room in ("decode", "toolcomp")]
    for _, programs in found:
        if not make(programs.program) or programs.time(LIMIT_S) is None:
            sys.exit("the programs do not run without any change")
    for path, program in c_tests.programs().items():
        if path.parent.name not in rooms:
            continue
        for suffix in c_tests.SUFFIXES:
            test = Test(path.parent.name, path.stem, f"{program}{suffix}")
            took = test.time(600.0) if make(test.program) else None
            if took is None:
                sys.exit(f"{test.program} {test.stem} fails without any change")
            found.append((SLACK_S + SLOWER * took, test))
    return sorted(found, key=lambda row: row[0])


def fingerprint():
    """Return a hash of all that the compiler made of the kernel."""
    digest = hashlib.sha256()
    for library in LIBRARIES:
        digest.update((BUILT / library).read_bytes())
    return digest.digest()


def in_order_for(file, tests):
    """Return the tests for a mutant of a file: its own room's, then the others."""
    own = [row for row in tests if row[1].room == room_of(file)]
    return own + [row for row in tests if row not in own]


def killer_of(tests):
    """Return the first test that notices the change; None if none does."""
    made = set()
    for limit_s, test in tests:
        if test.program not in made and not make(test.program):
            return test.program
        made.add(test.program)
        if test.time(limit_s) is None:
            return f"{test.stem} ({test.program})"
    return None


def judge(mutant, tests, original):
    """Try one mutant. Returns "same" for one that the compiler cannot tell from the original or
    does not compile, the test that kills it, or "survived"."""
    path = TREE / "csrc" / "nck" / mutant.file
    text = path.read_text(encoding="utf-8")
    path.write_text(text[: mutant.begin] + mutant.now + text[mutant.end :], encoding="utf-8")
    try:
        if not make(*LIBRARIES) or fingerprint() == original:
            return "same"
        return killer_of(in_order_for(mutant.file, tests)) or "survived"
    finally:
        path.write_text(text, encoding="utf-8")


def name_of(mutant):
    """Return what names a mutant in tests/house/mutants*.toml."""
    return mutant.file, mutant.source.strip(), mutant.was, " ".join(mutant.now.split())


def reviewed():
    """Return the names of the mutants of tests/house/mutants*.toml."""
    files = map(Path.read_bytes, (ROOT / "tests" / "house").glob("mutants*.toml"))
    rows = [row for text in files for row in tomllib.loads(text.decode())["equivalent"]]
    return {(row["file"], row["line"], row["was"], row["now"]) for row in rows}


def tally(mutants, count, judged):
    """Judge mutants until `count` of them were killed or survived; return the survivors, killed."""
    known = reviewed()
    survivors, killed, same = [], 0, 0
    for mutant in mutants:
        if killed + len(survivors) == count:
            break
        if name_of(mutant) in known:
            same += 1
            continue
        verdict = judged(mutant)
        same += verdict == "same"
        killed += verdict not in ("same", "survived")
        if verdict == "survived":
            survivors.append(mutant)
        print(f"{killed + len(survivors):4}  {verdict:40}{mutant}", flush=True)
    print(f"\n{same} mutants more are the same program, or none")
    return survivors, killed


def run(mutants, count):
    """Judge mutants by all tests in both sets of capacities; see tally."""
    copy_tree()
    configure()
    if not make(*LIBRARIES):
        sys.exit("libnck does not build")
    original = fingerprint()
    tests = tests_of({path.parent.name for path in c_tests.programs()} - FOREIGN)
    return tally(mutants, count, lambda mutant: judge(mutant, tests, original))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--count", type=int, default=100, help="mutants to judge")
    parser.add_argument("--seed", type=int, default=1, help="which sample")
    parser.add_argument("only", nargs="*", help="words, one of which a file's path contains")
    given = parser.parse_args()
    os.nice(10)
    survivors, killed = run(sample(given.seed, given.only), given.count)
    for mutant in survivors:
        print(f"survived  {mutant}\n          {mutant.source.strip()}")
    judged = killed + len(survivors)
    print(f"{killed} of {judged} mutants killed")
    return killed < GOAL * judged


if __name__ == "__main__":
    sys.exit(main())
