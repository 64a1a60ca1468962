// SPDX-License-Identifier: MIT
// The moves along a contour, and every other move of the cycles on one.
#ifndef NCK_PREP_DECODE_LATHE_FOLLOW_H
#define NCK_PREP_DECODE_LATHE_FOLLOW_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// Where the tool is: [0] along a, [1] along d. Cost: constant.
void nck_follow_place(const nck_decode_t *self, double *out);

// A move to a place; NCK_EMPTY: the tool is there. Cost: constant.
nck_status_t nck_follow_go(nck_decode_t *self, nck_block_kind_t kind, double a, double d,
                           nck_block_t *out);

// Where the way along the contour begins. Cost: constant.
void nck_follow_begin(const nck_decode_t *self, double *place_out);

// The next block of a phase from NCK_ROUGH_BESIDE on. NCK_EMPTY: it had none to give. Cost: linear
// in the contour.
nck_status_t nck_follow_next(nck_decode_t *self, nck_block_t *out);

#endif
