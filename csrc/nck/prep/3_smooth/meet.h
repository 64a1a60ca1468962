// SPDX-License-Identifier: MIT
// Inside room 3: what a corner between two blocks becomes where the spline comes by.
#ifndef NCK_PREP_MEET_H
#define NCK_PREP_MEET_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t

// By how much the control point of the corner at a block's end has to be lifted off it if knots
// stand h on either side of it; weight: as in spline_math.h. Cost: constant.
double nck_meet_lift(nck_smooth_t *self, uint32_t count, double h, double weight);

// A corner with a lift goes without, if that is faster. Then the path stops at it, if that is: the
// run ends there. Cost: some 200 square roots.
void nck_meet_choose(nck_smooth_t *self, uint32_t count);

#endif
