// SPDX-License-Identifier: MIT
// Room 5: where the path leaves the soft limits, and how long before it has to brake.
#include "nck/prep/5_slope/travel.h"

#include <string.h> // memset

#include "nck/base/budget.h"        // NCK_UNLIMITED
#include "nck/base/fence.h"         // nck_fence_store
#include "nck/base/path.h"          // nck_path_tangent nck_path_share
#include "nck/base/path_math.h"     // nck_path_point
#include "nck/base/real.h"          // nck_min nck_max nck_sqrt
#include "nck/prep/5_slope/brake.h" // NCK_BRAKE_SHARE

enum { POINTS = 32 }; // of the path in one step
// Bends that leave less than this share of a take some of a brake's, too: its way gets a margin.
#define BENT 0.25
#define BENT_MARGIN 1.3

// Between two points of a curve this far apart it strays by half of that, which is kept clear [mm].
#define STEP_LEAST 0.001
// Periods from the end of the final cells until a brake begins, on a processor that makes a plan in
// a few of them; a plan of the slopes that limit jerk is put off where it takes longer.
#define HEARD_PERIODS 10.0
#define HEARD_PERIODS_JERK 30.0
// A brake has at least this share of the limits: reach and ladder keep off them in turn.
#define BRAKE_LEAST (NCK_BRAKE_SHARE * NCK_BRAKE_SHARE)

void nck_travel_init(nck_travel_t *self) {
    memset(self, 0, sizeof *self);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        self->least[x] = -NCK_UNLIMITED;
        self->most[x] = NCK_UNLIMITED;
    }
}

void nck_travel_begin(nck_travel_t *self) {
    self->known = 0;
    self->leaves = 0;
    self->asked = -1.0;
    nck_fence_store(&self->stops, 0);
}

void nck_travel_set(nck_travel_t *self, int axis, double least, double most) {
    self->set = 1;
    self->least[axis] = least;
    self->most[axis] = most;
    nck_travel_begin(self);
}

// ---- where the path leaves

// How far the nearest limit is; negative outside.
static double room_at(const nck_travel_t *self, const double *point) {
    double room = NCK_UNLIMITED;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        room = nck_min(room, nck_min(self->most[x] - point[x], point[x] - self->least[x]));
    }
    return room;
}

// Where a straight line leaves behind a point inside; NCK_UNLIMITED if it does not.
static double leave_line(const nck_travel_t *self, const nck_seg_t *seg, const double *point) {
    double share = NCK_UNLIMITED;
    if (room_at(self, seg->end) >= 0.0) return NCK_UNLIMITED;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double way = seg->end[x] - point[x];
        const double left = way > 0.0 ? self->most[x] - point[x] : point[x] - self->least[x];
        if (nck_fabs(way) > left) share = nck_min(share, left > 0.0 ? left / nck_fabs(way) : 0.0);
    }
    return self->s + share * (seg->length - self->s);
}

static int is_clocked(const nck_seg_t *seg) {
    return NCK_HAS_OPTIMAL && seg->kind == NCK_SEG_SPLINE;
}

// How far along the path a place is [path mm]: a clocked path's coordinate goes by time.
static double along(const nck_seg_t *seg, double s) {
    double speed = 0.0;
    if (!is_clocked(seg)) return seg->s_begin + s;
    return seg->s_begin + seg->length * nck_path_share(seg, s, &speed);
}

static void found(nck_travel_t *self, const nck_seg_t *seg, double s) {
    self->leaves = 1;
    self->exit = along(seg, s);
}

// The share of a way to a limit for which s may go on along a spline: it has the slopes between its
// points.
static double slower(const nck_seg_t *seg) {
    double most = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double b1 = seg->shape.inner[0][x];
        const double b2 = seg->shape.inner[1][x];
        const double ends = nck_max(nck_fabs(b1 - seg->start[x]), nck_fabs(seg->end[x] - b2));
        most = nck_max(most, nck_max(ends, nck_fabs(b2 - b1)));
    }
    return seg->length / nck_max(3.0 * most, seg->length);
}

static void next_seg(nck_travel_t *self) {
    self->seq++;
    self->s = 0.0;
}

// 1 if a spline's hull is inside, and so all of it.
static int hull_is_inside(const nck_travel_t *self, const nck_seg_t *seg) {
    const double ends = nck_min(room_at(self, seg->start), room_at(self, seg->end));
    const double first = room_at(self, seg->shape.inner[0]);
    const double last = room_at(self, seg->shape.inner[1]);
    return nck_min(ends, nck_min(first, last)) > STEP_LEAST;
}

// As far as the nearest limit is, a share of it where coordinates change faster than s, the path
// stays inside.
static void look_at(nck_travel_t *self, const nck_seg_t *seg) {
    double point[NCK_AXIS_MAX];
    nck_path_point(seg, self->s, point);
    const int straight = seg->kind == NCK_SEG_LINE;
    const int spline = is_clocked(seg);
    const double room = room_at(self, point) - (straight ? 0.0 : STEP_LEAST / 2.0);
    const double leaves = straight ? leave_line(self, seg, point) : NCK_UNLIMITED;
    const double step = nck_max(spline ? slower(seg) * room : room, STEP_LEAST);
    if (room < 0.0) found(self, seg, self->s);
    else if (leaves < NCK_UNLIMITED) found(self, seg, leaves);
    else if (straight || self->s >= seg->length) next_seg(self);
    else if (spline && hull_is_inside(self, seg)) next_seg(self);
    else self->s = nck_min(seg->length, self->s + step);
}

static void look_further(nck_travel_t *self, const nck_link_t *link) {
    for (int n = 0; n < POINTS && !self->leaves && self->seq != link->seg_head; n++) {
        const nck_seg_t *const seg = nck_link_seg(link, self->seq);
        if (seg->kind < NCK_SEG_DWELL) look_at(self, seg);
        else next_seg(self);
    }
}

// ---- the front

// What is final ends here; the rest of the path can still be planned otherwise.
typedef struct front {
    uint32_t seq;
    double s;  // in the seg [path mm]
    double v;  // [path mm/s]
    double a;  // at the end of the cell before [path mm/s²]
} front_t;

// At rest: in the oldest piece that is needed, at the end of the last cell if that ends within.
static front_t rest_of(const nck_link_t *link, const nck_pieces_t *pieces, const nck_cell_t *last) {
    const nck_node_t *const piece = nck_plan_piece(pieces, pieces->head);
    const front_t behind_all = {nck_link_finished(link), 0.0, 0.0, 0.0};
    if (!piece) return behind_all;
    const int within = last && last->seg == piece->seg && last->span == 0 && !last->last;
    const front_t rest = {piece->seg, within ? last->s + last->length : piece->s, 0.0, 0.0};
    return rest;
}

// What every axis can take anywhere along a clocked path: its pieces know nothing of that.
static double least_of(const nck_terms_t *terms, int of_jerk) {
    double least = of_jerk ? terms->machine->path.j_max : terms->machine->path.a_max;
    for (int x = 0; x < terms->axes; x++) {
        const nck_axis_t *const axis = &terms->machine->axis[x];
        if (axis->present) least = nck_min(least, of_jerk ? axis->j_max : axis->a_max);
    }
    return least;
}

// A clocked path's front by its length. A brake there has to wait for what bends take: as if speed
// rose with all there is.
static front_t by_length(const nck_terms_t *terms, const nck_seg_t *seg, const front_t *front) {
    double tangent[NCK_AXIS_MAX];
    double sum = 0.0;
    nck_path_tangent(seg, front->s, tangent);
    for (int x = 0; x < NCK_AXIS_MAX; x++) sum += tangent[x] * tangent[x];
    const front_t there = {front->seq, front->s, front->v * nck_sqrt(sum),
                           least_of(terms, 0)};
    return there;
}

static front_t front_of(const nck_terms_t *terms, const nck_link_t *link,
                        const nck_pieces_t *pieces) {
    int entered = 0;
    uint32_t count = 0;
    const uint32_t end = nck_link_end(link, &entered);
    if (entered) return rest_of(link, pieces, nck_link_tail_end(link, &count));
    const nck_cell_t *const cell = nck_link_tail_cell(link, end);
    const nck_cell_t *const before = nck_link_tail_cell(link, (end - 1) & NCK_LINK_COUNT_MASK);
    if (!cell) return rest_of(link, pieces, before);
    const double a = before ? before->a + before->j * before->duration : 0.0;
    const front_t front = {cell->seg, cell->s, cell->v, a};
    const nck_seg_t *const seg = nck_link_seg(link, cell->seg);
    return is_clocked(seg) ? by_length(terms, seg, &front) : front;
}

// ---- how long before

// The weakest limits of what lies before the exit, and the jerk at the front.
typedef struct weakest {
    double a, j, v_cap;
    double j_here;
    double margin; // of the way: where bends take most of a, they take some of the brake's too
} weakest_t;

// … before any piece is looked at.
static weakest_t strongest(const nck_terms_t *terms) {
    weakest_t limits = {NCK_UNLIMITED, NCK_UNLIMITED, 0.0, 0.0, 1.0};
    if (!NCK_HAS_OPTIMAL || !(terms->knot_s > 0.0)) return limits;
    limits.a = BRAKE_LEAST * least_of(terms, 0);
    limits.j = BRAKE_LEAST * least_of(terms, 1);
    return limits;
}

static weakest_t weakest_before(const nck_travel_t *self, const nck_pieces_t *pieces,
                                const nck_terms_t *terms) {
    weakest_t limits = strongest(terms);
    for (uint32_t i = 0; i < pieces->fill; i++) {
        const nck_node_t *const piece = nck_plan_piece(pieces, pieces->head + i);
        if (piece->seg > self->seq && piece->seg - self->seq < NCK_SEG_MAX) break;
        if (!(piece->length > 0.0)) continue;
        limits.a = nck_min(limits.a, BRAKE_LEAST * nck_min(piece->a, piece->a_over));
        limits.j = nck_min(limits.j, BRAKE_LEAST * nck_min(piece->j, piece->j_over));
        limits.v_cap = nck_max(limits.v_cap, nck_sqrt(piece->vv_over));
        if (!(limits.j_here > 0.0)) limits.j_here = limits.j;
    }
    if (!terms->limits_jerk) limits.j = NCK_UNLIMITED;
    if (!terms->limits_jerk || !(limits.j_here > 0.0)) limits.j_here = NCK_UNLIMITED;
    if (limits.a < BENT * terms->machine->path.a_max) limits.margin = BENT_MARGIN;
    return limits;
}

// Braking from v and a: the acceleration goes first, as fast as the jerk at the front lets it; then
// comes and goes the deceleration.   v/a ≥ a/j:  v/2·(v/a + a/j),  else  v·√(v/j)
static double braking(const weakest_t *limits, double v, double a) {
    const double rising = nck_max(a, 0.0) / limits->j_here;
    const double most = nck_min(v + 0.5 * nck_max(a, 0.0) * rising, nck_max(v, limits->v_cap));
    const double ramp = limits->a / limits->j;
    const int full = most >= limits->a * ramp;
    return most * rising
           + (full ? 0.5 * most * (most / limits->a + ramp) : most * nck_sqrt(most / limits->j));
}

// Whether the exit is no farther than the way to rest from a front at `begin`. Until the brake is
// heard speed may rise.
static int is_near(const nck_travel_t *self, const front_t *front, double begin,
                   const weakest_t *limits, double heard) {
    const double v = nck_max(front->v, nck_min(front->v + limits->a * heard, limits->v_cap));
    const double way = v * heard + braking(limits, v, front->a);
    return self->exit - begin <= limits->margin * way;
}

int nck_travel_step(nck_travel_t *self, const nck_terms_t *terms, const nck_link_t *link,
                    const nck_pieces_t *pieces) {
    const front_t front = front_of(terms, link, pieces);
    if (!self->known || (int32_t)(front.seq - self->seq) > 0) {
        self->known = 1;
        self->seq = front.seq;
        self->s = front.s;
    }
    look_further(self, link);
    if (!self->leaves || self->stops) return (int)self->stops;
    const double begin = front.seq == link->seg_head
                             ? self->exit
                             : along(nck_link_seg(link, front.seq), front.s);
    const uint32_t end = pieces->head + pieces->fill;
    if (self->asked == begin && self->asked_end == end) return 0;
    self->asked = begin;
    self->asked_end = end;
    const weakest_t limits = weakest_before(self, pieces, terms);
    const double periods = terms->limits_jerk ? HEARD_PERIODS_JERK : HEARD_PERIODS;
    const int near = is_near(self, &front, begin, &limits, periods * terms->machine->period_s);
    nck_fence_store(&self->stops, (uint32_t)near);
    return near;
}
