# SPDX-License-Identifier: MIT
"""Join libnck into one pair, nck.h and nck.c, for projects that take sources and not libraries.

python cmake/amalgamate.py --out DIR [--capacities OPTIMAL] [--define NCK_WINDOW=128 …]

It stands beside the other generator of the build (make_binding.py). nck.h holds what the front
doors include, nck.c the formulas and sources in the order of the flow. Names that a source file
keeps to itself and another file spells too get the file's name in front; formulas that nobody calls
are left out. The same sources give the same bytes.
"""

import argparse
import re
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
CSRC = ROOT / "csrc"
FRONT_DOOR = "nck/nck_tools.h"  # it includes the others
OTHER_DOORS = ("nck_memory.h", "nck_session.h", "nck_tools.h")  # they lead to nck.h here
BITS = "nck/base/bits.h"  # what it says of arithmetic holds for all that follows it
NO_WORD = (
    r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\''  # comment, string, character
    r"|\.?\d(?:[eEpP][+-]|[\w.])*"  # number
)
WORD = re.compile(NO_WORD + r"|([A-Za-z_]\w*)", re.S)
TOKEN = re.compile(NO_WORD + r"|[A-Za-z_]\w*|->|\s+|.", re.S)  # word, arrow, blank, other
OWN_INCLUDE = re.compile(r'^#include "([^"]+)".*\n', re.M)
SYSTEM_INCLUDE = re.compile(r"^#include <([^>]+)>.*\n", re.M)
GUARD = re.compile(r"^#ifndef (NCK_\w*H)\n#define \1\n(.*)^#endif\n", re.M | re.S)
LINKAGE = re.compile(r'^#ifdef __cplusplus\n(?:extern "C" \{|\})\n#endif\n', re.M)
INLINE = re.compile(
    r"(?:^//[^\n]*\n)*^static inline [^;{]*?\b(\w+)\([^{]*\{(?:[^\n]*\}|.*?^\})\n", re.M | re.S
)


def read(name):
    """Return the text of a file of csrc without its licence line, which the pair has once."""
    text = (CSRC / name).read_text(encoding="utf-8")
    return re.sub(r"^// SPDX[^\n]*\n", "", text)


def words(text):
    """Return the words of C text that are neither comment nor string."""
    return filter(None, WORD.findall(text))


def headers_of(name, seen):
    """Return the headers that a file includes and does not find in seen, the innermost first."""
    found = []
    for header in OWN_INCLUDE.findall(read(name)):
        if header not in seen:
            seen.add(header)
            found += [*headers_of(header, seen), header]
    return found


def flow(path):
    """Sort sources as they are read: the ground, the rooms by number, the wires."""
    name = path.relative_to(CSRC).as_posix()
    wing = next((n for n, part in enumerate(("/base/", "/prep/", "/tick/")) if part in name), 3)
    return wing, name


def capacities_of(set_name):
    """Return the capacities NAME=VALUE of a set of capacities.cmake."""
    sets = (ROOT / "cmake" / "capacities.cmake").read_text(encoding="utf-8")
    found = dict(re.findall(r"^set\(NCK_CAPACITY_(\w+)\s+([^)]*)\)", sets, re.M))
    if set_name not in found:
        raise SystemExit(f"no capacities {set_name}; there are: {', '.join(found)}")
    return found[set_name].split()


def capacities_filled_in(text, definitions):
    """Put the capacities given as NAME=VALUE into the text of limits.h as its defaults."""
    for definition in definitions:
        name, value = definition.split("=")
        text, count = re.subn(rf"^(#define {name}) \S+$", rf"\g<1> {value}", text, flags=re.M)
        if count != 1:
            raise SystemExit(f"limits.h has no capacity {name}")
    return text


def body(name, text):
    """Return a file's text without guard and includes, under a line that names it."""
    text = LINKAGE.sub("", GUARD.sub(r"\2", text))
    text = OWN_INCLUDE.sub("", SYSTEM_INCLUDE.sub("", text)).strip("\n")
    return f"\n// ======== {name}\n" + re.sub(r"\n{3,}", "\n\n", text) + "\n"


def file_names(text):
    """Return the names that a source file defines and does not export."""
    text = re.sub(r"//[^\n]*|^#[^\n]*", "", text, flags=re.M)
    outer = re.sub(r"\{[^{}]*\}", "{}", text)
    while (flat := re.sub(r"\{[^{}]*\{\}[^{}]*\}", "{}", outer)) != outer:
        outer = flat
    found = re.findall(r"^static [^;={(]*?\b(\w+)(?:\[[^\n]*\])? ?[(=;]", outer, re.M)
    found += re.findall(r"^\} (\w+);", text, re.M)
    found += re.findall(r"^typedef \w+ (\w+) \{", text, re.M)
    for enumerators in re.findall(r"^(?:typedef )?enum(?: \w+)? \{(.*?)\}", text, re.M | re.S):
        found += re.findall(r"(\w+)\s*(?:=[^,]*)?(?:,|$)", enumerators)
    return set(found)


def renamed(text, names, prefix):
    """Put the prefix before the words in names, but for members (. ->) and directives (#)."""
    out, before = [], ""
    for token in TOKEN.findall(text):
        is_name = token in names and before not in (".", "->", "#")
        out.append(prefix + token if is_name else token)
        before = before if token.isspace() else token
    return "".join(out)


def with_own_names(texts):
    """Return {source: text} in which no file-local name is a word of another file."""
    files = Counter(word for text in texts.values() for word in set(words(text)))
    result = {}
    for name, text in texts.items():
        own = file_names(text) if name.endswith(".c") else ()
        shared = {word for word in own if files[word] > 1}
        prefix = Path(name).stem + "_"
        if any(prefix + word in files for word in shared):
            raise SystemExit(f"{name}: {prefix} in front makes a name that is taken")
        result[name] = renamed(text, shared, prefix) if shared else text
    return result


def without_idle_formulas(text):
    """Drop inline functions, with their comments, that nothing calls."""
    while True:
        spelled = Counter(words(text))
        idle = [match for match in INLINE.finditer(text) if spelled[match[1]] == 1]
        if not idle:
            return text
        for match in reversed(idle):
            text = text[: match.start()] + text[match.end() :]


def macros_end_here(text):
    """Return the lines that end the macros of a source file, so that the next may use the names."""
    return "".join(f"#undef {name}\n" for name in re.findall(r"^#define (\w+)", text, re.M))


def system_includes(texts):
    """Return the include lines of all system headers that the texts need, each once."""
    names = {name for text in texts for name in SYSTEM_INCLUDE.findall(text)}
    return "".join(f"#include <{name}>\n" for name in sorted(names))


def amalgamate(definitions):
    """Return the texts of nck.h and nck.c."""
    version = re.search(r"project\(nck VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
    licence = (ROOT / "LICENSE").read_text(encoding="utf-8").strip()
    head = "// SPDX-License-Identifier: MIT\n" + "".join(
        f"// {line}".rstrip() + "\n"
        for line in [f"libnck {version} in two files; made by cmake/amalgamate.py.", ""]
        + licence.splitlines()
    )
    seen = {FRONT_DOOR}
    faces = [*headers_of(FRONT_DOOR, seen), FRONT_DOOR]
    paths = sorted(CSRC.glob("nck/**/*.c"), key=flow)
    sources = [path.relative_to(CSRC).as_posix() for path in paths]
    seen.add(BITS)
    formulas = [header for name in sources for header in headers_of(name, seen)]

    texts = with_own_names({name: read(name) for name in [*faces, *formulas, *sources]})
    limits = "nck/base/limits.h"
    texts[limits] = capacities_filled_in(texts[limits], definitions)
    face = head + "#ifndef NCK_H\n#define NCK_H\n\n"
    face += system_includes(texts[name] for name in faces)
    face += '\n#ifdef __cplusplus\nextern "C" {\n#endif\n'
    face += "".join(body(name, texts[name]) for name in faces)
    face += "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n"
    inner = "".join(body(name, texts[name]) for name in formulas)
    for name in sources:
        inner += body(name, texts[name]) + macros_end_here(texts[name])
    code = head + system_includes([read(BITS)]) + body(BITS, read(BITS))
    code += '\n#include "nck.h"\n\n'
    code += system_includes(texts[name] for name in [*formulas, *sources])
    return face, code + without_idle_formulas(inner)


def main():
    """Write the pair of files that the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--out", required=True, type=Path, help="folder for nck.h and nck.c")
    parser.add_argument("--define", action="append", default=[], help="capacity, NAME=VALUE")
    parser.add_argument("--capacities", metavar="SET", help="of cmake/capacities.cmake")
    given = parser.parse_args()
    own = capacities_of(given.capacities) if given.capacities else []
    face, code = amalgamate([*own, *given.define])
    given.out.mkdir(parents=True, exist_ok=True)
    (given.out / "nck.h").write_text(face, encoding="utf-8")
    (given.out / "nck.c").write_text(code, encoding="utf-8")
    for name in OTHER_DOORS:
        way = '// SPDX-License-Identifier: MIT\n#include "nck.h"\n'
        (given.out / name).write_text(way, encoding="utf-8")


if __name__ == "__main__":
    main()
