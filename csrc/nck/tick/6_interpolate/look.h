// SPDX-License-Identifier: MIT
// Inside room 6: what a brake of the tick looks at: the path where it is, and corners and bends
// ahead.
#ifndef NCK_TICK_LOOK_H
#define NCK_TICK_LOOK_H

#include "nck/base/limits.h"  // NCK_AXIS_MAX NCK_HAS_OPTIMAL
#include "nck/base/link.h"    // nck_link_t
#include "nck/base/records.h" // nck_seg_t
#include "nck/base/terms.h"   // nck_terms_t

// The derivatives of the path by its length at a place, and those of the seg's coordinate by it.
typedef struct nck_look_geometry {
    double first[NCK_AXIS_MAX];
    double second[NCK_AXIS_MAX];
    double third[NCK_AXIS_MAX];
    double s[3];
} nck_look_geometry_t;

// Where the tool is, for a brake.
typedef struct nck_look_place {
    const nck_seg_t *seg;
    const nck_seg_t *behind; // the seg behind it; NULL: none is known, or the path rests between
    double s;                // in the seg [path mm]
    const nck_link_t *link;  // where the segs are
    nck_look_geometry_t at;
    double v, a, j;          // that the plan has there [path mm/s], [path mm/s²], [path mm/s³]
} nck_look_place_t;

// 1 if a seg is an interval of a clocked path. Cost: constant. Context: tick.
static inline int nck_look_is_clocked(const nck_seg_t *seg) {
    return NCK_HAS_OPTIMAL && seg->keeps == NCK_KEEP_CLOCK;
}

// a·b over all axes. Cost: linear in them. Context: tick, as all below.
static inline double nck_look_dot(const double *a, const double *b) {
    double sum = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) sum += a[x] * b[x];
    return sum;
}

// How far the seg's coordinate goes on over a length of the path [path mm]. Cost: constant.
static inline double nck_look_way(const nck_look_geometry_t *at, double length) {
    if (!NCK_HAS_OPTIMAL) return length;
    return (at->s[0] + (0.5 * at->s[1] + at->s[2] / 6.0 * length) * length) * length;
}

// The path at s of a seg. On a clocked path the coordinate goes on by the clock, so a brake goes by
// the length. Cost: three derivatives.
void nck_look_geometry(const nck_seg_t *seg, double s, nck_look_geometry_t *out);

// By how much p′ jumps at the place's end, at a corner or by what the seam of splines leaves, with
// the corners behind it that the sample of acceleration a period on mixes, by 1 − |t − T|/T, at the
// speed v [path mm/s]. Cost: two tangents a corner, of 16 at most.
void nck_look_corners(const nck_look_place_t *place, double v, double period, double *jump_out);

// How weak braking has to be now [path mm/s²], so that it is as weak as a bend asks for when it is
// there: here, where the tool is when braking can have become weaker by half, by all, and by half
// as much again, and at the seg's end, where p‴ jumps. v, a: of the tool [path mm/s], [path mm/s²];
// j: that makes braking weaker on a line [path mm/s³]; end_s: until that end.
// Cost: as many looks at a place, and the segs on the way.
double nck_look_bends(const nck_terms_t *terms, const nck_look_place_t *place, double v, double a,
                      double j, double end_s);

#endif
