// SPDX-License-Identifier: MIT
// Inside room 4: what neighbouring segs have to do with a seg's speed and limits.
#ifndef NCK_PREP_NEAR_H
#define NCK_PREP_NEAR_H

#include "nck/prep/4_lookahead/joint.h" // nck_lookahead_t nck_joint_t nck_joint_at

// The least limits so near to a seg's start or end that the slope's filter mixes them with its own.
typedef struct nck_near {
    double a;    // tangential acceleration [path mm/s²]
    double j;    // tangential jerk [path mm/s³]
    double slow; // share of the speed at which NCK_NEAR_SPAN segs reach far enough; 1: all of it
} nck_near_t;

// Level the caps of neighbouring splines, once the newest joint is known.
// Cost: NCK_NEAR_SPAN neighbours at most.
void nck_near_level(nck_lookahead_t *self);

// The path ends behind the newest joint: its splines come down to the rest there.
// Cost: as above.
void nck_near_end(nck_lookahead_t *self);

// Nobody knows when more comes: what is known may be settled as it is, and what is still to come is
// levelled with it. Cost: constant.
void nck_near_hurry(nck_lookahead_t *self);

// Settle the next joint's speeds and limits, as nck_lookahead_may_settle allows. Cost: constant.
void nck_near_settle(nck_lookahead_t *self);

// The least limits, under the share beta, near a seg's start (end), its own apart.
// after: NCK_EMPTY if segs are not settled that far. Cost: NCK_NEAR_SPAN neighbours at most.
nck_near_t nck_near_before(nck_lookahead_t *self, uint32_t count, int pace, double beta);
nck_status_t nck_near_after(nck_lookahead_t *self, uint32_t count, int pace, double beta,
                            nck_near_t *near_out);

#endif
