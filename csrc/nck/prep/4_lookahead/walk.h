// SPDX-License-Identifier: MIT
// Inside room 4: a junction's neighbours on both sides, nearest first.
#ifndef NCK_PREP_WALK_H
#define NCK_PREP_WALK_H

#include "nck/prep/4_lookahead/joint.h" // nck_lookahead_t nck_joint_t nck_joint_at

// What is known of the next neighbour on one side.
typedef enum nck_side_state {
    NCK_SIDE_KNOWN,
    NCK_SIDE_UNKNOWN, // the next neighbour's load hangs on a seg that is still to come
    NCK_SIDE_OVER     // no more neighbours
} nck_side_state_t;

// One direction of a walk along the junctions, away from the one in the middle.
typedef struct nck_side {
    uint32_t at;        // the next neighbour: the junction at the end of this joint
    uint32_t steps;     // neighbours so far
    double x;           // its distance [mm]; of an unknown one, the least that it can be
    nck_side_state_t state;
} nck_side_t;

// A walk in both directions.
typedef struct nck_walk {
    nck_side_t ahead;
    nck_side_t behind;
    double cut;         // where a side was cut off at NCK_CORNER_SPAN neighbours [mm]
} nck_walk_t;

// Stand at the junction at the end of joint `count`. Cost: constant.
void nck_walk_begin(nck_lookahead_t *self, nck_walk_t *walk, uint32_t count);

// The next neighbour nearer than reach [mm], and its distance [mm]. NCK_OK; NCK_DONE: no more;
// NCK_EMPTY: not known yet. Cost: constant.
nck_status_t nck_walk_next(nck_lookahead_t *self, nck_walk_t *walk, double reach,
                           const nck_joint_t **joint_out, double *x_out);

#endif
