// SPDX-License-Identifier: MIT
// Inside room 5: the motion along a clocked path becomes cells, two or more an interval.
#ifndef NCK_PREP_OPTIMAL_DRAW_H
#define NCK_PREP_OPTIMAL_DRAW_H

#include "nck/prep/5_slope/optimal.h" // nck_optimal_t

// Draw some intervals of the plan in work. NCK_OK: call again; NCK_DONE: it stands in the link's
// built tail. Cost: NCK_OPTIMAL_DRAW intervals. Context: prep.
nck_status_t nck_optimal_draw(nck_optimal_t *self, const nck_pieces_t *pieces);

#endif
