// SPDX-License-Identifier: MIT
// Velocity grades: speeds so far apart that a planning unit is just long enough for one step
// between them.
#ifndef NCK_HOST_GRADE_MATH_H
#define NCK_HOST_GRADE_MATH_H

#include "host/unit.h"              // nck_grade_rule_t
#include "nck/base/envelope_math.h" // nck_envelope_h
#include "nck/base/real.h"          // nck_real nck_floor

// Length of a planning unit: n steps at the command velocity,   L = n·v_c·T
// (Cao et al. 2014, eq. 10; theirs is in m/min).
static inline nck_real nck_grade_length(nck_real n, nck_real v_c, nck_real period) {
    return n * v_c * period;
}

// How many grades there are:   N = ⌈(v_c² − v_min²)/(2aL)⌉ + 1     (Cao et al. 2014, eq. 11)
// v_c ≤ v_min: 1.
static inline nck_real nck_grade_count(nck_real v_c, nck_real v_min, nck_real step) {
    const nck_real span = v_c * v_c - v_min * v_min;
    return span > (nck_real)0 ? -nck_floor(-span / step) + (nck_real)1 : (nck_real)1;
}

// Square of the speed of grade k:   v_k² = v_min² + 2aL·k,  the highest one v_c²
// (Cao et al. 2014, eq. 8, with v_{N−1} capped at v_c). 0 ≤ k < N.
static inline nck_real nck_grade_vv(NCK_IN nck_grade_rule_t *rule, int k) {
    const nck_real top = rule->v_max * rule->v_max;
    if (k + 1 >= (int)rule->count) return top;
    const nck_real step = nck_envelope_h(rule->a, rule->length);
    const nck_real vv = rule->v_min * rule->v_min + step * (nck_real)k;
    return vv < top ? vv : top;
}

// The grade of a speed given as v²:   g = ⌊(v² − v_min²)/(2aL)⌋ in 0 … N−1
// (Cao et al. 2014, eq. 9). Quantised in v²: floor of the table's own rounded speeds puts many
// grades one too low. Where the division rounds, the table decides: the grade's speed is never
// above v (but for grade 0 below v_min), the next grade's always.
static inline int nck_grade_of(NCK_IN nck_grade_rule_t *rule, nck_real vv) {
    const int top = (int)rule->count - 1;
    if (vv >= rule->v_max * rule->v_max) return top;
    const nck_real step = nck_envelope_h(rule->a, rule->length);
    const nck_real x = nck_floor((vv - rule->v_min * rule->v_min) / step);
    if (!(x >= (nck_real)0)) return 0;
    const int g = x < (nck_real)(top - 1) ? (int)x : top - 1;
    if (g + 1 < top && nck_grade_vv(rule, g + 1) <= vv) return g + 1;
    return g > 0 && nck_grade_vv(rule, g) > vv ? g - 1 : g;
}

#endif
