// SPDX-License-Identifier: MIT
// Inside room 3: how far apart the knots may be by what a block itself is.
#ifndef NCK_PREP_CURVE_H
#define NCK_PREP_CURVE_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t

// Share of the tolerance that a spacing is chosen for before it is checked, in general.
#define NCK_CURVE_AIM 0.7
// Pieces that a window holds where a knot more is worth it: a short one sees less with more pieces.
enum { NCK_CURVE_WINDOW = 128 };

// The widest spacing that a speed can ask for on this machine [path mm], v in path mm/s.
// Cost: linear in the axes, one root.
double nck_curve_widest(const nck_smooth_t *self, double v);

// The spacing of knots that the inside of an exact seg allows where its ends are corners or rests:
// what is slow there needs short pieces, each of which has one speed at most. Cost: constant.
double nck_curve_inside(const nck_smooth_t *self, const nck_seg_t *seg, double tolerance);

// The spacing that the inside of a block allows where it goes on straight at its ends.
// Cost: constant.
double nck_curve_along(const nck_smooth_t *self, const nck_raw_t *raw);

// The spacing at a step of the curvature behind a block that gets a knot of its own; 0: it is none,
// or does not. aim: how far the spline may leave the corner there [mm], alone: the spacing that the
// corner allows if it is alone. What it uses of the tolerance comes off. Cost: constant.
double nck_curve_step(nck_smooth_t *self, uint32_t count, double aim, double alone);

#endif
