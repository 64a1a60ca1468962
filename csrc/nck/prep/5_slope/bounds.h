// SPDX-License-Identifier: MIT
// Inside room 5: caps and limits of the cells of a ladder, and whether a hold keeps to them.
#ifndef NCK_PREP_BOUNDS_H
#define NCK_PREP_BOUNDS_H

#include "nck/prep/5_slope/jerk.h" // nck_jerk_t nck_pieces_t

// Caps and limits of every cell and node. NCK_OK: call again; NCK_DONE. Cost: bounded.
nck_status_t nck_bounds_set(nck_jerk_t *self, const nck_pieces_t *pieces);

// Whether a hold keeps to what bends leave at the speeds that it has in the end. NCK_OK: call
// again; NCK_DONE; NCK_E_STATE: it does not. Cost: bounded.
nck_status_t nck_bounds_check(nck_jerk_t *self, const nck_pieces_t *pieces);

#endif
