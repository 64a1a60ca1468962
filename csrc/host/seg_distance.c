// SPDX-License-Identifier: MIT
// Points of lines, arcs, helices and cubics, and the nearest of them. Their equations are written
// down once more here, so that a mistake in those that the tick uses shows.
#include "host/seg_distance.h"

#include "host/course.h"   // nck_host_course_apart
#include "nck/base/real.h" // nck_sqrt nck_fabs nck_min nck_max nck_sincos

#define PARTS 32 // of the grid

static void cubic_at(const nck_seg_t *seg, double f, double *point_out) {
    const double g = 1.0 - f;
    const double b0 = g * g * g;
    const double b1 = 3.0 * f * g * g;
    const double b2 = 3.0 * f * f * g;
    const double b3 = f * f * f;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        point_out[x] = seg->start[x] * b0 + seg->shape.inner[0][x] * b1
                       + seg->shape.inner[1][x] * b2 + seg->end[x] * b3;
    }
}

static void turn_to(const nck_seg_t *seg, double f, double *point_out) {
    const nck_seg_arc_t *const arc = &seg->shape.arc;
    const double ru = seg->start[arc->axis_u] - arc->centre_u;
    const double rv = seg->start[arc->axis_v] - arc->centre_v;
    double sin_phi = 0.0;
    double cos_phi = 1.0;
    nck_sincos(arc->sweep * f, &sin_phi, &cos_phi);
    point_out[arc->axis_u] = arc->centre_u + ru * cos_phi - rv * sin_phi;
    point_out[arc->axis_v] = arc->centre_v + ru * sin_phi + rv * cos_phi;
}

void nck_host_seg_point(const nck_seg_t *seg, double f, double *point_out) {
    if (seg->kind == NCK_SEG_SPLINE) {
        cubic_at(seg, f, point_out);
        return;
    }
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        point_out[x] = seg->start[x] + (seg->end[x] - seg->start[x]) * f;
    }
    if (seg->kind == NCK_SEG_ARC) turn_to(seg, f, point_out);
}

// How far a point is from the chord between two others [path mm].
static double chord_distance(const double *from, const double *to, const double *point) {
    double square = 0.0;
    double ahead = 0.0;
    double on[NCK_AXIS_MAX];
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        square += (to[x] - from[x]) * (to[x] - from[x]);
        ahead += (point[x] - from[x]) * (to[x] - from[x]);
    }
    const double q = square > 0.0 ? nck_min(1.0, nck_max(0.0, ahead / square)) : 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) on[x] = from[x] + (to[x] - from[x]) * q;
    return nck_host_course_apart(point, on);
}

// No point of a curve is further from its start than this.
static double reach_of(const nck_seg_t *seg) {
    const nck_seg_arc_t *const arc = &seg->shape.arc;
    if (seg->kind == NCK_SEG_SPLINE) {
        return nck_host_course_apart(seg->start, seg->shape.inner[0])
               + nck_host_course_apart(seg->shape.inner[0], seg->shape.inner[1])
               + nck_host_course_apart(seg->shape.inner[1], seg->end);
    }
    const double ru = seg->start[arc->axis_u] - arc->centre_u;
    const double rv = seg->start[arc->axis_v] - arc->centre_v;
    return nck_sqrt(ru * ru + rv * rv) * nck_min(2.0, nck_fabs(arc->sweep))
           + nck_host_course_apart(seg->start, seg->end);
}

// The share of a curve where it is nearest to a point, on the grid.
static double nearest_share(const nck_seg_t *seg, const double *point) {
    double at[NCK_AXIS_MAX];
    double least = 0.0;
    double share = 0.0;
    for (int k = 0; k <= PARTS; k++) {
        const double f = (double)k / (double)PARTS;
        nck_host_seg_point(seg, f, at);
        const double apart = nck_host_course_apart(at, point);
        if (k == 0 || apart < least) {
            least = apart;
            share = f;
        }
    }
    return share;
}

// From a part before a share to a part behind it, by PARTS chords.
static double distance_about(const nck_seg_t *seg, double share, const double *point) {
    double ends[2][NCK_AXIS_MAX];
    double least = 0.0;
    for (int k = 0; k <= PARTS; k++) {
        const double f = share + (2.0 * (double)k / (double)PARTS - 1.0) / (double)PARTS;
        nck_host_seg_point(seg, nck_min(1.0, nck_max(0.0, f)), ends[k % 2]);
        if (k == 0) continue;
        const double apart = chord_distance(ends[(k + 1) % 2], ends[k % 2], point);
        least = k == 1 ? apart : nck_min(least, apart);
    }
    return least;
}

double nck_host_seg_distance(const nck_seg_t *seg, const double *point, double most) {
    if (seg->kind != NCK_SEG_SPLINE && seg->kind != NCK_SEG_ARC) {
        return chord_distance(seg->start, seg->end, point);
    }
    if (nck_host_course_apart(seg->start, point) - reach_of(seg) >= most) return most;
    return distance_about(seg, nearest_share(seg, point), point);
}
