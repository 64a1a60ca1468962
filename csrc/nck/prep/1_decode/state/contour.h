// SPDX-License-Identifier: MIT
// Contours that G70 … G73 read, and the cycle that works on one.
//
//     G71 … ─▶ lines P … Q ─▶ elements ─▶ levels, passes ─▶ a block a pull
//              or a subprogram           (level.c)         (rough.c)
//              (decoded as ever, nothing moves)
#ifndef NCK_PREP_DECODE_STATE_CONTOUR_H
#define NCK_PREP_DECODE_STATE_CONTOUR_H

#include <stdint.h> // int64_t

#include "nck/base/limits.h" // NCK_AXIS_MAX NCK_CONTOUR_ROWS

// Motions in tenths, by the names of Fanuc's systems A and B; RS274NGC adds .1 and .2.
enum {
    NCK_MOTION_FINISH = 700, NCK_MOTION_ROUGH = 710, NCK_MOTION_FACE_ROUGH = 720,
    NCK_MOTION_PATTERN = 730
};

// How far Fanuc's and RS274NGC's cuts are lifted before they go back if nobody says.
enum { NCK_ROUGH_RETRACT_NM = 500000 };

// The phases of a cycle; 0: none is in work.
enum {
    NCK_ROUGH_BEGIN = 1, NCK_ROUGH_START, NCK_ROUGH_LEVEL, NCK_ROUGH_RISE, NCK_ROUGH_ACROSS,
    NCK_ROUGH_DOWN, NCK_ROUGH_PLUNGE, NCK_ROUGH_CUT, NCK_ROUGH_BACK, // of a level, rough.c
    NCK_ROUGH_BESIDE, NCK_ROUGH_SIDE, NCK_ROUGH_BEFORE, NCK_ROUGH_ENTER, NCK_ROUGH_FOLLOW,
    NCK_ROUGH_LEAVE, NCK_ROUGH_OUT, NCK_ROUGH_OVER, NCK_ROUGH_HOME, NCK_ROUGH_SHIFT,
    NCK_ROUGH_COPY, NCK_ROUGH_PHASES // along the contour, follow.c
};

// What happens to the lines of a contour.
typedef enum nck_contour_mode {
    NCK_CONTOUR_NOT = 0,   // there is none
    NCK_CONTOUR_READS = 1, // they are recorded
    NCK_CONTOUR_RUNS = 2,  // they are done: G70 P Q
    NCK_CONTOUR_LINES = 3, // either
    NCK_CONTOUR_CORNER = 4 // beside these: a corner is in work, corner.c
} nck_contour_mode_t;

// A line or an arc. [0]: X, [1]: Z.
typedef struct nck_element {
    int64_t to_nm[2];    // where it ends, machine position
    double centre_mm[2]; // of an arc, machine position
    double sweep_rad;    // of an arc, as a block has it; 0: a line
} nck_element_t;

// The contour: what is recorded, and what holds again behind it.
typedef NCK_CYCLE_STATE nck_contour {
    nck_element_t element[NCK_CONTOUR_ROWS]; // the first one leads from the start to the contour
    uint32_t count;          // of them
    uint32_t mode;           // bits of nck_contour_mode_t
    uint32_t code;           // of the cycle, in tenths
    uint32_t line;           // of the cycle
    uint32_t called;         // frames while the subprogram is in force; 0: lines first … last
    uint32_t begun;          // 1: its first line was read
    uint32_t broken;         // 1: a line of it was refused
    uint32_t rapid;          // 1: the first element is a rapid
    uint32_t falls;          // 1: the contour goes down somewhere: it has a pocket
    uint32_t one_way;        // 1: Fanuc's type I: it must not
    uint64_t first, last;    // N of its lines
    int64_t corner_nm;       // of the corner behind the last element: > 0 a fillet, < 0 a chamfer
    int64_t next_corner_nm;  // of the line in work
    int64_t from_nm[NCK_AXIS_MAX];  // where the axes stand
    int64_t start_nm[NCK_AXIS_MAX]; // where the cycle begins and ends
    struct {
        double feed, feed_word;
        int32_t motion;
        uint8_t incremental, centre_absolute, feed_mode, excused;
    } kept;                  // of the modes
} nck_contour_t;

// A cycle on a contour. Inside, a runs along the cuts, d against their depth, both [mm] from where
// the cycle begins.
typedef NCK_CYCLE_STATE nck_rough {
    int64_t depth_nm, retract_nm; // Fanuc's first line of G71, G72: they hold; depth 0: never said
    int64_t pattern_nm[2];        // of G73: X, Z
    uint32_t patterns;            // how many; 0: never said

    uint8_t phase;           // NCK_ROUGH_…; 0: none in work
    uint8_t along;           // which of X Z is a: 0, 1
    int8_t sign[2];          // of a and d along their axes; 0: not known yet
    uint8_t is_first, is_pocket; // 1: the stretch next to the start is cut; those behind it are
    uint8_t follows;         // 1: towards the contour itself, no more levels
    uint32_t level, levels;  // the one in work, from 1, and how many
    uint32_t pass, passes;   // along the contour
    uint32_t element, part;  // of the contour: the next one
    double depth, retract;   // [mm]
    double spare, spare_step; // distance from the contour; of every pass less [mm]
    double shift_mm[2];      // of the contour: X, Z
    double spare_mm[2];      // of it, what stays behind the last copy of G73
    double bottom, highest;  // of the tool, along d
    double begin, end;       // of the stretch in work, along a
    double top;              // how high the contour was so far
    double reach;            // how far along a it goes
    double feed;             // as a block has it
} nck_rough_t;

// A part of a contour that rises or falls all along.
typedef struct nck_slant {
    double a[2], d[2]; // its ends
    double ca, cd, r;  // circle; r 0: a line
    double turn;       // +1: from a towards d, −1
} nck_slant_t;

#endif
