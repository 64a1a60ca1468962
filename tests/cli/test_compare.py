# SPDX-License-Identifier: MIT
"""``pycnc compare``: two runs by time, path and line; measured logs; what is wrong with a log."""

import json

import numpy as np
import pytest
from command_line import pycnc

from pycnc import load, run
from pycnc.machine import Machine
from pycnc.report import compare

TEXT = "G21 G90 G17\nG1 F3000 X20\nY15\nG4 P0.2\nG1 X0 F1500\nG3 X0 Y5 J-5\nG1 Y0\nM2\n"


@pytest.fixture(scope="module")
def trace():
    return run(TEXT)


@pytest.fixture(scope="module")
def part(tmp_path_factory):
    file = tmp_path_factory.mktemp("compare") / "part.ngc"
    file.write_text(TEXT)
    return file


HEAD = "Time,PosX,PosY"


def write_log(file, trace, *, shift_s=0.0, rate=1.0, off_mm=0.0, noise_mm=0.0, head=HEAD):
    """Write a log as a controller might: its own clock, its own names, a path that is a bit off."""
    rng = np.random.default_rng(1)
    t = trace["t_s"] * rate + shift_s
    x, y = (trace[f"pos_{k}_mm"] + rng.normal(scale=noise_mm, size=len(t)) for k in "xy")
    y = y + off_mm * (np.abs(x - 10) < 2)
    mark = ";" if ";" in head else ","
    rows = (mark.join(f"{value:.6f}" for value in row) for row in zip(t, x, y, strict=True))
    file.write_text("\n".join([head, *rows, ""]))
    return file


def test_a_log_that_is_shifted_and_slowed_is_found_out(trace, tmp_path):
    log = write_log(tmp_path / "log.csv", trace, shift_s=0.003, rate=1.02, noise_mm=2e-4)
    columns = compare.columns_of("t=Time,x=PosX,y=PosY")
    found = compare.Comparison(compare.of_trace(trace, "A"), compare.read(log, columns))
    assert found.shift_s == pytest.approx(0.003, abs=3e-4)
    assert found.rate == pytest.approx(1.02, abs=1e-4)
    assert found.time_s == pytest.approx(0.02 * trace["t_s"][-1], rel=0.01)
    assert found.distance_mm < 0.002
    rest = next(row for row in found.lines if row[0] == 3)
    assert rest[2] == pytest.approx(1.02 * rest[1], abs=0.1), "with the dwell behind it"


@pytest.mark.parametrize("every", [500, 1500])
def test_a_log_of_few_samples_stays_in_order(tmp_path, every):
    slow = run(TEXT.replace("F3000", "F200").replace("F1500", "F300"))
    log = write_log(tmp_path / "log.csv", slow, shift_s=0.003, rate=1.02)
    head, *rows = log.read_text().splitlines()
    log.write_text("\n".join([head, *rows[::every]]))
    columns = compare.columns_of("t=Time,x=PosX,y=PosY")
    found = compare.Comparison(compare.of_trace(slow, "A"), compare.read(log, columns))
    assert len(found.b.t) == -(-len(rows) // every) > 12
    assert found.keeps_time
    assert found.distance_mm < 1e-4
    assert found.rate == pytest.approx(1.02, abs=1e-3)
    assert found.shift_s == pytest.approx(0.003, abs=0.01)


def test_a_path_that_goes_back_on_itself_stays_in_order(tmp_path):
    """The way back is as near as the way out: a log of some noise must not change over."""
    there = run("G21 G90\nG1 F3000 X9\nX0\nX9\nX0\nM2\n")
    log = write_log(tmp_path / "log.csv", there, rate=1.02, noise_mm=1e-3)
    columns = compare.columns_of("t=Time,x=PosX,y=PosY")
    found = compare.Comparison(compare.of_trace(there, "A"), compare.read(log, columns))
    assert found.distance_mm < 0.01
    assert found.rate == pytest.approx(1.02, abs=1e-3)


def test_no_clock_is_told_of_a_log_that_goes_elsewhere(trace, part, tmp_path):
    log = write_log(tmp_path / "log.csv", trace)
    result = pycnc("compare", part, log, "--map", "t=Time,x=PosX:inch,y=PosY:inch")
    assert "clock  no clock fits: " in result.out
    assert "most by line" not in result.out


def test_a_path_that_is_left_is_told_with_its_line(trace, tmp_path):
    log = write_log(tmp_path / "log.csv", trace, off_mm=-0.05)
    columns = compare.columns_of("t=Time,x=PosX,y=PosY")
    found = compare.Comparison(compare.of_trace(trace, "A"), compare.read(log, columns))
    assert found.distance_mm == pytest.approx(0.05, abs=1e-6)
    assert found.distance_line in (2, 5)


@pytest.mark.parametrize("ending", ["npz", "csv"])
def test_a_trace_is_equal_to_itself(trace, tmp_path, ending):
    file = tmp_path / f"trace.{ending}"
    getattr(trace, f"to_{ending}")(file)
    found = compare.Comparison(compare.of_trace(trace, "A"), compare.read(file))
    assert found.time_s == 0
    assert found.distance_mm < compare.STILL_MM
    assert {row[2] - row[1] for row in found.lines} == {0}
    assert abs(found.shift_s) + abs(found.rate - 1) + found.residual_s < 1e-3


def test_a_gap_and_other_units_are_told(trace, part, tmp_path):
    whole = write_log(tmp_path / "log.csv", trace).read_text().splitlines()
    (tmp_path / "gap.csv").write_text("\n".join([*whole[:100], *whole[200:]]))
    told = pycnc("compare", part, tmp_path / "gap.csv", "--map", "t=Time,x=PosX,y=PosY")
    assert told.code == 0
    (note,) = [line for line in told.out.splitlines() if line.startswith("note")]
    assert "no sample for 0.101 s behind sample 99" in note
    columns = compare.columns_of("t=Time,x=PosX,y=PosY")
    inches = compare.read(tmp_path / "log.csv", columns)
    inches.places = {letter: place / 25.4 for letter, place in inches.places.items()}
    (note,) = compare.Comparison(compare.of_trace(trace, "A"), inches).notes
    assert "is it in inch? (--map x=…:inch)" in note
    whole = compare.read(tmp_path / "log.csv", columns)
    assert compare.Comparison(compare.of_trace(trace, "A"), whole).notes == []


@pytest.mark.thorough
def test_settings_are_compared_by_line_and_tolerances_exit_3(part):
    options = ["compare", part, part, "--set-b", "axis.x.a_max_mm_s2=500"]
    told = json.loads(pycnc(*options, "--json").out)
    worst = told["lines"][0]
    assert worst["difference_s"] > 0.04
    assert worst["line"] in (2, 3, 5)
    assert told["time_difference_s"] == pytest.approx(
        sum(each["difference_s"] for each in told["lines"]), abs=0.01
    )
    assert pycnc(*options).code == 0
    beyond = pycnc(*options, "--tolerance-s", "0.01")
    assert beyond.code == 3
    assert "error[tolerance]: time: " in beyond.err
    assert pycnc(*options, "--tolerance-s", "10", "--tolerance", "1").code == 0
    path = ["compare", part, part, "--set-b", "path.tolerance_mm=0.5", "--tolerance", "0.1"]
    assert pycnc(*path).code == 3


def test_the_command_reads_a_log_with_units_and_other_marks(trace, part, tmp_path):
    log = write_log(tmp_path / "log.csv", trace, rate=1000, head="Time;PosX;PosY")
    result = pycnc("compare", part, log, "--map", "t=Time:ms,x=PosX,y=PosY", "--tolerance", "0.01")
    assert result.code == 0
    lines = result.out.splitlines()
    assert [line.split()[0] for line in lines[:5]] == ["A", "B", "time", "clock", "path"]
    assert "0.000% " in lines[3] or "0.001% " in lines[3]
    assert lines[4] == "path   B is on A's path; axes XY"


@pytest.mark.parametrize(
    ("text", "map_", "words"),
    [
        ("Time,PosX\n0,1\n0.1,nan\n", "t=Time,x=PosX", "sample 2: x is no number"),
        ("Time,PosX\n0,1\n0.1,abc\n", "t=Time,x=PosX", ":3: PosX is 'abc', no number"),
        ("Time,PosX\n0,1\n0.1\n", "t=Time,x=PosX", ":3: PosX is 'nothing', no number"),
        ("Time,PosX\n0,1\n0,2\n", "t=Time,x=PosX", "time does not go on"),
        ("Time,PosX\n0,1\n", "t=Time,x=PosX", "has less than two samples"),
        ("", "t=Time,x=PosX", "is empty"),
        ("Time,PosX\n0,1\n1,2\n", "t=Zeit,x=PosX", "no column 'Zeit'; it has: Time, PosX"),
        ("Time,PosX\n0,1\n1,2\n", "t=Time,x=PosX:parsec", "no unit of it"),
        ("Time,PosX\n0,1\n1,2\n", "x=PosX", "must look like"),
        ("Time,PosX\n0,1\n1,2\n", None, "--map t=Time,x=PosX"),
    ],
)
def test_what_is_wrong_with_a_log_is_told_with_its_place(part, tmp_path, text, map_, words):
    log = tmp_path / "log.csv"
    log.write_text(text)
    result = pycnc("compare", part, log, *(["--map", map_] if map_ else []))
    assert result.code == 2
    assert words in result.err
    assert "Traceback" not in result.err


def test_other_bad_operands_are_told(part, tmp_path):
    archive = tmp_path / "trace.npz"
    archive.write_bytes(b"no archive")
    assert "is no NumPy archive" in pycnc("compare", part, archive).err
    np.savez_compressed(archive, t_s=np.arange(9999.0))
    whole = archive.read_bytes()
    for bad in (whole[:-9], whole[:900] + bytes(99) + whole[999:]):
        archive.write_bytes(bad)
        assert "is no NumPy archive" in pycnc("compare", part, archive).err
    np.save(archive.open("wb"), np.arange(3.0))
    assert "is no NumPy archive" in pycnc("compare", part, archive).err
    (tmp_path / "trace.parquet").write_bytes(b"no table")
    assert "is no Parquet file" in pycnc("compare", part, tmp_path / "trace.parquet").err
    np.savez(archive, t_s=np.arange(3.0))
    assert "is no trace of pycnc" in pycnc("compare", part, archive).err
    assert pycnc("compare", part, tmp_path / "missing.npz").code == 2
    assert pycnc("compare", part, "-", stdin=b"G1 Q5\n").code == 1


def back_and_forth(seed):
    """Return a program whose path goes back the way that it came: holes, slots and laps of them."""
    rng = np.random.default_rng([31, seed])
    lines = ["G21 G90 G94 G17 G64", "G0 X0 Y0 Z5"]
    for _ in range(int(rng.integers(4, 12))):
        x, y = rng.uniform(-50, 50, 2)
        lines.append(f"G0 X{x:.3f} Y{y:.3f}")
        kind = rng.integers(3)
        if kind == 0:
            cycle = rng.choice(["G81", "G82 P0.1", "G83 Q2"])
            lines.append(f"{cycle} X{x:.3f} Y{y:.3f} Z-6 R1 F300")
            lines.append("G80 G0 Z5")
        else:
            lines.append("G1 Z-1 F400")
            turn = f"X{x + rng.uniform(5, 30):.3f}" if kind == 1 else "Z-1.2"
            for _ in range(int(rng.integers(1, 4))):
                lines += [f"G1 {turn} F{rng.integers(500, 5000)}", f"X{x:.3f} Z-1"]
            lines.append("G0 Z5")
    return "\n".join([*lines, "M2", ""])


def distance_within(seed, tolerance):
    """Return how far a program's run within a tolerance is told to be from that within 0.01 mm."""
    text = back_and_forth(seed)
    runs = [run(load(text, machine=Machine.load("mill3", set=[f"path.tolerance_mm={most}"])))
            for most in (0.01, tolerance)]  # fmt: skip
    found = compare.Comparison(*(compare.of_trace(each, "run") for each in runs))
    return found.distance_mm


# Of 40 programs it is a lap ahead in one (seed 16), where both laps are as near.
@pytest.mark.sample(1)
@pytest.mark.parametrize("first", range(0, 40, 8))
def test_a_path_that_goes_back_its_own_way_is_followed_in_order(first):
    told = {seed: distance_within(seed, 0.05) for seed in range(first, first + 8)}
    lost = [seed for seed, distance in told.items() if distance > 1.5 * (0.01 + 0.05)]
    assert len(lost) <= 1, told
