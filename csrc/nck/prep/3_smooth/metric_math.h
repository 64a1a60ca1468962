// SPDX-License-Identifier: MIT
// Lengths: of the path, and of what the program's feed is meant for.
#ifndef NCK_PREP_METRIC_MATH_H
#define NCK_PREP_METRIC_MATH_H

#include "nck/base/path_math.h" // nck_path_turns
#include "nck/base/real.h"      // nck_real nck_sqrt
#include "nck/base/records.h"   // nck_seg_t axis order

// Σ (end − start)² over the axes first … last, but for the two of an arc's plane.
static inline nck_real nck_metric_straight(const nck_seg_t *seg, int first, int last) {
    nck_real sum = 0.0;
    for (int x = first; x <= last && x < NCK_AXIS_MAX; x++) {
        const nck_real d = seg->end[x] - seg->start[x];
        if (!nck_path_turns(seg, x)) sum += d * d;
    }
    return sum;
}

// The square of the way round an arc, (r·sweep)², r from the start point; 0 for a line.
static inline nck_real nck_metric_round(const nck_seg_t *seg) {
    if (seg->kind != NCK_SEG_ARC) return 0.0;
    const nck_seg_arc_t *const arc = &seg->shape.arc;
    const nck_real ru = seg->start[arc->axis_u] - arc->centre_u;
    const nck_real rv = seg->start[arc->axis_v] - arc->centre_v;
    return (ru * ru + rv * rv) * arc->sweep * arc->sweep;
}

// Path length: √(Σ all axes), one degree counted as one millimetre (README, "the path metric").
static inline nck_real nck_metric_length(const nck_seg_t *seg) {
    return nck_sqrt(nck_metric_round(seg) + nck_metric_straight(seg, 0, NCK_AXIS_MAX - 1));
}

// The length that a feed in units per minute is meant for: X Y Z if any of them moves; else U V W;
// else the rotary axes, in degrees (NISTIR 6556, section 2.1.2.5).
static inline nck_real nck_metric_feed_length(const nck_seg_t *seg) {
    const nck_real xyz = nck_metric_round(seg) + nck_metric_straight(seg, NCK_AXIS_X, NCK_AXIS_Z);
    if (xyz > 0.0) return nck_sqrt(xyz);
    const nck_real uvw = nck_metric_straight(seg, NCK_AXIS_U, NCK_AXIS_W);
    if (uvw > 0.0) return nck_sqrt(uvw);
    return nck_sqrt(nck_metric_straight(seg, NCK_AXIS_A, NCK_AXIS_C));
}

#endif
