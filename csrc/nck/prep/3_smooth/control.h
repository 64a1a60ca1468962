// SPDX-License-Identifier: MIT
// Inside room 3: the control points of the spline, from the programmed path.
#ifndef NCK_PREP_CONTROL_H
#define NCK_PREP_CONTROL_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t

// All knots and control points at one place of the run. Cost: constant.
void nck_control_begin(nck_smooth_t *self, double s, const double *point);

// Place the knot t[5], and the two behind it as if the run had to end there: c[3] is what it stays,
// c[4] and c[5] are taken anew with the next knot. Cost: 19 points of the path.
void nck_control_place(nck_smooth_t *self, double t);

// Go on by one knot. Cost: constant.
void nck_control_advance(nck_smooth_t *self);

#endif
