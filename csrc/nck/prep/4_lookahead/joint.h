// SPDX-License-Identifier: MIT
// Inside room 4: caps of segs and junctions, before any envelope.
#ifndef NCK_PREP_JOINT_H
#define NCK_PREP_JOINT_H

#include "nck/prep/4_lookahead/lookahead.h" // nck_lookahead_t nck_joint_t

// What a piece of a seg may do when junctions nearby use the share beta of the acceleration.
typedef struct nck_piece_limit {
    double vv;     // v² cap
    double a;      // tangential acceleration
    uint8_t limit; // nck_limit_t that set vv
} nck_piece_limit_t;

// The joint with this count. Cost: constant.
nck_joint_t *nck_joint_at(nck_lookahead_t *self, uint32_t count);

// The largest tangential acceleration that any seg can have on this machine: √Σ a_x², path a_max at
// most.
// Cost: constant.
double nck_joint_a_any(const nck_machine_t *machine);

// The unit tangents at both ends of a seg, NCK_AXIS_MAX components each; of a rest: zero.
// Cost: constant.
void nck_joint_tangents(const nck_seg_t *seg, double *start_out, double *end_out);

// Fill in a seg's caps; the tangents are those at its start and end. Cost: constant.
void nck_joint_make(nck_joint_t *joint, const nck_seg_t *seg, const double *tangent_start,
                    const double *tangent_end, const nck_machine_t *machine);

// Settle what the junction between two segs costs, once the second one is known. The tangents are
// those at the junction. Cost: constant.
void nck_joint_meet(nck_joint_t *in, const nck_joint_t *out, const double *tangent_in,
                    const double *tangent_out, const nck_machine_t *machine);

// Decide the next junction's speed and share. NCK_OK, or NCK_EMPTY: more segs must be known.
// Cost: 2·NCK_CORNER_SPAN neighbours at most.
nck_status_t nck_joint_decide(nck_lookahead_t *self);

// The largest share that junctions within one period before (after) the seg's start (end) use.
// after: NCK_EMPTY if junctions are not decided that far. Cost: NCK_CORNER_SPAN neighbours at most.
double nck_joint_share_before(nck_lookahead_t *self, uint32_t count);
nck_status_t nck_joint_share_after(nck_lookahead_t *self, uint32_t count, double *share_out);

// Limits in a piece of the seg under the share beta. Cost: constant.
nck_piece_limit_t nck_joint_piece(const nck_joint_t *joint, double beta,
                                  const nck_machine_t *machine);

#endif
