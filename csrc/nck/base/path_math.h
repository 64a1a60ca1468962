// SPDX-License-Identifier: MIT
// Point of a seg at the path coordinate s, and its derivatives by s: straight lines, arcs, helices,
// cubic splines.
#ifndef NCK_BASE_PATH_MATH_H
#define NCK_BASE_PATH_MATH_H

#include "nck/base/real.h"      // nck_real
#include "nck/base/records.h"   // nck_seg_t
#include "nck/base/trig_math.h" // what nck_sincos stands for

// A cubic over f = s/L in 0…1 by its Bernstein points b0 … b3, repeated linear interpolation:
//   p = Σ C(3,k) (1 − f)^(3−k) f^k b_k
// (P. de Casteljau; G. Farin, Curves and Surfaces for CAGD, 2002, section 4.2.) Never outside of
// what its points span, but for rounding.
static inline nck_real nck_path_cubic(const nck_seg_t *seg, int x, nck_real f) {
    const nck_real b01 = seg->start[x] + (seg->inner[0][x] - seg->start[x]) * f;
    const nck_real b12 = seg->inner[0][x] + (seg->inner[1][x] - seg->inner[0][x]) * f;
    const nck_real b23 = seg->inner[1][x] + (seg->end[x] - seg->inner[1][x]) * f;
    const nck_real b012 = b01 + (b12 - b01) * f;
    const nck_real b123 = b12 + (b23 - b12) * f;
    return b012 + (b123 - b012) * f;
}

//  line    p(s) = start + (end − start)·s/L
//  spline  nck_path_cubic
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
    if (seg->kind == NCK_SEG_SPLINE) {
        for (int x = 0; x < NCK_AXIS_MAX; x++) point_out[x] = nck_path_cubic(seg, x, f);
        return;
    }
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

// Where the start radius (u, v) of an arc points at s: turned by sweep·s/L.
static inline void nck_path_radius(const nck_seg_t *seg, nck_real s, nck_real *radius_out) {
    const nck_real ru = seg->start[seg->axis_u] - seg->centre_u;
    const nck_real rv = seg->start[seg->axis_v] - seg->centre_v;
    nck_real sin_phi = 0.0;
    nck_real cos_phi = 1.0;
    nck_sincos(seg->sweep / seg->length * s, &sin_phi, &cos_phi);
    radius_out[0] = ru * cos_phi - rv * sin_phi;
    radius_out[1] = ru * sin_phi + rv * cos_phi;
}

// dp/ds: the unit tangent in the path metric (of a spline: no longer than 1).
//  line    (end − start)/L
//  spline  (3/L) Σ C(2,k) (1 − f)^(2−k) f^k (b_{k+1} − b_k)
//  arc     the radius at s, turned by a quarter towards the motion, times |sweep|/L
//          (Cao et al. 2014, eqs. 3 and 4, for start and end; here for every s)
// 0 ≤ s ≤ L; L must be positive.
static inline void nck_path_tangent(const nck_seg_t *seg, nck_real s, nck_real *tangent_out) {
    if (seg->kind == NCK_SEG_SPLINE) {
        const nck_real f = s / seg->length;
        for (int x = 0; x < NCK_AXIS_MAX; x++) {
            const nck_real d0 = seg->inner[0][x] - seg->start[x];
            const nck_real d1 = seg->inner[1][x] - seg->inner[0][x];
            const nck_real d2 = seg->end[x] - seg->inner[1][x];
            const nck_real d01 = d0 + (d1 - d0) * f;
            const nck_real d12 = d1 + (d2 - d1) * f;
            tangent_out[x] = 3.0 * (d01 + (d12 - d01) * f) / seg->length;
        }
        return;
    }
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        tangent_out[x] = (seg->end[x] - seg->start[x]) / seg->length;
    }
    if (seg->kind != NCK_SEG_ARC) return;
    const nck_real turn = seg->sweep / seg->length;
    nck_real radius[2];
    nck_path_radius(seg, s, radius);
    tangent_out[seg->axis_u] = -radius[1] * turn;
    tangent_out[seg->axis_v] = radius[0] * turn;
}

// d²p/ds² [1/mm]: 0 on a line.
//  spline  (6/L²) Σ (1 − f)^(1−k) f^k (b_{k+2} − 2b_{k+1} + b_k): linear in s, so the larger of its
//          two ends bounds each axis
//  arc     −radius·(sweep/L)²
// 0 ≤ s ≤ L; L must be positive.
static inline void nck_path_second(const nck_seg_t *seg, nck_real s, nck_real *second_out) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) second_out[x] = 0.0;
    if (seg->kind == NCK_SEG_SPLINE) {
        const nck_real f = s / seg->length;
        const nck_real scale = 6.0 / (seg->length * seg->length);
        for (int x = 0; x < NCK_AXIS_MAX; x++) {
            const nck_real d1 = seg->inner[1][x] - seg->inner[0][x];
            const nck_real dd0 = d1 - (seg->inner[0][x] - seg->start[x]);
            const nck_real dd1 = (seg->end[x] - seg->inner[1][x]) - d1;
            second_out[x] = scale * (dd0 + (dd1 - dd0) * f);
        }
    }
    if (seg->kind != NCK_SEG_ARC) return;
    const nck_real turn = seg->sweep / seg->length;
    nck_real radius[2];
    nck_path_radius(seg, s, radius);
    second_out[seg->axis_u] = -radius[0] * turn * turn;
    second_out[seg->axis_v] = -radius[1] * turn * turn;
}

// d³p/ds³ [1/mm²]: 0 on a line.
//  spline  (6/L³) (b3 − 3b2 + 3b1 − b0), the same everywhere in the seg
//  arc     −(dp/ds)·(sweep/L)²
// 0 ≤ s ≤ L; L must be positive.
static inline void nck_path_third(const nck_seg_t *seg, nck_real s, nck_real *third_out) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) third_out[x] = 0.0;
    if (seg->kind == NCK_SEG_SPLINE) {
        const nck_real scale = 6.0 / (seg->length * seg->length * seg->length);
        for (int x = 0; x < NCK_AXIS_MAX; x++) {
            const nck_real d1 = seg->inner[1][x] - seg->inner[0][x];
            const nck_real dd0 = d1 - (seg->inner[0][x] - seg->start[x]);
            const nck_real dd1 = (seg->end[x] - seg->inner[1][x]) - d1;
            third_out[x] = scale * (dd1 - dd0);
        }
    }
    if (seg->kind != NCK_SEG_ARC) return;
    const nck_real turn = seg->sweep / seg->length;
    nck_real radius[2];
    nck_path_radius(seg, s, radius);
    third_out[seg->axis_u] = radius[1] * turn * turn * turn;
    third_out[seg->axis_v] = -radius[0] * turn * turn * turn;
}

#endif
