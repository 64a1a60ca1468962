// SPDX-License-Identifier: MIT
// The junction of two planning units: its linking vector angle and its transfer speed.
#ifndef NCK_HOST_TURN_MATH_H
#define NCK_HOST_TURN_MATH_H

#include "nck/base/real.h"                      // nck_real NCK_IN
#include "host/unit.h"  // nck_unit_t nck_grade_rule_t
#include "nck/base/records.h"                   // nck_seg_t nck_unit_t nck_grade_rule_t
#include "host/angle_math.h"    // nck_angle_…
#include "host/transfer_math.h" // nck_transfer_tangent nck_transfer_junction

// 1 if nothing but the axes of mask (a bit each) moves along a seg.
static inline int nck_turn_moves_only(NCK_IN nck_seg_t *seg, uint32_t mask) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (!(mask >> x & 1u) && seg->start[x] != seg->end[x]) return 0;
    }
    return 1;
}

// Forward direction of a seg in the plane (u, w) at its start or end. 0 if it does not lie in it.
static inline int nck_turn_direction(NCK_IN nck_seg_t *seg, int u, int w, int end,
                                     nck_real *direction_out) {
    if (!nck_turn_moves_only(seg, 1u << u | 1u << w)) return 0;
    if (seg->kind == NCK_SEG_LINE) {
        nck_angle_line(seg->end[u] - seg->start[u], seg->end[w] - seg->start[w], direction_out);
        return 1;
    }
    NCK_IN nck_seg_arc_t *const arc = &seg->shape.arc;
    if (seg->kind != NCK_SEG_ARC || arc->axis_u != u || arc->axis_v != w) return 0;
    const nck_real at_u = end ? seg->end[u] : seg->start[u];
    const nck_real at_w = end ? seg->end[w] : seg->start[w];
    nck_angle_arc(arc->centre_u - at_u, arc->centre_v - at_w, arc->sweep, direction_out);
    return 1;
}

// The linking vector angle where seg `in` passes into seg `out`: by eq. 1 between lines in space,
// by eqs. 2 to 5 with an arc in its plane, over all axes otherwise (Cao et al. 2014, section 3).
static inline nck_real nck_turn_angle(NCK_IN nck_seg_t *in, NCK_IN nck_seg_t *out) {
    const uint32_t space = 1u << NCK_AXIS_X | 1u << NCK_AXIS_Y | 1u << NCK_AXIS_Z;
    const int lines = in->kind == NCK_SEG_LINE && out->kind == NCK_SEG_LINE;
    NCK_IN nck_seg_t *const arc = in->kind == NCK_SEG_ARC ? in : out;
    nck_real t_in[NCK_AXIS_MAX];
    nck_real t_out[NCK_AXIS_MAX];
    if (lines && nck_turn_moves_only(in, space) && nck_turn_moves_only(out, space)) {
        for (int x = NCK_AXIS_X; x <= NCK_AXIS_Z; x++) {
            t_in[x] = in->end[x] - in->start[x];
            t_out[x] = out->end[x] - out->start[x];
        }
        return nck_angle_space(t_in, t_out);
    }
    const int u = arc->shape.arc.axis_u;
    const int w = arc->shape.arc.axis_v;
    if (arc->kind == NCK_SEG_ARC && nck_turn_direction(in, u, w, 1, t_in)
        && nck_turn_direction(out, u, w, 0, t_out)) {
        return nck_angle_plane(t_in, t_out);
    }
    nck_transfer_tangent(in, 1, t_in);
    nck_transfer_tangent(out, 0, t_out);
    return nck_angle_tangents(t_in, t_out);
}

// Cap and linking angle where unit `in` passes into the next one; v: the smaller of both units'
// speeds. Inside of a seg the path is smooth.
static inline nck_real nck_turn_transfer(NCK_IN nck_seg_t *segs, NCK_IN nck_unit_t *in,
                                         NCK_IN nck_grade_rule_t *rule, nck_real v,
                                         nck_real *angle_out) {
    NCK_IN nck_unit_t *const out = in + 1;
    int axis = 0;
    *angle_out = (nck_real)0;
    if (in->seg_end == out->seg) return v;
    *angle_out = nck_turn_angle(&segs[in->seg_end], &segs[out->seg]);
    return nck_transfer_junction(&segs[in->seg_end], &segs[out->seg], rule, v, &axis);
}

#endif
