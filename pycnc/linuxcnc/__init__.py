# SPDX-License-Identifier: MIT
"""The kernel as LinuxCNC's trajectory planner: its module, and what an INI file lacks for it.

docs/linuxcnc.md tells a machine's owner what to do with it.
"""

import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from pycnc import errors

PARTS = Path("/usr/share/linuxcnc/Makefile.modinc")  # of the package linuxcnc-uspace-dev
MODULES = Path("/usr/lib/linuxcnc/modules")
MODULE = "nck_tp.so"


def adapter():
    """Return the folder of the adapter's sources: of the source tree, or of the package."""
    here = Path(__file__).resolve()
    tree, package = here.parents[2] / "adapters/linuxcnc", here.parents[1] / "adapters/linuxcnc"
    return package if package.is_dir() else tree


def _lay_out(folder):
    """Put the sources into a folder, the kernel as a pair of files among them."""
    sources = adapter()
    folder.mkdir(parents=True, exist_ok=True)
    for path in [*sources.glob("*.[ch]"), sources / "Makefile"]:
        shutil.copyfile(path, folder / path.name)
    pair = sources / "nck"
    if pair.is_dir():
        shutil.copytree(pair, folder / "nck", dirs_exist_ok=True)
        return
    generator = sources.parents[1] / "cmake" / "amalgamate.py"
    subprocess.run([sys.executable, generator, "--out", folder / "nck"], check=True)


def build(folder, headers=None, *, short_servo=False):
    """Compile the planner module for the LinuxCNC of this computer.

    Parameters
    ----------
    folder : path
        Where to; it is made if it is not there. The sources stay in it.
    headers : path, optional
        Of the LinuxCNC that is to load it, where they are not the installed ones.
    short_servo : bool
        For a servo period of less than 1 ms: a longer window of speeds, in shorter steps.

    Returns
    -------
    pathlib.Path
        The module, nck_tp.so.

    Raises
    ------
    AbsentError
        If LinuxCNC's headers or a C compiler are not installed.
    InternalError
        If the compiler refuses the sources.
    """
    folder = Path(folder).resolve()
    if not PARTS.is_file():
        raise errors.AbsentError(
            f"{PARTS} is not there: apt-get install linuxcnc-uspace-dev", id="linuxcnc-absent"
        )
    for tool in ("make", "gcc"):
        if not shutil.which(tool):
            raise errors.AbsentError(
                f"{tool} is not there: apt-get install build-essential", id="linuxcnc-absent"
            )
    _lay_out(folder)
    others = [f"HEADERS={Path(headers).resolve()}"] if headers else []
    others += ["SHORT_SERVO=1"] if short_servo else []
    done = subprocess.run(["make", "-s", "-C", folder, *others], capture_output=True, text=True)
    if done.returncode or not (folder / MODULE).is_file():
        raise errors.InternalError(f"{done.stderr.strip()}\nthe module does not compile")
    return folder / MODULE


def install(module, modules=MODULES):
    """Copy a module to where LinuxCNC looks for it.

    Parameters
    ----------
    module : path
    modules : path
        LinuxCNC's folder of modules.

    Returns
    -------
    pathlib.Path
        The file that LinuxCNC will load.

    Raises
    ------
    AbsentError
        If there is no such module or folder, or it may not be written.
    """
    place = Path(modules) / MODULE
    beside = place.with_suffix(".new")
    if not Path(module).is_file():
        words = f"{module} is not there: pycnc linuxcnc build {Path(module).parent}"
        raise errors.AbsentError(words, id="module")
    if not place.parent.is_dir():
        words = f"{place.parent} is not there: apt-get install linuxcnc-uspace"
        raise errors.AbsentError(words, id="linuxcnc-absent")
    try:
        shutil.copyfile(module, beside)  # a running LinuxCNC keeps the file that it has loaded
        os.replace(beside, place)
    except PermissionError:
        raise errors.AbsentError(
            f"{place.parent} may not be written; as root it may:\n"
            f"    sudo install -m 644 {shlex.quote(str(Path(module).resolve()))} {place}",
            id="not-written",
        ) from None
    return place
