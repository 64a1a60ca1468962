# SPDX-License-Identifier: MIT
"""What libnck costs on two microcontroller cores: print the tables, or renew them (--write).

They stand in docs/size.md.

Flash is code and constants, room by room, of the default capacities. The C runtime counts what a
linked image takes from the compiler's libraries on top: arithmetic in double without a double FPU,
memcpy and the like. Instructions are counted by the emulator, call included; they say nothing about
cycles.
"""

import argparse
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "tests" / "house" / "size")]

import stack  # noqa: E402
import targets  # noqa: E402
from cases import CASES  # noqa: E402

from pycnc.machine import Machine  # noqa: E402

CSRC = ROOT / "csrc"
PREFIX = "arm-none-eabi-"
BEGIN, END = "<!-- size-table -->\n", "<!-- /size-table -->"
CORES = {"m4f": "Cortex-M4F", "m7": "Cortex-M7"}
OPTIONS = {
    "m4f": "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16".split(),
    "m7": "-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16".split(),
}
DIALECT = "-std=c99 -ffp-contract=off -fno-math-errno -ffunction-sections -DNDEBUG".split()
RUNTIME = "C runtime"
SMOOTHED, HELD, LONG = "_smoothed", "_held", "_long_held"
HOLD_TICK, LONG_TICK = 150, 600
# A soft machine, which takes hundreds of periods to rest.
SOFT = tuple(f"axis.{axis}.{limit}" for axis in "xyz"
             for limit in ("a_max_mm_s2=300", "j_max_mm_s3=1000"))  # fmt: skip
WIRES = "nck.c (wires)"
SETS = {
    "linear": "linear", "jerk": "jerk", "mill": "mill", "small": "small", "optimal": "optimal",
    "full": "full", "default": "medium, the default", "host": "host",
}  # fmt: skip
LEAN_SETS = ("linear", "jerk", "mill", "small", "optimal")
FLASH = "flash [bytes]"
LINKED = "flash that a firmware links, -Os [bytes]"
DEEPEST = "deepest stack of a call [bytes]"
PARTS = {"flash": (FLASH, LINKED), "stack": (DEEPEST,)}  # that compile libnck for themselves
# Micro-segments, the same smoothed, arcs in three planes, one dense straight line, five axes, sharp
# corners; held on the way, where the tick brakes. The optimal slope has capacities of its own.
BUDGETS = (
    ("star", "linear"), ("star", "jerk"), ("star_smoothed", "linear"), ("star_smoothed", "jerk"),
    ("planes", "linear"), ("planes", "jerk"),
    ("micrometres", "linear"), ("micrometres", "jerk"), ("rotary", "linear"),
    ("zigzag_smoothed", "jerk"), ("zigzag_smoothed", "optimal"),
    ("zigzag_smoothed_held", "jerk"), ("zigzag_smoothed_held", "optimal"),
    ("star_smoothed_held", "optimal"), ("helix_smoothed_long_held", "optimal"),
)  # fmt: skip


def run(tool, *arguments):
    """Run a tool of the cross compiler and return what it prints."""
    command = [PREFIX + tool, *map(str, arguments)]
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout


def compiler():
    """Return name and version of the cross compiler."""
    return f"{PREFIX}gcc {run('gcc', '-dumpfullversion').strip()}"


def objects(core, library="nck_default"):
    """Return {source: object} of libnck, as tests/qemu builds it: -O2, default capacities.

    Beside those of nck_called stands what their functions take of the stack, and whom they call.
    """
    found = {}
    folder = targets.build(core, library)
    for binary in sorted((folder / f"CMakeFiles/{library}.dir").rglob("*.obj")):
        source = re.search(r"csrc/nck/(.*)\.obj$", binary.as_posix())[1]
        if (CSRC / "nck" / source).exists():
            found[source] = binary
    return found


def small_objects(core, folder):
    """Return {source: object} of libnck compiled for size, -Os."""
    kernel, found = CSRC / "nck", {}
    for path in sorted(kernel.rglob("*.c")):
        source = path.relative_to(kernel).as_posix()
        found[source] = Path(folder) / f"{core}_{source.replace('/', '_')}.o"
        run("gcc", *OPTIONS[core], *DIALECT, "-Os", f"-I{CSRC}", "-c", path, "-o", found[source])
    return found


def link_whole(core, built, folder):
    """Link all of libnck, used or not, with the C runtime that it needs; return the image."""
    image = Path(folder) / f"{core}.elf"
    link = [*OPTIONS[core], "-nostartfiles", "-Wl,-e,nck_tick", *built.values()]
    run("gcc", *link, "-lm", "-o", image)
    return image


def sizes(binary):
    """Return (flash, ram) of an object or image in bytes: text with constants, data with bss."""
    text, data, bss = map(int, run("size", binary).splitlines()[1].split()[:3])
    return text, data + bss


def measure_flash(built, image):
    """Return {room: flash in bytes}, the runtime last, and data plus bss of libnck."""
    rooms, ram = {}, 0
    for source, binary in built.items():
        flash, data = sizes(binary)
        folder = re.match(r"(?:prep/|tick/)?(\w+)/", source)  # whatever wing of it
        room = folder[1] if folder else WIRES
        rooms[room] = rooms.get(room, 0) + flash
        ram += data
    rooms[RUNTIME] = sizes(image)[0] - sum(rooms.values())
    return rooms, ram


def measure_structs(set_name):
    """Return {member of nck_t: bytes}, and {capacity: value}, as they are on a 32-bit Arm."""
    definitions = [f"-D{definition}" for definition in definitions_of(set_name)]
    text = (CSRC / "nck" / "nck_memory.h").read_text(encoding="utf-8")
    body = re.search(r"^struct nck \{\n(.*?)\n\};", text, re.S | re.M)[1]
    members = re.findall(r"^    (?:nck_\w+_t|\}) (\w+);", body, re.M)
    probes = [f"char p_{name}[sizeof(((nck_t *)0)->{name})];" for name in members]
    probes += [f"char p_{name}[{name}];" for name in ("NCK_AXIS_MAX", "NCK_WINDOW")]
    with tempfile.TemporaryDirectory() as folder:
        source, binary = Path(folder, "probe.c"), Path(folder, "probe.o")
        probes.append("char p_all[sizeof(nck_t)];\n")
        source.write_text("\n".join(['#include "nck/nck_memory.h"', *probes]))
        run("gcc", *OPTIONS["m7"], *definitions, f"-I{CSRC}", "-c", source, "-o", binary)
        rows = re.findall(r"^\w+ (\w+) \w p_(\w+)$", run("nm", "-S", binary), re.M)
    found = {name: int(size, 16) for size, name in rows}
    return {name: found[name] for name in [*members, "all"]}, found


def measure_stack(core, image):
    """Return {public function: deepest stack in bytes}."""
    graph = stack.CallGraph(objects(core, "nck_called").values(), image)
    doors = [CSRC / "nck" / name for name in ("nck.h", "nck_session.h")]
    return {name: graph.depth(name) for door in doors for name in stack.entry_points(door)}


def measure_instructions(core, name, slope):
    """Return (most and mean of a tick, most of a step of prep, mean of prep in a period) in
    instructions."""
    hold = LONG_TICK if name.endswith(LONG) else HOLD_TICK if name.endswith(HELD) else 0
    soft = SOFT if name.endswith(LONG) else ()
    name = name.removesuffix(LONG).removesuffix(HELD)
    case = next(case for case in CASES if case.name == name.removesuffix(SMOOTHED))
    if name.endswith(SMOOTHED):
        case = replace(case, text=case.text.replace("G61", "G64 P0.01"))
    machine = Machine.load(case.machine, set=(*case.set, *soft, f"path.slope={slope}"))
    with tempfile.TemporaryDirectory() as folder:
        set_name = slope if slope == "optimal" else "default"
        result = targets.run_setpoints(core, set_name, case, machine, Path(folder), count=True,
                                       hold=hold)
    runs, total, most = result.instructions["tick"]
    _, planned, step = result.instructions["prep"]
    return most, round(total / runs), step, round(planned / runs)


def in_order_of_flow(rooms):
    """Sort the rows: the ground, the rooms by number, the wires, the runtime."""
    first = [name for name in rooms if name == "base"]
    numbered = sorted(name for name in rooms if name[0].isdigit())
    return first + numbered + [name for name in rooms if name not in first + numbered]


def lines_of(head, columns, rows):
    """Return the lines of a Markdown table; rows are (title, numbers)."""
    yield f"| {head} | {' | '.join(columns)} |"
    yield "|---|" + "---:|" * len(columns)
    for title, values in rows:
        yield f"| {title} | " + " | ".join(f"{value:,}" for value in values) + " |"
    yield ""


def flash_lines(images, folder):
    flash = {}
    for core in images:
        title = CORES[core]
        built = small_objects(core, folder)
        flash[f"{title} -O2"] = measure_flash(objects(core), images[core])
        flash[f"{title} -Os"] = measure_flash(built, link_whole(core, built, folder))
    return list(lines_of(FLASH, list(flash), flash_rows(list(flash.values()))))


def definitions_of(set_name):
    """Return a set's capacities as NAME=VALUE."""
    given = {} if set_name == "default" else targets.capacities(set_name)
    return [f"{macro}={value}" for macro, value in given.items()]


def measure_share(core, set_name, folder):
    """Return what a firmware links of the pair of files, if it calls all of nck.h [bytes]."""
    place = Path(folder) / f"{core}_{set_name}"
    pair = [f"--define={definition}" for definition in definitions_of(set_name)]
    command = [sys.executable, ROOT / "cmake" / "amalgamate.py", "--out", place, *pair]
    subprocess.run(command, check=True)
    image = place / "share.elf"
    declared = run("gcc", *OPTIONS[core], "-E", "-P", place / "nck.h")
    doors = "|".join(stack.entry_points(CSRC / "nck" / "nck.h"))
    linked = re.findall(rf"\b((?:{doors})(?:_v\d\w*)?)\(", declared)
    kept = [f"-Wl,-u,{name}" for name in linked]
    warn = ["-Wall", "-Wextra", "-Werror"]
    link = ["-nostartfiles", "-Wl,--gc-sections", "-Wl,-e,nck_tick", *kept]
    source = place / "nck.c"
    run("gcc", *OPTIONS[core], *DIALECT, "-Os", *warn, *link, source, "-lm", "-o", image)
    return sizes(image)[0]


def share_rows(cores, lean):
    jobs = [(core, set_name) for set_name in lean for core in cores]
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        found = list(pool.map(lambda job: measure_share(*job, folder), jobs))
    for k in range(0, len(jobs), len(cores)):
        yield SETS[jobs[k][1]], found[k : k + len(cores)]


def flash_rows(flash):
    rooms = in_order_of_flow(flash[0][0])
    for room in rooms[:-1]:
        yield room, [found[room] for found, _ in flash]
    yield "**libnck**", [sum(found.values()) - found[RUNTIME] for found, _ in flash]
    yield "C runtime on top", [found[RUNTIME] for found, _ in flash]
    yield "data + bss of libnck", [ram for _, ram in flash]


def ram_lines():
    found = {title: measure_structs(set_name) for set_name, title in SETS.items()}
    columns = [
        f"{title} ({known['NCK_AXIS_MAX']} axes, window {known['NCK_WINDOW']})"
        for title, (_, known) in found.items()
    ]
    sizes_of = [members for members, _ in found.values()]
    names = {name: f"`{name}`" for name in sizes_of[0]} | {"all": "**`sizeof(nck_t)`**"}
    rows = [(names[name], [members[name] for members in sizes_of]) for name in names]
    return lines_of("RAM: members of `nck_t` [bytes]", columns, rows)


def stack_rows(images):
    depths = [measure_stack(core, image) for core, image in images.items()]
    for name in depths[0]:
        yield f"`{name}`", [found[name] for found in depths]


def instruction_rows(cores):
    jobs = [(core, *budget) for budget in BUDGETS for core in cores]
    with ThreadPoolExecutor(2) as pool:
        found = list(pool.map(lambda job: measure_instructions(*job), jobs))
    for k in range(0, len(jobs), len(cores)):
        numbers = [number for each in found[k : k + len(cores)] for number in each]
        yield f"{jobs[k][1].replace('_', ', ')}, {jobs[k][2]}", numbers


def table(cores=tuple(CORES), lean=LEAN_SETS, parts=PARTS):
    """Measure and return the tables as Markdown, for these cores and lean builds.

    What few parts leave out need not be compiled.
    """
    targets.build("host")
    names, lines = [CORES[core] for core in cores], []
    with tempfile.TemporaryDirectory() as folder:
        images = {core: link_whole(core, objects(core), Path(folder)) for core in cores}
        if "flash" in parts:
            with tempfile.TemporaryDirectory() as small:
                lines += flash_lines(images, small)
            lines += lines_of(LINKED, names, share_rows(cores, lean))
        lines += ram_lines()
        if "stack" in parts:
            lines += lines_of(DEEPEST, names, stack_rows(images))
    spans = ("tick, most", "tick, mean", "prep step, most", "prep, mean of a period")
    columns = [f"{name}: {span}" for name in map(str.upper, cores) for span in spans]
    lines += lines_of("instructions: program, slope", columns, instruction_rows(cores))
    lines += [
        f"Measured with {compiler()} by `tests/house/size/table.py`; RAM, stacks and",
        "instructions at -O2. A test fails where a number is off by more than 5 %. Stacks are",
        "bounds by call graph, without hooks and interrupts.",
        "Instructions are counted under QEMU over the programs of `tests/cases.py`, call included.",
    ]
    return "\n".join(lines) + "\n"


def numbers(text):
    """Return {(head of the table, title of the row): numbers} of the tables."""
    found, head = {}, ""
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) < 2 or cells[0].startswith("---"):
            continue
        if not cells[1].replace(",", "").isdigit():
            head = cells[0]
        else:
            found[head, cells[0]] = [int(cell.replace(",", "")) for cell in cells[1:]]
    return found


def split_page(text):
    """Return the page's text before, in and after the tables."""
    begin = text.index(BEGIN) + len(BEGIN)
    end = text.index(END, begin)
    return text[:begin], text[begin:end], text[end:]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", action="store_true", help="renew the tables in docs/size.md")
    given = parser.parse_args()
    measured = table()
    if not given.write:
        print(measured, end="")
        return
    page = ROOT / "docs" / "size.md"
    before, _, after = split_page(page.read_text(encoding="utf-8"))
    page.write_text(before + measured + after, encoding="utf-8")


if __name__ == "__main__":
    main()
