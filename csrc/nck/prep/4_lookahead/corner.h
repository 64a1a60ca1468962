// SPDX-License-Identifier: MIT
// Inside room 4: the speed at a junction, and the share of the acceleration that it takes.
#ifndef NCK_PREP_CORNER_H
#define NCK_PREP_CORNER_H

#include "nck/prep/4_lookahead/joint.h" // nck_lookahead_t nck_joint_t nck_joint_at

// Settle what the junction between two segs costs, once the second one is known; short lines may
// lose acceleration. The tangents are those at the junction. Cost: constant.
void nck_corner_meet(nck_joint_t *in, nck_joint_t *out, const double *tangent_in,
                     const double *tangent_out, const nck_terms_t *terms);

// Decide the next junction's speed and share at both paces. NCK_OK, or NCK_EMPTY: more segs must be
// known. Cost: 4·NCK_CORNER_SPAN neighbours at most.
nck_status_t nck_corner_decide(nck_lookahead_t *self);

#endif
