// SPDX-License-Identifier: MIT
// Inside room 5: which planner is in force. The exact path has the machine's; under the optimal
// slope a clocked path has its own, from rest to rest.
#ifndef NCK_PREP_PLANNER_H
#define NCK_PREP_PLANNER_H

#include "nck/prep/5_slope/slope.h" // nck_slope_t

// The planner in force, an nck_slope_kind_t. Cost: constant.
uint32_t nck_planner_kind(const nck_slope_t *self);

// All planners of the machine's slope begin, and that of the exact path is in force.
// Cost: linear in the capacities.
void nck_planner_init(nck_slope_t *self);

// The planner of a piece's path is in force; NULL: no change. Cost: constant.
void nck_planner_choose(nck_slope_t *self, const nck_node_t *piece);

// Begin, step and hurry the plan in work: see nck_jerk_begin, nck_jerk_step, nck_jerk_hurry.
void nck_planner_begin(nck_slope_t *self, const nck_job_t *job);
nck_status_t nck_planner_step(nck_slope_t *self, const nck_pieces_t *pieces);
void nck_planner_hurry(nck_slope_t *self);

// Intervals of a clocked path that the plan in work has, while it waits for more; 0: it has all, or
// is along the exact path. Cost: constant.
uint32_t nck_planner_laid(const nck_slope_t *self);

// What the next step of the plan in work takes at most, in hundreds of a PC's instructions; 0: it
// may wait for pieces. Cost: constant.
uint32_t nck_planner_price(const nck_slope_t *self);

// The first cell of the plan of now, from this one on, that another plan can begin with.
// Cost: linear in the cells passed.
uint32_t nck_planner_seam(nck_slope_t *self, uint32_t cell);

#endif
