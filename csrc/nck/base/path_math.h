// SPDX-License-Identifier: MIT
// Point and tangent of a seg at the path coordinate s: straight lines, arcs and helices, exactly.
#ifndef NCK_BASE_PATH_MATH_H
#define NCK_BASE_PATH_MATH_H

#include "nck/base/real.h"      // nck_real
#include "nck/base/records.h"   // nck_seg_t
#include "nck/base/trig_math.h" // nck_sincos

//  line    p(s) = start + (end − start)·s/L
//  arc     the start radius, turned:  (u, v) = centre + R(φ)·(start − centre),  φ = sweep·s/L;
//          every other axis as on a line (helix).
// Turning the start radius needs no start angle, and s = 0 gives start to the bit. s ≥ L gives end
// to the bit, s ≤ 0 gives start. L = 0 (dwell): start.
static inline void nck_path_point(const nck_seg_t *seg, nck_real s, nck_real *point_out) {
    if (s >= seg->length || s <= 0.0) {
        const nck_real *const p = s > 0.0 ? seg->end : seg->start;
        for (int x = 0; x < NCK_AXIS_MAX; x++) point_out[x] = p[x];
        return;
    }
    const nck_real f = s / seg->length;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        point_out[x] = seg->start[x] + (seg->end[x] - seg->start[x]) * f;
    }
    if (seg->kind != NCK_SEG_ARC) return;
    const nck_real ru = seg->start[seg->axis_u] - seg->centre_u;
    const nck_real rv = seg->start[seg->axis_v] - seg->centre_v;
    nck_real sin_phi = 0.0;
    nck_real cos_phi = 1.0;
    nck_sincos(seg->sweep * f, &sin_phi, &cos_phi);
    point_out[seg->axis_u] = seg->centre_u + (ru * cos_phi - rv * sin_phi);
    point_out[seg->axis_v] = seg->centre_v + (ru * sin_phi + rv * cos_phi);
}

// dp/ds: the unit tangent in the path metric.
//  line    (end − start)/L
//  arc     the radius at s, turned by a quarter towards the motion, times |sweep|/L
//          (Cao et al. 2014, eqs. 3 and 4, for start and end; here for every s)
// L must be positive.
static inline void nck_path_tangent(const nck_seg_t *seg, nck_real s, nck_real *tangent_out) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        tangent_out[x] = (seg->end[x] - seg->start[x]) / seg->length;
    }
    if (seg->kind != NCK_SEG_ARC) return;
    const nck_real ru = seg->start[seg->axis_u] - seg->centre_u;
    const nck_real rv = seg->start[seg->axis_v] - seg->centre_v;
    const nck_real turn = seg->sweep / seg->length;
    nck_real sin_phi = 0.0;
    nck_real cos_phi = 1.0;
    nck_sincos(turn * s, &sin_phi, &cos_phi);
    tangent_out[seg->axis_u] = -(ru * sin_phi + rv * cos_phi) * turn;
    tangent_out[seg->axis_v] = (ru * cos_phi - rv * sin_phi) * turn;
}

#endif
