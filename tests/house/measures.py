# SPDX-License-Identifier: MIT
"""The figures of the house: how it is built, how large it is, how much of it is told.

    .venv/bin/python tests/house/measures.py

A floor is a row of parts that need only those below it; an arrow back is a need within a ring of
parts, which no order of floors can have. Parts are rooms, wings, files or modules, and need whom
they call or import. Figures are those of the tree as it is, tracked files alone.
"""

import ast
import functools
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))

import house
import lizard

GENERATED = {"machine.md", "diagnostics.md", "json.md", "commands.md", "trace.md"}
SLOPE, DECODE = "csrc/nck/prep/5_slope/", "csrc/nck/prep/1_decode/"
PARAMETERS, COMPLEXITY = 6, 12
NUMBERS = ("double", "nck_real", "nck_num", "int64_t")


def room_of(name):
    """Return the room of a file of csrc/nck; the wires are a room each."""
    folder = re.match(r"csrc/nck/(?:prep/|tick/)?(\w+)/", name)
    return folder[1] if folder else name.rsplit(".", 1)[0]


def wing_of(name):
    """Return the wing of a file of room 1; its door is one, and what is beside it."""
    inside = name.removeprefix(DECODE)
    return inside.partition("/")[0] if "/" in inside else "door"


def grouped(graph, group):
    """Return the graph of the groups of a graph's nodes."""
    found = {group(node): set() for node in graph}
    for node, needs in graph.items():
        found[group(node)] |= {group(need) for need in needs} - {group(node)}
    return found


def reach(graph):
    """Return {node: all that it needs, and what those need}."""
    beyond = {node: set(needs) & graph.keys() - {node} for node, needs in graph.items()}
    for middle in graph:
        for node in graph:
            if middle in beyond[node]:
                beyond[node] = beyond[node] | beyond[middle]
    return beyond


def floors(graph):
    """Return (floors, arrows back) of a graph."""
    beyond = reach(graph)
    ring = {node: frozenset([node, *(n for n in beyond[node] if node in beyond[n])])
            for node in graph}  # fmt: skip
    back = sum(need in ring[node] and need != node
               for node, needs in graph.items() for need in needs & graph.keys())  # fmt: skip

    @functools.cache
    def height(node):
        below = {need for need in beyond[node] if ring[need] != ring[node]}
        return 1 + max(map(height, below), default=0)

    return max(map(height, graph), default=0), back


def core_calls(folder):
    """Return who calls whom, file by file, below a folder of csrc/nck."""
    return house.call_graph([name for name in house.CORE if name.startswith(folder)])


def module_imports():
    """Return {module of pycnc: modules of it that it imports}."""
    module = re.compile(r"(?:/__init__)?\.py$")
    names = {module.sub("", name).replace("/", "."): name
             for name in house.PYTHON_FILES if name.startswith("pycnc/")}  # fmt: skip
    graph = {one: house.python_imports(name) & names.keys() for one, name in names.items()}
    graph.pop("pycnc", None)
    return graph


def door():
    """Return (functions of nck.h, lines of it behind the preprocessor, share that is documented).

    A function is documented where a comment stands right above it.
    """
    text = house.read("csrc/nck/nck.h")
    found = re.findall(r"(^//[^\n]*\n)?^[a-z][\w *]*?\bnck_\w+\([^;{]*\);", text, re.M)
    command = ["gcc", "-E", "-P", "-I", str(house.ROOT / "csrc"), "csrc/nck/nck.h"]
    done = subprocess.run(command, cwd=house.ROOT, capture_output=True, text=True, check=True)
    lines = sum(bool(line.strip()) for line in done.stdout.splitlines())
    return len(found), lines, sum(map(bool, found)) / len(found)


def called_once():
    """Return (static functions of csrc/nck that one place calls, those without a reason, all).

    A reason is a formula, a condition, a phase that a table or a switch calls, a length of 20
    lines. Inline ones do not count.
    """
    once = every = without = 0
    function = re.compile(r"^static (?!inline|const)([\w *]*?)\b(\w+)\([^;{]*\)\s*"
                          r"\{([^\n]*\}| *\n.*?\n\})$", re.M | re.S)  # fmt: skip
    phase = re.compile(r"^\s*(?:case|default)\b.*?\b(\w+)\(|\b(\w+)(?=[,\s]*[,}]|\n)", re.M)
    for name in (name for name in house.CORE if name.endswith(".c")):
        text = house.without_comments(house.read(name))
        uses = Counter(re.findall(r"\b(\w+)\b", text))
        own = {each[2]: each for each in function.finditer(text)}
        single = [each for each in own.values() if uses[each[2]] == 2]
        phases = {word for found in phase.findall(text) for word in found}
        every += len(own)
        once += len(single)
        without += sum(each[1].strip() not in ("int", *NUMBERS) and each[2] not in phases
                       and each[3].count("\n") < 20 for each in single)  # fmt: skip
    return once, without, every


def doubles():
    """Return the static functions of csrc/nck that stand in two files, [[file: name, …], …]."""
    found = {}
    function = re.compile(r"^static [\w *]*?\b(\w+)(\([^;{]*\)\s*\{.*?\}$)", re.M | re.S)
    for name in (name for name in house.CORE if name.endswith(".c")):
        text = house.without_comments(house.read(name))
        for each in function.finditer(text):
            end = each.end() if each[0].count("\n") == 0 else text.index("\n}", each.start(2))
            body = " ".join(text[each.start(2) : end].split())
            found.setdefault(body, []).append(f"{name}: {each[1]}")
    return [names for names in found.values() if len({n.partition(":")[0] for n in names}) > 1]


def sources():
    """Return sources a 1000 lines of formula headers: a year of a work, a standard, a page."""
    texts = [house.read(name) for name in house.CORE if name.endswith("_math.h")]
    cited = re.compile(r"//.*(?:\b(?:19|20)\d\d\b|et al|IEEE|ISO|NISTIR)")
    lines = sum(text.count("\n") for text in texts)
    return 1000 * sum(len(cited.findall(text)) for text in texts) / lines


def glossary():
    """Return the words of the glossary, in its order."""
    rows = re.findall(r"^\| (?!word|---)([^|]+) \|", house.read("docs/glossary.md"), re.M)
    return [re.split(r"[,(]", row)[0].strip() for row in rows]


def rooms_of(word):
    """Return the rooms of csrc/nck, base left out, that have a file or a type of this name.

    Of several words the last is the thing: a velocity profile is a profile.
    """
    word = word.rpartition(" ")[2]
    own = re.compile(rf"\}} nck_{word}_t;")
    return {room_of(name) for name in house.CORE
            if Path(name).stem == word or own.search(house.read(name))} - {"base"}  # fmt: skip


def words_of_pages():
    """Return words of docs and DESIGN that nobody generates: (all, those of running text).

    All is what stands between blanks. Words of running text have a letter; no table, no code and
    no formula is one.
    """
    pages = [name for name in house.PAGES
             if name.startswith("docs/") and Path(name).name not in GENERATED]  # fmt: skip
    every = running = 0
    for text in map(house.read, [*pages, "DESIGN.md"]):
        every += len(text.split())
        text = re.sub(r"^```.*?^```|^ *\|.*?$|^    .*?$", "", text, flags=re.M | re.S)
        running += sum(bool(re.search(r"[^\W\d_]", word)) for word in text.split())
    return every, running


def wide(name):
    """Yield functions of a Python file with more parameters than the house has.

    What may only be said by its name is none: an option of the command line.
    """
    for node in house.python_nodes(name):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            given = [each.arg for each in node.args.posonlyargs + node.args.args]
            if len(given) - given[:1].count("self") > PARAMETERS:
                yield f"{name}: {node.name}"


def tangled(name):
    """Yield functions of a file that have more ways through them than the house has."""
    for each in lizard.analyze_file(str(house.ROOT / name)).function_list:
        if each.cyclomatic_complexity > COMPLEXITY:
            yield f"{name}: {each.name} ({each.cyclomatic_complexity})"


def broken(rule):
    """Return what breaks a rule for functions of Python, tests left out."""
    product = [name for name in house.PYTHON_FILES if not name.startswith("tests/")]
    return [each for name in product for each in rule(name)]


def figures():
    """Yield (what, figure) in the order of the table."""
    core, decode = core_calls("csrc/nck/"), core_calls(DECODE)
    for title, graph in (
        ("csrc/nck, rooms", grouped(core, room_of)), ("1_decode, wings", grouped(decode, wing_of)),
        ("1_decode, files", decode), ("5_slope, files", core_calls(SLOPE)),
        ("pycnc, modules", module_imports()),
    ):  # fmt: skip
        height, back = floors(graph)
        yield f"{title}: parts / floors / arrows back", f"{len(graph)} / {height} / {back}"
    functions, lines, told = door()
    yield "nck.h: functions / lines behind the preprocessor", f"{functions} / {lines:,}"
    yield "nck.h: documented each by itself", f"{told:.0%}"
    once, without, every = called_once()
    yield "static functions of csrc/nck called from one place", f"{once / every:.0%} of {every:,}"
    yield "those that are no formula, condition, phase or long", f"{without / every:.0%}"
    yield "static functions of csrc/nck that stand in two files", f"{len(doubles())}"
    yield "sources a 1000 lines of formulas", f"{sources():.1f}"
    yield "words of the glossary", f"{len(glossary())}"
    every, running = words_of_pages()
    yield "words of docs and DESIGN: all / running text", f"{every:,} / {running:,}"
    yield f"Python: functions with more than {PARAMETERS} parameters", f"{len(broken(wide))}"
    yield f"Python: functions beyond complexity {COMPLEXITY}", f"{len(broken(tangled))}"
    yield "lines of csrc/nck", f"{sum(house.read(name).count(chr(10)) for name in house.CORE):,}"


def main():
    print("| figure | |\n|---|---:|")
    for what, figure in figures():
        print(f"| {what} | {figure} |")
    for rule in (wide, tangled):
        print(f"\n{rule.__name__}:", *broken(rule), sep="\n  ")


if __name__ == "__main__":
    main()
