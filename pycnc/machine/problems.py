# SPDX-License-Identifier: MIT
"""What is wrong with a machine file, all of it at once."""

from pycnc import errors
from pycnc.kernel.bind import lib


class MachineFileError(errors.MachineError):
    """A machine file has errors, all of them told at once.

    Attributes
    ----------
    file : str
        The file.
    problems : list of (str, str)
        Path to the key (``axis.x.v_max_mm_s``, empty for the whole file) and what is wrong.
    places : list of str
        Of every problem: the file, or the option that made it.
    """

    def __init__(self, file, problems, changes=(), own=()):
        self.file, self.problems = file, problems
        self.places = [
            str(file) if problem in own else _place(file, problem[0], changes)
            for problem in problems
        ]
        lines = (
            f"{place}: error[machine]: {key + ': ' if key else ''}{message}"
            for place, (key, message) in zip(self.places, problems, strict=True)
        )
        super().__init__("\n".join(lines), id="machine", status=lib.NCK_E_MACHINE)


def _place(file, key, changes):
    """Return what a problem of a key is to be blamed on: the change of the key or of one in its
    table, else the file, with the changes that were made to it.

    changes: (path to key, value, source), as they were made.
    """
    for changed, value, source in changes:
        if changed == key or changed.startswith(f"{key}."):
            return f"--set {changed}={value}" if source == "--set" else source
    made = ", ".join(f"{name}={value}" for name, value, source in changes if source == "--set")
    return f"{file} with --set {made}" if made else file
