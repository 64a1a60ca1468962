// SPDX-License-Identifier: MIT
// Inside room 6: how a tick brakes without a plan, and sets off again.
#include "nck/tick/6_interpolate/clock.h"

#include <stddef.h> // NULL

#include "nck/base/cell_math.h"          // nck_cell_way nck_cell_speed
#include "nck/base/fence.h"              // nck_fence_load nck_fence_store
#include "nck/base/path.h"               // nck_path_slope nck_path_share nck_path_turns
#include "nck/base/real.h"               // nck_min nck_max nck_sqrt nck_fabs
#include "nck/tick/6_interpolate/look.h" // nck_look_…

// Of an axis' acceleration, what a brake plans with: geometry changes within a period.
#define SHARE 0.98
// Of its jerk, what a brake begins with: geometry changes within a period.
#define BEGIN_SHARE 0.9
// … and what leads back; all where it follows the plan to a corner's rest, which may take that.
#define BACK_SHARE 0.99995
// … and what is left of a plan that it has followed, which goes by steps.
#define FOLLOW_SHARE 0.97
// … and what it has over the plan's to give way where the plan, which may take all, catches up.
#define MEET_SHARE 0.01
// What it counts on when nearly at rest: directions change on the way.
#define END_SHARE 0.9
// Of an axis' acceleration, what a brake takes even where corners or bends leave less: at lower
// speeds they leave more, so it need not wait for them to end.
#define LEAST_SHARE 0.02
// A direction that asks nothing of an axis: below it no acceleration along the path moves it.
#define ALONG_LEAST 1e-6
// Of the speed now, what an axis may have on the way, with what acceleration makes while jerk
// brings it: k′ is as large as the speed of then allows, so a plan that speeds up by A meets a k
// that is nearly 1.
#define SOON_SHARE 1.5
#define SPEED_LEAST 1e-9 // [mm/s] a tool that is slower takes any k′
// A clock that is so near to running runs: a jump of 1e-9 periods' way.
#define RUNS_EPSILON 1e-9
// A clock that stands waits so long for a plan that is made: some tens are usual.
enum { KEPT_PERIODS = 250 };
// Newton's steps to a time within a cell: each doubles the digits of a first guess good to some %.
enum { TIME_STEPS = 4 };

// What all axes allow together.
typedef struct bounds {
    double a_low;            // behind this period [path mm/s²]
    double a_floor;          // on a line
    double j_low, j_high;    // in it [path mm/s³]
    double j_floor;          // the least for what must be
    double low_is, high_is;  // what one mm/s³ is to the axis that says so, of its limit
    double j_end;            // when nearly at rest [path mm/s³]
    double back;             // share of the jerk that leads back
} bounds_t;

// The end of a seg.
typedef struct seg_end {
    double jump[NCK_AXIS_MAX]; // by which dp/ds jumps there
    double in_s;               // until then [s]
    nck_look_geometry_t there; // behind it
    double vv;                 // (path mm/s)² that braking leaves then
} seg_end_t;

// Jerk of one axis along its own direction on the path:
//   |p‴v³ + 3p″va + p′j| ≤ J
// along: |p′|; twist: what the speed and the acceleration ask for, positive with p′.
static void bound_jerk(bounds_t *bounds, double along, double twist, double j_max) {
    const double low = (-BEGIN_SHARE * j_max - twist) / along;
    bounds->j_floor = nck_max(bounds->j_floor, (-j_max - twist) / along);
    const double high = (bounds->back * j_max - twist) / along;
    if (low > bounds->j_low) {
        bounds->j_low = low;
        bounds->low_is = along / j_max;
    }
    if (high < bounds->j_high) {
        bounds->j_high = high;
        bounds->high_is = along / j_max;
    }
}

// The most that |p′| of an axis is in a seg: an arc turns to it, a spline's is a mean of the
// slopes between its points.
static double most_along(const nck_seg_t *seg, int x) {
    if (nck_path_turns(seg, x)) return 1.0;
    if (seg->kind != NCK_SEG_SPLINE) return nck_fabs(nck_path_slope(seg, x));
    const double b1 = seg->shape.inner[0][x];
    const double b2 = seg->shape.inner[1][x];
    const double ends = nck_max(nck_fabs(b1 - seg->start[x]), nck_fabs(seg->end[x] - b2));
    return 3.0 * nck_max(ends, nck_fabs(b2 - b1)) / seg->length;
}

// The path's jerk that every axis allows anywhere in a seg.
static double least_jerk(const nck_terms_t *terms, const nck_seg_t *seg) {
    double j = terms->machine->path.j_max;
    for (int x = 0; x < terms->axes; x++) {
        const nck_axis_t *const axis = &terms->machine->axis[x];
        const double along = most_along(seg, x);
        if (axis->present && along >= ALONG_LEAST) j = nck_min(j, axis->j_max / along);
    }
    return seg->kind == NCK_SEG_LINE ? j : END_SHARE * j;
}

// What follows at the seg's end is felt one period on: a sample of acceleration spans two.
static int feels_end(const nck_clock_t *self, const nck_look_place_t *place, double period) {
    const double way = 2.0 * self->first.v * period;
    return place->behind && place->s + way >= place->seg->length;
}

// A corner is felt from two periods before it on, until the filter has forgotten it.
static void feel_corner(nck_clock_t *self, const nck_terms_t *terms, const double *jump, int felt) {
    if (self->feels > 0) self->feels--;
    if (!felt && self->feels > 0) return;
    for (int x = 0; x < terms->axes; x++) {
        const double before = self->feels > 0 ? (double)self->jump[x] : 0.0;
        self->jump[x] = felt ? (float)nck_max(before, jump[x]) : 0.0f;
    }
    if (felt) self->feels = (uint16_t)(terms->taps + 2u);
}

// One axis, at a place and behind the next seg's begin.
static void bound_axis(const nck_clock_t *self, const nck_terms_t *terms, int x,
                       const nck_look_geometry_t *const at[2], const seg_end_t *end,
                       bounds_t *bounds) {
    const nck_axis_t *const axis = &terms->machine->axis[x];
    const double period = terms->machine->period_s;
    const double v = self->first.v;
    const double next = nck_max(0.0, v + self->second.a * period);
    const double along = nck_fabs(at[0]->first[x]);
    const double sign = at[0]->first[x] < 0.0 ? -1.0 : 1.0;
    if (!axis->present || along < ALONG_LEAST) return;
    const double here = sign * (at[0]->second[x] + at[0]->third[x] * v * period);
    const double curve = nck_min(here, sign * at[1]->second[x]) * next * next;
    const double corner = (double)self->jump[x] * next / period;
    const double a_max = nck_max(0.0, SHARE * axis->a_max - corner);
    const double least = -LEAST_SHARE * axis->a_max / along;
    const double all = axis->a_max - corner + nck_min(0.0, curve);
    bounds->a_floor = nck_max(bounds->a_floor, -nck_max(0.0, all) / along);
    bounds->a_low = nck_max(bounds->a_low, nck_min((-a_max - curve) / along, least));
    if (!terms->limits_jerk) return; // by steps: what follows counts where it is felt
    const double a_there = nck_max(0.0, SHARE * axis->a_max - end->jump[x] * v / period);
    const double ramp = BEGIN_SHARE * axis->j_max * end->in_s;
    const double bend = nck_min(0.0, sign * end->there.second[x] * end->vv);
    bounds->a_low = nck_max(bounds->a_low, nck_min((-a_there - bend - ramp) / along, least));
    const double speed[2] = {v, next};
    for (int n = 0; n < 4; n++) {
        const double u = speed[n / 2];
        const nck_look_geometry_t *const g = at[n % 2];
        const double twist = sign * (g->third[x] * u * u + 3.0 * g->second[x] * self->second.a) * u;
        bound_jerk(bounds, along, twist, axis->j_max);
    }
}

// The jerk that takes the last acceleration away: what every axis allows in the seg, and in the one
// behind it where a brake with no more than that gets there: from v on within v·√(2v/j)/3.
static double last_jerk(const nck_clock_t *self, const nck_terms_t *terms,
                        const nck_look_place_t *place) {
    const double v = self->first.v;
    const double left = nck_max(0.0, place->seg->length - place->s);
    const double here = least_jerk(terms, place->seg);
    if (!place->behind) return here;
    const double j = nck_min(here, least_jerk(terms, place->behind));
    return v * nck_sqrt(2.0 * v / j) < 3.0 * left ? here : j;
}

// What is to be known of it.
static void look_at_end(const nck_clock_t *self, const nck_look_place_t *place, double period,
                        seg_end_t *end) {
    const double left = nck_max(0.0, place->seg->length - place->s);
    const double v = self->first.v;
    end->in_s = left / v;
    end->vv = nck_max(0.0, v * v + 2.0 * nck_min(0.0, self->second.a) * left);
    nck_look_corners(place, v, period, end->jump);
    if (place->behind) nck_look_geometry(place->behind, 0.0, &end->there);
    else end->there = place->at;
}

static bounds_t bounds_of(nck_clock_t *self, const nck_terms_t *terms,
                          const nck_look_place_t *place) {
    const nck_machine_t *const machine = terms->machine;
    const double j_path = machine->path.j_max;
    const double back = self->follows ? 1.0 : BACK_SHARE;
    const double a_path = machine->path.a_max;
    const int felt = feels_end(self, place, machine->period_s);
    bounds_t bounds = {-SHARE * a_path, -a_path, -BEGIN_SHARE * j_path, back * j_path, -j_path,
                       1.0 / j_path, 1.0 / j_path, j_path, back};
    const nck_look_geometry_t *at[2];
    seg_end_t end;
    look_at_end(self, place, machine->period_s, &end);
    at[0] = &place->at;
    at[1] = felt ? &end.there : &place->at;
    feel_corner(self, terms, end.jump, felt);
    for (int x = 0; x < terms->axes; x++) bound_axis(self, terms, x, at, &end, &bounds);
    bounds.j_end = last_jerk(self, terms, place);
    if (!terms->limits_jerk) return bounds;
    const nck_look_tool_t tool = {self->first.v, self->second.a, bounds.j_end, end.in_s, a_path};
    bounds.a_low = nck_max(bounds.a_low, nck_look_bends(terms, place, &tool));
    return bounds;
}

// Between two that allow nothing together: so that both are passed by the same share.
static double between(const bounds_t *bounds) {
    const double weight = bounds->low_is + bounds->high_is;
    const double j = (bounds->j_low * bounds->low_is + bounds->j_high * bounds->high_is) / weight;
    return nck_min(j, bounds->j_end);
}

// What a bend leaves of the jerk that takes the last acceleration away, from v on, of every axis:
//   |p′|j + 3|p″|v·|a| ≤ J with a² = 2jv.
// It grows as v falls, so what begins with it ends in time.
static double jerk_to_rest(const nck_terms_t *terms, const nck_look_place_t *place, double v,
                           double j_end) {
    const double way = v * nck_sqrt(2.0 * v / j_end) / 3.0;
    double j = j_end;
    if (place->seg->kind == NCK_SEG_LINE) return j;
    for (int x = 0; x < terms->axes; x++) {
        const nck_axis_t *const axis = &terms->machine->axis[x];
        const double along = nck_fabs(place->at.first[x]);
        const double sign = place->at.first[x] < 0.0 ? 1.0 : -1.0;
        const double there = place->at.second[x] + place->at.third[x] * way;
        const double bend = 3.0 * nck_max(sign * place->at.second[x], sign * there);
        const double left = END_SHARE * axis->j_max;
        if (!axis->present || !(bend > 0.0)) continue;
        const double b = bend * v * nck_sqrt(2.0 * v);
        const double root = 2.0 * left / (b + nck_sqrt(b * b + 4.0 * along * left));
        j = nck_min(j, root * root);
    }
    return j;
}

// a so that it is gone when v is, in steps of T:  |a| = √((JT/2)² + 2Jv) − JT/2
static double accel_to_rest(double v, double j, double period) {
    const double step = 0.5 * j * period;
    return step - nck_sqrt(step * step + 2.0 * j * v);
}

// 1 if the plan, which brakes harder, would be met before the brake has come to its acceleration.
static int meets_plan(const nck_clock_t *self, const nck_look_place_t *place,
                      const bounds_t *bounds) {
    const double harder = self->second.a - place->a;
    const double apart = nck_max(0.0, place->v - self->first.v);
    return harder > 0.0 && 2.0 * MEET_SHARE * bounds->j_end * apart < harder * harder;
}

// The acceleration behind this period.
static double next_accel(nck_clock_t *self, const nck_terms_t *terms,
                         const nck_look_place_t *place, double *v_least_out) {
    const double period = terms->machine->period_s;
    bounds_t bounds = bounds_of(self, terms, place);
    self->j_end = (float)bounds.j_end;
    // What the plan may ask for at a higher speed, the brake may as well.
    const double deeper = terms->limits_jerk ? bounds.j_floor * period : 0.0;
    const double floor = nck_min(bounds.a_floor, place->a);
    bounds.a_low = nck_min(bounds.a_low, nck_max(place->a + deeper, floor));
    *v_least_out = 0.0;
    if (!terms->limits_jerk) return bounds.a_low;
    const double v = nck_max(0.0, self->first.v + self->second.a * period);
    const double j_rest = jerk_to_rest(terms, place, v, bounds.j_end);
    const double to_rest = accel_to_rest(v, j_rest, period);
    const double wanted = nck_max(bounds.a_low, to_rest);
    // Of what is left then, jerk and acceleration take no more than theirs.
    const double last = nck_max(0.0, -0.5 * bounds.a_low);
    *v_least_out = nck_min(0.125 * bounds.j_end * period, last) * period;
    // No axis makes the brake harder: what a bend takes grows with that.
    bounds.j_high = nck_max(0.0, bounds.j_high);
    if (bounds.j_low > bounds.j_high) return self->second.a + between(&bounds) * period;
    const double j = (wanted - self->second.a) / period;
    const double a = self->second.a + nck_max(bounds.j_low, nck_min(bounds.j_high, j)) * period;
    if (!meets_plan(self, place, &bounds)) return a;
    // A plan that comes to rest knows where: the brake may end with all that there is here, as it.
    const double j_here = nck_max(j_rest, FOLLOW_SHARE * bounds.j_high);
    const double most = nck_max(bounds.a_low, accel_to_rest(v, j_here, period));
    return nck_min(a, nck_max(most, self->second.a + bounds.j_floor * period));
}

// x′k, x″k² + x′k′: the plan asks for x′ and x″, the clock is at k and k′.
void nck_clock_begin(nck_clock_t *self, double v, double a) {
    const int runs = self->state == NCK_CLOCK_RUNS;
    const double rate = runs ? 1.0 : self->first.rate;
    self->first.v = v * rate;
    self->second.a = a * rate * rate + (runs ? 0.0 : v * self->second.gain);
    self->feels = 0;
    self->follows = 1;
    nck_fence_store(&self->state, NCK_CLOCK_BRAKES);
}

void nck_clock_measure(const nck_seg_t *seg, double s, nck_pose_t *pose) {
    double speed = 0.0;
    pose->s = seg->s_begin + seg->length * nck_path_share(seg, s, &speed);
    pose->v *= speed;
}

void nck_clock_find(const nck_link_t *link, const nck_cell_t *cell, double t,
                    nck_look_place_t *place_out) {
    const uint32_t last = cell->seg + cell->span;
    uint32_t seq = cell->seg;
    double s = cell->s + nck_max(0.0, nck_min(nck_cell_way(cell, t), cell->length));
    while (seq != last && s >= nck_link_seg(link, seq)->length) {
        s -= nck_link_seg(link, seq++)->length;
    }
    const int known = nck_fence_load(&link->seg_head) - seq > 1;
    const int rests = (cell->stop & NCK_STOP_REST) && seq == last;
    const nck_seg_t *const behind = known && !rests ? nck_link_seg(link, seq + 1) : NULL;
    place_out->seg = nck_link_seg(link, seq);
    place_out->s = nck_min(s, place_out->seg->length);
    place_out->behind = behind && behind->length > 0.0 ? behind : NULL; // no dwell, no wait
    place_out->link = link;
    nck_look_geometry(place_out->seg, place_out->s, &place_out->at);
}

// Cells of constant acceleration are the steps of a ramp, which is met in the middle of each.
void nck_clock_plan(const nck_cell_t *cell, double t, double a_before, nck_look_place_t *place) {
    const double share = cell->duration > 0.0 ? t / cell->duration - 0.5 : 0.0;
    const double v = nck_max(0.0, nck_cell_speed(cell, t));
    const double a = cell->a + cell->j * t + share * (cell->a - a_before);
    place->v = v;
    place->a = a;
}

double nck_clock_brake(nck_clock_t *self, const nck_terms_t *terms,
                       const nck_look_place_t *place) {
    const double period = terms->machine->period_s;
    double v_least = 0.0;
    if (!(self->first.v > 0.0)) return 0.0;
    const double v0 = self->first.v;
    const double a = next_accel(self, terms, place, &v_least);
    const double a0 = terms->limits_jerk ? self->second.a : a; // without a limit of jerk it steps
    const double v = v0 + 0.5 * (a0 + a) * period;
    const int rests = !(v > v_least);
    self->second.a = rests ? 0.0 : a;
    self->first.v = rests ? 0.0 : v;
    return rests ? 0.5 * v0 * period : (v0 + (2.0 * a0 + a) / 6.0 * period) * period;
}

// The least time constant τ that the quantities V, A and J of an axis let a clock have that sets
// off as 1 − (1 + t/τ)·exp(−t/τ), whatever the plan asks for within them: by
//   |x″k² + x′k′| ≤ A          2τ ≥ V/A
//   |x‴k³ + 3x″kk′ + x′k″| ≤ J  τ² ≥ V/J at rest, 3A/τ + V/τ² ≤ 3J at the end
static double time_constant(double v, double a, double j) {
    const double by_end = (3.0 * a + nck_sqrt(9.0 * a * a + 12.0 * j * v)) / (6.0 * j);
    return nck_max(0.5 * v / a, nck_max(nck_sqrt(v / j), by_end));
}

void nck_clock_go_on(nck_clock_t *self) {
    self->first.rate = 0.0;
    self->second.gain = 0.0;
    self->feels = 1;
    self->kept = 0;
    self->share = 1;
    nck_fence_store(&self->state, NCK_CLOCK_SETS_OFF);
}

void nck_clock_leave(nck_clock_t *self, uint32_t kept) {
    if (self->state != NCK_CLOCK_STANDS) return;
    if (kept && self->kept < KEPT_PERIODS) self->kept++;
    else nck_clock_go_on(self);
}

// The speed that an axis may have on the way, where the path's is v now: it grows by A.
static double speed_soon(double v_max, double a_max, double j_max, double v) {
    return nck_min(v_max, SOON_SHARE * v + a_max * a_max / j_max);
}

double nck_clock_set_off(nck_clock_t *self, const nck_terms_t *terms, double v) {
    const nck_machine_t *const machine = terms->machine;
    const double period = machine->period_s;
    double a_max = machine->path.a_max;
    const double j_path = machine->path.j_max;
    const double soon = speed_soon(nck_max(v, machine->path.feed_max), a_max, j_path, v);
    double tau = time_constant(soon, a_max, j_path);
    for (int x = 0; x < terms->axes; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        if (!axis->present) continue;
        a_max = nck_min(a_max, axis->a_max);
        const double speed = speed_soon(axis->v_max, axis->a_max, axis->j_max, v);
        tau = nck_max(tau, time_constant(speed, axis->a_max, axis->j_max));
    }
    // k″ = (1 − k)/τ² − 2k′/τ by an implicit step, which never overshoots.
    const double share = period / tau;
    const double before = self->first.rate;
    const double gain = self->second.gain + share * (1.0 - before) / tau;
    // A plan that has sped up since may take A by itself: what it leaves is A(1 − k²)/v.
    const double most = a_max * (1.0 - before * before) / nck_max(v, SPEED_LEAST);
    self->second.gain = nck_min(gain / ((1.0 + share) * (1.0 + share)), most);
    self->first.rate += self->second.gain * period;
    if (1.0 - self->first.rate <= RUNS_EPSILON) {
        self->first.rate = 1.0;
        nck_fence_store(&self->state, NCK_CLOCK_RUNS);
    }
    return 0.5 * (before + self->first.rate) * period;
}

void nck_clock_follow(nck_clock_t *self, double v, double a) {
    self->first.v = v;
    self->second.a = nck_max(a, -nck_sqrt(2.0 * FOLLOW_SHARE * (double)self->j_end * v));
}

double nck_clock_time(const nck_cell_t *cell, double t, double way) {
    const double v = nck_cell_speed(cell, t);
    const double a = cell->a + cell->j * t;
    const double least = nck_sqrt(nck_max(0.0, v * v + 2.0 * a * way));
    if (!(v + least > 0.0)) return 0.0;
    double time = 2.0 * way / (v + least);
    for (int n = 0; n < TIME_STEPS && cell->j != 0.0; n++) {
        const double speed = v + (a + 0.5 * cell->j * time) * time;
        const double off = (v + (0.5 * a + cell->j / 6.0 * time) * time) * time - way;
        if (!(speed > 0.0)) break;
        time = nck_max(0.0, time - off / speed);
    }
    return time;
}
