// SPDX-License-Identifier: MIT
// Inside room 4: a junction's neighbours on both sides, nearest first.
#ifndef NCK_PREP_WALK_H
#define NCK_PREP_WALK_H

#include "nck/base/budget.h"               // NCK_UNLIMITED
#include "nck/prep/4_lookahead/junction.h" // nck_lookahead_t nck_junction_t nck_junction_at
#include "nck/prep/4_lookahead/zone.h"     // nck_zone_parts

// One direction of a walk along the junctions, away from the one in the middle.
typedef struct nck_side {
    uint32_t at;        // the next neighbour
    double x;           // its distance [mm]; of an unknown one, the least that it can be;
                        // NCK_UNLIMITED: there are no more
} nck_side_t;

// A walk in both directions.
typedef struct nck_walk {
    uint32_t count;     // the junction in the middle
    nck_side_t ahead;
    nck_side_t behind;
    double cut;         // where a side was cut off at NCK_CORNER_SPAN neighbours [mm]
} nck_walk_t;

// No more neighbours are looked at on a side. Cost: constant.
static inline void nck_walk_cut(nck_walk_t *walk, nck_side_t *side) {
    walk->cut = nck_min(walk->cut, side->x);
    side->x = NCK_UNLIMITED;
}

// One neighbour further ahead; nothing is shared across a rest. Cost: constant.
static inline void nck_walk_ahead(nck_lookahead_t *self, nck_walk_t *walk) {
    nck_side_t *const side = &walk->ahead;
    if (side->at - walk->count >= NCK_CORNER_SPAN) {
        nck_walk_cut(walk, side);
        return;
    }
    side->at++;
    if (side->at == self->junction.head) {
        if (self->ended) side->x = NCK_UNLIMITED;
        return;
    }
    const nck_junction_t *const junction = nck_junction_at(self, side->at);
    side->x += junction->length;
    if (nck_zone_parts(junction, self->zone_s)) side->x = NCK_UNLIMITED;
}

// 1 if the load of the next one ahead hangs on a seg that is still to come: a junction's is known
// once the seg behind it is. Cost: constant.
static inline int nck_walk_is_unknown(const nck_lookahead_t *self, const nck_walk_t *walk) {
    return self->junction.head - walk->ahead.at <= 1 && !self->ended;
}

// One neighbour further behind. Cost: constant.
static inline void nck_walk_behind(nck_lookahead_t *self, nck_walk_t *walk) {
    nck_side_t *const side = &walk->behind;
    if (walk->count - side->at >= NCK_CORNER_SPAN) {
        nck_walk_cut(walk, side);
        return;
    }
    if (side->at == 0 || nck_zone_parts(nck_junction_at(self, side->at - 1), self->zone_s)) {
        side->x = NCK_UNLIMITED;
        return;
    }
    side->x += nck_junction_at(self, side->at)->length;
    side->at--;
}

// Stand at the junction `count`. Cost: constant.
static inline void nck_walk_begin(nck_lookahead_t *self, nck_walk_t *walk, uint32_t count) {
    const nck_side_t here = {count, 0.0};
    walk->count = count;
    walk->ahead = here;
    walk->behind = here;
    walk->cut = NCK_UNLIMITED;
    nck_walk_ahead(self, walk);
    nck_walk_behind(self, walk);
}

// The next neighbour nearer than reach [mm], and its distance [mm]. NCK_OK; NCK_DONE: no more;
// NCK_EMPTY: not known yet. Cost: constant.
static inline nck_status_t nck_walk_next(nck_lookahead_t *self, nck_walk_t *walk, double reach,
                                         const nck_junction_t **junction_out, double *x_out) {
    if (nck_min(walk->behind.x, walk->ahead.x) >= reach) return NCK_DONE;
    if (walk->ahead.x <= walk->behind.x) {
        if (nck_walk_is_unknown(self, walk)) return NCK_EMPTY;
        *junction_out = nck_junction_at(self, walk->ahead.at);
        *x_out = walk->ahead.x;
        nck_walk_ahead(self, walk);
    } else {
        *junction_out = nck_junction_at(self, walk->behind.at);
        *x_out = walk->behind.x;
        nck_walk_behind(self, walk);
    }
    return NCK_OK;
}

#endif
