# SPDX-License-Identifier: MIT
"""The campaign: all that the suite draws its samples from, and the searches that take long.

    make campaign               all of it, in order; hours
    make campaign WHAT=nasty    one part, or several in quotes

Every part says how much it tried and from which seed, and is repeated by the command that is
printed before it. The exit status is the number of parts that found something.

    suite       every case of every test, fuzzing and the corpus at full length with it
    fuzz        the fuzzers in both sets of capacities, 2 million and 100 000 inputs
    sanitizers  all C tests under the sanitizers
    quality     cppcheck and MISRA over all files
    mutants     100 mutants of libnck against all C tests
    stops       20 000 rests asked for at any moment, after anything, prep alive or dead; 10 000 in
                the stand-in for LinuxCNC, 1 000 on each Cortex-M under QEMU
    limits      3 000 programs whose limits change while they run, and an operator
    nasty       4 000 nasty programs a slope, 1 000 of arcs on which the tick brakes
    clocked     1 000 programs, 2 000 rests and 4 000 nasty programs along clocked paths (they find
                some yet)
    rules       the planner without each of its numbers, on every family: what each buys
    monotony    50 programs of every family with more of a limit, a tolerance or a window
    scripts     24 000 random scripts of the front door, 100 000 programs; 20 000 sessions with
                wrong lines in them; 4 000 whose modes at the tool are known; 1 000 that wait for
                a spindle and for M66
    serve       in grbl's protocol 500 random streams, 20 000 jogs cancelled, 2 000 times noise,
                3 000 senders that mean no good, 5 000 with doors and holds at any moment
    senders     CNCjs and bCNC from their packages, in front of a served machine
    cycles      4 000 programs with cycles within a tolerance: limits of every axis
    threads     2 000 programs of each family with threads and taps; 20 000 spindles that fail
    comp        2 000 contours of each family under radius compensation, rs274 beside them
    rs274       15 000 random programs against rs274
    tongues     20 000 programs with a word of another language
    entering    the cases, the corpus and 50 programs of each family, begun at their lines
    linuxcnc    10 000 random calls beside LinuxCNC's own planner, 2 500 random scripts of other
                kinds in the stand-in, 20 operators and lathe programs in a live LinuxCNC
    imports     4 500 random configurations of other controls
    strangers   3 000 people with a machine, a program and a few commands, many of them wrong
"""

import argparse
import shlex
import subprocess
import sys
import time
from pathlib import Path

import sampling
from builds import build_c

ROOT = Path(__file__).resolve().parents[1]
PYTEST = "-m pytest -q -n logical --dist loadfile --no-loadscope-reorder --draw whole"
SLOPES = ("jerk", "linear")
PARTS = {
    "suite": [PYTEST],
    "fuzz": [f"{PYTEST} tests/house/test_fuzz.py --fuzz-factor 10"],
    "sanitizers": [f"{PYTEST} tests -k sanitized"],
    "quality": [f"{PYTEST} tests/house/test_quality.py"],
    "mutants": ["tests/house/mutate.py --count 100 --seed {seed}"],
    "nasty": [f"tests/kernel/nasty.py --slope {slope} --seed {{seed}} {words}"
              for slope in SLOPES
              for words in ("--count 4000", "--count 1000 --family held_arcs")],
    "stops": ["tests/stop_gate.py 20000 {seed}", "tests/linuxcnc/linuxcnc_stops.py 10000 {seed}",
              "tests/controller/firmware_stops.py 2000 {seed}"],
    "limits": ["tests/new_limits.py 3000 {seed}"],
    "clocked": ["tests/clocked.py 1000 {seed}", "tests/clocked.py stops 2000 {seed}",
                "tests/clocked.py offs 1000 {seed}",
                "tests/slope/test_lowered_feeds.py 2000 {seed}",
                "tests/kernel/nasty.py --slope optimal --count 4000 --seed {seed}"],
    "monotony": ["tests/slope/test_monotony.py 50 {seed}"],
    "rules": ["tests/slope/rules.py --seeds 3"],
    "scripts": ["build/gcc/tests_kernel test_script 24000 {seed}",
                "build/gcc/tests_kernel test_session 20000 {seed}",
                "build/gcc/tests_kernel test_stop 20000 {seed}",
                "build/gcc/tests_kernel test_executed 4000 {seed}",
                "build/gcc/tests_kernel test_await 1000 {seed}",
                "build/gcc/tests_kernel test_held 2000 {seed}"],
    "serve": ["build/gcc/tests_controller test_pulse 2000 {seed}",
              "build/gcc/tests_controller test_square 2000 {seed}",
              "build/gcc/tests_controller test_drive 1000 {seed}",
              "tests/controller/switching_runs.py homes 1000 {seed}",
              "tests/controller/switching_runs.py probes 1000 {seed}",
              "tests/controller/switching_runs.py limits 1000 {seed}",
              "tests/controller/switching_runs.py waits 1000 {seed}",
              "tests/controller/serving_runs.py streams 500 {seed}",
              "tests/controller/serving_runs.py jogs 1000 {seed}",
              "tests/controller/serving_runs.py bytes 2000 {seed}",
              "tests/controller/serving_runs.py modes 500 {seed}",
              "tests/controller/serving_runs.py resets 1000 {seed}",
              "tests/controller/serving_runs.py returns 1000 {seed}",
              "tests/controller/hostile_runs.py storms 3000 {seed}",
              "tests/controller/hostile_runs.py doors 5000 {seed}",
              "tests/controller/serving_runs.py brakes 1000 {seed}",
              "tests/controller/streaming.py surf_webgcode_46k.ngc jerk {seed}",
              "tests/controller/streaming.py surf_webgcode_46k.ngc optimal {seed}"],
    "senders": ["tests/controller/real_senders.py cncjs",
                "tests/controller/real_senders.py bcnc"],
    "cycles": ["tests/cycle_jerk.py --count 4000 --seed {seed}"],
    "threads": ["tests/thread_programs.py --count 2000 --seed {seed}",
                "build/gcc/tests_tick test_spindle 20000 {seed}"],
    "comp": ["tests/comp_gate.py --count 2000 --seed {seed} --rs274"],
    "rs274": ["tests/decode/against_rs274.py 15000 {seed}"],
    "tongues": ["tests/decode/tongues.py 20000 {seed}"],
    "entering": ["tests/decode/entering.py --lines 200",
                 "tests/decode/entering.py --family all --seeds {seed} +50"],
    "linuxcnc": ["tests/linuxcnc/linuxcnc_calls.py calls --count 10000 --seed {seed}",
                 "tests/linuxcnc/linuxcnc_calls.py stops feeds threads late reverses "
                 "--count 500 --seed {seed}",
                 "tests/linuxcnc/lathe_live.py", "tests/linuxcnc/operators.py {seed} 20"],
    "imports": ["tests/machine/configurations.py 1500 {seed}"],
    "strangers": ["tests/cli/strangers.py 3000 {seed}"],
}  # fmt: skip


def command_of(words, seed):
    """Return a command of a part: a C test, which is built for it, or one of Python."""
    command = shlex.split(words.format(seed=seed))
    if not command[0].startswith("build/"):
        return [".venv/bin/python", *command]
    complaints = build_c("gcc", Path(command[0]).name)[1]
    if complaints:
        raise SystemExit(complaints)
    return command


def run(name, seed):
    """Run a part; return (whether it found nothing, seconds)."""
    began, good = time.monotonic(), True
    for words in PARTS[name]:
        command = command_of(words, seed)
        print(f"\n=== {name}: {shlex.join(command)}", flush=True)
        good &= subprocess.run(command, cwd=ROOT).returncode == 0
    return good, time.monotonic() - began


def main():
    """Run the parts that are asked for; print a table of them."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("what", nargs="*", metavar="WHAT", help="parts; all without any")
    parser.add_argument("--seed", type=int, help="another seed than the commit's")
    given = parser.parse_args()
    unknown = [name for name in given.what if name not in PARTS]
    if unknown:
        parser.error(f"no part {' '.join(unknown)}; there are {' '.join(PARTS)}")
    seed = sampling.seed_of_commit() % 1_000_000 if given.seed is None else given.seed
    rows = [(name, *run(name, seed)) for name in given.what or PARTS]
    print(f"\nseed {seed}")
    for name, good, seconds in rows:
        print(f"{name:12}{'nothing found' if good else 'FOUND SOMETHING':18}{seconds:8.0f} s")
    return sum(not good for _, good, _ in rows)


if __name__ == "__main__":
    sys.exit(main())
