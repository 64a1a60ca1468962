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


@of_each(SOURCES)
def test_a_file_has_its_licence_and_its_size(name):
    lines = read(name).split("\n")
    licence = "GPL-2.0-or-later" if name in GUESTS else "MIT"
    assert any(f"SPDX-License-Identifier: {licence}" in line for line in lines[:2])
    assert len(lines) <= 501
    assert [number for number, line in enumerate(lines, 1) if len(line) > 100] == []
    assert "TODO" not in without_own_rules(read(name))
    assert "\t" not in read(name) or name == "Makefile"


@of_each(PAGES)
def test_a_page_has_short_lines(name):
    lines = [line for line in read(name).split("\n") if not line.lstrip().startswith("|")]
    assert [line for line in lines if len(line) > 100] == []


@of_each(CORE)
def test_the_core_is_simple(name):
    assert {f: count for f, count in complexity(name).items() if count > 12} == {}


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
        assert last - first < 60, f"{function} has {last - first + 1} lines"
        assert nesting <= 3, f"{function} is {nesting} blocks deep"
        own = name not in GUESTS or not function.startswith("tp")
        assert parameters <= 6 or not own, f"{function} has {parameters} parameters"


@of_each(PYTHON_FILES)
def test_python_functions_are_short(name):
    for node in python_nodes(name):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            assert node.end_lineno - node.lineno < 60, f"{node.name} is too long"
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
