// SPDX-License-Identifier: MIT
// Room 5, slope: how far the S-shape sees, and what it may pass junctions at.
#include "nck/prep/5_slope/sshape_ahead.h"

#include "nck/base/real.h" // nck_min nck_max nck_sqrt

// The highest override.
#define OVER_MOST 2.0
// Pieces that the look-ahead sees at most.
enum {
    BY_TAIL = (NCK_TAIL_MAX - NCK_SSHAPE_PART) / 3,
    BY_WINDOW = NCK_WINDOW - 8 - 2 * NCK_SSHAPE_PIECES,
    PIECES_MOST = BY_TAIL < BY_WINDOW ? BY_TAIL : BY_WINDOW
};

nck_sshape_view_t nck_sshape_view(const nck_sshape_t *self, const nck_pieces_t *pieces) {
    const nck_sshape_view_t view = {pieces, &self->job.wish, self->next->over};
    return view;
}

static double *speed_at(nck_sshape_t *self, uint32_t number) {
    return &self->memory.ahead.v[number & (NCK_WINDOW - 1)];
}

static uint8_t *pieces_at(nck_sshape_t *self, uint32_t number) {
    return &self->memory.ahead.pieces[number & (NCK_WINDOW - 1)];
}

// The speed that a node is raised to; 0: it is not.
static double floor_at(const nck_sshape_t *self, uint32_t number) {
    const nck_sshape_ahead_t *const ahead = &self->memory.ahead;
    const int raised = (int32_t)(ahead->raised - number) >= 0;
    return raised ? ahead->floor[number & (NCK_WINDOW - 1)] : 0.0;
}

// ---- hops

int nck_sshape_ends_block(const nck_sshape_t *self, const nck_pieces_t *pieces, uint32_t number) {
    if (!self->job.wish.single_block || (int32_t)(number + 1 - self->skip) <= 0) return 0;
    return nck_plan_piece(pieces, number + 1) && nck_plan_ends_block(self->link, pieces, number);
}

static int rests_behind(const nck_sshape_t *self, const nck_pieces_t *pieces, uint32_t number) {
    const nck_node_t *const piece = nck_plan_piece(pieces, number);
    return piece->stop || !(piece->length > 0.0) || nck_sshape_ends_block(self, pieces, number);
}

nck_sshape_hop_t nck_sshape_hop_at(nck_sshape_t *self, const nck_pieces_t *pieces,
                                   const nck_sshape_place_t *place) {
    const nck_sshape_view_t view = nck_sshape_view(self, pieces);
    nck_sshape_hop_t hop;
    nck_sshape_hop_of(&view, place->piece, *pieces_at(self, place->piece), &hop);
    hop.stops = (uint8_t)rests_behind(self, pieces, hop.first + hop.count - 1);
    if (!place->fresh) nck_sshape_hop_from(&hop, place->s);
    return hop;
}

double nck_sshape_end_most(nck_sshape_t *self, const nck_sshape_hop_t *hop) {
    const uint32_t behind = hop->first + hop->count;
    if (hop->stops) return 0.0;
    return nck_min(nck_max(hop->v_out, floor_at(self, behind)), *speed_at(self, behind));
}

// ---- look

void nck_sshape_look_anew(nck_sshape_t *self, double v_floor) {
    nck_sshape_ahead_t *const ahead = &self->memory.ahead;
    ahead->horizon = self->at.piece;
    ahead->was = self->at.piece;
    ahead->capped = self->at.piece;
    ahead->raised = self->at.piece;
    ahead->floor[self->at.piece & (NCK_WINDOW - 1)] = 0.0;
    ahead->v_floor = v_floor;
    ahead->looks = 0;
    ahead->back = 0;
}

// Whether as many blocks are seen as may be, to the end of the last one.
static int sees_blocks(const nck_sshape_t *self, const nck_pieces_t *pieces) {
    const uint32_t blocks = self->machine->lookahead_blocks;
    const uint32_t horizon = self->memory.ahead.horizon;
    const nck_node_t *const first = nck_plan_piece(pieces, self->at.piece);
    const nck_node_t *const last = nck_plan_piece(pieces, horizon - 1);
    if (blocks == 0 || !nck_plan_piece(pieces, horizon)) return 0;
    return nck_plan_ends_block(self->link, pieces, horizon - 1)
           && (blocks == 1 || nck_plan_is_beyond(self->link, first, last, blocks - 1));
}

// Whether the horizon has come as far as it may: a stop, or all that the look-ahead may see.
static int is_far(const nck_sshape_t *self, const nck_pieces_t *pieces) {
    const uint32_t horizon = self->memory.ahead.horizon;
    const uint32_t count = horizon - self->at.piece;
    if (count == 0) return 0;
    return rests_behind(self, pieces, horizon - 1) || sees_blocks(self, pieces)
           || count + NCK_SSHAPE_HOP > PIECES_MOST;
}

// Single block must know whether the horizon is a block's end.
static int knows_end(const nck_sshape_t *self, const nck_pieces_t *pieces) {
    const uint32_t horizon = self->memory.ahead.horizon;
    if (!self->job.wish.single_block || horizon == self->at.piece) return 1;
    const int waits = (int32_t)(pieces->head + pieces->barrier - horizon) >= 0;
    return nck_plan_piece(pieces, horizon) || pieces->complete || (pieces->barrier > 0 && waits);
}

// Whether to look further at all. N blocks are counted anew at every hop; what the window holds
// only when half of it is left, so that a hop costs two speeds, not as many as a ramp has hops.
static int is_far_enough(nck_sshape_t *self) {
    nck_sshape_ahead_t *const ahead = &self->memory.ahead;
    const uint32_t count = ahead->horizon - self->at.piece;
    if (self->machine->lookahead_blocks > 0 || count < PIECES_MOST / 2) ahead->looks = 1;
    return !ahead->looks;
}

static void begin_speeds(nck_sshape_t *self, const nck_pieces_t *pieces) {
    nck_sshape_ahead_t *const ahead = &self->memory.ahead;
    if (rests_behind(self, pieces, ahead->horizon - 1)) ahead->capped = ahead->horizon;
    *speed_at(self, ahead->horizon) = 0.0;
    ahead->i = ahead->horizon - 1;
    ahead->looks = 0;
    ahead->back = 1;
}

// What may have been in force since the path was last at rest.
static nck_wish_t free_wish(const nck_sshape_t *self) {
    const nck_wish_t wish = {self->next->over ? OVER_MOST : 1.0, 1.0, NCK_WISH_FREE, 0, 0, 0};
    return wish;
}

static nck_sshape_hop_t free_hop(const nck_sshape_t *self, const nck_pieces_t *pieces,
                                 uint32_t first, uint32_t count) {
    const nck_wish_t wish = free_wish(self);
    const nck_sshape_view_t view = {pieces, &wish, self->next->over};
    nck_sshape_hop_t hop;
    nck_sshape_hop_of(&view, first, count, &hop);
    return hop;
}

// The cap of a hop's start, raised.
static double raised_cap(const nck_sshape_t *self, const nck_pieces_t *pieces,
                         const nck_sshape_hop_t *hop, double cap) {
    const double floor = floor_at(self, hop->first);
    if (!(floor > cap)) return cap;
    const nck_wish_t wish = free_wish(self);
    const double node = nck_plan_at(pieces, hop->first, &wish, self->next->over);
    const double v_in = free_hop(self, pieces, hop->first, hop->count).v_in;
    return nck_max(cap, nck_min(floor, nck_min(v_in, nck_sqrt(node))));
}

// The caps behind a hop may lie below what the path can brake to: then they are raised, but no
// further than what the place allows under the highest override that may have been in force.
static void raise_caps(nck_sshape_t *self, const nck_pieces_t *pieces) {
    nck_sshape_ahead_t *const ahead = &self->memory.ahead;
    const nck_sshape_place_t start = {ahead->horizon, 1, 0.0, 0.0};
    const int is_first = ahead->horizon == self->at.piece;
    const nck_sshape_hop_t hop = nck_sshape_hop_at(self, pieces, is_first ? &self->at : &start);
    const uint32_t behind = hop.first + hop.count;
    const double v = ahead->v_floor;
    ahead->v_floor = hop.piece.length > 0.0 ? nck_sshape_slowest_end(&hop.piece, v, v) : 0.0;
    ahead->floor[behind & (NCK_WINDOW - 1)] =
        nck_min(ahead->v_floor, free_hop(self, pieces, hop.first, hop.count).v_out);
    ahead->raised = behind;
}

// NCK_EMPTY if the next hop is not known yet.
static nck_status_t add_hop(nck_sshape_t *self, const nck_pieces_t *pieces) {
    nck_sshape_ahead_t *const ahead = &self->memory.ahead;
    const nck_sshape_view_t view = nck_sshape_view(self, pieces);
    const uint32_t next = ahead->horizon;
    const uint32_t count = nck_sshape_hop_pieces(&view, next);
    for (uint32_t i = 0; i < count; i++) *pieces_at(self, next + i) = 0;
    *pieces_at(self, next) = (uint8_t)count;
    if (count > 0 && ahead->v_floor > 0.0) raise_caps(self, pieces);
    ahead->horizon += count;
    return count > 0 ? NCK_OK : NCK_EMPTY;
}

// ---- speeds

// One piece; returns 1 if the speeds before it stay as they are.
static int speed_piece(nck_sshape_t *self, const nck_pieces_t *pieces) {
    nck_sshape_ahead_t *const ahead = &self->memory.ahead;
    const uint32_t i = ahead->i;
    if ((int32_t)(i - self->at.piece) <= 0 || ahead->horizon == ahead->was) return 1;
    ahead->i--;
    if (*pieces_at(self, i) == 0) return 0;
    const nck_sshape_place_t start = {i, 1, 0.0, 0.0};
    const nck_sshape_hop_t hop = nck_sshape_hop_at(self, pieces, &start);
    const double node = nck_plan_at(pieces, i, &self->job.wish, self->next->over);
    const double cap = raised_cap(self, pieces, &hop, nck_min(hop.v_in, nck_sqrt(node)));
    const double most = nck_sshape_end_most(self, &hop);
    const double v = nck_min(cap, nck_sshape_brakeable(&hop.piece, most));
    const int known = (int32_t)(i - ahead->was) <= 0;
    const int same = known && v == *speed_at(self, i);
    if (v == cap && (int32_t)(i - ahead->capped) > 0) ahead->capped = i;
    *speed_at(self, i) = v;
    return same;
}

static nck_status_t look_back(nck_sshape_t *self, const nck_pieces_t *pieces) {
    nck_sshape_ahead_t *const ahead = &self->memory.ahead;
    for (int n = 0; n < NCK_SSHAPE_STEP; n++) {
        if (!speed_piece(self, pieces)) continue;
        ahead->was = ahead->horizon;
        ahead->back = 0;
        return NCK_DONE;
    }
    return NCK_OK;
}

// Whether more than the next hop is known. The last one stays in the stop tail, so that a path that
// has starved says so.
static int knows_way_on(nck_sshape_t *self) {
    const uint32_t count = self->memory.ahead.horizon - self->at.piece;
    return count > *pieces_at(self, self->at.piece);
}

nck_status_t nck_sshape_look(nck_sshape_t *self, const nck_pieces_t *pieces) {
    if (self->memory.ahead.back) return look_back(self, pieces);
    if (is_far_enough(self)) return NCK_DONE;
    for (int n = 0; n < NCK_SSHAPE_STEP; n++) {
        if (!knows_end(self, pieces)) return NCK_EMPTY;
        if (is_far(self, pieces)) {
            begin_speeds(self, pieces);
            return NCK_OK;
        }
        if (add_hop(self, pieces) == NCK_OK) continue;
        if (!self->job.starved || !knows_way_on(self)) return NCK_EMPTY;
        begin_speeds(self, pieces);
        return NCK_OK;
    }
    return NCK_OK;
}
