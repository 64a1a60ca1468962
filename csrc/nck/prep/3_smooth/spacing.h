// SPDX-License-Identifier: MIT
// Inside room 3: how far apart the knots may be.
#ifndef NCK_PREP_SPACING_H
#define NCK_PREP_SPACING_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t

// The spacing of knots that the inside of an exact seg allows. Cost: constant.
double nck_spacing_inside(const nck_smooth_t *self, const nck_seg_t *seg, double tolerance);

// Find the spacing that the end of a block of the run allows, once; and whether its corner is a
// key, or faster with a stop: then the run ends there.
// Returns NCK_OK, or NCK_EMPTY if more blocks must be known.
// Cost: 3 · 68 points and, at a sharp corner, some 100 square roots.
nck_status_t nck_spacing_know(nck_smooth_t *self, uint32_t count);

#endif
