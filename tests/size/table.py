# SPDX-License-Identifier: MIT
"""The size of libnck on two microcontroller cores: print the table, or renew README's (--write).

Flash is code and constants, room by room, of the default capacities. The C runtime counts what a
linked image takes from the compiler's libraries on top: arithmetic in double without a double FPU,
memcpy and the like.
"""

import argparse
import re
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CSRC = ROOT / "csrc"
PREFIX = "arm-none-eabi-"
BEGIN, END = "<!-- size-table -->\n", "<!-- /size-table -->"
CORES = {
    "Cortex-M4F": "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16",
    "Cortex-M7": "-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16",
}
FLAGS = "-std=c99 -Os -DNDEBUG -ffp-contract=off -fno-math-errno".split()
RUNTIME = "C runtime"


def run(tool, *arguments):
    """Run a tool of the cross compiler and return what it prints."""
    command = [PREFIX + tool, *map(str, arguments)]
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout


def capacities(name):
    """Return the macro definitions of a capacity set as compiler options."""
    text = (ROOT / "cmake" / "capacities.cmake").read_text(encoding="utf-8")
    words = re.search(rf"{name}\s+([^)]*)\)", text)[1].split()
    return [f"-D{word}" for word in words]


def room_of(source):
    """Return the row of the table that a source file counts in."""
    folder = source.relative_to(CSRC / "nck").parent.name
    return folder or "nck.c (wires)"


def compile_all(core, folder):
    """Compile every source file of libnck; return {source: object}."""
    objects = {}
    for source in sorted((CSRC / "nck").rglob("*.c")):
        objects[source] = folder / f"{len(objects)}.o"
        options = [*core.split(), *FLAGS, f"-I{CSRC}"]
        run("gcc", *options, "-c", source, "-o", objects[source])
    return objects


def sizes(binary):
    """Return (flash, ram) of an object or image in bytes: text with constants, data with bss."""
    text, data, bss = map(int, run("size", binary).splitlines()[1].split()[:3])
    return text, data + bss


def measure_flash(core):
    """Return {room: flash in bytes}, the runtime last, and data plus bss of libnck."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        objects = compile_all(core, folder)
        rooms, ram = {}, 0
        for source, binary in objects.items():
            flash, data = sizes(binary)
            rooms[room_of(source)] = rooms.get(room_of(source), 0) + flash
            ram += data
        image = folder / "image.elf"
        link = [*core.split(), "-nostartfiles", "-Wl,-e,nck_tick", *objects.values()]
        run("gcc", *link, "-lm", "-o", image)
        rooms[RUNTIME] = sizes(image)[0] - sum(rooms.values())
        return rooms, ram


def measure_struct(core, definitions):
    """Return sizeof(nck_t) in bytes, read from an object so that it holds for the target."""
    with tempfile.TemporaryDirectory() as folder:
        source, binary = Path(folder, "probe.c"), Path(folder, "probe.o")
        source.write_text('#include "nck/nck.h"\nchar probe[sizeof(nck_t)];\n')
        options = [*core.split(), *FLAGS, *definitions, f"-I{CSRC}"]
        run("gcc", *options, "-c", source, "-o", binary)
        symbol = re.search(r"^\w+ (\w+) \w probe$", run("nm", "-S", binary), re.M)
        return int(symbol[1], 16)


def compiler():
    """Return name and version of the cross compiler."""
    return f"{PREFIX}gcc {run('gcc', '-dumpfullversion').strip()}"


def in_order_of_flow(rooms):
    """Sort the rows: the ground, the rooms by number, the wires, the runtime."""
    first = [name for name in rooms if name == "base"]
    numbered = sorted(name for name in rooms if name[0].isdigit())
    return first + numbered + [name for name in rooms if name not in first + numbered]


def table():
    """Measure and return the table as Markdown."""
    flash = {name: measure_flash(core) for name, core in CORES.items()}
    rooms = in_order_of_flow(next(iter(flash.values()))[0])
    lines = [f"| flash [bytes] | {' | '.join(CORES)} |", "|---|" + "---:|" * len(CORES)]

    def row(title, values):
        lines.append(f"| {title} | " + " | ".join(f"{value:,}" for value in values) + " |")

    for room in rooms[:-1]:
        row(room, [found[room] for found, _ in flash.values()])
    row("**libnck**", [sum(found.values()) - found[RUNTIME] for found, _ in flash.values()])
    row("C runtime on top", [found[RUNTIME] for found, _ in flash.values()])
    row("data + bss of libnck", [ram for _, ram in flash.values()])
    lines += ["", f"| RAM: `sizeof(nck_t)` [bytes] | {' | '.join(CORES)} |"]
    lines += ["|---|" + "---:|" * len(CORES)]
    sets = {
        "small (3 axes, window 64)": capacities("NCK_CAPACITY_SMALL"),
        "default (9 axes, window 256)": [],
        "host (9 axes, window 16 384)": capacities("NCK_CAPACITY_HOST"),
    }
    for title, definitions in sets.items():
        row(title, [measure_struct(core, definitions) for core in CORES.values()])
    lines += ["", f"Measured with {compiler()} -Os by `tests/size/table.py`; a test holds it true."]
    return "\n".join(lines) + "\n"


def split_readme(text):
    """Return README's text before, in and after the table."""
    begin = text.index(BEGIN) + len(BEGIN)
    end = text.index(END, begin)
    return text[:begin], text[begin:end], text[end:]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", action="store_true", help="renew the table in README.md")
    measured = table()
    if not parser.parse_args().write:
        print(measured, end="")
        return
    readme = ROOT / "README.md"
    before, _, after = split_readme(readme.read_text(encoding="utf-8"))
    readme.write_text(before + measured + after, encoding="utf-8")


if __name__ == "__main__":
    main()
