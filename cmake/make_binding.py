# SPDX-License-Identifier: MIT
"""Generate the C source of the cffi module from the face headers.

The C preprocessor reads the headers once. What comes from our own files becomes the cdef, what
comes from the system's is dropped (cffi knows the integer types), and the macros of the capacities
header become constants. Inline functions are dropped: formulas are not for cffi. Names that carry
capacities and version for the linker have their short form here.
"""

import argparse
import re
import subprocess
from pathlib import Path

import cffi

LINE_MARKER = re.compile(r'^# \d+ "(?P<file>[^"]*)"')
SIZED = re.compile(r"\b(nck_\w+?)_v\d+_\d+_axes\w+")  # a name that carries its build (sized.h)
CAPACITY = re.compile(r"^#define (?P<name>NCK_\w+) (?!struct|union)\S")


def include_lines(headers):
    """Return the text of a file that includes the headers."""
    return "".join(f'#include "{header}"\n' for header in headers)


def preprocess(compiler, headers, includes, definitions):
    """Return the preprocessed headers with line markers and macro definitions."""
    command = [compiler, "-E", "-dD", "-std=c99", "-x", "c", "-"]
    command += [f"-I{folder}" for folder in includes] + [f"-D{each}" for each in definitions]
    umbrella = include_lines(headers)
    return subprocess.run(
        command, input=umbrella, stdout=subprocess.PIPE, text=True, check=True
    ).stdout


def own_lines(preprocessed, includes, capacities):
    """Yield what our own files declare, and the macros of the capacities header as constants."""
    folders = [Path(folder).resolve() for folder in includes]
    own = is_capacities = False
    for line in preprocessed.splitlines():
        if marker := LINE_MARKER.match(line):
            file = Path(marker["file"]).resolve()
            own = any(file.is_relative_to(folder) for folder in folders)
            is_given = marker["file"] == "<command-line>"  # where -D overrides the header
            is_capacities = is_given or file.match(capacities)
        elif line.startswith("#"):
            if is_capacities and (macro := CAPACITY.match(line)):
                yield f"#define {macro['name']} ..."
        elif own:
            yield line


def without_inline_functions(lines):
    """Drop every `static inline` function, head and body."""
    inside, depth = False, 0
    for line in lines:
        if line.startswith("static inline"):
            inside = True
        if not inside:
            yield line
            continue
        depth += line.count("{") - line.count("}")
        inside = depth > 0 or not line.rstrip().endswith(("}", ";"))


def main():
    """Write the source of the Python module."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cc", required=True, help="C compiler that preprocesses")
    parser.add_argument("--module", required=True, help="full name of the Python module")
    parser.add_argument("--out", required=True, type=Path, help="C file to write")
    parser.add_argument("--include", action="append", required=True, help="folder of our headers")
    parser.add_argument("--define", action="append", default=[], help="macro, NAME=VALUE")
    parser.add_argument("--capacities", required=True, help="header whose macros become constants")
    parser.add_argument("headers", nargs="+", help="face headers, as #include names them")
    given = parser.parse_args()

    preprocessed = preprocess(given.cc, given.headers, given.include, given.define)
    lines = own_lines(preprocessed, given.include, given.capacities)
    binding = cffi.FFI()
    binding.cdef(SIZED.sub(r"\1", "\n".join(without_inline_functions(lines))))
    binding.set_source(given.module, include_lines(given.headers), py_limited_api=True)
    binding.emit_c_code(str(given.out))


if __name__ == "__main__":
    main()
