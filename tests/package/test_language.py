# SPDX-License-Identifier: MIT
"""What NCK_LANGUAGE leaves out is refused at its word, and what it leaves in is read as ever."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

# (what it belongs to, dialect, the least level that reads it, column of its word, lines)
WORDS = [
    ("moves", "LINUXCNC", 0, 1, "G1 X1 Y2 F90"),
    ("arcs", "LINUXCNC", 0, 1, "G2 X2 I1 F90"),
    ("speed", "LINUXCNC", 0, 1, "G97 S500 M3"),
    ("place", "FANUC", 0, 1, "G10 L2 P1 X5"),
    ("cycles", "LINUXCNC", 1, 1, "G81 X1 Z-5 R2 F90"),
    ("compensation", "LINUXCNC", 1, 1, "G41.1 D1 G1 X9 Y9 F90"),
    ("modes", "FANUC", 2, 1, "G5.1 Q1"),
    ("ports", "LINUXCNC", 2, 1, "M62 P1"),
    ("states", "LINUXCNC", 2, 1, "M70"),
    ("printers", "MARLIN", 2, 1, "M104 S200"),
    ("surface speed", "LINUXCNC", 3, 1, "G96 D900 S50 M3"),
    ("threads", "LINUXCNC", 4, 9, "S500 M3 G33 Z-9 K1"),
    ("taps", "LINUXCNC", 4, 9, "S500 M3 G33.1 Z-9 K1"),
    ("layouts", "FANUC", 4, 1, "G68 X1 Y1 R30"),
    ("tapping cycles", "LINUXCNC", 4, 9, "S500 M3 G84 X1 Z-9 R2 F500"),
]

READER = """
#include "nck.h"
#include <stdio.h>
#include <string.h>
static nck_machine_t machine;
static double memory[1 << 17];
int main(int count, char **words) {
    for (int k = 1; k + 1 < count; k += 2) {
        nck_t *const kernel = nck_place(memory, sizeof memory);
        nck_diagnostic_t told = {0};
        size_t used = 0;
        nck_machine_default(&machine);
        machine.dialect.base = (uint8_t)(words[k][0] - '0');
        if (nck_init(kernel, &machine, NULL) != NCK_OK) return 2;
        nck_status_t status = nck_prep(kernel);
        for (const char *at = words[k + 1]; status >= NCK_OK && status != NCK_DONE; at += used) {
            nck_pose_t pose;
            nck_axes_t axes;
            used = 0;
            if (status == NCK_EMPTY && *at == 0) nck_end(kernel);
            else if (status == NCK_EMPTY) (void)nck_push(kernel, at, strlen(at), &used);
            if (nck_tick(kernel, &pose, &axes) == NCK_TICK_WAIT) nck_resume(kernel);
            status = nck_prep(kernel);
        }
        if (status < NCK_OK) (void)nck_diagnostic(kernel, &told);
        printf("%d %u\\n", status < NCK_OK, (unsigned)told.column);
    }
    return 0;
}
"""


@pytest.fixture(scope="module", params=range(5))
def reader(request, tmp_path_factory):
    """Return (level, a function that reads programs in a build of it)."""
    folder, level = tmp_path_factory.mktemp("language"), request.param
    made = [sys.executable, ROOT / "cmake" / "amalgamate.py", "--out", folder]
    subprocess.run([*made, f"--define=NCK_LANGUAGE={level}"], check=True)
    (folder / "reader.c").write_text(READER)
    command = ["gcc", "-std=c99", "-O0", "-Wall", "-Wextra", "-Werror", "reader.c", "nck.c", "-lm"]
    tool = [os.environ["NCK_CCACHE"]] if os.environ.get("NCK_CCACHE") else []
    subprocess.run([*tool, *command, "-o", "reader"], cwd=folder, check=True)

    def read(programs):
        words = [word for program in programs for word in program]
        command = [folder / "reader", *words]
        said = {"capture_output": True, "text": True, "timeout": 60}
        done = subprocess.run(command, check=True, **said)
        return [tuple(map(int, line.split())) for line in done.stdout.splitlines()]

    return level, read


@pytest.mark.thorough
def test_a_level_reads_what_it_has_and_refuses_the_rest_at_its_word(reader):
    from pycnc.kernel.bind import lib

    level, read = reader
    bases = {name: str(getattr(lib, f"NCK_DIALECT_{name}")) for _, name, *_ in WORDS}
    found = read([
        (bases[base], f"G21 G90\n{text}\n") for _, base, _, _, text in WORDS
    ])  # fmt: skip
    expected = [(int(level < least), column if level < least else 0)
                for *_, least, column, _ in WORDS]  # fmt: skip
    told = {words[0]: pair for words, pair in zip(WORDS, found, strict=True)}
    assert told == {words[0]: pair for words, pair in zip(WORDS, expected, strict=True)}
