# SPDX-License-Identifier: MIT
"""A Debian package of the planner module, for machines that are looked after by apt."""

import gzip
import re
import shutil
import subprocess
from pathlib import Path

from pycnc import errors, names
from pycnc.linuxcnc import MODULE, MODULES, adapter

NAME = "nck-tp"
HOST = "linuxcnc-uspace"

CONTROL = """Package: {name}
Version: {version}
Architecture: {architecture}
Maintainer: pycnc <pycnc@localhost>
Section: science
Priority: optional
Depends: {host} (>= {series}~), {host} (<< {next}~), libc6
Installed-Size: {kilobytes}
Description: jerk-limited trajectory planner for LinuxCNC
 The module nck_tp, which LinuxCNC loads in place of its own planner where
 the INI file of a machine says [TRAJ] TPMOD = nck_tp. Without that line
 nothing changes.
"""

COPYRIGHT = """Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: pycnc

Files: *
Copyright: the authors of pycnc
License: GPL-2.0-or-later
 nck_tp.c includes LinuxCNC's headers, so the module as a whole is under the
 GNU General Public License, version 2 or later: see
 /usr/share/common-licenses/GPL-2. All other sources are under the MIT licence.
"""


def _told(*call):
    """Return what a program of Debian's says."""
    if not shutil.which(call[0]):
        raise errors.AbsentError(f"{call[0]} is not there: it is Debian's", id="linuxcnc-absent")
    done = subprocess.run(call, capture_output=True, text=True)
    if done.returncode:
        raise errors.StateError(f"{' '.join(call)}: {done.stderr.strip()}", id="package")
    return done.stdout.strip()


def series_of(version):
    """Return (series, next series) of a version of LinuxCNC: what a planner module was built for.

    Its calls are the same within one series, as 2.9 or 2.10.
    """
    found = re.match(r"(?:\d+:)?(\d+)\.(\d+)", version)
    if not found:
        raise errors.StateError(f"{HOST} has a version that is none: {version}", id="package")
    major, minor = int(found[1]), int(found[2])
    return f"{major}.{minor}", f"{major}.{minor + 1}"


def _lay_out(root, module):
    """Put what is to be installed under a root; return its size [kB]."""
    place = root / Path(*MODULES.parts[1:])
    shared = root / "usr/share"
    for folder in (place, shared / "man/man9", shared / "doc" / NAME, root / "DEBIAN"):
        folder.mkdir(parents=True)
    shutil.copyfile(module, place / MODULE)
    (shared / "doc" / NAME / "copyright").write_text(COPYRIGHT, encoding="utf-8")
    page = (adapter() / "nck_tp.9").read_bytes()
    (shared / "man/man9/nck_tp.9.gz").write_bytes(gzip.compress(page, mtime=0))
    for path in root.rglob("*"):
        path.chmod(0o755 if path.is_dir() else 0o644)
    return sum(path.stat().st_size for path in root.rglob("*") if path.is_file()) // 1024 + 1


def pack(folder, to="."):
    """Make a Debian package of the module that was built in a folder.

    Parameters
    ----------
    folder : path
        Where `pycnc.linuxcnc.build` has put the module.
    to : path
        A folder for the package.

    Returns
    -------
    pathlib.Path
        The package; it is not signed.

    Raises
    ------
    AbsentError
        If there is no module, or dpkg is not installed.
    StateError
        If LinuxCNC is not installed as a package.
    """
    module = Path(folder) / MODULE
    if not module.is_file():
        words = f"{module} is not there: pycnc linuxcnc build {folder}"
        raise errors.AbsentError(words, id="module")
    series, following = series_of(_told("dpkg-query", "-W", "-f", "${Version}", HOST))
    architecture = _told("dpkg", "--print-architecture")
    root = Path(folder) / "package"
    shutil.rmtree(root, ignore_errors=True)
    control = CONTROL.format(
        name=NAME, version=names.version(), architecture=architecture, host=HOST, series=series,
        next=following, kilobytes=_lay_out(root, module),
    )  # fmt: skip
    (root / "DEBIAN/control").write_text(control, encoding="utf-8")
    made = Path(to) / f"{NAME}_{names.version()}_{architecture}.deb"
    _told("dpkg-deb", "--root-owner-group", "--build", str(root), str(made))
    return made
