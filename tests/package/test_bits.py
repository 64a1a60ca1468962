# SPDX-License-Identifier: MIT
"""The same bits on every processor, and a compiler that would change them is stopped or found out.

The pair of files is compiled for four more processors, which QEMU plays, with options under which
their compilers fuse a·b + c unless the sources forbid it.
"""

import platform
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

import cases

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "tests" / "package" / "project" / "bits.c"
# gnu99: gcc fuses by itself, where the processor can.
OPTIONS = ["-std=gnu99", "-O1", "-fno-math-errno", "-DNDEBUG"]
PROCESSORS = {  # name of the compiler: (options, name of QEMU's)
    "i686": (["-msse2", "-mfpmath=sse"], "i386"),
    "aarch64": ([], "aarch64"),
    "riscv64": ([], "riscv64"),
    "s390x": ([], "s390x"),
}
NAMES = ("square", "full_circle", "helix", "tiny_circles", "reversals")
SELFTEST = ("selftest.c", "base/trig.c", "base/path.c")
MAIN = '#include <stdio.h>\n#include "nck/nck.h"\n%s\nint main(void) {\n%s' + (
    '    printf("%%d\\n", nck_selftest() == NCK_SELFTEST);\n    return 0;\n}\n'
)
FUSED = ["-std=gnu99", "-O2", "-mfma", "-ffp-contract=fast"]
CHANGED = [
    ["-freciprocal-math"],
    ["-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"],
    ["-funsafe-math-optimizations"],
]
REFUSED = [
    (["-ffast-math"], "-ffast-math changes setpoints"),
    (["-Ofast"], "-ffast-math changes setpoints"),
    (["-ffinite-math-only"], "-ffinite-math-only changes setpoints"),
]


def call(*command):
    """Run a command; return what it prints, or fail with its words."""
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode != 0:
        pytest.fail(f"{command}\n{done.stdout}{done.stderr}", pytrace=False)
    return done.stdout


@pytest.fixture(scope="module")
def pair(tmp_path_factory):
    """Return the folder that holds nck/nck.h and nck/nck.c."""
    folder = tmp_path_factory.mktemp("pair")
    call(sys.executable, ROOT / "cmake" / "amalgamate.py", "--out", folder / "nck")
    return folder


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    """Return files of a few programs, on the exact path and within a tolerance."""
    folder = tmp_path_factory.mktemp("programs")
    exact = [case for case in cases.PROGRAM_CASES if case.name in NAMES]
    rounded = [replace(case, text=case.text.replace("G61", "G64 P0.01")) for case in exact]
    assert len(exact) == len(NAMES)
    files = []
    for k, case in enumerate([*exact, *rounded]):
        files.append(folder / f"{k}.ngc")
        files[-1].write_text(case.text)
    return files


def setpoints(pair, programs, compiler, options, emulator):
    """Compile the pair for a processor; return what its emulator prints of the setpoints."""
    binary = pair / f"bits_{Path(compiler).name}"
    sources = [PROGRAM, pair / "nck" / "nck.c"]
    call(compiler, *OPTIONS, *options, f"-I{pair}", *sources, "-static", "-lm", "-o", binary)
    return call(*emulator, binary, *programs)


@pytest.fixture(scope="module")
def here(kernel_build, programs, tool, tmp_path_factory):
    """Return what this processor prints, a line for each number: the release build does."""
    binary = tmp_path_factory.mktemp("here") / "bits"
    sources = [PROGRAM, kernel_build[0] / "libnck.a"]
    call(tool("gcc"), *OPTIONS, f"-I{ROOT / 'csrc'}", *sources, "-lm", "-o", binary)
    lines = call(binary, *programs).splitlines()
    assert lines[0] == "1", "the test of arithmetic fails on this machine"
    assert len(set(lines)) > len(lines) // 2, "the programs do not tell anything apart"
    return lines


@pytest.mark.thorough
@pytest.mark.sample(1)
@pytest.mark.parametrize("name", PROCESSORS)
def test_setpoints_are_the_same_on_every_processor(pair, programs, here, tool, name):
    options, played = PROCESSORS[name]
    compiler, emulator = tool(f"{name}-linux-gnu-gcc"), [tool(f"qemu-{played}")]
    assert setpoints(pair, programs, compiler, options, emulator).splitlines() == here


PLANNED = """
import hashlib, sys, pycnc
for name in sys.argv[1:]:
    plan = pycnc.plan(pycnc.load(open(name).read(), machine="mill3"))
    print(hashlib.sha256(plan.cells.tobytes()).hexdigest())
"""


@pytest.mark.skipif(platform.machine() != "x86_64", reason="a processor without AVX2")
def test_the_module_plans_the_same_without_avx2(programs, tool):
    here = call(sys.executable, "-c", PLANNED, *programs)
    assert len(set(here.split())) == len(programs)
    old = [tool("qemu-x86_64"), "-cpu", "Nehalem", sys.executable]
    assert call(*old, "-c", PLANNED, *programs) == here


# What the compiler may not do


@pytest.fixture
def selftest(tool, tmp_path):
    """Return a function: whether the test of arithmetic passes as compiled; words of a refusal."""

    def run(compiler, *options, declares="", begins=""):
        (tmp_path / "main.c").write_text(MAIN % (declares, begins))
        sources = [ROOT / "csrc" / "nck" / name for name in SELFTEST]
        command = [tool(compiler), *options, f"-I{ROOT / 'csrc'}", tmp_path / "main.c", *sources]
        command += ["-lm", "-o", tmp_path / "main"]
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
        return call(tmp_path / "main").strip() == "1" if done.returncode == 0 else done.stderr

    return run


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("compiler", ["gcc", "clang-19"])
@pytest.mark.parametrize("level", ["-O0", "-O2", "-O3", "-Os"])
def test_arithmetic_passes_at_any_level(selftest, compiler, level):
    assert selftest(compiler, "-std=c99", level, "-ffp-contract=off") is True


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("compiler", ["gcc", "clang-19"])
@pytest.mark.parametrize("options", CHANGED, ids=" ".join)
def test_arithmetic_in_another_order_is_found(selftest, compiler, options):
    assert selftest(compiler, "-std=c99", "-O2", *options) is False


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("compiler", ["gcc", "clang-19"])
@pytest.mark.parametrize(("options", "words"), REFUSED, ids=str)
def test_fast_math_is_refused(selftest, compiler, options, words):
    assert words in selftest(compiler, "-std=c99", "-O2", *options)


def test_x87_is_refused(selftest):
    assert "compile with -msse2 -mfpmath=sse" in selftest("gcc", "-std=c99", "-mfpmath=387")


def has_fma():
    """Return whether this processor multiplies and adds at once."""
    return " fma " in Path("/proc/cpuinfo").read_text()


@pytest.mark.sample(quick=1)
@pytest.mark.skipif(not has_fma(), reason="this processor has no fused multiply-add")
@pytest.mark.parametrize("compiler", ["gcc", "clang-19"])
def test_fused_operations_are_found(selftest, compiler):
    assert selftest(compiler, *FUSED) is False


HEADERS = """
#include <fenv.h>
#include <xmmintrin.h>
"""
SETTINGS = {
    "flushed to zero": "    _mm_setcsr(_mm_getcsr() | 0x8040u);\n",
    "rounded up": "    (void)fesetround(FE_UPWARD);\n",
    "rounded down": "    (void)fesetround(FE_DOWNWARD);\n",
    "cut off": "    (void)fesetround(FE_TOWARDZERO);\n",
}


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("setting", SETTINGS)
def test_a_processor_that_is_set_otherwise_is_found(selftest, setting):
    found = selftest("gcc", "-std=c99", "-O2", declares=HEADERS, begins=SETTINGS[setting])
    assert found is False
