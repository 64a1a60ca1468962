// SPDX-License-Identifier: MIT
// G76 and G87 of Fanuc's mills, as the other drilling cycles see them.
#ifndef NCK_PREP_DECODE_CYCLE_BORE_H
#define NCK_PREP_DECODE_CYCLE_BORE_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// Whether a motion in tenths is one of them. Cost: constant.
int nck_bore_has(const nck_decode_t *self, int32_t motion);

// By how much the tool steps aside: Q along the first axis of the plane, or I and J. Returns
// NCK_OK, NCK_E_WORD_MISSING, NCK_E_WORD_UNUSED, NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_bore_shift(nck_decode_t *self);

// Is a boring tool within the travel where it stands aside of the first and the last hole?
// NCK_E_TRAVEL. Cost: constant.
nck_status_t nck_bore_fits(nck_decode_t *self, const int64_t *last_nm);

// The next part of a hole: what nck_decode_cycle gives, or NCK_EMPTY. Returns 1 behind the last
// one. Cost: constant.
int nck_bore_step(nck_decode_t *self, nck_status_t *status_out, nck_block_t *out);

#endif
