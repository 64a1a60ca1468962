// SPDX-License-Identifier: MIT
// Inside room 4: how far around a junction its share of the acceleration is kept free.
#ifndef NCK_PREP_ZONE_H
#define NCK_PREP_ZONE_H

#include "nck/base/budget.h"                 // NCK_UNLIMITED
#include "nck/prep/4_lookahead/junction.h"   // nck_lookahead_t nck_junction_t nck_junction_at
#include "nck/prep/4_lookahead/limit_math.h" // NCK_CORNER_SHARE_…

// A seg is cut where its zones end only if it is longer than both of them together by so much: the
// middle is to be worth a piece.
#define NCK_ZONES_CUT 1.3

// Of a zone's time: more than the rounding of floats that count it.
#define NCK_ZONE_MARGIN 1.001

// How long before and after a junction its share is kept free: one period, and half of what the
// slope's filter mixes [s]. Cost: constant.
double nck_zone_s(const nck_terms_t *terms);

// 1 if a rest lasts longer than the zones of both its ends: what is before it has nothing to do
// with what is behind it. Cost: constant.
static inline int nck_zone_rests(double dwell_s, double zone_s) {
    return dwell_s >= 2.0 * zone_s;
}

// 1 if a junction is such a rest, a WAIT, or of a clocked path. Cost: constant.
static inline int nck_zone_parts(const nck_junction_t *junction, double zone_s) {
    if (junction->kind < NCK_SEG_DWELL) return 0;
    return junction->kind == NCK_SEG_WAIT || junction->kind == NCK_JUNCTION_CLOCKED
           || (junction->kind == NCK_SEG_DWELL && nck_zone_rests(junction->shape.dwell_s, zone_s));
}

// 1 if no other junction is near one of this load [s²/mm] between two segs. Cost: constant.
int nck_zone_is_alone(const nck_junction_t *in, const nck_junction_t *out, double load,
                      const nck_terms_t *terms);

// A walk away from a seg at both paces. No seg takes longer with an override than without: so the
// zone is left at NCK_PACE_OVER last.
typedef struct nck_zone_reach {
    double time[NCK_PACES];  // so far [s]
    double share[NCK_PACES]; // the largest
    double known;            // at NCK_PACE_OVER, as far as junctions are decided, if that is where
                             // the zone is left; else NCK_UNLIMITED [s]
} nck_zone_reach_t;

// The walk comes to a junction's end. Cost: constant.
static inline void nck_zone_meet(nck_zone_reach_t *reach, const nck_junction_t *junction,
                                 double zone_s) {
    for (int k = 0; k < NCK_PACES; k++) {
        if (k != NCK_PACE_FEED || reach->time[k] < zone_s) {
            reach->share[k] = nck_max(reach->share[k], junction->pace[k].share);
        }
    }
}

// The walk passes a junction. Returns 1 if the zone ends within it. Cost: constant.
static inline int nck_zone_pass(nck_zone_reach_t *reach, const nck_junction_t *junction,
                                double zone_s) {
    for (int k = 0; k < NCK_PACES; k++) reach->time[k] += junction->pace[k].time;
    return reach->time[NCK_PACE_OVER] >= zone_s;
}

// The walk ends at NCK_CORNER_SPAN neighbours, short of the zone's end. Under a jerk limit the seg
// is slowed until it does not (near.h); else share is assumed, the largest that may be further on.
// Cost: constant.
static inline void nck_zone_cut_off(nck_zone_reach_t *reach, const nck_lookahead_t *self,
                                    double share) {
    for (int k = 0; k < NCK_PACES; k++) {
        const int is_short = reach->time[k] < self->zone_s && !self->terms->limits_jerk;
        if (is_short) reach->share[k] = nck_max(reach->share[k], share);
    }
}

// 1 if NCK_CORNER_SPAN segs from this one on take so little time that a walk along them is cut off.
// Without a jerk limit it need not be made: what is assumed then is no less than what it meets, for
// a dense row is never an even polygon, whose junctions alone get more. Cost: constant.
static inline int nck_zone_is_dense(const nck_lookahead_t *self, uint32_t first) {
    return (int32_t)(first - self->junction.dense) >= 0;
}

// The next seg is settled: whether it goes on with such a row. Cost: constant.
static inline void nck_zone_count_dense(nck_lookahead_t *self, const nck_junction_t *junction) {
    const double least = NCK_CORNER_SPAN * NCK_ZONE_MARGIN * junction->pace[NCK_PACE_FEED].time;
    const int is_dense = least < self->zone_s && junction->kind < NCK_SEG_DWELL;
    if (!is_dense) self->junction.dense = self->junction.settled + 1;
}

// How many segs of a walk along a dense row, or along none, need not be looked at. Cost: constant.
static inline uint32_t nck_zone_skips(const nck_lookahead_t *self, int is_dense) {
    return is_dense && !self->terms->limits_jerk ? NCK_CORNER_SPAN : 0;
}

// The largest share that junctions use, by pace, so near before (after) the seg's start (end) that
// it must be kept free there. before: of the next seg that is placed. after: NCK_EMPTY if junctions
// are not decided that far.
// Cost: NCK_CORNER_SPAN neighbours at most.
static inline void nck_zone_shares_before(nck_lookahead_t *self, uint32_t count,
                                          nck_zone_reach_t *reach) {
    const nck_zone_reach_t begin = {{0.0, 0.0}, {0.0, 0.0}, NCK_UNLIMITED};
    const int is_dense = nck_zone_is_dense(self, count - NCK_CORNER_SPAN);
    *reach = begin;
    for (uint32_t n = nck_zone_skips(self, is_dense); n < NCK_CORNER_SPAN; n++) {
        if (count == 0) return;
        count--;
        const nck_junction_t *const junction = nck_junction_at(self, count);
        if (nck_zone_parts(junction, self->zone_s)) return;
        nck_zone_meet(reach, junction, self->zone_s);
        if (nck_zone_pass(reach, junction, self->zone_s)) return;
    }
    const int is_most = self->most_s > 0.0f;
    nck_zone_cut_off(reach, self, is_most ? NCK_CORNER_SHARE_LONE : NCK_CORNER_SHARE_MAX);
}
static inline nck_status_t nck_zone_shares_after(nck_lookahead_t *self, uint32_t count,
                                                 nck_zone_reach_t *reach) {
    const nck_zone_reach_t begin = {{0.0, 0.0}, {0.0, 0.0}, NCK_UNLIMITED};
    const nck_junction_t *junction = nck_junction_at(self, count);
    const int is_dense = nck_zone_is_dense(self, count) && !self->ended;
    if (is_dense && self->junction.decided - count < NCK_CORNER_SPAN) return NCK_EMPTY;
    *reach = begin;
    for (uint32_t n = nck_zone_skips(self, is_dense); n < NCK_CORNER_SPAN; n++) {
        if (count == self->junction.decided) return NCK_EMPTY;
        nck_zone_meet(reach, junction, self->zone_s);
        if (nck_zone_parts(junction, self->zone_s)) return NCK_OK;
        count++;
        if (count == self->junction.head) return self->ended ? NCK_OK : NCK_EMPTY;
        junction = nck_junction_at(self, count);
        if (!nck_zone_pass(reach, junction, self->zone_s)) continue;
        if (count == self->junction.decided) reach->known = reach->time[NCK_PACE_OVER];
        return NCK_OK;
    }
    nck_zone_cut_off(reach, self, NCK_CORNER_SHARE_MAX);
    return NCK_OK;
}

#endif
