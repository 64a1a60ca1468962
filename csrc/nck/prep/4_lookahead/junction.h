// SPDX-License-Identifier: MIT
// Inside room 4: caps of segs, before any junction or envelope.
#ifndef NCK_PREP_JUNCTION_H
#define NCK_PREP_JUNCTION_H

#include "nck/base/budget.h"                // NCK_OVERRIDE_TOP
#include "nck/base/path.h"                  // nck_path_tangent_part
#include "nck/base/path_math.h"             // nck_path_slope
#include "nck/base/real.h"                  // nck_min
#include "nck/prep/4_lookahead/lookahead.h" // nck_lookahead_t nck_junction_t

// What a piece of a seg may do where junctions nearby leave so much of the acceleration: `left` is
// 1 − β.
typedef struct nck_piece_limit {
    double vv;      // v² cap at the pace
    double vv_free; // v² cap by everything but the feed
    double a;       // tangential acceleration at that pace
    double j;       // tangential jerk at that pace
    uint8_t limit;  // nck_limit_t that set vv
} nck_piece_limit_t;

// The junction with this count. Cost: constant.
static inline nck_junction_t *nck_junction_at(nck_lookahead_t *self, uint32_t count) {
    return self->junction.at + (count & (NCK_JUNCTION_MAX - 1));
}

// The largest tangential acceleration that any seg can have on this machine: √Σ a_x², path a_max at
// most.
// Cost: constant.
double nck_junction_a_any(const nck_machine_t *machine);

// The unit tangents at both ends of a seg, so many components of each, from X on; of a rest: zero.
// Returns the one at its start: start_out, or end_out where they are the same. Cost: constant.
static inline const double *nck_junction_tangents(const nck_seg_t *seg, int axes, double *start_out,
                                                  double *end_out) {
    if (!(seg->length > 0.0)) {
        for (int x = 0; x < axes; x++) end_out[x] = 0.0;
        return end_out;
    }
    if (seg->kind != NCK_SEG_ARC) {
        for (int x = 0; x < axes; x++) end_out[x] = nck_path_slope(seg, x);
        return end_out;
    }
    nck_path_tangent_part(seg, 0.0, axes, start_out);
    nck_path_tangent_part(seg, seg->length, axes, end_out);
    return start_out;
}

// The j_x/|p″| of an arc [mm²/s³]; of a line NCK_UNLIMITED. Cost: constant.
double nck_junction_bends(const nck_junction_t *junction);

// Fill in a seg's caps; the tangents are those at its start and end. Cost: constant.
void nck_junction_make(nck_junction_t *junction, const nck_seg_t *seg, const double *tangent_start,
                       const double *tangent_end, const nck_terms_t *terms);

// nck_junction_settle beyond what all segs have: under a jerk limit.
void nck_junction_settle_more(nck_junction_t *junction, double vv_in, const nck_terms_t *terms);

// Speed and limits of a seg at both paces; it is entered at vv_in at most. Cost: constant.
static inline void nck_junction_settle(nck_junction_t *junction, double vv_in,
                                       const nck_terms_t *terms) {
    const double v_free = junction->v_free;
    const double v_over = junction->feed > 0.0 ? NCK_OVERRIDE_TOP * junction->feed : v_free;
    const double speeds[NCK_PACES] = {nck_min(junction->v_max, v_free), nck_min(v_free, v_over)};
    if (v_free < junction->v_max) junction->limit = junction->limit_free;
    for (int k = 0; k < NCK_PACES; k++) {
        nck_pace_t *const at = &junction->pace[k];
        at->v = speeds[k];
        at->a = junction->a_most;
        at->j = junction->j_straight;
        at->time = junction->length / at->v;
    }
    if (terms->limits_jerk) nck_junction_settle_more(junction, vv_in, terms);
}

// What the axes leave to a line's acceleration, or to an arc's outside of its plane.
// Cost: constant.
static inline double nck_junction_straight(const nck_junction_t *junction, double left) {
    return nck_min(junction->a_most, left * junction->shape.arc.a_straight);
}

// The largest tangential acceleration anywhere on a seg, when its junctions are known: a line's may
// have come down. Cost: constant.
static inline double nck_junction_most(const nck_junction_t *junction) {
    if (junction->kind != NCK_SEG_LINE) return junction->a_most;
    return nck_min(junction->a_most, junction->shape.arc.a_straight);
}

// nck_junction_piece of an arc, whose bend costs of the speed and of the acceleration.
// Cost: constant.
nck_piece_limit_t nck_junction_curved(const nck_junction_t *junction, double left, int pace,
                                      const nck_terms_t *terms);

// Limits in a piece of the settled seg at a pace (NCK_PACE_…).
// Cost: constant.
static inline nck_piece_limit_t nck_junction_piece(const nck_junction_t *junction, double left,
                                                   int pace, const nck_terms_t *terms) {
    if (junction->kind != NCK_SEG_LINE) return nck_junction_curved(junction, left, pace, terms);
    const nck_pace_t *const at = &junction->pace[pace];
    const nck_piece_limit_t piece = {at->v * at->v, junction->v_free * junction->v_free,
                                     nck_junction_straight(junction, left), at->j, junction->limit};
    return piece;
}

// The acceleration of nck_junction_piece alone. Cost: constant.
static inline double nck_junction_accel(const nck_junction_t *junction, double left, int pace,
                                        const nck_terms_t *terms) {
    if (junction->kind == NCK_SEG_LINE) return nck_junction_straight(junction, left);
    return nck_junction_piece(junction, left, pace, terms).a;
}

#endif
