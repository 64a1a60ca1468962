// SPDX-License-Identifier: MIT
// Inside room 5: intervals of a clocked path become the nodes of a motion.
#include "nck/prep/5_slope/optimal_nodes.h"

#include <string.h> // memset

#include "nck/base/path.h" // nck_path_ways nck_path_way_at
#include "nck/base/real.h" // nck_fabs nck_min nck_max nck_sqrt nck_num
#include "nck/base/spin_math.h" // nck_spin_…
#include "nck/base/tuning.h" // NCK_MET NCK_START
#include "nck/prep/5_slope/optimal_pace.h" // nck_optimal_work …

#define PACE_LEAST 1e-8
// Slower than that by its clock the path rests [mm/s].
#define REST_LEAST 1e-6
#define PACE_MOST 1e6
// Of an axis' limits, what a plan is asked to keep to: with what it may take more of them, and with
// what its cells are off it, that is all of them (0.002 of time is what 0.6 % of jerk cost).
#define SHARE_ASKED (SHARE_SPEED - NCK_OPTIMAL_CELL_SHARE)
// The same of speed, of which cells take no more.
#define SHARE_SPEED (1.0 - NCK_MET)

// A spline by the clock: differences of its points, and what a derivative by its own parameter is
// multiplied by to be one by the clock [1/s].
typedef struct hodograph {
    nck_num of[NCK_AXIS_MAX][3]; // [mm]
    nck_num length;              // of the path [path mm]
    nck_num per;                 // length over the clock's time [path mm/s]
} hodograph_t;

static void set_hodograph(const nck_optimal_t *self, const nck_seg_t *seg, hodograph_t *out) {
    memset(out, 0, sizeof *out);
    out->length = (nck_num)seg->length;
    out->per = (nck_num)(seg->length / self->terms->knot_s);
    for (int x = 0; x < self->terms->axes; x++) nck_path_ways(seg, x, out->of[x]);
}

// dp/ds at f of an interval: nck_path_tangent, near the path.
static nck_num tangent_at(const hodograph_t *path, int x, nck_num f) {
    return 3 * nck_path_way_at(path->of[x], f) / path->length;
}

// Derivatives by the clock, at the begin or the end of an interval.
static void derive(const nck_optimal_t *self, const nck_seg_t *seg, int at_end, nck_num *first_out,
                   nck_num *second_out) {
    hodograph_t path;
    set_hodograph(self, seg, &path);
    const nck_num f = (nck_num)at_end;
    const nck_num scale = 6 / (path.length * path.length);
    for (int x = 0; x < self->terms->axes; x++) {
        const nck_num dd0 = path.of[x][1] - path.of[x][0];
        const nck_num dd1 = path.of[x][2] - path.of[x][1];
        first_out[x] = path.per * tangent_at(&path, x, f);
        second_out[x] = path.per * path.per * (scale * (dd0 + (dd1 - dd0) * f));
    }
}

// Where in an interval a place is that is looked at. |p′|² is of the fourth degree there.
static nck_num place_at(int n) { return (nck_num)n / (nck_num)(NCK_OPTIMAL_PLACES - 1); }

// |p′|² at f of an interval; where the path is longer than what F is meant for, that of X Y Z over
// that share, if it is more: a curve goes over from one such line to the next.
static nck_num along_at(const nck_optimal_t *self, const hodograph_t *path, nck_num scale,
                        nck_num f) {
    nck_num all = 0;
    nck_num tool = 0;
    for (int x = 0; x < self->terms->axes; x++) {
        const nck_num tangent = tangent_at(path, x, f);
        all += tangent * tangent;
        if (x <= NCK_AXIS_Z) tool = all;
    }
    tool /= scale * scale;
    return path->per * path->per * nck_num_max(all, tool);
}

// |p′|² at the places of an interval. It is looked for once a plan: six nodes ask.
static const nck_num *look_along(nck_optimal_t *self, const nck_node_t *piece, uint32_t number) {
    nck_optimal_look_t *const look = &self->looked[number % NCK_OPTIMAL_LOOKS];
    if (look->known && look->number == number) return look->along;
    const nck_seg_t *const seg = nck_link_seg(self->link, piece->seg);
    hodograph_t path;
    set_hodograph(self, seg, &path);
    look->known = 1;
    look->number = number;
    for (int n = 0; n < NCK_OPTIMAL_PLACES; n++) {
        look->along[n] = along_at(self, &path, (nck_num)seg->feed_scale, place_at(n));
    }
    return look->along;
}

// The most b in an interval with which the spindle follows a surface speed: of X by its place.
static double spin_pace(const nck_optimal_t *self, const nck_seg_t *seg) {
    const nck_spin_t *const spin = &seg->spin;
    const double a = self->terms->machine->spindle.a_max_rpm_s;
    double slowness = 1.0 / PACE_MOST;
    if (!NCK_HAS_LATHE || !(spin->most > 0.0) || !(a > 0.0)) return PACE_MOST;
    hodograph_t path;
    set_hodograph(self, seg, &path);
    const double flat = nck_spin_flat(spin);
    const double begin = nck_fabs(seg->start[NCK_AXIS_X] - spin->x);
    const double end = nck_fabs(seg->end[NCK_AXIS_X] - spin->x);
    if (nck_max(begin, end) <= flat) return PACE_MOST;
    const double least = nck_spin_follow(spin, nck_max(flat, nck_min(begin, end)), a);
    for (int n = 0; n < NCK_OPTIMAL_PLACES; n++) {
        const nck_num tangent = tangent_at(&path, NCK_AXIS_X, place_at(n));
        slowness = nck_max(slowness, nck_fabs((double)(path.per * tangent)) / least);
    }
    return 1.0 / (slowness * slowness);
}

// What stands about a node: b is a mean of its own and both neighbours', so what holds within one
// and a half intervals of it keeps feeds between nodes, too.
typedef struct nearby {
    const nck_num *along[NCK_OPTIMAL_LOOKS]; // of the intervals about it, NULL: none
    double vv;     // the least that is wanted [(mm/s)²]
    double pace;   // the most b with which the spindle follows
} nearby_t;

enum {
    NEAR_FIRST = 1, // of these intervals, the first and
    NEAR_LAST = 4,  // the last that its b counts in; the node is the begin of the one
    NEAR_NODE = 3,  // in the middle
    NEAR_NODES = 7, // at their ends, itself the fourth; at the outer two b counts nothing
    MIDDLE = 2      // of an interval's places
};

// Of the pieces of the plan's window: whether more of the path is known hangs on time.
static void look_around(nck_optimal_t *self, const nck_pieces_t *pieces, uint32_t number,
                        nearby_t *around_out) {
    const nck_optimal_pace_t *const work = nck_optimal_work(self);
    around_out->vv = PACE_MOST * PACE_MOST;
    around_out->pace = PACE_MOST;
    for (uint32_t n = 0; n < NCK_OPTIMAL_LOOKS; n++) {
        const uint32_t at = number + n - NEAR_NODE;
        const nck_node_t *const piece = nck_plan_piece(pieces, at);
        around_out->along[n] = (const nck_num *)0;
        if (at - work->first >= work->n || !piece || !(piece->length > 0.0)) continue;
        const nck_seg_t *const seg = nck_link_seg(self->link, piece->seg);
        if (seg->kind != NCK_SEG_SPLINE) continue;
        around_out->along[n] = look_along(self, piece, at);
        if (n < NEAR_FIRST || n > NEAR_LAST) continue;
        around_out->vv = nck_min(around_out->vv, nck_optimal_wanted(self, piece));
        around_out->pace = nck_min(around_out->pace, spin_pace(self, seg));
    }
}

// About |p′|² at the end of an interval, the begin of the next one: no less than a quarter of what
// it is in the halves beside it. 0: there is neither.
static nck_num along_node(const nck_num *before, const nck_num *behind) {
    nck_num here = 0;
    nck_num beside = 0;
    for (int n = 0; n <= MIDDLE; n++) {
        if (before) beside = nck_num_max(beside, before[NCK_OPTIMAL_PLACES - 1 - n]);
        if (behind) beside = nck_num_max(beside, behind[n]);
    }
    if (before) here = before[NCK_OPTIMAL_PLACES - 1];
    if (behind) here = nck_num_max(here, behind[0]);
    return nck_num_max(here, beside / 4);
}

// What b would be at a place of an interval if it were `pace` at the nodes, from the one before its
// begin on: a parabola about either end.
static nck_num pace_between(const nck_num *pace, int place) {
    const int is_late = place > MIDDLE;
    const nck_num t = is_late ? place_at(place) - 1 : place_at(place);
    const nck_num *const node = is_late ? pace + 1 : pace;
    const nck_num half = (nck_num)0.5;
    return half * (half - t) * (half - t) * node[0] + ((nck_num)0.75 - t * t) * node[1]
           + half * (half + t) * (half + t) * node[2];
}

// The most |p′|²·b in an interval, from a place to another, if b is `pace` at nodes. Between three
// places it is above them by an eighth of its second difference.
static nck_num most_along(const nck_num *along, const nck_num *pace, int from, int to) {
    nck_num product[NCK_OPTIMAL_PLACES];
    nck_num most = 0;
    nck_num bend = 0;
    for (int n = from; n <= to; n++) {
        product[n] = along[n] * pace_between(pace, n);
        most = nck_num_max(most, product[n]);
        if (n < from + 2) continue;
        const nck_num second = product[n] - 2 * product[n - 1] + product[n - 2];
        bend = nck_num_max(bend, NCK_NUM_ABS(second));
    }
    return most + bend / 8;
}

// What keeps feeds about a node, as |p′|² there: with b_k ≤ F²/along_k at all nodes, |p′|²·b ≤ F²
// everywhere. For any w_k > 0,
//     along_k = w_k · max |p′|² Σ b-spline_i/w_i       over one and a half intervals of k
// does: then Σ b_i·b-spline_i ≤ F² Σ b-spline_i/w_i · min 1/(|p′|² Σ b-spline_i/w_i) ≤ F²/|p′|².
static nck_num along_of(const nearby_t *around) {
    nck_num pace[NEAR_NODES];
    nck_num most = 0;
    const nck_num here = along_node(around->along[NEAR_NODE - 1], around->along[NEAR_NODE]);
    if (!(here > 0)) return 0;
    for (int n = 0; n < NEAR_NODES; n++) pace[n] = 1 / here;
    for (int n = 1; n < NEAR_NODES - 1; n++) {
        const nck_num at = along_node(around->along[n - 1], around->along[n]);
        if (at > 0) pace[n] = 1 / at;
    }
    for (int n = NEAR_FIRST; n <= NEAR_LAST; n++) {
        const int from = n == NEAR_FIRST ? MIDDLE : 0;
        const int to = n == NEAR_LAST ? MIDDLE : NCK_OPTIMAL_PLACES - 1;
        if (!around->along[n]) continue;
        most = nck_num_max(most, most_along(around->along[n], pace + n - 1, from, to));
    }
    return here * most;
}

// Which limit stands behind the speed that is wanted in a piece.
static uint8_t wish_of(const nck_optimal_t *self, const nck_node_t *piece) {
    const int is_lowered = nck_optimal_wanted(self, piece) < piece->vv_piece;
    return is_lowered ? (uint8_t)NCK_LIMIT_FEED : piece->limit_piece;
}

// Cap of b at a node where the path's speed is at most v: by it and by every axis. Of a rapid every
// axis' speed is its own.
static double cap_of(const nck_optimal_t *self, const nck_num *first, const nearby_t *around,
                     uint8_t *limit) {
    const double along = (double)along_of(around);
    double cap = PACE_MOST;
    int slowest = 0;
    for (int x = 0; x < self->terms->axes; x++) {
        const double v = SHARE_SPEED * self->terms->machine->axis[x].v_max;
        const double pp = (double)first[x] * (double)first[x];
        if (!self->terms->machine->axis[x].present || pp * cap <= v * v) continue;
        cap = v * v / pp;
        slowest = x;
    }
    if (around->pace < cap && along * around->pace <= around->vv) {
        *limit = NCK_LIMIT_SPINDLE;
        return around->pace;
    }
    if (along * cap > around->vv) return around->vv / along;
    if (*limit != NCK_LIMIT_RAPID) *limit = (uint8_t)(NCK_LIMIT_AXIS_V + slowest);
    return cap;
}

// The most pace at a node that the path's acceleration has built up since the node before.
static double reached(nck_optimal_t *self, uint32_t k) {
    const nck_optimal_pace_t *const work = nck_optimal_work(self);
    const double before = (double)work->along[k - 1];
    const double here = (double)work->along[k];
    const double way = 0.5 * self->terms->knot_s * (nck_sqrt(before) + nck_sqrt(here));
    const double vv = before * work->b[k - 1] + 2.0 * self->terms->machine->path.a_max * way;
    return here * PACE_MOST > vv ? vv / here : PACE_MOST;
}

// Whether the last plan's pace at a node is one to begin with: not that of the brake for its
// window's end, nor for a rest, from which no end is found in time.
static int is_near(const nck_optimal_t *self, const nck_optimal_pace_t *now, uint32_t at) {
    return nck_optimal_goes_on(self) && at <= now->top;
}

// b so many intervals before the end of the brake for a window's end: b′ is twice the acceleration
// by the clock. Of `most` at most.
static double brake_guess(const nck_optimal_t *self, uint32_t off, double most,
                          const nck_num *first) {
    const double gained = 2.0 * self->terms->knot_s * NCK_START * (double)off;
    for (int x = 0; x < self->terms->axes; x++) {
        const double a = self->terms->machine->axis[x].a_max;
        const double speed = nck_fabs((double)first[x]);
        if (speed * most > gained * a) most = gained * a / speed;
    }
    return most;
}

// A pace to begin with, which may break limits by far: the last plan's, as far as that is near; the
// clock's own behind it, with a brake for this window's end. first: p′ there.
static double pace_guess(nck_optimal_t *self, uint32_t k, double most, const nck_num *first) {
    const nck_optimal_pace_t *const work = nck_optimal_work(self);
    const nck_optimal_pace_t *const now = nck_optimal_now(self);
    const uint32_t at = work->first - now->first + k;
    if (nck_optimal_goes_on(self) && k < NCK_OPTIMAL_GIVEN) return now->b[at];
    if (k == work->n && !work->ends) return 0.0;
    double b = NCK_START * nck_min(most, 1.0);
    if (k > 0) b = nck_min(b, reached(self, k));
    if (!work->ends) b = brake_guess(self, work->n - k - 1, b, first);
    if (!work->ends && k + 1 == work->n) b = NCK_START * most;
    if (is_near(self, now, at)) b = NCK_START * now->b[at];
    if (nck_optimal_slows(self)) b = now->b[at];
    return nck_max(b, PACE_LEAST);
}

// 1 if the path itself rests at a node: its clock goes on where its place does not.
static int is_rest(const nck_optimal_t *self, const nck_num *first) {
    for (int x = 0; x < self->terms->axes; x++) {
        if (!(nck_fabs((double)first[x]) < REST_LEAST)) return 0;
    }
    return 1;
}

// The most b, of `most`, that leaves an axis or the path, as fast by the clock, no more than a step
// of acceleration.
static double least_of(const nck_optimal_t *self, double speed, double step, double most) {
    const double room = 2.0 * self->terms->knot_s * SHARE_ASKED * step;
    return speed * most > room ? room / speed : most;
}

// Cap of b one node before a window's end, where the path goes on but the plan rests: what is left
// of its acceleration there, b/2τ by what |p′| is at the end, is no more than an axis' and gone
// within a period.
static nck_num cap_at_end(const nck_optimal_t *self, const nck_seg_t *seg, nck_num cap) {
    const nck_machine_t *const machine = self->terms->machine;
    nck_num first[NCK_AXIS_MAX];
    nck_num second[NCK_AXIS_MAX];
    double most = (double)cap;
    double square = 0.0;
    derive(self, seg, 1, first, second);
    for (int x = 0; x < self->terms->axes; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        const double step = nck_min(axis->j_max * machine->period_s, axis->a_max);
        if (axis->present) most = least_of(self, nck_fabs((double)first[x]), step, most);
        square += (double)first[x] * (double)first[x];
    }
    const double step = nck_min(machine->path.j_max * machine->period_s, machine->path.a_max);
    return (nck_num)least_of(self, nck_sqrt(square), step, most);
}

void nck_optimal_fill(nck_optimal_t *self, const nck_pieces_t *pieces, uint32_t k) {
    if (!NCK_HAS_OPTIMAL) return;
    nck_optimal_pace_t *const work = nck_optimal_work(self);
    const int at_end = k == work->n;
    const nck_node_t *const piece = nck_plan_there(pieces, work->first + k - (uint32_t)at_end);
    const nck_seg_t *const seg = nck_link_seg(self->link, piece->seg);
    nck_num first[NCK_AXIS_MAX];
    nck_num second[NCK_AXIS_MAX];
    nck_num cap_and_b[2];
    nearby_t around;
    look_around(self, pieces, work->first + k, &around);
    self->held_by[k] = wish_of(self, piece);
    derive(self, seg, at_end, first, second);
    if (k == 0) self->at_rest = (uint32_t)is_rest(self, first);
    work->along[k] = 0.0f;
    for (int x = 0; x < self->terms->axes; x++) {
        work->along[k] += (float)first[x] * (float)first[x];
    }
    if (nck_optimal_slows(self)) around.vv = nck_max(around.vv, nck_optimal_floor(self, k));
    cap_and_b[0] = (nck_num)cap_of(self, first, &around, &self->held_by[k]);
    if (k + 1 == work->n && !work->ends) {
        // It is firm: a lowered one would leave no start.
        const double least = nck_optimal_slows(self) ? pace_guess(self, k, 0.0, first) : 0.0;
        cap_and_b[0] = nck_num_max(cap_and_b[0], (nck_num)least);
        cap_and_b[0] = cap_at_end(self, seg, cap_and_b[0]);
    }
    cap_and_b[1] = (nck_num)pace_guess(self, k, (double)cap_and_b[0], first);
    work->b[k] = (double)cap_and_b[1];
    nck_motion_node(self->motion, (int)k, first, second, cap_and_b);
}

// What an axis may do; one that the machine lacks never moves: any limit will do.
void nck_optimal_set_limits(nck_optimal_t *self, nck_motion_wish_t *asked) {
    if (!NCK_HAS_OPTIMAL) return;
    const nck_machine_t *const machine = self->terms->machine;
    self->j_least = machine->path.j_max;
    if (self->terms->limits_path) {
        asked->along[0] = SHARE_ASKED * machine->path.a_max;
        asked->along[1] = SHARE_ASKED * machine->path.j_max;
    }
    for (int x = 0; x < self->terms->axes; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        asked->a[x] = axis->present ? SHARE_ASKED * axis->a_max : 1.0;
        asked->j[x] = axis->present ? SHARE_ASKED * axis->j_max : 1.0;
        asked->v[x] = axis->present ? SHARE_SPEED * axis->v_max : 0.0;
        if (axis->present) self->j_least = nck_min(self->j_least, asked->j[x]);
    }
}
