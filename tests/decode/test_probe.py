# SPDX-License-Identifier: MIT
"""Room 1: straight probes, simulated: where they go, what they find, and what rs274 makes of it."""

import re

import pytest
import rs274_oracle

import pycnc
from pycnc.kernel.bind import lib
from pycnc.machine import Machine

FREE = [f"axis.{axis}.{end}_mm=free" for axis in "xyz" for end in ("min", "max")]
PROBE = re.compile(r"STRAIGHT_PROBE\(([^)]*)\)")


def machine(probe="misses", *change):
    return Machine.load("mill3", set=[*FREE, f"dialect.probe={probe}", *change])


def decode(text, probe="misses", *change):
    program = pycnc.load(text, machine(probe, *change))
    found = [(each.id, each.line) for each in program.diagnostics if each.severity == "error"]
    moves = program.blocks[program.blocks["kind"] <= lib.NCK_BLOCK_ARC]
    return moves, found


def places(moves):
    return (moves["target_nm"][:, :3] / 1e6).round(6).tolist()


@pytest.fixture
def oracle(tool, tmp_path):
    tool("rs274")

    def run(text):
        (tmp_path / "program.ngc").write_text(text)
        _, complaint = rs274_oracle.run(tmp_path / "program.ngc", tmp_path, {})
        found = PROBE.findall((tmp_path / "canon.txt").read_text())
        return [[float(word) for word in each.split(",")[:3]] for each in found], complaint

    return run


@pytest.mark.parametrize("probe", ["misses", "touches"])
def test_a_probe_goes_from_rest_to_rest_at_its_feed_and_tells_where_it_ended(probe):
    text = "G21 G90 F120\nG0 X1 Y2 Z3\nG38.3 Z-5\nG0 X[#5061+10] Y#5070 Z#5063\nM2\n"
    moves, found = decode(text, probe)
    assert found == []
    assert places(moves) == [[1, 2, 3], [1, 2, -5], [11, int(probe == "touches"), -5]]
    assert moves["path_mode"][1] == lib.NCK_PATH_STOP
    assert moves["kind"][1] == lib.NCK_BLOCK_LINE and moves["feed"][1] == pytest.approx(120)


def test_what_a_probe_found_is_in_the_units_and_the_work_system_of_its_line():
    text = "G21 G90 F120 G55\nG20 G38.3 X1\nG21 G54 G0 X#5061 Y#5062 Z[#5063+#5069]\nM2\n"
    moves, found = decode(text, "misses", "work.g55.x_mm=7", "work.g55.z_mm=-2")
    assert found == []
    assert places(moves) == [[32.4, 0, 0], [1, 0, round(2 / 25.4, 6)]]


def test_before_any_probe_the_parameters_are_nought(oracle):
    text = "G21 G90 F120\nG0 X[#5061+1] Y#5070\nM2\n"
    assert decode(text)[1] == [] and oracle(text)[1] == ""
    assert places(decode(text)[0]) == [[1, 0, 0]]


def test_a_program_may_set_what_a_probe_has_found(oracle):
    text = "G21 G90 F120\n#5070=5\n#5061=[#5070+2]\nG0 X#5061 Y#5070\nG38.3 X1\nG0 Z#5061\nM2\n"
    moves, found = decode(text, "misses")
    assert found == [] and places(moves)[0] == [7, 5, 0] and places(moves)[-1] == [1, 5, 1]
    text = text.replace("G38.3 X1\n", "")
    assert oracle(text)[1] == "" and places(decode(text)[0])[0] == [7, 5, 0]


@pytest.mark.parametrize("code", ["G38.2", "G38.4"])
def test_a_probe_that_must_touch_and_does_not_is_one_clear_error(code):
    text = f"G21 G90 F120\n{code} Z-5\nZ-6\nX1\nG1 X2\nM2\n"
    moves, found = decode(text)
    assert found == [("probe", 2)]
    assert places(moves) == [[2, 0, -5]]
    (words,) = [str(each.message) for each in pycnc.load(text, machine()).diagnostics
                if each.severity == "error"]  # fmt: skip
    assert code in words
    assert decode(text, "touches")[1] == []


def test_probing_is_modal_and_its_ends_are_those_of_rs274(oracle):
    lines = [
        "G21 G90 F120", "G38.3 X10 Y5", "G0 X0 Y0 Z0", "G38.5 Z-3", "G0 Z1", "G91 G38.3 Z-2",
        "G90 G0 X0 Y0 Z0", "G20 G38.3 X.5", "G21 G0 X0 Y0 Z0", "G92 X5", "G38.3 X9 Z1", "M2",
    ]  # fmt: skip
    theirs, complaint = oracle("\n".join(lines) + "\n")
    assert complaint == ""
    moves, found = decode("\n".join(lines) + "\n", "misses")
    assert found == []
    ours = places(moves[moves["kind"] == lib.NCK_BLOCK_LINE])
    theirs[3] = [25.4 * each for each in theirs[3]]
    theirs[4][0] -= 5  # of the program: G92
    assert [pytest.approx(each, abs=1e-3) for each in theirs] == ours
    modal, _ = decode("G21 G90 F120\nG38.3 X1\nX2\nY3\nM2\n")
    assert set(modal["kind"]) == {lib.NCK_BLOCK_LINE} and len(modal) == 3


REFUSED = {
    "G38.2 X0": "probe",  # where it stands
    "G38.3": "word-missing",
    "G95 S100 M3 F1\nG38.3 Z-1": "probe",
    "G41 D1\nG38.3 X-1": "comp-on",
    "G53 G38.2 Z-1": "word-missing",
    "G38 Z1": "other-base",
    "G38.6 Z1": "g-unknown",
}


@pytest.mark.parametrize("lines", REFUSED)
def test_what_rs274_refuses_is_refused(lines, oracle):
    text = f"G21 G90 F120\n{lines}\nM2\n"
    change = "tool.1.radius_mm=1"
    assert [each for each, _ in decode(text, "touches", change)[1]] == [REFUSED[lines]]
    assert oracle(text)[1] != ""


def test_other_languages_and_machines_that_say_so_have_no_probe():
    text = "G21 G90 F120\nG38.3 Z-5\nM2\n"
    assert decode(text, "refused")[1] == [("unsupported", 2)]
    assert decode(text, "misses", "dialect.base=grbl")[1] == []
    assert decode(text, "misses", "dialect.base=fanuc")[1] == [("other-base", 2)]
