// SPDX-License-Identifier: MIT
// Inside room 3: the speeds that the guess and the clock ask for, and where the guess's places are.
#ifndef NCK_PREP_TIMING_MATH_H
#define NCK_PREP_TIMING_MATH_H

#include "nck/base/real.h"            // nck_num_min NCK_NUM_SQRT …
#include "nck/base/root_math.h"       // nck_root_cube
#include "nck/prep/3_smooth/timing.h" // nck_timing_t
#include "nck/prep/3_smooth/tuning.h" // NCK_TIMING_LEAVE NCK_TIMING_ASK

#define NCK_TIMING_REST ((nck_num)(4.5 * NCK_TIMING_LEAVE)) // v³ over J x² there

// Places or quarters a call: 5 000 instructions of a processor with doubles.
enum { NCK_TIMING_SLICE = 24 };

// A speed v where the way x from or to a rest allows it, else what that allows: s = J' t³/6 gives
// v³ = 4.5 J' x².
static inline nck_num nck_timing_near_rest(const nck_timing_terms_t *terms, double x, nck_num v) {
    const nck_num way = (nck_num)x;
    const nck_num most = NCK_TIMING_REST * terms->j_least * way * way;
    if (!(way > 0)) return 0;
    return v * v * v <= most ? v : (nck_num)nck_root_cube((double)most);
}

// The speed a way h on from v. The acceleration that it is built up with is `wish` of an axis', or
// what jerk leaves from 0 on, a = √(2 J v).
static inline nck_num nck_timing_reach_speed(const nck_timing_terms_t *terms, nck_num wish,
                                             nck_num v, double h) {
    const nck_num a = terms->a_least;
    const nck_num j = terms->j_least;
    const nck_num tau = (nck_num)terms->tau;
    const nck_num low = j * tau * tau / 32;
    const nck_num leaves = NCK_NUM_SQRT(2 * j * nck_num_max(v, low));
    const nck_num push = wish * nck_num_min(leaves, a);
    return NCK_NUM_SQRT(v * v + 2 * push * (nck_num)h);
}

// How fast the clock is, ds/du, where the path is to have the speed v: where nothing is near knots
// last longer, and the motion is slower than the clock.
static inline nck_num nck_timing_rate(const nck_timing_terms_t *terms, nck_num v, nck_num wide) {
    const nck_num most = (terms->longest - 1) * v;
    if (!(wide > 0) || !(most > 0)) return v;
    const nck_num more = wide * wide / (wide + v / 2);
    return v + more * most / (more + most);
}

// A place of the guess.
static inline nck_place_t *nck_timing_place(nck_timing_t *self, uint32_t count) {
    return &self->guess.at[count % NCK_TIMING_PLACES];
}

#endif
