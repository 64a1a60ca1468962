# SPDX-License-Identifier: MIT
"""Write first_part.ngc: a plate with a rounded contour, a round pocket and an engraved star.

    python make_first_part.py > first_part.ngc
"""

import math

PLATE, CORNER = 38.0, 12.0  # half the side of the contour and the radius of its corners [mm]
POCKET, TOOL = 21.0, 3.0  # radii of the pocket and of the end mill [mm]
DEPTHS = (-1.5, -3.0)  # of the pocket [mm]
STAR = 360  # micro-segments of the star


def main():
    """Print the program."""
    for part in (head(), contour(), pocket(), holes(), star(), tail()):
        print("\n".join(part))


def head():
    """Yield what stands before the first cut."""
    yield "%"
    yield "(first_part: a plate 76 x 76 mm, zero in its middle, Z0 on top)"
    yield "(written by make_first_part.py)"
    yield "G21 G90 G91.1 G94 G17 G40 G49 G54 G64"


def contour():
    """Yield a rounded square around the plate, entered along an arc."""
    side, lead = PLATE + TOOL, 6.0
    round_, flat = CORNER + TOOL, PLATE - CORNER
    yield from ("", "(1: contour, end mill of 6 mm)", "T1 M6", "S9000 M3", "M8")
    yield f"G0 X{lead:.3f} Y{-side - lead:.3f}"
    yield from ("G0 Z5", "G1 Z-2 F400", "F1200")
    yield f"G3 X0 Y{-side:.3f} I{-lead:.3f} J0 (tangential entry)"
    yield f"G1 X{-flat:.3f}"
    yield f"G2 X{-side:.3f} Y{-flat:.3f} I0 J{round_:.3f}"
    yield f"G1 Y{flat:.3f}"
    yield f"G2 X{-flat:.3f} Y{side:.3f} I{round_:.3f} J0"
    yield f"G1 X{flat:.3f}"
    yield f"G2 X{side:.3f} Y{flat:.3f} I0 J{-round_:.3f}"
    yield f"G1 Y{-flat:.3f}"
    yield f"G2 X{flat:.3f} Y{-side:.3f} I{-round_:.3f} J0"
    yield "G1 X0"
    yield f"G3 X{-lead:.3f} Y{-side - lead:.3f} I0 J{-lead:.3f} (tangential exit)"
    yield "G0 Z5"


def pocket():
    """Helix down, a spiral of half circles outwards, a full circle along the wall."""
    first, last, step = 4.0, POCKET - TOOL, 3.5
    yield from ("", "(2: pocket: helix, spiral, wall)", f"G0 X{first:.3f} Y0", "G0 Z0.5")
    top = 0.5
    for depth in DEPTHS:
        yield f"G3 X{first:.3f} Y0 Z{depth:.3f} I{-first:.3f} J0 P3 F800 (three turns down)"
        yield f"G3 X{first:.3f} Y0 I{-first:.3f} J0 F1500"
        here = first
        while abs(here) < last or here < 0:
            there = -math.copysign(min(abs(here) + step / 2, last), here)
            yield f"G3 X{there:.3f} Y0 I{(there - here) / 2:.3f} J0"
            here = there
        yield f"G3 X{last:.3f} Y0 I{-last:.3f} J0 F1000 (wall)"
        yield f"G1 X{last - 2:.3f}"
        yield f"G0 Z{top:.3f}"
        yield f"G0 X{first:.3f}"
        top = depth + 0.5
        yield f"G1 Z{top:.3f} F800"
    yield "G0 Z5"


def holes():
    """Yield four holes, each a helix and a dwell."""
    yield from ("", "(3: four holes, a helix and a dwell each)", "F600")
    for x, y in ((28, 28), (-28, 28), (-28, -28), (28, -28)):
        yield f"G0 X{x + 1.5:.3f} Y{y}"
        yield "G0 Z1"
        yield f"G3 X{x + 1.5:.3f} Y{y} Z-4 I-1.5 J0 P4"
        yield f"G3 X{x + 1.5:.3f} Y{y} I-1.5 J0"
        yield "G4 P0.1"
        yield "G0 Z5"


def star():
    """Yield a star of micro-segments."""
    yield from ("", "(4: star on the floor of the pocket, micro-segments)", "M9", "T7 M6")
    yield "S18000 M3"
    for k in range(STAR + 1):
        angle = 2 * math.pi * k / STAR
        radius = 11.5 + 4.5 * math.cos(5 * angle) + 0.8 * math.cos(10 * angle)
        x, y = radius * math.sin(angle), radius * math.cos(angle)
        if k == 0:
            yield from (f"G0 X{x:.3f} Y{y:.3f}", "G0 Z-2", "G1 Z-3.300 F300", "F2400")
        else:
            yield f"G1 X{x:.3f} Y{y:.3f}"
    yield "G0 Z5"


def tail():
    """Yield the way back."""
    yield from ("", "M5", "G28 Z5 (up to home)", "G0 X0 Y0", "M30", "%")


if __name__ == "__main__":
    main()
