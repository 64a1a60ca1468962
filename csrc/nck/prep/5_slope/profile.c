// SPDX-License-Identifier: MIT
// Hull – forward and backward – hull, in bounded steps.
//
//   reach back, reach forth   how fast at all, by acceleration alone
//   ramp forth, ramp back     where the acceleration limit changes along the path, it is approached
//                             within the jerk; U, the two-pass envelope under these bounds
//   hull, hull                E: the largest function under U whose slope falls slowly enough
//   rise, fall                forward and backward under E, the acceleration grows slowly enough
//   hull: F                   takes off the edge where the two meet, by the durations above it
//   hull, hull                by those of F, which is too high, then by those of that
#include "nck/prep/5_slope/profile.h"

#include <assert.h> // assert
#include <stddef.h> // size_t
#include <string.h> // memcpy

#include "nck/base/limits.h"                // NCK_HAS_BEST
#include "nck/prep/5_slope/hull_math.h"     // nck_hull_…
#include "nck/prep/5_slope/profile_reach.h" // nck_profile_reach_… nck_profile_ramp_…

enum {
    REACH_BACK = 0, REACH_FORTH, RAMP_BACK, RAMP_FORTH, HULL_U, LEVEL_U, HULL_E, LEVEL_E, RISE,
    FALL, HULL_VV, LEVEL_VV, HULL_HIGH, LEVEL_HIGH, HULL_LAST, LEVEL_LAST, KEEP, PLANNED
};

// 7 nodes of a climb have the instructions of 8 in other passes, or more: they count as such.
enum { CLIMB_PRICE = 8 };

// The entry speed is met if vv agrees so far; a change of acceleration within rule R if it exceeds
// it by no more than this share of a_max (rounding in vv over short cells).
#define SPEED_EPSILON 1e-9
#define JOIN_EPSILON 1e-6
// A plan that can but slow down at first is none if that takes it below a tenth of what a cell
// reaches from rest, v³ = J·h²: it would creep on from there.
#define SLOWEST 1e-3
// A hull that leaves more of v² everywhere is as good as one by the durations at its own speeds:
// E, which only bounds a plan, a plan from rest, and one that goes on.
#define BLUNT_ENVELOPE 0.5
#define BLUNT_FROM_REST 0.8
#define BLUNT_ONWARD 0.6
// The last hull takes durations from speeds so much higher: a plan that goes on from within a turn
// has other bounds to its speeds there, and needs some room to join.
#define FASTER 1.03
// A speed is at the envelope within this share of it: it was added to another one and taken off.
#define CAP_EPSILON 1e-14

static int is_backward(uint32_t phase) { return phase == REACH_BACK || phase == FALL; }

static int is_level(uint32_t phase) {
    return phase == LEVEL_U || phase == LEVEL_E || phase == LEVEL_VV || phase == LEVEL_HIGH
           || phase == LEVEL_LAST;
}

// The node, or the cell, that a pass begins with.
static uint32_t begin_of(const nck_profile_t *self, uint32_t phase) {
    if (phase == RAMP_BACK) return self->last;
    if (phase == RAMP_FORTH) return self->first;
    return is_backward(phase) ? self->n : 0;
}

static void begin_pass(nck_profile_t *self, uint32_t phase) {
    self->phase = phase;
    self->i = begin_of(self, phase);
    self->v_last = 0.0;
    self->a_last = 0.0;
    self->share = 0.0;
    self->sigma = 0.0;
    self->fall = 0.0;
    self->slows = 0;
    if (!is_level(phase)) self->top = 0;
    if (phase == LEVEL_U || phase == LEVEL_VV) self->sharp = 0;
}

void nck_profile_begin(nck_profile_t *self) {
    assert(self->n >= 1);
    self->vv_cap[self->n] = 0.0;
    self->fresh = 1;
    self->broken = 0;
    begin_pass(self, REACH_BACK);
}

// How much the slope may have fallen up to a node, summed over length: C of the README.
typedef struct fallen {
    double v;     // speed at the node
    double share; // of the cell before
    double sigma; // what the slope may have fallen
    double sum;   // the same, summed over length
} fallen_t;

// Over a cell of the length h to its end, where the speed is v. j: at the node where it begins; 0
// where nothing falls. most: the largest share.
static inline void fall_over(fallen_t *fallen, double h, double v, double j, double most) {
    const double share = nck_hull_share(h, fallen->v + v, most);
    fallen->sigma += 2.0 * j * (fallen->share + share);
    fallen->sum += fallen->sigma * h;
    fallen->share = share;
    fallen->v = v;
}

// The two newest corners of a hull; while it has but one, both are that one.
typedef struct corners {
    double s0, z0; // the older one
    double s1, z1;
} corners_t;

// So many corners are on the stack, one at least.
static inline corners_t corners_of(const nck_profile_t *self, size_t top) {
    const uint32_t older = self->stack[top > 1 ? top - 2 : 0];
    const uint32_t newest = self->stack[top - 1];
    const corners_t corners = {self->s[older], self->z[older], self->s[newest], self->z[newest]};
    return corners;
}

// Without the newest one.
static inline corners_t corners_before(const nck_profile_t *self, size_t top,
                                       const corners_t *corners) {
    const uint32_t older = self->stack[top > 1 ? top - 2 : 0];
    const corners_t before = {self->s[older], self->z[older], corners->s0, corners->z0};
    return before;
}

// 1 if the newest corner is above what joins the one before it and the next node.
static inline int sticks_out(const corners_t *corners, double s, double z) {
    return nck_hull_above(corners->s0, corners->z0, corners->s1, corners->z1, s, z) >= 0.0;
}

// The hull's first corner; the speeds as below.
static void begin_hull(nck_profile_t *self, const double *vv_of_time) {
    self->v_last = nck_sqrt(vv_of_time[0]);
    self->z[0] = self->vv[0];
    self->stack[0] = 0;
    self->top = 1;
    self->i = 1;
}

// Corners of the lower hull of (s, vv + C); vv_of_time: the speeds' squares that the durations come
// from. A node and a corner taken off are a unit each.
static uint32_t hull(nck_profile_t *self, uint32_t budget, const double *vv_of_time) {
    if (self->i == 0) {
        begin_hull(self, vv_of_time);
        return 1;
    }
    const uint32_t count = nck_profile_left_forth(self, budget);
    const double most = 0.5 * self->q_cap;
    const double *const h = self->h;
    const double *const j = self->j;
    const double *const s = self->s;
    const double *const vv = self->vv;
    double *const z = self->z;
    uint32_t *const stack = self->stack;
    fallen_t fallen = {self->v_last, self->share, self->sigma, self->fall};
    size_t i = self->i;
    size_t top = self->top;
    uint32_t fresh = self->fresh;
    corners_t corners = corners_of(self, top);
    double at = fresh ? 0.0 : z[i];
    uint32_t left = count;
    while (left > 0) {
        if (fresh) {
            fall_over(&fallen, h[i - 1], nck_sqrt(vv_of_time[i]), j[i - 1], most);
            at = vv[i] + fallen.sum;
            z[i] = at;
        }
        const double s_here = s[i];
        while (sticks_out(&corners, s_here, at) && top > 1 && left > 0) {
            top--;
            corners = corners_before(self, top, &corners);
            left--;
        }
        fresh = left > 0;
        if (!fresh) break;
        corners = (corners_t){corners.s1, corners.z1, s_here, at};
        stack[top] = (uint32_t)i;
        top++;
        i++;
        left--;
    }
    self->v_last = fallen.v;
    self->share = fallen.share;
    self->sigma = fallen.sigma;
    self->fall = fallen.sum;
    self->i = (uint32_t)i;
    self->top = (uint32_t)top;
    self->fresh = fresh;
    return count;
}

static int begins_at_rest(const nck_profile_t *self) { return !(self->v > 0.0); }

static double blunt_of(const nck_profile_t *self) {
    if (self->phase == LEVEL_U) return BLUNT_ENVELOPE;
    return begins_at_rest(self) ? BLUNT_FROM_REST : BLUNT_ONWARD;
}

// Every node of vv down onto the hull, in e; in its place if that is the plan. On a corner it stays
// to the bit. For the last hull it is what that takes durations from: no more than above it,
// for those are what acceleration falls by into a stretch of less.
static uint32_t level(nck_profile_t *self, uint32_t budget) {
    const uint32_t count = nck_profile_left_forth(self, budget);
    const double *const s = self->s;
    const double *const z = self->z;
    const uint32_t *corner = self->stack + (self->i > 0 ? self->top : 0); // i, or the next one
    const size_t end = self->i + count;
    const double blunt = blunt_of(self);
    const double faster = NCK_HAS_BEST && self->phase == LEVEL_HIGH ? FASTER * FASTER : 1.0;
    const double *const vv = self->vv;
    double *const out = NCK_HAS_BEST || self->phase != LEVEL_VV ? self->e : self->vv;
    uint32_t sharp = self->sharp;
    for (size_t i = self->i; i < end; i++) {
        const double value = vv[i];
        if (*corner == i) {
            corner++;
            out[i] = value;
            continue;
        }
        const double fall = z[i] - value;
        const uint32_t a = corner[-1];
        const uint32_t b = corner[0];
        const double on_hull = z[a] + (z[b] - z[a]) * ((s[i] - s[a]) / (s[b] - s[a]));
        const double leveled = nck_max(0.0, nck_min(value, on_hull - fall));
        sharp |= NCK_HAS_BEST && i < self->count && leveled < blunt * value;
        out[i] = nck_min(value, faster * leveled);
    }
    self->top = (uint32_t)(corner - self->stack);
    self->i = (uint32_t)end;
    self->sharp = sharp;
    return count;
}

// The envelope is the plan.
static uint32_t keep(nck_profile_t *self, uint32_t budget) {
    const uint32_t count = nck_profile_left_forth(self, budget);
    memcpy(self->vv + self->i, self->e + self->i, count * sizeof *self->vv);
    self->i += count;
    return count;
}

// The state of a rise from cell to cell.
typedef struct rise {
    double v, a, share;
    uint32_t slows, broken;
} rise_t;

static inline rise_t rise_of(const nck_profile_t *self) {
    const rise_t state = {self->v_last, self->a_last, self->share, self->slows, self->broken};
    return state;
}

static inline void keep_rise(nck_profile_t *self, const rise_t *state) {
    self->v_last = state->v;
    self->a_last = state->a;
    self->share = state->share;
    self->slows = state->slows;
    self->broken = state->broken;
}

// Whether a cell after which the jerk still keeps the acceleration negative shows that no plan
// begins like this.
static inline int comes_to_nothing(const nck_hull_cell_t *step, const rise_t *state, double a_max) {
    const double a_least = -(1.0 + JOIN_EPSILON) * a_max;
    const int creeps = state->v * state->v * state->v < SLOWEST * step->j * step->h * step->h;
    return creeps || state->a < a_least;
}

// One cell onward under the envelope e. a_max: of the cell; the step has what of it may be used.
static inline double rise(rise_t *state, const nck_hull_cell_t *step, const double *a_max,
                          double e_end) {
    const double v = state->v;
    const double b = state->a + step->j * state->share;
    const double v_cap = nck_sqrt(e_end);
    double v1 = v_cap;
    double vv1 = e_end;
    int capped = 1;
    if (!nck_hull_stays(v, b, v_cap)) {
        double most = nck_hull_rise(step, v, b, v_cap);
        if (most < 0.0) {
            state->broken = 1;
            most = 0.0;
        }
        capped = most >= v_cap * (1.0 - CAP_EPSILON);
        if (!capped) {
            v1 = most;
            vv1 = most * most;
        }
    }
    state->v = v1;
    state->a = (vv1 - v * v) / (2.0 * step->h);
    if (state->slows) {
        state->slows = !capped && state->a < 0.0;
        if (state->slows && comes_to_nothing(step, state, *a_max)) state->broken = 1;
    }
    state->share = nck_hull_share(step->h, v + v1, step->most);
    // at rest; or on a falling envelope, where the next cell may be level
    const int free = !(vv1 > 0.0) || (capped && state->a + step->j * state->share < 0.0);
    if (free) {
        state->a = 0.0;
        state->share = 0.0;
    }
    return vv1;
}

static void rise_first(nck_profile_t *self) {
    self->vv[0] = nck_min(self->e[0], self->v * self->v);
    self->v_last = nck_sqrt(self->vv[0]);
    self->a_last = self->a;
    self->share = 0.5 * nck_min(self->q, self->q_cap);
    self->slows = self->a < 0.0;
}

// The way down comes to nothing above the way up: that one is kept from here on.
static void follow_rise(const nck_profile_t *self, uint32_t i, rise_t *state) {
    const double h = self->h[i];
    state->v = nck_sqrt(self->vv[i]);
    state->a = (self->vv[i] - self->vv[i + 1]) / (2.0 * h);
    state->share = nck_hull_share(h, state->v + nck_sqrt(self->vv[i + 1]), 0.5 * self->q_cap);
}

// On the way back: node i, where the rise from behind comes to vv. v: its speed before it went over
// the cell; broken: what it had told by then.
static inline void meet(nck_profile_t *self, uint32_t i, double vv, double v, uint32_t broken,
                        rise_t *state) {
    if (vv > 0.0 || !(self->e[i] > 0.0) || !(self->vv[i + 1] < v * v)) {
        self->vv[i] = nck_min(self->vv[i], vv);
        return;
    }
    state->broken = broken;
    follow_rise(self, i, state);
}

// Where a pass of rises begins: the first node, and the next one to be done.
static uint32_t begin_climb(nck_profile_t *self, int back) {
    if (back) self->vv[self->n] = 0.0;
    else rise_first(self);
    return back ? self->n - 1 : 1;
}

// Jerk at the node that a pass of rises enters a cell by; at the path's ends it is the cell's own.
static double jerk_of_first(const nck_profile_t *self, uint32_t cell, int back) {
    if (back) return cell + 1 < self->n ? self->j[cell + 1] : self->j_max[cell];
    return cell > 0 ? self->j[cell] : self->j_max[0];
}

// Rise and fall: the cells of one pass, forth or back, each within its bound.
static uint32_t climb(nck_profile_t *self, uint32_t budget, const double *bound, int back) {
    const uint32_t nodes = budget - budget / CLIMB_PRICE;
    const uint32_t count = back ? nck_profile_left_back(self, nodes)
                                : nck_profile_left_forth(self, nodes);
    const int begins = self->i == (back ? self->n : 0);
    size_t i = begins ? begin_climb(self, back) : self->i;
    size_t cell = back ? i : i - 1;
    rise_t state = rise_of(self);
    const double most = 0.5 * self->q_cap;
    const size_t onward = back ? SIZE_MAX : 1; // one back, or forth
    const uint32_t end = count - (begins ? 1 : 0);
    double j = end > 0 ? jerk_of_first(self, (uint32_t)cell, back) : 0.0;
    for (uint32_t n = 0; n < end; n++) {
        const nck_hull_cell_t step = {self->h[cell], bound[cell], j, most};
        const double v = state.v;
        const uint32_t broken = state.broken;
        const double vv = rise(&state, &step, &self->a_max[cell], self->e[i]);
        if (back) meet(self, (uint32_t)i, vv, v, broken, &state);
        else self->vv[i] = vv;
        j = self->j[i]; // between this cell and the next one
        i += onward;
        cell += onward;
    }
    keep_rise(self, &state);
    self->i = (uint32_t)i;
    return count < nodes ? count + count / (CLIMB_PRICE - 1) : budget;
}

static uint32_t work(nck_profile_t *self, uint32_t budget) {
    if (is_level(self->phase)) return level(self, budget);
    switch (self->phase) {
    case REACH_BACK: return nck_profile_reach_back(self, budget);
    case REACH_FORTH: return nck_profile_reach_forth(self, budget);
    case RAMP_BACK: return nck_profile_ramp_back(self, budget);
    case RAMP_FORTH: return nck_profile_ramp_forth(self, budget);
    case RISE: return climb(self, budget, self->up, 0);
    case FALL: return climb(self, budget, self->down, 1);
    case KEEP: return keep(self, budget);
    case HULL_U:
    case HULL_VV: return hull(self, budget, self->vv);
    default: return hull(self, budget, self->e);
    }
}

// The pass has done its last node: forward n, backward 0, and i has gone beyond.
static int is_over(const nck_profile_t *self) { return self->i > self->n; }

// nck_profile_joins, of a plan vv.
static int joins(const nck_profile_t *self, const double *vv) {
    const double entry = self->v * self->v;
    if (!(entry > 0.0)) return 1;
    if (self->broken || nck_fabs(vv[0] - entry) > SPEED_EPSILON * entry) return 0;
    const double share =
        nck_hull_share(self->h[0], self->v + nck_sqrt(vv[1]), 0.5 * self->q_cap);
    const double a = (vv[1] - vv[0]) / (2.0 * self->h[0]);
    const double fall = self->j_max[0] * (share + 0.5 * nck_min(self->q, self->q_cap));
    return a >= self->a - fall - JOIN_EPSILON * self->a_max[0];
}

// The pass behind the one that is over. A plan that goes on has to join: its envelope is the best,
// and so is what would not join.
static uint32_t pass_behind(const nck_profile_t *self) {
    if (!NCK_HAS_BEST) return self->phase == LEVEL_VV ? PLANNED : self->phase + 1;
    if (self->sharp) return self->phase + 1;
    if (self->phase == LEVEL_U && begins_at_rest(self) && self->count > 0) return RISE;
    return self->phase == LEVEL_VV && joins(self, self->e) ? KEEP : self->phase + 1;
}

nck_status_t nck_profile_step(nck_profile_t *self, uint32_t budget) {
    uint32_t left = budget;
    while (left > 0 && self->phase != PLANNED) {
        left -= work(self, left);
        if (is_over(self)) begin_pass(self, pass_behind(self));
    }
    return self->phase == PLANNED ? NCK_DONE : NCK_OK;
}

int nck_profile_joins(const nck_profile_t *self) { return joins(self, self->vv); }
