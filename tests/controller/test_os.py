# SPDX-License-Identifier: MIT
"""The small kernel on emulated processors, and controls: what is broken on purpose is caught.

The same test programs run on the host, in both builds, in test_0_release and
test_0_sanitizers.
"""

import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
KERNEL = ROOT / "firmware_sim" / "os"
BOARD = ROOT / "firmware_sim" / "board"
PROGRAMS = sorted(path.stem for path in (ROOT / "tests" / "controller").glob("test_os_*.c"))
CORES = {
    "m4f": ("mps2-an386", "-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16"),
    "m7": ("mps2-an500", "-mcpu=cortex-m7", "-mfpu=fpv5-d16"),
}
FLAGS = (
    "-std=c99 -O2 -Wall -Wextra -Wpedantic -Werror -Wconversion -Wdouble-promotion -Wshadow -Wundef"
    " -Wvla -Wstrict-prototypes -Wmissing-prototypes -ffp-contract=off"
).split()
LIMIT_S = 60  # an interrupt that takes longer than its period never lets go

# (the program that must fail, the file, and in it pairs of what is there and of what a careless
# hand would make of it)
BROKEN = {
    "mutex without ceiling": (
        "test_os_wait",
        "mutex.c",
        ("    if (mutex->ceiling < task->priority) os_move(task, mutex->ceiling);\n", ""),
    ),
    "mutex given to nobody": ("test_os_random", "mutex.c", ("        own(mutex, next);\n", "")),
    "timeout a tick late": (
        "test_os_wait",
        "os.c",
        ("os_kernel.time + timeout;", "os_kernel.time + timeout + 1;"),
    ),
    "guard not looked at": (
        "test_os_guard",
        "os.c",
        ("inside && guard_is_whole(task->stack)", "inside"),
    ),
    "stack pointer not looked at": (
        "test_os_guard",
        "os.c",
        ("inside && guard_is_whole(task->stack)", "guard_is_whole(task->stack)"),
    ),
    "no switch after a tick": (
        "test_os_task",
        "os.c",
        ("    if (os_highest(os_kernel.ready) != os_kernel.running) os_port_pend_switch();\n", ""),
    ),
    "overrun not told": (
        "test_os_task",
        "os.c",
        ("if (!os_port_tick_is_due()) return;", "return;"),
    ),
}
BROKEN_ON_TARGET = {
    "a task's floating-point registers are not saved": (
        "test_os_numbers",
        "port/cortex_m/port.c",
        ('        "it eq\\n"\n        "vstmdbeq r0!, {s16-s31}\\n"\n', ""),
        ('        "it eq\\n"\n        "vldmiaeq r0!, {s16-s31}\\n"\n', ""),
    ),
    "the caller's floating-point registers are not saved": (
        "test_os_numbers",
        "port/cortex_m/port.c",
        ('        "vpush {s16-s31}\\n"\n', ""),
        ('        "vpop {s16-s31}\\n"\n', ""),
    ),
    "interrupts are not kept out": (
        "test_os_queue",
        "port/cortex_m/port.c",
        ('"cpsid i" ::: "memory"', '"" ::: "memory"'),
    ),
}


def kernel_copy(folder, fault):
    """Copy the kernel to folder/os, with one fault; return the folder."""
    for path in KERNEL.rglob("*.[ch]"):
        target = folder / "os" / path.relative_to(KERNEL)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(path.read_bytes())
    _, name, *changes = fault
    text = (folder / "os" / name).read_text(encoding="utf-8")
    for there, careless in changes:
        assert text.count(there) == 1, "the control does not fit the source any longer"
        text = text.replace(there, careless)
    (folder / "os" / name).write_text(text, encoding="utf-8")
    return folder


def compile_c(command, program, source, port, flags):
    """Compile a test program with the kernel that stands in source/os."""
    folders = [source, source / "os", ROOT / "firmware_sim", ROOT / "tests" / "c"]
    sources = [ROOT / "tests" / "controller" / f"{program}.c", *sorted((source / "os").glob("*.c"))]
    sources += sorted((source / "os" / "port" / port).glob("*.c"))
    command = [command, *sources, *flags, *(f"-I{folder}" for folder in folders)]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def run_on_target(tool, folder, core, program, source, warnings=FLAGS):
    """Build a program and run it under the emulator; return what came of it."""
    machine, *options = CORES[core]
    image = folder / f"{program}.elf"
    extra = [ROOT / "tests" / "c" / "target.c", *sorted(BOARD.glob("*.c"))]
    extra += ["-mthumb", "-mfloat-abi=hard", "-ffunction-sections", *options, "-nostartfiles"]
    extra += [f"-L{BOARD}", f"-T{core}.ld", "-Wl,--gc-sections", "--specs=nosys.specs", "-lm"]
    extra += ["-o", image]
    compile_c(tool("arm-none-eabi-gcc"), program, source, "cortex_m", [*warnings, *extra])
    command = [tool("qemu-system-arm"), "-M", machine, "-display", "none", "-monitor", "none"]
    command += ["-serial", "none", "-semihosting-config", "enable=on,target=native"]
    command += ["-icount", "shift=3,align=off,sleep=off", "-kernel", image]
    return subprocess.run(command, capture_output=True, text=True, timeout=LIMIT_S)


@pytest.mark.sample(6)
@pytest.mark.parametrize("program", PROGRAMS)
@pytest.mark.parametrize("core", CORES)
def test_the_kernel_keeps_its_promises_on_a_target(tool, tmp_path, core, program):
    done = run_on_target(tool, tmp_path, core, program, ROOT / "firmware_sim")
    assert done.returncode == 0, done.stdout + done.stderr
    assert ", 0 failed" in done.stderr


@pytest.mark.sample(quick=3)
@pytest.mark.parametrize("name", BROKEN)
def test_a_fault_in_the_kernel_is_caught_on_the_host(tool, tmp_path, name):
    fault = BROKEN[name]
    flags = ["-std=c99", "-O1", "-DOS_STACK_RESERVE=65536", "-lm", "-o", tmp_path / "program"]
    compile_c(tool("gcc"), fault[0], kernel_copy(tmp_path, fault), "host", flags)
    done = subprocess.run([tmp_path / "program"], capture_output=True, text=True, timeout=LIMIT_S)
    assert done.returncode != 0
    assert "broken:" in done.stdout


@pytest.mark.sample(3)
@pytest.mark.parametrize("name", BROKEN_ON_TARGET)
@pytest.mark.parametrize("core", CORES)
def test_a_fault_in_the_port_is_caught_on_a_target(tool, tmp_path, core, name):
    fault = BROKEN_ON_TARGET[name]
    source = kernel_copy(tmp_path, fault)
    done = run_on_target(tool, tmp_path, core, fault[0], source, ["-std=c99", "-O2"])
    assert done.returncode != 0
