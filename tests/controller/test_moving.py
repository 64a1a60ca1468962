# SPDX-License-Identifier: MIT
"""The files of docs/moving.md compile for their processors, are as short as it says, and move."""

import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import targets
from builds import build_c

FOLDER = "firmware_sim/moving"
CORES = {
    "stm32f4": ["-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"],
    "rp2040": ["-mcpu=cortex-m0plus", "-mfloat-abi=soft"],
}
FLAGS = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Wundef",
         "-Wdouble-promotion", "-Werror", "-O2", "-mthumb", "-ffp-contract=off"]  # fmt: skip
HANDLERS = {
    "stm32f4": ("TIM2_IRQHandler", "PendSV_Handler", "USART2_IRQHandler"),
    "rp2040": ("SysTick_Handler", "PendSV_Handler", "UART0_IRQ_Handler"),
}
LINES_MOST = 150


@pytest.mark.parametrize("part", CORES)
def test_a_part_compiles_with_what_is_common(part, root, tool, tmp_path):
    compiler = tool("arm-none-eabi-gcc")
    for name in (part, "moving"):
        command = [compiler, *FLAGS, *CORES[part]]
        command += [f"-I{root / 'csrc'}", f"-I{root / 'firmware_sim'}"]
        command += ["-c", root / FOLDER / f"{name}.c", "-o", tmp_path / f"{name}.o"]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
    needed = subprocess.run(["arm-none-eabi-nm", "-u", tmp_path / "moving.o"], capture_output=True,
                            text=True).stdout  # fmt: skip
    given = subprocess.run(["arm-none-eabi-nm", tmp_path / f"{part}.o"], capture_output=True,
                           text=True).stdout  # fmt: skip
    wanted = set(re.findall(r"U (part_\w+)", needed))
    assert len(wanted) == 5 and wanted <= set(re.findall(r"T (part_\w+)", given))


@pytest.mark.seldom(4, "csrc/nck/base", "docs/moving.md", "firmware_sim/moving")
@pytest.mark.parametrize("part", CORES)
def test_a_part_links_and_the_page_tells_how_large_it_is(part, root, tool, tmp_path):
    compiler = tool("arm-none-eabi-gcc")
    options = [*CORES[part], "-mthumb", "-std=c99", "-Os", "-DNDEBUG", "-ffp-contract=off"]
    options += ["-fno-math-errno", "-ffunction-sections"]
    options += [f"-D{macro}={value}" for macro, value in targets.capacities("mill").items()]
    places = [f"-I{root / 'csrc'}", f"-I{root / 'firmware_sim'}"]
    sources = [*(root / "csrc" / "nck").rglob("*.c"), root / FOLDER / "moving.c"]
    sources += [path for folder in ("serve", "inputs", "pulse")
                for path in (root / "firmware_sim" / folder).glob("*.c")]  # fmt: skip

    def compiled(item):
        number, source = item
        binary = tmp_path / f"{number}.o"
        subprocess.run([compiler, *options, *places, "-c", source, "-o", binary], check=True)
        return binary

    with ThreadPoolExecutor(2) as pool:
        objects = list(pool.map(compiled, enumerate([*sources, root / FOLDER / f"{part}.c"])))
    image = tmp_path / "image.elf"
    handlers = [f"-Wl,-u,{name}" for name in HANDLERS[part]]
    link = ["-nostartfiles", "-Wl,--gc-sections,-e,main", *handlers]
    subprocess.run([compiler, *options, *link, *objects, "-lm", "-o", image], check=True)
    sizes = subprocess.run(["arm-none-eabi-size", image], capture_output=True, text=True).stdout
    flash, data, bss = map(int, sizes.splitlines()[1].split()[:3])
    page = (root / "docs" / "moving.md").read_text(encoding="utf-8")
    told = re.search(r"(\d+) KB of flash on the STM32F4, (\d+) KB on the RP2040, (\d+) KB", page)
    now = {"stm32f4": told[1], "rp2040": told[2]}[part]
    assert flash / 1000 == pytest.approx(int(now), rel=0.05)
    assert (data + bss) / 1000 == pytest.approx(int(told[3]), rel=0.05)


def test_the_page_tells_how_long_they_are(root):
    page = (root / "docs" / "moving.md").read_text(encoding="utf-8")
    told = dict(re.findall(r"^\| `(\w+)\.c` \| (\d+) \|", page, re.M))
    assert set(told) == {*CORES, "moving"}
    for name, lines in told.items():
        text = (root / FOLDER / f"{name}.c").read_text(encoding="utf-8")
        assert len(text.splitlines()) == int(lines) <= LINES_MOST


@pytest.fixture(scope="module")
def machine(root, tool, tmp_path_factory):
    """Return what plays lines to moving.c on a part in virtual time: what it says, where it is."""
    compiler, folder = tool("gcc"), tmp_path_factory.mktemp("moving")
    built, complaints = build_c("gcc", "sim", "nck")
    assert not complaints, complaints
    common = [compiler, "-std=c99", "-Wall", "-Wextra", "-Werror", "-O1", f"-I{root / 'csrc'}"]
    common += [f"-I{root / 'firmware_sim'}"]
    for name, options in ((f"{FOLDER}/moving.c", ["-Dmain=part_main"]),
                          ("tests/controller/moving_part.c", [])):  # fmt: skip
        command = [*common, *options, "-c", root / name, "-o", folder / f"{Path(name).stem}.o"]
        subprocess.run(command, check=True)
    program = folder / "program"
    libraries = [built / "libsim.a", built / "libnck.a", "-lm"]
    objects = sorted(folder.glob("*.o"))
    command = [compiler, "-Wl,--wrap=serve_step", *objects, *libraries, "-o", program]
    subprocess.run(command, check=True)

    def play(lines, slow=0, home=1_000_000):
        """Return answers, steps of the motors, and the period of the first one."""
        command = [program, str(slow), str(home)]
        done = subprocess.run(command, input="".join(f"{line}\n" for line in lines),
                              capture_output=True, text=True, check=True)  # fmt: skip
        told = re.search(r"steps (\S+) (\S+) (\S+), first in period (\d+)", done.stdout)
        *steps, first = map(int, told.groups())
        return re.findall(r"^ok|^error.*|^ALARM.*", done.stdout, re.M), steps, first

    return play


def test_it_moves_by_as_many_steps_as_it_is_told(machine):
    lines = ["$X", "G1 X10 Y0.5 F600", "G91 G0 X-2.005 Z1", "G4 P0.1", "$J=G91 Y1 F300"]
    answers, steps, _ = machine(lines)
    assert answers == ["ok"] * len(lines)
    assert steps == [1599, 300, 200]


def test_it_waits_for_the_spindle(machine):
    lines = ["$X", "M3 S1000", "G1 X1 F600"]
    assert machine(lines)[2] < 200
    answers, steps, first = machine(lines, slow=1500)
    assert answers == ["ok"] * 3 and steps == [200, 0, 0] and 1500 <= first < 1600


def test_it_is_homed_to_a_step(machine):
    answers, steps, _ = machine(["$H", "G53 G0 X100"], home=4000)
    assert answers == ["ok"] * 2
    assert steps == [4000 - 100 * 200, 4000 - 200, 4000 - 200]
