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

// Parts of a spline over which its speed is straight, as good as. A length from it never goes back,
// where it all but stands still, too.
enum { SHARE_PARTS = 4 };

double nck_path_share(const nck_seg_t *seg, double s, double *speed_out) {
    const nck_num f = (nck_num)nck_min(s / seg->length, 1.0);
    nck_num speed[SHARE_PARTS + 1] = {0};
    nck_num here = 0;
    nck_num whole = 0;
    nck_num part = 0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        nck_num way[3];
        nck_path_ways(seg, x, way);
        const nck_num own = nck_path_way_at(way, f);
        here += own * own;
        for (int i = 0; i <= SHARE_PARTS; i++) {
            const nck_num third = nck_path_way_at(way, (nck_num)i / (nck_num)SHARE_PARTS);
            speed[i] += third * third;
        }
    }
    for (int i = 0; i <= SHARE_PARTS; i++) speed[i] = NCK_NUM_SQRT(speed[i]);
    for (int i = 0; i < SHARE_PARTS; i++) {
        const nck_num at = f * (nck_num)SHARE_PARTS - (nck_num)i;
        const nck_num way = at > 0 ? (at < 1 ? at : 1) : 0;
        whole += (speed[i] + speed[i + 1]) / 2;
        part += way * (speed[i] + way * (speed[i + 1] - speed[i]) / 2);
    }
    *speed_out = (double)(3 * NCK_NUM_SQRT(here)) / seg->length;
    if (!(whole > 0)) return (double)f;
    return part < whole ? (double)(part / whole) : 1.0;
}
