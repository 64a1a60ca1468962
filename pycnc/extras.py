# SPDX-License-Identifier: MIT
"""Packages that one job needs and everything else does without."""

import importlib

from pycnc import errors

_JOBS = {  # package → (what needs it, the extra that brings it)
    "casadi": ("bounds need", "bounds"),
    "distributed": ("a cluster needs", "cluster"),
    "matplotlib": ("pictures need", "plot"),
    "pandas": ("tables need", "table"),
    "polars": ("tables of polars need", "polars"),
    "pyarrow": ("Parquet files and tables of Arrow need", "trace"),
}


def need(name):
    """Import a module of an extra.

    Parameters
    ----------
    name : str
        Of a module, such as ``"matplotlib.figure"``.

    Raises
    ------
    AbsentError
        If it is not installed.
    """
    try:
        return importlib.import_module(name)
    except ImportError as cause:
        package = name.partition(".")[0]
        job, extra = _JOBS[package]
        raise errors.AbsentError(
            f'{job} {package} ({cause}): pip install "pycnc-nck[{extra}]"', id="absent"
        ) from None
