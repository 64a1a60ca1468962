// SPDX-License-Identifier: MIT
// Inside room 4: the speed at a junction, and the share of the acceleration that it takes.
#ifndef NCK_PREP_CORNER_H
#define NCK_PREP_CORNER_H

#include "nck/prep/4_lookahead/junction.h" // nck_lookahead_t nck_junction_t nck_junction_at

// Settle what the junction between two segs costs, once the second one is known; short lines may
// lose acceleration. The tangents are those at the junction. Cost: constant.
void nck_corner_meet(nck_junction_t *in, nck_junction_t *out, const double *tangent_in,
                     const double *tangent_out, const nck_terms_t *terms);

// Whether what the next junction hangs on is known, as far as it can be told without a look around:
// it needs both its segs; a rest, and the path's end, have one. Cost: constant.
static inline int nck_corner_may_decide(nck_lookahead_t *self) {
    const uint32_t known = self->junction.settled - self->junction.decided;
    if (self->junction.known == self->junction.head && !self->ended) return 0;
    if (known != 1) return known > 1;
    if (self->junction.settled != self->junction.head) return 0;
    return self->ended || nck_junction_at(self, self->junction.decided)->kind >= NCK_SEG_DWELL;
}

// Decide the next junction's speed and share at both paces, as nck_corner_may_decide allows.
// NCK_OK, or NCK_EMPTY: more segs must be known. Cost: 4·NCK_CORNER_SPAN neighbours at most.
nck_status_t nck_corner_decide(nck_lookahead_t *self);

#endif
