// SPDX-License-Identifier: MIT
// Inside room 5: intervals of a clocked path become the nodes of a motion.
#include "nck/prep/5_slope/optimal_nodes.h"

#include <string.h> // memset

#include "nck/base/path.h" // nck_path_ways nck_path_way_at
#include "nck/base/real.h" // nck_fabs nck_min nck_max nck_sqrt nck_num
#include "nck/prep/5_slope/optimal_pace.h" // nck_optimal_work …

// Of the clock's pace, what a plan begins to be sought with; and of the last plan's, as far as
// there is one: a little inside its limits.
#define GUESS 0.6
#define AGAIN 0.98
// Nodes over which the guess brakes for a window's end.
#define BRAKE_NODES 40.0
#define PACE_LEAST 1e-8
// Parts of an interval, at whose ends the path's speed over the clock is looked at: its square is
// of the fourth degree there.
enum { LOOKS = 4 };
// Slower than that by its clock the path rests [mm/s].
#define REST_LEAST 1e-6
#define PACE_MOST 1e6
// Of an axis' limits, what a plan is asked to keep to; what passes its rows (0.002 of time is what
// 0.6 % of jerk cost) stays below the limit.
#define SHARE_ASKED 0.996
// The same of speed, which it passes by less.
#define SHARE_SPEED 0.999

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

// The most |p′|² in either half of an interval. It is looked for once a plan: three nodes ask.
static const nck_num *look_along(nck_optimal_t *self, const nck_node_t *piece, uint32_t number) {
    nck_optimal_look_t *const look = &self->looked[number % NCK_OPTIMAL_LOOKS];
    if (look->known && look->number == number) return look->along;
    const nck_seg_t *const seg = nck_link_seg(self->link, piece->seg);
    hodograph_t path;
    set_hodograph(self, seg, &path);
    look->known = 1;
    look->number = number;
    look->along[0] = 0;
    look->along[1] = 0;
    for (int n = 0; n <= LOOKS; n++) {
        const nck_num f = (nck_num)n / (nck_num)LOOKS;
        const nck_num along = along_at(self, &path, (nck_num)seg->feed_scale, f);
        if (2 * n <= LOOKS) look->along[0] = nck_num_max(look->along[0], along);
        if (2 * n >= LOOKS) look->along[1] = nck_num_max(look->along[1], along);
    }
    return look->along;
}

// What stands about a node: within half an interval of it b is a mean of its own and both
// neighbours', so what holds at all three within one and a half keeps feeds between nodes, too.
typedef struct nearby {
    nck_num along; // the most |p′|² [(mm/s)²]
    double vv;     // the least that is wanted [(mm/s)²]
} nearby_t;

// … an interval of it, from one half to another.
static void look_at(nck_optimal_t *self, const nck_node_t *piece, uint32_t number,
                    const int span[2], nearby_t *around) {
    const nck_num *const along = look_along(self, piece, number);
    around->vv = nck_min(around->vv, nck_optimal_wanted(self, piece));
    for (int n = span[0]; n <= span[1]; n++) around->along = nck_num_max(around->along, along[n]);
}

// 1 if a plan looks at a piece: those of its window, and those before it that it goes on from.
// Whether more of the path is known hangs on time.
static int is_in_sight(nck_optimal_t *self, uint32_t number) {
    const nck_optimal_pace_t *const work = nck_optimal_work(self);
    const int32_t at = (int32_t)(number - work->first);
    return at < (int32_t)work->n && (at >= 0 || nck_optimal_goes_on(self));
}

// Begin of the path's motion or of the window, and its end, end what is looked at.
static void look_around(nck_optimal_t *self, const nck_pieces_t *pieces, uint32_t number,
                        nearby_t *around_out) {
    static const int span[4][2] = {{1, 1}, {0, 1}, {0, 1}, {0, 0}};
    around_out->along = 0;
    around_out->vv = PACE_MOST * PACE_MOST;
    for (uint32_t n = 0; n < 4; n++) {
        const uint32_t at = number + n - 2;
        const nck_node_t *const piece = nck_plan_piece(pieces, at);
        const int is_of_run = is_in_sight(self, at) && piece && piece->length > 0.0
                              && nck_link_seg(self->link, piece->seg)->keeps == NCK_KEEP_CLOCK;
        if (is_of_run) look_at(self, piece, at, span[n], around_out);
    }
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
    double cap = PACE_MOST;
    int slowest = 0;
    for (int x = 0; x < self->terms->axes; x++) {
        const double v = SHARE_SPEED * self->terms->machine->axis[x].v_max;
        const double pp = (double)first[x] * (double)first[x];
        if (!self->terms->machine->axis[x].present || pp * cap <= v * v) continue;
        cap = v * v / pp;
        slowest = x;
    }
    if ((double)around->along * cap > around->vv) return around->vv / (double)around->along;
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

// A pace to begin with, which may break limits by far: the last plan's, as far as that is not the
// brake for its window's end; the clock's own behind it, with a brake for this window's end.
static double pace_guess(nck_optimal_t *self, uint32_t k, double most) {
    const nck_optimal_pace_t *const work = nck_optimal_work(self);
    const nck_optimal_pace_t *const now = nck_optimal_now(self);
    const uint32_t at = work->first - now->first + k;
    if (self->again > 0) return work->b[k];
    if (nck_optimal_goes_on(self) && k < NCK_OPTIMAL_GIVEN) return now->b[at];
    if (k == work->n && !work->ends) return 0.0;
    const double x = (double)(work->n - k) / BRAKE_NODES;
    double b = GUESS * nck_min(most, 1.0);
    if (k > 0) b = nck_min(b, reached(self, k));
    if (!work->ends && x < 1.0) b *= x * nck_sqrt(nck_sqrt(x));
    if (nck_optimal_goes_on(self) && at <= now->top) b = AGAIN * now->b[at];
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
    if (nck_optimal_slows(self)) around.vv = nck_max(around.vv, self->vv_floor);
    cap_and_b[0] = (nck_num)cap_of(self, first, &around, &self->held_by[k]);
    if (k + 1 == work->n && !work->ends) {
        cap_and_b[0] = cap_at_end(self, seg, cap_and_b[0]);
    }
    cap_and_b[1] = (nck_num)pace_guess(self, k, (double)cap_and_b[0]);
    work->b[k] = (double)cap_and_b[1];
    nck_motion_node(&self->motion, (int)k, first, second, cap_and_b);
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
