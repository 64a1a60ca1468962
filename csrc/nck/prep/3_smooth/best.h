// SPDX-License-Identifier: MIT
// Inside room 3: the fastest curve of a window's rounds. Clock and curve may take turns, so that of
// the last round is not always it. Cost: linear in knots. Context: prep.
#ifndef NCK_PREP_BEST_H
#define NCK_PREP_BEST_H

#include "nck/prep/3_smooth/stream.h" // nck_stream_t

// Keep the curve in work, which has a plan, where there is room (NCK_HAS_FASTEST).
void nck_best_keep(nck_stream_t *self);

// Put the one that is kept in the place of the curve in work; none is kept then.
void nck_best_take(nck_stream_t *self);

// 1 if one is kept that takes less time than the curve in work, as far as both windows reach.
int nck_best_is_faster(const nck_stream_t *self);

#endif
