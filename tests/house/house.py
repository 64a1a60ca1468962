# SPDX-License-Identifier: MIT
"""How the house's tests read the sources: which files there are, and what stands in them."""

import ast
import functools
import gc
import re
import subprocess
from pathlib import Path

import lizard

ROOT = Path(__file__).resolve().parents[2]


def tracked(*patterns):
    """Return the files that git tracks or would track, as paths relative to the root."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "--", *patterns]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    return sorted(name for name in set(done.stdout.splitlines()) if (ROOT / name).is_file())


C_FILES = tracked("csrc/*.[ch]", "firmware_sim/*.[ch]", "adapters/*.[ch]", "tests/*.[ch]")
CL_FILES = tracked("opencl/*.cl", "opencl/*.h")
PYTHON_FILES = tracked("*.py")
OTHER_FILES = tracked("*.pyi", "*.cmake", "CMakeLists.txt", "Makefile", ".ci/run", "*.toml",
                      "page/*.mjs", "page/src/*", "pycnc/report/page.html",
                      "pycnc/controller/page.html")
PAGES = tracked("*.md")
SOURCES = C_FILES + CL_FILES + PYTHON_FILES + OTHER_FILES
CORE = [name for name in C_FILES if name.startswith("csrc/nck/")]
# The files under another licence: they include LinuxCNC's headers and have its signatures.
GUESTS = ("adapters/linuxcnc/nck_tp.c", "tests/linuxcnc/stand_in.c")


def of_each(names):
    """Make a rule for one file a test of all these files, which names every one that breaks it.

    As a test for each file there were 6500, and for each pytest takes 2 ms beside the rule.
    """

    def of_all(rule):
        def test():
            broken = {}
            for name in names:
                try:
                    rule(name)
                except AssertionError as said:
                    broken[name] = str(said)
                except Exception as cause:
                    cause.add_note(name)
                    raise
            assert names and not broken, "\n".join(": ".join(each) for each in broken.items())

        test.__name__, test.__doc__ = rule.__name__, rule.__doc__
        return test

    return of_all


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


def without_own_rules(text):
    """Drop the lines of this file that name what they forbid."""
    return re.sub(r'^.*"(TOD[O]|\.cdef\()".*$', "", text, flags=re.M)


def without_comments(text):
    """Blank out the comments, strings and characters of C text, keeping its lines."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)
    return pattern.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def c_functions(text):
    """Yield (name, first line, last line, parameters, nesting) of every function of C text."""
    text = without_comments(text)
    directive = re.compile(r"^\s*#(?:[^\n]*\\\n)*[^\n]*", re.M)
    text = directive.sub(lambda match: "\n" * match[0].count("\n"), text)
    head = re.compile(r"^(?=[A-Za-z_])[\w \t*]*?\b(\w+)\(([^;{}]*)\)\s*\{", re.M)
    for match in head.finditer(text):
        depth = deepest = blocks = 0
        kinds = []
        for end in range(match.end() - 1, len(text)):
            if text[end] == "{":
                before = text[:end].rstrip()
                is_block = before.endswith((")", "else", "do", ";", "}", "{", ":"))
                kinds.append(is_block)
                blocks += is_block
                deepest = max(deepest, blocks)
                depth += 1
            elif text[end] == "}":
                depth -= 1
                blocks -= kinds.pop()
                if depth == 0:
                    break
        first = text.count("\n", 0, match.start()) + 1
        last = text.count("\n", 0, end) + 1
        parameters = match[2].count(",") + 1
        yield match[1], first, last, parameters, deepest - 1


def identifiers(nodes):
    """Yield every name that nodes of Python define: functions, classes, arguments, variables."""
    for node in nodes:
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            yield node.name
        elif isinstance(node, ast.arg):
            yield node.arg
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id


@functools.cache
def python_nodes(name):
    """Return all nodes of a Python file's syntax tree, the whole first."""
    nodes = list(ast.walk(ast.parse(read(name))))
    gc.freeze()  # a tree has no rings: to look for some in all of them took longer than to read
    return nodes


def python_imports(name):
    """Return the full names of all modules that a Python file imports, wherever it does."""
    found = set()
    for node in python_nodes(name):
        if isinstance(node, ast.Import):
            found.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{name}: relative import"
            found.add(node.module)
            found.update(f"{node.module}.{alias.name}" for alias in node.names)
    return found


def complexity(name):
    """Return {function: cyclomatic complexity} of a C file."""
    found = lizard.analyze_file(str(ROOT / name)).function_list
    return {each.name: each.cyclomatic_complexity for each in found}


def call_graph(names):
    """Return {file: files whose functions it calls}; a header and its source are one file.

    The face of a folder (number/number.h) tells of all its files, and is one by itself.
    """
    is_face = re.compile(r"(?:^|/)(\w+)/\1\.h$")
    file_of = {name: name if is_face.search(name) else name.rsplit(".", 1)[0] for name in names}
    told = re.compile(r"^[a-z][\w *]*\([^;{}]*\);", re.M)  # which calls nobody
    texts = {name: told.sub("", without_comments(read(name))) for name in names}
    home = {
        function: file_of[name]
        for name in names
        for function, *_ in c_functions(read(name))
        if function.startswith("nck_")
    }
    graph = {}
    for name, text in texts.items():
        called = set(re.findall(r"\b(nck_\w+)\s*\(", text)) & home.keys()
        graph.setdefault(file_of[name], set()).update(home[call] for call in called)
    return graph


def circles(graph):
    """Return the nodes of a graph from which a way leads back to themselves."""
    beyond = {node: set(needs) - {node} for node, needs in graph.items()}
    for middle in graph:
        for node in graph:
            if middle in beyond[node]:
                beyond[node] = beyond[node] | beyond[middle]
    return sorted(node for node in graph if node in beyond[node])


def undocumented(text):
    """Yield the declarations of a header without a comment above or behind them.

    Declarations without an empty line between them share the comment of the first.
    """
    told, depth, goes_on = False, 0, False
    text = re.sub(r"#ifdef __cplusplus\n.*?\n#endif\n", "\n\n\n", text, flags=re.S)
    is_declaration = re.compile(
        r"#\s*define (?!\w+_H$)\w"
        r"|(typedef|enum|struct|static inline|extern)\b"
        r"|[a-z_]\w*\s[\w\s*]*\("
    )
    for code, line in zip(without_comments(text).split("\n"), text.split("\n")):
        code = code.rstrip()
        if depth == 0 and not goes_on:
            if not line.strip() or line.startswith("//"):
                told = line.startswith("//")
            elif is_declaration.match(code):
                told = told or "//" in line
                if not told:
                    yield line.strip()
        depth += sum(map(code.count, "({")) - sum(map(code.count, ")}"))
        if code.startswith("#"):
            goes_on = code.endswith("\\")
        elif code:
            goes_on = depth == 0 and not code.endswith((";", "}"))


def public_definitions(tree):
    """Yield the public functions, classes and methods that a Python module defines."""
    kinds = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
    for node in tree.body:
        if isinstance(node, kinds) and not node.name.startswith("_"):
            yield node
            if isinstance(node, ast.ClassDef):
                yield from public_definitions(node)
