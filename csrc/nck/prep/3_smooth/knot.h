// SPDX-License-Identifier: MIT
// Inside room 3: where the knots go.
#ifndef NCK_PREP_KNOT_H
#define NCK_PREP_KNOT_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t

// Begin a run at the front block: all knots at its begin. Cost: constant.
void nck_knot_begin(nck_smooth_t *self);

// Choose t[5], so that the seg over t[2] … t[3] is known and within the tolerance, and could be
// followed by an end at t[5] that is within it too. Where nothing fits, the spline ends at t[4] and
// rests there (run.rest); from such a rest something always fits (README, "Always a way on").
// Returns NCK_OK; NCK_FULL: call again; NCK_EMPTY if more blocks must be known.
// Cost: see nck_smooth_pull.
nck_status_t nck_knot_choose(nck_smooth_t *self);

// Go on by one knot: t[2] … t[3] is done with; behind a rest, begin anew there. Cost: constant.
void nck_knot_advance(nck_smooth_t *self);

// 1 if the path rests at this place, which the spline has come to. Cost: linear in outputs at the
// end of the run.
int nck_knot_rests(nck_smooth_t *self, double s);

#endif
