// SPDX-License-Identifier: MIT
// Inside room 4: whether the path is faster with a stop at a junction.
#ifndef NCK_PREP_STOP_H
#define NCK_PREP_STOP_H

#include "nck/prep/4_lookahead/junction.h"   // nck_junction_t nck_terms_t
#include "nck/prep/4_lookahead/limit_math.h" // nck_corner_sharp NCK_CORNER_SHARE_MAX

// nck_stop_pays under a jerk limit; without one, where a stop may be faster than crossing at v.
// Cost: constant.
int nck_stop_pays_jerk(const nck_junction_t *in, const nck_junction_t *out, double load,
                       const nck_terms_t *terms);
int nck_stop_is_faster(const nck_junction_t *in, const nck_junction_t *out, double load, double v,
                       const nck_machine_t *machine);

// Whether a seg's half is crossed at v no later than it is left from rest: half/v ≤ √(2·half/a).
// Cost: constant.
static inline int nck_stop_is_fast(const nck_junction_t *junction, double v) {
    return junction->a_most * junction->length <= 4.0 * v * v;
}

// 1 if the path better stops at the junction of this load [s²/mm] between two segs. Under a jerk
// limit: if it is alone, and even what little acceleration can be reached next to a standstill is
// worth more than its speed. Cost: constant.
static inline int nck_stop_pays(const nck_junction_t *in, const nck_junction_t *out, double load,
                                const nck_terms_t *terms) {
    const nck_machine_t *const machine = terms->machine;
    if (terms->limits_jerk) return nck_stop_pays_jerk(in, out, load, terms);
    if (nck_corner_sharp(load, nck_min(in->a_most, out->a_most))) return 1;
    const double v_max = nck_min(in->v_max, out->v_max);
    const double v = nck_min(NCK_CORNER_SHARE_MAX * machine->period_s / load, v_max);
    if (nck_stop_is_fast(in, v) && nck_stop_is_fast(out, v)) return 0; // a stop costs a period
    return nck_stop_is_faster(in, out, load, v, machine);
}

#endif
