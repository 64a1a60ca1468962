# SPDX-License-Identifier: MIT
"""The link between prep and tick: interrupted at every instruction, and between two threads; and
the whole kernel in three threads.

The negative controls change one thing in a copy of base/, and must be caught.
"""

import os
import shutil
import subprocess
from dataclasses import dataclass

import pytest
import targets
from cases import PROGRAM_CASES

import pycnc
from pycnc.machine import Machine

GAPS = (211, 307, 503, 997)  # instructions of prep between two interrupts
CLOCKS_PER_INSTRUCTION = 25.6  # SysTick counts every 40 ns; -icount shift=10 is 1024 ns
INTERRUPTS = 10_000
CELLS = 30_000
PATIENCE_S = 120  # sixty times what the threads take
WAYS = {"batches": 0, "plans": 1, "bare": 2}  # traffic_way_t
SWEPT = ("batches", "plans")
OPTIONS = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off"]
THREADED = [case for case in PROGRAM_CASES if case.name in ("planes", "waits")]
SMALL = [f"-D{macro}={value}" for macro, value in targets.capacities("small").items()]
CORES = {
    "m4f": ["-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16", "-mthumb", "-mfloat-abi=hard"],
    "m7": ["-mcpu=cortex-m7", "-mfpu=fpv5-d16", "-mthumb", "-mfloat-abi=hard"],
}


@dataclass(frozen=True)
class Fault:
    """A change that must be caught: in `file` of base/, `was` becomes `now`."""

    name: str
    file: str
    was: str
    now: str

    def __str__(self):
        return self.name


OUTPUT_WRITE = "    self->output[self->output_head & (NCK_OUTPUT_MAX - 1)] = *output;\n"
OUTPUT_PUBLISH = "    nck_fence_store(&self->output_head, self->output_head + 1);\n"
CELL_READ = "    *cell_out = self->cell[self->taken & (NCK_CELL_MAX - 1)];\n"
CELL_FREE = "    nck_fence_store(&self->taken, (self->taken + 1) & NCK_LINK_COUNT_MASK);\n"
EXCHANGE = (
    "    return __atomic_compare_exchange_n(word, &expected, desired, 0, __ATOMIC_ACQ_REL,\n"
    "                                       __ATOMIC_ACQUIRE);\n"
)

OUTPUT_FIRST = Fault(
    "an output is published before it is written", "link.c", OUTPUT_WRITE + OUTPUT_PUBLISH,
    "    const uint32_t at = self->output_head & (NCK_OUTPUT_MAX - 1);\n"
    + OUTPUT_PUBLISH + "    __asm__ volatile(\"\" ::: \"memory\");\n"
    + "    self->output[at] = *output;\n",
)  # fmt: skip
NO_EXCHANGE = Fault(
    "the exchange can be interrupted", "fence.h", EXCHANGE,
    "    if (*(const volatile uint32_t *)word != expected) return 0;\n"
    "    *(volatile uint32_t *)word = desired;\n    return 1;\n",
)  # fmt: skip
SAME_TAIL = Fault(
    "the tail in use is written over", "link.c", "return 1u - nck_link_parity(self->base);",
    "return nck_link_parity(self->base);",
)  # fmt: skip
NO_WAIT = Fault(
    "prep goes on before the tail has come to rest", "link.c", "!= end + 1) return NCK_FULL;",
    "== end + 2) return NCK_FULL;",
)  # fmt: skip
NO_LOSS = Fault(
    "prep does not see that it lost", "link.c",
    "if (!nck_fence_exchange(&self->word, self->base, word)) return NCK_E_STATE;",
    "nck_fence_store(&self->word, word);",
)  # fmt: skip
ROOM = Fault(
    "one cell more than there is room for", "link.c", "return NCK_CELL_MAX - used;",
    "return NCK_CELL_MAX + 1 - used;",
)  # fmt: skip
PLAIN_STORE = Fault(
    "words are stored without release", "fence.h", "__ATOMIC_RELEASE", "__ATOMIC_RELAXED"
)
PLAIN_LOAD = Fault(
    "words are read without acquire", "fence.h", "return __atomic_load_n(word, __ATOMIC_ACQUIRE);",
    "return *word;",
)  # fmt: skip
FREE_FIRST = Fault(
    "a cell's place is free before it is read", "link.h", CELL_READ + CELL_FREE,
    CELL_FREE + CELL_READ.replace("self->taken &", "(self->taken - 1) &"),
)  # fmt: skip

SWEEP_FAULTS = (OUTPUT_FIRST, NO_EXCHANGE, SAME_TAIL, NO_WAIT, NO_LOSS, ROOM)
THREAD_FAULTS = (OUTPUT_FIRST, PLAIN_STORE, PLAIN_LOAD, FREE_FIRST, SAME_TAIL, NO_WAIT)


GROUND = ("link.c", "marks.c")  # what the link calls


def ground(folder, fault=None):
    """Return the include folder and the link's sources: the real ones, or with a fault."""
    csrc = targets.ROOT / "csrc"
    if fault is None:
        return [f"-I{csrc}", *(csrc / "nck" / "base" / name for name in GROUND)]
    copy = folder / "csrc"
    shutil.copytree(csrc / "nck" / "base", copy / "nck" / "base", dirs_exist_ok=True)
    file = copy / "nck" / "base" / fault.file
    text = file.read_text(encoding="utf-8")
    assert text.count(fault.was) >= 1, f"{fault.file} has nothing that can be changed so"
    file.write_text(text.replace(fault.was, fault.now), encoding="utf-8")
    return [f"-I{copy}", *(copy / "nck" / "base" / name for name in GROUND)]


def compile_c(compiler, options, sources, program):
    command = [compiler, *OPTIONS, *SMALL, *options, f"-I{targets.ROOT / 'tests' / 'qemu'}"]
    command += [targets.ROOT / "tests" / "qemu" / name for name in sources]
    done = subprocess.run([*command, "-o", program], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def build_sweep(core, tool, folder, fault=None):
    """Build the sweep's image for a core."""
    sim, board = targets.ROOT / "firmware_sim", targets.ROOT / "firmware_sim" / "board"
    options = [*CORES[core], "-O2", "-DNDEBUG", *ground(folder, fault), f"-I{sim}", "-nostartfiles"]
    options += [board / "startup.c", board / "board.c", f"-L{board}", f"-T{core}.ld"]
    image = folder / f"sweep_{core}.elf"
    compile_c(tool("arm-none-eabi-gcc"), options, ["link_sweep.c", "traffic.c"], image)
    return image


def build_threads(tool, folder, fault=None):
    """Build the two threads under the thread sanitizer."""
    options = ["-O1", "-g1", "-fsanitize=thread", *ground(folder, fault), "-pthread"]
    program = folder / "threads"
    compile_c(tool("clang-19"), options, ["link_threads.c", "traffic.c"], program)
    return program


def sweep(core, image, gap, way):
    """Run the sweep; return what it says, empty if no rule is broken."""
    clocks, appetite = round(gap * CLOCKS_PER_INSTRUCTION), gap // 80 + 1
    try:
        targets.emulate(core, image, clocks, INTERRUPTS, appetite, WAYS[way], shift=10)
    except targets.TargetError as cause:
        return str(cause)
    return ""


def run_threads(program, way):
    """Run the threads; return what they say, empty if all is well. Two that wait for each other
    for ever say nothing: they take 2 s else."""
    first = {**os.environ, "TSAN_OPTIONS": "halt_on_error=1"}
    command = [program, str(CELLS), str(WAYS[way])]
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=PATIENCE_S, env=first, check=False
        )
    except subprocess.TimeoutExpired:
        return "broken: both threads wait"
    return done.stdout + done.stderr if done.returncode != 0 else ""


@pytest.mark.sample(2)
@pytest.mark.parametrize("way", SWEPT)
@pytest.mark.parametrize("core", CORES)
def test_no_interrupt_breaks_the_traffic(tool, tmp_path, core, way):
    tool("qemu-system-arm")
    image = build_sweep(core, tool, tmp_path)
    assert [said for gap in GAPS if (said := sweep(core, image, gap, way))] == []


@pytest.mark.sample(2)
@pytest.mark.parametrize("fault", SWEEP_FAULTS, ids=str)
def test_the_sweep_catches_a_broken_link(tool, tmp_path, fault):
    tool("qemu-system-arm")
    image = build_sweep("m7", tool, tmp_path, fault)
    assert any("broken: " in sweep("m7", image, gap, way) for way in SWEPT for gap in GAPS)


@pytest.mark.thorough
@pytest.mark.parametrize("way", WAYS)
def test_two_threads_do_not_race(tool, tmp_path, way):
    assert run_threads(build_threads(tool, tmp_path), way) == ""


@pytest.mark.sample(2)
@pytest.mark.parametrize("fault", THREAD_FAULTS, ids=str)
def test_two_threads_catch_a_broken_link(tool, tmp_path, fault):
    program = build_threads(tool, tmp_path, fault)
    said = (run_threads(program, way) for way in WAYS)
    assert any("data race" in each or "broken: " in each for each in said)


# The whole kernel


def build_kernel(tool, folder, fault=None):
    """Build prep, tick and operator in three threads under the thread sanitizer."""
    csrc = targets.ROOT / "csrc"
    includes = [ground(folder, fault)[0], f"-I{csrc}", f"-I{targets.ROOT / 'firmware_sim'}"]
    options = ["-O1", "-g1", "-fsanitize=thread", *includes, "-pthread", "-lm"]
    sources = ["kernel_threads.c", "board_host.c", *sorted((csrc / "nck").rglob("*.c"))]
    program = folder / "kernel_threads"
    compile_c(tool("clang-19"), options, sources, program)
    return program


def run_kernel(program, case, slope, folder, timeout=600):
    """Run a case; return the ticks, the last setpoints and what the sanitizer says."""
    machine = Machine.load(case.machine, set=(*case.set, f"path.slope={slope}"))
    (folder / "machine").write_bytes(targets.machine_image(machine, "small"))
    (folder / "program").write_text(case.text)
    first = {**os.environ, "TSAN_OPTIONS": "halt_on_error=1"}
    done = subprocess.run(
        [program, "machine", "program"], capture_output=True, text=True, timeout=timeout,
        env=first, cwd=folder,
    )  # fmt: skip
    if done.returncode != 0:
        return 0, [], done.stdout + done.stderr
    ticks, *setpoints = map(int, done.stdout.split())
    return ticks, setpoints, ""


@pytest.mark.seldom(4, "csrc/nck/base", "csrc/nck/tick", "csrc/nck/nck.c", "tests/qemu")
def test_prep_tick_and_operator_do_not_race(tool, tmp_path):
    program = build_kernel(tool, tmp_path)
    for case in THREADED:
        for slope in ("linear", "jerk"):
            ticks, setpoints, said = run_kernel(program, case, slope, tmp_path)
            assert said == ""
            end = pycnc.run(pycnc.load(case.text, machine=case.machine))
            assert ticks >= len(end["t_s"])
            assert setpoints == [int(end[f"joint_{k}_nm"][-1]) for k in range(3)]


@pytest.mark.campaign
def test_the_three_threads_catch_a_broken_fence(tool, tmp_path):
    program = build_kernel(tool, tmp_path, PLAIN_LOAD)

    def is_caught():
        try:
            return "data race" in run_kernel(program, THREADED[0], "linear", tmp_path, 120)[2]
        except subprocess.TimeoutExpired:  # a load that is made once may wait for ever
            return False

    assert any(is_caught() for _ in range(3))
