// SPDX-License-Identifier: MIT
// Inside room 5: what the parts of the optimal planner have in common.
#ifndef NCK_PREP_OPTIMAL_PACE_H
#define NCK_PREP_OPTIMAL_PACE_H

#include "nck/prep/5_slope/optimal.h" // nck_optimal_t

// Sizes.
enum {
    NCK_OPTIMAL_GIVEN = 2, // nodes that a plan takes over from the one before
    NCK_OPTIMAL_FILL = 4, // nodes filled in one bounded step
    NCK_OPTIMAL_DRAW = 8  // cells drawn, and what is left of an interval: up to 32
};
// A plan that keeps within so much of the caps needs no price.
#define NCK_OPTIMAL_NOT_SLOWER 0.999

// The pace of the plan of now, and of the one in work. Cost: constant.
static inline nck_optimal_pace_t *nck_optimal_now(nck_optimal_t *self) {
    return &self->pace[self->drawn];
}
static inline nck_optimal_pace_t *nck_optimal_work(nck_optimal_t *self) {
    return &self->pace[1 - self->drawn];
}

// 1 if a plan goes on from the one before: its first nodes are given. Cost: constant.
static inline int nck_optimal_goes_on(const nck_optimal_t *self) {
    return self->job.kind != NCK_JOB_START;
}

// 1 if caps have come down below what the plan of now is about to do. Cost: constant.
static inline int nck_optimal_slows(const nck_optimal_t *self) {
    return self->slower < NCK_OPTIMAL_NOT_SLOWER;
}

// v² that is wanted in a piece: none at a rest. Cost: constant.
static inline double nck_optimal_wanted(const nck_optimal_t *self, const nck_node_t *piece) {
    if (self->job.kind == NCK_JOB_BRAKE) return 0.0;
    return nck_plan_cap(piece, &self->job.wish, self->next->over);
}

#endif
