# SPDX-License-Identifier: MIT
"""Numbers in findings are the program's: as it writes them, in its units, with all their digits."""

import pytest

import pycnc

FANUC = {"dialect.base": "fanuc"}
COUNTS = {**FANUC, "dialect.integers": "increments"}
TURNS = {"dialect.system": "A"}
FREE = {f"axis.{axis}.{end}_mm": "free" for axis in "xyz" for end in ("min", "max")}

# line → message; settings of the machine where it is not the mill's own
TOLD = [
    ("G10 L2.5 P1 X1", "G10 L2.5 is not supported here", {}),
    ("G10 L-2 P1 X1", "G10 L-2 is not supported here", {}),
    ("G10 L99999999 P1 X1", "G10 L99999999 is not supported here", {}),
    ("G10 L12.50 P1 R1", "G10 L12.50 is not supported here", FANUC),
    ("G10 L2 P-1 X1", "P-1 is out of range (limit 9)", {}),
    ("G10 L2 P1.25 X1", "P1.25 is out of range (limit 9)", {}),
    ("G1.2345678 X1", "G1.2345678 is no G code that the kernel knows", {}),
    ("G90.0000001 X1", "G90.0000001 is no G code that the kernel knows", {}),
    ("G-1", "G-1 is no G code that the kernel knows", {}),
    ("G123456789", "G123456789 is no G code that the kernel knows", {}),
    ("M3.75", "M3.75 is no M code that the kernel knows", {}),
    ("M99999999", "M99999999 is no M code that the kernel knows", {}),
    ("T-1", "T-1 is out of range (limit 1000000000)", {}),
    ("T1.5", "T1.5 is out of range (limit 1000000000)", {}),
    ("T12345678 M6", "tool 12345678 is not in the tool table", {}),
    ("S123456789 M3", "S123456789 is out of range (most 24000)", {}),
    ("G1 X1 F-0.0000125", "F-0.0000125 is out of range (limit 1000000000)", {}),
    ("G20\nF50000000", "F50000000 is out of range (most 39370078.7401575)", {}),
    ("G20\nF.0000001", "F.0000001 is out of range (least 0.00000236220472440945)", {}),
    ("G1 X1234567.89 F9", "X1234567.89 is out of range (most 1000000)", {}),
    ("G1 X- 1 234 567.0 F9", "X-1234567.0 is out of range (most 1000000)", {}),
    ("G20 G0 X50000", "X50000 is out of range (most 39370.0787401575)", FREE),
    ("G91 G0 X900000\nX900001.5", "X900001.5 is out of range (most 100000)", FREE),
    ("G91 G0 X-900000\nX-900001.5", "X-900001.5 is out of range (most -100000)", FREE),
    ("G10 L2 P1 X900000\nG0 X900001", "X900001 is out of range (most 100000)", FREE),
    ("G0 X2000000000", "X2000000000 is out of range (most 1000000000)", {**COUNTS, **FREE}),
    ("G0 X[999999*3]", "X2999997 is out of range (most 1000000)", {}),
    ("G4 P10000001", "P10000001 is out of range (most 1000000)", {}),
    ("G4 P2000000001", "P2000000001 is out of range (most 1000000000)", FANUC),
    ("G64 P-.01", "P-.01 is out of range (limit 1000000)", {}),
    ("G2 X10 R4.25 F9", "R4.25 is shorter than half of the chord, 5.0000", {}),
    ("G20 G2 X1 R.25 F9", "R.25 is shorter than half of the chord, 0.5000", {}),
    ("G83 X1 Z-3 R1 Q-.5 F9", "Q-.5 is no depth of a peck", {}),
    ("G20 G81 X1 Z1 R.25 F9", "R.25 is out of range (limit 1)", {}),
    ("M67 E99 Q1", "E99 is out of range (most 15)", {}),
    ("G51 X0 Y0 P123456.", "P123456. is out of range (most 1000)", FANUC),
    ("G51 X0 Y0 P7", "a control may read the factor P7 as 7, as thousandths, or less", FANUC),
    ("G68 X0 Y0 R12345678.", "R12345678. is out of range (most 1000000)", FANUC),
    ("#3000=1.5", "the program stops with alarm 1.5 (#3000)", FANUC),
    ("#[-2.5]=1", "#-2.5 is out of range (limit 99999)", FANUC),
    ("G30 P4 X0", "the machine has no reference point 4, where G30 P4 goes", FANUC),
    ("X[ACOS[-1.5]]", "an expression without a value: it divides by zero, or a function has none "
                      "for -1.5", {}),
]  # fmt: skip


# The same where a word stands for another one, or for a length along the way of a cycle.
OTHERS = [
    ("cak6150n", "G0 U-4000001.", "U-4000001. is out of range (most 2000000)", TURNS),
    ("cak6150n", "G0 X60 Z2\nG90 X50 Z-9 F1 I7.50", "I7.50 is out of range (most 5)", TURNS),
    ("cak6150n", "G0 X60 Z2\nG90 X50 Z-9 F1 R7.50", "R7.50 is out of range (most 5)", TURNS),
    ("cak6150n", "G74 R-.5", "R-.5 is out of range (limit 0)", TURNS),
    ("cak6150n", "G71 U-2.5 R1", "U-2.5 is out of range (limit 0)", TURNS),
    ("printer", "G1 E2000000.5 F9", "E2000000.5 is out of range (most 1000000)", {}),
]


def messages(text, machine, changes):
    program = pycnc.load(text, machine=pycnc.Machine.load(machine, set=changes))
    return [each.message for each in program.diagnostics if each.severity == "error"]


@pytest.mark.parametrize("kind", ["grbl", "grblhal", "fluidnc", "nck"])
def test_a_key_of_grbl_is_named_where_the_control_has_it(kind):
    machine = pycnc.Machine.load("router", set={"control.kind": kind, "dialect.base": "grbl"})
    program = pycnc.load("G21 G90 G17 G94\nS999999 M3\nM2\n", machine)
    (note,) = (each for each in program.diagnostics if each.id == "speed-clipped")
    assert ("($30)" in note.help) == kind.startswith("grbl")


@pytest.mark.parametrize(("line", "told", "changes"), TOLD)
def test_a_number_is_told_as_the_program_writes_it(line, told, changes):
    assert messages(f"G21 G90 G17 G94\n{line}\nM2\n", "mill3", changes)[0] == told


@pytest.mark.parametrize(("machine", "line", "told", "changes"), OTHERS)
def test_its_letter_is_the_one_that_is_written(machine, line, told, changes):
    head = "" if machine == "printer" else "G21 G18 G97 S500 M3\n"
    assert messages(f"{head}{line}\nM2\n", machine, changes)[0] == told
