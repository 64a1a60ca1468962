// SPDX-License-Identifier: MIT
// Inside room 3: parts of the spline between two knots, at the ends of which words change.
#ifndef NCK_PREP_PART_H
#define NCK_PREP_PART_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t nck_raw_t

// What is no part of its own between t[2] and t[3] [path mm]: where a block ends, or something is
// output, nearer to a knot than this, the knot stands for it. Cost: constant.
double nck_part_least(const nck_smooth_t *self);

// Where the next part of the interval at t[2] … t[3] ends [path mm]: at an output, where the words
// of the program change, or where a block ends that makes much of the interval.
// Cost: as nck_raw_find, and linear in the blocks of the part.
double nck_part_end(nck_smooth_t *self);

// The same no further than `end`, for a spline that the tool passes unevenly; and |dp/ds| there
// where it is largest. Cost: 9 tangents for each of four parts at most.
double nck_part_even(nck_smooth_t *self, const nck_seg_t *spline, double end,
                     double *stretch_out);

// The block that a part ends in, or with: its words are those of it. Cost: as nck_raw_find.
const nck_raw_t *nck_part_raw(nck_smooth_t *self, double end);

#endif
