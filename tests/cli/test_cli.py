# SPDX-License-Identifier: MIT
"""The command line: verbs, JSON, exit codes, streams."""

import contextlib
import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from command_line import pycnc

from pycnc import kernel

EXAMPLES = Path(__file__).resolve().parents[2] / "pycnc" / "examples"
GOOD = b"G21 G90 G17 G91.1\nS1200 M3\nG1 X10 Y0.5 F600\nG3 X20 Y10.5 I0 J10\nG4 P0.25\nM30\n"
WRONG = b"G21 G90 G17\nG1 X10 F600\nG1 Q5\nG2 X20 I3 J4\nM2\n"


@pytest.fixture
def good(tmp_path):
    file = tmp_path / "good.nc"
    file.write_bytes(GOOD)
    return file


@pytest.fixture
def wrong(tmp_path):
    file = tmp_path / "wrong.nc"
    file.write_bytes(WRONG)
    return file


def script(*arguments, **options):
    """Run the installed module in a process of its own."""
    command = [sys.executable, "-m", "pycnc.cli", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, timeout=120, **options)


# The verbs


def test_the_verbs_are_those_that_are_built():
    shown = pycnc("--help").out
    verbs = re.findall(r"^  (\w+) {2,}\S", shown.split("Commands:")[1], re.M)
    built = "look check time why report run serve plot compare sweep"
    assert verbs == [*built.split(), "machine", "linuxcnc", "lab"]


def test_check_tells_all_diagnostics_with_line_caret_and_help(wrong, good):
    result = pycnc("check", wrong, good)
    lines = result.out.splitlines()
    assert result.code == 1
    at = lines.index(f"{wrong}:3:4: error[word-unused]: no code of this block uses Q5")
    assert lines[at + 1] == "  G1 Q5"
    assert lines[at + 2] == "     ^"
    assert lines[at + 3].startswith("  help: ")
    assert f"{wrong}:4:1: error[arc-radius]: arc ends" in result.out
    assert f"{good}: no errors in" in result.out


def test_the_arc_message_has_radii_and_tolerance(wrong):
    text = pycnc("check", wrong, "--set", "path.arc_radius_mm=0.002").out
    words = (
        r"arc ends \d+\.\d{3} mm off its circle "
        r"\(start radius 5\.000, end radius \d+\.\d{3}, tolerance 0\.002\)"
    )
    assert re.search(words, text)


def test_check_as_json_has_the_promised_keys(wrong):
    result = pycnc("check", "--json", wrong)
    found = json.loads(result.out)
    assert result.code == 1
    for each in found:
        assert set(each) == {"file", "line", "col", "id", "severity", "message", "help"}
    errors = [(e["line"], e["col"], e["id"]) for e in found if e["severity"] == "error"]
    assert errors == [(3, 4, "word-unused"), (4, 1, "arc-radius")]


def test_many_of_a_kind_are_counted(tmp_path):
    file = tmp_path / "many.nc"
    file.write_bytes(b"G21 G90\n" + b"G1 Q5 F100\n" * 50_000 + b"M2\n")
    result = pycnc("check", file)
    assert result.out.count("error[word-unused]: no code") == 1
    assert "49999 more like this are not shown: lines 3, 4, 5, 6, 7 …" in result.out
    assert result.code == 1


def test_quiet_check_leaves_out_the_notes():
    assert "note[" in pycnc("check", "-", stdin=b"G1 X1 F100\n").out
    assert pycnc("check", "-q", "-", stdin=b"G1 X1 F100\n").out == ""


def test_canon_lists_exact_decimals(good):
    lines = pycnc("lab", "canon", good).out.splitlines()
    assert lines[:2] == ["2 output S1200", "2 output M3"]
    assert lines[2] == "3 line X10.000000 Y0.500000 Z0.000000 F600 mm/min"
    arc = re.fullmatch(
        r"4 arc X20\.000000 Y10\.500000 Z0\.000000 G17 centre X(\S+) Y(\S+) sweep (\S+) deg"
        r" F600 mm/min",
        lines[3],
    )
    assert [float(word) for word in arc.groups()] == pytest.approx([10, 10.5, 90], abs=1e-9)
    assert lines[4:] == ["5 dwell 0.25 s", "6 end M30"]


def test_canon_as_json_and_in_inches(good):
    lines = pycnc("lab", "canon", "--json", "--units", "inch", good).out.splitlines()
    line = json.loads(lines[2])
    assert line["axes"]["X"] == "0.3937007874"
    assert (line["feed"], line["feed_unit"]) == (pytest.approx(600 / 25.4), "in/min")


def test_time_as_json_has_the_promised_keys(good):
    told = json.loads(pycnc("time", "--json", good).out)
    promised = {
        "file", "machine", "version", "schema_version", "period_s", "time_s", "blocks", "segments",
        "length_mm", "slope", "plan_s", "limit_time_s", "diagnostics", "cut_s", "rapid_s",
        "dwell_s", "accelerate_s", "cruise_s", "decelerate_s",
    }  # fmt: skip
    assert promised <= set(told)
    assert not {"peaks", "path_error_mm", "run_s", "ticks"} & set(told)
    assert told["dwell_s"] == pytest.approx(0.25)


def test_time_takes_several_files(good):
    result = pycnc("time", good, good)
    assert len(result.out.splitlines()) == 3, "and the total"
    assert len(json.loads(pycnc("time", "--json", good, good).out)) == 2


def test_time_looks_at_every_file_and_json_is_one_document(good, wrong, tmp_path):
    missing = tmp_path / "missing.nc"
    result = pycnc("time", "--json", good, wrong, missing, good)
    told = json.loads(result.out)
    assert result.code == 2
    assert [each["file"] for each in told] == list(map(str, (good, wrong, missing, good)))
    assert ["time_s" in each for each in told] == [True, False, False, True]
    errors = [[d["id"] for d in e["diagnostics"] if d["severity"] == "error"] for e in told]
    assert errors == [[], ["word-unused", "arc-radius"], ["file"], []]
    assert pycnc("time", "--json", good, wrong).code == 1
    assert json.loads(pycnc("time", "--json", wrong).out)["file"] == str(wrong)
    lines = pycnc("time", good, wrong, missing, good).out.splitlines()
    assert [line.partition(" on ")[0] for line in lines[:-1]] == [str(good)] * 2


def test_a_defect_in_one_file_does_not_hide_the_others(good, wrong, monkeypatch):
    pieces = kernel.Planner.pieces

    def spoilt(self):
        return pieces(self) if b"X20" in self._text else 1 / 0

    monkeypatch.setattr("pycnc.kernel.Planner.pieces", spoilt)
    good_too = good.with_name("short.nc")
    good_too.write_bytes(b"G21 G90\nG1 X1 F100\nM2\n")
    result = pycnc("time", "--json", good_too, good)
    told = json.loads(result.out)
    assert result.code == 4
    assert told[0]["diagnostics"][0]["id"] == "internal"
    assert told[1]["time_s"] > 0


def test_check_looks_at_every_file(good, wrong, tmp_path):
    result = pycnc("check", "--json", tmp_path, wrong, good)
    found = {(each["file"], each["id"]) for each in json.loads(result.out)}
    assert result.code == 2
    assert {(str(tmp_path), "file"), (str(wrong), "arc-radius")} <= found
    assert f"{good}: no errors" in pycnc("check", tmp_path, good).out


def test_time_names_machine_and_slope_and_tells_what_was_assumed():
    result = pycnc("time", "-", stdin=b"G1 X10 F600\nM2\n")
    assert re.match(r"<stdin> on mill3, slope optimal: 1\.0\d\d s \(cut 1\.", result.out)
    assert "note[assumed-units]" in result.err
    assert pycnc("time", "-q", "-", stdin=b"G1 X10 F600\nM2\n").err == ""
    grades = pycnc("lab", "time", "-", "--plan", "grades", stdin=GOOD)
    assert "slope linear, planned by grades: " in grades.out


def test_every_verb_tells_as_json_that_it_cannot_read_a_file(tmp_path):
    page, picture = tmp_path / "x.html", tmp_path / "x.png"
    for verb in (["time"], ["run"], ["report", "-o", page], ["plot", "-o", picture]):
        result = pycnc(*verb, "--json", tmp_path)
        assert result.code == 2
        assert json.loads(result.out)["diagnostics"][0]["id"] == "file"


def test_run_writes_json_a_trace_and_a_picture(good, tmp_path):
    trace, picture = tmp_path / "t.npz", tmp_path / "t.png"
    result = pycnc("run", "--json", good, "-o", trace, "--plot", picture)
    told = json.loads(result.out)
    assert result.code == 0
    assert told["slope"] == "optimal"
    assert 0 < told["path_error_mm"] <= 0.01, "the machine's tolerance"
    assert told["peaks"]["x"]["a"] <= 1 + 1e-6
    assert told["peaks"]["x"]["j"] <= 1 + 1e-6
    with np.load(trace) as archive:
        assert len(archive["t_s"]) == told["ticks"]
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_a_long_path_cuts_nothing_off_the_summary(tmp_path):
    folder = tmp_path / ("long_" * 20) / ("longer_" * 20)
    folder.mkdir(parents=True)
    file, trace = folder / "part.nc", folder / "trace.csv"
    file.write_bytes(GOOD)
    result = pycnc("run", file, "-o", trace)
    assert re.match(re.escape(str(file)) + r" on mill3, slope optimal: \d\.\d+ s\n", result.out)
    assert result.out.endswith(f"Trace: {trace}\n")
    shown = on_a_terminal("run", file, "-o", trace, COLUMNS="80", NO_COLOR="1").decode()
    told = re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", shown).replace("\r", "\n").splitlines()
    assert any(line.endswith(" s") and f"{file} on mill3, slope optimal: " in line for line in told)
    assert any(line.endswith(f"Trace: {trace}") for line in told)


def test_the_summary_of_a_run_fits_a_screen(good):
    result = pycnc("run", good)
    lines = result.out.splitlines()
    assert len(lines) <= 40
    assert max(map(len, lines)) <= 100 + len(str(good))
    for words in ("What holds it back", "Peaks", "worst at line", "No errors"):
        assert words in result.out


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ("path.tolerance_mm=0.01", ""),
        ("path.tolerance_mm=0", "On an exact path (G61, or no tolerance) a corner crossed moving"),
        ("path.slope=linear", "The linear slope limits acceleration, not jerk"),
    ],
)
def test_jerk_above_its_limit_is_explained_where_it_is_told(good, change, words):
    shown = pycnc("run", good, "--set", change).out
    told = json.loads(pycnc("run", "--json", good, "--set", change).out)
    assert (max(peak["j"] for peak in told["peaks"].values()) > 1 + 1e-6) == bool(words)
    assert words in shown
    for other in ("On an exact path", "The linear slope"):
        assert (other in shown) == words.startswith(other)


def test_a_run_with_errors_moves_nothing(wrong, tmp_path):
    result = pycnc("run", wrong, "-o", tmp_path / "t.npz")
    assert result.code == 1
    assert result.out == ""
    assert "error[arc-radius]" in result.err
    assert not (tmp_path / "t.npz").exists()
    as_json = json.loads(pycnc("run", "--json", wrong).out)
    assert [d["id"] for d in as_json["diagnostics"] if d["severity"] == "error"] == [
        "word-unused", "arc-radius",
    ]  # fmt: skip


@pytest.mark.thorough
def test_plot_says_what_it_wrote(good, tmp_path):
    picture = tmp_path / "part.svg"
    assert pycnc("plot", good, "-o", picture).out == f"{picture}\n"
    assert b"<svg" in picture.read_bytes()
    for verb, option in (("plot", "-o"), ("run", "--plot")):
        bare = tmp_path / f"bare_{verb}"
        assert pycnc(verb, good, option, bare).out.endswith(f"{bare}.png\n")
        assert bare.with_suffix(".png").read_bytes().startswith(b"\x89PNG")
        assert not bare.exists()
    told = json.loads(pycnc("plot", good, "--json", "-o", tmp_path / "bare").out)
    assert told["picture"] == str(tmp_path / "bare.png")


@pytest.mark.parametrize(
    ("name", "machine", "tolerance"),
    [("first_part.ngc", "mill3", 0.01), ("turned_pin.ngc", "cak6150n", 0.005)],
)
def test_the_examples_run_without_a_word_of_complaint(name, machine, tolerance):
    result = pycnc("run", "--json", EXAMPLES / name, "--machine", machine)
    told = json.loads(result.out)
    assert (result.code, result.err, told["diagnostics"]) == (0, "", [])
    assert told["path_error_mm"] <= tolerance
    assert max(peak["j"] for peak in told["peaks"].values()) <= 1


def test_the_first_part_is_what_its_generator_writes():
    made = subprocess.run(
        [sys.executable, EXAMPLES / "make_first_part.py"], capture_output=True, check=True
    )
    assert made.stdout == (EXAMPLES / "first_part.ngc").read_bytes()


def test_settings_and_tools_reach_the_run(tmp_path):
    table = tmp_path / "tool.tbl"
    table.write_text("T99 P1 Z12.5 D1\n")
    program = b"G21 G90 T99 M6\nG43 H99\nG1 Z1 F100\nM2\n"
    arguments = ("run", "--json", "-", "--tools", table)
    assert json.loads(pycnc(*arguments, stdin=program).out)["length_mm"] == pytest.approx(13.5)
    assert pycnc("run", "-q", "-", stdin=program).code == 1
    limited = pycnc(*arguments, "--set", "axis.z.max_mm=13", "--set", "home.g28.z_mm=0",
                    "--set", "home.g30.z_mm=0", stdin=program)  # fmt: skip
    assert json.loads(limited.out)["diagnostics"][-1]["id"] == "travel"


def test_the_machines_are_listed_and_shown():
    listed = {
        row["name"]: row["axes"] for row in json.loads(pycnc("machine", "list", "--json").out)
    }
    assert listed["mill5_xyzac"] == "xyzac"
    assert "[axis.x]" in pycnc("machine", "show", "mill3").out
    shown = json.loads(pycnc("machine", "show", "mill3", "--json", "--set", "axis.x.max_mm=1").out)
    assert shown["axis.x.max_mm"] == {"value": 1, "source": "--set"}


# Exit codes


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["check", "missing.nc"], 2),
        (["check", "."], 2),
        (["check"], 2),
        (["frobnicate"], 2),
        (["run", "-", "--machine", "nowhere"], 2),
        (["run", "-", "--set", "axis.x.max_mm"], 2),
        (["run", "-", "--dialect", "klartext"], 2),
        (["run", "-", "-o", "trace.xyz"], 2),
        (["run", "-", "-o", "/nowhere/trace.npz"], 2),
        (["run", "-", "--plot", "/nowhere/picture.png"], 2),
        (["run", "-", "--plot", "picture.xyz"], 2),
        (["lab", "run", "-", "--prep-steps", "0"], 2),
        (["lab", "run", "-", "--prep-steps", "99999999999"], 2),
        (["run", "-", "-o", ""], 2),
        (["run", "-", "--plot", ""], 2),
        (["plot", "-", "-o", "."], 2),
        (["lab", "time", "-", "--backend", "opencl"], 4),
        (["lab", "bench", "frobnicate"], 2),
        (["machine", "validate", "nowhere"], 2),
        (["check", "-"], 0),
    ],
)
def test_an_exit_code_says_what_kind_of_trouble_it_was(arguments, code, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = pycnc(*arguments, stdin=GOOD)
    assert result.code == code
    assert "Traceback" not in result.out + result.err
    if code:
        assert result.err + result.out


def test_a_broken_limit_is_told_and_exits_1(good, monkeypatch):
    monkeypatch.setattr("pycnc.cli.PEAK_TOLERANCE", -0.5)
    result = pycnc("run", "-q", good, "--set", "path.slope=linear")
    assert result.code == 1
    assert f"{good}: error[limit]: x a: 1.0" in result.err


def test_a_defect_is_one_line_and_exits_4(good, monkeypatch):
    monkeypatch.setattr("pycnc.kernel.Planner.pieces", lambda self: 1 / 0)
    result = pycnc("time", good)
    assert result.code == 4
    assert result.err.startswith("pycnc: error[internal]: ZeroDivisionError")
    assert "Traceback" not in result.err


def test_an_interrupt_exits_130(good, monkeypatch):
    def interrupted(self):
        raise KeyboardInterrupt

    monkeypatch.setattr("pycnc.kernel.Planner.pieces", interrupted)
    assert pycnc("time", good).code == 130


# Streams


def test_a_process_behaves_as_the_function_does(good, wrong):
    assert script("run", "--json", good).returncode == 0
    done = script("check", wrong, env={**os.environ, "LC_ALL": "C", "PYTHONIOENCODING": "ascii"})
    assert done.returncode == 1
    assert b"Traceback" not in done.stderr


def test_an_interrupt_from_the_keyboard_exits_130(tmp_path):
    file = tmp_path / "long.nc"
    file.write_bytes(b"G21\nG1 X1 F0.001\nM2\n")
    command = [sys.executable, "-m", "pycnc.cli", "run", "-v", str(file)]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )  # fmt: skip
    process.stderr.readline()  # the note about G90: the run is about to begin
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert b"Traceback" not in err


LOADING = """
import sys

class Interrupted:
    def find_spec(self, name, path=None, target=None):
        if name == "pycnc.cli.door":
            raise KeyboardInterrupt

sys.meta_path.insert(0, Interrupted())
from pycnc.__main__ import main
main()
"""


def test_an_interrupt_while_modules_are_loaded_exits_130():
    done = subprocess.run([sys.executable, "-c", LOADING, "--version"], capture_output=True)
    assert (done.returncode, done.stdout, done.stderr) == (130, b"", b"")


def test_an_interrupt_ends_workers_without_a_word(tmp_path):
    files = [tmp_path / name for name in ("one.nc", "two.nc")]
    for file in files:
        file.write_bytes(b"G21 G90 F600\n" + b"G1 X1\nG1 X2\n" * 400_000 + b"M2\n")
    command = [sys.executable, "-m", "pycnc", "time", "--jobs", "2", *map(str, files)]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )  # fmt: skip
    while len(_session(process.pid)) < 3:  # both workers are there
        assert process.poll() is None
    os.killpg(process.pid, signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert b"Traceback" not in err


def _session(leader):
    """Return the processes of a session, but for the one that tracks what they share."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            session = (folder / "stat").read_text().rpartition(")")[2].split()[3]
            helps = b"resource_tracker" in (folder / "cmdline").read_bytes()
            found += [folder.name] if session == str(leader) and not helps else []
    return found


def test_a_reader_that_leaves_early_is_no_error(tmp_path):
    file = tmp_path / "many.nc"
    file.write_bytes(b"G21 G90 F600\n" + b"G1 X1\nG1 X2\n" * 20_000 + b"M2\n")
    command = f"{sys.executable} -m pycnc.cli lab canon {file} | head -1; echo ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", command], capture_output=True, timeout=120)
    assert done.stdout.split()[-1] == b"0"
    assert done.stderr == b""


@pytest.mark.thorough
def test_a_stream_that_is_closed_or_full_is_no_traceback(good):
    for words, code in ((">&-", 0), ("2>&-", 0), (">/dev/full", 2), ("--json >/dev/full", 2)):
        command = f"{sys.executable} -m pycnc.cli time {good} {words}"
        done = subprocess.run(["bash", "-c", command], capture_output=True, timeout=120)
        assert (done.returncode, b"Traceback" in done.stderr) == (code, False), words
        assert (b"error[file]: No space left" in done.stderr) == (code == 2)
    done = subprocess.run(["bash", "-c", f"{sys.executable} -m pycnc.cli check - <&-"],
                          capture_output=True, timeout=120)  # fmt: skip
    assert done.returncode == 2
    assert b"-: error[file]: cannot read it" in done.stderr


def on_a_terminal(*arguments, **changes):
    """Return what a process writes to a terminal, as its stdout and stderr."""
    os_pty = pytest.importorskip("pty")
    try:
        ours, theirs = os_pty.openpty()
    except OSError as cause:
        pytest.skip(f"this system has no pseudo-terminals: {cause}")
    command = [sys.executable, "-m", "pycnc.cli", *map(str, arguments)]
    environment = {**os.environ, "TERM": "xterm", **changes}
    process = subprocess.Popen(command, stdout=theirs, stderr=theirs, env=environment)
    os.close(theirs)
    data = b""
    with contextlib.suppress(OSError):  # the terminal is gone with the process
        while piece := os.read(ours, 65536):
            data += piece
    os.close(ours)
    process.wait(timeout=120)
    return data


def test_a_name_with_brackets_is_no_markup(tmp_path):
    file = tmp_path / "[" / "b].nc"
    file.parent.mkdir()
    file.write_bytes(GOOD)
    shown = on_a_terminal("time", file)
    assert b"error[" not in shown
    assert str(file).encode() + b" on mill3" in shown


def test_colours_are_for_terminals_that_want_them(wrong):
    assert b"\x1b[" in on_a_terminal("check", wrong)
    assert b"\x1b[" not in on_a_terminal("check", wrong, "-q", NO_COLOR="1")
    assert b"\x1b[" not in script("check", wrong).stdout
