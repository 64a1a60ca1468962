// SPDX-License-Identifier: MIT
// What the files of this wing call of each other, and nobody else. Context of all: prep.
#ifndef NCK_PREP_DECODE_LATHE_PARTS_H
#define NCK_PREP_DECODE_LATHE_PARTS_H

#include "nck/prep/1_decode/lathe/lathe.h"

// ---- contour.c

// The lines that follow are a contour's, for the cycle of that code. Cost: constant.
void nck_contour_begin(nck_decode_t *self, nck_contour_mode_t mode, uint32_t code);

#endif
