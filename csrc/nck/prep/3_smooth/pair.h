// SPDX-License-Identifier: MIT
// Inside room 3: two sharp corners that are nearer to each other than their bends are wide.
#ifndef NCK_PREP_PAIR_H
#define NCK_PREP_PAIR_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t

// 1 if the corner at a block's end and the next one share a bend, and nothing beside them turns:
// even knots about their middle, with control points on the path, may be *spacing_out apart
// [path mm] within the aim [mm]. That is the corner's own spacing before.
// Cost: 46 points of the path at most, none where the block between is long or turns little.
int nck_pair_find(nck_smooth_t *self, uint32_t count, double aim, double *spacing_out);

#endif
