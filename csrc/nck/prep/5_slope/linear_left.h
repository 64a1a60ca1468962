// SPDX-License-Identifier: MIT
// Inside room 5: what corners and bends leave to the linear slope's brake.
#ifndef NCK_PREP_LINEAR_LEFT_H
#define NCK_PREP_LINEAR_LEFT_H

#include "nck/prep/5_slope/plan.h" // nck_pieces_t

// The acceleration of a piece that is entered under a brake at v² = vv and left no faster, at least
// that of its caps [path mm/s²]. over: by the limits for overrides beyond 100 %; period [s].
// README, section "Linear". Cost: linear in the pieces that are passed in a period, bounded.
// Context: prep.
double nck_linear_left(const nck_pieces_t *pieces, uint32_t number, double vv, uint32_t over,
                       double period);

#endif
