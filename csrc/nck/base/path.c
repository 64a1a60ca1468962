// SPDX-License-Identifier: MIT
// The derivatives of straight lines, arcs, helices and cubic splines.
#include "nck/base/path.h"

// Where the start radius (u, v) of an arc points at s: turned by sweep·s/L.
static void radius_at(const nck_seg_t *seg, double s, double *radius_out) {
    const nck_seg_arc_t *const arc = &seg->shape.arc;
    const double ru = seg->start[arc->axis_u] - arc->centre_u;
    const double rv = seg->start[arc->axis_v] - arc->centre_v;
    double sin_phi = 0.0;
    double cos_phi = 1.0;
    nck_sincos(arc->sweep / seg->length * s, &sin_phi, &cos_phi);
    radius_out[0] = ru * cos_phi - rv * sin_phi;
    radius_out[1] = ru * sin_phi + rv * cos_phi;
}

// dp/ds: the unit tangent in the path metric (of a spline: no longer than 1).
//  line    nck_path_slope
//  spline  (3/L) Σ C(2,k) (1 − f)^(2−k) f^k (b_{k+1} − b_k)
//  arc     the radius at s, turned by a quarter towards the motion, times |sweep|/L
//          (Cao et al. 2014, eqs. 3 and 4, for start and end; here for every s)
// 0 ≤ s ≤ L; L must be positive.
void nck_path_tangent_part(const nck_seg_t *seg, double s, int axes, double *tangent_out) {
    if (seg->kind == NCK_SEG_SPLINE) {
        const double f = s / seg->length;
        for (int x = 0; x < axes; x++) {
            const double d0 = seg->shape.inner[0][x] - seg->start[x];
            const double d1 = seg->shape.inner[1][x] - seg->shape.inner[0][x];
            const double d2 = seg->end[x] - seg->shape.inner[1][x];
            const double d01 = d0 + (d1 - d0) * f;
            const double d12 = d1 + (d2 - d1) * f;
            tangent_out[x] = 3.0 * (d01 + (d12 - d01) * f) / seg->length;
        }
        return;
    }
    for (int x = 0; x < axes; x++) tangent_out[x] = nck_path_slope(seg, x);
    if (seg->kind != NCK_SEG_ARC) return;
    const nck_seg_arc_t *const arc = &seg->shape.arc;
    const double turn = arc->sweep / seg->length;
    double radius[2];
    radius_at(seg, s, radius);
    tangent_out[arc->axis_u] = -radius[1] * turn;
    tangent_out[arc->axis_v] = radius[0] * turn;
}

void nck_path_tangent(const nck_seg_t *seg, double s, double *tangent_out) {
    nck_path_tangent_part(seg, s, NCK_AXIS_MAX, tangent_out);
}

// d²p/ds² [1/mm]: 0 on a line.
//  spline  (6/L²) Σ (1 − f)^(1−k) f^k (b_{k+2} − 2b_{k+1} + b_k): linear in s, so the larger of its
//          two ends bounds each axis
//  arc     −radius·(sweep/L)²
// 0 ≤ s ≤ L; L must be positive.
void nck_path_second_part(const nck_seg_t *seg, double s, int axes, double *second_out) {
    if (seg->kind == NCK_SEG_SPLINE) {
        const double f = s / seg->length;
        const double scale = 6.0 / (seg->length * seg->length);
        for (int x = 0; x < axes; x++) {
            const double d1 = seg->shape.inner[1][x] - seg->shape.inner[0][x];
            const double dd0 = d1 - (seg->shape.inner[0][x] - seg->start[x]);
            const double dd1 = (seg->end[x] - seg->shape.inner[1][x]) - d1;
            second_out[x] = scale * (dd0 + (dd1 - dd0) * f);
        }
        return;
    }
    for (int x = 0; x < axes; x++) second_out[x] = 0.0;
    if (seg->kind != NCK_SEG_ARC) return;
    const nck_seg_arc_t *const arc = &seg->shape.arc;
    const double turn = arc->sweep / seg->length;
    double radius[2];
    radius_at(seg, s, radius);
    second_out[arc->axis_u] = -radius[0] * turn * turn;
    second_out[arc->axis_v] = -radius[1] * turn * turn;
}

void nck_path_second(const nck_seg_t *seg, double s, double *second_out) {
    nck_path_second_part(seg, s, NCK_AXIS_MAX, second_out);
}

// d³p/ds³ [1/mm²]: 0 on a line.
//  spline  (6/L³) (b3 − 3b2 + 3b1 − b0), the same everywhere in the seg
//  arc     −(dp/ds)·(sweep/L)²
// 0 ≤ s ≤ L; L must be positive.
void nck_path_third_part(const nck_seg_t *seg, double s, int axes, double *third_out) {
    if (seg->kind == NCK_SEG_SPLINE) {
        const double scale = 6.0 / (seg->length * seg->length * seg->length);
        for (int x = 0; x < axes; x++) {
            const double d1 = seg->shape.inner[1][x] - seg->shape.inner[0][x];
            const double dd0 = d1 - (seg->shape.inner[0][x] - seg->start[x]);
            const double dd1 = (seg->end[x] - seg->shape.inner[1][x]) - d1;
            third_out[x] = scale * (dd1 - dd0);
        }
        return;
    }
    for (int x = 0; x < axes; x++) third_out[x] = 0.0;
    if (seg->kind != NCK_SEG_ARC) return;
    const nck_seg_arc_t *const arc = &seg->shape.arc;
    const double turn = arc->sweep / seg->length;
    double radius[2];
    radius_at(seg, s, radius);
    third_out[arc->axis_u] = radius[1] * turn * turn * turn;
    third_out[arc->axis_v] = -radius[0] * turn * turn * turn;
}

void nck_path_third(const nck_seg_t *seg, double s, double *third_out) {
    nck_path_third_part(seg, s, NCK_AXIS_MAX, third_out);
}

// |dp/ds| at s.
static double speed_at(const nck_seg_t *seg, double s) {
    double tangent[NCK_AXIS_MAX];
    double square = 0.0;
    nck_path_tangent(seg, s, tangent);
    for (int x = 0; x < NCK_AXIS_MAX; x++) square += tangent[x] * tangent[x];
    return nck_sqrt(square);
}

// Parts of a seg over which that is straight, as good as. A length from it never goes back, where a
// spline all but stands still, too.
enum { SHARE_PARTS = 4 };

double nck_path_share(const nck_seg_t *seg, double s) {
    const double place = nck_min(s / seg->length, 1.0) * (double)SHARE_PARTS;
    double before = speed_at(seg, 0.0);
    double whole = 0.0;
    double part = 0.0;
    for (int i = 0; i < SHARE_PARTS; i++) {
        const double behind = speed_at(seg, seg->length * (double)(i + 1) / (double)SHARE_PARTS);
        const double way = nck_min(nck_max(place - (double)i, 0.0), 1.0);
        whole += 0.5 * (before + behind);
        part += way * (before + 0.5 * way * (behind - before));
        before = behind;
    }
    return whole > 0.0 ? nck_min(part / whole, 1.0) : s / seg->length;
}
