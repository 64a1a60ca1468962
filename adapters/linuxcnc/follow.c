// SPDX-License-Identifier: MIT
// Motion whose time is the spindle's angle.
#include "follow.h"

#include <math.h>   // ceil copysign fabs floor fmax fmin INFINITY sqrt
#include <string.h> // memcpy memset

static const double spare = 1.3; // a spindle may turn so much faster than when the pass began
static const double larger = 1.5; // kinks may be by so much where lines are still to come
static const double least = 0.1;  // of a limit is left for a kink that is rounded, in any case

// ---- the way

static follow_node_t *node(const follow_t *self, uint32_t number) {
    return (follow_node_t *)&self->node[number % FOLLOW_LINES];
}

// By how much an axis moves a revolution, on the line that ends at a node; 0 outside of the way.
static double gradient(const follow_t *self, uint32_t number, int axis) {
    if (number == 0 || number > self->head) return 0.0;
    const follow_node_t *const from = node(self, number - 1), *const to = node(self, number);
    return (to->place[axis] - from->place[axis]) / (to->u - from->u);
}

// By how much the speed of an axis changes at a node, at most [mm/s].
static double kink(const follow_t *self, uint32_t number, int axis) {
    const double before = gradient(self, number, axis);
    return fabs(gradient(self, number + 1, axis) - before) * self->rps;
}

// The node at the end of the line that u is on.
static uint32_t line_at(const follow_t *self, double u) {
    uint32_t number = self->tail + 1;
    while (number < self->head && u > node(self, number)->u) number++;
    return number;
}

// What a node's rounding adds to the way: the mean of the kink over 2w, less the kink.
static void round_off(const follow_t *self, uint32_t number, double u, double *place) {
    const follow_node_t *const at = node(self, number);
    const double inside = at->w - fabs(u - at->u);
    if (!(inside > 0.0)) return;
    for (int k = 0; k < FOLLOW_AXES; k++) {
        const double turns = gradient(self, number + 1, k) - gradient(self, number, k);
        place[k] += turns * inside * inside / (4.0 * at->w);
    }
}

// The place at u of the way. Beyond its end a tap's goes straight on: the spindle has to brake.
static void place_at(const follow_t *self, double u, double *place_out) {
    const uint32_t number = line_at(self, u);
    const follow_node_t *const from = node(self, number - 1), *const to = node(self, number);
    const double x = fmax(u - from->u, 0.0), length = to->u - from->u;
    const double share = (self->taps ? x : fmin(x, length)) / length;
    for (int k = 0; k < FOLLOW_AXES; k++) {
        place_out[k] = from->place[k] + (to->place[k] - from->place[k]) * share;
    }
    round_off(self, number - 1, u, place_out);
    round_off(self, number, u, place_out);
}

// ---- how smooth it has to be

// The oldest node whose kink is known.
static uint32_t oldest(const follow_t *self) { return self->tail > 0 ? self->tail + 1 : 0; }

// The kinks from a node on that are reached within a length, of one axis: what the means mix.
static double kinks(const follow_t *self, uint32_t number, int axis, double length) {
    const double begin = node(self, number)->u;
    double sum = 0.0;
    for (; number <= self->head && node(self, number)->u - begin <= length; number++) {
        sum += kink(self, number, axis);
    }
    return sum;
}

// A kink of d in the speed of an axis becomes, under two means of τ each, a ramp of 2τ with the
// acceleration d/τ and the jerk d/τ²:   τ ≥ d/a,  τ ≥ √(d/j).   A tap's reversal is made by the
// spindle, which is no kink.
static double mean_time(const follow_t *self, double tau) {
    double longest = 0.0;
    for (uint32_t number = oldest(self); number <= self->head; number++) {
        for (int k = 0; k < FOLLOW_AXES; k++) {
            if (!(self->limits.v[k] > 0.0)) continue;
            const double d =
                kinks(self, number, k, 2.0 * self->rps * tau) * (self->open ? larger : 1.0);
            longest = fmax(longest, d / (self->limits.a[k] * self->share));
            longest = fmax(longest, sqrt(d / self->limits.j[k]));
        }
    }
    return longest;
}

// Cycles of each mean for the lines that are known.
static uint32_t cycles(const follow_t *self) {
    double tau = 0.0;
    for (int again = 0; again < 4; again++) tau = mean_time(self, tau);
    const double n = ceil(tau / self->cycle_s) + 1.0;
    return n < (double)FOLLOW_HALF ? (uint32_t)n : FOLLOW_HALF;
}

// What the other kinks of an axis take, that the means mix with a node's, rounded by w [mm/s].
static double others(const follow_t *self, uint32_t number, int axis, double w) {
    const double tau = (double)self->n * self->cycle_s, mixed = 2.0 * self->rps * tau;
    double sum = 0.0;
    for (uint32_t n = oldest(self); n <= self->head; n++) {
        const follow_node_t *const at = node(self, n);
        const double off = fabs(at->u - node(self, number)->u);
        if (n == number || off > mixed + w + at->w) continue;
        sum += kink(self, n, axis) * fmin(1.0, 0.25 * mixed / fmax(at->w, 1e-12));
    }
    return sum;
}

// How far to both sides a node is rounded, so that its kink is within what the others near it
// leave: a mean over the time W more makes it d/W and d/Wτ. They leave a tenth at least.
static double width_beside(const follow_t *self, uint32_t number, double w) {
    const double tau = (double)self->n * self->cycle_s;
    double most = 0.0;
    for (int k = 0; k < FOLLOW_AXES; k++) {
        if (!(self->limits.v[k] > 0.0)) continue;
        const double d = kink(self, number, k), sum = others(self, number, k, w);
        const double a = self->limits.a[k] * self->share, j = self->limits.j[k];
        const double left_a = a - sum / tau, left_j = j - sum / (tau * tau);
        if (d <= left_a * tau && d <= left_j * tau * tau) continue;
        most = fmax(most, fmax(d / fmax(left_a, least * a), d / (fmax(left_j, least * j) * tau)));
    }
    return 0.5 * most * self->rps;
}

// What is rounded further has others near it that are further away. −1: and so on.
static double width(const follow_t *self, uint32_t number) {
    double w = 0.0, before = -1.0;
    for (int again = 0; again < 4 && w > before; again++) {
        before = w;
        w = width_beside(self, number, w);
    }
    return w > before ? -1.0 : w;
}

// How fast the spindle may turn on the line to a node, and by how much its speed may change. Under
// the two means an acceleration a that turns round at once is a jerk of 2a/τ.
static void limit(const follow_t *self, uint32_t number) {
    follow_node_t *const to = node(self, number);
    const double tau = (double)self->n * self->cycle_s;
    to->v_most = to->a_most = to->v_stop = INFINITY;
    for (int k = 0; k < FOLLOW_AXES; k++) {
        const double share = fabs(gradient(self, number, k));
        if (share == 0.0 || !(self->limits.v[k] > 0.0)) continue;
        const double a = self->limits.a[k] * self->share, by_jerk = self->limits.j[k] * tau;
        to->v_most = fmin(to->v_most, self->limits.v[k] / share);
        to->a_most = fmin(to->a_most, fmin(a, 0.5 * by_jerk) / share);
        to->v_stop = fmin(to->v_stop, fmin(a, by_jerk) * tau / share);
    }
}

static void still(follow_t *self) {
    for (uint32_t n = 0; n < self->n; n++) {
        memcpy(self->first[n], node(self, 0)->place, sizeof self->first[n]);
        memcpy(self->second[n], node(self, 0)->place, sizeof self->second[n]);
    }
    self->at = 0;
}

// Before it moves the means may become longer, if the angle is still as far away.
static int prepare(follow_t *self) {
    const uint32_t n = cycles(self);
    const int cuts = self->phase == FOLLOW_CUTS;
    const double more = n > self->n ? self->step * (double)(n - self->n) : 0.0;
    if (cuts && self->asked + more >= 0.0) return 0;
    if (n > self->n || !cuts) self->n = n;
    if (cuts) {
        self->asked += more;
        still(self);
    }
    for (uint32_t number = self->tail + 1; number <= self->head; number++) limit(self, number);
    return 1;
}

// Behind the begin the last two kinks are rounded where n is too small for them. 0: there is no
// room for it, or the tool is there already.
static int fit(follow_t *self) {
    follow_node_t *const from = node(self, self->head - 1), *const to = node(self, self->head);
    const follow_node_t *const before = node(self, self->head - 2);
    const double kept = from->w, room = from->u - before->u - before->w;
    from->w = 0.0;
    const int there = self->u >= from->u; // it rests there already, or nearly: the chase goes on
    const double w = there ? 0.0 : width(self, self->head - 1);
    from->w = w;
    to->w = width(self, self->head);
    limit(self, self->head);
    const int late = self->u > from->u - fmax(kept, w) && (!there || kept > 0.0) && w != kept;
    if (w >= 0.0 && to->w >= 0.0 && w <= room && w + to->w <= to->u - from->u && !late) return 1;
    from->w = kept;
    return 0;
}

// ---- lines

void follow_begin(follow_t *self, const double *place, double rps, double cycle_s) {
    const follow_limits_t limits = self->limits;
    memset(self, 0, sizeof *self);
    self->limits = limits;
    self->rps = fabs(rps) * spare;
    self->cycle_s = cycle_s;
    self->share = 1.0;
    self->phase = FOLLOW_INDEX;
    memcpy(node(self, 0)->place, place, sizeof node(self, 0)->place);
}

int follow_has_room(const follow_t *self) { return self->head - self->tail < FOLLOW_LINES - 1; }

// Of what the means bear, what a stop at a node takes, with the kinks near it.
static double used(const follow_t *self, uint32_t number) {
    const double tau = (double)self->n * self->cycle_s;
    double most = 0.0;
    for (int k = 0; k < FOLLOW_AXES; k++) {
        if (!(self->limits.v[k] > 0.0)) continue;
        const double d = fabs(gradient(self, number, k)) * self->rps + others(self, number, k, 0.0);
        const double bears = fmin(self->limits.a[k] * self->share, self->limits.j[k] * tau) * tau;
        most = fmax(most, d / bears);
    }
    return most;
}

// A line that comes while the tool comes to rest: it goes on, and catches up. Until the means have
// left the stop behind, its ramp has what that leaves of the jerk.
static void go_on(follow_t *self) {
    self->phase = FOLLOW_CUTS;
    self->stopped = used(self, self->head - 1);
    self->eased = 2 * self->n - self->settled;
    self->settled = 0;
}

int follow_line(follow_t *self, const double *end, double lead, double share, uint32_t move) {
    double sum = 0.0;
    const double kept = self->share;
    const follow_node_t *const from = node(self, self->head);
    follow_node_t *const to = node(self, self->head + 1);
    if (!follow_has_room(self)) return 0;
    for (int k = 0; k < FOLLOW_AXES; k++) {
        sum += (end[k] - from->place[k]) * (end[k] - from->place[k]);
    }
    memset(to, 0, sizeof *to);
    to->move = move;
    to->lead = lead;
    to->u = from->u + sqrt(sum) / lead;
    memcpy(to->place, end, sizeof to->place);
    self->head++;
    self->share = fmin(self->share, share);
    const int moves = self->phase != FOLLOW_INDEX && self->asked >= 0.0;
    if ((!moves && prepare(self)) || (self->phase != FOLLOW_INDEX && fit(self))) {
        if (self->phase == FOLLOW_SETTLES) go_on(self);
        return 1;
    }
    self->head--;
    self->share = kept;
    return 0;
}

void follow_index(follow_t *self, double rps) {
    self->rps = fmax(self->rps, fabs(rps) * spare);
    (void)prepare(self);
    self->v_back = fmin(self->rps, node(self, self->head)->v_most);
    self->asked = -1.0;
    self->phase = FOLLOW_CUTS;
    still(self);
}

// ---- a cycle

// The mean of a ring's samples, summed anew: a running sum would drift.
static void mean(const follow_t *self, double (*ring)[FOLLOW_AXES], const double *sample,
                 double *mean_out) {
    memcpy(ring[self->at], sample, sizeof ring[0]);
    for (int k = 0; k < FOLLOW_AXES; k++) {
        double sum = 0.0;
        for (uint32_t n = 0; n < self->n; n++) sum += ring[n][k] - sample[k];
        mean_out[k] = sample[k] + sum / (double)self->n;
    }
}

// A spindle may change its speed, and turn back, faster than the axes can follow: then the way is
// what they can do until it is in step again. Whoever is off by x, and closes in by √(2ax), gets
// there with the speed of what he follows; here in steps of one cycle. A tap comes out no faster
// than the means can stop.
static double chase(const follow_t *self, double asked) {
    double v = INFINITY, a = INFINITY;
    for (uint32_t number = self->tail + 1; number <= self->head; number++) {
        v = fmin(v, node(self, number)->v_most);
        a = fmin(a, node(self, number)->a_most);
    }
    if (self->eased > 0) a *= fmin(1.0, 2.0 * fmax(1.0 - self->stopped, 0.5 * least));
    const double step = a * self->cycle_s * self->cycle_s;
    const double out = sqrt(self->v_back * self->v_back + 2.0 * a * fmax(self->u, 0.0));
    const double most = (self->phase == FOLLOW_RETURNS ? fmin(out, v) : v) * self->cycle_s;
    const double off = self->asked - self->u;
    const double closing = step * (sqrt(0.25 + 2.0 * fabs(off) / step) - 0.5);
    const double wish = asked - self->asked + copysign(fmin(fabs(off), closing), off);
    const double can = fmin(fmax(wish, self->step - step), self->step + step);
    return self->u + fmin(fmax(can, -most), most);
}

// An abort stops at once where the means make a ramp within the limits of it; else it brakes.
static double brake(const follow_t *self) {
    const follow_node_t *const to = node(self, line_at(self, self->u));
    const double v = fabs(self->step) / self->cycle_s;
    if (v <= to->v_stop || self->u <= 0.0) return self->u;
    const double step = fmax(v - to->a_most * self->cycle_s, 0.0) * self->cycle_s;
    return fmax(self->u + copysign(step, self->step), 0.0);
}

// Where the sample is, if the way, or the chase, is at u.
static void go(follow_t *self, double u) {
    const follow_node_t *const end = node(self, self->head);
    const double length = end->u + end->w;
    if (self->phase == FOLLOW_CUTS) {
        self->u = self->taps ? fmax(u, self->u) : fmin(fmax(u, self->u), length);
        if (self->u >= length) self->phase = self->taps ? FOLLOW_RETURNS : FOLLOW_SETTLES;
    } else if (self->phase == FOLLOW_RETURNS) {
        self->u = u;
        if (u <= 0.0) self->phase = FOLLOW_SETTLES;
    }
    if (self->phase != FOLLOW_SETTLES) return;
    const double before = self->u;
    if (self->taps) self->u = fmax(self->u, 0.0);
    if (self->stops) self->u = fmin(brake(self), fmax(before, length));
    self->settled += !self->stops || self->u == before;
}

// Both means together come n − 1 cycles late, and the axes get to a place by the end of the cycle:
// that far ahead the angle is asked for. A thread is the same a whole revolution later: the pass
// begins at the first one that is not there yet.
static void advance(follow_t *self, double turns, double rps) {
    const double ahead = turns + rps * (double)self->n * self->cycle_s;
    if (self->begin == 0.0) {
        self->begin = 1.0 + floor(ahead);
        self->asked = ahead - rps * self->cycle_s - self->begin;
    }
    const double asked = ahead - self->begin;
    const double before = self->u;
    if (self->eased > 0) self->eased--;
    const int moves = before > 0.0; // its begin is a kink, which the means know
    go(self, moves ? chase(self, asked) : asked);
    self->step = moves ? self->u - before : asked - self->asked;
    self->asked = asked;
}

// A line that the tool has left is behind it, but for the last one; one a cycle.
static void forget(follow_t *self) {
    const follow_node_t *const next = node(self, self->tail + 2);
    if (self->tail + 2 < self->head && self->u > next->u + next->w) self->tail++;
}

int follow_cycle(follow_t *self, double turns, double rps, double *place_out) {
    double sample[FOLLOW_AXES], between[FOLLOW_AXES];
    advance(self, turns, rps);
    place_at(self, self->u, sample);
    mean(self, self->first, sample, between);
    mean(self, self->second, between, place_out);
    self->at = self->at + 1 < self->n ? self->at + 1 : 0;
    if (!self->taps) forget(self);
    if (self->settled < 2 * self->n) return 1;
    self->phase = FOLLOW_NOT;
    return 0;
}

void follow_stop(follow_t *self) {
    if (self->phase == FOLLOW_INDEX) self->phase = FOLLOW_NOT;
    if (self->phase != FOLLOW_NOT) self->phase = FOLLOW_SETTLES;
    self->stops = 1;
    self->taps = 0;
}

uint32_t follow_move(const follow_t *self, double *to_go_out) {
    const uint32_t number = line_at(self, self->u);
    const follow_node_t *const to = node(self, number);
    *to_go_out = fmax(to->u - fmax(self->u, 0.0), 0.0) * to->lead;
    return to->move;
}
