// SPDX-License-Identifier: MIT
// Speed at the point where one planning unit passes into the next.
#ifndef NCK_HOST_TRANSFER_MATH_H
#define NCK_HOST_TRANSFER_MATH_H

#include "host/unit.h"        // nck_grade_rule_t
#include "nck/base/real.h"    // nck_real nck_fabs
#include "nck/base/records.h" // nck_seg_t

// Direction cosines of a seg at its start (end = 0) or end (end = 1), over all axes.
//   line    (end − start)/L
//   arc     in its plane the forward direction of Cao et al. 2014, eqs. 3 and 4, times R·|sweep|/L,
//           the in-plane share; every other axis as on a line. Sine and cosine are not needed.
// L > 0.
static inline void nck_transfer_tangent(NCK_IN nck_seg_t *seg, int end, nck_real *tangent_out) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        tangent_out[x] = (seg->end[x] - seg->start[x]) / seg->length;
    }
    if (seg->kind != NCK_SEG_ARC) return;
    NCK_IN nck_seg_arc_t *const arc = &seg->shape.arc;
    const int u = arc->axis_u;
    const int v = arc->axis_v;
    const nck_real i_u = arc->centre_u - (end ? seg->end[u] : seg->start[u]);
    const nck_real i_v = arc->centre_v - (end ? seg->end[v] : seg->start[v]);
    const nck_real turn = arc->sweep / seg->length;
    tangent_out[u] = i_v * turn;
    tangent_out[v] = -i_u * turn;
}

// (13): what speed the length l allows to be reached from v1² with the acceleration a:
//   v2² ≤ v1² + 2·a·l     (Cao et al. 2014, eq. 13)
static inline nck_real nck_transfer_reach(nck_real vv, nck_real a, nck_real length) {
    return vv + (nck_real)2 * a * length;
}

// One axis, direction cosines c1 ≠ c2 before and after:   v = a·T/|c1 − c2|
// (Cao et al. 2014, eq. 14; c1 = c2: the axis does not limit).
static inline nck_real nck_transfer_axis(nck_real a, nck_real period, nck_real c1, nck_real c2) {
    return a * period / nck_fabs(c1 - c2);
}

// All axes: the smallest of v and (14) for the tangents in and out; *axis_out is the axis that
// limits, −1 if v itself does. Cosines that differ by rounding alone limit far above any speed.
static inline nck_real nck_transfer_speed(const nck_real *in, const nck_real *out,
                                          NCK_IN nck_grade_rule_t *rule, nck_real v,
                                          int *axis_out) {
    *axis_out = -1;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (in[x] == out[x] || !(rule->a_axis[x] > (nck_real)0)) continue;
        const nck_real v_axis = nck_transfer_axis(rule->a_axis[x], rule->period_s, in[x], out[x]);
        if (v_axis < v) {
            v = v_axis;
            *axis_out = x;
        }
    }
    return v;
}

// The transfer speed between two units that meet at the end of seg `in`, the start of seg `out`.
static inline nck_real nck_transfer_junction(NCK_IN nck_seg_t *in, NCK_IN nck_seg_t *out,
                                             NCK_IN nck_grade_rule_t *rule, nck_real v,
                                          int *axis_out) {
    nck_real t_in[NCK_AXIS_MAX];
    nck_real t_out[NCK_AXIS_MAX];
    nck_transfer_tangent(in, 1, t_in);
    nck_transfer_tangent(out, 0, t_out);
    return nck_transfer_speed(t_in, t_out, rule, v, axis_out);
}

#endif
