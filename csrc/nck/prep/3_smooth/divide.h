// SPDX-License-Identifier: MIT
// Inside room 3: segs along which the spindle's speed changes are given in pieces.
#ifndef NCK_PREP_DIVIDE_H
#define NCK_PREP_DIVIDE_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t

// 1 if the seg is to be given in pieces: it is kept. Cost: constant.
int nck_divide_begin(nck_smooth_t *self, const nck_seg_t *seg);

// The next piece of the seg that is kept. Cost: constant.
void nck_divide_next(nck_smooth_t *self, nck_seg_t *seg_out);

#endif
