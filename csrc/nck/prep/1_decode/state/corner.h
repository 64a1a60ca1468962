// SPDX-License-Identifier: MIT
// Corners that ,R rounds, ,C cuts off, and angles alone say: a move waits until the one behind it
// is known.
#ifndef NCK_PREP_DECODE_STATE_CORNER_H
#define NCK_PREP_DECODE_STATE_CORNER_H

#include "nck/base/limits.h"          // NCK_CYCLE_STATE
#include "nck/base/records.h"         // nck_block_t
#include "nck/prep/1_decode/state/number.h" // nck_number_t

// How far a corner is.
typedef enum nck_corner_phase {
    NCK_CORNER_NOT = 0,   // none is in work
    NCK_CORNER_WAITS = 1, // `held` is the move before it
    NCK_CORNER_JOINS = 2, // `held` is the corner, `next` the move behind it
    NCK_CORNER_ENDS = 3   // `next` is to be given
} nck_corner_phase_t;

// The word of a corner.
typedef struct nck_corner_word {
    nck_number_t number;
    uint16_t column;
    char letter;    // R or C, of lathes I or K too, A: ,A alone; 0: the line has none
    uint8_t is_open; // 1: the line has ,A alone
    uint8_t is_old; // 1: without a comma: its sign says which way the next move goes
} nck_corner_word_t;

// All of it.
typedef NCK_CYCLE_STATE nck_corner {
    nck_corner_word_t word;  // of the line in work
    nck_block_t held, next;
    int64_t from_nm[NCK_AXIS_MAX]; // where the latest move begins, machine position
    int64_t end_nm[NCK_AXIS_MAX];  // where `next` ends, machine position
    double size;             // [mm], signed if is_old
    double slant[2];         // of `held`, if that is open, and of `next` [rad]
    uint32_t later;          // steps of the line that follow the corner
    uint32_t line;           // of the word, as findings call it
    uint16_t column;
    char letter;
    uint8_t is_old;
    uint8_t is_open;         // 1: `held` has an angle alone, 2: and `next` has said where it ends
    uint8_t is_missed;       // 1: an error has taken it: the line behind it may say too much
    uint8_t phase;           // nck_corner_phase_t
} nck_corner_t;

#endif
