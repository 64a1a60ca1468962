# SPDX-License-Identifier: MIT
"""The words of the findings: id → (message, help)."""

_STEPS = (
    "{found} counts from where the axis stands, and another code of its block changes that",
    "put the other code on a line before",
)
_TAPPING = (
    "G{value:g}: tapping cycles are not supported on lathes that speak Fanuc's language",
    "tap with G32 in and out, the spindle turned back between them, or --dialect linuxcnc: G33.1",
)
_SETS = (
    "a control may take this {letter} for one of another set of I J K, and so another parameter",
    "say I J K in this order, in every set what a later one has; or letters: D is #7, E is #8",
)
_D_OFFSET = (
    "G10 L{value:g} sets an offset for D: Fanuc's mills do, by radius or by diameter",
    "where the control is one, say which it takes: --set dialect.d_offset=radius (or diameter)",
)
_RELIEF = (
    "R beside the end of G{value:g} moves the tool aside at the end of every cut, of the first one "
    "into the wall, which is not supported",
    "leave R out there, or R0; how far a peck goes back is the R of a line of its own before it",
)
_DRIVEN = (
    "G{value:g} drills with a driven tool on Fanuc's lathes, which is not supported",
    "drill on the axis with G1; --dialect linuxcnc for a program made for RS274NGC",
)
_PROBES = (
    "G{value:g}: this machine refuses probes",
    "--set dialect.probe=misses (or touches) simulates them, in LinuxCNC's language and in grbl's",
)
_BITES = (
    "{letter}{value:g} would have the cycle cut into the contour",
    "what is left on the contour leads away from the work: turn its sign; W leaves nothing on the "
    "far side of a pocket and is 0 there",
)
_TURNS_BACK = (
    "the contour turns back along {letter} here",
    "G71 cuts along Z, G72 along X: the contour goes one way; pockets: name X and Z in line P",
)
_CORNER = (
    "a corner of {value:g} mm does not fit between this line and the one before",
    "make it smaller; it stands between two straight lines",
)
_STRANGE = (
    "{letter}{value:g} cannot stand in or beside the contour of a cycle",
    "a contour has G0 G1 G2 G3 in the plane of Z and X (G18); put other codes before the cycle",
)
_NOT_IN_A = (
    "G{value:g} is none of the codes of Fanuc's G-code system A, which a lathe is taken to speak",
    "--set dialect.system=B (or C); in A, U and W count steps and G99 is feed per revolution; a "
    "program made for RS274NGC: --dialect linuxcnc",
)
_BOTH_ENDS = (
    "G{value:g} is a turning cycle (Fanuc's G-code system A), needs X and Z, and has no {letter}",
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

# id, or id:letter or id:code (:lathe) where one needs its own, → (message, help). Fields: see
# Wording._fields.
WORDING = {
    "character": (
        "{found} starts no word",
        "a block is made of words such as G1 X10 F200; comments stand in ( ) or after ;",
    ),
    "number": (
        "{letter} has no number that can be read",
        "write the number right after the letter: {letter}12.5 (a decimal point, no comma)",
    ),
    "number:?": (
        "a number without a letter",
        "write the letter that the number belongs to, such as X12.5",
    ),
    "number-range": (
        "{letter}{value:g} is out of range (limit {limit:g})",
        "check the number and the units in force (G20 inch, G21 mm)",
    ),
    "number-range:S": (
        "S{value:g} is out of range (limit {limit:g})",
        "choose another speed, or set the machine's: --set spindle.rpm_max=…",
    ),
    "number-range:R": (
        "R{value:g} is out of range (limit {limit:g})",
        "check number and units; in a cycle R lies above the bottom, a taper beside its end",
    ),
    "number-range:Q": ("Q{value:g} is no depth of a peck", "Q has no sign and is more than 0"),
    "line-length": (
        "the line is longer than {value:.0f} bytes",
        "split the block into several lines or shorten its comment",
    ),
    "comment": (
        "the comment is not closed",
        "close it with ) on the same line, or begin it with ;",
    ),
    "word-unknown": (
        "the language has no {letter} word",
        "remove the word, or put it into a comment: ( )",
    ),
    "word-twice": (
        "{letter} stands twice in one block",
        "keep one of the two, or make two lines of the block",
    ),
    "word-unused": (
        "no code of this block uses {found}",
        "remove the word, or add the code that it belongs to",
    ),
    "word-missing": (
        "a word is missing in this block: {letter}",
        "add {letter} with its number to the block",
    ),
    "word-missing:X": (
        "{found} names no axis",
        "add the axes with their numbers, such as X0, to the block",
    ),
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
    "word-shared:#": (
        "#{value:g} is an offset that counts at once, and other words stand in its line",
        "set it on a line of its own",
    ),
    "word-shared": (
        "two codes of this block use {found}",
        "put one of the two codes on a line of its own",
    ),
    "word-missing:G": (
        "{found} without a straight move",
        "add G0 or G1 to the block",
    ),
    "g-unknown": (
        "G{value:g} is no G code that the kernel knows",
        "look up the code in the manual of the control that the program was made for",
    ),
    "m-unknown": (
        "M{value:g} is no M code that the kernel knows",
        "remove the code, or if the machine has it, tell so in its file: [m.{value:.0f}] "
        'action = "output"',
    ),
    "modal-group": (
        "{found} excludes another code of its block (both set the same, or both move)",
        "put one of the two codes on a line of its own",
    ),
    "unsupported": (
        "{found} is not supported yet",
        "have the post-processor write plain moves instead; nothing is skipped in silence",
    ),
    "unsupported:I": _SETS,
    "unsupported:J": _SETS,
    "unsupported:K": _SETS,
    "unsupported:P": (
        "the machine has no reference point {value:g}, where G30 P{value:g} goes",
        "say where it is in the machine: --set home.g30_p{value:g}.z_mm=…, or go there by G53",
    ),
    "unsupported:#": (
        "the program cannot reach the control's own parameter #{value:g} in this way",
        "keep values in #100 … #199; set offsets by G10: L2 P (work), L1 L10 L11 P (tools); Fanuc: "
        "#5221 … can be set, too",
    ),
    "unsupported:L": (
        "G10 L{value:g} is not supported here",
        "say it in the machine file: --set tool.N.length_mm=…, radius_mm, x_mm; work systems: L2",
    ),
    **{f"unsupported:L{each}": _D_OFFSET for each in (12, 13)},
    "unsupported:H": (
        "controls differ in when G10 counts that changes a tool while a length (G43) is in force",
        "put G49 before G10, and G43 H behind it",
    ),
    "unsupported:R": (
        "G10 L2 R turns the work system, which is not supported",
        "turn the part in the post-processor, or G68 X0 Y0 R… where the program is Fanuc's",
    ),
    **{f"unsupported:G{code}:lathe": _TAPPING for code in (84, 88)},
    **{f"unsupported:G{code}:lathe": _RELIEF for code in (74, 75)},
    **{f"unsupported:G{code}:lathe": _DRIVEN for code in (83, 85, 87, 89)},
    "unsupported:G87": ("G87 needs a spindle that stops at an angle", "bore from above"),
    "unsupported:G88": ("behind G88 nobody knows where the tool is", "use G86 or G89"),
    "unsupported:G93": ("inverse time (G93) is the time of one move", "use G94 in a cycle"),
    "unsupported:G91": _NOT_IN_A,
    "unsupported:G95": _NOT_IN_A,
    "unsupported:G92": (
        "G92 limits the spindle's speed (with S) on Fanuc's lathes alone",
        "limit the speed by --set spindle.rpm_max=…; where the zero is to be shifted: "
        "--set dialect.system=B, or --dialect linuxcnc for a program made for RS274NGC",
    ),
    **{f"unsupported:G38.{k}": _PROBES for k in range(2, 6)},
    "incremental": (
        "{found} names a machine position while distances are incremental (G91)",
        "put G90 into the block or before it",
    ),
    "feed-missing": (
        "a cut without feed",
        "put F on this line or before it, or give a default: --set dialect.feed_default_mm_min=500",
    ),
    "feed-missing:S": (
        "feed per revolution (G95) while the spindle stands",
        "start the spindle before it, as in S800 M3, or program G94 with F in mm/min",
    ),
    "arc-radius": (
        "arc ends {miss:.3f} mm off its circle "
        "(start radius {limit:.3f}, end radius {value:.3f}, tolerance {tolerance:.3g})",
        "check I J K and G90.1/G91.1, write more decimals, or set path.arc_radius_mm",
    ),
    "arc-mode": (
        "arc ends {miss:.3f} mm off its circle as it is read, and on one if I J K counted from "
        "the start (G91.1)",
        "--set dialect.arc_centre=incremental, or G91.1 in the program",
    ),
    "arc-mode:A": (
        "arc ends {miss:.3f} mm off its circle as it is read, and on one if I J K counted from "
        "the program's zero (G90.1)",
        "--set dialect.arc_centre=absolute, or G90.1 in the program",
    ),
    "arc-centre": (
        "the arc has no centre, or its radius is zero",
        "give the centre by I J K in the plane in force (G17: I J, G18: I K, G19: J K), or R",
    ),
    "arc-chord": (
        "R{value:g} is shorter than half of the chord, {limit:.4f} mm",
        "check R, the end point and the units in force",
    ),
    "axis-unknown": (
        "the machine {machine} has no {letter} axis",
        "choose a machine that has it (--machine), or remove the word",
    ),
    "travel": (
        "{letter} reaches {value:.3f} {unit}, its travel ends at {limit:.3f} {unit}",
        "move the work zero (--set work.g54.{key}=…), or if the machine has more travel: "
        "--set axis.{axis}.{end}_{unit}=…",
    ),
    "tool-unknown": (
        "tool {value:.0f} is not in the tool table",
        "add [tool.{value:.0f}] to the machine file, or give a tool table: --tools tool.tbl",
    ),
    "no-motion": (
        "axis words while no motion is in force",
        "begin the block with G0, G1, G2 or G3",
    ),
    "dialect": (
        "this is a program in {dialect}, which pycnc does not read",
        "have the post-processor write G-code as RS274NGC, Fanuc, grbl or Marlin have it",
    ),
    "binary": (
        "this is no NC program: it holds a NUL byte",
        "give a text file",
    ),
    "no-program": (
        "the text holds no block",
        "give a program with one word at least",
    ),
    "expression": (
        "{found} cannot be read here",
        "an expression is made of numbers, #parameters, [ ] and functions such as SIN[30]; an O "
        "word needs sub, call, if, while, repeat, do or their ends behind it",
    ),
    "value": (
        "an expression without a value: it divides by zero, or a function has none for {value:g}",
        "check the parameters that it is made of",
    ),
    "parameter-unset": (
        "the named parameter was never set",
        "set it before, or ask for it by EXISTS[#<name>]",
    ),
    "parameters-full": (
        "more than {limit:.0f} parameters are set at once",
        "build the kernel with a larger NCK_VARIABLES",
    ),
    "call-depth": (
        "more than {limit:.0f} calls and loops in one another",
        "end the recursion, or build the kernel with a larger NCK_CALL_DEPTH",
    ),
    "label-missing": (
        "what is called or jumped to is not in the text",
        "add the subprogram (O…) or the line (N…) to the same file",
    ),
    "flow": (
        "a control word without its other end",
        "every sub, if, while, repeat, do and DO needs its end, with the same number",
    ),
    "no-seek": (
        "a jump backward in text that is only pushed",
        "give the kernel the text to read (nck_read)",
    ),
    "alarm": ("the program stops with alarm {value:.0f} (#3000)", "see the remark on its line"),
    "endless:J": (
        "the program has gone back {limit:.0f} times",
        "check the condition of its loop: it seems never to end",
    ),
    "endless": (
        "{limit:.0f} lines were read and no block came",
        "a loop without a move never ends: check its condition",
    ),
    "label-missing:N": (
        "the program ends before line {value:.0f}, where it is to begin",
        "choose a line that is reached",
    ),
    "comp-on:N": (
        "line {value:.0f} stands in radius compensation: where its tool is, depends on before",
        "begin before its G41 or G42",
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
        "the line behind the cycle is not N{value:g}, where its contour begins",
        "write the lines P … Q right behind the cycle",
    ),
    "contour:D": (
        "D{value:g} has no decimal point: a length, or least increments?",
        "write D{value:g}. for a length",
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
        "{letter}{value:g} cannot be done while coordinates are mirrored, scaled, turned or polar",
        "end it before, in this order: G15, G69, G50, G50.1; they begin in the other one",
    ),
    "layout-on:?": (
        "an arc while its plane is scaled unevenly would be none, and I J K count from its start",
        "give both axes of the plane the same factor; G91.1 (dialect.arc_centre)",
    ),
    "scale-unit": (
        "a control may read the factor {letter}{value:g} as {value:g}, as thousandths, or less",
        "write a point ({letter}{value:g}.) or say what 1 means: --set dialect.scale_unit=0.001",
    ),
    "flow:M72": (
        "M72, and neither M70 nor M73 has kept a state in this call",
        "say M70 (or M73 in a subprogram) before it",
    ),
    "call-depth:M": (
        "states are kept in more calls than {limit:.0f}",
        "restore or forget them (M72, M71) before",
    ),
    "comp-on:M72": (
        "M72 would switch radius compensation, which needs a move of its own",
        "say G40 before it, or keep the state in the same compensation",
    ),
    "corner": (
        "a corner {letter}{value:g} does not fit between this move and the next one",
        "make it smaller; both are G1 G2 G3 in the plane, one line behind the other, and meet at "
        "an angle; a sign without a comma says which way the next one goes",
    ),
    "probe:G": (
        "G{value:g} must touch something (G38.4: leave it) on its way, and nothing is there",
        "--set dialect.probe=touches simulates it where it ends; G38.3 and G38.5 may miss (#5070)",
    ),
    "probe:G95": ("a probe has no feed per revolution (G95)", "say G94 and F before it"),
    "probe": ("the probe has no way to go", "probe towards a place where the axes do not stand"),
    "spline": ("{letter} does not move along a spline", "splines lie in X and Y: move it before"),
    "spline:G5.2": (
        "another motion before G5.3: the spline of G5.2 is not ended",
        "say G5.3 behind its last point",
    ),
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
    "limits-stay": (
        "M201 to M205 change limits of a printer's firmware: here the machine's hold",
        "set them in the machine file, as in --set axis.x.a_max_mm_s2=1000",
    ),
    "argument": ("a call to the kernel had a number outside of its range", "please report this"),
    "machine": ("the kernel refuses a number of the machine", "pycnc machine validate tells which"),
    "state": ("a call to the kernel came at the wrong time", "please report this"),
    "internal": ("an invariant of the kernel is broken", "please report this with the program"),
    "incremental:U": _STEPS,
    "incremental:V": _STEPS,
    "incremental:W": _STEPS,
    "repeats": (
        "M99 has the main program begin again: it is read once",
        "",
    ),
    "assumed-system": (
        "G90 and G94 are read as turning cycles (Fanuc's G-code system A)",
        "if that is wrong: --set dialect.system=B (or C); if it is right, A says so",
    ),
    "assumed-feed-mode": (
        "F is read per minute: no G98 or G99 (systems B and C: G94 or G95) stands before it",
        "if that is wrong: --set dialect.feed=per_rev; if it is right, per_minute says so",
    ),
    "assumed-units": ("no G20 or G21 before the first motion: {units} assumed", ""),
    "assumed-plane": ("no G17, G18 or G19 before the first arc or cycle: G{plane} assumed", ""),
    "assumed-distance": ("no G90 or G91 before the first motion: absolute (G90) assumed", ""),
    "assumed-centre": ("no G90.1 or G91.1 before I J K: {arc_centre} centres assumed", ""),
    "no-tolerance": (
        "G64 without P means the machine's tolerance, and that is 0: the path is exact",
        "give P, as in G64 P0.01, or the machine a tolerance: --set path.tolerance_mm=0.01",
    ),
    "no-end": ("the text ends without M2, M30 or a closing %", ""),
    "after-end": ("what follows the program's end is not read", "remove the text or the M2 / M30"),
    "called-from": ("called from here", ""),
    "comp-left": (
        "the tool is too large for the contour from here to line {limit:.0f}: up to {value:.3f} mm "
        "are left",
        "take a smaller tool if that is too much",
    ),
    "feed-units": (
        "F beside a change of units is read in the units that its own line begins",
        "put G20 or G21 on a line before: LinuxCNC reads such an F in the units before the line",
    ),
}
