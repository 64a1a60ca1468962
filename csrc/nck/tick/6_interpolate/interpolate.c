// SPDX-License-Identifier: MIT
// Room 6, interpolate: the tick.
#include "nck/tick/6_interpolate/interpolate.h"

#include <assert.h> // assert
#include <string.h> // memset

#include "nck/base/cell_math.h" // nck_cell_way
#include "nck/base/fence.h"     // nck_fence_load nck_fence_store
#include "nck/base/path_math.h" // nck_path_point
#include "nck/base/real.h"      // nck_floor
#include "nck/base/spin_math.h" // nck_spin_rpm

// Nothing in a build where no motions overlap.
enum { OVERLAPS = NCK_HAS_OVERLAP, RIDES = OVERLAPS * NCK_STOP_RIDES };

void nck_interpolate_init(nck_interpolate_t *self, const nck_terms_t *terms, nck_link_t *link) {
    const nck_machine_t *const machine = terms->machine;
    memset(self, 0, sizeof *self);
    self->machine = machine;
    self->link = link;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        self->pose.axis[x] = (double)machine->start_nm[x] / nck_machine_counts(machine, x);
    }
    self->pose.feed_scale = 1.0;
    self->cell.stop = NCK_STOP_REST;
    self->rests = 1;
    self->filter.taps = terms->taps;
    self->rider.filter.taps = terms->taps;
}

static const nck_seg_t *seg_at(const nck_interpolate_t *self, uint32_t seq) {
    return nck_link_seg(self->link, seq);
}

// From the start of one seg to that of a later one.
static double length_between(const nck_interpolate_t *self, uint32_t from, uint32_t to) {
    double length = 0.0;
    for (uint32_t seq = from; seq != to; seq++) length += seg_at(self, seq)->length;
    return length;
}

// Segs before this one are done with, unless what rides is in one of them.
static void finish_before(nck_interpolate_t *self, uint32_t seq) {
    if (!self->rider.on) nck_link_seg_finish(self->link, seq);
}

// The first cell behind a rest.
static void set_off(nck_interpolate_t *self) {
    self->rests = 0;
    self->filter.seg = self->cell.seg;
    self->filter.ahead = 0.0;
    for (uint32_t n = 0; n < self->filter.taps; n++) {
        self->filter.s[n] = self->cell.s;
        self->filter.v[n] = 0.0;
    }
    finish_before(self, self->filter.seg);
}

// The cell rides from here on: the motion behind its rest begins beside it. It is not the first
// one behind a rest.
static void part_ways(nck_interpolate_t *self) {
    int from_tail = 0;
    self->rider.on = 1;
    self->rider.cell = self->cell;
    self->rider.t_cell = self->t_cell;
    self->rider.filter = self->filter;
    nck_link_ride(self->link);
    (void)nck_link_take(self->link, &self->cell, &from_tail);
    set_off(self);
}

// The next cell; if there is none the one before stays.
static inline int next_cell(nck_interpolate_t *self) {
    const uint32_t seg_before = self->cell.seg;
    int from_tail = 0;
    if (nck_link_take(self->link, &self->cell, &from_tail) != NCK_OK) return 0;
    self->from_tail = (uint32_t)from_tail;
    if (self->rests) {
        set_off(self);
    } else if (self->filter.taps > 1) { // else nobody asks, and segs may be many
        self->filter.ahead += length_between(self, seg_before, self->cell.seg);
    }
    return 1;
}

static int fetch(nck_interpolate_t *self) {
    if (!next_cell(self)) return 0;
    nck_fence_store(&self->has_cell, 1);
    return 1;
}

// Stand at s of a seg.
static void place(nck_interpolate_t *self, const nck_seg_t *seg, double s, double v) {
    nck_pose_t *const pose = &self->pose;
    pose->seg = seg->seq;
    pose->line = seg->line;
    pose->block = seg->block;
    pose->kind = seg->kind;
    pose->rapid = seg->rapid;
    pose->limit = self->cell.limit;
    pose->s = seg->s_begin + s;
    pose->left = 0.0;
    pose->v = v;
    pose->feed = seg->feed;
    pose->feed_scale = seg->feed_scale;
    pose->state = self->cell.stop & NCK_STOP_HOLD ? NCK_TICK_HOLD
                  : self->from_tail ? NCK_TICK_STARVED
                  : seg->kind == NCK_SEG_DWELL ? NCK_TICK_DWELL
                  : seg->kind == NCK_SEG_WAIT ? NCK_TICK_WAIT : NCK_TICK_MOVE;
    if (seg->kind < NCK_SEG_DWELL) nck_path_point(seg, s, pose->axis);
    pose->spindle_rpm = nck_spin_rpm(&seg->spin, pose->axis[NCK_AXIS_X]);
}

// The segs from the filter's on that lie behind s; none beyond the seg where the cell ends.
static double walk(const nck_interpolate_t *self, nck_filter_t *filter, const nck_cell_t *cell,
                   double s) {
    const uint32_t last = cell->seg + cell->span;
    while (filter->seg != last && s >= seg_at(self, filter->seg)->length) {
        const double length = seg_at(self, filter->seg)->length;
        s -= length;
        filter->ahead -= length;
        for (uint32_t n = 0; n < filter->taps; n++) filter->s[n] -= length;
        filter->seg++;
    }
    return s;
}

// One more sample; returns the mean over the taps. Summed anew each time: a running sum drifts.
static double take_tap(nck_filter_t *filter, double s, double v, double *v_out) {
    filter->s[filter->at] = s;
    filter->v[filter->at] = v;
    filter->at = filter->at + 1 < filter->taps ? filter->at + 1 : 0;
    double s_sum = 0.0;
    double v_sum = 0.0;
    for (uint32_t n = 0; n < filter->taps; n++) {
        s_sum += filter->s[n];
        v_sum += filter->v[n];
    }
    const double taps = (double)filter->taps;
    *v_out = v_sum / taps;
    return s_sum / taps;
}

// The cells stand at s of the cell's seg: hand out the mean over the taps.
static void pass(nck_interpolate_t *self, double s, double v) {
    nck_filter_t *const filter = &self->filter;
    if (filter->taps == 1) {
        filter->seg = self->cell.seg;
        finish_before(self, filter->seg);
        place(self, seg_at(self, filter->seg), s, v);
        return;
    }
    double v_mean = 0.0;
    const double s_ahead = take_tap(filter, s + filter->ahead, v, &v_mean);
    const double s_mean = walk(self, filter, &self->cell, s_ahead);
    finish_before(self, filter->seg);
    place(self, seg_at(self, filter->seg), s_mean, v_mean);
}

static void leave_cell(nck_interpolate_t *self) {
    self->t_cell += self->cell.duration;
    nck_fence_store(&self->has_cell, 0);
}

// Come to rest at the end of the cell: the count of periods begins anew.
static void land(nck_interpolate_t *self) {
    const nck_cell_t *const cell = &self->cell;
    const uint32_t seq = cell->seg + cell->span;
    const nck_seg_t *const seg = seg_at(self, seq);
    const double s = cell->s + cell->length - length_between(self, cell->seg, seq);
    place(self, seg, cell->last ? seg->length : s, 0.0);
    nck_fence_store(&self->waits, seg->kind == NCK_SEG_WAIT);
    nck_fence_store(&self->resume, 0);
    leave_cell(self);
    nck_link_seg_finish(self->link, cell->last ? seq + 1 : seq);
    if (self->from_tail) nck_link_tail_rest(self->link);
    self->rests = 1;
    self->k = 0;
    self->t_cell = 0.0;
}

static int cuts_thread(const nck_interpolate_t *self) {
    return self->cell.length == 0.0 && seg_at(self, self->cell.seg)->kind >= NCK_SEG_THREAD;
}

// Behind a pass that was stopped nothing can follow: the tick waits, for another program.
static const nck_pose_t *follow_spindle(nck_interpolate_t *self, const nck_seg_t *seg) {
    place(self, seg, 0.0, 0.0);
    const uint32_t state = nck_sync_tick(&self->sync, self->machine, seg, &self->pose);
    const uint8_t found = self->pose.state;
    const int taps = seg->kind == NCK_SEG_TAP;
    if (state != NCK_SYNC_ENDS) return &self->pose;
    land(self);
    if (found != NCK_TICK_HOLD) return &self->pose;
    self->pose.state = found;
    if (taps) self->pose.spindle_rpm = 0.0; // the tool is in the hole
    nck_fence_store(&self->waits, 1);
    return &self->pose;
}

// The cell has come to rest at its end. Its mean does so when every tap is there.
static void settle(nck_interpolate_t *self) {
    nck_filter_t *const filter = &self->filter;
    const int moved = self->cell.length > 0.0;
    if (filter->settle == 0) filter->settle = moved ? filter->taps : 1;
    filter->settle--;
    if (filter->settle == 0) {
        land(self);
    } else {
        pass(self, self->cell.s + self->cell.length, 0.0);
    }
}

// s(t) = s0 + v·t + a·t²/2 + j·t³/6, never beyond the cell; t from the begin of the cell.
static inline double place_at(const nck_cell_t *cell, double t, double *v_out) {
    assert(t >= 0.0);
    *v_out = nck_max(0.0, cell->v + (cell->a + cell->j / 2.0 * t) * t);
    return cell->s + nck_max(0.0, nck_min(nck_cell_way(cell, t), cell->length));
}

static void evaluate(nck_interpolate_t *self, double t) {
    double v = 0.0;
    const double s = place_at(&self->cell, t, &v);
    pass(self, s, v);
}

// Add what is left of the motion that rides: the mean is at s of the filter's seg.
static void add_left(nck_interpolate_t *self, double s, double v) {
    nck_pose_t *const pose = &self->pose;
    const nck_cell_t *const cell = &self->rider.cell;
    const nck_seg_t *const seg = seg_at(self, self->rider.filter.seg);
    const nck_seg_t *const last = seg_at(self, cell->seg + cell->span);
    const double left = (last->s_begin + last->length) - (seg->s_begin + s);
    double at[NCK_AXIS_MAX];
    nck_path_point(seg, s, at);
    for (int x = 0; x < NCK_AXIS_MAX; x++) pose->axis[x] += at[x] - last->end[x];
    pose->s -= left;
    pose->v += v;
    pose->left = left;
}

// What rides is one tick further on. Its mean rests when every tap is there.
static void ride(nck_interpolate_t *self) {
    nck_rider_t *const rider = &self->rider;
    nck_filter_t *const filter = &rider->filter;
    const double t = (double)self->k * self->machine->period_s;
    while (t >= rider->t_cell + rider->cell.duration && filter->settle == 0) {
        if (rider->cell.stop & NCK_STOP_REST) {
            filter->settle = filter->taps;
            break;
        }
        const uint32_t seg_before = rider->cell.seg;
        rider->t_cell += rider->cell.duration;
        if (nck_link_take_rider(self->link, &rider->cell) != NCK_OK) break;
        filter->ahead += length_between(self, seg_before, rider->cell.seg);
    }
    double v = 0.0;
    double s = rider->cell.s + rider->cell.length;
    if (filter->settle == 0) s = place_at(&rider->cell, t - rider->t_cell, &v);
    const double s_ahead = take_tap(filter, s + filter->ahead, v, &v);
    const double s_mean = walk(self, filter, &rider->cell, s_ahead);
    if (filter->settle == 1) {
        rider->on = 0;
        finish_before(self, self->filter.seg);
        return;
    }
    if (filter->settle > 0) filter->settle--;
    add_left(self, s_mean, v);
}

// Nothing to execute: stay. In the middle of the path that is starvation, unless it is held there.
static const nck_pose_t *rest(nck_interpolate_t *self) {
    const int on_path = !self->rests || self->from_tail;
    self->k = 0;
    self->t_cell = 0.0;
    self->pose.v = 0.0;
    self->pose.limit = on_path ? NCK_LIMIT_STARVED : NCK_LIMIT_EXACT_STOP;
    self->pose.state = self->cell.stop & NCK_STOP_HOLD ? NCK_TICK_HOLD
                       : on_path ? NCK_TICK_STARVED : NCK_TICK_IDLE;
    return &self->pose;
}

// The next path begins where the drives stand: at whole counts.
static void settle_on_counts(nck_interpolate_t *self) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double counts = nck_machine_counts(self->machine, x);
        self->pose.axis[x] = nck_floor(self->pose.axis[x] * counts + 0.5) / counts;
    }
}

// Prep wants to begin anew: once nothing is left to execute the link is its own, and what the last
// program left behind is over.
static int yields(nck_interpolate_t *self, uint32_t owner) {
    if (owner == NCK_LINK_PREP) return 1;
    if (!nck_interpolate_is_at_rest(self)) return 0;
    memset(&self->cell, 0, sizeof self->cell);
    self->pose.seg = 0;
    self->pose.line = 0;
    self->pose.block = 0;
    self->pose.s = 0.0;
    settle_on_counts(self);
    self->from_tail = 0;
    self->rests = 1;
    nck_fence_store(&self->waits, 0);
    nck_fence_store(&self->sync.asked, 0);
    nck_fence_store(&self->sync.lost, 0);
    nck_link_yield(self->link);
    return 1;
}

// Whether the link is prep's alone; asked every tick.
static inline int stands_aside(nck_interpolate_t *self) {
    const uint32_t owner = nck_link_owner(self->link);
    if (owner == NCK_LINK_BOTH) return 0;
    return yields(self, owner);
}

// Time begins to count later.
static void rebase(nck_interpolate_t *self) {
    const uint64_t periods = nck_interpolate_rebase(&self->t_cell, self->machine->period_s);
    if (periods == 0) return;
    self->k -= periods;
    self->rider.t_cell -= (double)periods * self->machine->period_s;
}

// No cell follows: stand where the last one ends. A tail ends at rest.
static const nck_pose_t *run_dry(nck_interpolate_t *self) {
    nck_fence_store(&self->has_cell, 0);
    pass(self, self->cell.s + self->cell.length, 0.0);
    if (self->from_tail) nck_link_tail_rest(self->link);
    return rest(self);
}

// At a WAIT until somebody resumes.
static int waits_on(nck_interpolate_t *self) {
    if (!self->waits) return 0;
    if (!nck_fence_load(&self->resume)) return 1;
    nck_fence_store(&self->resume, 0);
    nck_fence_store(&self->waits, 0);
    return 0;
}

// One period on, what rides apart.
static const nck_pose_t *tick(nck_interpolate_t *self) {
    nck_sync_turn(&self->sync, self->machine, self->pose.spindle_rpm);
    if (stands_aside(self)) return rest(self);
    if (waits_on(self)) return &self->pose;
    if (self->filter.settle > 0) {
        settle(self);
        return &self->pose;
    }
    if (!self->has_cell && !fetch(self)) return rest(self);
    if (cuts_thread(self)) return follow_spindle(self, seg_at(self, self->cell.seg));
    const double period = self->machine->period_s;
    self->k++;
    while ((double)self->k * period >= self->t_cell + self->cell.duration) {
        if (self->cell.stop & NCK_STOP_REST) {
            settle(self);
            return &self->pose;
        }
        self->t_cell += self->cell.duration;
        rebase(self);
        if (!next_cell(self)) return run_dry(self);
        if (self->cell.stop & RIDES) part_ways(self);
    }
    evaluate(self, (double)self->k * period - self->t_cell);
    return &self->pose;
}

const nck_pose_t *nck_interpolate_tick(nck_interpolate_t *self) {
    const nck_pose_t *const pose = tick(self);
    if (self->rider.on & OVERLAPS) ride(self);
    return pose;
}

// As if it were executed: a tick that follows sets off from rest, and begins to count here.
nck_status_t nck_interpolate_take(nck_interpolate_t *self, nck_cell_t *cell_out) {
    nck_link_t *const link = self->link;
    if (stands_aside(self) || nck_link_waiting(link) == 0) return NCK_EMPTY;
    nck_link_take_final(link, &self->cell);
    const uint32_t seg = self->cell.seg + self->cell.span;
    nck_link_seg_finish(link, self->cell.last ? seg + 1 : self->cell.seg);
    nck_fence_store(&self->has_cell, 0);
    self->from_tail = 0;
    self->rests = 1;
    self->k = 0;
    self->t_cell = 0.0;
    *cell_out = self->cell;
    return NCK_OK;
}

int nck_interpolate_is_waiting(const nck_interpolate_t *self) {
    return nck_fence_load(&self->waits) && !nck_fence_load(&self->resume);
}

int nck_interpolate_is_at_rest(const nck_interpolate_t *self) {
    if (nck_fence_load(&self->waits)) return 1;
    return nck_link_is_spent(self->link) && !nck_fence_load(&self->has_cell);
}

void nck_interpolate_measure(nck_interpolate_t *self, double turns) {
    nck_sync_measure(&self->sync, turns);
}

void nck_interpolate_stop_thread(nck_interpolate_t *self) {
    nck_fence_store(&self->sync.asked, 1);
}

void nck_interpolate_hold_thread(nck_interpolate_t *self, uint32_t on) {
    nck_fence_store(&self->sync.held, on);
}

void nck_interpolate_resume(nck_interpolate_t *self) { nck_fence_store(&self->resume, 1); }

// Up to 2⁵² periods the quotient is never too large by one, however it is rounded.
uint64_t nck_interpolate_periods(double t, double period) {
    uint64_t k = (uint64_t)(t / period);
    while ((double)k * period < t) k++;
    return k > 0 ? k : 1;
}

uint64_t nck_interpolate_rebase(double *t, double period) {
    const double span = (double)NCK_INTERPOLATE_SPAN * period;
    if (*t < span) return 0;
    const double spans = nck_floor(*t / span);
    *t -= spans * span;
    return (uint64_t)spans * NCK_INTERPOLATE_SPAN;
}

int nck_interpolate_invariants(const nck_interpolate_t *self) {
    const nck_filter_t *const filter = &self->filter;
    const nck_pose_t *const pose = &self->pose;
    double sum = pose->s + pose->left + pose->feed;
    for (int x = 0; x < NCK_AXIS_MAX; x++) sum += pose->axis[x];
    return sum - sum == 0.0 && pose->v >= 0.0 && pose->state <= NCK_TICK_HOLD
           && filter->taps >= 1 && filter->taps <= NCK_FILTER_TAPS && filter->at < filter->taps
           && filter->settle <= filter->taps && self->t_cell >= 0.0
           && self->t_cell < (double)NCK_INTERPOLATE_SPAN * self->machine->period_s
           && (!self->has_cell || self->cell.duration >= 0.0);
}
