// SPDX-License-Identifier: MIT
// Canned cycles of drilling, boring and tapping.
//
// The face of the wing: what other wings call of it. Context of all: prep.
#ifndef NCK_PREP_DECODE_CYCLE_CYCLE_H
#define NCK_PREP_DECODE_CYCLE_CYCLE_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// ---- cycle.c

// A motion code that gives several blocks: the holes of a canned cycle; what another wing makes of
// the others. Cost: constant.
nck_status_t nck_decode_cycle(nck_decode_t *self, nck_block_t *out);

#endif
