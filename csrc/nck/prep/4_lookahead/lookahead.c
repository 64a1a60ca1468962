// SPDX-License-Identifier: MIT
// Room 4, lookahead: joints become nodes, nodes get their envelope.
#include "nck/prep/4_lookahead/lookahead.h"

#include <string.h> // memset

#include "nck/base/budget.h"             // NCK_UNLIMITED
#include "nck/base/real.h"               // nck_min nck_max nck_sqrt
#include "nck/prep/4_lookahead/corner.h" // nck_corner_…
#include "nck/prep/4_lookahead/joint.h"  // nck_joint_…
#include "nck/prep/4_lookahead/near.h"   // nck_near_…

enum {
    PIECES_PER_SEG = 3, // head, middle, tail
    WORKS_PER_SEG = 3, // settle, decide, place
    JOINT_ROOM = NCK_JOINT_MAX - NCK_CORNER_SPAN - NCK_SPLINE_PARTS, // and one seg more goes in
};

// A seg is cut where its junctions' share ends only if that frees more than this share of its
// acceleration, and if the middle is at least as long as both its ends.
#define SPLIT_SHARE 0.05
#define SPLIT_ZONES 1.3

void nck_lookahead_init(nck_lookahead_t *self, const nck_terms_t *terms) {
    memset(self, 0, sizeof *self);
    self->terms = terms;
    nck_lookahead_adapt(self);
    self->before.limit = NCK_LIMIT_EXACT_STOP;
}

void nck_lookahead_adapt(nck_lookahead_t *self) {
    self->a_any = nck_joint_a_any(self->terms->machine);
    self->zone_s = nck_corner_zone_s(self->terms);
}

int nck_lookahead_has_room(const nck_lookahead_t *self) {
    return self->joint.head - self->joint.placed <= JOINT_ROOM;
}

// Put the newest joint into the chain.
static void join(nck_lookahead_t *self) {
    self->joint.head++;
    nck_near_level(self);
}

// Part the newest joint, a spline's, which is not in the chain yet.
static void push_parts(nck_lookahead_t *self, const nck_seg_t *seg, int count) {
    double span[2] = {0.0, 0.0};
    for (int k = 0; k < count; k++) {
        span[1] = k + 1 < count ? seg->length * (double)(k + 1) / (double)count : seg->length;
        nck_joint_part(nck_joint_at(self, self->joint.head), seg, span, self->terms);
        join(self);
        span[0] = span[1];
    }
}

nck_status_t nck_lookahead_push(nck_lookahead_t *self, const nck_seg_t *seg) {
    if (!nck_lookahead_has_room(self)) return NCK_FULL;
    self->ended = 0;
    nck_joint_t *const joint = nck_joint_at(self, self->joint.head);
    double start[NCK_AXIS_MAX];
    double end[NCK_AXIS_MAX];
    nck_joint_tangents(seg, start, end);
    nck_joint_make(joint, seg, start, end, self->terms);
    if (self->joint.head > 0) {
        nck_corner_meet(nck_joint_at(self, self->joint.head - 1), joint, self->joint.tangent, start,
                        self->terms);
    }
    memcpy(self->joint.tangent, end, sizeof end);
    const int parts = nck_joint_parts(joint, self->terms);
    if (parts > 1) {
        push_parts(self, seg, parts);
    } else {
        join(self);
    }
    return NCK_OK;
}

void nck_lookahead_end(nck_lookahead_t *self) {
    nck_near_end(self);
    self->ended = 1;
}

static nck_node_t *node_at(nck_lookahead_t *self, uint32_t i) {
    return &self->window.at[(self->window.head + i) & (NCK_WINDOW - 1)];
}

// What the neighbourhood leaves to a piece, by pace.
typedef struct around {
    double share[NCK_PACES];
    nck_near_t near[NCK_PACES];
} around_t;

static const around_t NOTHING_AROUND = {
    {0.0, 0.0}, {{NCK_UNLIMITED, NCK_UNLIMITED, 1.0}, {NCK_UNLIMITED, NCK_UNLIMITED, 1.0}}};

// What another side's neighbourhood takes on top.
static void add_around(around_t *around, const around_t *other) {
    for (int k = 0; k < NCK_PACES; k++) {
        nck_near_t *const near = &around->near[k];
        around->share[k] = nck_max(around->share[k], other->share[k]);
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

// The caps of the node at a piece's start.
static void cap_node(nck_lookahead_t *self, nck_node_t *node, const double v_corner[]) {
    const double vv_corner = v_corner[NCK_PACE_FEED] * v_corner[NCK_PACE_FEED];
    node->vv_node = node_cap(self, node->vv_over, v_corner);
    node->vv_cap = node->vv_piece;
    node->limit = node->limit_piece;
    if (self->before.vv < node->vv_cap) {
        node->vv_cap = self->before.vv;
        node->limit = (uint8_t)self->before.limit;
    }
    if (vv_corner < node->vv_cap) {
        node->vv_cap = vv_corner;
        node->limit = NCK_LIMIT_CORNER;
    }
    if (self->terms->limits_jerk) node->vv_cap = nck_min(node->vv_cap, node->vv_node);
    self->before.vv = node->vv_piece;
    self->before.vv_over = node->vv_over;
    self->before.limit = node->limit_piece;
}

static nck_piece_limit_t limits_of(const nck_lookahead_t *self, const nck_joint_t *joint,
                                   const around_t *around, int pace) {
    const nck_near_t *const near = &around->near[pace];
    nck_piece_limit_t piece =
        nck_joint_piece(joint, around->share[pace], pace, self->terms);
    piece.a = nck_min(piece.a, near->a);
    piece.j = nck_min(piece.j, near->j);
    piece.vv *= near->slow * near->slow;
    piece.vv_free *= near->slow * near->slow;
    return piece;
}

// Append the piece from s[0] to s[1]; v_corner caps the node at its start.
static void add_piece(nck_lookahead_t *self, const nck_joint_t *joint, const double s[2],
                      const around_t *around, const double v_corner[]) {
    const nck_piece_limit_t piece = limits_of(self, joint, around, NCK_PACE_FEED);
    const nck_piece_limit_t over = limits_of(self, joint, around, NCK_PACE_OVER);
    nck_node_t *const node = node_at(self, self->window.fill);
    memset(node, 0, sizeof *node);
    node->seg = joint->seq;
    node->kind = joint->kind;
    node->s = joint->s + s[0];
    node->length = s[1] - s[0];
    node->a = piece.a;
    node->a_over = nck_min(piece.a, over.a);
    node->j = piece.j;
    node->j_over = nck_min(piece.j, over.j);
    node->feed = joint->feed;
    node->vv_piece = piece.vv;
    node->vv_over = over.vv_free;
    node->limit_piece = piece.limit;
    if (self->terms->limits_jerk) node->vv_piece = nck_min(piece.vv, over.vv_free);
    cap_node(self, node, v_corner);
    self->window.fill++;
}

static void add_rest(nck_lookahead_t *self, const nck_joint_t *joint) {
    nck_node_t *const node = node_at(self, self->window.fill);
    memset(node, 0, sizeof *node);
    node->seg = joint->seq;
    node->kind = joint->kind;
    node->a = self->terms->machine->path.a_max;
    node->a_over = node->a;
    node->j = self->terms->machine->path.j_max;
    node->j_over = node->j;
    node->dwell_s = joint->shape.dwell_s;
    node->limit = NCK_LIMIT_EXACT_STOP;
    node->limit_piece = joint->kind == NCK_SEG_DWELL ? NCK_LIMIT_DWELL : NCK_LIMIT_WAIT;
    self->window.fill++;
}

// How far a zone reaches into a seg that is entered (left) at v_node at most: at the seg's own
// speed, or at what it can have gained by then with the acceleration that the zone leaves. Where no
// junction takes a share, as far as the filter mixes.
static double zone_length(const nck_lookahead_t *self, const nck_joint_t *joint, double v_node,
                          const around_t *around) {
    if (!self->terms->limits_jerk) return joint->v_max * self->zone_s;
    const double time = around->share[NCK_PACE_OVER] > 0.0 ? self->zone_s : self->terms->mix_s;
    const double near = nck_max(around->near[NCK_PACE_FEED].a, around->near[NCK_PACE_OVER].a);
    const double gained = 0.5 * nck_min(joint->a_most, near) * time * time;
    const double raised = v_node + self->terms->v_filter;
    return nck_min(joint->pace[NCK_PACE_OVER].v * time, raised * time + gained);
}

// How fast the path may be between the segs count − 1 and count, both known if they exist, by the
// junction and the segs.
static double speed_between(nck_lookahead_t *self, uint32_t count) {
    if (count == 0 || count == self->joint.head) return 0.0;
    const nck_joint_t *const before = nck_joint_at(self, count - 1);
    const nck_joint_t *const behind = nck_joint_at(self, count);
    if ((before->end & NCK_JOINT_STOP) || behind->kind >= NCK_SEG_DWELL) return 0.0;
    const nck_pace_t *const pace = &before->pace[NCK_PACE_OVER];
    return nck_min(pace->v_corner, nck_min(pace->v, behind->pace[NCK_PACE_OVER].v));
}

// Whether a seg is worth a piece of its own next to the node around which less is allowed.
static int is_tighter(const nck_lookahead_t *self, const nck_joint_t *joint,
                      const around_t *around) {
    if (around->share[NCK_PACE_FEED] > SPLIT_SHARE) return 1;
    if (!self->terms->limits_jerk) return 0; // nothing is mixed: neighbours limit nothing
    const nck_piece_limit_t own = nck_joint_piece(joint, 0.0, NCK_PACE_FEED, self->terms);
    const nck_near_t *const near = &around->near[NCK_PACE_FEED];
    return near->a < (1.0 - SPLIT_SHARE) * own.a || near->j < (1.0 - SPLIT_SHARE) * own.j;
}

// The zones of a seg that are cut off, and how long they are; none if the middle would be too
// short. The linear slope, once it cuts a seg, cuts at every share. Returns 1 if any is.
static int find_zones(nck_lookahead_t *self, uint32_t count, const around_t ends[2],
                      int is_cut_off[2], double zone[2]) {
    const nck_joint_t *const joint = nck_joint_at(self, count);
    int tighter = 0;
    for (int n = 0; n < 2; n++) {
        is_cut_off[n] = is_tighter(self, joint, &ends[n]);
        tighter = tighter || is_cut_off[n];
    }
    if (!tighter) return 0;
    for (uint32_t n = 0; n < 2; n++) {
        if (!self->terms->limits_jerk) is_cut_off[n] = ends[n].share[NCK_PACE_FEED] > 0.0;
        if (!is_cut_off[n]) continue;
        zone[n] = zone_length(self, joint, speed_between(self, count + n), &ends[n]);
    }
    return joint->length > SPLIT_ZONES * (zone[0] + zone[1]);
}

// What is left of the neighbourhood in a middle whose ends are cut off or not. The linear slope's
// zones are those of the programmed speed, so beyond it the middle keeps the shares free too.
static void keep_in_middle(const nck_lookahead_t *self, const around_t ends[2],
                           const int is_cut_off[2], around_t *middle_out) {
    double share = 0.0;
    *middle_out = NOTHING_AROUND;
    for (int n = 0; n < 2; n++) {
        share = nck_max(share, ends[n].share[NCK_PACE_OVER]);
        if (!is_cut_off[n]) add_around(middle_out, &ends[n]);
    }
    if (!self->terms->limits_jerk) middle_out->share[NCK_PACE_OVER] = share;
}

// All of a seg in one piece, under what both of its sides leave.
static void add_whole(nck_lookahead_t *self, const nck_joint_t *joint, around_t ends[2],
                      const double v_start[]) {
    const double whole[2] = {0.0, joint->length};
    add_around(&ends[0], &ends[1]);
    add_piece(self, joint, whole, &ends[0], v_start);
}

// Inside a zone the share of its junction is kept free and its neighbour's limits hold; the middle
// has all that the seg allows.
static void add_motion(nck_lookahead_t *self, uint32_t count, around_t ends[2],
                       const double v_start[]) {
    const nck_joint_t *const joint = nck_joint_at(self, count);
    const double unlimited[NCK_PACES] = {joint->v_max, joint->v_free};
    double zone[2] = {0.0, 0.0};
    int is_cut_off[2];
    if (!find_zones(self, count, ends, is_cut_off, zone)) {
        add_whole(self, joint, ends, v_start);
        return;
    }
    const double a = is_cut_off[0] ? zone[0] : 0.0;
    const double b = is_cut_off[1] ? joint->length - zone[1] : joint->length;
    const double first[2] = {0.0, a};
    const double middle[2] = {a, b};
    const double last[2] = {b, joint->length};
    around_t inside;
    around_t beside[2];
    memcpy(beside, ends, sizeof beside);
    keep_in_middle(self, ends, is_cut_off, &inside);
    for (int n = 0; n < 2 && self->terms->limits_jerk; n++) {
        if (!is_cut_off[1 - n]) add_around(&beside[n], &ends[1 - n]); // it may reach all the way
    }
    if (is_cut_off[0]) add_piece(self, joint, first, &beside[0], v_start);
    add_piece(self, joint, middle, &inside, is_cut_off[0] ? unlimited : v_start);
    if (is_cut_off[1]) add_piece(self, joint, last, &beside[1], unlimited);
}

// What reaches into the oldest joint from before and from behind. NCK_EMPTY if it is not known yet.
static nck_status_t look_around(nck_lookahead_t *self, uint32_t count, around_t ends[2]) {
    ends[0] = NOTHING_AROUND;
    ends[1] = NOTHING_AROUND;
    for (int k = 0; k < NCK_PACES; k++) {
        nck_status_t status = nck_corner_share_after(self, count, k, &ends[1].share[k]);
        if (status != NCK_OK) return status;
        ends[0].share[k] = nck_corner_share_before(self, count, k);
        if (!self->terms->limits_jerk) continue;
        const double beta = nck_max(ends[0].share[k], ends[1].share[k]);
        status = nck_near_after(self, count, k, beta, &ends[1].near[k]);
        if (status != NCK_OK) return status;
        ends[0].near[k] = nck_near_before(self, count, k, beta);
    }
    return NCK_OK;
}

static void place_motion(nck_lookahead_t *self, uint32_t count, around_t ends[2]) {
    double v_start[NCK_PACES] = {0.0, 0.0};
    for (int k = 0; k < NCK_PACES && count > 0; k++) {
        v_start[k] = nck_joint_at(self, count - 1)->pace[k].v_corner;
    }
    add_motion(self, count, ends, v_start);
}

// Turn the oldest joint into nodes. NCK_EMPTY if what follows it is not decided yet.
static nck_status_t place(nck_lookahead_t *self) {
    const uint32_t count = self->joint.placed;
    const nck_joint_t *const joint = nck_joint_at(self, count);
    around_t ends[2];
    const nck_status_t status = look_around(self, count, ends);
    if (status != NCK_OK) return status;
    if (joint->kind >= NCK_SEG_DWELL) {
        add_rest(self, joint);
    } else {
        place_motion(self, count, ends);
    }
    nck_node_t *const end = node_at(self, self->window.fill - 1);
    end->last = (joint->end & NCK_JOINT_LAST) != 0;
    end->stop = (joint->end & NCK_JOINT_STOP) != 0;
    if (end->stop) {
        self->before.vv = 0.0;
        self->before.vv_over = 0.0;
        self->before.limit = NCK_LIMIT_EXACT_STOP;
    }
    if (joint->kind == NCK_SEG_WAIT) self->window.barrier = self->window.fill;
    self->joint.placed++;
    return NCK_OK;
}

static int window_full(const nck_lookahead_t *self) {
    return self->window.fill > NCK_WINDOW - PIECES_PER_SEG;
}

static int all_placed(const nck_lookahead_t *self) {
    return self->ended && self->joint.placed == self->joint.head;
}

int nck_lookahead_is_settled(const nck_lookahead_t *self) {
    return self->joint.placed == self->joint.head && (self->ended || self->joint.head == 0);
}

// What a seg needs after the other: its own speeds, its junction, its place in the window.
nck_status_t nck_lookahead_step(nck_lookahead_t *self) {
    int worked = 0;
    if (window_full(self)) return NCK_FULL;
    for (int n = 0; n < WORKS_PER_SEG; n++) {
        if (self->joint.near != self->joint.decided && place(self) == NCK_OK) return NCK_OK;
        if (nck_corner_decide(self) != NCK_OK && nck_near_settle(self) != NCK_OK) break;
        worked = 1;
    }
    if (worked) return NCK_OK;
    return all_placed(self) ? NCK_DONE : NCK_EMPTY;
}

const nck_node_t *nck_lookahead_ahead(const nck_lookahead_t *self, uint32_t i) {
    if (i >= self->window.fill) return (const nck_node_t *)0;
    return &self->window.at[(self->window.head + i) & (NCK_WINDOW - 1)];
}

uint32_t nck_lookahead_oldest(const nck_lookahead_t *self, uint32_t newer) {
    const uint32_t placed = self->joint.placed;
    if (self->window.fill > 0) return nck_lookahead_ahead(self, 0)->seg;
    return placed == self->joint.head ? newer : self->joint.at[placed & (NCK_JOINT_MAX - 1)].seq;
}

uint32_t nck_lookahead_fill(const nck_lookahead_t *self) { return self->window.fill; }

int nck_lookahead_is_complete(const nck_lookahead_t *self) {
    const uint32_t fill = self->window.fill;
    return all_placed(self) || (fill > 0 && self->window.barrier == fill);
}

void nck_lookahead_drop(nck_lookahead_t *self, uint32_t n) {
    self->window.head += n;
    self->window.fill -= n;
    self->window.barrier -= n < self->window.barrier ? n : self->window.barrier;
}

int nck_lookahead_invariants(const nck_lookahead_t *self) {
    const uint32_t fill = self->window.fill;
    int good = fill <= NCK_WINDOW && self->window.barrier <= fill
               && self->joint.head - self->joint.decided <= self->joint.head - self->joint.placed
               && self->joint.head - self->joint.settled <= self->joint.head - self->joint.decided
               && self->joint.head - self->joint.placed <= NCK_JOINT_MAX - NCK_CORNER_SPAN;
    for (uint32_t i = 0; good && i < fill; i++) {
        const nck_node_t *const node = nck_lookahead_ahead(self, i);
        const nck_node_t *const next = nck_lookahead_ahead(self, i + 1);
        good = node->vv_cap >= 0.0 && node->vv_cap <= node->vv_piece
               && (!next || !node->stop || next->vv_cap == 0.0);
    }
    return good;
}
