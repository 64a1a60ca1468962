// SPDX-License-Identifier: MIT
// Inside room 5: what the parts of the optimal planner have in common.
#ifndef NCK_PREP_OPTIMAL_PACE_H
#define NCK_PREP_OPTIMAL_PACE_H

#include "nck/base/real.h"            // NCK_ONCE
#include "nck/base/tuning.h"           // NCK_MET
#include "nck/prep/5_slope/optimal.h" // nck_optimal_t
#include "nck/prep/5_slope/tuning.h" // NCK_OPTIMAL_CELL_SHARE …

// Sizes.
enum {
    NCK_OPTIMAL_GIVEN = 2, // nodes that a plan takes over from the one before
    NCK_OPTIMAL_FILL = 4, // nodes filled in one bounded step
    NCK_OPTIMAL_DRAW = 8  // cells drawn, and what is left of an interval: up to 32
};
// The pace of the plan of now, and of the one in work. Cost: constant.
static inline nck_optimal_pace_t *nck_optimal_now(nck_optimal_t *self) {
    return &self->pace[self->drawn];
}
static NCK_ONCE nck_optimal_pace_t *nck_optimal_work(nck_optimal_t *self) {
    return &self->pace[1 - self->drawn];
}

// 1 if a plan goes on from the one before: its first nodes are given. Cost: constant.
static inline int nck_optimal_goes_on(const nck_optimal_t *self) {
    return self->job.kind != NCK_JOB_START;
}

// 1 if caps have come down below what the plan of now is about to do: one that keeps within what a
// plan may be off needs no price. Cost: constant.
static inline int nck_optimal_slows(const nck_optimal_t *self) {
    return self->slower < 1.0 - NCK_MET;
}

// v² that a plan slows down to at least at a node, whatever is wanted there: that share of what the
// plan of now has, and where it is slow itself, of that share of the most. Cost: constant.
static inline double nck_optimal_floor(const nck_optimal_t *self, uint32_t k) {
    static const double share = NCK_OPTIMAL_SLOWER_LEAST * NCK_OPTIMAL_SLOWER_LEAST;
    const nck_optimal_pace_t *const now = &self->pace[self->drawn];
    const uint32_t at = self->pace[1 - self->drawn].first - now->first + k;
    return share * nck_max((double)now->along[at] * now->b[at], share * self->vv_most);
}

// v² that is wanted in a piece. Cost: constant.
static inline double nck_optimal_wanted(const nck_optimal_t *self, const nck_node_t *piece) {
    return nck_plan_cap(piece, &self->job.wish, self->next->over);
}

#endif
