# SPDX-License-Identifier: MIT
"""The house rules for the look of a file, one by one: sizes, names, comments, simplicity."""

import ast
import re
from pathlib import Path

from house import (
    C_FILES,
    CL_FILES,
    CORE,
    GUESTS,
    PAGES,
    PYTHON_FILES,
    SOURCES,
    c_functions,
    complexity,
    identifiers,
    of_each,
    public_definitions,
    python_nodes,
    read,
    undocumented,
    without_comments,
    without_own_rules,
)

FORBIDDEN_WORDS = {"util", "utils", "helper", "helpers", "manager", "tmp", "interp"}
# Headers for others: not those that are compiled in variants, not those of another kernel.
PUBLIC_HEADERS = [
    name
    for name in C_FILES
    if name.endswith(".h")
    and name.startswith(("csrc/", "firmware_sim/"))
    and not name.startswith(("csrc/host/envelope/", "firmware_sim/glue/"))
]
PUBLIC_PYTHON = [name for name in PYTHON_FILES if name.startswith(("pycnc/", "cmake/", "docs/"))]


def forbidden(names):
    """Return the names that have a forbidden word in them; pytest's own fixtures are not ours."""
    fixtures = {"tmp_path", "tmp_path_factory"}
    words = {name: set(name.lower().split("_")) for name in names if name not in fixtures}
    return sorted(name for name, parts in words.items() if parts & FORBIDDEN_WORDS)


def assert_narrow(lines):
    """Hold numbered lines against what a screen shows."""
    wide = [number for number, line in lines if len(line) > 100]
    assert not wide, f"longer than 100 columns: line {', '.join(map(str, wide))}; break it there"


@of_each(SOURCES)
def test_a_file_has_its_licence_and_its_size(name):
    lines = read(name).split("\n")
    licence = "GPL-2.0-or-later" if name in GUESTS else "MIT"
    assert any(f"SPDX-License-Identifier: {licence}" in line for line in lines[:2])
    assert len(lines) <= 501, f"has {len(lines) - 1} lines, 500 at most: split it by thought"
    assert_narrow(enumerate(lines, 1))
    assert "TODO" not in without_own_rules(read(name))
    assert "\t" not in read(name) or name == "Makefile"


@of_each(PAGES)
def test_a_page_has_short_lines(name):
    lines = enumerate(read(name).split("\n"), 1)
    assert_narrow(each for each in lines if not each[1].lstrip().startswith("|"))


@of_each([name for name in C_FILES if name.startswith(("csrc/", "firmware_sim/", "adapters/"))])
def test_functions_of_c_are_simple(name):
    for function, count in complexity(name).items():
        assert count <= 12, f"{function} has {count} branches, 12 at most: give one part a name"


@of_each(PUBLIC_HEADERS)
def test_a_public_declaration_of_c_has_a_comment(name):
    assert list(undocumented(read(name))) == []


@of_each(PUBLIC_PYTHON)
def test_a_public_definition_of_python_has_a_docstring(name):
    defined = public_definitions(python_nodes(name)[0])
    assert [node.name for node in defined if not ast.get_docstring(node)] == []


@of_each(C_FILES)
def test_c_functions_are_short_and_shallow(name):
    for function, first, last, parameters, nesting in c_functions(read(name)):
        length = last - first + 1
        assert length <= 60, f"{function} has {length} lines, 60 at most: part it by phase"
        assert nesting <= 3, f"{function} is {nesting} blocks deep, 3 at most: give one a name"
        own = name not in GUESTS or not function.startswith("tp")
        told = f"{function} has {parameters} parameters, 6 at most: make a struct of some"
        assert parameters <= 6 or not own, told


@of_each(PYTHON_FILES)
def test_python_functions_are_short(name):
    for node in python_nodes(name):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            length = node.end_lineno - node.lineno + 1
            assert length <= 60, f"{node.name} has {length} lines, 60 at most: part it by phase"
            given = [each.arg for each in node.args.posonlyargs + node.args.args]
            by_place = [name for name in given if name not in ("self", "cls")]
            assert len(by_place) <= 6, f"{node.name}: what is more is given by name"


@of_each(C_FILES + CL_FILES)
def test_c_names_say_what_they_mean(name):
    found = set(re.findall(r"[A-Za-z_]\w*", without_comments(read(name))))
    assert forbidden(found | {Path(name).stem}) == []


@of_each(PYTHON_FILES)
def test_python_names_say_what_they_mean(name):
    assert forbidden(set(identifiers(python_nodes(name))) | {Path(name).stem}) == []


@of_each(CORE)
def test_preprocessor_branches_live_in_limits_real_and_bits(name):
    if name.endswith(("base/limits.h", "base/real.h", "base/bits.h")):
        return
    branches = re.findall(r"^\s*#\s*(?:if|ifdef|ifndef|elif)\b.*$", read(name), re.M)
    guard = re.compile(r"#ifndef (NCK_\w*H|__OPENCL_VERSION__)$|#ifdef __cplusplus$")
    assert [branch for branch in branches if not guard.match(branch.strip())] == []


@of_each(PYTHON_FILES)
def test_python_says_what_a_module_is_for(name):
    assert ast.get_docstring(python_nodes(name)[0])
