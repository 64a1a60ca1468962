// SPDX-License-Identifier: MIT
// Room 4, lookahead: joints become nodes, nodes get their envelope.
#include "nck/prep/4_lookahead/lookahead.h"

#include <string.h> // memset

#include "nck/prep/4_lookahead/envelope_math.h" // nck_envelope_…
#include "nck/prep/4_lookahead/joint.h"         // nck_joint_…

enum {
    PIECES_PER_SEG = 3, // head, middle, tail
    PASS_STEP = 32,     // nodes in one bounded step of a pass
    PHASE_NONE = 0, PHASE_BACKWARD = 1, PHASE_FORWARD = 2
};

// A seg is cut where its junctions' share ends only if that frees more than this share of its
// acceleration, and if the middle is at least as long as both its ends.
#define SPLIT_SHARE 0.05
#define SPLIT_ZONES 4.0

void nck_lookahead_init(nck_lookahead_t *self, const nck_machine_t *machine) {
    memset(self, 0, sizeof *self);
    self->machine = machine;
    self->a_any = nck_joint_a_any(machine);
    self->limit_before = NCK_LIMIT_EXACT_STOP;
}

int nck_lookahead_has_room(const nck_lookahead_t *self) {
    return self->joint.head - self->joint.placed < NCK_JOINT_MAX - NCK_CORNER_SPAN;
}

nck_status_t nck_lookahead_push(nck_lookahead_t *self, const nck_seg_t *seg) {
    if (!nck_lookahead_has_room(self)) return NCK_FULL;
    nck_joint_t *const joint = nck_joint_at(self, self->joint.head);
    double start[NCK_AXIS_MAX];
    double end[NCK_AXIS_MAX];
    nck_joint_tangents(seg, start, end);
    nck_joint_make(joint, seg, start, end, self->machine);
    if (self->joint.head > 0) {
        nck_joint_meet(nck_joint_at(self, self->joint.head - 1), joint, self->joint.tangent, start,
                       self->machine);
    }
    memcpy(self->joint.tangent, end, sizeof end);
    self->joint.head++;
    return NCK_OK;
}

void nck_lookahead_end(nck_lookahead_t *self) { self->ended = 1; }

static nck_node_t *node_at(nck_lookahead_t *self, uint32_t i) {
    return &self->window.at[(self->window.head + i) & (NCK_WINDOW - 1)];
}

static double h_of(const nck_node_t *node) { return nck_envelope_h(node->a, node->length); }

// Append the piece from s, of a length, under the share beta; v_node caps the node at its start.
static void add_piece(nck_lookahead_t *self, const nck_joint_t *joint, const double s[2],
                      double beta, double v_node) {
    const nck_piece_limit_t piece = nck_joint_piece(joint, beta, self->machine);
    nck_node_t *const node = node_at(self, self->window.fill);
    memset(node, 0, sizeof *node);
    node->seg = joint->seq;
    node->kind = joint->kind;
    node->s = s[0];
    node->length = s[1] - s[0];
    node->a = piece.a;
    node->vv_piece = piece.vv;
    node->limit_piece = piece.limit;
    node->vv_cap = piece.vv;
    node->limit = piece.limit;
    if (self->vv_before < node->vv_cap) {
        node->vv_cap = self->vv_before;
        node->limit = (uint8_t)self->limit_before;
    }
    if (v_node * v_node < node->vv_cap) {
        node->vv_cap = v_node * v_node;
        node->limit = NCK_LIMIT_CORNER;
    }
    self->vv_before = piece.vv;
    self->limit_before = piece.limit;
    self->window.fill++;
}

static void add_rest(nck_lookahead_t *self, const nck_joint_t *joint) {
    nck_node_t *const node = node_at(self, self->window.fill);
    memset(node, 0, sizeof *node);
    node->seg = joint->seq;
    node->kind = joint->kind;
    node->a = self->machine->path.a_max;
    node->dwell_s = joint->dwell_s;
    node->limit = NCK_LIMIT_EXACT_STOP;
    node->limit_piece = joint->kind == NCK_SEG_DWELL ? NCK_LIMIT_DWELL : NCK_LIMIT_WAIT;
    self->window.fill++;
}

// The ends within one period of a junction keep to its share; the middle has all of a.
static void add_motion(nck_lookahead_t *self, const nck_joint_t *joint, double head, double tail,
                       double v_start) {
    const double zone = joint->v_max * self->machine->period_s;
    const int split = nck_max(head, tail) > SPLIT_SHARE && joint->length > SPLIT_ZONES * zone;
    const double a = split && head > 0.0 ? zone : 0.0;
    const double b = split && tail > 0.0 ? joint->length - zone : joint->length;
    const double first[2] = {0.0, a};
    const double middle[2] = {a, b};
    const double last[2] = {b, joint->length};
    if (a > 0.0) add_piece(self, joint, first, head, v_start);
    add_piece(self, joint, middle, split ? 0.0 : nck_max(head, tail),
              a > 0.0 ? joint->v_max : v_start);
    if (b < joint->length) add_piece(self, joint, last, tail, joint->v_max);
}

// Turn the oldest joint into nodes. NCK_EMPTY if what follows it is not decided yet.
static nck_status_t place(nck_lookahead_t *self) {
    const uint32_t count = self->joint.placed;
    const nck_joint_t *const joint = nck_joint_at(self, count);
    double tail = 0.0;
    const nck_status_t status = nck_joint_share_after(self, count, &tail);
    if (status != NCK_OK) return status;
    if (joint->kind >= NCK_SEG_DWELL) {
        add_rest(self, joint);
    } else {
        const double v_start = count > 0 ? nck_joint_at(self, count - 1)->v_corner : 0.0;
        add_motion(self, joint, nck_joint_share_before(self, count), tail, v_start);
    }
    nck_node_t *const end = node_at(self, self->window.fill - 1);
    end->last = 1;
    end->stop = joint->stop;
    if (joint->stop) {
        self->vv_before = 0.0;
        self->limit_before = NCK_LIMIT_EXACT_STOP;
    }
    if (joint->kind == NCK_SEG_WAIT) self->window.barrier = self->window.fill;
    self->window.segs++;
    self->joint.placed++;
    return NCK_OK;
}

static int window_full(const nck_lookahead_t *self) {
    const uint32_t blocks = self->machine->lookahead_blocks;
    return self->window.fill > NCK_WINDOW - PIECES_PER_SEG
           || (blocks > 0 && self->window.segs >= blocks);
}

static int all_placed(const nck_lookahead_t *self) {
    return self->ended && self->joint.placed == self->joint.head;
}

// How many pieces become final by a pass begun now; 0: none, more must come first. Depends on
// counts of segs only, never on time, so that equal capacities give equal setpoints.
static uint32_t pass_final(const nck_lookahead_t *self) {
    if (self->window.fill == 0) return 0;
    if (all_placed(self)) return self->window.fill;
    const uint32_t half = window_full(self) || self->window.restart ? self->window.fill / 2 : 0;
    return half > self->window.barrier ? half : self->window.barrier;
}

static void pass_begin(nck_lookahead_t *self, uint32_t final) {
    self->pass.phase = PHASE_BACKWARD;
    self->pass.left = self->window.fill;
    self->pass.final = final;
    self->pass.vv = 0.0;
    self->pass.open = !node_at(self, self->window.fill - 1)->stop;
    self->window.restart = 0;
}

// w_i = min(w_cap,i, w_{i+1} + h_i) from the window's end, where the path must be able to rest.
static void pass_backward(nck_lookahead_t *self) {
    for (int n = 0; n < PASS_STEP && self->pass.left > 0; n++) {
        self->pass.left--;
        nck_node_t *const node = node_at(self, self->pass.left);
        const double h = h_of(node);
        if (!(self->pass.vv + h < node->vv_cap)) self->pass.open = 0;
        node->open = (uint8_t)self->pass.open;
        node->vv = nck_envelope_backward(node->vv_cap, self->pass.vv, h);
        self->pass.vv = node->vv;
    }
    if (self->pass.left > 0) return;
    self->pass.phase = PHASE_FORWARD;
    node_at(self, 0)->vv = self->window.vv_entry;
}

// w_{i+1} = min(w_{i+1}, w_i + h_i) over the pieces that become final.
static void pass_forward(nck_lookahead_t *self) {
    for (int n = 0; n < PASS_STEP && self->pass.left < self->pass.final; n++) {
        const nck_node_t *const node = node_at(self, self->pass.left);
        self->pass.left++;
        if (self->pass.left == self->window.fill) break;
        nck_node_t *const next = node_at(self, self->pass.left);
        next->vv = nck_envelope_forward(next->vv, node->vv, h_of(node));
    }
    if (self->pass.left < self->pass.final) return;
    self->pass.phase = PHASE_NONE;
    self->window.final = self->pass.final;
}

nck_status_t nck_lookahead_step(nck_lookahead_t *self) {
    if (self->pass.phase == PHASE_BACKWARD) {
        pass_backward(self);
        return NCK_OK;
    }
    if (self->pass.phase == PHASE_FORWARD) {
        pass_forward(self);
        return NCK_OK;
    }
    if (self->window.final == 0) {
        const uint32_t final = pass_final(self);
        if (final > 0) {
            pass_begin(self, final);
            return NCK_OK;
        }
    }
    if (window_full(self)) return NCK_FULL;
    const int open = self->joint.placed != self->joint.decided;
    if (open && place(self) == NCK_OK) return NCK_OK;
    if (nck_joint_decide(self) == NCK_OK) return NCK_OK;
    if (!all_placed(self)) return NCK_EMPTY;
    return self->window.final > 0 || self->window.fill == 0 ? NCK_DONE : NCK_OK;
}

nck_status_t nck_lookahead_piece(const nck_lookahead_t *self, uint32_t i,
                                 const nck_node_t **node_out, double *vv_end_out) {
    if (i >= self->window.final || self->pass.phase != PHASE_NONE) return NCK_EMPTY;
    *node_out = nck_lookahead_ahead(self, i);
    const nck_node_t *const next = nck_lookahead_ahead(self, i + 1);
    *vv_end_out = next ? next->vv : 0.0;
    return NCK_OK;
}

const nck_node_t *nck_lookahead_ahead(const nck_lookahead_t *self, uint32_t i) {
    if (i >= self->window.fill) return (const nck_node_t *)0;
    return &self->window.at[(self->window.head + i) & (NCK_WINDOW - 1)];
}

// Forget pieces from the head, final or not.
static void forget(nck_lookahead_t *self, uint32_t n) {
    for (uint32_t i = 0; i < n; i++) {
        if (node_at(self, i)->last) self->window.segs--;
    }
    self->window.head += n;
    self->window.fill -= n;
    self->window.final -= n < self->window.final ? n : self->window.final;
    self->window.barrier -= n < self->window.barrier ? n : self->window.barrier;
}

void nck_lookahead_drop(nck_lookahead_t *self, uint32_t n) {
    forget(self, n);
    self->window.vv_entry = self->window.fill > 0 ? node_at(self, 0)->vv : 0.0;
}

void nck_lookahead_restart(nck_lookahead_t *self, uint32_t n, double s) {
    forget(self, n);
    self->pass.phase = PHASE_NONE;
    self->window.final = 0;
    self->window.restart = 1;
    self->window.vv_entry = 0.0;
    nck_node_t *const node = node_at(self, 0);
    const double past = nck_min(s - node->s, node->length);
    node->length -= past;
    node->s += past;
    node->vv_cap = 0.0;
}

int nck_lookahead_invariants(const nck_lookahead_t *self) {
    const uint32_t fill = self->window.fill;
    int good = fill <= NCK_WINDOW && self->window.final <= fill && self->window.barrier <= fill
               && self->joint.head - self->joint.decided <= self->joint.head - self->joint.placed
               && self->joint.head - self->joint.placed <= NCK_JOINT_MAX - NCK_CORNER_SPAN;
    for (uint32_t i = 0; good && i < self->window.final; i++) {
        const nck_node_t *const node = nck_lookahead_ahead(self, i);
        const nck_node_t *const next = nck_lookahead_ahead(self, i + 1);
        good = node->vv >= 0.0 && node->vv <= node->vv_cap && node->vv_cap <= node->vv_piece
               && (!next || self->pass.phase != PHASE_NONE || !node->stop || next->vv == 0.0);
    }
    return good;
}
