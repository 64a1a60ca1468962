# SPDX-License-Identifier: MIT
"""What one job needs and everything else does without: packages, and rooms of the source tree."""

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


def of_tree(name):
    """Import a room that the source tree has and a wheel has not.

    Parameters
    ----------
    name : str
        Of a package, such as ``"pycnc.bench"``.

    Raises
    ------
    AbsentError
        If this is no checkout.
    """
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as cause:
        if cause.name != name:
            raise
        raise errors.AbsentError(
            f"{name} is in the source tree alone: run this in a checkout of pycnc", id="absent"
        ) from None
