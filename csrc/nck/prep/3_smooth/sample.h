// SPDX-License-Identifier: MIT
// Inside room 3: where a window's curve has to be, and the proof that it is.
#ifndef NCK_PREP_SAMPLE_H
#define NCK_PREP_SAMPLE_H

#include "nck/prep/3_smooth/stream.h" // nck_stream_t

// The reference's control point k, of knots + 3: on the program at its knot; at rests and joints
// what it has to be. Cost: one point. Context: prep.
void nck_sample_reference(nck_stream_t *self, int k);

// What interval i asks of the curve: the reference's jerk, samples of four bins.
// Cost: 4 points, and linear in elements. Context: prep.
void nck_sample_interval(nck_stream_t *self, int i);

// The most that the curve is off the program in interval i, over the tolerance there: a bound.
// Cost: 5 points, 60 operations an axis and element. Context: prep.
double nck_sample_miss(nck_stream_t *self, int i);

#endif
