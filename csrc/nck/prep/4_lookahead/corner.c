// SPDX-License-Identifier: MIT
// Inside room 4: speed and share of junctions, alone and where many share a period.
#include "nck/prep/4_lookahead/corner.h"

#include "nck/base/budget.h"                 // NCK_UNLIMITED
#include "nck/base/scurve_math.h"            // nck_scurve_over
#include "nck/prep/4_lookahead/limit_math.h" // nck_corner_…

// Smooth or straight pieces pass into each other without a corner, but for rounding: 1e-13 mm in
// 1000 mm over a piece of 0.01 mm turns it by 3e-11, which at 100 mm/s, 1 ms and 1000 mm/s² costs
// the share 3e-9.
// A share as small as this one is left out; the nanometre of a setpoint costs more.
#define SHARE_OF_ROUNDING 1e-7

// A junction is alone if the segs around it are longer than so many of its zones: then what happens
// between junctions takes longer than what happens at them.
#define ZONES_APART 16.0
// A seg is cut at its zones if it is longer than both of them by so much (lookahead.c).
#define ZONES_CUT 1.3

double nck_corner_zone_s(const nck_terms_t *terms) {
    return terms->machine->period_s + terms->mix_s;
}

// Whether no other junction is near one of this load.
static int is_alone(const nck_joint_t *in, const nck_joint_t *out, double load,
                    const nck_terms_t *terms) {
    const double time = nck_corner_zone_s(terms);
    const double v = nck_corner_speed(NCK_CORNER_SHARE_DENSE, load, 0.0, 0.0, 0.0,
                                      terms->machine->period_s);
    const double zone = (v + 0.5 * nck_max(in->a_most, out->a_most) * time) * time;
    return nck_min(in->length, out->length) > ZONES_APART * zone;
}

// Time of a junction that is crossed at v, over half of the segs beside it: in its zone the path
// keeps to about that speed.
static double crossing_time(const double half[2], double v, const nck_scurve_t *ramp,
                            double zone_s) {
    double time = 0.0;
    for (int n = 0; n < 2; n++) {
        const double zone = nck_min(half[n], v * zone_s);
        time += zone / v + nck_scurve_over(ramp, v, half[n] - zone);
    }
    return time;
}

// Whether the path, under a jerk limit, is faster with a stop at a junction. A blunt one is crossed
// as fast as a ramp from rest gets over half a seg, v³ = j·l².
static int is_slow(const nck_joint_t *in, const nck_joint_t *out, double load,
                   const nck_terms_t *terms) {
    const double period = terms->machine->period_s;
    const double half[2] = {0.5 * in->length, 0.5 * out->length};
    const nck_scurve_t ramp = {nck_min(in->a_most, out->a_most),
                             nck_min(in->j_straight, out->j_straight),
                             nck_min(in->v_free, out->v_free)};
    const double most = NCK_CORNER_SHARE_DENSE * period / load;
    const double v = most - terms->v_filter;
    if (most >= ramp.v_max) return 0;
    if (!(v > 0.0)) return 1;
    if (v * v * v >= ramp.j * nck_max(half[0] * half[0], half[1] * half[1])) return 0;
    const double stop = nck_scurve_over(&ramp, 0.0, half[0]) + nck_scurve_over(&ramp, 0.0, half[1])
                        + 2.0 * terms->mix_s + period;
    return stop < crossing_time(half, v, &ramp, nck_corner_zone_s(terms));
}

// Whether a seg's half is crossed at v no later than it is left from rest: half/v ≤ √(2·half/a).
static int is_fast(const nck_joint_t *joint, double v) {
    return joint->a_most * joint->length <= 4.0 * v * v;
}

// The same where jerk is not limited: all over segs that are too short to be cut at the zones of
// the programmed speed, a crossing leaves half of the acceleration. A stop costs a period at most.
static int is_slow_linear(const nck_joint_t *in, const nck_joint_t *out, double load,
                          const nck_machine_t *machine) {
    const nck_joint_t *joint[2];
    joint[0] = in;
    joint[1] = out;
    const double period = machine->period_s;
    const double v_max = nck_min(in->v_max, out->v_max);
    const double v = nck_min(NCK_CORNER_SHARE_MAX * period / load, v_max);
    if (is_fast(in, v) && is_fast(out, v)) return 0; // a stop costs a period on top
    const double share = v * load / period;
    double stop = period;
    double crossing = 0.0;
    for (int n = 0; n < 2; n++) {
        const nck_scurve_t all = {joint[n]->a_most, NCK_UNLIMITED, joint[n]->v_max};
        const nck_scurve_t left = {(1.0 - share) * all.a, NCK_UNLIMITED, all.v_max};
        const double half = 0.5 * joint[n]->length;
        const double zone = joint[n]->v_max * period;
        stop += nck_scurve_over(&all, 0.0, half);
        if (half > ZONES_CUT * zone) return 0;
        crossing += nck_scurve_over(&left, v, half);
    }
    return stop < crossing;
}

// Whether the path better stops at a junction. Under a jerk limit: if it is alone, and even what
// little acceleration can be reached next to a standstill is worth more than its speed.
static int is_sharp(const nck_joint_t *in, const nck_joint_t *out, double load,
                    const nck_terms_t *terms) {
    const nck_machine_t *const machine = terms->machine;
    const double a = nck_min(in->a_most, out->a_most);
    if (!terms->limits_jerk) {
        return nck_corner_sharp(load, a) || is_slow_linear(in, out, load, machine);
    }
    const double a_there = nck_min(a, machine->path.j_max * nck_corner_zone_s(terms));
    if (is_alone(in, out, load, terms) && nck_corner_sharp(load, a_there)) return 1;
    return is_slow(in, out, load, terms);
}

void nck_corner_meet(nck_joint_t *in, const nck_joint_t *out, const double *tangent_in,
                    const double *tangent_out, const nck_terms_t *terms) {
    const nck_machine_t *const machine = terms->machine;
    if (out->kind >= NCK_SEG_DWELL) in->end |= NCK_JOINT_STOP;
    if ((in->end & NCK_JOINT_STOP) || in->kind >= NCK_SEG_DWELL) return;
    double load = 0.0;
    for (int x = 0; x < terms->axes; x++) {
        if (tangent_in[x] == tangent_out[x]) continue;
        load = nck_max(load, nck_corner_load(tangent_in[x], tangent_out[x],
                                             machine->axis[x].a_max));
    }
    const double v = nck_min(in->v_free, out->v_free);
    if (!(load > 0.0)) return;
    if (load * v <= SHARE_OF_ROUNDING * machine->period_s) return;
    if (is_sharp(in, out, load, terms)) {
        for (int k = 0; k < NCK_PACES; k++) in->pace[k].v_corner = 0.0;
        if (terms->limits_jerk) in->end |= NCK_JOINT_STOP;
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
    walk->cut = NCK_UNLIMITED;
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
    const double period = self->terms->machine->period_s;
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

// The slope's filter crosses the junction up to v_filter faster than v. A junction that even this
// is too fast for is stopped at.
static void settle(nck_lookahead_t *self, nck_joint_t *joint, int pace, double v, double share) {
    const double most = self->terms->limits_jerk ? NCK_CORNER_SHARE_LONE : NCK_CORNER_SHARE_MAX;
    joint->pace[pace].v_corner = v;
    joint->pace[pace].share = nck_min(most, nck_max(0.0, share));
    if (share > most && v < self->terms->v_filter) joint->end |= NCK_JOINT_STOP;
}

// The largest share of a junction. Under a jerk limit the speed is least where the acceleration is
// small, so that most of it can go to the junction: more of it if the junction is alone.
static double share_most(const nck_lookahead_t *self, const nck_joint_t *in,
                         const nck_joint_t *out) {
    if (!self->terms->limits_jerk) return NCK_CORNER_SHARE_MAX;
    if (!is_alone(in, out, in->load, self->terms)) return NCK_CORNER_SHARE_DENSE;
    return nck_corner_share_lone(nck_max(in->j_straight, out->j_straight),
                                 nck_min(in->a_most, out->a_most), self->zone_s);
}

// Speed and share of a junction that shares a period with others; alone it takes beta at v.
static nck_status_t decide_crowd(nck_lookahead_t *self, uint32_t count, int pace, double beta,
                                 double v) {
    nck_joint_t *const joint = nck_joint_at(self, count);
    const double period = self->terms->machine->period_s;
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
    const double v_true = nck_max(v, self->terms->v_filter);
    settle(self, joint, pace, v,
           nck_corner_share(v_true, d + others_d, others_d, others_dx, a_t, period));
    return NCK_OK;
}

// Speed and share at a pace of a junction with a load that is crossed alone at v.
static nck_status_t decide_pace(nck_lookahead_t *self, uint32_t count, int pace, double beta,
                                double v) {
    nck_joint_t *const joint = nck_joint_at(self, count);
    const double period = self->terms->machine->period_s;
    const double reach = (v + self->a_any * period) * period;
    if (nck_min(joint->length, nck_joint_at(self, count + 1)->length) < reach) {
        return decide_crowd(self, count, pace, beta, v);
    }
    const double v_true = nck_max(v, self->terms->v_filter);
    settle(self, joint, pace, v, nck_corner_share(v_true, joint->load, 0.0, 0.0, 0.0, period));
    return NCK_OK;
}

// A junction between two known segs, at both paces, which mean the same where only the junction
// limits the speed. A stop takes no share.
static nck_status_t decide_corner(nck_lookahead_t *self, uint32_t count) {
    nck_joint_t *const joint = nck_joint_at(self, count);
    const nck_joint_t *const out = nck_joint_at(self, count + 1);
    const double beta = share_most(self, joint, out);
    const double most =
        nck_corner_speed(beta, joint->load, 0.0, 0.0, 0.0, self->terms->machine->period_s);
    double v_before = -1.0;
    for (int k = 0; k < NCK_PACES; k++) {
        const double v = nck_min(most, nck_min(joint->pace[k].v, out->pace[k].v));
        if (v == v_before) {
            joint->pace[k].v_corner = joint->pace[k - 1].v_corner;
            joint->pace[k].share = joint->pace[k - 1].share;
            continue;
        }
        const nck_status_t status = decide_pace(self, count, k, beta, v);
        if (status != NCK_OK) return status;
        v_before = v;
    }
    for (int k = 0; k < NCK_PACES && (joint->end & NCK_JOINT_STOP); k++) {
        joint->pace[k].v_corner = 0.0;
        joint->pace[k].share = 0.0;
    }
    return NCK_OK;
}

nck_status_t nck_corner_decide(nck_lookahead_t *self) {
    const uint32_t count = self->joint.decided;
    if (count == self->joint.head) return NCK_EMPTY;
    nck_joint_t *const joint = nck_joint_at(self, count);
    const int newest = count + 1 == self->joint.head;
    if (newest && !self->ended && joint->kind < NCK_SEG_DWELL) return NCK_EMPTY;
    if (count + !newest >= self->joint.settled) return NCK_EMPTY;
    if (self->joint.known == self->joint.head && !self->ended) return NCK_EMPTY;
    if (newest) joint->end |= NCK_JOINT_STOP;
    if (joint->load > 0.0) {
        const nck_status_t status = decide_corner(self, count);
        if (status == NCK_EMPTY) self->joint.known = self->joint.head;
        if (status != NCK_OK) return status;
    }
    self->joint.decided++;
    return NCK_OK;
}

// The share where the span is shorter than the zone. Under a jerk limit the seg is slowed until it
// is not (near.h); else the worst is assumed.
static double beyond_span(const nck_lookahead_t *self, double share) {
    return self->terms->limits_jerk ? share : NCK_CORNER_SHARE_MAX;
}

double nck_corner_share_before(nck_lookahead_t *self, uint32_t count, int pace) {
    double share = 0.0;
    double time = 0.0;
    for (uint32_t n = 0; n < NCK_CORNER_SPAN; n++) {
        if (count == 0) return share;
        count--;
        const nck_joint_t *const joint = nck_joint_at(self, count);
        if (joint->kind == NCK_SEG_WAIT) return share;
        share = nck_max(share, joint->pace[pace].share);
        time += joint->pace[pace].time;
        if (time >= self->zone_s) return share;
    }
    return beyond_span(self, share);
}

nck_status_t nck_corner_share_after(nck_lookahead_t *self, uint32_t count, int pace,
                                    double *share_out) {
    double share = 0.0;
    double time = 0.0;
    *share_out = NCK_CORNER_SHARE_MAX;
    for (uint32_t n = 0; n < NCK_CORNER_SPAN; n++) {
        if (count == self->joint.decided) {
            self->joint.near = count;
            return NCK_EMPTY;
        }
        const nck_joint_t *const joint = nck_joint_at(self, count);
        share = nck_max(share, joint->pace[pace].share);
        *share_out = share;
        if (joint->kind == NCK_SEG_WAIT) return NCK_OK;
        count++;
        if (count == self->joint.head) return self->ended ? NCK_OK : NCK_EMPTY;
        time += nck_joint_at(self, count)->pace[pace].time;
        if (time >= self->zone_s) return NCK_OK;
    }
    *share_out = beyond_span(self, share);
    return NCK_OK;
}
