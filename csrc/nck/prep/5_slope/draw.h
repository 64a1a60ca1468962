// SPDX-License-Identifier: MIT
// Inside room 5: a plan over the ladder as cells of a tail.
#ifndef NCK_PREP_DRAW_H
#define NCK_PREP_DRAW_H

#include "nck/prep/5_slope/jerk.h" // nck_jerk_t nck_pieces_t

// The plan as cells of a tail. NCK_OK: call again; NCK_DONE. Cost: bounded.
nck_status_t nck_draw_cells(nck_jerk_t *self, const nck_pieces_t *pieces);

#endif
