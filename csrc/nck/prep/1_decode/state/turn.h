// SPDX-License-Identifier: MIT
// Lathes that speak Fanuc's language: its three G-code systems, U V W, and the turning or pecking
// cycle in work.
#ifndef NCK_PREP_DECODE_STATE_TURN_H
#define NCK_PREP_DECODE_STATE_TURN_H

#include <stdint.h> // int64_t

#include "nck/base/limits.h" // NCK_CYCLE_STATE

// Motions in tenths, whatever a system calls them: those are system B's names.
enum {
    NCK_MOTION_TURN = 770, NCK_MOTION_FACE = 790,
    NCK_MOTION_PECK_Z = 740, NCK_MOTION_PECK_X = 750 // G74, G75
};

enum { NCK_LATHE_TOOLS = 100 }; // T0202: the tool 02 and, in the last two digits, its offset

// A turning or facing cycle. [0]: X, [1]: Z.
typedef NCK_CYCLE_STATE nck_turn {
    int64_t end_nm[2];     // where the cut ends as last said, program coordinates
    int64_t taper_nm;      // R: how far from there the cut begins, along its first move
    int64_t corner_nm[3][2]; // begin and end of the cut, and behind it; machine positions
    int64_t start_nm[2];   // where the cycle begins and ends; machine position
    double feed;           // as a block has it
    uint8_t said;          // letters that hold: bit 0 X, bit 1 Z
    uint8_t left;          // moves that are left; 0: none in work
} nck_turn_t;

// Cuts along Z or X with pecks, row beside row. [0]: X, [1]: Z; machine positions.
typedef NCK_CYCLE_STATE nck_peck {
    int64_t back_nm;       // R: how far it goes back after a peck, as last said
    int64_t start_nm[2];   // where the cycle begins and ends
    int64_t end_nm[2];     // the corner across from there
    int64_t step_nm[2];    // depth of a peck and distance of rows, in their axes
    int64_t cut_nm;        // how far the row is cut
    double feed;           // as a block has it
    uint8_t along;         // the axis that it pecks along: 0 X, 1 Z
    uint8_t phase;         // of the row in work, peck.c; 0: no cycle in work
} nck_peck_t;

#endif
