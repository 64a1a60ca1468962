// SPDX-License-Identifier: MIT
// Room 4, lookahead: junctions become nodes, nodes get their envelope.
#include "nck/prep/4_lookahead/lookahead.h"

#include <assert.h> // assert
#include <stddef.h> // offsetof
#include <string.h> // memset

#include "nck/base/budget.h"               // NCK_UNLIMITED
#include "nck/prep/4_lookahead/corner.h"   // nck_corner_…
#include "nck/prep/4_lookahead/junction.h" // nck_junction_…
#include "nck/prep/4_lookahead/near.h"     // nck_near_…
#include "nck/prep/4_lookahead/piece.h"    // nck_piece_place
#include "nck/prep/4_lookahead/zone.h"     // nck_zone_…

enum {
    PLACES_PER_STEP = 2 // segs: mostly one, and the next one is seen to be too early
};

void nck_lookahead_init(nck_lookahead_t *self, const nck_terms_t *terms) {
    const size_t before = offsetof(nck_lookahead_t, next);
    memset(self, 0, offsetof(nck_lookahead_t, junction.at)); // what rings hold is read once written
    memset(&self->next, 0, offsetof(nck_lookahead_t, window.at) - before);
    self->terms = terms;
    nck_lookahead_adapt(self);
    self->before_limit = NCK_LIMIT_EXACT_STOP;
}

void nck_lookahead_adapt(nck_lookahead_t *self) {
    self->a_any = nck_junction_a_any(self->terms->machine);
    self->zone_s = nck_zone_s(self->terms);
    self->next.is_weighed = 0;
}

nck_status_t nck_lookahead_push(nck_lookahead_t *self, const nck_seg_t *seg) {
    if (!nck_lookahead_has_room(self)) return NCK_FULL;
    self->ended = 0;
    nck_junction_t *const junction = nck_junction_at(self, self->junction.head);
    const double *const tangent = self->junction.tangent[(self->junction.head - 1) & 1u];
    double *const end = self->junction.tangent[self->junction.head & 1u];
    const int axes = self->terms->axes;
    double bent[NCK_AXIS_MAX];
    const double *const start = nck_junction_tangents(seg, axes, bent, end);
    nck_junction_make(junction, seg, start, end, self->terms);
    nck_junction_t *const before = nck_junction_at(self, self->junction.head - 1);
    if (self->junction.head > 0) nck_corner_meet(before, junction, tangent, start, self->terms);
    self->junction.head++;
    if (self->terms->limits_jerk) {
        nck_near_set_out(junction, nck_near_entered_at(self, self->junction.head - 1));
    }
    return NCK_OK;
}

void nck_lookahead_end(nck_lookahead_t *self) { self->ended = 1; }

nck_status_t nck_lookahead_take(nck_lookahead_t *self, const nck_node_t *piece) {
    if (self->ended) return NCK_E_STATE;
    if (self->window.fill == NCK_NODE_MAX) return NCK_FULL;
    self->window.at[(self->window.head + self->window.fill) & (NCK_NODE_MAX - 1)] = *piece;
    self->window.fill++;
    if (piece->kind == NCK_SEG_WAIT) self->window.barrier = self->window.fill;
    return NCK_OK;
}

int nck_lookahead_is_settled(const nck_lookahead_t *self) {
    const uint32_t head = self->junction.head;
    return self->junction.placed == head && (self->ended || head == 0);
}

// The next seg cannot be placed yet, as is seen without a walk: what comes behind the last junction
// that is decided reaches into it. known: of the walk behind the seg before (nck_zone_reach_t).
static inline int is_early(nck_lookahead_t *self, double known) {
    const uint32_t count = self->junction.placed;
    const uint32_t next = count + 1;
    if (count == self->junction.decided) return 1;
    const nck_junction_t *const junction = nck_junction_at(self, count);
    const double left = known - junction->pace[NCK_PACE_OVER].time;
    if (left * NCK_ZONE_MARGIN < self->zone_s && junction->kind < NCK_SEG_DWELL) return 1;
    if (next != self->junction.decided || next == self->junction.head) return 0;
    return nck_junction_at(self, next)->pace[NCK_PACE_OVER].time < self->zone_s
           && !nck_zone_parts(junction, self->zone_s);
}

// Place the next seg. Returns 1 if it is placed; known_io: as in is_early, and for the next one.
static inline int place_one(nck_lookahead_t *self, double *known_io) {
    nck_zone_reach_t after;
    if (is_early(self, *known_io)) return 0;
    if (nck_zone_shares_after(self, self->junction.placed, &after) != NCK_OK) return 0;
    *known_io = after.known;
    const double share[NCK_PACES] = {after.share[NCK_PACE_FEED], after.share[NCK_PACE_OVER]};
    return nck_piece_place(self, share) == NCK_OK;
}

// Place the next segs, unless it was tried in vain and nothing has become known since.
static int place(nck_lookahead_t *self) {
    const uint32_t known = self->junction.settled + self->junction.decided;
    double known_s = NCK_UNLIMITED;
    int placed = 0;
    if (self->junction.tried == known && !self->ended) return 0;
    while (placed < PLACES_PER_STEP && !nck_lookahead_is_full(self) && place_one(self, &known_s)) {
        placed++;
    }
    if (!nck_lookahead_is_full(self) && placed < PLACES_PER_STEP) self->junction.tried = known;
    return placed > 0;
}

// What a seg needs one after the other: its own speeds, its junction, its place in the window.
nck_status_t nck_lookahead_step(nck_lookahead_t *self) {
    if (nck_lookahead_is_full(self)) return NCK_FULL;
    const int settles = self->junction.settled != self->junction.head;
    if (settles) nck_near_settle(self);
    const int is_decided = nck_corner_may_decide(self) && nck_corner_decide(self) == NCK_OK;
    if (place(self) || is_decided || settles) return NCK_OK;
    return self->ended && self->junction.placed == self->junction.head ? NCK_DONE : NCK_EMPTY;
}

const nck_node_t *nck_lookahead_ahead(const nck_lookahead_t *self, uint32_t i) {
    if (i >= self->window.fill) return (const nck_node_t *)0;
    return &self->window.at[(self->window.head + i) & (NCK_NODE_MAX - 1)];
}

uint32_t nck_lookahead_oldest(const nck_lookahead_t *self, uint32_t newer) {
    const uint32_t placed = self->junction.placed;
    if (self->window.fill > 0) return nck_lookahead_ahead(self, 0)->seg;
    if (placed == self->junction.head) return newer;
    return self->junction.at[placed & (NCK_JUNCTION_MAX - 1)].seq;
}

uint32_t nck_lookahead_fill(const nck_lookahead_t *self) { return self->window.fill; }

void nck_lookahead_drop(nck_lookahead_t *self, uint32_t n) {
    assert(n <= self->window.fill);
    self->window.head += n;
    self->window.fill -= n;
    self->window.barrier -= n < self->window.barrier ? n : self->window.barrier;
}

// A piece of a clocked path, whose rests are room 5's.
static int is_clocked(const nck_lookahead_t *self, const nck_node_t *node) {
    return self->terms->machine->slope == NCK_SLOPE_OPTIMAL && node->kind == NCK_SEG_SPLINE;
}

int nck_lookahead_invariants(const nck_lookahead_t *self) {
    const uint32_t fill = self->window.fill, head = self->junction.head;
    int good = fill <= NCK_NODE_MAX && self->window.barrier <= fill
               && head - self->junction.decided <= head - self->junction.placed
               && head - self->junction.settled <= head - self->junction.decided
               && head - self->junction.placed <= NCK_JUNCTION_MAX - NCK_CORNER_SPAN;
    for (uint32_t i = 0; good && i < fill; i++) {
        const nck_node_t *const node = nck_lookahead_ahead(self, i);
        const nck_node_t *const next = nck_lookahead_ahead(self, i + 1);
        good = node->vv_cap >= 0.0 && node->vv_cap <= node->vv_piece
               && (!next || !node->stop || next->vv_cap == 0.0 || is_clocked(self, next));
    }
    return good;
}
