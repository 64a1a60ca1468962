// SPDX-License-Identifier: MIT
// G70 and G71 of Haas' mills, as the other drilling cycles see them.
#ifndef NCK_PREP_DECODE_CYCLE_RING_H
#define NCK_PREP_DECODE_CYCLE_RING_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// A line of G70 or G71: is it good in the cycle in force? Sets what it says of the ring, and how
// many holes there are; from then on the line is one of that cycle. Returns NCK_OK, for any other
// line, too; NCK_EMPTY behind a cycle that is refused; NCK_E_NO_MOTION, NCK_E_LAYOUT_ON,
// NCK_E_WORD_MISSING, NCK_E_WORD_UNUSED, NCK_E_NUMBER_RANGE, NCK_E_UNSUPPORTED. Cost: constant.
nck_status_t nck_ring_begin(nck_decode_t *self, int64_t *count_out);

// The first hole about the place that cycle.hole_nm has, and the last one; each is looked at.
// NCK_E_TRAVEL, NCK_E_NUMBER_RANGE. Cost: linear in the holes.
nck_status_t nck_ring_place(nck_decode_t *self, int64_t count, int64_t *last_nm);

// The next hole. Cost: constant.
void nck_ring_next(nck_decode_t *self);

#endif
