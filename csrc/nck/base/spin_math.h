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

// The feed [path mm/s] there: what holds all along, or one a revolution, under G96.
static inline nck_real nck_spin_feed(NCK_IN nck_spin_t *spin, nck_real feed, nck_real x) {
    return spin->per_rev > 0.0 ? spin->per_rev * nck_spin_rpm(spin, x) : feed;
}

// Up to this distance from its axis the spindle turns as fast as it may under G96 [mm].
static inline nck_real nck_spin_flat(NCK_IN nck_spin_t *spin) { return spin->speed / spin->most; }

// How fast the tool may come nearer under G96, or go away [mm/s], so that the spindle follows with
// a [rpm/s]:   |dn/dt| = V/(2πr²)·|dr/dt| ≤ a       r: beyond nck_spin_flat
static inline nck_real nck_spin_follow(NCK_IN nck_spin_t *spin, nck_real r, nck_real a) {
    return a * r * r / spin->speed;
}

#endif
