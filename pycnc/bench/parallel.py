# SPDX-License-Identifier: MIT
"""Rows of `pycnc lab bench lookahead`: the envelope by every road of C, beside the memory's bound.

All variants of one size run in turn on the same arrays, each until its least time has had time to
show. Wrong would make it: other work on the cores (threads lose more than the rest), a clock that
changes between variants, and paths on which no overlap is certain (see docs/parallel.md).
"""

import numpy as np

from pycnc.planning import parallel

SIZES = (1_000, 10_000, 100_000, 1_000_000, 10_000_000)
SECONDS = 0.1  # of repetition for each variant; large sizes take five runs at least
REALS = {"float": np.float32, "double": np.float64}


def roads():
    """Return (name, options of `time_envelope`) of every road of C that is here."""
    found = [("serial", {"backend": "c"}), ("simd", {"backend": "simd"})]
    if parallel.processors()[-1] != "plain":
        found.append(("simd, plain C", {"backend": "simd", "processor": "plain"}))
    if parallel.has_threads():
        crew = parallel.threads()
        found.append((f"threads ({crew})", {"backend": "threads", "threads": crew}))
    return found


def bench_lookahead_rows(sizes=SIZES, seconds=SECONDS):
    """Return rows {n, variant, ns_per_point, ratio_to_serial, equal, share_of_triad}.

    Parameters
    ----------
    sizes : iterable of int
        Nodes.
    seconds : float
        Least time of repetition for each variant.

    Returns
    -------
    list of dict
        ratio_to_serial: how many times as fast as the serial recurrence in the same number type,
        in the same run; None for the triad. equal: the bits are those of the serial recurrence.
        share_of_triad: how much of the triad's speed over the same bytes is reached. The variant
        "auto" repeats the time of the road that the dispatch takes at that size.
    """
    rows = []
    for n in sizes:
        bounds = {1: None, parallel.threads(): None}
        for crew in bounds:
            bounds[crew] = parallel.time_triad(n, threads=crew, seconds=seconds)
            rows.append(_row(n, f"triad ({crew})", bounds[crew]))
        for real in REALS:
            rows += _rows_of_real(n, real, bounds, seconds)
    return rows


def _rows_of_real(n, real, bounds, seconds):
    """Return the rows of one size and number type."""
    rows, serial_ns, least = [], None, {}
    vv_cap, h = parallel.sample(real, n)
    want = parallel.envelope(vv_cap, h, backend="c")
    for name, options in roads():
        vv = np.zeros_like(vv_cap)
        ns = parallel.time_envelope(real, vv_cap=vv_cap, h=h, vv=vv, seconds=seconds, **options)
        serial_ns = serial_ns or ns
        least.setdefault(options["backend"], ns)
        bound = bounds[options.get("threads", 1)] * vv.itemsize / 4  # the triad runs in float
        row = _row(n, f"{name}, {real}", ns)
        row |= {
            "ratio_to_serial": serial_ns / ns,
            "equal": vv.tobytes() == want.tobytes(),
            "share_of_triad": bound / ns,
        }
        rows.append(row)
    auto = parallel.chosen(real, n).backend
    if auto in least:
        row = _row(n, f"auto: {auto}, {real}", least[auto])
        rows.append(row | {"ratio_to_serial": serial_ns / least[auto], "equal": True})
    return rows


def _row(n, variant, ns):
    return {
        "n": n,
        "variant": variant,
        "ns_per_point": ns / n,
        "ratio_to_serial": None,
        "equal": None,
        "share_of_triad": None,
    }
