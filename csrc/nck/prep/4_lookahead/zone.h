// SPDX-License-Identifier: MIT
// Inside room 4: how far around a junction its share of the acceleration is kept free.
#ifndef NCK_PREP_ZONE_H
#define NCK_PREP_ZONE_H

#include "nck/prep/4_lookahead/joint.h" // nck_lookahead_t nck_joint_t nck_joint_at

// A seg is cut where its zones end only if it is longer than both of them together by so much: the
// middle is to be worth a piece.
#define NCK_ZONES_CUT 1.3

// How long before and after a junction its share is kept free: one period, and half of what the
// slope's filter mixes [s]. Cost: constant.
double nck_zone_s(const nck_terms_t *terms);

// 1 if a rest lasts longer than the zones of both its ends: what is before it has nothing to do
// with what is behind it. Cost: constant.
static inline int nck_zone_rests(double dwell_s, double zone_s) {
    return dwell_s >= 2.0 * zone_s;
}

// 1 if a joint is such a rest, or a WAIT. Cost: constant.
static inline int nck_zone_parts(const nck_joint_t *joint, double zone_s) {
    if (joint->kind < NCK_SEG_DWELL) return 0;
    return joint->kind == NCK_SEG_WAIT
           || (joint->kind == NCK_SEG_DWELL && nck_zone_rests(joint->shape.dwell_s, zone_s));
}

// 1 if no other junction is near one of this load [s²/mm] between two segs. Cost: constant.
int nck_zone_is_alone(const nck_joint_t *in, const nck_joint_t *out, double load,
                      const nck_terms_t *terms);

// The largest share that junctions use, by pace, so near before (after) the seg's start (end) that
// it must be kept free there. after: NCK_EMPTY if junctions are not decided that far.
// Cost: NCK_CORNER_SPAN neighbours at most.
void nck_zone_shares_before(nck_lookahead_t *self, uint32_t count, double share_out[NCK_PACES]);
nck_status_t nck_zone_shares_after(nck_lookahead_t *self, uint32_t count,
                                   double share_out[NCK_PACES]);

#endif
