// SPDX-License-Identifier: MIT
// Inside room 4: what neighbouring segs have to do with a seg's speed and limits.
#include "nck/prep/4_lookahead/near.h"

#include "nck/base/budget.h"                  // NCK_BUDGET_… NCK_UNLIMITED
#include "nck/base/scurve_math.h"             // nck_scurve_reach

// A cap comes down only if that frees more than this share of the acceleration left.
#define BENDS_SHARE 0.95

// Where caps may be levelled across: splines that pass into each other without a stop.
static int is_chain(const nck_joint_t *joint) {
    return joint->kind == NCK_SEG_SPLINE && !(joint->end & NCK_JOINT_STOP);
}

// What a joint's cap is levelled with: a neighbour, or a rest.
typedef struct neighbour {
    double w;      // v² there [path mm²/s²]
    double apart;  // between the middle of the joint and that of the neighbour [path mm]
    uint8_t limit; // nck_limit_t of w
} neighbour_t;

static neighbour_t beside(const nck_joint_t *joint, const nck_joint_t *neighbour) {
    const neighbour_t side = {neighbour->w_near, 0.5 * (joint->length + neighbour->length),
                              neighbour->limit_free};
    return side;
}

static neighbour_t at_rest(const nck_joint_t *joint) {
    const neighbour_t side = {0.0, 0.5 * joint->length, NCK_LIMIT_EXACT_STOP};
    return side;
}

// A neighbour that is too short from a rest on to reach its cap.
static neighbour_t gained_before(const nck_joint_t *joint, const nck_joint_t *before) {
    const neighbour_t side = {before->w_out, 0.5 * joint->length, NCK_LIMIT_EXACT_STOP};
    return side;
}

// A rest at the other end of a line: what the line gains before the filter mixes it with the joint.
static neighbour_t beyond_line(const nck_joint_t *joint, const nck_joint_t *line,
                               const nck_terms_t *terms) {
    const double v = nck_sqrt(joint->w_near);
    const double zone = nck_min(line->length, v * terms->mix_s);
    const nck_scurve_t ramp = {line->a_most, terms->limits_jerk ? line->j_straight : NCK_UNLIMITED,
                               line->v_free};
    const double v_line = nck_scurve_reach(&ramp, 0.0, line->length - zone);
    const neighbour_t side = {v_line * v_line, zone + 0.5 * joint->length, NCK_LIMIT_EXACT_STOP};
    return side;
}

// v² next to a neighbour's, with the acceleration that the joint's own bends leave at w:
//   g(w) = w_n + 2σ·a_left(w)·l
static double reach(const nck_joint_t *joint, const neighbour_t *side, double w,
                    const nck_terms_t *terms) {
    const double left = nck_max(0.0, nck_joint_left(joint, w, terms));
    return side->w + 2.0 * NCK_BUDGET_STEEP_SHARE * left * side->apart;
}

// The largest v² that a joint can come down from to its neighbour's: about the root of w = g(w). As
// g falls, the root lies between g(high) and any high that is not below it; a secant makes the gap
// small. It need not be exact: what is allowed at a speed is worked out when the speed is settled.
static double leveled(const nck_joint_t *joint, const neighbour_t *side,
                      const nck_terms_t *terms) {
    const double high = nck_min(joint->w_near, reach(joint, side, side->w, terms));
    const double low = reach(joint, side, high, terms);
    if (!(low < high)) return high;
    const double above = reach(joint, side, low, terms) - low;
    const double below = high - low;
    const double w = low + (high - low) * above / (above + below);
    return nck_min(w, reach(joint, side, w, terms));
}

// A cap much above its neighbour's is of no use, but would cost acceleration and jerk; where the
// joint hardly bends it costs none. Returns 1 if the cap came down.
static int level(nck_joint_t *joint, const neighbour_t *side, const nck_terms_t *terms) {
    if (!(side->w < joint->w_near)) return 0;
    const double w = leveled(joint, side, terms);
    if (!(w < joint->w_near)) return 0;
    const double left = nck_joint_left(joint, joint->w_near, terms);
    if (left >= BENDS_SHARE * nck_joint_left(joint, w, terms)) return 0;
    joint->w_near = w;
    joint->limit_free = side->limit;
    return 1;
}

// Level what lies before a joint whose cap came down, `most` joints before the newest at most. What
// is settled stays.
static void level_before(nck_lookahead_t *self, uint32_t at, uint32_t most) {
    while (at > self->joint.settled && self->joint.head - at <= most) {
        nck_joint_t *const before = nck_joint_at(self, at - 1);
        const neighbour_t side = beside(before, nck_joint_at(self, at));
        if (!is_chain(before) || !level(before, &side, self->terms)) return;
        at--;
    }
}

// A line that ends a chain of splines: where it ends at rest the chain comes down to it.
static int ends_chain(nck_lookahead_t *self, uint32_t at) {
    return at > 0 && nck_joint_at(self, at)->kind == NCK_SEG_LINE
           && is_chain(nck_joint_at(self, at - 1));
}

// Where the first joints are that a later one may level. A chain stays open behind its end until
// it is known whether the line there ends at rest.
static void close_chains(nck_lookahead_t *self, uint32_t at) {
    if (at > 0 && !is_chain(nck_joint_at(self, at - 1))) self->joint.broken = at;
    if (!is_chain(nck_joint_at(self, at)) && !ends_chain(self, at)) self->joint.broken = at + 1;
}

// The path rests behind a joint: it comes down to that, and so does what lies before it.
static void level_to_rest(nck_lookahead_t *self, uint32_t at, uint32_t most) {
    const int by_line = ends_chain(self, at);
    const uint32_t last = by_line ? at - 1 : at;
    nck_joint_t *const joint = nck_joint_at(self, last);
    if (joint->kind != NCK_SEG_SPLINE || last < self->joint.settled) return;
    const neighbour_t side =
        by_line ? beyond_line(joint, nck_joint_at(self, at), self->terms) : at_rest(joint);
    if (level(joint, &side, self->terms)) level_before(self, last, most);
}

// What a spline is levelled with before it: 0 if with nothing.
static int side_before(nck_lookahead_t *self, uint32_t at, neighbour_t *side_out) {
    const nck_joint_t *const joint = nck_joint_at(self, at);
    const nck_joint_t *const before = at > 0 ? nck_joint_at(self, at - 1) : (nck_joint_t *)0;
    if (nck_near_rests(before)) {
        *side_out = at_rest(joint);
        return 1;
    }
    if (is_chain(before)) {
        *side_out = beside(joint, before);
        if (before->w_out < before->w_near) *side_out = gained_before(joint, before);
        return 1;
    }
    if (before->kind != NCK_SEG_LINE) return 0;
    if (at > 1 && !nck_near_rests(nck_joint_at(self, at - 2))) return 0;
    *side_out = beyond_line(joint, before, self->terms);
    return 1;
}

void nck_near_level_newest(nck_lookahead_t *self) {
    const uint32_t at = self->joint.head - 1;
    nck_joint_t *const joint = nck_joint_at(self, at);
    neighbour_t side;
    close_chains(self, at);
    // Whether the joint before stops is known by now.
    if (at > 0 && (nck_joint_at(self, at - 1)->end & NCK_JOINT_STOP)) {
        level_to_rest(self, at - 1, NCK_NEAR_SPAN);
    }
    if (joint->kind == NCK_SEG_SPLINE && side_before(self, at, &side)) {
        (void)level(joint, &side, self->terms);
        if (at > 0 && is_chain(nck_joint_at(self, at - 1))) {
            level_before(self, at, NCK_NEAR_SPAN);
        }
    }
    nck_near_set_out(joint, nck_near_entered_at(self, at));
    if (joint->end & NCK_JOINT_STOP) level_to_rest(self, at, NCK_NEAR_SPAN);
}

// No joint is pushed: what the newest one had left to be settled may be, or not, as time would have
// it. It stays.
void nck_near_end(nck_lookahead_t *self) {
    const uint32_t head = self->joint.head;
    if (!self->ended && head > 0) level_to_rest(self, head - 1, NCK_NEAR_SPAN - 1);
}

// Its caps stay as if the path went on as it is: levelled to a rest at the newest joint's end they
// would be slow for good: 1500 chords, one a period, took 2.93 s in place of 2.05.
void nck_near_hurry(nck_lookahead_t *self) { self->joint.hurried = self->joint.head; }

static void include(nck_near_t *near, const nck_joint_t *joint, double a, int pace) {
    near->a = nck_min(near->a, a);
    near->j = nck_min(near->j, joint->pace[pace].j);
}

void nck_near_before(nck_lookahead_t *self, uint32_t count, int pace, double beta,
                     nck_near_t *near_out) {
    const nck_near_t unlimited = {NCK_UNLIMITED, NCK_UNLIMITED, 1.0};
    double time = 0.0;
    double least = 0.0;
    *near_out = unlimited;
    for (int n = 0; n < NCK_NEAR_SPAN; n++) {
        if (count == 0) return;
        count--;
        const nck_joint_t *const joint = nck_joint_at(self, count);
        if ((joint->end & NCK_JOINT_STOP) || joint->kind >= NCK_SEG_DWELL) return;
        include(near_out, joint, nck_joint_accel(joint, beta, pace, self->terms), pace);
        time += joint->pace[pace].time;
        least += joint->pace[pace].least;
        if (least >= self->terms->mix_s) return;
    }
    near_out->slow = time / self->terms->mix_s;
}

nck_status_t nck_near_after(nck_lookahead_t *self, uint32_t count, int pace, double beta,
                            nck_near_t *near_out) {
    const nck_near_t unlimited = {NCK_UNLIMITED, NCK_UNLIMITED, 1.0};
    double time = 0.0;
    double least = 0.0;
    *near_out = unlimited;
    for (int n = 0; n < NCK_NEAR_SPAN; n++) {
        if (nck_joint_at(self, count)->end & NCK_JOINT_STOP) return NCK_OK;
        count++;
        if (count == self->joint.head && self->ended) return NCK_OK;
        if (count >= self->joint.settled) return NCK_EMPTY;
        const nck_joint_t *const joint = nck_joint_at(self, count);
        if (joint->kind >= NCK_SEG_DWELL) return NCK_OK;
        include(near_out, joint, nck_joint_accel(joint, beta, pace, self->terms), pace);
        time += joint->pace[pace].time;
        least += joint->pace[pace].least;
        if (least >= self->terms->mix_s) return NCK_OK;
    }
    near_out->slow = time / self->terms->mix_s;
    return NCK_OK;
}
