// SPDX-License-Identifier: MIT
// Hull – forward and backward – hull, in bounded steps.
//
//   reach back, reach forth   how fast at all, by acceleration alone
//   ramp forth, ramp back     where the acceleration limit changes along the path, it is approached
//                             within the jerk; U, the two-pass envelope under these bounds
//   hull, hull                E: the largest function under U whose slope falls slowly enough
//   rise, fall                forward and backward under E, the acceleration grows slowly enough
//   hull                      takes off the edge where the two meet
#include "nck/prep/5_slope/profile.h"

#include "nck/prep/5_slope/hull_math.h" // nck_hull_…

enum {
    REACH_BACK = 0, REACH_FORTH, RAMP_BACK, RAMP_FORTH, HULL_U, LEVEL_U, HULL_E, LEVEL_E, RISE,
    FALL, HULL_W, LEVEL_W, PLANNED
};

// The entry speed is met if w agrees so far; a change of acceleration within rule R if it exceeds
// it by no more than this share of a_max (rounding in w over short cells).
#define SPEED_EPSILON 1e-9
#define JOIN_EPSILON 1e-6
// A plan that can but slow down at first is none if that takes it below a tenth of what a cell
// reaches from rest, v³ = J·h²: it would creep on from there.
#define SLOWEST 1e-3
// A speed is at the envelope within this share of it: it was added to another one and taken off.
#define CAP_EPSILON 1e-14

static double jerk_at(const nck_profile_t *self, uint32_t i) {
    if (i == 0) return self->j_max[0];
    if (i >= self->n) return self->j_max[self->n - 1];
    return nck_min(self->j_max[i - 1], self->j_max[i]);
}

static int is_backward(uint32_t phase) {
    return phase == REACH_BACK || phase == RAMP_BACK || phase == FALL;
}

static int is_level(uint32_t phase) {
    return phase == LEVEL_U || phase == LEVEL_E || phase == LEVEL_W;
}

static void begin_pass(nck_profile_t *self, uint32_t phase) {
    self->phase = phase;
    self->i = is_backward(phase) ? self->n : 0;
    self->v_last = 0.0;
    self->a_last = 0.0;
    self->share = 0.0;
    self->sigma = 0.0;
    self->fall = 0.0;
    self->slows = 0;
    if (!is_level(phase)) self->top = 0;
}

void nck_profile_begin(nck_profile_t *self) {
    self->w_cap[self->n] = 0.0;
    self->fresh = 1;
    self->broken = 0;
    begin_pass(self, REACH_BACK);
}

static void reach_back(nck_profile_t *self) {
    const uint32_t i = self->i;
    const double *const w = self->w;
    const double reach =
        i < self->n ? w[i + 1] + 2.0 * self->a_max[i] * self->h[i] : self->w_cap[i];
    self->w[i] = nck_min(self->w_cap[i], reach);
}

// Also: the bound on deceleration falls into a stretch of less no faster than the jerk lets it.
static void reach_forth(nck_profile_t *self) {
    const uint32_t i = self->i;
    double *const w = self->w;
    if (i == 0) {
        w[0] = nck_min(w[0], self->v * self->v);
        self->s[0] = 0.0;
        self->v_last = nck_sqrt(w[0]);
        return;
    }
    const uint32_t cell = i - 1;
    w[i] = nck_min(w[i], w[cell] + 2.0 * self->a_max[cell] * self->h[cell]);
    self->s[i] = self->s[cell] + self->h[cell];
    const double v = nck_sqrt(w[i]);
    const double share = nck_hull_share(self->h[cell], self->v_last + v, self->q_cap);
    double bound = self->a_max[cell];
    if (cell > 0) {
        const double step = jerk_at(self, cell) * (self->share + share);
        bound = nck_min(bound, self->down[cell - 1] + step);
    }
    self->down[cell] = bound;
    self->z[cell] = share;
    self->share = share;
    self->v_last = v;
}

static void ramp_back(nck_profile_t *self) {
    const uint32_t i = self->i;
    if (i == self->n) {
        self->w[i] = 0.0;
        return;
    }
    double bound = self->a_max[i];
    if (i + 1 < self->n) {
        const double growth = jerk_at(self, i + 1) * (self->z[i] + self->z[i + 1]);
        bound = nck_min(bound, self->up[i + 1] + growth);
    }
    self->up[i] = bound;
    self->w[i] = nck_min(self->w_cap[i], self->w[i + 1] + 2.0 * self->down[i] * self->h[i]);
}

static void ramp_forth(nck_profile_t *self) {
    const uint32_t i = self->i;
    double *const w = self->w;
    if (i == 0) {
        w[0] = nck_min(w[0], self->v * self->v);
    } else {
        w[i] = nck_min(w[i], w[i - 1] + 2.0 * self->up[i - 1] * self->h[i - 1]);
    }
}

// How much the slope may have fallen up to node i, summed over length: C of the README. Called for
// i = 0 … n in order, with the speeds' squares that the durations come from.
static double fall_at(nck_profile_t *self, const double *w_of_time) {
    const uint32_t i = self->i;
    const double v = nck_sqrt(w_of_time[i]);
    if (i > 0) {
        const double h = self->h[i - 1];
        const double share = nck_hull_share(h, self->v_last + v, self->q_cap);
        if (i > 1) self->sigma += 2.0 * jerk_at(self, i - 1) * (self->share + share);
        self->fall += self->sigma * h;
        self->share = share;
    }
    self->v_last = v;
    return self->fall;
}

// Corners of the lower hull of (s, g + C). Returns 1 when node i is on the stack, 0 after taking
// one corner off.
static int hull(nck_profile_t *self, const double *g, const double *w_of_time, int fresh) {
    const uint32_t i = self->i;
    const double *const s = self->s;
    double *const z = self->z;
    if (fresh) z[i] = g[i] + fall_at(self, w_of_time);
    if (self->top >= 2) {
        const uint32_t b = self->stack[self->top - 1];
        const uint32_t a = self->stack[self->top - 2];
        if (nck_hull_above(s[a], z[a], s[b], z[b], s[i], z[i]) >= 0.0) {
            self->top--;
            return 0;
        }
    }
    self->stack[self->top] = i;
    self->top++;
    return 1;
}

// Every node down onto the hull. On a corner the value stays to the bit.
static void level(nck_profile_t *self, const double *g, double *out) {
    const uint32_t i = self->i;
    const double value = g[i];
    const double fall = self->z[i] - value;
    if (i == 0) self->top = 0;
    if (self->stack[self->top] == i) {
        self->top++;
        out[i] = value;
        return;
    }
    const uint32_t a = self->stack[self->top - 1];
    const uint32_t b = self->stack[self->top];
    const double *const s = self->s;
    const double *const z = self->z;
    const double on_hull = z[a] + (z[b] - z[a]) * ((s[i] - s[a]) / (s[b] - s[a]));
    out[i] = nck_max(0.0, nck_min(value, on_hull - fall));
}

// One cell onward under the envelope e from speed v; the state of the cell before in a_last, share.
static double rise(nck_profile_t *self, double v, uint32_t cell, double j, double a_max,
                   double e_end) {
    const double h = self->h[cell];
    const double b = self->a_last + j * self->share;
    const double v_cap = nck_sqrt(e_end);
    const nck_hull_cell_t step = {h, a_max, j, self->q_cap};
    double v1 = nck_hull_rise(&step, v, b, v_cap);
    if (v1 < 0.0) {
        self->broken = 1;
        v1 = 0.0;
    }
    const int capped = v1 >= v_cap * (1.0 - CAP_EPSILON);
    const double vv1 = capped ? e_end : v1 * v1;
    if (capped) v1 = v_cap;
    self->a_last = (vv1 - v * v) / (2.0 * h);
    self->slows = self->slows && !capped && self->a_last < 0.0;
    const double a_least = -(1.0 + JOIN_EPSILON) * self->a_max[cell];
    const int creeps = v1 * v1 * v1 < SLOWEST * j * h * h;
    if (self->slows && (creeps || self->a_last < a_least)) self->broken = 1;
    self->share = nck_hull_share(h, v + v1, self->q_cap);
    if (!(vv1 > 0.0)) {
        self->a_last = 0.0;
        self->share = 0.0;
    } else if (capped && self->a_last + j * self->share < 0.0) {
        self->a_last = 0.0; // on a falling envelope the next cell may be level
        self->share = 0.0;
    }
    self->v_last = v1;
    return vv1;
}

static void rise_one(nck_profile_t *self) {
    const uint32_t i = self->i;
    if (i == 0) {
        self->w[0] = nck_min(self->e[0], self->v * self->v);
        self->v_last = nck_sqrt(self->w[0]);
        self->a_last = self->a;
        self->share = 0.5 * nck_min(self->q, self->q_cap);
        self->slows = self->a < 0.0;
        return;
    }
    const double j = jerk_at(self, i - 1);
    self->w[i] = rise(self, self->v_last, i - 1, j, self->up[i - 1], self->e[i]);
}

// The way down comes to nothing above the way up: that one is kept from here on.
static void follow_rise(nck_profile_t *self) {
    const uint32_t i = self->i;
    const double h = self->h[i];
    self->v_last = nck_sqrt(self->w[i]);
    self->a_last = (self->w[i] - self->w[i + 1]) / (2.0 * h);
    self->share = nck_hull_share(h, self->v_last + nck_sqrt(self->w[i + 1]), self->q_cap);
}

static void fall_one(nck_profile_t *self) {
    const uint32_t i = self->i;
    if (i == self->n) {
        self->w[i] = 0.0;
        return;
    }
    const double j = jerk_at(self, i + 1);
    const double v = self->v_last;
    const uint32_t broken = self->broken;
    const double vv = rise(self, v, i, j, self->down[i], self->e[i]);
    if (vv > 0.0 || !(self->e[i] > 0.0) || !(self->w[i + 1] < v * v)) {
        self->w[i] = nck_min(self->w[i], vv);
        return;
    }
    self->broken = broken;
    follow_rise(self);
}

// One unit of work; returns 1 when node i of the pass is done.
static int work(nck_profile_t *self, int fresh) {
    switch (self->phase) {
    case REACH_BACK: reach_back(self); return 1;
    case REACH_FORTH: reach_forth(self); return 1;
    case RAMP_BACK: ramp_back(self); return 1;
    case RAMP_FORTH: ramp_forth(self); return 1;
    case HULL_U: return hull(self, self->w, self->w, fresh);
    case LEVEL_U: level(self, self->w, self->e); return 1;
    case HULL_E: return hull(self, self->w, self->e, fresh);
    case LEVEL_E: level(self, self->w, self->e); return 1;
    case RISE: rise_one(self); return 1;
    case FALL: fall_one(self); return 1;
    case HULL_W: return hull(self, self->w, self->w, fresh);
    default: level(self, self->w, self->w); return 1;
    }
}

static void advance(nck_profile_t *self) {
    const uint32_t last = is_backward(self->phase) ? 0 : self->n;
    if (self->i == last) {
        begin_pass(self, self->phase + 1);
    } else if (last == 0) {
        self->i--;
    } else {
        self->i++;
    }
}

nck_status_t nck_profile_step(nck_profile_t *self, uint32_t budget) {
    for (uint32_t n = 0; n < budget; n++) {
        if (self->phase == PLANNED) return NCK_DONE;
        self->fresh = (uint32_t)work(self, (int)self->fresh);
        if (self->fresh) advance(self);
    }
    return self->phase == PLANNED ? NCK_DONE : NCK_OK;
}

int nck_profile_joins(const nck_profile_t *self) {
    const double vv = self->v * self->v;
    if (!(vv > 0.0)) return 1;
    if (self->broken || nck_fabs(self->w[0] - vv) > SPEED_EPSILON * vv) return 0;
    const double share =
        nck_hull_share(self->h[0], self->v + nck_sqrt(self->w[1]), self->q_cap);
    const double a = (self->w[1] - self->w[0]) / (2.0 * self->h[0]);
    const double fall = self->j_max[0] * (share + 0.5 * nck_min(self->q, self->q_cap));
    return a >= self->a - fall - JOIN_EPSILON * self->a_max[0];
}
