// SPDX-License-Identifier: MIT
// What the files of this wing call of each other, and nobody else. Context of all: prep.
#ifndef NCK_PREP_DECODE_LATHE_PARTS_H
#define NCK_PREP_DECODE_LATHE_PARTS_H

#include "nck/prep/1_decode/lathe/lathe.h"

// Places of a cycle have two coordinates: X, Z. Cost: constant.
static inline unsigned nck_lathe_axis(unsigned k) { return k == 0 ? NCK_AXIS_X : NCK_AXIS_Z; }

// ---- contour.c

// The lines that follow are a contour's, for the cycle of that code. Cost: constant.
void nck_contour_begin(nck_decode_t *self, nck_contour_mode_t mode, uint32_t code);

#endif
