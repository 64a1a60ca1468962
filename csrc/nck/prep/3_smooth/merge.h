// SPDX-License-Identifier: MIT
// Inside room 3: G64 Q, nearly collinear lines become one block.
#ifndef NCK_PREP_MERGE_H
#define NCK_PREP_MERGE_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t

// Join a line to the newest block, if that is a line of the same feed and tolerance, not used yet,
// and the path stays within Q and a twentieth of P. What it leaves the path by is taken from the
// block's tolerance. Returns 1 if it was joined.
// Cost: NCK_SMOOTH_MERGE points.
int nck_merge_line(nck_smooth_t *self, const nck_block_t *block, const nck_seg_t *seg);

// The newest block of the ring begins to be one that lines can be joined to. Cost: constant.
void nck_merge_begin(nck_smooth_t *self, const nck_block_t *block);

#endif
