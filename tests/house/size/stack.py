# SPDX-License-Identifier: MIT
"""The worst stack of every public function, by call graph.

The compiler says what each function takes and whom it calls (``-fcallgraph-info=su``); for the C
runtime, which is compiled already, the disassembly does. Recursion, frames of unknown size and
unknown callees are errors. Calls by pointer go to the functions that the file's constant tables
name; a hook of the caller's is not ours to count.
"""

import re
import subprocess
from pathlib import Path

PREFIX = "arm-none-eabi-"
NODE = re.compile(
    r'^node: \{ title: "([^"]+)" label: "[^"]*?(?:\\n(\d+) bytes \((\w+)\))?" ?[s}]', re.M
)
EDGE = re.compile(r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', re.M)
INDIRECT = "__indirect_call"
FUNCTION = re.compile(r"^[0-9a-f]+ <([^>]+)>:$")
INSTRUCTION = re.compile(r"^\s*[0-9a-f]+:\t(\S+)\s*(.*)$")
SIZED = re.compile(r"\b(nck_\w+?)_v\d+_\d+_axes\w+")  # a name that carries its build (sized.h)
WORD, DOUBLE = 4, 8


class StackError(Exception):
    """The stack has no bound that can be told."""


class CallGraph:
    """Functions, what each takes of the stack [bytes], and whom it calls.

    Parameters
    ----------
    objects : iterable of Path
        Object files; beside each stands its ``.ci``.
    image : Path
        A linked image with all that they need of the C runtime.
    """

    def __init__(self, objects, image):
        self.frames, self.calls, self.runtime = {}, {}, set()
        for binary in objects:
            self._add_object(binary)
        self._add_runtime(image)
        self._depths = {}

    def _add_object(self, binary):
        text = SIZED.sub(r"\1", binary.with_suffix(".ci").read_text(encoding="utf-8"))
        own = {}
        for title, size, kind in NODE.findall(text):
            if size:
                own[title.rsplit(":", 1)[-1]] = title
                self.frames[title] = int(size)
                if kind != "static":
                    raise StackError(f"{title}: a frame of unknown size")
        for caller, callee in EDGE.findall(text):
            calls = self.calls.setdefault(caller, set())
            if callee != INDIRECT:
                calls.add(callee)
                continue
            calls.update(own.get(name, name) for name in _named_by_tables(binary))

    def _add_runtime(self, image):
        functions = _disassembled(image)
        for names in _aliases(image):
            shown = next((name for name in names if name in functions), None)
            for name in names:
                if shown and name not in self.frames:
                    self.frames[name], self.calls[name] = functions[shown]
                    self.runtime.add(name)

    def depth(self, name):
        """Return the deepest stack of a call of this function [bytes]."""
        if name not in self._depths:
            self._depths[name] = self._deepest(name, ())
        return self._depths[name]

    def _deepest(self, name, path):
        if name not in self.frames:
            raise StackError(f"{path[-1]} calls {name}, which nobody knows")
        if name in path:
            if name in self.runtime:
                return 0  # jumps to and fro inside the C runtime, which does not recurse
            raise StackError(f"recursion: {' '.join([*path, name])}")
        if name in self._depths:
            return self._depths[name]
        callees = self.calls.get(name, ())
        below = max((self._deepest(callee, (*path, name)) for callee in callees), default=0)
        depth = self.frames[name] + below
        if name not in self.runtime:
            self._depths[name] = depth
        return depth


def _run(tool, *arguments):
    command = [PREFIX + tool, *map(str, arguments)]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    return SIZED.sub(r"\1", done.stdout)


def _named_by_tables(binary):
    """Return the functions whose addresses stand in an object's constants."""
    symbols = _run("objdump", "-t", binary)
    functions = set(re.findall(r"^\S+ [ \w]+F \S+\s+\w+ (\S+)$", symbols, re.M))
    found, inside = set(), False
    for line in _run("objdump", "-r", binary).splitlines():
        if line.startswith("RELOCATION RECORDS"):
            inside = ".rodata" in line
        elif inside and "R_ARM_ABS32" in line:
            name = line.split()[-1]
            if name in functions or name.startswith("nck_"):
                found.add(name)
    return found


def _aliases(image):
    """Return the sets of names that stand for one address."""
    names = {}
    for row in _run("nm", image).splitlines():
        address, _, name = row.split()
        names.setdefault(address, set()).add(name)
    return names.values()


def _disassembled(image):
    """Return {function: (bytes that it pushes, whom it calls or jumps to)} of an image."""
    found, name = {}, None
    for line in _run("objdump", "-d", "--no-show-raw-insn", image).splitlines():
        if head := FUNCTION.match(line):
            if name and falls_through:
                found[name][1].add(head[1])
            name, falls_through = head[1], True
            found[name] = [0, set()]
        elif name and (row := INSTRUCTION.match(line)):
            operation, rest = row.groups()
            found[name][0] += _growth(operation, rest)
            target = re.search(r"<([^>+]+)(?:\+0x[0-9a-f]+)?>$", rest)
            if operation.startswith(("b", "cb")) and target and target[1] != name:
                found[name][1].add(target[1])
            falls_through = not _leaves(operation, rest)
    return {name: (size, calls) for name, (size, calls) in found.items()}


def _leaves(operation, rest):
    """Tell whether nothing behind an instruction is reached from it."""
    return (
        operation in ("b", "b.n", "b.w", "bx", "udf", "nop")
        or (operation.startswith(("pop", "ldmia")) and "pc" in rest)
        or (operation.startswith("ldr") and rest.startswith("pc"))
        or operation.startswith(".")
    )


def _growth(operation, rest):
    """Return by how many bytes an instruction lets the stack grow."""
    if operation.startswith(("push", "vpush", "stmdb", "stmfd")):
        if not operation.startswith(("push", "vpush")) and not rest.startswith("sp!"):
            return 0
        registers = re.search(r"\{([^}]*)\}", rest)[1].split(",")
        return sum(_register_bytes(each.strip()) for each in registers)
    if operation.startswith("sub") and re.match(r"sp, (sp, )?#", rest):
        return int(re.search(r"#(\d+)", rest)[1])
    if operation.startswith("str") and (moved := re.search(r"\[sp, #-(\d+)\]!", rest)):
        return int(moved[1])
    return 0


def _register_bytes(registers):
    first, _, last = registers.partition("-")
    count = int(last[1:]) - int(first[1:]) + 1 if last else 1
    return count * (DOUBLE if first.startswith("d") else WORD)


def objects_of(image):
    """Return the object files of setpoints_default in tests/qemu, those of libnck among them."""
    folder = image.parent / "CMakeFiles"
    for kind in (image.stem, "nck_called"):
        yield from (folder / f"{kind}.dir").rglob("*.obj")


def entry_points(header):
    """Return the names of the functions that a header declares, in its order."""
    text = Path(header).read_text(encoding="utf-8")
    return re.findall(r"^[a-z][\w ]*?[ *](nck_\w+)\(", text, re.M)
