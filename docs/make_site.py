# SPDX-License-Identifier: MIT
"""Make the site in build/site: all pages, the Python front door and the C headers.

python docs/make_site.py

It takes Sphinx with MyST and breathe (the extra ``docs``) and Doxygen. A warning is an error.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCE, XML, SITE = (ROOT / "build" / name for name in ("site-source", "site-xml", "site"))
COPIED = ("*.md", "*.png", "csrc/*.h", "firmware_sim/*.h", "cmake/*.cmake", "docs/site/*.py")
HEADERS = ("nck/nck.h", "nck/nck_session.h", "nck/nck_tools.h", "nck/base/machine.h",
           "nck/base/records.h", "nck/base/status.h", "nck/base/limits.h", "host/host.h",
           "host/why.h", "host/trail.h")  # fmt: skip
SECTIONS = {
    "User": ("README", "docs/my_machine", "docs/why", "docs/report", "docs/journeys", "docs/lathe",
             "docs/firmware", "docs/python"),
    "Reference": ("docs/commands", "docs/machine", "docs/diagnostics", "docs/json", "docs/trace",
                  "docs/words", "docs/cycles", "docs/shops", "docs/controls", "docs/controller",
                  "docs/serve", "docs/linuxcnc", "docs/moving", "docs/size", "docs/glossary",
                  "api_python", "api_c"),
    "Lab": ("docs/planner", "docs/stops", "docs/grades", "docs/parallel",
            "docs/opencl", "docs/papers"),
}  # fmt: skip
# Doxygen takes comments of three slashes: the house writes two.
FILTER = r"sed -e 's,^\( *\)// ,\1/// ,' -e 's,\([;{},] *\)// ,\1///< ,'"
DOXYGEN = """\
QUIET = YES
INPUT = {input}
OUTPUT_DIRECTORY = {xml}
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
OPTIMIZE_OUTPUT_FOR_C = YES
EXTRACT_ALL = YES
FULL_PATH_NAMES = YES
STRIP_FROM_PATH = {root}/csrc
MARKDOWN_SUPPORT = NO
AUTOLINK_SUPPORT = NO
MACRO_EXPANSION = YES
PREDEFINED = __cplusplus=0 NCK_THREAD_STATE=struct "NCK_SIZED(name):=name"
INPUT_FILTER = "{filter}"
WARN_IF_UNDOCUMENTED = NO
WARN_IF_DOC_ERROR = NO
"""


def stage():
    """Copy what the site is made of, each file where it lies in the project."""
    shutil.rmtree(SOURCE, ignore_errors=True)
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "--", *COPIED]
    found = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    for name in found.stdout.splitlines():
        (SOURCE / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, SOURCE / name)
    shutil.copyfile(SOURCE / "docs/site/conf.py", SOURCE / "conf.py")
    for name, page in (("index", index), ("api_python", python_page), ("api_c", c_page)):
        (SOURCE / f"{name}.md").write_text(page(), encoding="utf-8")


def tree(title, names):
    """Return a toctree in MyST."""
    return "\n".join(["```{toctree}", f":caption: {title}", ":maxdepth: 1", "", *names, "```", ""])


def index():
    """Return the first page: every page of the project is in one of its lists."""
    pages = {str(path.relative_to(SOURCE).with_suffix("")) for path in SOURCE.rglob("*.md")}
    listed = {name for names in SECTIONS.values() for name in names}
    rest = sorted(pages - listed - {"index", "CHANGELOG"})
    text = ["# pycnc", "", "A numerical control kernel: NC text in, axis setpoints out.", ""]
    text += [tree(title, names) for title, names in SECTIONS.items()]
    text += [tree("Inside", [*rest, "CHANGELOG"])]
    return "\n".join(text)


def python_page():
    """Return the page of the front door, from its docstrings."""
    import pycnc

    names = [name for name in pycnc.__all__ if name not in ("__version__", "stages")]
    parts = ["# Python, name by name", ""]
    for name in sorted(names, key=str.lower):
        kind = "autoclass" if isinstance(getattr(pycnc, name), type) else "autofunction"
        options = [":members:", ":inherited-members: Exception, object"] * (kind == "autoclass")
        parts += [f"## {name}", "", "```{eval-rst}", f".. {kind}:: pycnc.{name}"]
        parts += [f"   {option}" for option in options] + ["```", ""]
    return "\n".join(parts)


def c_page():
    """Return the page of the C headers."""
    parts = ["# C, header by header", ""]
    for name in HEADERS:
        parts += [f"## {name}", "", "```{eval-rst}", f".. doxygenfile:: {Path(name).name}", "```",
                  ""]
    return "\n".join(parts)


def read_headers():
    """Let Doxygen read the headers."""
    shutil.rmtree(XML, ignore_errors=True)
    XML.mkdir(parents=True)
    inputs = " ".join(str(ROOT / "csrc" / name) for name in HEADERS)
    settings = DOXYGEN.format(input=inputs, xml=XML, root=ROOT, filter=FILTER)
    subprocess.run(["doxygen", "-"], input=settings, text=True, check=True)


def main():
    """Make the site."""
    stage()
    read_headers()
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html"]
    environment = {**os.environ, "PYCNC_DOXYGEN": str(XML / "xml")}
    done = subprocess.run([*command, SOURCE, SITE], env=environment)
    if done.returncode == 0:
        print(SITE / "index.html")
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
