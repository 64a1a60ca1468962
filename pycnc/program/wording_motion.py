# SPDX-License-Identifier: MIT
"""The words of the findings about cycles, contours, threads, compensation, splines and probes."""

_RELIEF = (
    "R beside the end of G{value} moves the tool aside at the end of every cut, of the first one "
    "into the wall, which is not supported",
    "leave R out there, or R0; how far a peck goes back is the R of a line of its own before it",
)
_OF_MILLS = (
    "G{value} is a drilling cycle of mills and of Haas' lathes, and none of Fanuc's lathes",
    "G83 without Q drills, with P it rests; G85 bores: G83 Z… R… P… F…, where R of system A is a "
    "step",
)
_PROBES = (
    "G{value}: this machine refuses probes",
    "--set dialect.probe=misses (or touches) simulates them, in LinuxCNC's language and in grbl's",
)
_BITES = (
    "{letter}{value} would have the cycle cut into the contour",
    "what is left on the contour leads away from the work: turn its sign; W leaves nothing on the "
    "far side of a pocket and is 0 there",
)
_TURNS_BACK = (
    "the contour turns back along {letter} here",
    "G71 cuts along Z, G72 along X: the contour goes one way; pockets: name X and Z in line P",
)
_CORNER = (
    "a corner of {value} mm does not fit between this line and the one before",
    "make it smaller; it stands between two straight lines",
)
_STRANGE = (
    "{letter}{value} cannot stand in or beside the contour of a cycle",
    "a contour has G0 G1 G2 G3 in the plane of Z and X (G18); put other codes before the cycle",
)
_BOTH_ENDS = (
    "G{value} is a turning cycle (Fanuc's G-code system A), needs X and Z, and has no {letter}",
    "say both; if G90 means absolute distances, or G94 feed per minute: --set dialect.system=B; a "
    "program made for RS274NGC: --dialect linuxcnc",
)
_THREAD = (
    "G92 is a thread cycle (Fanuc's G-code system A), needs X, Z and F, and has no {letter}",
    "say them; if it shifts the zero: --set dialect.system=B; a program made for RS274NGC: "
    "--dialect linuxcnc",
)
_THREAD_C = (
    "G21 is a thread cycle (Fanuc's G-code system C), needs X, Z and F, and has no {letter}",
    "say them; if it means millimetres: --set dialect.system=A (or B)",
)
_SPLINE_OPEN = (
    "the program ends before the spline that G{value} begins here does",
    "say G5.3 behind its last point; of G6.2 as many lines with K alone as its order P",
)

_POLAR_ZERO = (
    "{found} counts from the program's zero, and another code of its block moves that",
    "put the other code on a line before",
)
_POLAR_SHARED = ("{found} says where X and Y are, and so does another word", "keep one of both")
_POLAR_PLANE = ("{found} is a place in the plane of X and Y, and another one is in force",
                "say G17 before it")  # fmt: skip
_SLANT = {
    "word-unused:,": ("{found} is the angle of a line, and no G1 is in force", "say G1 before it"),
    "incremental:,": (
        "{found} counts from where the tool is: another code of its block moves the zero, or the "
        "line before ends where this one leads",
        "put the other code on a line before; behind a line with an angle alone say where the end "
        "is, not by how far (G90, X and Z)",
    ),
    "layout-on:,": (
        "{found} cannot be had while coordinates are mirrored, scaled, turned or polar",
        "end it before: G15, G69, G50, G50.1; or say both axes",
    ),
    "word-shared:,": (
        "{found} and two axes of the plane say where the line ends",
        "keep two of the three",
    ),
    "unsupported:,": (
        "{found}: where the line before ends is not known, which has an angle alone",
        "say both axes of the plane here, where this line ends",
    ),
    "number-range:,": (
        "a line at {found} comes to no such place", "say the other axis of the plane"
    ),
}  # fmt: skip
_POLAR_STEP = (
    "{found} is a step from the program's zero, where no angle is",
    "go away from the zero before, or say G90 with a distance (@) and an angle (^)",
)

# As in wording.py.
MOTION = {
    "word-missing:X90": _BOTH_ENDS,
    "word-missing:Z90": _BOTH_ENDS,
    "word-missing:X94": _BOTH_ENDS,
    "word-missing:Z94": _BOTH_ENDS,
    "word-missing:X92": _THREAD,
    "word-missing:Z92": _THREAD,
    "word-missing:F92": _THREAD,
    "word-missing:X21": _THREAD_C,
    "word-missing:Z21": _THREAD_C,
    "word-missing:F21": _THREAD_C,
    "word-missing:P76": (
        "G76 needs P: in two lines each has one, the first for passes, pull-out and angle",
        "write G76 P010060 Q100 R0.05 before G76 X… Z… P… Q… F…; "
        "or both in one line, with K and D",
    ),
    "word-missing:M": ("G86 stops the spindle, which stands", "start it before the cycle"),
    **{f"unsupported:G{code}:lathe": _RELIEF for code in (74, 75)},
    **{f"unsupported:G{code}:lathe": _OF_MILLS for code in (81, 82, 86)},
    "unsupported:G87": ("G87 needs a spindle that stops at an angle", "bore from above"),
    "unsupported:G88": ("behind G88 nobody knows where the tool is", "use G86 or G89"),
    "unsupported:G93": ("inverse time (G93) is the time of one move", "use G94 in a cycle"),
    **{f"unsupported:G38.{k}": _PROBES for k in range(2, 6)},
    "approach": (
        "the program is to begin at line {value:.0f}, and no height is known at which {letter} "
        "clears everything on the way there",
        "say it in machine coordinates: --set approach.height_mm=…; without it, it is the end of "
        "the travel, axis.{axis}.max_mm, which is free here",
    ),
    "comp-on": (
        "{found} while radius compensation (G41, G42) is in force",
        "end it by G40 and a move of the plane before, and begin it again behind",
    ),
    "comp-plane": (
        "the tool's nose points somewhere (orientation {value:.0f}), and the plane is not G18",
        "choose G18, or set tool.….orientation to 0 for a round cutter",
    ),
    "comp-entry": (
        "the first move under radius compensation, {value:.3f} mm, is not larger than the tool's "
        "radius, {limit:.3f} mm",
        "begin further away: the tool is beside the contour at this move's end",
    ),
    "comp-entry:G": (
        "the first move under radius compensation is an arc",
        "begin it by a straight move (G0 or G1), or say that the control takes an arc: --set "
        "dialect.comp_start=rs274",
    ),
    "comp-exit": (
        "the first move behind G40 is an arc",
        "leave the contour by a straight move (G0 or G1)",
    ),
    "comp-radius": (
        "the tool's radius, {value:.3f} mm, does not fit into an arc of {limit:.3f} mm",
        "take a smaller tool, or a larger arc",
    ),
    "contour": (
        "the contour of the cycle cannot be cut: it has no length, or reaches beyond the start",
        "begin the cycle further outside, and give the contour more than one point",
    ),
    "contour:P": (
        "the line behind the cycle is not N{value}, where its contour begins",
        "write the lines P … Q right behind the cycle",
    ),
    "contour:D": (
        "D{value} has no decimal point: a length, or least increments?",
        "write D{value}. for a length",
    ),
    "contour:U": _BITES,
    "contour:W": _BITES,
    "contour:X": _TURNS_BACK,
    "contour:Z": _TURNS_BACK,
    "contour:A": _CORNER,
    "contour:C": _CORNER,
    "contour:G": _STRANGE,
    "contour:M": _STRANGE,
    "contour-full": (
        "the contour has more than {limit:.0f} lines and arcs",
        "make it shorter, or build with a larger NCK_CONTOUR",
    ),
    "comp-gouge:G": (
        "on its way to the contour, or from it, the tool would cut {value:.3f} mm into the one of "
        "line {limit:.0f}",
        "begin and end where the tool comes straight to the contour's side, over no other part",
    ),
    "comp-gouge": (
        "the tool would cut {value:.3f} mm into the contour of line {limit:.0f}",
        "take a smaller tool, or widen the contour between the two lines",
    ),
    "speed-limit": (
        "G96 while nothing limits the spindle's speed, which grows towards the axis",
        "say the most beside it, as in G96 S200 D2500, or --set spindle.rpm_max=…",
    ),
    "speed-limit:S": (
        "G96 while nothing limits the spindle's speed, which grows towards the axis",
        "say the most before it, as in G50 S2500 (systems B and C: G92), or "
        "--set spindle.rpm_max=…",
    ),
    "thread-speed": (
        "the lead times the speed of the spindle is {value:.3g} mm/s: an axis can follow "
        "{limit:.3g} mm/s",
        "turn slower, or raise the axis' limit if the machine has more: "
        "--set axis.z.v_max_mm_s=…",
    ),
    "thread-speed:G": (
        "a thread under G96: the spindle's speed would change with X",
        "say G97 with S in rpm before it",
    ),
    "thread-speed:S": (
        "a thread while the spindle stands",
        "start it before, as in G97 S800 M3",
    ),
    "thread-run-in": (
        "the pass is {limit:.3f} mm long; to reach its speed and to leave it takes {value:.3f} mm",
        "begin further from the thread, end further behind it, or turn slower",
    ),
    "layout-on": (
        "{letter}{value} cannot be done while coordinates are mirrored, scaled, turned or polar",
        "end it before, in this order: G15, G69, G50, G50.1; LinuxCNC: G10 L2 P0 R0",
    ),
    "layout-on:?": (
        "an arc while its plane is scaled unevenly would be none, and I J K count from its start",
        "give both axes of the plane the same factor; G91.1 (dialect.arc_centre)",
    ),
    **_SLANT,
    **{f"incremental:{sign}": _POLAR_ZERO for sign in "@^"},
    **{f"word-shared:{sign}": _POLAR_SHARED for sign in "@^"},
    **{f"unsupported:{sign}": _POLAR_PLANE for sign in "@^"},
    **{f"value:{sign}": _POLAR_STEP for sign in "@^"},
    "scale-unit:Q": (
        "a control may read {letter}{value} as {value} mm, or as {value} least increments "
        "(0.001 mm)",
        "write a point ({letter}{value}.) or say what it is: --set dialect.integers=increments "
        "(or units)",
    ),
    "scale-unit": (
        "a control may read the factor {letter}{value} as {value}, as thousandths, or less",
        "write a point ({letter}{value}.) or say what 1 means: --set dialect.scale_unit=0.001",
    ),
    **dict.fromkeys(("modal-group:G28", "modal-group:G30"), (
        "{found} excludes another code of its block, which moves, too",
        "put one of the two codes on a line of its own; if the program is written for Fanuc, which "
        "takes both: --dialect fanuc",
    )),
    "comp-on:M72": (
        "M72 would switch radius compensation, which needs a move of its own",
        "say G40 before it, or keep the state in the same compensation",
    ),
    "corner:A": (
        "a line with an angle alone ends where it meets the next line, and they do not meet",
        "say in the next line an angle and both axes (G1 ,A30. and then X20. Y9. ,A90.); both lie "
        "a degree apart at least",
    ),
    "corner": (
        "a corner {letter}{value} does not fit between this move and the next one",
        "make it smaller; both are G1 G2 G3 in the plane, one line behind the other, and meet at "
        "an angle; a sign without a comma says which way the next one goes",
    ),
    "probe:G": (
        "G{value} must touch something (G38.4: leave it) on its way, and nothing is there",
        "--set dialect.probe=touches simulates it where it ends; G38.3 and G38.5 may miss (#5070)",
    ),
    "probe:G95": ("a probe has no feed per revolution (G95)", "say G94 and F before it"),
    "probe": ("the probe has no way to go", "probe towards a place where the axes do not stand"),
    "spline": ("{letter} does not move along a spline", "splines lie in X and Y: move it before"),
    "spline:G5.2": (
        "another motion before G5.3: the spline of G5.2 is not ended",
        "say G5.3 behind its last point",
    ),
    **{f"spline:M{code}": _SPLINE_OPEN for code in (5.2, 6.2)},
    "spline:G5.3": ("G5.3 without a G5.2 before it", "begin the spline with G5.2 and its points"),
    "spline:G": ("splines lie in the plane of X and Y (G17)", "say G17 before"),
    "spline:G6.2": (
        "another motion before the last knots of G6.2: its spline is not ended",
        "behind the last point say as many lines with K alone as its order P",
    ),
    "spline:G91": ("points of G6.2 are places, and distances are steps (G91)", "say G90 before"),
    "spline:P": ("G6.2 begins elsewhere than where the tool stands", "move there before"),
    "spline:K": (
        "the knots of G6.2 fit no curve from its first point to its last one",
        "never say less than before; P equal ones first and last (4 without P), fewer between",
    ),
    "spline:L": (
        "a spline of order {limit:.0f} needs {limit:.0f} points and has {value:.0f}",
        "say more points between G5.2 and G5.3, or a lower order with L",
    ),
    "comp-left": (
        "the tool is too large for the contour from here to line {limit:.0f}: up to {value:.3f} mm "
        "are left",
        "take a smaller tool if that is too much",
    ),
    "comp-way": (
        "on its way to the contour, or from it, the tool cuts {value:.3f} mm into its end in line "
        "{limit:.0f}",
        "if that is no lead in the air: come, or go, at a right angle to it, or along an arc",
    ),
}
