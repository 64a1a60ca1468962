// SPDX-License-Identifier: MIT
// Inside the profile: its first passes, by acceleration alone. Each does nodes from self->i on,
// `budget` units at most, and returns how many it has done. What it carries from node to node
// stands in self between two calls, and in locals within one. Cost: a node a unit. Context: any one
// context.
#ifndef NCK_PREP_PROFILE_REACH_H
#define NCK_PREP_PROFILE_REACH_H

#include "nck/prep/5_slope/profile.h" // nck_profile_t

// How many nodes of a backward pass are left, or the budget if it is less.
static inline uint32_t nck_profile_left_back(const nck_profile_t *self, uint32_t budget) {
    const uint32_t left = self->i + 1;
    return left < budget ? left : budget;
}

// The same of a forward one.
static inline uint32_t nck_profile_left_forth(const nck_profile_t *self, uint32_t budget) {
    const uint32_t left = self->n + 1 - self->i;
    return left < budget ? left : budget;
}

// vv: what can be braked from, backward, by acceleration alone.
uint32_t nck_profile_reach_back(nck_profile_t *self, uint32_t budget);

// vv: what can be reached as well, forward. Also the bound on deceleration, which falls into a
// stretch of less no faster than the jerk lets it; the last cell where the limit steps; and j.
uint32_t nck_profile_reach_forth(nck_profile_t *self, uint32_t budget);

// The same for the bound on acceleration, from the last step on: behind it nothing changes. e: the
// envelope backward; vv stays, for its durations.
uint32_t nck_profile_ramp_back(nck_profile_t *self, uint32_t budget);

// vv: the envelope under both bounds, U, from the first node on that the ramps change.
uint32_t nck_profile_ramp_forth(nck_profile_t *self, uint32_t budget);

#endif
