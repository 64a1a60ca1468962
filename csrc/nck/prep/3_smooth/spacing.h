// SPDX-License-Identifier: MIT
// Inside room 3: how far apart the knots may be.
#ifndef NCK_PREP_SPACING_H
#define NCK_PREP_SPACING_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t

// 1 if the spacing that a block's end allows is found. Cost: constant.
static inline int nck_spacing_is_known(const nck_raw_t *raw) {
    return raw->spacing > 0.0 && raw->lacks == NCK_LACKS_NOTHING;
}

// Find the spacing that the end of a block of the run allows, where it is not known; and whether
// its corner is a key, or faster with a stop: then the run ends there.
// Returns NCK_OK; NCK_EMPTY if more blocks must be known; NCK_FULL beside an arc: call again.
// Cost: 4 · 48 points; at a sharp corner some 100 square roots, beside an arc in a call of their
// own.
nck_status_t nck_spacing_know(nck_smooth_t *self, uint32_t count);

#endif
