// SPDX-License-Identifier: MIT
// Room 6, interpolate: the tick.
#include "nck/tick/6_interpolate/interpolate.h"

#include <assert.h> // assert
#include <stddef.h> // offsetof
#include <string.h> // memset

#include "nck/base/cell_math.h" // nck_cell_way
#include "nck/base/fence.h"     // nck_fence_load nck_fence_store
#include "nck/base/path_math.h" // nck_path_point
#include "nck/base/real.h"      // nck_floor nck_real_of
#include "nck/base/spin_math.h" // nck_spin_rpm
#include "nck/tick/6_interpolate/ease.h" // nck_ease_begin

// A brake follows the plan as long as it is slower by no more than rounding has made it.
#define FOLLOWS_EPSILON 1e-6

// The next path begins where the drives stand: at whole counts, or where prep says.
static void settle_on_counts(nck_interpolate_t *self) {
    const int told = (self->told & 1u) != 0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double counts = nck_machine_counts(self->machine, x);
        const double at = nck_floor(self->pose.axis[x] * counts + 0.5);
        self->pose.axis[x] = (told ? nck_real_of(self->machine->start_nm[x]) : at) / counts;
    }
    self->told += self->told & 1u;
}

void nck_interpolate_init(nck_interpolate_t *self, const nck_terms_t *terms, nck_link_t *link) {
    memset(self, 0, sizeof *self);
    self->machine = terms->machine;
    self->terms = terms;
    self->link = link;
    self->told = 1;
    settle_on_counts(self);
    self->pose.feed_scale = 1.0;
    self->cell.stop = NCK_STOP_REST;
    self->rests = 1;
    self->filter.taps = terms->taps;
}

static const nck_seg_t *seg_at(const nck_interpolate_t *self, uint32_t seq) {
    return nck_link_seg(self->link, seq);
}

// The next cell; if there is none the one before stays.
static inline int next_cell(nck_interpolate_t *self) {
    const uint32_t seg_before = self->cell.seg;
    int from_tail = 0;
    self->a_before = self->rests ? 0.0 : self->cell.a;
    if (nck_link_take(self->link, &self->cell, &from_tail) != NCK_OK) return 0;
    self->from_tail = (uint32_t)from_tail;
    if (self->rests) {
        // The first cell behind a rest.
        if (self->cell.stop & NCK_STOP_SETS_OFF) nck_clock_go_on(&self->clock);
        self->filter.taps = nck_clock_taps(self->terms, seg_at(self, self->cell.seg));
        self->rests = 0;
        if (NCK_HAS_OPTIMAL) nck_stretch_begin(&self->past, self->pose.axis);
        nck_mean_begin(&self->filter, &self->cell);
        nck_link_seg_finish(self->link, self->filter.seg);
    } else if (self->filter.taps > 1) { // else nobody asks, and segs may be many
        self->filter.ahead += nck_mean_length(self->link, seg_before, self->cell.seg);
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
    pose->line = nck_marks_line(&self->link->marks, seg, s, &self->modes);
    pose->block = seg->block;
    pose->kind = seg->kind;
    pose->rapid = seg->rapid;
    pose->limit = self->brakes == NCK_TICK_STARVED ? NCK_LIMIT_STARVED : self->cell.limit;
    pose->s = seg->s_begin + s;
    pose->v = v;
    pose->feed = seg->feed;
    pose->feed_scale = seg->feed_scale;
    const uint32_t clock = self->clock.state;
    const int slowed = clock == NCK_CLOCK_BRAKES || clock == NCK_CLOCK_STANDS;
    pose->state = slowed && self->brakes ? (uint8_t)self->brakes
                  : self->cell.stop & NCK_STOP_HOLD ? NCK_TICK_HOLD
                  : self->from_tail ? NCK_TICK_STARVED
                  : seg->kind == NCK_SEG_DWELL ? NCK_TICK_DWELL
                  : seg->kind == NCK_SEG_WAIT ? NCK_TICK_WAIT : NCK_TICK_MOVE;
    if (seg->kind < NCK_SEG_DWELL) nck_path_point(seg, s, pose->axis);
    pose->spindle_rpm = nck_spin_rpm(&seg->spin, pose->axis[NCK_AXIS_X]);
    if (!nck_look_is_clocked(seg)) return;
    nck_clock_measure(seg, s, pose);
    nck_stretch_pass(&self->past, pose->axis);
}

// The cells stand at s of the cell's seg: hand out the mean over the taps.
static void pass(nck_interpolate_t *self, double s, double v) {
    nck_filter_t *const filter = &self->filter;
    if (filter->taps == 1) {
        filter->seg = self->cell.seg;
        nck_link_seg_finish(self->link, filter->seg);
        place(self, seg_at(self, filter->seg), s, v);
        return;
    }
    double v_mean = 0.0;
    const double s_mean = nck_mean_take(filter, self->link, &self->cell, s, v, &v_mean);
    nck_link_seg_finish(self->link, filter->seg);
    place(self, seg_at(self, filter->seg), s_mean, v_mean);
}

// The tool rests: time counts from here.
static void begin_to_count(nck_interpolate_t *self) {
    self->k = 0;
    self->t_cell = 0.0;
    nck_fence_store(&self->clock.state, NCK_CLOCK_RUNS); // prep reads it
    memset(&self->clock.feels, 0, sizeof self->clock - offsetof(nck_clock_t, feels));
}

// The path's time: that of the periods, less what the clock is late.
static inline double now(const nck_interpolate_t *self) {
    return nck_real_of((int64_t)self->k) * self->machine->period_s - self->clock.late;
}

// Come to rest at the end of the cell: the count of periods begins anew.
static void land(nck_interpolate_t *self) {
    const nck_cell_t *const cell = &self->cell;
    const uint32_t seq = cell->seg + cell->span;
    const nck_seg_t *const seg = seg_at(self, seq);
    const double s = cell->s + cell->length - nck_mean_length(self->link, cell->seg, seq);
    place(self, seg, cell->last ? seg->length : s, 0.0);
    const int waits = seg->kind == NCK_SEG_WAIT;
    nck_fence_store(&self->waits, (uint32_t)waits);
    nck_fence_store(&self->resume, 0);
    self->t_cell += self->cell.duration;
    nck_fence_store(&self->has_cell, 0);
    nck_link_seg_finish(self->link, cell->last && !waits ? seq + 1 : seq);
    if (self->from_tail) nck_link_tail_rest(self->link);
    self->rests = 1;
    begin_to_count(self);
}

static int cuts_thread(const nck_interpolate_t *self) {
    if (!NCK_HAS_THREADS) return 0;
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

static void evaluate(nck_interpolate_t *self, double t) {
    double v = 0.0;
    const double s = nck_mean_place(&self->cell, t, &v);
    pass(self, s, v);
}

// Nothing to execute: stay. In the middle of the path that is starvation, unless it is held there.
static const nck_pose_t *rest(nck_interpolate_t *self) {
    const int on_path = !self->rests || self->from_tail;
    begin_to_count(self);
    if (NCK_HAS_OPTIMAL) nck_stretch_pass(&self->past, self->pose.axis);
    self->pose.v = 0.0;
    self->pose.limit = on_path ? NCK_LIMIT_STARVED : NCK_LIMIT_EXACT_STOP;
    self->pose.state = self->cell.stop & NCK_STOP_HOLD ? NCK_TICK_HOLD
                       : on_path ? NCK_TICK_STARVED : NCK_TICK_IDLE;
    return &self->pose;
}

// Prep wants to begin anew: once nothing is left to execute the link is its own, and what the last
// program left behind is over.
static int yields(nck_interpolate_t *self, uint32_t owner) {
    if (owner == NCK_LINK_PREP) return 1;
    if (!nck_interpolate_is_at_rest(self) && !nck_interpolate_stands(self)) return 0;
    memset(&self->cell, 0, sizeof self->cell);
    memset(&self->clock, 0, sizeof self->clock);
    self->filter.settle = 0;
    nck_fence_store(&self->has_cell, 0);
    self->pose.seg = 0;
    self->pose.line = 0;
    self->pose.block = 0;
    self->pose.s = 0.0;
    settle_on_counts(self);
    self->from_tail = 0;
    self->rests = 1;
    self->halt = NULL;
    nck_fence_store(&self->waits, 0);
    nck_fence_store(&self->awaits, 0);
    nck_fence_store(&self->sync.asked, 0);
    nck_fence_store(&self->sync.lost, 0);
    nck_link_yield(self->link);
    return 1;
}

// Whether the link is prep's alone; asked every tick.
static inline int stands_aside(nck_interpolate_t *self) {
    const uint32_t owner = nck_link_owner(self->link);
    return owner != NCK_LINK_BOTH && yields(self, owner);
}

// No cell follows: stand where the last one ends. A tail ends at rest.
static const nck_pose_t *run_dry(nck_interpolate_t *self) {
    nck_fence_store(&self->has_cell, 0);
    pass(self, self->cell.s + self->cell.length, 0.0);
    if (self->from_tail) nck_link_tail_rest(self->link);
    return rest(self);
}

// At a WAIT until somebody resumes, or what it is for is there. Outputs behind it wait, too.
static int waits_on(nck_interpolate_t *self) {
    if (!self->waits) return 0;
    const int awaits = nck_fence_load(&self->awaits) != 0;
    if (awaits && self->pose.state == NCK_TICK_WAIT) self->pose.state = NCK_TICK_DWELL;
    if (nck_interpolate_is_waiting(self)) return 1;
    nck_link_seg_finish(self->link, self->pose.seg + 1);
    nck_fence_store(&self->resume, 0);
    nck_fence_store(&self->waits, 0);
    return 0;
}

// The cell is over: the next one. 0: there is none, or the path rests.
static inline int cross(nck_interpolate_t *self) {
    if (self->cell.stop & NCK_STOP_REST) {
        settle(self);
        return 0;
    }
    self->t_cell += self->cell.duration;
    // Time begins to count later.
    self->k -= nck_interpolate_rebase(&self->t_cell, self->machine->period_s);
    if (!next_cell(self)) {
        (void)run_dry(self);
        return 0;
    }
    return 1;
}

// The path at its time. 0: it is at rest.
static inline int seek(nck_interpolate_t *self) {
    while (now(self) >= self->t_cell + self->cell.duration) {
        if (!cross(self)) return 0;
    }
    return 1;
}

// ---- the tick's own clock

// Where the plan is, and the speed and the acceleration that it has. A step of acceleration is a
// ramp's for as long as the filter knows it: what lasts longer is the plan's own acceleration.
static void find_place(const nck_interpolate_t *self, nck_look_place_t *place_out) {
    const double t = now(self) - self->t_cell;
    const double known_s = (double)self->filter.taps * self->machine->period_s;
    const int steps = self->filter.taps > 1 && t <= known_s;
    const double steps_from = steps ? self->a_before : self->cell.a;
    nck_clock_find(self->link, &self->cell, t, place_out);
    nck_clock_plan(&self->cell, t, steps_from, place_out);
}

// An abort does not wait for a dwell's end: the tool rests already, and stays.
static void leave_dwell(nck_interpolate_t *self) {
    if (seg_at(self, self->cell.seg)->kind != NCK_SEG_DWELL) return;
    self->brakes = NCK_TICK_HOLD;
    nck_fence_store(&self->clock.state, NCK_CLOCK_STANDS);
}

// What is asked for on the way. A brake goes on to its rest: to end it earlier takes as much again.
static void hear(nck_interpolate_t *self) {
    nck_clock_t *const clock = &self->clock;
    if (nck_fence_load(&self->sync.asked)) leave_dwell(self);
    const int slows = clock->state == NCK_CLOCK_BRAKES || clock->state == NCK_CLOCK_STANDS;
    const int begins = self->brakes && !slows && self->cell.length > 0.0;
    nck_look_place_t here;
    switch (begins ? nck_look_goes_by(seg_at(self, self->cell.seg)) : NCK_GOES_NOT) {
    case NCK_GOES_BY_CLOCK: nck_ease_begin(clock); break;
    case NCK_GOES_BY_LENGTH: find_place(self, &here); nck_clock_begin(clock, here.v, here.a); break;
    default: break;
    }
    if (!slows || self->brakes) return;
    if (nck_look_is_clocked(seg_at(self, self->cell.seg))) nck_ease_release(clock);
    nck_clock_leave(clock, nck_fence_load(&self->kept));
}

// So far along the plan, as long as a period at most: it is never overtaken. 0: the path rests.
static int go(nck_interpolate_t *self, double way) {
    nck_clock_t *const clock = &self->clock;
    double left = self->machine->period_s;
    double ahead = way;
    for (;;) {
        const nck_cell_t *const cell = &self->cell;
        const double t = nck_max(0.0, now(self) - self->t_cell);
        const double time = nck_max(0.0, cell->duration - t);
        const double length = cell->length - nck_min(nck_cell_way(cell, t), cell->length);
        if (ahead < length || time >= left) {
            clock->late -= nck_min(left, nck_clock_time(cell, t, ahead));
            return 1;
        }
        left -= time;
        ahead = nck_max(0.0, ahead - length);
        clock->late -= self->t_cell + cell->duration - now(self);
        if (!cross(self)) return 0;
    }
}

static void pass_at(nck_interpolate_t *self, double share) {
    double v = 0.0;
    const double s = nck_mean_place(&self->cell, nck_max(0.0, now(self) - self->t_cell), &v);
    pass(self, s, v * share);
}

static void brake(nck_interpolate_t *self) {
    nck_clock_t *const clock = &self->clock;
    nck_look_place_t here;
    find_place(self, &here);
    if (!go(self, nck_clock_brake(clock, self->terms, &here))) return;
    find_place(self, &here);
    clock->follows = clock->first.v >= here.v * (1.0 - FOLLOWS_EPSILON);
    if (clock->first.v > here.v) nck_clock_follow(clock, here.v, here.a);
    pass_at(self, clock->first.v > 0.0 ? clock->first.v / here.v : 0.0);
    if (!(clock->first.v > 0.0)) nck_fence_store(&clock->state, NCK_CLOCK_STANDS);
}

// One period on in its own time; k has been counted.
static void own_time(nck_interpolate_t *self) {
    nck_clock_t *const clock = &self->clock;
    clock->late += self->machine->period_s;
    const double t = nck_max(0.0, now(self) - self->t_cell);
    const int by_clock = nck_look_is_clocked(seg_at(self, self->cell.seg));
    if (!by_clock && clock->state == NCK_CLOCK_BRAKES) {
        brake(self);
        return;
    }
    clock->late -= by_clock ? nck_ease_period(clock, self->terms, self->link, &self->cell, t,
                                              &self->past)
                            : nck_clock_set_off(clock, self->terms, nck_cell_speed(&self->cell, t));
    const int moves = seek(self);
    const double since = by_clock ? clock->second.gain * self->machine->period_s : 0.0;
    if (moves) pass_at(self, nck_max(0.0, nck_min(clock->first.rate + since, 1.0)));
    if (by_clock) nck_ease_rest(clock, moves);
}

// One period on.
static const nck_pose_t *tick(nck_interpolate_t *self) {
    nck_sync_turn(&self->sync, self->machine, self->pose.spindle_rpm);
    if (stands_aside(self)) return rest(self);
    if (waits_on(self)) return &self->pose;
    if (self->filter.settle > 0) {
        settle(self);
        return &self->pose;
    }
    if (!self->has_cell && (self->brakes || !fetch(self))) return rest(self);
    if (cuts_thread(self)) return follow_spindle(self, seg_at(self, self->cell.seg));
    hear(self);
    if (self->clock.state == NCK_CLOCK_STANDS) {
        pass_at(self, 0.0); // where it is, to the bit: time does not count
        return &self->pose;
    }
    self->k++;
    if (self->clock.state != NCK_CLOCK_RUNS) {
        own_time(self);
    } else if (seek(self)) {
        evaluate(self, nck_max(0.0, now(self) - self->t_cell)); // a span less rounds otherwise
    }
    return &self->pose;
}

static void go_on(nck_interpolate_t *self) {
    (void)tick(self);
    if (self->brakes | self->stands) {
        const int rests = !self->has_cell || self->clock.state == NCK_CLOCK_STANDS;
        nck_fence_store(&self->stands, self->brakes && rests && !(self->pose.v > 0.0));
    }
}

// One period on by the path tells the speed of every axis; from where it began they brake.
static void begin_halt(nck_interpolate_t *self) {
    nck_halt_t *const halt = self->halt;
    const int aside = stands_aside(self); // the axes may be told where they stand
    memcpy(halt->at, self->pose.axis, sizeof halt->at);
    if (!aside) go_on(self);
    nck_halt_plan(halt, self->terms, &self->pose);
    if (self->sync.state == NCK_SYNC_NOT) return;
    self->sync.state = NCK_SYNC_NOT;
    nck_fence_store(&self->sync.lost, 1);
}

// Beside the path to rest. What is left of it is dropped.
static void stop_axes(nck_interpolate_t *self) {
    nck_halt_t *const halt = self->halt;
    if (nck_fence_load(&halt->periods) == 0) {
        begin_halt(self);
    } else if (stands_aside(self)) {
        (void)rest(self);
        return;
    }
    const uint32_t rests = (uint32_t)nck_halt_tick(halt, self->machine->period_s, &self->pose);
    if (!self->halt) return; // prep has begun anew
    nck_fence_store(&self->has_cell, 1);
    nck_fence_store(&self->stands, rests);
}

const nck_pose_t *nck_interpolate_tick(nck_interpolate_t *self) {
    if (self->halt) stop_axes(self);
    else go_on(self);
    return &self->pose;
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
    if (!self->rests) begin_to_count(self);
    self->rests = 1;
    *cell_out = self->cell;
    return NCK_OK;
}
