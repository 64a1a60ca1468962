// SPDX-License-Identifier: MIT
// Inside room 3: the speeds that the guess and the clock ask for, and where the guess's places are.
#ifndef NCK_PREP_TIMING_MATH_H
#define NCK_PREP_TIMING_MATH_H

#include "nck/base/real.h"            // nck_max nck_min nck_sqrt
#include "nck/base/root_math.h"       // nck_root_cube
#include "nck/prep/3_smooth/timing.h" // nck_timing_t

#define NCK_TIMING_REST 0.4 // share of the jerk that the guess leaves a rest with
#define NCK_TIMING_ASK 0.7  // share of the acceleration that the guess builds up speed with

// The speed from rest after x: s = J' t³/6 gives v = (4.5 J' x²)^(1/3).
static inline double nck_timing_rest_speed(const nck_timing_terms_t *terms, double x) {
    return x > 0.0 ? nck_root_cube(4.5 * NCK_TIMING_REST * terms->j_least * x * x) : 0.0;
}

// The acceleration that speed is built up with from v on: jerk from 0 leaves a = √(2 J v).
static inline double nck_timing_push(const nck_timing_terms_t *terms, double wish, double v) {
    const double low = terms->j_least * terms->tau * terms->tau / 32.0;
    return wish * nck_min(terms->a_least, nck_sqrt(2.0 * terms->j_least * nck_max(v, low)));
}

// The speed a way h on from v.
static inline double nck_timing_reach_speed(const nck_timing_terms_t *terms, double wish, double v,
                                            double h) {
    return nck_sqrt(v * v + 2.0 * nck_timing_push(terms, wish, v) * h);
}

// A place of the guess.
static inline nck_place_t *nck_timing_place(nck_timing_t *self, uint32_t count) {
    return &self->guess.at[count % NCK_TIMING_PLACES];
}

#endif
