// SPDX-License-Identifier: MIT
// Inside room 5: soft limits, and the hold before the path leaves them. Face: nck_set_travel.
#ifndef NCK_PREP_TRAVEL_H
#define NCK_PREP_TRAVEL_H

#include "nck/base/link.h"         // nck_link_t
#include "nck/base/terms.h"        // nck_terms_t
#include "nck/prep/5_slope/plan.h" // nck_pieces_t

// Soft limits, and how far the path is known to keep within them.
typedef struct nck_travel {
    uint32_t set;      // 1: an axis has soft limits
    uint32_t known;    // 1: the path from the front on is looked through from `seq` on
    uint32_t seq;      // seg that is looked at
    uint32_t leaves;   // 1: `exit` is known
    uint32_t stops;    // 1: the path has to rest before it, at once; prep writes, any context reads
    double s;          // up to there in the seg it is inside [path mm]
    double exit;       // where the path leaves, from the program's start [path mm]
    double asked;      // where the front was when it was last asked how near that is [path mm] …
    uint32_t asked_end; // … and how far the pieces were known
    double least[NCK_AXIS_MAX]; // [mm, deg]
    double most[NCK_AXIS_MAX];
} nck_travel_t;

// No soft limits. Cost: constant. Context: any, before the tick runs.
void nck_travel_init(nck_travel_t *self);

// Soft limits of an axis; the path is looked through anew. least ≤ most [mm, deg].
// Cost: constant. Context: prep.
void nck_travel_set(nck_travel_t *self, int axis, double least, double most);

// The path begins anew. Cost: constant. Context: prep.
void nck_travel_begin(nck_travel_t *self);

// 1 if an axis has soft limits. Cost: constant. Context: prep.
static inline int nck_travel_is_set(const nck_travel_t *self) { return self->set != 0; }

// Look further along the path, if soft limits are set. Returns 1 if it has to rest as soon as it
// can.
// Cost: 32 points of the path; once it is known to leave, linear in the window whenever
// the front or the window has moved. Context: prep.
int nck_travel_step(nck_travel_t *self, const nck_terms_t *terms, const nck_link_t *link,
                    const nck_pieces_t *pieces);

#endif
