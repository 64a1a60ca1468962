// SPDX-License-Identifier: MIT
// The moves of G70 … G73 on a contour that is recorded, or done.
#ifndef NCK_PREP_DECODE_LATHE_ROUGH_H
#define NCK_PREP_DECODE_LATHE_ROUGH_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// The next block of the cycle in work; the first call checks contour and travel. NCK_EMPTY: it is
// done. NCK_E_CONTOUR, NCK_E_NUMBER_RANGE, NCK_E_TRAVEL. Cost: quadratic in the contour at worst.
nck_status_t nck_rough_next(nck_decode_t *self, nck_block_t *out);

#endif
