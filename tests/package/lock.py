# SPDX-License-Identifier: MIT
"""Write the hashes of all files that a locked package may come as into requirements*.lock.

    .venv/bin/python tests/package/lock.py        # after a version was changed there

The packages are looked up where pip would: its own code asks, with its own settings. Files for
interpreters that the project does not take are left out.
"""

import itertools
import re
from pathlib import Path

from pip._internal.commands import create_command
from pip._internal.index.collector import parse_links
from pip._vendor.packaging.utils import parse_sdist_filename, parse_wheel_filename
from pip._vendor.packaging.version import Version

ROOT = Path(__file__).resolve().parents[2]
LOCKS = ("requirements.lock", "requirements-test.lock")
PINNED = re.compile(r"^([\w.-]+)==([^\s\\]+)")
OLDEST = (3, 11)  # Python, as in pyproject.toml
ELSEWHERE = re.compile(r"ios|android|emscripten|wasm|pyodide")  # where no libnck module is built


def suits(tag):
    """Return whether one tag of a wheel is for an interpreter and a system that we take."""
    if ELSEWHERE.search(tag.platform) or tag.abi.endswith("t"):
        return False
    found = re.fullmatch(r"(cp|py)(\d)(\d*)", tag.interpreter)
    if not found or found[2] != "3":
        return False
    return found[1] == "py" or tag.abi == "abi3" or (3, int(found[3] or 0)) >= OLDEST


def is_wanted(name, version):
    """Return whether a file is of this version, as source or for one of our interpreters."""
    try:
        if not name.endswith(".whl"):
            return parse_sdist_filename(name)[1] == version
        _, found, _, tags = parse_wheel_filename(name)
    except ValueError:  # a name of another age
        return False
    return found == version and any(map(suits, tags))


def hashes(finder, name, version):
    """Return the SHA-256 of the files of a version, in order."""
    collector = finder._link_collector
    sources = collector.collect_sources(name, candidates_from_page=lambda link: [])
    pages = [source.link for source in itertools.chain(*sources) if source and source.link]
    answers = [answer for page in pages if (answer := collector.fetch_response(page))]
    links = [link for answer in answers for link in parse_links(answer)]
    wanted = [link for link in links if is_wanted(link.filename, Version(version))]
    return sorted({link.hash for link in wanted if link.hash_name == "sha256"})


def locked(text, finder):
    """Return the text of a lock with the hashes of today."""
    lines = []
    for line in text.splitlines():
        if line.lstrip().startswith("--hash"):
            continue
        lines.append(line.rstrip("\\ "))
        if pin := PINNED.match(line):
            found = hashes(finder, *pin.groups())
            if not found:
                raise SystemExit(f"{line}: nobody has it")
            lines[-1] = " \\\n".join([lines[-1], *(f"    --hash=sha256:{each}" for each in found)])
    return "\n".join(lines) + "\n"


def main():
    """Renew the hashes of both locks."""
    command = create_command("download")
    options, _ = command.parse_args(["--quiet", "nothing"])
    with command.main_context():
        session = command.get_default_session(options)
        finder = command._build_package_finder(options, session)
        for name in LOCKS:
            path = ROOT / name
            path.write_text(locked(path.read_text(encoding="utf-8"), finder), encoding="utf-8")


if __name__ == "__main__":
    main()
