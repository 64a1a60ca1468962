// SPDX-License-Identifier: MIT
// Speed inside a planning unit: the number of interpolation steps that keep length, chord error
// and the acceleration of every axis (Cao et al. 2014, section 5).
#ifndef NCK_HOST_UNIT_MATH_H
#define NCK_HOST_UNIT_MATH_H

#include "host/unit.h"          // nck_unit_t nck_grade_rule_t
#include "nck/base/path_math.h" // nck_path_point
#include "nck/base/real.h"      // nck_real nck_sqrt nck_fabs nck_floor nck_max
#include "nck/base/records.h"   // nck_seg_t

// No unit takes more steps; below, counts are exact in a float too.
#define NCK_UNIT_STEP_MAX 16777216
// Share of a limit that is rounding.
#define NCK_UNIT_EPSILON 1e-9

// Going along a unit: the seg under way, as a copy since it may stand in another address space.
typedef struct nck_unit_walk {
    nck_seg_t seg;
    uint32_t at;     // its place
    nck_real before; // from the unit's begin to the seg's start [path mm]; ≤ 0 in the first seg
} nck_unit_walk_t;

// Stand at the begin of a unit.
static inline void nck_unit_walk_begin(nck_unit_walk_t *walk, NCK_IN nck_seg_t *segs,
                                       NCK_IN nck_unit_t *unit) {
    walk->at = unit->seg;
    walk->seg = segs[unit->seg];
    walk->before = -unit->s;
}

// The point at the path length s from the unit's begin; s never falls from call to call.
static inline void nck_unit_walk_to(nck_unit_walk_t *walk, NCK_IN nck_seg_t *segs, uint32_t last,
                                    nck_real s, nck_real *point_out) {
    while (walk->at < last && s - walk->before > walk->seg.length) {
        walk->before += walk->seg.length;
        walk->at++;
        walk->seg = segs[walk->at];
    }
    nck_path_point(&walk->seg, s - walk->before, point_out);
}

// ⌈x⌉, 1 at least; what exceeds a whole number by rounding alone does not count.
static inline int nck_unit_steps(nck_real x) {
    const nck_real n = -nck_floor(-x * ((nck_real)1 - (nck_real)NCK_UNIT_EPSILON));
    if (!(n > (nck_real)1)) return 1;
    return n < (nck_real)NCK_UNIT_STEP_MAX ? (int)n : NCK_UNIT_STEP_MAX;
}

// First step, the length: the fewest steps of v·T that end no further than the length tolerance ε
// before the unit's end,   n = ⌈(L − ε)/(v·T)⌉ ≥ 1.
static inline int nck_unit_steps_least(NCK_IN nck_unit_t *unit, NCK_IN nck_grade_rule_t *rule) {
    return nck_unit_steps((unit->length - rule->length_error) / (unit->v_command * rule->period_s));
}

// More steps than these are never needed: at v ≤ a·T/2 not even a reversal breaks a,
//   n = ⌈2L/(a·T²)⌉     (a: the smallest of the axes' limits; derived in docs/grades.md)
static inline int nck_unit_steps_most(NCK_IN nck_unit_t *unit, NCK_IN nck_grade_rule_t *rule) {
    nck_real a = (nck_real)0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const nck_real a_axis = rule->a_axis[x];
        if (a_axis > (nck_real)0 && (!(a > (nck_real)0) || a_axis < a)) a = a_axis;
    }
    if (!(a > (nck_real)0)) return NCK_UNIT_STEP_MAX;
    return nck_unit_steps((nck_real)2 * unit->length / (a * rule->period_s * rule->period_s));
}

// Second and third step, for n equal steps of the unit, p_k the points between them:
//   out[0]  the largest distance of a chord's middle from the path half-way along its step, over δ
//   out[1]  the largest |p_{k+1} − 2p_k + p_{k−1}|/T² of an axis over its limit
// 1 is just allowed.
static inline void nck_unit_ratios(NCK_IN nck_seg_t *segs, NCK_IN nck_unit_t *unit,
                                   NCK_IN nck_grade_rule_t *rule, int n, nck_real *out) {
    const nck_real tt = rule->period_s * rule->period_s;
    const nck_real length = unit->length / (nck_real)n;
    nck_real from[NCK_AXIS_MAX];
    nck_real middle[NCK_AXIS_MAX];
    nck_real to[NCK_AXIS_MAX];
    nck_real before[NCK_AXIS_MAX]; // the step before
    nck_unit_walk_t walk;
    nck_unit_walk_begin(&walk, segs, unit);
    nck_unit_walk_to(&walk, segs, unit->seg_end, (nck_real)0, from);
    out[0] = (nck_real)0;
    out[1] = (nck_real)0;
    for (int k = 0; k < n; k++) {
        const nck_real s = (nck_real)k * length;
        nck_unit_walk_to(&walk, segs, unit->seg_end, s + length / (nck_real)2, middle);
        nck_unit_walk_to(&walk, segs, unit->seg_end, s + length, to);
        nck_real chord = (nck_real)0;
        for (int x = 0; x < NCK_AXIS_MAX; x++) {
            const nck_real off = (from[x] + to[x]) / (nck_real)2 - middle[x];
            const nck_real step = to[x] - from[x];
            const nck_real a = k > 0 ? nck_fabs(step - before[x]) / tt : (nck_real)0;
            chord += off * off;
            if (rule->a_axis[x] > (nck_real)0) out[1] = nck_max(out[1], a / rule->a_axis[x]);
            before[x] = step;
            from[x] = to[x];
        }
        out[0] = nck_max(out[0], nck_sqrt(chord) / rule->chord_error);
    }
}

// The count to try after one that exceeded a limit by the factor r > 1: one more, or n·√r if that
// is more. Both errors fall with 1/n² on a curve (and more slowly at a corner), so that no count
// in between would do but by the luck of where its steps fall.
static inline int nck_unit_steps_after(int n, nck_real r) {
    const nck_real more = (nck_real)n * nck_sqrt(r);
    const int next = more < (nck_real)NCK_UNIT_STEP_MAX ? (int)more : NCK_UNIT_STEP_MAX;
    return next > n ? next : n + 1;
}

// The unit's step count: the least one that holds all three; *limit_out is what bound last, a
// nck_limit_t: the commanded speed's, NCK_LIMIT_CHORD, or NCK_LIMIT_CURVATURE for the
// acceleration. At nck_unit_steps_most it ends in any case. A piece of a line holds at once.
static inline int nck_unit_step_count(NCK_IN nck_seg_t *segs, NCK_IN nck_unit_t *unit,
                                      NCK_IN nck_grade_rule_t *rule, int *limit_out) {
    const nck_real most_ratio = (nck_real)1 + (nck_real)NCK_UNIT_EPSILON;
    int n = nck_unit_steps_least(unit, rule);
    *limit_out = unit->limit;
    if (unit->seg == unit->seg_end && segs[unit->seg].kind == NCK_SEG_LINE) return n;
    const int most = nck_unit_steps_most(unit, rule);
    while (n < most) {
        nck_real ratio[2];
        nck_unit_ratios(segs, unit, rule, n, ratio);
        const nck_real worst = nck_max(ratio[0], ratio[1]);
        if (!(worst > most_ratio)) break;
        *limit_out = ratio[0] > most_ratio ? NCK_LIMIT_CHORD : NCK_LIMIT_CURVATURE;
        n = nck_unit_steps_after(n, worst);
        n = n < most ? n : most;
    }
    return n;
}

// The unit's speed:   v = L/(n·T)     (Cao et al. 2014, eq. 12), the commanded one at most.
static inline nck_real nck_unit_speed(NCK_IN nck_unit_t *unit, nck_real period, int n) {
    const nck_real v = unit->length / ((nck_real)n * period);
    return v < unit->v_command ? v : unit->v_command;
}

#endif
