# SPDX-License-Identifier: MIT
"""Whose words are whose: what each language is given by its maker's manual, written apart from the
kernel's tables, and programs that say the words of one to another."""

import random

from pycnc import stages
from pycnc.kernel.bind import lib, status_id
from pycnc.machine import Machine

# Language → (machine, what is set). Fanuc's lathes speak G-code system B: its numbers stand alone.
TONGUES = {
    "linuxcnc": ("mill3", {"dialect.base": "linuxcnc"}),
    "fanuc": ("mill3", {"dialect.base": "fanuc"}),
    "turning": ("cak6150n", {"dialect.base": "fanuc", "dialect.system": "B",
                             "dialect.feed": "per_minute"}),
    "grbl": ("mill3", {"dialect.base": "grbl"}),
    "marlin": ("mill3", {"dialect.base": "marlin"}),
}


def _spread(words):
    """Return codes in tenths of a list such as ``0-3 5.1``."""
    found = set()
    for word in words.split():
        first, _, last = word.partition("-")
        if last:
            found |= {10 * code for code in range(int(first), int(last) + 1)}
        else:
            found.add(round(10 * float(first)))
    return found


# The G codes that are read, language by language.
# LinuxCNC 2.9, "G-Codes"; grbl 1.1, "Supported G-Codes"; Fanuc 0i-MF and 0i-TF, "Preparatory
# function (G function)"; Marlin 2.1, "G-code Index".
_MODAL = "0-4 17-21 28 53-59 80 90-92 "
_HAAS = "103 110 111 114-129 154 187"  # Haas, "Mill G-codes"; G61.1: Mitsubishi's, and Mazak's
G = {
    "linuxcnc": _MODAL
    + "5 5.1 5.2 5.3 7 8 9 10 28.1 30 30.1 33 33.1 38.2 38.3 38.4 38.5 40-43 41.1 42.1 43.1 43.2 "
    "49 52 59.1 59.2 59.3 61 61.1 64 73 74 76 81-86 89 90.1 91.1 92.1 92.2 92.3 93-99",
    "fanuc": _MODAL
    + "5 5.1 6.2 8 9 10 10.9 13.1 15 16 23 25 30 31 40-43 40.1 49-52 50.1 50.2 51.1 54.1 61-71 "
    "61.1 73 74 76 81-87 89 93-99 " + _HAAS,
    "turning": _MODAL
    + "5 5.1 8 9 10 10.9 13.1 23 25 30 31 33 40-42 40.1 50.2 52 54.1 61-67 61.1 70-79 83-85 87-89 "
    "93-99 "
    + _HAAS,
    "grbl": _MODAL + "10 28.1 30 30.1 38.2 38.3 38.4 38.5 40 43.1 49 61 91.1 92.1 93 94",
    "marlin": _MODAL + "5 10-12 26 27 29 30 34 35 59.1 59.2 59.3",
}
G = {name: _spread(words) for name, words in G.items()}
M = {
    "linuxcnc": "0-9 30 48-53 60-68 70-73 98 99",
    "fanuc": "0-9 29 30 48 49 97-99",
    "turning": "0-9 29 30 48 49 97-99",
    "grbl": "0-5 7-9 30 62-68",  # M62 … M68: of grblHAL and FluidNC
    # Marlin 2.1; M73 M74 M86 M142 M555 M572 M601 M602 M603 M862 M907: of Prusa's firmware; M116
    # M374 M375 M376 M557 M561 M566 M568: of RepRapFirmware.
    "marlin": "0 1 3-5 7-9 16-18 24 25 27 31 42 73-78 80-87 92 104-111 113-121 123 125 140-142 145 "
    "149 150 154 155 163-166 190-193 201-205 207-209 211 217 220 221 226 240 250 255 256 260 261 "
    "280-282 290-292 300-306 309 350 355 374-376 400-402 404-407 410 412 413 420 421 425 430 486 "
    "500-504 555 557 561 566 568 569 572 575 591 592 593 600-603 851 862.1 862.2 862.3 862.4 "
    "862.5 862.6 900 906-908 910-915 919 928",
}
M = {name: _spread(words) for name, words in M.items()}
# grblHAL, "Supported G-codes": what it has of LinuxCNC's beside grbl's.
HAL = {
    "G": _spread("5 5.1 7 8 33 43 43.2 59.1 59.2 59.3 73 76 81-83 85 86 89 92.2 92.3 95-99"),
    "M": _spread("6 48-53 60 61 70-73 98 99"),
}
UNKNOWN = {"unsupported", "other-base", "g-unknown", "m-unknown"}

# Words of one language that others must not take for their own: line, whose it is.
LINES = (
    ("G7", "linuxcnc"), ("G8", "linuxcnc"), ("G43.1 Z1.", "linuxcnc grbl"),
    ("G41.1 D1.", "linuxcnc"), ("G59.1", "linuxcnc marlin"), ("G61.1", "linuxcnc fanuc turning"),
    ("G64 P0.1", "linuxcnc"), ("G90.1", "linuxcnc"), ("G91.1", "linuxcnc grbl"),
    ("G92.1", "linuxcnc grbl"), ("G92.2", "linuxcnc"), ("G28.1", "linuxcnc grbl"),
    ("G10 L20 P1 X0.", "linuxcnc fanuc turning grbl"), ("G10 L2 P7 X0.", "linuxcnc"),
    ("G33 Z-1. K1.", "linuxcnc"), ("G5.1 X1. Y1. I1. J0.", "linuxcnc"),
    ("M62 P1", "linuxcnc grbl"), ("M66 P1 L0", "linuxcnc grbl"), ("G54.1 P1", "fanuc turning"),
    ("G187 P1", "fanuc turning"), ("M73 P1", "linuxcnc marlin"),
    ("G31 X1. F100.", "fanuc turning"), ("M70", "linuxcnc"), ("M60", "linuxcnc"),
    ("#<wide>=1", "linuxcnc"), ("X[EXISTS[#1]]", "linuxcnc"), ("X[2**3]", "linuxcnc"),
    ("O7 if [1 gt 2]", "linuxcnc"), ("X#5220", "linuxcnc"),
    ("G2 X0. Y0. I1. P2", "linuxcnc marlin"), ("G96 S100 D900", "linuxcnc"),
    ("G9 X1.", "linuxcnc fanuc turning"), ("G15", "fanuc"), ("G30 P2 X0.", "fanuc turning"),
    ("G51.1 X0.", "fanuc"), ("G68 X0. Y0. R10.", "fanuc"), ("G65 P9 A1.", "fanuc turning"),
    ("G66 P9", "fanuc turning"), ("M29", "fanuc turning"), ("X[POW[2,3]]", "fanuc turning"),
    ("IF [1 EQ 2] GOTO 9", "fanuc turning"), ("GOTO 9", "fanuc turning"),
    ("WHILE [1 EQ 2] DO 1", "fanuc turning"), ("X#5001", "fanuc turning"),
    ("X#5041", "fanuc turning"), ("#5201=1.", "fanuc turning"), ("#3006=1", "fanuc turning"),
    ("G76 X1. Z-5. I0 K.5 D.1 F1.", "turning"), ("G75 X1. P500 F.1", "turning"),
    ("M104 S200", "marlin"), ("M82", "marlin"), ("M400", "marlin"), ("G4 S1", "marlin"),
    ("G81 X1. Z-1. R1.", "linuxcnc fanuc"), ("G43 H1", "linuxcnc fanuc"),
    ("G41 D1", "linuxcnc fanuc turning"), ("G95", "linuxcnc fanuc turning"),
    ("G93", "linuxcnc fanuc turning grbl"), ("M6", "linuxcnc fanuc turning"),
    ("M98 P9", "linuxcnc fanuc turning"), ("#100=1", "linuxcnc fanuc turning"),
    ("X[1.]", "linuxcnc fanuc turning"), ("M2", "linuxcnc fanuc turning grbl"),
    ("M97 P9", "fanuc turning"), ("M52 P1", "linuxcnc"), ("G38.3 Z-1.", "linuxcnc grbl"),
    ("G52 X1.", "linuxcnc fanuc turning"),
)  # fmt: skip
# What is a plain number to one language and a parameter of the control to another: a program's own.
OWN = {"#3006=1": "linuxcnc"}


def machine_of(tongue, **changes):
    """Return a machine that speaks a language, with a tool and its offset, free to go anywhere."""
    name, said = TONGUES[tongue]
    free = {f"axis.{axis}.{end}_mm": "free" for axis in "xz" for end in ("min", "max")}
    tool = {"tool.1.radius_mm": 1, "tool.1.length_mm": 5}
    return Machine.load(name, set={**said, **free, **tool, **changes})


def decode(text, machine):
    """Return (blocks, [(id, line, limit) of the errors])."""
    blocks, diagnostics = stages.decode(text.encode(), machine)
    errors = diagnostics[diagnostics["code"] < 0]
    return blocks, [
        (status_id(int(each["code"])), int(each["line"]), int(each["limit"])) for each in errors
    ]


def plain(rng, tongue):
    """Return a line that all languages read alike."""
    place = " ".join(f"{axis}{rng.randint(1, 40)}." for axis in rng.sample("XZ", rng.randint(1, 2)))
    return rng.choice([f"G0 {place}", f"G1 F100. {place}", place, "M8", "M5", "G21", "G54", "G55"])


def mixed(seed):
    """Return (tongue, text, number of the strange line, whose that is) of a random program."""
    rng = random.Random(seed)
    tongue = rng.choice(list(TONGUES))
    strange, whose = rng.choice([
        (line, whose) for line, whose in LINES
        if tongue not in whose.split() and OWN.get(line) != tongue
    ])  # fmt: skip
    lines = ["G21 G90" if tongue in ("turning", "marlin") else "G21 G90 G94", "G0 X1. Z1."]
    lines += [plain(rng, tongue) for _ in range(rng.randint(0, 8))]
    at = len(lines) + 1
    # A motion that only names a place is never what is strange.
    if strange[0] in "X#":
        lines[-1] = "G0 X1. Z1."
    lines += [strange] + [plain(rng, tongue) for _ in range(rng.randint(0, 4))]
    return tongue, "\n".join(lines) + "\n", at, whose


def search(count, first):
    """Return (tried, what was not refused) of random programs with a strange word each."""
    machines = {name: machine_of(name) for name in TONGUES}
    found = []
    for seed in range(first, first + count):
        tongue, text, at, _ = mixed(seed)
        errors = decode(text, machines[tongue])[1]
        if [line for _, line, _ in errors[:1]] != [at]:
            found.append((seed, tongue, text.splitlines()[at - 1], errors[:2]))
    return count, found


def spelled(letter, tenths):
    """Return a code as it is written."""
    return f"{letter}{tenths // 10}" + (f".{tenths % 10}" if tenths % 10 else "")


def refused_of(letter, read, machine):
    """Return {code: (id, limit)} of the codes 0 to 999.9 that are refused, but for those read."""
    codes = [tenths for tenths in range(10000) if tenths not in read]
    errors = decode("".join(f"{spelled(letter, each)}\n" for each in codes), machine)[1]
    return {codes[line - 1]: (name, whose) for name, line, whose in errors if name in UNKNOWN}


if __name__ == "__main__":
    import sys

    tried, found = search(int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    for each in found:
        print(*each)
    print(f"{tried} programs with a word of another language, {len(found)} not refused there")
    sys.exit(bool(found))
