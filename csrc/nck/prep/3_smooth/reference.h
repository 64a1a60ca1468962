// SPDX-License-Identifier: MIT
// Inside room 3: a window's reference, the program at knots as a spline: a curve is told from it.
#ifndef NCK_PREP_REFERENCE_H
#define NCK_PREP_REFERENCE_H

#include "nck/prep/3_smooth/stream.h" // nck_stream_t

// The reference's control point k, of knots + 3: on the program at its knot; at rests and seams
// what it has to be. Cost: one point. Context: prep.
void nck_reference_set(nck_stream_t *self, int k);

// The program's point at s. Cost: as nck_track_find. Context: prep.
void nck_reference_point(nck_stream_t *self, double s, double *point_out);

// Along a line the clock becomes the reference's: s at the quarters of interval i as its control
// points have it. So the curve is not off the program for how its knots follow each other.
// Cost: four control points. Context: prep.
void nck_reference_follow(nck_stream_t *self, int i);

#endif
