// SPDX-License-Identifier: MIT
// Inside room 5: intervals of a clocked path become the nodes of a motion.
#ifndef NCK_PREP_OPTIMAL_NODES_H
#define NCK_PREP_OPTIMAL_NODES_H

#include "nck/prep/5_slope/optimal.h" // nck_optimal_t

// What is asked of the motion: limits of each axis. Cost: linear in axes. Context: prep.
void nck_optimal_set_limits(nck_optimal_t *self, nck_motion_wish_t *asked);

// Set node k of the plan in work. Cost: linear in axes. Context: prep.
void nck_optimal_fill(nck_optimal_t *self, const nck_pieces_t *pieces, uint32_t k);

#endif
