// SPDX-License-Identifier: MIT
// Motion whose time is the spindle's angle.
#include "follow.h"

#include <math.h>   // ceil copysign fabs floor fmax fmin INFINITY sqrt
#include <string.h> // memcpy memset

static const double spare = 1.3; // a spindle may turn so much faster than when the pass began

void follow_begin(follow_t *self, const double *place, double lead, double cycle_s) {
    memset(self, 0, sizeof *self);
    self->lead = lead;
    self->cycle_s = cycle_s;
    memcpy(self->point[0], place, sizeof self->point[0]);
}

int follow_line(follow_t *self, const double *end) {
    double sum = 0.0;
    const double *const from = self->point[self->lines];
    if (self->lines == FOLLOW_LINES) return 0;
    for (int k = 0; k < FOLLOW_AXES; k++) sum += (end[k] - from[k]) * (end[k] - from[k]);
    self->end[self->lines + 1] = self->end[self->lines] + sqrt(sum);
    self->lines++;
    memcpy(self->point[self->lines], end, sizeof self->point[0]);
    return 1;
}

// The place at s of the way.
static void place_at(const follow_t *self, double s, double *place_out) {
    uint32_t line = 1;
    while (line < self->lines && s > self->end[line]) line++;
    const double *const from = self->point[line - 1], *const to = self->point[line];
    const double length = self->end[line] - self->end[line - 1];
    const double x = fmin(fmax(s - self->end[line - 1], 0.0), length);
    for (int k = 0; k < FOLLOW_AXES; k++) {
        place_out[k] = length > 0.0 ? from[k] + (to[k] - from[k]) * (x / length) : to[k];
    }
}

// Direction of a line along an axis; 0 outside of the way.
static double direction(const follow_t *self, uint32_t line, int axis) {
    if (line == 0 || line > self->lines) return 0.0;
    const double length = self->end[line] - self->end[line - 1];
    const double way = self->point[line][axis] - self->point[line - 1][axis];
    return length > 0.0 ? way / length : 0.0;
}

// By how much the speed of an axis changes at the end of a line, and at the ends behind it that are
// reached within a length: what the means mix.
static double kink(const follow_t *self, uint32_t line, int axis, double length) {
    double sum = 0.0;
    for (uint32_t k = line; k <= self->lines; k++) {
        if (self->end[k] - self->end[line] > length) break;
        sum += fabs(direction(self, k + 1, axis) - direction(self, k, axis));
    }
    return sum;
}

// A kink of d in the speed of an axis becomes, under two means of τ each, a ramp of 2τ with the
// acceleration d/τ and the jerk d/τ²:   τ ≥ d/a,  τ ≥ √(d/j).   A tap's reversal is made by the
// spindle, which is no kink.
static double mean_time(const follow_t *self, const nck_machine_t *machine, double v, double tau) {
    double longest = 0.0;
    for (uint32_t line = 0; line <= self->lines; line++) {
        for (int k = 0; k < FOLLOW_AXES; k++) {
            const nck_axis_t *const axis = &machine->axis[k];
            const double d = axis->present ? v * kink(self, line, k, 2.0 * v * tau) : 0.0;
            if (d == 0.0) continue;
            longest = fmax(longest, d / axis->a_max);
            if (machine->slope != NCK_SLOPE_LINEAR) longest = fmax(longest, sqrt(d / axis->j_max));
        }
    }
    return longest;
}

// How the speed along the way may change, and how high it may be. Under the two means an
// acceleration a that turns round at once is a jerk of 2a/τ.
static void limit(follow_t *self, const nck_machine_t *machine) {
    const double tau = (double)self->n * self->cycle_s;
    self->v_most = INFINITY;
    self->a_most = INFINITY;
    for (uint32_t line = 1; line <= self->lines; line++) {
        for (int k = 0; k < FOLLOW_AXES; k++) {
            const nck_axis_t *const axis = &machine->axis[k];
            const double share = axis->present ? fabs(direction(self, line, k)) : 0.0;
            if (share == 0.0) continue;
            self->v_most = fmin(self->v_most, axis->v_max / share);
            self->a_most = fmin(self->a_most, axis->a_max / share);
            if (machine->slope == NCK_SLOPE_LINEAR) continue;
            self->a_most = fmin(self->a_most, 0.5 * axis->j_max * tau / share);
        }
    }
}

void follow_prepare(follow_t *self, const nck_machine_t *machine, double rps) {
    const double v = self->lead * fabs(rps) * spare;
    double tau = 0.0;
    for (int more = 0; more < 4; more++) tau = mean_time(self, machine, v, tau);
    const double n = ceil(tau / self->cycle_s) + 1.0;
    self->n = n < (double)FOLLOW_HALF ? (uint32_t)n : FOLLOW_HALF;
    limit(self, machine);
    self->v_back = fmin(v, self->v_most);
    self->phase = FOLLOW_INDEX;
}

// A thread is the same a whole revolution later. So the pass begins at the first whole revolution
// that is not there yet when the first sample is taken, in the next cycle and n ahead.
void follow_index(follow_t *self, double rps) {
    const double ahead = fabs(rps) * (double)(self->n + 1) * self->cycle_s;
    self->begin = 1.0 + floor(ahead);
    self->asked = -self->lead * self->begin;
    self->phase = FOLLOW_CUTS;
    for (uint32_t n = 0; n < self->n; n++) {
        memcpy(self->first[n], self->point[0], sizeof self->first[n]);
        memcpy(self->second[n], self->point[0], sizeof self->second[n]);
    }
}

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
    const double step = self->a_most * self->cycle_s * self->cycle_s;
    const double out = sqrt(self->v_back * self->v_back + 2.0 * self->a_most * fmax(self->s, 0.0));
    const double v = self->phase == FOLLOW_RETURNS ? fmin(out, self->v_most) : self->v_most;
    const double most = v * self->cycle_s;
    const double off = self->asked - self->s;
    const double closing = step * (sqrt(0.25 + 2.0 * fabs(off) / step) - 0.5);
    const double wish = asked - self->asked + copysign(fmin(fabs(off), closing), off);
    const double can = fmin(fmax(wish, self->step - step), self->step + step);
    return self->s + fmin(fmax(can, -most), most);
}

// Both means together come n − 1 cycles late, and the axes get to a place by the end of the cycle:
// that far ahead the angle is asked for.
static void advance(follow_t *self, double turns, double rps) {
    const double length = self->end[self->lines];
    const double ahead = turns + rps * (double)self->n * self->cycle_s;
    const double asked = self->lead * (ahead - self->begin);
    const double before = self->s;
    const int moves = before > 0.0; // its begin is a kink, which the means know
    const double s = moves ? chase(self, asked) : asked;
    if (self->phase == FOLLOW_CUTS) {
        self->s = self->taps ? fmax(s, self->s) : fmin(fmax(s, self->s), length);
        if (self->s >= length) self->phase = self->taps ? FOLLOW_RETURNS : FOLLOW_SETTLES;
    } else if (self->phase == FOLLOW_RETURNS) {
        self->s = s;
        if (s <= 0.0) self->phase = FOLLOW_SETTLES;
    }
    if (self->phase == FOLLOW_SETTLES) {
        self->s = self->taps == 1 ? fmax(self->s, 0.0) : self->s;
        self->settled++;
    }
    self->step = moves ? self->s - before : asked - self->asked;
    self->asked = asked;
    self->reached = fmax(self->reached, self->s);
}

// Beyond the end a tap's way goes straight on: the spindle has to brake first.
static void sample_at(const follow_t *self, double *place_out) {
    const double beyond = self->s - self->end[self->lines];
    place_at(self, self->s, place_out);
    if (!(beyond > 0.0)) return;
    for (int k = 0; k < FOLLOW_AXES; k++) {
        place_out[k] += beyond * direction(self, self->lines, k);
    }
}

int follow_cycle(follow_t *self, double turns, double rps, double *place_out) {
    double sample[FOLLOW_AXES], between[FOLLOW_AXES];
    advance(self, turns, rps);
    sample_at(self, sample);
    mean(self, self->first, sample, between);
    mean(self, self->second, between, place_out);
    self->at = self->at + 1 < self->n ? self->at + 1 : 0;
    if (self->settled < 2 * self->n) return 1;
    self->phase = FOLLOW_NOT;
    return 0;
}

void follow_stop(follow_t *self) {
    if (self->phase == FOLLOW_INDEX) self->phase = FOLLOW_NOT;
    if (self->phase != FOLLOW_NOT) self->phase = FOLLOW_SETTLES;
    self->taps = 0;
}

uint32_t follow_at(const follow_t *self) {
    uint32_t line = 1;
    while (line < self->lines && self->s > self->end[line]) line++;
    return line - 1;
}
