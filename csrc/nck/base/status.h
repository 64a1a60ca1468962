// SPDX-License-Identifier: MIT
// Status codes: zero is good, positive is "not now", negative is an error with a stable id.
#ifndef NCK_BASE_STATUS_H
#define NCK_BASE_STATUS_H

#include <stdint.h> // int32_t uint32_t

#ifdef __cplusplus
extern "C" {
#endif

// What a call returns.
typedef enum nck_status {
    NCK_OK = 0,       // done, or one bounded piece of work done
    NCK_EMPTY = 1,    // nothing to take: the producer must go first
    NCK_FULL = 2,     // no room: the consumer must go first
    NCK_DONE = 3,     // the program has ended and everything is handed over
    NCK_WAIT = 4,     // stopped by M0, M1, M6 or M60: nck_resume goes on

    // program errors (1_decode, 2_toolcomp): line and column are in nck_diagnostic_t; behind each:
    // its id, and what it means; "value", "limit" and "letter" are what the diagnostic carries
    NCK_E_CHARACTER = -1,     // "character": a character that starts no word
    NCK_E_NUMBER = -2,        // "number": a word without a readable number
    NCK_E_NUMBER_RANGE = -3,  // "number-range": outside of what its word takes; value = number
    NCK_E_LINE_LENGTH = -4,   // "line-length": longer than NCK_LINE_MAX; value = NCK_LINE_MAX
    NCK_E_COMMENT = -5,       // "comment": a comment that is not closed
    NCK_E_WORD_UNKNOWN = -6,  // "word-unknown": a letter that the language does not have
    NCK_E_WORD_TWICE = -7,    // "word-twice": a letter twice in one block
    NCK_E_WORD_UNUSED = -8,   // "word-unused": a word that no code of its block uses
    NCK_E_WORD_MISSING = -9,  // "word-missing": a code without a word it needs; letter
    NCK_E_G_UNKNOWN = -10,    // "g-unknown": a G code that the kernel does not know; value
    NCK_E_M_UNKNOWN = -11,    // "m-unknown": an M code that the kernel does not know; value
    NCK_E_MODAL_GROUP = -12,  // "modal-group": two codes of one modal group in a block
    NCK_E_UNSUPPORTED = -13,  // "unsupported": of the language, but not built, or left out of this
                              // build; of a machine: a slope that is left out
    NCK_E_FEED_MISSING = -14, // "feed-missing": a cut before any F, or G93 without its F; again
                              // only behind another word about feed or spindle
    NCK_E_ARC_RADIUS = -15,   // "arc-radius": value = end radius, limit = start radius [mm]
    NCK_E_ARC_CENTRE = -16,   // "arc-centre": no centre, or a radius of zero
    NCK_E_ARC_CHORD = -17,    // "arc-chord": R below half of the chord; value, limit [mm]
    NCK_E_AXIS_UNKNOWN = -18, // "axis-unknown": a word of an axis that the machine lacks; letter
    NCK_E_TRAVEL = -19,       // "travel": leaves the travel; letter, value, limit [mm or deg]
    NCK_E_TOOL_UNKNOWN = -20, // "tool-unknown": T or H not in the table; value = number
    NCK_E_NO_MOTION = -21,    // "no-motion": axis words, but no motion mode is in force (G80)
    NCK_E_DIALECT = -22,      // "dialect": a known foreign dialect; value = nck_dialect_hint_t
    NCK_E_BINARY = -23,       // "binary": a NUL byte: this is no NC program
    NCK_E_NO_PROGRAM = -24,   // "no-program": the text holds no block at all
    NCK_E_WORD_SHARED = -25,  // "word-shared": a word that two codes of its block would use; letter
    NCK_E_INCREMENTAL = -26,  // "incremental": G53 while G91 is in force
    NCK_E_ARC_MODE = -27,     // "arc-mode": as arc-radius, but on its circle if I J K counted the
                              // other way; letter 'A': from the zero (G90.1), 'I': from the start
    NCK_E_EXPRESSION = -28,   // "expression": an expression or control word that cannot be read
    NCK_E_VALUE = -29,        // "value": no such value: a division by 0, a root of −1; value
    NCK_E_UNSET = -30,        // "parameter-unset": a named parameter that was never set
    NCK_E_VARIABLES = -31,    // "parameters-full": more of them than NCK_VARIABLES = limit
    NCK_E_DEPTH = -32,        // "call-depth": more calls and loops than NCK_CALL_DEPTH = limit
    NCK_E_LABEL = -33,        // "label-missing": nothing in the text where a jump or call is to go
                              // to; value = its number (0: a name)
    NCK_E_FLOW = -34,         // "flow": the end of what has no beginning here, or no end of it
    NCK_E_NO_SEEK = -35,      // "no-seek": a jump backward in text that can only be pushed
    NCK_E_ALARM = -36,        // "alarm": the program says so (#3000); value = number
    NCK_E_ENDLESS = -37,      // "endless": limit lines read, and no block came; letter J: limit
                              // jumps backward
    NCK_E_SPEED_LIMIT = -38,  // "speed-limit": G96 without a most of the spindle's speed; letter:
                              // of the word that would say it
    NCK_E_THREAD_SPEED = -39, // "thread-speed": lead times speed is beyond an axis; value, limit
                              // [mm/s]; letter 'G': under G96, 'S': the spindle stands
    NCK_E_THREAD_RUN_IN = -51, // "thread-run-in": a pass shorter than its run-in and its run-out;
                              // value: both, limit: the pass [mm]
    NCK_E_COMP_ON = -52,      // "comp-on": not while G41 or G42 is in force; value = the code
    NCK_E_COMP_PLANE = -53,   // "comp-plane": a nose that points somewhere, outside of G18;
                              // value = orientation
    NCK_E_COMP_ENTRY = -54,   // "comp-entry": the first move behind G41 or G42 is no longer (an
                              // arc: no larger) than the tool's radius; value, limit [mm]
    NCK_E_COMP_EXIT = -55,    // "comp-exit": the first move behind G40 is an arc
    NCK_E_COMP_RADIUS = -56,  // "comp-radius": the tool does not fit into an arc; value = the
                              // tool's radius, limit = the arc's [mm]
    NCK_E_COMP_GOUGE = -57,   // "comp-gouge": the tool would cut into another part of the contour;
                              // value = how deep [mm], limit = the other line
    NCK_E_CONTOUR = -58,      // "contour": what cannot be in the contour of G70 to G73, or cannot
                              // be cut; letter and value: which word; X, Z: turns back along it
    NCK_E_CONTOUR_FULL = -59, // "contour-full": more lines and arcs than NCK_CONTOUR = limit

    NCK_E_LAYOUT_ON = -61,    // "layout-on": not while G16, G51, G51.1 or G68 is in force; letter
                              // G: value = the code; none: an arc, value 1: with its centre from
                              // the zero; else an axis
    NCK_E_SCALE_UNIT = -62,   // "scale-unit": G51 with a factor that has no point; letter, value

    NCK_E_SPLINE = -63,       // "spline": letter G: value = 5.2, 6.2: it is not ended, 5.3: it was
                              // not begun, else the plane; M: value = 5.2, 6.2: the program ends
                              // before it; L: value points, limit wanted; else an axis that does
                              // not move on splines

    NCK_E_CORNER = -64,       // "corner": ,R or ,C does not fit between its two moves, or one of
                              // them is none; letter, value [mm]

    NCK_E_PROBE = -65,        // "probe": G38.2 or G38.4, and nothing is touched; value = the code,
                              // 95: under G95; letter X: it has no way to go

    NCK_E_APPROACH = -70,     // "approach": no height is known for the way to where a program
                              // begins in the middle; letter: of its axis, value = the line
    NCK_E_OTHER_BASE = -71,   // "other-base": not of the language that is read; letter, value: the
                              // word (0: a control word); limit = whose it is (nck_tongue_t)

    // the front door
    NCK_E_ARGUMENT = -40, // "argument": an argument outside of its range
    NCK_E_MACHINE = -41,  // "machine": a machine number outside of its range
    NCK_E_STATE = -42,    // "state": not possible in this state

    // what must not happen, and is told all the same
    NCK_E_INTERNAL = -60   // "internal": an invariant is broken
} nck_status_t;

// Notes: assumed defaults and the like. Not errors; at most one of each in a program, but for
// NCK_NOTE_CALLED, NCK_NOTE_COMP_LEFT, NCK_NOTE_COMP_WAY and, of each code one, NCK_NOTE_MODE.
typedef enum nck_note {
    NCK_NOTE_UNITS = 1,      // "assumed-units": motion before G20 or G21
    NCK_NOTE_PLANE = 2,      // "assumed-plane": an arc before G17, G18 or G19
    NCK_NOTE_DISTANCE = 3,   // "assumed-distance": motion before G90 or G91
    NCK_NOTE_ARC_CENTRE = 4, // "assumed-centre": I J K before G90.1 or G91.1
    NCK_NOTE_NO_END = 5,     // "no-end": the text ends without M2, M30 or a closing %
    NCK_NOTE_AFTER_END = 6,  // "after-end": text after M2 or M30 is not read
    NCK_NOTE_FEED_UNITS = 7, // "feed-units": F beside a G20 or G21 that changes the units
    NCK_NOTE_TOLERANCE = 8,  // "no-tolerance": the path is exact under G64: P, letter and value
                             // [mm], or without P the machine's tolerance is below 0.1 µm, or
                             // (letter G) the slope or the build smooths nothing
    NCK_NOTE_CALLED = 9,     // "called-from": behind an error, once for every call in force: where
    NCK_NOTE_COMP_LEFT = 10, // "comp-left": the tool does not come to the contour between the line
                             // and line `limit`; value = material left there at most [mm]
    NCK_NOTE_COMP_WAY = 16,  // "comp-way": the first move under radius compensation, or the one
                             // behind G40, is in the contour of line `limit` where that begins or
                             // ends; value = so deep [mm]
    NCK_NOTE_REPEATS = 12,   // "repeats": M99 in the main program, which is done once
    NCK_NOTE_SYSTEM = 11,    // "assumed-system": a turning cycle of system A, which nobody said
    NCK_NOTE_LIMITS = 14,    // "limits-stay": M201 … M205 of a printer: the machine's limits hold
    NCK_NOTE_FEED_MODE = 13, // "assumed-feed-mode": F of a lathe before its G98 or G99
    NCK_NOTE_ABORT = 20,     // "abort": (abort, …) ends the program; column: of its text
    NCK_NOTE_MODE = 17,      // "mode-stays": a code chooses how the control smooths or looks
                             // ahead, or moves what no text tells, and the machine does not say
                             // what that means; letter G, value: the code
    NCK_NOTE_CLIPPED = 18,   // "speed-clipped": S is more than the spindle has: grbl clips it
    NCK_NOTE_FEED_KEPT = 19, // "feed-kept": F0 or a negative F, which a printer does not hear
    NCK_NOTE_CLAMPED = 22,   // "travel-end": a printer's axis stays at the end of its travel;
                             // letter, value: where it was to go, limit [mm]
    NCK_NOTE_OWN_LEFT = 23,  // "own-left": an M code of the machine's own before the line that is
                             // begun at is not done; letter M, value: the code
    NCK_NOTE_ENDS_OFF = 26,  // "ends-off": M211 S0 of a printer: no axis is held within its travel
    NCK_NOTE_CLOCK = 24,     // "assumed-clock": a program asks for the date or the time of day, and
                             // nobody has said it; letter #, value: which one
    NCK_NOTE_TIMER = 25,     // "timer-read": a program asks for #3001 or #3002 (value), which know
                             // no moves, since lines are read ahead of them
    NCK_NOTE_PECK = 27,      // "assumed-peck": a lathe's G83 or G87 goes back a little from peck to
                             // peck
    NCK_NOTE_LENGTH = 21,    // "assumed-length": H of a machine without a tool table is 0
    NCK_NOTE_INTEGERS = 15   // "assumed-integers": a length, angle or dwell of Fanuc's has no point
} nck_note_t;

// One finding in a program. Wording is the caller's; ids and numbers are the kernel's.
typedef struct nck_diagnostic {
    int32_t code;    // negative: nck_status_t; positive: nck_note_t; nck_diagnostic_id names both
    uint32_t line;   // 1-based source line
    uint32_t column; // 1-based byte column; 0: the whole line
    int32_t letter;  // the word's letter in upper case, 0 if none
    double value;    // the offending number (see the code)
    double limit;    // what it was held against
} nck_diagnostic_t;

// The stable id of a status that a call returns ("arc-radius"; "ok" and the like for
// non-errors), never NULL.
// Cost: linear in the number of codes. Context: any.
const char *nck_status_id(int32_t status);

// The stable id of what a diagnostic's code says, a status below zero or a note above it
// ("assumed-units"), never NULL. Cost and context as above.
const char *nck_diagnostic_id(int32_t code);

#ifdef __cplusplus
}
#endif

#endif
