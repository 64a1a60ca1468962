// SPDX-License-Identifier: MIT
// Inside room 4: speed and share of junctions, and how far they reach.
#ifndef NCK_PREP_CORNER_H
#define NCK_PREP_CORNER_H

#include "nck/prep/4_lookahead/joint.h" // nck_lookahead_t nck_joint_t nck_joint_at

// How long before and after a junction its share is kept free: one period, and half of what the
// slope's filter mixes [s]. Cost: constant.
double nck_corner_zone_s(const nck_terms_t *terms);

// Settle what the junction between two segs costs, once the second one is known. The tangents are
// those at the junction. Cost: constant.
void nck_corner_meet(nck_joint_t *in, const nck_joint_t *out, const double *tangent_in,
                     const double *tangent_out, const nck_terms_t *terms);

// Decide the next junction's speed and share at both paces. NCK_OK, or NCK_EMPTY: more segs must be
// known. Cost: 4·NCK_CORNER_SPAN neighbours at most.
nck_status_t nck_corner_decide(nck_lookahead_t *self);

// The largest share that junctions use so near before (after) the seg's start (end) that it must be
// kept free there. after: NCK_EMPTY if junctions are not decided that far.
// Cost: NCK_CORNER_SPAN neighbours at most.
double nck_corner_share_before(nck_lookahead_t *self, uint32_t count, int pace);
nck_status_t nck_corner_share_after(nck_lookahead_t *self, uint32_t count, int pace,
                                    double *share_out);

#endif
