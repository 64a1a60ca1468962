// SPDX-License-Identifier: MIT
// Inside room 4: caps of segs, before any junction or envelope.
#ifndef NCK_PREP_JOINT_H
#define NCK_PREP_JOINT_H

#include "nck/base/budget.h"                // NCK_OVERRIDE_TOP
#include "nck/base/path.h"                  // nck_path_tangent_part
#include "nck/base/path_math.h"             // nck_path_slope
#include "nck/base/real.h"                  // nck_min nck_sqrt
#include "nck/prep/4_lookahead/lookahead.h" // nck_lookahead_t nck_joint_t

// What a piece of a seg may do when junctions nearby use the share beta of the acceleration.
typedef struct nck_piece_limit {
    double vv;      // v² cap at the pace
    double vv_free; // v² cap by everything but the feed
    double a;       // tangential acceleration at that pace
    double j;       // tangential jerk at that pace
    uint8_t limit;  // nck_limit_t that set vv
} nck_piece_limit_t;

// The joint with this count. Cost: constant.
static inline nck_joint_t *nck_joint_at(nck_lookahead_t *self, uint32_t count) {
    return self->joint.at + (count & (NCK_JOINT_MAX - 1));
}

// The largest tangential acceleration that any seg can have on this machine: √Σ a_x², path a_max at
// most.
// Cost: constant.
double nck_joint_a_any(const nck_machine_t *machine);

// The unit tangents at both ends of a seg, so many components of each, from X on; of a rest: zero.
// Returns the one at its start: start_out, or end_out where they are the same. Cost: constant.
static inline const double *nck_joint_tangents(const nck_seg_t *seg, int axes, double *start_out,
                                               double *end_out) {
    const int is_bent = seg->kind == NCK_SEG_ARC || seg->kind == NCK_SEG_SPLINE;
    if (!(seg->length > 0.0)) {
        for (int x = 0; x < axes; x++) end_out[x] = 0.0;
        return end_out;
    }
    if (!is_bent) {
        for (int x = 0; x < axes; x++) end_out[x] = nck_path_slope(seg, x);
        return end_out;
    }
    nck_path_tangent_part(seg, 0.0, axes, start_out);
    nck_path_tangent_part(seg, seg->length, axes, end_out);
    return start_out;
}

// Into how many joints a spline is worth to be parted. joint: the whole seg's. Cost: constant.
int nck_joint_parts(const nck_joint_t *joint, const nck_terms_t *terms);

// The least j_x/|p″| of a spline or an arc [mm²/s³]. Cost: constant.
double nck_joint_bends(const nck_joint_t *joint, const nck_terms_t *terms);

// What a spline's bends leave of the path's acceleration at v². Cost: constant.
double nck_joint_left(const nck_joint_t *joint, double w, const nck_terms_t *terms);

// Fill in a seg's caps, of a spline those from span[0] to span[1]; the tangents are those at the
// seg's start and end, of a spline nobody asks for them. Cost: constant.
void nck_joint_make(nck_joint_t *joint, const nck_seg_t *seg, const double span[2],
                    const double *tangent_start, const double *tangent_end,
                    const nck_terms_t *terms);

// nck_joint_settle beyond what all segs have: of splines, and under a jerk limit.
void nck_joint_settle_more(nck_joint_t *joint, double v_free, double w_in,
                           const nck_terms_t *terms);

// Speed and limits of a seg at both paces, once w_near is known; it is entered at w_in at most.
// Cost: constant.
static inline void nck_joint_settle(nck_joint_t *joint, double w_in, const nck_terms_t *terms) {
    const int bends = joint->kind == NCK_SEG_SPLINE;
    const double v_free = bends ? nck_sqrt(joint->w_near) : joint->v_free;
    const double v_over = joint->feed > 0.0 ? NCK_OVERRIDE_TOP * joint->feed : v_free;
    const double speeds[NCK_PACES] = {nck_min(joint->v_max, v_free), nck_min(v_free, v_over)};
    if (v_free < joint->v_max) joint->limit = joint->limit_free;
    for (int k = 0; k < NCK_PACES; k++) {
        nck_pace_t *const at = &joint->pace[k];
        at->v = speeds[k];
        at->a = joint->a_most;
        at->j = joint->j_straight;
        at->time = joint->length / at->v;
    }
    if (bends || terms->limits_jerk) nck_joint_settle_more(joint, v_free, w_in, terms);
}

// What the axes leave to a line's acceleration, or to an arc's outside of its plane, under beta.
// Cost: constant.
static inline double nck_joint_straight(const nck_joint_t *joint, double beta) {
    return nck_min(joint->a_most, (1.0 - beta) * joint->shape.arc.a_straight);
}

// The largest tangential acceleration anywhere on a seg, when its junctions are known: a line's may
// have come down. Cost: constant.
static inline double nck_joint_most(const nck_joint_t *joint) {
    return joint->kind == NCK_SEG_LINE ? nck_joint_straight(joint, 0.0) : joint->a_most;
}

// nck_joint_piece of arcs and splines: bends cost of the speed and of the acceleration.
// Cost: constant.
nck_piece_limit_t nck_joint_curved(const nck_joint_t *joint, double beta, int pace,
                                   const nck_terms_t *terms);

// Limits in a piece of the settled seg at a pace (NCK_PACE_…), under the share beta.
// Cost: constant.
static inline nck_piece_limit_t nck_joint_piece(const nck_joint_t *joint, double beta, int pace,
                                                const nck_terms_t *terms) {
    if (joint->kind != NCK_SEG_LINE) return nck_joint_curved(joint, beta, pace, terms);
    const nck_pace_t *const at = &joint->pace[pace];
    const nck_piece_limit_t piece = {at->v * at->v, joint->v_free * joint->v_free,
                                     nck_joint_straight(joint, beta), at->j, joint->limit};
    return piece;
}

// The acceleration of nck_joint_piece alone. Cost: constant.
static inline double nck_joint_accel(const nck_joint_t *joint, double beta, int pace,
                                     const nck_terms_t *terms) {
    if (joint->kind == NCK_SEG_LINE) return nck_joint_straight(joint, beta);
    return nck_joint_piece(joint, beta, pace, terms).a;
}

#endif
