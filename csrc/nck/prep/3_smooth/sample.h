// SPDX-License-Identifier: MIT
// Inside room 3: where a window's curve has to be, and the proof that it is.
#ifndef NCK_PREP_SAMPLE_H
#define NCK_PREP_SAMPLE_H

#include "nck/prep/3_smooth/stream.h" // nck_stream_t
#include "nck/prep/3_smooth/tuning.h" // NCK_SAMPLE_REST

// What interval i asks of the curve: the reference's jerk, samples of four bins.
// Cost: 4 points, and linear in elements. Context: prep.
void nck_sample_interval(nck_stream_t *self, int i);

// The most that the curve is off the program in interval i, over the tolerance there: a bound.
// Cost: 5 points, 60 operations an axis and element. Context: prep.
double nck_sample_miss(nck_stream_t *self, int i);

// Such a rest: control points, the last three of which are one, on the program.
typedef struct nck_sample_rest {
    double point[NCK_SAMPLE_REST + 3][NCK_AXIS_MAX];
    double place[NCK_SAMPLE_REST + 3]; // s of the program, as coefficients of the same spline
} nck_sample_rest_t;

// The rest behind its first three control points, which are given, as are three s of the program:
// at their knot and the two behind it. Each way is half as long as the one before, so it rests one
// knot on at most. Cost: 8 points. Context: prep.
void nck_sample_rest(nck_stream_t *self, const double *s, nck_sample_rest_t *rest);

// The most that its interval i is off the program, over the tolerance: a bound. Cost: 40 points,
// more where that is above 1. Context: prep.
double nck_sample_rest_miss(nck_stream_t *self, const nck_sample_rest_t *rest, int i);

#endif
