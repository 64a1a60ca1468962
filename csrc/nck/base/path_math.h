// SPDX-License-Identifier: MIT
// Point of a seg at the path coordinate s: straight lines, arcs, helices, cubic splines.
#ifndef NCK_BASE_PATH_MATH_H
#define NCK_BASE_PATH_MATH_H

#include "nck/base/real.h"      // nck_real
#include "nck/base/records.h"   // nck_seg_t
#include "nck/base/trig_math.h" // what nck_sincos stands for

// 1 if the axis is one of the two that an arc turns in.
static inline int nck_path_turns(const nck_seg_t *seg, int x) {
    return seg->kind == NCK_SEG_ARC && (x == seg->shape.arc.axis_u || x == seg->shape.arc.axis_v);
}

// A cubic over f = s/L in 0…1 by its Bernstein points b0 … b3, repeated linear interpolation:
//   p = Σ C(3,k) (1 − f)^(3−k) f^k b_k
// (P. de Casteljau; G. Farin, Curves and Surfaces for CAGD, 2002, section 4.2.) Never outside of
// what its points span, but for rounding.
static inline nck_real nck_path_cubic(const nck_seg_t *seg, int x, nck_real f) {
    const nck_real b1 = seg->shape.inner[0][x];
    const nck_real b2 = seg->shape.inner[1][x];
    const nck_real b01 = seg->start[x] + (b1 - seg->start[x]) * f;
    const nck_real b12 = b1 + (b2 - b1) * f;
    const nck_real b23 = b2 + (seg->end[x] - b2) * f;
    const nck_real b012 = b01 + (b12 - b01) * f;
    const nck_real b123 = b12 + (b23 - b12) * f;
    return b012 + (b123 - b012) * f;
}

// A line over f = s/L in 0…1:   p = start + (end − start)·f
static inline nck_real nck_path_straight(const nck_seg_t *seg, int x, nck_real f) {
    return seg->start[x] + (seg->end[x] - seg->start[x]) * f;
}

// Its tangent:   dp/ds = (end − start)/L
static inline nck_real nck_path_slope(const nck_seg_t *seg, int x) {
    return (seg->end[x] - seg->start[x]) / seg->length;
}

//  line    nck_path_straight
//  spline  nck_path_cubic
//  arc     the start radius, turned:  (u, v) = centre + R(φ)·(start − centre),  φ = sweep·s/L;
//          every other axis as on a line (helix).
// Turning the start radius needs no start angle, and s = 0 gives start to the bit. s ≥ L gives end
// to the bit, s ≤ 0 gives start. L = 0 (dwell): start. axes: so many coordinates, from X on; an arc
// turns in two of them.
static inline void nck_path_part(const nck_seg_t *seg, nck_real s, int axes, nck_real *point_out) {
    if (s >= seg->length || s <= 0.0) {
        const nck_real *const p = s > 0.0 ? seg->end : seg->start;
        for (int x = 0; x < axes; x++) point_out[x] = p[x];
        return;
    }
    const nck_real f = s / seg->length;
    if (seg->kind == NCK_SEG_SPLINE) {
        for (int x = 0; x < axes; x++) point_out[x] = nck_path_cubic(seg, x, f);
        return;
    }
    for (int x = 0; x < axes; x++) point_out[x] = nck_path_straight(seg, x, f);
    if (seg->kind != NCK_SEG_ARC) return;
    const nck_seg_arc_t *const arc = &seg->shape.arc;
    const nck_real ru = seg->start[arc->axis_u] - arc->centre_u;
    const nck_real rv = seg->start[arc->axis_v] - arc->centre_v;
    nck_real sin_phi = 0.0;
    nck_real cos_phi = 1.0;
    nck_sincos(arc->sweep * f, &sin_phi, &cos_phi);
    point_out[arc->axis_u] = arc->centre_u + (ru * cos_phi - rv * sin_phi);
    point_out[arc->axis_v] = arc->centre_v + (ru * sin_phi + rv * cos_phi);
}

// All coordinates of the point.
static inline void nck_path_point(const nck_seg_t *seg, nck_real s, nck_real *point_out) {
    nck_path_part(seg, s, NCK_AXIS_MAX, point_out);
}

#endif
