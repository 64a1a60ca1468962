# SPDX-License-Identifier: MIT
"""The pages: what stands in them runs, what they say of JSON holds, and the site is built."""

import ast
import importlib.util
import json
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from pycnc.machine import Machine
from cases import FAMILIES, ROOT
from command_line import pycnc
from pydantic import TypeAdapter

DOCS = ROOT / "docs"
EXAMPLE = ROOT / "pycnc" / "examples" / "first_part.ngc"
GRBL = "".join(f"${k}={v}.000\n" for k, v in {100: 250, 110: 5000, 111: 5000, 112: 2000, 120: 500,
                                                121: 500, 122: 200}.items())  # fmt: skip
TEXT = "G21 G90 G17\nT1 M6\nS900 M3\nG1 X10 F600\nG3 X20 Y10 I0 J10\nG4 P0.1\nG0 X0\nY5\nM2\n"


def module_of(name):
    spec = importlib.util.spec_from_file_location(name, DOCS / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


models = module_of("json_models")


def blocks(page, language):
    return re.findall(rf"```{language}\n(.*?)```", (DOCS / page).read_text(encoding="utf-8"), re.S)


@pytest.fixture
def workshop(tmp_path, monkeypatch):
    """Return a folder with part.ngc, where the test is."""
    monkeypatch.chdir(tmp_path)
    shutil.copy(EXAMPLE, "part.ngc")
    (tmp_path / "grbl.txt").write_text(GRBL)
    return tmp_path


# What stands there runs


@pytest.mark.thorough
def test_the_commands_of_the_five_minutes_work(workshop):
    lines = [line for block in blocks("my_machine.md", "sh") for line in block.splitlines()]
    assert len(lines) >= 10
    for line in lines:
        words = shlex.split(line)
        if words[0] != "pycnc":
            continue  # the program is there
        result = pycnc(*words[1:])
        assert (result.code, "error[" in result.err) == (0, False), f"{line}: {result.err}"
    assert Path("part.html").stat().st_size > 500_000
    times, approach, inputs = blocks("my_machine.md", "toml")
    assert approach.startswith("[approach]")
    text = Path("mymill.toml").read_text(encoding="utf-8")
    assert Machine.from_text(f"{text}\n{inputs}").switches is not None
    settings = [f"times.{line.replace(' ', '')}" for line in times.splitlines()[1:]]
    set_them = [word for each in settings for word in ("--set", each)]
    assert "tool changes 16.00 s" in pycnc("time", "part.ngc", *set_them).out


@pytest.mark.thorough
def test_the_code_of_the_python_page_runs(workshop, capsys):
    code = "\n".join(blocks("python.md", "python"))
    exec(compile(code, "docs/python.md", "exec"), {})
    assert len(capsys.readouterr().out.splitlines()) >= 7


@pytest.mark.thorough
def test_the_notebook_runs_and_every_result_shows_itself(workshop):
    cells = json.loads((DOCS / "first_part.ipynb").read_text(encoding="utf-8"))["cells"]
    names, shown = {}, 0
    for cell in cells:
        assert cell.get("outputs", []) == []
        if cell["cell_type"] != "code":
            continue
        tree = ast.parse("".join(cell["source"]))
        *before, last = tree.body
        exec(compile(ast.Module(before, []), "notebook", "exec"), names)
        result = eval(compile(ast.Expression(last.value), "notebook", "eval"), names)
        how = [name for name in ("_repr_html_", "_repr_png_", "to_frame") if hasattr(result, name)]
        shown += bool(how) or type(result).__name__ == "Figure"
    assert shown == sum(cell["cell_type"] == "code" for cell in cells)


# What it says of JSON


@pytest.mark.sample(quick=4)
@pytest.mark.parametrize("arguments", [[], ["--slope", "linear"], ["--set", "path.tolerance_mm=0"]])
@pytest.mark.parametrize("verb", ["time", "run", "why", "report"])
def test_a_verb_tells_what_the_schema_says(verb, arguments, tmp_path):
    more = ["-o", tmp_path / "x.html"] if verb == "report" else []
    result = pycnc(verb, "-", "--json", *arguments, *more, stdin=TEXT.encode())
    told = TypeAdapter(models.MODELS[verb]).validate_json(result.out)
    assert told.time_s == json.loads(result.out)["time_s"] > 0


def test_parts_cures_and_findings_are_as_the_schema_says():
    for by in ("tool", "section", "line"):
        told = json.loads(pycnc("time", "-", "--json", "--by", by, stdin=TEXT.encode()).out)
        assert models.Time.model_validate(told).parts
    make, count = FAMILIES[next(iter(FAMILIES))]
    import numpy as np

    text = make(np.random.default_rng(1), count // 8).encode()
    found = models.Why.model_validate_json(pycnc("why", "-", "--json", "--what-if", stdin=text).out)
    assert found.what_if and found.causes
    wrong = pycnc("time", "-", "--json", stdin=b"G1 X10 Q\n").out
    assert models.Program.model_validate_json(wrong).diagnostics[0].severity in ("error", "note")
    findings = pycnc("check", "-", "--json", stdin=b"G1 X10 Q\n").out
    TypeAdapter(list[models.Diagnostic]).validate_json(findings)


@pytest.mark.thorough
def test_a_sweep_and_a_comparison_are_as_the_schema_says(workshop):
    out = pycnc("sweep", "part.ngc", "--set", "path.slope=jerk,linear", "--json").out
    assert len(models.Sweep.model_validate_json(out).rows) == 2
    out = pycnc("compare", "part.ngc", "part.ngc", "--set-b", "path.slope=linear", "--json").out
    assert models.Compare.model_validate_json(out).time_difference_s < 0


def test_what_is_not_in_the_schema_is_noticed():
    told = json.loads(pycnc("time", "-", "--json", stdin=TEXT.encode()).out)
    for change in ({"strange": 1}, {"time_s": "1"}, {"slope": "steep"}):
        with pytest.raises(ValueError, match=next(iter(change))):
            models.Time.model_validate(told | change)


# The site


def test_a_reader_has_eight_pages_and_every_page_has_a_shelf():
    shelves = module_of("make_site").SECTIONS
    assert list(shelves) == ["User", "Reference", "Lab"] and len(shelves["User"]) <= 8
    pages = [page for shelf in shelves.values() for page in shelf if page.startswith("docs/")]
    assert sorted(pages) == sorted(f"docs/{path.stem}" for path in DOCS.glob("*.md"))


@pytest.mark.seldom(4, "docs", "README.md", "pycnc", "csrc/nck/nck.h")
def test_the_site_is_built_without_a_warning(tool):
    pytest.importorskip("sphinx")
    tool("doxygen")
    command = [sys.executable, DOCS / "make_site.py"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    site = Path(done.stdout.strip()).parent
    for page, words in (
        ("README.html", "numerical control kernel"), ("docs/commands.html", "pycnc sweep"),
        ("docs/report.html", "figures/report.png"), ("api_python.html", "pycnc.load"),
        ("api_c.html", "nck_prep"), ("docs/json.html", "limit_time_s"),
    ):  # fmt: skip
        text = (site / page).read_text(encoding="utf-8")
        assert words in text or words.replace("figures", "_images").split("/")[-1] in text, page
    assert "Do one bounded piece of work" in (site / "api_c.html").read_text(encoding="utf-8")
