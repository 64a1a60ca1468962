// SPDX-License-Identifier: MIT
// S-shaped ramps between two speeds, a = 0 at both ends: how long they take, and how far they get.
#ifndef NCK_BASE_RAMP_MATH_H
#define NCK_BASE_RAMP_MATH_H

#include "nck/base/real.h" // nck_real nck_sqrt nck_max

enum { NCK_RAMP_HALVINGS = 30 }; // of a speed that is sought: to 1e-9 of the highest

// What ramps keep to.
typedef struct nck_ramp {
    nck_real a;     // [mm/s²] > 0
    nck_real j;     // [mm/s³] > 0
    nck_real v_max; // [mm/s] > 0
} nck_ramp_t;

// Duration of a ramp over a difference of speeds dv ≥ 0:   2·√(dv/j) up to dv = a²/j, then
// dv/a + a/j  (the jerk is j, 0 and −j in turn).
static inline nck_real nck_ramp_time(NCK_IN nck_ramp_t *ramp, nck_real dv) {
    const nck_real a = ramp->a;
    const nck_real j = ramp->j;
    return dv * j <= a * a ? 2.0 * nck_sqrt(dv / j) : dv / a + a / j;
}

// Length of a ramp from v to v_end ≥ v: the mean speed times its duration.
static inline nck_real nck_ramp_length(NCK_IN nck_ramp_t *ramp, nck_real v, nck_real v_end) {
    return 0.5 * (v + v_end) * nck_ramp_time(ramp, v_end - v);
}

// The speed that a ramp from v reaches within a length ≥ 0, v_max at most.
static inline nck_real nck_ramp_reach(NCK_IN nck_ramp_t *ramp, nck_real v, nck_real length) {
    nck_real low = v;
    nck_real high = ramp->v_max;
    for (int n = 0; n < NCK_RAMP_HALVINGS; n++) {
        const nck_real middle = 0.5 * (low + high);
        if (nck_ramp_length(ramp, v, middle) <= length) low = middle;
        else high = middle;
    }
    return low;
}

// Least time over a length from v on: a ramp, and what is left at its end's speed.
static inline nck_real nck_ramp_over(NCK_IN nck_ramp_t *ramp, nck_real v, nck_real length) {
    const nck_real v_end = nck_ramp_reach(ramp, v, length);
    const nck_real left = length - nck_ramp_length(ramp, v, v_end);
    const nck_real time = nck_ramp_time(ramp, v_end - v);
    return left > 0.0 ? time + left / v_end : time;
}

// Least time over a length that is entered at v and ends at rest, where v can be braked from.
static inline nck_real nck_ramp_to_rest(NCK_IN nck_ramp_t *ramp, nck_real v, nck_real length) {
    nck_real low = v;
    nck_real high = ramp->v_max;
    for (int n = 0; n < NCK_RAMP_HALVINGS; n++) {
        const nck_real top = 0.5 * (low + high);
        const nck_real both = nck_ramp_length(ramp, v, top) + nck_ramp_length(ramp, 0.0, top);
        if (both <= length) low = top;
        else high = top;
    }
    const nck_real left =
        length - nck_ramp_length(ramp, v, low) - nck_ramp_length(ramp, 0.0, low);
    return nck_ramp_time(ramp, low - v) + nck_ramp_time(ramp, low) + nck_max(0.0, left) / low;
}

#endif
