# SPDX-License-Identifier: MIT
"""The house rules of DESIGN.md and CONTRIBUTING.md, as far as a program can check them: who knows
whom, what the core may do, what stands in the repository. test_file_rules.py has those of a file.
"""

import ast
import re
import subprocess
import sys
from collections import Counter
from functools import cache
from pathlib import Path

import pytest
from house import (
    C_FILES,
    CL_FILES,
    CORE,
    GUESTS,
    PAGES,
    PYTHON_FILES,
    ROOT,
    SOURCES,
    c_functions,
    call_graph,
    circles,
    of_each,
    python_imports,
    read,
    without_comments,
    without_own_rules,
)

ROOMS = (
    "prep/1_decode", "prep/2_toolcomp", "prep/3_smooth", "prep/4_lookahead", "prep/5_slope",
    "tick/6_interpolate", "tick/7_transform",
)  # fmt: skip
# The wings of room 1: each may call those before it, by their faces, and all know the room's state.
DECODE = "nck/prep/1_decode/"
WINGS = (
    "state", "number", "tongue", "modal", "place", "macro", "motion", "lathe", "cycle", "line",
)  # fmt: skip
FACES = tuple(f"{DECODE}{wing}/{wing}.h" for wing in WINGS)
EXTRAS = ("typer", "rich", "pydantic", "matplotlib", "pyarrow", "pyopencl")
# The rooms of pycnc: each may import those before it.
PYTHON_ROOMS = (
    "errors", "names", "extras", "files", "kernel", "machine", "program", "device", "planning",
    "stages", "report", "controller", "linuxcnc", "papers", "bench", "cli",
)  # fmt: skip
# Who calls the kernel; everybody else may read its constants.
WRAPPERS = (
    "kernel/__init__", "kernel/batches", "kernel/bind", "kernel/kept", "kernel/records",
    "kernel/session", "machine/__init__",
    "planning/control", "planning/grades", "planning/parallel", "planning/sshape",
    "planning/whole", "stages", "report/path_error", "bench/timing",
)  # fmt: skip

# Headers beside a file of the adapter; those of LinuxCNC are for GUESTS alone.
LINUXCNC = ("rtapi.h", "rtapi_app.h", "rtapi_string.h", "hal.h", "motion.h", "motion_types.h",
            "tp.h")
HOST_OF_ADAPTER = ("arc.h", "back.h", "bounds.h", "feed.h", "follow.h", "moves.h", "planner.h",
                   "rates.h", "settings.h", "thread.h")

# What a firmware opens; nck_tools.h is for hosts and tests.
DOORS = ("nck/nck.h", "nck/nck_session.h", "nck/nck_memory.h")

# Which of our headers a file may include, by the longest path that fits the file.
MAY_INCLUDE = {
    "csrc/nck/base/": ("nck/base/",),
    **{f"csrc/nck/{room}/": ("nck/base/", f"nck/{room}/") for room in ROOMS},
    f"csrc/{DECODE}": ("nck/base/", f"{DECODE}decode.h", f"{DECODE}parts.h",
                       f"{DECODE}state/room.h", *FACES),
    **{f"csrc/{DECODE}{wing}/": ("nck/base/", f"{DECODE}state/", f"{DECODE}{wing}/", *FACES[:k])
       for k, wing in enumerate(WINGS)},
    "csrc/nck/nck.": ("nck/",),
    "csrc/nck/nck_": ("nck/",),
    "csrc/nck/front.": ("nck/nck_tools.h", "nck/base/"),
    "csrc/nck/selftest.": ("nck/",),
    "csrc/host/": ("nck/", "host/"),
    "opencl/": ("nck/base/", "_math.h", "host/unit.h", "opencl/"),
    "firmware_sim/os/": ("os/", "os.h"),
    "firmware_sim/app/": ("app/", *DOORS, "os.h", "hal.h"),
    "firmware_sim/hal/": ("hal", "board/board.h", "os/port.h"),
    "firmware_sim/board/": ("board/", "hal.h", "os.h"),
    "firmware_sim/examples/": ("nck/nck_memory.h", "board/board.h", "os.h"),
    "firmware_sim/soft_double/": ("soft_double/",),
    "firmware_sim/glue/": ("glue/", "os/os.h"),
    "firmware_sim/serve/": ("serve/", "inputs/inputs.h", *DOORS, "nck/base/fence.h"),
    "firmware_sim/moving/": ("moving/", "inputs/inputs.h", *DOORS, "pulse/pulse.h",
                             "serve/serve.h", "hal/input.h"),
    "firmware_sim/pulse/": ("pulse/", "nck/base/"),
    "firmware_sim/drive/": ("drive/", "nck/base/"),
    "firmware_sim/inputs/": ("inputs/", "hal/input.h", *DOORS, "nck/base/fence.h"),
    "firmware_sim/host_serve": ("host_s", "inputs/inputs.h", "serve/serve.h", *DOORS),
    "firmware_sim/host_switches": ("host_s", "hal/input.h", *DOORS),
    "firmware_sim/sim": ("nck/", "sim", "app/", "os.h", "hal.h"),
    "firmware_sim/sim_build": ("host/host.h", "sim"),
    "adapters/linuxcnc/": ("nck/nck.h", "nck/nck_tools.h", *HOST_OF_ADAPTER),
    "tests/linuxcnc/": ("host/host.h",),
    "tests/": ("nck/", "host/", "sim.h", "host_serve.h", "serve/", "inputs/", "check.h", "pace.h",
                 "os/", "board/", "app/", "hal/", "pulse/", "drive/", "soft_double/", "moving/"),
    "tests/house/fuzz/": ("nck/", "host/", "sim.h", "host_serve.h"),
    "tests/qemu/": ("nck/nck_tools.h", "nck/base/link.h", "board/", "mark.h", "traffic.h",
                    "pulse/", "drive/", "host_serve.h", "uart.h"),
    "tests/package/project/": ("nck/nck.h", "nck/nck_memory.h", "host/"),
}
PYCNC = [name for name in PYTHON_FILES if name.startswith("pycnc/")]
LIBC = {
    "memcpy", "memset", "memmove", "memchr", "memcmp", "strlen", "sqrt", "fabs", "floor",
    "__assert_fail",
}  # fmt: skip


# Who may know whom


@of_each(C_FILES + CL_FILES)
def test_a_room_includes_only_the_ground_and_itself(name):
    fits = [start for start in MAY_INCLUDE if name.startswith(start)]
    assert fits, f"{name}: stands in no room of the plan"
    allowed = MAY_INCLUDE[max(fits, key=len)]
    included = re.findall(r'^\s*#\s*include\s+"([^"]+)"', read(name), re.M)
    allowed += LINUXCNC if name in GUESTS else ()
    strangers = [
        header
        for header in included
        if not any(header.startswith(start) or header.endswith(start) for start in allowed)
    ]
    assert strangers == []


@of_each([name for name in C_FILES if name.endswith("_math.h")])
def test_a_formula_header_has_formulas_only(name):
    text = without_comments(read(name))
    assert not re.search(r"^\s*#\s*include\s+<", read(name), re.M), "includes a system header"
    heads = re.findall(r"^(?!#)(\w[^\n;{}]*)\(", text, re.M)
    assert all(head.startswith("static inline") for head in heads)


def test_files_of_the_core_do_not_call_in_circles():
    assert circles(call_graph(CORE)) == []


def wing_of(path):
    """Return the place of a path's wing in WINGS; the room's door stands behind them all."""
    folder = path.removeprefix(f"csrc/{DECODE}").rpartition("/")[0]
    return WINGS.index(folder) if folder else len(WINGS)


IN_DECODE = [name for name in CORE if name.startswith(f"csrc/{DECODE}")]


def test_a_wing_calls_those_before_it():
    graph = call_graph(IN_DECODE)
    arrows = [(one, other) for one, needs in graph.items() for other in needs]
    assert {wing_of(one) for one, _ in arrows} == set(range(len(WINGS) + 1))
    assert [(one, other) for one, other in arrows if wing_of(one) < wing_of(other)] == []


@cache
def of_decode():
    """Return {file: (how often it has each word, functions that it defines)} of room 1."""
    found = {}
    for name in IN_DECODE:
        defined = {function for function, *_ in c_functions(read(name))}
        found[name] = Counter(re.findall(r"\w+", without_comments(read(name)))), defined
    return found


def callers(function, header):
    """Return the files that call a function: not the one that has it, nor the header that tells it.

    An inline function of the header calls it for whoever includes that.
    """
    return [name for name, (words, defined) in of_decode().items()
            if words[function] > (name == header)
            and (function not in defined or name == header)]  # fmt: skip


@of_each([n for n in IN_DECODE if n.removeprefix("csrc/") in FACES or n.endswith("/parts.h")])
def test_a_face_tells_what_other_wings_call_and_parts_what_none_does(name):
    text = without_comments(read(name))
    told = re.findall(r"^(?!static )[a-z][\w ]*?[ *]+(nck_\w+)\(", text, re.M)
    assert told
    is_face = name.removeprefix("csrc/") in FACES
    for function in told:
        users = callers(function, name)
        beyond = [user for user in users if wing_of(user) != wing_of(name) or user == name]
        assert users and bool(beyond) == is_face, f"{function}: called by {users}"


@of_each(CORE)
def test_only_the_fence_and_the_link_know_atomics(name):
    if name.endswith(("base/link.h", "base/fence.h")):
        return
    text = without_comments(read(name))
    assert not re.search(r"__atomic|__sync|_Atomic|\bvolatile\b|stdatomic", text)


@of_each(PYCNC)
def test_a_room_of_python_imports_those_before_it(name):
    room = name.split("/")[1].removesuffix(".py")
    if room in ("__init__", "__main__", "examples"):  # the front doors; a program of its own
        return
    found = {module.split(".")[1] for module in python_imports(name) if module[:6] == "pycnc."}
    before = PYTHON_ROOMS[: PYTHON_ROOMS.index(room) + 1]
    binding = {"_nck", "_nck_tp"} if name == "pycnc/kernel/bind.py" else set()
    assert found <= {*before, *binding}


@of_each(PYCNC)
def test_cffi_and_opencl_have_one_door_each(name):
    packages = {module.split(".")[0] for module in python_imports(name)}
    assert "cffi" not in packages
    assert "pyopencl" not in packages or name == "pycnc/device/__init__.py"


@of_each(PYCNC)
def test_only_the_wrappers_call_the_kernel(name):
    if name.removeprefix("pycnc/").removesuffix(".py") in WRAPPERS:
        return
    tree = ast.parse(read(name))
    assert "ffi" not in {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    reached = (node for node in ast.walk(tree) if isinstance(node, ast.Attribute))
    calls = [node.attr for node in reached if getattr(node.value, "id", "") == "lib"]
    assert [call for call in calls if not call.startswith("NCK_")] == []


def test_python_modules_do_not_import_in_circles():
    graph = {}
    for name in PYCNC:
        module = name.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
        graph[module] = python_imports(name)
    graph["pycnc"] = set()  # the front door imports all and nobody needs it
    assert circles({module: found & graph.keys() for module, found in graph.items()}) == []


def test_the_wrapper_needs_cffi_and_numpy_alone():
    code = f"import pycnc, sys; print([name for name in {EXTRAS} if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_no_declaration_of_c_is_copied_by_hand():
    code = {name: without_own_rules(read(name)) for name in PYTHON_FILES}
    assert [name for name, text in code.items() if ".cdef(" in text] == ["cmake/make_binding.py"]


# The rooms


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_has_its_page_and_its_face(room):
    folder = ROOT / "csrc" / "nck" / room
    page = folder / "README.md"
    assert page.exists()
    assert len(page.read_text(encoding="utf-8").splitlines()) <= 80
    assert (folder / f"{room.split('_')[-1]}.h").exists()


def test_the_core_has_no_data(kernel_build):
    command = ["size", "-A", kernel_build[0] / "libnck.a"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    sections = re.findall(r"^(\.\S+)\s+(\d+)", done.stdout, re.M)
    relocated = ".data.rel.ro"  # constant tables of pointers in position-independent code
    data = [
        (section, size)
        for section, size in sections
        if section.startswith((".data", ".bss", ".tdata", ".tbss"))
        and not section.startswith(relocated)
        and int(size) > 0
    ]
    assert data == []


def test_the_core_calls_nothing_but_a_few_of_libc(kernel_build):
    command = ["nm", "-u", kernel_build[0] / "libnck.a"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    needed = set(re.findall(r"^\s+U (\w+)$", done.stdout, re.M))
    strangers = {name for name in needed if not name.startswith(("nck_", "_GLOBAL_OFFSET_TABLE_"))}
    assert strangers <= LIBC


@of_each([n for n in C_FILES if n.startswith(("csrc/", "firmware_sim/"))])
def test_no_static_local_that_changes(name):
    text = without_comments(read(name))
    assert re.findall(r"^[ \t]+static (?!const\b|inline\b)[^\n]*", text, re.M) == []


def test_the_knobs_are_few():
    knobs = re.findall(r"^#ifndef (NCK_\w+)$", read("csrc/nck/base/limits.h"), re.M)
    assert len([knob for knob in knobs if not knob.endswith("_H")]) <= 17


# The repository


@of_each(SOURCES + PAGES)
def test_a_page_that_is_named_is_there(name):
    named = {found.lstrip("./") for found in re.findall(r"[\w./-]+\.md\b", read(name))}
    pages = [f"/{page}" for page in PAGES]
    assert [found for found in named if not any(p.endswith(f"/{found}") for p in pages)] == []


def test_the_makefile_has_two_commands_and_three_for_those_who_change_it():
    text = read("Makefile")
    assert re.findall(r"^\.PHONY: (.*)$", text, re.M) == ["run test room quick campaign"]
    rules = re.findall(r"^([^\s#:=][^#:=\n]*):(?!=)", text, re.M)
    targets = {target for rule in rules for target in rule.split()}
    commands = {"run", "test", "room", "quick", "campaign"}
    assert {target for target in targets if "/" not in target} == {".PHONY", *commands}


# Programs among the tests that search for nothing.
TOOLS = {"campaign.py", "durations.py", "rooms.py", "lock.py", "measures.py", "table.py",
         "bcnc.py"}


def test_the_campaign_has_every_search():
    names = [name for name in PYTHON_FILES if name.startswith("tests/")
             and not Path(name).name.startswith("test_") and Path(name).name not in TOOLS
             and "\nif __name__ ==" in read(name)]  # fmt: skip
    counting = [name for name in C_FILES if "/test_" in name and "argv[1]" in read(name)]
    names += [Path(name).stem for name in counting]
    assert len(names) >= 12
    campaign = read("tests/campaign.py")
    assert [name for name in names if not re.search(rf'{name}[ "]', campaign)] == []


def test_ci_calls_the_test_command():
    assert "make test" in read(".ci/run")


def test_the_installed_packages_fit_together():
    command = [sys.executable, "-m", "pip", "--disable-pip-version-check", "check"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


# The front door

FRONT_MOST = 24  # functions: what a firmware calls
FRONT_LINES_MOST = 800  # that a file which includes it compiles: names of records, no rooms


def functions_of(header):
    return re.findall(r"^[a-z][\w ]*?[ *](nck_\w+)\(", read(header), re.M)


def test_the_front_door_is_small_and_knows_no_room():
    assert 20 < len(functions_of("csrc/nck/nck.h")) <= FRONT_MOST
    command = ["gcc", "-std=c99", "-E", "-P", "-Icsrc", "csrc/nck/nck.h"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    lines = [line for line in done.stdout.splitlines() if line.strip()]
    assert 200 < len(lines) <= FRONT_LINES_MOST
    assert "struct nck {" not in done.stdout


@pytest.mark.parametrize("header", ["nck.h", "nck_session.h", "nck_tools.h"])
def test_every_door_has_its_own_text(header):
    text = read(f"csrc/nck/{header}")
    told = re.findall(r"^//[^\n]*\n[a-z][\w ]*?[ *](nck_\w+)\(", text, re.M)
    assert told == functions_of(f"csrc/nck/{header}") != []


def kernel_members():
    """Return the names of nck_t's members."""
    text = without_comments(read("csrc/nck/nck_memory.h"))
    body = re.search(r"^struct nck \{(.*?)\n\};", text, re.S | re.M)[1]
    return re.findall(r"^    (?:nck_\w+_t|\}) (\w+);", body, re.M)


def test_the_kernel_has_members_that_are_looked_for():
    assert {"machine", "decode", "link", "interpolate", "wire"} <= set(kernel_members())


OUTSIDE = ("csrc/host/", "firmware_sim/", "pycnc/")


@of_each([n for n in C_FILES + PYTHON_FILES if n.startswith(OUTSIDE)])
def test_nobody_outside_of_the_kernel_touches_its_members(name):
    members = "|".join(kernel_members())
    assert re.findall(rf"\bnck\)?(?:\.|->|\[0\]\.)(?:{members})\b", read(name)) == []
