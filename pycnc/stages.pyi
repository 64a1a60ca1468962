# SPDX-License-Identifier: MIT
# The types of the rooms one by one. A test holds the names and the parameters against the code.
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pycnc import Machine

class Profile:
    v_node: NDArray[np.float64]
    cells: NDArray[np.void]
    segment_s: NDArray[np.float64]
    time_s: float
    def sample(
        self, period_s: float
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]: ...

class Keinert:
    vv: NDArray[np.float64]

def decode(text: bytes, machine: Machine) -> tuple[NDArray[np.void], NDArray[np.void]]: ...
def envelope(
    vv_cap: ArrayLike,
    h: ArrayLike,
    *,
    vv_start: float = 0.0,
    vv_end: float = 0.0,
    backend: Literal["auto", "c", "simd", "threads", "opencl"] = "auto",
    threads: int | None = None,
    processor: str | None = None,
    out: NDArray[np.floating] | None = None,
) -> NDArray[np.floating]: ...
def keinert(
    vv_cap: ArrayLike,
    h: ArrayLike,
    vv_feed: ArrayLike,
    *,
    vv_start: float = 0.0,
    vv_end: float = 0.0,
    length: int = 300,
    overlap: tuple[int, int] = (5, 50),
    threads: int | None = None,
) -> Keinert: ...
def slope(
    length_mm: ArrayLike,
    v_cap: ArrayLike,
    a_max: ArrayLike,
    j_max: ArrayLike | None,
    v_node: ArrayLike,
    *,
    kind: Literal["linear", "jerk", "sshape", "whole", "fixed"] = "linear",
    lookahead: int | None = None,
    ramp_s: float = 1.0,
    period_s: float = 1e-3,
    step_s: float | None = None,
    j_scale: float = 0.0,
) -> Profile: ...
