// SPDX-License-Identifier: MIT
// S-shaped ramps between two speeds, a = 0 at both ends: how long they take, and how far they get.
#ifndef NCK_BASE_SCURVE_MATH_H
#define NCK_BASE_SCURVE_MATH_H

#include "nck/base/real.h"      // nck_real nck_sqrt nck_min
#include "nck/base/root_math.h" // nck_root_cube

enum { NCK_SCURVE_NEWTON = 8 }; // steps of a search at most; 3 to 5 are the rule

// What ramps keep to.
typedef struct nck_scurve {
    nck_real a;     // [mm/s²] > 0
    nck_real j;     // [mm/s³] > 0
    nck_real v_max; // [mm/s] > 0
} nck_scurve_t;

// Duration of a ramp over a difference of speeds dv ≥ 0:   2·√(dv/j) up to dv = a²/j, then
// dv/a + a/j  (the jerk is j, 0 and −j in turn).
static inline nck_real nck_scurve_time(NCK_IN nck_scurve_t *ramp, nck_real dv) {
    const nck_real a = ramp->a;
    const nck_real j = ramp->j;
    return dv * j <= a * a ? 2.0 * nck_sqrt(dv / j) : dv / a + a / j;
}

// Length of a ramp from v to v_end ≥ v: the mean speed times its duration.
static inline nck_real nck_scurve_length(NCK_IN nck_scurve_t *ramp, nck_real v, nck_real v_end) {
    return 0.5 * (v + v_end) * nck_scurve_time(ramp, v_end - v);
}

// The speed that a ramp from v reaches within a length ≥ 0, v_max at most. With u = √dv and no
// cruise in it:   u³ + 2v·u = length·√j,   found by Newton from above (convex for u > 0);
// beyond dv = a²/j:   (2v + dv)·(dv/a + a/j)/2 = length.
static inline nck_real nck_scurve_reach(NCK_IN nck_scurve_t *ramp, nck_real v, nck_real length) {
    const nck_real a = ramp->a;
    const nck_real j = ramp->j;
    const nck_real whole = length * nck_sqrt(j);
    if (!(whole > 0.0)) return v;
    nck_real u = nck_root_cube(whole);
    if (u * 2.0 * v > whole) u = whole / (2.0 * v);
    for (int n = 0; n < NCK_SCURVE_NEWTON; n++) {
        const nck_real next = u - ((u * u + 2.0 * v) * u - whole) / (3.0 * u * u + 2.0 * v);
        if (!(next < u)) break;
        u = next;
    }
    nck_real dv = u * u;
    if (dv * j > a * a) {
        const nck_real half = v / a + 0.5 * a / j;
        const nck_real twice = 2.0 * (length - v * a / j);
        dv = twice / (nck_sqrt(half * half + twice / a) + half);
    }
    return nck_min(ramp->v_max, v + dv);
}

// Least time over a length from v on: a ramp, and what is left at its end's speed.
static inline nck_real nck_scurve_over(NCK_IN nck_scurve_t *ramp, nck_real v, nck_real length) {
    const nck_real v_end = nck_scurve_reach(ramp, v, length);
    const nck_real left = length - nck_scurve_length(ramp, v, v_end);
    const nck_real time = nck_scurve_time(ramp, v_end - v);
    return left > 0.0 ? time + left / v_end : time;
}

#endif
