# SPDX-License-Identifier: MIT
"""What a newcomer meets first: version, help, examples, completion, types, plain remedies."""

import ast
import inspect
import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import pycnc

import pycnc as package
from pycnc import kernel, stages
from pycnc.cli import app, options
from pycnc.cli.door import lab, machines
from pycnc.controller import CONTROLLERS
from pycnc.machine import shipped
from pycnc.planning.plan import BACKENDS, SLOPES

ROOT = Path(__file__).resolve().parents[2]
PART = b"G21 G90 G17\nG1 X10 F600\nY5\nM2\n"
KLIPPER = "[printer]\nmax_velocity: 300\nmax_accel: 3000\n[stepper_x]\nposition_max: 200\n"
# What takes longer to load than a small program to plan, and what only some verbs use.
HEAVY = ("matplotlib", "pandas", "pycnc.device", "pycnc.planning.grades", "pycnc.controller",
         "multiprocessing")
COMMANDS = {
    tuple(name.split()): command
    for group, before in ((app, ""), (machines, "machine "), (lab, "lab "))
    for command in group.registered_commands
    for name in [before + command.name]
}


def interpreter(*arguments, **environment):
    return subprocess.run(
        [sys.executable, *arguments], capture_output=True, text=True, timeout=120,
        env={**os.environ, **environment},
    )  # fmt: skip


def test_the_version_is_told_everywhere_and_is_the_same():
    assert package.__version__ == kernel.version()
    assert pycnc("--version").out == f"pycnc {kernel.version()}\n"
    done = interpreter("-m", "pycnc", "--version")
    assert (done.returncode, done.stdout) == (0, f"pycnc {kernel.version()}\n")


@pytest.mark.parametrize(
    ("arguments", "unused"),
    [
        (("--version",), {*HEAVY, "numpy", "pycnc.kernel", "pycnc.machine"}),
        (("check", "part.ngc"), {*HEAVY, "pycnc.planning.plan"}),
        (("time", "part.ngc"), {*HEAVY, "pycnc.planning.why"}),
    ],
    ids=lambda value: value[0] if isinstance(value, tuple) else "",
)
def test_a_small_verb_loads_nothing_that_it_does_not_use(arguments, unused, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_bytes(PART)
    done = interpreter("-X", "importtime", "-m", "pycnc", *arguments)
    loaded = {line.rpartition("|")[2].strip() for line in done.stderr.splitlines()}
    assert (done.returncode, "pycnc.cli" in loaded) == (0, True)
    assert loaded & unused == set()


@pytest.mark.sample(quick=5)
@pytest.mark.parametrize("verb", COMMANDS, ids=" ".join)
def test_the_example_of_a_verb_works_as_it_is_written(verb, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("part.ngc", "other.ngc"):
        Path(name).write_bytes(PART)
    Path("printer.cfg").write_text(KLIPPER)
    shown = pycnc(*verb, "--help").out
    example = " ".join(shown.split("Example: pycnc ")[1].split())
    assert tuple(shlex.split(example)[: len(verb)]) == verb
    if verb == ("lab", "bench"):
        example = "lab bench"  # the list of subjects: a bench takes its time
    if verb in (("lab", "controller"), ("serve",)):
        return  # tests/controller builds and runs the one, and talks to the other until Ctrl-C
    result = pycnc(*shlex.split(example))
    assert (result.code, result.err.count("error[")) == (0, 0)
    assert result.out


@pytest.mark.parametrize(
    ("choices", "names"),
    [
        (options.Slope, SLOPES),
        (options.PlanKind, BACKENDS),
        (options.BackendName, {name for names in BACKENDS.values() for name in names}),
        (options.Controller, CONTROLLERS),
    ],
)
def test_help_lists_what_an_option_takes(choices, names):
    assert sorted(choices) == sorted(names)
    shown = pycnc("lab", "run", "--help").out + pycnc("lab", "controller", "--help").out
    assert f"<{'|'.join(choices)}>" in shown


def test_verbose_stands_only_where_more_is_told():
    has = [verb for verb in COMMANDS if "--verbose" in pycnc(*verb, "--help").out]
    assert has == [("check",), ("run",), ("lab", "run")]
    assert "note[" in pycnc("run", "-v", "-", stdin=b"G1 X1 F100\n").err
    assert "note[" not in pycnc("run", "-", stdin=b"G1 X1 F100\n").err


@pytest.mark.parametrize("verb", ["time", "run", "plot"])
def test_what_is_the_labs_stands_there_alone(verb):
    for option in ("--plan=grades", "--backend=c", "--prep-steps=9"):
        refused = pycnc(verb, "-", option, stdin=PART)
        assert refused.code == 2 and "No such option" in refused.err
    assert pycnc("canon", "-", stdin=PART).code == 2
    own = {words[1] for words in COMMANDS if words[0] == "lab"}
    assert own == {"bench", "canon", "controller", "run", "time"}


def test_slope_is_short_for_its_setting():
    short = pycnc("time", "-", "--slope", "linear", stdin=PART).out
    assert short == pycnc("time", "-", "--set", "path.slope=linear", stdin=PART).out
    assert "slope linear" in short


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_a_shell_completes_verbs_machines_and_settings(shell):
    assert "_PYCNC_COMPLETE" in completing(f"source_{shell}")
    typed = {"COMP_CWORD": "3", "COMP_WORDS": "pycnc time -m c"}
    machines = [name for name in shipped() if name.startswith("c")]
    assert completing("complete_bash", **typed).split() == machines
    typed["COMP_WORDS"] = "pycnc part.ngc -m c"
    assert completing("complete_bash", **typed).split() == machines
    typed["COMP_WORDS"] = "pycnc time --set path.s"
    assert completing("complete_bash", **typed).split() == ["path.slope="]


def completing(step, **environment):
    """Return what the installed command tells a shell that completes it."""
    command = Path(sys.executable).with_name("pycnc")
    environment = {**os.environ, "_PYCNC_COMPLETE": step, **environment}
    return subprocess.run([command], capture_output=True, text=True, env=environment).stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--set", "axis.x.j_max_mm_s3=5e4", "--slope", "linear"], "limits jerk"),
        (["--set", "path.j_max_mm_s3=5e4", "--set", "path.slope=linear"], "does not limit it"),
        (["--set", "path.slope=linear", "--slope", "optimal"], "path.slope=optimal comes behind"),
        (["--set", "dialect.system=B"], "only dialect.base=fanuc"),
        (["--set", "description=mine"], "only lists"),
        (["--set", "path.tolerance_mm=0.1", "--plan", "grades"], "grades are planned under"),
        (["--set", "path.slope=linear", "--plan", "sshape"], "the S-shape is planned under"),
        (["--set", "axis.x.j_max_mm_s3=5e4"], ""),
        (["--set", "path.slope=jerk"], ""),
    ],
)
def test_a_setting_without_effect_is_a_warning(arguments, words):
    result = pycnc("lab", "time", "-", *arguments, stdin=PART)
    told = [line for line in result.err.splitlines() if "no-effect" in line]
    assert result.code == 0
    assert len(told) == bool(words)
    if words and words != "limits jerk":
        assert words in told[0]
    quiet = pycnc("lab", "time", "-q", "-", *arguments, stdin=PART)
    assert (quiet.code, quiet.err) == (0, "")


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("a.cfg", "[stepper_x]\nstep_pin: PF0\n[printer]\nmax_accel: 9\n", "axis.x: no v_max"),
        ("mill.ini", "[EMC]\nVERSION = 1.1\nMACHINE = my mill\n", "LINEAR_UNITS"),
        ("grbl.txt", "$100=250.000\n$110=500.000\n", "axis.x: no a_max"),
        ("config.yaml", "axes:\n  x:\n    max_travel_mm: -5\n", "axis.x"),
        ("mine.toml", "[path\n", "is not valid TOML"),
    ],
)
def test_a_configuration_that_does_not_say_all_is_told_by_what_is_missing(
    name, text, words, tmp_path
):
    file = tmp_path / name
    file.write_text(text)
    result = pycnc("time", "-", "-m", file, stdin=PART)
    assert result.code == 2
    assert f"{file}: error[machine]: " in result.err
    assert words in result.err
    assert ("pycnc machine import" in result.err) == (name == "mill.ini")


# Types


@pytest.mark.thorough
def test_a_strictly_typed_script_is_clean(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(
        "import pycnc\n"
        "from pycnc import Machine, Plan, Program, ProgramError\n\n\n"
        "def seconds(text: str) -> float:\n"
        '    machine = Machine.load("mill3", set={"path.slope": "jerk"})\n'
        "    program: Program = pycnc.load(text, machine=machine)\n"
        "    plan: Plan = pycnc.plan(program)\n"
        '    trace = pycnc.run(program, commands=[(400, "hold"), (500, "resume")])\n'
        "    profile = pycnc.stages.slope([4.0], 10.0, 2.0, None, [0.0, 0.0])\n"
        '    print(pycnc.__version__, program.bounds["x"][1], trace["t_s"][-1])\n'
        "    return plan.time_s + profile.time_s\n\n\n"
        "try:\n"
        '    print(seconds("G21 G90 G1 X10 F600\\nM2\\n"))\n'
        "except ProgramError as error:\n"
        "    print(error.id, error.line)\n"
    )
    command = ["-m", "mypy", "--strict", "--cache-dir", tmp_path / "cache", script]
    done = interpreter(*command)
    assert done.returncode == 0, done.stdout + done.stderr
    wrong = script.read_text().replace("slope([4.0]", 'slope("four"').replace("(text, m", "(5, m")
    script.write_text(wrong)
    assert interpreter(*command).stdout.count("error:") >= 1


def stub_of(name):
    """Return {name: ast node} of what a stub defines."""
    tree = ast.parse((ROOT / "pycnc" / name).read_text(encoding="utf-8"))
    kinds = (ast.FunctionDef, ast.ClassDef)
    return {node.name: node for node in tree.body if isinstance(node, kinds)}


@pytest.mark.parametrize(("name", "room"), [("__init__.pyi", package), ("stages.pyi", stages)])
def test_the_types_are_those_of_the_code(name, room):
    stub, hidden = stub_of(name), {"Diagnostic", "Diagnostics", "JerkPlanner", "Tables"}
    errors = {each for each in package.__all__ if each.endswith("Error") and each not in stub}
    promised = set(room.__all__) - {"stages", "__version__"} - errors
    assert promised - hidden == set(stub) - hidden
    for function, node in functions(stub, room):
        given = [each.arg for each in node.args.posonlyargs + node.args.args + node.args.kwonlyargs]
        assert given == list(inspect.signature(function).parameters), node.name


def functions(stub, room):
    """Yield (function of the code, its stub) of all functions and methods of a stub."""
    for name, node in stub.items():
        if isinstance(node, ast.FunctionDef):
            yield getattr(room, name), node
        for method in getattr(node, "body", ()) if isinstance(node, ast.ClassDef) else ():
            if isinstance(method, ast.FunctionDef) and hasattr(room, name):
                attribute = inspect.getattr_static(getattr(room, name), method.name)
                if isinstance(attribute, property):
                    attribute = attribute.fget
                yield getattr(attribute, "__func__", attribute), method
