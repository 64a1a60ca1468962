// SPDX-License-Identifier: MIT
// Cycles for turning: contours, roughing, pecks, threads in passes.
//
// The face of the wing: what other wings call of it. Context of all: prep.
#ifndef NCK_PREP_DECODE_LATHE_LATHE_H
#define NCK_PREP_DECODE_LATHE_LATHE_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// ---- turn.c

// The moves of a cycle for turning. Cost: constant.
nck_status_t nck_decode_turn(nck_decode_t *self, nck_block_t *out);

// ---- peck.c

// The moves of G74, G75. Cost: constant.
nck_status_t nck_decode_peck(nck_decode_t *self, nck_block_t *out);

// ---- screw.c

// The passes of a threading cycle. Cost: constant.
nck_status_t nck_decode_screw(nck_decode_t *self, nck_block_t *out);

// ---- contour.c

// Of a line of a contour: its words before they are resolved, the line behind that, a block that it
// gave, and its end: with the last line the cycle begins. status: the line's own, handed back.
// NCK_E_CONTOUR, NCK_E_CONTOUR_FULL. Cost: constant.
nck_status_t nck_contour_words(nck_decode_t *self);
nck_status_t nck_contour_check(nck_decode_t *self);
nck_status_t nck_contour_take(nck_decode_t *self, const nck_block_t *block);
nck_status_t nck_contour_behind(nck_decode_t *self, nck_status_t status);

// The text ends in the middle of a contour. NCK_E_LABEL. Cost: constant.
nck_status_t nck_contour_missing(nck_decode_t *self);

// ---- contour_cycle.c

// G70 … G73.
nck_status_t nck_decode_contour_cycle(nck_decode_t *self, nck_block_t *out);

#endif
