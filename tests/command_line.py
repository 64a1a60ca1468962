# SPDX-License-Identifier: MIT
"""Run the command line inside the test's process: exit code, stdout, stderr."""

import contextlib
import io
import sys
from typing import NamedTuple
from unittest import mock

from pycnc.cli import app


class Result(NamedTuple):
    """What a call said."""

    code: int
    out: str
    err: str


def pycnc(*arguments, stdin=b""):
    """Call ``pycnc ARGUMENTS`` with bytes on stdin."""
    out, err = io.StringIO(), io.StringIO()
    entered = io.TextIOWrapper(io.BytesIO(stdin))
    with (
        contextlib.redirect_stdout(out),
        contextlib.redirect_stderr(err),
        mock.patch.object(sys, "stdin", entered),
    ):
        try:
            app([str(each) for each in arguments])
        except SystemExit as end:
            code = end.code or 0
    return Result(code, out.getvalue(), err.getvalue())
