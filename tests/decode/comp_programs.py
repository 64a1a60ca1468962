# SPDX-License-Identifier: MIT
"""Random programs with radius compensation that rs274 reads: contours that the tool fits into."""

import contours
import numpy as np

RADII = {3: 1.0, 4: 3.0, 5: 6.0}  # of tools [mm]
LETTERS = {17: "XYIJ", 18: "ZXKI"}  # rs274 has none in G19


def program(seed):
    """Return one to three contours, each in a plane of its own, by D of a tool or by a diameter."""
    rng = np.random.default_rng([seed, 3])
    lines = ["G21 G90 G94 G61 F1000"]
    for _ in range(rng.integers(1, 4)):
        tool, plane = int(rng.choice(list(RADII))), int(rng.choice(list(LETTERS)))
        radius, side = RADII[tool], int(rng.choice([-1, 1]))
        elements = contours.hills(rng, int(rng.integers(5, 40)), radius, side)
        ahead = -1j * elements[0].left(np.zeros(1))[0]
        entry = elements[0].start - 10 * radius * ahead * np.exp(0.5j * rng.choice([-1, 1]))
        leave = elements[-1].end + 10 * radius * np.exp(1j * rng.uniform(-1, 1))
        text = contours.program(elements, radius, side, entry, leave)
        text = text.removeprefix(contours.HEAD).removesuffix("M2\n")
        if rng.random() < 0.5:
            code = "G41" if side > 0 else "G42"
            text = text.replace(f"{code}.1 D{2 * radius:.6f}", f"{code} D{tool}")
        lines += [f"G{plane}", text.translate(str.maketrans("XYIJ", LETTERS[plane]))]
    return "\n".join([*lines, "M2", ""]).encode()
