// SPDX-License-Identifier: MIT
// One axis' acceleration and jerk on a smooth path p(s), shared between what the path's bends cost
// at speed v and what is left along the path:
//   p̈ = p″·v² + p′·a           p⃛ = p‴·v³ + 3p″·v·a + p′·j
// first, second, third: bounds on |p′|, |p″|, |p‴| of the axis. README, section "smooth pieces".
#ifndef NCK_PREP_BUDGET_MATH_H
#define NCK_PREP_BUDGET_MATH_H

#include "nck/base/budget.h" // NCK_BUDGET_…
#include "nck/base/real.h"   // nck_real nck_sqrt nck_min

// v² that the curvature allows:   v² ≤ γ·a/|p″|,   second > 0
static inline nck_real nck_budget_curve(nck_real a, nck_real second) {
    return NCK_BUDGET_CURVE_SHARE * a / second;
}

// v³ that the change of curvature allows:   v³ ≤ β·j/|p‴|,   third > 0
static inline nck_real nck_budget_twist(nck_real j, nck_real third) {
    return NCK_BUDGET_TWIST_SHARE * j / third;
}

// What |p″|v² leaves to the path's acceleration:   a_t ≤ (a − |p″|v²)/|p′|,   first > 0
static inline nck_real nck_budget_accel(nck_real a, nck_real first, nck_real second, nck_real v) {
    return (a - second * v * v) / first;
}

// The path's acceleration with which 3|p″|v·a_t keeps to its share of the jerk, second·v > 0:
//   a_t ≤ ½·(j − |p‴|v³)/(3|p″|v)
static inline nck_real nck_budget_ramp(nck_real j, nck_real second, nck_real third, nck_real v) {
    return NCK_BUDGET_RAMP_SHARE * (j - third * v * v * v) / ((nck_real)3 * second * v);
}

// What is left to the path's jerk:   j_t ≤ (j − |p‴|v³ − 3|p″|v·a_t)/|p′|,   first > 0
static inline nck_real nck_budget_jerk(nck_real j, nck_real first, nck_real second, nck_real third,
                                       nck_real v, nck_real a_t) {
    return (j - third * v * v * v - (nck_real)3 * second * v * a_t) / first;
}

#endif
