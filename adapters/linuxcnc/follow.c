// SPDX-License-Identifier: MIT
// Motion whose time is the spindle's angle.
#include "follow.h"

#include <math.h>   // ceil copysign fabs floor fmax fmin INFINITY sqrt
#include <string.h> // memcpy memset

static const double spare = 1.3; // a spindle may turn so much faster than when the pass began
static const double larger = 1.5; // kinks may be by so much where lines are still to come
static const double least = 0.1;  // of what the axes bear is left for a chase, in any case
static const double wider = 1.1;  // at most, what a kink is rounded further by than it has to be

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

// By how much the speed of an axis changes at a node, with its sign, at most [mm/s].
static double kink(const follow_t *self, uint32_t number, int axis) {
    const double before = gradient(self, number, axis);
    return (gradient(self, number + 1, axis) - before) * self->rps;
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

// A speed on its way through kinks, from the last one back: what two means of it can be.
typedef struct follow_mix {
    double v;            // before the kinks so far, less that behind them all [mm/s]
    double high;         // the most of it …
    double low;          // … and the least
    double peak;         // the most of a speed less twice one before it …
    double dip;          // … and the least
    double acceleration; // the largest difference of two: times 1/τ
    double jerk;         // the largest second difference of three: times 1/τ²
} follow_mix_t;

// One more kink: the speeds before it differ by d from those behind it.
static void mix_kink(follow_mix_t *self, double d) {
    self->v -= d;
    self->high = fmax(self->high, self->v);
    self->low = fmin(self->low, self->v);
    self->peak = fmax(self->peak, self->high - 2.0 * self->v);
    self->dip = fmin(self->dip, self->low - 2.0 * self->v);
    self->acceleration = fmax(self->high - self->low, self->acceleration);
    self->jerk = fmax(fmax(self->v + self->peak, -self->v - self->dip), self->jerk);
}

// What the means mix of an axis until the kink of a node, where one mean is `mean` revolutions
// long. With the speed V under two means of τ each
//
//   acceleration = mean of (V(t) − V(t − τ)) / τ,   jerk = (V(t) − 2V(t − τ) + V(t − 2τ)) / τ²:
//
// kinks that follow each other up and down within 2τ make no more than 2(max V − min V) / τ². Of
// one that is rounded by w, no more than mean/2w is within τ. A slower spindle has less of all.
static follow_mix_t mixed(const follow_t *self, uint32_t last, int axis, double mean) {
    const follow_node_t *const end = node(self, last);
    follow_mix_t mix = {0};
    for (uint32_t n = last + 1; n-- > oldest(self);) {
        const follow_node_t *const at = node(self, n);
        if (end->u - at->u > 2.0 * mean + end->w + at->w) break;
        const double within = at->w > 0.5 * mean ? 0.5 * mean / at->w : 1.0;
        mix_kink(&mix, kink(self, n, axis) * within);
    }
    return mix;
}

// A kink of d in the speed of an axis becomes, under two means of τ each, a ramp of 2τ with the
// acceleration d/τ and the jerk d/τ²:   τ ≥ d/a,  τ ≥ √(d/j).   A tap's reversal is made by the
// spindle, which is no kink.
static double mean_time(const follow_t *self, double tau) {
    const double more = self->open ? larger : 1.0;
    double longest = 0.0;
    for (uint32_t number = oldest(self); number <= self->head; number++) {
        for (int k = 0; k < FOLLOW_AXES; k++) {
            if (!(self->limits.v[k] > 0.0)) continue;
            if (kink(self, number, k) == 0.0) continue; // those before have mixed all that it has
            const follow_mix_t mix = mixed(self, number, k, self->rps * tau);
            const double a = self->limits.a[k] * self->share;
            longest = fmax(longest, more * mix.acceleration / a);
            longest = fmax(longest, sqrt(more * mix.jerk / self->limits.j[k]));
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

// Of what the axes bear, what the kink of a node takes with those before it.
static double used(const follow_t *self, uint32_t number) {
    const double tau = (double)self->n * self->cycle_s;
    double most = 0.0;
    for (int k = 0; k < FOLLOW_AXES; k++) {
        if (!(self->limits.v[k] > 0.0)) continue;
        const follow_mix_t mix = mixed(self, number, k, self->rps * tau);
        most = fmax(most, mix.acceleration / (self->limits.a[k] * self->share * tau));
        most = fmax(most, mix.jerk / (self->limits.j[k] * tau * tau));
    }
    return most;
}

// How far to both sides a node is rounded, within its room, so that the axes bear its kink with
// those before it. Less than half of a mean makes it no smoother. 0: no width is enough.
static int round_node(follow_t *self, uint32_t number, double room) {
    follow_node_t *const at = node(self, number);
    const double least_w = 0.5 * self->rps * (double)self->n * self->cycle_s;
    at->w = 0.0;
    for (;;) {
        at->used = used(self, number);
        if (at->used <= 1.0) return 1;
        if (!(at->w < room)) return 0;
        at->w = fmin(fmax(at->w, least_w) * wider, room);
    }
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
    for (uint32_t number = self->tail + 1; number <= self->head; number++) {
        node(self, number)->used = used(self, number);
        limit(self, number);
    }
    node(self, 0)->used = used(self, 0);
    return 1;
}

// Behind the begin the last two kinks are rounded where n is too small for them. 0: there is no
// room for it, or the tool is there already.
static int fit(follow_t *self) {
    follow_node_t *const from = node(self, self->head - 1), *const to = node(self, self->head);
    const follow_node_t *const before = node(self, self->head - 2);
    const double kept = from->w, room = from->u - before->u - before->w;
    const int there = self->u >= from->u; // it rests there already, or nearly: the chase goes on
    from->w = 0.0;
    const int fits = (there || round_node(self, self->head - 1, room))
                     && round_node(self, self->head, to->u - from->u - from->w);
    const int late = self->u > from->u - fmax(kept, from->w) && (!there || kept > 0.0)
                     && from->w != kept;
    limit(self, self->head);
    if (fits && !late) return 1;
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

// A line that comes while the tool comes to rest: it goes on, and catches up. Until the means have
// left the stop behind, its ramp has what that leaves of the jerk.
static void go_on(follow_t *self, double stopped) {
    self->phase = FOLLOW_CUTS;
    self->stopped = stopped;
    self->eased = 2 * self->n - self->settled;
    self->settled = 0;
}

int follow_line(follow_t *self, const double *end, double lead, double share, uint32_t move) {
    double sum = 0.0;
    const double kept = self->share;
    const follow_node_t *const from = node(self, self->head);
    follow_node_t *const to = node(self, self->head + 1);
    if (!follow_has_room(self)) return 0;
    const double stopped = self->phase == FOLLOW_SETTLES ? used(self, self->head) : 0.0;
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
    if (self->phase == FOLLOW_INDEX) return 1; // there all are prepared at once
    if ((!(self->asked >= 0.0) && prepare(self)) || fit(self)) {
        if (self->phase == FOLLOW_SETTLES) go_on(self, stopped);
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

// Of what the axes bear, what kinks take that the means mix with the way of now, or soon will: what
// is left is for a chase. Kinks are passed no faster than leaves a little (to_kinks).
static double strain(const follow_t *self, int ahead) {
    const double means = 2.0 * self->rps * (double)self->n * self->cycle_s;
    double most = 0.0;
    for (uint32_t n = oldest(self); n <= self->head; n++) {
        const follow_node_t *const at = node(self, n);
        const double off = self->u - at->u;
        const int mixes = off <= means + at->w && -off <= (ahead ? means : 0.0) + at->w;
        if (mixes) most = fmax(most, at->used);
    }
    return fmin(most, 1.0 - least);
}

// How fast the way may be gone, so that with an acceleration a the kinks ahead are come to no
// faster than they were rounded for [revolutions/s].
static double to_kinks(const follow_t *self, double a) {
    double v = INFINITY;
    for (uint32_t n = oldest(self); n <= self->head; n++) {
        const follow_node_t *const at = node(self, n);
        if (at->u + at->w < self->u) continue;
        const double there = self->rps * fmin(1.0, (1.0 - least) / fmax(at->used, least));
        const double way = fmax(at->u - at->w - self->u, 0.0);
        v = fmin(v, sqrt(there * there + 2.0 * a * way));
    }
    return v;
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
    if (!self->taps) a *= 1.0 - strain(self, 1);
    const double bent = self->taps ? INFINITY : to_kinks(self, a) * self->cycle_s;
    const double step = a * self->cycle_s * self->cycle_s;
    const double out = sqrt(self->v_back * self->v_back + 2.0 * a * fmax(self->u, 0.0));
    const double most = (self->phase == FOLLOW_RETURNS ? fmin(out, v) : v) * self->cycle_s;
    const double off = self->asked - self->u;
    const double closing = step * (sqrt(0.25 + 2.0 * fabs(off) / step) - 0.5);
    const double wish = asked - self->asked + copysign(fmin(fabs(off), closing), off);
    const double can = fmin(fmax(fmin(wish, bent), self->step - step), self->step + step);
    return self->u + fmin(fmax(can, -most), most);
}

// An abort stops at once where the means make a ramp within the limits of it, as soon as kinks
// behind have left them that much of the jerk; else it brakes.
static double brake(const follow_t *self) {
    const follow_node_t *const to = node(self, line_at(self, self->u));
    const double v = fabs(self->step) / self->cycle_s;
    if (self->u <= 0.0 || v <= to->v_stop * (1.0 - strain(self, 0))) return self->u;
    if (v <= to->v_stop) return fmax(self->u + self->step, 0.0);
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

// A line that the tool has left is behind it, but for the last one, as soon as its end has left the
// means, too; one a cycle.
static void forget(follow_t *self) {
    const follow_node_t *const next = node(self, self->tail + 2);
    const double means = 2.0 * self->rps * (double)self->n * self->cycle_s;
    if (self->tail + 2 < self->head && self->u > next->u + next->w + means) self->tail++;
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

const double *follow_end(const follow_t *self) {
    return node(self, self->taps ? 0 : self->head)->place;
}

uint32_t follow_price(const follow_t *self) {
    return 40 + 11 * self->n / 10 + 3 * (self->head - self->tail);
}
