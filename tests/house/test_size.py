# SPDX-License-Identifier: MIT
"""The tables in docs/size.md say what libnck costs on two cores, and nothing grows unseen.

In the suite they are measured on one core, flash or stacks beside the rest, both as drawn.
"""

import importlib.util
import re

import pytest
import sampling

pytestmark = pytest.mark.thorough

SLACK = 0.05  # how far a number of the page may be off


def load(root, name):
    spec = importlib.util.spec_from_file_location(name, root / f"tests/house/size/{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def size_table(root, tool):
    """Return the module tests/house/size/table.py."""
    tool("arm-none-eabi-gcc")
    tool("qemu-system-arm")
    return load(root, "table")


@pytest.fixture(scope="module")
def cores(size_table, pytestconfig, draw):
    """Return the cores whose columns are measured: in the suite the one that is drawn."""
    every = tuple(size_table.CORES)
    one = sampling.generator(pytestconfig, "size").choice(every)
    return every if draw == "whole" else (one,)


@pytest.fixture(scope="module")
def lean(size_table, pytestconfig, draw):
    """Return the sets of capacities that are linked: in the suite the one that is drawn."""
    every = size_table.LEAN_SETS
    one = sampling.generator(pytestconfig, "lean sizes").choice(every)
    return every if draw == "whole" else (one,)


@pytest.fixture(scope="module")
def parts(size_table, pytestconfig, draw):
    """Return the parts that are measured of those that compile: in the suite the one drawn."""
    every = tuple(size_table.PARTS)
    one = sampling.generator(pytestconfig, "parts of size").choice(every)
    return every if draw == "whole" else (one,)


@pytest.fixture(scope="module")
def measured(size_table, cores, lean, parts):
    """Return all numbers of the cores and of what is linked, measured now."""
    return size_table.numbers(size_table.table(cores, lean, parts))


@pytest.fixture(scope="module")
def written(root, size_table, cores, lean, parts):
    """Return the numbers of the page for the same, if they are of the compiler at hand."""
    _, text, _ = size_table.split_page((root / "docs" / "size.md").read_text(encoding="utf-8"))
    if size_table.compiler() not in text:
        pytest.skip(f"the tables were measured with another compiler than {size_table.compiler()}")
    left_out = {head for part, heads in size_table.PARTS.items() if part not in parts
                for head in heads}  # fmt: skip
    return {
        key: row if key[0].startswith("RAM") else columns(row, cores, size_table.CORES)
        for key, row in size_table.numbers(text).items()
        if key[0] not in left_out and (key[0] != size_table.LINKED or key[1] in lean)
    }


def columns(row, cores, every):
    """Return what a row of the page has for some of the cores: equal parts, core by core."""
    each = len(row) // len(every)
    return [n for k, core in enumerate(every) if core in cores for n in row[k * each :][:each]]


def off(written, measured):
    """Return the rows in which a number is off by more than the slack."""
    return {
        key: (written[key], measured[key])
        for key in measured.keys() & written.keys()
        if any(abs(now - was) > SLACK * was for was, now in zip(written[key], measured[key]))
    }


def test_the_tables_in_the_page_are_true(written, measured):
    hint = "renew them: python tests/house/size/table.py --write"
    assert list(measured) == list(written), hint
    assert off(written, measured) == {}, hint


def test_a_rise_by_six_percent_is_seen(measured):
    grown = {key: [round(number * 1.06) for number in row] for key, row in measured.items()}
    large = {key for key, row in measured.items() if max(row) >= 100}
    assert len(large) >= 30
    assert large <= off(measured, grown).keys()


def test_the_core_has_no_data_on_a_target(size_table, cores):
    for core in cores:
        data = [size_table.sizes(binary)[1] for binary in size_table.objects(core).values()]
        assert data and not any(data)


# Builds that leave out rooms and planners: nck_t and flash that their users count on [bytes]

MOST = {
    "linear": (21_440, {"m4f": 110_500, "m7": 89_500}),
    "jerk": (32_768, {"m4f": 134_500, "m7": 106_500}),
    "mill": (32_768, {"m4f": 126_000, "m7": 99_000}),
    "optimal": (163_840, {"m4f": 204_800, "m7": 163_840}),
}


@pytest.mark.parametrize("name", MOST)
def test_lean_builds_fit_into_their_memory(size_table, measured, cores, lean, parts, name):
    titles = [title.partition(" (")[0] for title in size_table.SETS.values()]
    sizes = measured["RAM: members of `nck_t` [bytes]", "**`sizeof(nck_t)`**"]
    most, flash_most = MOST[name]
    assert sizes[titles.index(name)] <= most
    if name in lean and "flash" in parts:
        linked = measured[size_table.LINKED, name]
        limits = [flash_most[core] for core in cores]
        assert all(flash <= limit for flash, limit in zip(linked, limits, strict=True))


# The protocol of grbl, without switches, for three axes

PROTOCOL_MOST = {"m4f": 6_208, "m7": 6_144}
SESSION_MOST = 576  # of serve_t


def compiled(size_table, core, source, folder, *options):
    """Return an object of firmware_sim, compiled for size for a small mill."""
    binary, root = folder / f"{source.stem}.o", size_table.ROOT
    definitions = [f"-D{each}" for each in size_table.definitions_of("mill")]
    options = [*size_table.OPTIONS[core], *size_table.DIALECT, "-Os", *definitions, *options]
    places = [f"-I{root / 'csrc'}", f"-I{root / 'firmware_sim'}"]
    size_table.run("gcc", *options, *places, "-c", source, "-o", binary)
    return binary


def told_of(page):
    """Return what the room's page tells of flash."""
    words = r"([\d,]+) bytes of flash on a Cortex-M4F, ([\d,]+)"
    numbers = re.search(words, page.read_text(encoding="utf-8")).groups()
    return {core: int(number.replace(",", "")) for core, number in zip(("m4f", "m7"), numbers)}


def test_the_protocol_fits_into_its_memory(size_table, cores, root, tmp_path):
    folder = root / "firmware_sim" / "serve"
    for core in cores:
        parts = {path.stem: size_table.sizes(compiled(size_table, core, path, tmp_path))
                 for path in sorted(folder.glob("*.c"))}  # fmt: skip
        assert not any(ram for _, ram in parts.values())
        flash = sum(flash for part, (flash, _) in parts.items() if part != "beside")
        assert flash <= PROTOCOL_MOST[core]
        assert abs(flash - told_of(folder / "README.md")[core]) <= SLACK * flash
    probe = tmp_path / "probe.c"
    probe.write_text('#include "serve/serve.h"\nchar size[sizeof(serve_t)];\n')
    assert size_table.sizes(compiled(size_table, "m7", probe, tmp_path))[1] <= SESSION_MOST


# The stack


def test_no_run_uses_more_stack_than_the_bound(size_table, cores, parts, tmp_path):
    if "stack" not in parts:
        pytest.skip("bounds of the stack are not drawn")
    stack, targets = size_table.stack, size_table.targets
    for core in cores:
        targets.build(core, "nck_called")
        image = targets.build(core) / "setpoints_default.elf"
        graph = stack.CallGraph(stack.objects_of(image), image)
        bound = graph.depth("Reset_Handler")
        case = next(case for case in size_table.CASES if case.name == "random_arcs_0")
        machine = size_table.Machine.load(case.machine, set={"path.slope": "jerk"})
        used = targets.run_setpoints(core, "default", case, machine, tmp_path).stack_bytes
        assert bound / 3 < used <= bound


SOURCES = {
    "recursion": "int f(int n); int f(int n) { return n ? n + f(n - 1) * n : 0; }",
    "nobody knows": "int g(int n); int f(int n); int f(int n) { return g(n) + 1; }",
    "unknown size": "int g(char *x); int f(int n); int f(int n) { char x[n]; return g(x) + 1; }",
}


@pytest.mark.parametrize("word", SOURCES)
def test_a_stack_without_a_bound_is_refused(size_table, cores, tmp_path, word):
    source, binary = tmp_path / "f.c", tmp_path / "f.o"
    source.write_text(SOURCES[word])
    options = [*size_table.OPTIONS[cores[0]], "-O1", "-fcallgraph-info=su"]
    size_table.run("gcc", *options, "-c", source, "-o", binary)
    stack = size_table.stack
    image = size_table.targets.build(cores[0]) / "setpoints_default.elf"
    with pytest.raises(stack.StackError, match=word):
        stack.CallGraph([binary], image).depth("f")
