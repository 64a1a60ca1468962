# SPDX-License-Identifier: MIT
"""libnck as strangers take it: installed, by pkg-config, as one pair of files; the same setpoints.

Every project here lies outside of the tree and knows of libnck what an installation tells it.
"""

import array
import functools
import hashlib
import itertools
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import cases
import sampling
import targets

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "tests" / "package" / "project"
STRICT = (
    "-std=c99 -Wall -Wextra -Wpedantic -Werror -Wconversion -Wdouble-promotion -Wshadow -Wundef"
    " -Wvla -Wstrict-prototypes -Wmissing-prototypes -ffp-contract=off -fno-math-errno"
).split()
CORES = {
    "m4f": "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16".split(),
    "m7": "-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16".split(),
}
VERSION = re.search(r"project\(nck VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
CMAKE = Path(sys.executable).with_name("cmake")
NINJA = Path(sys.executable).with_name("ninja")


def call(*command, **options):
    """Run a command; return what it prints, or fail with its words."""
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, **options)
    if done.returncode != 0:
        pytest.fail(f"{command}\n{done.stdout}{done.stderr}", pytrace=False)
    return done.stdout


def digest(text):
    """Return the SHA-256 of a text."""
    return hashlib.sha256(text.encode()).hexdigest()


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    """Return the files of all programs that the kernel's default machine can run."""
    folder = tmp_path_factory.mktemp("programs")
    files = []
    for case in cases.PROGRAM_CASES:
        if case.machine == "mill3" and not case.set:
            files.append(folder / f"{case}.ngc")
            files[-1].write_text(case.text)
    return files


@pytest.fixture(scope="module")
def setpoints(programs):
    """Return a function: the digests of the setpoints of all programs from an executable."""

    def run_all(executable):
        return {file.stem: digest(call(executable, file)) for file in programs}

    return run_all


@pytest.fixture(scope="module")
def expected(gcc_build, setpoints, tmp_path_factory):
    """Return what the tree's own library makes of the programs."""
    executable = tmp_path_factory.mktemp("tree") / "run"
    library = gcc_build[0] / "libnck.a"
    call("gcc", *STRICT, f"-I{ROOT / 'csrc'}", PACKAGE / "run.c", library, "-lm", "-o", executable)
    found = setpoints(executable)
    assert len(set(found.values())) > len(found) // 2, "the programs do not tell anything apart"
    return found


@pytest.fixture(scope="module")
def prefix(gcc_build, tmp_path_factory):
    """Return an installation that was moved after it was made."""
    folder = tmp_path_factory.mktemp("installed")
    call(CMAKE, "--install", gcc_build[0], "--prefix", folder / "here")
    return (folder / "here").rename(folder / "there")


def configure(source, build, *options):
    """Configure a project with Ninja; return the finished process."""
    command = [CMAKE, "-S", source, "-B", build, "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={NINJA}"]
    return subprocess.run([*command, *options], capture_output=True, text=True)


def stranger(folder, *options):
    """Copy the stranger's project to a folder and configure it there."""
    source = shutil.copytree(PACKAGE, folder / "stranger")
    return configure(source, folder / "build", *options)


# find_package


def test_a_project_finds_the_package_and_gets_the_same_setpoints(
    prefix, setpoints, expected, tmp_path
):
    done = stranger(tmp_path, f"-DCMAKE_PREFIX_PATH={prefix}")
    assert done.returncode == 0, done.stdout + done.stderr
    call(CMAKE, "--build", tmp_path / "build")
    assert setpoints(tmp_path / "build" / "run") == expected
    assert not (tmp_path / "build" / "bulk").exists(), "a component that nobody asked for"


def test_a_component_brings_its_library_and_what_that_needs(prefix, tmp_path):
    want = "-DNCK_WANT=0.1;REQUIRED;COMPONENTS;nck;host"
    done = stranger(tmp_path, f"-DCMAKE_PREFIX_PATH={prefix}", want)
    assert done.returncode == 0, done.stdout + done.stderr
    call(CMAKE, "--build", tmp_path / "build")
    assert call(tmp_path / "build" / "bulk") == "0 50 0\n"


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("want", ["0.2;REQUIRED", "0.0;REQUIRED", "1;REQUIRED"])
def test_another_version_is_refused(prefix, tmp_path, want):
    done = stranger(tmp_path, f"-DCMAKE_PREFIX_PATH={prefix}", f"-DNCK_WANT={want}")
    assert done.returncode != 0
    assert f"nckConfig.cmake, version: {VERSION}" in done.stderr


def test_a_component_that_is_not_there_is_refused_by_name(gcc_build, tmp_path):
    call(CMAKE, "--install", gcc_build[0], "--prefix", tmp_path / "kernel", "--component", "nck")
    want = "-DNCK_WANT=0.1;REQUIRED;COMPONENTS;host"
    done = stranger(tmp_path, f"-DCMAKE_PREFIX_PATH={tmp_path / 'kernel'}", want)
    assert done.returncode != 0
    assert "no component host is installed here" in " ".join(done.stderr.split())


# pkg-config


def test_pkg_config_names_all_that_a_compiler_needs(prefix, setpoints, expected, tool, tmp_path):
    (pc,) = prefix.rglob("nck.pc")
    asked = {**os.environ, "PKG_CONFIG_PATH": str(pc.parent)}
    config = tool("pkg-config")
    flags = call(config, "--cflags", "--libs", "nck", env=asked).split()
    call("gcc", *STRICT, PACKAGE / "run.c", *flags, "-o", tmp_path / "run")
    assert setpoints(tmp_path / "run") == expected
    assert call(config, "--modversion", "nck", env=asked).strip() == VERSION


# Capacities


def kernel_size(nm, binary):
    """Return the size of the symbol that tests/package/sizes.c defines."""
    return int(re.search(r"^\w+ (\w+) \w kernel_size$", call(nm, "-S", binary), re.M)[1], 16)


@pytest.mark.seldom(4, "CMakeLists.txt", "cmake", "firmware_sim/board", "tests/package")
def test_an_installation_for_a_microcontroller_keeps_its_capacities(tool, tmp_path):
    compiler, nm = tool("arm-none-eabi-gcc"), tool("arm-none-eabi-nm")
    board = [f"--toolchain={ROOT / 'firmware_sim/board/arm-none-eabi.cmake'}", "-DNCK_CORE=m4f"]
    folders = ["-DCMAKE_INSTALL_LIBDIR=lib/m4f", "-DCMAKE_INSTALL_INCLUDEDIR=include/m4f"]
    done = configure(ROOT, tmp_path / "cross", *board, *folders, "-DNCK_CAPACITIES=SMALL")
    assert done.returncode == 0, done.stdout + done.stderr
    call(CMAKE, "--build", tmp_path / "cross")
    call(CMAKE, "--install", tmp_path / "cross", "--prefix", tmp_path / "small")
    done = stranger(tmp_path, f"-Dnck_DIR={tmp_path / 'small/lib/m4f/cmake/nck'}", *board)
    assert done.returncode == 0, done.stdout + done.stderr
    call(CMAKE, "--build", tmp_path / "build")
    sizes = []
    for given in (targets.capacities("small"), {}):
        definitions = [f"-D{name}={value}" for name, value in given.items()]
        options = [*CORES["m4f"], *definitions, f"-I{ROOT / 'csrc'}"]
        call(compiler, "-std=c99", *options, "-c", PACKAGE / "sizes.c", "-o", tmp_path / "sizes.o")
        sizes.append(kernel_size(nm, tmp_path / "sizes.o"))
    assert sizes[0] < sizes[1]
    assert kernel_size(nm, tmp_path / "build" / "libsizes.a") == sizes[0]


def test_a_capacity_that_does_not_exist_is_refused(tmp_path):
    done = configure(ROOT, tmp_path, "-DNCK_CAPACITIES=NCK_WINDOWS=128")
    assert done.returncode != 0
    assert "no capacity like NCK_WINDOWS=128" in done.stderr


# The pair of files


@pytest.fixture(scope="module")
def pair(gcc_build):
    """Return the folder of nck.h and nck.c, made by the build's target."""
    call(CMAKE, "--build", gcc_build[0], "--target", "amalgamation")
    return gcc_build[0] / "amalgamation" / "nck"


@pytest.mark.thorough
def test_the_pair_is_the_same_bytes_wherever_it_is_made(pair, tmp_path):
    for seed, folder in (("1", tmp_path), ("2", ROOT)):
        out = tmp_path / seed
        script = [sys.executable, ROOT / "cmake" / "amalgamate.py", "--out", out]
        call(*script, cwd=folder, env={**os.environ, "PYTHONHASHSEED": seed})
        for name in ("nck.h", "nck.c"):
            assert (out / name).read_bytes() == (pair / name).read_bytes()


def test_no_file_of_the_pair_leaves_its_macros_to_the_next(pair):
    text = (pair / "nck.c").read_text(encoding="utf-8")
    sources = [path.read_text(encoding="utf-8") for path in (ROOT / "csrc/nck").rglob("*.c")]
    names = {name for source in sources for name in re.findall(r"^#define (\w+)", source, re.M)}
    assert names
    assert [name for name in sorted(names) if f"\n#undef {name}\n" not in text] == []


@pytest.mark.thorough
@pytest.mark.sample(1)
@pytest.mark.parametrize("compiler", ["gcc", "clang-19"])
def test_the_pair_gives_the_same_setpoints(pair, setpoints, expected, tool, tmp_path, compiler):
    folder = shutil.copytree(pair, tmp_path / "nck")
    command = [tool(compiler), *STRICT, "-O1", f"-I{tmp_path}", PACKAGE / "run.c", folder / "nck.c"]
    call(*command, "-lm", "-o", tmp_path / "run")
    assert setpoints(tmp_path / "run") == expected


CPP = """
#include "nck/nck.h"
static double memory[120000];
static nck_machine_t machine;
int main() {
    nck_t *const kernel = nck_place(memory, sizeof memory);
    nck_machine_default(&machine);
    return nck_init(kernel, &machine, nullptr) == NCK_OK && nck_is_idle(kernel) ? 0 : 1;
}
"""
CPP_FLAGS = "-std=c++11 -fno-exceptions -fno-rtti -Wall -Wextra -Werror".split()


@pytest.mark.thorough
@pytest.mark.parametrize("form", ["library", "pair"])
def test_a_cpp_file_includes_links_and_runs(gcc_build, pair, tool, tmp_path, form):
    source, program = tmp_path / "firmware.cpp", tmp_path / "firmware"
    source.write_text(CPP)
    include, kernel = ROOT / "csrc", gcc_build[0] / "libnck.a"
    if form == "pair":
        include, kernel = pair.parent, tmp_path / "nck.o"
        call("gcc", "-std=c99", "-c", pair / "nck.c", "-o", kernel)
    for compiler, options in ((tool("clang++-19"), []), (tool("arm-none-eabi-g++"), CORES["m7"])):
        call(compiler, *CPP_FLAGS, *options, f"-I{include}", "-c", source, "-o", f"{program}.o")
        if not options:
            call("gcc", f"{program}.o", kernel, "-lm", "-o", program)
            call(program)


@pytest.mark.thorough
def test_every_public_header_links_from_cpp(gcc_build, tool, tmp_path):
    source, program = tmp_path / "all.cpp", tmp_path / "all"
    headers = [*(f"host/{path.name}" for path in sorted((ROOT / "csrc/host").glob("*.h"))),
               *(f"nck/base/{name}.h" for name in ("link", "machine", "status"))]  # fmt: skip
    lines = [f'#include "{name}"' for name in headers if not name.endswith("_math.h")]
    wanted = ("nck_host_decode", "nck_host_grade_rule", "nck_host_slope", "nck_host_bench_clock",
              "nck_host_jerk", "nck_host_keinert", "nck_host_threads",
              "nck_host_measure_float",
              "nck_host_triad", "nck_link_init", "nck_machine_check", "nck_status_id")  # fmt: skip
    addresses = ", ".join(f"(const void *)&{name}" for name in wanted)
    lines.append(f"static const void *const all[] = {{{addresses}}};")
    lines.append("int main(int count, char **) { return all[count - 1] ? 0 : 1; }\n")
    source.write_text("\n".join(lines))
    options = [*CPP_FLAGS, "-std=c++17", f"-I{ROOT / 'csrc'}"]
    call(tool("clang++-19"), *options, "-c", source, "-o", tmp_path / "all.o")
    libraries = [gcc_build[0] / "libnck_host.a", gcc_build[0] / "libnck.a"]
    call("gcc", tmp_path / "all.o", *libraries, "-lm", "-fopenmp", "-o", program)
    call(program)


@pytest.mark.thorough
@pytest.mark.sample(1)
@pytest.mark.parametrize("core", CORES)
def test_the_pair_compiles_for_a_microcontroller(pair, tool, tmp_path, core):
    # At any level, for what it says of a level the pair of the host does, and house/test_size.py.
    command = [tool("arm-none-eabi-gcc"), *STRICT, *CORES[core], "-O0", "-c", pair / "nck.c"]
    call(*command, "-o", tmp_path / "nck.o")


@pytest.mark.parametrize("set_name", ["OPTIMAL", None])
def test_the_pair_can_have_other_capacities(tool, tmp_path, set_name):
    script = [sys.executable, ROOT / "cmake" / "amalgamate.py", "--out", tmp_path / "nck"]
    wanted = {"NCK_WINDOW": 128, "NCK_CELL_MAX": 64, "NCK_CORNER_SPAN": 32}
    own = targets.capacities(set_name) if set_name else {}
    chosen = [f"--capacities={set_name}"] if set_name else []
    call(*script, *chosen, *(f"--define={name}={value}" for name, value in wanted.items()))
    for name, include, definitions in (
        ("pair", tmp_path, []),
        ("tree", ROOT / "csrc", [f"-D{name}={value}" for name, value in {**own, **wanted}.items()]),
    ):
        options = [*STRICT, *definitions, f"-I{include}", "-c", PACKAGE / "sizes.c"]
        call("gcc", *options, "-o", tmp_path / f"{name}.o")
    found = [kernel_size(tool("nm"), tmp_path / f"{name}.o") for name in ("pair", "tree")]
    assert found[0] == found[1]


def test_a_set_of_capacities_that_there_is_not_is_told(tmp_path):
    script = [sys.executable, ROOT / "cmake" / "amalgamate.py", "--out", tmp_path / "nck"]
    asked = subprocess.run([*script, "--capacities=TINY"], capture_output=True, text=True)
    assert asked.returncode == 1 and not (tmp_path / "nck").exists()
    sets = "SMALL, LINEAR, JERK, MILL, OPTIMAL, FULL, HOST"
    assert asked.stderr.strip() == f"no capacities TINY; there are: {sets}"


# docs/firmware.md


PAGE_PROGRAM = "G21 G90 G17 G91.1 G61\nS1200 M3\nM8\nG1 F3000 X60\nG3 X90 Y30 J30\nG1 Y80\nM9\nM2\n"
PAGE_END = [90_000_000, 80_000_000, 0]  # [nm]
PAGE_STEP = 50_001  # F3000 in one period, rounded at both ends [nm]


@pytest.fixture(scope="module")
def page_firmware(prefix, tmp_path_factory):
    """Return a function that runs the firmware of the page: (exit status, setpoints, outputs)."""
    folder = tmp_path_factory.mktemp("page")
    page = (ROOT / "docs" / "firmware.md").read_text(encoding="utf-8")
    for language, name in (("cmake", "CMakeLists.txt"), ("c", "firmware.c")):
        blocks = re.findall(rf"^```{language}\n(.*?)^```", page, re.M | re.S)
        assert blocks, f"the page has no {language}"
        (folder / name).write_text("".join(blocks), encoding="utf-8")
    shutil.copy(PACKAGE / "board.c", folder)
    strict = [word for word in STRICT if word != "-Wmissing-prototypes"]  # its caller is the board
    flags = f"-DCMAKE_C_FLAGS={' '.join(strict)}"
    done = configure(folder, folder / "build", f"-DCMAKE_PREFIX_PATH={prefix}", flags)
    assert done.returncode == 0, done.stdout + done.stderr
    call(CMAKE, "--build", folder / "build")

    def run(*panel, text=PAGE_PROGRAM, told=()):
        (folder / "part.ngc").write_text(text)
        command = [folder / "build" / "firmware", folder / "part.ngc", *map(str, panel)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60)
        assert done.stderr.splitlines()[:-1] == list(told)
        lines = done.stdout.splitlines()
        rows = [list(map(int, row.split())) for row in lines if row[0] in "-0123456789"]
        return done.returncode, rows, [row for row in lines if row[0] in "sc"]

    def prefill(text):
        (folder / "long.ngc").write_text(text)
        command = [folder / "build" / "firmware", folder / "long.ngc", "1", "abort"]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60)
        return int(done.stderr.splitlines()[-1])

    run.prefill = prefill
    return run


def test_the_planning_of_the_page_says_when_it_may_sleep(page_firmware, tmp_path):
    text = "G21 G90 G61 F3000\n" + "".join(f"X{k % 7} Y{k % 11}\n" for k in range(2000)) + "M2\n"
    steps = page_firmware.prefill(text)
    assert steps < 8 * 2000, "it plans on and on where only a tick makes room"


def largest_step(rows):
    """Return the longest way of an axis in one period [nm]."""
    return max(
        abs(after - before) for b, a in zip(rows, rows[1:]) for before, after in zip(b, a)
    )


def test_the_firmware_of_the_page_runs_a_program(page_firmware):
    status, rows, outputs = page_firmware()
    assert status == 0
    assert rows[-1] == PAGE_END
    assert largest_step(rows) <= PAGE_STEP
    assert outputs == ["spindle 1200", "coolant 1", "coolant 0"]


def test_the_firmware_of_the_page_runs_long_programs_and_tells_what_it_finds(
    page_firmware, request
):
    rng = sampling.generator(request.config, "long programs of the page")
    for count in (rng.randrange(300, 1000), rng.randrange(2000, 6000)):
        way = "".join(f"X{rng.uniform(0, 1):.3f} Y{rng.uniform(0, 1):.3f}\n" for _ in range(count))
        text = f"G21 G90 G17 G61 F3000 G1\n{way}X7 Y5\n"
        status, rows, _ = page_firmware(text=f"{text}M2\n")
        assert (status, rows[-1]) == (0, [7_000_000, 5_000_000, 0])
        status, rows, _ = page_firmware(
            text=f"{text}G3 X9 Y5 I1\nX1 Q1\nM2\n",
            told=[f"line {count + 3}, column 0: assumed-centre",
                  f"line {count + 4}, column 4: word-unused"],
        )  # fmt: skip
        assert (status, rows[-1]) == (0, [9_000_000, 5_000_000, 0])


def test_the_panel_of_the_page_holds_and_goes_on(page_firmware):
    _, free, _ = page_firmware()
    status, held, outputs = page_firmware(100, "hold", 1500, "start")
    assert status == 0
    assert held[-1] == PAGE_END
    assert held[1400] == held[1498] != free[1498], "it rests while it is held"
    assert largest_step(held) <= PAGE_STEP
    assert outputs == ["spindle 1200", "coolant 1", "coolant 0"]


def test_the_panel_of_the_page_overrides_and_aborts(page_firmware):
    _, free, _ = page_firmware()
    _, slow, _ = page_firmware(1, "half")
    assert slow[-1] == PAGE_END
    assert len(slow) > 1.5 * len(free)
    status, rows, outputs = page_firmware(100, "abort")
    assert status == 0
    assert rows[-1] not in ([0, 0, 0], PAGE_END)
    assert largest_step(rows[-2:]) <= 10, "it ends at rest, to nanometres a period"
    assert outputs[-1] == "coolant 1", "what was not executed is dropped"


# The examples, under an emulator


EXAMPLES = ROOT / "firmware_sim" / "examples"
TOOLCHAIN = ROOT / "firmware_sim" / "board" / "arm-none-eabi.cmake"
MACHINES = {"m4f": "mps2-an386", "m7": "mps2-an500"}


@pytest.fixture(scope="module")
def examples(tool, tmp_path_factory):
    """Return a function: the folder of the examples, built for a core."""
    tool("arm-none-eabi-gcc")

    @functools.cache
    def build(core):
        folder = tmp_path_factory.mktemp(f"examples_{core}")
        options = [f"--toolchain={TOOLCHAIN}", f"-DNCK_CORE={core}", "-DNCK_STRICT=ON"]
        done = configure(EXAMPLES, folder, *options)
        assert done.returncode == 0, done.stdout + done.stderr
        call(CMAKE, "--build", folder)
        return folder

    return build


def emulate(emulator, core, image, arguments, shift=3):
    """Run an image; return the exit status. An instruction takes 2^shift ns of its time."""
    arguments = ",".join(f"arg={word}" for word in ("image", *arguments))
    command = ["timeout", "60", emulator, "-M", MACHINES[core], "-kernel", image]
    command += ["-display", "none", "-monitor", "none", "-serial", "none"]
    command += ["-semihosting-config", f"enable=on,target=native,{arguments}"]
    command += ["-icount", f"shift={shift},align=off,sleep=off"]
    return subprocess.run(list(map(str, command)), capture_output=True).returncode


def logged(file, axes=9):
    """Return the setpoints of a log as tests/package/run.c prints them."""
    numbers = array.array("q", file.read_bytes())
    rows = (numbers[k : k + 3] for k in range(0, len(numbers), axes))
    return "".join(f"{x} {y} {z}\n" for x, y, z in rows)


@pytest.mark.seldom(4, "firmware_sim", "CMakeLists.txt", "cmake", "tests/package")
@pytest.mark.parametrize("of", [*itertools.product(MACHINES, ("bare_metal", "os_kernel"))], ids=str)
def test_an_example_drives_as_the_library_on_the_host(
    examples, programs, expected, tool, tmp_path, of
):
    core, name = of
    image = examples(core) / f"{name}.elf"
    for program in programs:
        if program.stem in ("star", "helix"):
            log = tmp_path / f"{program.stem}.bin"
            assert emulate(tool("qemu-system-arm"), core, image, (program, log)) == 0
            assert digest(logged(log)) == expected[program.stem], program.stem


@pytest.mark.seldom(4, "firmware_sim", "CMakeLists.txt", "cmake", "tests/package")
@pytest.mark.parametrize("name", ["bare_metal", "os_kernel"])
def test_an_example_on_a_core_that_is_too_slow_says_so(examples, programs, tool, tmp_path, name):
    image, arguments = examples("m4f") / f"{name}.elf", (programs[0], tmp_path / "log")
    assert emulate(tool("qemu-system-arm"), "m4f", image, arguments, shift=10) == 106
