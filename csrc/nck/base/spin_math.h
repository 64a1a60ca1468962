// SPDX-License-Identifier: MIT
// The spindle's speed at a place of the path.
#ifndef NCK_BASE_SPIN_MATH_H
#define NCK_BASE_SPIN_MATH_H

#include "nck/base/real.h"    // NCK_IN nck_real nck_fabs
#include "nck/base/records.h" // nck_spin_t

// Speed [rpm] where the tool is at x [mm]. Under G96, with the surface speed V = 2π·speed:
//   n = min(V / (2π·r), most)      r = |x − x of the spindle's axis|
// On the axis it is the most.
static inline nck_real nck_spin_rpm(NCK_IN nck_spin_t *spin, nck_real x) {
    if (!(spin->most > 0.0)) return spin->speed;
    const nck_real r = nck_fabs(x - spin->x);
    return spin->speed >= spin->most * r ? spin->most : spin->speed / r;
}

#endif
