// SPDX-License-Identifier: MIT
// Inside room 4: caps of segs and junctions.
#include "nck/prep/4_lookahead/joint.h"

#include <string.h> // memset

#include "nck/base/path_math.h"              // nck_path_tangent
#include "nck/prep/4_lookahead/limit_math.h" // nck_limit_… nck_corner_…

#define UNLIMITED 1e30

nck_joint_t *nck_joint_at(nck_lookahead_t *self, uint32_t count) {
    return &self->joint.at[count & (NCK_JOINT_MAX - 1)];
}

static void cap_speed(nck_joint_t *joint, double v, int limit) {
    if (v < joint->v_max) {
        joint->v_max = v;
        joint->limit = (uint8_t)limit;
    }
}

// How much of the path speed an axis sees at most: its direction cosine, on an arc the largest one.
static double largest_cosine(const nck_joint_t *joint, const nck_seg_t *seg, int x,
                             const double *t_in, const double *t_out) {
    if (seg->kind != NCK_SEG_ARC || (x != seg->axis_u && x != seg->axis_v)) {
        return nck_fabs(t_in[x]);
    }
    const double cos_lambda = joint->cos_lambda;
    if (nck_fabs(seg->sweep) >= NCK_PI) return cos_lambda;
    const int across = x == seg->axis_u ? seg->axis_v : seg->axis_u;
    return cos_lambda * nck_limit_arc_cos(t_in[x] / cos_lambda, t_in[across] / cos_lambda,
                                          t_out[x] / cos_lambda, t_out[across] / cos_lambda);
}

static void cap_by_axes(nck_joint_t *joint, const nck_seg_t *seg, const double *t_in,
                        const double *t_out, const nck_machine_t *machine) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        const double c = largest_cosine(joint, seg, x, t_in, t_out);
        if (c == 0.0) continue;
        cap_speed(joint, nck_limit_along(seg->rapid ? axis->rapid : axis->v_max, c),
                  seg->rapid ? NCK_LIMIT_RAPID : NCK_LIMIT_AXIS_V + x);
        if (seg->kind == NCK_SEG_ARC && (x == seg->axis_u || x == seg->axis_v)) {
            joint->a_plane = nck_min(joint->a_plane, axis->a_max);
        } else {
            joint->a_straight = nck_min(joint->a_straight, nck_limit_along(axis->a_max, c));
        }
    }
}

static void make_arc(nck_joint_t *joint, const nck_seg_t *seg, const nck_machine_t *machine) {
    const double ru = seg->start[seg->axis_u] - seg->centre_u;
    const double rv = seg->start[seg->axis_v] - seg->centre_v;
    const double r = nck_sqrt(ru * ru + rv * rv);
    joint->cos_lambda = nck_min(1.0, r * nck_fabs(seg->sweep) / seg->length);
    joint->kappa = joint->cos_lambda * joint->cos_lambda / r;
    cap_speed(joint,
              nck_limit_chord(r, machine->path.chord_error, machine->period_s) / joint->cos_lambda,
              NCK_LIMIT_CHORD);
}

void nck_joint_tangents(const nck_seg_t *seg, double *start_out, double *end_out) {
    memset(start_out, 0, NCK_AXIS_MAX * sizeof *start_out);
    if (seg->length > 0.0) nck_path_tangent(seg, 0.0, start_out);
    if (seg->kind == NCK_SEG_ARC) {
        nck_path_tangent(seg, seg->length, end_out);
    } else {
        memcpy(end_out, start_out, NCK_AXIS_MAX * sizeof *end_out);
    }
}

void nck_joint_make(nck_joint_t *joint, const nck_seg_t *seg, const double *tangent_start,
                    const double *tangent_end, const nck_machine_t *machine) {
    memset(joint, 0, sizeof *joint);
    joint->seq = seg->seq;
    joint->kind = seg->kind;
    joint->length = seg->length;
    joint->stop = seg->stop;
    joint->dwell_s = seg->dwell_s;
    joint->v_corner = UNLIMITED;
    joint->v_max = UNLIMITED;
    joint->a_straight = UNLIMITED;
    joint->a_plane = UNLIMITED;
    if (seg->kind >= NCK_SEG_DWELL) return;
    if (!seg->rapid) {
        cap_speed(joint, seg->feed, NCK_LIMIT_FEED);
        cap_speed(joint, machine->path.feed_max / seg->feed_scale, NCK_LIMIT_FEED_MAX);
    }
    if (seg->kind == NCK_SEG_ARC) make_arc(joint, seg, machine);
    cap_by_axes(joint, seg, tangent_start, tangent_end, machine);
    joint->time = joint->length / joint->v_max;
    joint->a_most = nck_min(machine->path.a_max, joint->a_straight);
    if (joint->kappa > 0.0) {
        joint->a_most = nck_min(joint->a_most, joint->a_plane / joint->cos_lambda);
    }
}

double nck_joint_a_any(const nck_machine_t *machine) {
    double sum = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (machine->axis[x].present) sum += machine->axis[x].a_max * machine->axis[x].a_max;
    }
    return nck_min(machine->path.a_max, nck_sqrt(sum));
}

nck_piece_limit_t nck_joint_piece(const nck_joint_t *joint, double beta,
                                  const nck_machine_t *machine) {
    nck_piece_limit_t piece = {joint->v_max * joint->v_max, machine->path.a_max, joint->limit};
    piece.a = nck_min(piece.a, (1.0 - beta) * joint->a_straight);
    if (joint->kappa > 0.0) {
        const double vv_curve = nck_limit_curve(joint->a_plane, joint->kappa, beta);
        if (vv_curve < piece.vv) {
            piece.vv = vv_curve;
            piece.limit = NCK_LIMIT_CURVATURE;
        }
        const double a_arc = nck_limit_arc_accel((1.0 - beta) * joint->a_plane,
                                                 piece.vv * joint->kappa, joint->cos_lambda);
        piece.a = nck_min(piece.a, a_arc);
    }
    return piece;
}

void nck_joint_meet(nck_joint_t *in, const nck_joint_t *out, const double *tangent_in,
                    const double *tangent_out, const nck_machine_t *machine) {
    if (out->kind >= NCK_SEG_DWELL) in->stop = 1;
    if (in->stop || in->kind >= NCK_SEG_DWELL) return;
    double load = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (tangent_in[x] == tangent_out[x]) continue;
        load = nck_max(load, nck_corner_load(tangent_in[x], tangent_out[x],
                                             machine->axis[x].a_max));
    }
    if (nck_corner_sharp(load, nck_min(in->a_most, out->a_most))) {
        in->v_corner = 0.0;
        return;
    }
    in->load = load;
}

// One direction of a walk along the junctions, away from the one in the middle.
typedef enum side_state { SIDE_KNOWN, SIDE_UNKNOWN, SIDE_OVER } side_state_t;

typedef struct side {
    uint32_t at;        // the next neighbour: the junction at the end of this joint
    uint32_t steps;     // neighbours so far
    double x;           // its distance [mm]; of an unknown one, the least that it can be
    side_state_t state;
} side_t;

// Neighbours of a junction on both sides, nearest first.
typedef struct walk {
    side_t ahead;
    side_t behind;
    double cut;         // where a side was cut off at NCK_CORNER_SPAN neighbours [mm]
} walk_t;

static void cut_off(walk_t *walk, side_t *side) {
    side->state = SIDE_OVER;
    walk->cut = nck_min(walk->cut, side->x);
}

// A junction's load is known once the seg behind it is; nothing is shared across a WAIT.
static void walk_ahead(nck_lookahead_t *self, walk_t *walk) {
    side_t *const side = &walk->ahead;
    if (side->steps >= NCK_CORNER_SPAN) {
        cut_off(walk, side);
        return;
    }
    side->steps++;
    side->at++;
    if (side->at == self->joint.head) {
        side->state = self->ended ? SIDE_OVER : SIDE_UNKNOWN;
        return;
    }
    const nck_joint_t *const joint = nck_joint_at(self, side->at);
    const int newest = side->at + 1 == self->joint.head;
    side->x += joint->length;
    side->state = newest && !self->ended ? SIDE_UNKNOWN : SIDE_KNOWN;
    if (joint->kind == NCK_SEG_WAIT) side->state = SIDE_OVER;
}

static void walk_behind(nck_lookahead_t *self, walk_t *walk) {
    side_t *const side = &walk->behind;
    if (side->steps >= NCK_CORNER_SPAN) {
        cut_off(walk, side);
        return;
    }
    if (side->at == 0 || nck_joint_at(self, side->at - 1)->kind == NCK_SEG_WAIT) {
        side->state = SIDE_OVER;
        return;
    }
    side->x += nck_joint_at(self, side->at)->length;
    side->steps++;
    side->at--;
}

static void walk_begin(nck_lookahead_t *self, walk_t *walk, uint32_t count) {
    const side_t here = {count, 0, 0.0, SIDE_KNOWN};
    walk->ahead = here;
    walk->behind = here;
    walk->cut = UNLIMITED;
    walk_ahead(self, walk);
    walk_behind(self, walk);
}

// The next neighbour nearer than reach. NCK_OK; NCK_DONE: no more; NCK_EMPTY: not known yet.
static nck_status_t walk_next(nck_lookahead_t *self, walk_t *walk, double reach,
                              const nck_joint_t **joint_out, double *x_out) {
    const int forth = walk->behind.state == SIDE_OVER
                      || (walk->ahead.state != SIDE_OVER && walk->ahead.x <= walk->behind.x);
    const side_t *const side = forth ? &walk->ahead : &walk->behind;
    if (side->state == SIDE_OVER || side->x >= reach) return NCK_DONE;
    if (side->state == SIDE_UNKNOWN) return NCK_EMPTY;
    *joint_out = nck_joint_at(self, side->at);
    *x_out = side->x;
    if (forth) {
        walk_ahead(self, walk);
    } else {
        walk_behind(self, walk);
    }
    return NCK_OK;
}

// A·T, where A is the largest acceleration on the segs that can share a period with the junction
// when it is crossed at v.
static nck_status_t largest_gain(nck_lookahead_t *self, uint32_t count, double v, double *a_t_out) {
    const double period = self->machine->period_s;
    const double reach = (v + self->a_any * period) * period;
    const nck_joint_t *neighbour = nck_joint_at(self, count + 1);
    double a = nck_max(nck_joint_at(self, count)->a_most, neighbour->a_most);
    double x = 0.0;
    walk_t walk;
    walk_begin(self, &walk, count);
    nck_status_t status = walk_next(self, &walk, reach, &neighbour, &x);
    while (status == NCK_OK) {
        a = nck_max(a, neighbour->a_most);
        status = walk_next(self, &walk, reach, &neighbour, &x);
    }
    *a_t_out = a * period;
    return status == NCK_DONE ? NCK_OK : status;
}

static void settle(nck_joint_t *joint, double v, double share) {
    joint->v_corner = v;
    joint->share = nck_min(NCK_CORNER_SHARE_MAX, nck_max(0.0, share));
}

// Speed and share of a junction that shares a period with others, v is its speed alone.
static nck_status_t decide_crowd(nck_lookahead_t *self, uint32_t count, double v) {
    nck_joint_t *const joint = nck_joint_at(self, count);
    const double period = self->machine->period_s;
    const double beta = NCK_CORNER_SHARE_MAX;
    const double d = joint->load;
    double a_t = 0.0;
    nck_status_t status = largest_gain(self, count, v, &a_t);
    if (status != NCK_OK) return status;
    double others_d = 0.0;
    double others_dx = 0.0;
    walk_t walk;
    walk_begin(self, &walk, count);
    for (;;) {
        const nck_joint_t *neighbour = joint;
        double x = 0.0;
        status = walk_next(self, &walk, (v + a_t) * period, &neighbour, &x);
        if (status != NCK_OK) break;
        others_d += neighbour->load;
        others_dx += neighbour->load * x;
        v = nck_min(v, nck_corner_speed(beta, d + others_d, others_d, others_dx, a_t, period));
    }
    if (status != NCK_DONE) return status;
    v = nck_max(0.0, nck_min(v, walk.cut / period - a_t));
    settle(joint, v, nck_corner_share(v, d + others_d, others_d, others_dx, a_t, period));
    return NCK_OK;
}

// Speed and share of a junction with a load, between two known segs.
static nck_status_t decide_corner(nck_lookahead_t *self, uint32_t count) {
    nck_joint_t *const joint = nck_joint_at(self, count);
    const nck_joint_t *const out = nck_joint_at(self, count + 1);
    const double period = self->machine->period_s;
    double v = nck_corner_speed(NCK_CORNER_SHARE_MAX, joint->load, 0.0, 0.0, 0.0, period);
    v = nck_min(v, nck_min(joint->v_max, out->v_max));
    const double reach = (v + self->a_any * period) * period;
    if (joint->length < reach || out->length < reach) return decide_crowd(self, count, v);
    settle(joint, v, nck_corner_share(v, joint->load, 0.0, 0.0, 0.0, period));
    return NCK_OK;
}

nck_status_t nck_joint_decide(nck_lookahead_t *self) {
    const uint32_t count = self->joint.decided;
    if (count == self->joint.head) return NCK_EMPTY;
    nck_joint_t *const joint = nck_joint_at(self, count);
    const int newest = count + 1 == self->joint.head;
    if (newest && !self->ended && joint->kind < NCK_SEG_DWELL) return NCK_EMPTY;
    if (newest) joint->stop = 1;
    if (joint->load > 0.0) {
        const nck_status_t status = decide_corner(self, count);
        if (status != NCK_OK) return status;
    }
    self->joint.decided++;
    return NCK_OK;
}

double nck_joint_share_before(nck_lookahead_t *self, uint32_t count) {
    double share = 0.0;
    double time = 0.0;
    for (uint32_t n = 0; n < NCK_CORNER_SPAN; n++) {
        if (count == 0) return share;
        count--;
        const nck_joint_t *const joint = nck_joint_at(self, count);
        if (joint->kind == NCK_SEG_WAIT) return share;
        share = nck_max(share, joint->share);
        time += joint->time;
        if (time >= self->machine->period_s) return share;
    }
    return NCK_CORNER_SHARE_MAX;
}

nck_status_t nck_joint_share_after(nck_lookahead_t *self, uint32_t count, double *share_out) {
    double share = 0.0;
    double time = 0.0;
    *share_out = NCK_CORNER_SHARE_MAX;
    for (uint32_t n = 0; n < NCK_CORNER_SPAN; n++) {
        if (count == self->joint.decided) return NCK_EMPTY;
        share = nck_max(share, nck_joint_at(self, count)->share);
        *share_out = share;
        if (nck_joint_at(self, count)->kind == NCK_SEG_WAIT) return NCK_OK;
        count++;
        if (count == self->joint.head) return self->ended ? NCK_OK : NCK_EMPTY;
        time += nck_joint_at(self, count)->time;
        if (time >= self->machine->period_s) return NCK_OK;
    }
    *share_out = NCK_CORNER_SHARE_MAX;
    return NCK_OK;
}
