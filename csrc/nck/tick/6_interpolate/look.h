// SPDX-License-Identifier: MIT
// Inside room 6: what a brake of the tick looks at: the path where it is, and corners and bends
// ahead.
#ifndef NCK_TICK_LOOK_H
#define NCK_TICK_LOOK_H

#include "nck/base/limits.h"  // NCK_AXIS_MAX NCK_HAS_OPTIMAL
#include "nck/base/link.h"    // nck_link_t
#include "nck/base/records.h" // nck_seg_t
#include "nck/base/terms.h"   // nck_terms_t

// The derivatives of the path at a place, by its coordinate.
typedef struct nck_look_geometry {
    double first[NCK_AXIS_MAX];
    double second[NCK_AXIS_MAX];
    double third[NCK_AXIS_MAX];
} nck_look_geometry_t;

// Where the tool is, for a brake.
typedef struct nck_look_place {
    const nck_seg_t *seg;
    const nck_seg_t *behind; // the seg behind it; NULL: none is known, or the path rests between
    double s;                // in the seg [path mm]
    const nck_link_t *link;  // where the segs are
    nck_look_geometry_t at;
    double v, a;             // that the plan has there [path mm/s], [path mm/s²]
} nck_look_place_t;

// How it brakes.
typedef struct nck_look_tool {
    double v, a;  // [path mm/s], [path mm/s²]
    double j;     // that makes braking weaker on a line [path mm/s³]
    double end_s; // until the seg's end [s]
    double most;  // braking without bends [path mm/s²]
} nck_look_tool_t;

// 1 if a seg is an interval of a clocked path. Cost: constant. Context: tick.
static inline int nck_look_is_clocked(const nck_seg_t *seg) {
    return NCK_HAS_OPTIMAL && seg->kind == NCK_SEG_SPLINE;
}

// By what a path goes on. Cost: constant. Context: tick.
enum { NCK_GOES_NOT = 0, NCK_GOES_BY_LENGTH, NCK_GOES_BY_CLOCK };
static inline int nck_look_goes_by(const nck_seg_t *seg) {
    return NCK_GOES_BY_LENGTH + nck_look_is_clocked(seg);
}

// The path at s of a seg. Cost: three derivatives. Context: tick, as all below.
void nck_look_geometry(const nck_seg_t *seg, double s, nck_look_geometry_t *out);

// By how much p′ jumps at the place's end, at a corner or by what the seam of splines leaves, with
// the corners behind it that the sample of acceleration a period on mixes, by 1 − |t − T|/T, at the
// speed v [path mm/s]. Cost: two tangents a corner, of 16 at most.
void nck_look_corners(const nck_look_place_t *place, double v, double period, double *jump_out);

// How weak braking has to be now [path mm/s²], so that it is as weak as a bend asks for when it is
// there: here, where the tool is when braking can have become weaker by half, by all, and by half
// as much again, and at the seg's end, where p‴ jumps. Cost: as many looks at a place, and the segs
// on the way.
double nck_look_bends(const nck_terms_t *terms, const nck_look_place_t *place,
                      const nck_look_tool_t *tool);

#endif
