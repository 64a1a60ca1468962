# SPDX-License-Identifier: MIT
"""The words of the findings: id → (message, help)."""

from pycnc.program.wording_motion import MOTION

_STEPS = (
    "{found} counts from where the axis stands, and another code of its block changes that",
    "put the other code on a line before; a drilling cycle is told its depth by Z, or X",
)
_MACH_UNITS = (
    "G{value} works on a contour on LinuxCNC's lathes alone; Mach3's is another one",
    "in a program for Mach3 G70 is G20 (inches) and G71 is G21 (mm): write those, or leave it out "
    "where they stand, too",
)
_SETS = (
    "a control may take this {letter} for one of another set of I J K, and so another parameter",
    "say I J K in this order, in every set what a later one has; or letters: D is #7, E is #8",
)
_D_OFFSET = (
    "G10 L{value} sets an offset for D: Fanuc's mills do, by radius or by diameter",
    "where the control is one, say which it takes: --set dialect.d_offset=radius (or diameter)",
)
_PROBES = (
    "{found} has the printer probe: its moves and their time are left out",
    "say so: --set g.{key_of_g}.action=ignore",
)
_RETRACTS = (
    "{found} is a retraction of the firmware's own: it is left out, and so is its time",
    "have the slicer write retractions as moves of E, or say so: "
    "--set g.{key_of_g}.action=ignore",
)
_OWN_WAYS = (
    "{found} has the printer go a way of its own: its moves and their time are left out",
    "say so: --set g.{key_of_g}.action=ignore",
)
_SENDERS = (
    "{found} begins what a sender says to grbl, and no block of a program",
    "take the line out: the machine is homed ($H), moved by hand ($J) or asked (?) before it runs",
)
META = (
    "{meta} is of RepRapFirmware's meta commands: what it comes to, the printer knows alone",
    "have the slicer write plain commands and numbers",
)
_OWN_M = (
    "M{value} is a function of the machine's own, and its file does not name it",
    "if the machine has it: --set m.{value:.0f}.action=output (or wait, until it is done)",
)
_NOT_IN_A = (
    "G{value} is none of the codes of Fanuc's G-code system A, which a lathe is taken to speak",
    "--set dialect.system=B (or C); in A, U and W count steps and G99 is feed per revolution; a "
    "program made for RS274NGC: --dialect linuxcnc",
)

_POCKET = (
    "G{value} of Haas mills a pocket by a way of the control's own, which no manual says in full",
    "have the post-processor write its arcs and lines (or say G2 and G3 by yourself)",
)
_RING = (
    "G{value} drills holes on a circle by the cycle in force, and there is none",
    "say the cycle on a line before, without a hole: G81 Z-5. R2. F90. L0",
)

# id, or id:letter or id:code (:lathe) where one needs its own, → (message, help). Fields: see
# Wording._fields.
WORDING = {
    "character": (
        "{found} starts no word",
        "a block is made of words such as G1 X10 F200; comments stand in ( ) or after ;",
    ),
    **{f"character:?{code}": _SENDERS for code in map(ord, "$?~!")},
    "number": (
        "{letter} has no number that can be read",
        "write the number right after the letter: {letter}12.5 (a decimal point, no comma)",
    ),
    "number:?": (
        "a number without a letter",
        "write the letter that the number belongs to, such as X12.5",
    ),
    "number-range": (
        "{letter}{value} is out of range ({bound} {limit})",
        "check the number and the units in force (G20 inch, G21 mm)",
    ),
    "number-range:S": (
        "S{value} is out of range ({bound} {limit})",
        "choose another speed, or set the machine's: --set spindle.rpm_max=…",
    ),
    "number-range:S:marlin": (
        "S{value} is out of range ({bound} {limit})",
        "check the number; a spindle's most is --set spindle.rpm_max=…",
    ),
    "number-range:$": (
        "$ names a spindle that there is not: the kernel has one, $0",
        "leave $ out, or say $0 (and M5 $-1 for all)",
    ),
    "number-range:*": (
        "by its checksum *{value} the line has a mistake: it comes to *{limit}",
        "leave * out where the line was changed on purpose",
    ),
    "number-range:F0": (
        "F0 is no speed that Klipper takes: it ends the print", "say a feed, or leave F out"
    ),
    "number-range:R": (
        "R{value} is out of range ({bound} {limit})",
        "check number and units; in a cycle R lies above the bottom, a taper beside its end, and "
        "in system A R of G83 … G89 is a step from where the drill stands, 0 or less",
    ),
    "number-range:Q": ("Q{value} is no depth of a peck", "Q has no sign and is more than 0"),
    "line-length": (
        "the line is longer than {value:.0f} bytes",
        "split the block into several lines or shorten its comment",
    ),
    "comment": (
        "the comment is not closed",
        "close it with ) on the same line, or begin it with ;",
    ),
    "comment:(": (
        "a comment in a comment",
        "write the inner one without ( ): LinuxCNC refuses it, and others run what follows its )",
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
    "word-unused:H:marlin": (
        "{found} has a move end at a switch, or moves motors by themselves",
        "leave homing to G28: where such a move ends, the printer knows alone",
    ),
    "word-missing": (
        "a word is missing in this block: {letter}",
        "add {letter} with its number to the block",
    ),
    "word-missing:X": (
        "{found} names no axis",
        "add the axes with their numbers, such as X0, to the block",
    ),
    "word-shared:#": (
        "#{value} is an offset that counts at once, and other words stand in its line",
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
        "G{value} is no G code that the kernel knows",
        "look up the code in the manual of the control that the program was made for",
    ),
    "m-unknown": (
        "M{value} is no M code that the kernel knows",
        "remove the code, or if the machine has it, tell so in its file: [m.{value:.0f}] "
        'action = "output"',
    ),
    "other-base": (
        "{found} is not of the language {base} (dialect.base); it is of {others}",
        "if the program is written for it: --dialect {dialects}; else say it in {base}'s words",
    ),
    "other-base:#": (
        "the language {base} (dialect.base) has no parameter #{value}; it is of {others}",
        "if the program is written for it: --dialect {dialects}; values go into #100 … #499",
    ),
    "other-base:M": (
        "{found} is not of the language {base} (dialect.base); it is of {others}",
        "if the machine has it: --set m.{value:.0f}.action=output (or wait, until it is done); "
        "if the program is written for another one: --dialect {dialects}",
    ),
    "modal-group": (
        "{found} excludes another code of its block (both set the same, or both move)",
        "put one of the two codes on a line of its own",
    ),
    "unsupported": (
        "{found} is not supported yet",
        "have the post-processor write plain moves instead; nothing is skipped in silence",
    ),
    **{f"unsupported:M{code}": _OWN_M for code in (10, 11, 13, 14, 19, *range(40, 46))},
    "unsupported:M99": (
        "M99 ends what M98 calls, and this subprogram was called by an O word",
        "end it by endsub, or by return before its end",
    ),
    "unsupported:I": _SETS,
    "unsupported:J": _SETS,
    "unsupported:K": _SETS,
    "unsupported:P": (
        "the machine has no reference point {value}, where G30 P{value} goes",
        "say where it is in the machine: --set home.g30_p{value}.z_mm=…, or go there by G53",
    ),
    "unsupported:#": (
        "the program cannot reach the control's own parameter #{value} in this way",
        "keep values in #100 … #199; set offsets by G10: L2 P (work), L1 L10 L11 P (tools); Fanuc: "
        "#5221 … can be set, too",
    ),
    "unsupported:L": (
        "G10 L{value} is not supported here",
        "say it in the machine file: --set tool.N.length_mm=…, radius_mm, x_mm; work systems: L2",
    ),
    **{f"unsupported:L{each}": _D_OFFSET for each in (12, 13)},
    "unsupported:H": (
        "controls differ in when G10 counts that changes a tool while a length (G43) is in force",
        "put G49 before G10, and G43 H behind it",
    ),
    "unsupported:R": (
        "R turns a work system by G10 L2 alone, in LinuxCNC's language, and on no lathe",
        "G10 L2 P… R…; where the program is Fanuc's, G68 X0 Y0 R…",
    ),
    "unsupported:G91": _NOT_IN_A,
    "unsupported:G95": _NOT_IN_A,
    **{f"unsupported:G{code}": _POCKET for code in (12, 13, 150)},
    "unsupported:G92": (
        "G92 limits the spindle's speed (with S) on Fanuc's lathes alone",
        "limit the speed by --set spindle.rpm_max=…; where the zero is to be shifted: "
        "--set dialect.system=B, or --dialect linuxcnc for a program made for RS274NGC",
    ),
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
        "R{value} is shorter than half of the chord, {limit:.4f}",
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
        "tool {value} is not in the tool table",
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
        "an expression without a value: it divides by zero, or a function has none for {value}",
        "check the parameters that it is made of",
    ),
    "parameter-unset": (
        "the named parameter was never set",
        "set it before, or ask for it by EXISTS[#<name>]",
    ),
    "parameter-unset:own": (
        "the program asks what LinuxCNC alone knows (its files, HAL, a mode, its version)",
        "write the number in its place",
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
        "add the line (N…) or the subprogram (O…) to the same file, or say which folder has its "
        "file: --programs DIR",
    ),
    "flow": (
        "a control word without its other end",
        "every sub, if, while, repeat, do and DO needs its end, with the same number",
    ),
    "no-seek": (
        "a jump backward in text that is only pushed",
        "give the kernel the text to read (nck_read)",
    ),
    "alarm": ("the program stops with alarm {value} (#3000)", "see the remark on its line"),
    "abort": ("the program stops here: {remark}", "(abort, …) ends it, as LinuxCNC does"),
    "endless:J": (
        "the program has gone back {limit:.0f} times",
        "check the condition of its loop: it seems never to end",
    ),
    "endless": (
        "{limit:.0f} lines were read and no block came",
        "a loop without a move never ends: check its condition",
    ),
    "label-missing:N": (
        "the program never comes to line {value:.0f}, where it is to begin",
        "choose a line that is executed",
    ),
    "flow:M72": (
        "M72, and neither M70 nor M73 has kept a state in this call",
        "say M70 (or M73 in a subprogram) before it",
    ),
    "call-depth:M": (
        "states are kept in more calls than {limit:.0f}",
        "restore or forget them (M72, M71) before",
    ),
    "mode-stays": (
        "{found} chooses how the control smooths or looks ahead; here the path's tolerance holds",
        "say what it means on this machine: --set g.{key_of_g}.action=ignore, or "
        "g.{key_of_g}.action=tolerance and g.{key_of_g}.tolerance_mm=0.01",
    ),
    **{f"mode-stays:G{code}": _PROBES for code in (29, 30, 34, 35, 80)},
    **{f"mode-stays:G{code}": _OWN_WAYS for code in (12, 26, 27)},
    **{f"mode-stays:G{code}": _RETRACTS for code in (10, 11)},
    "limits-stay": (
        "M201 to M205 change limits of a printer's firmware: here the machine's hold",
        "set them in the machine file, as in --set axis.x.a_max_mm_s2=1000",
    ),
    "assumed-length": (
        "the machine file has no tools: 0 is taken for length and radius of tool {value:.0f}, and "
        "of all",
        "to say it: [tool.{value:.0f}] in the machine file, or a tool table: --tools tool.tbl",
    ),
    "assumed-clock": (
        "#{value:.0f} asks what day or time it is: it is taken to be 2000-01-01 00:00:00 all along",
        'to say it: --set dialect.clock="2030-12-31 23:59:59"',
    ),
    "timer-read": (
        "#3001 and #3002 know no moves, since lines are read ahead of them: #3001 counts a "
        "millisecond each time it is read, and a wait by it is not in the time",
        "say a wait by G4 P, in milliseconds",
    ),
    "ends-off": (
        "M211 S0 lets axes leave their travel: from here on moves go where they are told to",
        "M211 S1 holds them again",
    ),
    "feed-kept": (
        "{found} is no feed: Marlin does not hear it, and the one before stays",
        "say a feed, or leave F out: Klipper ends a print there",
    ),
    "own-left": (
        "M{value}, of the machine's own, stands before the line that is begun at: it is not done "
        "on the way there, nor is all like it",
        "do by hand what the line needs of it; or if its effect stays: --set m.{value}.stays=true",
    ),
    **{f"no-motion:G{code}": _RING for code in (70, 71)},
    **{f"unsupported:G{code}": _MACH_UNITS for code in (70, 71)},
    "unsupported:G72": (
        "G72 of Haas drills a row of holes, and no manual says whether one is where it begins",
        "say the row by steps: G91 X… Y… L…, or its holes by X and Y",
    ),
    "travel-end": (
        "{letter} was to reach {value:.3f} mm: it stays at {limit:.3f}, where its travel ends, as "
        "Marlin has it, and so does all like it",
        "if the machine has more travel: --set axis.{axis}.{end}_{unit}=…",
    ),
    "speed-clipped": (
        "{found} is above spindle.rpm_max: grbl clips it there, and so are all like it",
        "if the spindle has more: --set spindle.rpm_max=…{own_key}",
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
        "G90, G92 and G94 are read as cycles (Fanuc's G-code system A)",
        "if that is wrong: --set dialect.system=B (or C); if it is right, A says so",
    ),
    "assumed-peck": (
        "pecks of G83 and G87 go back by 0.254 mm, as Fanuc's lathes are delivered (5101 bit 2: 0)",
        "where that bit is 1, each goes out to R, and takes longer: write its moves by G1 and G0",
    ),
    "assumed-feed-mode": (
        "F is read per revolution, as Fanuc's lathes begin: no G98 or G99 (systems B and C: G94 or "
        "G95) stands before it",
        "if that is wrong: --set dialect.feed=per_minute; if it is right, per_rev says so",
    ),
    "assumed-integers": (
        "numbers without a point are read in mm, inches, degrees or seconds: X100 is 100.0",
        "if that is wrong: --set dialect.integers=increments; if it is right, units says so",
    ),
    "assumed-units": ("no G20 or G21 before the first motion: {units} assumed", ""),
    "assumed-plane": ("no G17, G18 or G19 before the first arc or cycle: G{plane} assumed", ""),
    "assumed-distance": ("no G90 or G91 before the first motion: absolute (G90) assumed", ""),
    "assumed-centre": ("no G90.1 or G91.1 before I J K: {arc_centre} centres assumed", ""),
    "no-tolerance:P": (
        "P is {value} mm, and within less than 0.0001 mm nothing is smoothed: the path is exact",
        "G61 says so; else give a P of 0.0001 mm or more, as in G64 P0.01",
    ),
    "no-tolerance:G": (
        "under the slope {slope} the path is exact, whatever P",
        "--set path.slope=optimal smooths within P; where the path is to be exact, G61 says so",
    ),
    "no-tolerance": (
        "G64 without P means the machine's tolerance, and that is 0: the path is exact",
        "give P, as in G64 P0.01, or the machine a tolerance: --set path.tolerance_mm=0.01",
    ),
    "no-end": ("the text ends without M2, M30 or a closing %", ""),
    "after-end": ("what follows the program's end is not read", "remove the text or the M2 / M30"),
    "called-from": ("called from here", ""),
    "feed-units": (
        "F beside a change of units is read in the units {feed_units}",
        "put G20 or G21 on a line before: LinuxCNC reads such an F in the units before the line, "
        "other controls in those of its line",
    ),
    **MOTION,
}
