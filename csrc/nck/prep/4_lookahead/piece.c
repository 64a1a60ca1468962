// SPDX-License-Identifier: MIT
// Inside room 4: a junction becomes the nodes of its pieces, each with its caps.
#include "nck/prep/4_lookahead/piece.h"

#include <assert.h> // assert
#include <string.h> // memset memcpy

#include "nck/base/budget.h"               // NCK_UNLIMITED
#include "nck/prep/4_lookahead/junction.h" // nck_junction_…
#include "nck/prep/4_lookahead/near.h"     // nck_near_…
#include "nck/prep/4_lookahead/zone.h"     // nck_zone_… NCK_ZONE…

// A seg is cut where its junctions' share ends only if that frees more than this share of its
// acceleration.
#define SPLIT_SHARE 0.05
// More than a float's rounding.
#define FLOAT_ROUNDING 1e-6

static nck_node_t *node_at(nck_lookahead_t *self, uint32_t i) {
    assert(i < NCK_NODE_MAX);
    return self->window.at + ((self->window.head + i) & (NCK_NODE_MAX - 1));
}

// What the neighbourhood leaves to a piece, by pace.
typedef struct around {
    double share[NCK_PACES];
    nck_near_t near[NCK_PACES];
} around_t;

static const nck_near_t NOTHING_NEAR = {NCK_UNLIMITED, NCK_UNLIMITED, 1.0, NCK_UNLIMITED};

// Nothing around. Without a jerk limit `near` is never asked for.
static void begin_around(const nck_lookahead_t *self, around_t *around) {
    for (int k = 0; k < NCK_PACES; k++) around->share[k] = 0.0;
    if (!self->terms->limits_jerk) return;
    for (int k = 0; k < NCK_PACES; k++) around->near[k] = NOTHING_NEAR;
}

// What another side's neighbourhood takes on top.
static inline void add_around(const nck_lookahead_t *self, around_t *around,
                              const around_t *other) {
    for (int k = 0; k < NCK_PACES; k++) {
        around->share[k] = nck_max(around->share[k], other->share[k]);
    }
    if (!self->terms->limits_jerk) return;
    for (int k = 0; k < NCK_PACES; k++) {
        nck_near_t *const near = &around->near[k];
        near->a = nck_min(near->a, other->near[k].a);
        near->j = nck_min(near->j, other->near[k].j);
        near->slow = nck_min(near->slow, other->near[k].slow);
    }
}

// The cap at a node by everything but the feeds: its junction and the pieces at both sides. Where
// the speed has to fall there, what the slope's filter adds comes off.
static double node_cap(const nck_lookahead_t *self, double vv_over, const double v_corner[]) {
    const double vv_before = self->before.vv_over;
    const double vv_corner = v_corner[NCK_PACE_OVER] * v_corner[NCK_PACE_OVER];
    const double vv = nck_min(nck_min(vv_before, vv_over), vv_corner);
    if (!self->terms->limits_jerk || (vv_before == vv_over && vv == vv_over)) return vv;
    const double v = nck_max(0.0, nck_sqrt(vv) - self->terms->v_filter);
    return v * v;
}

// The caps of the node at a piece's start, whose own caps are these.
static inline void cap_node(nck_lookahead_t *self, nck_node_t *node, const nck_piece_limit_t *piece,
                            const double v_corner[]) {
    const double vv_corner = v_corner[NCK_PACE_FEED] * v_corner[NCK_PACE_FEED];
    double vv_cap = piece->vv;
    uint32_t limit = piece->limit;
    if (self->before.vv < vv_cap) {
        vv_cap = self->before.vv;
        limit = self->before_limit;
    }
    if (vv_corner < vv_cap) {
        vv_cap = vv_corner;
        limit = NCK_LIMIT_CORNER;
    }
    const double vv_node = node_cap(self, piece->vv_free, v_corner);
    self->before.vv = piece->vv;
    self->before.vv_over = piece->vv_free;
    self->before_limit = piece->limit;
    node->limit = (uint8_t)limit;
    node->limit_piece = piece->limit;
    node->vv_piece = piece->vv;
    node->vv_over = piece->vv_free;
    node->vv_cap = self->terms->limits_jerk ? nck_min(vv_cap, vv_node) : vv_cap;
    node->vv_node = vv_node;
}

static inline nck_piece_limit_t limits_of(const nck_lookahead_t *self,
                                          const nck_junction_t *junction, const around_t *around,
                                          int pace) {
    const nck_near_t *const near = &around->near[pace];
    nck_piece_limit_t piece =
        nck_junction_piece(junction, 1.0 - around->share[pace], pace, self->terms);
    if (!self->terms->limits_jerk) return piece;
    piece.a = nck_min(piece.a, near->a);
    piece.j = nck_min(piece.j, near->j);
    piece.vv *= near->slow * near->slow;
    piece.vv_free *= near->slow * near->slow;
    return piece;
}

// As a float, which is no larger.
static float no_more(double x) { return (float)(x * (1.0 - FLOAT_ROUNDING)); }

// The upper half of a positive float, which is no larger.
static uint16_t half_of(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (uint16_t)(bits >> 16);
}

// What the axes leave at standstill; the linear slope asks for the acceleration alone.
static inline void leave_at_rest(nck_node_t *node, const nck_junction_t *junction,
                                 const nck_terms_t *terms) {
    node->standstill.left.a = no_more(nck_junction_most(junction));
    if (!terms->limits_jerk) return;
    node->standstill.left.j = no_more(junction->j_straight);
    const int bends = junction->kind != NCK_SEG_LINE; // told apart here, which is quicker
    node->q_rest = bends ? half_of(no_more(nck_junction_bends(junction)))
                         : half_of(no_more(NCK_UNLIMITED));
}

// What a node has of its junction, and what nobody has found yet.
static void begin_node(nck_node_t *node, const nck_junction_t *junction) {
    node->seg = junction->seq;
    node->stop = 0;
    node->last = 0;
    node->kind = junction->kind;
    node->open = 0;
    node->q_rest = 0;
    node->tool = (float)junction->tool;
    node->feed = junction->feed;
    node->standstill.dwell_s = 0.0;
    node->vv = 0.0;
}

// Append the piece from s[0] to s[1]; v_corner caps the node at its start.
static nck_node_t *add_piece(nck_lookahead_t *self, const nck_junction_t *junction,
                             const double s[2], const around_t *around, const double v_corner[]) {
    nck_piece_limit_t piece = limits_of(self, junction, around, NCK_PACE_FEED);
    const nck_piece_limit_t over = limits_of(self, junction, around, NCK_PACE_OVER);
    nck_node_t *const node = node_at(self, self->window.fill);
    if (self->terms->limits_jerk) piece.vv = nck_min(piece.vv, over.vv_free);
    piece.vv_free = over.vv_free;
    cap_node(self, node, &piece, v_corner);
    begin_node(node, junction);
    node->s = s[0];
    node->length = s[1] - s[0];
    node->a = piece.a;
    node->a_over = nck_min(piece.a, over.a);
    node->j = piece.j;
    node->j_over = nck_min(piece.j, over.j);
    leave_at_rest(node, junction, self->terms);
    self->window.fill++;
    return node;
}

static nck_node_t *add_rest(nck_lookahead_t *self, const nck_junction_t *junction) {
    nck_node_t *const node = node_at(self, self->window.fill);
    memset(node, 0, sizeof *node);
    node->seg = junction->seq;
    node->kind = junction->kind;
    node->a = self->terms->machine->path.a_max;
    node->a_over = node->a;
    node->j = self->terms->j_max;
    node->j_over = node->j;
    node->standstill.dwell_s = junction->shape.dwell_s;
    node->limit = NCK_LIMIT_EXACT_STOP;
    node->limit_piece = junction->kind == NCK_SEG_DWELL    ? NCK_LIMIT_DWELL
                        : junction->kind >= NCK_SEG_THREAD ? NCK_LIMIT_THREAD
                                                        : NCK_LIMIT_WAIT;
    self->window.fill++;
    return node;
}

// An interval of a clocked path: caps by feeds, all else is room 5's.
static nck_node_t *add_clocked(nck_lookahead_t *self, const nck_junction_t *junction) {
    nck_node_t *const node = node_at(self, self->window.fill);
    const double most = junction->v_free;
    memset(node, 0, sizeof *node);
    node->seg = junction->seq;
    node->kind = NCK_SEG_SPLINE;
    node->tool = (float)junction->tool;
    node->length = junction->shape.clocked;
    node->a = self->terms->machine->path.a_max;
    node->a_over = node->a;
    node->j = self->terms->j_max;
    node->j_over = node->j;
    node->feed = junction->feed;
    node->vv_over = most * most;
    node->vv_piece = junction->feed > 0.0 ? nck_min(most * most, junction->feed * junction->feed)
                                       : most * most;
    node->vv_node = node->vv_over;
    node->vv_cap = node->vv_piece;
    node->limit = junction->limit;
    node->limit_piece = junction->limit;
    self->window.fill++;
    return node;
}

// How fast the path may be between the segs count − 1 and count, both known if they exist, by the
// junction and the segs.
static double speed_between(nck_lookahead_t *self, uint32_t count) {
    if (count == 0 || count == self->junction.head) return 0.0;
    const nck_junction_t *const before = nck_junction_at(self, count - 1);
    const nck_junction_t *const behind = nck_junction_at(self, count);
    if ((before->end & NCK_JUNCTION_STOP) || behind->kind >= NCK_SEG_DWELL) return 0.0;
    const nck_pace_t *const pace = &before->pace[NCK_PACE_OVER];
    return nck_min(pace->v_corner, nck_min(pace->v, behind->pace[NCK_PACE_OVER].v));
}

// Under a jerk limit: how far a zone reaches into a seg from its node, between the segs node − 1
// and node: at the seg's own speed, or at what it can have gained by then with the acceleration
// that the zone leaves, from the node's speed on, which junctions near it bound.
// Where no junction takes a share, as far as the filter mixes.
static double zone_length(nck_lookahead_t *self, const nck_junction_t *junction, uint32_t node,
                          const around_t *around) {
    const double time = around->share[NCK_PACE_OVER] > 0.0 ? self->zone_s : self->terms->mix_s;
    const double near = nck_max(around->near[NCK_PACE_FEED].a, around->near[NCK_PACE_OVER].a);
    const double gained = 0.5 * nck_min(junction->a_most, near) * time * time;
    const double vv = nck_max(around->near[NCK_PACE_FEED].vv, around->near[NCK_PACE_OVER].vv);
    const double v = nck_min(speed_between(self, node), nck_sqrt(vv));
    const double raised = v + self->terms->v_filter;
    return nck_min(junction->pace[NCK_PACE_OVER].v * time, raised * time + gained);
}

// Under a jerk limit: whether a seg is worth a piece of its own next to the node around which less
// is allowed.
static inline int is_tighter(const nck_lookahead_t *self, const nck_junction_t *junction,
                             const around_t *around) {
    if (around->share[NCK_PACE_FEED] > SPLIT_SHARE) return 1;
    const nck_piece_limit_t own = nck_junction_piece(junction, 1.0, NCK_PACE_FEED, self->terms);
    const nck_near_t *const near = &around->near[NCK_PACE_FEED];
    return near->a < (1.0 - SPLIT_SHARE) * own.a || near->j < (1.0 - SPLIT_SHARE) * own.j;
}

// 1 if a seg has a middle that is worth a piece beside zones that are so long.
static inline int has_middle(const nck_junction_t *junction, double zones) {
    return junction->length > NCK_ZONES_CUT * zones;
}

// The linear slope, once it cuts a seg, cuts at every share, and all zones are of one length.
static int find_shares(const nck_lookahead_t *self, const nck_junction_t *junction,
                       const around_t ends[2], int is_cut_off[2], double zone[2]) {
    const double share[2] = {ends[0].share[NCK_PACE_FEED], ends[1].share[NCK_PACE_FEED]};
    const double length = junction->v_max * self->zone_s;
    if (!(nck_max(share[0], share[1]) > SPLIT_SHARE)) return 0;
    if (!has_middle(junction, length)) return 0; // too short for one of them
    is_cut_off[0] = share[0] > 0.0;
    is_cut_off[1] = share[1] > 0.0;
    zone[0] = is_cut_off[0] ? length : 0.0;
    zone[1] = is_cut_off[1] ? length : 0.0;
    return has_middle(junction, zone[0] + zone[1]);
}

// The zones of a seg that are cut off, and how long they are; none if the middle would be too
// short. Returns 1 if any is.
static int find_zones(nck_lookahead_t *self, uint32_t count, const around_t ends[2],
                      int is_cut_off[2], double zone[2]) {
    const nck_junction_t *const junction = nck_junction_at(self, count);
    for (uint32_t n = 0; n < 2; n++) {
        is_cut_off[n] = is_tighter(self, junction, &ends[n]);
        zone[n] = 0.0;
        if (!is_cut_off[n]) continue;
        zone[n] = zone_length(self, junction, count + n, &ends[n]);
        if (!has_middle(junction, zone[n])) return 0;
    }
    return (is_cut_off[0] || is_cut_off[1]) && has_middle(junction, zone[0] + zone[1]);
}

// What is left of the neighbourhood in a middle whose ends are cut off or not. The linear slope's
// zones are those of the programmed speed, so beyond it the middle keeps the shares free too.
static void keep_in_middle(const nck_lookahead_t *self, const around_t ends[2],
                           const int is_cut_off[2], around_t *middle_out) {
    double share = 0.0;
    begin_around(self, middle_out);
    for (int n = 0; n < 2; n++) {
        share = nck_max(share, ends[n].share[NCK_PACE_OVER]);
        if (!is_cut_off[n]) add_around(self, middle_out, &ends[n]);
    }
    if (!self->terms->limits_jerk) middle_out->share[NCK_PACE_OVER] = share;
}

// A seg as its pieces.
typedef struct cutting {
    uint32_t count;                            // of pieces
    double s[NCK_PIECES_PER_SEG + 1];          // where they begin, and where the last one ends
    const around_t *under[NCK_PIECES_PER_SEG]; // what is around each: one of these, or of the seg
    around_t inside;                           // of the middle
    around_t beside[2];                        // of what is cut off
} cutting_t;

// All of a seg in one piece, under what both of its sides leave.
static inline void keep_whole(const nck_lookahead_t *self, const nck_junction_t *junction,
                              around_t ends[2], cutting_t *cutting) {
    add_around(self, &ends[0], &ends[1]);
    cutting->under[0] = &ends[0];
    cutting->s[1] = junction->length;
    cutting->count = 1;
}

// One more piece, up to s.
static void cut_at(cutting_t *cutting, double s, const around_t *around) {
    cutting->under[cutting->count] = around;
    cutting->count++;
    cutting->s[cutting->count] = s;
}

// Inside a zone the share of its junction is kept free and its neighbour's limits hold; the middle
// has all that the seg allows.
static void cut_off(const nck_lookahead_t *self, const nck_junction_t *junction,
                    const around_t ends[2], const int is_cut_off[2], const double zone[2],
                    cutting_t *cutting) {
    const double middle = is_cut_off[1] ? junction->length - zone[1] : junction->length;
    memcpy(cutting->beside, ends, sizeof cutting->beside);
    keep_in_middle(self, ends, is_cut_off, &cutting->inside);
    for (int n = 0; n < 2 && self->terms->limits_jerk; n++) {
        const int may_reach = !is_cut_off[1 - n]; // all the way
        if (may_reach) add_around(self, &cutting->beside[n], &ends[1 - n]);
    }
    if (is_cut_off[0]) cut_at(cutting, zone[0], &cutting->beside[0]);
    cut_at(cutting, middle, &cutting->inside);
    if (is_cut_off[1]) cut_at(cutting, junction->length, &cutting->beside[1]);
}

// Returns the last piece.
static nck_node_t *add_motion(nck_lookahead_t *self, uint32_t count, around_t ends[2],
                              const double v_start[]) {
    const nck_junction_t *const junction = nck_junction_at(self, count);
    const double unlimited[NCK_PACES] = {junction->v_max, junction->v_free};
    double zone[2];
    int is_cut_off[2];
    cutting_t cutting;
    cutting.count = 0;
    cutting.s[0] = 0.0;
    const int is_cut = self->terms->limits_jerk
                           ? find_zones(self, count, ends, is_cut_off, zone)
                           : find_shares(self, junction, ends, is_cut_off, zone);
    if (is_cut) cut_off(self, junction, ends, is_cut_off, zone, &cutting);
    else keep_whole(self, junction, ends, &cutting);
    nck_node_t *node = (nck_node_t *)0;
    for (uint32_t k = 0; k < cutting.count; k++) {
        const double *const v_node = k == 0 ? v_start : unlimited;
        node = add_piece(self, junction, &cutting.s[k], cutting.under[k], v_node);
    }
    return node;
}

// What reaches into the oldest junction from before and, beside the shares, from behind. NCK_EMPTY
// if it is not known yet.
static nck_status_t look_around(nck_lookahead_t *self, uint32_t count, around_t ends[2]) {
    nck_zone_reach_t before;
    nck_zone_shares_before(self, count, &before);
    for (int k = 0; k < NCK_PACES; k++) ends[0].share[k] = before.share[k];
    if (!self->terms->limits_jerk) return NCK_OK;
    for (int k = 0; k < NCK_PACES; k++) {
        const double left = 1.0 - nck_max(ends[0].share[k], ends[1].share[k]);
        const nck_status_t status = nck_near_after(self, count, k, left, &ends[1].near[k]);
        if (status != NCK_OK) return status;
        nck_near_before(self, count, k, left, &ends[0].near[k]);
    }
    return NCK_OK;
}

static nck_node_t *place_motion(nck_lookahead_t *self, uint32_t count, around_t ends[2]) {
    double v_start[NCK_PACES] = {0.0, 0.0};
    if (count > 0) {
        const nck_pace_t *const pace = nck_junction_at(self, count - 1)->pace;
        v_start[NCK_PACE_FEED] = pace[NCK_PACE_FEED].v_corner;
        v_start[NCK_PACE_OVER] = pace[NCK_PACE_OVER].v_corner;
    }
    return add_motion(self, count, ends, v_start);
}

// The seg is placed: for how long the share of a junction that got more than half is kept free.
static inline void pass_share(nck_lookahead_t *self, const nck_junction_t *junction) {
    const nck_pace_t *const pace = &junction->pace[NCK_PACE_OVER];
    const int is_most = pace->share > NCK_CORNER_SHARE_MAX;
    if (is_most) self->most_s = (float)(NCK_ZONE_MARGIN * self->zone_s);
    else self->most_s -= (float)pace->time;
}

nck_status_t nck_piece_place(nck_lookahead_t *self, const double share_after[NCK_PACES]) {
    const uint32_t count = self->junction.placed;
    const nck_junction_t *const junction = nck_junction_at(self, count);
    around_t ends[2];
    memcpy(ends[1].share, share_after, sizeof ends[1].share);
    const nck_status_t status = look_around(self, count, ends);
    if (status != NCK_OK) return status;
    const int is_clocked = NCK_HAS_OPTIMAL && junction->kind == NCK_JUNCTION_CLOCKED;
    nck_node_t *const end = is_clocked                     ? add_clocked(self, junction)
                            : junction->kind >= NCK_SEG_DWELL ? add_rest(self, junction)
                                                           : place_motion(self, count, ends);
    end->last = 1;
    end->stop = (junction->end & (is_clocked ? NCK_JUNCTION_RESTS : NCK_JUNCTION_STOP)) != 0;
    if (junction->end & NCK_JUNCTION_STOP) {
        self->before.vv = 0.0;
        self->before.vv_over = 0.0;
        self->before_limit = NCK_LIMIT_EXACT_STOP;
    }
    if (junction->kind == NCK_SEG_WAIT) self->window.barrier = self->window.fill;
    if (!self->terms->limits_jerk) pass_share(self, junction);
    self->junction.placed++;
    return NCK_OK;
}
