# SPDX-License-Identifier: MIT
"""Bad input: one clear diagnostic, the right exit code, never a traceback."""

import json

import pytest
from command_line import pycnc
from hypothesis import given
from hypothesis import strategies as st
from sampling import examples

from pycnc import stages
from pycnc.kernel.bind import lib
from pycnc.program import diagnostics
from pycnc.machine import Machine

START = b"G21 G90 G17 G91.1 G54\n"


def findings(text, *options):
    """Return (exit code, the errors) of a program, and see that nothing fell over."""
    result = pycnc("check", "--json", "-", *options, stdin=text)
    assert "Traceback" not in result.out + result.err
    errors = [each for each in json.loads(result.out) if each["severity"] == "error"]
    return result.code, errors


# text, id, line, column
BAD = {
    "unknown word": (START + b"G1 X10 F100\nG1 X1 E2.5\n", "word-unknown", 3, 7),
    "word that nothing uses": (START + b"G1 X10 F100 Q3\n", "word-unused", 2, 13),
    "unknown G code": (START + b"G777 X1\n", "g-unknown", 2, 1),
    "unknown M code": (START + b"M177\n", "m-unknown", 2, 1),
    "G code that is not built": (START + b"G17.1\n", "unsupported", 2, 1),
    "G code that is standard": (START + b"G50 S500\n", "other-base", 2, 1),
    "limit of the spindle's speed": (START + b"G92 S500\nS900\nX1\n", "unsupported", 2, 1),
    "one P for two codes": (START + b"G64 P2 G2 I3 J4 F9\n", "word-shared", 2, 5),
    "G53 in incremental": (START + b"G91 G53 G0 X1\n", "incremental", 2, 5),
    "expression": (START + b"G1 X[1+] F100\n", "expression", 2, 8),
    "subprogram": (START + b"O100 sub\n", "flow", 2, 0),
    "call of nothing": (START + b"O100 call\n", "label-missing", 2, 0),
    "division by zero": (START + b"G1 X[1/0] F100\n", "value", 2, 9),
    "missing feed": (START + b"G1 X10\n", "feed-missing", 2, 0),
    "missing dwell time": (START + b"G4\n", "word-missing", 2, 1),
    "arc off its circle": (START + b"G2 X10 I4 J0 F100\n", "arc-radius", 2, 1),
    "arc without centre": (START + b"G2 X10 Y10 F100\n", "arc-centre", 2, 1),
    "arc with a small R": (START + b"G2 X10 R4 F100\n", "arc-chord", 2, 8),
    "number out of range": (START + b"G1 X99999999 F100\n", "number-range", 2, 4),
    "huge number": (START + b"G1 X" + b"9" * 300 + b" F100\n", "number-range", 2, 4),
    "negative feed": (START + b"G1 X1 F-5\n" + b"X2\nG2 X3 I1\n" * 50, "number-range", 2, 7),
    "missing feed of many lines": (START + b"G1 X10\n" + b"X20\nX30\n" * 50, "feed-missing", 2, 0),
    "spindle too fast": (START + b"S99999 M3\n", "number-range", 2, 1),
    "word without number": (START + b"G1 X Y5 F100\n", "number", 2, 4),
    "number without letter": (START + b"5 X1\n", "character", 2, 1),
    "strange character": (START + b"G1 X1 $ F100\n", "character", 2, 7),
    "control character": (START + b"G1 X1 \x1b[31m\n", "character", 2, 7),
    "no UTF-8": (START + b"G1 X1 \xff F100\n", "character", 2, 7),
    "open comment": (START + b"G1 X1 F100 (never closed\n", "comment", 2, 12),
    "letter twice": (START + b"G1 X1 X2 F100\n", "word-twice", 2, 7),
    "two motions": (START + b"G0 G1 X1 F100\n", "modal-group", 2, 4),
    "axis that is not there": (START + b"G1 A10 F100\n", "axis-unknown", 2, 4),
    "beyond the travel": (START + b"G1 X301 F100\n", "travel", 2, 4),
    "arc beyond the travel": (
        START + b"G0 X290 Y-20\nG3 X290 Y20 I0 J20 F100\n", "travel", 3, 4,
    ),
    "tool that is not there": (START + b"T77 M6\n", "tool-unknown", 2, 1),
    "axis words without motion": (START + b"G80\nX1\n", "no-motion", 3, 1),
    "long line": (START + b"(" + b"x" * 5000 + b")\n", "line-length", 2, 0),
    "line of 10 MB": (START + b"G1 X1 " * (10 * 2**20 // 6) + b"\n", "line-length", 2, 0),
    "binary": (b"\x7fELF\x02\x01\x01\x00\x00\x00" + bytes(range(256)) * 40, "binary", 1, 0),
    "empty": (b"", "no-program", 0, 0),
    "blank": (b"\n \n\t\n", "no-program", 0, 0),
    "Klartext": (b"0 BEGIN PGM 1 MM\n1 L X+0 Y+0 R0 FMAX\n" * 9, "dialect", 1, 0),
    "Sinumerik": (b"%_N_PART_MPF\nDEF REAL A\nR1=5\n" * 9, "dialect", 1, 0),
    "ShopBot": (b"'SHOPBOT\nSA\nMS,50,20\nJ2,0,0\n&T=1\nC6\n" * 9, "dialect", 1, 0),
    "Okuma": (b"$PART.MIN%\nO1\nG1 X=V1\n" * 9, "dialect", 1, 0),
}  # fmt: skip


@pytest.mark.sample(quick=12)
@pytest.mark.parametrize("name", BAD)
def test_bad_text_gives_one_clear_diagnostic(name):
    text, wanted, line, column = BAD[name]
    code, errors = findings(text)
    assert code == 1
    assert [each["id"] for each in errors] == [wanted]
    assert errors[0]["help"]
    assert "{" not in errors[0]["message"] + errors[0]["help"]
    if line:
        assert errors[0]["line"] == line
    if column:
        assert errors[0]["col"] == column


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("verb", ["lab canon", "time", "run", "plot"])
@pytest.mark.parametrize("name", ["empty", "binary", "missing feed", "line of 10 MB"])
def test_every_verb_refuses_bad_text(verb, name, tmp_path):
    picture = ["-o", tmp_path / "x.png"] if verb == "plot" else []
    result = pycnc(*verb.split(), "-", *picture, stdin=BAD[name][0])
    assert result.code == 1
    assert f"error[{BAD[name][1]}]" in result.err
    assert "Traceback" not in result.err
    assert len(result.err) < 2000


def test_what_a_terminal_would_obey_is_not_printed():
    shown = pycnc("check", "-", stdin=BAD["control character"][0]).out
    assert "\x1b" not in shown
    assert "\N{REPLACEMENT CHARACTER}" in shown


def test_a_long_line_is_shown_around_its_mistake():
    text = START + b"(" + b"x" * 500 + b") G1 X1 \xc3\xa4 F100\n"
    lines = pycnc("check", "-", stdin=text).out.splitlines()
    source, caret = next((a, b) for a, b in zip(lines, lines[1:], strict=False) if b[-1:] == "^")
    assert len(source) < 120
    assert source[len(caret) - 1] == "ä"


@pytest.mark.parametrize(
    ("wording", "letter"),
    [("travel", "X"), ("number-range", "S"), ("feed-missing", "S"), ("word-missing", "G")],
)
def test_a_word_can_have_wording_of_its_own(wording, letter):
    assert diagnostics.WORDING.get(f"{wording}:{letter}", diagnostics.WORDING[wording])


def test_what_is_not_built_is_told_as_not_supported_yet():
    for line in (b"G17.1", b"G18.1", b"G19.1"):
        (error,) = findings(START + line + b"\n")[1]
        assert error["id"] == "unsupported"
        assert error["message"] == f"{line.split()[0].decode()} is not supported yet"


# What a lathe reads in G-code system A and a program may have meant otherwise: id and words of the
# finding, and whether system B reads the lines without one.
LATHE_LINES = {
    "G90 X55\nX50": ("word-missing", "needs X and Z", True),
    "G94 F100\nX55": ("word-missing", "needs X and Z", True),
    "G91 X-1": ("unsupported", "system A", True),
    "G95 F0.2": ("unsupported", "system A", True),
    "G92 X49.2 Z-20": ("word-missing", "thread cycle", True),
    "G54 G0 U2": ("incremental", "counts from where the axis stands", False),
}


@pytest.mark.parametrize("lines", LATHE_LINES)
def test_what_a_lathe_reads_by_its_system_is_told_with_the_flag_that_settles_it(lines):
    text = f"G21 G18\nG0 X60 Z2\n{lines}\nM2\n".encode()
    name, words, fits_b = LATHE_LINES[lines]
    code, errors = findings(text, "--machine", "cak6150n")
    assert code == 1
    assert [each["id"] for each in errors] == [name]
    assert words in errors[0]["message"]
    assert not fits_b or "dialect.system=B" in errors[0]["help"]
    in_b = findings(text, "--machine", "cak6150n", "--set", "dialect.system=B")[1]
    assert (in_b == []) == fits_b


@pytest.mark.parametrize("system", ["A", None])
def test_a_turning_cycle_notes_a_system_that_nobody_said(system):
    text = b"G21 G18 F100\nG0 X60 Z2\nG90 X55 Z-30\nX50\nM2\n"
    said = ["--set", f"dialect.system={system}"] if system else []
    result = pycnc("check", "--json", "--machine", "cak6150n", *said, "-", stdin=text)
    found = json.loads(result.out)
    assert [each["id"] for each in found].count("assumed-system") == (system is None)


@pytest.mark.parametrize(("base", "feed"), [("linuxcnc", "F10"), ("grbl", "F254")])
def test_a_feed_beside_its_units_is_read_as_the_language_does_with_a_note(base, feed):
    text, more = b"G90 G17 G94 G20 F10\nG1 X1\nM2\n", ("--dialect", base)
    (note,) = json.loads(pycnc("check", "--json", "-", *more, stdin=text).out)
    assert (note["id"], note["severity"], note["line"]) == ("feed-units", "note", 1)
    assert f"{feed} mm/min" in pycnc("lab", "canon", "-", *more, stdin=text).out


def test_the_travel_message_names_the_end_that_was_passed():
    low = findings(START + b"G1 Y-251 F100\n")[1][0]
    assert "Y reaches -251.000 mm, its travel ends at -250.000 mm" in low["message"]
    assert "axis.y.min_mm" in low["help"]


def test_every_id_of_the_kernel_has_words():
    assert set(diagnostics.ids()) <= set(diagnostics.WORDING)


# Files


@pytest.mark.parametrize("verb", ["check", "lab canon", "time", "run"])
def test_a_file_that_cannot_be_read_is_told(verb, tmp_path):
    for name in (tmp_path, tmp_path / "missing.nc", tmp_path / "a" / "b.nc"):
        result = pycnc(*verb.split(), name)
        assert result.code == 2
        assert f"{name}: error[file]: cannot read it: " in result.err
        assert "Traceback" not in result.err


@pytest.mark.parametrize(
    "data", [b"", b"\x00\x01\x02", b"\xff\xfe", b"axis = 1\n", b"[axis.x]\nv_max_mm_s = -1\n"]
)
def test_a_machine_file_that_is_wrong_is_told(data, tmp_path):
    file = tmp_path / "machine.toml"
    file.write_bytes(data)
    for name in (file, tmp_path):
        result = pycnc("check", "-", "--machine", name, stdin=START)
        assert result.code == 2
        assert f"{name}: error[machine]: " in result.err
        assert "Traceback" not in result.err


# Anything at all

WORDS = st.sampled_from(
    "G0 G1 G2 G3 G4 G10 G17 G18 G19 G20 G21 G28 G43 G49 G53 G55 G59.3 G61.1 G64 G80 G90 G91 G90.1 "
    "G92 G92.1 G93 G94 G95 M0 M1 M2 M3 M6 M30 M60 T1 H1 S100 F100 X1 Y-2 Z.5 I3 J-4 K5 R6 P7 Q8 L2 "
    "X999999 X1e5 N5 / ( ) ; % # [ = <a> E1 U1 A90 $H \t \r \0".split(" ")
)


@pytest.mark.thorough
@examples(150)
@given(st.lists(st.lists(WORDS, max_size=6).map(" ".join), max_size=12).map("\n".join))
def test_any_words_are_planned_and_run_or_refused(text):
    result = pycnc("run", "-q", "-", "--set", "axis.a.v_max_deg_s=90",
                   "--set", "axis.a.a_max_deg_s2=900", "--set", "axis.a.j_max_deg_s3=9000",
                   "--set", "dialect.feed_default_mm_min=9000", stdin=text.encode())  # fmt: skip
    assert result.code in (0, 1)
    assert "error[limit]" not in result.err
    assert "error[internal]" not in result.err


@examples(300)
@given(st.binary(max_size=400))
def test_any_bytes_are_decoded_or_refused(data):
    blocks, found = stages.decode(data, MILL)
    assert len(blocks) + len(found) > 0
    assert set(found["code"].tolist()) <= CODES


MILL = Machine.load("mill3")
CODES = {getattr(lib, name) for name in dir(lib) if name.startswith(("NCK_E_", "NCK_NOTE_"))}


def test_quiet_tells_like_errors_once_with_their_count():
    told = pycnc("check", "-q", "-", stdin=b"G1 F100 X1 E5\n" * 99).out
    assert told.count("error[") == 2 and "98 more like this" in told and "note" not in told
