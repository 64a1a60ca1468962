# SPDX-License-Identifier: MIT
"""What is written is there whole or not at all, where it was asked for; what is read has an end."""

import os
import signal
import stat
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from command_line import pycnc as command

import pycnc
from pycnc import files
from pycnc.planning import pipeline
from pycnc.planning import plan as planning

SLOW = b"G21 G90 F0.5 G1 X0.05\nM2\n"  # 6 s, some thousand cells
ENDLESS = "G21 G90 F6000\no1 while [1 gt 0]\nG1 X1\nG1 X0\no1 endwhile\nM2\n"
LOOP = ENDLESS.replace("[1 gt 0]", "[#1 lt 30000]").replace("G1 X0", "G1 X0\n#1=[#1+1]")


def write(path, text):
    with files.Part(path) as part:
        part.write(text)


def test_writers_of_one_file_do_not_mix(tmp_path):
    target, texts = tmp_path / "out.csv", [str(k) * 100_000 for k in range(8)]
    with ThreadPoolExecutor(8) as pool:
        list(pool.map(lambda text: write(target, text), texts))
    assert target.read_text() in texts
    assert os.listdir(tmp_path) == ["out.csv"]


def test_what_is_beside_the_file_stays(tmp_path):
    (tmp_path / "out.csv.part").write_text("mine")
    write(tmp_path / "out.csv", "ours")
    assert (tmp_path / "out.csv.part").read_text() == "mine"
    with pytest.raises(ZeroDivisionError), files.Part(tmp_path / "out.csv") as part:
        part.write("half of")
        raise ZeroDivisionError
    assert (tmp_path / "out.csv").read_text() == "ours"
    assert sorted(os.listdir(tmp_path)) == ["out.csv", "out.csv.part"]


@pytest.mark.parametrize("there", [True, False])
def test_a_link_stays_one_and_what_it_leads_to_is_written(tmp_path, there):
    (tmp_path / "far").mkdir()
    if there:
        (tmp_path / "far" / "it").write_text("old")
    (tmp_path / "near").symlink_to("far/it")
    (tmp_path / "nearer").symlink_to("near")
    write(tmp_path / "nearer", "fresh")
    assert (tmp_path / "nearer").is_symlink() and (tmp_path / "near").is_symlink()
    assert (tmp_path / "far" / "it").read_text() == "fresh"


def test_a_file_keeps_its_mode_and_another_has_that_of_its_maker(tmp_path):
    kept, made = tmp_path / "kept", tmp_path / "made"
    kept.write_text("")
    kept.chmod(0o640)
    before = os.umask(0o027)
    try:
        write(kept, "x")
        write(made, "x")
    finally:
        os.umask(before)
    assert [stat.S_IMODE(each.stat().st_mode) for each in (kept, made)] == [0o640, 0o640]
    kept.chmod(0o600)
    write(kept, "y")
    assert stat.S_IMODE(kept.stat().st_mode) == 0o600


def test_a_pipe_and_a_device_are_written_as_they_are(tmp_path):
    pipe, read = tmp_path / "pipe", []
    os.mkfifo(pipe)
    reader = threading.Thread(target=lambda: read.append(pipe.read_bytes()))
    reader.start()
    write(pipe, "through")
    reader.join()
    assert read == [b"through"] and stat.S_ISFIFO(pipe.stat().st_mode)
    write("/dev/null", "away")
    assert stat.S_ISCHR(os.stat("/dev/null").st_mode)


def test_a_name_may_be_as_long_as_names_are(tmp_path):
    write(tmp_path / ("n" * 255), "x")
    assert (tmp_path / ("n" * 255)).read_text() == "x"


@pytest.mark.parametrize("name", ["", "absent/out.csv"])
def test_what_cannot_be_written_is_named_as_it_was_asked_for(tmp_path, name):
    with pytest.raises(OSError) as told:
        files.Part(tmp_path / name)
    assert told.value.filename == str(tmp_path / name)
    assert os.listdir(tmp_path) == []


def test_what_is_read_has_an_end(tmp_path):
    (tmp_path / "long").write_bytes(b"G1 X1\n" * 10)
    with pytest.raises(OSError, match="more than 59 bytes"):
        files.read(tmp_path / "long", 59)
    assert files.read(tmp_path / "long", 60) == b"G1 X1\n" * 10
    with open("/dev/zero", "rb") as zeros, pytest.raises(OSError, match="more than 100 bytes"):
        files.read_open(zeros, "zeros", 100)
    told = command("check", "/dev/zero")
    assert (told.out + told.err).count("error[binary]") == 1
    os.truncate(tmp_path / "long", files.PROGRAM_MOST + 1)
    assert "error[file]" in command("check", tmp_path / "long").err
    assert "error[machine]" in command("check", "/dev/null", "-m", "/dev/zero").err


def test_a_program_that_never_ends_is_not_planned(tmp_path):
    (tmp_path / "endless.ngc").write_text(ENDLESS)
    told = command("time", tmp_path / "endless.ngc")
    assert told.code == 1 and "error[endless]" in told.err


@pytest.mark.thorough
def test_a_program_that_goes_round_is_planned_when_it_is_read():
    with pipeline.Pipeline() as beside:
        program = pycnc.Program(LOOP.encode(), pycnc.Machine.load("mill3"), beside=beside)
        assert beside.is_left and program.diagnostics.errors == 0
        plan = planning.Plan(program, keep=False, beside=beside)
    assert plan.totals == planning.Plan(program).totals


def test_many_cells_are_planned_again_when_they_are_asked_for(monkeypatch):
    program = pycnc.load(SLOW)
    kept = pycnc.plan(program)
    monkeypatch.setattr(planning, "_CELLS_AT_ONCE", 100)
    later = pycnc.plan(program)
    assert later._cells is None and repr(later) == repr(kept)
    assert later.time_s == kept.time_s and (later.segs == kept.segs).all()
    assert np.array_equal(later.cells, kept.cells)


def test_a_feed_that_no_axis_may_have_is_refused():
    text = "G21 G90 G94\nG1 X1 F0.000000001\nG1 X2 F0.00005\nG1 X3 F0.00006\nM2\n"
    found = pycnc.load(text).diagnostics
    told = [(each.id, each.line, each.col) for each in found if each.severity == "error"]
    assert told == [("number-range", 2, 7), ("number-range", 3, 7)]


@pytest.mark.parametrize("ignored", [False, True])
def test_an_interrupt_while_modules_are_loaded_is_the_systems(ignored):
    ask = "import signal, pycnc.__main__; print(int(signal.getsignal(signal.SIGINT)))"
    before = f"import signal; signal.signal(2, signal.{'SIG_IGN' if ignored else 'SIG_DFL'})"
    handler = "" if ignored else "signal.signal(2, signal.default_int_handler); "
    code = f"{before}; {handler}{ask}"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stdout.strip() == str(int(signal.SIG_IGN if ignored else signal.SIG_DFL))
