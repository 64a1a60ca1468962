// SPDX-License-Identifier: MIT
// Inside room 4: what neighbouring segs have to do with a seg's speed and limits.
#ifndef NCK_PREP_NEAR_H
#define NCK_PREP_NEAR_H

#include "nck/prep/4_lookahead/junction.h" // nck_lookahead_t nck_junction_t nck_junction_at
#include "nck/prep/4_lookahead/zone.h"     // nck_zone_count_dense

// The least limits so near to a seg's start or end that the slope's filter mixes them with its own.
typedef struct nck_near {
    double a;    // tangential acceleration [path mm/s²]
    double j;    // tangential jerk [path mm/s³]
    double slow; // share of the speed at which NCK_NEAR_SPAN segs reach far enough; 1: all of it
    double vv;   // v² at the start or end is no more, by the junctions so near
} nck_near_t;

// 1 if nothing moves out of a junction (NULL: the path's begin). Cost: constant.
static inline int nck_near_rests(const nck_junction_t *junction) {
    return !junction || (junction->end & NCK_JUNCTION_STOP) || junction->kind >= NCK_SEG_DWELL;
}

// v² at which a junction is entered at most. Cost: constant.
static inline double nck_near_entered_at(nck_lookahead_t *self, uint32_t at) {
    const nck_junction_t *const before =
        at > 0 ? nck_junction_at(self, at - 1) : (nck_junction_t *)0;
    return nck_near_rests(before) ? 0.0 : before->vv_out;
}

// What a junction is left at, at most, if it is entered at vv_in: vv_out. Cost: constant.
static inline void nck_near_set_out(nck_junction_t *junction, double vv_in) {
    junction->vv_out = nck_min(junction->v_free * junction->v_free,
                               vv_in + 2.0 * junction->a_most * junction->length);
}

// Settle the next junction's speeds and limits, as nck_lookahead_step has it. Cost: constant.
static inline void nck_near_settle(nck_lookahead_t *self) {
    const uint32_t count = self->junction.settled;
    const double vv_in = self->terms->limits_jerk ? nck_near_entered_at(self, count) : 0.0;
    nck_junction_t *const junction = nck_junction_at(self, count);
    nck_junction_settle(junction, vv_in, self->terms);
    nck_zone_count_dense(self, junction);
    self->junction.settled++;
}

// The least limits, with what junctions leave, near a seg's start (end), its own apart.
// after: NCK_EMPTY if segs are not settled that far. Cost: NCK_NEAR_SPAN neighbours at most.
void nck_near_before(nck_lookahead_t *self, uint32_t count, int pace, double left,
                     nck_near_t *near_out);
nck_status_t nck_near_after(nck_lookahead_t *self, uint32_t count, int pace, double left,
                            nck_near_t *near_out);

#endif
