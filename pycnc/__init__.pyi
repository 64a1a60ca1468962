# SPDX-License-Identifier: MIT
# The types of the front door: what a script meets. A test holds the names and the parameters
# against the code.
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from os import PathLike
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pycnc import stages as stages
from pycnc.errors import (
    AbsentError as AbsentError,
    ArgumentError as ArgumentError,
    InternalError as InternalError,
    MachineError as MachineError,
    NckError as NckError,
    ProgramError as ProgramError,
    StateError as StateError,
)

__version__: str

_Path = str | PathLike[str]
_Source = Program | _Path | bytes
_Slope = Literal["linear", "jerk", "optimal"]
_Planning = Literal["exact", "grades", "sshape"]
_Backend = Literal["auto", "c", "opencl"]
_Dialect = Literal["linuxcnc", "fanuc", "grbl", "marlin", "auto"]
_Records = Literal["segs", "nodes", "cells"]
_Settings = Mapping[str, Any] | Iterable[str]

class MachineFileError(MachineError):
    file: str
    problems: list[tuple[str, str]]
    places: list[str]

class Machine:
    name: str
    file: str
    text: str
    settings: Any
    sources: dict[str, str]
    changes: tuple[tuple[str, Any, str], ...]
    @classmethod
    def load(
        cls,
        name: _Path | Machine,
        *,
        set: _Settings = (),
        dialect: _Dialect | None = None,
        tools: _Path | None = None,
    ) -> Machine: ...
    @classmethod
    def from_text(cls, text: str, name: str = "machine") -> Machine: ...
    @property
    def axes(self) -> str: ...
    @property
    def period_s(self) -> float: ...
    @property
    def record(self) -> np.void: ...
    @property
    def sha256(self) -> str: ...
    def limits(self, kind: Literal["v_max", "a_max", "j_max"]) -> NDArray[np.float64]: ...
    def effective(self) -> Iterator[tuple[str, str | int | bool | Decimal | None, str]]: ...

class Diagnostic:
    file: str
    line: int
    col: int
    id: str
    severity: Literal["error", "warning", "note"]
    message: str
    help: str
    def as_dict(self) -> dict[str, str | int]: ...
    def text(self, colour: bool = False) -> str: ...

class Tables:
    def to_pandas(self) -> Any: ...
    def to_polars(self) -> Any: ...
    def to_arrow(self) -> Any: ...

class Diagnostics(Tables):
    shown: list[Diagnostic]
    counts: dict[str, int]
    errors: int
    def text(self, file: str, colour: bool = False) -> str: ...
    def as_list(self) -> list[dict[str, str | int]]: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[Diagnostic]: ...

class Program:
    file: str
    text: bytes
    machine: Machine
    blocks: NDArray[np.void] | None
    diagnostics: Diagnostics
    block_count: int
    @classmethod
    def from_points(
        cls,
        points: ArrayLike,
        feed: ArrayLike,
        machine: _Path | Machine = ...,
        *,
        tolerance: float | None = None,
    ) -> Program: ...
    @classmethod
    def from_moves(
        cls,
        sequence: Iterable[Mapping[str, Any]] | NDArray[np.void],
        machine: _Path | Machine = ...,
    ) -> Program: ...
    @property
    def sha256(self) -> str: ...
    @property
    def bounds(self) -> dict[str, tuple[float, float]]: ...
    @property
    def length_mm(self) -> float: ...
    def check(self) -> Program: ...

class Plan:
    program: Program
    time_s: float
    exact_time_s: float
    totals: dict[str, Any]
    plan_s: float
    kind: _Planning
    parts: list[dict[str, Any]] | None
    segs: NDArray[np.void]
    nodes: NDArray[np.void]
    cells: NDArray[np.void]
    def as_dict(self) -> dict[str, Any]: ...
    def why(self) -> Why: ...
    def to_pandas(self, records: _Records = "nodes") -> Any: ...
    def to_polars(self, records: _Records = "nodes") -> Any: ...
    def to_arrow(self, records: _Records = "nodes") -> Any: ...

class Why(Tables):
    plan: Plan
    program: Program
    time_s: float
    ideal_s: float
    causes: list[dict[str, Any]]
    cures: list[dict[str, Any]]
    def what_if(
        self,
        progress: Callable[[int, int], None] | None = None,
        changes: Iterable[str] = (),
        cures: bool = True,
    ) -> list[dict[str, Any]]: ...
    def as_dict(self) -> dict[str, Any]: ...
    def rows(self) -> list[dict[str, Any]]: ...
    def to_csv(self, path: _Path) -> None: ...

class Sweep(Tables):
    machine: Machine
    axes: dict[str, list[str]]
    rows: list[dict[str, Any]]
    @property
    def columns(self) -> list[str]: ...

class Rows(Tables):
    columns: dict[str, NDArray[Any]]
    @classmethod
    def load(cls, path: _Path) -> Rows: ...
    def metadata(self) -> dict[str, Any]: ...
    def __getitem__(self, name: str) -> NDArray[Any]: ...
    def __len__(self) -> int: ...
    def derived(self) -> dict[str, NDArray[np.float64]]: ...
    def names(self) -> dict[str, dict[int, str]]: ...
    def limit_names(self) -> dict[int, str]: ...
    def to_npz(self, path: _Path) -> None: ...
    def to_csv(self, path: _Path) -> None: ...
    def to_parquet(self, path: _Path) -> None: ...

class Trace(Rows):
    program: Program
    plan: Plan
    summary: dict[str, Any]
    as_planned: bool
    worst_lines: dict[str, list[tuple[int, float]]]
    def plot(self, path: _Path | None = None) -> Any: ...

def load(
    path_or_text: _Path | bytes,
    machine: _Path | Machine = ...,
    dialect: _Dialect | None = None,
) -> Program: ...
def plan(
    program: _Source,
    machine: _Path | Machine | None = None,
    slope: _Slope | None = None,
    backend: _Backend = "auto",
    plan: _Planning = "exact",
) -> Plan: ...
def why(
    program: _Source,
    machine: _Path | Machine | None = None,
    slope: _Slope | None = None,
    *,
    what_if: bool | list[str] = False,
) -> Why: ...
def sweep(
    files: Iterable[_Path],
    settings: Mapping[str, Iterable[Any]] | Iterable[str],
    machine: _Path | Machine = ...,
    *,
    jobs: int = 1,
    cluster: str | None = None,
) -> Sweep: ...
def run(
    program: _Source,
    machine: _Path | Machine | None = None,
    *,
    slope: _Slope | None = None,
    prep_steps: int = ...,
    commands: Sequence[tuple[Any, ...]] = (),
    backend: _Backend = "auto",
    plan: _Planning = "exact",
) -> Trace: ...
